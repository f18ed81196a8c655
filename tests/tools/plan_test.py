"""plan: exit codes, the JSON of a result, the plain output, files."""
import json
import math
import os
import subprocess
import unittest

from program import MAPS, ProgramTest

KEYS = ["format", "version", "map", "algorithm", "start", "goal", "seed", "threads", "parameters",
        "status", "error", "length", "path", "iterations", "best", "mean", "arrived",
        "lower_bound", "gap", "optimal", "elapsed_ms"]
WALKS = ["raw_best", "cut_mean", "cut_best", "iteration_best", "steps", "band", "trail_entropy"]  # of a colony's iterations
WITH_WALKS = KEYS[:17] + WALKS + KEYS[17:]
FAN = dict(map_file=os.path.join(MAPS, "fan400x200.map"), start="14,14", goal="380,179")


def path_length(path):
    return sum(math.dist(p, q) for p, q in zip(path, path[1:]))


class ExitCodes(ProgramTest):
    def test_found(self):
        self.assertEqual(self.plan().code, 0)

    def test_a_missing_or_broken_map(self):
        self.refused(self.plan(map_file="missing.map"), 3, "missing.map")
        self.refused(self.plan(map_file="."), 3)
        for name, content in (("empty.map", ""), ("short.map", "type octile\nheight 6\nwidth 10\nmap\n...\n"),
                              ("text.map", "this is no map\n"), ("size.map", "type octile\nheight x\n"),
                              ("cut.pbm", b"P4\n64 64\n\0\0")):
            with self.subTest(name=name):
                self.write(name, content)
                self.refused(self.plan(map_file=name), 3, name)

    def test_start_or_goal_outside_or_blocked(self):
        cases = [("3,1", "0,0", "start", "3, 0"), ("0,0", "3,1", "goal", "3, 0"),
                 ("-1,5", "0,0", "start", "0, 5"), ("0,0", "10,5", "goal", "9, 5"),
                 ("0,0", "99999999999,2", "goal", "9, 2"), ("0,-2147483648", "0,0", "start", "0, 0")]
        for start, goal, which, free in cases:
            with self.subTest(start=start, goal=goal):
                run = self.plan(start=start, goal=goal)
                self.assertEqual((run.code, run.out), (4, "invalid\n"))
                self.assertIn(which, run.err)
                self.assertIn(f"nearest free cell is ({free})", run.err)

    def test_a_whole_number_of_any_size_is_a_cell(self):
        for number in (2147483647, 2147483648, -4294967297, 1 << 53):
            run = self.plan("--json", start=f"{number},3")
            self.assertEqual((run.code, run.json["start"]), (4, [number, 3]))
            self.assertIn(f"start ({number}, 3) is outside", run.json["error"])
        self.assertEqual(self.plan(start="3," + "9" * 400).code, 4)

    def test_unreachable_says_so_and_invalid_beats_it(self):
        run = self.plan(goal="4,2")
        self.assertEqual((run.code, run.out), (5, "unreachable\n"))
        self.assertIn("(0, 0)", run.err)
        self.assertIn("(4, 2)", run.err)
        self.assertEqual(self.plan(start="3,1", goal="4,2").code, 4)

    def test_grown_obstacles_are_named(self):
        for algorithm in "as", "exact":
            self.ended(self.plan("--radius", "0.6", "--algorithm", algorithm), 4, "is too near to the edge of the map, 0.5 cells away")

    def test_no_path_within_the_iterations(self):
        run = self.plan("--iterations", "0")
        self.assertEqual((run.code, run.out), (6, "no_path\n"))
        self.assertIn("0 iterations", run.err)

    def test_a_time_limit(self):
        spent = self.plan("--time-limit", "0", **FAN)
        self.assertEqual((spent.code, spent.out), (6, "limit\n"))
        self.assertIn("after 0 iterations", spent.err)
        exact = self.plan("--time-limit", "0", "--algorithm", "exact", **FAN)
        self.assertRegex(exact.err, "the time limit ended the run, (no path yet|the best)")
        kept = self.plan("--iterations", "1000000000", "--time-limit", "0.2", "--json")
        self.assertEqual(kept.code, 0)
        self.assertEqual(kept.json["status"], "limit")
        self.assertAlmostEqual(path_length(kept.json["path"]), kept.json["length"], places=9)
        self.assertEqual(len(kept.json["best"]), kept.json["iterations"])

    def test_an_output_that_cannot_be_written(self):
        self.refused(self.plan("-o", "no/folder/x.json"), 7, "no/folder")
        os.mkdir(self.path("x.json"))
        self.refused(self.plan("-o", "x.json"), 7, "x.json")

    def test_a_world_frame_needs_a_ros_map(self):
        self.refused(self.plan("--frame", "world"), 2, "frame", ".yaml")


