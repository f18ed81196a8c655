"""Plans on bitmaps: answers, parameters, observers, what is refused."""

import copy
import functools
import pickle

import numpy as np
import pytest

import lasius
from conftest import GOAL, START


def test_exact_is_proven(planner):
    result = planner.plan(START, GOAL)
    assert (result.status, result.fault, result.optimal, result.gap) == ("solved", "none", True, 0)
    assert result.length == pytest.approx(lasius.path_length(result.path), abs=1e-9) == 445.0006683543657
    assert result.path[0].tolist() == [14.5, 14.5] and result.path[-1].tolist() == [380.5, 179.5]
    assert lasius.path_fault(planner.grid, result.path) is None
    assert result.curves is None and result.found and result.params == lasius.Params()


def test_a_colony_is_the_same_with_any_number_of_threads(planner):
    runs = [planner.plan(START, GOAL, "fan2004", iterations=30, threads=n) for n in (1, 2, 5)]
    for run in runs:
        assert np.array_equal(run.path, runs[0].path) and np.array_equal(run.curves.mean, runs[0].curves.mean)
        assert run.iterations == len(run.curves) == 30 and run.curves.best[-1] == run.length
    assert not np.array_equal(planner.plan(START, GOAL, "fan2004", iterations=30, seed=2).curves.mean, runs[0].curves.mean)


def test_a_disc():
    array = np.zeros((20, 30), np.uint8)
    array[:17, 15] = 1
    grid = lasius.Grid(array, free=0)
    disc = lasius.Planner(grid, radius=1.5)
    result = disc.plan((3, 3), (26, 3))
    assert result.optimal and [piece.turn for piece in result.curve] == [0, -1, 0, -1, 0]
    straight = [np.hypot(*np.subtract(p.end, p.start)) for p in result.curve if p.turn == 0]
    arcs = [p.angle * p.radius for p in result.curve if p.turn]
    assert sum(straight) + sum(arcs) == pytest.approx(result.length, abs=1e-9)
    assert {p.centre for p in result.curve if p.turn} == {(15.0, 17.0), (16.0, 17.0)} and result.curve[0].centre is None
    assert result.length <= lasius.path_length(result.path) <= 1.001 * result.length
    assert (disc.radius, disc.grid, disc.passable) == (1.5, grid, lasius.Grid(lasius.clearance(grid) < 1.5, free=0))
    assert disc.clear((1, 3)) and not disc.clear((0, 3)) and disc.widest_disc((3, 3), (26, 3)) == 1.5
    assert lasius.Planner(grid).plan((3, 3), (26, 3)).curve == ()
    assert lasius.Planner(grid, radius=1.500001).plan((3, 3), (26, 3)).status == "unreachable"
    for other in (disc.prepared(), pickle.loads(pickle.dumps(disc)), disc.edited([[0, 0]], blocked=False)):
        assert (other.radius, other.plan((3, 3), (26, 3)).curve) == (1.5, result.curve)
    batch = disc.batch([[3, 3]], [[26, 3]])
    assert batch.length[0] == result.length and np.array_equal(batch.path(0), result.path)
    assert pickle.loads(pickle.dumps(result)) == result
    colony = lasius.Planner(grid, radius=1).plan((3, 3), (26, 3), "acs", iterations=5)
    assert colony.found and colony.curve == ()
    for radius in (-1, float("nan")):
        with pytest.raises(lasius.InvalidParameter, match="radius"):
            lasius.Planner(grid, radius=radius)
    with pytest.raises(lasius.InvalidParameter, match="between 0.05 and 54"):
        lasius.Planner(grid, radius=60).plan((3, 3), (26, 3))
    poses = result.poses(0.1)
    on_it = np.abs(np.hypot(*(poses[:, :2] - (15, 17)).T) - 1.5) < 1e-9
    assert on_it.sum() > 12 and np.abs(np.diff(poses[on_it, 2])).max() < 0.08


@pytest.mark.parametrize("cells", [([14, 14], (380, 179)), (np.array([14, 14]), np.array([380, 179], np.uint16))])
def test_cells_of_any_kind(planner, cells):
    assert planner.plan(*cells).length == 445.0006683543657


