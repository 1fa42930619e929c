#!/usr/bin/env python3
"""One table from one run: the times of mavc and its peers, their ratios, and whether both find the same numbers.

mavc's times are those of whole processes (the least of --repeat runs); the peers' times exclude the start of Python and
imports. Exit code 1 if mavc and a peer disagree about a number; a missed ratio does not fail the run.
"""

import argparse
import json
import os
import re
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from case import PeerError, load, main_with_errors
from peer_compare import RESOLUTION, Effort, Planner, compare, planning_sets
from peer_sets import hull_seconds
from resolve import disagreements, read_json, resolve

HERE = Path(__file__).resolve().parent
UNITS = {"ns": 1e-9, "us": 1e-6, "µs": 1e-6, "ms": 1e-3, "s": 1.0}
BARE_SOLVES = {"case1": 12, "case3": 40}  # what `compare` may cost at most, in solves of the full-row RSP
MEGABYTES = 300  # resident, case 3


@dataclass
class Finished:
    """A successful process: wall and user time in s, resident memory in MB, its output."""

    seconds: float
    user_seconds: float
    megabytes: float
    out: str
    complaints: str
    timings: dict


def parse_timings(text):
    """Seconds by name from lines such as `admissible sets  1.25 ms`; other lines are ignored."""
    pattern = re.compile(r"^\s*(\S.*?)[\s:=]+([0-9.]+(?:e-?\d+)?)\s*(ns|us|µs|ms|s)\b", re.MULTILINE)
    return {name: float(value) * UNITS[unit] for name, value, unit in pattern.findall(text)}


def run(command, repeat=1):
    """The fastest of several runs of a command that must succeed."""
    best = None
    for _ in range(repeat):
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            begin = time.perf_counter()
            try:
                process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
            except OSError as error:
                raise PeerError(f"cannot run {command[0]}: {error.strerror}") from error
            _, status, usage = os.wait4(process.pid, 0)
            seconds = time.perf_counter() - begin
            process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0), err.seek(0)
            said, complaints = out.read().decode(errors="replace"), err.read().decode(errors="replace")
        if process.returncode != 0:
            line = " ".join(map(str, command))
            raise PeerError(f"{line} ended with {process.returncode}:\n{complaints.strip()[-800:]}")
        if best is None or seconds < best.seconds:
            best = Finished(
                seconds, usage.ru_utime, usage.ru_maxrss / 1024, said, complaints, parse_timings(complaints)
            )
    return best


class Table:
    """Rows of peer, mavc, ratio and required ratio."""

    def __init__(self):
        self.rows, self.differences = [], []

    def add(self, what, peer, mavc, target, at_least=True, unit="s"):
        """Adds a ratio: peer / mavc, required to be at least the target, or mavc / peer, at most the target."""
        if mavc is None:
            self.rows.append((what, f"{peer:.4g} {unit}", "not reported", "", f"{target:g}", ""))
            return
        ratio = peer / mavc if at_least else mavc / peer
        met = ratio >= target if at_least else ratio <= target
        asked = f"{'>=' if at_least else '<='} {target:g}"
        cells = (f"{peer:.4g} {unit}", f"{mavc:.4g} {unit}", f"{ratio:.3g}", asked, "met" if met else "MISSED")
        self.rows.append((what, *cells))

    def agree(self, what, words):
        """Adds a comparison of numbers; `words` lists the differences and is empty if there are none."""
        self.rows.append((what, "", "", "", "", "DIFFERS" if words else "agrees"))
        self.differences += [f"{what}: {line}" for line in words]

    def show(self):
        rows = [("", "peer", "mavc", "ratio", "asked", ""), *self.rows]
        widths = [max(len(row[i]) for row in rows) for i in range(6)]
        for row in rows:
            cells = [cell.ljust(w) if i in (0, 5) else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths))]
            print("  ".join(cells).rstrip())
        for line in self.differences:
            print(f"DIFFERS  {line}")


def named(timings, *words):
    """The time whose name contains one of the words, tried in order; None if there is none."""
    for word in words:
        for name, seconds in timings.items():
            if word in name.lower():
                return seconds
    return None


def sets_rows(table, options):
    done = run([options.mavc, "analyze", str(options.sets_spec), "--timings"], 10 * options.repeat)
    hull = hull_seconds("PPNNPPNN")
    table.add("36 fault sets against ConvexHull", hull, named(done.timings, "admissible", "sets"), 100)
    table.add("  the same, whole `analyze` process", hull, done.seconds, 1)


