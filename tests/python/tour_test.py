"""Tours: shortest up to 12 stops, each leg as it is planned alone."""

import itertools
import pickle

import numpy as np
import pytest

import lasius


@pytest.fixture(scope="module")
def stops(planner):
    free = np.argwhere(planner.grid.to_array(free=True))[:, ::-1]
    drawn = np.random.default_rng(5).choice(free, 60)
    return np.array([cell for cell in drawn if planner.connected(cell, (14, 14))][:40])


@pytest.mark.parametrize("ends", [{}, {"open": True}, {"open": True, "start": 2}, {"open": True, "start": 0, "goal": 3}])
def test_shortest_of_all_orders(planner, stops, ends):
    some = stops[:6]
    run = planner.tour(some, **ends)
    length = {(a, b): planner.plan(some[a], some[b]).length for a in range(6) for b in range(6)}

    def sum_of(order):
        return sum(length[leg] for leg in zip(order, order[1:] + (() if ends.get("open") else order[:1])))
    allowed = [order for order in itertools.permutations(range(6)) if order[0] == ends.get("start", order[0])
               and order[-1] == ends.get("goal", order[-1])]
    assert run.status == "solved" and run.optimal and run.length == pytest.approx(min(map(sum_of, allowed)), abs=1e-2)
    following = [*run.order[1:], *([] if ends.get("open") else run.order[:1])]
    assert len(run.legs) == len(following)
    for place, (a, b) in enumerate(zip(run.order, following)):
        assert np.array_equal(run.leg(place)[[0, -1]], some[[a, b]] + 0.5)
        assert run.lengths[place] == pytest.approx(length[a, b], abs=1e-9)


