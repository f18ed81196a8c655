"""Reports, -o FILE.html: whole, closed to the network, with what the run gave, and bounded."""
import base64
import json
import os
import re
import struct
import unittest
import zlib

from program import MAPS, ProgramTest

FAN = dict(map_file=os.path.join(MAPS, "fan400x200.map"), start="14,14", goal="380,179")


def unpacked(text):
    return zlib.decompress(base64.b64decode(text, validate=True))


def frames(text, size):
    """Undoes the differences from frame to frame."""
    data, result, before = unpacked(text), [], bytes(size)
    for at in range(0, len(data), size):
        before = bytes((a + b) % 256 for a, b in zip(before, data[at:at + size]))
        result.append(before)
    return result


class Report(ProgramTest):
    def content(self, name="run.html"):
        page = self.read(name).decode()
        found = re.findall(r'<script type="application/json" id="content">(.*?)</script>', page, re.S)
        self.assertEqual(len(found), 1)
        return json.loads(found[0])

    def reported(self, *arguments, **question):
        run = self.plan(*arguments, "--json", "-q", "-o", "run.html", **(question or FAN))
        self.assertEqual(run.err, "")
        return run.json, self.content()

    def test_a_page_names_no_address_and_forbids_all(self):
        self.plan("--iterations", "3", "-o", "run.html", **FAN)
        page = self.read("run.html").decode()
        self.assertTrue(page.startswith("<!doctype html>\n<html lang=\"en\">"))
        self.assertIn("Content-Security-Policy\" content=\"default-src 'none';", page)
        outside = re.findall(r"https?://[^\s\"'<>)]+", page)
        self.assertEqual(set(outside), {"http://www.w3.org/2000/svg"})  # a name, not an address
        self.assertFalse(re.findall(r"<(?:link|iframe|img|object|embed)\b|<script[^>]+src|@import|url\((?!#)", page))
        self.assertNotRegex(page, r"(?m)^(?:import|export) ")

    def test_a_radius_keeps_the_obstacles_as_they_were(self):
        near = {**FAN, "goal": "60,63"}
        self.assertIsNone(self.reported(**near)[1]["map"]["obstacles"])
        grown = self.reported("--radius", "2.8", **near)[1]["map"]
        walls, obstacles = (unpacked(grown[part]["shares"]) for part in ("walls", "obstacles"))
        self.assertTrue(all(a >= b for a, b in zip(walls, obstacles, strict=True)))
        self.assertGreater(sum(map(bool, walls)), 1.3 * sum(map(bool, obstacles)))

    def test_an_unknown_index_has_no_code_and_others_all(self):
        trail = self.reported("--algorithm", "terminal-index", map_file=os.path.join(MAPS, "grid20a.map"),
                              start="0,0", goal="19,19")[1]["frames"]["trail"]
        first, *_, last = frames(trail["frames"], 400)
        self.assertEqual(set(first), {0})
        self.assertGreater(len(set(last)), 50)
        self.assertLess(trail["most"], 200)

    def test_it_has_the_result_and_the_command(self):
        result, content = self.reported("--iterations", "12", "--gap")
        shown = content["result"]
        for key in ("length", "path", "seed", "parameters", "status", "optimum", "map"):
            self.assertEqual(shown[key], result[key], key)
        self.assertEqual(content["curves"]["iteration"], list(range(1, 13)))
        for key in ("best", "mean", "arrived", "raw_best"):
            self.assertEqual(content["curves"][key], result[key], key)
            self.assertNotIn(key, shown)
        self.assertRegex(content["command"], r"^lasius plan .*fan400x200\.map --start 14,14 .* -o run\.html$")

    def test_the_command_is_quoted_for_a_shell(self):
        name = self.write("it's a map.map", self.read("small.map"))
        self.plan("--iterations", "2", "-o", "run.html", map_file=name)
        self.assertIn(r"'it'\''s a map.map'", self.content()["command"])

    def test_frames_hold_every_iteration_of_a_short_run(self):
        result, content = self.reported("--iterations", "12")
        kept = content["frames"]
        size = kept["width"] * kept["height"]
        self.assertEqual((kept["width"], kept["height"], kept["cells_a_pixel"]), (400, 200, 1))
        self.assertEqual(kept["iterations"], list(range(1, 13)))
        self.assertEqual(kept["arrived"], result["arrived"])
        self.assertEqual(set(kept["ants"]), {10})
        trail, tracks = (frames(kept[name]["frames"], size) for name in ("trail", "tracks"))
        self.assertEqual((len(trail), len(tracks)), (12, 12))
        blocked = unpacked(content["map"]["walls"]["shares"])
        self.assertEqual(len(blocked), size)
        start = 14 * 400 + 14
        for frame in trail + tracks:
            self.assertGreater(frame[start], 0)
            self.assertFalse([i for i in range(size) if frame[i] and blocked[i]][:1])
        self.assertEqual(max(map(max, tracks)), 255)
        lengths = [sum(((ax - bx) ** 2 + (ay - by) ** 2) ** 0.5 for (ax, ay), (bx, by) in zip(path, path[1:]))
                   for path in kept["paths"]]
        for best, number in zip(result["best"], kept["path_of"]):
            self.assertAlmostEqual(lengths[number], best, places=6)
        self.assertEqual(kept["paths"][-1], result["path"])

    def test_over_costs_lines_of_equal_cost_and_the_asked_ends(self):
        exact = ("--algorithm", "exact", "--inflation", "2,1")
        plain = self.plan(*exact, "--json").json
        costs = (*exact, "-o", "run.svg")
        result, content = self.reported(*costs, map_file="small.map", start="0,0", goal="9,5")
        for key in ("path", "cost", "lower_bound", "gap"):
            self.assertEqual(result[key], plain[key], key)  # a proof for lines alone changes nothing
        lines, apart = content["map"]["level_lines"], content["map"]["lines_apart"]
        self.assertGreater(len(lines), 20)
        self.assertGreater(apart, 0)
        self.assertTrue(all(0 <= x <= 10 and 0 <= y <= 6 for ax, ay, bx, by in lines for x, y in ((ax, ay), (bx, by))))
        self.assertTrue(all((ax - bx) ** 2 + (ay - by) ** 2 <= 2.1 for ax, ay, bx, by in lines))
        self.assertIn("lines: cost to the goal, where the proof looked, %g apart" % apart, self.words("run.svg"))
        self.assertEqual(content["ends"], [[0.5, 0.5], [9.5, 5.5], None])
        proof = content["frames"]["proof"]
        self.assertTrue(all(bound <= best * (1 + 1e-9) for bound, best in zip(proof["bound"], proof["best"], strict=True)))
        self.assertGreater(len(proof["bound"]), 0)
        for options in ((*exact, "--radius", "0.4"), ("--inflation", "2,1", "--algorithm", "mmas", "--iterations", "3")):
            content = self.reported(*options, map_file="small.map", start="0,0", goal="9,5")[1]
            self.assertGreater(len(content["map"]["level_lines"]), 20, options)
        content = self.reported(*costs, map_file="small.map", start="0.25,0.5", goal="9.5,5.75")[1]
        self.assertEqual(content["ends"], [[0.25, 0.5], [9.5, 5.75], None])  # the goal is reached, and no cell's centre
        content = self.reported(*exact, "--via", "4,0", map_file="small.map", start="0,0", goal="9,5")[1]
        self.assertNotIn("level_lines", content["map"])  # it would be of no leg

    def test_clearance_along_the_path(self):
        result, content = self.reported("--polish", "taut", map_file="small.map", start="0,0", goal="9,5")
        clearance = content["clearance"]
        self.assertAlmostEqual(clearance["step"] * (len(clearance["values"]) - 1), result["length"])
        self.assertEqual((clearance["values"][0], clearance["values"][-1]), (0.5, 0.5))
        self.assertLess(min(clearance["values"]), 0.1)  # it touches corners

    def test_a_long_run_is_thinned(self):
        self.run_program("generate", "blobs", "--size", "500x300", "--seed", "3", "-o", "big.map")
        rows = self.read("big.map").decode().splitlines()[4:]
        start = next(f"{x},10" for x in range(10, 500) if rows[10][x] == ".")
        goal = next(f"{x},60" for x in range(60, 500) if rows[60][x] == ".")
        result, content = self.reported("--iterations", "4500", "--ants", "1", "--algorithm", "acs",
                                        "--polish", "straight", map_file="big.map", start=start, goal=goal)
        self.assertEqual(result["iterations"], 4500)
        kept = content["frames"]
        self.assertLessEqual(max(kept["width"], kept["height"]), 400)
        self.assertLessEqual(len(kept["iterations"]), 401)
        self.assertEqual(kept["iterations"][-1], 4500)
        self.assertLessEqual(len(content["curves"]["best"]), 4001)
        self.assertLess(os.path.getsize(self.path("run.html")), 5_000_000)

    def test_long_curves_are_thinned_and_keep_their_ends(self):
        result, content = self.reported("--iterations", "9000", "--ants", "1", map_file="small.map", start="0,0", goal="9,5")
        curves = content["curves"]
        self.assertEqual(result["iterations"], 9000)
        self.assertEqual(curves["iteration"][:2] + curves["iteration"][-1:], [1, 4, 9000])
        self.assertEqual([curves["best"][0], curves["best"][-1]], [result["best"][0], result["best"][-1]])
        self.assertEqual({len(curve) for curve in curves.values()}, {3001})
        self.assertLessEqual(len(content["frames"]["iterations"]), 401)

    def test_a_run_without_a_path(self):
        self.ended(self.plan("-q", "-o", "run.html", start="5,2", goal="9,5"), 5)
        content = self.content()
        self.assertEqual(content["result"]["status"], "unreachable")
        self.assertIsNone(content["result"]["path"])
        self.assertIsNone(content["frames"])

    def test_a_path_does_not_depend_on_who_watches(self):
        watched, _ = self.reported("--iterations", "15")
        alone = self.plan("--iterations", "15", "--json", **FAN).json
        for key in ("path", "best", "mean", "steps"):
            self.assertEqual(watched[key], alone[key])

    def test_text_cannot_leave_its_place(self):
        name = "<!--<script>\u2215&amp;\".map"
        self.write(name, self.read("small.map"))
        self.plan("--iterations", "2", "-o", "run.html", map_file=name)
        page = self.read("run.html").decode()
        self.assertEqual(page.count("<!--"), 0)
        self.assertEqual(page.count("<script"), 2)
        self.assertIn("<title>fan2004 on &lt;!--&lt;script&gt;\u2215&amp;amp;&quot;.map", page)
        self.assertIn(name, self.content()["title"])

    def test_a_name_that_is_no_utf_8_is_shown_with_marks(self):
        name = os.fsencode(self.folder) + b"/bad\xff.map"
        with open(name, "wb") as file:
            file.write(self.read("small.map"))
        run = self.plan("--iterations", "2", "-q", "-o", "run.html", map_file=os.fsdecode(name))
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("bad\ufffd.map", self.content()["title"])

    def test_metres(self):
        self.write("map.pgm", b"P5 4 3 255\n" + bytes([254] * 12))
        self.write("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [10, 20, 0]\nnegate: 0\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        self.ended(self.plan("--frame", "world", "--iterations", "2", "-q", "-o", "run.html",
                             map_file="map.yaml", start="10.2,20.2", goal="11.7,21.2"), 0)
        content = self.content()
        self.assertEqual((content["unit"], content["scale"]), ("m", 0.5))
        self.assertEqual(content["map"]["to_world"], [0.5, 0, 10, 0, -0.5, 21.5])
        self.assertEqual(len(content["result"]["path_world"]), len(content["result"]["path"]))

    def test_what_plays_one_run_refuses_many(self):
        self.refused(self.plan("--seed", "1-3", "-o", "run.html"), 2, "run.html", "one run")
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n")
        self.refused(self.run_program("batch", "small.map", "q.tsv", "-o", "run.html"), 2, ".html")
        self.refused(self.run_program("study", "all", "-o", "run.html"), 2, "run.html")

    def test_a_drive(self):
        run = self.run_program("drive", "small.map", "--start", "0,0", "--goal", "9,5", "--json", "-o", "run.html")
        content, result = self.content(), run.json
        kept = content["frames"]
        self.assertEqual(kept["ticks"], list(range(result["ticks"] + 1)))
        self.assertEqual(kept["robots"], result["track"])
        codes = frames(kept["codes"], 60)
        self.assertEqual(len(codes), len(kept["ticks"]))
        self.assertEqual(codes[0][0], 1)  # free, in sight
        self.assertGreaterEqual(codes[0][13], 2)  # a wall
        points = struct.unpack(f"<{2 * sum(kept['way_lengths'])}f", unpacked(kept["ways"]))
        self.assertEqual(points[:2], (0.5, 0.5))
        self.assertEqual(content["result"]["track"], result["track"])
        rows = self.read("small.map").decode().splitlines()[4:]
        walls = [(x, y) for x in range(-1, 11) for y in range(-1, 7)
                 if not (0 <= x < 10 and 0 <= y < 6) or rows[y][x] != "."]
        clearances = [min(max(abs(x - cx) - 0.5, 0) ** 2 + max(abs(y - cy) - 0.5, 0) ** 2 for cx, cy in walls) ** 0.5
                      for x, y in result["track"]]
        self.assertEqual((kept["clearances"]["step"], kept["clearances"]["most"]), (1, 64))
        self.assertEqual(kept["clearances"]["last"], kept["clearances"]["values"][-1])
        for kept_value, value in zip(kept["clearances"]["values"], clearances, strict=True):
            self.assertAlmostEqual(kept_value, value, delta=0.0005)

    def test_a_file_that_cannot_be_written(self):
        self.refused(self.plan("-o", "none/run.html"), 7, "none/run.html")


if __name__ == "__main__":
    unittest.main()
