#!/usr/bin/env python3
"""Are there plans at fixed times about the shortest time found? `python3 benches/missions/fixed_times.py MAVC FOUND --output FILE`.

FOUND is a measurement by `run.py` of the generated missions. Each mission found there is planned by the same planner at fixed times, which
are the factors below times the shortest time: the longer ones should all have a plan, and those more than 0.3 % (or 0.05 s, whichever is
more) shorter should have none. Each run appends one JSON line to FILE; runs that FILE has already are skipped. At the end it prints, for
each factor, how many plans were found, and the missions that are not as they should be.

    --seeds A..B          the first and the last seed
    --planners LIST       rip,rcp unless given
    --factors LIST        0.99,0.996,1.005,1.02,1.1,1.3,2 unless given
    --timeout SECONDS     processor time that a plan may take (60)
    --jobs N              plans at the same time (1)
"""

import argparse
import json
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import generate
from run import limited

ALLOWED = 0.003  # of the time
ALLOWED_S = 0.05


def plan(mavc, found, factor, options):
    """The verdict at one fixed time; None at a time that is less than the two allowances below the shortest found."""
    seed, planner, shortest = found["seed"], found["planner"], found["time_s"]
    time = round(factor * shortest, 2)
    if 0.0 <= shortest - time <= max(ALLOWED * shortest, ALLOWED_S):
        return None
    with tempfile.TemporaryDirectory(prefix="missions") as folder:
        spec, report = Path(folder, f"{seed:03}.mav"), Path(folder, "report.json")
        spec.write_text(generate.mission(seed)[1])
        settings = ["--set", f"plan.planner={planner}", "--set", f"plan.time={time} s"]
        code, _, err, cpu, _ = limited([mavc, "plan", str(spec), *settings, "--report", str(report), "--quiet"], options.timeout, folder)
        verdict = "timeout" if code is None else "crashed"
        if report.exists() and code is not None:
            verdict = [p for p in json.loads(report.read_text())["planners"] if p["name"] == planner][-1]["verdict"]
    statement = err.strip()[-200:] if verdict == "crashed" else None
    return {"seed": seed, "planner": planner, "factor": factor, "shortest_s": shortest, "time_s": time, "verdict": verdict, "cpu_s": cpu, "statement": statement}


def summary(lines):
    for factor in sorted({line["factor"] for line in lines}):
        of_factor = [line for line in lines if line["factor"] == factor]
        count = sum(line["verdict"] == "found" for line in of_factor)
        worst = max(line["cpu_s"] for line in of_factor)
        print(f"{factor} times the shortest: a plan for {count} of {len(of_factor)}; at most {worst:.1f} s of processor time")
    for line in sorted(lines, key=lambda line: (line["seed"], line["planner"], line["factor"])):
        if (line["verdict"] == "found") != (line["factor"] >= 1.0):
            print(f"{line['seed']:03} {line['planner']}: {line['verdict']} at {line['time_s']} s; shortest {line['shortest_s']} s {line['statement'] or ''}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("found")
    parser.add_argument("--output", required=True)
    parser.add_argument("--seeds", default="0..299")
    parser.add_argument("--planners", default="rip,rcp")
    parser.add_argument("--factors", default="0.99,0.996,1.005,1.02,1.1,1.3,2")
    parser.add_argument("--timeout", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    output, mavc = Path(options.output), str(Path(options.mavc).resolve())
    lines = [json.loads(line) for line in output.read_text().splitlines()] if output.exists() else []
    done = {(line["seed"], line["planner"], line["factor"]) for line in lines}
    first, _, last = options.seeds.partition("..")
    seeds, planners = range(int(first), int(last or first) + 1), options.planners.split(",")
    found = [line for line in map(json.loads, Path(options.found).read_text().splitlines()) if line["time_s"]]
    found = [line for line in found if line["seed"] in seeds and line["planner"] in planners]
    factors = [float(factor) for factor in options.factors.split(",")]
    wanted = [(line, factor) for line in found for factor in factors if (line["seed"], line["planner"], factor) not in done]
    lock = threading.Lock()

    def measure(run):
        line = plan(mavc, *run, options)
        if line:
            with lock, output.open("a") as file:
                file.write(json.dumps(line) + "\n")
            lines.append(line)
            print(f"{line['seed']} {line['planner']} {line['factor']}: {line['verdict']}, {line['cpu_s']} s", file=sys.stderr, flush=True)

    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(measure, wanted))
    summary(lines)


if __name__ == "__main__":
    main()
