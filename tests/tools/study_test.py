"""study: lists, refuses, stops and goes on, and writes its report."""
import os
import unittest

from program import MAPS, ProgramTest


class Study(ProgramTest):
    COMMAND = ("study", "terminal-index", "--seeds", "1", "-o", "out", "--maps", MAPS)

    def out(self, *parts):
        return os.path.join(self.folder, "out", *parts)

    def runs(self):
        return [os.path.join(at, f) for at, _, files in os.walk(self.out("runs")) for f in files]

    def test_lists_what_there_is(self):
        run = self.quiet(self.run_program("study", "list"))
        names = [line.split("\t")[0] for line in run.out.splitlines()]
        # The studies on polygons are there where polygons were built.
        self.assertEqual([name for name in names if name != "maklink"],
                         ["fan2004", "terminal-index", "cong2009", "lecture-grid",
                          "neighbourhoods", "families", "goritov2020", "online", "tours"])

    def test_refuses_what_it_does_not_know(self):
        self.refused(self.run_program("study", "fan2005", "-o", "out"), 2, "fan2004")
        self.refused(self.run_program("study", "fan2004", "--seeds", "0"), 2, "--seeds")
        self.refused(self.run_program("study", "fan2004", "--maps", "nowhere"), 3, "fan400x200.map")

    def test_a_folder_that_cannot_be_made(self):
        self.write("file", "")
        for name in ("terminal-index", "goritov2020"):
            self.refused(self.run_program("study", name, "-o", "file/out"), 7, "file/out")

    def test_maklink(self):
        if "maklink" not in self.run_program("study", "list").out:
            self.skipTest("this lasius was built without polygon worlds")
        run = self.run_program("study", "maklink", "--seeds", "3", "-o", "m", "--maps", MAPS)
        self.assertEqual((run.code, run.out), (0, "m/report.md\n"))
        self.assertRegex(run.err, r"^lasius: maklink: 21 runs, about \d+ (s|min) with \d+ threads")
        rows = self.rows("m/runs.csv")
        self.assertEqual(len(rows), 21)
        for row in rows:
            self.assertGreaterEqual(float(row["length"]), float(row["own_limit"]) * (1 - 1e-12))
        self.assertIn("What the source claims", self.read("m/report.md").decode())
        for row in self.rows("m/claims.csv"):
            self.assertTrue(row["outcome"] and row["place"], row)
        quiet = self.run_program("study", "maklink", "--seeds", "3", "-o", "m", "--maps", MAPS, "-q")
        self.assertEqual((quiet.code, quiet.err), (0, ""))

    def test_all_makes_one_table_and_can_be_stopped(self):
        process = self.start_program("study", "all", "--seeds", "1", "-o", "out", "--maps", MAPS,
                                     "-q")
        while process.poll() is None and not os.path.isdir(self.out("fan2004", "runs")):
            pass
        out, err = self.interrupted(process, timeout=None)
        self.assertEqual(out, b"", err)
        text = self.read("out/claims.md").decode()
        self.assertIn("\n## `fan2004`\n", text)
        self.assertIn("interrupted", self.read("out/claims/fan2004.md").decode())
        self.assertNotIn("| confirmed |", text)

    def test_goes_on_where_it_stopped_and_reports(self):
        process = self.start_program(*self.COMMAND)
        while process.poll() is None and not self.runs():
            pass
        out, err = self.interrupted(process, timeout=None)
        self.assertEqual(out, b"")
        self.assertIn(b"goes on", err)
        text = self.read("out/report.md").decode()
        self.assertIn("Partial: interrupted", text)
        self.assertNotIn("| confirmed |", text)
        self.assertNotIn("| **refuted** |", text)
        kept = {f: os.stat(f).st_mtime_ns for f in self.runs()}
        self.assertTrue(kept)

        run = self.run_program(*self.COMMAND)
        self.assertEqual((run.code, run.out), (0, "out/report.md\n"), run.err)
        for file, time_ns in kept.items():
            self.assertEqual(os.stat(file).st_mtime_ns, time_ns)
        self.assertEqual(len(self.rows("out/runs.csv")), len(self.runs()))
        text = self.read("out/report.md").decode()
        for word in ("optimum of 8 moves", "What the source claims", "index off", "cannot decide with 1 seeds"):
            self.assertIn(word, text)
        for name in ("paths", "convergence"):
            for ending in ("svg", "png"):
                picture = f"pictures/example-grid20a-{name}.{ending}"
                self.assertIn(picture, text)
                self.assertGreater(os.path.getsize(self.out(picture)), 1000)


if __name__ == "__main__":
    unittest.main()
