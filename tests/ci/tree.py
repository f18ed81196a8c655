"""A small repository for a script of .ci to look at. Standard library only."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / ".ci"


class TreeTest(unittest.TestCase):
    """Each test has an empty repository of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="lasius-test-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.git("init", "-q")
        self.tracked = set()

    def git(self, *arguments):
        subprocess.run(["git", "-C", self.root, *arguments], check=True)

    def write(self, name, text, tracked=True):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        if tracked:
            self.tracked.add(name)

    def check(self, script):
        """Exit code and output of .ci/SCRIPT on this repository."""
        self.git("add", "--", *self.tracked)
        done = subprocess.run([sys.executable, "-B", SCRIPTS / script, self.root],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertNotIn("Traceback", done.stdout)
        return done.returncode, done.stdout

    def assert_passes(self, script):
        code, out = self.check(script)
        self.assertEqual(code, 0, out)
        return out

    def assert_fails(self, script, *sentences):
        code, out = self.check(script)
        self.assertEqual(code, 1, out)
        for sentence in sentences:
            self.assertIn(sentence, out)
        return out
