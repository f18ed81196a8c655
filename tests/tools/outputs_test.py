"""Files that are written: whole or not at all, never over an input, and nothing else is left."""
import ctypes
import json
import os
import platform
import random
import re
import resource
import signal
import struct
import time
import unittest

from program import MAPS, ProgramTest, refuse_constant, tuning

FAN = os.path.join(MAPS, "fan400x200.map")
ARMS = os.path.join(MAPS, "arms")
QUERY = ("--start", "0,0", "--goal", "9,5")
QUERIES = "sx\tsy\tgx\tgy\n0\t0\t9\t5\n"
WORLD = """{"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"role": "boundary"}, "geometry": {"type": "Polygon",
  "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}}]}"""
ROS = "image: image.png\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n" \
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n"
FACET = "facet\nouter loop\nvertex 5 5 5\nvertex 5 6 5\nvertex 6 5 5\nendloop\nendfacet\n"
MESH = {"shape": "mesh", "file": "body.stl"}
ROBOT = """<robot name="one"><link name="foot"/><link name="arm"><collision>
  <geometry><mesh filename="body.stl"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="foot"/><child link="arm"/>
  <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="2" effort="1"/></joint></robot>"""


class Inputs(ProgramTest):
    def refused_over(self, kept, *arguments):
        """Refused for the two names at the end of `arguments`; the file `kept` stays as it is."""
        before = self.read(kept)
        run = self.run_program(*arguments)
        self.refused(run, 2, arguments[-1], "are one file")
        self.assertEqual(self.read(kept), before)
        self.assertFalse([name for name in os.listdir(self.folder) if name.startswith(".")])
        return run

    def test_a_map(self):
        self.assertEqual(self.run_program("generate", "open", "--size", "10x6", "-o",
                                          "image.png").code, 0)
        os.symlink("small.map", self.path("link.json"))
        os.link(self.path("small.map"), self.path("hard.csv"))
        for output in ("image.png", "./image.png", self.path("image.png")):
            run = self.refused_over("image.png", "plan", "image.png", *QUERY, "-o", output)
            self.assertIn("the input image.png", run.err)
        for output in ("link.json", "hard.csv"):
            self.refused_over("small.map", "plan", "small.map", *QUERY, "-o", "ok.svg", "-o", output)
            self.assertFalse(os.path.exists(self.path("ok.svg")))
        self.write("map.yaml", ROS)
        self.refused_over("image.png", "plan", "map.yaml", *QUERY, "-o", "image.png")
        self.write("q.tsv", QUERIES)
        self.refused_over("image.png", "batch", "map.yaml", "q.tsv", "-o", "image.png")

    def test_queries(self):
        self.write("q.csv", QUERIES)
        self.refused_over("q.csv", "batch", "small.map", "q.csv", "-o", "q.csv")
        os.symlink("small.map", self.path("link.json"))
        self.refused_over("small.map", "batch", "small.map", "q.csv", "-o", "link.json")

    def test_a_preset(self):
        self.write("p.json", '{"algorithm": "as", "set": {"iterations": 2}}')
        self.write("q.tsv", QUERIES)
        ends = ("--algorithm", "as", "--preset", "p.json", "-o", "p.json")
        for words in (["plan", "small.map", *QUERY[:4]], ["drive", "small.map", *QUERY[:4]],
                      ["batch", "small.map", "q.tsv"]):
            self.refused_over("p.json", *words, *ends)

    def test_a_world(self):
        self.write("world.json", WORLD)
        run = self.run_program("plan", "world.json", "--algorithm", "exact", "--start", "1,1",
                               "--goal", "8,8", "-o", "./world.json")
        if "built without" in run.err:
            self.skipTest("this lasius was built without polygon worlds")
        self.refused(run, 2, "./world.json", "are one file")
        self.assertEqual(self.read("world.json").decode(), WORLD)

    def test_robot_scene_and_meshes(self):
        if "goritov2020" not in self.run_program("algorithms").out:
            self.skipTest("this lasius was built without arms")
        for name in ("planar3.json", "flat.json"):
            with open(os.path.join(ARMS, name), encoding="utf-8") as file:
                self.write(name, file.read())
        arm = ("arm", "planar3.json", "--scene", "flat.json", "--start", "-0.3,0.5,0.5", "--goal",
               "0.4,0.5,0", "-o")
        for name in ("planar3.json", "flat.json"):
            self.refused_over(name, *arm, name)
        self.write("body.stl", "solid s\n" + FACET + "endsolid s\n")
        os.link(self.path("body.stl"), self.path("mesh.json"))
        self.write("meshes.json", json.dumps({"format": "lasius-scene/1", "obstacles": [MESH]}))
        self.refused_over("body.stl", "arm", "planar3.json", "--scene", "meshes.json", *arm[4:],
                          "mesh.json")
        self.write("robot.urdf", ROBOT)
        self.refused_over("body.stl", "arm", "robot.urdf", "--scene", "flat.json", "--start", "0",
                          "--goal", "0.4,0.5,0", "-o", "mesh.json")

    def test_two_outputs(self):
        os.symlink("r.json", self.path("link.json"))
        for output in ("r.json", "./r.json", "link.json"):
            run = self.plan("-o", "r.json", "-o", "r.csv", "-o", output)
            self.refused(run, 2, "the output r.json", output)
        self.assertEqual(sorted(os.listdir(self.folder)), ["link.json", "small.map"])

    def test_standard_output(self):
        def run(stream, *arguments):
            process = self.start_program("plan", "small.map", *QUERY, *arguments, stdout=stream)
            return process.communicate(timeout=120)[1].decode(), process.returncode

        with open(self.path("small.map"), "ab") as stream:
            err, code = run(stream)
        self.assertEqual(code, 2, err)
        self.assertIn("standard output and the input small.map", err)
        with open(self.path("r.json"), "wb") as stream:
            err, code = run(stream, "-o", "r.json")
        self.assertEqual(code, 2, err)
        self.assertIn("r.json and standard output", err)
        with open(self.path("both"), "wb") as stream:
            self.assertEqual(run(stream, "-o", "/dev/stdout", "-o", "/dev/fd/1"), ("", 0))
        status, *_, first, second = self.read("both").decode().splitlines()
        self.assertEqual((status, first), ("solved", second))
        self.assertEqual(json.loads(first, parse_constant=refuse_constant)["status"], "solved")

    def test_a_verdict_is_told_by_the_exit_code_where_nobody_reads(self):
        self.plan("-o", "r.json")
        self.write("bad.json", self.read("r.json").replace(b'"length":', b'"length":1'))
        self.write("bad.csv", "x,y\n0.5,0.5\n9.5,5.5\n")
        self.write("flat.pgm", b"P5 10 6 255\n" + bytes(60))
        self.ended(self.plan("--algorithm", "exact", "--cost", "flat.pgm", "-o", "p.proof.json"), 0)
        self.write("dear.pgm", b"P5 10 6 255\n" + bytes([9]) * 60)
        for words, code in ((("verify", "bad.json"), 1), (("verify", "r.json"), 0), (("check-path", "small.map", "bad.csv"), 1),
                            (("check-proof", "small.map", "p.proof.json", "--cost", "dear.pgm"), 1)):
            with self.subTest(words=words):
                reader, writer = os.pipe()
                os.close(reader)
                process = self.start_program(*words, stdout=writer)
                os.close(writer)
                err = process.communicate(timeout=120)[1]
                self.assertEqual(process.returncode, code, err)


