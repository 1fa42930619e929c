#!/usr/bin/env python3
"""Compares what two builds of mavc compute: python3 benches/same_numbers.py OLD NEW [SPEC...]

For every shipped spec (or those named) it runs analyze, plan, simulate and campaign with both, and compares the trajectory, the
certificate, the reports and the rows byte for byte. Words of reports may differ where RENAMED maps one to the other, and
so may the hash of the program in campaign rows. Prints one line for each spec and ends with 1 if any number differs.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Keys of reports: old -> new.
RENAMED = {
    # --report of plan and compare, schema 2 -> 3
    "time_bound_s": "time_lower_bound_s",
    "between": "between_nodes",
    "excess": "violation",
    "per": "relaxed_by",
    "gives_back_s": "time_saved_s",
    "positions": "violated_nodes",
    "outside_s": "violation_duration_s",
    "last_outside_s": "last_violation_s",
    "of_selection": "only_for_selection",
    "of_samples": "only_for_samples",
    "any_time": "time_is_free",
    "questions": "searches",
    # --report of campaign, schema 2 -> 3 (and outside_s, last_outside_s as above)
    "inside": "hover_inside",
    "refused": "refused_reconfigurations",
    "worth": "strength",
    "rank_worth": "rank_strength",
    # --report of simulate, schema 2 -> 3
    "alike": "indistinguishable_modes",
    # analyze, schema 2 -> 3
    "given_away": "unreached_share",
}

# What reports no longer have.
REMOVED = {
    "rounds",  # plan and compare, schema 4 -> 5
    "predictors", "harm", "rank_correlation", "rank_strength", "pairs",  # campaign, schema 4 -> 5
}

# Values that are sentences for people.
SENTENCES = {"statement", "message", "help", "label", "text", "what", "why", "schema", "undecided", "detail"}


def numbers(value):
    """A report without sentences, with its present keys."""
    if isinstance(value, dict):
        return {RENAMED.get(k, k): numbers(v) for k, v in value.items() if k not in SENTENCES | REMOVED}
    if isinstance(value, list):
        return [numbers(v) for v in value]
    return value


def rows(text):
    """Rows of a campaign without its identity, which depends on the hash of the program, and without the checksum, which covers it."""
    return [line.split(",")[1:-1] for line in text.splitlines()]


def run(mavc, spec, folder):
    """All outputs of one build for a spec: name -> content."""
    out = {}

    def call(name, *args):
        done = subprocess.run([mavc, *args], capture_output=True, text=True, cwd=ROOT, check=False)
        out[name + " exit"] = done.returncode
        return done.stdout

    analysis = call("analyze", "analyze", spec, "-q", "--format", "json")
    out["a.json"] = numbers(json.loads(analysis)) if analysis else None
    call("plan", "plan", spec, "-q", "-o", f"{folder}/t.csv", "--certificate", f"{folder}/c.json", "--report", f"{folder}/r.json")
    call("simulate", "simulate", spec, "-q", "-o", f"{folder}/f.csv", "--report", f"{folder}/s.json")
    call("campaign", "campaign", spec, "-q", "--times", "3", "--seeds", "1", "-o", f"{folder}/k.csv", "--report", f"{folder}/k.json")
    for name in ("t.csv", "c.json", "f.csv"):
        path = Path(folder, name)
        out[name] = path.read_text() if path.exists() else None
    for name in ("r.json", "s.json", "k.json"):
        path = Path(folder, name)
        out[name] = numbers(json.loads(path.read_text())) if path.exists() else None
    if out["k.json"]:
        out["k.json"].pop("campaign", None)
    path = Path(folder, "k.csv")
    out["k.csv"] = rows(path.read_text()) if path.exists() else None
    return out


def main():
    old, new, *named = sys.argv[1:]
    specs = named or sorted(str(p.relative_to(ROOT)) for f in ("specs", "examples") for p in (ROOT / f).rglob("*.mav"))
    different = 0
    for spec in specs:
        with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
            before, after = run(old, spec, a), run(new, spec, b)
        wrong = [name for name in before if before[name] != after[name]]
        made = sum(1 for name, value in after.items() if value is not None and not name.endswith("exit"))
        different += bool(wrong)
        print(f"{spec}: {'differs in ' + ', '.join(wrong) if wrong else f'the same ({made} results)'}", flush=True)
    print(f"{len(specs)} specs, {different} with differences")
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
