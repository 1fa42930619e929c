"""Ranks every order of the rotors of a balanced ring of eight: by the faults survived, the smallest margin, and the time of a mission.

    python python/examples/rank_rings.py [rows.jsonl]

Layouts that are turned, mirrored or have P and N swapped have the same sets, so one of each class is analysed. The time of a mission
is that of the vehicle as it stands, so it is searched for every layout, with the plan inside the set of every fault that the layout
survives. With a file an interrupted run continues.
"""

import sys
import time

import mavc
from mavc.layouts import images

VEHICLE = {"arm": 0.211, "mass": 1.8, "inertia": (0.0429, 0.0429, 0.0748)}
ROTOR = {"max_thrust": 6.53, "torque_per_thrust": 0.016, "max_speed": 874}
FAULTS = [mavc.FaultMode(f"M{rotor}", lost=rotor) for rotor in range(1, 9)]
ROUTE = [(0, 0, 2), (10, 0, 12), (10, 8, 12), (0, 8, 12), (0, 0, 2)]
PLAN = {"planner": "rcp", "model": "hover", "time": "minimum", "samples": 30}


def template() -> mavc.Spec:
    vehicle = mavc.Vehicle(layout=mavc.rings(8)[0], rotor=ROTOR, **VEHICLE)
    mission = mavc.Mission(ROUTE, limits={"speed": 6.0, "tilt": 0.35})
    return mavc.build(vehicle, FAULTS, mission, plan={**PLAN, "against": [mode.name for mode in FAULTS]})


def survived(spec: mavc.Spec) -> dict:
    """What is known of a layout without a plan."""
    faults = spec.analyze(threads=1).faults
    names = [mode.name for mode in faults if mode.outcome == "full control"]
    margins = [mode.acai for mode in faults]
    return {"survived": len(names), "smallest_margin_n_m": min(margins), "names": " ".join(names)}


def main(path: "str | None" = None) -> None:
    begin = time.monotonic()
    spec = template()
    classes = mavc.sweep(spec, samples=[{"vehicle.layout": ring} for ring in mavc.rings(8)], run=survived)
    found = {}
    for ring, faults, margin in zip(*(classes[name] for name in ("vehicle.layout", "survived", "smallest_margin_n_m"))):
        found.update({layout: (faults, margin) for layout in images(ring)})
    layouts = sorted(found, reverse=True)
    analyses = mavc.sweep(spec, samples=[{"vehicle.layout": layout} for layout in layouts], run=survived)
    samples = [
        # Without a fault that is survived the plan only has to respect the healthy set.
        {"vehicle.layout": layout, "plan.against": names.split()} if names else {"vehicle.layout": layout, "plan.planner": "rip"}
        for layout, names in zip(layouts, analyses["names"])
    ]
    plans = mavc.sweep(spec, samples=samples, run="plan", path=path)
    ranked = sorted(zip(layouts, plans["time_s"]), key=lambda row: (-found[row[0]][0], -round(found[row[0]][1], 9), row[1]))
    print("layout    faults survived  smallest margin, N m  mission, s")
    for layout, seconds in ranked:
        faults, margin = found[layout]
        print(f"{layout}  {faults:>15}  {margin:>20.4f}  {seconds:>10.3f}")
    print(f"{len(layouts)} layouts, {len(classes['survived'])} classes, {time.monotonic() - begin:.1f} s")


if __name__ == "__main__":
    main(*sys.argv[1:2])
