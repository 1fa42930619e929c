"""Recorded logs, diagnosed and compared with what is known of them.

    python3 benches/diagnosis/recorded.py target/release/mavc FOLDER

FOLDER has logs and `truth.csv`: log, motor, taken_s (when the output of the motor was taken away), held_us, off_s (when
it was switched off). A log without a row had no loss. Logs with a row are diagnosed a second time with the outputs of
their motors hidden, as if the motors themselves had failed.
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


def main():
    mavc, folder = sys.argv[1], pathlib.Path(sys.argv[2])
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
    print(f"{found} of {changes} changes of outputs found")


if __name__ == "__main__":
    main()
