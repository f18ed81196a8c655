"""`lasius help`, --help and the manual pages: all of one source, and true."""
import gzip
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

from layers import map_text, pfm
from program import MAPS, PROGRAM, ProgramTest

ROOT = os.path.dirname(MAPS)
DOCUMENTS = os.path.join(ROOT, "docs")


def document(name):
    with open(os.path.join(DOCUMENTS, name + ".md"), encoding="utf-8") as file:
        return file.read()


class HelpTest(ProgramTest):
    algorithm = "exact"  # what is shown is what is run

    def text(self, *words):
        shown = self.run_program(*words)
        self.assertEqual((shown.code, shown.err), (0, ""), words)
        return shown.out

    def listed(self, heading):
        """The labels of a list of `lasius help`."""
        part = self.text("help").partition(heading + ":\n")[2].partition("\n\n")[0]
        return re.findall(r"^  (\S+)  ", part, re.MULTILINE)

    def commands(self):
        return self.listed("Commands")

    def words_of(self, text):
        return " ".join(text.split())


class Help(HelpTest):
    def test_the_program(self):
        self.assertEqual(self.text("help"), self.text("--help"))
        self.assertLess({"plan", "batch", "drive", "verify", "help"}, set(self.commands()))
        self.assertLess({"json", "exit-codes", "algorithms", "environment"}, set(self.listed("Topics")))

    def test_help_of_a_command_is_its_help_option(self):
        topics = self.listed("Topics")
        for command in self.commands():
            with self.subTest(command=command):
                shown = self.text(command, "--help")
                self.assertTrue(shown.startswith(f"Usage: lasius {command}"))
                self.assertIn("\nExit codes:\n  0 ", shown)
                if command not in topics:
                    self.assertEqual(self.text("help", command), shown)
                for line in shown.splitlines():
                    self.assertTrue(len(line) <= 80 or line.startswith("    lasius "), line)

    def test_unknown_topics(self):
        self.refused(self.run_program("help", "jsno"), 2, 'did you mean "json"')
        self.refused(self.run_program("help", "json", "more"), 2, "one argument too many")

    def test_usage_names_what_must_be_there(self):
        self.assertIn("Usage: lasius generate KIND --size WxH -o FILE [options]\n",
                      self.text("generate", "--help"))
        self.assertIn("Usage: lasius help [TOPIC] [options]\n", self.text("help", "--help"))

    def test_lists_in_an_options_help(self):
        shown = self.text("plan", "--help")
        self.assertRegex(shown, r"\n( {20,})\.json {2,}what --json prints\n\1\.csv {2,}\w")

    def test_topics_are_the_documents(self):
        for topic, name, heading in (("exit-codes", "program", "Exit codes"),
                                     ("environment", "program", "Environment"),
                                     ("json", "driving", "JSON of a drive")):
            part = re.split(r"^#+ ", document(name).partition(f"## {heading}\n")[2],
                            flags=re.MULTILINE)[0]
            shown = self.text("help", topic)
            labels = re.findall(r"^\| `?([A-Za-z_0-9]+)`?[ ,].*\|$", part, re.MULTILINE)[1:]
            self.assertGreater(len(labels), 1, topic)
            for label in labels:
                self.assertRegex(shown, rf"(?m)^  {label}\b", topic)

    def test_links_and_bars_are_plain(self):
        shown = self.text("help", "driving")
        self.assertNotIn("](", shown)
        self.assertIn("see library.md", self.words_of(shown))
        self.assertIn("  TICK X Y blocked|free  ", shown)
        self.assertNotIn("\\|", self.text("help", "json"))

    def test_every_algorithm_is_in_its_topic(self):
        shown = self.text("help", "algorithms")
        known = self.run_program("algorithms", "--json").json
        worlds = [world for world in known.values() if isinstance(world, list)]
        for algorithm in sum(worlds, []):
            self.assertRegex(shown, rf"(?m)^  {algorithm['name']} ")

    def test_every_field_of_a_result_is_told(self):
        def check(result, *command):
            shown = self.words_of(self.text(*command, "--help").partition("JSON:")[2])
            topic = self.text("help", "json")
            for field in result:
                self.assertRegex(topic, rf"\b{field}\b", command)
            return shown

        plan = self.plan("--json", "--gap", "--algorithm", "fan2004", "--iterations", "2").json
        shown = check(plan, "plan")
        for field in plan:
            self.assertIn(f"`{field}`", shown)
        check(self.run_program("drive", "small.map", "--start", "0,0", "--goal", "9,5", "--json").json,
              "drive")
        self.write("stops.tsv", "0 0\n9 5\n")
        check(self.run_program("tour", "small.map", "--stops", "stops.tsv", "--json").json, "tour")

    def test_examples_run(self):
        os.symlink(MAPS, self.path("maps"))
        self.write("queries.tsv", "sx\tsy\tgx\tgy\n14\t14\t380\t179\n")
        for part in ("1", "2"):
            answers = self.run_program("batch", "maps/fan400x200.map", "queries.tsv", "--part", part + "/2")
            self.write(f"part{part}.jsonl", answers.out)
        self.write("stops.tsv", "x\ty\n3\t4\n20\t10\n9\t25\n")
        self.write("stops.json", "[[3, 4], [20, 10], [9, 25]]")
        self.write("world.map", map_text(["." * 40] * 30))
        self.write("car.yaml", "{footprint: [[-1, -1], [3, -1], [3, 1], [-1, 1]], turning_radius: 4}")
        self.write("path.csv", "x,y\n14,14\n16,16\n")
        self.write("world.pfm", pfm([[x * y % 7 for x in range(40)] for y in range(30)]))
        slow = "lasius study fan2004"  # minutes
        count = 0
        commands = self.commands()
        commands.sort(key=lambda name: name in ("verify", "check-proof", "check-path"))  # of what plan wrote
        for command in commands:
            text = self.text(command, "--help").partition("\nExamples:\n")[2]
            for line in re.findall(r"^    (lasius .*)$", text, re.MULTILINE):
                if line.startswith(slow):
                    continue
                if command == "arm" and self.without_arms():
                    continue
                with self.subTest(line=line):
                    run = self.ended(self.run_program(*shlex.split(line)[1:]), 0)
                    self.assertNotIn("no effect", run.err)
                count += 1
        self.assertGreater(count, 10)

    def without_arms(self):
        return "arm_algorithms" not in self.run_program("algorithms", "--json").json


