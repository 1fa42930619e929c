"""Many specs, layouts of rings, and frames."""

import json
import math
import threading
from concurrent.futures import ThreadPoolExecutor
from itertools import product

import mavc
import numpy as np
import pandas
import polars
import pytest
from mavc.layouts import images

SPEC = mavc.new()
MASSES = [1.6, "1.8 kg", 2.0]


def test_a_grid_of_analyses():
    grid = {"vehicle.mass": MASSES, "vehicle.arm": [0.2, 0.25]}
    found = mavc.sweep(SPEC, grid=grid)
    assert found.rows == 6 and list(found)[:2] == ["vehicle.mass", "vehicle.arm"]
    single = mavc.compile(SPEC, set=["vehicle.mass = 1.8 kg", "vehicle.arm = 0.25 m"]).analyze()
    assert found["smallest_margin_n_m"][3] == single.margins.min()
    assert found["survived"].tolist() == [9] * 6
    assert mavc.sweep(SPEC, grid=grid, workers=1).csv == found.csv


def test_plans_and_functions(small):
    samples = [{"plan.time": time, "simulate.duration": 8.0} for time in (6.0, 1.0)]
    found = mavc.sweep(mavc.compile(small), samples=samples, run="plan")
    assert found["verdict"].tolist() == ["found", "proved infeasible"]
    assert found["time_s"][0] == 6.0 and math.isnan(found["time_s"][1])
    assert found["smallest_margin"][0] > 0

    rotors = mavc.sweep(small, samples=samples, run=lambda spec: {"rotors": spec.analyze().record["rotors"]})
    assert rotors["rotors"].tolist() == [8, 8]
    with pytest.raises(ValueError, match="no run 'fly'"):
        mavc.sweep(SPEC, samples=samples, run="fly")
    with pytest.raises(ValueError, match="a grid or samples"):
        mavc.sweep(SPEC)


def test_a_sample_that_is_no_spec_has_its_error():
    found = mavc.sweep(SPEC, samples=[{"vehicle.mass": 1.8}, {"vehicle.mass": 800.0}])
    assert found["error"][0] is None and "too_heavy" in found["error"][1]
    assert found.to_pandas()["survived"].isna().tolist() == [False, True]


def test_an_error_of_a_function_ends_the_sweep():
    with pytest.raises(ZeroDivisionError):
        mavc.sweep(SPEC, samples=[{}], run=lambda spec: 1 / 0)


def test_a_sweep_continues(tmp_path):
    path = tmp_path / "sweep.parquet"
    reports = []
    grid = {"vehicle.mass": MASSES}
    mavc.sweep(SPEC, grid={"vehicle.mass": MASSES[:2]}, path=path)
    journal = path.with_suffix(".jsonl")
    with journal.open("a") as file:
        file.write('{"key": "of a run that was killed')
    found = mavc.sweep(SPEC, grid=grid, path=path, progress=lambda *counts: reports.append(counts))
    assert reports == [(2, 3), (3, 3)]
    assert found.csv == mavc.sweep(SPEC, grid=grid).csv
    assert len([json.loads(line) for line in journal.read_text().splitlines()]) == 3
    assert polars.read_parquet(path).equals(found.to_polars())
    reports.clear()
    mavc.sweep(SPEC, grid=grid, path=path, progress=lambda *counts: reports.append(counts))
    assert reports == [(3, 3)]
    # Another spec has other rows.
    mavc.sweep(SPEC.replace("0.211 m", "0.212 m"), grid=grid, path=path, progress=lambda *c: reports.append(c))
    assert reports[1] == (0, 3)


def test_clients():
    expected = mavc.sweep(SPEC, grid={"vehicle.mass": MASSES}).csv
    with ThreadPoolExecutor(2) as pool:
        assert mavc.sweep(SPEC, grid={"vehicle.mass": MASSES}, client=pool).csv == expected

    class Dask:
        """Futures that are not those of the standard library."""

        class Future:
            def __init__(self, work):
                self.thread = threading.Thread(target=lambda: setattr(self, "value", work()))
                self.thread.start()

            def result(self):
                self.thread.join()
                return self.value

        def submit(self, function, *arguments):
            return self.Future(lambda: function(*arguments))

    assert mavc.sweep(SPEC, grid={"vehicle.mass": MASSES}, client=Dask()).csv == expected