@pytest.mark.parametrize("cell, error", [
    ((14,), TypeError), ("ab", TypeError), (None, TypeError), (14, TypeError), ((14, "b"), TypeError),
    ((2**40, 0), ValueError),
])
def test_what_is_no_cell(planner, cell, error):
    with pytest.raises(error, match="cell"):
        planner.plan(cell, GOAL)


def test_points(planner):
    cells = planner.plan(START, GOAL)
    for start in ((14.5, 14.5), np.array([14.5, 14.5]), (np.float32(14.5), 14.5)):
        centres = planner.plan(start, (380.5, 179.5))
        assert np.array_equal(centres.path, cells.path) and centres.lower_bound == cells.lower_bound
    for algorithm in ("exact", "as"):
        result = planner.plan((14.25, 14.875), (380, 179.0625), algorithm, **({} if algorithm == "exact" else {"iterations": 3}))
        assert result.path[0].tolist() == [14.25, 14.875] and result.path[-1].tolist() == [380, 179.0625]
        assert result.length == pytest.approx(lasius.path_length(result.path))
        assert lasius.path_fault(planner.grid, result.path) is None
        assert (result.start, result.goal) == ((14.25, 14.875), (380, 179.0625))
        assert pickle.loads(pickle.dumps(result)) == result
        result.plot()
    assert planner.plan((-0.5, 3.25), GOAL).error.startswith("start (-0.5, 3.25) is outside the map; the nearest free cell")


def test_via(planner):
    middle = planner.nearest_free((200, 100))
    whole = planner.plan(START, GOAL, via=[middle, (14.25, 14.5)])
    legs = [planner.plan(START, middle), planner.plan(middle, (14.25, 14.5)), planner.plan((14.25, 14.5), GOAL)]
    assert whole.length == sum(leg.length for leg in legs) and whole.optimal
    assert np.array_equal(whole.path, np.concatenate([leg.path[i > 0:] for i, leg in enumerate(legs)]))
    assert planner.plan(START, GOAL, via=[middle, (-3, 1)]).error.startswith("via point 2 (-3, 1) is outside the map")
    with pytest.raises(TypeError, match="cell"):
        planner.plan(START, GOAL, via=["ab"])


def test_poses(planner):
    result = planner.plan(START, GOAL)
    poses = result.poses(1.5)
    assert np.array_equal(poses[[0, -1], :2], result.path[[0, -1]])
    steps = np.diff(poses[:, :2], axis=0)
    assert np.hypot(*steps.T).max() <= 1.5 + 1e-12 and np.hypot(*steps.T).sum() == pytest.approx(result.length)
    assert np.abs(np.arctan2(steps[:, 1], steps[:, 0]) - poses[:-1, 2]).max() < 1e-9
    assert set(map(tuple, result.path)) <= set(map(tuple, poses[:, :2]))
    room = lasius.Map(planner.grid, lasius.WorldFrame(0.5, -3, 4, 0.3), "")
    metres = result.poses(0.75, map=room)
    assert np.allclose(metres[:, :2], room.frame.to_world(poses[:, :2], room.grid.height))
    assert np.allclose(np.exp(1j * metres[:, 2]), np.exp(1j * (0.3 - poses[:, 2])))
    assert planner.plan(START, START).poses(1).tolist() == [[14.5, 14.5, 0]]
    assert planner.plan((-1, 0), GOAL).poses(1).shape == (0, 3)
    with pytest.raises(lasius.InvalidParameter, match="spacing of poses is 0; give a length above 0"):
        result.poses(0)
    with pytest.raises(TypeError, match="spacing"):
        result.poses("1")


def test_ends_that_are_bad_are_answers(planner):
    outside = planner.plan(START, (999, 0))
    assert (outside.status, outside.fault, outside.nearest_free) == ("invalid", "goal_outside", (399, 0))
    assert len(outside.path) == 0 and outside.path.shape == (0, 2) and outside.length != outside.length
    walls = np.zeros((9, 9), np.uint8)
    walls[:, 4] = 1
    apart = lasius.plan(lasius.Grid(walls, free=0), (0, 0), (8, 0))
    assert (apart.status, apart.fault) == ("unreachable", "disconnected") and not apart.found


