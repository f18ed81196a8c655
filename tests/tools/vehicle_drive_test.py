"""drive --vehicle: every motion judged by separating axes in the truth, recorded, replayed, shown."""
import json
import math
import unittest

from program import ProgramTest
from vehicle_test import CAR, MAP, ROBOT, ROWS, depth, pose_on

UNKNOWN = "type octile\nheight 30\nwidth 44\nmap\n" + "\n".join(["." * 44] * 30) + "\n"


class VehicleDrives(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("yard.map", MAP)
        self.write("unknown.map", UNKNOWN)
        self.write("car.json", json.dumps(CAR))
        self.write("robot.json", json.dumps(ROBOT))

    def drive(self, vehicle, *options, start="4,4,0", goal="38,25,90deg", map_file="unknown.map"):
        return self.run_program("drive", map_file, "--world", "yard.map", "--vehicle", vehicle, "--start", start,
                                "--goal", goal, *options)

    def check(self, result, vehicle, rows=ROWS):
        track, segments = result["track"], list(result["segments"])
        self.assertEqual(len(track), result["ticks"] + 1)
        for a, b in zip(track, track[1:]):
            if a == b:
                continue
            segment = segments.pop(0)
            for at, share in ((a, 0), (b, 1)):
                told = pose_on(segment, share)
                self.assertLess(math.hypot(told[0] - at[0], told[1] - at[1]), 1e-6)
                self.assertLess(abs(math.remainder(told[2] - at[2], 2 * math.pi)), 1e-6)
            for i in range(5):
                self.assertLess(depth(vehicle["footprint"], pose_on(segment, i / 4), rows), 1e-9)
        self.assertEqual(segments, [])

    def test_a_yard_is_learned_on_the_way(self):
        for name, vehicle in (("car", CAR), ("robot", ROBOT)):
            run = self.drive(name + ".json", "--sense", "8", "--json", "-o", "run.json", "-o", "run.csv", "-o", "run.svg")
            self.assertEqual(run.code, 0, run.err)
            result = run.json
            self.assertEqual((result["format"], result["status"], result["algorithm"]),
                             ("lasius-drive/1", "solved", "lattice"))
            self.check(result, vehicle)
            self.assertGreater(result["seen"], 20)
            self.assertLess(math.dist(result["track"][-1], result["goal"]), 1e-6)
            self.assertGreaterEqual(result["length"], result["lower_bound"])
            self.assertIsNone(result["optimum"])
            self.quiet(self.run_program("verify", "-q", "run.json"))
            self.assertEqual(list(self.rows("run.csv")[0]), ["x", "y", "yaw"])
            judged = self.run_program("check-path", "yard.map", "run.csv", "--vehicle", name + ".json")
            self.assertEqual(judged.code, 0, judged.out)
            self.assertIn(b"swept by the footprint", self.read("run.svg"))

    def test_changes_wait_for_its_sweep(self):
        self.write("changes.txt", "6 6 2 30 6 blocked\n0 move 3 3 0.5 20 15 20 24\n")
        run = self.drive("car.json", "--changes", "changes.txt", "--json", "-o", "run.json", "-o", "run.html")
        self.assertIn(run.code, (0, 6), run.err)
        self.assertGreater(run.json["deferred"], 0)
        self.check(run.json, CAR)
        self.quiet(self.run_program("verify", "-q", "run.json"))

    def test_metres(self):
        """In a map turned in the world the drive in metres is that in cells, seen from there."""
        for name, rows in (("yard", ROWS), ("unknown", ["." * 44] * 30)):
            grey = bytes(0 if c == "@" else 255 for row in rows for c in row)
            self.write(name + ".pgm", b"P5\n44 30\n255\n" + grey)
            self.write(name + ".yaml", f"image: {name}.pgm\nresolution: 0.25\norigin: [-3.0, 2.0, 0.5]\nnegate: 0\n"
                       "occupied_thresh: 0.65\nfree_thresh: 0.2\n")
        car = {**CAR, "footprint": [[x / 4, y / 4] for x, y in CAR["footprint"]], "turning_radius": 1}
        del car["units"]
        self.write("metres.json", json.dumps(car))
        cells = self.drive("car.json", "--sense", "8", "--json").json

        def world(x, y, yaw):
            u, v = x / 4, (30 - y) / 4
            c, s = math.cos(0.5), math.sin(0.5)
            return -3 + c * u - s * v, 2 + s * u + c * v, 0.5 - yaw

        ends = [",".join(map(repr, world(*cells[end]))) for end in ("start", "goal")]
        run = self.run_program("drive", "unknown.yaml", "--world", "yard.yaml", "--vehicle", "metres.json", "--frame",
                               "world", "--start", ends[0], "--goal", ends[1], "--sense", "2", "--json", "-o", "w.json")
        self.assertEqual(run.code, 0, run.err)
        self.check(run.json, CAR)
        self.assertAlmostEqual(run.json["length_m"], run.json["length"] / 4)
        self.assertLess(math.dist(run.json["track"][-1], cells["goal"]), 1e-6)
        for at, there in zip(run.json["track"], run.json["track_world"]):
            self.assertLess(math.dist(world(*at)[:2], there[:2]), 1e-9)
            self.assertLess(abs(math.remainder(world(*at)[2] - there[2], 2 * math.pi)), 1e-9)
        self.quiet(self.run_program("verify", "-q", "w.json"))
        self.write("bad.json", json.dumps({**run.json, "goals_world": []}))
        self.refused(self.run_program("verify", "bad.json"), 3, "bad.json", '"goals_world" is []')

    def test_over_costs_and_to_one_of_several_goals(self):
        near, far = "20,4,0", "38,25,90deg"
        run = self.drive("car.json", "--goal", near, "--inflation", "4,1", "--sense", "8", "--json", "-o", "run.json", goal=far)
        self.assertEqual(run.code, 0, run.err)
        result = run.json
        self.check(result, CAR)
        self.assertEqual(len(result["goals"]), 2)
        self.assertEqual(result["goal"], result["goals"][result["goal_index"]])
        self.assertLess(math.dist(result["track"][-1], result["goal"]), 1e-6)
        self.assertGreater(result["cost"], result["length"])
        self.assertIn("inflation", result["parameters"])
        self.quiet(self.run_program("verify", "-q", "run.json"))
        for goals in ([], None, {"a": near}):
            self.write("bad.json", json.dumps({**result, "goals": goals}))
            self.refused(self.run_program("verify", "bad.json"), 3, "bad.json", '"goals" is')

    def test_what_is_refused(self):
        for options, said in ((("--radius", "2"), "--radius with --vehicle"), (("--algorithm", "mmas"), "lattice alone"),
                              (("--prepare",), "--prepare with --vehicle")):
            self.refused(self.drive("car.json", *options), 2, said)
        self.refused(self.drive("car.json", start="4,4"), 2, "X,Y,YAW")
        self.refused(self.run_program("drive", "yard.map", "--start", "1,1", "--goal", "3,3", "--heading-tolerance", "1"),
                     2, "--heading-tolerance is for --vehicle")
        self.refused(self.run_program("drive", "yard.map", "--start", "1,1", "--goal", "3,3", "--goal", "2,2"),
                     2, "several goals are for --vehicle")
        run = self.drive("car.json", "-o", "none.csv", start="12,4,0")
        self.assertEqual(self.read("none.csv"), b"x,y,yaw\n")
        self.ended(run, 4, "start (12.5, 4.5, 0): the footprint meets the blocked cell (12, ", "nearest pose of this heading")
        run = self.drive("car.json", goal="27,9,0", map_file="yard.map")
        self.ended(run, 4, "goal (27.5, 9.5, 0): the footprint meets the blocked cell", "nearest pose of this heading")


if __name__ == "__main__":
    unittest.main()
