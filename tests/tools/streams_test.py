"""Closed and full outputs, signals."""
import json
import os
import signal
import subprocess
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


class Signals(ProgramTest):
    def interrupt(self, number, *arguments):
        """Sends a signal once the run says that it is on its way."""
        process = self.start_program(*LONG, *arguments)
        seen = b""
        while b"best" not in seen:
            byte = process.stderr.read(1)
            self.assertNotEqual(byte, b"", seen)
            seen += byte
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        return process.returncode, out.decode(), err.decode()

    def test_the_best_so_far_is_written(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number=number):
                code, out, err = self.interrupt(number, "--json", "-o", "r.json", "-o", "r.png")
                self.assertEqual(code, 130)
                self.assertIn("interrupted", err)
                result = json.loads(out, parse_constant=refuse_constant)
                self.assertEqual(result["status"], "interrupted")
                self.assertEqual(result["length"], result["best"][-1])
                self.assertEqual(len(result["best"]), result["iterations"])
                self.assertEqual(result["path"][-1], [380.5, 179.5])
                self.assertEqual(self.read("r.json").decode(), out)
                self.assertGreater(min(self.png_size("r.png")), 100)

    def test_batch_prints_whole_lines_only(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n14\t14\t60\t40\n" + "14\t14\t380\t179\n" * 100000)
        process = self.start_program("batch", FAN, "q.tsv", "--iterations", "20", "--threads", "2")
        first = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertTrue((first + out).endswith(b"\n"))
        lines = [json.loads(line) for line in (first + out).splitlines()]
        self.assertEqual([line["index"] for line in lines], list(range(len(lines))))
        self.assertLess(len(lines), 100001)
        self.assertEqual(lines[0]["status"], "solved")


if __name__ == "__main__":
    unittest.main()
