"""--prepare: as short as without, replayed, shown by info, and said where it has no effect."""
import os
import unittest

from program import MAPS, ProgramTest

FAN = os.path.join(MAPS, "fan400x200.map")
QUERIES = "sx\tsy\tgx\tgy\n14\t14\t380\t179\n0\t0\t399\t0\n14\t14\t14\t14\n380\t179\t20\t15\n"


class Prepare(ProgramTest):
    algorithm = "exact"

    def fan(self, *arguments, goal="380,179", **options):
        return self.plan(*arguments, start="14,14", goal=goal, map_file=FAN, **options)

    def test_a_plan_is_as_short_and_as_certain(self):
        plain, prepared = self.fan("--json").json, self.fan("--json", "--prepare").json
        self.assertAlmostEqual(prepared["length"], plain["length"], delta=1e-9 * plain["length"])
        self.assertEqual((prepared["status"], prepared["optimal"], prepared["gap"]),
                         ("solved", True, 0))
        self.assertNotIn("prepare", plain["parameters"])
        self.assertIs(prepared["parameters"]["prepare"], True)

    def test_threads_change_nothing(self):
        one, three = [self.fan("--json", "--prepare", "--threads", n).json for n in ("1", "3")]
        self.assertEqual((one["path"], one["length"]), (three["path"], three["length"]))

    def test_outcomes_without_a_path(self):
        outcomes = (("399,0", 5, "unreachable"), ("1000,0", 4, "invalid"), ("14,14", 0, "solved"))
        for goal, code, status in outcomes:
            run = self.fan("--json", "--prepare", goal=goal)
            self.assertEqual((run.code, run.json["status"]), (code, status))
            self.assertIs(run.json["parameters"]["prepare"], True)

    def test_a_question_without_a_search_prepares_nothing(self):
        for goal in ("399,0", "1000,0", "14,14"):
            self.assertNotIn("corners", self.fan("--prepare", "-v", goal=goal).err)

    def test_a_batch_gives_what_plan_gives_and_is_replayed(self):
        self.write("q.tsv", QUERIES)
        run = self.quiet(self.run_program("batch", FAN, "q.tsv", "--prepare", "--threads", "2",
                                          "-o", "lines.json"))
        self.assertEqual(run.lines[0]["path"], self.fan("--json", "--prepare").json["path"])
        verified = self.run_program("verify", "lines.json")
        self.assertEqual((verified.code, verified.out),
                         (0, "4 of 4 results are equal to the replay\n"))

    def test_a_colonys_optimum_is_asked_on_it(self):
        colony = ("--json", "--algorithm", "fan2004", "--iterations", "3", "--gap")
        plain, prepared = self.fan(*colony).json, self.fan(*colony, "--prepare").json
        self.assertEqual(prepared["path"], plain["path"])
        self.assertAlmostEqual(prepared["optimum"], plain["optimum"], places=6)

    def test_it_is_said_where_it_has_no_effect(self):
        run = self.ended(self.fan("--json", "--algorithm", "fan2004", "--iterations", "3",
                                  "--prepare"), 0, "--prepare has no effect")
        self.assertNotIn("prepare", run.json["parameters"])

    def test_verbose_says_what_it_costs(self):
        run = self.fan("--prepare", "-v")
        self.assertRegex(run.err, r"--prepare: \d+ vertices, \d+ edges, [\d.]+ MB, [\d.]+ ms")

    def test_info_shows_it(self):
        self.assertIsNone(self.run_program("info", FAN, "--json").json["preparation"])
        info = self.run_program("info", FAN, "--json", "--prepare").json
        shown = info["preparation"]
        self.assertEqual(shown["state"], "ready")
        self.assertGreater(shown["edges"], shown["corners"])
        self.assertEqual(shown["bytes"], info["memory"]["corners"])
        self.assertGreater(shown["ms"], 0)
        text = self.run_program("info", FAN, "--prepare").out
        self.assertRegex(text, r"--prepare +\d+ vertices, \d+ edges, \d+ bytes, [\d.]+ ms\n")


if __name__ == "__main__":
    unittest.main()
