"""tour of groups, of which one stop is visited, and of several robots."""
import itertools
import json
import math
import unittest

from program import ProgramTest

FREE = "type octile\nheight 20\nwidth 30\nmap\n" + ("." * 30 + "\n") * 20
ROS = "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n"
GROUPS = [((2, 2), "a"), ((25, 17), "a"), ((14, 7), "b"), ((3, 12), "b"), ((14, 2), ""), ((5, 8), "c"), ((20, 3), "c")]


class Robots(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("free.map", FREE)
        self.write("g.tsv", "x\ty\tgroup\n" + "".join(f"{x}\t{y}\t{group}\n" for (x, y), group in GROUPS))
        self.write("p.tsv", "x y\n" + "".join(f"{x} {y}\n" for (x, y), _ in GROUPS))

    def tour(self, *arguments, stops="g.tsv", map_file="free.map"):
        return self.run_program("tour", map_file, "--stops", stops, *arguments)

    def least_of_groups(self, is_open):
        own = {}
        for i, (cell, group) in enumerate(GROUPS):
            own.setdefault(group or i, []).append(cell)
        return min(self.around(order, is_open) for choice in itertools.product(*own.values())
                   for order in itertools.permutations(choice))

    @staticmethod
    def around(order, is_open):
        return sum(math.dist(order[i - 1], order[i]) for i in range(1 if is_open else 0, len(order)))

    def test_one_stop_of_each_group(self):
        self.write("g.json", json.dumps([{"x": x, "y": y, "group": group or None} for (x, y), group in GROUPS]))
        self.write("g.geojson", json.dumps({"type": "FeatureCollection", "features": [
            {"type": "Feature", "geometry": {"type": "Point", "coordinates": cell}, "properties": {"group": group}}
            for cell, group in GROUPS]}))
        for name, options in itertools.product(("g.tsv", "g.json", "g.geojson"), ([], ["--open"])):
            with self.subTest((name, options)):
                result = self.quiet(self.tour("--json", *options, stops=name)).json
                self.assertEqual(result["groups"], [group for _, group in GROUPS])
                self.assertAlmostEqual(result["length"], self.least_of_groups(options != []), places=9)
                self.assertEqual(sorted(GROUPS[i][1] for i in result["order"]), ["", "a", "b", "c"])
                self.assertEqual((result["optimal"], result["left_out"]), (True, []))
                self.assertNotIn("tours", result)
        self.ended(self.replay_of(result), 0)
        self.ended(self.replay_of({**result, "groups": ["a"] * 7}), 1)
        for key, value in (("starts", 1e300), ("stops", ["a"]), ("stops", "a"), ("groups", 3), ("parameters", [])):
            with self.subTest((key, value)):
                self.refused(self.replay_of({**result, key: value}), 3, "bad.json", "cannot be replayed")
        begun = self.tour("--json", "--start", "25,17").json  # of its group it is the one
        self.assertEqual((begun["order"][0], len(begun["order"])), (1, 4))

    def test_a_group_that_cannot_be_reached(self):
        self.write("s.tsv", "x\ty\tgroup\n4\t2\tk\n3\t2\tk\n0\t0\tm\n4\t2\tm\n9\t5\t\n8\t5\t\n")
        run = self.tour(stops="s.tsv", map_file="small.map")
        why = "no stop of group k can be visited: stop 0 at (4, 2) cannot be reached from the others"
        self.ended(run, 0, why + ": left out")
        result = self.tour("--json", stops="s.tsv", map_file="small.map").json
        self.assertEqual(result["left_out"], [{"stop": 0, "why": why, "group": "k"}])
        self.assertEqual(sorted(result["order"]), [2, 4, 5])

    def test_robots(self):
        cells = [cell for cell, _ in GROUPS]
        for options in ([], ["--open"]):
            is_open = options != []
            run = self.quiet(self.tour("--json", "--start", "0,0", "--start", "29,19", *options, stops="p.tsv"))
            result = run.json
            best = math.inf
            for share in itertools.product((0, 1), repeat=7):
                total = 0
                for robot, depot in enumerate(((0, 0), (29, 19))):
                    own = [cell for cell, to in zip(cells, share) if to == robot]
                    total += min(self.around((depot, *order), is_open) for order in itertools.permutations(own))
                    if total >= best:
                        break
                best = min(best, total)
            self.assertAlmostEqual(result["length"], best, places=9)
            self.assertTrue(result["optimal"])
            self.assertEqual((result["start"], result["goal"]), (None, None))
            self.assertEqual((result["starts"], result["stops"][7:]), ([[0, 0], [29, 19]], [[0, 0], [29, 19]]))
            self.check(result)
            self.ended(self.replay_of(result), 0)
        self.ended(self.replay_of({**result, "starts": [[0, 0], [0, 19]]}), 1)
        self.ended(self.tour("--start", "0,0", "--start", "29,19", stops="p.tsv"), 0, "of 2 robots, ", "proven shortest", "robot 0: start, ", "robot 1: start, ")

    def check(self, result):
        """Each robot from its start, by the legs that it names; all in all each stop once."""
        self.assertEqual(sorted(result["order"]), list(range(len(result["stops"]))))
        self.assertEqual([i for tour in result["tours"] for i in tour["legs"]], list(range(len(result["legs"]))))
        self.assertEqual([i for tour in result["tours"] for i in tour["order"]], result["order"])
        for tour, start in zip(result["tours"], result["starts"]):
            order = tour["order"]
            self.assertEqual((tour["start"], result["stops"][order[0]]), (order[0], start))
            following = order[1:] + ([] if result["parameters"]["open"] else order[:1])
            legs = [result["legs"][i] for i in tour["legs"]]
            self.assertEqual([(leg["from"], leg["to"]) for leg in legs], list(zip(order, following)) if order[1:] else [])
            self.assertAlmostEqual(tour["length"], sum(leg["length"] for leg in legs), places=9)
        self.assertAlmostEqual(result["length"], sum(tour["length"] for tour in result["tours"]), places=9)

    def test_most_stops_and_one_depot_for_all(self):
        depots = ["--start", "10,10"] * 3
        apart = self.tour("--json", *depots, "--most-stops", "3", stops="p.tsv").json
        self.check(apart)
        self.assertEqual(apart["parameters"]["most_stops"], 3)
        self.assertEqual(sorted(len(tour["order"]) for tour in apart["tours"])[-1], 4)
        self.ended(self.replay_of(apart), 0)
        self.assertLess(self.tour("--json", *depots, stops="p.tsv").json["length"], apart["length"])
        self.ended(self.tour(*depots, "--most-stops", "2", stops="p.tsv"), 5, "3 robots have no room for 7 stops")
        self.check(self.tour("--json", *depots, "--open", stops="p.tsv").json)

    def test_larger_ones_are_the_same_on_any_threads(self):
        self.write("many.tsv", "x\ty\tgroup\n" + "".join(
            f"{i * 7 % 30}\t{i * 11 % 20}\t{i % 20 if i % 3 else ''}\n" for i in range(60)))
        for robots in ([], ["--start", "0,0", "--start", "29,19"]):
            answers = []
            for threads in (1, 2, 5):
                result = self.tour("--json", "--threads", threads, "--generations", "1", *robots, stops="many.tsv").json
                del result["threads"], result["elapsed_ms"]
                answers.append(result)
            self.assertEqual(answers, answers[:1] * 3)
            self.assertLess(answers[0]["lower_bound"], answers[0]["length"])
            self.ended(self.tour("--generations", "1", *robots, stops="many.tsv"), 0, "no order is below")

    def test_files(self):
        self.write("world.pgm", "P2\n30 20\n255\n" + "254 " * 600 + "\n")
        self.write("world.yaml", ROS)
        self.write("m.tsv", "x y\n0.5 0.5\n3.25 4\n9 2\n6 6.5\n")
        robots = ["--frame", "world", "--start", "0,0", "--start", "10,7"]
        files = [word for name in ("a.json", "a.csv", "a.svg", "a.yaml") for word in ("-o", name)]
        run = self.tour(*robots, *files, stops="m.tsv", map_file="world.yaml")
        self.ended(run, 0)
        result = json.loads(self.read("a.json"))
        self.check(result)
        self.assertEqual(result["starts_world"], [[0, 0], [10, 7]])
        for tour in result["tours"]:
            self.assertAlmostEqual(tour["length_m"], 0.5 * tour["length"])
        self.assertEqual(run.out.splitlines()[2 + sum(row["robot"] == "0" for row in self.rows("a.csv"))], "")  # from robot to robot
        rows = self.rows("a.csv")
        self.assertEqual(list(rows[0]), ["robot", "x_m", "y_m"])
        self.assertEqual([rows[0]["x_m"], rows[0]["y_m"]], ["0", "0"])
        self.holds(self.words("a.svg"), "2 robots, 6 stops", "robot 0", "robot 1", "start")
        paths = self.read("a.yaml").decode().split("---\n")[1:]
        self.assertEqual(len(paths), 2)
        self.holds(paths[1], "frame_id: map", "position: {x: 10.0, y: 7.0, z: 0.0}")
        self.tour("--frame", "world", "--spacing", "5", "-o", "one.yaml", stops="m.tsv", map_file="world.yaml")
        self.assertNotIn(b"---", self.read("one.yaml"))
        self.assertLess(self.read("one.yaml").count(b"position"), 15)

    def test_what_does_not_go_together(self):
        self.write("l.tsv", "x\ty\tgroup\tload\n1\t1\ta\t1\n2\t2\ta\t-1\n")
        self.write("two.tsv", "x\ty\tgroup\n1\t1\ta\n2\t2\ta\n")
        robots = ["--start", "0,0", "--start", "9,9"]
        for run, *words in (
                (self.tour(stops="l.tsv"), "tours with groups have no order given in part"),
                (self.tour("--algorithm", "mmas"), "ants know no tours with groups"),
                (self.tour("--start", "1,1", "--goal", "2,2", stops="two.tsv"), "both ends of the tour and of group a, of which one stop is visited"),
                (self.tour(*robots, "--goal", "1,1"), "--goal: 2 robots end where they began"),
                (self.tour(*robots, "--algorithm", "acs"), "--algorithm acs: ants know no tours of several robots"),
                (self.tour(*robots, "--capacity", "3"), "--capacity: tours of several robots have no loads"),
                (self.tour("--most-stops", "3"), "--most-stops is for several robots"),
                (self.tour(*robots, "--most-stops", "0"), "--most-stops"),
                (self.tour(*robots, "-o", "a.gif"), ".gif")):
            with self.subTest(words):
                self.refused(run, 2, *words)
        for starts, code, words in (("3,2", 4, "start"), ("4,2", 5, "start (4, 2) cannot be reached from the others"),
                                    ("40,2", 4, "outside")):
            run = self.tour("--start", "0,0", "--start", starts, map_file="small.map")
            self.ended(run, code, words)

    def test_the_start_that_is_none_is_named(self):
        self.write("one.tsv", "x\ty\n0\t0\n")
        for starts, words in ((("1,1", "3,2"), "start (3, 2) is blocked; the nearest free cell"),
                              (("1,1", "50,1"), "start (50, 1) is outside")):
            run = self.tour("--start", starts[0], "--start", starts[1], stops="one.tsv", map_file="small.map")
            self.ended(run, 4, words)
        for what in (("--stops", "one.tsv"), ("--cover", "1")):
            run = self.run_program("tour", "small.map", *what, "--start", "0.0,0.0", "--radius", "0.3")
            self.ended(run, 4, "start (0, 0) is too near")
            self.assertNotIn("goal", run.err)


if __name__ == "__main__":
    unittest.main()
