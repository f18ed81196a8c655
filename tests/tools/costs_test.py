"""plan and batch over costs: weights, cost and bounds judged by arithmetic of their own."""
import heapq
import itertools
import json
import math
import os
import random
import unittest

from disc_test import Judge
from layers import map_text, npy, pfm, pgm, random_map, yaml
from program import ProgramTest


class Weights:
    """What cells cost, by the contract's formulas."""

    def __init__(self, rows):
        self.free = [[c == "." for c in row] for row in rows]
        self.height, self.width = len(rows), len(rows[0])
        self.weights = [[1.0] * self.width for _ in rows]

    def cells(self):
        return itertools.product(range(self.width), range(self.height))

    def add(self, values, factor=1.0):
        for x, y in self.cells():
            self.weights[y][x] += factor * values[y][x]

    def inflate(self, radius, scaling, weight=2.0, robot=1.0):
        blocked = [(x, y) for x, y in self.cells() if not self.free[y][x]]
        for x, y in self.cells():
            d = min((math.dist((x, y), b) for b in blocked), default=math.inf)
            if d <= radius:
                self.weights[y][x] += weight * min(1.0, math.exp(-scaling * (d - robot)))

    def at(self, x, y):
        inside = 0 <= x < self.width and 0 <= y < self.height and self.free[y][x]
        return self.weights[y][x] if inside else math.inf

    def cost(self, path):
        """The integral along a polyline; infinite where it enters what is blocked."""
        total = 0.0
        for (x0, y0), (x1, y1) in zip(path, path[1:]):
            cuts = {0.0, 1.0}
            for a, b in ((x0, x1), (y0, y1)):
                for line in range(math.ceil(min(a, b)), math.floor(max(a, b)) + 1):
                    if a != b:
                        cuts.add(min(1.0, max(0.0, (line - a) / (b - a))))
            cuts = sorted(cuts)
            length = math.dist((x0, y0), (x1, y1))
            for s, t in zip(cuts, cuts[1:]):
                if (t - s) * length < 1e-9:
                    continue
                x, y = x0 + (x1 - x0) * (s + t) / 2, y0 + (y1 - y0) * (s + t) / 2
                columns = {math.floor(x)} | ({int(x) - 1} if x == int(x) and x0 == x1 else set())
                lines = {math.floor(y)} | ({int(y) - 1} if y == int(y) and y0 == y1 else set())
                total += (t - s) * length * min(self.at(c, r) for c in columns for r in lines)
        return total

    def eight_moves(self, start, goal):
        best, queue = {start: 0.0}, [(0.0, start)]
        while queue:
            cost, (x, y) = heapq.heappop(queue)
            if (x, y) == goal:
                return cost
            if cost > best[(x, y)]:
                continue
            for dx, dy in itertools.product((-1, 0, 1), repeat=2):
                to = (x + dx, y + dy)
                if math.isinf(self.at(*to) + self.at(x + dx, y) + self.at(x, y + dy)):
                    continue
                more = cost + math.hypot(dx, dy) * (self.at(x, y) + self.at(*to)) / 2
                if more < best.get(to, math.inf):
                    best[to] = more
                    heapq.heappush(queue, (more, to))
        return math.inf