class ManualPages(HelpTest):
    @classmethod
    def make_pages(cls):
        """All pages by name."""
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.path.join(ROOT, "tools", "manual", "make_manual"), "pages", PROGRAM, folder],
                           check=True, timeout=600)
            return {file.name: file.read_bytes() for file in pathlib.Path(folder).iterdir()}

    @classmethod
    def setUpClass(cls):
        cls.made = cls.make_pages()

    def pages(self):
        return sorted(self.made)

    def test_a_page_for_each_command(self):
        self.assertEqual(self.pages(), sorted(["lasius.1", *(f"lasius-{name}.1" for name in self.commands()), "lasius_mpi.1"]))

    def test_the_same_every_time(self):
        self.assertEqual(self.make_pages(), self.made)

    def test_the_build_has_them(self):
        folder = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "man")
        if not os.path.isdir(folder):
            self.skipTest(f"SKIPPED: no {folder}: a build without install rules")
        self.assertEqual(sorted(os.listdir(folder)), [name + ".gz" for name in self.pages()])
        for name in self.pages():
            with gzip.open(os.path.join(folder, name + ".gz")) as file:
                self.assertEqual(file.read(), self.made[name], name)

    def test_every_option_is_on_its_page(self):
        for command in self.commands():
            page = self.made[f"lasius-{command}.1"].decode().replace("\\-", "-")
            shown = self.text(command, "--help").partition("\nOptions:\n")[2].partition("\n\n")[0]
            options = re.findall(r"^  (?:-\w, )?(--[a-z-]+)", shown, re.MULTILINE)
            self.assertIn("--help", options)
            for option in options:
                self.assertRegex(page, rf"(?m)^\\fB(-\w, )?{option}\\fR", command)

    def test_requests_and_escapes(self):
        for name in self.pages():
            for line in self.made[name].decode().splitlines():
                self.assertNotIn("`", line)
                if line.startswith("."):
                    self.assertRegex(line, r"^\.(TH|SH|SS|TP|PP|RS|RE|nf|fi)\b", name)

    def lint(self, tool, *arguments):
        if shutil.which(tool) is None:
            self.skipTest(f"SKIPPED: no {tool} on this machine")
        for name, page in self.made.items():
            with open(self.path(name), "wb") as file:
                file.write(page)
            done = subprocess.run([tool, *arguments, self.path(name)], check=False,
                                  capture_output=True, text=True, timeout=60,
                                  env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
            yield name, done

    def test_mandoc_finds_no_fault(self):
        for name, done in self.lint("mandoc", "-T", "lint", "-W", "warning"):
            self.assertEqual((done.returncode, done.stdout), (0, ""), name)

    def test_man_finds_no_fault(self):
        for name, done in self.lint("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z"):
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)


if __name__ == "__main__":
    unittest.main()
