"""What is built or tested for a mutant ends whole when it takes too long."""
import importlib.machinery
import importlib.util
import os
import pathlib
import tempfile
import unittest

SCRIPT = str(pathlib.Path(__file__).resolve().parent.parent.parent / ".ci/mutate")


class Mutate(unittest.TestCase):
    def test_no_process_is_left(self):
        loader = importlib.machinery.SourceFileLoader("mutate", SCRIPT)
        mutate = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
        loader.exec_module(mutate)
        with tempfile.TemporaryDirectory() as folder:
            mutate.TREE = folder
            os.mkfifo(os.path.join(folder, "pipe"))
            self.assertEqual(mutate.run("sh", "-c", "echo said; exit 3"), (3, "said\n"))
            # Its child holds the output, and would wait for ever.
            self.assertEqual(mutate.run("sh", "-c", "cat pipe & wait", seconds=0.2), (None, ""))
            with self.assertRaises(OSError):  # nobody reads
                os.open(os.path.join(folder, "pipe"), os.O_WRONLY | os.O_NONBLOCK)


if __name__ == "__main__":
    unittest.main()
