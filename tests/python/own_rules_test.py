"""Rules of the caller's own: what computes the same as a built-in rule gives the same plan, bit for bit."""

import gc

import numpy as np
import pytest

import lasius
from conftest import GOAL, START
from own_rules import rank_based


FAR = (5, 40), (112, 44)  # on `small`


def learning(trail, tours):
    """Cong & Ponnambalam 2009, eq. 3 and 4, in numpy."""
    for ant in range(len(tours.lengths)):
        trail.persist(0.8)
        cells, length = tours.cells_of(ant), tours.lengths[ant]
        if np.isnan(length):
            cells = cells[len(cells) // 2 :]
            trail.set(cells, trail.get(cells) * 0.5)
            trail.set_learned(cells, trail.get_learned(cells) * 0.5)
        else:
            trail.set(cells, trail.get(cells) * (1 + 1.2 * (tours.height / length)))
            trail.set_learned(cells, trail.get_learned(cells) + tours.height / length)


def same(a, b):
    assert (a.status, a.iterations) == (b.status, b.iterations)
    np.testing.assert_array_equal(a.path, b.path)
    np.testing.assert_array_equal(a.curves.steps, b.curves.steps)


@pytest.fixture(scope="module")
def small():
    return lasius.Planner(lasius.generate("blobs", width=120, height=80, seed=3))


@pytest.mark.parametrize("preset", ["usual", "book"])
def test_ras_is_the_built_in_one_for_20_seeds(small, preset):
    for seed in range(1, 21):
        params = lasius.Params("ras", preset=preset, iterations=5, seed=seed, threads=1 + seed % 2)
        own = small.plan(*FAR, params, update=rank_based)
        same(own, small.plan(*FAR, params))
        assert own.found and own.own_rules


def test_cong2009_is_the_built_in_one():
    blocked = np.zeros((20, 30), bool)
    blocked[5:, 10] = blocked[:15, 20] = blocked[9, 3:8] = True
    planner, start, goal = lasius.Planner(lasius.Grid(blocked, free=False)), (1, 18), (28, 1)
    lost = 0
    for seed in range(1, 21):
        params = lasius.Params("cong2009", iterations=40, ants=5, seed=seed)
        own = planner.plan(start, goal, params, update=learning)
        same(own, planner.plan(start, goal, params))
        lost += (5 - own.curves.arrived).sum()
    assert lost > 100


def test_a_table_of_inverse_distances(grid, planner):
    y, x = np.mgrid[: grid.height, : grid.width]
    near = 1 / np.maximum(np.hypot(x - GOAL[0], y - GOAL[1]), 0.5)
    own = planner.plan(START, GOAL, "ras", heuristic=near, iterations=5)
    same(own, planner.plan(START, GOAL, "ras", heuristic="inverse-distance", iterations=5))
    steps = [(dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if (dy, dx) != (0, 0)]
    padded = np.pad(near, 1, mode="edge")
    arcs = np.stack([padded[1 + dy : 1 + dy + grid.height, 1 + dx : 1 + dx + grid.width] for dy, dx in steps], axis=2)
    same(planner.plan(START, GOAL, "ras", heuristic=arcs, iterations=5), own)


def test_a_schedule(planner):
    params = lasius.Params("as", iterations=5, heuristic="inverse-distance")
    own = planner.plan(START, GOAL, params, schedule=lambda q: {"alpha": 2.0, "beta": 3.0})
    settled = params.replace(alpha=2.0, beta=3.0, critical_time=0)
    same(own, planner.plan(START, GOAL, settled))
    same(planner.plan(START, GOAL, params, schedule=lambda q: {}), planner.plan(START, GOAL, params))


def test_arrays_hold_after_the_update(planner):
    kept = []

    def keep(trail, tours):
        kept.append((tours.cells, tours.cells.copy(), tours.lengths, tours.lengths.copy(), tours))

    planner.plan(START, GOAL, "ras", update=keep, iterations=5)
    gc.collect()
    assert len(kept) == 5
    for cells, copied, lengths, lengths_copied, tours in kept:
        np.testing.assert_array_equal(cells, copied)
        np.testing.assert_array_equal(lengths, lengths_copied)
        with pytest.raises(RuntimeError):
            tours.cells
        with pytest.raises(ValueError):
            cells[0] = 1


def test_numbers_by_hand(planner):
    def check(trail, tours):
        a, b = tours.best_cells[:2]
        trail.clamp(0, np.inf)
        trail.set([a, b], [1.0, 2.0])
        trail.persist(0.5)
        trail.add([a, b, a], 1)
        trail.add([b], [0.25])
        np.testing.assert_allclose(trail.get([a, b]), [2.5, 2.25], rtol=1e-6)
        trail.clamp(0.0, 2.375)
        np.testing.assert_allclose(trail.get([a, b]), [2.375, 2.25], rtol=1e-6)
        assert trail.to_array().shape == (200, 400)
        assert trail.to_array()[b // 400, b % 400] == trail.get([b])[0]
        seen.append(tours.iteration)
        tours.stop()

    seen = []
    result = planner.plan(START, GOAL, "ras", update=check, iterations=5)
    assert (seen, result.status, result.iterations) == ([0], "interrupted", 1)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda trail: trail.add([80000], 1), "places[0] is 80000"),
        (lambda trail: trail.add([1, 2], [1]), "1 values for 2 places"),
        (lambda trail: trail.add([1], -1), "amount is -1"),
        (lambda trail: trail.set([1], [np.nan]), "values[0] is nan"),
        (lambda trail: trail.persist(2), "persistence is 2"),
        (lambda trail: trail.clamp(2, 1), "most is 1"),
    ],
)
def test_what_is_refused_ends_the_plan(planner, call, words):
    with pytest.raises(lasius.InvalidParameter) as caught:
        planner.plan(START, GOAL, "ras", update=lambda trail, tours: call(trail), iterations=5)
    assert words in str(caught.value)


