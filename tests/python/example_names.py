"""What the examples in documents take as given: `lasius`, `np`, the folder `maps`, a folder to write in."""

import os
import pathlib

import numpy
import pytest

import lasius


@pytest.fixture(autouse=True)
def names(doctest_namespace, tmp_path, monkeypatch):
    maps = pathlib.Path(os.environ["LASIUS_MAPS_DIR"])
    doctest_namespace.update(lasius=lasius, np=numpy, maps=maps)
    monkeypatch.chdir(tmp_path)
