"""Navigator and drives."""

import pickle
import threading

import numpy as np
import pytest

import lasius


def open_grid(width=30, height=20):
    return lasius.Grid(np.zeros((height, width), np.uint8), free=0)


def test_the_way_is_mended_where_the_world_changed():
    navigator = lasius.Navigator(open_grid(), (29, 10))
    way = navigator.step((0, 10))
    assert way.length == 29 and way.replanned and way.walk[0].tolist() == [0, 10] and way.goal == (29, 10)
    navigator.observe_rectangle(15, 1, 1, 19, blocked=True)
    mended = navigator.step((1, 10))
    assert mended.replanned and mended.length == lasius.plan(navigator.map, (1, 10), (29, 10)).length > 29
    navigator.observe([[15, y] for y in range(20)], blocked=True)
    assert navigator.step((1, 10)).status == "unreachable" and not navigator.connected((0, 0), (29, 0))
    navigator.goal = (10, 3)
    assert navigator.step((1, 10)).status == "solved" and navigator.goal == (10, 3)
    navigator.forget()
    assert pickle.loads(pickle.dumps(mended)) == mended


def test_a_robot_with_a_radius_and_a_colony():
    navigator = lasius.Navigator(open_grid(), (25, 10), "mmas", radius=2, iterations=10, seed=3)
    assert navigator.passable.count_free() < navigator.map.count_free() == 600
    assert navigator.step((4, 10)).iterations == 10
    with pytest.raises(lasius.InvalidParameter):
        lasius.Navigator(open_grid(), (1, 1), radius=-1)


def test_ways_where_none_is_known():
    navigator = lasius.Navigator(open_grid(), (25, 10), radius=2, goal_tolerance=9, doubt_after=3)
    first = navigator.step((0, 10))
    assert first.way_out == (2.5, 10.5) and first.status == "solved" and first.walk[:3].tolist() == [[0, 10], [1, 10], [2, 10]]
    navigator.observe_rectangle(24, 9, 3, 3, blocked=True)
    short = navigator.step((5, 10))
    assert short.goal_reached == (25, 6) and len(short.walk) > 1
    navigator.observe_rectangle(10, 0, 1, 20, blocked=True)
    steps = [navigator.step((5, 10)) for _ in range(4)]
    assert [way.status for way in steps] == ["invalid"] * 3 + ["solved"]
    assert [way.doubted for way in steps] == [0, 0, 0, 29] and steps[3].goal_reached == (25, 10)
    later = navigator.step(tuple(steps[3].walk[5]))
    assert not later.replanned and later.path[0].tolist() == [10.5, 10.5] and later.length == 15


def test_threads_take_turns():
    navigator = lasius.Navigator(open_grid(200, 200), (199, 100))
    lengths = []

    def step(robot):
        for _ in range(20):
            navigator.observe([[100, robot]], blocked=True)
            lengths.append(navigator.step((0, robot)).length)

    threads = [threading.Thread(target=step, args=(y,)) for y in range(0, 200, 25)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(lengths) == 160 and min(lengths) >= 199


def wall():
    truth = np.zeros((20, 30), np.uint8)
    truth[:15, 10] = 1
    return lasius.Grid(truth, free=0)


def test_a_drive_finds_its_way():
    ticks = []

    def observe(tick):
        ticks.append(tick.robot)
        assert tick.world == wall() and tick.path.shape[1] == 2 and tick.news.shape[1] == 2
        assert tick.obstacles.shape == (0, 4) and tick.map.width == 30

    run = lasius.drive(open_grid(), wall(), (2, 2), (28, 2), sense=5, observer=observe)
    assert run.status == "solved" and run.track[-1].tolist() == [28, 2] and run.ticks == len(run.track) - 1
    assert len(run.replans) >= 2 and run.seen > 0 and len(ticks) == len(run.track)
    assert all(not (x == 10 and y < 15) for x, y in run.track.tolist())
    assert pickle.loads(pickle.dumps(run)) == run and "solved" in repr(run)


def test_changes_and_moving_obstacles(tmp_path):
    changes = lasius.Changes()
    changes.add_change(3, 10, 0, 1, 19, blocked=True)
    changes.add_obstacle(width=2, height=2, speed=0.5, track=[[20, 5], [20, 15]])
    seen = []
    run = lasius.drive(open_grid(), open_grid(), (2, 2), (28, 2), changes=changes,
                       observer=lambda tick: seen.append(tick.obstacles.tolist()))
    assert run.status == "solved" and run.seen > 0 and seen[0] == [[20, 5, 2, 2]]
    (tmp_path / "it.txt").write_text("3 10 0 1 19 blocked\n0 move 2 2 0.5 20 5 20 15\n")
    read = lasius.Changes.read(tmp_path / "it.txt", open_grid())
    assert np.array_equal(lasius.drive(open_grid(), open_grid(), (2, 2), (28, 2), changes=read).track, run.track)
    (tmp_path / "bad.txt").write_text("3 10 0 maybe\n")
    with pytest.raises(lasius.FileBroken, match="bad.txt"):
        lasius.Changes.read(tmp_path / "bad.txt", open_grid())
    with pytest.raises(lasius.FileMissing, match="none.txt"):
        lasius.Changes.read(tmp_path / "none.txt", open_grid())
    (tmp_path / "bad.txt").write_bytes(b"3 10 0 caf\xe9\n")
    with pytest.raises(lasius.FileBroken, match="caf\udce9") as broken:
        lasius.Changes.read(tmp_path / "bad.txt", open_grid())
    assert broken.value.line == 1


@pytest.mark.parametrize("blocked", [None, "x", 1])
def test_what_is_neither_blocked_nor_free(blocked):
    navigator = lasius.Navigator(open_grid(), (1, 1))
    for tell in (lambda: navigator.observe([[1, 1]], blocked), lambda: navigator.observe_rectangle(1, 1, 1, 1, blocked),
                 lambda: lasius.Changes().add_change(1, 1, 1, blocked=blocked)):
        with pytest.raises(TypeError, match="blocked is .*: give True or False"):
            tell()
    navigator.observe([[1, 2]], np.True_)
    assert not navigator.map.free((1, 2))


def test_an_observer_ends_a_drive():
    run = lasius.drive(open_grid(), wall(), (2, 2), (28, 2),
                       observer=lambda tick: tick.stop() if tick.tick == 4 else None)
    assert run.status == "interrupted" and run.ticks == 4 and len(run.track) == 5
    run = lasius.drive(open_grid(), wall(), (2, 2), (28, 2), max_ticks=3)
    assert (run.status, run.limit, run.ticks) == ("limit", "ticks", 3)


def test_options_that_an_algorithm_ignores_are_refused():
    for options in ({"params": "acs", "prepare": True}, {"search_on": True}):
        with pytest.raises(lasius.InvalidParameter, match="ignores"):
            lasius.Navigator(open_grid(), (28, 2), **options)


def test_what_an_observer_of_a_drive_raises():
    def fail(tick):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError) as caught:
        lasius.drive(open_grid(), wall(), (2, 2), (28, 2), observer=fail)
    assert caught.value.result.status == "interrupted"
    kept = []
    lasius.drive(open_grid(), wall(), (2, 2), (5, 2), observer=kept.append)
    with pytest.raises(RuntimeError, match="has ended"):
        kept[0].tick
    with pytest.raises(lasius.InvalidParameter):
        lasius.drive(open_grid(), open_grid(5, 5), (1, 1), (2, 2))


