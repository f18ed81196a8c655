"""--goal-tolerance, and what is said of the nearest free cell."""
import unittest

from program import ProgramTest

SHELF = ["." * 20] * 5 + ["." * 10 + "@" * 7 + "..."] + [
    "." * 10 + "@" + ("....." if y != 8 else ".@...") + "@..." for y in range(6, 11)] + [
    "." * 10 + "@" * 7 + "..."] + ["." * 20] * 4


class GoalTolerance(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("shelf.map", "type octile\nheight 16\nwidth 20\nmap\n" + "\n".join(SHELF) + "\n")
        pixels = "\n".join(" ".join("0" if c == "@" else "255" for c in row) for row in SHELF)
        self.write("shelf.pgm", f"P2\n20 16\n255\n{pixels}\n")
        self.write("shelf.yaml", "image: shelf.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                 "occupied_thresh: 0.65\nfree_thresh: 0.2\n")

    def shelf(self, *arguments, start="2,2", goal="12,8", map_file="shelf.map"):
        return self.plan(*arguments, start=start, goal=goal, map_file=map_file)

    def test_the_path_ends_at_the_nearest_cell(self):
        for algorithm in ("exact", "acs", "grid-ga"):
            run = self.ended(self.shelf("--goal-tolerance", "3", "--algorithm", algorithm, "--json", "--gap"), 0)
            result = run.json
            self.assertEqual((result["status"], result["goal"], result["goal_reached"]),
                             ("solved", [12, 8], [9, 8]))
            self.assertEqual(result["path"][-1], [9.5, 8.5])
            self.assertEqual(result["parameters"]["goal_tolerance"], 3)
            self.assertIsNotNone(result["optimum"])
            self.assertIsNotNone(result["grid_optimum"])
            self.assertIn("1 of 1", self.replay_of(result).out)
        run = self.shelf("--goal-tolerance", "3")
        self.ended(run, 0, "the path ends at (9, 8), 3 cells from the goal, which cannot be reached")

    def test_too_far_is_what_it_was_and_says_how_far(self):
        for goal, code, status in (("12,8", 4, "invalid"), ("13,8", 5, "unreachable")):
            run = self.shelf("--goal-tolerance", "2.5", "--json", goal=goal)
            self.assertEqual((run.code, run.json["status"]), (code, status))
            self.assertIsNone(run.json["goal_reached"])
        self.assertIn("the nearest cell that can be reached, (13, 4), is 4 cells from the goal, the tolerance is 2.5 cells",
                      run.json["error"])

    def test_from_the_farthest_goals(self):
        for goal, reached in (("2e9,8", [19, 8]), ("8,1e150", [8, 15]), ("-2e9,-1e150", [0, 0]), ("2000000000,8", [19, 8])):
            for algorithm in ("exact", "acs"):
                run = self.shelf("--goal-tolerance", "1e200", "--algorithm", algorithm, "--json", "-q", goal=goal)
                self.assertEqual((run.code, run.json["goal_reached"]), (0, reached), goal)
        disc = self.shelf("--goal-tolerance", "1e20", "--radius", "0.4", "--algorithm", "exact", "--json", "-q", goal="1e17,8")
        self.assertAlmostEqual(disc.json["goal_reached"][0], 19.6)
        self.write("q.tsv", "sx\tsy\tgx\tgy\n2\t2\t2e9\t8\n")
        self.assertIn("free cell is (19, 8)", self.run_program("batch", "shelf.map", "q.tsv").lines[0]["error"])

    def test_without_one_nothing_is_added(self):
        result = self.shelf("--json", goal="3,3").json
        self.assertNotIn("goal_reached", result)
        self.assertNotIn("goal_tolerance", result["parameters"])
        self.refused(self.shelf("--goal-tolerance", "-1"), 2, "a number from 0 up")

    def test_in_metres(self):
        where = {"start": "0.125,0.675", "goal": "0.625,0.375", "map_file": "shelf.yaml"}
        run = self.ended(self.shelf("--frame", "world", "--goal-tolerance", "0.15", "--json", **where), 0)
        result = run.json
        self.assertEqual((result["goal_reached"], result["parameters"]["goal_tolerance"]), ([9, 8], 3))
        self.assertAlmostEqual(result["goal_reached_world"][0], 0.475)
        self.assertAlmostEqual(result["goal_reached_world"][1], 0.375)
        self.assertEqual(self.replay_of(result).code, 0)
        text = self.shelf("--frame", "world", "--goal-tolerance", "0.15", **where)
        self.ended(text, 0, "the path ends at (9, 8), its centre at 0.475,0.375 m, 0.15 m from the goal")

    def test_a_batch(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n2\t2\t12\t8\n2\t2\t30\t8\n2\t2\t5\t5\n")
        for algorithm in ("exact", "acs"):
            run = self.ended(self.run_program("batch", "shelf.map", "q.tsv", "--goal-tolerance", "3", "--gap",
                                              "--algorithm", algorithm, "-o", "lines.json"), 0)
            self.assertEqual([line["goal_reached"] for line in run.lines], [[9, 8], None, [5, 5]])
            self.assertEqual([line["optimum"] is None for line in run.lines], [False, True, False])
            self.assertEqual(self.run_program("verify", "lines.json").out, "3 of 3 results are equal to the replay\n")

    def test_a_drive(self):
        drive = ["drive", "shelf.map", "--start", "2,2", "--goal", "12,8", "--json"]
        run = self.ended(self.run_program(*drive, "--goal-tolerance", "3", "-o", "d.gif", "-o", "d.html"), 0)
        self.assertEqual((run.json["status"], run.json["goal_reached"], run.json["track"][-1]),
                         ("solved", [9, 8], [9, 8]))
        self.assertIsNotNone(run.json["ratio"])
        self.assertEqual(self.replay_of(run.json).code, 0)
        self.assertEqual(self.run_program(*drive, "--goal-tolerance", "2").code, 4)

    def test_the_advice_can_be_followed(self):
        for words, arguments in (
                ("that can be reached from the start is (9, 8); (12, 7) is nearer, but cannot be reached", {}),
                ("from which the goal can be reached is (9, 8); (12, 7) is nearer, but does not lead there",
                 {"start": "12,8", "goal": "2,2"}),
                ("is blocked; the nearest free cell is (9, 8)", {"goal": "10,8"})):
            self.ended(self.shelf(**arguments), 4, words)
        run = self.run_program("drive", "shelf.map", "--start", "2,2", "--goal", "12,8")
        self.ended(run, 4, "can be reached from the start is (9, 8)")
        self.assertEqual(self.shelf(goal="9,8").code, 0)


if __name__ == "__main__":
    unittest.main()
