"""lasius arm: results, files, exit codes and every kind of bad input."""
import csv
import io
import json
import math
import os
import re
import shutil
import unittest

from program import MAPS, ProgramTest

ARMS = os.path.join(MAPS, "arms")
PLANAR = os.path.join(ARMS, "planar3.json")
FLAT = os.path.join(ARMS, "flat.json")

TWO_JOINTS = """<robot name="two">
  <link name="foot"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.25 0 0" rpy="0 1.5707963 0"/>
    <geometry><cylinder radius="0.03" length="0.5"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.2 0 0"/>
    <geometry><box size="0.4 0.05 0.05"/></geometry></collision></link>
  <link name="tool"/>
  <joint name="turn" type="revolute"><parent link="foot"/><child link="upper"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="2" effort="1"/></joint>
  <joint name="bend" type="revolute"><parent link="upper"/><child link="lower"/>
    <origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-2.5" upper="2.5" velocity="2" effort="1"/></joint>
  <joint name="end" type="fixed"><parent link="lower"/><child link="tool"/>
    <origin xyz="0.4 0 0"/></joint>
</robot>
"""

ROBOTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "core", "arm", "robots")


UR5_START, UR5_GOAL = "0.1,-1.2,1.4,-1.5,0.2,0.3", "0.8,-1.5,1.2,-1,0.5,0"
SRDF = """<?xml version="1.0"?>
<robot name="ur5_gripper">
  <group name="arm"><chain base_link="base_link" tip_link="tool0"/></group>
  <group_state name="home" group="arm">
    <joint name="shoulder_pan_joint" value="0.1"/><joint name="shoulder_lift_joint" value="-1.2"/>
    <joint name="elbow_joint" value="1.4"/><joint name="wrist_1_joint" value="-1.5"/>
    <joint name="wrist_2_joint" value="0.2"/><joint name="wrist_3_joint" value="0.3"/>
  </group_state>
  <group_state name="up" group="arm">
    <joint name="shoulder_pan_joint" value="0.6"/><joint name="shoulder_lift_joint" value="-1.4"/>
    <joint name="elbow_joint" value="0.9"/><joint name="wrist_1_joint" value="-1.2"/>
    <joint name="wrist_2_joint" value="0.2"/><joint name="wrist_3_joint" value="0.3"/>
  </group_state>
  <disable_collisions link1="left_finger" link2="forearm_link" reason="Never"/>
</robot>
"""
LIMITS = """joint_limits:
  shoulder_pan_joint:
    has_velocity_limits: true
    max_velocity: 0.25
    has_acceleration_limits: true
    max_acceleration: 2.0
"""


def planar_tip(q):
    angle, tip = 0, [0, 0, 0]
    for value, length in zip(q, (0.4, 0.3, 0.2)):
        angle += value
        tip[0] += length * math.cos(angle)
        tip[1] += length * math.sin(angle)
    return tip


def read_ros_trajectory(text):
    """As a YAML reader sees it; where there is none, by the form in which it is written."""
    try:
        import yaml
        return yaml.safe_load(text)
    except ImportError:
        pass
    message, lines = {"joint_names": [], "points": []}, text.splitlines()
    number = r"-?\d+\.\d+(?:e[-+]\d+)?"
    for line in lines:
        if match := re.fullmatch(r'  - "(.*)"', line):
            message["joint_names"].append(match[1])
        elif match := re.fullmatch(rf"  ([- ]) (\w+): \[((?:{number}(?:, )?)+)\]", line):
            if match[1] == "-":
                message["points"].append({})
            message["points"][-1][match[2]] = [float(value) for value in match[3].split(", ")]
        elif match := re.fullmatch(r"    time_from_start: {sec: (\d+), nanosec: (\d+)}", line):
            message["points"][-1]["time_from_start"] = {"sec": int(match[1]),
                                                        "nanosec": int(match[2])}
        elif line not in ("joint_names:", "points:", "points: []"):
            raise ValueError(line)
    return message


EMPTY = '{"format": "lasius-scene/1", "obstacles": []}'


