#!/usr/bin/env python3
"""Solves exported problems again with independent solvers and compares the results.

Reads the JSON of `mavc emit qp --format json` (P the upper triangle, q, constant, A, b, cones). Exit code 1 if verdicts
or objectives differ.
"""

import argparse
import importlib
import json
import math
import sys
import time

import numpy as np
import scipy.sparse as sp

from case import PeerError, main_with_errors
from solvers import SOLVERS, Problem

DEFAULT = "clarabel,ecos,scs,piqp,highs"


def matrix(fields, name):
    try:
        shape = (fields["rows"], fields["cols"])
        found = sp.csc_matrix((fields["nzval"], fields["rowval"], fields["colptr"]), shape=shape, dtype=float)
        found.check_format(full_check=True)
        return found
    except (KeyError, TypeError, ValueError) as error:
        raise PeerError(f"{name} is no matrix with rows, cols, colptr, rowval and nzval: {error}") from error


def read_json(text, name):
    """The Problem in an export; `name` is used in error messages."""
    try:
        fields = json.loads(text)
        upper, A = matrix(fields["P"], f"{name}: P"), matrix(fields["A"], f"{name}: A")
        cones = [(cone["cone"], int(cone["rows"])) for cone in fields["cones"]]
        q, b = np.array(fields["q"], dtype=float), np.array(fields["b"], dtype=float)
        constant = float(fields.get("constant", 0.0))
    except (ValueError, KeyError, TypeError) as error:
        raise PeerError(f"{name} is no exported problem: {error!r}") from error
    if sp.tril(upper, -1).nnz:
        raise PeerError(f"{name}: P has entries below its diagonal")
    unknown = {kind for kind, _ in cones} - {"zero", "nonnegative", "second_order"}
    if unknown:
        raise PeerError(f"{name}: unknown cones {sorted(unknown)}")
    if any(n < 1 for _, n in cones) or sum(n for _, n in cones) != len(b):
        raise PeerError(f"{name}: the cones do not make up the {len(b)} rows")
    if A.shape != (len(b), len(q)) or upper.shape != (len(q), len(q)):
        raise PeerError(f"{name}: the sizes of P, q, A and b do not fit together")
    if not all(np.isfinite(v).all() for v in (upper.data, q, A.data, b, [constant])):
        raise PeerError(f"{name} holds a number that is not finite")
    full = (upper + sp.triu(upper, 1).T).tocsc()
    return Problem(full, q, constant, A.tocsr(), b, cones)


def resolve(problem, names, trials=1):
    """One record per solver: verdict, objective, largest violation of a row, seconds (the least of the trials)."""
    records = []
    for name in names:
        try:
            importlib.import_module("highspy" if name == "highs" else name)
        except ImportError:
            records.append({"solver": name, "status": "not installed", "seconds": 0.0})
            continue
        seconds = math.inf
        for _ in range(trials):
            begin = time.perf_counter()
            status, x = SOLVERS[name](problem)
            seconds = min(seconds, time.perf_counter() - begin)
        record = {"solver": name, "status": status, "seconds": seconds}
        if x is not None:
            record |= {"objective": problem.objective(x), "violation": problem.violation(x)}
        records.append(record)
    return records


def disagreements(records, expected=None, tolerance=1e-5):
    """What contradicts the expected objective, or the first verdict if there is none, in words.

    Objectives may differ by the tolerance, relative if they exceed one, and by the violation of rows.
    """
    verdicts = [r for r in records if r["status"] in ("solved", "infeasible")]
    if not verdicts:
        return ["no solver reached a verdict"]
    first = verdicts[0] if expected is None else {"status": "solved", "objective": expected, "violation": 0.0}
    found = []
    for r in verdicts:
        if r["status"] != first["status"]:
            found.append(f"{r['solver']} says {r['status']}, not {first['status']}")
        elif r["status"] == "solved":
            allowed = max(tolerance, r["violation"], first["violation"]) * max(1.0, abs(first["objective"]))
            if not abs(r["objective"] - first["objective"]) <= allowed:
                found.append(f"{r['solver']} finds {r['objective']:.9g}, not {first['objective']:.9g}")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("problem", nargs="+", help="exported JSON, or - for standard input")
    parser.add_argument("--solvers", default=DEFAULT, help=f"any of {','.join(SOLVERS)} (default %(default)s)")
    parser.add_argument("--expect", type=float, metavar="VALUE", help="the objective that mavc reports")
    parser.add_argument("--tolerance", type=float, default=1e-5, help="of objectives (default %(default)g)")
    options = parser.parse_args()
    names = options.solvers.split(",")
    if set(names) - set(SOLVERS):
        raise PeerError(f"unknown solver; there are {', '.join(SOLVERS)}")
    failed = False
    for path in options.problem:
        records = resolve(read_json(read_text(path), path), names)
        print(path)
        for r in records:
            solved = f"{r['objective']:18.9f}  rows missed by {r['violation']:.1e}" if "objective" in r else ""
            print(f"  {r['solver']:9} {r['seconds']:7.2f} s  {r['status']:11} {solved}")
        words = disagreements(records, options.expect, options.tolerance)
        for line in words:
            print(f"  DIFFERS: {line}")
        failed |= bool(words)
    return 1 if failed else 0


def read_text(path):
    try:
        if path == "-":
            return sys.stdin.read()
        with open(path, encoding="utf-8") as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise PeerError(f"cannot read {path}: {error}") from error


if __name__ == "__main__":
    main_with_errors(main)
