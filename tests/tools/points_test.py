"""plan and batch between points: what they begin and end with, in cells and in metres."""
import json
import math
import re
import unittest

from program import ProgramTest

MAP = "image: m.pgm\nresolution: 0.05\norigin: [-2.3, 1.7, YAW]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"


class Points(ProgramTest):
    algorithm = "exact"

    def replayed(self, answer):
        self.ended(self.replay_of(answer), 0)

    def apart_from(self, answer, *keys):
        return {k: v for k, v in answer.items() if k not in ("elapsed_ms", *keys)}

    def test_a_centre_is_its_cell(self):
        for more in ((), ("--algorithm", "as", "--iterations", "3"), ("--radius", "0.5"), ("--prepare",)):
            cells = self.quiet(self.plan("--json", *more)).json
            points = self.quiet(self.plan("--json", *more, start="0.5,0.5", goal="9.5,55e-1")).json
            self.assertEqual((points["start"], points["goal"]), ([0.5, 0.5], [9.5, 5.5]))
            self.assertIn('"start":[0.5,0.5]', json.dumps(points, separators=(",", ":")))
            self.assertEqual(self.apart_from(points, "start", "goal"), self.apart_from(cells, "start", "goal"))
            self.replayed(points)
            self.replayed(cells)

    def test_points(self):
        length = {}
        for algorithm, *more in (("exact",), ("as", "--iterations", "4"), ("grid-ga", "--iterations", "3"),
                                 ("exact", "--prepare")):
            answer = self.quiet(self.plan("--json", "-q", "--algorithm", algorithm, *more, "--gap", start="0.25,1e-1",
                                          goal="9,5.75")).json
            self.assertEqual((answer["start"], answer["goal"]), ([0.25, 0.1], [9.0, 5.75]))
            self.assertEqual((answer["path"][0], answer["path"][-1]), (answer["start"], answer["goal"]))
            self.assertAlmostEqual(answer["length"], sum(map(math.dist, answer["path"], answer["path"][1:])), delta=1e-9)
            self.assertGreaterEqual(answer["length"], answer["optimum"] - 1e-9)
            length[algorithm] = answer["optimum"]
            if answer["best"]:
                self.assertEqual(answer["best"][-1], answer["length"])
            self.replayed(answer)
        self.assertEqual(len(set(length.values())), 1)
        back = self.quiet(self.plan("--json", start="9,5.75", goal="0.25,0.1")).json
        self.assertAlmostEqual(back["length"], length["exact"], delta=1e-12)
        # A pair is a point as a whole; its text and table tell it.
        text = self.quiet(self.plan("-o", "p.csv", start="0,0.5", goal="9,5")).out.splitlines()
        self.assertEqual((text[2], text[-1]), ("0 0.5", "9.5 5.5"))
        self.assertEqual(self.rows("p.csv")[0], {"x": "0", "y": "0.5"})

    def test_borders_and_what_is_refused(self):
        for goal in ("3,2.5", "4.0,0", "10,6.0", "0.0,6", "3.0,2"):  # beside the wall, its corner, the map's corners
            self.assertEqual(self.quiet(self.plan("--json", goal=goal)).json["status"], "solved", goal)
        self.ended(self.plan(goal="3.5,2.5"), 4, "goal (3.5, 2.5) is blocked; the nearest free cell")
        self.ended(self.plan(goal="4.0,1.5"), 4, "goal (4, 1.5) is blocked")  # between two blocked cells
        self.ended(self.plan(goal="10.25,2"), 4, "goal (10.25, 2) is outside the map")
        self.ended(self.plan(start="0.5,-1e-9"), 4, "start (0.5, -1e-09) is outside the map")
        self.ended(self.plan(goal="4.5,2.5"), 5, "goal (4.5, 2.5)")
        self.refused(self.plan(goal="4.5,2.5.1"), 2, "--goal")
        self.refused(self.plan(goal="nan,1.5"), 2, "--goal")
        self.refused(self.plan(goal="1e999,1.5"), 2, "--goal")
        # A disc's points keep its radius.
        self.ended(self.plan("--radius", "0.4", goal="9.7,5.5"), 4, "goal (9.7, 5.5)", "too near to the edge of the map")
        disc = self.quiet(self.plan("--json", "--radius", "0.25", goal="9.75,5.75")).json
        self.assertEqual(disc["path"][-1], [9.75, 5.75])
        led = self.ended(self.plan("--json", "--radius", "0.4", start="0.25,0.5"), 0).json
        self.assertAlmostEqual(led["way_out"][0], 0.4, delta=1e-6)
        self.assertEqual(led["path"][0], [0.25, 0.5])
        self.replayed(led)

    def test_batches(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n0.5\t0.5\t9.5\t5.5\n0.25\t1\t9\t5\n3.5\t2.5\t0\t0\n")
        cells, centres, point, bad = self.quiet(self.run_program("batch", "small.map", "q.tsv", "-o", "q.csv")).lines
        self.assertEqual(cells["path"], centres["path"])
        self.assertEqual((point["start"], point["goal"], point["path"][0]), ([0.25, 1.0], [9, 5], [0.25, 1.0]))
        self.assertEqual(bad["status"], "invalid")
        alone = self.quiet(self.plan("--json", start="0.25,1", goal="9,5")).json
        self.assertEqual(alone["path"], point["path"])
        self.assertEqual([row["sx"] for row in self.rows("q.csv")], ["0", "0.5", "0.25", "3.5"])
        self.write("lines.json", "".join(json.dumps(answer) + "\n" for answer in (cells, centres, point, bad)))
        self.ended(self.run_program("verify", "lines.json"), 0)

    def test_metres(self):
        pixels = bytearray(b"\xfe" * 30 * 20)
        for y in range(4, 20):
            pixels[30 * y + 15] = 0
        self.write("m.pgm", b"P5\n30 20\n255\n" + bytes(pixels))
        for yaw in ("0", "0.7"):
            self.write("m.yaml", MAP.replace("YAW", yaw))
            turn = float(yaw)

            def world(x, y):  # of a point in cells, the origin at the lower left
                u, v = 0.05 * x, 0.05 * (20 - y)
                return -2.3 + u * math.cos(turn) - v * math.sin(turn), 1.7 + u * math.sin(turn) + v * math.cos(turn)

            start, goal = (tuple(round(c, 3) for c in world(*p)) for p in ((3.3, 12.7), (27.1, 15.2)))
            for more in ((), ("--algorithm", "mmas", "--iterations", "3", "--polish", "taut"), ("--radius", "0.06")):
                answer = self.quiet(self.plan("--json", "--frame", "world", "--spacing", "0.1", "-o", "p.yaml", *more,
                                              map_file="m.yaml", start=f"{start[0]},{start[1]}",
                                              goal=f"{goal[0]},{goal[1]}")).json
                self.assertEqual(answer["path_world"][0], list(start))
                self.assertEqual(answer["path_world"][-1], list(goal))
                self.assertEqual((answer["start_world"], answer["goal_world"]), (list(start), list(goal)))
                self.assertEqual(answer["poses_world"][0][:2], list(start))
                self.assertEqual((answer["start"], answer["goal"]), ([3, 12], [27, 15]))
                for cell, point in ((answer["path"][0], start), (answer["path"][-1], goal)):
                    self.assertLess(math.dist(world(*cell), point), 1e-12)
                self.replayed(answer)
            # The centre of a cell in metres is that cell.
            x, y = world(3.5, 12.5)
            cell = self.quiet(self.plan("--json", map_file="m.yaml", start="3,12", goal="27,15")).json
            metres = self.quiet(self.plan("--json", "--frame", "world", map_file="m.yaml", start=f"{x},{y}",
                                          goal=",".join(map(str, world(27.5, 15.5))))).json
            self.assertEqual(metres["path"], cell["path"])
            # As versions before had it: whole numbers, from centre to centre.
            old = dict(metres, start=[3, 12], goal=[27, 15])
            old.update(start_world=list(world(3.75, 12.25)), version="0.3.0")
            del old["path_world"]
            old["parameters"] = {key: value for key, value in old["parameters"].items() if key != "ends"}
            self.ended(self.replay_of(old), 0)

    def test_via_where_blocked_cells_meet(self):
        self.write("meet.map", "type octile\nheight 4\nwidth 4\nmap\n..@@\n..@@\n@@..\n@@..\n")
        for more in ((), ("--inflation", "2,1")):
            self.ended(self.plan("--via", "2.0,2.0", *more, goal="3,3", map_file="meet.map"), 5, "via point 1 lies between")
            self.ended(self.plan("--via", "2.0,2.0", *more, goal="0,1", map_file="meet.map"), 0)

    def test_via(self):
        whole = self.quiet(self.plan("--json", "--via", "9,0", "--via", "9.25,5")).json
        legs = [self.quiet(self.plan("--json", start=a, goal=b)).json
                for a, b in (("0,0", "9,0"), ("9.5,0.5", "9.25,5"), ("9.25,5", "9,5"))]
        self.assertEqual(whole["via"], [[9, 0], [9.25, 5.0]])
        self.assertEqual(whole["length"], sum(leg["length"] for leg in legs))
        self.assertEqual(whole["path"], [p for i, leg in enumerate(legs) for p in leg["path"][i > 0:]])
        self.assertEqual((whole["optimal"], whole["gap"], whole["lower_bound"]), (True, 0, whole["length"]))
        self.replayed(whole)
        colony = self.quiet(self.plan("--json", "--algorithm", "as", "--iterations", "3", "--via", "9,0", "--gap", "-o",
                                      "p.svg", "-o", "p.html", "--spacing", "1")).json
        self.assertEqual((colony["iterations"], colony["best"][:3], colony["grid_optimum"]), (6, [None] * 3, None))
        self.assertEqual(colony["best"][-1], colony["length"])
        self.assertGreaterEqual(colony["length"], colony["optimum"])
        self.assertIn([9.5, 0.5], colony["path"])
        self.replayed(colony)
        self.ended(self.plan("--via", "9,0", "--via", "3,2"), 4, "via point 2 (3, 2) is blocked; the nearest free cell")
        self.ended(self.plan("--via", "9.5,99"), 4, "via point 1 (9.5, 99) is outside the map")
        self.ended(self.plan("--via", "9,0", "--via", "4,2"), 5,
                   "via point 1 (9, 0) and via point 2 (4, 2) lie in different regions")
        self.ended(self.plan("--via", "9,0", goal="4,2"), 5, "via point 1 (9, 0) and goal (4, 2)")
        self.ended(self.plan("--via", "9,0", start="3,2"), 4, "start (3, 2) is blocked")
        self.refused(self.plan("--via", "9"), 2, "--via")
        self.write("q.tsv", "sx sy gx gy\n0 0 9 5\n0 5 0 0\n")
        first, second = self.quiet(self.run_program("batch", "small.map", "q.tsv", "--via", "9,0", "--via", "9.25,5")).lines
        self.assertEqual(first["path"], whole["path"])
        self.assertIn([9.25, 5], second["path"])

    def test_marks_stand_where_the_path_begins_and_ends(self):
        self.quiet(self.plan("-o", "p.svg", start="0.25,1e-1", goal="9,5.75"))
        lines = re.findall(r'style="([^"]*)" d="([^"]*)"', self.read("p.svg").decode())

        def last(style):
            numbers = [float(n) for n in re.findall(r"[\d.]+", [d for of, d in lines if style in of][-1])]
            return list(zip(numbers[::2], numbers[1::2]))

        path = last("stroke-width:3;")
        for colour, end in (("rgb(10%,60%,25%)", path[0]), ("rgb(90%,45%,5%)", path[-1])):
            for axis, at in zip(zip(*last(f"stroke:{colour}")), end):
                self.assertAlmostEqual((min(axis) + max(axis)) / 2, at, delta=0.01)

    def test_drives_and_tours_take_cells(self):
        cells = self.ended(self.run_program("drive", "small.map", "--start", "0,0", "--goal", "9,5", "--json"), 0).json
        points = self.ended(self.run_program("drive", "small.map", "--start", "0.25,0.5", "--goal", "9.75,5.5", "--json"), 0).json
        self.assertEqual(self.apart_from(points, "replans"), self.apart_from(cells, "replans"))


if __name__ == "__main__":
    unittest.main()