def test_a_goal_tolerance_and_the_nearest_cell_that_can_be_reached():
    walls = np.zeros((16, 20), np.uint8)
    walls[5:12, 10:17] = 1
    walls[6:11, 11:16] = 0
    walls[8, 12] = 1
    planner = lasius.Planner(lasius.Grid(walls, free=0))
    bad = planner.plan((2, 2), (12, 8), goal_tolerance=2)
    assert (bad.status, bad.nearest_free, bad.nearest_reachable, bad.goal_reached) == ("invalid", (12, 7), (9, 8), None)
    near = planner.plan((2, 2), (12, 8), goal_tolerance=3)
    assert (near.status, near.goal, near.goal_reached) == ("solved", (12, 8), (9, 8))
    assert near.path[-1].tolist() == [9.5, 8.5] and pickle.loads(pickle.dumps(near)) == near
    answers = planner.batch([(2, 2), (2, 2)], [(12, 8), (30, 8)], goal_tolerance=3)
    assert answers.status.tolist() == ["solved", "invalid"] and "its tolerance 3" in answers.errors[1]
    with pytest.raises(lasius.InvalidParameter, match="goal_tolerance is -1"):
        planner.plan((2, 2), (3, 3), goal_tolerance=-1)


def test_parameters():
    params = lasius.Params("mmas", ants=7, persistence=0.5, seed=2**53 - 1)
    assert (params.ants, params.persistence, params.seed, params.algorithm) == (7, 0.5, 2**53 - 1, "mmas")
    assert params.replace(ants=8).ants == 8 and params.ants == 7
    assert pickle.loads(pickle.dumps(params)) == params == copy.deepcopy(params) != lasius.Params("mmas")
    assert hash(copy.copy(params)) == hash(params) and "ants" in dir(params)
    assert lasius.Params("as", preset="book") != lasius.Params("as")
    assert lasius.Params("mmas", persistence=1 / 3).persistence == 1 / 3
    assert lasius.Params("mmas", ants=np.int64(5)).ants == 5
    assert any("tau" in line for line in params.formulas())
    for name, algorithm in lasius.algorithms().items():
        ours = lasius.Params(name)
        assert set(ours.to_dict()) == {p.name for p in algorithm.parameters} and algorithm.source


@pytest.mark.parametrize("make, words", [
    (lambda: lasius.Params("fan204"), "fan2004"),
    (lambda: lasius.Params("mmas", antz=3), "ants"),
    (lambda: lasius.Params("mmas", ants=0), "ants"),
    (lambda: lasius.Params("mmas", ants="many"), "ants"),
    (lambda: lasius.Params("mmas", update="none"), "ant-system"),
    (lambda: lasius.Params("fan2004", preset="book"), "fan2004"),
    (lambda: lasius.Params("as", preset="textbook"), "usual, book"),
])
def test_parameters_out_of_range(make, words):
    with pytest.raises(lasius.InvalidParameter, match=words) as caught:
        make()
    assert isinstance(caught.value, ValueError) and caught.value.remedy and caught.value.problem


def test_seeds_and_threads_are_whole_numbers():
    assert lasius.Params("as", seed=np.int64(7)).seed == 7
    for bad in (1.5, "3", None):
        with pytest.raises(TypeError):
            lasius.Params("as", seed=bad)
    for bad in (-1, 2**53, 2**70):
        with pytest.raises(lasius.InvalidParameter, match="seed is"):
            lasius.Params("as", seed=bad)


def test_parameters_never_change():
    with pytest.raises(AttributeError, match="replace"):
        lasius.Params("mmas").ants = 3
    with pytest.raises(AttributeError, match="crossover"):
        lasius.Params("mmas").crossover


