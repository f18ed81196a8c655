"""Types of arrays, and values as the library and pickle take them."""

from __future__ import annotations

import os
from typing import Any, Tuple, Union

import numpy as np
import numpy.typing as npt

from .errors import invalid

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]
LongArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

Cell = Tuple[int, int]
End = Union[Tuple[int, int], Tuple[float, float]]  #: a cell, or where a number is no integer a point
Point = Tuple[float, float]
Path = Union[str, "os.PathLike[str]"]


def int_rows(rows: npt.ArrayLike, name: str) -> IntArray:
    """Rows of integers. Numbers with a fraction are refused, not cut off, and so are those of no map."""
    array = np.asarray(unmasked(rows, name))
    if array.size == 0:
        return np.empty((0, 2), np.int32)
    huge = array.dtype.kind == "O" and all(isinstance(number, int) for number in array.flat)
    if array.dtype.kind not in "iu" and not huge:
        raise TypeError(f"{name} is an array of {array.dtype}: give integers")
    limits = np.iinfo(np.int32)
    beyond = array[(array < limits.min) | (array > limits.max)]
    if beyond.size > 0:
        raise invalid(f"{name} has {beyond[0]}", f"numbers of cells are {limits.min} .. {limits.max}")
    return np.ascontiguousarray(array, np.int32)


def cells_or_points(rows: npt.ArrayLike, name: str) -> Tuple[IntArray, FloatArray]:
    """Rows of integers as cells, of other numbers as points; the other is empty."""
    given = np.asarray(unmasked(rows, name))
    are_points = given.dtype.kind == "f" and given.size > 0
    points = np.ascontiguousarray(given if are_points else np.empty((0, 2)), np.float64)
    return int_rows([] if are_points else rows, name), points


def unmasked(array: npt.ArrayLike, name: str) -> npt.ArrayLike:
    """The array; refuses one whose mask would be lost."""
    if isinstance(array, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array: say what masked values are by .filled(value)")
    return array


def flags_of(value: npt.ArrayLike, name: str) -> BoolArray:
    """A bool or an array of them. What only counts as true or false is refused: it is most likely a mistake."""
    flags = np.asarray(unmasked(value, name))
    if flags.dtype.kind != "b" and flags.size > 0:
        raise TypeError(f"{name} is {value!r:.60}: give True or False, or an array of them")
    return flags.astype(np.bool_)


def flag_of(value: Any, name: str) -> bool:
    """True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {value!r:.60}: give True or False")
    return bool(value)


def numbers_of(value: npt.ArrayLike, shape: Tuple[int, ...], name: str) -> FloatArray:
    """An array of this shape, in which -1 is any length."""
    try:
        array = np.asarray(unmasked(value, name), np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r:.60}: give an array of numbers") from None
    if len(array.shape) != len(shape) or any(a != b for a, b in zip(array.shape, shape) if b >= 0):
        wanted = str(shape).replace("-1", "n")
        raise ValueError(f"{name} has the shape {array.shape}: give {wanted}")
    return array


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
