#!/usr/bin/env python3
"""Tables of a measurement by `run.py`: `python3 benches/missions/report.py FILE`, or `report.py BEFORE AFTER` for two.

For each planner it prints how many missions ended with each verdict, the distribution of processor time over all runs and of found/bound
over the missions found, then what is wrong: missions that are not found, plans that `mavc verify` does not accept, and missions where a
planner with more constraints is faster than one with fewer (RIP <= RSP <= RCP, beyond the hundredths of a second to which times are
rounded). A run that ended at its limit counts with the time that it took until then. `--markdown` prints the first table for a document.
Of two files it also lists where a mission is found in one only, and where its time has changed by more than 0.3 %.
"""

import json
import sys
from collections import Counter, defaultdict
from pathlib import Path

VERDICTS = ["found", "not found", "proved infeasible", "not attempted", "timeout", "crashed"]
ROUNDING = 0.0101  # s


def share(values, q):
    """The smallest value that at least a share q of the values does not exceed."""
    ordered = sorted(values)
    return ordered[max(0, -int(-q * len(ordered) // 1) - 1)] if ordered else None


def spread(values, form):
    return [form.format(x) if x is not None else "-" for x in (share(values, 0.5), share(values, 0.9), share(values, 0.95), max(values, default=None))]


def table(rows, markdown):
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    for number, row in enumerate(rows):
        cells = [str(cell).ljust(w) if i == 0 else str(cell).rjust(w) for i, (cell, w) in enumerate(zip(row, widths))]
        print("| " + " | ".join(cells) + " |" if markdown else "  ".join(cells))
        if markdown and number == 0:
            print("|" + "|".join("-" * (w + 2) if i == 0 else "-" * (w + 1) + ":" for i, w in enumerate(widths)) + "|")


def report(lines, markdown):
    of_planner, of_seed = defaultdict(list), defaultdict(dict)
    for line in lines:
        of_planner[line["planner"]].append(line)
        of_seed[line["seed"]][line["planner"]] = line
    names = [name for name in ("rip", "rsp", "rcp") if name in of_planner]
    rows = [["", *(name.upper() for name in names)], ["missions", *(len(of_planner[name]) for name in names)]]
    for verdict in VERDICTS:
        counts = [sum(line["verdict"] == verdict for line in of_planner[name]) for name in names]
        if any(counts) or verdict in VERDICTS[:2]:
            rows.append([verdict, *counts])
    rows.append(["accepted by verify", *(sum(line["verdict"] == "found" and line["verify_exit"] == 0 for line in of_planner[name]) for name in names)])
    cpu = [spread([line["cpu_s"] for line in of_planner[name]], "{:.1f}") for name in names]
    ratio = [spread([line["time_s"] / line["bound_s"] for line in of_planner[name] if line["time_s"] and line["bound_s"]], "{:.3f}") for name in names]
    memory = [max(line["memory_mb"] for line in of_planner[name]) for name in names]
    for i, label in enumerate(("median", "90 %", "95 %", "largest")):
        rows.append([f"processor time, s: {label}", *(each[i] for each in cpu)])
    for i, label in enumerate(("median", "90 %", "95 %", "largest")):
        rows.append([f"found/bound: {label}", *(each[i] for each in ratio)])
    rows.append(["largest memory, MB", *memory])
    table(rows, markdown)
    if markdown:
        return
    failures = [line for line in lines if line["verdict"] != "found"]
    print(f"\nwithout a plan: {len(failures)} runs, {len({line['seed'] for line in failures})} missions")
    for line in sorted(failures, key=lambda line: (str(line["seed"]).zfill(9), line["planner"])):
        print(f"  {line['seed']:>4} {line['planner']}  {line['verdict']}, exit {line['exit']}, {line['cpu_s']:.1f} s: {(line['statement'] or '')[:110]}")
    refused = [line for line in lines if line["verdict"] == "found" and line["verify_exit"] != 0]
    print(f"\nplans that verify does not accept: {len(refused)}")
    for line in refused:
        print(f"  {line['seed']:>4} {line['planner']}  exit {line['verify_exit']}: {line['verify']}")
    order, wrong = [("rip", "rsp"), ("rsp", "rcp"), ("rip", "rcp")], []
    for seed, own in sorted(of_seed.items(), key=lambda item: str(item[0]).zfill(9)):
        times = {name: line["time_s"] for name, line in own.items() if line["time_s"]}
        wrong += [(seed, a, b, times[a], times[b]) for a, b in order if a in times and b in times and times[a] > times[b] + ROUNDING]
    print(f"\nRIP <= RSP <= RCP violated: {len(wrong)} times")
    for seed, a, b, first, second in wrong:
        print(f"  {seed:>4} {a.upper()} {first} s > {b.upper()} {second} s ({100 * (first / second - 1):.2f} %)")
    slowest = Counter({(line["seed"], line["planner"]): line["cpu_s"] for line in lines}).most_common(5)
    print("\nslowest: " + ", ".join(f"{seed} {planner} {cpu:.1f} s" for (seed, planner), cpu in slowest))


def changes(before, after):
    times = [{(line["seed"], line["planner"]): line["time_s"] for line in lines} for lines in (before, after)]
    print("\nchanged by more than 0.3 %, or found in one file only:")
    for key in sorted(set(times[0]) & set(times[1]), key=lambda key: (str(key[0]).zfill(9), key[1])):
        old, new = times[0][key], times[1][key]
        if old is None and new is None or old and new and abs(new / old - 1) <= 0.003:
            continue
        change = f" ({100 * (new / old - 1):+.2f} %)" if old and new else ""
        print(f"  {key[0]:>4} {key[1]}  {old} s -> {new} s{change}")


def main():
    arguments = [a for a in sys.argv[1:] if a != "--markdown"]
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    measured = [[json.loads(line) for line in Path(name).read_text().splitlines()] for name in arguments]
    for name, lines in zip(arguments, measured):
        print(f"{name}\n" if len(arguments) > 1 else "", end="")
        report(lines, "--markdown" in sys.argv)
    if len(arguments) == 2:
        changes(*measured)


if __name__ == "__main__":
    main()
