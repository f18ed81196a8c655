"""Every command ends within a second of SIGTERM, and leaves whole files or none.

LASIUS_ENDS is how many commands are tried (default 24; 1000 nightly), LASIUS_ENDS_SEED the first seed.
"""
import os
import random
import re
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from program import MAPS, PROGRAM, ProgramTest, environment

ARMS = os.path.join(MAPS, "arms")
CLAIMS = ["share: 0, to: 1", "share: 1e-300", "share: 1, best_of: 100000", "share: 0.5, from: nan",
          "share: 0.999999999"]
STUDY = """contenders: [{name: a, algorithm: as, set: {ants: 2, iterations: 2}}]
seeds: SEEDS
questions: [{map: "blobs SIZE 0.2 1", draw: DRAW}]
claims: [{text: x, test: most, a: a, CLAIM}]
"""
SWEEP = """contenders: [{name: as, algorithm: as}]
sweep: {design: DESIGN, points: POINTS, factors: {persistence: {from: 0, to: 1}, beta: {from: 0, to: 9}}}
budget: {BUDGET}
questions: [{map: "blobs 60x50 0.3 1", draw: DRAW}]
claims: [{text: x, test: less, a: as-1, b: [default, as-2]}]
"""
TUNING = """algorithm: mmas
set: {iterations: ITERATIONS}
parameters: {ants: [1, 10]}
candidates: CANDIDATES
maps: {b: {kind: blobs, size: 40x30, density: 0.3, seeds: 1..3}}
training: [{map: b, draw: DRAW}]
race: {first_test: 2, blocks: 3000}
seeds: 1..5
"""
CODES = {0, 1, 2, 3, 4, 5, 6, 7, 130}
ENDINGS = {".json": rb"\}\n\Z", ".csv": rb"\n\Z", ".svg": rb"</svg>\s*\Z", ".gif": rb";\Z",
           ".png": rb"IEND....\Z", ".html": rb"</html>\s*\Z", ".yaml": rb"\n\Z", ".map": rb"\n\Z",
           ".md": rb"\n\Z", ".pbm": rb""}


