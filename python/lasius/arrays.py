"""Types of arrays, and values as the library and pickle take them."""

from __future__ import annotations

import os
from typing import Any, Tuple, Union

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]
LongArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

Cell = Tuple[int, int]
Point = Tuple[float, float]
Path = Union[str, "os.PathLike[str]"]


def int_rows(rows: npt.ArrayLike, name: str) -> IntArray:
    """Rows of integers. Numbers with a fraction are refused, not cut off."""
    array = np.asarray(rows)
    if array.size == 0:
        return np.empty((0, 2), np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} is an array of {array.dtype}: give integers")
    limits = np.iinfo(np.int32)  # far outside of any map
    return np.ascontiguousarray(np.clip(array, limits.min, limits.max), np.int32)


def file_name(path: Path) -> bytes:
    """A path as the system has it: os.listdir gives names that are no UTF-8, too."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError(f"{path!r} is no path: it has a NUL byte")
    return name


def same(a: Any, b: Any) -> bool:
    """Equality of two values of a record: of arrays in all elements, NaN equal to NaN."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        kinds = isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and a.dtype.kind == b.dtype.kind
        return kinds and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    if isinstance(a, float) and isinstance(b, float) and a != a:
        return b != b
    return bool(a == b)


def reduced(value: Any, protocol: Any) -> Any:
    """`__reduce_ex__` of what has no __init__ without arguments: pickle's protocols 0 and 1 made instances
    of it without its __new__, and instances of the extension's classes so made end the process."""
    return object.__reduce_ex__(value, max(protocol, 2))