class Arm(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("empty.json", EMPTY)

    def arm(self, *arguments, robot=PLANAR, scene=FLAT, start="-0.3,0.5,0.5", goal="0.4,0.5,0",
            **options):
        asked = () if goal is None else ("--goal", goal)
        return self.run_program("arm", robot, "--scene", scene, "--start", start, *asked,
                                *arguments, **options)

    def test_the_source_goes_to_joint_values_in_the_time_prescribed(self):
        goal = ("--goal-joints", "0.1,1.15,0.82", "--algorithm", "goritov2020", "--iterations", "9")
        run = self.arm("--json", "-o", "slow.json", "--duration", "7", *goal, goal=None)
        self.assertEqual(run.code, 0, run.err)
        slow = run.json
        self.assertEqual((slow["duration"], slow["parameters"]["duration"]), (7, 7))
        self.assertEqual(slow["trajectory"]["knots"]["t"][-1], 7)
        self.assertEqual(slow["joints"][-1], [0.1, 1.15, 0.82])
        self.assertEqual(slow["parameters"]["initial_pheromone"], 0.01)
        fast = self.arm("--json", *goal, goal=None).json
        self.assertLess(fast["duration"], 7)
        self.assertIsNone(fast["parameters"]["duration"])
        self.assertEqual(fast["questions"], slow["questions"])
        self.assertEqual(self.run_program("verify", "slow.json").code, 0)
        hurried = self.arm("--json", "--duration", "0.01", *goal, goal=None)
        self.assertEqual(hurried.json["duration"], fast["duration"])
        self.assertIn("as the joints' limits ask, not 0.01 s", hurried.err)
        self.refused(self.arm("--duration", "0"), 2, "--duration")

    def test_a_motion_with_all_that_json_promises(self):
        run = self.ended(self.arm("--json", "--algorithm", "goritov2020", "--iterations", "20",
                                  "--recheck", "200"), 0)
        result = run.json
        self.assertEqual(result["format"], "lasius-arm-plan/1")
        self.assertEqual((result["status"], result["error"]), ("solved", None))
        self.assertEqual(result["algorithm"], "goritov2020")
        moves = len(result["path"]) - 1
        self.assertAlmostEqual(result["length"], moves * result["lattice"]["pitch"])
        self.assertEqual(len(result["joints"]), moves + 1)
        self.assertEqual(result["path"][-1], [0.4, 0.5, 0])
        self.assertEqual([len(result[name]) for name in ("best", "mean", "arrived")], [20] * 3)
        self.assertLessEqual(result["lower_bound"], result["length"])
        self.assertGreater(result["questions"]["positions"], moves)
        self.assertEqual(result["recheck"]["samples"], 200)
        for key in ("contacts", "limits", "unproven"):
            self.assertEqual(result["recheck"][key], 0)
        samples = result["trajectory"]["samples"]
        self.assertEqual(samples["q"][0], [-0.3, 0.5, 0.5])
        for end in (0, -1):
            self.assertEqual(samples["dq"][end], [0, 0, 0])
            self.assertEqual(samples["ddq"][end], [0, 0, 0])
        self.assertAlmostEqual(samples["t"][-1], result["trajectory"]["duration"])
        self.assertLess(math.dist(samples["tip"][-1], [0.4, 0.5, 0]), 1e-6)
        lengths = [len(samples[name]) for name in ("t", "q", "dq", "ddq", "tip")]
        self.assertEqual(len(set(lengths)), 1)

    def test_threads_change_nothing(self):
        results = []
        for threads in (1, 2, 5):
            result = self.arm("--json", "--iterations", "6", "--threads", threads).json
            for volatile in ("threads", "elapsed_ms"):
                del result[volatile]
            results.append(result)
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])

    def test_files(self):
        run = self.quiet(self.arm("-q", "--iterations", "5", "--set", "trees=0", "-o", "m.json", "-o", "m.csv", "-o",
                                  "m.svg", "-o", "m.png"))
        self.assertEqual(json.loads(self.read("m.json"))["status"], "solved")
        rows = list(csv.reader(io.StringIO(self.read("m.csv").decode())))
        names = ["shoulder", "elbow", "wrist"]
        self.assertEqual(rows[0], ["t", *names, *(name + "_velocity" for name in names),
                                   *(name + "_acceleration" for name in names), "x", "y", "z"])
        self.assertTrue(all(len(row) == 13 for row in rows))
        self.assertGreater(self.png_size("m.png")[0], 1000)
        self.holds(self.words("m.svg"), "tip at the start", "goal of the tip", "arm at the start",
                   "arm at the end", "way of the tip", "obstacle", "base", "x, m", "y, m", "z, m",
                   "time, s", "questions asked", *names)
        self.assertEqual(run.out.splitlines()[0], "solved")

    def test_goals_of_every_kind(self):
        def reached(*arguments):
            run = self.ended(self.arm("--json", *arguments, goal=None), 0)
            return run.json, run.json["trajectory"]["samples"]
        result, samples = reached("--goal-joints", "-0.8,0.4,0.3")
        for value, wanted in zip(samples["q"][-1], (-0.8, 0.4, 0.3)):
            self.assertAlmostEqual(value, wanted)
        self.assertEqual(result["goals"], [{"kind": "joints", "values": [-0.8, 0.4, 0.3]}])
        self.assertEqual(result["goal_reached"], 0)
        self.assertLess(math.dist(result["goal"], planar_tip((-0.8, 0.4, 0.3))), 1e-9)
        result, samples = reached("--goal-pose", "0.4,0.5,0,0,0,2", "--angle-tolerance", "0.01",
                                  "--position-tolerance", "1e-4")
        self.assertLess(abs(sum(samples["q"][-1]) - 2), 0.011)
        self.assertLess(math.dist(samples["tip"][-1], (0.4, 0.5, 0)), 1.1e-4)
        self.assertEqual(result["goals"][0], {
            "kind": "pose", "values": [0.4, 0.5, 0, 0, 0, 2], "position_tolerance": 1e-4,
            "angle_tolerance": 0.01})
        run = self.ended(self.arm("--angle-tolerance", "0.1", "--goal-joints", "-0.8,0.4,0.3", goal=None), 0)
        self.assertIn("--angle-tolerance has no effect without --goal-pose", run.err)
        # Any one of several, in the order of the command line.
        result, samples = reached("--goal-joints", "3,2.5,2", "--goal", "0.4,0.5,0",
                                  "--goal", "0.8,0.2,0")
        self.assertEqual([goal["kind"] for goal in result["goals"]],
                         ["joints", "position", "position"])
        self.assertIn(result["goal_reached"], (1, 2))
        goal = result["goals"][result["goal_reached"]]["values"]
        self.assertLess(math.dist(samples["tip"][-1], goal), 1e-6)
        self.assertEqual(result["goal"], goal)

    def test_effort_and_travel(self):
        result = self.arm("--json", "--set", "direct=off", "--set", "trees=0").json
        asked = result["questions"]["by_iteration"]
        for name in ("positions", "motions"):
            self.assertEqual(len(asked[name]), result["iterations"])
            self.assertEqual(asked[name], sorted(asked[name]))
            self.assertLessEqual(asked[name][-1], result["questions"][name])
        self.assertFalse(result["direct"])
        samples = result["trajectory"]["samples"]
        self.assertEqual(result["duration"], result["trajectory"]["duration"])
        for name, points in (("tip_travel", samples["tip"]), ("joint_travel", samples["q"])):
            sampled = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
            self.assertGreater(result[name], 0.98 * sampled)
        fewer = self.arm("--json", "--set", "direct=off", "--set", "trees=0", "--max-questions", "20")
        counts = fewer.json["questions"]
        self.assertLessEqual(counts["positions"] + counts["motions"] + counts["trajectory"], 20)
        self.assertEqual((fewer.code, fewer.json["status"]), (6, "limit"))
        self.assertIn("--max-questions ended the run", fewer.err)
        self.assertNotIn("no time", fewer.err)
        self.write("fewer.json", fewer.out)
        self.assertEqual(self.run_program("verify", "fewer.json").code, 0)
        # Parameters that are gone: idle ones are passed over, others are refused.
        old = self.arm("--json", "--algorithm", "goritov2020", "--iterations", "3").json
        old["parameters"].update(postures=1, lines=0, leash=0, vias=0, refine=0, prove="off", scout="off")
        old["lattice"]["postures"] = 3
        old["version"] = "0.3.0"
        self.write("old.json", json.dumps(old))
        self.assertEqual(self.run_program("verify", "old.json").code, 0)
        old["parameters"]["leash"] = 2
        self.write("old.json", json.dumps(old))
        self.ended(self.run_program("verify", "old.json"), 2, "parameter leash, which is gone")
        met = self.arm("--json", "--set", "direct=off").json
        waiting = re.findall(r"^  (\w+)=.*\(trees=0\)$", self.run_program("algorithms", "postures").out, re.MULTILINE)
        self.assertEqual(len(waiting), 12)
        for name in waiting:
            value = {"dead_end": "kill", "pheromone": "edges", "persistence": "0.3"}.get(name, "3")
            run = self.ended(self.arm("--json", "--set", "direct=off", "--set", f"{name}={value}"), 0,
                             f"--set {name}={value} has no effect: it is read only with trees=0")
            self.assertEqual(*({**r, "parameters": {}, "elapsed_ms": 0} for r in (met, run.json)))
        self.assertNotIn("no effect", self.arm("--set", "pitch=0.2", "--set", "shortcut=off").err)
        self.assertEqual((met["trees"], met["iterations"], met["status"]), (True, 0, "solved"))
        for objective in ("joint", "duration"):
            run = self.arm("--json", "--objective", objective)
            self.assertEqual((run.code, run.json["parameters"]["objective"]), (0, objective))
        self.ended(self.arm("--objective", "duration"), 0, "the motion made of the way that was found: ",
                   f"{run.json['joint_travel']:.3f} rad of the joints, {run.json['duration']:.3f} s")
        self.assertLess(run.json["length"], run.json["duration"])

    def test_a_ros_trajectory(self):
        self.quiet(self.arm("-q", "--rate", "7", "-o", "m.yaml", "-o", "m.yml", "-o", "m.json"))
        self.assertEqual(self.read("m.yaml"), self.read("m.yml"))
        message = read_ros_trajectory(self.read("m.yaml").decode())
        samples = json.loads(self.read("m.json"))["trajectory"]["samples"]
        self.assertEqual(message["joint_names"], ["shoulder", "elbow", "wrist"])
        self.assertEqual(len(message["points"]), len(samples["t"]))
        for i, point in enumerate(message["points"]):
            for key, name in (("positions", "q"), ("velocities", "dq"), ("accelerations", "ddq")):
                self.assertEqual(point[key], samples[name][i])
                self.assertTrue(all(isinstance(value, float) for value in point[key]))
            time = point["time_from_start"]
            self.assertLess(time["nanosec"], 10**9)
            self.assertLess(abs(time["sec"] + 1e-9 * time["nanosec"] - samples["t"][i]), 1e-8)
        self.ended(self.arm("-q", "-o", "none.yaml", start="0.3,0,0"), 4)
        self.assertEqual(read_ros_trajectory(self.read("none.yaml").decode())["points"], [])

    def test_a_urdf_chain(self):
        self.write("two.urdf", TWO_JOINTS)
        run = self.ended(self.arm("--json", "--iterations", "5", robot="two.urdf",
                                  scene="empty.json", start="0,1", goal="0.2,0.6,0"), 0)
        self.assertEqual(run.json["robot"]["name"], "two")
        self.ended(self.arm("--json", "--iterations", "3", "--tip", "lower", robot="two.urdf",
                            scene="empty.json", start="0,1", goal="0.5,0,0"), 0)
        self.refused(self.arm("--tip", "tol", robot="two.urdf", scene="empty.json", start="0,1"),
                     2, 'did you mean "tool"?')
        self.refused(self.arm("--base", "tool", robot="two.urdf", scene="empty.json", start="0,1",
                              goal="0,0.5,0"), 2, "choose another")

    def test_without_shortcuts_every_lattice_point_is_passed(self):
        lattice = ("--json", "--iterations", "20", "--set", "trees=0")
        plain = self.arm(*lattice, "--no-shortcut").json
        short = self.arm(*lattice).json
        self.assertEqual(plain["trajectory"]["waypoints"], len(plain["joints"]))
        self.assertLess(short["trajectory"]["waypoints"], len(short["joints"]))
        self.assertLess(short["trajectory"]["duration"], plain["trajectory"]["duration"])
        self.assertEqual(plain["path"], short["path"])

    def test_the_recheck_is_told(self):
        self.assertIn("recheck: 50 samples, 0 contacts, 0 broken limits, nearest",
                      self.arm("--iterations", "5", "--recheck", "50").err)

    def test_exit_codes(self):
        def status(code, name, *arguments, **options):
            run = self.arm("--json", "--iterations", "5", *arguments, **options)
            self.assertEqual((run.code, run.json["status"]), (code, name), run.err)
            return run
        status(4, "invalid", goal="5,0,0")
        self.assertIn("goal 1e+300,0,0 is outside", status(4, "invalid", goal="1e300,0,0").err)
        self.assertIn("is -1e+300, its limits", status(4, "invalid", start="0,-1e300,0").err)
        status(4, "invalid", goal="0.4,0.5,0.3")
        status(4, "invalid", start="4,0,0")
        run = status(4, "invalid", start="0.3,0,0")
        self.assertIn("obstacle 1 (post)", run.json["error"])
        run = status(4, "invalid", goal="0.62,0.18,0")  # within the post: no ant could try it
        self.assertIn("at the goal", run.json["error"])
        run = status(6, "no_path", "--set", "joint_step=0.01", "--set", "direct=off", "--set", "trees=0")
        self.assertIn("not found in this lattice", run.err)
        run = status(6, "no_path", "--set", "joint_step=0.01", "--set", "direct=off", "--set", "trees=0",
                     "--goal-joints", "0.3,1.1,0.2", start="0,0,0", goal=None)
        self.assertIn("try a smaller pitch", run.err)
        self.assertIn("did not meet", status(6, "no_path", "--set", "trees=1", "--set", "direct=off").err)
        status(6, "no_path", "--set", "iterations=0", "--set", "trees=0")
        status(6, "limit", "--time-limit", "0")
        self.refused(self.arm("-o", "nowhere/m.json"), 7, "nowhere")

    def test_a_hair_outside_of_the_limits(self):
        run = self.ended(self.arm("--json", "-o", "r.json", start="-0.3,0.5,2.2004", scene="empty.json"), 0)
        self.assertEqual(run.json["start"], [-0.3, 0.5, 2.2004])
        self.assertEqual(run.json["joints"][0], [-0.3, 0.5, 2.2])
        note = "start: joint 3 (wrist) is 2.2004, its limits are -2.2 .. 2.2: taken at the limit"
        self.assertEqual(run.json["notes"], [note])
        self.assertIn(note, run.err)
        self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_near_links_are_told_with_their_distance(self):
        run = self.arm("--clearance", "0.2", scene="empty.json", start="0,0,0")
        self.ended(run, 4, "at the start: ", " m apart (less than twice the clearance, 0.4 m, counts as touching)")

    def test_names_of_thousands_of_letters_are_cut_in_pictures(self):
        with open(PLANAR, encoding="utf-8") as file:
            robot = json.load(file)
        robot["joints"][0]["name"] = "\u00e4" * 60000
        robot["joints"][1]["name"] = "a b " * 15000
        self.write("long.json", json.dumps(robot))
        self.quiet(self.arm("-q", "-o", "m.svg", "-o", "m.html", "-o", "m.json", robot="long.json"))
        self.assertIn("\u00e4" * 99 + "\u2026", self.words("m.svg").replace(" ", ""))
        self.assertLess(len(self.words("m.svg")), 10000)
        self.assertEqual(json.loads(self.read("m.json"))["robot"]["joint_names"][0], "\u00e4" * 60000)

    def test_files_of_another_kind_are_named(self):
        facet = "facet\nvertex 0 0 0\nvertex 900 0 0\nvertex 0 1 0\nendfacet\n"
        self.write("long.stl", "solid s\n" + facet + "endsolid\n")
        self.write("hall.json", '{"format": "lasius-scene/1", "obstacles": [{"shape": "mesh", "file": "long.stl",'
                   '"position": [0, 0, 5]}]}')
        run = self.ended(self.arm("--json", scene="hall.json"), 0, "long.stl is 900 m long: if it is in millimetres")
        self.assertEqual(len(run.json["scene"]["warnings"]), 1)
        files = {"a robot in URDF": TWO_JOINTS, "an SRDF file": SRDF, "MoveIt's joint limits": LIMITS, "a scene": EMPTY,
                 "a robot in JSON": '{"format": "lasius-arm/1"}', "a MovingAI map": "type octile\nheight 1\n",
                 "GeoJSON": '{"type": "FeatureCollection", "features": []}', "an image": b"\x89PNG" + 99999 * b"\0",
                 "a result of lasius": '{"format": "lasius-plan/1"}', "a study": "name: s\ncontenders: [exact]\n",
                 "a tuning": "training: {}\n", "the YAML file of a ROS map": "image: a.png\n"}
        for kind, text in files.items():
            self.write("other", text)
            self.write("right.urdf", TWO_JOINTS)
            for own, ask in {
                    "a robot": lambda: self.arm(robot="other"), "a scene": lambda: self.arm(scene="other"),
                    "an SRDF file": lambda: self.arm("--srdf", "other", robot="right.urdf", start="0,1"),
                    "MoveIt's": lambda: self.arm("--joint-limits", "other", robot="right.urdf", start="0,1"),
                    "a tuning": lambda: self.run_program("tune", "other")}.items():
                with self.subTest(kind=kind, own=own):
                    if not kind.startswith(own):
                        self.refused(ask(), 3, "other", "this is " + kind)

    def test_start_is_goal(self):
        result = self.arm("--json", scene="empty.json", start="0,0,0", goal="0.9,0,0").json
        self.assertEqual((result["status"], result["length"], result["gap"]), ("solved", 0, 0))
        self.assertEqual(len(result["path"]), 1)
        self.assertEqual(result["trajectory"]["duration"], 0)

    def test_usage(self):
        cases = [
            (["--set", "gama=1"], 'did you mean "gamma"?'),
            (["--gaol", "1,1,1"], 'did you mean "--goal"?'),
            (["--algorithm", "goritof2020"], 'did you mean "goritov2020"?'),
            (["--set", "dead_end=kil"], 'did you mean "kill"?'),
            (["-o", "m.pngg"], 'did you mean ".png"?'),
            (["--set", "evaporation=2"], "0 .. 1"), (["--ants", "0"], "1 .. 1000000"),
            (["--set", "ants"], "NAME=VALUE"), (["--pitch", "1e-9"], "pitch"),
            (["--clearance", "-1"], "--clearance"), (["--rate", "0"], "--rate"),
            (["--recheck", "x"], "--recheck"), (["--seed", "-1"], "--seed"),
            (["--seed", "1-20"], "arm takes one seed"),
            (["--base", "a"], "no URDF"), (["--side", "255"], "0 .. 254"),
            (["--objective", "jont"], 'did you mean "joint"?'),
            (["--goal-pos", "0,0,0,0,0,0"], 'did you mean "--goal-pose"?'),
            (["--goal-pose", "0,0,0"], "--goal-pose"), (["--goal-joints", "0,0"], "3 joints"),
            (["--angle-tolerance", "0"], "--angle-tolerance"),
            (["--max-questions", "-1"], "max_questions"),
            (["--allow-contact", "a"], "LINK,LINK"), (["--package", "a"], "NAME=DIR"),
            (["--set-joint", "a=b"], "--set-joint a"), (["--set-joint", "=1"], "NAME=VALUE"),
            (["--set-joint", "a=1", "--set-joint", "a=2"], "twice"),
            (["--goal-state", "home"], "--srdf"), (["-o", "m.yalm"], 'did you mean ".yaml"?'),
        ]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                self.refused(self.arm(*arguments), 2, words)
        for goal in ("1,2", "1,2,3,4", "a,b,c", "1,,2", "nan,0,0", ""):
            with self.subTest(goal=goal):
                self.refused(self.arm(goal=goal), 2, "--goal")
        self.refused(self.arm(goal=None), 2, "--goal-pose")
        self.refused(self.arm(start="home"), 2, "--start home", "--srdf")
        for start in ("0,0", "0,0,0,0"):
            with self.subTest(start=start):
                self.refused(self.arm(start=start), 2, "--start", "3 joints")
        self.refused(self.run_program("plan", "small.map", "--start", "0,0", "--goal", "9,5",
                                      "--algorithm", "goritov2020"), 2, "lasius arm")

    def test_verify(self):
        shutil.copy(FLAT, self.path("flat.json"))
        self.write("two.urdf", TWO_JOINTS)
        runs = {"planar.json": {"scene": "flat.json"},
                "urdf.json": {"robot": "two.urdf", "scene": "empty.json", "start": "0,1",
                              "goal": "0,0.7,0"}}
        for name, question in runs.items():
            more = ["--tip", "tool"] if name == "urdf.json" else ["--recheck", "50"]
            self.ended(self.arm("-q", "--iterations", "5", "--seed", "3", "--target-gap", "1",
                                "-o", name, *more, **question), 0)
            for threads in ("1", "3"):
                verified = self.run_program("verify", name, "--threads", threads)
                self.assertEqual((verified.code, verified.out),
                                 (0, "1 of 1 result is equal to the replay\n"), verified.err)
        result = json.loads(self.read("planar.json"))
        self.assertEqual(result["parameters"]["timing"], "optimal")
        # As before there was a choice: splines, and FCL measured.
        old = self.arm("--json", "--iterations", "5", "--recheck", "50", "--set", "timing=splines",
                       scene="flat.json").json
        self.assertLess(result["duration"], old["duration"])
        del old["parameters"]["timing"]
        old["recheck"]["nearest"] += 1e-9
        self.assertEqual(self.replay_of(old).code, 1)
        self.assertEqual(self.replay_of({**old, "version": "0.3.0"}).code, 0)
        for key, value in (("seed", 4), ("joints", result["joints"][:-1]), ("length", 0)):
            with self.subTest(key=key):
                self.assertEqual(self.replay_of({**result, key: value}).code, 1)
        self.refused(self.replay_of({**result, "parameters": {}}), 3, "lacks an input")
        for name, value in (("rate", 0), ("rate", -1), ("rate", 1e300), ("clearance", 2)):
            with self.subTest(name=name, value=value):
                tampered = {**result["parameters"], name: value}
                self.refused(self.replay_of({**result, "parameters": tampered}), 3,
                             "parameters/" + name)
        self.refused(self.replay_of({**result, "recheck": {"samples": 0}}), 3, "recheck/samples")
        goal = result["goals"][0]
        for goals in ([], [{**goal, "values": [1, 2]}], [{**goal, "kind": "pose"}]):
            self.refused(self.replay_of({**result, "goals": goals}), 3, '"goals')
        self.refused(self.run_program("verify", "planar.json", "--map", "small.map"), 2, "--map")
        self.write("flat.json", EMPTY)
        self.refused(self.run_program("verify", "planar.json"), 3, "flat.json",
                     result["scene"]["hash"])

    def ur5(self, *arguments, start=UR5_START, **options):
        return self.arm(*arguments, robot=os.path.join(ROBOTS, "ur5_gripper.urdf"),
                        scene="empty.json", start=start, goal=None, **options)

    def test_bodies_and_pairs_are_listed(self):
        result = self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, "--json").json
        bodies = {body["name"]: body for body in result["robot"]["bodies"]}
        self.assertEqual(bodies["left_finger"], {
            "name": "left_finger", "moves_with": "wrist_3_joint", "solids": ["box"]})
        self.assertIsNone(bodies["base_link"]["moves_with"])
        self.assertEqual(result["robot"]["joint_names"][0], "shoulder_pan_joint")
        checked = {frozenset(pair) for pair in result["robot"]["pairs_checked"]}
        self.assertIn(frozenset(("left_finger", "forearm_link")), checked)
        why = {frozenset(pair["links"]): pair["why"]
               for pair in result["robot"]["pairs_not_checked"]}
        self.assertEqual(why[frozenset(("left_finger", "gripper_base"))], "rigid")
        self.assertEqual(why[frozenset(("base_link", "shoulder_link"))], "neighbours")
        self.assertFalse(checked & set(why))
        self.assertEqual(len(checked) + len(why), len(bodies) * (len(bodies) - 1) // 2)
        told = self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, "-v",
                        "--allow-contact", "left_finger,forearm_link").err
        self.assertIn("body left_finger, moves with wrist_3_joint: box", told)
        self.assertIn("not checked, rigid", told)
        self.assertRegex(told, "pair (left_finger, forearm_link|forearm_link, left_finger): "
                               "not checked, allowed")

    def test_states_pairs_and_limits_of_files(self):
        self.write("ur5.srdf", SRDF)
        self.write("limits.yaml", LIMITS)
        more = ("--tip", "tool0", "--srdf", "ur5.srdf", "--joint-limits", "limits.yaml")
        self.ended(self.ur5(*more, "--goal-state", "up", "-q", "-o", "r.json", start="home"), 0)
        result = json.loads(self.read("r.json"))
        self.assertEqual((result["start_state"], result["goals"][0]["state"]), ("home", "up"))
        self.assertEqual(result["start"], [0.1, -1.2, 1.4, -1.5, 0.2, 0.3])
        named = {pair["why"] for pair in result["robot"]["pairs_not_checked"]
                 if set(pair["links"]) == {"left_finger", "forearm_link"}}
        self.assertEqual(named, {"allowed"})
        speeds = [max(abs(row[j]) for row in result["trajectory"]["samples"]["dq"])
                  for j in range(6)]
        self.assertLessEqual(speeds[0], 0.25 + 1e-9)
        self.assertLessEqual({"ur5.srdf", "limits.yaml"},
                             {file["file"] for file in result["robot"]["files"]})
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        self.refused(self.ur5(*more, "--goal-state", "upp"), 2, 'did you mean "up"?')
        self.refused(self.ur5(*more, "--goal-state", "up", "-o", "ur5.srdf"), 2, "ur5.srdf")
        for file, ending in (("ur5.srdf", "json"), ("limits.yaml", "yaml")):
            link = "link." + ending
            os.symlink(file, self.path(link))
            self.refused(self.ur5(*more, "--goal-state", "up", "-o", link), 2, file)
        self.write("limits.yaml", LIMITS + "\n")
        self.refused(self.run_program("verify", "r.json"), 3, "limits.yaml")

    def test_what_is_assumed_is_told(self):
        run = self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, "--json")
        notes = run.json["robot"]["notes"]
        self.assertTrue(any("left_finger_joint" in note for note in notes), notes)
        self.assertTrue(any("acceleration" in note for note in notes), notes)
        for note in notes:
            self.assertIn(note, run.err)
        far = self.ur5("--tip", "tool0", "--goal", "9,9,9", "--json")
        self.assertEqual(far.json["robot"]["notes"], notes)
        self.assertTrue(far.err.startswith("lasius: goal 9,9,9 is outside"), far.err)
        self.holds(far.err, *notes)  # they may be why
        self.assertEqual(self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, "-q").err, "")
        run = self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, "--json", "--set-joint",
                       "left_finger_joint=0.02")
        self.assertEqual(run.json["parameters"]["set_joint"], {"left_finger_joint": 0.02})
        for arguments, words in ((["--set-joint", "left_finger_jont=0"], "left_finger_joint"),
                                 (["--allow-contact", "left_fingr,forearm_link"], "left_finger"),
                                 (["--srdf", "no.srdf"], "no.srdf"),
                                 (["--joint-limits", "no.yaml"], "no.yaml")):
            with self.subTest(arguments=arguments):
                run = self.ur5("--tip", "tool0", "--goal-joints", UR5_GOAL, *arguments)
                self.assertIn(run.code, (2, 3), run.err)
                self.assertIn(words, run.err)

    def test_meshes_in_packages(self):
        def ask(*arguments):
            return self.arm(*arguments, "--tip", "tool", robot=os.path.join(ROBOTS, "branch.urdf"),
                            scene="empty.json", start="0.3,0.9,0.6,0", goal=None)
        goal = ("--goal-joints", "-0.5,1.2,0.4,1")
        self.refused(ask(*goal), 3, "--package")
        shutil.copytree(ROBOTS, self.path("parts"))
        self.ended(ask(*goal, "--package", "parts=parts", "-q", "-o", "r.json", "-o", "r.png"), 0)
        result = json.loads(self.read("r.json"))
        self.assertEqual(result["robot"]["packages"], {"parts": "parts"})
        meshes = {os.path.basename(file["file"]): file["hash"] for file in result["robot"]["files"]}
        self.assertEqual(set(meshes), {"tool.obj", "wedge.stl"})
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        os.rename(self.path("parts/tool.obj"), self.path("parts/tool.json"))
        os.symlink("tool.json", self.path("parts/tool.obj"))
        self.refused(ask(*goal, "--package", "parts=parts", "-o", "parts/tool.json"), 2, "tool.json")
        self.write("parts/tool.json", self.read("parts/tool.json").decode() + "# more\n")
        self.refused(self.run_program("verify", "r.json"), 3, "tool.obj")

    def test_robots_without_a_body(self):
        bare = re.sub("<collision>.*?</collision>", "", TWO_JOINTS, flags=re.S)
        def ask(text, *arguments):
            self.write("bare.urdf", text)
            return self.arm("--json", *arguments, robot="bare.urdf", scene="empty.json", start="0,1",
                            goal="0.2,0.6,0")
        refused = ask(bare)
        self.refused(refused, 3, "--use-visual")
        self.assertIn("--bodiless", refused.err)
        run = ask(bare, "--bodiless")
        self.assertEqual((run.code, run.json["parameters"]["bodiless"]), (0, True), run.err)
        run = self.ended(ask(TWO_JOINTS.replace("collision>", "visual>"), "--use-visual"), 0)
        self.assertEqual([body["name"] for body in run.json["robot"]["bodies"]],
                         ["foot", "upper", "lower"])

    def test_a_long_motion_says_that_it_is_sampled_less_often(self):
        with open(PLANAR, encoding="utf-8") as file:
            robot = json.load(file)
        for joint in robot["joints"]:
            joint["velocity"] = 1e-3
        self.write("slow.json", json.dumps(robot))
        self.ended(self.arm("--rate", "100000", robot="slow.json"), 0,
                   "1000000 times in all, not 100000 times a second")

    def test_broken_files(self):
        robots = {
            "": "is empty", "{": "this is not JSON", "[1, 2]": 'no "format"',
            '{"format": "lasius-arm/2"}': "lasius-arm/1",
            '{"format": "lasius-arm/1"}': "joints is missing",
            '{"format": "lasius-arm/1", "joints": []}': "1 .. 16",
            '{"format": "lasius-arm/1", "joints": [{"axiss": [0, 0, 1]}]}': 'did you mean "axis"?',
            "<robot/>": "URDF", "<html></html>": "URDF", "[" * 100000: "nests too deep",
            '<robot name="a">\n' + "<a>" * 40000 + "</a>" * 40000 + "</robot>": "nest too deep",
        }
        for text, words in robots.items():
            with self.subTest(robot=text[:60]):
                self.write("bad.json", text)
                self.refused(self.arm(robot="bad.json"), 3, "bad.json", words)
        scenes = {
            '{"shape": "bax"}': 'did you mean "box"?',
            '{"shape": "box"}': "obstacles[0].size is missing",
            '{"shape": "sphere", "radius": -1}': "obstacles[0].radius is -1",
            '{"shape": "sphere", "radius": 1, "size": [1, 1, 1]}': "not a field of a sphere",
            '{"shape": "box", "size": [1, 1]}': "list of 3",
            '{"shape": "box", "size": [1, 1, 1e9]}': "1000",
            '{"shape": "mesh", "file": "no.stl"}': "no.stl",
            '{"shape": "mesh", "file": "bad.stl"}': "no STL file",
            '{"shape": "mesh", "file": "cut.stl"}': "endsolid",
        }
        facet = "facet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n"
        self.write("cut.stl", "solid s\n" + facet)
        self.write("bad.stl", "this is no mesh")
        for text, words in scenes.items():
            with self.subTest(scene=text):
                self.write("bad.json", '{"format": "lasius-scene/1", "obstacles": [%s]}' % text)
                self.refused(self.arm(scene="bad.json"), 3, words)
        self.refused(self.arm(robot="missing.json"), 3, "missing.json", "cannot be opened")
        self.refused(self.arm(scene="missing.json"), 3, "missing.json", "cannot be opened")

    def test_a_recheck_is_interrupted(self):
        run = self.start_program("arm", PLANAR, "--scene", FLAT, "--start", "-0.3,0.5,0.5",
                                 "--goal", "0.4,0.5,0", "--set", "direct=off", "--set", "trees=0",
                                 "--recheck", "1000000", "--json", "--progress", "always")
        self.assertTrue(run.stderr.read(1))  # after the first of few iterations
        self.assertNotIn("recheck", json.loads(self.interrupted(run)[0]))

    def test_interrupted(self):
        run = self.start_program("arm", PLANAR, "--scene", FLAT, "--start", "-0.3,0.5,0.5",
                                 "--goal", "0.4,0.5,0", "--algorithm", "goritov2020",
                                 "--iterations", "1000000", "--json", "--progress", "always")
        self.assertTrue(run.stderr.read(1))  # progress shows after an iteration
        result = json.loads(self.interrupted(run)[0])
        self.assertEqual(result["status"], "interrupted")
        self.assertIsNotNone(result["path"])

    def test_listed(self):
        names = {a["name"]: a for a in self.run_program("algorithms", "--json").json["arm_algorithms"]}
        self.assertIn("theta", names["goritov2020"]["formulas"][0])
        parameters = {p["name"]: p for p in names["goritov2020"]["parameters"]}
        defaults = {name: parameters[name]["default"]
                    for name in ("alpha", "beta", "gamma", "persistence", "ants", "iterations",
                                 "elite_weight")}
        self.assertEqual(defaults, {"alpha": 1, "beta": 1, "gamma": 0.25, "persistence": 0.75,
                                    "ants": 64, "iterations": 100, "elite_weight": 0})


if __name__ == "__main__":
    unittest.main()
