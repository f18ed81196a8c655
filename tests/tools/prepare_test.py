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

    def test_labels_are_as_short_and_shown(self):
        plain, labelled = [self.fan("--json", *how).json for how in ((), ("--prepare", "labels"))]
        self.assertAlmostEqual(labelled["length"], plain["length"], delta=1e-9 * plain["length"])
        self.assertEqual((labelled["optimal"], labelled["parameters"]["prepare"]), (True, "labels"))
        self.assertIs(self.fan("--json", "--prepare", "graph").json["parameters"]["prepare"], True)
        shown = self.run_program("info", FAN, "--json", "--prepare", "labels").json["preparation"]
        self.assertEqual(shown["labels"]["state"], "ready")
        self.assertGreater(shown["labels"]["entries"], shown["corners"])
        self.assertRegex(self.run_program("info", FAN, "--prepare", "labels").out,
                         r"labels +\d+ entries, \d+ bytes, [\d.]+ ms\n")
        self.write("q.tsv", QUERIES)
        self.quiet(self.run_program("batch", FAN, "q.tsv", "--prepare", "labels", "-o", "l.json"))
        self.assertEqual(self.run_program("verify", "l.json").code, 0)

    def test_a_slip_of_the_pen_is_named(self):
        self.ended(self.fan("--prepare", "lables"), 2, 'did you mean "labels"?')
        self.ended(self.fan("--prepare", "grap"), 2, 'did you mean "graph"?')

    def test_a_batch_that_prepares_for_itself_answers_as_single_plans(self):
        self.write("q.tsv", QUERIES.splitlines()[0] + "\n" + 100 * "14\t14\t380\t179\n"
                   + 250 * "380\t179\t20\t15\n")
        run = self.quiet(self.run_program("batch", FAN, "q.tsv", "--threads", "2"))
        self.assertEqual(run.lines[0]["path"], self.fan("--json").json["path"])
        self.assertEqual(len({str(line["path"]) for line in run.lines}), 2)
        self.assertNotIn("prepare", run.lines[300]["parameters"])

    def test_labels_where_there_are_none(self):
        for more, note in ((("--radius", "0.5"), "labels are for a point"),
                           (("--algorithm", "fan2004", "--iterations", "3"), "has no effect")):
            self.ended(self.fan("--json", "--prepare", "labels", *more), 0, note)

    def test_a_file_of_what_was_prepared(self):
        made = self.quiet(self.fan("--json", "--prepared", "fan.prepared")).json
        kept = self.quiet(self.fan("--json", "--prepared", "fan.prepared")).json
        self.assertEqual((kept["path"], kept["parameters"]), (made["path"], made["parameters"]))
        self.assertEqual(made["parameters"]["prepare"], "labels")
        with open(os.path.join(self.folder, "fan.prepared"), "rb") as file:
            whole = file.read()
        damaged = whole[:5000] + bytes([whole[5000] ^ 1]) + whole[5001:]
        for name, content, problem in (("short", whole[:-9], "is cut short"),
                                       ("long", whole + b"x", "more than"),
                                       ("damaged", damaged, "its checksum differs"),
                                       ("newer", whole[:16] + b"\2" + whole[17:], "is of version 2, this program reads 1"),
                                       ("flags", whole[:20] + b"\7" + whole[21:], "is damaged"),
                                       ("none", b"lasius", "is no file of a prepared map")):
            with open(os.path.join(self.folder, name), "wb") as file:
                file.write(content)
            self.ended(self.fan("--prepared", name), 3, problem)
        other = os.path.join(MAPS, "grid30a.map")
        self.ended(self.plan("--prepared", "fan.prepared", start="0,0", goal="29,29",
                             map_file=other), 3, "was prepared for another map")
        for goal in ("0,0", "0,1"):  # no search, or a start that is blocked
            self.ended(self.plan("--prepared", "fan.prepared", start="0,0", goal=goal,
                                 map_file=other), 3, "was prepared for another map")
        self.ended(self.fan("--prepared", "fan.prepared", "--algorithm", "fan2004",
                            "--iterations", "3"), 0, "--prepared has no effect")
        self.ended(self.fan("--prepared", "no/folder"), 7, "no/folder")
        self.ended(self.fan("--prepared", "new", "--radius", "1"), 2, "--prepared is for a point")


if __name__ == "__main__":
    unittest.main()
