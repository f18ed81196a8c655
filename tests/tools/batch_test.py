"""batch: formats of queries, order, equality with plan, exit codes."""
import json
import os
import unittest

from program import MAPS, ProgramTest

HEADER = "map\tsx\tsy\tgx\tgy\tnote\n"
FAN = os.path.join(MAPS, "fan400x200.map")


def without(result, *keys):
    return {key: value for key, value in result.items() if key not in keys}


class Formats(ProgramTest):
    def batch(self, queries, *arguments, name="q.tsv", map_file="small.map"):
        self.write(name, queries)
        return self.run_program("batch", map_file, name, "--iterations", "3", *arguments)

    def test_a_table_with_columns_among_others(self):
        run = self.quiet(self.batch(HEADER + "a\t0\t0\t9\t5\tx\nb\t1\t0\t9\t0\t\n"))
        self.assertEqual([(q["index"], q["start"], q["goal"], q["status"]) for q in run.lines],
                         [(0, [0, 0], [9, 5], "solved"), (1, [1, 0], [9, 0], "solved")])

    def test_yaws_without_a_vehicle_are_told(self):
        queries = "sx sy syaw gx gy gyaw\n0 0 0 9 5 north\n"
        run = self.batch(queries)
        self.assertEqual((run.code, run.err), (0, "lasius: q.tsv: its yaws have no effect without --vehicle\n"))
        self.quiet(self.batch(queries, "-q"))

    def test_columns_in_any_order_blanks_and_line_ends(self):
        run = self.batch("gy gx  sy sx\r\n5 9 0 0\r\n\r\n 0\t9  0 1 \r\n")
        self.assertEqual([(q["start"], q["goal"]) for q in run.lines],
                         [([0, 0], [9, 5]), ([1, 0], [9, 0])])

    def test_lines_that_end_in_cr_alone(self):
        run = self.batch("\ufeffsx sy gx gy\r0 0 9 5\r\r1 0 9 0\r")
        self.assertEqual([(q["start"], q["goal"]) for q in run.lines],
                         [([0, 0], [9, 5]), ([1, 0], [9, 0])])
        self.refused(self.batch("sx sy gx gy\r0 0 9 5\r\r0 0 9\r"), 3, "line 4")

    def test_tables_of_commas(self):
        text = 'sx,sy,gx,gy,note\n0,0,9,5,loading dock\n"1", 0, 9, 0,"a, ""b"""\n0,0,9,5,\n2,0,9,0,c,,\n'
        self.assertEqual([(q["start"], q["goal"]) for q in self.batch(text).lines],
                         [([0, 0], [9, 5]), ([1, 0], [9, 0]), ([0, 0], [9, 5]), ([2, 0], [9, 0])])
        self.refused(self.batch("sx,sy,gx,gy,note\n1,,2,3,4 5\n"), 3, "line 2: sy is ''")
        self.refused(self.batch("sx sy gx gy\n0,5 9,5\n"), 3, "line 2: 2 fields")
        self.refused(self.batch('sx,sy,gx,gy\n"0,0,9,5\n'), 3, "line 2: a quote is not closed")

    def test_scenarios(self):
        for version in ("1", "1.0"):
            for blank in ("\t", "  ", " \t "):
                with self.subTest(version=version, blank=blank):
                    fields = ["0", "maps/other.map", "10", "6", "0", "0", "9", "5", "10.5"]
                    run = self.batch(f"version {version}\n" + blank.join(fields) + "\n", name="q.scen")
                    self.assertEqual(run.code, 0, run.err)
                    self.assertEqual([q["goal"] for q in run.lines], [[9, 5]])
        run = self.batch("version 1\n0\tmy 2 maps/a b.map\t10\t6\t0\t0\t9\t5\t1\n0 a 10 6 0 0 9 0 1\n", name="q.scen")
        self.assertEqual([q["goal"] for q in run.lines], [[9, 5], [9, 0]], run.err)

    def test_a_table_whose_first_column_is_a_version(self):
        run = self.batch("version\tsx\tsy\tgx\tgy\n1\t0\t0\t9\t5\n")
        self.assertEqual([(q["start"], q["goal"]) for q in run.lines], [([0, 0], [9, 5])])

    def test_no_queries_is_no_error(self):
        for queries in ("version 1\n", HEADER):
            run = self.batch(queries)
            self.assertEqual((run.code, run.out), (0, ""))

    def test_a_broken_file_prints_nothing_and_names_the_line(self):
        good = "a\t0\t0\t9\t5\tx\n"
        row = "0\tm.map\t10\t6\t0\t0\t9\t5\t1\n"
        cases = [
            ("", "empty"), ("\n\n", "empty"), ("sx sy gx\n1 2 3\n", "line 1"),
            ("sx\tsy\tgx\tgy\tgy\n", "two columns"), ("sx\tsy\tgx\tgy\n0\t0\t9\t5\0\n", "gy holds a zero byte"),
            (HEADER + good + "a\t0\t0\t9\tfive\tx\n", "line 3"),
            (HEADER + good + "a\t0\t0\t9\t5.5.\tx\n", "line 3"),
            (HEADER + good + good + "a\t0\t0\t9\n", "line 4"),
            (HEADER + good + "a\t0\t0\t9\t5\tx\ty\n", "line 3"),
            ("version 2\n" + row, "line 1"), ("version\n" + row, "line 1"),
            ("version 1\n" + row + "0\tm.map\t10\t6\t0\t0\t9\t5\n", "line 3"),
            ("version 1\n" + row + row.replace("10", "11"), "line 3"),
            ("version 1\n" + row.replace("\t1\n", "\tone\n"), "line 2"),
            ("version 1\n" + row.replace("\t1\n", "\t1\t1\n"), "10 fields instead of 9"),
            ("version 1\n" + row.replace("9\t5", "9\tx"), "line 2"),
        ]
        for queries, word in cases:
            with self.subTest(queries=queries):
                self.refused(self.batch(queries), 3, "q.tsv", word)
        self.refused(self.run_program("batch", "small.map", "missing.tsv"), 3, "missing.tsv")
        self.refused(self.run_program("batch", "small.map", "."), 3)
        self.refused(self.batch(HEADER + good, map_file="missing.map"), 3, "missing.map")

    def test_bad_queries_do_not_end_the_run(self):
        run = self.batch("sx\tsy\tgx\tgy\n3\t1\t0\t0\n0\t0\t99\t0\n0\t0\t4\t2\n-5\t0\t0\t0\n"
                         "0\t0\t9\t5\n0\t0\t99999999999\t0\n")
        self.assertEqual(run.code, 0)
        self.assertEqual([q["status"] for q in run.lines],
                         ["invalid", "invalid", "unreachable", "invalid", "solved", "invalid"])
        self.assertEqual([q["index"] for q in run.lines], list(range(6)))
        for query in run.lines:
            self.assertEqual(query["error"] is None, query["status"] == "solved")
        self.assertIn("nearest free cell", run.lines[0]["error"])

    def test_a_whole_number_of_any_size_is_a_cell(self):
        numbers = ("2147483648", "-2147483649", "4294967297", "99999999999999999999999")
        rows = [f"0\tm\t10\t6\t0\t0\t{number}\t5\t1\n" for number in numbers]
        run = self.quiet(self.batch("version 1\n" + "".join(rows), "-o", "all.csv", name="q.scen"))
        for number, line in zip(numbers, run.lines):
            self.assertEqual((line["status"], line["goal"]), ("invalid", [float(number), 5]))
            self.assertIn(number[:-1] if len(number) < 20 else "e+", line["error"])
        csv = [row.split(",")[3] for row in self.read("all.csv").decode().splitlines()[1:]]
        self.assertEqual(csv[:3], list(numbers[:3]))


