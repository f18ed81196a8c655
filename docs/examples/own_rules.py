"""The rank-based ant system's update (Bullnheimer, Hartl & Strauss 1999), written outside the library."""

import numpy as np

import lasius


def rank_based(trail, tours, ranks=6, persistence=0.9):
    trail.persist(persistence)
    for rank, ant in enumerate(tours.ranked[: ranks - 1], start=1):
        trail.add(tours.places_of(ant), (ranks - rank) / tours.lengths[ant])
    if len(tours.best_cells):
        trail.add(tours.best_places(), ranks / tours.best_length)


if __name__ == "__main__":
    planner = lasius.Planner(lasius.generate("blobs", width=400, height=200, seed=61))
    for seed in range(1, 4):
        params = lasius.Params("ras", iterations=5, seed=seed)
        own = planner.plan((14, 14), (380, 179), params, update=rank_based)
        assert own.own_rules and np.array_equal(own.path, planner.plan((14, 14), (380, 179), params).path)