class Odd:
    """Commands with odd inputs, drawn from a seed."""

    def __init__(self, seed):
        self.draw = random.Random(seed)
        self.files = {}  # to be written before

    def one(self, *of):
        return self.draw.choice(of)

    def some(self, *options):
        """Some of the options, each a list of words."""
        return [word for option in options if self.draw.random() < 0.15 for word in option]

    def number(self):
        if self.draw.random() < 0.8:
            return self.one("0", "1", "2.5", "7", "40")
        return self.one("-1", "1000", "1e9", "nan", "", "99999999999999999999", "x")

    def count(self):
        return self.one("0", "1", "3", "50", "1000", "1000000000")

    def cell(self, side=1000):
        if self.draw.random() < 0.05:
            return self.number() + "," + self.number()
        return f"{self.draw.randrange(side)},{self.draw.randrange(side)}"

    def map(self):
        if self.draw.random() < 0.1:
            return self.one("small.map", "empty.map", ".", "none.map", os.fsdecode(b"n\xffme.map"))
        return self.one("blobs.map", "blobs.map", "maze.map", "huge.pbm", "noise.map", "strip.map", "rings.wkt",
                        os.path.join(MAPS, "maklink200.geojson"))

    def algorithm(self):
        return ["--algorithm", self.one("exact", "as", "acs", "mmas", "ras", "eas", "fan2004", "grid-ga",
                                        "terminal-index", "cong2009", "lecture-grid", "maklink-acs", "real-ga")]

    def outputs(self, *endings):
        return self.some(*(["-o", "out" + ending] for ending in endings))

    def search(self):
        return self.some(["--iterations", self.count()], ["--ants", self.one("1", "7", "500", "100000")],
                         ["--seed", self.one("1", "0", "5", "1-4", "1..1000000", "x")], ["--json"],
                         ["--time-limit", self.one("0", "0.3", "1e9", "1e-300", "nan")], ["-v"],
                         ["--target-gap", self.number()], ["--progress", "always"])

    def on_map(self):
        return self.search() + self.some(
            ["--radius", self.number()], ["--corners", self.one("forbid", "one-side", "allow")],
            ["--neighbours", self.one("4", "8", "16", "16k", "24", "32", "9")], ["--prepare"], ["--gap"],
            ["--polish", self.one("none", "straight", "taut", "local")], ["--unknown-free"],
            ["--frame", self.one("cell", "world")])

    def write(self, name, text):
        self.files[name] = text
        return name

    def plan(self):
        ends = ["--start", self.cell(), "--goal", self.cell()]
        return [self.map(), *ends, *self.algorithm(), *self.on_map(),
                *self.outputs(".json", ".csv", ".svg", ".png", ".html")]

    def batch(self):
        rows = [f"{self.draw.randrange(1000)} {self.draw.randrange(1000)} {self.draw.randrange(1000)} 3"
                for _ in range(self.one(0, 1, 50, 5000))]
        queries = self.write("q.tsv", "\n".join([self.one("sx sy gx gy", "sx sy", ""), *rows]) + "\n")
        return [self.map(), queries, *self.algorithm(), *self.on_map(),
                *self.outputs(".json", ".csv", ".svg", ".png")]

    def info(self):
        return [self.map(), *self.some(["--prepare"], ["--json"], ["--radius", self.number()],
                                       ["--margin", self.number()])]

    def algorithms(self):
        return self.some(["--json"], ["-x"])

    def generate(self):
        size = self.one("1x1", "40x30", "1x32768", "3000x2000", "32768x32768", "0x1", "99999x2", "x")
        return [self.one("blobs", "maze", "rooms", "city", "random", "open", "hole"), "--size", size,
                *self.some(["--density", self.one("0", "0.5", "1", "nan")], ["--seed", self.number()]),
                "-o", self.one("out.map", "out.pbm", "out.png", "no/out.map")]

    def verify(self):
        return [self.one("long.json", "lines.json", "drive.json", "arm.json", "small.map", "none.json"),
                *self.some(["-q"], ["--map", self.map()], ["--threads", "2"])]

    def study(self):
        kind = self.draw.randrange(5)
        if kind == 0:
            return self.one(["list"], ["fan2004"], ["all"], ["nobody"], ["families"]) + ["--seeds", "1..3", "-o", "s"]
        if kind == 1:
            return ["run", self.map(), "--start", self.cell(10), "--goal", self.cell(10), "--algorithm",
                    self.one("as", "as,exact", "x"), "--set", self.one("persistence=0.5,0.9", "ants=1,1e9", "q"),
                    "--seeds", self.one("2", "1..100000", "0"), "-o", "s", *self.some(["--steps", "100000"])]
        text = SWEEP if kind == 2 else STUDY
        for word, value in {"SEEDS": self.one("1", "1..5", "1..100000"), "SIZE": self.one("40x30", "900x900"),
                            "DRAW": self.one("1", "40", "100000"), "CLAIM": self.one(*CLAIMS),
                            "DESIGN": self.one("latin", "random"), "POINTS": self.one("4", "10000"),
                            "BUDGET": self.one("steps: 1000", "seconds: 0.01", "iterations: 3")}.items():
            text = text.replace(word, value)
        return [self.write("study.yaml", text), "-o", self.one("s", "s.html")]

    def tune(self):
        text = TUNING
        for word, value in {"ITERATIONS": self.one("1", "1000000"), "CANDIDATES": self.one("3", "2000"),
                            "DRAW": self.one("1", "100000")}.items():
            text = text.replace(word, value)
        return [self.write("tune.yaml", text), "-o", "t"]

    def arm(self):
        robot = self.one("industrial6.json", "planar3.json", "redundant7.json", "cell.json")
        joints = self.one("-0.9,0.3,0.4,0,0.4,0", "0,0,0", "0,0,0,0,0,0,0", "1,2", "nan,0,0")
        return [os.path.join(ARMS, robot), "--scene", os.path.join(ARMS, self.one("cell.json", "flat.json")),
                f"--start={joints}", self.one("--goal=0.45,0.4,0.5", "--goal=0.3,0.3,0", "--goal=9,9,9"),
                *self.some(["--algorithm", self.one("postures", "goritov2020")], ["--pitch", "0.004"],
                           ["--recheck", self.one("1", "1000000000")], ["--rate", self.one("1", "1e6", "0")],
                           ["--clearance", self.number()], ["--duration", self.number()]),
                *self.search(), *self.outputs(".json", ".csv", ".yaml", ".svg", ".png", ".html")]

    def drive(self):
        changes = "\n".join(f"{t} {self.draw.randrange(400)} {self.draw.randrange(200)} {self.one('blocked', 'free')}"
                            for t in range(self.one(0, 3, 3000)))
        return [self.map(), "--start", self.cell(), "--goal", self.cell(), *self.algorithm(), *self.on_map(),
                *self.some(["--changes", self.write("c.txt", changes)], ["--sense", self.number()],
                           ["--max-ticks", self.count()], ["--world", self.map()]),
                *self.outputs(".json", ".csv", ".svg", ".png", ".gif", ".html")]

    def tour(self):
        stops = "\n".join(f"{self.draw.randrange(400)} {self.draw.randrange(200)}" for _ in range(self.one(0, 3, 30, 300)))
        return [self.map(), "--stops", self.write("stops.tsv", stops), *self.some(
            ["--open"], ["--start", self.cell()], ["--goal", self.cell()], ["--generations", self.count()]),
                *self.search(), *self.outputs(".json", ".csv", ".svg", ".png")]

    def help(self):
        return self.some(["plan"], ["json"], ["nothing"])

    COMMANDS = ["plan", "batch", "info", "algorithms", "generate", "verify", "study", "tune", "arm", "drive", "tour", "help"]

    def command(self):
        name = self.draw.choice(self.COMMANDS)
        if self.draw.random() < 0.03:
            return self.one(["completion", "bash"], ["--version"], [], ["plan"], ["__complete", "plan", ""])
        arguments = getattr(self, name)()
        if name in ("plan", "batch", "study", "tune", "arm", "drive", "tour"):
            arguments += ["--threads", self.one("1", "2")]
        return [name, *arguments]


