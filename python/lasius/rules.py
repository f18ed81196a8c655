"""Rules of your own in a colony on a bitmap: a variant of a paper without touching the library.

A place is what carries one number of the trail, tau. With `trail="cells"` (of `ras` and others) it is a
cell, y * width + x; with `trail="arcs"` a move out of one, cell * moves + k, moves counted by rows.
"""

from __future__ import annotations

from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._lasius import Grid, IterationTours, Pheromone
from .arrays import FloatArray, unmasked

Update = Callable[[Pheromone, IterationTours], Any]
Schedule = Callable[[int], Dict[str, float]]
Heuristic = Union[str, npt.ArrayLike]
OwnRules = Tuple[Optional[FloatArray], Optional[Update], Optional[Schedule]]


def table_of(heuristic: Optional[Heuristic], grid: Grid) -> Optional[FloatArray]:
    """The table of an own heuristic as the library reads it, without a copy where it is one already;
    None for the name of a built-in one."""
    if heuristic is None or isinstance(heuristic, str):
        return None
    table = np.ascontiguousarray(unmasked(heuristic, "heuristic"), np.float64)
    if table.ndim not in (2, 3) or table.shape[:2] != grid.shape:
        raise ValueError(
            f"heuristic has the shape {table.shape}: give {grid.shape}, a value a cell, or {grid.shape} x moves"
        )
    return table


def own_rules(
    heuristic: Optional[Heuristic], update: Union[None, str, Update], schedule: Optional[Schedule], grid: Grid
) -> OwnRules:
    """What of a colony is the caller's own, as the library takes it."""
    return table_of(heuristic, grid), None if isinstance(update, str) else update, schedule


def named(settings: Dict[str, Any], update: Any, heuristic: Any) -> Dict[str, Any]:
    """The parameters, with the names of a built-in update and heuristic among them."""
    names = {"update": update, "heuristic": heuristic}
    return {**settings, **{name: value for name, value in names.items() if isinstance(value, str)}}