def test_an_order_given_in_part(planner, stops):
    for count in (7, 30):
        after = {place: [place - 1] for place in range(2, count, 2)}
        load = np.array([0] + [1, -1] * (count // 2) + [0])[:count]
        run = planner.tour(stops[:count], start=0, after=after, load=load, capacity=1, generations=1)
        place = {stop: i for i, stop in enumerate(run.order.tolist())}
        assert run.status == "solved" and sorted(place) == list(range(count)) and place[0] == 0
        assert all(place[a] < place[b] for b, before in after.items() for a in before)
        assert np.cumsum(load[run.order]).max() <= 1
        assert run.length >= planner.tour(stops[:count], start=0, generations=1).lower_bound
    for given, words in (({"after": {1: [2], 2: [1]}}, "circle: stop 1 before stop 2 before stop 1"),
                         ({"after": {7: [0]}}, "no stop 7"), ({"after": {0: [9]}}, "no stop 9"),
                         ({"load": [1]}, "load has 1 entries"), ({"load": [0] * 4, "capacity": -1}, "capacity is -1")):
        with pytest.raises(lasius.InvalidParameter, match=words):
            planner.tour(stops[:4], **given)
    none = planner.tour(stops[:3], load=[1, 1, 0], capacity=1)
    assert (none.status, none.error, len(none.order)) == ("unreachable", "no order keeps the capacity of 1", 0)


def test_the_same_on_any_threads(planner, stops):
    first, *others = [planner.tour(stops, threads=threads, generations=2) for threads in (1, 2, 5)]
    assert all(first == other for other in others) and pickle.loads(pickle.dumps(first)) == first
    assert sorted(first.order) == list(range(40)) and 0 <= first.gap < 0.1
    assert "TourResult: solved, 40 stops, length" in repr(first)


def test_what_is_left_out(planner, stops):
    run = planner.tour([*stops[:3], [-1, 4]])
    assert run.left_out == {3: "stop 3 at (-1, 4) is outside the map"} and len(run.order) == 3
    none = planner.tour([[-1, 4]], start=0)
    assert (none.status, len(none.order), none.legs) == ("invalid", 0, [])
    assert none.error == "stop 0 at (-1, 4) is outside the map" and np.isnan(none.length)


def test_ends_early(planner, stops):
    told = []

    def observe(order, length):
        told.append((len(order), length))
        return False
    assert sorted(planner.tour(stops, observer=observe).order) == list(range(40)) and [n for n, _ in told] == [40]
    assert planner.tour(stops, time_limit=0).status == "limit"
    assert planner.tour(stops, target_gap=0.5).gap <= 0.5

    def fail(order, length):
        raise ZeroDivisionError
    with pytest.raises(ZeroDivisionError):
        planner.tour(stops, observer=fail)


@pytest.mark.parametrize("options, error", [
    ({"start": 40}, lasius.InvalidParameter), ({"open": True, "start": 1, "goal": 1}, lasius.InvalidParameter),
    ({"goal": 1}, lasius.InvalidParameter), ({"generations": -1}, lasius.InvalidParameter),
    ({"target_gap": -1.0}, lasius.InvalidParameter), ({"threads": 2000}, lasius.InvalidParameter),
    ({"seed": -1}, lasius.InvalidParameter), ({"time_limit": -1.0}, ValueError), ({"start": 0.5}, TypeError)])
def test_refusals(planner, stops, options, error):
    with pytest.raises(error):
        planner.tour(stops, **options)


def test_of_a_disc():
    grid = lasius.Grid(np.zeros((20, 30), np.uint8), free=0)
    run = lasius.tour(grid, [[3, 3], [20, 3], [0, 0]], radius=2)
    assert run.length == 34 and list(run.left_out) == [2]


def test_points() -> None:
    planner = lasius.Planner(lasius.Grid(np.zeros((20, 30), np.uint8), free=0))
    run = planner.tour([[0.25, 2.0], [12.5, 2.0], [30.0, 2.0]], open=True, start=0)
    assert (run.order.tolist(), run.length) == ([0, 1, 2], 29.75)
    assert planner.tour([[0.25, 2.0], [40.0, 2.0]]).left_out.keys() == {1}


def test_one_stop_of_each_group(planner, stops):
    group = ["a", "b", None, "a", 7, "b", None, 7]
    run = planner.tour(stops[:8], group=group, open=True)
    told = [group[stop] for stop in run.order]
    assert sorted(map(str, told)) == ["7", "None", "None", "a", "b"] and run.optimal and run.tours == []
    least = min(planner.tour(stops[[a, b, 2, c, 6]], open=True).length for a in (0, 3) for b in (1, 5) for c in (4, 7))
    assert run.length == pytest.approx(least, abs=1e-9)
    for wrong, words in (({"group": ["a"]}, "group has 1 entries"), ({"group": group, "load": [0] * 8}, "no order given"),
                         ({"group": group, "algorithm": "as"}, "ants know no tours with groups")):
        with pytest.raises(lasius.InvalidParameter, match=words):
            planner.tour(stops[:8], **wrong)


def test_robots(planner, stops):
    run = planner.tour(stops[:9], robots=[3, 0], most_stops=4)
    assert [robot.start for robot in run.tours] == [3, 0]
    assert [len(robot.order) for robot in run.tours] == [len(robot.legs) for robot in run.tours]
    assert max(len(robot.order) for robot in run.tours) == 5 and sorted(run.order) == list(range(9))
    assert np.array_equal(np.concatenate([robot.order for robot in run.tours]), run.order)
    for robot in run.tours:
        assert robot.length == pytest.approx(run.lengths[robot.legs.start : robot.legs.stop].sum())
        assert np.isnan(robot.cost)
    assert pickle.loads(pickle.dumps(run)) == run and run.optimal
    assert planner.tour(stops[:9], robots=[3, 0]).length <= run.length
    for wrong, words in (({"robots": [9]}, "no stop 9"), ({"robots": [1, 1]}, "two robots begin"),
                         ({"robots": [1], "start": 1}, "no other start"), ({"most_stops": 2}, "but no robots")):
        with pytest.raises(lasius.InvalidParameter, match=words):
            planner.tour(stops[:9], **wrong)


def test_over_costs():
    planner = lasius.Planner(lasius.generate("blobs", width=80, height=40, seed=61))
    free = np.argwhere(planner.grid.to_array(free=True))[:, ::-1]
    stops = np.array([cell for cell in free[::97] if planner.connected(cell, free[0])])
    weights = np.ones((40, 80))
    weights[:, weights.shape[1] // 2 :] = 3
    some = stops[:6]
    runs = [planner.tour(some, costs=weights), planner.tour(some, costs=lasius.CostField.of(weights)),
            lasius.CostPlanner(planner, weights).tour(some), lasius.tour(planner.grid, some, costs=weights)]
    assert all(run == runs[0] for run in runs) and runs[0].status == "solved"
    assert runs[0].cost == pytest.approx(runs[0].costs.sum()) and runs[0].lower_bound <= runs[0].cost
    near = planner.tour(some, inflation=(3.0, 0.5), robots=[0, 1])
    assert near.cost > near.length and sum(robot.cost for robot in near.tours) == pytest.approx(near.cost)
    with pytest.raises(lasius.InvalidParameter, match="another map"):
        planner.tour(some, costs=lasius.CostPlanner(planner.grid, weights, radius=0.4))
    assert len(planner.tour(some).costs) == 0 and np.isnan(planner.tour(some).cost)


def test_ants(planner, stops):
    run = planner.tour(stops, algorithm="mmas", settings={"ants": 5, "iterations": 3, "local_search": "two-edges"})
    assert sorted(run.order) == list(range(40)) and run.length >= run.lower_bound
    for wrong, words in (({"algorithm": "mmass"}, "mmas"), ({"settings": {"ants": 3}}, "ants"),
                         ({"algorithm": "as", "settings": {"antz": 3}}, "did you mean")):
        with pytest.raises(lasius.InvalidParameter, match=words):
            planner.tour(stops, **wrong)
