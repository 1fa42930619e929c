"""Recorded logs, diagnosed and compared with what is known of them.

    python3 benches/diagnosis/recorded.py target/release/mavc FOLDER [GOOD.bin ...]

FOLDER has logs and `truth.csv`: log, motor, taken_s (when the output of the motor was taken away), held_us, off_s (when
it was switched off). A log without a row had no loss. Logs with a row are diagnosed a second time with the outputs of
their motors hidden, as if the motors themselves had failed, and the motor of which the mean output over the flight
deviates most is printed beside it (with the package pymavlink). Those without one are compared with the logs GOOD.
"""

import collections
import csv
import json
import pathlib
import subprocess
import sys


def diagnose(mavc, log, *options):
    run = subprocess.run([mavc, "diagnose", log, "--format", "json", "-q", *options], capture_output=True, text=True)
    return json.loads(run.stdout) if run.stdout else {"answer": run.stderr.strip().splitlines()[0], "losses": []}


def deviates_most(log, motors, hidden):
    """The motor whose mean pulse in flight is farthest from that of all, of those that are not hidden, and how far, us."""
    try:
        from pymavlink.DFReader import DFReader_binary
    except ImportError:
        return "unknown: no pymavlink"
    reader, rows = DFReader_binary(str(log)), []
    while (message := reader.recv_match(type="RCOU")) is not None:
        rows.append([getattr(message, f"C{k + 1}") for k in range(motors)])
    rows = [row for row in rows if sum(row) > 1300 * motors]
    means = [sum(row[k] for row in rows) / len(rows) for k in range(motors)]
    apart = [mean - sum(means) / motors for mean in means]
    motor = max((k for k in range(motors) if k + 1 not in hidden), key=lambda k: abs(apart[k]))
    return motor + 1, round(apart[motor])


def main():
    mavc, folder, good = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    truth = collections.defaultdict(list)
    with open(folder / "truth.csv") as lines:
        for row in csv.DictReader(lines):
            truth[row["log"]].append((int(row["motor"]), float(row["taken_s"]), float(row["off_s"])))
    changes = found = 0
    for log in sorted([*folder.glob("*.bin"), *folder.glob("*.ulg")]):
        answer = diagnose(mavc, log)
        losses = [(loss["motor"], round(loss["time_s"], 2), loss["kind"]) for loss in answer["losses"]]
        print(f"{log.name}: {answer['answer']} {losses}")
        for motor, taken, off in truth[log.name]:
            for time in {taken, off}:
                apart = min((abs(loss["time_s"] - time) for loss in answer["losses"] if loss["motor"] == motor), default=9e9)
                changes, found = changes + 1, found + (apart < 0.3)
                print(f"    motor {motor} at {time}: {'NOT FOUND' if apart >= 0.3 else f'found, {apart:.2f} s'}")
        if truth[log.name]:
            motors = [str(motor) for motor, *_ in truth[log.name]]
            first = min(truth[log.name], key=lambda row: row[1])
            losses = diagnose(mavc, log, *[part for motor in motors for part in ("--hide", motor)])["losses"]
            named = [([loss["motor"], *loss["alternatives"]], round(loss["time_s"] - first[1], 2)) for loss in losses]
            print(f"    hidden: the first is motor {first[0]}; named, s after it: {named}")
            mean = deviates_most(log, len(answer["capacities"]), [motor for motor, *_ in truth[log.name]])
            print(f"    mean outputs: the motor that deviates most, us: {mean}")
        elif good and log.suffix == ".bin" and str(log) not in good:
            compared = diagnose(mavc, log, "--baseline", *good)
            marked = [one["motor"] for one in compared["capacities"] if one.get("is_significant")]
            print(f"    changed against the good flights: motors {marked}")
    print(f"{found} of {changes} changes of outputs found")


if __name__ == "__main__":
    main()