def test_what_other_settings_leave_unread_is_refused(planner):
    plan = functools.partial(planner.plan, START, GOAL, "as")
    for typed in (functools.partial(lasius.Params, "as"), lasius.Params("as").replace, plan):
        with pytest.raises(lasius.InvalidParameter, match="ranks is 9, but it is read only with update=rank; set it to 6"):
            typed(ranks=9)
    idle = lasius.Params("ras", ranks=9).replace(update="ant-system")  # as a sweep over updates does
    assert idle.ranks == 9 and pickle.loads(pickle.dumps(idle)) == idle
    same = lasius.Params("ras", update="ant-system")
    assert planner.plan(START, GOAL, idle, iterations=2).length == planner.plan(START, GOAL, same, iterations=2).length
    assert idle.why_unread("ranks") == "it is read only with update=rank" and idle.why_unread("ants") == ""
    with pytest.raises(lasius.InvalidParameter, match=r"persistence \(1 - evaporation\) is 0, but"):
        lasius.Params("terminal-index", evaporation=1)
    with pytest.raises(lasius.InvalidParameter, match="local_evaporation is 0.5, but"):
        lasius.Params("as", local_evaporation=0.5)
    with pytest.raises(lasius.InvalidParameter, match="beta is 1, but"):
        planner.plan(START, GOAL, "as", beta=1)
    table = np.linspace(1, 2, planner.grid.shape[0] * planner.grid.shape[1]).reshape(planner.grid.shape)
    ours = [planner.plan(START, GOAL, "as", heuristic=table, beta=beta, iterations=2) for beta in (1, 3)]
    assert ours[0] != ours[1]  # an own heuristic is raised to beta
    assert lasius.Params("ras", ranks=9, update="rank").replace(ranks=8).ranks == 8
    ranks, trail = (lasius.algorithms()["as"][name] for name in ("ranks", "trail"))
    assert ranks.only_with == "update=rank" and (ranks.least, ranks.most, ranks.choices) == (2, 1000000, ())
    assert trail.choices == ("cells", "arcs") and trail.range == "cells|arcs"


def test_evaporation_and_persistence_are_one():
    assert lasius.Params("as", evaporation=0.25) == lasius.Params("as", persistence=0.75)
    with pytest.raises(lasius.InvalidParameter, match="both given"):
        lasius.Params("as", evaporation=0.25, persistence=0.75)


def test_what_does_not_compose_is_refused(planner):
    with pytest.raises(lasius.InvalidParameter):
        planner.plan(START, GOAL, "mmas", target_gap=0.1)
    with pytest.raises(TypeError, match="params"):
        planner.plan(START, GOAL, 3)
    with pytest.raises(TypeError, match="Grid"):
        lasius.Planner(np.zeros((3, 3)))
    for bad in (-1, float("nan")):
        with pytest.raises(ValueError, match="time_limit"):
            planner.plan(START, GOAL, time_limit=bad)


def test_no_time_is_an_answer(planner):
    late = planner.plan(START, GOAL, "mmas", iterations=10**6, time_limit=0)
    assert (late.status, late.limit) == ("limit", "time")


def test_an_observer_sees_and_stops(planner):
    seen = []

    def observe(progress):
        seen.append((progress.iteration, progress.best_length, progress.arrived, progress.ants))
        assert len(progress.curves) == progress.iteration + 1
        if progress.iteration == 4:
            trail = progress.pheromone(planner.grid)
            assert trail.shape == (200, 400) and trail.max() > 0
            assert trail[START[1], START[0]] == progress.pheromone_at(START)
            tours = [progress.tour(ant) for ant in range(progress.ants)]
            assert any(len(t) and t[0].tolist() == [14, 14] and t[-1].tolist() == [380, 179] for t in tours)
            assert lasius.path_length(progress.path()) == pytest.approx(progress.best_length)
            progress.stop()

    result = planner.plan(START, GOAL, "fan2004", observer=observe)
    assert result.status == "interrupted" and result.iterations == 5 and [s[0] for s in seen] == [0, 1, 2, 3, 4]
    assert result.curves.best.tolist() == [s[1] for s in seen]


def test_exact_shows_shorter_and_shorter_paths(planner):
    lengths = []
    result = planner.plan(START, GOAL, observer=lambda progress: lengths.append(progress.best_length))
    assert lengths == sorted(lengths, reverse=True) and lengths[-1] == result.length


