#!/usr/bin/env python3
"""A hundred specs planned from Python and by the command, two at a time.

    python benches/python/hundred.py target/release/mavc [ROUNDS]

The template of `mavc new` with ten masses and ten arms is planned by `mavc.sweep` in two threads, and by runs of `mavc plan`, two at a
time, with one thread for each plan in both. Both are repeated in turn, 4 times unless ROUNDS is given. Wall and processor times are
printed, and the ratio of the shortest, which other work on the machine disturbs least. Every trajectory has to be equal byte for byte.
The package and the command have to be built with one profile.
"""

import hashlib
import os
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import mavc

AT_A_TIME = 2
SAMPLES = [
    {"vehicle.mass": f"{1.5 + 0.05 * i:.2f} kg", "vehicle.arm": f"{20 + 0.5 * k:.1f} cm"} for i in range(10) for k in range(10)
]


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def planned(spec: mavc.Spec) -> dict:
    plan = spec.plan(threads=1)
    return {"verdict": plan.verdict, "sha256": digest(plan.csv or "")}


def from_python(template: Path) -> list:
    found = mavc.sweep(template, samples=SAMPLES, run=planned, workers=AT_A_TIME)
    return list(zip(found["verdict"], found["sha256"]))


def by_command(command: str, template: Path) -> list:
    def one(item: tuple) -> tuple:
        k, sample = item
        sets = [part for field, value in sample.items() for part in ("--set", f"{field} = {value}")]
        table = template.parent / f"{k}.csv"
        arguments = [command, "plan", template, *sets, "-o", table, "--quiet"]
        ran = subprocess.run(arguments, capture_output=True, text=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
        return ("found", digest(table.read_text())) if ran.returncode == 0 else (ran.stderr, digest(""))

    with ThreadPoolExecutor(AT_A_TIME) as pool:
        return list(pool.map(one, enumerate(SAMPLES)))


def cpu() -> float:
    """Processor seconds of this process and of the commands that have ended."""
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def main() -> None:
    command = str(Path(sys.argv[1]).resolve())
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 4
    times: dict = {"python": [], "command": []}
    with tempfile.TemporaryDirectory() as folder:
        template = Path(folder) / "template.mav"
        template.write_text(mavc.new())
        runs = [("python", lambda: from_python(template)), ("command", lambda: by_command(command, template))]
        for k in range(rounds):
            answers = {}
            # Neither is always the first.
            for name, run in runs if k % 2 == 0 else runs[::-1]:
                begin, used = time.perf_counter(), cpu()
                answers[name] = run()
                times[name].append((time.perf_counter() - begin, cpu() - used))
                print(f"{name}: {times[name][-1][0]:.2f} s, {times[name][-1][1]:.2f} s of the processor", flush=True)
            if answers["python"] != answers["command"]:
                differing = sum(a != b for a, b in zip(answers["python"], answers["command"]))
                sys.exit(f"{differing} of {len(SAMPLES)} plans differ: {answers['python'][0]}, {answers['command'][0]}")
    found = sum(verdict == "found" for verdict, _ in answers["python"])
    print(f"{found} of {len(SAMPLES)} plans found, all equal")
    for k, what in enumerate(("wall", "processor")):
        python, by = (min(seconds[k] for seconds in times[name]) for name in ("python", "command"))
        print(f"shortest {what} time: python {python:.2f} s, command {by:.2f} s, ratio {python / by:.3f}")


if __name__ == "__main__":
    main()
