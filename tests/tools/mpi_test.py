"""lasius_mpi: what lasius prints, on any ranks and threads, by Open MPI and MPICH; a job that died goes on.

LASIUS_MPI_KILLS: jobs to kill of each kind, at random moments (without it one of a batch, none of a study), and then
also all ranks by all threads.
"""
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

from program import MAPS, ProgramTest, Run, environment

FAN = os.path.join(MAPS, "fan400x200.map")
PROGRAMS = {mpi: os.environ[name] for mpi, name in (("openmpi", "LASIUS_MPI_OPENMPI"), ("mpich", "LASIUS_MPI_MPICH"))
            if name in os.environ and shutil.which("mpirun." + mpi)}
KILLS = int(os.environ.get("LASIUS_MPI_KILLS", 0))
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

RANKS = [(mpi, ranks, threads) for mpi in PROGRAMS
         for ranks, threads in ([(r, t) for r in (1, 2, 3, 5, 8) for t in (1, 2, 4)] if KILLS else [(1, 2), (3, 1)])]


TUNING = """
algorithm: mmas
set: {ants: 1, iterations: 1}
parameters: {ants: [1, 10], iterations: [2, 20]}
candidates: 4
maps: {b: {kind: blobs, size: 40x30, density: 0.3, seeds: 1..2}}
optimum: 8 moves
training: [{map: b, draw: 1}]
race: {first_test: 3, blocks: 4}
seeds: 1..2
"""


def timeless(lines):
    return [{**line, "elapsed_ms": 0, "threads": 0} for line in lines]


def descendants(pid):
    """Of a process, those that are lasius_mpi."""
    children = {}
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat", encoding="utf-8", errors="replace") as file:
                name, rest = file.read().split("(", 1)[1].rsplit(")", 1)
        except OSError:
            continue
        children.setdefault(int(rest.split()[1]), []).append((int(entry), name))
    found, open_ = [], [pid]
    while open_:
        for child, name in children.get(open_.pop(), []):
            open_.append(child)
            if name.startswith("lasius_mpi"):
                found.append(child)
    return found


class MpiTest(ProgramTest):
    def job(self, mpi, ranks, arguments):
        more = ["--oversubscribe", "--bind-to", "none"] if mpi == "openmpi" else []
        return ["mpirun." + mpi, *more, "-n", str(ranks), PROGRAMS[mpi], *map(str, arguments)]

    def run_job(self, mpi, ranks, *arguments):
        return Run(subprocess.run(self.job(mpi, ranks, arguments), cwd=self.folder, env=environment(AS_ROOT),
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False))

    def start_job(self, mpi, ranks, *arguments):
        return subprocess.Popen(self.job(mpi, ranks, arguments), cwd=self.folder, env=environment(AS_ROOT),
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def kill_a_rank(self, job):
        for pid in random.sample(ranks := descendants(job.pid), min(1, len(ranks))):
            os.kill(pid, signal.SIGKILL)
        job.stdout.close()
        return job.wait(60)

    def journals(self):
        return [name for name in os.listdir(self.folder) if name.endswith(".journal")]


class Batches(MpiTest):
    def setUp(self):
        super().setUp()
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "".join(f"{14 + i}\t14\t380\t{150 + i % 30}\n" for i in range(60)))
        self.asked = ("batch", FAN, "q.tsv", "--algorithm", "acs", "--islands", "3", "--ants", "6", "--iterations", "2",
                      "-q", "--threads")
        self.alone = timeless(self.quiet(self.run_program(*self.asked, "2")).lines)

    def test_any_ranks_print_what_one_process_prints(self):
        for mpi, ranks, threads in RANKS:
            with self.subTest(mpi=mpi, ranks=ranks, threads=threads):
                run = self.run_job(mpi, ranks, *self.asked, threads)
                self.assertEqual((run.code, timeless(run.lines)), (0, self.alone), run.err)
                self.assertEqual(self.journals(), [])

    def test_tables_and_pictures_are_of_all_queries(self):
        files = ("-o", "all.csv", "-o", "all.svg", "-o", "all.json")
        mpi, ranks, _ = RANKS[-1]
        run = self.run_job(mpi, ranks, *self.asked, 1, *files)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(len(self.rows("all.csv")), 60)
        self.assertEqual(self.read("all.json").decode(), run.out)
        self.quiet(self.run_program(*self.asked, 1, "-o", "alone.svg"))
        self.assertEqual(self.words("all.svg"), self.words("alone.svg"))

    def test_a_job_that_lost_a_rank_goes_on_with_others(self):
        for number in range(max(1, KILLS)):
            mpi = list(PROGRAMS)[number % len(PROGRAMS)]
            with self.subTest(number=number, mpi=mpi):
                job = self.start_job(mpi, 3, *self.asked, 1)
                for _ in range(random.randrange(1, 40)):  # so many answers are on disk
                    job.stdout.readline()
                self.kill_a_rank(job)
                if self.journals():  # else it had ended
                    self.write("torn", self.read(self.journals()[0]) + b"7 1000 0123")
                    os.replace(self.path("torn"), self.path(self.journals()[0]))
                run = self.run_job(mpi, 2, *self.asked, 2)
                self.assertEqual((run.code, timeless(run.lines)), (0, self.alone), run.err)
                self.assertEqual(self.journals(), [])

    def test_what_is_wrong_is_said_once(self):
        for mpi in PROGRAMS:
            for arguments, code, words in ((("batch", "none.map", "q.tsv"), 3, "none.map"), (("batch", "--what"), 2, "--what")):
                run = self.run_job(mpi, 3, *arguments)
                self.assertEqual(run.code, code, run.err)
                self.assertEqual(run.err.count("lasius: "), 1, run.err)
                self.assertIn(words, run.err)

    def test_what_is_not_shared_is_done_by_one(self):
        for mpi in PROGRAMS:
            run = self.run_job(mpi, 2, "plan", "small.map", "--start", "0,0", "--goal", "9,5", "--json")
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(timeless([run.json]), timeless([self.run_program(
                "plan", "small.map", "--start", "0,0", "--goal", "9,5", "--json", "--algorithm", "exact").json]))