class Names(ProgramTest):
    def test_are_looked_at_before_the_run(self):
        self.write("q.tsv", QUERIES)
        os.mkdir(self.path("folder.json"))
        self.write("kept.json", "old")
        os.chmod(self.path("kept.json"), 0o444)
        cases = [("x" * 251 + ".json", "too long"), ("folder.json", "folder"), ("kept.json", "read-only"),
                 ("none/r.json", "no folder none")]
        for output, word in cases:
            for command in (["plan", "small.map", *QUERY], ["batch", "small.map", "q.tsv"]):
                with self.subTest(output=output, command=command):
                    self.refused(self.run_program(*command, "-o", output), 7, output, word)
        self.refused(self.run_program("generate", "open", "--size", "8x8", "-o", "none/m.map"), 7)
        self.assertEqual(self.read("kept.json"), b"old")
        os.mkdir(self.path("study"))
        os.mkdir(self.path("study/report.md"))
        self.refused(self.run_program("study", "terminal-index", "--maps", MAPS, "-o", "study"), 7,
                     "study/report.md")
        self.assertEqual(os.listdir(self.path("study")), ["report.md"])

    def test_permissions_are_kept(self):
        user = 1 if os.geteuid() == 0 else os.geteuid()  # only the superuser can give files away
        for mode in (0o600, 0o664):
            for name in ("r.json", "r.csv", "r.svg", "r.png"):
                self.write(name, "old")
                os.chown(self.path(name), user, -1)
                os.chmod(self.path(name), mode)
                os.symlink(name, self.path("to-" + name))
                self.assertEqual(self.plan("-o", "to-" + name).code, 0)
                self.assertEqual(os.stat(self.path(name)).st_mode & 0o777, mode)
                self.assertEqual(os.stat(self.path(name)).st_uid, user)
                self.assertTrue(os.path.islink(self.path("to-" + name)))
                self.assertNotEqual(self.read(name), b"old")
                os.remove(self.path("to-" + name))

    def test_streams_need_no_ending(self):
        self.assertEqual(self.plan("-o", "/dev/null").code, 0)
        self.write("q.tsv", QUERIES)
        run = self.quiet(self.run_program("batch", "small.map", "q.tsv", "-o", "/dev/stdout"))
        self.assertEqual(run.lines[0], run.lines[1])
        made = self.run_program("generate", "maze", "--size", "9x7", "-o", "/dev/stdout")
        self.assertTrue(made.out.startswith("type octile\nheight 7\nwidth 9\nmap\n"), made.out)
        self.refused(self.plan("-o", "picture"), 2, ".png")