class Json(ProgramTest):
    def test_keys_types_and_order(self):
        run = self.plan("--json", "--iterations", "7", "--seed", "5", "--threads", "2")
        result = run.json
        self.assertEqual(list(result), WITH_WALKS)
        self.assertEqual(run.out.count("\n"), 1)
        self.assertEqual(result["format"], "lasius-plan/1")
        self.assertEqual(list(result["map"]), ["file", "hash", "width", "height"])
        self.assertEqual((result["map"]["file"], result["map"]["width"], result["map"]["height"]),
                         ("small.map", 10, 6))
        self.assertRegex(result["map"]["hash"], r"^[0-9a-f]{16}$")
        self.assertEqual((result["start"], result["goal"]), ([0, 0], [9, 5]))
        self.assertEqual((result["seed"], result["threads"]), (5, 2))
        self.assertEqual((result["status"], result["error"]), ("solved", None))
        self.assertEqual((result["path"][0], result["path"][-1]), ([0.5, 0.5], [9.5, 5.5]))
        self.assertAlmostEqual(path_length(result["path"]), result["length"], places=9)
        self.assertEqual(result["iterations"], 7)
        for key in ("best", "mean", "arrived"):
            self.assertEqual(len(result[key]), 7)
        self.assertEqual(result["best"], sorted(result["best"], reverse=True))
        self.assertEqual(result["best"][-1], result["length"])
        self.assertTrue(all(isinstance(n, int) and 0 <= n <= 10 for n in result["arrived"]))
        self.assertEqual(result["parameters"]["iterations"], 7)
        self.assertIs(result["optimal"], False)

    def test_results_without_a_path(self):
        for arguments, status in ((dict(goal="4,2"), "unreachable"), (dict(goal="3,1"), "invalid")):
            with self.subTest(status=status):
                result = self.plan("--json", **arguments).json
                self.assertEqual(list(result), KEYS)
                self.assertEqual((result["status"], result["length"], result["path"]),
                                 (status, None, None))
                self.assertIsInstance(result["error"], str)
                self.assertEqual((result["iterations"], result["best"]), (0, []))
        self.assertIn("nearest free cell is (3, 0)", self.plan("--json", goal="3,1").json["error"])

    def test_start_is_goal(self):
        result = self.plan("--json", start="2,2", goal="2,2").json
        self.assertEqual((result["status"], result["length"], result["path"]),
                         ("solved", 0, [[2.5, 2.5]]))

    def test_iterations_without_an_arrival_are_null(self):
        # Ants that die in dead ends, on a map that is one: few or none arrive.
        rows = ["." * 40 if y % 2 == 0 else "." * 39 + "@" if y % 4 == 1 else "@" + "." * 39
                for y in range(40)]
        self.write("dead.map", "type octile\nheight 40\nwidth 40\nmap\n" + "\n".join(rows) + "\n")
        result = self.plan("--json", "--set", "dead_end=kill", "--ants", "1", "--iterations", "20",
                           "--algorithm", "as", "--set", "beta=0", map_file="dead.map",
                           goal="39,39").json
        for best, mean, arrived in zip(result["best"], result["mean"], result["arrived"]):
            self.assertEqual(mean is None, arrived == 0)
            if best is None:
                self.assertEqual(arrived, 0)
        self.assertIn(0, result["arrived"])

    def test_equal_runs_differ_in_threads_and_time_only(self):
        runs = [self.plan("--json", "--iterations", "12", "--threads", threads, **FAN).json
                for threads in ("1", "2", "5")]
        for run in runs:
            del run["threads"], run["elapsed_ms"]
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(runs[0], runs[2])
        other = self.plan("--json", "--iterations", "12", "--seed", "2", **FAN).json
        self.assertNotEqual(other["mean"], runs[0]["mean"])

    def test_numbers_round_trip(self):
        out = self.plan("--json", "--iterations", "5", **FAN).out
        again = json.dumps(json.loads(out), separators=(",", ":"))
        self.assertEqual(json.loads(again), json.loads(out))
        self.assertEqual(again, out.rstrip("\n"))

    def test_parameters_are_recorded(self):
        result = self.plan("--json", "--set", "persistence=0.123456789", "--ants", "3", "--polish",
                           "none", "--set", "alpha=2.5", "--time-limit", "100", "--target-gap",
                           "1").json
        expected = {"persistence": 0.123456789, "ants": 3, "polish": "none", "alpha": 2.5,
                    "time_limit": 100, "target_gap": 0.01, "radius": 0, "unknown": "blocked",
                    "frame": "cell", "corners": "forbid", "neighbours": 4}
        self.assertEqual({key: result["parameters"][key] for key in expected}, expected)

    def test_the_library_reads_the_parameters(self):
        """params_from_json passes over all that is no parameter, whatever was asked."""
        self.write("metric.pgm", "P2\n10 6\n255\n" + "255 " * 60)
        self.write("metric.yaml", "image: metric.pgm\nresolution: 1\norigin: [0, 0, 0]\n"
                   "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        metric = {"map_file": "metric.yaml", "start": "0.5,0.5"}
        for words, where in ((["--iterations", "2"], {}),
                             (["--ants", "7", "--radius", "0.25", "--time-limit", "9", "--gap"],
                              {"start": "1,1", "goal": "1,4"}),
                             (["--algorithm", "exact", "--prepare", "--target-gap", "0.1"], {}),
                             (["--unknown-free", "--frame", "world"], metric)):
            with self.subTest(words=words):
                saved = self.ended(self.plan("--json", *words, **where), 0)
                run = subprocess.run([os.environ["LASIUS_READ_PARAMS"]], input=saved.out,
                                     capture_output=True, text=True, check=False)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                read = json.loads(run.stdout)["parameters"]
                self.assertEqual(read, {name: saved.json["parameters"][name] for name in read})
                self.assertEqual("ants" in read, saved.json["algorithm"] != "exact")

    def test_set_wins_over_the_options_own_name(self):
        result = self.plan("--json", "--set", "ants=4", "--ants", "3").json
        self.assertEqual(result["parameters"]["ants"], 4)

    def test_gap_adds_the_optimum(self):
        result = self.plan("--json", "--gap").json
        self.assertEqual([key for key in result if key not in WITH_WALKS],
                         ["optimum", "optimum_gap", "grid_optimum", "grid_gap"])
        self.assertEqual(result["grid_optimum"], 14)  # by 4 moves
        self.assertAlmostEqual(result["grid_gap"], min(result["cut_best"]) / 14 - 1, places=12)
        for name in ("grid-ga", "terminal-index"):  # the walk of one, the answer of many ants
            walk = self.plan("--json", "--gap", "--algorithm", name, "--polish", "none",
                             map_file=os.path.join(MAPS, "grid20a.map"), start="0,0",
                             goal="19,19").json
            self.assertAlmostEqual(walk["grid_gap"], walk["length"] / walk["grid_optimum"] - 1,
                                   places=12)

    def test_gap_adds_the_optimum_of_the_own_moves(self):
        fan = self.plan("--json", "--gap", "--iterations", "2", **FAN).json
        four = fan["grid_optimum"]
        self.assertEqual(four, int(four))
        self.assertLess(fan["optimum"], four)
        self.assertLessEqual(four, fan["mean"][0])
        eight = self.plan("--json", "--gap", "--iterations", "2", "--neighbours", "8",
                          **FAN).json["grid_optimum"]
        self.assertLess(fan["optimum"], eight)
        self.assertLess(eight, four)

    def test_gap_has_a_time_limit_too(self):
        result = self.plan("--json", "--gap", "--time-limit", "0", **FAN).json
        self.assertEqual((result["status"], result["optimum"], result["optimum_gap"],
                          result["grid_optimum"]), ("limit", None, None, None))
        result = self.plan("--json", "--gap", "--time-limit", "1000", "--iterations", "2",
                           **FAN).json
        self.assertGreater(result["optimum_gap"], 0)

    def test_no_gap_where_cells_allow_more_than_the_plane(self):
        squeezing = ("--gap", "--iterations", "2", "--corners", "allow", "--neighbours", "8")
        result = self.plan("--json", *squeezing, **FAN).json
        self.assertEqual((result["optimum"], result["optimum_gap"]), (None, None))
        self.assertGreater(result["grid_optimum"], 0)
        self.assertIn("optimum unknown; of walks by its own moves", self.plan(*squeezing, **FAN).err)
        nowhere = self.plan("--json", *squeezing, start="0,0", goal="0,0").json
        self.assertEqual((nowhere["optimum"], nowhere["optimum_gap"]), (0, 0))
        upright = self.plan("--json", *squeezing[:-1], "4", **FAN).json  # passes no corner
        self.assertGreater(upright["optimum_gap"], 0)

    def test_gap_is_told_beside_the_text(self):
        run = self.plan("--gap", "--iterations", "2", **FAN)
        self.assertEqual(run.out.splitlines()[0], "solved")
        self.assertRegex(run.err, r"optimum [0-9.]+ .*; of walks by its own moves [0-9.]+ "
                         r"\(its shortest walk: \+[0-9.]+%\)")
        self.assertEqual(self.plan("--gap", "-q", "--iterations", "2", **FAN).err, "")


class Exact(ProgramTest):
    """The default algorithm."""

    def exact(self, *arguments):
        return self.plan("--algorithm", "exact", "--json", *arguments)

    def test_it_is_the_default(self):
        run = self.run_program("algorithms", "--json")
        self.assertEqual(run.json[0]["name"] if isinstance(run.json, list)
                         else run.json["algorithms"][0]["name"], "exact")

    def test_its_path_is_proven(self):
        result = self.exact().json
        self.assertEqual((result["status"], result["optimal"], result["gap"]), ("solved", True, 0))
        self.assertEqual(result["length"], result["lower_bound"])
        self.assertEqual((result["iterations"], result["best"], result["mean"]), (0, [], []))

    def test_gap_adds_the_optimum_to_any_algorithm(self):
        best = self.exact().json["length"]
        own = self.exact("--gap").json
        self.assertEqual((own["optimum"], own["grid_optimum"], own["optimum_gap"]), (best, best, 0))
        result = self.plan("--gap", "--json").json
        self.assertEqual(result["optimum"], best)
        self.assertAlmostEqual(result["optimum_gap"], result["length"] / best - 1)

    def test_parameters_of_others_are_named(self):
        self.refused(self.exact("--set", "alhpa=1"), 2, "takes none", "alpha")


class Text(ProgramTest):
    def test_status_length_and_one_vertex_a_line(self):
        result = self.plan("--json").json
        lines = self.plan().out.splitlines()
        self.assertEqual(lines[0], "solved")
        self.assertEqual(float(lines[1]), result["length"])
        self.assertEqual([[float(n) for n in line.split()] for line in lines[2:]], result["path"])

    def test_messages_only_where_asked(self):
        self.assertEqual(self.plan().err, "")
        self.assertIn("small.map", self.plan("-v").err)
        self.assertIn("fan2004", self.plan("-v").err)
        self.assertNotEqual(self.plan("-q", goal="4,2").err, "")

    def test_progress_never_unless_a_terminal_or_asked(self):
        self.assertNotIn("\r", self.plan("--progress", "auto", "-v").err)
        shown = self.plan("--progress", "always").err
        self.assertIn("/120", shown)
        self.assertTrue(shown.endswith("\033[K"))


class Files(ProgramTest):
    def test_json_is_what_stdout_gets(self):
        run = self.plan("--json", "-o", "a.json", "-o", "b.json")
        self.assertEqual(self.read("a.json").decode(), run.out)
        self.assertEqual(self.read("b.json").decode(), run.out)
        left = sorted(name for name in os.listdir(self.folder))
        self.assertEqual(left, ["a.json", "b.json", "small.map"])

    def test_json_of_a_failure_is_written_too(self):
        self.assertEqual(self.plan("-o", "a.json", goal="4,2").code, 5)
        self.assertEqual(json.loads(self.read("a.json"))["status"], "unreachable")

    def test_csv_is_the_convergence(self):
        result = self.plan("--json", "--iterations", "4", "-o", "run.csv").json
        rows = [row.split(",") for row in self.read("run.csv").decode().splitlines()]
        self.assertEqual(rows[0], ["iteration", "best", "mean", "arrived"])
        self.assertEqual([int(row[0]) for row in rows[1:]], [1, 2, 3, 4])
        self.assertEqual([float(row[1]) for row in rows[1:]], result["best"])
        self.assertEqual([float(row[2]) for row in rows[1:]], result["mean"])
        self.assertEqual([int(row[3]) for row in rows[1:]], result["arrived"])
        self.plan("--iterations", "0", "-o", "run.csv")
        self.assertEqual(self.read("run.csv").decode(), "iteration,best,mean,arrived\n")

    def test_a_picture_of_a_map_whose_name_is_no_text(self):
        name = os.fsdecode(b"\xff\xfe.map")
        self.write(name, self.read("small.map"))
        self.ended(self.plan("-o", "a.png", "-o", "a.svg", map_file=name), 0)
        self.png_size("a.png")

    def test_a_failed_run_leaves_an_older_file_alone(self):
        self.write("a.json", "old")
        self.plan("-o", "a.json", map_file="missing.map")
        self.assertEqual(self.read("a.json"), b"old")


if __name__ == "__main__":
    unittest.main()
