"""lasius check-proof, and tools/check_proof, which shares nothing with it: both say the same of proofs."""
import json
import pathlib
import random
import struct
import subprocess
import sys
import unittest

from layers import map_text, npy, pfm, random_map
from program import ProgramTest

SCRIPT = pathlib.Path(__file__).parents[2] / "tools" / "check_proof"
INFLATION = ("--inflation", "4,0.5,3")


def has_numpy():
    return subprocess.run([sys.executable, "-c", "import numpy"], capture_output=True, check=False).returncode == 0


class Proofs(ProgramTest):
    def setUp(self):
        super().setUp()
        rng = random.Random(7)
        for i in range(12):
            while True:
                width, height = rng.randint(8, 37), rng.randint(8, 37)
                self.write(f"{i}.map", map_text(random_map(rng, width, height)))
                self.write(f"{i}.pfm", pfm([[rng.randrange(40) / 8 for _ in range(width)] for _ in range(height)]))
                if self.run_program("plan", f"{i}.map", "--algorithm", "exact", "--start", "0,0", "--goal",
                                    f"{width - 1},{height - 1}", "--cost", f"{i}.pfm", *INFLATION,
                                    "-o", f"{i}.proof.json", "-o", f"{i}.proof.cbor").code == 0:
                    if i == 0:
                        self.far = f"{width - 1},{height - 1}"
                    break

    def check(self, i, proof=None, *options):
        return self.run_program("check-proof", f"{i}.map", proof or f"{i}.proof.json",
                                *(options or ("--cost", f"{i}.pfm", *INFLATION)))

    def script(self, i, proof=None):
        return subprocess.run([sys.executable, SCRIPT, f"{i}.map", proof or f"{i}.proof.json", "--cost",
                               f"{i}.pfm", *INFLATION], cwd=self.folder, capture_output=True, text=True, check=False)

    def test_proofs_hold(self):
        for i in range(12):
            run = self.quiet(self.check(i))
            proof = json.loads(self.read(f"{i}.proof.json"))
            ends = "({}, {}) and ({}, {})".format(*proof["start"], *proof["goal"])
            self.assertEqual(run.out, f"holds: no path between the centres of cells {ends} costs less than "
                             f"{proof['lower_bound']}\n")
            self.assertEqual(self.check(i, f"{i}.proof.cbor").out, run.out)

    @unittest.skipUnless(has_numpy(), f"{sys.executable} has no numpy, which tools/check_proof needs")
    def test_a_proof_over_one_layer_alone(self):
        self.quiet(self.run_program("plan", "0.map", "--algorithm", "exact", "--start", "0,0", "--goal",
                                    self.far, "--cost", "0.pfm",
                                    "-o", "alone.proof.cbor", "-q"))
        script = subprocess.run([sys.executable, SCRIPT, "0.map", "alone.proof.cbor", "--cost", "0.pfm"], cwd=self.folder,
                                capture_output=True, text=True, check=False)
        self.assertEqual(script.returncode, 0, script.stderr)

    def changed(self):
        """Proofs of which one number is another."""
        for i in range(12):
            proof = json.loads(self.read(f"{i}.proof.json"))
            level = proof["levels"][i % len(proof["levels"])]
            if i % 3 == 0:
                proof["lower_bound"] *= 1.001
            elif i % 3 == 1:
                level["values"][len(level["values"]) // 2] += 30 * level["block"]
            else:
                level["runs"][2] -= 1
            self.write("changed.json", json.dumps(proof))
            yield i

    def test_one_changed_number_is_refused(self):
        for i in self.changed():
            run = self.check(i, "changed.json")
            self.assertEqual((run.code, run.err), (1, ""))
            self.holds(run.out, "does not hold: ")

    @unittest.skipUnless(has_numpy(), f"{sys.executable} has no numpy, which tools/check_proof needs")
    def test_the_script_says_the_same(self):
        for i in range(12):
            for proof in (None, f"{i}.proof.cbor") if i < 3 else (None,):
                run = self.script(i, proof)
                self.assertEqual(run.returncode, 0, run.stderr)
        for i in self.changed():
            run = self.script(i, "changed.json")
            self.assertEqual(run.returncode, 1)
            self.holds(run.stderr, "the proof does not hold: ")

    def test_proofs_are_of_one_plan(self):
        self.write("s.tsv", "x y\n0 0\n9 9\n")
        for command in (("tour", "0.map", "--stops", "s.tsv"), ("drive", "0.map", "--start", "0,0", "--goal", "9,9"),
                        ("batch", "0.map", "q.tsv")):
            for ending in ("json", "cbor"):
                self.refused(self.run_program(*command, "-o", f"t.proof.{ending}"), 2, "-o t.proof." + ending)

    def test_other_inputs(self):
        self.holds(self.check(0, None, "--cost", "0.pfm*2", *INFLATION).out, "does not hold: the proof is of other costs")
        self.holds(self.check(0, None, *INFLATION).out, "does not hold: the proof is of other costs")
        self.holds(self.run_program("check-proof", "small.map", "0.proof.json").out,
                   "does not hold: the proof is of another map")

    def test_layers(self):
        """The same numbers as .npy are the same costs."""
        pfm = self.read("0.pfm")
        _, size, _, rest = pfm.split(b"\n", 3)
        width, height = map(int, size.split())
        values = struct.unpack(f"<{width * height}f", rest)
        npy_file = npy([values[y * width:(y + 1) * width] for y in reversed(range(height))])
        self.write("0.npy", npy_file)
        self.quiet(self.check(0, None, "--cost", "0.npy", *INFLATION))
        for content, says in ((npy_file[:-1], "bytes of values"), (npy_file[:40], "ends in its head"),
                              (npy_file.replace(b"<f8", b"<c8"), "another type"), (pfm[:9], "no PFM's"),
                              (pfm.replace(size, b"3 2"), "bytes of values"), (b"no", "no PNG, PGM, PBM or BMP image"),
                              (b"Pf\n1 1\n-1\n\0\0\0\0", "it has 1 x 1 values, the map"),
                              (npy_file[:-8] + struct.pack("<d", -1), "it holds -1")):
            self.write("bad", content)
            self.refused(self.check(0, None, "--cost", "bad"), 3, says)

    def test_what_is_broken(self):
        self.refused(self.check(0, "none.json"), 3, "none.json")
        self.write("bad.json", "{}")
        self.refused(self.check(0, "bad.json"), 3, "bad.json", 'lacks "format"')
        self.refused(self.check(0, None, "--inflation", "4"), 2, "--inflation")
        self.refused(self.check(0, None, "--cost", "0.pfm*-1"), 2, "--cost")


if __name__ == "__main__":
    unittest.main()
