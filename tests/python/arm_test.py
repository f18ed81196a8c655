"""Arms from files, goals of every kind, motions."""

import pickle

import numpy as np
import pytest

import lasius

arm = pytest.importorskip("lasius.arm", reason="built without the component arm")


@pytest.fixture(scope="module")
def robot(maps):
    return arm.Robot.read(maps / "arms/planar3.json")


@pytest.fixture(scope="module")
def query(robot):
    return robot.random_query(seed=4, obstacles=3)


def test_kinematics_at_zero(robot):
    assert len(robot) == 3 == len(robot.joint_names) and robot.limits[0].shape == (3,)
    position, pose = robot.tip_position([0, 0, 0]), robot.tip_pose(np.zeros(3))
    assert position.shape == (3,) and pose.shape == (4, 4) and np.array_equal(pose[:3, 3], position)
    assert np.linalg.norm(robot.tip_position([0.5, 0, 0])) == pytest.approx(np.linalg.norm(position))
    with pytest.raises(lasius.InvalidParameter):
        robot.tip_position([0, 0])


def test_goals_of_every_kind(robot, query):
    goals = [arm.Goal.position(query.goal), arm.Goal.joints(query.goal_joints),
             arm.Goal.pose(robot.tip_pose(query.goal_joints), 1e-3, 1e-2)]
    for goal in goals:
        result = arm.plan(robot, query.scene, query.start, goal, seed=2)
        assert result.status == "solved" and result.joints.shape[1] == 3 and result.tips.shape[1] == 3
        assert result.joints[0] == pytest.approx(query.start)
        assert robot.tip_position(result.joints[-1]) == pytest.approx(query.goal, abs=2e-3)
    assert arm.plan(robot, query.scene, query.start, goals, seed=2).goal in (0, 1, 2)


def test_a_pose_has_tolerances_with_defaults(robot, query):
    pose = robot.tip_pose(query.goal_joints)
    loose = arm.Goal.pose(pose, position_tolerance=1e-3, angle_tolerance=4)
    assert arm.plan(robot, query.scene, query.start, [arm.Goal.pose(pose), loose], seed=2).found
    assert arm.TOLERANCE == 1e-7
    tight = arm.plan(robot, query.scene, query.start, arm.Goal.pose(pose, position_tolerance=1e-8))
    assert tight.status == "invalid" and "1e-07" in tight.error
    for make, words in ((lambda: arm.Goal.position([1, 2]), r"position has the shape \(2,\): give \(3,\)"),
                        (lambda: arm.Goal.pose(np.eye(3)), r"pose has the shape \(3, 3\): give \(4, 4\)"),
                        (lambda: arm.Goal.joints([[1]]), r"joints has the shape \(1, 1\): give \(n,\)")):
        with pytest.raises(ValueError, match=words):
            make()
    with pytest.raises(TypeError, match="position is 'x'"):
        arm.Goal.position("x")


def test_a_motion_is_smooth_and_free(robot, query):
    result = arm.plan(robot, query.scene, query.start, arm.Goal.position(query.goal), seed=2)
    motion = result.trajectory
    states = motion.at(np.linspace(0, motion.duration, 50))
    assert states.q.shape == states.dq.shape == (50, 3) and states.dq[0] == pytest.approx(np.zeros(3))
    assert states.q[0] == pytest.approx(query.start) and motion.at(1e9).q[0] == pytest.approx(result.joints[-1])
    check = arm.recheck(robot, query.scene, motion, 200)
    assert (check.samples, check.contacts, check.limits, check.unproven) == (200, 0, 0, 0)
    assert pickle.loads(pickle.dumps(result)) == result
    assert result.questions.positions >= 0 and len(result.points) == 3


def test_no_motion(robot, query):
    result = arm.plan(robot, query.scene, query.start, arm.Goal.position(query.goal), motion=False, threads=2)
    assert not result.trajectory and result.found
    with pytest.raises(ValueError, match="empty"):
        result.trajectory.at(0)


def test_an_observer_sees_the_best_way(robot):
    query, seen = robot.random_query(seed=5, obstacles=3), []
    result = arm.plan(robot, query.scene, query.start, arm.Goal.position(query.goal), "goritov2020",
                      iterations=5, observer=lambda progress: seen.append(progress.joints()))
    assert len(seen) == 5 and np.array_equal(seen[-1], result.joints)


