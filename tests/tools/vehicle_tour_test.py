"""tour of a vehicle: stops as poses, legs that check-path and verify confirm."""
import json
import math
import re
import unittest

from program import ProgramTest

FREE = "type octile\nheight 20\nwidth 30\nmap\n" + ("." * 30 + "\n") * 20
ROS = "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n"
CAR = "footprint: [[-1, -0.6], [1.4, -0.6], [1.4, 0.6], [-1, 0.6]]\nturning_radius: 2\nunits: cells\n"
STOPS = [(4, 4, 0), (24, 5, math.pi / 2), (20, 15, None), (6, 14, None)]


class VehicleTours(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("free.map", FREE)
        self.write("car.yaml", CAR)
        self.write("s.json", json.dumps([list(stop) for stop in STOPS]))

    def tour(self, *arguments, stops="s.json", map_file="free.map"):
        return self.run_program("tour", map_file, "--stops", stops, "--vehicle", "car.yaml", *arguments)

    def test_a_tour_that_is_checked_and_replayed(self):
        self.write("s.tsv", "x\ty\tyaw\n4\t4\t0\n24\t5\t90deg\n20\t15\t\n6\t14\t\n")
        table = self.tour("--json", stops="s.tsv").json
        result = self.quiet(self.tour("--json", "-o", "t.json", "-o", "t.csv", "-o", "t.svg", "-o", "t.yaml")).json
        self.assertEqual(table["order"], result["order"])
        self.assertEqual(sorted(result["order"]), [0, 1, 2, 3])
        poses = dict(zip(result["order"], result["poses"]))
        for stop, (x, y, yaw) in enumerate(STOPS):
            self.assertEqual(poses[stop][:2], [x + 0.5, y + 0.5])
            if yaw is not None:
                self.assertEqual(poses[stop][2], yaw)
            else:
                self.assertEqual(poses[stop][2] % (math.pi / 4), 0)
        self.assertAlmostEqual(sum(leg["length"] for leg in result["legs"]), result["length"], places=9)
        self.assertLessEqual(result["lower_bound"], result["length"])
        for leg in result["legs"]:
            first = leg["segments"][0]
            self.assertEqual([first["x"], first["y"]], poses[leg["from"]][:2])
        self.ended(self.run_program("verify", "t.json"), 0)
        self.ended(self.run_program("check-path", "free.map", "t.csv", "--vehicle", "car.yaml"), 0)
        times = [float(row["t"]) for row in self.rows("t.csv")]
        self.assertEqual(times, sorted(times))
        self.assertAlmostEqual(times[-1], result["duration"], places=9)

    def test_from_pose_to_pose_in_metres(self):
        self.write("world.pgm", b"P5 30 20 255 " + b"\xfe" * 600)
        self.write("world.yaml", ROS)
        self.write("s.json", json.dumps([[1.5, 0.5, 0], [10.5, 1, "90deg"], [8, 4.5], [2, 4]]))
        result = self.tour("--json", "--frame", "world", "--start", "0,0,90deg", "--goal", "11,5,0", "-o", "m.json",
                           map_file="world.yaml").json
        self.assertEqual((result["order"][0], result["order"][-1]), (result["stops_world"].index([0, 0]),
                                                                    result["stops_world"].index([11, 5])))
        self.assertAlmostEqual(result["poses_world"][0][2], math.pi / 2, places=12)
        self.assertAlmostEqual(result["length_m"], 0.5 * result["length"], places=9)
        self.assertEqual((result["start_world"], result["goal_world"]), ([0, 0, math.pi / 2], [11, 5, 0]))
        self.ended(self.run_program("verify", "m.json"), 0)

    def test_a_stop_that_is_blocked_at_all_headings_of_a_turned_map(self):
        self.write("world.pgm", b"P5 30 20 255 " + b"\xfe" * 280 + b"\x00" + b"\xfe" * 319)
        self.write("world.yaml", ROS.replace("-2, 0]", "-2, -0.39269908]"))
        turn, cells = -0.39269908, [(10.5, 10.5), (20.5, 5.5), (5.5, 5.5)]
        self.write("s.json", json.dumps([[-1 + (x * math.cos(turn) - y * math.sin(turn)) / 2,
                                          -2 + (x * math.sin(turn) + y * math.cos(turn)) / 2] for x, y in cells]))
        result = self.tour("--json", "--frame", "world", map_file="world.yaml")
        self.ended(result, 0)
        (left,) = result.json["left_out"]
        self.assertRegex(left["why"], r"in cell \(10, 9\): the footprint meets cell \(\d+, \d+\), and others")

    def test_a_third_number_is_the_yaw(self):
        self.write("plain.tsv", "4\t4\t0\n24\t5\t90deg\n20\t15\t\n")
        self.assertEqual(self.tour("--json", stops="plain.tsv").json["yaws"], [0, math.pi / 2, None])
        for name, content in (("four.tsv", "4 4 0 1\n"), ("four.json", "[[4, 4, 0], [8, 8, 0, 1]]")):
            self.write(name, content)
            self.refused(self.tour(stops=name), 3, "the yaw")

    def test_of_one_stop_files_hold_its_pose(self):
        self.write("one.json", "[[6, 7, 1.5]]")
        result = self.tour("--json", "-o", "one.csv", "-o", "one.yaml", stops="one.json").json
        self.assertEqual((result["order"], result["legs"], result["duration"]), ([0], [], 0))
        for row in self.rows("one.csv"):
            self.assertEqual([float(row[key]) for key in ("x", "y", "yaw", "t")], [6.5, 7.5, 1.5, 0])
        self.assertEqual(len(self.rows("one.csv")), 1)  # as of a plan that begins at its goal
        self.assertIn(b"position: {x: 6.5, y: 7.5, z: 0.0}", self.read("one.yaml"))

    def test_a_page_has_the_tour_and_what_is_swept(self):
        result = self.tour("--json", "-o", "t.html", "-o", "t.csv").json
        page = self.read("t.html").decode()
        content = json.loads(re.search(r'<script type="application/json" id="content">(.*?)</script>', page, re.S)[1])
        self.assertEqual(content["kind"], "tour")
        self.assertEqual(content["vehicle"]["footprint"], [[-1, -0.6], [1.4, -0.6], [1.4, 0.6], [-1, 0.6]])
        self.assertEqual((content["result"]["order"], content["result"]["legs"]), (result["order"], result["legs"]))
        rows = [[float(v) for v in row.values()] for row in self.rows("t.csv")]
        self.assertEqual(len(rows), len(content["vehicle"]["poses"]))
        for row, pose in zip(rows, content["vehicle"]["poses"]):
            for a, b in zip(row, pose):
                self.assertAlmostEqual(a, b, delta=1e-6)
        self.write("one.json", "[[6, 7, 1.5]]")
        self.tour("-o", "one.html", stops="one.json")
        self.assertIn('"poses":[[6.5,7.5,1.5,', self.read("one.html").decode())

    def test_what_is_refused(self):
        self.ended(self.tour("--start", "4,4"), 2)
        self.ended(self.tour("--radius", "2"), 2)
        self.ended(self.tour("--start", "4,4,0", "--start", "8,8,0"), 2)
        self.ended(self.tour("--start", "0,0,0"), 4)
        self.ended(self.tour("--goal", "0,5,0"), 4, "goal (0.5, 5.5, 0): the footprint reaches out of the map, to cell (-1, 4); "
                   "the nearest pose of this heading, whole cells away, that meets nothing is (1.5, 5.5, 0)")
        self.write("bad.tsv", "x\ty\tyaw\n4\t4\tnorth\n")
        self.ended(self.tour(stops="bad.tsv"), 3)
        self.write("after.json", json.dumps([{"x": 4, "y": 4, "name": "a"}, {"x": 9, "y": 9, "after": "a"}]))
        self.ended(self.tour(stops="after.json"), 2)


if __name__ == "__main__":
    unittest.main()