class Answers(ProgramTest):
    QUERIES = [((14, 14), (380, 179)), ((14, 14), (60, 40)), ((380, 179), (14, 14)),
               ((200, 20), (14, 14)), ((14, 14), (14, 14)), ((399, 0), (14, 14))] * 3

    def setUp(self):
        super().setUp()
        rows = [f"{sx}\t{sy}\t{gx}\t{gy}\n" for (sx, sy), (gx, gy) in self.QUERIES]
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "".join(rows))

    def batch(self, *arguments):
        return self.run_program("batch", FAN, "q.tsv", "--iterations", "4", "--seed", "7",
                                *arguments)

    def test_each_query_gives_what_plan_gives(self):
        lines = self.batch("--threads", "2").lines
        for query, line in list(zip(self.QUERIES, lines))[:6]:
            (sx, sy), (gx, gy) = query
            single = self.plan("--json", "--iterations", "4", "--seed", "7", map_file=FAN,
                               start=f"{sx},{sy}", goal=f"{gx},{gy}").json
            self.assertEqual(without(line, "index", "threads", "elapsed_ms"),
                             without(single, "threads", "elapsed_ms"))

    def test_a_range_of_seeds_gives_what_each_of_them_gives(self):
        options = ("--algorithm", "as", "--iterations", "3", "--gap")
        lines = self.run_program("batch", FAN, "q.tsv", *options, "--seed", "4..6").lines
        self.assertEqual([(q["index"], q["seed"]) for q in lines],
                         [(i, s) for i in range(len(self.QUERIES)) for s in (4, 5, 6)])
        (sx, sy), (gx, gy) = self.QUERIES[1]
        ends = {"map_file": FAN, "start": f"{sx},{sy}", "goal": f"{gx},{gy}"}
        run = self.plan(*options, "--seed", "4-6", "-o", "s.csv", "-o", "s.json", "-o", "s.svg", **ends)
        self.assertEqual((run.code, self.read("s.json").decode()), (0, run.out))
        for line, of_batch in zip(run.lines, lines[3:6], strict=True):
            single = self.plan(*options, "--json", "--seed", str(line["seed"]), **ends).json
            for found in (line, of_batch):
                self.assertEqual(without(found, "index", "threads", "elapsed_ms"),
                                 without(single, "threads", "elapsed_ms"))
        self.assertEqual(len({str(line["path"]) for line in run.lines}), 3)
        header, *rows = [row.split(",") for row in self.read("s.csv").decode().splitlines()]
        columns = [dict(zip(header, row, strict=True)) for row in rows]
        self.assertEqual([(int(c["seed"]), float(c["optimum"]), float(c["optimum_gap"])) for c in columns],
                         [(q["seed"], q["optimum"], q["optimum_gap"]) for q in run.lines])
        self.svg_root("s.svg")
        self.assertEqual(self.run_program("verify", "s.json").code, 0)

    def test_ranges_of_seeds_that_are_none(self):
        for seeds in ("3-2", "3..2", "1-", "1..", "..", "..3", "-1..3", "1-..3", "1..+2", "1.5", "1-x", "1-100001", "9007199254740990-9007199254740992", "1-2-3"):
            self.refused(self.plan("--seed", seeds), 2, "--seed")
        self.refused(self.run_program("drive", "small.map", "--start", "0,0", "--goal", "9,5", "--seed", "3-3"), 2,
                     "one drive has one seed")

    def test_a_range_of_seeds_ends_as_one_seed_does_unless_any_found_a_path(self):
        self.assertEqual([line["seed"] for line in self.quiet(self.plan("--seed", "3-3")).lines], [3])
        for goal, code, why in (("7,2", 5, "different regions"), ("3,2", 4, "nearest free cell is (2, 2)")):
            for seeds in ("1..1", "1..2"):
                run = self.ended(self.plan("--seed", seeds, goal=goal), code, why)
                self.assertEqual(len(run.lines), int(seeds[-1]))
        none = ("--algorithm", "as", "--ants", "1", "--iterations", "1", "--set", "dead_end=kill")
        found = [self.plan(*none, "--seed", str(seed)).code == 0 for seed in range(1, 9)]
        self.assertEqual(set(found), {True, False})
        self.ended(self.plan(*none, "--seed", "{0}-{0}".format(found.index(False) + 1)), 6, "no path after 1 iteration")
        self.quiet(self.plan(*none, "--seed", "1-8"))

    def test_batches_tell_of_limits(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "0\t0\t9\t5\n" * 2)
        cut = ("batch", "small.map", "q.tsv", "--algorithm", "mmas", "--time-limit", "0")
        self.ended(self.run_program(*cut), 0, "the time limit ended 2 of 2 answers")
        self.quiet(self.run_program(*cut, "-q"))
        endless = self.start_program("plan", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", "as",
                                     "--seed", "1-50", "--iterations", "1000000", "--time-limit", "0.3", "--threads", "1")
        endless.stdout.readline()
        self.holds(self.interrupted(endless)[1].decode(), " of 50 answers", "interrupted after ")

    def test_a_squeeze_has_no_optimum_as_plan_has_none(self):
        self.write("diagonal.map", "type octile\nheight 3\nwidth 3\nmap\n..@\n.@.\n...\n")
        self.write("one.tsv", "sx sy gx gy\n1 0 2 1\n")
        for neighbours in ("4", "8"):
            with self.subTest(neighbours=neighbours):
                options = ["--algorithm", "as", "--corners", "allow", "--gap", "--neighbours",
                           neighbours, "--iterations", "2"]
                line = self.run_program("batch", "diagonal.map", "one.tsv", *options, "-o",
                                        "one.json").lines[0]
                single = self.plan("--json", *options, map_file="diagonal.map", start="1,0",
                                   goal="2,1").json
                self.assertEqual(without(line, "index", "threads", "elapsed_ms"),
                                 without(single, "threads", "elapsed_ms"))
                self.assertEqual(self.run_program("verify", "one.json").code, 0)

    def test_any_number_of_threads_prints_the_same(self):
        runs = [[without(line, "threads", "elapsed_ms") for line in self.batch("--threads", n).lines]
                for n in ("1", "2", "7")]
        self.assertEqual(len(runs[0]), len(self.QUERIES))
        self.assertEqual([line["index"] for line in runs[0]], list(range(len(self.QUERIES))))
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(runs[0], runs[2])

    def test_files(self):
        run = self.batch("-o", "all.json", "-o", "all.csv", "-o", "all.png")
        self.assertEqual(self.read("all.json").decode(), run.out)
        rows = self.read("all.csv").decode().splitlines()
        self.assertEqual(rows[0].split(",")[:7], ["index", "sx", "sy", "gx", "gy", "status", "length"])
        self.assertEqual(len(rows), 1 + len(self.QUERIES))
        self.assertEqual([row.split(",")[5] for row in rows[1:]],
                         [line["status"] for line in run.lines])
        self.assertLessEqual(max(self.png_size("all.png")), 2000)

    def test_a_time_limit_holds_for_each_optimum(self):
        line = self.batch("--time-limit", "0", "--gap").lines[0]
        self.assertEqual((line["status"], line["optimum"], line["grid_optimum"]),
                         ("limit", None, None))

    def test_a_time_limit_holds_for_each_query(self):
        lines = self.batch("--time-limit", "0").lines
        self.assertEqual(len(lines), len(self.QUERIES))
        for query, line in zip(self.QUERIES, lines):
            if line["status"] not in ("invalid", "unreachable"):
                self.assertEqual(line["status"], "solved" if query[0] == query[1] else "limit")


if __name__ == "__main__":
    unittest.main()
