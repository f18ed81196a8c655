"""Why a start or a goal is refused or not reached, and what would help: maps of a robot among them."""
import json
import math
import unittest

from program import ProgramTest

LEVELS = {".": 254, "#": 0, "?": 205}
# A wall with a door of three cells, and a closet whose door is unknown.
ROOMS = ["...........#........",
         "...........#........",
         "...........#....####",
         "................?...",
         "................?...",
         "................?...",
         "...........#....####",
         "...........#........",
         "...........#........"]


class Reasons(ProgramTest):
    def setUp(self):
        super().setUp()
        self.algorithm = "exact"
        self.ros(ROOMS)

    def ros(self, rows, resolution=0.1, origin="[-1, 2, 0]"):
        pixels = bytes(LEVELS[c] for row in rows for c in row)
        self.write("map.pgm", b"P5\n%d %d\n255\n" % (len(rows[0]), len(rows)) + pixels)
        self.write("map.yaml", f"image: map.pgm\nresolution: {resolution}\norigin: {origin}\n"
                   "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")

    def asked(self, *arguments, start="3,4", goal="13,4"):
        return self.plan(*arguments, map_file="map.yaml", start=start, goal=goal)

    def info(self, *arguments):
        return self.ended(self.run_program("info", "map.yaml", *arguments), 0)

    def test_info_takes_the_cells_that_hold_points(self):
        cells = self.info("--start", "3,4", "--goal", "13,4", "--json").json
        points = self.info("--start", "3.25,4.0", "--goal", "13.5,4.75", "--json").json
        for key in ("start", "goal", "joined", "widest_radius"):
            self.assertEqual(points[key], cells[key])

    def test_what_blocks_a_start(self):
        for arguments, start, by, text in (
                ([], "11,0", "obstacle", "start (11, 0) is blocked by an obstacle; the nearest"),
                ([], "16,4", "unknown", "is unknown, and blocked without --unknown-free; the nearest"),
                ([], "20,4", "outside", "is outside the map"),
                (["--radius", "1.2"], "15,4", "radius",
                 "is too near to an unknown cell, 0.5 cells away: the radius is 1.2 cells; the nearest"),
                (["--radius", "2.2", "--unknown-free"], "10,2", "radius",
                 "is too near to an obstacle, 0.5 cells away: the radius is 2.2 cells"),
                (["--radius", "1.2"], "4,0", "radius", "is too near to the edge of the map, 0.5 cells"),
                (["--radius", "0.12", "--frame", "world"], "0.55,2.45", "radius",
                 "goal 0.55,2.45 m, in cell (15, 4), is too near to an unknown cell, 0.05 m away: "
                 "the radius is 0.12 m; the nearest")):
            with self.subTest(start=start, arguments=arguments):
                goal = "-0.65,2.45" if "world" in arguments else "3,4"
                ends = {"start": start, "goal": goal}
                if by == "radius":  # a start would be led out
                    ends = {"start": goal, "goal": start}
                run = self.asked("--json", *arguments, **ends)
                self.ended(run, 4, text)
                self.assertEqual(run.json["blocked_by"], by)
                self.assertEqual("clearance" in run.json, by == "radius")
                self.write("r.json", run.out)
                self.assertEqual(self.run_program("verify", "r.json").code, 0)
        self.ended(self.plan(start="3,2"), 4, "start (3, 2) is blocked; the nearest")

    def test_a_cell_that_is_free_in_part(self):
        self.ended(self.asked("--radius", "1.5", start="1,4"), 0)
        self.algorithm = "as"
        self.ended(self.asked("--radius", "1.5", start="5,4", goal="1,4"), 0)
        run = self.asked("--json", "--radius", "1.6", start="5,4", goal="1,4")
        self.ended(run, 4, "is too near to the edge of the map, 1.5 cells away: the radius is 1.6 cells; the nearest "
                   "free cell is (2, 4)")
        self.assertEqual((run.json["blocked_by"], run.json["clearance"]), ("radius", 1.5))

    def test_metres_given_as_cells(self):
        self.ended(self.asked(start="-0.65,2.45"), 4, "start (-0.65, 2.45) is outside the map",
                   "taken as metres, with --frame world, it is in the free cell (3, 4)")
        self.ended(self.asked(start="a,2"), 2, "is not a cell X,Y", "or a point")
        self.ended(self.asked(start="0,2", goal="-1,2"), 4, "goal (-1, 2) is outside the map",
                   "taken as metres, with --frame world, it is in the free cell (0, 8)")
        self.write("q.tsv", "sx\tsy\tgx\tgy\na\t2\t0\t2\n")
        self.refused(self.run_program("batch", "map.yaml", "q.tsv"), 3, "metres with --frame world")

    def test_what_would_join_two_regions(self):
        self.ended(self.asked(goal="18,4"), 5, "different regions of free cells; with --unknown-free they are joined")
        self.assertNotIn("widest", self.asked(goal="18,4").err)
        run = self.asked("--json", "--radius", "1.6")
        self.ended(run, 5, "(for a disc of radius 1.6 cells)", "the widest radius that joins start and goal is 1.5 cells")
        self.assertEqual(run.json["widest_radius"], 1.5)
        self.algorithm = "as"
        of_cells = self.asked("--json", "--radius", "1.6")
        self.ended(of_cells, 5, "(by walks over cells, for a disc of radius 1.6 cells)", "the widest radius that joins start and goal is 1.5 cells")
        self.assertEqual(of_cells.json["widest_radius"], 1.5)
        self.algorithm = "exact"
        self.ended(self.asked("--radius", "0.16", "--frame", "world", start="-0.65,2.45", goal="0.35,2.45"), 5,
                   "start -0.65,2.45 m, in cell (3, 4), and goal 0.35,2.45 m, in cell (13, 4), lie in different",
                   "(for a disc of radius 0.16 m)", "the widest radius that joins start and goal is 0.15 m")
        closed = self.asked("--radius", "0.4", "--json", goal="18,4")
        self.ended(closed, 5, "no radius joins start and goal", "with --unknown-free they are joined")
        self.assertIsNone(closed.json["widest_radius"])
        self.write("q.tsv", "sx sy gx gy\n3 4 13 4\n3 4 18 4\n")
        for line, alone in zip(self.run_program("batch", "map.yaml", "q.tsv", "--radius", "1.6").lines,
                               (run, self.asked("--json", "--radius", "1.6", goal="18,4"))):
            self.assertEqual(line["error"], alone.json["error"])

    def test_an_end_too_near_in_a_region_that_is_not_reached(self):
        self.ros(["." * 20] * 4 + ["#" * 9 + ".." + "#" * 9] + ["." * 20] * 4)
        run = self.asked("--radius", "1.2", "--json", start="10,2", goal="3,8")
        self.ended(run, 4, "is too near to the edge of the map", "; the widest radius that joins start and goal is 0.5 cells")
        self.assertEqual(run.json["widest_radius"], 0.5)
        near = self.asked("--radius", "1.2", "--json", start="10,2", goal="3,3")  # its region is the start's
        self.ended(near, 4, "is too near to an obstacle")
        self.assertNotIn("widest_radius", near.json)

    def test_stops_and_tables_in_metres_given_as_cells(self):
        self.write("s.tsv", "x y\n-0.65 2.45\n3 4\n5 5\n")
        run = self.run_program("tour", "map.yaml", "--stops", "s.tsv")
        self.ended(run, 0, "stop 0 at (-0.65, 2.45) is outside the map; taken as metres, with --frame world, it is in the "
                   "free cell (3, 4): left out", "; proven shortest without what is left out")
        self.write("p.csv", "x,y\n-0.65,2.45\n0.35,2.45\n")
        self.assertIn("taken as metres, with --frame world", self.run_program("check-path", "map.yaml", "p.csv").out)
        judged = self.run_program("check-path", "map.yaml", "p.csv", "--json").json
        self.assertIn("taken as metres, with --frame world", judged["fault"]["why"])
        self.write("p.csv", "x,y\n1e15,2.45\n0.35,2.45\n")
        self.assertNotIn("taken as metres", self.run_program("check-path", "map.yaml", "p.csv").out)
        self.write("p.csv", "x_m,y_m\n-5,2.45\n0.35,2.45\n")
        self.assertNotIn("taken as metres", self.run_program("check-path", "map.yaml", "p.csv").out)
        self.write("p.csv", "x_m,y_m,robot\n0.25,2.45,0\n0.35,2.45,0\n0.35,2.45,1\n")
        self.refused(self.run_program("check-path", "map.yaml", "p.csv"), 3, "line 4: is of robot 1, the path of robot 0", "the rows of one")
        self.write("p.csv", "x,y,x\n1,2,3\n")
        self.refused(self.run_program("check-path", "map.yaml", "p.csv"), 3, "names x twice")
        self.write("p.csv", "x,y\n3.5,4.5\n4.5,4.5\n")
        self.write("q.tsv", "sx sy gx gy\n3 4 4 4\n")
        for words in (("check-path", "map.yaml", "p.csv"), ("batch", "map.yaml", "q.tsv"), ("info", "map.yaml")):
            self.ended(self.run_program(*words, "--radius", "0.3"), 0, "the radius is 0.3 cells, 0.03 m; with --frame world")
        self.write("cart.yaml", "type: differential\nfootprint: [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]\n")
        self.ended(self.asked("--vehicle", "cart.yaml", start="-0.65,2.45,0", goal="5,4,0"), 4, "out of the map",
                   "taken as metres, with --frame world, it is in the free cell (3, 4)")
        turned = self.asked("--vehicle", "cart.yaml", start="3,4,90", goal="6,4,90deg")
        self.ended(turned, 0, "--start: 90 radians are 14.32 turns; degrees end in deg")
        self.assertNotIn("--goal:", turned.err)
        self.ended(self.asked("--inflation", "0.5,3"), 0, "--inflation has no effect: its radius of 0.5 cells reaches no other cell; "
                   "with --frame world its radius is in metres")
        self.ended(self.run_program("drive", "map.yaml", "--start", "3,4", "--goal", "6,4", "--inflation", "0.5,3"), 0,
                   "--inflation has no effect: its radius of 0.5 cells reaches no other cell")
        for resolution in (0.042, 0.1, 0.104):  # r * (1 / r) is below 1 for some
            self.ros([".........."] * 6, resolution, "[0, 0, 0]")
            ends = f"{2.5 * resolution},{2.5 * resolution}", f"{7.5 * resolution},{2.5 * resolution}"
            run = self.asked("--frame", "world", "--inflation", f"{resolution},3", start=ends[0], goal=ends[1])
            self.assertNotIn("no effect", self.ended(run, 0).err)

    def test_inflation_in_metres_is_that_in_cells_and_is_replayed(self):
        self.ros([".........."] * 3 + [".....#...."] + [".........."] * 3, 0.1, "[0, 0, 0]")
        ends = {"start": "0.15,0.35", "goal": "0.95,0.35"}
        self.write("cart.yaml", "type: differential\nunits: cells\nfootprint: [[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3], [-0.3, 0.3]]\n")
        for more in ((), ("--vehicle", "cart.yaml")):
            yaw = ",0" if more else ""
            for command in ("plan", "drive"):
                with self.subTest(command=command, more=more):
                    def asked(inflation, frame, start, goal):
                        return self.ended(self.run_program(command, "map.yaml", "--start", start + yaw, "--goal", goal + yaw, *more, *frame,
                                                           "--inflation", inflation, "--json"), 0).json
                    metres = asked("0.2,5,9", ("--frame", "world"), **ends)
                    cells = asked("2,0.5,9", (), start="1.5,3.5", goal="9.5,3.5")
                    self.assertEqual(metres["parameters"]["inflation"], [2, 0.5, 9])
                    self.assertAlmostEqual(metres["cost"], cells["cost"], places=9)
                    self.write("r.json", json.dumps(metres))
                    self.quiet(self.run_program("verify", "-q", "r.json"))

    def test_the_widest_radius_passes_and_a_hair_more_does_not(self):
        for resolution in (0.1, 0.05, 0.07):
            self.ros(ROOMS, resolution)
            start, goal = ("%r,%r" % (-1 + (x + 0.5) * resolution, 2 + 4.5 * resolution) for x in (3, 13))
            found = self.info("--json", "--frame", "world", "--start", start, "--goal", goal).json
            self.assertTrue(found["joined"])
            for algorithm, key, hair in (("exact", "widest_radius", 1e-6), ("as", "widest_radius_grown", 1e-6)):
                self.algorithm = algorithm
                metres, cells = found[key + "_m"], found[key]
                for radius, code in ((metres, 0), (metres + hair, 5)):
                    run = self.asked("--frame", "world", "--radius", repr(radius), start=start, goal=goal)
                    self.assertEqual(run.code, code, (resolution, radius))
                for radius, code in ((cells, 0), (cells + hair, 5)):
                    self.assertEqual(self.asked("--radius", repr(radius)).code, code, (resolution, radius))

    def test_info_tells_metres_unknown_cells_and_the_widest_radius(self):
        known = self.info("--json").json
        self.assertEqual((known["unknown_cells"], known["unknown_share"]), (3, 3 / 180))
        self.assertEqual([round(m, 9) for m in known["extent_m"]], [2.0, 0.9])
        self.assertNotIn("joined", known)
        text = self.info("--frame", "world", "--radius", "0.12", "--start", "-0.65,2.45", "--goal", "0.35,2.45").out
        for words in ("20 x 9 cells, 2 x 0.9 m", "3 cells, 2%, counted as blocked", "yes, up to --radius 0.15 m for exact, for the others up to 0.15 m"):
            self.assertIn(words, text)
        self.assertIn("no, up to --radius 1.5 cells for exact, for the others up to 1.5 cells", self.info("--radius", "2", "--start", "3,4", "--goal", "13,4").out)
        self.assertIn("counted as free", self.info("--unknown-free").out)
        self.assertIn("joined      no\n", self.info("--start", "3,4", "--goal", "99,4").out)
        self.assertIsNone(self.run_program("info", "small.map", "--json").json["unknown_cells"])
        for arguments, says in ((["map.yaml", "--start", "3,4"], "together"),
                                (["small.map", "--frame", "world"], "gives no frame"),
                                (["w.wkt", "--start", "3,4", "--goal", "3,4"], "for bitmaps")):
            self.refused(self.run_program("info", *arguments), 2, says)


if __name__ == "__main__":
    unittest.main()
