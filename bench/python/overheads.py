#!/usr/bin/env python3
"""What Python adds: batches, single calls, maps from arrays; beside the same in C++ (overheads.cpp).

    cmake --preset bench && cmake --build --preset bench
    PYTHONPATH=build/bench/python python3 bench/python/overheads.py build/bench/bin/python_overheads

Each figure is the least of several rounds that alternate between the two, so that a busy machine
slows down both.
"""

import subprocess
import sys
import time

import numpy as np

import lasius

ROUNDS = 7
QUERIES = 10_000


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def queries(grid):
    """Cells drawn as the C++ program draws them: from those that are free, in order of rows."""
    free = np.argwhere(grid.to_array(free=True))[:, ::-1]
    step = np.arange(QUERIES, dtype=np.int64)
    return free[step * 7919 % len(free)], free[step * 104729 % len(free)]


def large_array():
    y, x = np.mgrid[:4096, :4096]
    return ((x // 64 * 7 + y // 64 * 13) % 11 == 0).astype(np.uint8)


def call_overhead(planner):
    """Microseconds of a plan from a cell to itself: nothing is searched."""
    calls = 2000
    return seconds(lambda: [planner.plan((14, 14), (14, 14)) for _ in range(calls)]) / calls * 1e6


def least_of_maps(array, free):
    """Seconds from an array to a planner, the least of as many as in C++."""
    return min(seconds(lambda: lasius.Planner(lasius.Grid(array, free=free))) for _ in range(15))


def measure(program):
    planner = lasius.Planner(lasius.generate("blobs", width=400, height=200, seed=61))
    starts, goals = queries(planner.grid)
    array = large_array()
    works = {
        "batch of 10 000 queries, s": lambda: seconds(lambda: planner.batch(starts, goals, threads=1)),
        "a call that searches nothing, us": lambda: call_overhead(planner),
        "map of 4096 x 4096 to planner, s": lambda: least_of_maps(array, 0),
        "map of 4096 x 4096 from a range of values, s": lambda: least_of_maps(array, range(0, 2)),
    }
    ours = {name: [] for name in works}
    theirs = {name: [] for name in works}
    for _ in range(ROUNDS):
        told = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()
        for (name, work), figure in zip(works.items(), [*told, told[-1]]):
            ours[name].append(work())
            theirs[name].append(float(figure))
    return {name: (min(ours[name]), min(theirs[name])) for name in works}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("| what | Python | C++ | ratio | difference |\n|---|---|---|---|---|")
    for name, (ours, theirs) in measure(sys.argv[1]).items():
        print(f"| {name} | {ours:.4g} | {theirs:.4g} | {ours / theirs:.3f} | {ours - theirs:.3g} |")


main()
