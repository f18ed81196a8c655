"""lasius arm: results, files, exit codes and every kind of bad input."""
import csv
import io
import json
import math
import os
import shutil
import signal
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

EMPTY = '{"format": "lasius-scene/1", "obstacles": []}'


class Arm(ProgramTest):
    def arm(self, *arguments, robot=PLANAR, scene=FLAT, start="-0.3,0.5,0.5", goal="0.4,0.5,0",
            **options):
        return self.run_program("arm", robot, "--scene", scene, "--start", start, "--goal", goal,
                                *arguments, **options)

    def test_a_motion_with_all_that_json_promises(self):
        run = self.arm("--json", "--iterations", "20", "--recheck", "200")
        self.assertEqual(run.code, 0, run.err)
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
        self.assertEqual((result["recheck"]["contacts"], result["recheck"]["limits"]), (0, 0))
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
        run = self.arm("-q", "--iterations", "5", "-o", "m.json", "-o", "m.csv", "-o", "m.svg",
                       "-o", "m.png")
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertEqual(json.loads(self.read("m.json"))["status"], "solved")
        rows = list(csv.reader(io.StringIO(self.read("m.csv").decode())))
        self.assertEqual(rows[0], ["t", "q1", "q2", "q3", "dq1", "dq2", "dq3", "ddq1", "ddq2",
                                   "ddq3", "x", "y", "z"])
        self.assertTrue(all(len(row) == 13 for row in rows))
        self.assertGreater(self.png_size("m.png")[0], 1000)
        self.assertIn(b"<svg", self.read("m.svg")[:300])
        self.assertEqual(run.out.splitlines()[0], "solved")

    def test_a_urdf_chain(self):
        self.write("two.urdf", TWO_JOINTS)
        self.write("empty.json", EMPTY)
        run = self.arm("--json", "--iterations", "5", robot="two.urdf", scene="empty.json",
                       start="0,1", goal="0.2,0.6,0")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(run.json["robot"]["name"], "two")
        shorter = self.arm("--json", "--iterations", "3", "--tip", "lower", robot="two.urdf",
                           scene="empty.json", start="0,1", goal="0.5,0,0")
        self.assertEqual(shorter.code, 0, shorter.err)
        self.refused(self.arm("--tip", "tol", robot="two.urdf", scene="empty.json", start="0,1"),
                     2, 'did you mean "tool"?')
        self.refused(self.arm("--base", "tool", robot="two.urdf", scene="empty.json", start="0,1",
                              goal="0,0.5,0"), 2, "choose another")

    def test_without_shortcuts_every_lattice_point_is_passed(self):
        plain = self.arm("--json", "--no-shortcut", "--iterations", "20").json
        short = self.arm("--json", "--iterations", "20").json
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
        status(5, "unreachable", "--set", "joint_step=0.01")
        status(6, "no_path", "--set", "iterations=0")
        status(6, "limit", "--time-limit", "0")
        self.refused(self.arm("-o", "nowhere/m.json"), 7, "nowhere")

    def test_start_is_goal(self):
        self.write("empty.json", EMPTY)
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
            (["--base", "a"], "no URDF"), (["--side", "255"], "0 .. 254"),
        ]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                self.refused(self.arm(*arguments), 2, words)
        for goal in ("1,2", "1,2,3,4", "a,b,c", "1,,2", "nan,0,0", ""):
            with self.subTest(goal=goal):
                self.refused(self.arm(goal=goal), 2, "--goal")
        for start in ("0,0", "0,0,0,0"):
            with self.subTest(start=start):
                self.refused(self.arm(start=start), 2, "--start", "3 joints")
        self.refused(self.run_program("plan", "small.map", "--start", "0,0", "--goal", "9,5",
                                      "--algorithm", "goritov2020"), 2, "lasius arm")

    def test_verify(self):
        shutil.copy(FLAT, self.path("flat.json"))
        self.write("two.urdf", TWO_JOINTS)
        self.write("empty.json", EMPTY)
        runs = {"planar.json": {"scene": "flat.json"},
                "urdf.json": {"robot": "two.urdf", "scene": "empty.json", "start": "0,1",
                              "goal": "0,0.7,0"}}
        for name, question in runs.items():
            more = ["--tip", "tool"] if name == "urdf.json" else ["--recheck", "50"]
            run = self.arm("-q", "--iterations", "5", "--seed", "3", "--target-gap", "1", "-o",
                           name, *more, **question)
            self.assertEqual(run.code, 0, run.err)
            for threads in ("1", "3"):
                verified = self.run_program("verify", name, "--threads", threads)
                self.assertEqual((verified.code, verified.out),
                                 (0, "1 of 1 result is equal to the replay\n"), verified.err)
        result = json.loads(self.read("planar.json"))
        for key, value in (("seed", 4), ("joints", result["joints"][:-1]), ("length", 0)):
            with self.subTest(key=key):
                self.write("bad.json", json.dumps({**result, key: value}))
                self.assertEqual(self.run_program("verify", "bad.json").code, 1)
        self.write("bad.json", json.dumps({**result, "parameters": {}}))
        self.refused(self.run_program("verify", "bad.json"), 3, "lacks an input")
        for name, value in (("rate", 0), ("rate", -1), ("rate", 1e300), ("clearance", 2)):
            with self.subTest(name=name, value=value):
                tampered = {**result["parameters"], name: value}
                self.write("bad.json", json.dumps({**result, "parameters": tampered}))
                self.refused(self.run_program("verify", "bad.json"), 3, "parameters/" + name)
        self.write("bad.json", json.dumps({**result, "recheck": {"samples": 0}}))
        self.refused(self.run_program("verify", "bad.json"), 3, "recheck/samples")
        self.refused(self.run_program("verify", "planar.json", "--map", "small.map"), 2, "--map")
        self.write("flat.json", EMPTY)
        self.refused(self.run_program("verify", "planar.json"), 3, "flat.json",
                     result["scene"]["hash"])

    def test_a_long_motion_says_that_it_is_sampled_less_often(self):
        with open(PLANAR, encoding="utf-8") as file:
            robot = json.load(file)
        for joint in robot["joints"]:
            joint["velocity"] = 1e-3
        self.write("slow.json", json.dumps(robot))
        run = self.arm("--rate", "100000", robot="slow.json")
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("1000000 times in all, not 100000 times a second", run.err)

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

    def test_interrupted(self):
        run = self.start_program("arm", PLANAR, "--scene", FLAT, "--start", "-0.3,0.5,0.5",
                                 "--goal", "0.4,0.5,0", "--iterations", "1000000", "--json",
                                 "--progress", "always")
        first = run.stderr.read(1)  # progress shows after an iteration
        self.assertTrue(first)
        run.send_signal(signal.SIGINT)
        out, _ = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 130)
        result = json.loads(out)
        self.assertEqual(result["status"], "interrupted")
        self.assertIsNotNone(result["path"])

    def test_listed(self):
        names = {a["name"]: a for a in self.run_program("algorithms", "--json").json["arm_algorithms"]}
        parameters = {p["name"]: p for p in names["goritov2020"]["parameters"]}
        defaults = {name: parameters[name]["default"]
                    for name in ("alpha", "beta", "gamma", "evaporation", "ants", "iterations",
                                 "elite_weight")}
        self.assertEqual(defaults, {"alpha": 1, "beta": 1, "gamma": 0.25, "evaporation": 0.25,
                                    "ants": 64, "iterations": 100, "elite_weight": 0})


if __name__ == "__main__":
    unittest.main()
