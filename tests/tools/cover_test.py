"""tour --cover: swaths that cover a map, told with their shares, drawn, replayed; what is no width is refused."""
import json
import math
import unittest

from program import MAPS, ProgramTest

ROS = "image: world.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n"
GRID = f"{MAPS}/grid30a.map"


class Cover(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("free.map", "type octile\nheight 12\nwidth 20\nmap\n" + ("." * 20 + "\n") * 12)

    def cover(self, map_file, width, *arguments):
        return self.run_program("tour", map_file, f"--cover={width}", "--generations", "2", *arguments)

    def test_an_empty_room(self):
        run = self.cover("free.map", 3, "--open", "--json", "-o", "tour.svg", "-o", "tour.png", "-o", "tour.csv")
        self.assertEqual(run.code, 0, run.err)
        result, cover = run.json, run.json["cover"]
        self.assertEqual((cover["swaths"], cover["angle"], cover["covered"], cover["overlap"], cover["unreachable"]), (4, 0, 1, 0, 0))
        self.assertAlmostEqual(result["length"], 4 * 20 + 3 * 3)
        self.assertLess(result["gap"], 1e-3)
        for leg in result["legs"]:
            self.assertAlmostEqual(leg["length"], math.dist(leg["path"][0], leg["path"][-1]))
        with open(self.path("tour.csv")) as lines:
            self.assertEqual(len(lines.read().split()), 1 + 8)
        with open(self.path("tour.svg"), encoding="utf-8") as picture:
            self.assertIn("4 swaths, length 89.00 cells, 100.00% covered", picture.read().replace("\xa0", " "))

    def test_results_are_replayed(self):
        self.write("world.yaml", ROS)
        self.write("world.pgm", b"P5 16 12 255\n" + bytes(254 if x != 9 or y > 8 else 0 for y in range(12) for x in range(16)))
        for name, arguments in (("a", (GRID, 2, "--start", "0,0")),
                                ("b", ("world.yaml", 1.3, "--frame", "world", "--radius", "0.3", "--start", "0,0", "--open"))):
            run = self.cover(*arguments, "-o", f"{name}.json", "--json")
            self.assertEqual(run.code, 0, run.err)
            result = run.json
            self.assertEqual(sorted(result["order"]), list(range(len(result["stops"]))))
            self.assertEqual(result["order"][0], 2 * result["cover"]["swaths"])
            self.assertGreater(result["cover"]["covered"], 0.95)
            self.assertLessEqual(result["lower_bound"], result["length"])
            self.assertAlmostEqual(result["length"], sum(leg["length"] for leg in result["legs"]))
            self.assertEqual(self.run_program("verify", f"{name}.json").code, 0)
        self.assertEqual(result["cover"]["width"], 2.6)
        self.assertAlmostEqual(result["cover"]["width_m"], 1.3)
        self.assertAlmostEqual(result["length_m"], result["length"] / 2)
        self.assertEqual(result["legs"][0]["path_world"][0], [0, 0])
        result["length"] += 1
        self.write("other.json", json.dumps(result))
        self.assertEqual(self.run_program("verify", "other.json").code, 1)

    def test_poses_and_pages(self):
        run = self.cover("free.map", 3, "--open", "--spacing", "2", "-o", "tour.yaml", "-o", "tour.html")
        self.assertEqual(run.code, 0, run.err)
        with open(self.path("tour.yaml"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn("frame_id", text)
        self.assertGreaterEqual(text.count("position:"), (4 * 20 + 3 * 3) / 2)
        with open(self.path("tour.html"), encoding="utf-8") as file:
            self.assertTrue(file.read().lower().startswith("<!doctype html"))

    def test_text_tells_the_shares(self):
        run = self.cover(GRID, 2)
        self.assertEqual(run.out.split("\n")[0], "solved")
        for words in ("swaths, ", "covered of what the tool can come to", "3.14% of the free area is out of its reach", "is below"):
            self.assertIn(words, run.err)

    def test_refusals(self):
        for width, words in ((0, "is no width"), (-1, "not a number from 0 up"), ("nan", "not a number from 0 up"),
                             (31, "at most the map's 30 cells"), (1e-5, "more than 10000 swaths")):
            run = self.cover(GRID, width)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn(words, run.err)
        self.write("long.map", "type octile\nheight 30000\nwidth 2\nmap\n" + "..\n" * 30000)
        for width, words in ((0.001, "more samples of the map's area than 200000000"), (0.1, "more lines than 100000")):
            run = self.cover("long.map", width)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn(words, run.err)
        for option in (("--goal", "1,1"), ("--capacity", "1"), ("--target-gap", "1"), ("--algorithm", "mmas"), ("--inflation", "2,3"),
                       ("--stops", "free.map"), ("--most-stops", "2")):
            run = self.cover(GRID, 2, *option)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn("tours of stops", run.err)
        run = self.cover(GRID, 2, "--start", "0,0", "--start", "1,1")
        self.assertEqual(run.code, 2, run.err)
        self.assertIn("give one --start", run.err)
        for option, words in ((("--radius", "0.5", "--start", "0.2,0.2"), "start (0.2, 0.2) is too near to the edge"), (("--start", "50,1"), "start (50, 1) is outside the map"), (("--radius", "20"), "no place on the map")):
            run = self.cover(GRID, 2, *option, "--json")
            self.assertEqual((run.code, run.json["status"], run.json["legs"], run.json["order"]), (4, "invalid", None, None))
            self.assertIn(words, run.json["error"])
            self.write("invalid.json", json.dumps(run.json))
            self.assertEqual(self.run_program("verify", "invalid.json").code, 0)


if __name__ == "__main__":
    unittest.main()