class Studies(MpiTest):
    asked = ("study", "run", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", "acs,mmas", "--set",
             "islands=1,3", "--set", "iterations=2", "--seeds", "6", "-q", "-o")

    def table(self, folder):
        return [{**row, "seconds": None} for row in self.rows(os.path.join(folder, "runs.csv"))]

    def setUp(self):
        super().setUp()
        self.quiet(self.run_program(*self.asked, "alone", "--threads", "2"))

    def test_any_ranks_make_one_report(self):
        for number, (mpi, ranks, threads) in enumerate(RANKS):
            with self.subTest(mpi=mpi, ranks=ranks, threads=threads):
                folder = f"run{number}"
                run = self.run_job(mpi, ranks, *self.asked, folder, "--threads", threads)
                self.assertEqual((run.code, run.out), (0, folder + "/report.md\n"), run.err)
                self.assertEqual(self.table(folder), self.table("alone"))
                self.assertEqual(len(self.table(folder)), 24)

    @unittest.skipUnless(KILLS, "of the night: set LASIUS_MPI_KILLS")
    def test_a_study_that_lost_ranks_goes_on(self):
        for number in range(KILLS):
            mpi = list(PROGRAMS)[number % len(PROGRAMS)]
            with self.subTest(number=number, mpi=mpi):
                folder = f"killed{number}"
                job = self.start_job(mpi, 3, *self.asked, folder)
                time.sleep(random.random() * 1.5)
                self.kill_a_rank(job)
                run = self.run_job(mpi, random.choice((1, 2, 5)), *self.asked, folder)
                self.assertEqual(run.code, 0, run.err)
                self.assertEqual(self.table(folder), self.table("alone"))
                left = [name for _, _, names in os.walk(self.path(folder)) for name in names if not name[0].isalnum()]
                self.assertEqual(left, [])


class Races(MpiTest):
    def test_all_ranks_come_to_one_preset(self):
        self.write("t.yaml", TUNING)
        alone = self.run_program("tune", "t.yaml", "-o", "alone", "-q")
        if alone.code != 0:
            self.fail(alone.err)
        for number, mpi in enumerate(PROGRAMS):
            run = self.run_job(mpi, 2, "tune", "t.yaml", "-o", f"run{number}", "-q")
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(self.read(f"run{number}/race.csv"), self.read("alone/race.csv"))
            self.assertEqual(self.read(f"run{number}/preset.yaml"), self.read("alone/preset.yaml"))


if __name__ == "__main__":
    if not PROGRAMS:
        print("SKIPPED: lasius_mpi was not built (-DLASIUS_BUILD_MPI=ON, tools/setup mpi) for an MPI whose mpirun is here")
        sys.exit(0)
    unittest.main()
