"""Vehicles: what is planned is within their means, touches nothing, and is told whole."""

import dataclasses
import itertools
import pickle

import numpy as np
import pytest

import lasius
from lasius import SpeedLimits, Vehicle, VehiclePlanner, plan_vehicle


@pytest.fixture(scope="module")
def yard():
    cells = np.zeros((60, 80), np.uint8)
    cells[0:30, 30:33] = cells[40:60, 50:53] = 1
    return lasius.Grid(cells, free=0)


CAR = Vehicle.car(Vehicle.rectangle(1, 4, 1.5), 5.0)


def corners(footprint, pose):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.asarray(footprint) @ np.array([[c, s], [-s, c]]) + pose[:2]


def test_a_plan_and_its_poses(yard):
    start, goal = (8, 8, 0.3), (70, 50, -2.0)
    result = plan_vehicle(yard, CAR, start, goal)
    assert result.status == "solved" and result.goal == 0
    poses = result.poses(0.25)
    assert poses[0, :3] == pytest.approx(start) and poses[-1, :2] == pytest.approx(goal[:2], abs=1e-6)
    assert abs(np.remainder(poses[-1, 2] - goal[2] + np.pi, 2 * np.pi) - np.pi) < 1e-6
    assert np.all(np.abs(poses[:, 3]) <= 1 / 5 + 1e-12) and np.all(np.diff(poses[:, 6]) >= 0)
    assert np.hypot(*np.diff(poses[:, :2], axis=0).T).max() <= 0.25 + 1e-9
    for pose in poses:
        x, y = corners(CAR.footprint, pose).T
        assert x.min() > 0 and y.min() > 0 and x.max() < 80 and y.max() < 60
    assert VehiclePlanner(yard, CAR).first_contact(poses[:, :3]) is None
    assert result.poses(limits=SpeedLimits(speed=2, reverse_speed=2))[-1, 6] == pytest.approx(poses[-1, 6] / 2)
    assert pickle.loads(pickle.dumps(result)) == result == plan_vehicle(yard, CAR, start, goal)


def test_costs(yard):
    costs = lasius.CostField(yard)
    hill = np.zeros((60, 80))
    hill[:40, 36:46] = 1
    costs.add(hill, 5)
    start, goal = (10, 10, 0), (70, 10, 0)
    over = plan_vehicle(yard, CAR, start, goal, costs=costs)
    brief = plan_vehicle(yard, CAR, start, goal)
    assert over.lower_bound <= over.cost < 1.1 * over.lower_bound and over.length > brief.length
    assert over.gap == pytest.approx(over.cost / over.lower_bound - 1)
    assert VehiclePlanner(yard, CAR, lasius.CostField(yard)).plan(start, goal) == brief
    with pytest.raises(lasius.InvalidParameter):
        VehiclePlanner(yard, CAR, lasius.CostField(lasius.Grid(np.zeros((5, 5), np.uint8), free=0)))


def test_a_slow_wheel(yard):
    slow = dataclasses.replace(CAR, curvature_rate=0.1)
    result = plan_vehicle(yard, slow, (8, 8, 0.3), (70, 50, -2.0))
    assert result.status == "solved" and result.corners <= 2
    assert 0.09 < np.abs(result.segments[:, 4]).max() <= 0.1 + 1e-12
    poses = result.poses(0.05, SpeedLimits(acceleration=1, braking=1, steady_curvature=True))
    jumps = (np.abs(np.diff(poses[:, 3])) > 0.006) & (poses[1:, 4] == poses[:-1, 4])
    assert np.count_nonzero(jumps) == result.corners and np.all(poses[:-1, 5][jumps] == 0)


def test_contacts(yard):
    planner = VehiclePlanner(yard, CAR)
    assert planner.free((8, 8, 0)) and not planner.free((28, 8, 0))
    met = planner.first_contact([(8, 8, 0), (20, 8, 0), (40, 8, 0)])
    assert met.cell == (30, met.cell[1]) and met.place == pytest.approx(1 + 6 / 20, abs=1e-3)
    blocked = planner.plan((28, 8, 0), (70, 50, 0))
    assert (blocked.status, blocked.fault, blocked.touched[0]) == ("invalid", "start_blocked", 30)
    assert np.isnan(blocked.length) and blocked.segments.shape == (0, 8) and blocked.poses().shape == (0, 7)