def test_a_tick_ends_with_its_callback_that_raises_too() -> None:
    kept = []

    def keep(tick: object) -> None:
        kept.append(tick)
        raise ValueError("enough")

    grid = lasius.Grid(np.zeros((5, 9), np.uint8), free=0)
    with pytest.raises(ValueError, match="enough"):
        lasius.drive(grid, grid, (0, 0), (8, 4), observer=keep)
    with pytest.raises(RuntimeError, match="ended"):
        kept[0].tick


def test_costs_follow_what_is_seen():
    cells = np.zeros((40, 60), np.uint8)
    cells[18:22, 30] = 1
    grid = lasius.Grid(cells, free=0)
    inflation = lasius.Inflation(6, 0.5, weight=3)
    given = lasius.CostField.of(np.linspace(1, 2, 40 * 60).reshape(40, 60))
    navigator = lasius.Navigator(grid, (55, 20), costs=given, inflation=inflation)
    way = navigator.step((5, 20))

    def field(grid):
        costs = lasius.CostField.of(given.weights)
        costs.inflate(grid, *inflation[:2], weight=3)
        return costs

    assert way.replanned and way.cost == pytest.approx(lasius.path_cost(grid, field(grid), way.path))
    best = lasius.CostPlanner(lasius.Planner(grid), field(grid)).plan((5, 20), (55, 20), target_gap=0.01)
    assert best.lower_bound <= way.cost <= 1.02 * best.cost
    navigator.observe(way.walk[10:11], blocked=True)
    other = navigator.step((5, 20))
    assert other.cost > way.cost
    assert other.cost == pytest.approx(lasius.path_cost(navigator.map, field(navigator.map), other.path))
    navigator.set_costs(0, 0, np.full((40, 60), 1.5))
    assert navigator.step((5, 20)).cost != other.cost
    with pytest.raises(lasius.InvalidParameter, match="leave the map"):
        navigator.set_costs(50, 0, np.ones((1, 11)))
    with pytest.raises(lasius.InvalidParameter, match="costs"):
        lasius.Navigator(grid, (5, 5), "mmas", costs=given)


def test_a_drive_over_costs():
    grid = lasius.Grid(np.zeros((20, 40), np.uint8), free=0)
    truth = np.zeros((20, 40), np.uint8)
    truth[6:14, 20] = 1
    run = lasius.drive(grid, lasius.Grid(truth, free=0), (2, 10), (37, 10), sense=8, inflation=(4, 0.5))
    assert run.status == "solved" and run.cost > run.length
    assert run.replans.cost[0] == pytest.approx(35)
    plain = lasius.drive(grid, lasius.Grid(truth, free=0), (2, 10), (37, 10), sense=8)
    assert plain.cost == pytest.approx(plain.length) and np.isnan(plain.replans.cost).all()
