"""--alternatives of plan and batch: other ways in text, JSON, pictures and replays, and where there are none."""
import math
import unittest

from program import ProgramTest

ROWS = ["." * 20 if y < 2 or y > 7 else "........####........" for y in range(12)]
MAP = "type octile\nheight 12\nwidth 20\nmap\n" + "\n".join(row.replace("#", "@") for row in ROWS) + "\n"
ROS = "image: m.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"


class Alternatives(ProgramTest):
    algorithm = "exact"

    def setUp(self):
        super().setUp()
        self.write("block.map", MAP)

    def ask(self, *options, command="plan", ends=("--start", "1,5", "--goal", "18,5")):
        return self.run_program(command, "block.map", *ends, *options)

    def test_the_other_side_of_a_block(self):
        above = 2 * math.hypot(6.5, 3.5) + 4
        for more in ((), ("--prepare",), ("--prepare", "labels")):
            answer = self.quiet(self.ask("--alternatives", "1", "--json", *more)).json
            (other,) = answer["alternatives"]
            self.assertAlmostEqual(other["length"], above, delta=1e-12)
            self.assertEqual(other["path"], [[1.5, 5.5], [8, 2], [12, 2], [18.5, 5.5]])
            self.assertLess(answer["length"], above)
            self.assertEqual(answer["parameters"]["alternatives"], 1)
            self.ended(self.replay_of(answer), 0)
            answer["alternatives"][0]["length"] += 1
            self.ended(self.replay_of(answer), 1, "alternatives")
        self.assertNotIn("alternatives", self.quiet(self.ask("--json")).json)
        text = self.quiet(self.ask("--alternatives", "1")).out
        first, second = text.split("\n\n")
        self.assertEqual(first.splitlines()[0], "solved")
        self.assertEqual(second.splitlines()[1:], ["1.5 5.5", "8 2", "12 2", "18.5 5.5"])
        few = self.ask("--alternatives", "3", "-o", "p.svg")
        self.ended(few, 0, "--alternatives 3: 1 way short enough")
        self.assertIn("alternatives", self.words("p.svg"))

    def test_batches_and_metres(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n1\t5\t18\t5\n18\t5\t1\t5\n1\t1\t1\t1\n9\t4\t1\t1\n")
        done = self.quiet(self.run_program("batch", "block.map", "q.tsv", "--alternatives", "2"))
        self.assertEqual([len(answer["alternatives"]) for answer in done.lines], [1, 1, 0, 0])
        self.write("m.yaml", ROS)
        pixels = bytes(0 if cell == "#" else 255 for row in ROWS for cell in row)
        self.write("m.pgm", b"P5\n20 12\n255\n" + pixels)
        answer = self.quiet(self.run_program("plan", "m.yaml", "--frame", "world", "--start", "0.75,3.25", "--goal",
                                             "9.25,3.25", "--alternatives", "1", "--json")).json
        (other,) = answer["alternatives"]
        self.assertEqual((other["path_world"][0], other["length_m"]), ([0.75, 3.25], other["length"] / 2))

    def test_where_there_are_none(self):
        for options, why in ((("--algorithm", "as"), "leave --algorithm out"), (("--radius", "0.5"), "a disc has none"),
                             (("--inflation", "3,1"), "over costs"), (("--via", "3,3"), "leave --via out"),
                             (("--target-gap", "5"), "leave --target-gap out")):
            self.refused(self.ask("--alternatives", "2", *options), 2, why)
        for number in ("0", "101", "two"):
            self.refused(self.ask("--alternatives", number), 2, "--alternatives")


if __name__ == "__main__":
    unittest.main()
