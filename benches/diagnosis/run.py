"""Simulated flights with known losses as logs, diagnosed and judged.

    python3 benches/diagnosis/run.py target/release/mavc [--flights 200] [--seed 1] [--keep FOLDER] [--log ulog|dataflash]

Each flight (flights.py): a quadcopter, a hexacopter (PNPNPN or PPNNPN), an octocopter or an X8 of random mass, size and time
constant; hover, climbs, lanes or turns in gusts; no fault, one rotor lost, or one reduced to 5 to 90 %; the controller does
not learn of it. It is logged at 10 to 400 Hz: by `mavc simulate --format ulog`, or from the flight's table as a DataFlash
log (dataflash.py). `mavc diagnose` gets the spec, except where parameters of the DataFlash log name the frame.
"""

import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import statistics
import subprocess
import tempfile

import dataflash
from flights import LAYOUTS, MISSIONS, RATES, Flight

# A loss from this much on is large: the share of its thrust that the rotor loses.
LARGE = 0.3
SIZES = ["100 %", "60 to 95 %", "30 to 60 %", "10 to 30 %"]


def size(flight):
    lost = 1 - flight.capacity
    return SIZES[0] if lost == 1 else SIZES[1] if lost > 0.6 else SIZES[2] if lost > LARGE else SIZES[3]


def fly(mavc, flight, number, kind, folder, seed):
    """Simulates and diagnoses; the answer, when the log begins and ends in its own time, s. None if it was not flown."""
    stem = folder / f"{number:04}"
    spec = stem.with_suffix(".mav")
    spec.write_text(flight.spec)
    log = stem.with_suffix(".ulg" if kind == "ulog" else ".bin")
    if kind == "ulog":
        written, options, begins = log, ["--format", "ulog", "--rate", f"{flight.rate}Hz"], 0.0
    else:
        written, options, begins = stem.with_suffix(".csv"), ["--rate", "400Hz"], dataflash.BEFORE
    run = subprocess.run([mavc, "simulate", spec, "-o", written, "-q", *options], capture_output=True, text=True)
    if not written.exists():
        return None, run.stderr.strip().splitlines()[:2], None
    if kind != "ulog":
        rng = random.Random(f"{seed} {number}")
        rates_hz = max(flight.rate, rng.choice([25, 50, 100, 400]))
        dataflash.write(flight, written, rates_hz, rng, log)
        written.unlink()
    vehicle = [] if kind != "ulog" and flight.frame is not None else [spec]
    run = subprocess.run([mavc, "diagnose", log, *vehicle, "--format", "json", "-q"], capture_output=True, text=True)
    if not run.stdout:
        return None, run.stderr.strip().splitlines()[:4], None
    return json.loads(run.stdout), begins, log.stat().st_size


def judge(flight, answer, begins):
    """What became of a flight: a row for the tables."""
    strike = None if flight.time is None else begins + flight.time
    ends = max((one["to_s"] for one in answer["flights"]), default=begins)
    healthy = min(strike, ends) - begins if strike is not None else ends - begins
    losses = answer["losses"]
    early = [loss for loss in losses if strike is None or loss["time_s"] < strike - 1]
    late = [loss for loss in losses if loss not in early]
    row = {"healthy": healthy, "early": len(early), "found": None, "more": 0, "note": "-"}
    if flight.time is None:
        return row
    hit = late[0] if late and flight.motor in [late[0]["motor"], *late[0]["alternatives"]] else None
    row["found"] = hit is not None
    row["note"] = f"MISSED {[(l['motor'], round(l['time_s'] - begins, 2), l['capacity']) for l in late]}"
    if hit:
        low, high = hit["capacity_interval"]
        row |= {"error": abs(hit["time_s"] - strike), "inside": low - 1e-9 <= flight.capacity <= high + 1e-9,
                "width": high - low, "alone": not hit["alternatives"],
                "more": sum(flight.motor not in [l["motor"], *l["alternatives"]] for l in late[1:])}
        row["note"] = (f"found, {row['error']:.3f} s, {hit['capacity']:.2f} [{low:.2f} {high:.2f}]"
                       f"{'' if row['inside'] else ' OUTSIDE'} {hit['alternatives'] or ''}")
    return row