def test_one_of_several_goals_and_tolerances(yard):
    planner = VehiclePlanner(yard, CAR)
    goals = [(70, 50, 0), (20, 8, 0)]
    assert planner.plan((8, 8, 0), goals).goal == 1
    assert planner.plan((8, 8, 0), (20, 8, np.pi), heading_tolerance=np.pi).length == pytest.approx(12, abs=0.2)


def test_what_is_refused(yard):
    for vehicle, problem in [(Vehicle.car([[0, 0], [1, 0]], 3), "corners"),
                             (Vehicle.car([[0, 0], [2, 2], [2, 0], [0, 2]], 3), "footprint"),
                             (Vehicle(CAR.footprint), "turning_radius")]:
        with pytest.raises(lasius.InvalidParameter, match=problem):
            VehiclePlanner(yard, vehicle)
    with pytest.raises(lasius.InvalidParameter):
        plan_vehicle(yard, CAR, (8, 8, 0), (70, 50, 0), weight=0.5)


STOPS = [(8, 8, 0.3), (70, 50, -2.0), (20, 45, 1.0), (60, 10, 0.0)]


@pytest.mark.parametrize("ends", [{}, {"open": True}, {"open": True, "start": 2}])
def test_a_tour_is_the_shortest_over_its_plans(yard, ends):
    planner = VehiclePlanner(yard, CAR)
    run = planner.tour(STOPS, **ends)
    length = {(a, b): planner.plan(STOPS[a], STOPS[b]).length for a, b in itertools.permutations(range(4), 2)}

    def legs(order):
        return list(zip(order, (*order[1:], *([] if ends.get("open") else order[:1]))))
    best = min(sum(length[leg] for leg in legs(order)) for order in itertools.permutations(range(4))
               if order[0] == ends.get("start", order[0]))
    assert run.status == "solved" and run.length == pytest.approx(best, abs=1e-2) and run.lower_bound <= run.length
    order = run.order.tolist()
    assert run.lengths == pytest.approx([length[leg] for leg in legs(order)]) and len(run.plans) == len(run.legs)
    assert run.poses == pytest.approx(np.array(STOPS)[order])
    for (a, b), plan, path in zip(legs(order), run.plans, run.legs):
        assert plan.status == "solved" and planner.first_contact(plan.poses()[:, :3]) is None
        assert plan.segments[0, :3] == pytest.approx(STOPS[a])
        assert path[[0, -1]] == pytest.approx(np.array([STOPS[a], STOPS[b]])[:, :2], abs=1e-6)


def test_a_tour_on_any_threads_and_its_options(yard):
    some = [(8, 8, 0.3), (70.5, 50.5, None), (20, 45, np.nan)]
    first, *others = [lasius.tour(yard, some, vehicle=CAR, start=0, threads=threads) for threads in (1, 2, 5)]
    assert all(first == other for other in others) and pickle.loads(pickle.dumps(first)) == first
    eighths = np.round(first.poses[1:, 2] / (np.pi / 4), 9)
    assert np.all(eighths == eighths.astype(int)) and first.poses[0, 2] == 0.3
    robot = Vehicle.differential(Vehicle.rectangle(2, 2, 1.5))
    cells = lasius.tour(yard, [[10, 40], [20, 40]], vehicle=robot)
    assert cells == lasius.tour(yard, [[10.5, 40.5], [20.5, 40.5]], vehicle=robot) and cells.length == pytest.approx(20)
    out = lasius.tour(yard, [*STOPS, (31, 8, 0)], vehicle=CAR, group=["a", "a", None, None, None])
    assert sorted(out.order) in ([0, 2, 3], [1, 2, 3]) and out.left_out.keys() == {4}
    two = lasius.tour(yard, STOPS, vehicle=CAR, robots=[0, 1], most_stops=1)
    assert [robot.start for robot in two.tours] == [0, 1] and [len(robot.legs) for robot in two.tours] == [2, 2]
    hill = np.where(np.arange(80) < 40, 1.0, 3.0) * np.ones((60, 1))
    over = lasius.tour(yard, STOPS, vehicle=CAR, costs=lasius.CostField.of(hill))
    assert over.lower_bound <= over.cost == pytest.approx(over.costs.sum()) and over.cost > over.length
    told = []
    VehiclePlanner(yard, CAR).tour(STOPS, observer=lambda order, length: told.append((len(order), length)))
    assert told and all(count == 4 for count, _ in told)