def _phi(n):
    return sum(math.gcd(k, n) == 1 for k in range(1, n + 1))


@pytest.mark.parametrize("n", [2, 4, 6, 8, 10, 12])
def test_rings_are_as_many_as_published(n):
    # Necklaces: OEIS A003239, here by its formula. Bracelets: OEIS A005648, by the reflections that keep a ring.
    half = n // 2
    divisors = [d for d in range(1, half + 1) if half % d == 0]
    necklaces = sum(_phi(d) * math.comb(n // d, half // d) for d in divisors) // n
    assert necklaces == {2: 1, 4: 2, 6: 4, 8: 10, 10: 26, 12: 80}[n]
    assert len(mavc.rings(n, symmetries=["rotation"])) == necklaces
    bracelets = {2: 1, 4: 2, 6: 3, 8: 8, 10: 16, 12: 50}[n]
    assert len(mavc.rings(n, symmetries=["rotation", "reflection"])) == bracelets
    assert len(mavc.rings(n, symmetries=[])) == math.comb(n, half)


@pytest.mark.parametrize("n", [3, 6, 8])
def test_classes_of_rings_are_a_partition(n):
    # Burnside: the number of classes is the mean number of layouts that a symmetry keeps.
    layouts = ["".join(letters) for letters in product("PN", repeat=n)]
    turn = lambda layout, k: layout[k:] + layout[:k]
    swap = lambda layout: layout.translate(str.maketrans("PN", "NP"))
    symmetries = [
        lambda layout, k=k, mirrored=m, swapped=s: (swap if s_(swapped) else str)(turn(layout[::-1] if mirrored else layout, k))
        for k in range(n)
        for m in (False, True)
        for s in (False, True)
        for s_ in (bool,)
    ]
    kept = sum(symmetry(layout) == layout for symmetry in symmetries for layout in layouts)
    rings = mavc.rings(n, balanced=False)
    assert len(rings) * len(symmetries) == kept
    assert sorted(image for ring in rings for image in images(ring)) == sorted(layouts)


def test_symmetries_keep_what_an_analysis_finds():
    spec = mavc.compile(SPEC)

    def found(layout):
        analysis = spec.set("vehicle.layout", layout).analyze()
        modes = sorted((round(m.acai, 9), m.verdict, m.hover, round(m.critical_mass, 9)) for m in analysis.faults[:8])
        return modes, round(analysis.modes[0].acai, 9)

    for ring in ("PPNPNPNN", "PPNNPPNN"):
        assert len({str(found(image)) for image in sorted(images(ring))[::3]}) == 1
    assert found("PPNNPPNN") != found("PPNPNPNN")


def test_frames(small):
    plan = mavc.compile(SPEC).plan()
    frame = plan.trajectory.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame["x"].tolist() == plan.trajectory["x"].tolist()
    assert polars.DataFrame(plan.trajectory).equals(plan.trajectory.to_polars())
    rows = mavc.compile(small).campaign(times=1, seeds=2).rows
    polar = rows.to_polars()
    assert polar.height == rows.rows and polar["fault_time_s"].null_count() == np.isnan(rows["fault_time_s"]).sum() > 0
    assert polar.schema["heading_broken"] == polars.Boolean and polar.schema["seed"] == polars.Int64
    assert rows.to_pandas()["planner"].tolist() == rows["planner"].tolist()


def test_what_notebooks_show(small):
    spec = mavc.compile(small)
    found = spec.analyze()
    assert found.headline in found._repr_html_() and found.headline in repr(found)
    plan = spec.plan()
    shown = plan._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and shown.count("<") == 2
    import html

    assert html.unescape(shown.split('"')[1]) == plan.html()
    campaign = spec.campaign(times=1, seeds=1)
    assert f"{campaign.rows.rows} flights" in campaign._repr_html_() and "healthy" in campaign._repr_html_()
