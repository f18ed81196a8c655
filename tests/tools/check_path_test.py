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

    def test_faults_of_files_are_told_by_line(self):
        cases = [
            ("", r"path\.csv, line 1: .*holds no point"),
            ("x,y,yaw\n", r"path\.csv, line 2: holds a header alone: there is no path; give the path of a plan"),
            ("a,b\n1,2\n", r"path\.csv, line 1: the header has no column x"),
            ("x,y\n1,2\n3,z\n", r"path\.csv, line 3: y is 'z'"),
            ("x,y\n1,nan\n", r"path\.csv, line 2: y is 'nan'"),
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
