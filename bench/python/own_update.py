"""Steps a second with an own update in numpy against the built-in one: 30 ants on 400 x 200 cells.

PYTHONPATH=build/release/python:docs/examples python3 bench/python/own_update.py [ROUNDS]

Both take turns, on one thread; a round's ratio compares two plans that took the same steps.
"""

import statistics
import sys
import time

import numpy as np

import lasius
from own_rules import rank_based


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    planner = lasius.Planner(lasius.generate("blobs", width=400, height=200, seed=61))
    for preset in ("usual", "book"):
        params = lasius.Params("ras", preset=preset, ants=30, iterations=200, threads=1)
        workspace, ratios, rates = lasius.Workspace(), [], []
        for _ in range(rounds + 1):
            seconds, results = [], []
            for update in (None, rank_based):
                begin = time.process_time()
                results.append(planner.plan((14, 14), (380, 179), params, update=update, workspace=workspace))
                seconds.append(time.process_time() - begin)
            assert np.array_equal(results[0].path, results[1].path)
            ratios.append(seconds[0] / seconds[1])
            rates.append(results[1].curves.steps.sum() / seconds[1])
        print(
            f"ras {preset}: own update {statistics.median(rates[1:]) / 1e6:.1f} million steps/s, "
            f"{statistics.median(ratios[1:]):.3f} of the built-in's ({min(ratios[1:]):.3f} .. {max(ratios[1:]):.3f})"
        )


main()
