"""The rank-based ant system's update (Bullnheimer, Hartl & Strauss 1999), written outside the library."""

import numpy as np

import lasius


def rank_based(trail, tours, ranks=6, persistence=0.9):
    trail.persist(persistence)
    for rank, ant in enumerate(tours.ranked[: ranks - 1], start=1):
        trail.add(tours.places_of(ant), (ranks - rank) / tours.lengths[ant])
    if len(tours.best_cells):
        trail.add(tours.best_places(), ranks / tours.best_length)


planner = lasius.Planner(lasius.generate("blobs", width=400, height=200, seed=61))
for seed in range(1, 21):
    own = planner.plan((14, 14), (380, 179), "ras", update=rank_based, iterations=20, seed=seed)
    assert np.array_equal(own.path, planner.plan((14, 14), (380, 179), "ras", iterations=20, seed=seed).path)