def processor_seconds(pid):
    """Of a process so far; None once it has ended."""
    with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return None if fields[0] in "ZX" else (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def catches_sigterm(pid):
    with open(f"/proc/{pid}/status", encoding="ascii", errors="replace") as status:
        sets = [line.split()[1] for line in status if line.startswith("SigCgt")]
    return bool(sets) and bool(int(sets[0], 16) >> (signal.SIGTERM - 1) & 1)


class Ends(ProgramTest):
    def prepare(self):
        for arguments in (["blobs", "--size", "1000x1000", "-o", "blobs.map"],
                          ["maze", "--size", "1001x1001", "-o", "maze.map"],
                          ["random", "--size", "700x700", "--density", "0.3", "-o", "noise.map"],
                          ["open", "--size", "8000x8000", "-o", "huge.pbm"],
                          ["open", "--size", "30000x1", "-o", "strip.map"]):
            self.ended(self.run_program("generate", *arguments), 0)
        self.write("empty.map", "")
        self.write(os.fsdecode(b"n\xffme.map"), self.read("small.map"))
        rings = " ".join(f"POLYGON (({x} {y}, {x + 6} {y}, {x + 3} {y + 6}, {x} {y}))"
                         for x in range(2, 990, 12) for y in range(2, 990, 12))
        self.write("rings.wkt", f"POLYGON ((0 0, 1000 0, 1000 1000, 0 1000, 0 0)) {rings}\n"
                                "POINT (1 1) POINT (999 998)\n")
        ends = ["--start", "0,0", "--goal", "9,5", "-q"]
        made = [("long.json", ["plan", "small.map", "--algorithm", "as", "--iterations", "4000", *ends]),
                ("lines.json", ["plan", "small.map", "--seed", "1..40", *ends]),
                ("drive.json", ["drive", "small.map", *ends]),
                ("arm.json", ["arm", os.path.join(ARMS, "planar3.json"), "--scene", os.path.join(ARMS, "flat.json"),
                              "--start=0,0,0", "--goal=0.3,0.3,0", "-q"])]
        for name, arguments in made:
            self.run_program(*arguments, "-o", name)
        return set(os.listdir(self.folder))

    def whole(self, name):
        """A file that is there is as its writer ends it."""
        data, ending = self.read(name), os.path.splitext(name)[1]
        self.assertRegex(data[-200:], re.compile(ENDINGS[ending], re.DOTALL), name)
        if ending == ".png" and len(data) < 10_000_000:
            self.png_size(name)

    def left_whole(self, inputs):
        """Whatever is beside the inputs is whole; it is removed."""
        for at, folders, files in os.walk(self.folder, topdown=False):
            for file in files:
                name = os.path.relpath(os.path.join(at, file), self.folder)
                if name in inputs:
                    continue
                self.assertNotIn(".part", name)
                self.whole(name)
                os.remove(self.path(name))
            for folder in folders:
                os.rmdir(os.path.join(at, folder))

    def ends(self, command, moment):
        """Code, messages, the seconds that it took after SIGTERM, by the wall and the processor, and ran before."""
        limit = (4 << 30, 4 << 30)
        with tempfile.TemporaryFile() as err, subprocess.Popen(
                [PROGRAM, *command], cwd=self.folder, env=environment(None), stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=err,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit)) as process:
            while process.poll() is None and not catches_sigterm(process.pid):
                pass
            ready = time.monotonic()
            try:
                process.wait(timeout=moment)
            except subprocess.TimeoutExpired:
                pass
            ran = time.monotonic() - ready
            before = processor_seconds(process.pid) if process.poll() is None else None
            begun, used = time.monotonic(), 0
            process.send_signal(signal.SIGTERM)
            while process.poll() is None and time.monotonic() - begun < 60:
                try:
                    process.wait(timeout=0.02)
                except subprocess.TimeoutExpired:
                    now = processor_seconds(process.pid)
                    used = max(used, (now or 0) - (before or 0))
            took = time.monotonic() - begun
            if process.poll() is None:
                process.kill()
            code = process.wait()
            err.seek(0)
            return code, err.read().decode(errors="replace"), took, used, ran

    def test_within_a_second_with_whole_files(self):
        inputs = self.prepare()
        first, count = int(os.environ.get("LASIUS_ENDS_SEED", "1")), int(os.environ.get("LASIUS_ENDS", "24"))
        slowest, cut = 0, 0
        for seed in range(first, first + count):
            odd = Odd(seed)
            command = odd.command()
            moment = min(2.0, 10 ** odd.draw.uniform(-3, 0.3))
            for name, text in odd.files.items():
                self.write(name, text)
            for _ in range(2):
                code, err, took, used, ran = self.ends(command, moment)
                with self.subTest(seed=seed, command=command, moment=moment, took=took, used=used):
                    self.assertIn(code, CODES, err[-300:])
                    self.assertNotIn("internal error", err)
                    # On a machine with other work the wall's second is long: the processor's counts.
                    self.assertFalse(took > 1 and used > 1 or took > 20)
                    self.left_whole(inputs | set(odd.files))
                if code == 130:
                    break
                moment = ran / 2  # it ended before: once more, and in its midst
            for name in odd.files:
                os.remove(self.path(name))
            slowest, cut = max(slowest, min(took, max(used, 0.02))), cut + (code == 130)
        self.assertGreater(8 * cut, count, "too few were cut short")
        print(f"{count} commands, {cut} cut short, the slowest ended {slowest:.2f} s after SIGTERM")


