"""lasius_mpi: what lasius prints, on any ranks and threads, by Open MPI and MPICH; a job that died goes on.

LASIUS_MPI_KILLS: jobs to kill of each kind, after so many answers or runs and a moment (without it one), and then
also all ranks by all threads, and a rank that is late.
"""
import itertools
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest

from layers import map_text, pgm, yaml
from program import MAPS, ProgramTest, Run, environment, tuning

FAN = os.path.join(MAPS, "fan400x200.map")
DRAWN = random.Random(47)
PROGRAMS = {mpi: os.environ[name] for mpi, name in (("openmpi", "LASIUS_MPI_OPENMPI"), ("mpich", "LASIUS_MPI_MPICH"))
            if name in os.environ and shutil.which("mpirun." + mpi)}
KILLS = int(os.environ.get("LASIUS_MPI_KILLS", 0))
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
ALL_AT_WORK = {"LASIUS_MPI_CORES": "64"}  # on a machine of few cores, too

RANKS = [(mpi, ranks, threads) for mpi in PROGRAMS
         for ranks, threads in ([(r, t) for r in (1, 2, 3, 5, 8) for t in (1, 2, 4)] if KILLS else [(3, 1) if mpi == "openmpi" else (2, 2)])]
SKIPPED = 77


TUNING = tuning(iterations=20, candidates=4, maps=2, draw=1, blocks=4, first_test=3, seeds=2)


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


def rank_of(pid):
    with open(f"/proc/{pid}/environ", encoding="utf-8", errors="replace") as file:
        values = dict(value.split("=", 1) for value in file.read().split("\0") if "=" in value)
    return int(values.get("OMPI_COMM_WORLD_RANK", values.get("PMI_RANK", 0)))


