"""drive: arrives without touching anything, records it, replays it, and shows it."""
import json
import os
import unittest

from gif import read_film
from program import MAPS, SMALL_MAP, SVG, ProgramTest

# What small.map does not tell: its gap in row 4 is shut, one in row 2 is open.
TRUTH = SMALL_MAP.replace("....@.....", "....@@@@@@")


def solid(text):
    """Blocked cells of a map's text."""
    rows = text.split("map\n", 1)[1].split("\n")
    return {(x, y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "@"}


class Drive(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("truth.map", TRUTH)

    def drive(self, *arguments, start="0,0", goal="9,5", map_file="small.map"):
        return self.run_program("drive", map_file, "--start", start, "--goal", goal, *arguments)

    def check_track(self, result, blocked_at, size=(10, 6)):
        """Each move to one of the eight neighbours, free at its tick, no corner cut."""
        track = [tuple(cell) for cell in result["track"]]
        self.assertEqual(track[0], tuple(result["start"]))
        self.assertEqual(len(track), result["ticks"] + 1)
        length = 0
        for tick, ((x, y), (to_x, to_y)) in enumerate(zip(track, track[1:])):
            self.assertLessEqual(max(abs(to_x - x), abs(to_y - y)), 1)
            for cell in ((to_x, to_y), (to_x, y), (x, to_y)):
                self.assertNotIn(cell, blocked_at(tick))
                self.assertTrue(0 <= cell[0] < size[0] and 0 <= cell[1] < size[1])
            # Nor does anything come onto the robot.
            self.assertNotIn((to_x, to_y), blocked_at(tick + 1))
            length += (abs(to_x - x) + abs(to_y - y)) ** 0.5
        self.assertAlmostEqual(length, result["length"], places=9)
        self.assertEqual(sum(a == b for a, b in zip(track, track[1:])), result["waits"])

    def test_options_of_plan_that_are_none_of_a_drive(self):
        help_text = self.run_program("drive", "--help").out
        self.assertIn("No effect: a drive always tells the optimum of its moves", " ".join(help_text.split()))
        for option in ("--tracks", "--prepared"):
            self.assertNotIn(option, help_text)
        for value in ("1", "abc"):
            self.refused(self.drive("--tracks", value), 2, "a drive's picture shows the robot's track")
        self.refused(self.drive("--tracks"), 2, "--tracks needs a value, N,N,...")
        run = self.drive("--track", "1")
        self.refused(run, 2, "unknown option \"--track\"; see --help")
        self.assertNotIn('"--tracks"', run.err)

    def test_an_unknown_wall_is_learned_and_gone_round(self):
        run = self.quiet(self.drive("--world", "truth.map", "--sense", "1", "--json", start="9,2"))
        result = run.json
        self.assertEqual(list(result), [
            "format", "version", "map", "world", "changes", "algorithm", "start", "goal", "seed",
            "threads", "parameters", "status", "error", "track", "ticks", "replans", "seen",
            "length", "optimum", "ratio", "waits", "deferred", "elapsed_ms"])
        self.assertEqual(result["format"], "lasius-drive/1")
        self.assertEqual((result["status"], result["error"]), ("solved", None))
        self.assertEqual(result["track"][-1], [9, 5])
        self.check_track(result, lambda tick: solid(TRUTH))
        # To (9, 3) and the shut gap, and back again round the west end.
        self.assertGreater(result["ratio"], 1)
        self.assertAlmostEqual(result["ratio"], result["length"] / result["optimum"])
        self.assertGreater(result["seen"], 0)
        self.assertEqual(result["replans"][0]["tick"], 0)
        self.assertGreaterEqual(len(result["replans"]), 2)
        for replan in result["replans"]:
            self.assertEqual(set(replan), {"tick", "ms", "length"})
        self.assertEqual(result["parameters"]["sense"], 1)
        self.assertIsNone(result["changes"])

    def test_without_a_world_the_map_is_the_truth(self):
        result = self.drive("--json").json
        self.assertIsNone(result["world"])
        self.assertEqual((result["seen"], len(result["replans"])), (0, 1))
        # By (2, 2), (2, 4) and (3, 5): no corner of the walls is cut.
        self.assertAlmostEqual(result["optimum"], 8 + 3 * 2 ** 0.5)

    def test_a_door_that_opens_and_one_that_shuts(self):
        self.write("shut.map", TRUTH)
        self.write("c.txt", "# the east\n1 0 4 4 1 blocked\n12, 9 4 free\n")
        result = self.drive("--world", "shut.map", "--changes", "c.txt", "--json").json
        west = {(x, 4) for x in range(4)}

        def blocked(tick):
            there = solid(TRUTH) | (west if tick >= 1 else set())
            return there - {(9, 4)} if tick >= 12 else there
        self.assertEqual(result["status"], "solved")
        self.check_track(result, blocked)
        self.assertGreaterEqual(result["ticks"], 12)

    def test_a_moving_obstacle_is_given_way(self):
        self.write("lane.map", "type octile\nheight 3\nwidth 12\nmap\n" + "............\n" * 3)
        self.write("c.txt", "0 move 1 2 1 11 0 0 0\n")
        result = self.drive("--changes", "c.txt", "--json", goal="10,0", map_file="lane.map").json
        self.assertEqual(result["status"], "solved")
        # It waits for nobody: the lane is wide enough for the robot beside it.
        self.check_track(result, lambda tick: {(11 - tick, y) for y in (0, 1)}, size=(12, 3))
        self.assertTrue(any(y == 2 for _, y in result["track"]))

    def test_how_a_drive_ends(self):
        self.refused_status(self.drive("--json", goal="4,2"), 5, "unreachable")
        self.refused_status(self.drive("--json", goal="3,2"), 4, "invalid", "goal (3, 2) is blocked",
                            "nearest free cell is (2, 2)")
        self.refused_status(self.drive("--json", goal="10,2"), 4, "invalid", "outside")
        self.refused_status(self.drive("--json", "--max-ticks", "3"), 6, "limit")
        self.refused_status(self.drive("--json", "--time-limit", "0"), 6, "limit")
        self.write("c.txt", "0 move 1 1 0 9 4\n")
        self.write("shut.map", TRUTH.replace("....@@@@@@", "@@@@@@@@@."))
        trapped = self.drive("--json", "--world", "shut.map", "--changes", "c.txt")
        self.refused_status(trapped, 6, "no_path", "trapped")
        for file in ("f.gif", "f.png"):
            self.assertEqual(self.drive("-o", file, goal="3,2").code, 4)
            self.assertGreater(len(self.read(file)), 0)

    def test_a_signal_ends_a_drive_with_what_was_driven(self):
        # What goes up and down the lane lets nobody through.
        self.write("lane.map", "type octile\nheight 1\nwidth 9\nmap\n.........\n")
        self.write("c.txt", "0 move 1 1 0.5 2 0 7 0\n")
        process = self.start_program("drive", "lane.map", "--start", "0,0", "--goal", "8,0",
                                     "--changes", "c.txt", "--max-ticks", "1000000000", "--json",
                                     "-o", "r.json", "-o", "r.png", "--progress", "always")
        seen = b""
        while b"tick " not in seen:
            seen += process.stderr.read(1)
            self.assertIsNone(process.poll(), seen)
        out, err = self.interrupted(process)
        self.assertIn(b"interrupted after", err)
        result = json.loads(out)
        self.assertEqual(result["status"], "interrupted")
        self.assertEqual(len(result["track"]), result["ticks"] + 1)
        self.assertEqual(self.read("r.json"), out)
        self.assertGreater(min(self.png_size("r.png")), 100)

    def refused_status(self, run, code, status, *words):
        self.assertEqual((run.code, run.json["status"]), (code, status), run.err)
        for word in words:
            self.assertIn(word, run.json["error"])

    def test_what_the_command_line_refuses(self):
        self.refused(self.drive("--sence", "3"), 2, "--sense")
        self.refused(self.drive("--sense", "0"), 2, "--sense")
        self.refused(self.drive("--seed", "1-3"), 2, "--seed")
        self.refused(self.drive("-o", "x.webm"), 2, ".gif")
        self.refused(self.drive("--world", "no.map"), 3, "no.map")
        self.refused(self.drive(map_file="world.json"), 2, "world.json")
        self.write("wide.map", "type octile\nheight 1\nwidth 12\nmap\n............\n")
        self.refused(self.drive("--world", "wide.map"), 3, "wide.map", "12 x 1", "10 x 6")

    def test_broken_changes_name_file_and_line(self):
        for line, word in (("5 1 1 blokced", "blocked"), ("1 2", "words"), ("-1 1 1 free", "-1"),
                           ("0 9 9 free", "inside"), ("0 move 1 1 fast 1 1", "speed"),
                           ("0 move 1 1 65 1 1", "speed"), ("0 1 1 3 0 free", "none")):
            self.write("c.txt", "# a comment\n\n" + line + "\n")
            self.refused(self.drive("--changes", "c.txt"), 3, "c.txt, line 3", word)
        self.refused(self.drive("--changes", "no.txt"), 3, "no.txt")

    def test_changes_may_be_none(self):
        for text in ("", "# nothing\n"):
            self.write("none.txt", text)
            run = self.quiet(self.drive("--changes", "none.txt", "--json"))
            self.assertEqual(run.json["track"], self.drive("--json").json["track"])

    def test_the_optimum_is_that_of_the_world_at_tick_0(self):
        # The start's change is put off, as long as the robot is there.
        self.write("changes.txt", "0 0 0 2 1 blocked\n0 4 0 blocked\n")
        result = self.drive("--changes", "changes.txt", "--json").json
        self.assertEqual(result["status"], "solved")
        self.assertGreater(result["deferred"], 0)
        self.assertGreater(result["ratio"], 1 - 1e-9)

    def test_a_map_with_a_door_that_it_does_not_show(self):
        self.write("shut.map", "type octile\nheight 3\nwidth 5\nmap\n..@..\n..@..\n..@..\n")
        self.write("open.map", "type octile\nheight 3\nwidth 5\nmap\n..@..\n..@..\n.....\n")
        run = self.run_program("drive", "shut.map", "--start", "0,0", "--goal", "4,0", "--world",
                               "open.map", "--sense", "1", "--json")
        self.assertEqual((run.code, run.json["status"]), (0, "solved"))
        run = self.run_program("drive", "shut.map", "--start", "0,0", "--goal", "4,0", "--json")
        self.assertEqual((run.code, run.json["status"], run.json["ticks"]), (5, "unreachable", 0))

    def write_ros(self, name, resolution, origin="0, 0, 0"):
        self.write("cells.pgm", "P2\n4 3\n255\n" + "255 " * 12)
        self.write(name, f"image: cells.pgm\nresolution: {resolution}\norigin: [{origin}]\n"
                         "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")

    def test_a_world_is_of_the_same_place(self):
        self.write_ros("map.yaml", 0.5)
        self.write_ros("fine.yaml", 0.25)
        self.write_ros("elsewhere.yaml", 0.5, "0, 1, 0")
        for name, what in (("fine.yaml", "resolution"), ("elsewhere.yaml", "y of the origin")):
            self.ended(self.drive("--world", name, map_file="map.yaml", goal="3,2"), 3,
                       f"{name}: {what}")
        self.ended(self.drive("--world", "map.yaml", map_file="map.yaml", goal="3,2"), 0)

    def test_sense_in_metres_is_told_in_metres(self):
        self.write_ros("map.yaml", 0.5)
        metres = ("--frame", "world", "--json")
        run = self.drive("--sense", "1", *metres, map_file="map.yaml", start="0.1,0.1",
                         goal="1.9,1.4")
        self.assertEqual(run.json["parameters"]["sense"], 2)
        for sense in ("0.4", "700001"):
            self.ended(self.drive("--sense", sense, *metres, map_file="map.yaml", start="0.1,0.1",
                                  goal="1.9,1.4"), 2, f"--sense {sense} m")

    def test_verify_says_where_a_result_lacks_what_it_found(self):
        self.drive("-o", "run.json")
        result = json.loads(self.read("run.json"))
        result["optimum"] = result["ratio"] = None
        self.write("cut.json", json.dumps(result))
        self.ended(self.run_program("verify", "cut.json"), 0, "'optimum' is null")

    def test_text_and_table(self):
        run = self.drive("-o", "t.csv", "--radius", "0.3", start="1,1", goal="1,4")
        lines = run.out.splitlines()
        self.assertEqual(lines[0], "solved")
        self.assertEqual(lines[2:], [line.replace(",", " ")
                                     for line in self.read("t.csv").decode().splitlines()[1:]])
        self.assertEqual((lines[2], lines[-1]), ("1 1", "1 4"))
        self.assertIn("1.0000 of the optimum", run.err)

    def test_a_recorded_drive_is_replayed(self):
        self.write("c.txt", "4 9 0 blocked\n9 9 0 free\n0 move 1 1 0.5 0 3 2 3\n")
        for more in ([], ["--algorithm", "fan2004", "--iterations", "4"], ["--max-ticks", "5", "--time-limit", "100"], ["--max-ticks", "5"]):
            self.drive("--world", "truth.map", "--changes", "c.txt", "--sense", "2", *more,
                       "-o", "r.json", "-q", start="9,2")
            for threads in ("1", "2"):
                self.quiet(self.run_program("verify", "r.json", "--threads", threads))
        saved = json.loads(self.read("r.json"))
        for key, value in (("seen", 1), ("track", saved["track"][:-1]), ("start", [8, 0])):
            self.assertEqual(self.replay_of({**saved, key: value}).code, 1, key)
        self.write("c.txt", "4 9 0 blocked\n")
        self.refused(self.run_program("verify", "r.json"), 3, "c.txt", "hash")
        self.drive("--time-limit", "0", "-o", "r.json")
        self.assertEqual(self.run_program("verify", "r.json").code, 2)

    def test_pictures(self):
        self.write("c.txt", "3 9 0 blocked\n0 move 1 1 0.5 0 3 2 3\n")
        self.drive("--world", "truth.map", "--changes", "c.txt", "--sense", "2", "-o", "p.svg",
                   "-o", "p.png", start="9,2")
        self.holds(self.words("p.svg"), "a way was planned", "never learned", "moving obstacle",
                   "through truth.map")
        self.assertLessEqual(max(self.png_size("p.png")), 2000)

    def test_a_picture_has_a_dot_where_a_way_was_found(self):
        rows = ["@" * 20, "." * 20, "@" * 20]
        self.write("lane.map", "type octile\nheight 3\nwidth 20\nmap\n" + "\n".join(rows) + "\n")
        self.write("c.txt", "3 10 1 blocked\n14 10 1 free\n")
        result = self.drive("--changes", "c.txt", "--sense", "4", "--json", "-o", "p.svg", start="0,1",
                            goal="19,1", map_file="lane.map").json
        self.assertEqual([plan["length"] is None for plan in result["replans"]], [False, True, False])
        lines = [path.get("d").split() for path in self.svg_root("p.svg").iter(SVG + "path")]
        dots = [d for d in lines if len(d) == 6 and d[1:3] == d[4:6]]
        self.assertEqual(len(dots), 2 + 1)  # one is the legend's

    def test_a_film_shows_the_robot_at_each_tick(self):
        result = self.drive("--json", "-o", "f.gif").json
        width, height, frames = read_film(self.read("f.gif"))
        self.assertEqual((width, height, len(frames)), (500, 300, result["ticks"] + 1))
        robot = frames[0][25][25]  # 50 pixels a cell
        for (x, y), frame in zip(result["track"], frames):
            self.assertEqual(frame[50 * y + 25][50 * x + 25], robot)
        red, green, blue = robot
        self.assertGreater(red, green + blue)

    def test_a_long_film_is_thinned(self):
        fan = os.path.join(MAPS, "fan400x200.map")
        result = self.drive("--json", "-o", "f.gif", start="14,14", goal="380,179",
                            map_file=fan).json
        self.assertGreater(result["ticks"], 300)
        width, height, frames = read_film(self.read("f.gif"))
        self.assertEqual((width, height), (400, 200))
        self.assertTrue(150 <= len(frames) <= 301, len(frames))


if __name__ == "__main__":
    unittest.main()