def test_what_an_observer_raises_carries_the_result(planner):
    def fail(progress):
        if progress.iteration == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough") as caught:
        planner.plan(START, GOAL, "mmas", observer=fail)
    assert caught.value.result.status == "interrupted" and caught.value.result.iterations == 4
    assert caught.traceback[-1].name == "fail"


def test_progress_ends_with_the_callback(planner):
    kept = []
    planner.plan(START, GOAL, "mmas", iterations=2, observer=kept.append)
    for use in (lambda p: p.iteration, lambda p: p.path(), lambda p: p.stop(), lambda p: p.curves):
        with pytest.raises(RuntimeError, match="has ended"):
            use(kept[0])


def test_a_plan_within_a_callback(planner):
    inner = []
    outer = planner.plan(START, GOAL, "mmas", iterations=3, observer=lambda _: inner.append(planner.plan(START, GOAL)))
    assert outer.iterations == 3 and [r.length for r in inner] == [445.0006683543657] * 3


def test_results_are_values(planner):
    for result in (planner.plan(START, GOAL), planner.plan(START, GOAL, "ras", iterations=4), planner.plan(START, (999, 0))):
        for other in (pickle.loads(pickle.dumps(result)), copy.copy(result), copy.deepcopy(result)):
            assert other == result and other.params == result.params and other.grid == result.grid
        assert result != planner.plan((15, 14), GOAL) and result != 3
        assert result.status in repr(result)


def test_a_workspace_is_used_again_and_by_one_call_at_a_time(planner):
    workspace = lasius.Workspace()
    plain = planner.plan(START, GOAL, "acs", iterations=5)
    for _ in range(3):
        assert planner.plan(START, GOAL, "acs", iterations=5, workspace=workspace) == plain

    def again(_):
        planner.plan(START, GOAL, workspace=workspace)

    with pytest.raises(RuntimeError, match="in use"):
        planner.plan(START, GOAL, "acs", iterations=5, workspace=workspace, observer=again)
    assert planner.plan(START, GOAL, workspace=workspace).optimal


def test_alternatives(planner):
    result = planner.plan(START, GOAL, alternatives=2)
    first, second = result.alternatives
    assert result.length < first.length < second.length <= 1.3 * result.length
    for other in result.alternatives:
        assert np.array_equal(other.path[[0, -1]], result.path[[0, -1]])
        assert np.hypot(*np.diff(other.path, axis=0).T).sum() == pytest.approx(other.length, abs=1e-9)
    assert pickle.loads(pickle.dumps(result)) == result and result != planner.plan(START, GOAL)
    for bad in ({"params": "as"}, {"target_gap": 0.1}, {"via": [(200, 100)]}):
        with pytest.raises(lasius.InvalidParameter, match="alternatives are asked for"):
            planner.plan(START, GOAL, alternatives=1, **bad)


def test_a_planner_without_a_graph_of_its_own(planner):
    alone = lasius.Planner(planner.grid)
    alone.limit_own_graph(0)
    assert (alone.plan(START, GOAL).path == planner.plan(START, GOAL).path).all()
    with pytest.raises(TypeError, match="max_bytes"):
        alone.limit_own_graph("much")