class MpiTest(ProgramTest):
    def job(self, mpi, ranks, arguments, other_folder=None):
        """A rank more where there is another folder: it works there."""
        more = ["--oversubscribe", "--bind-to", "none"] if mpi == "openmpi" else []
        asked = [PROGRAMS[mpi], *map(str, arguments)]
        other = [":", "-n", "1", "-wdir", other_folder, *asked] if other_folder else []
        return ["mpirun." + mpi, *more, "-n", str(ranks), "-wdir", self.folder, *asked, *other]

    def run_job(self, mpi, ranks, *arguments, other_folder=None, env=None):
        env = environment(AS_ROOT | (ALL_AT_WORK if env is None else env))
        return Run(subprocess.run(self.job(mpi, ranks, arguments, other_folder), cwd=self.folder, env=env,
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False))

    def start_job(self, mpi, ranks, *arguments, other_folder=None, env=None):
        env = environment(AS_ROOT | (ALL_AT_WORK if env is None else env))
        job = subprocess.Popen(self.job(mpi, ranks, arguments, other_folder), cwd=self.folder, env=env,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(job.stdout.close)
        return job

    def ended_by(self, job, number, *ranks):
        """A signal to these ranks, or to any one. The exit code, and what was printed after."""
        if KILLS:
            time.sleep(DRAWN.uniform(0, 0.1))  # so that it is at any moment
        pids = descendants(job.pid)
        for pid in [pid for pid in pids if rank_of(pid) in ranks] if ranks else DRAWN.sample(pids, min(1, len(pids))):
            os.kill(pid, number)
        out = job.stdout.read()
        return job.wait(60), out

    def run_files(self, folder, job=None, count=0):
        """Run files by their time of change, once there are so many or the job has ended."""
        while True:
            paths = [os.path.join(at, name) for at, _, names in os.walk(self.path(os.path.join(folder, "runs")))
                     for name in names if name[0].isdigit()]
            if len(paths) >= count or job.poll() is not None:
                return {path: os.stat(path).st_mtime_ns for path in paths}
            try:
                job.wait(0.01)
            except subprocess.TimeoutExpired:
                pass

    def journals(self):
        return [name for name in os.listdir(self.folder) if name.endswith(".journal")]


class Batches(MpiTest):
    alone = None

    def setUp(self):
        super().setUp()
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + "".join(f"{14 + i}\t14\t380\t{150 + i % 30}\n" for i in range(30)))
        self.asked = ("batch", FAN, "q.tsv", "--algorithm", "acs", "--islands", "3", "--ants", "6", "--iterations", "2",
                      "-q", "--threads")
        Batches.alone = Batches.alone or timeless(self.quiet(self.run_program(*self.asked, "2")).lines)

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
        self.assertEqual(len(self.rows("all.csv")), 30)
        self.assertEqual(self.read("all.json").decode(), run.out)
        self.quiet(self.run_program(*self.asked, 1, "-o", "alone.svg"))
        self.assertEqual(self.words("all.svg"), self.words("alone.svg"))

    def goes_on(self, mpi, printed):
        """The command to its end; answers that were printed before are not found anew."""
        run = self.run_job(mpi, 2, *self.asked, 2)
        self.assertEqual((run.code, timeless(run.lines)), (0, self.alone), run.err)
        self.assertEqual(run.out.splitlines(True)[:len(printed)], printed)
        self.assertEqual(self.journals(), [])

    def test_a_job_that_lost_a_rank_goes_on_with_others(self):
        number = hits = 0
        while number < max(1, KILLS):
            mpi = list(PROGRAMS)[number % len(PROGRAMS)]
            with self.subTest(number=number, mpi=mpi):
                number += 1
                job = self.start_job(mpi, 3, *self.asked, 1)
                printed = [job.stdout.readline() for _ in range(DRAWN.randrange(1, 20))]  # these are on disk
                code, _ = self.ended_by(job, signal.SIGKILL)
                if journals := self.journals():  # else it had ended
                    hits += 1
                    self.assertNotEqual(code, 0)
                    self.write("torn", self.read(journals[0]) + b"7 1000 0123")
                    os.replace(self.path("torn"), self.path(journals[0]))
                self.goes_on(mpi, printed if journals else [])
        self.assertGreater(2 * hits, number)

    def test_a_signal_to_any_rank_interrupts_the_job(self):
        for mpi, signalled in zip(PROGRAMS, [((0,), (1,), (0, 1))] * 2 if KILLS else [((0,),), ((1,),)]):
            for ranks, env in itertools.product(signalled, ({}, {"LASIUS_MPI_CORES": "1"})):  # at rest, too
                with self.subTest(mpi=mpi, ranks=ranks, env=env):
                    job = self.start_job(mpi, 2, *self.asked, 1, env=env)
                    first = job.stdout.readline()
                    code, out = self.ended_by(job, signal.SIGTERM, *ranks)
                    self.assertEqual(code, 130)
                    self.assertEqual(len(self.journals()), 1)
                    self.goes_on(mpi, (first + out).splitlines(True))

    def test_no_more_ranks_are_at_work_than_cores(self):
        for mpi in PROGRAMS if KILLS else list(PROGRAMS)[:1]:
            run = self.run_job(mpi, 3, *self.asked, 1, env={})  # what this machine has
            self.assertEqual((run.code, timeless(run.lines)), (0, self.alone), run.err)
            job = self.start_job(mpi, 3, *self.asked, 1, env={"LASIUS_MPI_CORES": "1"})
            printed = [job.stdout.readline()]
            others = [pid for pid in descendants(job.pid) if rank_of(pid) != 0]
            self.assertEqual(len(others), 2)
            ended = threading.Timer(120, lambda pids=others: [os.kill(pid, signal.SIGKILL) for pid in pids])
            ended.start()
            for pid in others:
                os.kill(pid, signal.SIGSTOP)  # an answer that one of them were to give would not come
            printed += [job.stdout.readline() for _ in self.alone[1:]]
            ended.cancel()
            self.assertEqual(timeless(json.loads(line) for line in printed if line), self.alone)
            for pid in others:
                os.kill(pid, signal.SIGCONT)
            self.assertEqual(job.wait(60), 0)
        for value, code in (("no", 2), ("0", 2), ("", 0)):
            run = self.run_job(mpi, 2, *self.asked, 1, env={"LASIUS_MPI_CORES": value})
            self.assertEqual((run.code, "LASIUS_MPI_CORES" in run.err, self.journals()), (code, code == 2, []), run.err)

    def other_folder(self, queries):
        other = self.path("other")
        os.makedirs(other, exist_ok=True)
        return self.write("other/q.tsv", queries) and other

    def test_only_the_leader_needs_the_folder_of_outputs(self):
        os.makedirs(self.path("out"))
        other = self.other_folder(self.read("q.tsv"))
        for mpi in PROGRAMS if KILLS else list(PROGRAMS)[:1]:
            run = self.run_job(mpi, 1, *self.asked, 1, "-o", "out/all.csv", other_folder=other)
            self.assertEqual((run.code, timeless(run.lines)), (0, self.alone), run.err)
            run = self.run_job(mpi, 1, *Studies.asked, "study-" + mpi, other_folder=other)
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(os.listdir(other), ["q.tsv"])

    def test_ranks_with_other_input_are_refused(self):
        other = self.other_folder(self.read("q.tsv").replace(b"14\t14", b"14\t15", 1))
        for mpi in PROGRAMS:
            run = self.run_job(mpi, 1, *self.asked, 1, other_folder=other)
            self.ended(run, 3, "rank 1 has other input")

    @unittest.skipUnless(KILLS, "of the night: set LASIUS_MPI_KILLS")
    def test_a_complete_job_waits_for_a_rank_that_is_late(self):
        other = self.other_folder("")
        os.remove(os.path.join(other, "q.tsv"))
        os.mkfifo(os.path.join(other, "q.tsv"))
        for mpi in PROGRAMS:
            job = self.start_job(mpi, 1, *self.asked, 1, other_folder=other)
            self.assertEqual(timeless(json.loads(job.stdout.readline()) for _ in self.alone), self.alone)
            with self.assertRaises(subprocess.TimeoutExpired):
                job.wait(12)
            with open(os.path.join(other, "q.tsv"), "w", encoding="utf-8"):
                pass  # it reads nothing
            self.assertEqual(job.wait(60), 0)

    def test_an_answer_of_any_size_comes_whole(self):
        rows = ["." * 150, "@" * 149 + ".", "." * 150, "." + "@" * 149] * 37 + ["." * 150]
        self.write("long.map", map_text(rows))  # one way, by 11 000 cells
        self.write("q.tsv", "sx\tsy\tgx\tgy\n" + f"0\t0\t149\t{len(rows) - 1}\n" * 6)
        asked = ("batch", "long.map", "q.tsv", "--algorithm", "as", "--ants", "2", "--iterations", "1", "--polish", "none",
                 "-q", "--threads", 1)
        run = self.quiet(self.run_program(*asked))
        self.assertGreater(len(run.out), 6 << 16)
        alone = timeless(run.lines)
        for mpi in PROGRAMS:
            run = self.run_job(mpi, 3, *asked)
            self.assertEqual((run.code, timeless(run.lines)), (0, alone), run.err)

    def test_what_is_wrong_is_said_once(self):
        for mpi in list(PROGRAMS)[-1:]:
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
             "islands=1,2", "--set", "iterations=2", "--seeds", "4", "-q", "-o")
    alone = None

    def table(self, folder):
        return [{**row, "seconds": None} for row in self.rows(os.path.join(folder, "runs.csv"))]

    def setUp(self):
        super().setUp()
        if not Studies.alone:
            self.quiet(self.run_program(*self.asked, "alone", "--threads", "2"))
            Studies.alone = self.table("alone")

    def test_any_ranks_make_one_report(self):
        for number, (mpi, ranks, threads) in enumerate(RANKS):
            with self.subTest(mpi=mpi, ranks=ranks, threads=threads):
                folder = f"run{number}"
                run = self.run_job(mpi, ranks, *self.asked, folder, "--threads", threads)
                self.assertEqual((run.code, run.out), (0, folder + "/report.md\n"), run.err)
                self.assertEqual(self.table(folder), self.alone)
                self.assertEqual(len(self.table(folder)), 16)

    def goes_on(self, mpi, folder, kept):
        run = self.run_job(mpi, DRAWN.choice((1, 2, 5) if KILLS else (1, 2)), *self.asked, folder)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(self.table(folder), self.alone)
        files = self.run_files(folder)
        self.assertEqual({path: files[path] for path in kept}, kept)
        left = [name for _, _, names in os.walk(self.path(folder)) for name in names if not name[0].isalnum()]
        self.assertEqual(left, [])

    def test_a_study_that_lost_ranks_goes_on(self):
        number = hits = 0
        while number < max(1, KILLS):
            mpi = list(PROGRAMS)[number % len(PROGRAMS)]
            with self.subTest(number=number, mpi=mpi):
                folder = f"killed{number}"
                number += 1
                job = self.start_job(mpi, 3, *self.asked, folder)
                self.run_files(folder, job, DRAWN.randrange(1, 11))
                code, _ = self.ended_by(job, signal.SIGKILL)
                hits += code != 0
                self.goes_on(mpi, folder, self.run_files(folder))
        self.assertGreater(2 * hits, number)

    def test_a_signal_to_another_rank_interrupts_a_study(self):
        for mpi in PROGRAMS if KILLS else list(PROGRAMS)[:1]:
            folder = "cut-" + mpi
            job = self.start_job(mpi, 2, *self.asked, folder)
            self.run_files(folder, job, 1)
            code, out = self.ended_by(job, signal.SIGTERM, 1)
            self.assertEqual((code, out), (130, ""))
            self.goes_on(mpi, folder, self.run_files(folder))


