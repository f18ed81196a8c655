"""Pickles of every protocol, and copies."""

import copy
import pickle

import numpy as np
import pytest

import lasius

PROTOCOLS = range(pickle.HIGHEST_PROTOCOL + 1)


def small_planner():
    return lasius.Planner(lasius.Grid(np.zeros((9, 9), np.uint8), free=0))


def values():
    planner = small_planner()
    grid = planner.grid
    changes = [planner.plan((0, 0), (8, 8)), planner.plan((0, 0), (8, 8), "as", iterations=2), planner.batch([[0, 0]], [[8, 8]]),
               lasius.Navigator(grid, (8, 8)).step((0, 0)), lasius.drive(grid, grid, (0, 0), (8, 8)),
               planner.tour([[0, 0], [8, 8], [0, 8]])]
    return [grid, lasius.Params("mmas", ants=3), *changes]


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_every_protocol(protocol):
    for value in values():
        assert pickle.loads(pickle.dumps(value, protocol)) == value
    frame = pickle.loads(pickle.dumps(lasius.WorldFrame(0.5, 1, 2, 3), protocol))
    assert (frame.resolution, frame.origin_x, frame.origin_y, frame.yaw) == (0.5, 1, 2, 3)
    planner = pickle.loads(pickle.dumps(small_planner().prepared(threads=1), protocol))
    assert planner.plan((0, 0), (8, 8)).optimal and planner.preparation.state == "ready"


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_what_does_not_pickle_says_so(protocol):
    for value in (lasius.Workspace(), lasius.Navigator(small_planner().grid, (8, 8)), lasius.Params("mmas")._raw):
        with pytest.raises(TypeError, match="pickle"):
            pickle.dumps(value, protocol)


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_motion_of_an_arm(maps, protocol):
    arm = pytest.importorskip("lasius.arm", reason="built without the component arm")
    robot = arm.Robot.read(maps / "arms/planar3.json")
    query = robot.random_query(seed=4, obstacles=3)
    result = arm.plan(robot, query.scene, query.start, arm.Goal.position(query.goal), seed=2)
    assert pickle.loads(pickle.dumps(result, protocol)) == result


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda p: pickle.loads(pickle.dumps(p))])
def test_a_copy_frees_what_was_excluded(copied):
    closed = small_planner().exclude([[5, 5, 1, 0]])
    other = copied(closed)
    assert other.plan((0, 5), (6, 5)).fault == closed.plan((0, 5), (6, 5)).fault == "goal_blocked"
    assert other.grid == closed.grid and other.excluded.tolist() == [[5, 5, 1, 0]]
    assert other.allow([[5, 5, 1, 0]]).plan((0, 5), (6, 5)).length == 6
    assert copied(closed.prepared(threads=1)).preparation.state == "ready"
