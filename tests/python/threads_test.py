"""Eight Python threads on one planner, with callbacks, exceptions and Ctrl-C.

LASIUS_PYTHON_PLANS: plans in all, 48 unless said otherwise; from 2000 on memory must not grow in the
second half of them.
"""

import os
import signal
import threading

import numpy as np
import pytest

import lasius
from conftest import GOAL, START

PLANS = int(os.environ.get("LASIUS_PYTHON_PLANS", 48))
THREADS = 8


def resident_kb():
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))


class Worker(threading.Thread):
    """Plans in turn: to the end, stopped by its observer, failed by it."""

    def __init__(self, planner, wanted, count):
        super().__init__()
        self.planner, self.wanted, self.count = planner, wanted, count
        self.faults = []

    def run(self):
        for i in range(self.count):
            try:
                self.plan(i)
            except BaseException as error:  # noqa: B902: told by the test
                self.faults.append(repr(error))

    def plan(self, i):
        def observe(progress):
            if i % 3 == 1 and progress.iteration == 2:
                progress.stop()
            if i % 3 == 2 and progress.iteration == 1:
                raise RuntimeError(str(i))

        try:
            result = self.planner.plan(START, GOAL, "fan2004", iterations=4, seed=1 + i % 5, threads=1, observer=observe)
        except RuntimeError as error:
            assert str(error) == str(i) and error.result.iterations == 2
            return
        wanted = self.wanted[i % 5]
        assert result.iterations == (3 if i % 3 == 1 else 4)
        assert np.array_equal(result.curves.mean, wanted.curves.mean[: result.iterations])


def interrupted_plans(planner, workers):
    """While workers work, the main thread plans and is interrupted; how often."""
    times = 0
    while any(worker.is_alive() for worker in workers):
        with pytest.raises(KeyboardInterrupt) as caught:
            planner.plan(START, GOAL, "mmas", iterations=10**9, threads=1, observer=lambda p: interrupt(p.iteration))
        assert caught.value.result.status == "interrupted"
        times += 1
    return times


def interrupt(iteration):
    if iteration == 3:
        os.kill(os.getpid(), signal.SIGINT)


def work(planner, wanted, plans):
    workers = [Worker(planner, wanted, plans // THREADS) for _ in range(THREADS)]
    for worker in workers:
        worker.start()
    times = interrupted_plans(planner, workers)
    for worker in workers:
        worker.join()
        assert worker.faults == []
    return times


def test_eight_threads_with_callbacks_and_interrupts(planner):
    wanted = [planner.plan(START, GOAL, "fan2004", iterations=4, seed=seed) for seed in range(1, 6)]
    assert work(planner, wanted, PLANS // 2) > 0
    half = resident_kb()
    assert work(planner, wanted, PLANS // 2) > 0
    sanitized = "asan" in os.environ.get("LD_PRELOAD", "")  # which keeps what is freed for a while
    if PLANS >= 2000 and not sanitized:
        assert resident_kb() < half + 8192, "memory grows"
