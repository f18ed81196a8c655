"""Maps: from files and seeds, and questions about them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import Grid, WorldFrame, Workspace
from .arguments import explained
from .arrays import Cell, FloatArray, Path, file_name, flag_of, unmasked
from .errors import invalid, made
from .parameters import text_of


@dataclass(frozen=True)
class Map:
    """A map as read from a file."""

    grid: Grid  #: row 0 at the top
    frame: Optional[WorldFrame]  #: where it lies in the world; None where the file does not say
    image: str  #: of a ROS map the file of its image, else empty
    unknown: Optional[Grid] = None  #: of a ROS map a grid whose blocked cells are the unknown ones


@explained
def read_map(path: Path, *, unknown_is_free: bool = False, free_below: float = 0.5) -> Map:
    """Reads MovingAI .map, PBM, PGM, PNG, BMP (told apart by content) or ROS map_server YAML.

    Args:
        path: the file's name.
        unknown_is_free: unknown cells of a ROS map count as free; `Map.unknown` tells which they are.
        free_below: a pixel of less darkness than this is free, in (0, 1].
    Raises:
        FileMissing, FileBroken, FileUnsupported: with the file, the line or offset, and the remedy.
    """
    return Map(*_lasius.read_map(file_name(path), flag_of(unknown_is_free, "unknown_is_free"), free_below))


@explained
def write_map(grid: Grid, path: Path) -> None:
    """Writes .map, .pbm or .png by the name's ending, whole or not at all."""
    _lasius.write_map(grid, file_name(path))


def map_kinds() -> List[str]:
    """What `generate` can make.

    >>> map_kinds()
    ['blobs', 'maze', 'rooms', 'city', 'random', 'open']
    """
    return list(_lasius.map_kinds())


@explained
def generate(
    kind: str, *, width: int = 512, height: int = 512, density: Optional[float] = None, seed: int = 1
) -> Grid:
    """A map made from a seed, the same on every machine.

    >>> generate("maze", width=40, height=30, seed=3)
    Grid(40 x 30 cells)

    Args:
        kind: one of `map_kinds()`.
        width: in cells, 1 to 32768; likewise height.
        density: share of blocked cells that is aimed at; None: the kind's own.
        seed: another one, another map.
    """
    return made(*_lasius.generate(kind, width, height, density, seed))


@explained
def clearance(grid: Grid) -> FloatArray:
    """Distance in cells from each cell's centre to the nearest blocked cell or the outside, [y, x]; exact.

    >>> clearance(lasius.Grid(np.zeros((3, 3), np.uint8), free=0))[1]
    array([0.5, 1.5, 0.5])
    """
    return made(*_lasius.clearance(grid))


@explained
def grow_obstacles(grid: Grid, radius: float) -> Grid:
    """The map for a robot of this radius, in cells: blocks each cell that has a point nearer than that
    to a blocked cell or the outside. Radius 0 changes nothing. A disc passes more: Planner(grid, radius=...).

    >>> grow_obstacles(lasius.Grid(np.zeros((3, 3), np.uint8), free=0), 1).count_free()
    1
    """
    return made(*_lasius.grow_obstacles(grid, radius))


@explained
def shortest_walk(
    grid: Grid, start: Cell, goal: Cell, neighbours: Union[str, int] = 8, corners: str = "forbid"
) -> Optional[float]:
    """Length in cells of the shortest walk by the moves that ants have; None where there is none.

    >>> shortest_walk(lasius.Grid(np.zeros((3, 3), np.uint8), free=0), (0, 0), (2, 2), 4)
    4.0

    Args:
        neighbours: 4, 8, 16, "16k", 24 or 32.
        corners: diagonal steps past blocked cells: "forbid", "one-side" or "allow".
    """
    error, length = _lasius.shortest_walk(grid, start, goal, text_of(neighbours), corners)
    if error is not None:
        raise error
    return length


@explained
def path_length(path: npt.ArrayLike) -> float:
    """Length of a polyline (n, 2).

    >>> path_length([[0.5, 0.5], [3.5, 4.5]])
    5.0
    """
    return float(_lasius.path_length(unmasked(path, "path")))


@explained
def path_fault(grid: Grid, path: npt.ArrayLike, corners: str = "forbid") -> Optional[str]:
    """Why a polyline (n, 2) breaks the rule of the plane, or None if it obeys; exact. Vertices but
    the first and the last are multiples of 0.5."""
    return _lasius.path_fault(grid, unmasked(path, "path"), corners)


@explained
def visible(grid: Grid, a: Cell, b: Cell) -> bool:
    """True when the straight line between the centres of two free cells is free; exact."""
    return bool(_lasius.visible(grid, a, b))


@explained
def pull_taut(grid: Grid, path: npt.ArrayLike, corners: str = "forbid") -> FloatArray:
    """The shortest path (m, 2) that goes the same way round all obstacles as a valid one (n, 2)."""
    return made(*_lasius.pull_taut(grid, unmasked(path, "path"), corners))


_made_workspace: Any = Workspace.__init__
_made_grid: Any = Grid.__init__  # the extension's
_made_frame: Any = WorldFrame.__init__


def grid_init(self: Grid, array: npt.NDArray[Any], *, free: Any) -> None:
    if not isinstance(array, np.ndarray):
        raise TypeError(f"array is a {type(array).__name__}: give one of numpy, as np.asarray(cells, np.uint8)")
    _made_grid(self, unmasked(array, "array"), free=free)


def workspace_init(self: Workspace) -> None:
    _made_workspace(self)


workspace_init.__qualname__ = "Workspace"


def frame_init(
    self: WorldFrame, resolution: float, origin_x: float = 0.0, origin_y: float = 0.0, yaw: float = 0.0
) -> None:
    _made_frame(self, resolution, origin_x, origin_y, yaw)
    values = frame_values(self)
    if not (self.resolution > 0 and np.isfinite(values).all()):
        raise invalid(f"WorldFrame{values}", "the resolution must be above 0, and all numbers finite")


def frame_values(frame: WorldFrame) -> Tuple[float, ...]:
    return frame.__getstate__()


def frame_equal(frame: WorldFrame, other: object) -> bool:
    return isinstance(other, WorldFrame) and frame_values(frame) == frame_values(other)


def frame_hash(frame: WorldFrame) -> int:
    return hash(frame_values(frame))


def frame_repr(frame: WorldFrame) -> str:
    resolution, x, y, yaw = frame_values(frame)
    return f"WorldFrame({resolution!r}, origin_x={x!r}, origin_y={y!r}, yaw={yaw!r})"


grid_init.__qualname__, frame_init.__qualname__ = "Grid", "WorldFrame"
setattr(Grid, "__init__", explained(grid_init))
setattr(Workspace, "__init__", workspace_init)
setattr(WorldFrame, "__init__", explained(frame_init))
setattr(WorldFrame, "__eq__", frame_equal)
setattr(WorldFrame, "__hash__", frame_hash)
setattr(WorldFrame, "__repr__", frame_repr)
