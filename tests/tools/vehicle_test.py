"""plan, batch and check-path --vehicle: footprints judged by separating axes of the test's own."""
import json
import math
import os
import random
import re
import unittest

from layers import npy
from program import ProgramTest

MAP = """type octile
height 30
width 44
map
"""
ROWS = ["." * 44 for _ in range(30)]
for x, y, w, h in ((12, 0, 3, 12), (12, 18, 3, 12), (26, 8, 4, 4), (30, 20, 6, 3)):
    for row in range(y, y + h):
        ROWS[row] = ROWS[row][:x] + "@" * w + ROWS[row][x + w:]
MAP += "\n".join(ROWS) + "\n"

CAR = {"type": "car", "footprint": [[-1, -1.2], [3.5, -1.2], [3.5, 1.2], [-1, 1.2]], "turning_radius": 4, "units": "cells"}
ROBOT = {"type": "differential", "footprint": [[-2, -1.5], [2, -1.5], [2, 1.5], [-2, 1.5]], "units": "cells"}
FORWARD = {**CAR, "reverse": False}
OMNI = {**ROBOT, "type": "omni"}


def moved(corners, x, y, yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return [(x + c * a - s * b, y + s * a + c * b) for a, b in corners]


def overlap(polygon, x, y):
    """How deep a convex polygon is in the square at (x, y); below 0 apart."""
    square = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
    sides = [(1, 0), (0, 1)] + [(b[1] - a[1], a[0] - b[0]) for a, b in zip(polygon, polygon[1:] + polygon[:1])]
    least = math.inf
    for ax, ay in sides:
        size = math.hypot(ax, ay)
        one = [(px * ax + py * ay) / size for px, py in polygon]
        other = [(px * ax + py * ay) / size for px, py in square]
        least = min(least, max(one) - min(other), max(other) - min(one))
    return least


def depth(corners, pose, rows=ROWS):
    polygon = moved(corners, *pose)
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    deepest = -math.inf
    for y in range(math.floor(min(ys)) - 1, math.floor(max(ys)) + 2):
        for x in range(math.floor(min(xs)) - 1, math.floor(max(xs)) + 2):
            if not (0 <= x < len(rows[0]) and 0 <= y < len(rows)) or rows[y][x] == "@":
                deepest = max(deepest, overlap(polygon, x, y))
    return deepest


def pose_on(segment, share):
    """By the rule of the documents: yaw grows by curvature for each cell driven forwards."""
    x, y, yaw = segment["x"], segment["y"], segment["yaw"]
    if segment["gear"] == 0:
        return x, y, yaw + share * segment["angle"]
    far, k = segment["gear"] * share * segment["length"], segment["curvature"]
    if "angle" in segment:
        aside = yaw + segment["angle"]
        return x + far * math.cos(aside), y + far * math.sin(aside), yaw
    rate = segment.get("curvature_rate", 0)
    turned = yaw + k * far + rate * far ** 2 / 2
    if rate:  # Simpson's rule
        ways = [(yaw + k * s + rate * s * s / 2, (1 if i in (0, 60) else 4 if i % 2 else 2) * far / 180)
                for i in range(61) for s in [far * i / 60]]
        return x + sum(w * math.cos(a) for a, w in ways), y + sum(w * math.sin(a) for a, w in ways), turned
    if abs(k * far) < 1e-9:
        return x + far * math.cos(yaw), y + far * math.sin(yaw), turned
    return x + (math.sin(turned) - math.sin(yaw)) / k, y - (math.cos(turned) - math.cos(yaw)) / k, turned


def turned(a, b):
    return abs(math.remainder(a - b, 2 * math.pi))


class Vehicles(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("yard.map", MAP)
        for name, vehicle in (("car", CAR), ("robot", ROBOT), ("forward", FORWARD), ("omni", OMNI)):
            self.write(name + ".json", json.dumps(vehicle))

    def drive(self, vehicle, start, goal, *options, map_file="yard.map"):
        return self.run_program("plan", map_file, "--vehicle", vehicle, "--start", start, "--goal", goal, *options)

    def check(self, result, vehicle):
        """Ends, joints, curvature, sweep, length."""
        segments = result["segments"]
        at = result["start"]
        length = 0
        for segment in segments:
            self.assertLess(math.hypot(segment["x"] - at[0], segment["y"] - at[1]), 1e-6)
            self.assertLess(turned(segment["yaw"], at[2]), 1e-6)
            extent = abs(segment.get("angle", 0)) * 4 if segment["gear"] == 0 else segment["length"]
            if segment["gear"] == 0:
                self.assertTrue(vehicle.get("rotate_in_place", vehicle["type"] != "car"))
            else:
                radius = vehicle.get("turning_radius", 0)
                self.assertLessEqual(abs(segment["curvature"]), (1 / radius if radius else 0) * (1 + 1e-12))
                length += segment["length"]
            if segment["gear"] != 0 and "angle" in segment:
                self.assertEqual((vehicle["type"], segment["curvature"]), ("omni", 0))
            if segment["gear"] < 0:
                self.assertTrue(vehicle.get("reverse", vehicle["type"] == "car"))
            parts = max(1, math.ceil(extent / 0.05))
            for i in range(parts + 1):
                self.assertLess(depth(vehicle["footprint"], pose_on(segment, i / parts)), 1e-9)
            at = pose_on(segment, 1)
        self.assertLess(math.hypot(result["goal"][0] - at[0], result["goal"][1] - at[1]), 1e-6)
        self.assertLess(turned(result["goal"][2], at[2]), 1e-6)
        self.assertAlmostEqual(result["length"], length, places=6)

    def test_plans_touch_nothing_and_verify(self):
        draw, solved = random.Random(3), 0
        for name, vehicle in (("car", CAR), ("robot", ROBOT), ("forward", FORWARD), ("omni", OMNI)):
            for _ in range(5):
                ends = []
                while len(ends) < 2:
                    pose = (draw.uniform(2, 42), draw.uniform(2, 28), draw.uniform(-math.pi, math.pi))
                    if depth(vehicle["footprint"], pose) < -0.01:
                        ends.append(",".join(map(repr, pose)))
                run = self.drive(name + ".json", *ends, "-o", "run.json", "--json")
                self.assertIn(run.code, (0, 6), run.err)
                if run.code != 0:
                    continue
                solved += 1
                self.check(run.json, vehicle)
                self.assertGreaterEqual(run.json["length"], run.json["lower_bound"] * (1 - 1e-9))
                self.quiet(self.run_program("verify", "-q", "run.json"))
                self.assertEqual(self.run_program("check-path", "yard.map", "run.json").code, 0)
        self.assertGreaterEqual(solved, 17)

    def test_who_is_there_already_has_one_vertex(self):
        for goal in ("4,4,0", "4,4,360deg"):
            run = self.drive("car.json", "4,4,0", goal, "--json", "-o", "one.csv")
            self.assertEqual((run.json["path"], run.json["length"]), ([[4.5, 4.5]], 0))
            self.assertEqual(len(self.rows("one.csv")), 1)

    def test_files_of_poses(self):
        run = self.drive("car.json", "4,4,0", "38,26,180deg", "-o", "run.csv", "-o", "run.yaml", "-o", "run.svg", "--json")
        self.assertEqual(run.code, 0, run.err)
        rows = self.rows("run.csv")
        self.assertEqual(list(rows[0]), ["x", "y", "yaw", "kappa", "v", "t", "gear"])
        self.assertEqual([float(rows[0][k]) for k in ("x", "y", "yaw", "t")], [4.5, 4.5, 0, 0])
        self.assertAlmostEqual(float(rows[-1]["t"]), run.json["duration"], places=9)
        cusps = 0
        for a, b in zip(rows, rows[1:]):
            far = math.hypot(float(b["x"]) - float(a["x"]), float(b["y"]) - float(a["y"]))
            self.assertLessEqual(far, 0.5 + 1e-9)
            cusps += a["gear"] != b["gear"]
            self.assertEqual(a["gear"] != b["gear"], far == 0)
        self.assertEqual(cusps, run.json["cusps"])
        self.assertEqual(self.read("run.yaml").decode().count("position:"), len(rows))
        self.assertEqual(self.run_program("check-path", "yard.map", "run.csv", "--vehicle", "car.json", "--strict").code, 0)
        self.svg_root("run.svg")

    def test_a_page_has_what_is_swept_and_when(self):
        run = self.drive("car.json", "4,4,0", "38,26,180deg", "--json", "-o", "run.html", "-o", "run.csv")
        page = self.read("run.html").decode()
        found = re.findall(r'<script type="application/json" id="content">(.*?)</script>', page, re.S)
        content = json.loads(found[0])
        self.assertEqual((content["kind"], content["vehicle"]["footprint"]), ("vehicle", CAR["footprint"]))
        rows = [[float(v) for v in row.values()] for row in self.rows("run.csv")]
        self.assertEqual(len(rows), len(content["vehicle"]["poses"]))
        for row, pose in zip(rows, content["vehicle"]["poses"]):
            for a, b in zip(row, pose):
                self.assertAlmostEqual(a, b, delta=1e-6)
        self.assertEqual(content["result"]["segments"], run.json["segments"])
        self.assertIn("showVehicle", page)
        self.drive("car.json", "10.5,5,0", "38,26,0", "-o", "none.html")
        self.assertIn('"poses":[]', self.read("none.html").decode().replace(" ", ""))

    def test_contacts_are_named(self):
        run = self.drive("car.json", "10.5,5,0", "38,26,0")
        self.ended(run, 4, "start (10.5, 5, 0): the footprint meets the blocked cell (12, ", "nearest pose of this heading")
        run = self.drive("car.json", "5,5,0", "43,26,0", "--json")
        self.assertEqual((run.code, run.json["status"]), (4, "invalid"))
        x, y, yaw = run.json["nearest_free"]
        self.assertLess(depth(CAR["footprint"], (x, y, yaw)), 0)
        for goal in ("46,8,0", "80,8,0", "99999,8,0", "-500,8,0", "22,400,0", "300,-400,0"):  # the map is 44 x 30
            run = self.drive("car.json", "5,5,0", goal, "--json")
            x, y, yaw = run.json["nearest_free"]
            self.assertEqual((run.code, x % 1, y % 1), (4, 0.5, 0.5))
            self.assertLess(depth(CAR["footprint"], (x, y, yaw)), 0)
            asked = [float(v) + 0.5 for v in goal.split(",")[:2]]
            free = [(c + 0.5, r + 0.5) for c in range(44) for r in range(30) if depth(CAR["footprint"], (c + 0.5, r + 0.5, 0)) < -1e-6]
            self.assertAlmostEqual(math.dist(asked, (x, y)), min(math.dist(asked, p) for p in free), places=6)
        self.write("path.csv", "x,y,yaw\n5,15,0\n20,15,0\n24,10,-0.9\n")
        run = self.run_program("check-path", "yard.map", "path.csv", "--vehicle", "car.json", "--json")
        self.assertEqual((run.code, run.json["judged_as"], run.json["assumed_straight"]), (1, "vehicle", 1))
        fault = run.json["fault"]
        self.assertEqual(ROWS[fault["cell"][1]][fault["cell"][0]], "@")
        self.assertLess(abs(depth(CAR["footprint"], fault["at"])), 2e-3)

    def test_planted_contacts_are_found_and_clean_paths_pass(self):
        draw, verdicts, wanted = random.Random(8), [0, 0], int(os.environ.get("LASIUS_PLANTED", "8"))
        while min(verdicts) < wanted:
            x, y, yaw = draw.uniform(3, 41), draw.uniform(3, 27), draw.uniform(-3, 3)
            rows, deepest = ["x,y,yaw"], -math.inf
            k = draw.choice([0, 1 / 4, -1 / 7])
            for i in range(25):
                share = pose_on({"x": x, "y": y, "yaw": yaw, "curvature": k, "length": 12, "gear": 1}, i / 24)
                rows.append(",".join(f"{v:.6f}" for v in share))
            for i in range(301):
                pose = pose_on({"x": x, "y": y, "yaw": yaw, "curvature": k, "length": 12, "gear": 1}, i / 300)
                deepest = max(deepest, depth(CAR["footprint"], pose))
                if deepest > 0.04:
                    break
            # No point of it moves farther than that in half a step.
            if abs(deepest) < 0.04 or verdicts[deepest < 0] == wanted:
                continue
            self.write("path.csv", "\n".join(rows) + "\n")
            run = self.run_program("check-path", "yard.map", "path.csv", "--vehicle", "car.json")
            self.assertEqual(run.code, 0 if deepest < 0 else 1, (run.out, deepest))
            verdicts[deepest < 0] += 1

    def test_what_cannot_be_driven(self):
        cases = [
            ("5,15,0\n5.958851,15.244835,0.5\n", "turns sharper than the vehicle can", "car"),
            ("8,5,0\n6,5,0\n", "drives backwards", "forward"),
            ("5,15,0\n5,15,1\n", "turns in place", "car"),
            ("5,15,0\n5,16,0\n", "slip aside", "car"),
        ]
        self.write("aside.csv", "x,y,yaw\n5,15,0\n5,16,0\n6,17,1\n")
        self.assertEqual(self.run_program("check-path", "yard.map", "aside.csv", "--vehicle", "omni.json", "--strict").code, 0)
        for poses, why, vehicle in cases:
            with self.subTest(why=why):
                self.write("path.csv", "x,y,yaw\n" + poses)
                asked = ["check-path", "yard.map", "path.csv", "--vehicle", vehicle + ".json"]
                self.ended(self.run_program(*asked), 0, why)
                self.assertRegex(self.run_program(*asked, "--strict").out, "does not hold: .*" + why)

    def test_files_of_vehicles_are_refused_by_line_and_key(self):
        cases = [
            ("footprint: [[0,0],[1,0],[1,1]]\nturning_radios: 3\n", "line 2: 'turning_radios' is unknown", "turning_radius"),
            ("turning_radius: 3\n", "line 1: ", "'footprint' is missing"),
            ("footprint: [[0,0],[1,0]]\nturning_radius: 3\n", "line 1: 'footprint' has 2 corners", "3"),
            ("turning_radius: 3\nfootprint: [[0,0],[2,2],[2,0],[0,2]]\n", "line 2: 'footprint' cannot be", "meets another"),
            ("turning_radius: 3\nfootprint: [[0,0],[.nan,2],[2,0]]\n", "line 2: 'footprint' is \".nan\"", "number"),
            ("turning_radius: 3\nfootprint: [[0,0],[2],[2,0]]\n", "line 2: ", "not [x, y]"),
            ("type: car\nfootprint: [[0,0],[1,0],[1,1]]\n", "line 1: ", "'turning_radius' is missing"),
            ("type: car\nturning_radius: 0\nfootprint: [[0,0],[1,0],[1,1]]\n", "line 2: 'turning_radius' is 0", "differential"),
            ("type: omni\nturning_radius: 2\nfootprint: [[0,0],[1,0],[1,1]]\n", "line 2: 'turning_radius' is of no use to omni"),
            ("type: omni\nfootprint: [[0,0],[1,0],[1,1]]\nreverse: true\n", "line 3: 'reverse'", "any side"),
            ("type: cat\nturning_radius: 1\nfootprint: [[0,0],[1,0],[1,1]]\n", "line 1: 'type' is \"cat\"", "car"),
            ("units: metres\nturning_radius: 1\nfootprint: [[0,0],[1,0],[1,1]]\n", "line 1: 'units' is metres", "resolution"),
            ("turning_radius: 1\nfootprint: [[0,0],[1,0],[1,1]]\nreverse_cost: 0.5\n", "line 3: 'reverse_cost' is \"0.5\"", "from 1"),
            ("turning_radius: 1\nfootprint: [[0,0],[1,0],[1,1]]\nspeed: -1\n", "line 3: 'speed' is \"-1\"", "number"),
        ]
        for text, *words in cases:
            with self.subTest(text=text):
                self.write("v.yaml", text)
                self.refused(self.drive("v.yaml", "5,5,0", "20,20,0"), 3, "v.yaml", *words)
        self.refused(self.drive("none.yaml", "5,5,0", "20,20,0"), 3, "none.yaml")
        self.refused(self.drive("yard.map", "5,5,0", "20,20,0"), 3, "yard.map: this is a MovingAI map; give a vehicle")

    def test_commands_that_make_no_sense(self):
        for options, words in [(["--radius", "2"], "--radius"), (["--ants", "5"], "--ants"), (["--islands", "2"], "--islands"),
                               (["--exchange", "scheduled"], "--exchange"), (["--algorithm", "mmas"], "mmas"),
                               (["--seed", "1-3"], "--seed"), (["-o", "a.proof.json"], "a.proof.json"), (["--via", "3,3"], "--via")]:
            with self.subTest(options=options):
                self.refused(self.drive("car.json", "5,5,0", "20,20,0", *options), 2, words)
        for start in ("5,5", "5,5,x", "5,5,90degs", "5,5,1e9", "5,,1", "5,5,nan"):
            with self.subTest(start=start):
                self.refused(self.drive("car.json", start, "20,20,0"), 2, "--start")
        points = ("plan", "yard.map", "--start", "1,1", "--goal", "9,9")
        self.refused(self.run_program(*points, "--heading-tolerance", "1"), 2, "--vehicle")
        # What results name is listed.
        name = self.drive("car.json", "5,5,0", "20,20,0", "--json").json["algorithm"]
        self.holds(self.quiet(self.run_program("algorithms", name)).out, "Vehicles", f"\n{name}: ")
        self.refused(self.run_program(*points, "--algorithm", name), 2, name + " plans for vehicles", "--vehicle")

    def test_goals(self):
        near, far = "9.5,15.5,0", "38.5,26.5,180deg"
        run = self.drive("car.json", "4,4,0", far, "--goal", near, "-o", "g.json", "--json")
        result = run.json
        self.assertEqual((run.code, result["goal_index"], result["goal"], len(result["goals"])), (0, 1, [9.5, 15.5, 0], 2))
        self.check(result, CAR)
        self.quiet(self.run_program("verify", "-q", "g.json"))
        for goals in ([], None, {"a": result["goal"]}):
            self.write("bad.json", json.dumps({**result, "goals": goals}))
            self.refused(self.run_program("verify", "bad.json"), 3, "bad.json", '"goals" is')
        self.refused(self.run_program("plan", "yard.map", "--start", "1,1", "--goal", "2,2", "--goal", "3,3"), 2, "more than once")
        # Any heading will do where any is asked for, and a blocked goal is not met but neared.
        free = self.drive("car.json", "4,4,0", "9,15,3", "--heading-tolerance", "180deg", "--json").json
        self.assertLess(free["length"], self.drive("car.json", "4,4,0", "9,15,3", "--json").json["length"])
        close = self.drive("car.json", "4,4,0", "12.5,6,0", "--goal-tolerance", "6", "--json").json
        x, y, _ = close["goal_reached"]
        self.assertEqual(close["status"], "solved")
        self.assertLessEqual(math.hypot(x - 12.5, y - 6), 6)
        limit = self.drive("car.json", "4,4,0", far, "--time-limit", "0")
        self.ended(limit, 6, "the time limit ended the run, no path yet")

    def test_batch_gives_what_plan_gives(self):
        poses = [("4,4,0", "38,26,180deg"), ("10.5,5,0", "38,26,0"), ("20.5,15.5,90deg", "4.5,24.5,-1")]
        lines = ["\t".join(a.split(",") + b.split(",")) for a, b in poses]
        self.write("poses.tsv", "sx\tsy\tsyaw\tgx\tgy\tgyaw\n" + "\n".join(lines) + "\n")
        run = self.run_program("batch", "yard.map", "poses.tsv", "--vehicle", "car.json", "--threads", "2", "-o", "b.csv", "-o", "b.png")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual([line["status"] for line in run.lines], ["solved", "invalid", "solved"])
        for i, (start, goal) in enumerate(poses):
            alone = self.drive("car.json", start, goal, "--json").json
            self.assertEqual((run.lines[i]["index"], run.lines[i]["segments"]), (i, alone["segments"]))
        rows = self.rows("b.csv")
        self.assertEqual([row["status"] for row in rows], ["solved", "invalid", "solved"])
        self.assertEqual(float(rows[0]["gyaw"]), math.pi)
        self.write("b.jsonl", run.out)
        self.quiet(self.run_program("verify", "-q", "b.jsonl"))
        for text, problem in [("sx sy gx gy\n", "line 1: the header has no column syaw"),
                              ("sx sy syaw gx gy gyaw\n1 2 3\n", "line 2: 3 fields"),
                              ("sx,sy,syaw,gx,gy,gyaw,note\n1,,2,3,4,5,6 7\n", "line 2: start: "),
                              ("sx,sy,syaw,gx,gy,gyaw,gx\n1,2,2,3,4,5,6\n", "line 1: two columns are named gx"),
                              ("sx sy syaw gx gy gyaw\n1 2 east 3 4 0\n", "line 2: start: \"east\" is no angle; write 1.57")]:
            self.write("bad.tsv", text)
            self.refused(self.run_program("batch", "yard.map", "bad.tsv", "--vehicle", "car.json"), 3, problem)
        # Numbers out of range are of their query alone.
        far = "sx sy syaw gx gy gyaw\n4 4 1e9 38 26 0\n4 4 0 38 26 -1e300\n1e9 4 0 38 26 0\n4 4 0 38.5 1e300 0\n4 4 0 38 26 180deg\n"
        self.write("far.tsv", far)
        run = self.run_program("batch", "yard.map", "far.tsv", "--vehicle", "car.json")
        self.assertEqual((run.code, [line["status"] for line in run.lines]), (0, ["invalid"] * 4 + ["solved"]), run.err)
        self.assertIn("far.tsv: a yaw: 1e+09 radians are ", run.err)
        for line, word in zip(run.lines, ("start .*yaw", "goal .*yaw", "start .*outside", "goal .*outside")):
            self.assertRegex(line["error"], word)

    def test_broken_results_are_refused_by_file_and_place(self):
        good = self.drive("car.json", "4,4,0", "38,26,0", "--json").json
        self.write("good.json", json.dumps(good))
        self.assertEqual(self.run_program("check-path", "yard.map", "good.json").code, 0)
        segment = good["segments"][0]
        cases = [({"segments": 3}, '"segments" is no list'), ({"segments": [{**segment, "gear": 2}]}, '"gear"'),
                 ({"segments": [{**segment, "length": "far"}]}, '"length"'), ({"path": 7}, '"path"'), ({"path": [[1]]}, '"path"'),
                 ({"parameters": {"vehicle": {"footprint": [[0, 0], [1, 0]]}}}, "turning_radius"),
                 ({"segments": []}, '"segments" are none'), ({"segments": None}, '"segments" is no list'),
                 ({"parameters": {}}, "no vehicle"), ({"curve": [1]}, '"curve"'),
                 ({"segments": good["segments"][:-1]}, '"segments" begin or end elsewhere than "path"')]
        for change, word in cases:
            with self.subTest(change=change):
                self.write("bad.json", json.dumps({**good, **change}))
                self.refused(self.run_program("check-path", "yard.map", "bad.json"), 3, "bad.json", word)
        self.write("bad.json", "{")
        self.refused(self.run_program("check-path", "yard.map", "bad.json"), 3, "bad.json")
        for path in ([], None):
            self.write("none.json", json.dumps({**good, "path": path, "status": "no_path"}))
            self.refused(self.run_program("check-path", "yard.map", "none.json"), 2, "none.json", "no path to judge", "no_path")
        self.write("bad.json", json.dumps({**good, "parameters": []}))
        self.refused(self.run_program("verify", "bad.json"), 3, "bad.json", "cannot be replayed")

    def test_curvature_changes_no_faster_than_it_may(self):
        slow = {**CAR, "curvature_rate": 0.2, "acceleration": 1, "braking": 1}
        self.write("slow.json", json.dumps(slow))
        jumps = 0
        for start, goal in (("4,4,0", "38,26,180deg"), ("4,4,0", "36,4,0"), ("20.5,15.5,90deg", "4.5,24.5,-1")):
            run = self.drive("slow.json", start, goal, "--json", "-o", "s.json", "-o", "s.csv", "--spacing", "0.05")
            self.assertEqual(run.code, 0, run.err)
            self.check(run.json, slow)
            kept = [s["curvature_rate"] for s in run.json["segments"]]
            self.assertLessEqual(max(map(abs, kept)), 0.2 + 1e-12)
            self.assertGreater(max(map(abs, kept)), 0.19)
            jumps += run.json["corners"]
            # The curvature jumps where it rests alone.
            rows = [{k: float(v) for k, v in row.items()} for row in self.rows("s.csv")]
            rests = 0
            for a, b in zip(rows, rows[1:]):
                far = math.hypot(b["x"] - a["x"], b["y"] - a["y"])
                if abs(b["kappa"] - a["kappa"]) > 0.2 * far + 1e-6 and a["gear"] == b["gear"]:
                    self.assertEqual(a["v"], 0)
                    rests += 1
            self.assertEqual(rests, run.json["corners"])
            self.quiet(self.run_program("verify", "-q", "s.json"))
            self.assertEqual(self.run_program("check-path", "yard.map", "s.json").code, 0)
            self.assertEqual(self.run_program("check-path", "yard.map", "s.csv", "--vehicle", "slow.json").code, 0)
        self.assertLessEqual(jumps, 3)
        self.assertNotIn("corners", self.drive("car.json", "4,4,0", "36,4,0", "--json").json)
        self.write("bad.json", json.dumps({**CAR, "curvature_rate": 1e-5}))
        self.refused(self.drive("bad.json", "4,4,0", "36,4,0"), 3, "'curvature_rate' cannot be", "hundredth")

    def test_costs(self):
        values = [[(x * 7 + y * 3) % 5 / 4 for x in range(44)] for y in range(30)]
        self.write("hills.npy", npy(values))
        blocked = [(x, y) for y in range(30) for x in range(44) if ROWS[y][x] == "@"]

        def weight(x, y):
            d = min(math.dist((x, y), b) for b in blocked)
            return 1 + 2 * values[y][x] + (3 * min(1, math.exp(-0.5 * (d - 1))) if d <= 6 else 0)

        weights = [[weight(x, y) for x in range(44)] for y in range(30)]

        def cost(segments):
            total = 0
            for s in segments:
                pieces = 1 + int(500 * s["length"])
                ways = (pose_on(s, (i + 0.5) / pieces) for i in range(pieces))
                total += sum(weights[int(y)][int(x)] for x, y, _ in ways) * s["length"] / pieces * (2 if s["gear"] < 0 else 1)
            return total

        asked = ["--cost", "hills.npy*2", "--inflation", "6,0.5,3"]
        run = self.drive("car.json", "4,4,0", "38,26,180deg", *asked, "--json", "-o", "c.json", "-o", "c.svg")
        self.assertEqual(run.code, 0, run.err)
        self.check(run.json, CAR)
        self.assertAlmostEqual(run.json["cost"], cost(run.json["segments"]), delta=1e-3 * run.json["cost"])
        plain = self.drive("car.json", "4,4,0", "38,26,180deg", "--json").json
        self.assertLess(run.json["cost"], cost(plain["segments"]))
        self.assertLessEqual(run.json["lower_bound"], run.json["cost"])
        self.assertGreater(run.json["lower_bound"], plain["lower_bound"])
        self.assertAlmostEqual(run.json["gap"], run.json["cost"] / run.json["lower_bound"] - 1, places=9)
        self.assertGreaterEqual(run.json["priced_length"], run.json["length"])
        self.assertEqual((run.json["layers"][0]["factor"], run.json["parameters"]["inflation"]), (2, [6, 0.5, 3]))
        self.assertNotIn("cost", plain)
        text = "".join(self.svg_root("c.svg").itertext())
        self.assertIn("above the least", text)
        self.assertIn("weight of cells", text)
        self.quiet(self.run_program("verify", "-q", "c.json"))
        self.write("poses.tsv", "sx sy syaw gx gy gyaw\n4 4 0 38 26 180deg\n")
        batch = self.run_program("batch", "yard.map", "poses.tsv", "--vehicle", "car.json", *asked, "-o", "b.csv")
        self.assertEqual(batch.lines[0]["segments"], run.json["segments"])
        self.assertEqual(float(self.rows("b.csv")[0]["cost"]), run.json["cost"])
        # One weight everywhere: the paths without.
        self.write("flat.npy", npy([[1] * 44] * 30))
        flat = self.drive("car.json", "4,4,0", "38,26,180deg", "--cost", "flat.npy*0.5", "--json").json
        self.assertEqual((flat["segments"], flat["cost"]), (plain["segments"], 1.5 * plain["priced_length"]))
        self.write("hills.npy", npy(values[::-1]))
        self.refused(self.run_program("verify", "c.json"), 3, "hills.npy", "has hash")
        self.refused(self.drive("car.json", "4,4,0", "38,26,0", "--cost", "none.npy"), 3, "none.npy")

    def test_metres_and_degrees(self):
        """A map turned in the world: the plan in metres is that in cells, seen from there."""
        grey = bytes(0 if c == "@" else 255 for row in ROWS for c in row)
        self.write("yard.pgm", b"P5\n44 30\n255\n" + grey)
        self.write("yard.yaml", "image: yard.pgm\nresolution: 0.25\norigin: [-3.0, 2.0, 0.5]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.2\n")
        # y of a footprint is to the left in the world, and down in cells.
        skew = {"type": "car", "footprint": [[-1, -1], [3, -1], [3, 1.75], [-1, 1]], "turning_radius": 4}
        mirrored = {**skew, "footprint": [[x, -y] for x, y in skew["footprint"]], "units": "cells"}
        metres = {**skew, "footprint": [[x / 4, y / 4] for x, y in skew["footprint"]], "turning_radius": 1}
        self.write("m.json", json.dumps(metres))
        self.write("c.json", json.dumps(mirrored))

        def world(x, y, yaw):
            c, s, u, v = math.cos(0.5), math.sin(0.5), x * 0.25, (30 - y) * 0.25
            return -3 + c * u - s * v, 2 + s * u + c * v, 0.5 - yaw

        ends = [(4.5, 4.5, 0.25), (38.5, 26.5, -2)]
        given = [",".join(map(repr, world(*end))) for end in ends]
        run = self.drive("m.json", *given, "--frame", "world", "-o", "w.csv", "-o", "w.json", "--json", map_file="yard.yaml")
        self.assertEqual(run.code, 0, run.err)
        cells = self.drive("c.json", *(",".join(map(repr, end)) for end in ends), "--json").json
        self.check(run.json, mirrored)
        self.assertAlmostEqual(run.json["length"], cells["length"], places=6)
        self.assertAlmostEqual(run.json["length_m"], cells["length"] / 4, places=6)
        self.assertEqual(run.json["start_world"], list(world(*ends[0])))
        rows = self.rows("w.csv")
        for row, end in ((rows[0], ends[0]), (rows[-1], ends[1])):
            self.assertEqual([float(row["x"]), float(row["y"])], list(world(*end)[:2]))
            self.assertLess(turned(float(row["yaw"]), world(*end)[2]), 1e-6)
        for segment, there in zip(run.json["segments"], run.json["segments_world"]):
            at = world(segment["x"], segment["y"], segment["yaw"])
            self.assertLess(math.hypot(at[0] - there["x"], at[1] - there["y"]) + turned(at[2], there["yaw"]), 1e-9)
            self.assertAlmostEqual(there["curvature"], -4 * segment["curvature"], places=9)
        self.quiet(self.run_program("verify", "-q", "w.json"))
        asked = ["--frame", "world", "--vehicle", "m.json", "--strict"]
        self.assertEqual(self.run_program("check-path", "yard.yaml", "w.csv", *asked).code, 0)


if __name__ == "__main__":
    unittest.main()