def table(rows, key, order):
    """A table of the large losses by a property of the flight."""
    groups = collections.defaultdict(list)
    for flight, row in rows:
        groups[key(flight)].append((flight, row))
    for name in order:
        here = groups.get(name, [])
        large = [row for flight, row in here if flight.time is not None and (1 - flight.capacity > LARGE or name in SIZES)]
        found = [row for row in large if row["found"]]
        median = f"{statistics.median(row['error'] for row in found):.3f} s" if found else "-"
        inside = [row["inside"] for row in found]
        minutes = sum(row["healthy"] for _, row in here) / 60
        alarms = sum(row["early"] for _, row in here)
        print(f"| {name} | {len(found)} of {len(large)} | {median} | {sum(inside)} of {len(inside)} | {alarms} in {minutes:.0f} min |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mavc")
    parser.add_argument("--flights", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--log", choices=["ulog", "dataflash"], default="ulog")
    parser.add_argument("--keep", help="a folder for the specs and logs")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    folder = pathlib.Path(args.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    flights = [Flight(random.Random(f"{args.seed} flight {number}")) for number in range(args.flights)]
    rows, failed = [], 0

    def one(number):
        found = fly(args.mavc, flights[number], number, args.log, folder, args.seed)
        if not args.keep:
            for path in folder.glob(f"{number:04}.*"):
                path.unlink()
        return found

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for number, (answer, begins, _) in enumerate(pool.map(one, range(args.flights))):
            flight = flights[number]
            what = f"{number} {flight.layout}, {flight.mission}, {flight.rate} Hz"
            if answer is None:
                failed += 1
                print(f"{what}: NO ANSWER: {begins}", flush=True)
                continue
            row = judge(flight, answer, begins)
            rows.append((flight, row))
            fault = "no fault" if flight.time is None else f"motor {flight.motor} to {flight.capacity} at {flight.time} s"
            alarms = f" EARLY {[(l['motor'], l['time_s'], l['capacity']) for l in answer['losses'][:row['early']]]}"
            print(f"{what}: {fault}: {row['note']}{alarms if row['early'] else ''}{' MORE' if row['more'] else ''}", flush=True)
    large = [row for flight, row in rows if flight.time is not None and 1 - flight.capacity > LARGE]
    found = [row for row in large if row["found"]]
    errors = sorted(row["error"] for row in found)
    print(f"\n{len(rows)} flights, {failed} without an answer; losses above 30 %: {len(found)} of {len(large)} found")
    if errors:
        print(f"error of the time: median {statistics.median(errors):.3f} s, 95 % {errors[int(0.95 * len(errors))]:.3f} s")
        inside = sum(row["inside"] for row in found)
        print(f"capacity inside its 95 % interval: {inside} of {len(found)} ({100 * inside / len(found):.0f} %), width "
              f"{statistics.median(row['width'] for row in found):.2f}")
        print(f"named without alternatives: {sum(row['alone'] for row in found)}; flights in which another motor is named "
              f"after it: {sum(row['more'] > 0 for row in found)}")
    minutes = sum(row["healthy"] for _, row in rows) / 60
    print(f"false alarms: {sum(row['early'] for _, row in rows)} in {minutes:.0f} min without a loss\n")
    print("| | found | median error of the time | capacity in its interval | false alarms |\n|---|---|---|---|---|")
    table([row for row in rows if row[0].time is not None], size, SIZES)
    table(rows, lambda flight: f"{flight.rate} Hz", [f"{rate} Hz" for rate in RATES])
    table(rows, lambda flight: flight.layout, LAYOUTS)
    table(rows, lambda flight: flight.mission, MISSIONS)


if __name__ == "__main__":
    main()
