"""Threads, progress, and runs that end early."""

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import mavc
import pytest

# Many seconds of planning.
LONG = ["plan.time = minimum", "plan.samples = 400", "plan.against = all"]

INTERRUPTED = f"""
import mavc, sys
spec = mavc.compile(mavc.new(), set={LONG})
spec.plan(progress=lambda report: print(report.text, flush=True))
"""


def test_progress(small):
    reports = []
    spec = mavc.compile(mavc.new())
    spec.plan(progress=reports.append)
    assert reports[0].text == "building the admissible sets"
    tried = [report for report in reports if report.planner]
    assert tried and all(report.time == 30.0 for report in tried)
    flights = []
    campaign = mavc.compile(small).campaign(times=1, seeds=1, progress=flights.append)
    assert flights[-1].done == flights[-1].total == campaign.rows.rows


def test_an_exception_of_the_callback_ends_the_run():
    class Enough(Exception):
        pass

    def stop(report):
        raise Enough(report.text)

    begin = time.monotonic()
    with pytest.raises(Enough, match="building"):
        mavc.compile(mavc.new(), set=LONG).plan(progress=stop)
    assert time.monotonic() - begin < 2


def test_cancel_from_another_thread():
    cancel = mavc.Cancel()
    timer = threading.Timer(0.3, cancel.cancel)
    timer.start()
    begin = time.monotonic()
    with pytest.raises(mavc.Cancelled):
        mavc.compile(mavc.new(), set=LONG).plan(cancel=cancel)
    assert time.monotonic() - begin < 2
    with pytest.raises(mavc.Cancelled):
        mavc.compile(mavc.new()).analyze(cancel=cancel)
    assert mavc.compile(mavc.new()).analyze().survived == 9


@pytest.mark.skipif(os.name != "posix", reason="sends a signal")
def test_ctrl_c():
    running = subprocess.Popen([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert running.stdout.readline()
    time.sleep(0.5)
    assert running.poll() is None, "the plan must take longer than that"
    begin = time.monotonic()
    running.send_signal(signal.SIGINT)
    _, errors = running.communicate(timeout=30)
    assert time.monotonic() - begin < 1.5
    assert errors.rstrip().endswith(b"KeyboardInterrupt")


@pytest.mark.long
def test_threads_run_at_the_same_time_and_change_nothing():
    spec = mavc.compile(mavc.new())
    expected = spec.plan(threads=1)
    with ThreadPoolExecutor(4) as pool:
        plans = list(pool.map(lambda _: spec.plan(threads=1), range(4)))
    assert {(plan.json, plan.csv, plan.text) for plan in plans} == {(expected.json, expected.csv, expected.text)}
    assert spec.plan(threads=3).json == expected.json
    with pytest.raises(ValueError, match="at least one thread"):
        spec.plan(threads=0)


def test_the_lock_is_released():
    spec = mavc.compile(mavc.new())
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    begin, before = time.monotonic(), counted[0]
    spec.plan(threads=1)
    seconds, ticks = time.monotonic() - begin, counted[0] - before
    done.set()
    counter.join()
    # With the lock held there would be none.
    assert ticks > 50 * seconds


def test_a_panic_is_an_exception(capfd):
    from mavc import _mavc

    with pytest.raises(mavc.InternalError, match="mavc has a bug: as asked"):
        _mavc.panic(0, None, _mavc.new_cancel())
    assert issubclass(mavc.InternalError, Exception)
    assert mavc.compile(mavc.new()).analyze().survived == 9


def test_effort_is_that_of_the_spec(small):
    spec = mavc.compile(small)
    assert spec.plan(effort="quick").json == spec.set("plan.effort", "quick").plan().json
    with pytest.raises(mavc.SpecError):
        spec.plan(effort="endless")