def test_what_is_refused_of_tours(yard):
    for stops, options, problem in [
            ([(8, 8, None), (20, 45, 0)], {"start": 0}, "yaw"), (STOPS, {"start": 4}, "no stop 4"), (STOPS, {"seed": -1}, "seed"),
            (STOPS, {"radius": 1.0}, "radius"), ([(8, 8, np.inf)], {}, "yaw"), (STOPS, {"group": ["a"]}, "group")]:
        with pytest.raises(lasius.InvalidParameter, match=problem):
            lasius.tour(yard, stops, vehicle=CAR, **options)
    for stops, error in [([[1, 2, 3, 4]], ValueError), ([("a", 2, 0)], TypeError), ([(8, 8), (20, 45, 0)], (TypeError, ValueError))]:
        with pytest.raises(error):
            lasius.tour(yard, stops, vehicle=CAR)
    with pytest.raises(TypeError, match="algorithm"):
        lasius.tour(yard, STOPS, vehicle=CAR, algorithm="as")


def test_a_navigator_keeps_its_way_and_learns_from_a_scan(yard):
    frame = lasius.WorldFrame(0.1, origin_x=-1.0, origin_y=2.0)
    navigator = lasius.VehicleNavigator(yard, CAR, (70, 50, 0))
    way = navigator.step((8, 8, 0))
    assert way.status == "solved" and way.replanned
    pose = way.poses(4.0)[3, :3]
    kept = navigator.step(tuple(pose))
    assert not kept.replanned and kept.length < way.length and kept.segments[0, :3] == pytest.approx(pose)
    # A wall across the way, 2 m ahead of where the scanner stands.
    x, y, yaw = kept.poses(2.0)[2, :3]
    sensor = (-1.0 + 0.1 * x, 2.0 + 0.1 * (60 - y), -yaw)
    angles = np.linspace(-1.0, 1.0, 201)
    free, blocked = lasius.cells_of_scan(sensor, 1.5 / np.cos(angles), -1.0, 0.01, 9.0, frame, yard)
    assert len(free) > 50 and len(blocked) > 20
    navigator.observe(free, False)
    navigator.observe(blocked, True)
    other = navigator.step(tuple(pose))
    assert other.replanned and other.status == "solved"
    assert VehiclePlanner(navigator.map, CAR).first_contact(other.poses(0.25)[:, :3]) is None
    points = [(sensor[0] + 1, sensor[1])]
    assert lasius.cells_of_points(sensor[:2], points, 9.0, frame, yard)[1].shape == (1, 2)
    navigator.set_goal([(8, 8, 0), (70, 50, 0)])
    assert navigator.step((8, 8, 0)).goal == 0
    with pytest.raises(lasius.InvalidParameter):
        navigator.step((np.nan, 0, 0))


@pytest.fixture
def hill(yard):
    costs = lasius.CostField(yard)
    weights = np.zeros((60, 80))
    weights[:40, 36:46] = 1
    costs.add(weights, 5)
    return costs


SMALL = lasius.CostField(lasius.Grid(np.zeros((5, 5), np.uint8), free=0))


def test_a_navigator_goes_over_costs(yard, hill):
    start, goal = (10, 10, 0), (70, 10, 0)
    navigator = lasius.VehicleNavigator(yard, CAR, goal)
    brief = navigator.step(start)
    navigator.set_costs(hill)
    over = navigator.step(start)
    assert over.replanned and over.length > brief.length
    assert over.cost == plan_vehicle(yard, CAR, start, goal, costs=hill).cost
    assert lasius.VehicleNavigator(yard, CAR, goal, costs=hill).step(start) == over
    with pytest.raises(lasius.InvalidParameter):
        navigator.set_costs(SMALL)
    for wrong, problem in (({"costs": SMALL}, "costs"), ({"inflation": lasius.Inflation(-1, 1)}, "radius"),
                           ({"max_states": 0}, "max_states")):
        with pytest.raises(lasius.InvalidParameter, match=problem):
            lasius.VehicleNavigator(yard, CAR, goal, **wrong).step(start)


