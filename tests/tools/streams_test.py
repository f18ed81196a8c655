"""Closed and full outputs, signals."""
import errno
import json
import os
import signal
import subprocess
import time
import unittest

from program import MAPS, PROGRAM, ProgramTest, Run, environment, refuse_constant

FAN = os.path.join(MAPS, "fan400x200.map")
LONG = ["plan", FAN, "--start", "14,14", "--goal", "380,179", "--iterations", "1000000000",
        "--progress", "always"]


class Outputs(ProgramTest):
    def test_a_closed_pipe_ends_quietly(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "0\t0\t9\t5\n" * 2000)
        for arguments in (["plan", "small.map", "--start", "0,0", "--goal", "9,5"], ["--help"],
                          ["algorithms"], ["batch", "small.map", "q.tsv", "--iterations", "2"]):
            with self.subTest(arguments=arguments):
                read_end, write_end = os.pipe()
                os.close(read_end)
                try:
                    run = Run(subprocess.run(self.command(arguments), cwd=self.folder,
                                             stdin=subprocess.DEVNULL, stdout=write_end,
                                             stderr=subprocess.PIPE, text=True, timeout=120,
                                             env=environment(None), check=False))
                finally:
                    os.close(write_end)
                self.assertEqual((run.code, run.err), (0, ""))

    def test_a_closed_stdout_ends_quietly(self):
        command = '"$0" plan small.map --start 0,0 --goal 9,5 -o r.json >&-'
        run = Run(subprocess.run(["sh", "-c", command, PROGRAM], cwd=self.folder,
                                 capture_output=True, text=True, timeout=120, check=False))
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        self.assertEqual(json.loads(self.read("r.json"))["status"], "solved")

    def test_a_full_stdout_is_an_error(self):
        with open("/dev/full", "wb") as full:
            run = Run(subprocess.run([PROGRAM, "algorithms"], stdout=full, stderr=subprocess.PIPE,
                                     text=True, timeout=120, check=False))
        self.assertEqual(run.code, 7)
        self.assertIn("standard output", run.err)

    def test_a_full_stdout_leaves_the_files(self):
        with open("/dev/full", "wb") as full:
            process = self.start_program("plan", "small.map", "--start", "0,0", "--goal", "9,5",
                                         "-o", "r.json", stdout=full)
            process.communicate(timeout=120)
        self.assertEqual(process.returncode, 7)
        self.assertEqual(json.loads(self.read("r.json"))["status"], "solved")


    def test_what_one_output_refuses_the_others_get(self):
        self.write("q.tsv", "sx sy gx gy\n0 0 9 5\n")
        os.symlink("/dev/full", self.path("full.json"))
        for arguments in (["plan", "small.map", "--start", "0,0", "--goal", "9,5"],
                          ["batch", "small.map", "q.tsv"]):
            with self.subTest(arguments=arguments):
                self.ended(self.run_program(*arguments, "-o", "full.json", "-o", "ok.json", "-o",
                                            "ok.png"), 7, "full.json")
                self.assertEqual(json.loads(self.read("ok.json"))["status"], "solved")
                self.assertTrue(self.read("ok.png"))
                os.remove(self.path("ok.json"))

    def test_a_batch_writes_files_though_nobody_reads_it(self):
        self.write("q.tsv", "sx sy gx gy\n" + "0 0 9 5\n" * 20)
        for stdout, code in ((">&-", 0), (">/dev/full", 7)):
            with self.subTest(stdout=stdout):
                command = f'"$0" batch small.map q.tsv -o all.json {stdout}'
                run = Run(subprocess.run(["sh", "-c", command, PROGRAM], cwd=self.folder,
                                         capture_output=True, text=True, timeout=120, check=False))
                self.assertEqual(run.code, code)
                self.assertEqual(len(self.read("all.json").decode().splitlines()), 20)
                os.remove(self.path("all.json"))


