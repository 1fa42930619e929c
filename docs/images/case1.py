"""Draws case1.svg: the planned path of the paper's case 1, coloured by how far the wrench stays inside M1's set.

    cargo run --release -- plan specs/paper/case1.mav -o traj.csv
    cargo run --release -- emit sets specs/paper/case1.mav > sets.txt
    python3 docs/images/case1.py traj.csv sets.txt docs/images/case1.svg     # needs numpy and matplotlib
"""

import csv
import sys

import matplotlib
import numpy as np

matplotlib.use("svg")
import matplotlib.pyplot as plt

CUT = 0.2  # N, N m


def facets(text, mode):
    """(N, 4), (N,): the facets N w <= e of one mode in the text that `emit sets` prints."""
    normals, offsets, inside = [], [], False
    for line in text.splitlines():
        if line and not line.startswith(" "):
            inside = line.startswith(mode + ":")
        elif inside and "<=" in line:
            left, right = line.split("<=")
            normals.append([float(v) for v in left.split()])
            offsets.append(float(right.split()[0]))
    return np.array(normals), np.array(offsets)


def main(trajectory, sets, picture):
    with open(trajectory, newline="") as file:
        rows = list(csv.DictReader(file))
    with open(sets) as file:
        normals, offsets = facets(file.read(), "M1")
    column = lambda name: np.array([float(row[name]) for row in rows])
    x, y, z = column("x"), column("y"), column("z")
    wrench = np.stack([column(name) for name in ("thrust", "tau_x", "tau_y", "tau_z")], axis=1)
    margin = (offsets - wrench @ normals.T).min(axis=1)

    plt.rcParams["svg.hashsalt"] = "mavc"
    figure = plt.figure(figsize=(8, 4.6))
    axes = figure.add_subplot(projection="3d")
    dots = axes.scatter(x, y, z, c=np.clip(margin, -CUT, CUT), cmap="RdYlGn", s=10)
    axes.plot(x, y, z, lw=0.6, color="0.5")
    met = slice(None, None, 10)
    axes.scatter(x[met], y[met], z[met], marker="o", facecolors="none", edgecolors="k", s=26, label="waypoints")
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]", title="RSP, paper case 1, 16 s")
    axes.legend(loc="upper left")
    figure.colorbar(dots, label=f"distance to the edge of M1's set [N, N m], cut at {CUT}", shrink=0.8, pad=0.08)
    figure.subplots_adjust(left=0, right=0.98, top=0.95, bottom=0.03)
    figure.savefig(picture, metadata={"Date": None})


if __name__ == "__main__":
    main(*sys.argv[1:])