def test_inflation_is_added_and_follows_what_is_observed(yard, hill):
    start, goal, around = (10, 10, 0), (70, 10, 0), lasius.Inflation(8, 0.4)
    navigator = lasius.VehicleNavigator(yard, CAR, goal, costs=hill, inflation=around)
    both = lasius.CostField(yard)
    both.add(hill.weights - 1)
    both.inflate(yard, 8, 0.4)
    assert navigator.step(start).cost == plan_vehicle(yard, CAR, start, goal, costs=both).cost
    navigator.observe_rectangle(56, 48, 3, 3, True)
    known = navigator.map
    later = lasius.CostField(yard)
    later.add(hill.weights - 1)
    later.inflate(known, *around[:2])
    navigator.forget()
    assert navigator.step(start).cost == plan_vehicle(known, CAR, start, goal, costs=later).cost


def test_a_drive_over_costs(yard, hill):
    start, goal = (10, 10, 0), (70, 10, 0)
    brief = lasius.drive_vehicle(yard, yard, CAR, start, goal)
    over = lasius.drive_vehicle(yard, yard, CAR, start, goal, costs=hill)
    wide = lasius.drive_vehicle(yard, yard, CAR, start, goal, inflation=(8, 0.4, 2, 1))
    assert [run.status for run in (brief, over, wide)] == ["solved"] * 3
    assert brief.cost == pytest.approx(brief.length) and over.length > brief.length
    assert over.cost == pytest.approx(plan_vehicle(yard, CAR, start, goal, costs=hill).cost)
    assert wide.cost > wide.length > brief.length
    with pytest.raises(lasius.InvalidParameter, match="costs"):
        lasius.drive_vehicle(yard, yard, CAR, start, goal, costs=SMALL)


def test_a_drive(yard):
    truth = yard.to_array(free=True)
    truth[20:60, 40:42] = False
    world, start, goal = lasius.Grid(truth, free=True), (8, 8, 0), (70, 50, 0)
    changes = lasius.Changes()
    changes.add_change(tick=5, x=60, y=20, width=4, height=4, blocked=True)
    told = []
    run = lasius.drive_vehicle(yard, world, CAR, start, goal, changes=changes, sense=10,
                               observer=lambda tick: told.append((tick.robot, len(tick.path))))
    assert run.status == "solved" and len(run.poses) == run.ticks + 1 == len(run.track) and run.seen > 0
    assert run.poses[0] == pytest.approx(start) and run.poses[-1, :2] == pytest.approx(goal[:2], abs=1e-6)
    assert np.cos(run.poses[-1, 2] - goal[2]) == pytest.approx(1)
    assert len(run.moves) == run.ticks - run.waits and run.length == pytest.approx(run.moves[:, 5].sum())
    assert np.array_equal(np.floor(run.poses[:, :2]), run.track)
    judge = VehiclePlanner(world, CAR)
    assert all(judge.free(tuple(pose)) for pose in run.poses)
    assert told[0][0] == (8, 8) and told[0][1] > 1 and len(told) == len(run.track)
    assert pickle.loads(pickle.dumps(run)) == run and len(run.replans) > 1
    ended = lasius.drive_vehicle(yard, world, CAR, start, goal, observer=lambda tick: tick.stop())
    assert (ended.status, ended.ticks, ended.moves.shape) == ("interrupted", 0, (0, 8))
    assert lasius.drive_vehicle(yard, world, CAR, start, goal, max_ticks=3).limit == "ticks"
    for wrong, problem in (({"goal": (np.nan, 1, 0)}, "goal"), ({"start": (np.inf, 1, 0)}, "start"),
                           ({"sense": 0.0}, "sense"), ({"seed": -1}, "seed")):
        with pytest.raises(lasius.InvalidParameter, match=problem):
            lasius.drive_vehicle(yard, world, CAR, **{"start": start, "goal": goal, **wrong})
