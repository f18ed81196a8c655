"""--part of batch and study, and merge: the parts become what the undivided run prints."""
import json
import os
import shutil
import unittest

from program import MAPS, ProgramTest

FAN = os.path.join(MAPS, "fan400x200.map")


def timeless(lines):
    return [{**line, "elapsed_ms": 0} for line in lines]


class Batches(ProgramTest):
    ASKED = ("--seed", "1-2", "--algorithm", "as", "--iterations", "2", "-q")

    def parts(self, of, queries="q.tsv", map_file="small.map", asked=ASKED):
        names = []
        for number in range(1, of + 1):
            run = self.quiet(self.run_program("batch", map_file, queries, "--part", f"{number}/{of}", *asked))
            names.append(f"part{number}.jsonl")
            self.write(names[-1], run.out)
        return names

    def write_queries(self, count):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "".join(f"{i % 10}\t0\t9\t{i % 6}\n" for i in range(count)))

    def test_parts_are_joined_in_any_order(self):
        for count, of in ((7, 3), (2, 4), (5, 1)):
            with self.subTest(count=count, of=of):
                self.write_queries(count)
                whole = self.quiet(self.run_program("batch", "small.map", "q.tsv", *self.ASKED))
                names = self.parts(of)
                merged = self.quiet(self.run_program("merge", *reversed(names), "-o", "all.json"))
                self.assertEqual(timeless(merged.lines), timeless(whole.lines))
                self.assertEqual([list(line) for line in merged.lines], [list(line) for line in whole.lines])
                self.assertEqual(self.read("all.json").decode(), merged.out)

    def test_a_part_is_every_nth_query_and_can_be_verified(self):
        self.write_queries(7)
        name = self.parts(3)[1]
        answers = [json.loads(line) for line in self.read(name).splitlines()]
        self.assertEqual([a["index"] for a in answers], [1, 1, 4, 4])
        self.assertEqual(answers[0]["part"], {"number": 2, "of": 3, "queries": 7, "hash": answers[0]["part"]["hash"], "seeds": [1, 2]})
        self.assertEqual(self.run_program("verify", name).code, 0)

    def test_polygon_worlds_and_scenarios(self):
        self.write("q.scen", "version 1\n" + "0\tm\t10\t6\t0\t0\t9\t5\t1\n0\tm\t10\t6\t1\t0\t9\t5\t1\n")
        names = self.parts(2, "q.scen", asked=("-q",))
        self.assertEqual([a["start"] for a in self.run_program("merge", *names).lines], [[0, 0], [1, 0]])
        world = os.path.join(MAPS, "maklink200.geojson")
        self.write("q.tsv", "sx\tsy\tgx\tgy\n20\t180\t160\t90\n20\t180\t180\t20\n30\t180\t160\t90\n")
        plain = self.run_program("batch", world, "q.tsv", "-q")
        if plain.code == 2:
            self.skipTest("built without polygon worlds")
        names = self.parts(2, map_file=world, asked=("-q",))
        self.assertEqual(timeless(self.run_program("merge", *names).lines), timeless(plain.lines))

    def test_poses_of_vehicles(self):
        self.write("free.map", "type octile\nheight 20\nwidth 20\nmap\n" + ("." * 20 + "\n") * 20)
        self.write("car.yaml", "type: car\nfootprint: [[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]]\nturning_radius: 2\nunits: cells\n")
        self.write("q.tsv", "sx\tsy\tsyaw\tgx\tgy\tgyaw\n" + "".join(f"{3 + i}.5\t4.5\t0\t14.5\t{10 + i}.5\t1.5\n" for i in range(3)))
        asked = ("--vehicle", "car.yaml", "-q")
        plain = self.quiet(self.run_program("batch", "free.map", "q.tsv", *asked))
        names = self.parts(2, map_file="free.map", asked=asked)
        self.assertEqual(timeless(self.quiet(self.run_program("merge", *names)).lines), timeless(plain.lines))

    def test_what_is_no_whole_run_is_refused(self):
        self.write_queries(7)
        one, two, three = self.parts(3)
        self.refused(self.run_program("merge", one, three), 3, "query 1 of 7", "part 2/3")
        self.refused(self.run_program("merge", one, two, two, three), 2, "given twice")
        self.write("copy", self.read(two))
        self.refused(self.run_program("merge", one, two, "copy", three), 3, "copy", "as is part2.jsonl")
        self.write("short", b"".join(self.read(two).splitlines(True)[:-1]))
        self.refused(self.run_program("merge", one, "short", three), 3, "query 4 of 7")
        self.write("torn", self.read(two)[:-9])
        self.refused(self.run_program("merge", one, "torn", three), 3, "torn")
        self.write("other", self.read(two).replace(b'"as"', b'"acs"'))
        self.refused(self.run_program("merge", one, "other", three), 3, "other, result 1", "'algorithm'")
        self.write("foreign", self.read(two).replace(b'"index":1', b'"index":2'))
        self.refused(self.run_program("merge", one, "foreign", three), 3, "query 2 is none of its part")
        for index in ("0.9", "1e300", "-1", '"a"'):
            self.write("index", self.read(two).replace(b'"index":1', b'"index":' + index.encode()))
            self.refused(self.run_program("merge", one, "index", three), 3, "index, result 1", "is no answer that")
        self.write("twice", self.read(two) + self.read(two).splitlines(True)[0])
        self.refused(self.run_program("merge", one, "twice", three), 3, "twice, result 5", "answers query 1 once more")
        self.write("cut", self.read(two).replace(b'"solved"', b'"interrupted"'))
        self.refused(self.run_program("merge", one, "cut", three), 3, "cut, result 1", "was interrupted")
        whole = self.run_program("batch", "small.map", "q.tsv", *self.ASKED)
        self.write("whole", whole.out)
        self.refused(self.run_program("merge", "whole"), 3, "--part I/N")
        self.refused(self.run_program("merge", "nowhere"), 3, "nowhere")
        self.write("empty", "")
        self.refused(self.run_program("merge", "empty"), 3, "no part holds an answer")
        for name, words, queries, asked in (
                ("seed", "'seeds'", "q.tsv", ("--seed", "2-3", *self.ASKED[2:])),
                ("gap", "'gap'", "q.tsv", ("--gap", *self.ASKED)),
                ("queries", "'hash'", "q2.tsv", self.ASKED)):
            self.write("q2.tsv", self.read("q.tsv") + b"\n")
            run = self.run_program("batch", "small.map", queries, "--part", "2/3", *asked)
            self.write(name, run.out)
            self.refused(self.run_program("merge", one, name, three), 3, words)
        for asked, key in ((("--via", "1,0"), "via"), (("--cost", "small.pgm"), "layers")):
            for number, grey in ((1, 3), (2, 4)):
                self.write("small.pgm", b"P5 10 6 255\n" + bytes([grey]) * 60)
                run = self.run_program("batch", "small.map", "q.tsv", "-q", "--part", f"{number}/2", *asked)
                self.write(f"{key}{number}", run.out)
                asked = ("--via", "2,0") if key == "via" else asked
            self.refused(self.run_program("merge", f"{key}1", f"{key}2"), 3, f"'{key}'")
        self.refused(self.run_program("merge", one, "."), 2, "one kind")
        self.refused(self.run_program("merge", one, two, three, "-o", "x.png"), 2, ".png")

    def test_no_part_is_written_over(self):
        self.write_queries(2)
        one, two = self.parts(2)
        os.symlink(one, self.path("link.jsonl"))
        os.link(self.path(two), self.path("hard.json"))
        before = self.read(one), self.read(two)
        for output in (one, "./" + two, "link.jsonl", "hard.json"):
            with self.subTest(output=output):
                self.refused(self.run_program("merge", one, two, "-o", output), 2, output, "are one file")
                self.assertEqual((self.read(one), self.read(two)), before)

    def test_parts_that_are_none(self):
        self.write_queries(2)
        for text in ("0/2", "3/2", "1", "1/2/3", "a/2", "1/0", "1/1000001", "-1/2", ""):
            with self.subTest(part=text):
                self.refused(self.run_program("batch", "small.map", "q.tsv", "--part", text), 2, "--part")


