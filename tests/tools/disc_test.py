"""plan and batch --radius: curve and path judged by distances of their own."""
import json
import math
import random
import re
import unittest

from program import ProgramTest

ROOM = 1e-9  # of a distance


class Judge:
    """Distances to all blocked squares, and to those around the map."""

    def __init__(self, rows):
        height, width = len(rows), len(rows[0])
        self.squares = [(x, y) for y in range(-1, height + 1) for x in range(-1, width + 1)
                        if not (0 <= x < width and 0 <= y < height) or rows[y][x] == "@"]

    def point(self, x, y):
        return min(math.hypot(max(a - x, 0, x - a - 1), max(b - y, 0, y - b - 1)) for a, b in self.squares)

    def segment(self, a, b):
        return min(apart(a, b, x, y) for x, y in self.squares)


def apart(a, b, x, y):
    """Of a segment and the square at (x, y)."""
    enters, leaves = 0, 1
    for k, low in ((0, x), (1, y)):
        along = b[k] - a[k]
        if along == 0:
            if not low <= a[k] <= low + 1:
                enters = 2
            continue
        one, other = sorted(((low - a[k]) / along, (low + 1 - a[k]) / along))
        enters, leaves = max(enters, one), min(leaves, other)
    if enters <= leaves:
        return 0
    least = min(math.hypot(max(x - p[0], 0, p[0] - x - 1), max(y - p[1], 0, p[1] - y - 1)) for p in (a, b))
    dx, dy = b[0] - a[0], b[1] - a[1]
    for corner in ((x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)):
        t = ((corner[0] - a[0]) * dx + (corner[1] - a[1]) * dy) / (dx * dx + dy * dy or 1)
        t = min(1, max(0, t))
        least = min(least, math.hypot(corner[0] - a[0] - t * dx, corner[1] - a[1] - t * dy))
    return least


def pieces_of(curve):
    """(from, arc or None, to), of points and arcs between them."""
    pieces, arc = [], None
    for entry in curve[1:]:
        if isinstance(entry, dict):
            arc = entry
            continue
        pieces.append((last := pieces[-1][2] if pieces else curve[0], arc, entry))
        arc = None
    return pieces


def swept(start, arc, end):
    """The angle of an arc."""
    angles = [math.atan2(p[1] - arc["centre"][1], p[0] - arc["centre"][0]) for p in (start, end)]
    return (arc["turn"] * (angles[1] - angles[0])) % (2 * math.pi)


