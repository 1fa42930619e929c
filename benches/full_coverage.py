#!/usr/bin/env python3
"""What can be done after each fault, and what it costs that something always can: `full_coverage.py MAVC SPEC... [--kept FOLDER]`.

Each spec is planned twice with `mavc plan --recovery`: as it is, and with `require uncovered <= 0 %` in its `plan`. Prints a table. Shares are
of time and modes, of the modes for which ways out are sought. Processor times are of this computer, user and system, with all that a run
does: the plan, the ways out, and the plans that are tried. `--kept` writes the reports (JSON) to a folder.

docs/how-to/recovery.md has the table that this prints:

    benches/full_coverage.py target/release/mavc specs/missions/{tower_hexa,parcel_x8,inspection_octo,ridge_hexa}.mav examples/parcel_quad.mav
"""

import argparse
import collections
import json
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile

LABELS = {"continue": "back", "continue spinning": "back, spinning", "land at site": "site", "land here": "here"}
LABELS |= {"caught": "caught", "none": "none"}


def run(mavc, spec, text):
    """The report on a spec with this text, in a copy of its folder, the exit code, and the processor time, s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(shutil.copytree(spec.parent, pathlib.Path(folder, "specs")), spec.name)
        copy.write_text(text)
        command = [mavc, "plan", copy.name, "--recovery", "--report", "-", "-q"]
        found = subprocess.run(command, capture_output=True, text=True, cwd=copy.parent)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(found.stdout) if found.stdout else {"error": found.stderr}, found.returncode, spent


def shares(recovery):
    """By outcome the share of time and modes, over the modes for which a way out was sought, and how many were not."""
    seconds = collections.Counter()
    sought = [mode for mode in recovery["modes"] if "not_attempted" not in mode]
    for piece in (piece for mode in sought for piece in mode["pieces"]):
        seconds[LABELS[piece["outcome"]]] += piece["to_s"] - piece["from_s"]
    whole = sum(seconds.values()) or 1.0
    return {label: 100.0 * seconds[label] / whole for label in LABELS.values()}, len(recovery["modes"]) - len(sought)


def words(report, code, spent):
    """What a report says in one line: the shares of outcomes, the mission time and the processor time."""
    if "recovery" not in report:
        return f"exit code {code}: {report.get('error', 'no ways out')}"
    found, none_sought = shares(report["recovery"])
    outcomes = ", ".join(f"{label} {share:.1f} %" for label, share in found.items() if share > 0.0)
    sought = len(report["recovery"]["modes"]) - none_sought
    duration = report["recovery"]["modes"][0]["pieces"][-1]["to_s"]
    return f"{sought} of {sought + none_sought} modes | {outcomes} | {duration:.2f} s | {spent:.0f} s | {code}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("specs", nargs="+", type=pathlib.Path)
    parser.add_argument("--kept", type=pathlib.Path)
    options = parser.parse_args()
    mavc = str(pathlib.Path(options.mavc).resolve())
    if options.kept:
        options.kept.mkdir(parents=True, exist_ok=True)
    print("| mission | sought for | ways out | mission time | processor time | exit code |\n|---|---|---|---|---|---|")
    for spec in (spec.resolve() for spec in options.specs):
        text = spec.read_text()
        required = re.sub(r"^plan \{", "plan {\n    require uncovered <= 0 %\n", text, count=1, flags=re.MULTILINE)
        for kind, text in [("as it is", text), ("without gaps", required)]:
            report, code, spent = run(mavc, spec, text)
            if options.kept:
                (options.kept / f"{spec.stem}, {kind}.json").write_text(json.dumps(report))
            print(f"| {spec.stem}, {kind} | {words(report, code, spent)} |", flush=True)


if __name__ == "__main__":
    main()