class Plans(MpiTest):
    """Of one query, with many seeds: what is shared are the seeds."""
    asked = ("plan", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", "acs", "--ants", "4", "--iterations", "2",
             "--seed", "3-42", "--json", "-q", "--threads")

    def test_seeds_are_shared_and_a_dead_job_goes_on(self):
        run = self.quiet(self.run_program(*self.asked, "2", "-o", "alone.csv"))
        alone, out = timeless(run.lines), [json.loads(line)["seed"] for line in run.out.splitlines()]
        self.assertEqual(out, list(range(3, 43)))
        for mpi in PROGRAMS if KILLS else list(PROGRAMS)[-1:]:
            asked = (*self.asked, 1, "-o", f"{mpi}.csv")  # a journal is of all the words but --threads
            job = self.start_job(mpi, 2, *asked)
            printed = [job.stdout.readline() for _ in range(4)]
            self.ended_by(job, signal.SIGKILL)
            self.assertEqual(len(self.journals()), 1)
            run = self.run_job(mpi, 3, *asked)
            self.assertEqual((run.code, timeless(run.lines)), (0, alone), run.err)
            self.assertEqual(run.out.splitlines(True)[:4], printed)  # their elapsed_ms, too: they are kept
            self.assertEqual(self.journals(), [])
            self.assertEqual(len(self.rows(f"{mpi}.csv")), 40)

    def test_a_query_of_a_batch_is_divided_among_its_seeds(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n9\t5\t0\t0\n9\t0\t0\t5\n")
        for seeds in ("2-2", "2-3", "2-41"):  # more and fewer than a chunk's
            asked = ("batch", "small.map", "q.tsv", "--algorithm", "acs", "--ants", "2", "--iterations", "1", "--seed",
                     seeds, "-q", "--threads", 1)
            alone = self.quiet(self.run_program(*asked))
            run = self.run_job(list(PROGRAMS)[-1], 2, *asked)
            self.assertEqual((run.code, timeless(run.lines)), (0, timeless(alone.lines)), run.err)

    def test_a_plan_without_a_path_says_so(self):
        self.write("walls.map", map_text([".@."] * 3))
        asked = ("plan", "walls.map", "--start", "0,0", "--goal", "2,2", "--algorithm", "acs", "--seed", "1-3", "--json")
        run, alone = self.run_job(list(PROGRAMS)[-1], 2, *asked), self.run_program(*asked)
        self.assertEqual((run.code, run.err, timeless(run.lines)), (5, alone.err, timeless(alone.lines)))


class Islands(MpiTest):
    """Of one search, with one seed: what is shared are the islands of its colony."""

    def asked(self, colony, *more):
        return ("plan", FAN, "--start", "14,14", "--goal", "380,179", "--algorithm", colony, "--islands", "4", "--ants", "12",
                *(more or ("--iterations", "5")), "--set", "exchange_every=2", "--json", "-q", "--threads")

    def test_any_ranks_find_one_path(self):
        for colony in ("acs", "mmas", "fan2004") if KILLS else ("acs",):
            alone = timeless([self.run_program(*self.asked(colony), 2).json])
            for mpi, ranks, threads in RANKS:
                with self.subTest(colony=colony, mpi=mpi, ranks=ranks, threads=threads):
                    run = self.run_job(mpi, ranks, *self.asked(colony), threads)
                    self.assertEqual((run.code, timeless(run.lines)), (0, alone), run.err)

    def test_limits_and_other_input_end_all_ranks(self):
        mpi = list(PROGRAMS)[-1]
        run = self.run_job(mpi, 2, *self.asked("acs", "--iterations", "1000000", "--time-limit", "0.5"), 1)
        self.assertEqual(run.json["status"], "limit", run.err)
        shutil.copy(FAN, self.path("a.map"))
        os.makedirs(self.path("other"))
        self.write("other/a.map", self.read("a.map").replace(b".", b"@", 1))
        asked = [word if word != FAN else "a.map" for word in self.asked("acs")]
        self.ended(self.run_job(mpi, 1, *asked, 1, other_folder=self.path("other")), 3, "rank 1 has other input")

    def test_ranks_that_do_not_wait_find_a_whole_answer(self):
        for mpi, ranks, threads in RANKS:
            with self.subTest(mpi=mpi, ranks=ranks, threads=threads):
                run = self.run_job(mpi, ranks, *self.asked("acs", "--exchange", "asynchronous", "--iterations", "40"), threads,
                                   "-o", "r.json")
                result = run.json
                self.assertEqual((run.code, result["status"], result["iterations"]), (0, "solved", 40), run.err)
                self.assertEqual(result["parameters"]["exchange"], "asynchronous")
                self.assertEqual(result["best"][-1], result["length"])
                self.assertLessEqual(max(result["arrived"]), 12)
                self.quiet(self.run_program("check-path", FAN, "r.json"))
                # Until one is told something, all is as scheduled.
                first = self.run_program(*self.asked("acs", "--iterations", "2"), 1).json
                self.assertEqual(result["steps"][:2], first["steps"])
                limited = self.run_job(mpi, ranks, *self.asked("acs", "--exchange", "asynchronous", "--iterations", "1000000",
                                                               "--time-limit", "0.3"), threads)
                self.assertEqual(limited.json["status"], "limit", limited.err)

    def test_pictures_of_ants_are_of_one_process(self):
        self.quiet(self.run_program(*self.asked("acs"), 1, "-o", "alone.svg"))
        run = self.run_job(list(PROGRAMS)[-1], 2, *self.asked("acs"), 1, "-o", "ranks.svg")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(self.read("ranks.svg"), self.read("alone.svg"))


class Keys(MpiTest):
    """A journal is of one input. An output that cannot be written leaves it, and its name is the input's hash."""

    def setUp(self):
        super().setUp()
        os.symlink("/dev/full", self.path("full.json"))
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t9\t5\n")
        self.write("poses.tsv", "sx\tsy\tsyaw\tgx\tgy\tgyaw\n4\t4\t0\t14\t5\t0\n")
        self.write("yard.map", map_text(["." * 20] * 10))
        self.write("ground.yaml", yaml("ground.pgm", 1, (0, 0, 0)))
        self.write("layer.yaml", yaml("layer.pgm", 1, (0, 0, 0), "scale"))
        for name in ("ground.pgm", "layer.pgm"):
            self.write(name, pgm([[250] * 10] * 6))
        self.write("car.json", json.dumps({"type": "omni", "footprint": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "units": "cells"}))
        self.write("world.wkt", "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0), (9 4, 11 4, 11 8, 9 8, 9 4))\n")
        self.write("p.yaml", "algorithm: exact\n")

    def key(self, *arguments):
        run = self.run_job(list(PROGRAMS)[-1], 1, "batch", *arguments, "-q", "-o", "full.json")
        self.assertEqual(run.code, 7, run.err)
        journals = self.journals()
        self.assertEqual(len(journals), 1)
        os.remove(self.path(journals[0]))
        return journals[0]

    def test_every_input_is_in_it(self):
        layers = ("ground.yaml", "q.tsv", "--cost", "layer.yaml")
        vehicle = ("yard.map", "poses.tsv", "--vehicle", "car.json")
        world = ("world.wkt", "q.tsv", "--preset", "p.yaml", "--algorithm", "exact")
        kinds = ((layers, ("q.tsv", "ground.pgm", "layer.pgm")), (vehicle, ("yard.map", "car.json")))
        if "maklink" in self.run_program("algorithms").out:
            kinds += ((world, ("world.wkt", "p.yaml")),)
        for arguments, files in kinds:
            keys = {self.key(*arguments)}
            self.assertEqual({self.key(*arguments, "--threads", "2")}, keys)
            for file in files:
                with self.subTest(arguments=arguments, file=file):
                    was = self.read(file)
                    self.write(file, was[:-2] + b"\xf9\xfa" if file.endswith(".pgm") else was + b"\n")
                    key = self.key(*arguments)
                    self.assertNotIn(key, keys)
                    keys.add(key)
                    self.write(file, was)

    def test_what_is_read_once_is_refused(self):
        os.mkfifo(self.path("pipe.tsv"))
        job = self.start_job(list(PROGRAMS)[-1], 1, "batch", "small.map", "pipe.tsv", "-q")
        with open(self.path("pipe.tsv"), "wb") as file:
            file.write(self.read("q.tsv"))
        self.assertEqual((job.stdout.read(), job.wait(60)), ("", 3))
        self.assertEqual(self.journals(), [])


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
        sys.exit(SKIPPED)
    unittest.main()