def without_nameless_files():
    """From here on the system calls answer as on a file system that lacks O_TMPFILE."""
    number = {"x86_64": 257, "aarch64": 56}[platform.machine()]  # of openat
    load, jump_equal, jump_set, give = 0x20, 0x15, 0x45, 0x06
    program = b"".join(struct.pack("HBBI", *line) for line in [
        (load, 0, 0, 0), (jump_equal, 0, 3, number), (load, 0, 0, 32),  # the call; its flags
        (jump_set, 0, 1, 0o20000000), (give, 0, 0, 0x00050000 | 95),    # EOPNOTSUPP
        (give, 0, 0, 0x7fff0000)])
    text = ctypes.create_string_buffer(program)
    libc = ctypes.CDLL(None, use_errno=True)
    head = struct.pack("HxxxxxxP", len(program) // 8, ctypes.addressof(text))
    if libc.prctl(38, 1, 0, 0, 0) != 0 or libc.prctl(22, 2, head, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "no seccomp filter")


def no_core():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def named():
    no_core()
    without_nameless_files()


class Ends(ProgramTest):
    """However the program ends, no half-written file is left."""

    SIDE = 8192
    BIG = ("generate", "open", "--size", f"{SIDE}x{SIDE}", "-o", "big.map")

    def temporary(self, process):
        """The file that is being written in the test's folder, if there is one."""
        try:
            numbers = [f"/proc/{process.pid}/fd/{n}" for n in os.listdir(f"/proc/{process.pid}/fd")]
            links = [os.readlink(number) for number in numbers]
        except OSError:  # it ended
            return None
        return next((link for link in links if link.startswith(self.folder + "/") and
                     (link.endswith(".part") or link.endswith(" (deleted)"))), None)

    def stopped_while_it_writes(self, prepare):
        for _ in range(200):
            process = self.start_program(*self.BIG, preexec_fn=prepare)
            while process.poll() is None:
                if self.temporary(process):
                    process.send_signal(signal.SIGSTOP)
                    if self.temporary(process):
                        return process
                    process.send_signal(signal.SIGCONT)
            process.communicate()
        self.fail("no process was stopped while it wrote, in 200 of them")

    def end(self, prepare, *numbers):
        process = self.stopped_while_it_writes(prepare)
        self.assertEqual(".part" in self.temporary(process), prepare == named or not self.nameless())
        for number in numbers:
            process.send_signal(number)
        process.send_signal(signal.SIGCONT)
        self.assertEqual(process.communicate(timeout=60), (b"", b""))
        self.assertLessEqual(set(os.listdir(self.folder)), {"small.map", "big.map"})
        if os.path.exists(self.path("big.map")):  # stopped just before it was whole
            self.assertEqual(self.read("big.map").count(b"\n"), 4 + self.SIDE)
        return process.returncode

    def nameless(self):
        """True where the file system has files without a name."""
        try:
            os.close(os.open(self.folder, os.O_TMPFILE | os.O_WRONLY))
        except OSError:
            return False
        return True

    def test_a_second_signal_ends_it_at_once(self):
        for prepare in (no_core, named):
            for numbers, code in [((signal.SIGHUP, signal.SIGTERM), 130),
                                  ((signal.SIGINT, signal.SIGHUP), 130),
                                  ((signal.SIGQUIT,), -signal.SIGQUIT)]:
                with self.subTest(numbers=numbers, prepare=prepare):
                    self.assertEqual(self.end(prepare, *numbers), code)

    def test_nothing_is_left_of_a_killed_one(self):
        if self.nameless():
            self.assertEqual(self.end(no_core, signal.SIGKILL), -signal.SIGKILL)

    LONG = ("plan", FAN, "--start", "14,14", "--goal", "380,179", "--iterations", "1000000000",
            "--progress", "always", "--threads", "1", "-o", "r.json", "-o")

    def test_a_pipe_that_nobody_reads(self):
        os.mkfifo(self.path("pipe.json"))
        self.ends_while_it_waits("plan", f"{MAPS}/grid20a.map", "--start", "0,0", "--goal", "19,19",
                                 "-q", "-o", "pipe.json")

    def test_a_pipe_that_nobody_writes(self):
        for ending in ("map", "yaml", "tsv", "txt", "json"):
            os.mkfifo(self.path("pipe." + ending))
        ends = ("--start", "0,0", "--goal", "9,5")
        for words in (("plan", "pipe.map", *ends), ("plan", "pipe.yaml", *ends), ("batch", "small.map", "pipe.tsv"),
                      ("drive", "small.map", *ends, "--changes", "pipe.txt"), ("verify", "pipe.json")):
            with self.subTest(words=words):
                self.ends_while_it_waits(*words)

    def ends_while_it_waits(self, *words):
        process = self.start_program(*words)
        waits, deadline = "", time.monotonic() + 60
        while waits != "wait_for_partner":
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline, f"it waits for {waits}")
            with open(f"/proc/{process.pid}/wchan", encoding="ascii") as file:
                waits = file.read()
        self.interrupted(process, signal.SIGTERM)

    def test_hang_up_at_twenty_moments(self):
        moments = random.Random(22)
        for run in range(20):
            self.write("r.json", "old")
            os.chmod(self.path("r.json"), 0o600)
            # A picture where a second signal may tear it, and now and then; drawing is slow.
            twice = run % 5 == 4
            second = "r.png" if twice or run % 5 == 0 else "r.csv"
            process = self.start_program(*self.LONG, second, preexec_fn=named if run % 2 else no_core)
            process.stderr.read(moments.randint(1, 64))
            process.send_signal(signal.SIGHUP)
            if twice:
                process.stderr.read(moments.randint(0, 40))
                process.send_signal(signal.SIGHUP)
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130)
            self.assertLessEqual(set(os.listdir(self.folder)), {"small.map", "r.json", "r.png", "r.csv"})
            self.assertEqual(os.stat(self.path("r.json")).st_mode & 0o777, 0o600)
            if not twice or self.read("r.json") != b"old":
                result = json.loads(self.read("r.json"), parse_constant=refuse_constant)
                self.assertEqual(result["status"], "interrupted")
            if second == "r.csv":
                self.assertEqual(self.read("r.csv").splitlines()[0], b"iteration,best,mean,arrived")
            elif not twice:
                self.assertGreater(min(self.png_size("r.png")), 100)

    def ended_while_it_draws(self, *numbers):
        """Exit code and messages of a plan that gets signals once its JSON and CSV are written."""
        process = self.start_program("plan", FAN, "--start", "14,14", "--goal", "380,179", "--iterations", "20",
                                     "-v", "-o", "r.html", "-o", "r.svg", "-o", "r.json", "-o", "r.csv")
        err = b""
        while b"wrote r.csv" not in err:
            line = process.stderr.readline()
            self.assertTrue(line, err)
            err += line
        self.assertLess(err.index(b"wrote r.json"), err.index(b"wrote r.csv"))
        for number in numbers:
            process.send_signal(number)
        err += process.communicate(timeout=60)[1]
        self.assertIn(process.returncode, (0, 130))  # 0: it had ended before
        self.assertTrue(self.read("r.json").endswith(b"}\n"))
        return process.returncode, err.decode()

    def test_a_signal_among_outputs_loses_none(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            _, err = self.ended_while_it_draws(number)
            self.assertNotIn("not written", err)
            self.assertTrue(self.read("r.html").endswith(b"</html>\n"))
            self.assertTrue(self.read("r.svg").endswith(b"</svg>\n"))
            for name in ("r.html", "r.svg"):
                os.unlink(self.path(name))

    def test_a_second_signal_names_what_is_not_written(self):
        code, err = self.ended_while_it_draws(signal.SIGINT, signal.SIGTERM)  # two of one kind may come as one
        lost = [name for name in ("r.html", "r.svg") if not os.path.exists(self.path(name))]
        if lost:  # one that has just been written may be named, too
            told = re.search("^lasius: interrupted: not written: (.*)$", err, re.M)
            self.assertIn(told and told[1], (", ".join(lost), "r.html, r.svg"), err)
            self.assertEqual(code, 130)

    def test_an_end_during_the_search_names_what_is_not_written(self):
        self.write("q.tsv", QUERIES.replace("9\t5", "0\t0") + "0\t0\t9\t5\n")  # the first one is soon answered
        self.write("t.yaml", tuning(blocks=3000, seeds=5000))
        slow = ("--algorithm", "as", "--iterations", "1000000000", "--progress", "always", "-o", "r.svg", "-o", "r.json")
        sweep = ("--start", "0,0", "--goal", "9,5", "--algorithm", "as", "--seeds", "1..100000", "-o", "s")
        for words, names in (
                (self.LONG + ("r.svg",), "r.json, r.svg"),
                (("batch", "small.map", "q.tsv", *slow), "r.json, r.svg"),
                (("study", "run", "small.map", *sweep), "s/runs.csv, s/results.csv, s/claims.csv, s/report.md, s/report.html"),
                (("tune", "t.yaml", "-o", "t"), "t/race.csv, t/candidates.csv, t/report.md, t/preset.yaml")):
            # Ends at once though it is the first: a second signal would come before, among or after the files.
            process = self.start_program(*words, preexec_fn=no_core)
            process.stderr.read(1)
            process.send_signal(signal.SIGQUIT)
            err = process.communicate(timeout=60)[1].decode()
            self.assertEqual(process.returncode, -signal.SIGQUIT)
            self.assertIn(f"lasius: interrupted: not written: {names}\n", err)
            self.assertEqual([name for name in names.split(", ") if os.path.exists(self.path(name))], [])
        self.assertEqual(set(os.listdir(self.folder)), {"small.map", "q.tsv", "t.yaml", "s", "t"})

    def test_a_hang_up_that_was_ignored_stays_so(self):
        process = self.start_program(
            *self.LONG, "r.png", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.stderr.read(100)
        process.send_signal(signal.SIGHUP)
        process.stderr.read(100)
        self.assertIsNone(process.poll())
        self.assertFalse(os.path.exists(self.path("r.json")))
        self.interrupted(process, signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
