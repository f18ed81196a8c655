"""study FILE, study run, tune, --preset FILE: one's own studies."""
import os
import random
import signal
import subprocess
import unittest

from program import MAPS, ProgramTest, tuning

# 16 points of 4 factors and 2 others, on 3 questions with 2 seeds: 108 runs.
SWEEP = """
summary: how much trail should stay
seeds: 1..2
maps:
  blobs: {kind: blobs, size: 120x90, density: 0.33, seeds: [1..2]}
  own: small.map
contenders:
  - {name: default, algorithm: as, sweep: no}
  - {name: exact, algorithm: exact}
  - {name: as, algorithm: as}
sweep:
  design: grid
  factors:
    persistence: [0.5, 0.9]
    ants: {from: 5, to: 20, levels: 2}
    beta: [1, 5]
    walk_cut: [none, own-cells]
budget: {steps: 150000}
targets: [0.01, 0.1]
questions:
  - {map: blobs, draw: 1}
  - {map: own, start: [0, 0], goal: [9, 5]}
claims:
  - {text: the trail is of use, test: less, a: as-1, b: [default, as-2]}
"""

TUNING = tuning()


class OwnStudy(ProgramTest):
    def wait_for(self, process, reached):
        """Until `reached()`, or the process has ended."""
        while not reached():
            try:
                process.wait(timeout=0.005)
                return
            except subprocess.TimeoutExpired:
                pass

    def runs_of(self, folder):
        """The table of a study's runs, but for the time that they took."""
        return [{k: v for k, v in row.items() if k != "seconds"}
                for row in self.rows(folder + "/runs.csv")]

    def runs_done(self, folder):
        return sum(f.endswith(".json") for _, _, files in os.walk(self.path(folder)) for f in files)

    def test_a_sweep_killed_at_random_ends_with_the_same_table(self):
        self.write("s.yaml", SWEEP.replace("[1..2]", "1..2").replace("150000", "50000"))
        whole = self.run_program("study", "s.yaml", "-o", "whole", "--threads", 2)
        self.assertEqual((whole.code, whole.out), (0, "whole/report.md\n"), whole.err)
        self.assertRegex(whole.err, r"lasius: s: 108 runs, about \d+ (s|min) with 2 threads")
        expected = self.runs_of("whole")
        self.assertEqual(len(expected), 108)

        draw = random.Random(20)
        for kill in range(8):
            begun = self.runs_done("killed/runs")
            wanted = begun + draw.randint(1, 4)  # one more at least: by then it listens to signals
            process = self.start_program("study", "s.yaml", "-o", "killed", "--threads", 1 + kill % 2)
            self.wait_for(process, lambda: self.runs_done("killed/runs") >= wanted)
            sent = draw.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM])
            process.send_signal(sent)
            process.communicate()
            self.assertEqual(process.returncode, -9 if sent == signal.SIGKILL else 130)
        self.assertLess(self.runs_done("killed/runs"), 108)
        # A run's file that is torn or of other parameters is done again.
        torn = next(os.path.join(at, f) for at, _, files in os.walk(self.path("killed/runs"))
                    for f in files)
        self.write(os.path.relpath(torn, self.folder), '{"key": "lasius')
        self.ended(self.run_program("study", "s.yaml", "-o", "killed", "--threads", 5), 0)
        self.assertEqual(self.runs_of("killed"), expected)
        self.assertEqual(self.read("killed/claims.csv"), self.read("whole/claims.csv"))
        self.quiet(self.run_program("study", "s.yaml", "-o", "killed", "-q"))

    def test_every_run_is_a_row_with_its_factors(self):
        self.write("s.yaml", SWEEP.replace("[1..2]", "1").replace("1..2", "1").replace("150000", "20000"))
        self.ended(self.run_program("study", "s.yaml", "-o", "o", "--seeds", "3..4"), 0)
        rows = self.runs_of("o")
        self.assertEqual(len(rows), 18 * 2 * 2)
        self.assertEqual({r["seed"] for r in rows}, {"3", "4"})
        self.assertEqual({r["map"] for r in rows},
                         {"blobs 120x90 0.33 1", os.path.realpath(self.path("small.map"))})
        swept = [r for r in rows if r["contender"] == "as-6"]
        self.assertEqual({(r["set.persistence"], r["set.ants"], r["set.beta"], r["set.walk_cut"])
                          for r in swept}, {("0.5", "20", "1", "own-cells")})
        for row in rows:
            gap = float(row["length"]) / float(row["optimum"]) - 1
            self.assertAlmostEqual(float(row["gap"]), gap, places=6)
            if row["contender"] == "exact":
                self.assertEqual((row["gap"], row["set.ants"]), ("0.000000000", ""))
            else:
                self.assertEqual(row["status"], "limit")
                self.assertGreaterEqual(int(row["steps"]), 20000)
        page = self.read("o/report.md").decode()
        self.holds(page, "What each parameter does", "| walk_cut | own-cells |",
                   "`lasius study s.yaml --seeds 3..4`", "within 10.0% of the optimum", "the trail is of use")

    def test_json_is_the_same_format(self):
        self.write("s.json", '{"contenders": [{"name": "as", "algorithm": "as", "set": '
                   '{"iterations": 5}}], "seeds": 2, "questions": [{"map": "small.map", '
                   '"start": [0, 0], "goal": [9, 5]}]}')
        run = self.run_program("study", "s.json")
        self.assertEqual((run.code, run.out), (0, "study-s/report.md\n"), run.err)
        self.assertEqual(len(self.runs_of("study-s")), 2)

    def test_refuses_a_file_with_its_line_and_key(self):
        good = SWEEP.replace("[1..2]", "1")
        for old, new, line, key, nearest in (
                ("seeds: 1..2", "sedes: 1..2", 3, "'sedes'", '"seeds"'),
                ("algorithm: exact", "algorithm: exakt", 9, "'algorithm'", '"exact"'),
                ("persistence:", "persistance:", 14, "'persistance'", '"persistence"'),
                ("design: grid", "design: gird", 12, "'design'", '"grid"'),
                ("map: own", "map: onw", 22, "'map'", '"own"'),
                ("goal: [9, 5]", "goal: [9, 6]", 22, "outside", "9,5"),
                ("test: less", "test: les", 24, "'test'", '"less"'),
                ("seeds: 1", "compare: []\nseeds: 1", 3, "'compare' is empty", "name contenders"),
                ("seeds: 1", "compare: [exact, exact]\nseeds: 1", 3, "'compare' has \"exact\" twice", "name it once"),
                ("[0.5, 0.9]", "[0.5, 0.9", 15, "neither YAML nor JSON", "correct")):
            self.assertIn(old, good)
            self.write("bad.yaml", good.replace(old, new, 1))
            run = self.run_program("study", "bad.yaml", "-o", "bad")
            self.refused(run, 3, f"bad.yaml, line {line}: ", key, nearest)
        self.refused(self.run_program("study", "none.yaml"), 3, "none.yaml")
        self.write("bad.yaml", good.replace("small.map", "none.map"))
        self.refused(self.run_program("study", "bad.yaml", "-o", "bad"), 3, "bad.yaml, line 22: ",
                     " on none.map: cannot be opened")
        self.write("file", "")
        self.write("good.yaml", good)
        self.refused(self.run_program("study", "good.yaml", "-o", "file/x"), 7, "file/x")

    SHORT = ("study", "run", "small.map", "--start", "0,0", "--goal", "9,5")

    def test_the_short_form_is_a_study(self):
        run = self.run_program(*self.SHORT, "--algorithm", "as,mmas", "--set", "persistence=0.5,0.9",
                               "--set", "iterations=5", "--seeds", "1..3", "-o", "r")
        self.assertEqual((run.code, run.out), (0, "r/report.md\n"), run.err)
        rows = self.runs_of("r")
        self.assertEqual(len(rows), 12)
        self.assertEqual({r["set.persistence"] for r in rows}, {"0.5", "0.9"})
        self.assertEqual({r["iterations"] for r in rows}, {"5"})
        lost = self.run_program(*self.SHORT, "--algorithm", "as,mmas", "--set", "evaporation=0.5,0.1",
                                "--set", "iterations=5", "--seeds", "1..3", "-o", "lost")
        self.assertEqual(lost.code, 0, lost.err)
        self.assertEqual([r["length"] for r in self.runs_of("lost")], [r["length"] for r in rows])
        # Its file says the same.
        self.ended(self.run_program("study", "r/study.yaml", "-o", "r2"), 0)
        self.assertEqual(self.runs_of("r2"), rows)
        # A run of plan with the same numbers is the same run.
        plan = self.plan("--set", "persistence=0.9", "--iterations", 5, "--seed", 2, "--json",
                         "--algorithm", "mmas")
        row = next(r for r in rows if r["contender"] == "mmas-2" and r["seed"] == "2")
        self.assertAlmostEqual(plan.json["length"], float(row["length"]), places=8)

    def test_a_radius_and_metres(self):
        self.write("m.pgm", b"P5 20 12 255\n" + (b"\xfe" * 9 + b"\x00" + b"\xfe" * 10) * 4 + b"\xfe" * 160)
        self.write("m.yaml", "image: m.pgm\nresolution: 0.5\norigin: [-2, 1, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        world = ("--start=-0.25,4.25", "--goal=6.25,4.75", "--frame", "world", "--radius", "0.6")
        cells = ("--start=3,5", "--goal=16,4", "--radius", "1.2")
        plan = self.run_program("plan", "m.yaml", *world, "--json", "--algorithm", "exact").json
        for name, ends in (("w", world), ("c", cells)):
            form = ("study", "run", "m.yaml", *ends, "--algorithm", "exact", "--seeds", "1", "-o", name)
            self.ended(self.run_program(*form), 0)
            self.assertAlmostEqual(float(self.runs_of(name)[0]["length"]), plan["length"], places=8)
        self.assertEqual(self.runs_of("w")[0]["length"], self.runs_of("c")[0]["length"])
        self.assertIn('"frame": "world"', self.read("w/study.yaml").decode().replace('":"', '": "'))
        self.refused(self.run_program("study", "run", "small.map", *world, "--algorithm", "as"), 3, "gives no frame")
        self.refused(self.run_program("study", "run", "m.yaml", *cells[:2], "--radius=-1", "--algorithm", "as"), 2, "--radius")
        self.refused(self.run_program("study", "fan2004", "--radius", "1"), 2, "--radius is for")
        # Of a point the cell that holds it, as drives have it.
        self.ended(self.run_program("study", "run", "m.yaml", "--start=3.75,5.0", "--goal=16.5,4.5", *cells[2:],
                                    "--algorithm", "exact", "--seeds", "1", "-o", "p"), 0)
        self.assertEqual(self.read("p/study.yaml"), self.read("c/study.yaml"))

    TWO = """
seeds: 2..2
contenders:
  - {name: mmas, algorithm: mmas, set: {iterations: 5}}
  - {name: exact, algorithm: exact}
questions:
"""

    def test_costs_of_inflation_take_the_place_of_lengths(self):
        self.write("s.yaml", self.TWO + """  - {map: small.map, start: [0, 0], goal: [9, 5], inflation: [3, 0.7, 4]}
""")
        self.ended(self.run_program("study", "s.yaml", "-o", "s"), 0)
        mmas, exact = self.runs_of("s")
        options = ("--inflation", "3,0.7,4")
        plan = self.plan(*options, "--algorithm", "mmas", "--iterations", 5, "--seed", 2, "--gap", "--json").json
        self.assertAlmostEqual(float(mmas["length"]), plan["cost"], places=8)
        self.assertAlmostEqual(float(mmas["optimum"]), plan["optimum"], places=8)
        self.assertAlmostEqual(float(mmas["own_limit"]), self.plan(*options, "--algorithm", "exact", "--moves", 8, "--json").json["cost"], places=8)
        self.assertAlmostEqual(float(exact["length"]), self.plan(*options, "--algorithm", "exact", "--json").json["cost"], places=8)
        self.write("bad.yaml", self.read("s.yaml").decode().replace("[3, 0.7, 4]", "[3]"))
        self.refused(self.run_program("study", "bad.yaml", "-o", "b"), 3, "line 7", "[RADIUS, SCALING]")

    def test_costs_of_layers(self):
        self.write("a.pgm", "P2 10 6 4 " + " ".join(str((3 * x + 5 * y) % 5) for y in range(6) for x in range(10)))
        self.write("s.yaml", self.TWO + """  - {name: a, map: small.map, start: [0, 0], goal: [9, 5], cost: a.pgm*3}
  - {name: b, map: small.map, start: [0, 0], goal: [9, 5], cost: [a.pgm*3, a.pgm], inflation: [3, 0.7, 4]}
""")
        self.ended(self.run_program("study", "s.yaml", "-o", "s"), 0)
        for name, options in (("a", ("--cost", "a.pgm*3")), ("b", ("--cost", "a.pgm*4", "--inflation", "3,0.7,4"))):
            mmas, exact = [run for run in self.runs_of("s") if run["question"] == name]
            plan = self.plan(*options, "--algorithm", "mmas", "--iterations", 5, "--seed", 2, "--gap", "--json").json
            self.assertAlmostEqual(float(mmas["length"]), plan["cost"], places=8)
            self.assertAlmostEqual(float(mmas["optimum"]), plan["optimum"], places=8)
            self.assertAlmostEqual(float(exact["length"]), self.plan(*options, "--algorithm", "exact", "--json").json["cost"], places=8)
        self.ended(self.run_program("study", "run", "small.map", "--start", "0,0", "--goal", "9,5", "--algorithm", "exact",
                                    "--cost", "a.pgm*3", "--seeds", "1", "-o", "run"), 0)
        alone, = self.runs_of("run")
        self.assertAlmostEqual(float(alone["length"]),
                               self.plan("--cost", "a.pgm*3", "--algorithm", "exact", "--json").json["cost"], places=8)
        for bad, says in (("a.pgm*-1", "no layer of costs"), ("none.pgm", "none.pgm")):
            self.write("bad.yaml", self.read("s.yaml").decode().replace("cost: a.pgm*3", f"cost: {bad}"))
            self.refused(self.run_program("study", "bad.yaml", "-o", "b"), 3, says)

    def test_what_no_contender_reads_is_told_once(self):
        run = (*self.SHORT, "--algorithm", "as", "--set", "elite_weight=2,3", "--set", "iterations=2", "--seeds", "1")
        told = "elite_weight of as has no effect: it is read only with update=elitist"
        self.assertEqual(self.ended(self.run_program(*run), 0).err.count(told), 1)
        self.assertNotIn("no effect", self.run_program(*run, "--set", "update=elitist,ant-system", "-o", "s").err)
        self.quiet(self.run_program(*run, "-q"))
        self.write("p.yaml", "algorithm: as\nset: {elite_weight: 2}\n")
        self.assertIn("the preset's elite_weight=2 has no effect", self.run_program(
            "drive", *self.SHORT[2:], "--preset", "p.yaml", "--algorithm", "as").err)

    def test_the_short_form_refuses(self):
        form = (*self.SHORT, "-o", "r")
        self.refused(self.run_program(*form), 2, "--algorithm")
        for words, told in ((("--algorithm", "as,mmass"), '"mmas"'), (("--algorithm", "as,"), "missing"),
                            (("--algorithm", "as", "--set", "persistance=1"), '"persistence"'),
                            (("--algorithm", "as", "--set", "ants=4,x"), "ants"),
                            (("--algorithm", "as", "--set", "ants"), "NAME=VALUE"),
                            (("--algorithm", "as", "--set", "ants=3,"), "--set ants=3,: a value is missing"),
                            (("--algorithm", "as,as"), "--algorithm as,as: as is given twice"),
                            (("--algorithm", "as", "--set", "ants=3,3"), "--set ants=3,3: 3 is given twice"),
                            (("--algorithm", "as,fan2004", "--preset", "book"), "fan2004 has no preset book"),
                            (("--algorithm", "as", "--seeds", "0"), "--seeds"),
                            (("--algorithm", "as", "--seeds", "3..1"), "--seeds"),
                            (("--algorithm", "as", "--preset", "bok"), '"book"'),
                            (("--algorithm", "as", "--steps", "0"), "--steps")):
            self.refused(self.run_program(*form, *words), 2, told)
        self.refused(self.run_program("study", "run", "--algorithm", "as"), 2, "MAP")
        self.refused(self.run_program("study", "run", "w.wkt", *form[3:], "--algorithm", "as"), 2, "polygon world")
        self.refused(self.run_program("study", "fan2004", "--start", "1,1"), 2, "--start")
        blocked = ("study", "run", "small.map", "--goal", "9,5", "--algorithm", "as", "-o", "r")
        self.refused(self.run_program(*blocked, "--start", "3,2"), 4, "3,2", "nearest free cell")
        self.refused(self.run_program(*blocked, "--start", "99999999999,2"), 4, "outside")
        self.refused(self.run_program(*blocked, "--start", "0,0", "--radius", "1"), 4,
                     "start 0,0 is nearer to what is blocked than the radius of 1: the nearest free cell is ")
        self.refused(self.run_program(*blocked, "--start", "3,2", "--radius", "0.5"), 4, "start 3,2 is blocked")
        none = ("study", "run", "none.map", "--start", "0,0", "--goal", "9,5", "--algorithm", "as")
        self.refused(self.run_program(*none), 3, "lasius: none.map: ")
        self.assertFalse(any(os.path.exists(self.path(name)) for name in ("r", "study-small", "study-none")))

    def test_tune_finds_what_is_planted_and_plan_takes_it(self):
        self.write("t.yaml", TUNING)
        run = self.run_program("tune", "t.yaml", "-o", "t")
        self.assertEqual((run.code, run.out), (0, "t/preset.yaml\n"), run.err)
        self.holds(run.err, "5 candidates", "better")
        preset = self.read("t/preset.yaml").decode()
        self.holds(preset, "algorithm: mmas\n", 'ants: "10"\n', 'iterations: "50"\n')
        self.holds(self.read("t/report.md").decode(), "| blobs |", "| default |", "F-race")
        # The same again, from another start, after an interruption.
        process = self.start_program("tune", "t.yaml", "-o", "t2", "--threads", 1)
        self.wait_for(process, lambda: self.runs_done("t2/runs") >= 12)
        self.interrupted(process, timeout=None)
        self.holds(self.read("t2/preset.yaml").decode(), "interrupted", "algorithm: mmas")
        self.assertEqual(self.run_program("tune", "t.yaml", "-o", "t2").code, 0)
        for name in ("preset.yaml", "race.csv", "candidates.csv", "report.md"):
            self.assertEqual(self.read("t2/" + name), self.read("t/" + name))

        plan = self.run_program("plan", "small.map", "--start", "0,0", "--goal", "9,5", "--preset",
                                "t/preset.yaml", "--algorithm", "mmas", "--json")
        self.assertEqual(plan.code, 0, plan.err)
        self.assertEqual(plan.json["algorithm"], "mmas")
        self.assertEqual((plan.json["parameters"]["ants"], plan.json["parameters"]["iterations"]), (10, 50))
        # An option wins over a preset; the algorithm is the preset's.
        words = ("small.map", "--preset", "t/preset.yaml", "--ants", 3)
        drive = self.run_program("drive", *words, "--start", "0,0", "--goal", "9,5", "--json")
        self.assertEqual((drive.json["algorithm"], drive.json["parameters"]["ants"]), ("mmas", 3))
        study = self.run_program(*self.SHORT, "--preset", "t/preset.yaml", "--seeds", 1, "-o", "p")
        self.assertEqual(study.code, 0, study.err)
        self.assertEqual([(r["algorithm"], r["iterations"]) for r in self.runs_of("p")],
                         [("mmas", "50")])
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n")
        batch = self.run_program("batch", "small.map", "q.tsv", "--preset", "t/preset.yaml",
                                 "--algorithm", "mmas")
        self.assertEqual(batch.lines[0]["parameters"]["iterations"], 50)

    def test_presets_and_tunings_are_refused_with_line_and_key(self):
        self.write("p.yaml", "algorithm: mmas\nset:\n  persistance: 0.5\n")
        self.refused(self.plan("--preset", "p.yaml", "--algorithm", "mmas"), 3, "p.yaml, line 3: ",
                     '"persistence"')
        self.write("p.yaml", "algorithm: mmas\n")
        self.refused(self.plan("--preset", "p.yaml", "--algorithm", "as"), 2, "mmas")
        self.write("p.yaml", "algorithm: as\nset: {evaporation: 0.3, persistence: 0.2}\n")
        self.refused(self.plan("--preset", "p.yaml"), 3, "p.yaml, line 2: ", "'evaporation'", "keep one")
        self.refused(self.plan("--preset", "none.yaml", "--algorithm", "as"), 3, "none.yaml")
        self.refused(self.plan("--preset", "bok", "--algorithm", "as"), 2, '"book"')
        for old, new, line, told in (("training:", "trainig:", 8, '"training"'),
                                     ("candidates: 8", "candidates: 1", 5, "'candidates'"),
                                     ("ants: [1, 10]", "nats: [1, 10]", 4, '"ants"'),
                                     ("ants: [1, 10]", "persistence: {from: 0.5, to: 1.01}", 4, "'to' is \"1.01\""),
                                     ("mmas", "mms", 2, '"mmas"'),
                                     ("mmas", "maklink-acs", 2, "'algorithm'"),
                                     ("mmas", "exact", 3, "'ants'")):
            self.write("t.yaml", TUNING.replace(old, new, 1))
            self.refused(self.run_program("tune", "t.yaml"), 3, f"t.yaml, line {line}: ", told)
        self.refused(self.run_program("tune", "none.yaml"), 3, "none.yaml")
        os.mkdir(self.path("here"))
        self.write("here/preset.yaml", "algorithm: mmas\n")
        self.write("here/t.yaml", TUNING.replace("algorithm: mmas", "algorithm: mmas\npreset: preset.yaml", 1))
        self.refused(self.run_program("tune", "here/t.yaml", "-o", "here"), 2, "preset.yaml", "one file")
        self.write("t.yaml", TUNING)
        self.write("file", "")
        self.refused(self.run_program("tune", "t.yaml", "-o", "file/x"), 7, "file/x")

    def test_the_programs_maps_are_found(self):
        self.write("s.yaml", "contenders: [{name: as, algorithm: as, set: {iterations: 2}}]\n"
                   "seeds: 1\nquestions: [{map: grid20a.map, draw: 1}]\n")
        self.ended(self.run_program("study", "s.yaml", "--maps", MAPS), 0)
        self.assertEqual(self.runs_of("study-s")[0]["map"], "grid20a.map")


if __name__ == "__main__":
    unittest.main()
