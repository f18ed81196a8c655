"""The command line: help, and every kind of bad argument."""
import unittest

from program import ProgramTest


class Usage(ProgramTest):
    def test_control_characters_are_shown(self):
        """They neither cut a message short nor steer the terminal."""
        self.write("zero.map", "type octile\nheight 1\0 2\nwidth 3\nmap\n...\n")
        self.refused(self.run_program("info", "zero.map"), 3, "zero.map, line 2", r"1\x00 2", "whole number")
        self.refused(self.plan("--algorithm", "\33[31mexact"), 2, r"\x1b[31mexact", 'did you mean "exact"')

    def test_version_and_help_go_to_stdout(self):
        version = self.quiet(self.run_program("--version"))
        self.assertRegex(version.out, r"^lasius \d+\.\d+\.\d+\n$")
        for command in ([], ["plan"], ["batch"], ["info"], ["algorithms"], ["generate"],
                        ["verify"], ["arm"], ["help"]):
            with self.subTest(command=command):
                shown = self.quiet(self.run_program(*command, "--help"))
                self.assertIn("Usage: lasius", shown.out)

    def test_no_command(self):
        self.refused(self.run_program(), 2, "no command", "plan", "verify")

    def test_a_point_is_one_word(self):
        self.refused(self.run_program("plan", "small.map", "--start", "0", "0", "--goal", "9,5"), 2,
                     '"0" is one argument too many; points are X,Y, without a blank')
        self.assertNotIn("X,Y", self.run_program("info", "small.map", "5").err)

    def test_two_dashes_end_the_options(self):
        self.assertEqual(self.run_program("info", "--", "small.map").code, 0)
        self.write("-odd.map", self.read("small.map"))
        self.assertEqual(self.run_program("info", "--", "-odd.map").code, 0)
        self.refused(self.run_program("info", "small.map", "--", "more"), 2, "one argument too many")
        for words in (["plan", "--", "small.map", "--start", "0,0"],
                      ["plan", "--start", "0,0", "--goal", "9,5", "--", "small.map", "--start=0,0"],
                      ["info", "small.map", "--", "--json"]):
            run = self.run_program(*words)
            self.refused(run, 2, "is one argument too many: no option follows --")

    def test_the_nearest_known_word_is_named(self):
        plan = ["plan", "small.map", "--start", "0,0", "--goal", "9,5"]
        cases = [
            (["paln", "small.map"], '"plan"'),
            (["verfy"], '"verify"'),
            (["plan", "small.map", "--strat", "0,0", "--goal", "9,5"], '"--start"'),
            ([*plan, "--iteratoins", "3"], '"--iterations"'),
            ([*plan, "--sead=3"], '"--seed"'),
            (["info", "small.map", "--jsn"], '"--json"'),
            ([*plan, "--algo", "exact"], '"--algorithm"'),
            ([*plan, "--GAP"], '"--gap"'),
            ([*plan, "-V"], '"-v"'),
            (["PLAN", "small.map"], '"plan"'),
            ([*plan, "--algorithm", "fan204"], '"fan2004"'),
            ([*plan, "--set", "persistance=0.5"], '"persistence"'),
            ([*plan, "--set", "dead_end=kil"], '"kill"'),
            ([*plan, "--polish", "tuat"], '"taut"'),
            ([*plan, "--corners", "one_side"], '"one-side"'),
            ([*plan, "--frame", "wrld"], '"world"'),
            ([*plan, "--progress", "nevr"], '"never"'),
            ([*plan, "-o", "picture.pngg"], '".png"'),
            (["study", "lst"], '"list"'),
            (["generate", "mazes", "--size", "8x8", "-o", "m.map"], '"maze"'),
            (["generate", "maze", "--size", "8x8", "-o", "m.pdm"], '".pbm"'),
        ]
        for arguments, nearest in cases:
            with self.subTest(arguments=arguments):
                self.refused(self.run_program(*arguments), 2, "did you mean " + nearest)

    def test_a_word_that_is_like_none_is_not_taken_for_one(self):
        plan = ["plan", "small.map", "--start", "0,0", "--goal", "9,5"]
        cases = [
            ([*plan, "--footprint", "1"], "robots are discs: --radius R; see --help"),
            ([*plan, "--waypoints", "3,3"], "give each of them with --via X,Y; see --help"),
            ([*plan, "--quux"], 'unknown option "--quux"; see --help'),
            (["drive", "small.map", "--islands", "3"], 'unknown option "--islands"'),
            (["info", "small.map", "--islands"], 'unknown option "--islands"'),
            ([*plan, "--polish", "smooth"], "none|straight|taut|local"),
            (["zzzz"], "it is one of plan, drive, tour, batch"),
            ([*plan, "--set", "zzzz=1", "--algorithm", "acs"], "`lasius algorithms acs` lists all"),
        ]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                run = self.run_program(*arguments)
                self.refused(run, 2, words)
                self.assertNotIn("did you mean", run.err)
        self.refused(self.run_program(*plan, "--tolerance", "3"), 2, 'did you mean "--goal-tolerance"?')

    def test_what_belongs_elsewhere_is_sent_there(self):
        plan = ["plan", "small.map", "--start", "0,0", "--goal", "9,5"]
        self.refused(self.run_program(*plan, "--algorithm", "goritov2020"), 2, "lasius arm")
        for setting in ("time_limit=1", "time-limit=1", "seed=2", "threads=1", "target_gap=1", "join=mitre", "radius=2"):
            option = "--" + setting.split("=")[0].replace("_", "-")
            self.refused(self.run_program(*plan, "--set", setting), 2, "an option, " + option)

    def test_a_count_of_islands_is_refused_by_its_option(self):
        for count in ("4x", "-2", "0"):
            self.refused(self.plan("--algorithm", "acs", "--islands", count), 2, "islands is " + count)
        self.refused(self.plan("--algorithm", "acs", "--islands", "x"), 2, '"x" is one argument too many, and no value of --islands;')
        for run in (self.plan("--prepare", "zz"), self.run_program("info", "small.map", "--prepare", "zz")):
            self.refused(run, 2, '"zz" is one argument too many, and no value of --prepare;')
        self.quiet(self.plan("--algorithm", "acs", "--iterations", "1", "--islands", "2", "-q"))
        self.write("4x", self.read("small.map"))
        self.assertEqual(self.run_program("plan", "--algorithm", "acs", "--iterations", "1", "--start", "0,0", "--goal", "9,5",
                                          "-q", "--islands", "4x").code, 0)

    def test_an_exchange_is_of_islands(self):
        asked = ("--algorithm", "acs", "--iterations", "1", "--exchange")
        self.refused(self.plan(*asked, "at-once", "--islands", "2"), 2, "exchange is \"at-once\"", "scheduled|asynchronous")
        self.ended(self.plan(*asked, "asynchronous"), 0, "exchange", "islands above 1")
        self.ended(self.plan("--algorithm", "exact", "--exchange", "asynchronous"), 0, "exchange", "exact")

    def test_values_of_another_form_and_names_far_from_all(self):
        for setting, words in (("ants=1e3", "ants is 1e3; it must be a whole number, 1 .. 1000000"),
                               ("persistence=0x1p-1", "it must be a plain number, 0 .. 1"),
                               ("ants=-3", "ants is -3; it must be 1 .. "), ("foo=3", "`lasius algorithms mmas` lists all")):
            self.refused(self.plan("--algorithm", "mmas", "--set", setting), 2, words)
        self.assertNotIn("lists", self.plan("--algorithm", "mmas", "--set", "persistance=3").err)

    def test_a_parameter_is_set_once(self):
        plan = ["plan", "small.map", "--start", "0,0", "--goal", "9,5", "--algorithm", "as"]
        for command in (plan, ["study", "run", *plan[1:]]):
            for first, second, name in (("ants=3", "ants=5", "ants"), ("ants=3", "ants=3", "ants"),
                                        ("persistence=0.5", "evaporation=0.5", "persistence")):
                run = self.run_program(*command, "--set", first, "--set", "alpha=1", "--set", second)
                self.refused(run, 2, f"--set {first}, --set {second}: {name} is given more than once")

    def test_plain_words(self):
        plan = ["plan", "small.map", "--start", "0,0", "--goal", "9,5"]
        cases = [(["--seed", "1", "--seed", "2"], "--seed is given more than once"),
                 (["--time-limit"], "--time-limit needs a value, SECONDS"),
                 (["--set"], "--set needs a value, NAME=VALUE"),
                 (["--set="], "--set needs a value, NAME=VALUE"),
                 (["--json=yes"], "--json takes no value")]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                self.assertEqual(self.run_program(*plan, *arguments).err,
                                 f"lasius: {words}; see --help\n")

    def test_bad_values(self):
        cases = [
            ("--start", "1"), ("--start", "1,"), ("--start", "1,2,3"), ("--start", "1.5,2.5.1"),
            ("--start", "a,b"), ("--start", " 1,2"), ("--start", "1;2"), ("--start", ""),
            ("--seed", "-1"), ("--seed", "9007199254740992"), ("--seed", "1.5"), ("--seed", "x"),
            ("--threads", "0"), ("--threads", "-2"), ("--threads", "many"),
            ("--time-limit", "-1"), ("--time-limit", "inf"), ("--time-limit", "nan"),
            ("--time-limit", "2s"), ("--target-gap", "-1"), ("--target-gap", "1%"),
            ("--ants", "0"), ("--ants", "-3"), ("--ants", "2.5"), ("--ants", ""),
            ("--iterations", "-1"), ("--iterations", "1e3"), ("--neighbours", "5"),
            ("--radius", "-1"), ("--radius", "nan"), ("--tracks", "0"), ("--tracks", "1,,2"),
            ("--tracks", "1,"),
            ("--tracks", ",".join(map(str, range(1, 22)))), ("--set", "ants"), ("--set", "=3"), ("--set", "ants="),
            ("--set", "ants=many"), ("--set", "alpha=nan"), ("--set", "alpha=1e99"),
        ]
        for option, value in cases:
            with self.subTest(option=option, value=value):
                arguments = {"--start": "0,0", "--goal": "9,5", option: value}
                flat = [word for pair in arguments.items() for word in pair]
                run = self.run_program("plan", "small.map", *flat)
                self.refused(run, 2)
                self.assertTrue(run.err.startswith("lasius: "), run.err)

    def test_missing_and_surplus_arguments(self):
        self.refused(self.run_program("plan"), 2, "required")
        self.refused(self.run_program("plan", "small.map", "--start", "0,0"), 2, "--goal")
        self.refused(self.run_program("batch", "small.map"), 2, "QUERIES")
        self.refused(self.run_program("generate", "maze", "-o", "m.map"), 2, "--size")
        self.refused(self.run_program("generate", "maze", "--size", "8x8"), 2, "--output")
        self.refused(self.plan("more"), 2, "more")
        self.refused(self.plan("--seed"), 2, "--seed")
        self.refused(self.plan("--seed", "1", "--seed", "2"), 2, "--seed")
        self.refused(self.plan("--json=yes"), 2, "json")
        self.refused(self.plan("-q", "-v"), 2, "-q and -v")

    def test_bad_sizes_and_densities(self):
        for size in ("8", "8x", "x8", "0x8", "8x-1", "8x8x8", "8.5x8", "32769x8", "99999999999x8"):
            with self.subTest(size=size):
                self.refused(self.run_program("generate", "open", "--size", size, "-o", "m.map"), 2)
        for kind, most in (("blobs", "0.999"), ("maze", "0.8"), ("rooms", "0.35"), ("city", "0.5")):
            self.ended(self.run_program("generate", kind, "--size", "8x8", "--density", "1", "-o",
                                        "m.map"), 0, f"--density is {most}")
        for density in ("-0.1", "1.5", "nan", "half"):
            with self.subTest(density=density):
                self.refused(self.run_program("generate", "blobs", "--size", "8x8", "--density",
                                              density, "-o", "m.map"), 2)

    def test_threads_of_the_environment(self):
        def threads(*arguments, **env):
            return self.plan("--json", "--iterations", "1", *arguments, env=env).json["threads"]

        self.assertEqual(threads(LASIUS_THREADS="3", OMP_NUM_THREADS="2"), 3)
        self.assertEqual(threads(OMP_NUM_THREADS="2,4"), 2)
        self.assertEqual(threads("--threads", "4", LASIUS_THREADS="3"), 4)
        for none in ("nonsense", "0", "1025", "99999999999"):
            self.assertEqual(threads(OMP_NUM_THREADS=none), threads())
        self.refused(self.plan(env={"LASIUS_THREADS": "some"}), 2, "LASIUS_THREADS")

    def test_kernels_of_the_environment(self):
        wrong = {"LASIUS_KERNELS": "foo"}
        self.write("q.tsv", "sx sy gx gy\n0 0 1 1\n")
        for words in (("plan", "small.map", "--start", "0,0", "--goal", "9,5"), ("batch", "small.map", "q.tsv"), ("info", "small.map")):
            self.refused(self.run_program(*words, env=wrong), 2, 'LASIUS_KERNELS is "foo"', "set it to scalar")
            self.assertEqual(self.run_program(*words, env={"LASIUS_KERNELS": "scalar"}).code, 0)
        for words in (("--help",), ("plan", "--help"), ("help", "plan"), ("--version",), ("complete", "pl")):
            self.quiet(self.run_program(*words, env=wrong))

    def test_what_has_no_effect_is_said(self):
        cases = [("--target-gap", "3"), ("--unknown-free",), ("--tracks", "1,2"), ("--prepare",)]
        for arguments in cases:
            with self.subTest(arguments=arguments):
                self.assertIn(f"{arguments[0]} has no effect", self.plan(*arguments).err)
                self.assertEqual(self.plan("-q", *arguments).err, "")
        self.assertEqual(self.plan("--algorithm", "exact", "--target-gap", "3").err, "")
        for algorithm in ("exact", "as", "grid-ga"):
            self.assertIn("persistence, the share kept, or evaporation",
                          self.plan("--algorithm", algorithm, "--set", "rho=0.1").err)
        self.assertIn("evaporation=0.1 has no effect",
                      self.plan("--algorithm", "terminal-index", "--iterations", "1", "--set", "evaporation=0.1").err)
        elitist = "--set elite_weight=3 has no effect: it is read only with update=elitist"
        self.assertIn(elitist, self.plan("--algorithm", "as", "--set", "elite_weight=3").err)
        self.assertEqual(self.plan("--algorithm", "eas", "--set", "elite_weight=3").err, "")
        self.assertEqual(self.plan("--tracks", "1", "-o", "p.svg").err, "")

    def test_usage_comes_before_files(self):
        self.refused(self.plan("--seed", "x", map_file="missing.map"), 2, "--seed")


if __name__ == "__main__":
    unittest.main()
