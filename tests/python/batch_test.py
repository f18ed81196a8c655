"""Batches: the same answers as one by one, in arrays."""

import pickle

import numpy as np
import pytest

import lasius

RANDOM = np.random.default_rng(8)


@pytest.fixture(scope="module")
def cells(planner):
    free = np.argwhere(planner.grid.to_array(free=True))[:, ::-1]
    return RANDOM.choice(free, 60), RANDOM.choice(free, 60)


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_as_one_by_one(planner, cells, threads):
    answers = planner.batch(*cells, threads=threads)
    assert len(answers) == 60 and answers.index.tolist() == list(range(60)) and answers.points.shape[1] == 2
    for row, (start, goal) in enumerate(zip(*cells)):
        one = planner.plan(start, goal)
        assert answers.status[row] == one.status and np.array_equal(answers.path(row), one.path)
        assert answers.length[row] == one.length or not one.found
        assert bool(answers.optimal[row]) == one.optimal and answers.errors.get(row, "") == one.error
    assert np.array_equal(answers.path(-1), answers.paths[59])
    with pytest.raises(IndexError):
        answers.path(60)


def test_seeds_of_a_colony(planner, cells):
    answers = planner.batch(cells[0][:2], cells[1][:2], "fan2004", iterations=3, seed=5, seeds=3)
    assert answers.index.tolist() == [0, 0, 0, 1, 1, 1] and answers.seed.tolist() == [5, 6, 7] * 2
    assert (answers.iterations == 3).all() and not answers.optimal.any()
    one = planner.plan(cells[0][1], cells[1][1], "fan2004", iterations=3, seed=7)
    assert answers.length[5] == one.length


def test_bad_queries_are_answers(planner):
    answers = planner.batch([[14, 14], [-1, 0]], [[10**9, 0], [14, 14]])
    assert answers.status.tolist() == ["invalid", "invalid"] and sorted(answers.errors) == [0, 1]
    assert np.isnan(answers.length).all() and len(answers.path(0)) == 0


def test_an_empty_batch(planner):
    answers = planner.batch([], [])
    assert len(answers) == 0 and answers.points.shape == (0, 2) and answers.paths == []


@pytest.mark.parametrize("starts, goals, options, error", [
    ([[1, 1]], [[1, 1], [2, 2]], {}, ValueError),
    ([[1.0, 1.0]], [[1, 1]], {}, TypeError),
    ([1, 1], [1, 1], {}, ValueError),
    ([[1, 1]], [[2**40, 1]], {}, lasius.InvalidParameter),
    ([[1, 1]], [[2**70, 1]], {}, lasius.InvalidParameter),
    (np.array([[2**63, 1]], np.uint64), [[1, 1]], {}, lasius.InvalidParameter),
    (np.ma.masked_array([[1, 1]], [[True, False]]), [[1, 1]], {}, TypeError),
    ([[1, 1]], [[1, 1]], {"seeds": 0}, lasius.InvalidParameter),
    ([[1, 1]], [[1, 1]], {"threads": -1}, lasius.InvalidParameter),
    ([[1, 1]], [[1, 1]], {"time_limit": -1}, lasius.InvalidParameter),
    ([[1, 1]], [[1, 1]], {"params": "none"}, lasius.InvalidParameter),
])
def test_what_is_refused(planner, starts, goals, options, error):
    with pytest.raises(error):
        planner.batch(starts, goals, **options)


def test_numbers_of_no_map_are_told_as_they_are(planner):
    with pytest.raises(ValueError, match="starts has 1099511627776"):
        planner.batch([[2**40, 1]], [[1, 1]])
    with pytest.raises(ValueError, match="1099511627776"):
        planner.plan((2**40, 1), (1, 1))


def test_a_callback_counts_and_its_exception_ends_the_batch(planner, cells):
    told = []
    planner.batch(*cells, progress=lambda done, total, text: told.append((done, total)))
    assert told[-1] == (60, 60) and told == sorted(told)

    def fail(done, total, text):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough") as caught:
        planner.batch(*cells, progress=fail, threads=2)
    assert 0 < len(caught.value.result) < 60


def test_a_batch_is_a_value(planner, cells):
    answers = planner.batch(*cells)
    assert pickle.loads(pickle.dumps(answers)) == answers and "60 answers" in repr(answers)
