"""Coverage: swaths in a short order, the same on any threads."""

import pickle

import numpy as np
import pytest

import lasius


@pytest.fixture(scope="module")
def small():
    return lasius.generate("rooms", width=40, height=30, seed=4)


def test_an_empty_room():
    run = lasius.Planner(lasius.Grid(np.zeros((12, 20), np.uint8), free=0)).cover(3, open=True)
    assert (run.status, run.swaths, run.angle, run.covered, run.unreachable) == ("solved", 4, 0, 1, 0)
    assert run.length == pytest.approx(4 * 20 + 3 * 3) and run.swept == pytest.approx(80)
    assert sorted(run.order) == list(range(8)) and len(run.legs) == 7
    for place, (a, b) in enumerate(zip(run.order, run.order[1:])):
        assert np.array_equal(run.leg(place)[[0, -1]], run.stops[[a, b]])
    assert "CoverResult: solved, 4 swaths, length 89, 100.00% covered" in repr(run)


def test_the_same_on_any_threads(small):
    planner = lasius.Planner(small, radius=0.5)
    start = next((x + 0.5, y + 0.5) for y in range(30) for x in range(40) if planner.passable.to_array(free=True)[y, x])
    told = []
    first, *others = [planner.cover(2, start=start, threads=threads, generations=1) for threads in (1, 2, 5)]
    assert all(first == other for other in others) and pickle.loads(pickle.dumps(first)) == first
    planner.cover(2, start=start, generations=1, observer=lambda order, length: told.append(length))
    assert first.covered > 0.9 and tuple(first.stops[-1]) == start and first.order[0] == len(first.stops) - 1
    assert told == sorted(told, reverse=True) and told


def test_refusals(small):
    planner = lasius.Planner(small)
    for width, words in ((0, "width"), (-1, "width"), (41, "at most the map's 40"), (np.nan, "width"), (1e-4, "10000 swaths")):
        with pytest.raises(lasius.InvalidParameter, match=words):
            planner.cover(width)
    assert planner.cover(2, start=(-1, 5)).status == "invalid"
