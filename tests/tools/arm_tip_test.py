"""lasius arm: what the tip holds, straight motions, joint values, what is nearest."""
import json
import math
import os
import unittest

from program import MAPS, ProgramTest

ROBOT = os.path.join(MAPS, "arms", "industrial6.json")
START = "0.3,0.4,0.7,0.2,0.6,0.1"
STICK = {"format": "lasius-scene/1", "name": "stick",
         "obstacles": [{"shape": "cylinder", "radius": 0.01, "length": 0.3, "position": [0, 0, 0.2]}]}
EMPTY = {"format": "lasius-scene/1", "obstacles": []}


class Tip(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("empty.json", json.dumps(EMPTY))
        self.write("stick.json", json.dumps(STICK))

    def arm(self, *arguments, scene="empty.json", **options):
        return self.run_program("arm", ROBOT, "--scene", scene, "--start", START, *arguments, **options)

    def pose(self, x=0.0, y=0.0, z=0.0):
        """The tip's at the start, moved."""
        run = self.ended(self.arm("--json", "--goal-joints", START), 0)
        at = run.json["path"][0]
        return ",".join(map(str, (at[0] + x, at[1] + y, at[2] + z)))

    def ahead(self, metres):
        """A point on the z axis of the tip's frame: where a ball that is held would be."""
        joints = [float(value) for value in START.split(",")]
        with open(ROBOT, encoding="utf-8") as file:
            robot = json.load(file)

        def turned(axis, angle, v):
            (x, y, z), c, s = axis, math.cos(angle), math.sin(angle)
            dot = sum(a * b for a, b in zip(axis, v))
            cross = (y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0])
            return [c * a + s * b + (1 - c) * dot * n for a, b, n in zip(v, cross, axis)]

        point = [0, 0, metres]
        for joint, value in zip(reversed(robot["joints"]), reversed(joints)):
            point = turned(joint["axis"], value, [a + b for a, b in zip(point, joint["link"])])
        return [a + b for a, b in zip(point, robot["base"])]

    def replayed(self, name):
        verified = self.run_program("verify", name)
        self.assertEqual((verified.code, verified.out), (0, "1 of 1 result is equal to the replay\n"),
                         verified.err)

    def test_what_is_held_is_part_of_the_arm(self):
        goal = ("--goal-joints", "0.5,0.4,0.7,0.2,0.6,0.1", "--nearest", "--json")
        bare = self.ended(self.arm(*goal), 0).json
        self.assertNotIn("held", bare)
        held = self.ended(self.arm(*goal, "--held", "stick.json", "-o", "held.json"), 0).json
        self.assertEqual(held["held"]["obstacles"], 1)
        self.assertEqual(held["robot"]["bodies"][-1]["name"], "stick")
        self.replayed("held.json")
        # A ball where the stick ends, of which the bare arm keeps clear.
        self.write("flat.json", json.dumps({**EMPTY, "obstacles": [
            {"shape": "sphere", "name": "ball", "radius": 0.05, "position": self.ahead(0.3)}]}))
        self.ended(self.arm("--nearest", scene="flat.json"), 0)
        touching = self.arm("--nearest", "--held", "stick.json", scene="flat.json")
        self.ended(touching, 4)
        self.assertIn("stick", touching.err)
        self.refused(self.arm(*goal, "--held", "stick.json", "--held-touches", "no link"), 2, "no link")
        self.refused(self.arm(*goal, "--held", "nowhere.json"), 3, "nowhere.json")
        self.ended(self.arm(*goal, "--held", "stick.json", "--held-touches", "link 5 (after pitch)"), 0)

    def test_what_is_held_is_found_beside_its_result(self):
        self.ended(self.arm("--goal-joints", "0.5,0.4,0.7,0.2,0.6,0.1", "--held", "stick.json", "-o", "held.json"), 0)
        os.mkdir(self.path("moved"))
        for name in ("empty.json", "stick.json", "held.json"):
            os.rename(self.path(name), self.path("moved/" + name))
        self.replayed("moved/held.json")

    def test_straight(self):
        goal = self.pose(0.05, -0.2, -0.1)
        angles = "0.2,0.3,0.4"
        run = self.arm("--straight", "--goal-pose", f"{goal},{angles}", "--straight-angle", "4",
                       "--json", "-o", "line.json", "--recheck", "100")
        result = self.ended(run, 0).json
        self.assertEqual(result["straight"], {"tolerance": 0.001, "angle_tolerance": 4, "reached": 1})
        begin, end = result["path"][0], result["path"][-1]
        self.assertAlmostEqual(result["length"], math.dist(begin, end))
        way = [b - a for a, b in zip(begin, end)]
        for tip in result["trajectory"]["samples"]["tip"]:
            share = sum((p - a) * w for p, a, w in zip(tip, begin, way)) / result["length"] ** 2
            self.assertLess(math.dist(tip, [a + share * w for a, w in zip(begin, way)]), 0.001)
        self.assertEqual([result["recheck"][key] for key in ("contacts", "limits")], [0, 0])
        self.assertFalse(result["trajectory"]["stops"])
        self.replayed("line.json")
        far = self.arm("--straight", "--goal-pose", "9,0,0,0,0,0", "--json")
        self.assertEqual(self.ended(far, 4).json["status"], "invalid")
        self.refused(self.arm("--straight", "--goal", goal), 2, "--goal-pose")
        self.refused(self.arm("--straight", "--goal-pose", "1,0,0,0,0,0", "--objective", "joint"), 2,
                     "--objective")

    def test_inverse(self):
        goal = self.pose()
        run = self.arm("--inverse", "3", "--goal", goal, "--json", "-o", "inverse.json")
        result = self.ended(run, 0).json
        found = result["inverse"]["found"]
        self.assertTrue(1 <= len(found) <= 3)
        self.assertLess(result["length"], 1e-4)  # the start itself
        self.assertEqual((result["path"], result["trajectory"]), (None, None))
        for one in found:
            self.assertEqual(len(one["joints"]), 6)
            self.assertGreaterEqual(one["nearest"]["distance"], 0)
        self.replayed("inverse.json")
        text = self.ended(self.arm("--inverse", "1", "--goal", goal), 0)
        self.assertEqual(len(text.out.splitlines()[2].split()), 6)
        self.assertIn("joint values 1: free", text.err)
        self.ended(self.arm("--inverse", "3", "--goal", "9,9,9"), 4)
        self.refused(self.arm("--inverse", "3", "--goal", goal, "-o", "a.svg"), 2, "--inverse")

    def test_postures_that_all_touch_solve_nothing(self):
        """A goal within a ball: values are listed, none is free."""
        self.write("ball.json", json.dumps({**EMPTY, "obstacles": [
            {"shape": "sphere", "name": "ball", "radius": 0.2, "position": self.ahead(0)}]}))
        run = self.arm("--inverse", "2", "--goal", self.pose(), "--json", "-o", "touch.json", scene="ball.json")
        result = self.ended(run, 4, "the arm touches something in each of ", "ball").json
        self.assertEqual((result["status"], result["length"]), ("invalid", None))
        self.assertEqual([one["free"] for one in result["inverse"]["found"]],
                         [False] * len(result["inverse"]["found"]))
        self.assertGreater(len(result["inverse"]["found"]), 0)
        self.replayed("touch.json")
        # A free goal beside it, further than the blocked ones: `--inverse` has room for none of its own.
        free = ("--goal-joints", "2.7,0.4,0.7,0.2,0.6,0.1")
        both = self.arm("--inverse", "2", "--goal", self.pose(), *free, "--json", "-o", "both.json", scene="ball.json")
        result = self.ended(both, 0).json
        self.assertEqual((result["status"], [one["free"] for one in result["inverse"]["found"]]),
                         ("solved", [False, True]))
        self.assertEqual(result["inverse"]["found"][1]["goal"], 1)
        self.replayed("both.json")
        self.ended(self.arm("--inverse", "2", "--goal", self.pose(), "--time-limit", "0"), 6)
        # One goal that is out of reach takes nothing from another.
        self.ended(self.arm("--inverse", "2", "--goal", self.pose(), "--goal", "9,9,9"), 0)

    def test_options_without_effect_are_told(self):
        plan = ("--algorithm", "goritov2020", "--set", "joint_step=0.4", "--ants", "3", "--iterations", "3",
                "--max-questions", "9", "--pitch", "0.2", "--side", "20", "--target-gap", "3", "--no-shortcut")
        motion = ("--duration", "9", "--rate", "9")
        goal = self.pose()
        for asked, why, idle in (
                (("--straight", "--goal-pose", self.pose(0.05, -0.2, -0.1) + ",0.2,0.3,0.4", "--straight-angle", "4"), "with --straight",
                 (*plan, "--seed", "3", "--position-tolerance", "0.1", "--angle-tolerance", "0.1")),
                (("--inverse", "1", "--goal", goal), "with --inverse", (*plan, *motion, "--recheck", "3")),
                (("--nearest",), "without a goal", (*plan, *motion, "--seed", "3"))):
            run = self.ended(self.arm(*asked, *idle), 0)
            for option in idle:
                if option.startswith("--"):
                    self.assertIn(f"{option} has no effect {why}\n", run.err)
            plain = self.ended(self.arm(*asked), 0)
            self.assertNotIn("no effect", plain.err)
            self.assertEqual(run.out, plain.out)
        run = self.ended(self.arm("--goal", goal, "--nearest", "--seed", "3", "--rate", "9"), 0)
        self.assertNotIn("no effect", run.err)

    def test_nearest_without_a_goal(self):
        run = self.ended(self.arm("--nearest", "--json", "-o", "near.json"), 0)
        near = run.json["nearest"]
        self.assertEqual(near["start"], near["end"])
        self.assertGreater(near["start"]["distance"], 0)
        self.replayed("near.json")
        alone = self.ended(self.arm("--nearest"), 0)
        self.assertIn("at the start: ", alone.err)
        self.assertNotIn("at the end: ", alone.err)
        self.refused(self.arm(), 2, "a goal is required")


if __name__ == "__main__":
    unittest.main()
