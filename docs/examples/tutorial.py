#!/usr/bin/env python3
"""A tour of lasius in Python, cell by cell: run it as it is, or open it as a notebook (cells begin with # %%).

tutorial.py [PICTURE]: leaves the picture of two plans, tutorial.png unless said otherwise.
"""

# %% A map: an array [y, x], and what is free in it
import sys

import numpy as np

import lasius

cells = lasius.generate("blobs", width=400, height=200, seed=61).to_array(free=False).astype(np.uint8)
cells[90:110, 150:158] = 1  # arrays are edited, grids never change
grid = lasius.Grid(cells, free=0)
print(grid, f"{grid.count_free() / cells.size:.0%} free")

# %% The shortest path, and that of a colony
planner = lasius.Planner(grid)
start, goal = (14, 14), (380, 179)
shortest = planner.plan(start, goal)
colony = planner.plan(start, goal, "fan2004", iterations=60, seed=3)
print(shortest, colony, sep="\n")
assert shortest.optimal and colony.length >= shortest.length

# %% Watch the colony, and stop it when it is good enough
seen = []


def observe(progress):
    seen.append(progress.best_length)
    if progress.best_length < 1.02 * shortest.length:
        progress.stop()


early = planner.plan(start, goal, "fan2004", iterations=60, seed=3, observer=observe)
print(f"within 2% after {early.iterations} iterations")
assert len(seen) == early.iterations <= 60

# %% How much do seeds differ? Ten of them side by side
runs = planner.batch([start], [goal], "fan2004", iterations=60, seeds=10)
gaps = runs.length / shortest.length - 1
print(f"gap of ten seeds: median {np.median(gaps):.2%}, worst {gaps.max():.2%}")
assert (gaps >= 0).all()

# %% Many questions: prepare the map once
free = np.argwhere(grid.to_array(free=True))[:, ::-1]
draws = np.random.default_rng(1)
answers = planner.prepared().batch(draws.choice(free, 1000), draws.choice(free, 1000))
print(answers, f"{np.median(answers.elapsed) * 1e6:.0f} microseconds each")
assert set(answers.status) <= {"solved", "unreachable"}

# %% A robot that sees something in its way
navigator = lasius.Navigator(grid, goal)
before = navigator.step(start)
x, y = (int(value) for value in before.path[len(before.path) // 2])
navigator.observe_rectangle(x - 6, y - 6, 12, 12, blocked=True)
after = navigator.step(tuple(before.walk[1]))
print(f"the way is {after.length - before.length:+.1f} cells longer")
assert after.replanned

# %% A picture
try:
    axes = colony.plot()
    axes.plot(*shortest.path.T, "--", color="#1f77b4", label="shortest")
    axes.legend(loc="upper right", fontsize="small")
    axes.figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "tutorial.png")
except ImportError as error:
    print(error)
