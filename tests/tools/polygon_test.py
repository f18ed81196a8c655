"""plan, info, verify and algorithms on polygon worlds."""
import json
import math
import unittest

from program import ProgramTest

WORLD = {
    "boundary": [[0, 0], [200, 0], [200, 200], [0, 200]],
    "obstacle": [[[40, 140], [60, 160], [100, 140], [60, 120]],
                 [[50, 30], [30, 40], [80, 80], [100, 40]],
                 [[120, 160], [140, 100], [180, 170], [165, 180]],
                 [[120, 40], [170, 40], [140, 80]]],
}
OPTIMUM = 168.371941370


def feature(role, kind, coordinates):
    return {"type": "Feature", "properties": {"role": role},
            "geometry": {"type": kind, "coordinates": coordinates}}


def collection(start=(20, 180), goal=(160, 90), margin=0, obstacles=None):
    features = [feature("boundary", "Polygon", [WORLD["boundary"] + [WORLD["boundary"][0]]])]
    for ring in WORLD["obstacle"] if obstacles is None else obstacles:
        features.append(feature("obstacle", "Polygon", [ring + [ring[0]]]))
    if start:
        features.append(feature("start", "Point", list(start)))
    if goal:
        features.append(feature("goal", "Point", list(goal)))
    return json.dumps({"type": "FeatureCollection", "margin": margin, "features": features})


class WorldTest(ProgramTest):
    algorithm = "exact"

    def setUp(self):
        super().setUp()
        self.write("world.geojson", collection())

    def plan_world(self, *arguments, world="world.geojson"):
        return self.run_program("plan", world, *arguments)