class Costs(ProgramTest):
    algorithm = "exact"

    def over(self, rows, *options, start=(0, 0), goal=None):
        self.write("m.map", map_text(rows))
        goal = goal or (len(rows[0]) - 1, len(rows) - 1)
        return self.plan("--json", *options, start="%d,%d" % start, goal="%d,%d" % goal, map_file="m.map")

    def judge(self, result, weights, start=(0, 0), goal=None):
        """Cost and gap are what they say, no bound is above what a walk costs."""
        walk = weights.eight_moves(start, goal or (weights.width - 1, weights.height - 1))
        if result["status"] == "unreachable":
            self.assertEqual((walk, result["cost"]), (math.inf, None))
            return False
        self.assertEqual(result["status"], "solved")
        self.assertAlmostEqual(weights.cost(result["path"]), result["cost"], delta=1e-6 * result["cost"])
        self.assertLessEqual(result["lower_bound"], result["cost"])
        self.assertLessEqual(result["cost"], walk * (1 + 1e-12))
        self.assertEqual(result["gap"], (result["cost"] - result["lower_bound"]) / result["lower_bound"])
        self.assertLess(result["gap"], 0.01)
        self.assertAlmostEqual(result["length"], sum(map(math.dist, result["path"], result["path"][1:])), places=9)
        return True

    def test_costs_are_what_the_formulas_say(self):
        rng, solved = random.Random(5), 0
        for i in range(30):
            width, height = rng.randint(5, 24), rng.randint(5, 24)
            rows = random_map(rng, width, height)
            weights, options = Weights(rows), []
            levels = [[rng.randint(0, 200) for _ in range(width)] for _ in range(height)]
            values = [[rng.randint(0, 9) / 4 for _ in range(width)] for _ in range(height)]
            if i % 3 != 1:
                most = (200, 255, 65535)[i // 3 % 3]
                self.write("a.pgm", pgm(levels, most))
                options += ["--cost", "a.pgm*3"]
                weights.add([[level / most for level in row] for row in levels], 3)
            if i % 3 != 2:
                name = self.write(*(("b.pfm", pfm(values)) if i % 2 else ("b.npy", npy(values))))
                options += ["--cost", name]
                weights.add(values)
            if i % 4:
                options += ["--inflation", ("3,0.7", "2.5,1,4", "6,0.25,1.5")[i % 3]]
                weights.inflate(*((3, 0.7), (2.5, 1, 4), (6, 0.25, 1.5))[i % 3])
            result = self.over(rows, *options).json
            solved += self.judge(result, weights)
            walk = self.over(rows, *options, "--moves", "8").json
            if result["status"] == "solved":
                self.assertAlmostEqual(walk["cost"], weights.eight_moves((0, 0), (width - 1, height - 1)), places=9)
                self.assertTrue(walk["optimal"])
                self.assertEqual(walk["parameters"]["moves"], 8)
        self.assertGreater(solved, 12)

    def test_a_ros_layer_stands_where_its_frame_says(self):
        rng = random.Random(8)
        rows = ["." * 12] * 8
        for mode, negate in itertools.product(("trinary", "scale", "raw"), (0, 1)):
            # The map: 0.1 m a cell from (1, 2). The layer: 0.2 m a cell from (1.4, 1.8), 3 x 4.
            self.write("ground.pgm", pgm([[255 if c == "." else 0 for c in row] for row in rows]))
            self.write("ground.yaml", yaml("ground.pgm", 0.1, (1, 2, 0)))
            levels = [[rng.choice((0, 40, 90, 100, 130, 205, 255)) for _ in range(3)] for _ in range(4)]
            self.write("layer.pgm", pgm(levels))
            self.write("layer.yaml", yaml("layer.pgm", 0.2, (1.4, 1.8, 0), mode, negate=negate))
            weights = Weights(rows)
            for x, y in weights.cells():
                metres_x, metres_y = 1 + 0.1 * (x + 0.5), 2 + 0.1 * (8 - y - 0.5)
                column, row = math.floor((metres_x - 1.4) / 0.2), 3 - math.floor((metres_y - 1.8) / 0.2)
                if not (0 <= column < 3 and 0 <= row < 4):
                    continue
                level = levels[row][column]
                p = (level if negate else 255 - level) / 255
                if mode == "raw":
                    percent = level if level <= 100 else 0
                elif p >= 0.65:
                    percent = 100
                else:
                    percent = 0 if p <= 0.25 or mode == "trinary" else round(100 * (p - 0.25) / 0.4)
                weights.free[y][x] = percent < 100
                weights.weights[y][x] += 2 * percent / 100
            weights.inflate(3, 0.5)
            run = self.plan("--cost", "layer.yaml*2", "--inflation", "3,0.5", "--json", start="0,0",
                            goal="11,7", map_file="ground.yaml")
            self.assertTrue(self.judge(run.json, weights))
            self.write("away.yaml", yaml("layer.pgm", 0.2, (50, 1.8, 0)))
            self.ended(self.plan("--cost", "away.yaml", start="0,0", goal="11,7", map_file="ground.yaml"), 0,
                       "away.yaml has no effect")
            metres = self.plan("--cost", "layer.yaml*2", "--inflation", "0.3,5", "--frame", "world", "--json",
                               start="1.05,2.75", goal="2.15,2.05", map_file="ground.yaml").json
            self.assertAlmostEqual(metres["cost"], run.json["cost"], places=6)
            self.assertEqual(metres["layers"], run.json["layers"])

    def test_points_on_the_way_and_the_gap_of_a_colony(self):
        rng, judged = random.Random(33), 0
        for _ in range(8):
            rows = random_map(rng, 18, 16, 0.1)
            weights = Weights(rows)
            weights.inflate(3, 0.7)
            cells = [(x, y) for x, y in weights.cells() if weights.free[y][x]]
            via = rng.sample(cells, 2)
            ends = [(0, 0), *via, (17, 15)]
            walks = [weights.eight_moves(*pair) for pair in zip(ends, ends[1:])]
            if math.inf in walks:
                continue
            judged += 1
            options = ["--inflation", "3,0.7"]
            through = [text for x, y in via for text in ("--via", "%d,%d" % (x, y))]
            whole = self.over(rows, *options, *through).json
            legs = [self.over(rows, *options, start=a, goal=b).json for a, b in zip(ends, ends[1:])]
            for key in ("cost", "length", "lower_bound"):
                self.assertAlmostEqual(whole[key], sum(leg[key] for leg in legs), places=9)
            self.assertAlmostEqual(weights.cost(whole["path"]), whole["cost"], places=6)
            ants = self.over(rows, *options, *through, "--algorithm", "mmas", "--iterations", "6", "--gap").json
            self.assertAlmostEqual(weights.cost(ants["path"]), ants["cost"], places=6)
            self.assertAlmostEqual(ants["best"][-1], ants["cost"], places=9)
            self.assertAlmostEqual(ants["optimum"], whole["cost"], places=9)
            self.assertEqual(ants["lower_bound"], whole["lower_bound"])
            self.assertAlmostEqual(ants["optimum_gap"], ants["cost"] / whole["cost"] - 1, places=9)
            self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t17\t15\n")
            line = self.run_program("batch", "m.map", "q.tsv", *options, *through, "--algorithm", "mmas", "--iterations",
                                    "6", "--gap").json
            for key in ("cost", "optimum", "optimum_gap", "lower_bound", "gap", "best"):
                self.assertEqual(line[key], ants[key])
        self.assertGreater(judged, 2)
        self.ended(self.over(["." * 9] * 5, *options, "--gap"), 0, "--gap has no effect")

    def test_drives_take_the_cheapest_walk(self):
        rng = random.Random(21)
        for i in range(12):
            width, height = rng.randint(8, 24), rng.randint(8, 24)
            rows = random_map(rng, width, height)
            weights = Weights(rows)
            values = [[rng.randint(0, 9) / 4 for _ in range(width)] for _ in range(height)]
            weights.add(values)
            weights.inflate(3, 0.7)
            self.write("m.map", map_text(rows))
            self.write("v.pfm", pfm(values))
            self.write("c.txt", "3 move 1 1 0.5 %d %d %d %d" % (width // 2, 1, width // 2, height - 2))
            command = ["drive", "m.map", "--start", "0,0", "--goal", "%d,%d" % (width - 1, height - 1), "--cost", "v.pfm",
                       "--inflation", "3,0.7", "-o", "d.json", "-o", "d.png", "--json"]
            result = self.run_program(*command).json
            if result["status"] == "unreachable":
                continue
            walk = weights.eight_moves((0, 0), (width - 1, height - 1))
            track = [(x + 0.5, y + 0.5) for x, y in result["track"]]
            self.assertAlmostEqual(result["optimum"], walk, places=9)
            self.assertAlmostEqual(result["cost"], weights.cost(track), places=9)
            self.assertAlmostEqual(result["ratio"], 1, places=9)
            self.assertLessEqual(result["replans"][0]["cost"], walk * (1 + 1e-12))
            moved = self.run_program(*command, "--changes", "c.txt").json
            self.assertEqual(moved["status"], "solved")
            self.assertGreaterEqual(moved["ratio"], 1 - 1e-12)
            self.holds(self.run_program("verify", "d.json").out, "is equal")
        for options, told in ((["--algorithm", "mmas"], "exact"), (["--target-gap", "1"], "certified"),
                              (["--moves", "8"], "--moves")):
            self.ended(self.run_program(*command, *options), 2, told)

    def test_a_disc_keeps_its_radius_over_costs(self):
        rng, solved = random.Random(11), 0
        for radius in (0.3, 0.5, 0.8, 1.3):
            for _ in range(4):
                rows = random_map(rng, 22, 18, 0.06)
                weights = Weights(rows)
                weights.inflate(5, 0.6, 3, max(1.0, radius))
                start, goal = (2, 2), (19, 15)
                result = self.over(rows, "--radius", radius, "--inflation", "5,0.6,3", start=start, goal=goal).json
                if result["status"] != "solved" or result["way_out"]:
                    continue
                solved += 1
                judge = Judge(rows)
                for a, b in zip(result["path"], result["path"][1:]):
                    self.assertGreaterEqual(judge.segment(a, b), radius - 1e-9)
                self.assertAlmostEqual(weights.cost(result["path"]), result["cost"], delta=1e-6 * result["cost"])
                point = self.over(rows, "--cost", self.layer_of(weights), start=start, goal=goal).json
                self.assertLessEqual(point["lower_bound"], result["cost"])
                self.assertLess(result["gap"], 0.2)
        self.assertGreater(solved, 6)

    def layer_of(self, weights):
        return self.write("same.npy", npy([[w - 1 for w in row] for row in weights.weights]))

    def run_in(self, folder, *arguments):
        """Run by who stands in another folder."""
        own, self.folder = self.folder, folder
        try:
            return self.run_program(*arguments)
        finally:
            self.folder = own

    def test_points(self):
        """A path between points of cells, whose bound is that of cells less what the ends may save."""
        rng = random.Random(6)
        for _ in range(6):
            rows = random_map(rng, 20, 16, 0.1)
            rows[5] = rows[5][:3] + "." + rows[5][4:]
            rows[12] = rows[12][:17] + "." + rows[12][18:]
            weights = Weights(rows)
            weights.inflate(4, 0.5, 3)
            ends = dict(start=(3, 5), goal=(17, 12))
            cells = self.over(rows, "--inflation", "4,0.5,3", **ends).json
            if cells["status"] != "solved":
                continue
            points = self.plan("--inflation", "4,0.5,3", "--json", start="3.2,5.9", goal="17.5,12.25", map_file="m.map").json
            self.assertEqual((points["path"][0], points["path"][-1]), ([3.2, 5.9], [17.5, 12.25]))
            self.assertAlmostEqual(weights.cost(points["path"]), points["cost"], delta=1e-6 * points["cost"])
            self.assertLessEqual(points["lower_bound"], points["cost"])
            room = weights.at(3, 5) * math.hypot(0.3, 0.4) + weights.at(17, 12) * 0.25
            self.assertLessEqual(abs(points["cost"] - cells["cost"]), room + cells["cost"] * cells["gap"])
            same = self.plan("--inflation", "4,0.5,3", "--json", start="3.5,5.5", goal="17.5,12.5", map_file="m.map").json
            self.assertEqual(same["path"], cells["path"])

    def test_colonies(self):
        rng, found, over, alone = random.Random(9), 0, 0, 0
        rows = random_map(rng, 24, 18, 0.08)
        weights = Weights(rows)
        weights.inflate(5, 0.5, 4)
        best = self.over(rows, "--inflation", "5,0.5,4").json
        for name in ("as", "acs", "mmas", "fan2004", "cong2009", "terminal-index"):
            run = self.over(rows, "--inflation", "5,0.5,4", "--algorithm", name, "--iterations", "10", "-o", "c.json").json
            if run["status"] != "solved":
                continue
            found += 1
            self.assertAlmostEqual(weights.cost(run["path"]), run["cost"], delta=1e-6 * run["cost"])
            self.assertGreaterEqual(run["cost"], best["lower_bound"])
            self.assertAlmostEqual(run["best"][-1], run["cost"], delta=1e-6 * run["cost"])
            self.assertEqual((run["lower_bound"], run["gap"], run["optimal"]), (None, None, False))
            self.quiet(self.run_program("verify", "c.json"))
            for threads in (1, 5):
                again = self.over(rows, "--inflation", "5,0.5,4", "--algorithm", name, "--iterations", "10",
                                  "--threads", threads).json
                self.assertEqual((again["path"], again["mean"]), (run["path"], run["mean"]))
            # The control: by length alone ways are dearer.
            plain = self.plan("--algorithm", name, "--iterations", "10", "--json", start="0,0", goal="23,17", map_file="m.map").json
            over, alone = over + run["cost"], alone + weights.cost(plain["path"])
        self.assertLess(over, alone)
        self.assertGreaterEqual(found, 4)

    def test_no_costs_are_lengths(self):
        zeros = self.write("zero.pgm", pgm([[0] * 10] * 6))
        plain = self.plan("--json").json
        over = self.plan("--cost", zeros, "--json").json
        for field in ("path", "length", "lower_bound", "gap", "optimal"):
            self.assertEqual(over[field], plain[field])
        self.assertEqual(over["cost"], over["length"])
        self.assertEqual(list(plain).count("cost"), 0)
        proven = self.plan("--cost", zeros, "-o", "z.proof.json", "-o", "z.json")
        self.assertEqual(json.loads(self.read("z.json"))["path"], plain["path"])
        self.quiet(self.run_program("verify", "z.json"))
        self.quiet(self.run_program("check-proof", "small.map", "z.proof.json", "--cost", zeros))

    def test_ends_in_one_cell(self):
        """Out of a dear cell and back where that is cheaper than straight."""
        self.write("g.map", map_text(["...."] * 4))
        self.write("g.pgm", pgm([[1, 0, 0, 0], [0, 1, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], 1))
        for start, goal, most in (("1.05,1.1", "1.95,1.1", 4.2), ("1.9,1.3", "1.04,1.95", 9)):
            run = self.plan("--cost", "g.pgm*20", "--target-gap", "1", "--json", start=start, goal=goal, map_file="g.map").json
            self.assertLess(run["cost"], most)
            self.assertLess(run["gap"], 0.01)

    def test_results_replay_and_proofs_hold(self):
        self.write("a.pgm", pgm([[(7 * x + 5 * y) % 11 for x in range(10)] for y in range(6)], 10))
        options = ("--cost", "a.pgm*1.5", "--inflation", "2,1")
        run = self.plan(*options, "-o", "r.json", "-o", "r.proof.json", "-o", "r.svg", "-o", "r.csv")
        self.ended(run, 0, "cost ", "% above the least")
        self.holds(self.words("r.svg"), "% above the least; colours: weight of cells")
        self.quiet(self.run_program("verify", "r.json"))
        self.quiet(self.run_program("check-proof", "small.map", "r.proof.json", *options))
        for name in ("plain", "proven"):  # between points; the proof is beside
            proof = ("-o", "p.proof.json") if name == "proven" else ()
            self.plan(*options, *proof, "-o", name + ".json", start="0.3,0.4", goal="9.2,5.7")
            self.quiet(self.run_program("verify", name + ".json"))
        for field in ("path", "cost", "lower_bound", "gap"):
            self.assertEqual(*(json.loads(self.read(name + ".json"))[field] for name in ("plain", "proven")))
        self.quiet(self.run_program("check-proof", "small.map", "p.proof.json", *options))
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n9\t5\t0\t0\n4\t2\t0\t0\n3\t2\t0\t0\n")
        lines = self.run_program("batch", "small.map", "q.tsv", *options).lines
        one = json.loads(self.read("r.json"))
        self.assertEqual([line["status"] for line in lines], ["solved", "solved", "unreachable", "invalid"])
        for field in ("path", "cost", "length", "lower_bound", "gap", "layers", "parameters"):
            self.assertEqual(lines[0][field], one[field])
        for seed_threads in (1, 5):
            again = self.run_program("batch", "small.map", "q.tsv", *options, "--threads", seed_threads).lines
            self.assertEqual([line["path"] for line in again], [line["path"] for line in lines])
        self.run_program("batch", "small.map", "q.tsv", *options, "-o", "b.csv")
        rows = self.rows("b.csv")
        self.assertEqual([row["cost"] for row in rows[2:]], ["", ""])
        self.assertAlmostEqual(float(rows[0]["cost"]), one["cost"])
        self.assertAlmostEqual(float(rows[0]["gap"]), float(rows[0]["cost"]) / float(rows[0]["lower_bound"]) - 1)
        parts = [self.write(f"p{i}", self.run_program("batch", "small.map", "q.tsv", *options, "--radius", "0.5",
                                                      "--part", f"{i}/2").out) for i in (1, 2)]
        self.assertEqual(len(self.quiet(self.run_program("merge", *parts)).lines), 4)
        elsewhere = os.path.join(self.folder, "elsewhere")
        os.mkdir(elsewhere)
        self.quiet(self.run_in(elsewhere, "verify", self.path("r.json")))
        self.write("lines.jsonl", "".join(json.dumps(line) + "\n" for line in lines))
        self.quiet(self.run_program("verify", "lines.jsonl"))
        self.write("a.pgm", pgm([[1] * 10] * 6, 10))
        self.ended(self.run_program("verify", "r.json"), 3, "a.pgm: has hash ", "put the file of that time")

    def test_targets_and_limits(self):
        rng = random.Random(2)
        rows = random_map(rng, 90, 90, 0.05)
        self.write("a.npy", npy([[rng.random() * 3 for _ in row] for row in rows]))
        loose = self.over(rows, "--cost", "a.npy", "--target-gap", "5").json
        tight = self.over(rows, "--cost", "a.npy").json
        self.assertLessEqual(loose["gap"], 0.05)
        self.assertLess(tight["gap"], 1e-3)
        self.assertLessEqual(tight["lower_bound"], loose["cost"])
        none = self.over(rows, "--cost", "a.npy", "--time-limit", "0")
        self.assertEqual(none.json["status"], "limit")
        self.assertEqual(none.code, 6 if none.json["cost"] is None else 0)

    def test_broken_layers(self):
        for name, content, problem in (
                ("size.pgm", pgm([[1] * 10] * 5), "it has 10 x 5 values, the map 10 x 6 cells"),
                ("nan.pfm", pfm([[0.0] * 10] * 5 + [[0.0] * 9 + [math.nan]]), "it holds nan in cell (9, 5)"),
                ("less.npy", npy([[0.0] * 10] * 2 + [[-1.0] * 10] * 4), "it holds -1 in cell (0, 2)"),
                ("word.pgm", "P9 10 6", "this is no PNG, PGM, PBM or BMP image"),
                ("none.yaml", yaml("lost.pgm", 1, (0, 0, 0)), "none.yaml, line 1: its image "),
                ("same.yaml", yaml("size.pgm", 1, (0, 0, 0)), "it has 10 x 5 values"),
                ("lost.npy", None, "cannot be opened")):
            if content is not None:
                self.write(name, content)
            self.refused(self.plan("--cost", name), 3, problem)
            self.refused(self.run_program("check-proof", "small.map", "small.map", "--cost", name), 3, problem)

    def test_usage(self):
        self.write("a.pgm", pgm([[1] * 10] * 6))
        self.write("full.pgm", pgm([[255] * 10] * 6))
        for options, words in (
                (("--cost", "a.pgm*x"), ("--cost", "x")),
                (("--cost", "a.pgm*-1"), ("--cost", "-1")),
                (("--inflation", "3"), ("--inflation",)),
                (("--inflation", "3,-1"), ("scaling",)),
                (("--inflation", "3,1,2,4"), ("--inflation",)),
                (("--moves", "4"), ("--moves",)),
                (("--inflatoin", "3,1"), ("--inflation",)),
                (("--cost", "a.pgm", "--algorithm", "grid-ga"), ("--cost is for exact", "grid-ga")),
                (("--cost", "a.pgm", "--algorithm", "acs", "--corners", "allow"), ("squeeze",)),
                (("--cost", "a.pgm", "--via", "3,3", "-o", "p.proof.json"), ("--via",)),
                (("--cost", "*2"), ("names no file",)),
                (("--moves", "8", "--radius", "1"), ("--moves is for a point",)),
                (("-o", "x.proof.json"), ("of a proof",)),
                (("--moves", "8", "-o", "x.proof.json"), ("of a proof",))):
            self.refused(self.plan(*options), 2, *words)
        self.refused(self.plan("--cost", "a.pgm", "-o", "a.pgm"), 2, "a.pgm")
        self.ended(self.plan("--cost", "a.pgm", "-o", "none.proof.json", goal="4,2"), 5, "nothing is proven")
        self.assertFalse(os.path.exists(self.path("none.proof.json")))
        self.refused(self.plan("--cost", "full.pgm*1e6"), 2, "use a smaller factor")


if __name__ == "__main__":
    unittest.main()