class Missing(ProgramTest):
    """What the system does not give is told, with the remedy."""

    PLAN = ("plan", "small.map", "--start", "0,0", "--goal", "9,5", "--algorithm", "exact")

    def limited(self, resource_name, amount, *arguments):
        limit = (amount, amount)
        return self.run_program(*arguments, env={"OMP_NUM_THREADS": "1"},
                                preexec_fn=lambda: resource.setrlimit(resource_name, limit))

    def test_file_descriptors(self):
        self.refused(self.limited(resource.RLIMIT_NOFILE, 4, *self.PLAN), 1, "Too many open files", "ulimit -n")

    def test_stack(self):
        self.refused(self.limited(resource.RLIMIT_STACK, 256 << 10, *self.PLAN), 1, "256 kB", "ulimit -s")

    def test_threads(self):
        # With the least address space in which one thread plans there is no room for 300 stacks.
        colony = (*self.PLAN[:-1], "as", "--ants", "3000", "--iterations", "2", "--json", "--threads")
        space = 128 << 20
        while (one := self.limited(resource.RLIMIT_AS, space, *colony, "1")).code != 0:
            self.assertLess(space, 8 << 30, one.err)
            space += 64 << 20
        many = self.limited(resource.RLIMIT_AS, space + (1 << 30), *colony, "300")
        self.ended(many, 0)
        self.assertEqual(many.json["path"], one.json["path"])

    def test_threads_have_room_for_their_heaps(self):
        self.ended(self.run_program("generate", "rooms", "--size", "100x100", "-o", "rooms.map"), 0)
        cover = ("tour", "rooms.map", "--cover", "4", "--generations", "0", "--json", "--threads")
        one = self.ended(self.run_program(*cover, "1"), 0)
        for size in (1100, 1200, 1300):
            many = self.ended(self.limited(resource.RLIMIT_AS, size << 20, *cover, "60"), 0)
            self.assertEqual(many.json["legs"], one.json["legs"])

    def test_names_that_are_not_utf8(self):
        name = os.fsdecode(b"m\xff.map")
        self.write(name, self.read("small.map"))
        ends = ("--start", "0,0", "--goal", "9,5")
        self.refused(self.run_program("study", "run", name, *ends, "--algorithm", "as", "-o", "s"), 2,
                     "not UTF-8", "rename")
        self.ended(self.run_program("plan", name, *ends, "-o", "r.json"), 0)
        self.assertEqual(self.read("r.json").decode().count("m\ufffd.map"), 1)


if __name__ == "__main__":
    unittest.main()