class PolygonTest(WorldTest):
    def test_shortest_path(self):
        run = self.quiet(self.plan_world())
        lines = run.out.splitlines()
        self.assertEqual(lines[0], "solved")
        self.assertAlmostEqual(float(lines[1]), OPTIMUM, places=8)
        self.assertEqual(lines[2:], ["20 180", "100 140", "140 100", "160 90"])

    def test_every_algorithm_prints_the_contract(self):
        keys = ["format", "version", "map", "algorithm", "start", "goal", "seed", "threads",
                "parameters", "status", "error", "length", "path", "iterations", "best", "mean",
                "arrived", "lower_bound", "gap", "optimal", "optimum", "optimum_gap", "maklink",
                "note", "elapsed_ms"]
        for algorithm in ("exact", "maklink-acs", "real-ga"):
            with self.subTest(algorithm=algorithm):
                run = self.quiet(self.plan_world("--algorithm", algorithm, "--json"))
                result = run.json
                asked = self.plan_world("--algorithm", algorithm, "--json", "--gap").json
                self.assertEqual(asked["optimum"], result["optimum"])
                self.assertIsNone(result["note"])
                self.assertEqual(list(result), keys)
                self.assertEqual(result["format"], "lasius-plan/1")
                self.assertEqual(result["map"]["width"], 200)
                self.assertEqual((result["start"], result["goal"]), ([20, 180], [160, 90]))
                length = sum(math.dist(a, b) for a, b in zip(result["path"], result["path"][1:]))
                self.assertAlmostEqual(result["length"], length, places=9)
                self.assertAlmostEqual(result["lower_bound"], OPTIMUM, places=8)
                self.assertAlmostEqual(result["optimum"], OPTIMUM, places=8)
                self.assertAlmostEqual(result["gap"], result["length"] / OPTIMUM - 1, places=8)
                self.assertEqual(result["optimal"], result["gap"] == 0)
                self.assertGreaterEqual(result["optimum_gap"], 0)
                self.assertEqual(len(result["best"]), result["iterations"])

    def test_maklink_part(self):
        result = self.plan_world("--algorithm", "maklink-acs", "--json").json["maklink"]
        self.assertEqual(len(result["crossed"]), len(result["values"]))
        self.assertAlmostEqual(result["discrete_optimum"], OPTIMUM, places=8)
        self.assertAlmostEqual(result["sequence_optimum"], OPTIMUM, places=8)
        self.assertGreater(result["dijkstra_length"], OPTIMUM)

    def test_options_override_the_world(self):
        run = self.plan_world("--start", "1.5,2.25", "--goal", "150,10.5", "--margin", "4",
                              "--join", "mitre", "--boundary", "keep", "--json")
        self.assertEqual(run.code, 0)
        self.assertEqual(run.json["start"], [1.5, 2.25])
        self.assertEqual(run.json["parameters"]["margin"], 4)
        self.assertEqual(run.json["parameters"]["join"], "mitre")
        self.assertEqual(run.json["parameters"]["boundary"], "keep")
        grown = self.plan_world("--margin", "2", "--json").json
        self.assertEqual(grown["parameters"]["join"], "round")
        self.assertEqual(grown["parameters"]["boundary"], "shrink")
        self.assertGreater(grown["length"], OPTIMUM)

    def test_the_world_s_margin_counts(self):
        self.write("wide.geojson", collection(margin=2))
        self.assertEqual(self.plan_world("--json", world="wide.geojson").json["length"],
                         self.plan_world("--margin", "2", "--json").json["length"])

    def test_wkt(self):
        text = "".join(f"POLYGON (({', '.join(f'{x} {y}' for x, y in ring + [ring[0]])}))\n"
                       for ring in [WORLD["boundary"]] + WORLD["obstacle"])
        self.write("world.wkt", text + "POINT (20 180)\n")
        self.refused(self.plan_world(world="world.wkt"), 2, "WKT: the second POINT")
        self.write("world.wkt", text + "POINT (20 180)\nPOINT (160 90)\n")
        run = self.plan_world("--json", world="world.wkt")
        self.assertAlmostEqual(run.json["length"], OPTIMUM, places=8)
        self.assertEqual(run.json["map"]["hash"], self.plan_world("--json").json["map"]["hash"])

    def test_an_empty_geometry_swallows_nothing(self):
        box = "POLYGON ((0 0, 20 0, 20 12, 0 12, 0 0))"
        ends = "POINT (1 6) POINT (19 6)"
        block = "POLYGON ((8 2, 12 2, 12 10, 8 10, 8 2))"
        for text in (f"{box} POLYGON EMPTY {block} {ends}", f"{box} GEOMETRYCOLLECTION EMPTY;{block}\n{ends}"):
            self.write("it.wkt", text)
            run = self.quiet(self.plan_world(world="it.wkt"))
            self.assertAlmostEqual(float(run.out.splitlines()[1]), 2 * math.hypot(7, 4) + 4, places=9)
        self.write("it.wkt", f"{box}\nPOLYGON EMPTY, {block} {ends}")
        self.refused(self.plan_world(world="it.wkt"), 3,
                     'line 2, byte 53: geometry 2: "," stands where the name of a geometry must stand')

    def test_walls_are_told_drawn_and_replayed(self):
        self.write("it.wkt", "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0)) LINESTRING (10 0, 10 6) POINT (1 1) POINT (19 1)")
        run = self.quiet(self.plan_world("--algorithm", "maklink-acs", "-o", "it.json", "-o", "it.svg", "-o", "it.html",
                                         world="it.wkt"))
        self.assertAlmostEqual(json.loads(self.read("it.json"))["optimum"], 2 * math.hypot(9, 5), places=12)
        self.assertIn('"walls":[[[10', self.read("it.html").decode().replace(".0", ""))
        self.quiet(self.run_program("verify", "it.json"))
        self.assertIn("obstacles   0 with 0 corners, 1 wall, 0 grown and merged",
                      self.quiet(self.run_program("info", "it.wkt")).out)
        self.assertEqual(self.run_program("info", "it.wkt", "--json").json["walls"], 1)

    def test_degrees_are_told(self):
        degrees = collection().replace('"margin"', '"crs": {"type": "name", "properties": {"name": "EPSG:4326"}}, "margin"')
        self.write("it.geojson", degrees)
        self.write("it.wkt", "SRID=4326;POLYGON ((0 0, 200 0, 200 200, 0 0)) POINT (2 1) POINT (9 1)")
        self.write("it.tsv", "sx\tsy\tgx\tgy\n2\t1\t9\t1\n")
        for command in ("plan", "info", "batch"):
            for world in ("it.geojson", "it.wkt"):
                run = self.run_program(command, world, *(["it.tsv"] if command == "batch" else []))
                self.assertEqual(run.code, 0)
                self.assertIn(f"{world}: the coordinates are degrees", run.err)

    def test_usage(self):
        self.write("open.geojson", collection(start=None))
        cases = [
            (["--algorithm", "maklink-asc"], "did you mean \"maklink-acs\"?"),
            (["--algorithm", "fan2004"], "fan2004 plans on bitmaps, not among polygons"),
            (["--algorithm", "goritov2020"], "lasius arm"),
            (["--set", "seed=2"], "an option, --seed"),
            (["--set", "beta=1"], "exact has no parameter"),
            (["--algorithm", "real-ga", "--set", "population"], "NAME=VALUE"),
            (["--algorithm", "real-ga", "--set", "populatoin=3"], "did you mean \"population\"?"),
            (["--algorithm", "maklink-acs", "--ants", "0"], "1 .. 1000000"),
            (["--join", "miter"], "did you mean \"mitre\"?"),
            (["--boundary", "shrnk"], "did you mean \"shrink\"?"),
            (["--margin", "-1"], "--margin"),
            (["--start", "1"], "--start"),
            (["--radius", "1"], "--margin"),
            (["--via", "1,9", "-q"], "--via is for bitmaps, and world.geojson is a polygon world; leave it out"),
            (["--alternatives", "2"], "--alternatives is for bitmaps"),
            (["--spacing", "1"], "--spacing is for bitmaps"),
            (["--frame", "world"], "--frame world: world.geojson gives no frame"),
            (["--frame", "wrold"], "did you mean \"world\"?"),
            (["--margin", "1e308"], "--margin"),
            (["--ants", "abc"], "ants is abc"),
            (["--algorithm", "maklink-acs", "--polish", "strait"], "straight"),
            (["-o", "x.jpg"], "-o x.jpg"),
            (["--algorithm", "real-ga", "--preset", "book"], "real-ga has none; see lasius algorithms"),
        ]
        for arguments, part in cases:
            with self.subTest(arguments=arguments):
                run = self.plan_world(*arguments)
                self.assertEqual((run.code, run.out), (2, ""))
                self.assertIn(part, run.err)
        self.write("q.tsv", "sx sy gx gy\n20 180 160 90\n")
        for option in (["--via", "1,9"], ["--alternatives", "2"], ["--spacing", "1"]):
            self.refused(self.run_program("batch", "world.geojson", "q.tsv", *option, "-q"), 2, option[0] + " is for bitmaps")
        self.ended(self.plan_world(world="open.geojson"), 2, "--start is required")
        run = self.plan("--algorithm", "maklink-acs")
        self.refused(run, 2, "maklink-acs plans among polygons")
        self.ended(self.plan(map_file="small.map", start="0,0", goal="1,1"), 0)
        self.write("q.tsv", "sx sy gx gy\n0 0 1 1\n")
        for option in (["--margin", "1"], ["--join", "round"], ["--boundary", "keep"], ["--repair"]):
            for command in (["plan", "small.map", "--start", "0,0", "--goal", "1,1"],
                            ["batch", "small.map", "q.tsv"]):
                self.refused(self.run_program(*command, *option), 2, "polygon worlds")

    def test_options_without_effect_are_named(self):
        run = self.plan_world("--ants", "3", "--polish", "taut", "--unknown-free", "--frame", "cell")
        self.assertEqual(run.code, 0)
        for part in ("--frame has no effect", "--ants has no effect", "--polish has no effect", "--unknown-free"):
            self.assertIn(part, run.err)
        self.assertEqual(self.plan_world("--ants", "3", "-q").err, "")

    def test_broken_worlds(self):
        bow = [[10, 10], [30, 30], [30, 10], [10, 30]]
        cases = [
            ("missing.geojson", None, "cannot be opened"),
            ("a.geojson", "{\"type\":\n x", "line 2"),
            ("large.geojson", "{\"type\":\n\n 1e999}", "line 3, byte 15: a number"),
            ("role.geojson", "{\"type\": \"FeatureCollection\", \"features\": [\n{},\n{}]}",
             "line 2: feature 0: has no role"),
            ("b.geojson", "{}", "FeatureCollection"),
            ("c.geojson", collection(obstacles=[bow]), "feature 1 (obstacle): Self-intersection"),
            ("d.wkt", "POLYGON ((0 0, 1 1", "byte 0"),
        ]
        for name, text, part in cases:
            with self.subTest(name=name):
                if text is not None:
                    self.write(name, text)
                for command in ("plan", "info"):
                    run = self.run_program(command, name)
                    self.assertEqual((run.code, run.out), (3, ""))
                    self.assertIn(name, run.err)
                    self.assertIn(part, run.err)
        self.assertEqual(self.plan_world("--repair", world="c.geojson").code, 0)
        self.write("far.wkt", "POLYGON ((0 0, 1e300 0, 9 9, 0 0))")
        for arguments in ([], ["--repair"]):
            self.refused(self.plan_world(*arguments, world="far.wkt"), 3,
                         "at (1e+300, 0), which is no number within 1e12; correct the ring\n")

    def test_points_far_away(self):
        for far, near in (("1e12,100", "200, 100"), ("-1e12,5", "0, 5"), ("1e12,1e12", "200, 200"),
                          ("100,1e15", "100, 200"), ("100,-1e300", "100, 0"),
                          ("1e300,-1e300", "200, 0")):
            with self.subTest(far=far):
                self.ended(self.plan_world("--start", "1,1", f"--goal={far}", world=self.empty()),
                           4, f"the nearest free point is ({near})")

    def empty(self):
        return self.write("empty.wkt", "POLYGON ((0 0, 200 0, 200 200, 0 200, 0 0))")

    def test_blocked_outside_unreachable(self):
        run = self.ended(self.plan_world("--start", "60,140", "--json"), 4)
        self.assertEqual(run.json["status"], "invalid")
        self.assertIn("nearest free point is (50, 150)", run.json["error"])
        self.assertIsNone(run.json["path"])
        self.assertEqual(self.plan_world("--goal", "300,1").code, 4)
        wall = [[100, -1], [101, -1], [101, 201], [100, 201]]
        self.write("wall.geojson", collection(obstacles=[wall]))
        for algorithm in ("exact", "maklink-acs", "real-ga"):
            run = self.plan_world("--json", "--algorithm", algorithm, world="wall.geojson")
            self.assertEqual((run.code, run.json["status"]), (5, "unreachable"))

    def test_no_space_is_free(self):
        self.write("full.geojson", collection(obstacles=[WORLD["boundary"]]))
        for world, margin, says in (("full.geojson", [], "blocked; no space is free"),
                                    ("world.geojson", ["--margin", "120"],
                                     "nearer to what is blocked than the margin of 120; no space is free")):
            run = self.ended(self.plan_world(*margin, "--json", world=world), 4)
            self.assertEqual(run.json["status"], "invalid")
            self.assertIn(says, run.json["error"])
            run = self.ended(self.run_program("info", world, *margin, "--json"), 0)
            self.assertEqual((run.json["components"], run.json["regions"]), (0, 0))
            self.write("q.tsv", "sx\tsy\tgx\tgy\n1\t1\t2\t2\n3\t3\t4\t4\n")
            run = self.run_program("batch", world, "q.tsv", *margin)
            self.assertEqual((run.code, [line["status"] for line in run.lines]), (0, 2 * ["invalid"]))

    def test_a_goal_that_cannot_be_reached(self):
        shelf = [[[30, 30], [70, 30], [70, 40], [30, 40]], [[30, 60], [70, 60], [70, 70], [30, 70]],
                 [[30, 30], [40, 30], [40, 70], [30, 70]], [[60, 30], [70, 30], [70, 70], [60, 70]]]
        self.write("shelf.geojson", collection((10, 50), (50, 50), obstacles=shelf))
        shelf = ["--json", "-o", "r.json", "--goal-tolerance"]
        run = self.plan_world(*shelf, "25", world="shelf.geojson")
        self.assertEqual((run.code, run.json["goal"], run.json["goal_reached"], run.json["length"]),
                         (0, [50, 50], [30, 50], 20))
        self.assertEqual(run.json["parameters"]["goal_tolerance"], 25)
        self.quiet(self.run_program("verify", "r.json"))
        self.ended(self.plan_world("--goal-tolerance", "25", world="shelf.geojson"), 0,
                   "the path ends at (30, 50), 20 from the goal, which cannot be reached")
        run = self.plan_world(*shelf, "19", world="shelf.geojson")
        self.assertEqual((run.code, run.json["goal_reached"]), (5, None))
        self.assertIn("the nearest point that can be reached, (30, 50), is 20 from the goal",
                      run.json["error"])
        self.quiet(self.run_program("verify", "r.json"))
        self.write("q.tsv", "sx\tsy\tgx\tgy\n10\t50\t50\t50\n10\t50\t65\t50\n")
        lines = self.run_program("batch", "shelf.geojson", "q.tsv", "--goal-tolerance", "21").lines
        self.assertEqual([(line["status"], line["goal_reached"]) for line in lines],
                         [("solved", [30, 50]), ("solved", [70, 50])])
        self.assertNotIn("goal_reached", self.plan_world("--json").json)

    def test_time_limit(self):
        run = self.plan_world("--algorithm", "maklink-acs", "--time-limit", "0", "--json")
        self.assertEqual((run.code, run.json["status"]), (0, "limit"))
        self.assertEqual(run.json["length"], run.json["maklink"]["dijkstra_length"])
        self.assertEqual(self.plan_world("--time-limit", "0").code, 6)

    def test_outputs(self):
        for algorithm in ("exact", "maklink-acs"):
            self.ended(self.plan_world("--algorithm", algorithm, "-o", "o.json", "-o", "o.csv",
                                       "-o", "o.svg", "-o", "o.png"), 0)
            head = self.read("o.csv").decode().splitlines()[0]
            self.assertEqual(head, "x,y" if algorithm == "exact" else "iteration,best,mean,arrived")
            text = self.words("o.svg")
            self.holds(text, "start", "goal", "obstacle", "outside", "path, length",
                       "x, the world's units", "y, the world's units")
            for words in ("MAKLINK line", "its midpoint", "Dijkstra's path over midpoints",
                          "best path so far", "mean tour of the ants", "optimum of its own crossings"):
                self.assertEqual(words in text, algorithm != "exact", words)
            self.assertEqual(self.read("o.png")[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.plan_world("-o", "no/such/o.json").code, 7)

    def test_verify(self):
        for arguments in ([], ["--algorithm", "maklink-acs", "--set", "values=7"],
                          ["--algorithm", "real-ga", "--iterations", "40", "--gap"],
                          ["--algorithm", "maklink-acs", "--set", "routes=3", "--margin", "1.5",
                           "--join", "bevel", "--seed", "9007199254740991"],
                          ["--margin", "1", "--boundary", "keep", "--join", "chords"],
                          ["--margin", "1", "--algorithm", "maklink-acs"],
                          ["--start", "60,140"]):
            with self.subTest(arguments=arguments):
                self.plan_world("--json", "-o", "r.json", *arguments)
                self.quiet(self.run_program("verify", "r.json", "--threads", "2"))
        result = json.loads(self.read("r.json"))
        result["start"] = [61, 140]
        self.write("r.json", json.dumps(result))
        self.assertEqual(self.run_program("verify", "r.json").code, 1)
        self.write("world.geojson", collection(margin=1))
        self.ended(self.run_program("verify", "r.json"), 3, "hash")

    def test_a_bitmaps_preparation_has_no_effect(self):
        self.ended(self.plan_world("--prepare"), 0, "--prepare has no effect")
        self.refused(self.run_program("info", "world.geojson", "--prepare"), 2, "--prepare")
        self.refused(self.run_program("info", "world.geojson", "--radius", "1"), 2, "--margin")
        self.refused(self.run_program("info", "world.geojson", "--corners", "alow"), 2, "allow")

    def test_info_and_algorithms(self):
        run = self.ended(self.run_program("info", "world.geojson", "--json"), 0)
        self.assertEqual((run.json["obstacles"], run.json["corners"], run.json["components"]),
                         (4, 15, 1))
        self.assertIn("maklink", self.run_program("info", "world.geojson").out)
        listed = self.run_program("algorithms", "--json").json["polygon_algorithms"]
        names = [algorithm["name"] for algorithm in listed]
        self.assertEqual(names, ["exact", "maklink-acs", "real-ga"])
        self.assertIn("maklink-acs", self.run_program("algorithms").out)
        acs = listed[names.index("maklink-acs")]
        self.assertEqual([bool(algorithm["formulas"]) for algorithm in listed],
                         [False, True, False])
        self.assertIn("(1.1 - |h - h*|) / 1.1", acs["formulas"][0])
        values = {p["name"]: p["default"] for p in acs["parameters"]}
        self.assertEqual([values[n] for n in ("ants", "iterations", "values", "beta", "greedy",
                                              "persistence", "initial_pheromone")],
                         [10, 400, 21, 2, 0.5, 0.9, 0])

    def test_a_mitre_that_closes_a_passage_is_told(self):
        spikes = [[[98, 0], [102, 0], [100, 96]], [[98, 200], [100, 104], [102, 200]]]
        self.write("spikes.geojson", collection(margin=2, obstacles=spikes))
        self.assertEqual(self.plan_world(world="spikes.geojson").code, 0)
        run = self.ended(self.plan_world("--join", "mitre", "--json", world="spikes.geojson"), 5)
        self.assertIn("round joins start and goal are joined", run.json["note"])
        self.assertIn(run.json["note"], run.err)
        self.assertNotIn("note", self.plan_world("--join", "mitre", "-q", world="spikes.geojson").err)

    def test_values_ask_for_iterations(self):
        for arguments, iterations in ((["--set", "values=41"], 800), (["--set", "values=7"], 200),
                                      (["--iterations", "30", "--set", "values=41"], 30)):
            run = self.plan_world("--algorithm", "maklink-acs", "--json", *arguments)
            self.assertEqual(run.json["parameters"]["iterations"], iterations)


class PolygonBatch(WorldTest):
    QUERIES = "name\tsx\tsy\tgx\tgy\na\t20\t180\t160\t90\nb\t1.5\t2.25\t150\t10.5\n" \
              "blocked\t60\t140\t1\t1\noutside\t1\t1\t1e300\t0\nstay\t5\t5\t5\t5\n"

    def batch(self, *arguments, world="world.geojson", queries=None):
        self.write("q.tsv", self.QUERIES if queries is None else queries)
        return self.run_program("batch", world, "q.tsv", *arguments)

    def test_each_query_is_what_plan_gives(self):
        self.write("open.geojson", collection(start=None, goal=None, margin=1.5))
        for arguments in (["--algorithm", "maklink-acs", "--seed", "7", "--threads", "2"], [],
                          ["--algorithm", "real-ga", "--iterations", "3", "--gap", "--time-limit", "60"],
                          ["--algorithm", "real-ga", "--gap", "--time-limit", "0"]):
            cut = "0" in arguments
            run = self.batch(*arguments, world="open.geojson")
            if cut:
                self.ended(run, 0, "the time limit ended 2 of 5 answers")
            else:
                self.quiet(run)
            lines = run.lines
            self.assertEqual([line["index"] for line in lines], [0, 1, 2, 3, 4])
            self.assertEqual([line["status"] for line in lines],
                             [*2 * ["limit" if cut else "solved"], "invalid", "invalid", "solved"])
            self.assertEqual([line["optimum"] is None for line in lines], [cut, cut, True, True, False])
            for line in lines:
                self.assertIsNone(line["note"])
                start, goal = ([f"{v!r}" for v in line[end]] for end in ("start", "goal"))
                one = self.plan_world("--json", "--start", ",".join(start), "--goal", ",".join(goal),
                                      *arguments, world="open.geojson").json
                for result in (one, line):
                    for key in ("elapsed_ms", "threads", "index"):
                        result.pop(key, None)
                self.assertEqual(line, one)

    def test_outputs_and_verify(self):
        run = self.batch("--algorithm", "maklink-acs", "-o", "b.json", "-o", "b.csv", "-o", "b.svg")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(self.read("b.json").decode(), run.out)
        rows = self.read("b.csv").decode().splitlines()
        self.assertEqual(rows[0], "index,sx,sy,gx,gy,status,length,lower_bound,gap,iterations,elapsed_ms,"
                                  "seed,optimum,optimum_gap")
        self.assertTrue(rows[2].startswith("1,1.5,2.25,150,10.5,solved,"))
        self.assertIn(b"<svg", self.read("b.svg")[:2000])
        run = self.run_program("verify", "b.json")
        self.assertEqual((run.code, run.out), (0, "5 of 5 results are equal to the replay\n"))

    def test_a_range_of_seeds_gives_what_each_of_them_gives(self):
        options = ("--algorithm", "real-ga", "--iterations", "3")
        run = self.batch(*options, "--seed", "5-6", "-o", "b.json", "-o", "b.csv")
        self.assertEqual([(q["index"], q["seed"]) for q in run.lines],
                         [(i, s) for i in range(5) for s in (5, 6)])
        rows = [row.split(",") for row in self.read("b.csv").decode().splitlines()]
        self.assertEqual([row[rows[0].index("seed")] for row in rows[1:]], ["5", "6"] * 5)
        self.assertEqual(self.run_program("verify", "b.json").code, 0)
        of_plan = self.plan_world(*options, "--seed", "5-6").lines  # the world's own start and goal
        self.assertEqual([q["length"] for q in of_plan], [q["length"] for q in run.lines[:2]])
        self.assertNotEqual(of_plan[0]["length"], of_plan[1]["length"])
        self.write("open.geojson", collection(start=None))
        self.refused(self.plan_world("--seed", "5-6", world="open.geojson"), 2, "--start is required")

    def test_a_signal_ends_it_after_whole_lines(self):
        self.write("q.tsv", "sx sy gx gy\n" + "20 180 160 90\n" * 100000)
        process = self.start_program("batch", "world.geojson", "q.tsv", "--algorithm", "maklink-acs", "--threads", "2",
                                     bufsize=0)  # else what is read ahead is lost
        out = process.stdout.readline() + self.interrupted(process)[0]
        self.assertTrue(out.endswith(b"\n"))
        lines = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([line["index"] for line in lines], list(range(len(lines))))
        self.assertLess(len(lines), 100000)
        self.assertEqual(lines[0]["status"], "solved")

    def test_broken_queries_print_nothing(self):
        for queries, word in (("", "empty"), ("sx sy gx\n", "line 1"), ("sx sy gx gy\n1 1 2 x\n", "line 2"),
                              ("sx sy gx gy\n1 1 2 inf\n", "line 2"), ("version 1\n", "scenario")):
            self.refused(self.batch(queries=queries), 3, "q.tsv", word)
        self.refused(self.run_program("batch", "missing.geojson", "q.tsv"), 3, "missing.geojson")
        self.refused(self.run_program("batch", "world.geojson", "missing.tsv"), 3, "missing.tsv")
        self.refused(self.batch("--frame", "world"), 2, "--frame world")
        self.refused(self.batch("--radius", "1"), 2, "--margin")


if __name__ == "__main__":
    unittest.main()