class Studies(ProgramTest):
    def study(self, *arguments):
        return self.run_program("study", "run", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", "as,mmas",
                                "--set", "iterations=2,3", "--seeds", "3", "-q", *arguments)

    def table(self, folder):
        return [{**row, "seconds": None} for row in self.rows(os.path.join(folder, "runs.csv"))]

    def test_folders_become_one_report(self):
        self.quiet(self.study("-o", "whole"))
        for number in (1, 2, 3):
            run = self.quiet(self.study("-o", f"part{number}", "--part", f"{number}/3"))
            self.assertEqual(run.out, f"part{number}\n")
            self.assertFalse(os.path.exists(self.path(f"part{number}/report.md")))
        self.refused(self.run_program("merge", "part1", "part3"), 3, "part 2 of 3 is missing")
        merged = self.quiet(self.run_program("merge", "part2/", "part1", "part3", "-o", "joined"))
        self.assertEqual(merged.out, "joined/report.md\n")
        self.assertEqual(self.table("joined"), self.table("whole"))
        # No run was made anew: each file is a part's.
        kept = [os.path.join(at, name) for at, _, names in os.walk(self.path("joined/runs")) for name in names]
        self.assertEqual(len(kept), 12)
        for file in kept:
            inside = os.path.relpath(file, self.path("joined"))
            origins = [p for p in ("part1", "part2", "part3") if os.path.exists(self.path(os.path.join(p, inside)))]
            self.assertEqual(len(origins), 1)
            self.assertEqual(self.read(file), self.read(os.path.join(origins[0], inside)))

    def test_a_part_is_taken_once_and_as_it_was_run(self):
        self.write("m.map", self.read(FAN))
        for number in (1, 2):
            self.quiet(self.run_program("study", "run", "m.map", "--start", "14,14", "--goal", "380,179", "--algorithm", "as", "--set",
                                        "iterations=2", "--seeds", "2", "-q", "-o", f"part{number}", "--part", f"{number}/2"))
        shutil.copytree(self.path("part1"), self.path("copy"))
        for again in ("copy", "part1/", "./part1"):
            self.refused(self.run_program("merge", "part1", again, "part2", "-o", "joined"), 3, again, "is part 1 once more")
        self.write("m.map", self.read("m.map").replace(b".", b"@", 1))
        self.refused(self.run_program("merge", "part1", "part2", "-o", "joined"), 3, "joined", "lacks 2 runs, or they were made of other maps")

    def test_parts_of_other_runs_are_refused(self):
        self.quiet(self.study("-o", "part1", "--part", "1/2"))
        self.quiet(self.run_program("study", "run", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", "as",
                                    "--set", "iterations=2", "--seeds", "2", "-q", "-o", "part2", "--part", "2/2"))
        self.refused(self.run_program("merge", "part1", "part2", "-o", "joined"), 3, "part2", "another run")
        self.quiet(self.run_program("study", "run", FAN, "--start", "14,14", "--goal", "380,178", "--algorithm", "as,mmas",
                                    "--set", "iterations=2,3", "--seeds", "3", "-q", "-o", "part3", "--part", "2/2"))
        self.refused(self.run_program("merge", "part1", "part3", "-o", "joined"), 3, "part3", "another run")
        self.refused(self.run_program("merge", "."), 3, "no part of a study")
        self.refused(self.run_program("study", "list", "--part", "1/2"), 2, "--part")
        self.write("part1/part-1-of-2.json", "{}")
        self.refused(self.run_program("merge", "part1"), 3, "part-1-of-2.json")
        self.refused(self.study("-o", "x.html", "--part", "1/2"), 2, "a part has no page")


if __name__ == "__main__":
    unittest.main()
