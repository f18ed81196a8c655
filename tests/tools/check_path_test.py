"""check-path: points, discs and footprints along anybody's path, judged by distances of the test's own."""
import json
import math
import random
import unittest

from disc_test import Judge
from program import ProgramTest

MAP = """type octile
height 12
width 24
map
........................
........................
....@@..................
....@@......@...........
............@...........
........................
........................
.......@................
................@@@@....
................@@@@....
........................
........................
"""
ROWS = MAP.splitlines()[4:]


class CheckPath(ProgramTest):
    algorithm = "exact"

    def setUp(self):
        super().setUp()
        self.write("room.map", MAP)

    def judged(self, content, *options, name="path.csv", code=None):
        self.write(name, content)
        run = self.run_program("check-path", "room.map", name, *options)
        self.assertEqual(run.code, 0 if run.out.startswith("holds") else 1, run.err)
        if code is not None:
            self.assertEqual(run.code, code, run.out)
        return run

    def table(self, points, header="x,y"):
        return header + "\n" + "".join(",".join(repr(v) for v in p) + "\n" for p in points)

    def test_points_obey_the_rule_of_the_map(self):
        cases = [
            ([(0.5, 0.5), (23.5, 0.5)], None),
            ([(0.3, 2.7), (3.9, 2.1), (4, 2), (6, 2), (7.25, 3.125)], None),  # along an edge, by a corner
            ([(0.5, 0.5), (8.5, 4.5)], r"enters the blocked cell \(4, 2\)"),
            ([(0.25, 0.25), (3.3, 2.7), (4.2, 2.7)], r"meets a blocked cell.*, 4\.6\d* cells along the path, at \(4, 2\.7\)"),
            ([(0.5, 0.5), (30, 0.5)], r"leaves the map, 23\.5 cells along"),
            ([(-1, 3), (2, 3)], "begins outside the map"),
        ]
        for points, fault in cases:
            with self.subTest(points=points):
                run = self.judged(self.table(points), code=0 if fault is None else 1)
                self.assertRegex(run.out, fault or r"^holds: \d+ pieces?, ")

    def test_of_a_point_the_cell_is_told_and_the_first_fault(self):
        self.write("diagonal.map", "type octile\nheight 5\nwidth 5\nmap\n.....\n..@..\n.@...\n.....\n...@.\n")
        for points, cells, at in (([(0.5, 0.5), (4.5, 3.5)], [[2, 1]], None), ([(0.5, 3.5), (0.5, 9)], [[0, 5]], [0.5, 5]),
                                  ([(1.5, 2.5)], [[1, 2]], [1.5, 2.5]), ([(3, 2), (4, 4), (4, 5), (3.5, 4.5)], [[3, 4]], [4, 5]),
                                  # A squeeze at (2, 2), then a blocked cell.
                                  ([(1.5, 1.5), (2, 2), (3.5, 4.9)], [[2, 1], [1, 2]], [2, 2]),
                                  ([(1, 1), (0, 1), (-1, 0)], [[-1, 0]], [0, 1]),
                                  ([(1.5, 1.5), (2, 2), (2.5, 3)], [[2, 1], [1, 2]], [2, 2]), ([(9, 9), (1, 1)], [None], [9, 9])):
            self.write("path.csv", self.table(points))
            run = self.run_program("check-path", "diagonal.map", "path.csv", "--json")
            fault = run.json["fault"]
            self.assertIn(fault["cell"], cells, points)
            for place, value in zip(fault["at"], at or fault["at"]):
                self.assertAlmostEqual(place, value, places=6)
        # A squeeze that is allowed, then a blocked cell.
        self.write("run.json", json.dumps({"path": [[0.5, 3.5], [2, 2], [4, 0], [3.5, 4.5]], "parameters": {"corners": "allow"}}))
        fault = self.run_program("check-path", "diagonal.map", "run.json", "--json").json["fault"]
        self.assertEqual(fault["cell"], [1, 2])
        self.write("run.json", json.dumps({"path": [[0.5, 0.5], [4.5, 4.5], [3.5, 4.5]], "parameters": {"corners": "allow"}}))
        fault = self.run_program("check-path", "diagonal.map", "run.json", "--json").json["fault"]
        self.assertEqual(fault["cell"], [3, 4])
        self.assertAlmostEqual(fault["at"][0], 4, places=6)

    def test_discs_on_random_lines_are_judged_as_by_distance(self):
        draw, judge, verdicts = random.Random(5), Judge(ROWS), [0, 0]
        for _ in range(40):
            points = [(draw.uniform(1, 23), draw.uniform(1, 11)) for _ in range(3)]
            least = min(judge.segment(a, b) for a, b in zip(points, points[1:]))
            for radius, holds in ((least + 1e-6, False), (least - 1e-6, True)):
                if radius > 0.01:
                    self.judged(self.table(points), "--radius", repr(radius), code=0 if holds else 1)
                    verdicts[holds] += 1
        self.assertGreater(min(verdicts), 8)

    def test_of_a_disc_the_first_place_is_named(self):
        run = self.judged(self.table([(2.5, 3.5), (2.5, 5.5), (20.5, 5.5)]), "--radius", "0.75", "--json")
        self.assertEqual(run.code, 1)
        fault = json.loads(run.out)["fault"]
        self.assertEqual(fault["cell"], [12, 4])
        far = math.sqrt(0.75 ** 2 - 0.5 ** 2)
        self.assertAlmostEqual(fault["along"], 2 + 12 - far - 2.5, places=6)
        self.assertAlmostEqual(fault["at"][0], 12 - far, places=6)

    def test_no_path_keeps_more_than_half_the_map(self):
        for radius in ("6.0001", "1e6", "3e9", "1e100", "1e308"):  # of 12 rows
            run = self.judged(self.table([(15.5, 6), (16, 6)]), "--radius", radius, code=1)
            self.assertIn("comes nearer than the radius to ", run.out)
            self.assertIn(", 0 cells along the path", run.out)
        self.write("room.map", MAP.replace("@", "."))
        self.judged(self.table([(15.5, 6), (16, 6)]), "--radius", "6", code=0)

    def test_own_results_hold_for_what_they_were_planned_with(self):
        for radius in ("0", "0.5", "1.3", "2"):
            run = self.run_program("plan", "room.map", "--start", "4,6", "--goal", "21,2", "--radius", radius,
                              "--spacing", "0.3", "-o", "run.json", "-o", "run.csv")
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(self.run_program("check-path", "room.map", "run.json").code, 0)
            more = repr(float(radius) + 1e-4)
            self.assertEqual(self.run_program("check-path", "room.map", "run.json", "--radius", more).code, 1)
            # Poses on arcs of the curve: lines between them would come too near.
            asked = ["--radius", radius] if radius != "0" else []
            run = self.run_program("check-path", "room.map", "run.csv", *asked)
            self.assertEqual(run.code, 0, run.out)

    def test_all_that_the_program_writes_is_read(self):
        """Plans, drives and tours of vehicles, arcs and clothoids, as JSON, table and nav_msgs/Path."""
        corners = [[-1, -0.6], [1.4, -0.6], [1.4, 0.6], [-1, 0.6]]
        car = {"footprint": corners, "turning_radius": 2, "units": "cells"}
        self.write("stops.json", json.dumps([[4, 6, 0], [20, 2, "90deg"], [12, 10]]))
        self.write("one.json", json.dumps([[4, 6, 1]]))
        for name, vehicle in (("car", car), ("clothoid", {**car, "curvature_rate": 0.4}),
                              ("omni", {"footprint": corners, "type": "omni", "units": "cells"})):
            self.write("v.json", json.dumps(vehicle))
            runs = [["plan", "--start", "4,6,0", "--goal", "20,2,90deg"], ["tour", "--stops", "stops.json"],
                    ["tour", "--stops", "one.json", "--open"], ["drive", "--start", "4,6,0", "--goal", "20,2,90deg"]]
            for command, *options in runs[:3] if name == "clothoid" else runs:
                files = ["run.json", "run.csv"] + (["run.yaml"] if command != "drive" else [])
                done = self.run_program(command, "room.map", *options, "--vehicle", "v.json",
                                        *(word for file in files for word in ("-o", file)))
                self.assertEqual(done.code, 0, done.err)
                for file in files:
                    # A nav_msgs/Path tells no curvature: there clothoids are not seen.
                    strict = ["--strict"] if name != "clothoid" or file != "run.yaml" else []
                    run = self.run_program("check-path", "room.map", file, "--vehicle", "v.json", *strict, "--json")
                    self.assertEqual((run.code, run.json["judged_as"]), (0, "vehicle"), (command, file, run.out))
                    if command != "drive":
                        told = json.loads(self.read("run.json"))["length"]
                        self.assertAlmostEqual(run.json["length"], told, places=2 if file == "run.yaml" else 4)
                    if strict and name != "omni":  # which is driven aside, as told
                        self.assertEqual(run.json["assumed_straight"], 0)
                self.assertEqual(self.run_program("check-path", "room.map", "run.json").code, 0)
        # A wider turn than the result's vehicle, and a curvature that changes more slowly.
        self.write("clothoid.json", json.dumps({**car, "curvature_rate": 0.4}))
        self.run_program("plan", "room.map", "--start", "4,6,0", "--goal", "20,2,90deg", "--vehicle", "clothoid.json",
                         "-o", "run.json")
        for more, fault in (({"turning_radius": 4}, "turns sharper"),
                            ({"turning_radius": 1, "curvature_rate": 0.1}, "curvature changes faster")):
            self.write("other.json", json.dumps({**car, **more}))
            run = self.run_program("check-path", "room.map", "run.json", "--vehicle", "other.json")
            self.assertEqual(run.code, 1)
            self.assertIn(fault, run.out)

    def test_clothoids_are_rebuilt_from_their_curvatures(self):
        """Forwards and backwards, in metres of a turned map too; one curvature that is wrong at a corner does no harm."""
        def clothoid(gear, n=200000):
            poses, x, y, yaw = [], 6.0, 6.0, 0.3
            for i in range(n + 1):
                s = gear * 4 * i / n
                if i % (n // 8) == 0:
                    poses.append((x, y, 0.3 - 0.1 * s + 0.06 * s * s, -0.1 + 0.12 * s))
                middle = s + gear * 2 / n
                yaw = 0.3 - 0.1 * middle + 0.06 * middle ** 2
                x, y = x + gear * 4 / n * math.cos(yaw), y + gear * 4 / n * math.sin(yaw)
            return poses
        self.write("v.json", json.dumps({"footprint": [[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]], "turning_radius": 1.5,
                                         "reverse": True, "units": "cells"}))
        self.write("room.map", MAP.replace("@", "."))
        self.write("world.pgm", b"P5 24 12 255 " + b"\xfe" * 288)
        self.write("world.yaml", "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0.7]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.2\n")
        c, s = math.cos(0.7), math.sin(0.7)
        for gear in (1, -1):
            poses = clothoid(gear)
            poses[4] = (*poses[4][:3], 0.0)
            metres = [(-1 + (c * x - s * (12 - y)) / 2, -2 + (s * x + c * (12 - y)) / 2, 0.7 - yaw, -2 * k)
                      for x, y, yaw, k in poses]
            for rows, map_file, frame in ((poses, "room.map", "cell"), (metres, "world.yaml", "world")):
                self.write("path.csv", self.table(rows, "x,y,yaw,kappa"))
                run = self.run_program("check-path", map_file, "path.csv", "--vehicle", "v.json", "--strict", "--frame", frame,
                                       "--json")
                self.assertEqual((run.code, run.json["assumed_straight"]), (0, 0), run.out)
                self.assertAlmostEqual(run.json["length"], 4, places=6)
            self.write("path.csv", self.table([p[:3] for p in poses], "x,y,yaw"))
            self.assertEqual(self.run_program("check-path", "room.map", "path.csv", "--vehicle", "v.json", "--strict").code, 1)

    def test_paths_as_ros_prints_them(self):
        pose = "- header: {}\n  pose:\n    position: {x: %s, y: 6, z: 0}\n    orientation: {x: 0, y: 0, z: 0, w: %s}\n"
        text = "header: {frame_id: map}\nposes:\n"
        self.assertIn("1 piece, 2 cells", self.judged(text + pose % (2, 1) + pose % (4, 1) + "---\n", name="path.yaml").out)
        for content, said in ((text + pose % (2, 0), r"line 6: 'orientation' is all zero"), ("poses: []\n", "there is no path"),
                              (text + pose % ("x", 1), r"line 5: 'x' is \"x\""), ("a: 1\n", "'poses' is missing"),
                              (text + pose % (2, 1e300), r"line 6: 'w' is ")):
            self.write("path.yaml", content)
            run = self.run_program("check-path", "room.map", "path.yaml")
            self.assertEqual(run.code, 3)
            self.assertRegex(run.err, said)

    def test_results_without_one_path(self):
        for content, code, said in (('{"track": null, "status": "invalid"}', 2, "its status is invalid"),
                                    ('{"track": null, "status": null}', 3, '"status"'), ('{"path": null, "status": 4}', 3, '"status"'),
                                    ('{"legs": [], "tours": []}', 2, "tours of several robots"),
                                    ('{"legs": []}', 3, '"order"'),
                                    ('{"legs": [], "order": [0]}', 3, '"stops"'),
                                    ('{"legs": {"a": {"path": [[1, 2]]}}}', 3, "no list of legs"),
                                    ('{"legs": [], "stops": [[1, 1]], "order": [1]}', 3, '"order"'),
                                    ('{"legs": [], "stops": [[1]], "order": [0]}', 3, '"stops"'),
                                    ('{"legs": [], "stops": [], "order": [0]}', 3, '"order"'),
                                    ('{"legs": [], "stops": [[1, 1]], "order": []}', 3, "no point"),
                                    ('{"path": {"a": [1, 2]}}', 3, "no list of points"),
                                    ('{"track": [[1, 1, 0]], "parameters": 5}', 3, '"parameters" is 5'),
                                    ('{"track": [[1, 1, 0]], "parameters": null}', 3, '"parameters" is null'),
                                    ('{"legs": [{"from": 0, "to": 1, "path": [[1]]}], "order": [0, 1]}', 3, "no list of points"),
                                    ('{"track": [[1, 1, 0], [9, 9, 0]], "segments": [], "length": 12, "parameters": {"vehicle": {}}}', 3,
                                     '"segments" are none'),
                                    ('{"path": 4}', 3, "no list of points"), ("[]", 3, "path")):
            self.write("run.json", content)
            run = self.run_program("check-path", "room.map", "run.json")
            self.assertEqual(run.code, code, run.err)
            self.assertIn(said, run.err)

    def test_of_a_tour_no_leg_may_be_missing(self):
        self.write("v.json", json.dumps({"footprint": [[-1, -0.6], [1, -0.6], [1, 0.6]], "turning_radius": 2, "units": "cells"}))
        self.write("stops.json", json.dumps([[4, 6], [21, 2], [12, 10], [4, 6]]))
        cases = [(lambda legs: [], "leg 0 of "), (lambda legs: legs[:-1], " is missing"),
                 (lambda legs: [{**legs[0], "path": []}, *legs[1:]], "leg 0 has no path"),
                 (lambda legs: legs[::-1], "leg 0 joins other stops than"), (lambda legs: legs + legs, " joins other stops than")]
        of_vehicle = [(lambda legs: legs[:-1] + [{**legs[-1], "segments": []}], " has no path")]
        for options in (["--open"], [], ["--start", "4,6", "--goal", "4,6"], ["--start", "4,6", "--goal", "21,2"],
                        ["--vehicle", "v.json"], ["--vehicle", "v.json", "--start", "4,6,0", "--goal", "4,6,0"]):
            run = self.run_program("tour", "room.map", "--stops", "stops.json", *options, "-o", "tour.json")
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(self.run_program("check-path", "room.map", "tour.json").code, 0, options)
            tour = json.loads(self.read("tour.json"))
            for legs, said in cases + (of_vehicle if "--vehicle" in options else []):
                self.write("cut.json", json.dumps({**tour, "legs": legs(tour["legs"])}))
                self.refused(self.run_program("check-path", "room.map", "cut.json"), 3, "cut.json", said)

    def test_tours_of_one_stop(self):
        self.write("world.pgm", b"P5 24 12 255 " + b"\xfe" * 288)
        self.write("world.yaml", "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0.7]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.2\n")
        for stop, map_file, frame in (([3, 2], "room.map", "cell"), ([3.5, 2.25], "room.map", "cell"),
                                      ([-0.5, -1], "world.yaml", "world")):
            self.write("one.json", json.dumps([stop]))
            run = self.run_program("tour", map_file, "--stops", "one.json", "--open", "--radius", "0.25", "--frame", frame,
                                   "-o", "run.json")
            self.assertEqual(run.code, 0, run.err)
            self.assertIn("holds: ", self.run_program("check-path", map_file, "run.json").out)
        result = json.loads(self.read("run.json"))
        self.write("run.json", json.dumps({**result, "stops": [[4, 2]], "stops_world": None}))
        run = self.run_program("check-path", "room.map", "run.json")
        self.assertEqual((run.code, "at (4.5, 2.5)" in run.out), (1, True), run.out)

    def test_what_a_line_meets_before_it_leaves_the_map(self):
        for end, options, why, at in (((900, 900), [], "meets a blocked cell", [7, 7]), ((1e15, 1e15), [], "meets a blocked cell", [7, 7]),
                                      ((1e15, 1e15), ["--radius", "0.2"], r"the blocked cell \(4, 3\)", [3.8, 3.8]),
                                      ((1e15, 1.5), [], "^leaves the map$", [24, 1.5]), ((1.5, -3e14), [], "^leaves the map$", [1.5, 0]),
                                      ((1.5, -3e14), ["--radius", "0.2"], r"the outside, cell \(1, -1\)", [1.5, 0.2])):
            self.write("path.csv", f"x,y\n1.5,1.5\n{end[0]},{end[1]}\n")
            run = self.run_program("check-path", "room.map", "path.csv", *options, "--json")
            fault = json.loads(run.out)["fault"]
            self.assertEqual(run.code, 1, run.err)
            self.assertRegex(fault["why"], why)
            for i in range(2):
                self.assertAlmostEqual(fault["at"][i], at[i], delta=1e-6)

    def test_arcs_of_a_curve_join_its_points(self):
        self.write("open.map", "type octile\nheight 9\nwidth 9\nmap\n" + "\n".join(["." * 9] * 4 + ["...@@@..."] + ["." * 9] * 4) + "\n")
        run = self.run_program("plan", "open.map", "--start", "4,1", "--goal", "4,7", "--radius", "0.5", "-o", "run.json")
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("holds: ", self.run_program("check-path", "open.map", "run.json").out)
        result = json.loads(self.read("run.json"))
        arc = next(i for i, piece in enumerate(result["curve"]) if isinstance(piece, dict))
        for change, said in (({"centre": [4.5, 5]}, "does not join its points"), ({"radius": 1e9}, "does not join its points"),
                             ({"centre": [1e308, 0]}, "coordinates are at most 1e")):
            curve = list(result["curve"])
            curve[arc] = {**curve[arc], **change}
            self.write("changed.json", json.dumps({**result, "curve": curve}))
            self.refused(self.run_program("check-path", "open.map", "changed.json"), 3, "changed.json", said)
        for curve in (result["curve"][:-1], result["curve"][1:], result["curve"][:1]):
            self.write("changed.json", json.dumps({**result, "curve": curve}))
            self.refused(self.run_program("check-path", "open.map", "changed.json"), 3, "changed.json", "elsewhere than \"path\"")

    def test_a_disc_that_stays_where_it_is(self):
        self.run_program("plan", "room.map", "--start", "8,5", "--goal", "8,5", "--radius", "1", "-o", "run.json")
        self.assertEqual(self.run_program("check-path", "room.map", "run.json").out, "holds: 1 piece, 0 cells\n")

    def test_faults_of_files_are_told_by_line(self):
        cases = [
            ("", r"path\.csv, line 1: .*holds no point"),
            ("x,y,yaw\n", r"path\.csv, line 2: holds a header alone: there is no path; give the path of a plan"),
            ("a,b\n1,2\n", r"path\.csv, line 1: the header has no column x"),
            ("x,y\n1,2\n3,z\n", r"path\.csv, line 3: y is 'z'"),
            ("x,y\n1,nan\n", r"path\.csv, line 2: y is 'nan'"),
            ("x,y\n1,2\n1.7e308,1\n", r"path\.csv, line 3: x is '1\.7e308'; give a number, at most 1e\+15"),
            ("x,y,yaw\n1,2,3e5\n", r"path\.csv, line 2: yaw is '3e5'; give radians"),
            ("x,y,yaw\n1,2\n", r"path\.csv, line 2: 2 fields instead of 3"),
        ]
        for content, text in cases:
            with self.subTest(content=content):
                self.write("path.csv", content)
                run = self.run_program("check-path", "room.map", "path.csv")
                self.assertEqual(run.code, 3)
                self.assertRegex(run.err, text)


if __name__ == "__main__":
    unittest.main()
