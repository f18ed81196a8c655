"""Runs the built program as a user would. Standard library only."""
import csv
import io
import json
import os
import signal
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

PROGRAM = os.environ["LASIUS_PROGRAM"]
MAPS = os.environ["LASIUS_MAPS_DIR"]
SVG = "{http://www.w3.org/2000/svg}"

# nohup and a shell's jobs in the background ignore these, and so would the program.
for number in (signal.SIGHUP, signal.SIGQUIT):
    signal.signal(number, signal.SIG_DFL)

# Free cells are dots. (0,0)-(9,5) is joined, (6,2) lies in a closed cell, (3,2) is blocked.
SMALL_MAP = """type octile
height 6
width 10
map
..........
...@@@@@@.
...@..@.@.
...@@@@@@.
....@.....
..........
"""


class Run:
    """What a finished run left: code, out, err."""

    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr

    @property
    def json(self):
        return json.loads(self.out, parse_constant=refuse_constant)

    @property
    def lines(self):
        return [json.loads(line, parse_constant=refuse_constant)
                for line in self.out.splitlines()]


def refuse_constant(name):
    raise ValueError(f"{name} is no JSON")


def environment(extra):
    clean = {k: v for k, v in os.environ.items() if k not in ("LASIUS_THREADS", "OMP_NUM_THREADS")}
    # Threads that wait shall sleep: other tests run beside this one.
    return {**clean, "OMP_WAIT_POLICY": "passive", **(extra or {})}


def tuning(iterations=50, candidates=8, maps=3, draw=2, first_test=4, blocks=30, seeds=5):
    """What `lasius tune` reads; the most ants and iterations are best."""
    return f"""
algorithm: mmas
set: {{ants: 1, iterations: 1}}
parameters: {{ants: [1, 10], iterations: [2, {iterations}]}}
candidates: {candidates}
maps: {{b: {{kind: blobs, size: 40x30, density: 0.3, seeds: 1..{maps}}}}}
optimum: 8 moves
training: [{{map: b, draw: {draw}}}]
race: {{first_test: {first_test}, blocks: {blocks}}}
seeds: 1..{seeds}
"""


class ProgramTest(unittest.TestCase):
    """Each test runs in a folder of its own that holds small.map."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="lasius-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("small.map", SMALL_MAP)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def rows(self, name):
        """A table with a header, row by row."""
        return list(csv.DictReader(io.StringIO(self.read(name).decode(), newline="")))

    # Most tests want iterations to look at, which the default algorithm has not.
    algorithm = "fan2004"

    def command(self, arguments):
        words = [PROGRAM, *map(str, arguments)]
        if words[1:2] not in (["plan"], ["batch"]) or {"--algorithm", "--vehicle"} & set(words):
            return words
        return words[:2] + ["--algorithm", self.algorithm] + words[2:]

    def run_program(self, *arguments, env=None, **options):
        return Run(subprocess.run(self.command(arguments), cwd=self.folder,
                                  env=environment(env), stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, timeout=120, check=False,
                                  **options))

    def start_program(self, *arguments, **options):
        return subprocess.Popen(self.command(arguments), cwd=self.folder,
                                env=environment(None), stdin=subprocess.DEVNULL,
                                stdout=options.pop("stdout", subprocess.PIPE),
                                stderr=subprocess.PIPE, **options)

    def interrupted(self, process, number=signal.SIGINT, timeout=60):
        """What a run still writes once a signal ends it, with exit code 130."""
        process.send_signal(number)
        out, err = process.communicate(timeout=timeout)
        self.assertEqual(process.returncode, 130, err)
        return out, err

    def plan(self, *arguments, start="0,0", goal="9,5", map_file="small.map", **options):
        return self.run_program("plan", map_file, "--start", start, "--goal", goal, *arguments,
                                **options)

    def ended(self, run, code, *words):
        """The run, whose exit code is `code` and whose messages say all `words`."""
        self.assertEqual(run.code, code, run.err)
        self.holds(run.err, *words)
        return run

    def quiet(self, run):
        """The run, which ended well and without a message."""
        self.assertEqual((run.code, run.err), (0, ""))
        return run

    def refused(self, run, code, *words):
        """Exit code `code`, nothing on stdout, and a message that says all `words`."""
        self.assertEqual(self.ended(run, code, *words).out, "")

    def replay_of(self, result, *options):
        """What verify says of a result."""
        self.write("bad.json", json.dumps(result))
        return self.run_program("verify", *options, "bad.json")

    def svg_root(self, name):
        root = xml.etree.ElementTree.fromstring(self.read(name))
        self.assertEqual(root.tag, SVG + "svg")
        return root

    def words(self, name):
        """All texts of a picture, of which none is cut; lines are joined."""
        text = self.svg_root(name).find(SVG + "desc").text
        self.assertNotIn("...", text)
        return text.replace("\n", " ").replace("\u00a0", " ")

    def holds(self, text, *parts):
        for part in parts:
            self.assertIn(part, text)

    def png_pixels(self, name):
        """Rows of (red, green, blue) of a PNG of 8 bits a channel without a palette."""
        width, height = self.png_size(name)
        data = self.read(name)
        channels = {2: 3, 6: 4}[data[25]]
        position, packed = 8, b""
        while position < len(data):
            length, kind = struct.unpack(">I4s", data[position:position + 8])
            packed += data[position + 8:position + 8 + length] if kind == b"IDAT" else b""
            position += 12 + length
        raw, size = zlib.decompress(packed), width * channels
        above, rows = bytearray(size), []
        for y in range(height):
            start = y * (size + 1)
            row = bytearray(raw[start + 1:start + 1 + size])
            filtered = raw[start]
            if filtered == 2:
                row = bytearray((a + b) & 255 for a, b in zip(row, above))
            elif filtered:
                for i in range(size):
                    left = row[i - channels] if i >= channels else 0
                    guess = left if filtered == 1 else (left + above[i]) // 2
                    if filtered == 4:
                        corner = above[i - channels] if i >= channels else 0
                        guess = min((left, above[i], corner),
                                    key=lambda v: abs(left + above[i] - corner - v))
                    row[i] = (row[i] + guess) & 255
            rows.append([tuple(row[i:i + 3]) for i in range(0, size, channels)])
            above = row
        return rows

    def png_size(self, name):
        """Width and height of a PNG whose every chunk is whole."""
        data = self.read(name)
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        position, kinds = 8, []
        while position < len(data):
            length, kind = struct.unpack(">I4s", data[position:position + 8])
            body = data[position + 4:position + 8 + length]
            self.assertEqual(struct.unpack(">I", data[position + 8 + length:][:4])[0],
                             zlib.crc32(body))
            kinds.append(kind)
            position += 12 + length
        self.assertEqual((kinds[0], kinds[-1]), (b"IHDR", b"IEND"))
        return struct.unpack(">II", data[16:24])