def case_rows(table, name, options):
    case, spec = load(HERE / "cases" / f"{name}.json"), str(options.specs / f"{name}.mav")
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        command = [options.mavc, "compare", spec, "--timings", "--report", str(report)]
        done = run(command, options.repeat)
        planners = json.loads(report.read_text())["planners"]
    peer = compare(case)
    table.add(f"{name}: compare, wall time", peer["effort"]["wall_seconds"], done.seconds, 20)
    solver = named(done.timings, "solver", "solve")
    table.add(f"{name}: solver seconds against full-row bisection", peer["effort"]["seconds"], solver, 5)
    bare = bare_rsp(peer, spec, options)
    if name in BARE_SOLVES:
        table.add(f"{name}: compare in bare solves of the full-row RSP", bare, done.seconds, BARE_SOLVES[name], False)
    if name == "case3":
        table.add(f"{name}: resident memory", MEGABYTES, done.megabytes, 1, False, "MB")
    table.agree(f"{name}: shortest times within {RESOLUTION} s", times_that_differ(peer, planners))
    table.agree(f"{name}: objectives at the common time", objectives_that_differ(case, planners))


def bare_rsp(peer, spec, options):
    """Seconds of one solve of RSP with all rows at its own time: of mavc's export if there is one, else of the peer."""
    time_s = peer["planners"]["rsp"]["time_s"]
    fallback = peer["planners"]["rsp"]["own"]["solver_seconds"]
    try:
        done = run([options.mavc, "emit", "qp", spec, "--format", "json", "--set", f"plan.time={time_s + 0.01:.2f}s"])
        record = resolve(read_json(done.out, "mavc emit qp"), ["clarabel"], trials=3)[0]
    except PeerError as error:
        print(f"note: no exported RSP of {spec}, the peer's own stands in ({str(error).splitlines()[0]})")
        return fallback
    return record["seconds"] if record["status"] == "solved" else fallback


def matching(planners, wanted):
    """Pairs of the peer's name and mavc's record for one kind of run."""
    for record in planners:
        if record["run"] == wanted and record["time_s"] is not None:
            several = len(record["against"]) > 1
            name = {"rip": "rip", "rsp": "rsp"}.get(record["name"])
            yield name or ("rcp all" if several else f"rcp {record['against'][0]}"), record


def times_that_differ(peer, planners):
    words, seen = [], set()
    for name, record in matching(planners, "own"):
        if name in peer["planners"]:
            seen.add(name)
            theirs = peer["planners"][name]["time_s"]
            # Each is at most one step above the same threshold.
            if abs(record["time_s"] - theirs) > RESOLUTION + 1e-6:
                words.append(f"{name} {record['time_s']:.3f} s, peer {theirs:.3f} s")
    # RSP depends on the facets chosen at each tool's own common time, but both must have one.
    return words + [f"{name} is missing in mavc's report" for name in peer["planners"] if name not in seen]


def objectives_that_differ(case, planners, tolerance=1e-4):
    """Plans RIP and the RCPs again by the peer, at the common time of mavc."""
    healthy, sets, joint = planning_sets(case)
    known = {"rip": healthy, "rcp all": joint} | {f"rcp {name}": facets for name, facets in sets.items()}
    words = []
    for name, record in matching(planners, "common"):
        if name not in known or record["objective"] is None:
            continue
        plan = Planner(case, known[name], Effort()).plan(record["time_s"])
        if plan is None:
            words.append(f"{name} at {record['time_s']} s: the peer finds no plan")
        elif abs(plan.objective - record["objective"]) > tolerance * max(1.0, abs(plan.objective)):
            words.append(f"{name} at {record['time_s']} s: {record['objective']:.6f}, peer {plan.objective:.6f}")
    return words


def export_rows(table, name, options):
    """Solves the exported problem of a spec at a time well above its shortest, by four other solvers."""
    spec = str(options.specs / f"{name}.mav")
    command = [options.mavc, "emit", "qp", spec, "--format", "json", "--set", f"plan.time={options.export_time}"]
    records = resolve(read_json(run(command).out, "mavc emit qp"), ["clarabel", "ecos", "scs", "piqp"])
    count = sum(r["status"] == "solved" for r in records)
    table.agree(f"{name}: exported problem, {count} of {len(records)} solvers with a verdict", disagreements(records))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc", help="the release binary, such as target/release/mavc")
    parser.add_argument(
        "--specs", type=Path, default=HERE.parents[1] / "specs" / "paper", help="folder of case1.mav ..."
    )
    parser.add_argument(
        "--sets-spec", type=Path, default=HERE / "octocopter_faults.mav", help="spec with all single and double faults"
    )
    parser.add_argument("--cases", default="case1,case2,case3", help="comma-separated (default %(default)s)")
    parser.add_argument("--repeat", type=int, default=3, help="runs of mavc, the fastest counts (default 3)")
    parser.add_argument(
        "--export-time", default="22s", help="mission time of the exported problems (default %(default)s)"
    )
    options = parser.parse_args()
    if options.repeat < 1:
        raise PeerError("--repeat: at least 1")
    table = Table()
    sets_rows(table, options)
    for name in options.cases.split(","):
        case_rows(table, name, options)
        export_rows(table, name, options)
    table.show()
    return 1 if table.differences else 0


if __name__ == "__main__":
    main_with_errors(main)