def test_what_is_refused(robot, query, tmp_path):
    assert arm.plan(robot, query.scene, [0, 0], arm.Goal.position(query.goal)).status == "invalid"
    with pytest.raises(lasius.InvalidParameter, match="pitch"):
        arm.Params(pich=1)
    with pytest.raises(lasius.FileMissing):
        arm.Robot.read(tmp_path / "none.urdf")
    for goals in ([query.goal], query.goal):
        with pytest.raises(TypeError, match="goals has .*: give Goal.position"):
            arm.plan(robot, query.scene, query.start, goals)
    with pytest.raises(TypeError, match="scene is a Robot: give a lasius.arm.Scene"):
        arm.plan(robot, robot, query.start, arm.Goal.position(query.goal))
    with pytest.raises(TypeError, match="start is 'abc': give an array"):
        arm.plan(robot, query.scene, "abc", arm.Goal.position(query.goal))
    outside = arm.plan(robot, query.scene, query.start, arm.Goal.position([99, 0, 0]))
    assert outside.status == "invalid" and outside.error


def test_parameters_and_scenes(robot, maps):
    assert arm.Params(direct=False).direct is False and arm.Params().direct is True
    assert pickle.loads(pickle.dumps(arm.Params("goritov2020", ants=9))) == arm.Params("goritov2020", ants=9)
    assert len(arm.Scene()) == 0 and len(arm.Scene.read(maps / "arms/cell.json")) > 0
    assert arm.position_free(robot, arm.Scene(), np.zeros(3))
    assert arm.distance(robot, arm.Scene(), [0.0, 2.5, 1.9]) == 0.0  # links 1 and 3 touch
    far = arm.distance(robot, arm.Scene(), np.zeros(3))
    assert far > 2 * arm.LEAST_CLEARANCE and arm.contact(robot, arm.Scene(), np.zeros(3)) == ""
    assert arm.position_free(robot, arm.Scene(), np.zeros(3), far / 2.001)
    assert not arm.position_free(robot, arm.Scene(), np.zeros(3), far / 1.999)  # twice the clearance counts
    assert "m apart (less than twice the clearance" in arm.contact(robot, arm.Scene(), np.zeros(3), far / 1.999)


def test_values_a_hair_outside_of_the_limits(robot):
    low, high = robot.limits
    result = arm.plan(robot, arm.Scene(), [0, 0, high[2] + 5e-4], arm.Goal.joints([0.1, 0, 0]))
    assert result.status == "solved" and result.joints[0, 2] == high[2]
    assert len(result.notes) == 1 and "start: joint 3 (wrist)" in result.notes[0]
    assert arm.plan(robot, arm.Scene(), [0, 0, high[2] + 2e-3], arm.Goal.joints([0.1, 0, 0])).status == "invalid"


def test_a_mesh_in_millimetres_is_warned_of(tmp_path):
    corners = "facet\nvertex 0 0 0\nvertex 900 0 0\nvertex 0 1 0\nendfacet\n"
    (tmp_path / "m.stl").write_text(f"solid s\n{corners}endsolid\n")
    link = '<collision><geometry><mesh filename="m.stl"/></geometry></collision>'
    (tmp_path / "r.urdf").write_text(
        f'<robot name="r"><link name="a"/><link name="b">{link}</link><joint name="j" type="continuous">'
        '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>')
    (tmp_path / "s.json").write_text('{"format": "lasius-scene/1", "obstacles": [{"shape": "mesh", "file": "m.stl"}]}')
    for read in (lambda: arm.Robot.read(tmp_path / "r.urdf"), lambda: arm.Scene.read(tmp_path / "s.json")):
        with pytest.warns(UserWarning, match="m.stl is 900 m long: if it is in millimetres") as told:
            read()
        assert told[0].filename == __file__


URDF = """<robot name="two"><link name="base"/><link name="upper"/><link name="tip"/>
<joint name="a" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
<joint name="b" type="revolute"><parent link="upper"/><child link="tip"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>"""