def test_other_refusals(planner):
    def plan(**rules):
        return planner.plan(START, GOAL, "ras", iterations=5, **rules)

    with pytest.raises(ValueError, match="shape"):
        plan(heuristic=np.ones((400, 200)))
    with pytest.raises(lasius.InvalidParameter, match="values"):
        plan(heuristic=np.ones((200, 400, 3)))
    with pytest.raises(lasius.InvalidParameter, match="nan"):
        plan(heuristic=np.full((200, 400), np.nan))
    with pytest.raises(TypeError, match="dict"):
        plan(schedule=lambda q: 3)
    with pytest.raises(ValueError, match="gamma"):
        plan(schedule=lambda q: {"gamma": 1})
    with pytest.raises(ValueError, match="udc00"):
        plan(schedule=lambda q: {"\udc00": 1})
    with pytest.raises(ValueError, match="3"):
        plan(schedule=lambda q: {3: 1})
    with pytest.raises(lasius.InvalidParameter, match="alpha"):
        plan(schedule=lambda q: {"alpha": -1})
    for first in ({"alpha": -1}, {}):
        with pytest.raises(TypeError, match="must be real number") as caught:
            plan(schedule=lambda q: {**first, "beta": "x"})
        assert caught.value.result.status == "interrupted"
    with pytest.raises(TypeError):
        plan(update=lambda trail, tours: trail.add([0.5], 1))
    with pytest.raises(TypeError, match="integers"):
        plan(update=lambda trail, tours: trail.get(tours.lengths))
    with pytest.raises(lasius.InvalidParameter, match="no colony"):
        planner.plan(START, GOAL, "exact", update=rank_based)


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_a_batch(small, threads):
    start, goal = FAR
    starts, goals = [start, goal, start], [goal, start, (60, 42)]
    own = small.batch(starts, goals, "ras", update=rank_based, threads=threads, seeds=2, iterations=10)
    built_in = small.batch(starts, goals, "ras", seeds=2, iterations=10)
    assert len(own) == 6 and np.array_equal(own.points, built_in.points) and own.errors == {}
    table = np.ones((80, 120))
    plain = small.batch(starts, goals, "as", heuristic=table, schedule=lambda q: {"beta": 0.0}, iterations=3)
    one = small.plan(goal, start, "as", heuristic=table, schedule=lambda q: {"beta": 0.0}, iterations=3)
    assert np.array_equal(plain.path(1), one.path)


def test_one_value_for_all_places(planner):
    seen = []

    def update(trail, tours):
        for value in (3.0, 3, np.float32(3), np.array(3.0), [3.0, 3.0]):
            trail.set([1, 2], 1.0)
            trail.add([1, 2], value)
            trail.set(np.array([5, 6]), value)
            seen.append(trail.get([1, 2, 5, 6]))

    planner.plan(START, GOAL, "ras", update=update, iterations=1)
    assert len(seen) == 5 and np.allclose(seen, [4, 4, 3, 3])


def test_what_the_library_refuses_in_a_batch_carries_the_answers(planner):
    def bad(iteration):
        return {"alpha": -1 if iteration == 2 else 1}

    with pytest.raises(lasius.InvalidParameter, match="alpha") as caught:
        planner.batch([START] * 3, [GOAL] * 3, "ras", schedule=bad, threads=1, iterations=5)
    assert len(caught.value.result) < 3


def test_what_an_update_raises_in_a_batch(planner):
    calls = []

    def fail(trail, tours):
        calls.append(tours.iteration)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError) as caught:
        planner.batch([START] * 50, [GOAL] * 50, "ras", update=fail, threads=2, iterations=5)
    assert len(calls) == 1 and len(caught.value.result) < 50


def test_what_an_update_raises(planner):
    with pytest.raises(ZeroDivisionError):
        planner.plan(START, GOAL, "ras", update=lambda trail, tours: 1 / 0, iterations=5)
