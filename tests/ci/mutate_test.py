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
            self.assertEqual(mutate.run("sh", "-c", "echo said; exit 3"), (3, "said\n"))
            for name in ("never", "pipe"):
                os.mkfifo(os.path.join(folder, name))
            reader = os.open(os.path.join(folder, "pipe"), os.O_RDONLY | os.O_NONBLOCK)
            self.addCleanup(os.close, reader)
            # Its child waits for ever, and holds both ends that are read here.
            self.assertEqual(mutate.run("sh", "-c", "cat never >pipe & wait", seconds=0.2), (None, ""))
            os.set_blocking(reader, True)
            self.assertEqual(os.read(reader, 1), b"")  # waits for whoever could still write


if __name__ == "__main__":
    unittest.main()