def test_urdf(tmp_path):
    (tmp_path / "two.urdf").write_text(URDF)
    with pytest.raises(lasius.FileBroken, match="collision"):
        arm.Robot.read(tmp_path / "two.urdf")
    two = arm.Robot.read(tmp_path / "two.urdf", bodiless=True)
    assert two.joint_names == ["a", "b"] and two.limits[1].tolist() == [2, 1] and two.name == "two"
    assert two.tip_position([np.pi / 2, 0]) == pytest.approx([0, 1, 0])


def moved(*by):
    pose = np.eye(4)
    pose[:3, 3] = by
    return pose


def test_scenes_and_what_is_held_are_made_of_solids(maps):
    robot, q = arm.Robot.read(maps / "arms/industrial6.json"), [0.3, 0.4, 0.7, 0.2, 0.6, 0.1]
    tip = robot.tip_pose(q)
    square = [[[-1, -1, 0], [1, -1, 0], [1, 1, 0]], [[-1, -1, 0], [1, 1, 0], [-1, 1, 0]]]
    for thing in (arm.Solid.sphere(0.05, tip @ moved(0, 0, 0.18), name="it"),
                  arm.Solid.box([0.1, 0.1, 0.1], tip @ moved(0, 0, 0.18), "it"),
                  arm.Solid.cylinder(0.2, 0.1, tip @ moved(0, 0, 0.18), "it"),
                  arm.Solid.capsule(0.05, [0, 0, 1], tip @ moved(0, 0, 0.18), "it"),
                  arm.Solid.mesh(0.1 * np.array(square), tip @ moved(0, 0, 0.13), "it")):
        scene = arm.Scene.of([thing])
        bare = arm.nearest(robot, scene, q)
        held = robot.holding([arm.Solid.sphere(0.01, moved(0, 0, 0.1))], "grip")
        distance, link, other = arm.nearest(held, scene, q)
        assert distance == pytest.approx(0.02, abs=1e-6) and "grip" in link and "it" in other
        assert bare[0] > distance and len(scene) == 1 and len(held) == 6
    with pytest.raises(TypeError, match="Solid.box"):
        arm.Scene.of([3])
    with pytest.raises(ValueError, match=r"\(n, 3, 3\)"):
        arm.Solid.mesh([[1, 2, 3]])
    with pytest.raises(lasius.InvalidParameter):
        arm.Scene.of([arm.Solid.sphere(-1)])


def test_inverse_kinematics_and_straight_motions_of_the_tip(maps):
    robot, q = arm.Robot.read(maps / "arms/industrial6.json"), np.array([0.3, 0.4, 0.7, 0.2, 0.6, 0.1])
    pose = robot.tip_pose(q)
    found = robot.inverse(arm.Goal.pose(pose), q)
    assert len(found) > 2 and found[0] == pytest.approx(q, abs=1e-5)
    for other in found:
        assert robot.tip_pose(other) == pytest.approx(pose, abs=1e-6)
    line = arm.tip_line(robot, arm.Scene(), q, moved(0.05, -0.2, -0.1) @ pose)
    assert line.status == "solved" and line.reached == 1 and line.error == "" and len(line.joints) > 2
    for a, b in zip(line.joints, line.joints[1:]):
        assert arm.motion_free(robot, arm.Scene(), a, b)
        off = np.cross(robot.tip_position((a + b) / 2) - pose[:3, 3], [0.05, -0.2, -0.1]) / 0.229
        assert np.linalg.norm(off) <= 1e-3
    assert not line.trajectory
    assert arm.tip_line(robot, arm.Scene(), q, moved(9, 0, 0) @ pose).status == "invalid"


def test_a_straight_motion_in_time(maps):
    robot, q = arm.Robot.read(maps / "arms/industrial6.json"), np.array([0.3, 0.4, 0.7, 0.2, 0.6, 0.1])
    pose, way = robot.tip_pose(q), np.array([0.05, -0.2, -0.1])
    line = arm.tip_line(robot, arm.Scene(), q, moved(*way) @ pose, motion=True, duration=20.0)
    assert line.status == "solved" and not line.stops and line.trajectory.duration == 20.0
    for joints in line.trajectory.at(np.linspace(0, 20, 101)).q:
        assert np.linalg.norm(np.cross(robot.tip_position(joints) - pose[:3, 3], way)) <= 1e-3 * np.linalg.norm(way)
