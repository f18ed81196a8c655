"""tour: orders stops, names what it leaves out, refuses what is broken, and replays its results."""
import itertools
import json
import math
import random
import re
import unittest

from layers import pgm
from program import MAPS, ProgramTest

FREE = "type octile\nheight 20\nwidth 30\nmap\n" + ("." * 30 + "\n") * 20
ROS = "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n"
TSPLIB = "NAME: box\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 3 4\n3 3 0\n4 0 4\nEOF\n"


class Tour(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("free.map", FREE)
        # The corners of a rectangle, 12 by 5, out of their order.
        self.write("box.tsv", "x\ty\tname\n2\t2\ta\n14\t7\tb\n14\t2\tc\n2\t7\td\n")

    def tour(self, *arguments, stops="box.tsv", map_file="free.map"):
        return self.run_program("tour", map_file, "--stops", stops, *arguments)

    def check(self, result):
        """Each stop once or left out; the legs join, end in the stops, and add up."""
        stops, order, legs = result["stops"], result["order"], result["legs"]
        out = [one["stop"] for one in result["left_out"]]
        self.assertEqual(sorted(order + out), list(range(len(stops))))
        is_open = result["parameters"]["open"] or result["goal"] not in (None, result["start"])
        following = order[1:] if is_open else order[1:] + order[:1]
        self.assertEqual([(leg["from"], leg["to"]) for leg in legs], list(zip(order, following)) if order[1:] else [])
        for leg in legs:
            for end, stop in ((0, leg["from"]), (-1, leg["to"])):
                at = stops[stop]
                self.assertEqual(leg["path"][end], at if any(isinstance(c, float) for c in at) else [c + 0.5 for c in at])
            polyline = sum(map(math.dist, leg["path"], leg["path"][1:]))  # of a disc's curve a little longer
            self.assertAlmostEqual(leg["length"], polyline, places=2 if result["parameters"]["radius"] else 9)
        self.assertAlmostEqual(result["length"], sum(leg["length"] for leg in legs), places=9)
        self.assertLessEqual(result["lower_bound"], result.get("cost", result["length"]))
        return result

    def test_worked_by_hand(self):
        result = self.check(self.quiet(self.tour("--json")).json)
        self.assertEqual(list(result), [
            "format", "version", "map", "algorithm", "start", "goal", "seed", "threads", "parameters",
            "status", "error", "stops", "names", "order", "legs", "length", "lower_bound", "gap", "optimal",
            "left_out", "priced", "elapsed_ms"])
        self.assertEqual(result["format"], "lasius-tour/1")
        for ends, length in (([], 34), (["--open"], 22), (["--open", "--start", "14,7"], 22),
                             (["--start", "14,7"], 34), (["--goal", "2,2"], 22),
                             (["--start", "14,7", "--goal", "14,7"], 34),
                             (["--start", "2,2", "--goal", "14,7"], 5 + 13 + 5),
                             (["--start", "2,2", "--goal", "20,7"], 5 + 13 + 5 + 6)):  # one stop more
            with self.subTest(ends):
                result = self.check(self.tour(*ends, "--json").json)
                for end, place in (("--start", 0), ("--goal", -1)):
                    if end in ends and (end == "--start" or length != 34):
                        cell = [int(c) for c in ends[ends.index(end) + 1].split(",")]
                        self.assertEqual(result["stops"][result["order"][place]], cell)
                self.assertEqual(len(result["stops"]), 5 if "20,7" in ends else 4)
                self.assertAlmostEqual(result["length"], length, places=9)
                self.assertEqual((result["optimal"], result["status"]), (True, "solved"))
                self.assertLess(result["gap"], 1e-3)

    def test_legs_go_round_what_is_blocked(self):
        self.write("s.tsv", "x y\n0 0\n9 5\n9 0\n0 5\n")
        result = self.check(self.tour("--json", stops="s.tsv", map_file="small.map").json)
        for leg in result["legs"]:
            ends = ["{},{}".format(*result["stops"][leg[end]]) for end in ("from", "to")]
            plan = self.plan("--algorithm", "exact", "--json", start=ends[0], goal=ends[1]).json
            self.assertAlmostEqual(leg["length"], plan["length"], places=12)

    def test_points(self):
        self.write("p.tsv", "x y\n0.25 0\n9.75 5.5\n9 0\n0,5\n3.0 2.5\n")
        self.write("p.geojson", json.dumps({"type": "MultiPoint", "coordinates": [
            [0.25, 0], [9.75, 5.5], [9, 0], [0, 5], [3.0, 2.5]]}))
        for name in ("p.tsv", "p.geojson"):
            for more in ([], ["--radius", "0.25"]):
                with self.subTest((name, more)):
                    run = self.check(self.tour("--json", *more, "--start", "9.75,5.5", "--goal", "1.5,0.5", stops=name,
                                               map_file="small.map").json)
                    self.assertEqual(run["stops"], [[0.25, 0.0], [9.75, 5.5], [9, 0], [0, 5], [3.0, 2.5], [1.5, 0.5]])
                    self.assertEqual((run["start"], run["goal"], run["order"][0], run["order"][-1]), ([9.75, 5.5], [1.5, 0.5], 1, 5))
                    self.assertEqual([one["stop"] for one in run["left_out"]], [0, 4] if more else [])
                    self.ended(self.replay_of(run), 0)
        self.ended(self.tour("--start", "3.5,2.25", stops="p.tsv", map_file="small.map"), 4, "start (3.5, 2.25) is blocked")
        self.write("one.tsv", "0.25 1.75\n")
        self.assertEqual(self.ended(self.tour(stops="one.tsv"), 0).out, "solved\n0\n0.25 1.75\n")

    def test_one_stop(self):
        self.write("s.tsv", "3,4\n")
        run = self.tour("--json", stops="s.tsv").json
        self.assertEqual((run["order"], run["legs"], run["length"], run["optimal"]), ([0], [], 0, True))
        self.assertEqual(self.ended(self.tour(stops="s.tsv"), 0).out, "solved\n0\n3.5 4.5\n")

    def test_forms_of_stops(self):
        cells = [[2, 2], [14, 7], [14, 2]]

        def point(x, y):
            return {"type": "Point", "coordinates": [x, y]}
        features = [{"type": "Feature", "properties": None, "geometry": point(*cell)} for cell in cells[:1]]
        features.append({"type": "Feature", "properties": {}, "geometry": {
            "type": "GeometryCollection", "geometries": [{"type": "MultiPoint", "coordinates": cells[1:]}]}})
        for name, text in (("a.tsv", "name\ty\tx\na b\t2\t2\n\nc\t7\t14\r\nd\t2\t14"), ("b.txt", "2 2\n14 7\n14 2\n"),
                           ("c.csv", "x,y\n2.5,2.5\n14,7\n14.5,2.5\n"), ("d.json", json.dumps(cells)),
                           ("e.json", "[[2.5, 2.5], [14, 7], [14, 2]]"), ("f.geojson", json.dumps(point(2, 2))),
                           ("g.geojson", json.dumps({"type": "FeatureCollection", "features": features}))):
            with self.subTest(name):
                self.write(name, text)
                run = self.tour("--json", stops=name).json
                stops = run["stops"]
                if name in ("c.csv", "e.json"):  # a pair is a point as a whole
                    self.assertEqual([type(x) for x in stops[0] + stops[1]], [float] * 2 + [int] * 2)
                    stops = [[math.floor(x) for x in stop] for stop in stops]
                self.assertEqual(stops, cells[:1] if name == "f.geojson" else cells)

    def test_yaws_without_a_vehicle_are_told(self):
        feature = {"type": "Feature", "properties": {"yaw": 1}, "geometry": {"type": "Point", "coordinates": [2, 2]}}
        for name, text in (("a.tsv", "x y yaw\n2 2 90deg\n14 7 north\n"), ("b.json", '[{"x": 2, "y": 2, "yaw": 0.5}, [14, 7]]'),
                           ("c.geojson", json.dumps(feature))):
            self.write(name, text)
            run = self.ended(self.tour(stops=name), 0)
            self.assertIn(f"lasius: {name}: its yaws have no effect without --vehicle\n", run.err)
            self.quiet(self.tour("-q", stops=name))
        self.write("d.json", '[{"x": 2, "y": 2, "yaw": null}]')
        self.assertNotIn("yaw", self.tour(stops="d.json").err)

    def test_names_that_are_not_read_are_told(self):
        feature = {"type": "Feature", "properties": {"After": "b", "city": "x"}, "geometry": {"type": "Point", "coordinates": [2, 2]}}
        for name, text, words in (
                ("a.tsv", "x y After z\n2 2 b 0\n", 'not read: "After" (did you mean "after"?), "z"'),
                ("b.json", '[{"x": 2, "y": 2, "afer": "b", "yaw": 1}]', 'not read: "afer" (did you mean "after"?)'),
                ("c.geojson", json.dumps(feature), 'not read: "After" (did you mean "after"?)\n'),
                ("d.geojson", json.dumps(feature).replace("After", "LOAD"), 'not read: "LOAD" (did you mean "load"?)\n')):
            self.write(name, text)
            self.assertIn(f"lasius: {name}: {words}", self.ended(self.tour(stops=name), 0).err)
            self.quiet(self.tour("-q", stops=name))

    def test_a_table_of_commas_has_empty_fields_and_quotes(self):
        self.write("a.csv", 'name,x,y,after\n"d, e",2, 2,\n "b" ,14,7,"d, e,c"\nc,14,2,\n,,,\n')
        self.refused(self.tour(stops="a.csv"), 3, 'line 3: "after": no stop is named "d"')
        self.write("a.csv", 'name,x,y,after\n"my desk",2, 2,\n "b" ,14,7,"my desk,c"\nc,14,2,\n,,,\n')
        self.write("b.csv", "x,y\n2,2,\n14,7,,\n")  # as spreadsheets end lines
        self.assertEqual(self.tour("--json", stops="b.csv").json["stops"], [[2, 2], [14, 7]])
        run = self.check(self.tour("--json", stops="a.csv").json)
        self.assertEqual((run["names"], run["after"]), (["my desk", "b", "c"], [[], [0, 2], []]))
        self.write("a.csv", 'name,x,y,\n"a ""b"", c" ,2,2,\n5" bolt,14,7,\n')
        run = self.tour("--json", stops="a.csv")
        self.assertEqual((run.json["names"], run.err), (['a "b", c', '5" bolt'], ""))
        self.write("a.csv", "2,2,\n14,7,\n")
        self.quiet(self.tour("--json", stops="a.csv"))
        self.write("a.csv", "x,y\n2,2\n14 7\n")
        self.refused(self.tour(stops="a.csv"), 3, "line 3: 1 field, but the first line has 2; give every column a value")
        self.write("a.csv", 'name,x,y\n"b,2,2\n')
        self.refused(self.tour(stops="a.csv"), 3, "line 2: a quote is not closed")
        self.write("a.csv", "name,x,y\nb, c,2,2\n")
        self.refused(self.tour(stops="a.csv"), 3, "line 2: 4 fields, but the first line has 3; put quotes about")

    def test_broken_stops(self):
        for name, text, words in (
                ("a.tsv", "", ["line 1", "is empty"]), ("a.tsv", "x y\n", ["holds no stop"]),
                ("a.tsv", "x z\n1 2\n", ["line 1", "no column is named y"]),
                ("a.tsv", "x y x\n1 2 3\n", ["two columns are named x"]),
                ("a.tsv", "x y\n1 2\n1\n", ["line 3", "1 field, but the first line has 2"]),
                ("a.tsv", "x y\n1 2\n1 b\n", ["line 3", "y is 'b'", "finite number"]),
                ("a.tsv", "x y\n1 2\n1 nan\n", ["line 3", "y is 'nan'"]), ("a.tsv", "1\n", ["has no y"]),
                ("a.tsv", "1 2 0.5\n", ["line 1", "more than x y", "--vehicle"]),
                ("a.json", "[[1, 2],\n [3, 4, 0.5]]", ["line 2", "[1] is no [x, y]", "--vehicle"]),
                ("a.json", "[[1, 2],\n [3]]", ["line 2", "[1] is no [x, y]"]),
                ("a.json", "[[1, 2],\n3}", ["line 2: this is not JSON, in or behind stop 1"]), ("a.json", "[]", ["holds no stop"]),
                ("a.json", "[[1, 2],\n[3, 4]\n[5, 6]]", ["line 3: this is not JSON, in or behind stop 1"]),
                ("a.json", '[{"x": 1, "y": 2},\n{"x": 1}]', ["line 2", "[1] is no [x, y]"]),
                ("a.geojson", '{"type": "Feature",\n"geometry": {"type": "Polygon"}}', ["line 2", "a Polygon, no point"]),
                ("a.geojson", '{"type": "Feature"}', ["lacks its \"geometry\""]),
                ("a.geojson", '{"type": "Feature",\n"geometry": null}', ["line 2", "the stop has no place"]),
                ("a.json", '[{"x": 1, "y": 2, "load": 1000001}]', ["line 1", "of at most 1000000"]),
                ("a.geojson", '{"a": 1}', ["no GeoJSON object"])):
            with self.subTest(text):
                self.write(name, text)
                self.refused(self.tour(stops=name), 3, name, *words)
        self.refused(self.tour(stops="none.tsv"), 3, "none.tsv", "cannot be opened", ".geojson")

    def test_usage(self):
        for run, *words in (
                (self.run_program("tour", "free.map"), "--stops or --cover is required"),
                (self.tour("--capacity", "2"), "--capacity 2: no stop has a load"),
                (self.tour("--capacity", "-1"), "--capacity"),
                (self.tour("--algorithm", "exat"), "did you mean \"exact\"?"),
                (self.tour("--algorithm", "fan2004"), "fan2004 plans", "not over stops"),
                (self.tour("--algorithm", "mmas", "--set", "greedy=0.5"), "mmas has no parameter \"greedy\""),
                (self.tour("--set", "alpha=2"), "exact has no parameter \"alpha\"", "as"),
                (self.tour("--algorithm", "as", "--set", "local_search=lk"), "local_search is \"lk\"", "two-edges"),
                (self.tour("--goal-tolerance", "2"), "leaves out what it cannot reach"),
                (self.tour("--seed", "1-3"), "one tour has one seed"), (self.tour("--generations", "-1"), "--generations"),
                (self.tour("--start", "1"), "--start"), (self.tour("-o", "a.gif"), ".gif")):
            with self.subTest(words):
                self.refused(run, 2, *words)
        self.ended(self.tour("--gap"), 0, "--gap has no effect")
        self.ended(self.tour("--spacing", "2"), 0, "--spacing has no effect without --vehicle or -o FILE.yaml")

    def test_what_is_left_out(self):
        self.write("s.tsv", "x y\n0 0\n4 2\n40 1\n3 2\n9 5\n")
        run = self.tour(stops="s.tsv", map_file="small.map")
        self.ended(run, 0, "stop 1 at (4, 2) cannot be reached from the others: left out", "2 stops, ")
        result = self.check(self.tour("--json", stops="s.tsv", map_file="small.map").json)
        self.assertEqual(result["left_out"], [
            {"stop": 1, "why": "stop 1 at (4, 2) cannot be reached from the others"},
            {"stop": 2, "why": "stop 2 at (40, 1) is outside the map"},
            {"stop": 3, "why": "stop 3 at (3, 2) is blocked"}])
        # Where the tour begins decides of two regions.
        result = self.check(self.tour("--json", "--start", "4,2", stops="s.tsv", map_file="small.map").json)
        self.assertEqual(result["order"], [1])
        # A disc does not come into the corner.
        result = self.tour("--json", "--radius", "1", stops="s.tsv", map_file="small.map").json
        self.assertIn("radius", json.dumps(result["left_out"]) + json.dumps(result["error"]))

    def test_an_end_that_is_no_stop_is_not_left_out(self):
        self.write("s.tsv", "x y\n0 0\n9 5\n")
        for ends in (["--start", "3,2"], ["--goal", "30,2"], ["--start", "0,0", "--goal", "4,2"]):
            run = self.tour(*ends, stops="s.tsv", map_file="small.map")
            self.assertNotIn("left out", run.err)

    def test_an_order_given_in_part(self):
        """Against all orders: forms of stops, ends, loads; and replayed."""
        names, after, load = "abcdefg", {"b": "a", "d": "c, a", "g": "b,d"}, dict(zip("abcd", (1, -1, 1, -1)))
        cells = [[3 * i % 29, 7 * i % 19] for i in range(7)]
        rows = [(cell, name, after.get(name, ""), load.get(name, 0)) for cell, name in zip(cells, names)]
        self.write("p.tsv", "x\ty\tname\tafter\tload\n" + "".join(
            f"{x}\t{y}\t{name}\t{before}\t{load or ''}\n" for (x, y), name, before, load in rows))
        self.write("p.json", json.dumps([{"x": x, "y": y, "name": name, "after": before, "load": load}
                                         for (x, y), name, before, load in rows]))
        self.write("p.geojson", json.dumps({"type": "FeatureCollection", "features": [
            {"type": "Feature", "geometry": {"type": "Point", "coordinates": cell},
             "properties": {"name": name, "after": [one.strip() for one in before.split(",")] if before else None,
                            "load": load}} for cell, name, before, load in rows]}))

        def best(is_open, capacity, start=None):
            def length(order):
                done, carried = set(), 0
                for i in order:
                    carried += rows[i][3]
                    if carried > capacity or not {one.strip() for one in rows[i][2].split(",")} - {""} <= done:
                        return math.inf
                    done.add(names[i])
                ends = order[1:] if is_open else order[1:] + order[:1]
                return sum(math.dist(cells[a], cells[b]) for a, b in zip(order, ends))
            return min(length(order) for order in itertools.permutations(range(7)) if start in (None, order[0]))
        for options, *given in (([], False, 9), (["--open"], True, 9), (["--capacity", "1"], False, 1),
                                (["--capacity", "1", "--open", "--start", "15,16"], True, 1, 5)):
            answers = [self.check(self.tour("--json", *options, stops=name).json)
                       for name in ("p.tsv", "p.json", "p.geojson")]
            for answer in answers:
                self.assertEqual(answer["after"], [[], [0], [], [2, 0], [], [], [1, 3]])
                self.assertEqual((answer["names"], answer["loads"]), (list(names), [1, -1, 1, -1, 0, 0, 0]))
                self.assertAlmostEqual(answer["length"], best(*given), places=9)
                self.assertTrue(answer["optimal"])
            self.ended(self.replay_of(answers[0]), 0)
        for stops, words in (("x\ty\tname\tafter\n1\t2\ta\tc\n3\t4\tb\ta\n5\t6\tc\tb\n",
                              ["line 2", "\"after\" is a circle: a before b before c before a"]),
                             ("x\ty\tname\tafter\n1\t2\ta\ta\n", ["line 2", "circle: a before a"]),
                             ("x\ty\tname\tafter\n1\t2\talpha\t\n3\t4\tb\talpa\n",
                              ["line 3", "no stop is named \"alpa\"", "did you mean \"alpha\"?"]),
                             ("x\ty\tafter\n1\t2\ta\n", ["no stop is named", "give each stop its name"]),
                             ("x\ty\tname\tafter\n1\t2\ta\t\n3\t4\ta\ta\n", ["stops 0 and 1 are both named \"a\""]),
                             ("x y name after\n1 2 a\n", ["3 fields", "split columns at tabs"]),
                             ("x y load\n1 2 0.5\n", ["line 2", "load is '0.5'", "whole number"]),
                             ('[{"x": 1, "y": 2, "load": "much"}]', ["load is '\"much\"'"]),
                             ('[{"x": 1, "y": 2, "after": [[]]}]', ["\"after\" is []", "list of names"])):
            self.write("q.txt", stops)
            self.refused(self.tour(stops="q.txt"), 3, "q.txt", *words)
        self.ended(self.tour("--start", "3,7", stops="p.tsv"), 5, "stop 1 is the start, but stop 0 comes before it")
        self.write("q.tsv", "x y load\n1 2 2\n3 4 2\n5 6 0\n")
        run = self.ended(self.tour("--capacity", "3", "--json", stops="q.tsv"), 5, "no order keeps the capacity of 3")
        self.assertEqual((run.json["status"], run.json["order"]), ("unreachable", None))

    def test_ends_that_are_none(self):
        for ends, code, *words in (
                (["--start", "3,2"], 4, "invalid", "start (3, 2) is blocked", "nearest free cell"),
                (["--start", "0,0", "--goal", "3,2"], 4, "invalid", "goal (3, 2) is blocked", "nearest free cell"),
                (["--goal", "30,2"], 4, "invalid", "goal (30, 2) is outside"),
                (["--start", "0,0", "--goal", "4,2"], 5, "unreachable", "goal (4, 2) cannot be reached")):
            with self.subTest(ends):
                self.write("s.tsv", "x y\n0 0\n9 5\n")
                run = self.ended(self.tour(*ends, "--json", stops="s.tsv", map_file="small.map"), code, *words[1:])
                result = run.json
                self.assertEqual((result["status"], result["order"], result["legs"], result["length"]),
                                 (words[0], None, None, None))
        self.write("s.tsv", "x y\n3 2\n")
        self.ended(self.tour(stops="s.tsv", map_file="small.map"), 4, "no stop is free")

    def many(self):
        cells = [[7 * i % 29, (5 * i + i // 20) % 19] for i in range(70)]
        return self.write("many.json", json.dumps(cells))

    def test_the_same_on_any_threads_and_replayed(self):
        stops = self.many()
        answers = []
        for threads in (1, 2, 5):
            result = self.check(self.tour("--json", "--threads", threads, "--generations", "2", stops=stops).json)
            self.assertEqual(result.pop("threads"), threads)
            del result["elapsed_ms"]
            answers.append(result)
        self.assertEqual(answers, answers[:1] * 3)
        self.assertLess(answers[0]["gap"], 0.1)
        result = {**answers[0], "threads": 1, "elapsed_ms": 0}
        self.ended(self.replay_of(result), 0)
        result["length"] += 1
        self.ended(self.replay_of(result), 1, "length")
        for wrong, words in (({"stops": []}, "no list of stops"), ({"stops": [["a", 0]]}, "\"stops\""),
                             ({"start": "a"}, "\"start\"")):
            self.ended(self.replay_of({**result, **wrong}), 3, words)
        other = self.tour("--json", "--start", "20,3", "--goal", "21,3", "--radius", "0.4").json
        self.ended(self.replay_of(other), 0)

    def test_costs(self):
        self.write("dear.pgm", pgm([[200 if 8 <= x < 12 and y < 15 else 0 for x in range(30)] for y in range(20)]))
        over = ("--cost", "dear.pgm*0.05", "--inflation", "3,1,5")
        run = self.check(self.quiet(self.tour("--json", *over)).json)
        self.assertEqual(list(run)[-3:], ["priced", "layers", "elapsed_ms"])
        self.assertEqual(run["layers"][0]["factor"], 0.05)
        self.assertAlmostEqual(run["cost"], sum(leg["cost"] for leg in run["legs"]), places=9)
        self.assertGreater(run["cost"], run["length"])
        self.assertLessEqual(run["lower_bound"], run["cost"])
        self.assertAlmostEqual(run["gap"], (run["cost"] - run["lower_bound"]) / run["lower_bound"], places=9)
        cost = {}
        for a, b in itertools.combinations(range(4), 2):
            plan = self.run_program("plan", "free.map", "--start", "{},{}".format(*run["stops"][a]), "--goal",
                                    "{},{}".format(*run["stops"][b]), "--json", *over).json
            cost[a, b] = cost[b, a] = plan["cost"]
        best = min(sum(cost[p[i - 1], p[i]] for i in range(4)) for p in itertools.permutations(range(4)))
        self.assertLessEqual(run["lower_bound"], best + 1e-9)
        self.assertLessEqual(run["cost"], 1.003 * best)
        self.ended(self.replay_of(run), 0)
        self.ended(self.tour(*over), 0, "4 stops, 6 legs priced; cost ", "no order is below")
        self.write("box.tsp", TSPLIB)
        self.refused(self.run_program("tour", "box.tsp", "--cost", "dear.pgm"), 2, "--cost is for maps")

    def test_ants(self):
        stops = self.many()
        best = self.tour("--json", stops=stops).json["length"]
        self.write("pairs.tsv", "x\ty\tname\tafter\n" + "".join(
            f"{i}\t{7 * i % 19}\t{i}\t{i - 1 if i % 2 else ''}\n" for i in range(16)))
        for family in ("as", "eas", "ras", "mmas", "acs", "has-sop", "eacs"):
            with self.subTest(family):
                plainly = ("--set", "local_search=none") if family in ("has-sop", "eacs") else ()
                ask = ("--algorithm", family, "--iterations", "20", "--json")
                plain = self.check(self.quiet(self.tour(*ask, *plainly, stops=stops)).json)
                self.assertEqual((plain["algorithm"], plain["parameters"]["iterations"], plain["iterations"]), (family, 20, 20))
                self.assertEqual((len(plain["best"]), plain["parameters"]["local_search"]), (20, "none"))
                self.assertAlmostEqual(plain["best"][-1], plain["length"], delta=0.1)  # thousandths of a cell a leg
                self.assertEqual(plain["best"], sorted(plain["best"], reverse=True))
                self.ended(self.replay_of(plain), 0)
                better = self.check(self.tour(*ask, "--ants", "10", "--set", "local_search=three-edges", "--threads", "2",
                                              stops=stops).json)
                self.assertLess(better["length"], 1.02 * best)
                self.assertLess(better["length"], plain["length"])
                self.ended(self.replay_of({**better, "threads": 1}), 0)
                given = self.check(self.tour(*ask, "--open", "--start", "0,0", stops="pairs.tsv").json)
                place = {stop: i for i, stop in enumerate(given["order"])}
                self.assertTrue(all(place[i] < place[i + 1] for i in range(0, 16, 2)))
                pieces = self.check(self.tour(*ask, "--set", "local_search=pieces", "--open", "--start", "0,0",
                                              stops="pairs.tsv").json)
                self.assertLessEqual(pieces["length"], given["length"])
                self.ended(self.replay_of(pieces), 0)
                self.write("box.tsp", TSPLIB)
                box = self.run_program("tour", "box.tsp", *ask).json
                self.assertEqual((box["length"], box["lower_bound"], box["algorithm"]), (14, 14, family))
                self.ended(self.replay_of(box), 0)
        run = self.tour("--algorithm", "as", "--iterations", "0", "--json")
        self.ended(run, 6, "no ant has come to all stops")
        self.ended(self.tour("--ants", "3"), 0, "--ants has no effect: exact has no such parameter")

    def test_limits(self):
        stops = self.many()
        run = self.tour("--json", "--time-limit", "0", stops=stops)
        self.assertEqual((run.code, self.check_status(run.json)), (0, "limit"))
        near = self.tour("--json", "--target-gap", "40", stops=stops).json
        self.assertEqual(near["status"], "solved")
        self.assertLessEqual(near["gap"], 0.4)

    def test_many_stops_are_in_a_short_order_from_the_first_on(self):
        """A shortest tour of places drawn in a square is 0.7124 sqrt(n area) long or a little more."""
        side, count = 300, 4500
        self.write("open.map", f"type octile\nheight {side}\nwidth {side}\nmap\n" + ("." * side + "\n") * side)
        cells = random.Random(1).sample(range(side * side), count)
        self.write("many.tsv", "x y\n" + "".join(f"{c % side} {c // side}\n" for c in cells))
        run = self.run_program("tour", "open.map", "--stops", "many.tsv", "--time-limit", "0", "--json")
        self.assertEqual((run.code, run.json["status"]), (0, "limit"))
        self.assertLess(run.json["length"], 1.3 * 0.7124 * math.sqrt(count) * side)

    def check_status(self, result):
        self.assertEqual(sorted(result["order"]), list(range(70)))
        return result["status"]

    def test_metres(self):
        self.write("world.pgm", b"P5\n10 8\n255\n" + b"\xfe" * 80)
        self.write("world.yaml", ROS)
        self.write("m.tsv", "x y\n-0.8 -1.8\n3.2 1.2\n")
        result = self.tour("--frame", "world", "--json", stops="m.tsv", map_file="world.yaml").json
        self.assertEqual(result["stops"], [[0, 7], [8, 1]])
        self.assertEqual(result["stops_world"], [[-0.8, -1.8], [3.2, 1.2]])
        self.assertAlmostEqual(result["length"], 20, places=9)
        self.assertAlmostEqual(result["length_m"], 10, places=9)
        self.assertEqual(result["legs"][0]["path_world"], [[-0.8, -1.8], [3.2, 1.2]])
        self.assertEqual(result["parameters"]["ends"], "points")
        self.ended(self.replay_of(result), 0)
        ends = self.tour("--frame", "world", "--json", "--start=-0.8,-1.8", "--goal", "0.1,-0.2", "--radius", "0.1",
                         "-o", "w.csv", stops="m.tsv", map_file="world.yaml").json
        self.assertEqual((ends["start_world"], ends["goal_world"], len(ends["stops"])), ([-0.8, -1.8], [0.1, -0.2], 3))
        self.assertEqual((self.rows("w.csv")[0], self.rows("w.csv")[-1]),
                         ({"x_m": "-0.8", "y_m": "-1.8"}, {"x_m": "0.1", "y_m": "-0.2"}))
        self.ended(self.replay_of(ends), 0)
        self.ended(self.tour("--frame", "world", stops="m.tsv", map_file="world.yaml"), 0, "proven shortest")

    def test_files(self):
        told = self.ended(self.tour("-o", "a.json", "-o", "a.csv", "-o", "a.svg", "-o", "a.png"), 0)
        result = json.loads(self.read("a.json"))
        self.check(result)
        self.assertIn("lasius: in the order " + ", ".join(result["names"][i] for i in result["order"]) + "\n", told.err)
        self.assertEqual(len(self.rows("a.csv")), 5)
        self.assertEqual(list(self.rows("a.csv")[0]), ["x", "y"])
        self.assertGreater(min(self.png_size("a.png")), 200)
        self.tour("-o", "ants.svg", "--algorithm", "mmas", "--iterations", "2")
        self.holds(self.words("ants.svg"), "tour, mmas on free.map")
        self.holds(self.words("a.svg"), "tour of 4 stops, length 34.00 cells, proven shortest", "stop, by its name")
        self.assertEqual(self.labels("a.svg"), ["a", "b", "c", "d"])
        self.write("s.tsv", "x y\n0 0\n3 2\n9 5\n")
        self.tour("-o", "b.svg", "--start", "0,0", stops="s.tsv", map_file="small.map")
        self.holds(self.words("b.svg"), "1 stop left out", "start", "stop, by its number")
        self.assertEqual(self.labels("b.svg"), ["0", "2"])  # as the JSON counts them
        self.assertNotIn("goal", self.words("b.svg"))

    def labels(self, picture):
        """What stands beside the stops."""
        return sorted(re.search("y, cells (.*) tour of", self.words(picture))[1].split())

    def test_tsplib(self):
        self.write("box.tsp", TSPLIB)
        run = self.run_program("tour", "box.tsp", "--json", "-o", "box.csv")
        result = self.quiet(run).json
        self.assertEqual((result["length"], result["optimal"], result["stops"][1]), (14, True, [3, 4]))
        self.assertNotIn("legs", result)
        self.assertEqual([int(row["stop"]) for row in self.rows("box.csv")], result["order"])
        self.ended(self.replay_of(result), 0)
        self.assertEqual(self.run_program("tour", "box.tsp", "--open", "--json").json["length"], 10)
        self.assertEqual(self.run_program("tour", "box.tsp").out.split()[:2], ["solved", "14"])
        self.write("box.tsp", TSPLIB.replace("3 4", "3 5"))
        self.ended(self.replay_of(result), 3, "has hash")
        self.write("bad.tsp", TSPLIB.replace("3 3 0", "3 3 x"))
        self.refused(self.run_program("tour", "bad.tsp"), 3, "bad.tsp", "line 8")
        self.refused(self.run_program("tour", "none.tsp"), 3, "cannot be opened")
        self.write("a.sop", "TYPE: SOP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
                   "EDGE_WEIGHT_SECTION\n2\n0 5\n-1 0\nEOF\n")
        run = self.run_program("tour", "a.sop", "--json")
        self.assertEqual((run.json["order"], run.json["length"], run.json["optimal"]), ([0, 1], 5, True))
        self.assertEqual(run.json["stops"], [])
        self.ended(self.replay_of(run.json), 0)
        # Of more than twelve places no bound is told: up by steps of 1, 13 before 2.
        rows = [[-1 if b < a and (a == 14 or b == 0) or (a, b) == (1, 12) else abs(a - b) for b in range(15)]
                for a in range(15)]
        self.write("b.sop", "TYPE: SOP\nDIMENSION: 15\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
                   "EDGE_WEIGHT_SECTION\n15\n" + "".join(" ".join(map(str, row)) + "\n" for row in rows))
        result = self.run_program("tour", "b.sop", "--json").json
        self.assertEqual((result["length"], result["lower_bound"], result["gap"], result["optimal"]),
                         (12 + 11 + 13, None, None, False))
        self.assertLess(result["order"].index(12), result["order"].index(1))
        self.ended(self.replay_of(result), 0)
        self.refused(self.run_program("tour", "box.tsp", "--stops", "box.tsv"), 2, "--stops is for maps")
        self.refused(self.run_program("tour", "box.tsp", "-o", "a.png"), 2, "pictures, poses and pages are of tours on maps")

    def test_on_a_map_of_ours(self):
        self.write("s.tsv", "0 0\n29 29\n29 0\n15 15\n0 29\n")
        self.check(self.tour("--json", stops="s.tsv", map_file=MAPS + "/grid30a.map").json)


if __name__ == "__main__":
    unittest.main()
