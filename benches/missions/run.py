#!/usr/bin/env python3
"""Plans the generated missions with every planner: `python3 benches/missions/run.py MAVC --output FILE`.

For each seed and planner a child process runs `mavc plan` with a report and a certificate, and `mavc verify` then checks the
certificate. Each run appends one JSON line to FILE; runs that FILE has already are skipped, so an interrupted measurement continues where
it ended. `report.py FILE` prints the tables.

    --seeds A..B          the first and the last seed (0..299)
    --planners LIST       rip,rcp,rsp unless given
    --timeout SECONDS     processor time that a plan may take (60); the process is ended then, and the verdict is `timeout`
    --jobs N              plans at the same time (1)
    --set FIELD=VALUE     passed to `mavc plan` and `mavc verify`, repeatable
    --option WORDS        passed to `mavc plan` alone, such as `--option "--effort quick"`, repeatable
    --specs FOLDER        plans the specs of a folder instead of the generated ones; their names take the place of seeds

Fields of a line: seed, planner, verdict (found, not found, proved infeasible, not attempted, timeout or crashed), exit code, time_s, the
proved bound_s, processor time of `plan` and of `verify` (cpu_s, verify_cpu_s: user and system, all threads), peak memory (memory_mb), the
exit code of `verify` and its last line, the statement of mavc, and the sha256 of binary and spec. Processor time depends on the machine
and on what else runs; compare runs of one machine.
"""

import argparse
import hashlib
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import generate


def limited(command, seconds, folder):
    """Runs a command with a limit on its processor time: exit code (None at the limit), output, cpu_s, memory_mb."""

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))

    with open(Path(folder, "out"), "w+") as out, open(Path(folder, "err"), "w+") as err:
        child = subprocess.Popen(command, stdout=out, stderr=err, preexec_fn=limit)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = code = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        texts = out.read(), err.read()
    cpu = usage.ru_utime + usage.ru_stime
    at_limit = code == -signal.SIGXCPU or (code == -signal.SIGKILL and cpu >= 0.9 * seconds)
    return None if at_limit else code, *texts, round(cpu, 3), round(usage.ru_maxrss / 1024, 1)


def run(mavc, name, spec, planner, options, folder):
    """One line of the file."""
    report, certificate = Path(folder, "report.json"), Path(folder, "certificate.json")
    report.unlink(missing_ok=True)
    certificate.unlink(missing_ok=True)
    settings = ["--set", f"plan.planner={planner}"] + [part for each in options.set for part in ("--set", each)]
    extra = [word for each in options.option for word in each.split()]
    begun = time.monotonic()
    command = [mavc, "plan", str(spec), *settings, *extra, "--report", str(report), "--certificate", str(certificate), "--quiet"]
    code, _, err, cpu, memory = limited(command, options.timeout, folder)
    line = {
        "seed": name, "planner": planner, "verdict": "timeout" if code is None else "crashed", "exit": code, "time_s": None, "bound_s": None,
        "cpu_s": cpu, "wall_s": round(time.monotonic() - begun, 2), "memory_mb": memory, "verify_exit": None, "verify": None,
        "verify_cpu_s": None, "statement": None,
    }  # fmt: skip
    if report.exists() and code is not None:
        own = [p for p in json.loads(report.read_text())["planners"] if p["name"] == planner][-1:]
        for found in own:
            line |= {"verdict": found["verdict"], "time_s": found["time_s"], "bound_s": found["time_lower_bound_s"], "statement": found["statement"]}
    if code not in (None, 0, 3, 4):
        line["statement"] = err.strip()[-400:]
    if certificate.exists() and code is not None:
        verify, out, err, line["verify_cpu_s"], _ = limited([mavc, "verify", str(certificate), str(spec), *settings], options.timeout, folder)
        line["verify_exit"] = verify
        last = ((out or err).strip().splitlines() or [""])[-1]
        line["verify"] = last.removeprefix(f"{certificate}: ")[:200]
    return line


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("--output", required=True)
    parser.add_argument("--seeds", default="0..299")
    parser.add_argument("--planners", default="rip,rcp,rsp")
    parser.add_argument("--timeout", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--option", action="append", default=[])
    parser.add_argument("--specs")
    options = parser.parse_args()
    output = Path(options.output)
    done = set()
    digest = hashlib.sha256(Path(options.mavc).read_bytes()).hexdigest()[:16]
    if output.exists():
        lines = [json.loads(line) for line in output.read_text().splitlines()]
        if any(line["mavc"] != digest for line in lines):
            sys.exit(f"{output} has runs of another binary")
        done = {(line["seed"], line["planner"]) for line in lines}
    if options.specs:
        names = [path.stem for path in sorted(Path(options.specs).glob("*.mav"))]
    else:
        first, _, last = options.seeds.partition("..")
        names = list(range(int(first), int(last or first) + 1))
    planners = options.planners.split(",")
    lock, mavc = threading.Lock(), str(Path(options.mavc).resolve())

    def measure(name):
        wanted = [planner for planner in planners if (name, planner) not in done]
        if not wanted:
            return
        with tempfile.TemporaryDirectory(prefix="missions") as folder:
            if options.specs:
                spec = Path(options.specs, f"{name}.mav")
                text = spec.read_text()
            else:
                _, text = generate.mission(name)
                spec = Path(folder, f"{name:03}.mav")
                spec.write_text(text)
            for planner in wanted:
                line = run(mavc, name, spec, planner, options, folder)
                line |= {"mavc": digest, "spec": hashlib.sha256(text.encode()).hexdigest()[:16]}
                with lock, output.open("a") as file:
                    file.write(json.dumps(line) + "\n")
                times = f"{line['time_s']} s of {line['bound_s'] and round(line['bound_s'], 2)} s" if line["time_s"] else ""
                print(f"{name} {planner}: {line['verdict']} {times}, {line['cpu_s']} s, verify {line['verify_exit']}", file=sys.stderr, flush=True)

    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(measure, names))


if __name__ == "__main__":
    main()