class Signals(ProgramTest):
    def wait_for_best(self, process):
        """Until the run says that it has a path."""
        seen = b""
        while b"best" not in seen:
            byte = process.stderr.read(1)
            self.assertNotEqual(byte, b"", seen)
            seen += byte

    def test_the_best_so_far_is_written(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number=number):
                process = self.start_program(*LONG, "--json", "-o", "r.json", "-o", "r.png")
                self.wait_for_best(process)
                out, err = self.interrupted(process, number)
                self.assertIn(b"interrupted", err)
                result = json.loads(out, parse_constant=refuse_constant)
                self.assertEqual(result["status"], "interrupted")
                # Ants of the iteration that was cut short may have found a better one.
                self.assertLessEqual(result["length"], result["best"][-1])
                self.assertEqual(len(result["best"]), result["iterations"])
                self.assertEqual(result["path"][-1], [380.5, 179.5])
                self.assertEqual(self.read("r.json"), out)
                self.assertGreater(min(self.png_size("r.png")), 100)

    def test_batch_prints_whole_lines_only(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n14\t14\t60\t40\n" + "14\t14\t380\t179\n" * 100000)
        process = self.start_program("batch", FAN, "q.tsv", "--iterations", "20", "--threads", "2")
        first = process.stdout.readline()
        out = first + self.interrupted(process)[0]
        self.assertTrue(out.endswith(b"\n"))
        lines = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([line["index"] for line in lines], list(range(len(lines))))
        self.assertLess(len(lines), 100001)
        self.assertEqual(lines[0]["status"], "solved")

    def test_the_search_for_the_optimum_ends_too(self):
        self.ended(self.run_program("generate", "random", "--size", "4096x4096", "--density",
                                    "0.2", "-o", "big.pbm"), 0)
        # One ant that always takes the best move: the plan takes no time, its optimum a second.
        process = self.start_program("plan", "big.pbm", "--start", "0,0", "--goal", "4095,4095",
                                     "--algorithm", "as", "--set", "greedy=1", "--neighbours", "8",
                                     "--ants", "1", "--iterations", "1", "--polish", "none",
                                     "--gap", "--json", "--progress", "always")
        self.wait_for_best(process)
        result = json.loads(self.interrupted(process)[0], parse_constant=refuse_constant)
        self.assertEqual((result["status"], result["iterations"]), ("solved", 1))
        self.assertEqual((result["optimum"], result["optimum_gap"]), (None, None))

    def caught(self, process):
        """True once the program catches SIGTERM."""
        with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
            sets = [line.split()[1] for line in status if line.startswith("SigCgt")]
        return bool(sets) and bool(int(sets[0], 16) >> (signal.SIGTERM - 1) & 1)

    def test_generate_leaves_nothing_behind(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number=number):
                process = self.start_program("generate", "blobs", "--size", "32768x32768", "-o",
                                             "big.pbm")
                while not self.caught(process):
                    self.assertIsNone(process.poll())
                self.assertEqual(self.interrupted(process, number), (b"", b""))
                self.assertEqual(os.listdir(self.folder), ["small.map"])

    def test_generate_writes_whole_what_it_began(self):
        os.mkfifo(self.path("pipe.pbm"))
        process = self.start_program("generate", "open", "--size", "2048x2048", "-o", "pipe.pbm")
        with open(self.path("pipe.pbm"), "rb") as pipe:
            head = pipe.read(13)
            process.send_signal(signal.SIGTERM)
            self.assertEqual(len(head + pipe.read()), len(b"P4\n2048 2048\n") + 2048 * 2048 // 8)
        self.assertEqual(process.wait(timeout=60), 130)
        process.communicate()

    def test_info_ends_at_once(self):
        os.mkfifo(self.path("pipe.map"))
        process = self.start_program("info", "pipe.map", "--prepare")
        with open(self.path("pipe.map"), "wb"):  # when it reads
            self.assertEqual(self.interrupted(process, signal.SIGTERM), (b"", b""))

    # Of 64 tiles, more than are labelled between two polls.
    SIDE = 2048

    def big_map(self, name):
        head = f"type octile\nheight {self.SIDE}\nwidth {self.SIDE}\nmap\n"
        self.write(name, head + ("." * self.SIDE + "\n") * self.SIDE)
        return name

    def interrupt_while_read(self, *arguments):
        """The map comes through a pipe, its last byte when the signal has been seen."""
        whole = self.read(self.big_map("big.map"))
        os.mkfifo(self.path("pipe.map"))
        process = self.start_program(*arguments)
        deadline = time.monotonic() + 60
        pipe = None
        while pipe is None:  # until the program reads it
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline)
            try:
                pipe = os.open(self.path("pipe.map"), os.O_WRONLY | os.O_NONBLOCK)
            except OSError as fault:
                self.assertEqual(fault.errno, errno.ENXIO)
        os.set_blocking(pipe, True)
        with open(pipe, "wb", buffering=0) as stream:
            body = memoryview(whole)
            while len(body) > 1:
                body = body[stream.write(body[:-1]):]
            tasks = f"/proc/{process.pid}/task"
            before = len(os.listdir(tasks))
            process.send_signal(signal.SIGINT)
            while len(os.listdir(tasks)) == before:  # the thread that waits for signals ends
                self.assertLess(time.monotonic(), deadline)
            stream.write(body)
        out, err = process.communicate(timeout=60)
        os.unlink(self.path("pipe.map"))
        return Run(subprocess.CompletedProcess(arguments, process.returncode, out.decode(),
                                               err.decode()))

    def test_a_map_half_prepared_is_no_map(self):
        corner = f"{self.SIDE - 1},{self.SIDE - 1}"
        for more in ([], ["--radius", "1"], ["--algorithm", "exact", "--prepare"],
                     ["--algorithm", "exact", "--prepared", "p"]):
            with self.subTest(more=more):
                run = self.interrupt_while_read(
                    "plan", "pipe.map", "--start", "1,1", "--goal", corner, "--json", "-v", "-o",
                    "r.json", "-o", "r.png", *more)
                self.ended(run, 130, "interrupted")
                self.assertNotIn("ready after", run.err)
                self.assertEqual("p is not written: its preparation was interrupted" in run.err, "p" in more)
                self.assertFalse(os.path.exists(self.path("p")))
                self.assertEqual((run.json["status"], run.json["path"], run.json["length"]),
                                 ("interrupted", None, None))
                self.assertEqual((run.json["best"], run.json["error"]), ([], None))
                self.assertEqual(self.read("r.json").decode(), run.out)
                self.assertGreater(min(self.png_size("r.png")), 100)

    def test_a_batch_on_a_map_half_prepared(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n1\t1\t9\t5\n")
        run = self.interrupt_while_read("batch", "pipe.map", "q.tsv", "-o", "r.csv")
        self.ended(run, 130, "interrupted after 0 of 1 answer")
        self.assertEqual(run.out, "")
        self.assertEqual(len(self.read("r.csv").splitlines()), 1)

    def test_verify_ends_at_once(self):
        self.ended(self.plan("--algorithm", "exact", "-o", "r.json"), 0)
        os.mkfifo(self.path("pipe.map"))
        process = self.start_program("verify", "r.json", "--map", "pipe.map")
        with open(self.path("pipe.map"), "wb"):  # when it reads
            self.assertEqual(self.interrupted(process, signal.SIGTERM), (b"", b""))


if __name__ == "__main__":
    unittest.main()
