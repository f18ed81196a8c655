"""Ctrl-C, and processes that are forked."""

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import lasius
from conftest import GOAL, START

ENDLESS = 10**9


def interrupt_when(event):
    """A thread that sends SIGINT once the event is set."""
    def send():
        assert event.wait(60)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    return thread


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_carries_the_best_so_far(planner, threads):
    begun = threading.Event()
    sender = interrupt_when(begun)
    with pytest.raises(KeyboardInterrupt) as caught:
        planner.plan(START, GOAL, "mmas", iterations=ENDLESS, threads=threads, observer=lambda _: begun.set())
    sender.join()
    result = caught.value.result
    assert result.status == "interrupted" and result.iterations == len(result.curves) > 0
    assert lasius.path_fault(planner.grid, result.path) is None and result.found
    assert planner.plan(START, GOAL).optimal, "the next call is not stopped by the signal before"


def test_ctrl_c_in_a_batch(planner):
    begun = threading.Event()
    sender = interrupt_when(begun)
    with pytest.raises(KeyboardInterrupt) as caught:
        planner.batch([START] * 100000, [GOAL] * 100000, "fan2004", iterations=2, progress=lambda *_: begun.set())
    sender.join()
    assert 0 < len(caught.value.result) < 100000 and caught.value.result.status[0] == "solved"


WITHOUT_CALLBACK = """
import signal
import lasius
planner = lasius.Planner(lasius.generate("blobs", width=400, height=200, seed=61))
while True:
    try:
        print("ready", flush=True)
        planner.plan((14, 14), (380, 179), "mmas", iterations=10**9)
    except KeyboardInterrupt as stopped:
        if hasattr(stopped, "result"):
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            print("\\n", stopped.result.status, flush=True)
            break
"""


def test_ctrl_c_without_a_callback():
    with subprocess.Popen([sys.executable, "-c", WITHOUT_CALLBACK], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "ready\n"
        for _ in range(40):
            child.send_signal(signal.SIGINT)  # one that comes before the plan begins stops nothing
            try:
                child.wait(3)
                break
            except subprocess.TimeoutExpired:
                pass
        else:
            child.kill()
        assert child.stdout.read().endswith("interrupted\n")


def test_a_handler_of_ones_own_gets_the_result(planner):
    seen = []
    before = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    try:
        begun = threading.Event()
        sender = interrupt_when(begun)
        result = planner.plan(START, GOAL, "mmas", iterations=ENDLESS, observer=lambda _: begun.set())
        sender.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert result.status == "interrupted" and seen == [signal.SIGINT]


def test_handlers_are_as_before(planner):
    for handler in (signal.SIG_IGN, signal.SIG_DFL, signal.default_int_handler):
        before = signal.signal(signal.SIGINT, handler)
        planner.plan(START, GOAL, "mmas", iterations=2)
        assert signal.signal(signal.SIGINT, before) == handler


def test_making_a_planner_can_be_stopped():
    grid = lasius.generate("blobs", width=2048, height=2048, seed=1)  # labelled in 2 ms
    signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(TimeoutError("alarm")))
    try:
        for wait in (0.001, 0.003, 0.01):
            made = False
            with pytest.raises(TimeoutError):
                signal.setitimer(signal.ITIMER_REAL, wait)
                lasius.Planner(grid, prepare=True)
                made = True
                time.sleep(60)  # a signal that was kept back ends it
            assert not made, wait
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)


def planned(seed):
    grid = lasius.generate("blobs", width=400, height=200, seed=61)
    return lasius.Planner(grid).plan(START, GOAL, "fan2004", iterations=5, seed=seed, threads=2)


def test_forked_processes_plan_with_two_threads():
    mine = [planned(seed) for seed in (1, 2, 3, 4)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        theirs = pool.map_async(planned, (1, 2, 3, 4)).get(120)
    assert theirs == mine and not np.array_equal(mine[0].curves.mean, mine[1].curves.mean)


@pytest.mark.parametrize("call", ["plan", "batch"])
def test_python_ends_though_a_daemon_thread_plans_with_callbacks(call):
    """Python ends threads that ask for its lock then, which C++ must not be in the midst of."""
    ask = {"plan": "planner.plan((5, 5), (90, 70), 'mmas', iterations=10**9, update=update)",
           "batch": "planner.batch([(5, 5)] * 9, [(90, 70)] * 9, 'mmas', iterations=10**9, threads=2, update=update)"}[call]
    program = f"""
import threading, lasius
planner = lasius.Planner(lasius.generate("blobs", width=100, height=80, density=0.05))
begun = threading.Event()
def update(trail, tours):
    begun.set()
def go():
    while True:
        {ask}
threading.Thread(target=go, daemon=True).start()
assert begun.wait(60)
"""
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert ended.returncode == 0 and "FATAL" not in ended.stderr, ended.stderr
