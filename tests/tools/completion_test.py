"""What shells complete: what the program answers, and bash, zsh and fish themselves."""
import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

from program import MAPS, PROGRAM, ProgramTest

SHELLS = os.path.join(os.path.dirname(MAPS), "tools", "manual", "shells")


def paths(folder):
    return ":".join((os.path.join(folder, "bin"), os.path.dirname(PROGRAM), os.environ["PATH"]))


class CompletionTest(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("other.png", "notes.txt", "world.geojson", "result.json"):
            self.write(name, "")
        os.mkdir(self.path("folder"))


class Answers(CompletionTest):
    def answers(self, *words):
        """{word: meaning}, of files the endings."""
        run = self.quiet(self.run_program("complete", *words))
        return dict(line.split("\t") for line in run.out.splitlines())

    def names(self, *words):
        return list(self.answers(*words))

    def test_commands(self):
        found = self.answers("")
        self.assertEqual(found["plan"], "Plan one path")
        for command in found:
            self.assertEqual(self.run_program(command, "--help").code, 0, command)
        self.assertEqual(self.names("pl"), ["plan"])
        self.assertEqual(self.names("--v"), ["--version"])
        self.assertEqual(self.names("nothing"), [])
        self.assertEqual(self.names("nothing", ""), [])
        self.assertEqual(self.run_program("complete").code, 0)

    def test_all_options_of_every_command(self):
        for command in self.names(""):
            shown = self.run_program(command, "--help").out
            options = re.findall(r"^  (?:-\w, )?(--[a-z-]+)", shown, re.MULTILINE)
            self.assertEqual(self.names(command, "-"), options, command)

    def test_an_option_is_offered_once_unless_it_repeats(self):
        self.assertEqual(self.names("plan", "--see"), ["--seed"])
        self.assertEqual(self.names("plan", "--seed", "1", "--see"), [])
        self.assertEqual(self.names("plan", "--seed=1", "--see"), [])
        self.assertEqual(self.names("plan", "-o", "a.png", "--outp"), ["--output"])
        self.assertEqual(self.names("plan", "--", "--see"), [":files"])

    def test_algorithms_by_world(self):
        bitmap = self.names("plan", "a.map", "--algorithm", "")
        polygon = self.names("plan", "a.geojson", "--algorithm", "")
        arm = self.names("arm", "--algorithm", "")
        known = self.run_program("algorithms", "--json").json
        for names, key in ((bitmap, "algorithms"), (polygon, "polygon_algorithms"), (arm, "arm_algorithms")):
            if key in known:
                self.assertEqual(names, [a["name"] for a in known[key]])
        self.assertEqual(set(self.names("plan", "--algorithm", "")), {*bitmap, *polygon})
        self.assertEqual(self.names("drive", "--algorithm=fan"), ["--algorithm=fan2004"])
        self.assertLess(set(bitmap), set(self.names("algorithms", "")))
        self.assertEqual(self.answers("plan", "--algorithm", "mmas")["mmas"],
                         next(a["summary"] for a in known["algorithms"] if a["name"] == "mmas"))

    def test_parameters_and_their_values(self):
        self.assertEqual(self.names("plan", "a.map", "--algorithm", "mmas", "--set", "pers"), ["persistence="])
        self.assertEqual(self.names("plan", "a.map", "--algorithm", "exact", "--set", "pers"), [])
        self.assertEqual(self.names("plan", "a.map", "--set", "pers"), ["persistence="])
        self.assertEqual(self.names("plan", "--set", "polish=s"), ["polish=straight"])
        self.assertEqual(self.names("plan", "--set=polish=s"), ["--set=polish=straight"])
        self.assertEqual(self.names("plan", "--set", "persistence="), [])
        self.assertIn("pitch=", self.names("arm", "--set", ""))
        self.assertEqual(self.names("study", "run", "--algorithm", "as,mm"), ["as,mmas"])
        self.assertEqual(self.names("study", "run", "--set", "polish=none,s"), ["polish=none,straight"])

    def test_choices_files_and_folders(self):
        self.assertEqual(self.names("plan", "--corners", ""), ["forbid", "one-side", "allow"])
        self.assertEqual(self.names("generate", "ma"), ["maze"])
        self.assertEqual(self.names("generate", "maze", ""), self.names("generate", "maze", "-"))
        self.assertIn(".map ", self.answers("plan", "")[":files"])
        self.assertIn(".geojson ", self.answers("plan", "")[":files"])
        self.assertNotIn(".geojson ", self.answers("drive", "")[":files"])
        self.assertIn(".gif ", self.answers("drive", "-o", "")[":files"])
        self.assertEqual(self.answers("drive", "--changes", "")[":files"], "")
        self.assertEqual(self.names("arm", "r.urdf", "--package", ""), [])
        self.assertEqual(self.names("study", "fan2004", "-o", ""), [":folders"])
        self.assertLess({"list", "all", "fan2004"}, set(self.names("study", "")))
        self.assertEqual(self.names("plan", "--preset", ""), ["usual", "book", ":files"])
        self.assertLess({"json", "plan"}, set(self.names("help", "")))

    def test_endings_are_those_that_output_takes(self):
        for command in ("plan", "batch", "drive"):
            words = ["small.map", "q.tsv"] if command == "batch" else ["small.map", "--start", "0,0", "--goal", "9,5"]
            refused = self.run_program(command, *words, "-o", "picture.nothing").err
            for ending in self.answers(command, "-o", "")[":files"].split():
                self.assertIn(ending, refused, command)


class Terminal:
    """An interactive shell, typed at."""

    SHOW = "printf 'LI''NE<%s>\\n' "

    def __init__(self, words, folder, home):
        self.child, self.at = pty.fork()
        if self.child == 0:
            os.chdir(folder)
            os.environ.update(HOME=home, TERM="dumb", LC_ALL="C.UTF-8", HISTFILE="",
                              PATH=paths(home))
            os.execvp(words[0], words)
        self.shown = ""

    def read_until(self, pattern, seconds=60):
        give_up = time.monotonic() + seconds
        while not re.search(pattern, self.shown):
            if time.monotonic() > give_up or not select.select([self.at], [], [], seconds)[0]:
                raise AssertionError(f"no {pattern} in {self.shown!r}")
            self.shown += os.read(self.at, 65536).decode(errors="replace").replace("\r", "")
        found, self.shown = self.shown, ""
        return found

    def type(self, text):
        os.write(self.at, text.encode())

    def run(self, line):
        self.type(line + "; echo DO''NE\n")
        return self.read_until("DONE")

    def completed(self, line):
        """The words of the line after a TAB."""
        self.type(line + "\t\x01" + self.SHOW + "\x05; echo DO''NE\n")
        return re.findall("LINE<(.*)>", self.read_until("DONE\n"))[1:]

    def close(self):
        self.type("\x03\x04exit\n")
        os.close(self.at)
        os.waitpid(self.child, 0)


class Shells(CompletionTest):
    # The line typed, and the last word that TAB makes of it.
    CASES = [("lasius pla", "plan"),
             ("lasius plan smal", "small.map"),
             ("lasius plan oth", "other.png"),
             ("lasius plan not", "not"),
             ("lasius plan ./fol", "./folder/"),
             ("lasius plan small.map --algo", "--algorithm"),
             ("lasius plan small.map --algorithm fan", "fan2004"),
             ("lasius plan small.map --algorithm=fan", "--algorithm=fan2004"),
             ("lasius plan small.map --algorithm mmas --set pers", "persistence="),
             ("lasius plan small.map --set polish=st", "polish=straight"),
             ("lasius plan small.map --corners one", "one-side"),
             ("lasius verify res", "result.json"),
             ("lasius plan world.geojson --algorithm maklink", "maklink-acs"),
             ("lasius study fan2004 -o fol", "folder/"),
             ("lasius help exit", "exit-codes"),
             ("lasius_mpi batch --thr", "--threads")]

    def setUp(self):
        super().setUp()
        os.makedirs(self.path("bin"))
        os.symlink(PROGRAM, self.path("bin/lasius_mpi"))

    def shell(self, name):
        if shutil.which(name) is None:
            self.skipTest(f"SKIPPED: no {name} on this machine")

    def check(self, terminal):
        self.addCleanup(terminal.close)
        for line, last in self.CASES:
            if last == "maklink-acs" and not self.polygons():
                continue
            with self.subTest(line=line):
                found = terminal.completed(line)
                # A shell may take the slash of a folder back.
                found[-1:] = [word + "/" * (last == word + "/") for word in found[-1:]]
                self.assertEqual(found, [*line.split()[1:-1], last])

    def polygons(self):
        return "polygon_algorithms" in self.run_program("algorithms", "--json").json

    def test_bash(self):
        self.shell("bash")
        terminal = Terminal(["bash", "--norc", "--noprofile", "-i"], self.folder, self.folder)
        terminal.run("bind 'set enable-bracketed-paste off'; PS1='$ '")
        terminal.run(f"source {SHELLS}/lasius.bash")
        self.check(terminal)

    def test_zsh(self):
        self.shell("zsh")
        terminal = Terminal(["zsh", "-f", "-i"], self.folder, self.folder)
        terminal.run(f"unsetopt zle_bracketed_paste prompt_cr prompt_sp; bindkey -e; PS1='$ '; fpath=({SHELLS} $fpath)")
        terminal.run("autoload -U compinit; compinit -u -D; LISTMAX=0")
        self.check(terminal)

    def test_fish(self):
        self.shell("fish")
        for line, last in self.CASES:
            if last == "maklink-acs" and not self.polygons():
                continue
            done = subprocess.run(
                ["fish", "--no-config", "-c", f"source {SHELLS}/lasius.fish; complete --do-complete '{line}'"],
                cwd=self.folder, capture_output=True, text=True, timeout=120, check=False,
                env={**os.environ, "HOME": self.folder, "PATH": paths(self.folder)})
            words = [found.split("\t")[0] for found in done.stdout.splitlines()]
            with self.subTest(line=line):
                self.assertEqual(done.stderr, "")
                self.assertEqual(words, [last] if last != "not" else [])


if __name__ == "__main__":
    unittest.main()
