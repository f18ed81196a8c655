"""tour on polygon worlds: orders stops, names what it leaves out, refuses what is of bitmaps, draws, and is replayed."""
import json
import math
import os
import unittest

from program import MAPS, ProgramTest

WORLD = os.path.join(MAPS, "maklink200.geojson")
WALL = {"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"role": role}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    for role, ring in (("boundary", [[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]),
                       ("obstacle", [[4, 0], [6, 0], [6, 8], [4, 8], [4, 0]]))]}


class PolygonTour(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("wall.geojson", json.dumps(WALL))
        self.write("stops.tsv", "x\ty\tname\n2\t1\ta\n8.5\t1.5\tb\n8\t6\tc\n1\t9\td\n")

    def tour(self, *arguments, world="wall.geojson", stops="stops.tsv"):
        return self.run_program("tour", world, "--stops", stops, *arguments)

    def test_worked_by_hand(self):
        result = self.quiet(self.tour("--json")).json
        self.assertEqual(result["format"], "lasius-tour/1")
        # From a to b over the wall's two corners.
        over = math.dist((2, 1), (4, 8)) + 2 + math.dist((6, 8), (8.5, 1.5))
        back = math.dist((8.5, 1.5), (8, 6)) + math.dist((8, 6), (6, 8)) + math.dist((6, 8), (4, 8)) + math.dist((4, 8), (1, 9)) + math.dist((1, 9), (2, 1))
        self.assertLessEqual(result["length"], over + back + 1e-9)
        self.assertTrue(result["optimal"])
        self.assertEqual(sorted(result["order"]), [0, 1, 2, 3])
        self.assertEqual(result["stops"][1], [8.5, 1.5])
        self.assertEqual(result["parameters"]["margin"], 0)
        for leg in result["legs"]:
            self.assertAlmostEqual(leg["length"], sum(map(math.dist, leg["path"], leg["path"][1:])), places=9)
        opened = self.tour("--open", "--start", "2,1", "--goal", "8,6", "--margin", "0.5", "--json").json
        self.assertEqual((opened["order"][0], opened["order"][-1]), (0, 2))
        self.assertEqual(opened["parameters"]["margin"], 0.5)

    def test_left_out_and_ends(self):
        self.write("more.json", "[[2, 1], [5, 3], [8, 1], [20, 1]]")
        run = self.tour("--json", stops="more.json")
        self.assertEqual(run.code, 0)
        self.assertEqual([one["stop"] for one in run.json["left_out"]], [1, 3])
        self.assertIn("stop 1 at (5, 3) is blocked", run.json["left_out"][0]["why"])
        self.assertIn("stop 3 at (20, 1) is outside", run.json["left_out"][1]["why"])
        self.ended(self.tour("--start", "5,3"), 4, "start (5, 3) is blocked")

    def test_files_and_replays(self):
        for stops, more in (("stops.tsv", []), ("stops.tsv", ["--start", "2,1", "--start", "8,6"])):
            run = self.tour(*more, "-o", "t.json", "-o", "t.svg", "-o", "t.csv", "-q", stops=stops)
            self.assertEqual(run.code, 0, run.err)
            with open(self.path("t.svg"), encoding="utf-8") as file:
                self.assertIn("<svg", file.read())
            again = self.run_program("verify", "t.json")
            self.assertEqual((again.code, again.out), (0, "1 of 1 result is equal to the replay\n"), again.err)

    def test_many_stops_of_a_published_world(self):
        self.write("many.tsv", "x\ty\n" + "".join(f"{7 + 31 * i % 186}\t{5 + 53 * i % 190}\n" for i in range(90)))
        one, three = (self.tour("--threads", n, "--json", world=WORLD, stops="many.tsv").json for n in ("1", "3"))
        self.assertEqual(one["order"], three["order"])
        self.assertLess(one["gap"], 0.02)
        self.assertGreater(len(one["order"]), 40)

    def test_refusals(self):
        for arguments, words in ((["--radius", "1"], "--radius is for bitmaps"), (["--frame", "world"], "--frame is for bitmaps"),
                                 (["-o", "t.html"], "pages are of tours on bitmaps"), (["-o", "t.yaml"], "poses")):
            self.ended(self.tour(*arguments), 2, words)
        self.write("free.map", "type octile\nheight 1\nwidth 3\nmap\n...\n")
        self.ended(self.tour("--margin", "1", world="free.map"), 2, "--margin is for polygon worlds")


if __name__ == "__main__":
    unittest.main()
