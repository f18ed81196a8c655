"""What is run for a mutant ends whole when it takes too long, and harms nothing; the cases that execute a place."""
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / ".ci"
SCRIPT = str(FOLDER / "mutate")
sys.path.insert(0, str(FOLDER))
from executed import Executed  # noqa: E402


def script(folder):
    """.ci/mutate as a module that works in a folder."""
    loader = importlib.machinery.SourceFileLoader("mutate", SCRIPT)
    mutate = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
    loader.exec_module(mutate)
    mutate.TREE = folder
    return mutate


class Mutate(unittest.TestCase):
    @unittest.skipIf(os.geteuid() != 0, "others than root cannot harm /dev")
    def test_tests_of_a_mutant_harm_nothing(self):
        with tempfile.TemporaryDirectory(dir="/tmp") as folder:
            mutate = script(folder)
            shield = (*mutate.SHIELD[:-1], folder)
            if mutate.run(*shield, "true")[0] != 0:
                self.skipTest("unshare and mount are not allowed here, so that mutate refuses to run")
            name = os.path.basename(folder)  # of no other file
            for place in ("/dev", "/"):
                self.assertNotEqual(mutate.run(*shield, "touch", f"{place}/{name}")[0], 0)
                self.assertFalse(os.path.exists(f"{place}/{name}"))
            self.assertEqual(mutate.run(*shield, "sh", "-c", f"echo said >/dev/null; echo >{folder}/made; exit 5"),
                             (5, ""))
            self.assertTrue(os.path.exists(f"{folder}/made"))

    def test_no_process_is_left(self):
        with tempfile.TemporaryDirectory() as folder:
            mutate = script(folder)
            self.assertEqual(mutate.run("sh", "-c", "echo said; exit 3"), (3, "said\n"))
            for name in ("never", "pipe"):
                os.mkfifo(os.path.join(folder, name))
            reader = os.open(os.path.join(folder, "pipe"), os.O_RDONLY | os.O_NONBLOCK)
            self.addCleanup(os.close, reader)
            # Its child waits for ever, and holds both ends that are read here.
            self.assertEqual(mutate.run("sh", "-c", "cat never >pipe & wait", seconds=0.2), (None, ""))
            os.set_blocking(reader, True)
            self.assertEqual(os.read(reader, 1), b"")  # waits for whoever could still write

    def test_cases_that_execute_a_place(self):
        executed = Executed("/tree")
        functions = {
            # A function, and a lambda within it; a branch that is not taken.
            "outer": [[1, 5, 9, 2, 2, 0, 0, 0], [2, 9, 4, 4, 0, 0, 0, 0]],
            "inner": [[6, 5, 7, 9, 1, 0, 0, 0]],
        }
        executed.read_functions(json.dumps({"data": [{"functions": [
            {"name": name, "filenames": ["/tree/core/grid/a.cpp"], "regions": regions}
            for name, regions in functions.items()]}]}))
        names = {regions[0][0]: name for _, _, name, regions in executed.functions["core/grid/a.cpp"]}
        outer, inner = names[1, 5], names[6, 5]
        executed.read_cases("p", f"A.a 0.5 ok {outer}\nA.b 0.25 ok {outer} {inner}\nA.c 1 failed {inner}\n")
        self.assertEqual(executed.seconds, {("p", "A.a"): 0.5, ("p", "A.b"): 0.25})
        both, one = {("p", "A.a"), ("p", "A.b")}, {("p", "A.b")}
        for path, place, included_by, cases in (
                ("a.cpp", (1, 9), (), both), ("a.cpp", (3, 1), (), set()), ("a.cpp", (6, 7), (), one),
                ("a.cpp", (20, 1), (), both), ("a.h", (1, 1), ["core/grid/a.cpp"], both), ("a.h", (1, 1), (), set())):
            self.assertEqual(executed.at(f"core/grid/{path}", place, included_by), cases, (path, place))


if __name__ == "__main__":
    unittest.main()