def test_prepared_and_edited(planner, tmp_path):
    prepared = planner.prepared(threads=1)
    assert prepared.preparation.state == "ready" and prepared.preparation.edges > 0
    assert planner.preparation.state == "none" and prepared.plan(START, GOAL).length == 445.0006683543657
    assert lasius.Planner(planner.grid, prepare=True, max_bytes=1).preparation.state == "too_large"
    labelled = planner.prepared(threads=2, labels=True)
    assert labelled.preparation.labels == "ready" and labelled.preparation.label_entries > 0
    assert labelled.plan(START, GOAL).length == 445.0006683543657
    assert pickle.loads(pickle.dumps(labelled)).preparation.labels == "ready"
    labelled.save_preparation(tmp_path / "fan.prepared")
    loaded = planner.load_preparation(tmp_path / "fan.prepared")
    assert np.array_equal(loaded.plan(START, GOAL).path, labelled.plan(START, GOAL).path)
    with pytest.raises(lasius.FileBroken, match="prepared for another map"):
        planner.edited([[0, 0]], blocked=True).load_preparation(tmp_path / "fan.prepared")
    assert prepared.footprint[2] > 0 and pickle.loads(pickle.dumps(prepared)).preparation.state == "ready"
    path = planner.plan(START, GOAL).path
    x, y = (int(v) for v in path[1])
    around = [[x + dx, y + dy] for dx in range(-3, 4) for dy in range(-3, 4)]
    edited = planner.edited(around, blocked=True)
    assert edited.plan(START, GOAL).length > 445.0006683543657 == planner.plan(START, GOAL).length
    back = edited.edited(around, [not planner.grid.free(tuple(c)) for c in around])
    assert back.grid == planner.grid
    with pytest.raises(lasius.InvalidParameter):
        planner.edited([[999, 999]], True)
    with pytest.raises(TypeError, match="integers"):
        planner.edited([[1.5, 2]], True)
    with pytest.raises(ValueError):
        planner.edited([[1, 2, 3]], True)
    with pytest.raises(ValueError):
        planner.edited([[1, 2], [3, 4]], [True, False, True])
    assert planner.edited([], True).grid == planner.grid
    masked = np.ma.masked_array([[1, 1]], [[True, False]])
    for cells, blocked in (([[1, 1]], "x"), ([[1, 1]], None), ([[1, 1]], [1]), (masked, True), ([[1, 1]], masked[0] > 0)):
        with pytest.raises(TypeError, match="True or False|masked"):
            planner.edited(cells, blocked)
    assert planner.edited([[14, 14]], np.True_).grid != planner.grid


@pytest.mark.parametrize("threads", [-1, 1025, 2**40])
def test_threads_out_of_range(planner, threads):
    for use in (lambda: lasius.Planner(planner.grid, threads=threads), lambda: planner.prepared(threads=threads),
                lambda: planner.batch([START], [GOAL], threads=threads), lambda: lasius.Params("as", threads=threads),
                lambda: planner.plan(START, GOAL, threads=threads)):
        with pytest.raises(lasius.InvalidParameter, match=f"threads is {threads}.*1024"):
            use()


def test_excluded_directions():
    planner = lasius.Planner(lasius.Grid(np.zeros((3, 5), np.uint8), free=0))
    closed = planner.exclude([[1, 1, 1, 0]])
    assert closed.excluded.tolist() == [[1, 1, 1, 0]] and planner.excluded.shape == (0, 4)
    assert closed.plan((0, 1), (4, 1)).length > 4 == planner.plan((0, 1), (4, 1)).length
    assert pickle.loads(pickle.dumps(closed)).excluded.tolist() == [[1, 1, 1, 0]]
    assert closed.allow([[1, 1, 1, 0]]).plan((0, 1), (4, 1)).length == 4
    with pytest.raises(lasius.InvalidParameter):
        planner.exclude([[1, 1, 2, 0]])


def test_questions_about_the_map(planner):
    assert planner.connected(START, GOAL) and planner.nearest_free((-5, 300)) == (0, 199)
    assert planner.components() >= planner.components("allow") >= 1
    with pytest.raises(lasius.InvalidParameter, match="one-side"):
        planner.components("never")


def test_a_disc_is_led_out_of_where_it_stands_too_near():
    cells = np.zeros((18, 30), np.uint8)
    cells[8:14, 9:11] = 1
    planner = lasius.Planner(lasius.Grid(cells, free=0), radius=2.3)
    led = planner.plan((8, 10), (20, 12))
    assert led.status == "solved" and not led.optimal and led.lower_bound is None and led.radius == 2.3
    assert np.allclose(led.way_out, (6.7, 10.5)) and led.path[:2].tolist() == [[8.5, 10.5], list(led.way_out)]
    assert led.curve[0].end == led.way_out and pickle.loads(pickle.dumps(led)) == led
    assert planner.plan((8, 10), (20, 12), "acs", iterations=2).way_out == (6.5, 10.5)
    assert planner.plan((2, 3), (20, 12)).way_out is None
    short = planner.plan((2, 3), (8, 10), goal_tolerance=2)
    assert short.goal_reached == (6, 10) and np.allclose(short.path[-1], (6.7, 10.5)) and short.optimal
