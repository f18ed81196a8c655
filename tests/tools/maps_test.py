"""info, algorithms, generate, and the world frame of ROS maps."""
import json
import math
import os
import unittest

from program import MAPS, ProgramTest


class Info(ProgramTest):
    def test_what_is_known_of_a_map(self):
        run = self.quiet(self.run_program("info", "small.map", "--json"))
        info = run.json
        self.assertEqual((info["width"], info["height"], info["free_cells"]), (10, 6, 44))
        self.assertAlmostEqual(info["free_share"], 44 / 60)
        self.assertEqual((info["connectivity"], info["components"]), (4, 3))
        self.assertIsNone(info["frame"])
        self.assertGreater(info["memory"]["total"], 0)
        self.assertGreaterEqual(info["prepare_ms"], 0)
        self.assertEqual(info["hash"], self.plan("--json").json["map"]["hash"])

    def test_for_people(self):
        run = self.ended(self.run_program("info", "small.map"), 0)
        for word in ("10 x 6 cells", "44 cells, 73%", "3 (4-connected)", "bits a cell"):
            self.assertIn(word, run.out)

    def test_a_missing_map(self):
        self.refused(self.run_program("info", "missing.map"), 3, "missing.map")


class Editors(ProgramTest):
    """What editors and other systems make of files that people write."""
    MARK = b"\xef\xbb\xbf"
    WORLD = ('{"type": "FeatureCollection", "features": [{"properties": {"role": "boundary"}, '
             '"geometry": {"type": "Polygon", "coordinates": '
             '[[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}}]}')

    def test_a_byte_order_mark_is_stepped_over(self):
        self.write("marked.map", self.MARK + self.read("small.map"))
        self.write("marked.pgm", self.MARK + b"P2\n2 1\n255\n255 255\n")
        self.write("marked.yaml", self.MARK + b"image: marked.pgm\nresolution: 1\n"
                   b"origin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        self.write("marked.geojson", self.MARK + self.WORLD.encode())
        self.write("marked.wkt", self.MARK + b"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))")
        for name in ("marked.map", "marked.pgm", "marked.yaml", "marked.geojson", "marked.wkt"):
            with self.subTest(name=name):
                run = self.ended(self.run_program("info", name), 0)
        for name, queries in (("q.scen", b"version 1\n0 m 10 6 0 0 9 5 1\n"),
                              ("q.tsv", b"sx\tsy\tgx\tgy\n0\t0\t9\t5\n")):
            with self.subTest(name=name):
                self.write(name, self.MARK + queries)
                run = self.run_program("batch", "marked.map", name, "--iterations", "2")
                self.assertEqual(run.code, 0, run.err)
                self.assertEqual(run.lines[0]["goal"], [9, 5])
        self.write("bare.map", self.MARK)
        self.refused(self.run_program("info", "bare.map"), 3, "is empty")

    def test_endings_may_be_in_capitals(self):
        self.write("MAP.PGM", b"P2\n2 1\n255\n255 255\n")
        self.write("MAP.YML", "image: MAP.PGM\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        self.write("WORLD.GeoJSON", self.WORLD)
        for name in ("MAP.YML", "WORLD.GeoJSON"):
            with self.subTest(name=name):
                self.ended(self.run_program("info", name), 0)
        run = self.plan("-o", "A.JSON", "-o", "A.CSV", "-o", "A.SVG", "-o", "A.Png", "--json")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(self.read("A.JSON").decode(), run.out)
        self.assertTrue(self.read("A.CSV").startswith(b"iteration,"))
        self.assertTrue(self.read("A.SVG").startswith(b"<?xml"))
        self.png_size("A.Png")
        self.ended(self.run_program("generate", "open", "--size", "4x4", "-o", "OPEN.MAP"), 0)
        self.assertTrue(self.read("OPEN.MAP").startswith(b"type octile"))


class Algorithms(ProgramTest):
    def test_machine_readable(self):
        listing = self.run_program("algorithms", "--json").json
        names = [entry["name"] for entry in listing["algorithms"]]
        self.assertIn("fan2004", names)
        self.assertIn("as", names)
        for entry in listing["algorithms"]:
            self.assertTrue(entry["summary"] and entry["source"])
            for parameter in entry["parameters"]:
                with self.subTest(algorithm=entry["name"], parameter=parameter["name"]):
                    self.assertIn(parameter["type"], ("integer", "number", "choice"))
                    if parameter["type"] == "choice":
                        self.assertIn(parameter["default"], parameter["values"])
                    else:
                        self.assertLessEqual(parameter["minimum"], parameter["default"])
                        self.assertLessEqual(parameter["default"], parameter["maximum"])

    def test_every_listed_parameter_can_be_set_and_is_recorded(self):
        for entry in self.run_program("algorithms", "--json").json["algorithms"]:
            defaults = {p["name"]: p["default"] for p in entry["parameters"]}
            settings = [word for name, value in defaults.items() if name != "iterations"
                        for word in ("--set", f"{name}={value}")]
            result = self.plan("--json", "--algorithm", entry["name"], *settings).json
            self.assertEqual({name: result["parameters"][name] for name in defaults}, defaults)

    def test_every_listed_neighbourhood_is_taken(self):
        for entry in self.run_program("algorithms", "--json").json["algorithms"]:
            for parameter in entry["parameters"]:
                if parameter["name"] != "neighbours":
                    continue
                for value in parameter["values"]:
                    with self.subTest(algorithm=entry["name"], value=value):
                        run = self.plan("--algorithm", entry["name"], "--neighbours", value,
                                        "--iterations", "1")
                        self.assertNotEqual(run.code, 2, run.err)

    def test_bounds_are_the_ones_that_hold(self):
        seen = set()  # colonies share their parameters: each is tried with the first that has it
        for entry in self.run_program("algorithms", "--json").json["algorithms"]:
            for parameter in entry["parameters"]:
                of_its_own = entry["name"] if entry["name"] in ("exact", "grid-ga", "acs") else ""
                bound = (of_its_own, parameter["name"], str(parameter.get("maximum", parameter.get("values"))))
                if bound in seen:
                    continue
                seen.add(bound)
                if parameter["type"] == "integer":
                    beyond = parameter["maximum"] + 1
                elif parameter["type"] == "number":
                    beyond = parameter["maximum"] * 2
                else:
                    beyond = "nonsense"
                with self.subTest(parameter=parameter["name"]):
                    run = self.plan("--algorithm", entry["name"], "--set",
                                    f"{parameter['name']}={beyond}")
                    self.refused(run, 2, parameter["name"])

    def test_for_people(self):
        out = self.run_program("algorithms").out
        for word in ("fan2004:", "persistence=0.7", "[0 .. 1]", "forbid|one-side|allow"):
            self.assertIn(word, out)

    def test_one_alone(self):
        out = self.run_program("algorithms", "cong2009").out
        self.assertTrue(out.startswith("cong2009: "), out)
        self.assertIn("small maps", out)
        self.assertNotIn("fan2004", out)
        listed = self.run_program("algorithms", "as", "--json").json
        self.assertEqual([entry["name"] for entry in listed["algorithms"]], ["as"])
        self.refused(self.run_program("algorithms", "cong209"), 2, 'did you mean "cong2009"?')


class Generate(ProgramTest):
    def test_equal_bits_from_equal_seeds_in_every_format(self):
        hashes = {}
        for name in ("a.map", "b.pbm", "c.png"):
            run = self.run_program("generate", "blobs", "--size", "70x40", "--seed", "3", "-o", name)
            self.assertEqual((run.code, run.out, run.err), (0, "", ""))
            hashes[name] = self.run_program("info", name, "--json").json["hash"]
        self.assertEqual(len(set(hashes.values())), 1, hashes)
        self.run_program("generate", "blobs", "--size", "70x40", "--seed", "4", "-o", "d.map")
        self.assertNotEqual(self.run_program("info", "d.map", "--json").json["hash"],
                            hashes["a.map"])

    def test_every_kind(self):
        for kind in ("blobs", "maze", "rooms", "city", "random", "open"):
            run = self.run_program("generate", kind, "--size", "33x21", "-o", f"{kind}.map")
            self.assertEqual(run.code, 0, run.err)
            info = self.run_program("info", f"{kind}.map", "--json").json
            self.assertEqual((info["width"], info["height"]), (33, 21))
            self.assertGreater(info["free_cells"], 0)

    def test_an_output_that_cannot_be_written(self):
        self.refused(self.run_program("generate", "open", "--size", "8x8", "-o", "no/m.map"), 7)


class WorldFrame(ProgramTest):
    # 8 x 4 cells of 0.5 m whose lower left corner lies at (-1, 2), turned by 30 degrees.
    YAW = math.pi / 6

    def setUp(self):
        super().setUp()
        self.write("world.pgm", b"P5\n8 4\n255\n" + b"\xfe" * 8 + b"\xfe" * 3 + b"\x00" * 2 +
                   b"\xfe" * 3 + b"\xfe" * 3 + b"\x00" * 2 + b"\xcd" * 3 + b"\xfe" * 8)
        self.write("world.yaml", "image: world.pgm\nresolution: 0.5\n"
                   f"origin: [-1.0, 2.0, {self.YAW!r}]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")

    def metres(self, x, y):
        east, north = 0.5 * x, 0.5 * (4 - y)
        c, s = math.cos(self.YAW), math.sin(self.YAW)
        return -1 + c * east - s * north, 2 + s * east + c * north

    def world(self, *arguments, start=(0.2, 0.3), goal=(7.7, 0.6)):
        points = ["%.12f,%.12f" % self.metres(*point) for point in (start, goal)]
        return self.plan("--frame", "world", *arguments, map_file="world.yaml", start=points[0],
                         goal=points[1])

    def test_metres_in_and_out(self):
        run = self.ended(self.world("--json", goal=(7.7, 3.6)), 0)
        result = run.json
        self.assertEqual((result["start"], result["goal"]), ([0, 0], [7, 3]))
        self.assertEqual(result["parameters"]["frame"], "world")
        self.assertAlmostEqual(result["length_m"], 0.5 * result["length"], places=12)
        self.assertEqual(len(result["path_world"]), len(result["path"]))
        for cell, world in zip(result["path"], result["path_world"]):
            for got, expected in zip(world, self.metres(*cell)):
                self.assertAlmostEqual(got, expected, places=9)

    def test_plain_output_is_in_metres(self):
        result = self.world("--json").json
        lines = self.world().out.splitlines()
        self.assertEqual(float(lines[1]), result["length_m"])
        self.assertEqual([[float(n) for n in line.split()] for line in lines[2:]],
                         result["path_world"])

    def test_tables_are_in_metres(self):
        self.algorithm = "exact"
        result = self.world("--json", "--gap", "-o", "path.csv", goal=(7.7, 3.6)).json
        rows = [row.split(",") for row in self.read("path.csv").decode().splitlines()]
        self.assertEqual(rows[0], ["x_m", "y_m"])
        self.assertEqual([[float(n) for n in row] for row in rows[1:]], result["path_world"])
        self.assertIn("optimum %.6f m" % result["length_m"],
                      self.world("--gap", goal=(7.7, 3.6)).err)
        self.algorithm = "as"
        run = self.world("--json", "-o", "run.csv", "--iterations", "2", "--progress", "always")
        rows = [row.split(",") for row in self.read("run.csv").decode().splitlines()]
        self.assertEqual(rows[0], ["iteration", "best_m", "mean_m", "arrived"])
        self.assertEqual([float(row[1]) for row in rows[1:]], [n / 2 for n in run.json["best"]])
        self.assertEqual([float(row[2]) for row in rows[1:]], [n / 2 for n in run.json["mean"]])
        self.assertIn("best %.3f m" % run.json["length_m"], run.err)
        self.world("-o", "metres.svg", "--iterations", "2")
        self.plan("-o", "cells.svg", "--iterations", "2", map_file="world.yaml", goal="7,0")
        self.assertNotEqual(self.read("metres.svg"), self.read("cells.svg"))  # "length in ..."

    def test_tables_of_a_batch_are_in_metres(self):
        start, goal = self.metres(0.5, 0.5), self.metres(7.5, 0.5)
        self.write("q.tsv", "sx\tsy\tgx\tgy\n%r\t%r\t%r\t%r\n" % (*start, *goal))
        self.algorithm = "exact"
        run = self.run_program("batch", "world.yaml", "q.tsv", "--frame", "world", "-o", "all.csv")
        head, row = [row.split(",") for row in self.read("all.csv").decode().splitlines()]
        self.assertEqual(head, ["index", "sx_m", "sy_m", "gx_m", "gy_m", "status", "length_m",
                                "lower_bound_m", "gap", "iterations", "elapsed_ms",
                                "seed", "optimum_m", "optimum_gap"])
        self.assertEqual([float(n) for n in row[1:5]], [*start, *goal])
        self.assertEqual([float(n) for n in row[6:9]], [3.5, 3.5, 0])
        self.assertEqual(len(run.lines[0]["path_world"]), len(run.lines[0]["path"]))

    def test_the_cell_frame_has_no_metres(self):
        result = self.plan("--json", map_file="world.yaml", start="0,0", goal="7,0").json
        self.assertNotIn("path_world", result)
        self.assertNotIn("length_m", result)

    def test_outside_is_named_in_both_frames(self):
        self.ended(self.world(goal=(9.5, 0.5)), 4, "(7, 0)", "%.3f" % self.metres(7.5, 0.5)[0],
                   "goal %.12f,%.12f m, in cell (9, 0), is outside" % self.metres(9.5, 0.5))

    def test_cells_far_outside_are_told_as_they_are(self):
        self.write("flat.yaml", "image: world.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        for goal, cell in (("99999999999,1", (199999999998, 1)), ("1,-3e9", (2, 6000000003)),
                           ("1e308,1", (1.7976931348623157e308, 1))):
            run = self.plan("--frame", "world", "--json", map_file="flat.yaml", start="0,0",
                            goal=goal)
            self.assertEqual((run.code, tuple(run.json["goal"])), (4, cell))
            self.assertIn("in cell (", run.json["error"])
            self.assertNotIn("2147483647", run.json["error"])
            self.write("far.json", run.out)
            self.assertEqual(self.run_program("verify", "far.json").code, 0)

    def test_metres_of_many_digits_are_told_whole(self):
        self.write("flat.yaml", "image: world.pgm\nresolution: 1e299\norigin: [1.25e300, -1e300, 0]\n"
                   "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        run = self.plan("--frame", "world", map_file="flat.yaml", start="0,0", goal="1e300,1")
        self.assertEqual(run.code, 4)
        self.assertRegex(run.err, r"its centre at 1\.\d+e\+300,-\d\.\d+e\+299 m$")

    def test_a_map_holds_its_left_and_lower_edge(self):
        self.write("flat.yaml", "image: world.pgm\nresolution: 0.5\norigin: [-3, 4, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")

        def flat(start):
            return self.plan("--frame", "world", "--json", map_file="flat.yaml", start=start,
                             goal="-2.75,4.25")

        for start, cell in (("-3,4", [0, 3]), ("-3,4.5", [0, 2]), ("-2.5,4", [1, 3]),
                            ("0.999,5.999", [7, 0])):
            with self.subTest(start=start):
                result = flat(start).json
                self.assertEqual((result["status"], result["start"]), ("solved", cell))
                self.assertEqual(result["path_world"][0], result["start_world"])
                self.assertEqual(result["start_world"], [float(n) for n in start.split(",")])
        for start in ("-3,6", "1,4"):  # the map's border is a place to be
            self.assertEqual(flat(start).code, 0)
        for start in ("-3.001,4", "-3,3.999", "1e300,4"):
            with self.subTest(start=start):
                self.assertEqual(flat(start).code, 4)

    def test_unknown_cells(self):
        self.assertEqual(self.world(goal=(6.5, 2.5)).code, 4)
        self.assertEqual(self.world("--unknown-free", goal=(6.5, 2.5)).code, 0)

    def test_a_radius_is_in_metres(self):
        blocked = self.world("--json", "--radius", "0.3").json
        self.assertEqual(blocked["parameters"]["radius"], 0.6)
        self.assertEqual(blocked["status"], "invalid")

    def test_batch_tables_are_in_metres_and_scenarios_in_cells(self):
        start, goal = self.metres(0.5, 0.5), self.metres(7.5, 0.5)
        self.write("q.tsv", "sx\tsy\tgx\tgy\n%r\t%r\t%r\t%r\n" % (*start, *goal))
        self.write("q.scen", "version 1\n0 m 8 4 0 0 7 0 7\n")
        for name in ("q.tsv", "q.scen"):
            run = self.ended(self.run_program("batch", "world.yaml", name, "--frame", "world"), 0)
            self.assertEqual((run.lines[0]["start"], run.lines[0]["goal"]), ([0, 0], [7, 0]))
            self.assertAlmostEqual(run.lines[0]["length_m"], 3.5)

    def test_verify_replays_it(self):
        self.world("-o", "r.json", "--unknown-free", goal=(6.5, 2.5))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        self.world("-o", "r.json", goal=(9.123, 0.5))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        result = json.loads(self.read("r.json"))
        self.ended(self.replay_of({**result, "start_world": self.metres(1.5, 0.5)}), 1, "'start'")


if __name__ == "__main__":
    unittest.main()