class Discs(ProgramTest):
    def setUp(self):
        super().setUp()
        self.algorithm = "exact"

    def map(self, rows):
        self.write("m.map", f"type octile\nheight {len(rows)}\nwidth {len(rows[0])}\nmap\n" + "\n".join(rows) + "\n")

    def judged(self, answer, radius, judge):
        """Its curve and path keep the radius, its lengths are theirs."""
        length, pieces = 0, pieces_of(answer["curve"])
        self.assertEqual((pieces[0][0], pieces[-1][2]), (answer["path"][0], answer["path"][-1]))
        for a, arc, b in pieces:
            if arc is None:
                length += math.dist(a, b)
                self.assertGreaterEqual(judge.segment(a, b), radius - ROOM)
                continue
            self.assertEqual((arc["radius"], abs(arc["turn"])), (radius, 1))
            for end in (a, b):
                self.assertAlmostEqual(math.dist(arc["centre"], end), radius, delta=ROOM)
            angle = swept(a, arc, b)
            self.assertLessEqual(angle, math.pi / 2 + ROOM)
            length += angle * radius
            for i in range(17):
                at = math.atan2(a[1] - arc["centre"][1], a[0] - arc["centre"][0]) + arc["turn"] * angle * i / 16
                x, y = (arc["centre"][k] + radius * (math.cos, math.sin)[k](at) for k in (0, 1))
                self.assertGreaterEqual(judge.point(x, y), radius - ROOM)
        self.assertAlmostEqual(length, answer["length"], delta=1e-9)
        polyline = sum(math.dist(a, b) for a, b in zip(answer["path"], answer["path"][1:]))
        self.assertTrue(length * (1 - 1e-12) <= polyline <= 1.001 * length)
        for a, b in zip(answer["path"], answer["path"][1:]):
            self.assertGreaterEqual(judge.segment(a, b), radius - ROOM)

    def from_way_out(self, answer, judge):
        """Without the leg that leads out, if there is one."""
        out, start = answer["way_out"], [v + 0.5 for v in answer["start"]]
        if out is None:
            return answer
        self.assertEqual((answer["path"][:2], answer["curve"][:2]), ([start, out], [start, out]))
        self.assertEqual((answer["lower_bound"], answer["gap"], answer["optimal"]), (None, None, False))
        self.assertGreaterEqual(judge.segment(start, out), judge.point(*start) - ROOM)
        return {**answer, "curve": answer["curve"][1:], "path": answer["path"][1:],
                "length": answer["length"] - math.dist(start, out), "optimal": True}

    def test_curves_and_paths_keep_the_radius(self):
        draw = random.Random(5)
        bent = led = 0
        for radius in (0.3, 0.5, 1, 1.7, 2.3):
            rows = ["".join("@" if draw.random() < 0.12 / (1 + radius) else "." for _ in range(30)) for _ in range(24)]
            self.map(rows)
            judge = Judge(rows)
            self.write("q.tsv", "sx sy gx gy\n" + "\n".join(
                " ".join(str(draw.randrange(n)) for n in (30, 24, 30, 24)) for _ in range(12)))
            for more in ([], ["--prepare"]):
                run = self.ended(self.run_program("batch", "m.map", "q.tsv", "--radius", str(radius), *more), 0)
                for i, answer in enumerate(run.lines):
                    x, y = answer["start"]
                    clear = rows[y][x] == "." and judge.point(x + 0.5, y + 0.5) >= radius - ROOM
                    if not clear and answer["way_out"] is None:
                        self.assertEqual(answer["status"], "invalid")
                    if answer["status"] != "solved" or answer["length"] == 0:
                        continue
                    rest = self.from_way_out(answer, judge)
                    led += rest is not answer
                    self.assertTrue(rest["optimal"])
                    self.judged(rest, radius, judge)
                    bent += len(answer["curve"]) > 2
                    if i < 2 and not more:
                        alone = self.plan("--json", "--radius", str(radius), map_file="m.map", goal="%d,%d" % tuple(answer["goal"]),
                                          start="%d,%d" % (x, y)).json
                        self.assertEqual((alone["curve"], alone["path"]), (answer["curve"], answer["path"]))
                self.write("lines.json", run.out)
                self.ended(self.run_program("verify", "lines.json"), 0)
        self.assertGreater(bent, 20)
        self.assertGreater(led, 3)

    def test_the_way_out(self):
        rows = ["." * 30] * 8 + ["." * 9 + "@" * 2 + "." * 19] * 6 + ["." * 30] * 4
        self.map(rows)
        judge = Judge(rows)
        for algorithm in ("exact", "acs", "grid-ga"):
            self.algorithm = algorithm
            ask = dict(map_file="m.map", start="8,10", goal="20,12")
            few = [] if algorithm == "exact" else ["--iterations", "3"]
            run = self.ended(self.plan("--json", "--radius", "2.3", *few, **ask), 0)
            answer, start = run.json, [8.5, 10.5]
            out = answer["way_out"]
            self.assertEqual((answer["status"], answer["path"][:2]), ("solved", [start, out]))
            for a, b in zip(answer["path"][1:], answer["path"][2:]):
                self.assertGreaterEqual(judge.segment(a, b), 2.3 - ROOM)
            if algorithm == "exact":
                self.assertAlmostEqual(out[0], 9 - 2.3, delta=ROOM)
                self.judged(self.from_way_out(answer, judge), 2.3, judge)
            else:
                self.assertEqual(answer["best"][-1], answer["length"])
            self.ended(self.replay_of(answer), 0)
            self.ended(self.plan("--radius", "2.3", *few, **ask), 0, "start (8, 10) is too near to an obstacle, 0.5 cells away: "
                       "the radius is 2.3 cells; the path first leads straight out to " +
                       ("the point (6.7, 10.5), 1.8 cells away" if algorithm == "exact" else "(6, 10), 2 cells away"))
            self.write("q.tsv", "sx sy gx gy\n8 10 20 12\n9 10 20 12\n4 4 20 12\n")
            lines = self.ended(self.run_program("batch", "m.map", "q.tsv", "--algorithm", algorithm, "--radius", "2.3", *few), 0).lines
            self.assertEqual((lines[0]["path"], lines[0]["length"]), (answer["path"], answer["length"]))
            self.assertEqual([line["status"] for line in lines], ["solved", "invalid", "solved"])
            self.assertEqual([line["way_out"] for line in lines], [out, None, None])

    def test_a_goal_that_is_too_near(self):
        rows = ["." * 30] * 8 + ["." * 9 + "@" * 2 + "." * 19] * 6 + ["." * 30] * 4
        self.map(rows)
        ask = dict(map_file="m.map", start="2,3", goal="8,10")
        self.ended(self.plan("--radius", "2.3", **ask), 4, "goal (8, 10) is too near to an obstacle, 0.5 cells away")
        short = self.plan("--radius", "2.3", "--goal-tolerance", "1.7", **ask)
        self.ended(short, 4, "the nearest cell that can be reached, (6, 10), is 2 cells from the goal, the tolerance is 1.7 cells")
        run = self.ended(self.plan("--json", "--radius", "2.3", "--goal-tolerance", "1.9", "-o", "r.svg", **ask), 0)
        answer = run.json
        self.assertEqual((answer["goal"], answer["goal_reached"]), ([8, 10], answer["path"][-1]))
        self.assertAlmostEqual(answer["path"][-1][0], 6.7, delta=ROOM)
        self.assertTrue(answer["optimal"])
        self.judged(answer, 2.3, Judge(rows))
        self.ended(self.replay_of(answer), 0)
        self.ended(self.plan("--radius", "2.3", "--goal-tolerance", "1.9", **ask), 0,
                   "the path ends at the point (6.7, 10.5), 1.8 cells from the goal, which cannot be reached")
        self.holds(self.words("r.svg"), "goal asked: (8, 10), reached: the point (6.7, 10.5), 1.80", "goal reached",
                   "swept by the robot, a disc of radius 2.30")

    def test_pictures_have_arcs(self):
        self.map(["." * 20] * 8 + ["." * 6 + "@" * 8 + "." * 6] * 8)
        for algorithm, arcs in (("exact", True), ("as", False)):
            self.algorithm = algorithm
            self.ended(self.plan("--radius", "2", "-o", "r.svg", map_file="m.map", start="3,13", goal="16,13"), 0)
            lines = re.findall(r'<path[^>]*stroke-width[:=]"?3[;"][^>]* d="([^"]*)"', self.read("r.svg").decode())
            self.assertEqual(any(" C " in line for line in lines), arcs)
            self.assertGreater(len(lines), 1)  # the legend's among them

    def test_a_corridor_as_wide_as_the_disc(self):
        self.map(["." * 30] * 3 + ["." * 8 + "@" * 12 + "." * 10] * 4 + ["." * 30] * 3 +
                 ["." * 8 + "@" * 12 + "." * 10] * 6)
        for radius, code in (("1.5", 0), ("1.500001", 5), ("60", 2), ("0.01", 2)):
            run = self.plan("--json", "--radius", radius, map_file="m.map", start="4,8", goal="24,8")
            self.assertEqual(run.code, code, (radius, run.err))
            if code == 5:
                self.assertEqual((run.json["curve"], run.json["widest_radius"]), (None, 1.5))
            if code == 2:
                self.assertIn("between 0.05 and 54", run.err)
        self.algorithm = "as"
        run = self.ended(self.plan("--json", "--radius", "1", map_file="m.map", start="4,8", goal="24,8"), 0)
        self.assertNotIn("curve", run.json)
        self.assertNotIn("curve", self.plan("--json", map_file="m.map", start="4,8", goal="24,8").json)

    def test_metres(self):
        pixels = bytearray(b"\xfe" * 30 * 20)
        for y in range(4, 20):
            pixels[30 * y + 15] = 0
        self.write("m.pgm", b"P5\n30 20\n255\n" + bytes(pixels))
        self.write("m.yaml", "image: m.pgm\nresolution: 0.5\norigin: [-2, 1, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        run = self.ended(self.plan("--json", "--radius", "0.75", "--frame", "world", map_file="m.yaml",
                                   start="0.25,4.25", goal="11.25,4.25"), 0)
        answer = run.json
        rows = ["".join("@" if p == 0 else "." for p in pixels[30 * y:30 * y + 30]) for y in range(20)]
        self.judged(answer, 1.5, Judge(rows))
        length = 0
        run = self.plan("--radius", "40", "--frame", "world", map_file="m.yaml", start="-1,2", goal="2,3")
        self.assertEqual(run.code, 2)
        self.assertIn("--radius is 40 m; for exact a disc's radius is between 0.025 and 27 m (0.05 and 54 cells)", run.err)
        for a, arc, b in pieces_of(answer["curve_world"]):
            length += math.dist(a, b) if arc is None else 0.75 * swept(a, arc, b)
        self.assertAlmostEqual(length, answer["length_m"], delta=1e-9)
        self.assertAlmostEqual(answer["length_m"], 0.5 * answer["length"], delta=1e-12)
        self.ended(self.plan("--radius", "30", "--frame", "world", map_file="m.yaml", start="0.25,4.25", goal="11.25,4.25"), 2,
                   "--radius is 30 m; for exact a disc's radius is between 0.025 and 27 m (0.05 and 54 cells)")
        led = self.ended(self.plan("--json", "--radius", "0.75", "--frame", "world", map_file="m.yaml", start="5.25,4.25",
                                   goal="0.25,4.25"), 0).json
        self.assertEqual(led["way_out"], led["path"][1])
        self.assertEqual(led["way_out_world"], led["path_world"][1])
        arc = next(e for e in answer["curve_world"] if isinstance(e, dict))
        self.assertEqual((arc["radius"], arc["turn"], arc["centre"]), (0.75, -1, [5.5, 9.0]))
        self.write("r.json", json.dumps(answer))
        self.ended(self.run_program("verify", "r.json"), 0)


if __name__ == "__main__":
    unittest.main()
