"""Runs of the mavc binary for the scripts beside this file: what it prints, as Python values."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
LOST = 6  # exit code of `mavc simulate` for a vehicle that was lost


class Mavc:
    def __init__(self, binary):
        self.binary = Path(binary).resolve()

    def run(self, *arguments, overrides=(), codes=(0,)):
        """What a command prints; ends the script at an exit code that is not expected."""
        settings = [part for override in overrides for part in ("--set", override)]
        command = [str(part) for part in (self.binary, *arguments, "--quiet", *settings)]
        ran = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
        if ran.returncode not in codes:
            sys.exit(f"{' '.join(command)}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
        return ran.stdout

    def model(self, spec, overrides=()):
        """The record of the model (docs/schema/model.schema.json), and the model of MuJoCo."""
        record = json.loads(self.run("emit", "model", spec, "--format", "json", overrides=overrides))
        return record, self.run("emit", "mjcf", spec, overrides=overrides)

    def captures(self, spec, overrides=()):
        """The heights of `mavc analyze --capture`, as records."""
        return json.loads(self.run("analyze", spec, "--capture", "--format", "json", overrides=overrides))["captures"]

    def plan(self, spec, table, rate, overrides=()):
        """Writes the table of the plan with rows at `rate` Hz."""
        self.run("plan", spec, "-o", table, "--rate", f"{rate}Hz", overrides=overrides)

    def simulate(self, spec, folder, rate, overrides=()):
        """The outcome of a flight (`flown`, `landed` or the cause of the loss), and its log with rows at `rate` Hz as columns."""
        log, report = Path(folder, "flight.csv"), Path(folder, "flight.json")
        self.run("simulate", spec, "-o", log, "--report", report, "--rate", f"{rate}Hz", overrides=overrides, codes=(0, LOST))
        with open(log) as file:
            rows = list(csv.DictReader(file))
        columns = {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if rows[0][key] != ""}
        outcome = json.loads(report.read_text())["outcome"]
        return outcome.get("cause", outcome["status"]), columns
