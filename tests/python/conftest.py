"""What the tests share."""

import os
import pathlib
import signal

import pytest

import lasius

START, GOAL = (14, 14), (380, 179)

# A shell's jobs in the background ignore Ctrl-C, which tests send themselves.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def maps():
    return pathlib.Path(os.environ["LASIUS_MAPS_DIR"])


@pytest.fixture(scope="session")
def grid():
    return lasius.generate("blobs", width=400, height=200, seed=61)


@pytest.fixture(scope="session")
def planner(grid):
    return lasius.Planner(grid)
