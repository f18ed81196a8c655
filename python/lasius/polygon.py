"""Planning among polygons. Coordinates are plain planar ones, y up, in any unit.

An area is a ring (an array (n, 2), the first vertex not repeated or repeated), a pair (ring, [hole,
...]), or anything with `__geo_interface__`: shapely's geometries and GeoJSON-like objects.

>>> world = World([[0, 0], [10, 0], [10, 10], [0, 10]], [[[4, 2], [6, 2], [6, 9], [4, 9]]])
>>> result = Planner(world).plan((1, 5), (9, 5))
>>> result.status, round(result.length, 4)
('solved', 10.4853)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from .arguments import explained
from .arrays import FloatArray, IntArray, Path, Point, file_name, unmasked
from .errors import finish, made
from .parameters import Algorithm, ParameterSet, chosen, described
from .progress import Shown, counted, watched
from .results import BatchResult, Record, SearchResult, answer, batch_result

if not hasattr(_lasius, "polygon"):
    raise ImportError("lasius was built without its component polygon")
_raw: Any = _lasius.polygon

Progress = _raw.Progress
Ring = FloatArray
Area = Tuple[Ring, List[Ring]]  #: outline and holes
AreaLike = Any


def ring_of(points: Any) -> Ring:
    """A ring as an array (n, 2), its first vertex not repeated; of 3-D coordinates x and y."""
    ring = np.asarray(unmasked(points, "a ring"), np.float64)
    if ring.ndim != 2 or ring.shape[1] < 2:
        raise ValueError(f"a ring of the shape {ring.shape}: give (n, 2)")
    ring = ring[:, :2]
    closed = len(ring) > 1 and bool((ring[0] == ring[-1]).all())
    return np.ascontiguousarray(ring[:-1] if closed else ring)


def areas_of_geometry(geometry: Dict[str, Any]) -> Iterator[Area]:
    """All areas of a GeoJSON object."""
    kind = geometry["type"]
    if kind == "Polygon":
        outer, *holes = geometry["coordinates"]
        yield ring_of(outer), [ring_of(hole) for hole in holes]
    elif kind == "MultiPolygon":
        for polygon in geometry["coordinates"]:
            yield from areas_of_geometry({"type": "Polygon", "coordinates": polygon})
    elif kind == "Feature":
        yield from areas_of_geometry(geometry["geometry"])
    elif kind in ("FeatureCollection", "GeometryCollection"):
        for part in geometry["features" if kind == "FeatureCollection" else "geometries"]:
            yield from areas_of_geometry(part)
    else:
        raise ValueError(f"a geometry of type {kind}: give polygons")


def areas_of(source: AreaLike) -> Iterator[Area]:
    """The areas of anything that stands for some."""
    geometry = source if isinstance(source, dict) else getattr(source, "__geo_interface__", None)
    if geometry is not None:
        yield from areas_of_geometry(geometry)
    elif isinstance(source, tuple) and len(source) == 2 and np.ndim(source[0]) == 2:
        yield ring_of(source[0]), [ring_of(hole) for hole in source[1]]
    else:
        yield ring_of(source), []


@explained
class World:
    """A boundary, obstacles in it, perhaps a start and a goal.

    Args:
        boundary: one area; its holes are obstacles.
        obstacles: areas, which may overlap, or one geometry with several.
        start: point (x, y) of requests that name none; likewise goal.
        margin: of the robot: obstacles grow by it.
    Raises:
        InvalidParameter: for rings that cross themselves or have no area.
    """

    __slots__ = ("_raw",)

    def __init__(
        self,
        boundary: AreaLike,
        obstacles: Union[AreaLike, Iterable[AreaLike]] = (),
        *,
        start: Optional[Point] = None,
        goal: Optional[Point] = None,
        margin: float = 0.0,
    ) -> None:
        outlines = list(areas_of(boundary))
        if len(outlines) != 1:
            raise ValueError(f"a boundary of {len(outlines)} areas: give one")
        whole = isinstance(obstacles, dict) or hasattr(obstacles, "__geo_interface__")
        parts = [obstacles] if whole else list(obstacles)
        areas = [area for part in parts for area in areas_of(part)]
        self._raw = _raw.World(outlines[0], areas, start, goal, margin)

    @classmethod
    def _of(cls, raw: Any) -> World:
        world = cls.__new__(cls)
        world._raw = raw
        return world

    @classmethod
    def read(cls, path: Path, *, repair: bool = False) -> World:
        """From GeoJSON or WKT, see docs/worlds.md.

        Args:
            repair: geometry that is not valid is repaired, not refused.
        """
        return cls._of(_raw.read_world(file_name(path), repair))

    @classmethod
    def from_geojson(cls, text: str, *, repair: bool = False) -> World:
        """From the text of a GeoJSON FeatureCollection."""
        return cls._of(_raw.parse_geojson(text, repair))

    def to_geojson(self) -> str:
        """A feature a line, which `from_geojson` reads."""
        return str(self._raw.to_geojson())

    def write(self, path: Path) -> None:
        """GeoJSON or, to names that end in .wkt, WKT."""
        self._raw.write(file_name(path))

    @property
    def boundary(self) -> Area:
        """Its outline and holes."""
        return self._raw.boundary()

    @property
    def obstacles(self) -> List[Area]:
        """Outlines and holes."""
        return self._raw.obstacles()

    @property
    def start(self) -> Optional[Point]:
        return self._raw.start

    @property
    def goal(self) -> Optional[Point]:
        return self._raw.goal

    @property
    def margin(self) -> float:
        return float(self._raw.margin)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, World) and self.to_geojson() == other.to_geojson()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Tuple[Any, ...]:
        return (restored, (self.to_geojson(),))

    def __repr__(self) -> str:
        return f"<World: {len(self.obstacles)} obstacles, margin {self.margin:g}>"


def restored(text: str) -> World:
    """A world that was pickled."""
    return World.from_geojson(text)


def algorithms() -> Dict[str, Algorithm]:
    """All algorithms among polygons by name, the default first.

    >>> list(algorithms())
    ['exact', 'maklink-acs', 'real-ga']
    """
    return described(_raw.algorithms())


@explained
class Params(ParameterSet):
    """The parameters of one algorithm among polygons.

    >>> Params("maklink-acs", ants=20, seed=4)
    Params('maklink-acs', ants=20, seed=4)
    """

    __slots__ = ()
    _known = staticmethod(algorithms)

    def __init__(self, algorithm: str = "exact", **settings: Any) -> None:
        self._set(_raw.Params(algorithm), settings)


@dataclass(eq=False)
class Crossing(Record):
    """A way across lines, and the crossing point on each."""

    lines: IntArray  #: (n,), rows of Planner.lines, in the order they are crossed
    values: FloatArray  #: (n,), 0 to 1 along each line
    path: FloatArray  #: (n + 2, 2), start, crossing points, goal
    length: float  #: in the world's unit


@dataclass(eq=False, repr=False)
class Result(SearchResult):
    """One answer among polygons; lengths in the world's unit."""

    path: FloatArray  #: (n, 2)
    goal_reached: Optional[Point]  #: with a goal tolerance: where the path ends
    nearest_free: Optional[Point]  #: to a start or goal that is blocked or outside
    nearest_reachable: Optional[Point]  #: the same among the points that are joined to the other end
    crossing: Optional[Crossing]  #: of the ants' or the genetic algorithm's best path
    dijkstra: Optional[Crossing]  #: through midpoints
    discrete_optimum: Optional[Crossing]  #: of the same lines and values
    sequence_optimum: Optional[Crossing]  #: of the same lines
    optimum: Optional[float]  #: length of the shortest path, where it was found
    note: str  #: what mitre joins do to the answer, or empty
    params: ParameterSet  #: as asked
    world: World  #: as asked

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The path as a GeoJSON LineString."""
        return {"type": "LineString", "coordinates": self.path.tolist()}

    def plot(self, axes: Any = None) -> Any:
        """Draws world and path; as lasius.Result.plot."""
        from . import plots

        axes = plot_world(self.world, axes)
        plots.draw_line(self.path, axes)
        axes.set_title(plots.title(self))
        return axes


def plot_world(world: Optional[World], axes: Any = None) -> Any:
    """Draws boundary and obstacles; needs matplotlib. None: the axes alone."""
    from . import plots

    axes = axes if axes is not None else plots.new_axes(False)[0]
    if world is not None:
        outline, holes = world.boundary
        axes.plot(*np.vstack([outline, outline[:1]]).T, color="black", linewidth=1)
        for ring in [*holes, *(outer for outer, _ in world.obstacles)]:
            axes.fill(*ring.T, color="#8c8c8c")
    axes.set(aspect="equal", xlabel="x", ylabel="y")
    return axes


@explained
class Planner:
    """A world made ready: obstacles grown, the MAKLINK graph made. It never changes: use one from many
    threads.

    Args:
        world: what to plan in.
        margin: in place of the world's own.
        join: how obstacles grow at corners: "round", "mitre", "bevel", "chords".
        boundary: "shrink": the robot keeps the margin to it, too; "keep": it may run along it.
    """

    __slots__ = ("_raw", "_world")
    _raw: Any

    def __init__(
        self, world: World, *, margin: Optional[float] = None, join: str = "round", boundary: str = "shrink"
    ) -> None:
        self._world = world
        self._raw = made(*_raw.make_planner(world._raw, margin, join, boundary))

    def plan(
        self,
        start: Optional[Point] = None,
        goal: Optional[Point] = None,
        params: Union[None, str, Params] = None,
        *,
        time_limit: Optional[float] = None,
        target_gap: float = 0.0,
        goal_tolerance: float = 0.0,
        observer: Optional[Callable[[Any], Any]] = None,
        progress: Shown = None,
        **settings: Any,
    ) -> Result:
        """Answers one question; as lasius.Planner.plan.

        Args:
            start: point (x, y); None: the world's; likewise goal.
            goal_tolerance: where the goal cannot be reached, the path ends at the point nearest to it that can
                be, at most so far from it; `goal_reached` of the result tells where.
        """
        used = chosen(Params, params, settings)
        with watched(observer, progress, used) as watch:
            error, fields = self._raw.plan(
                start, goal, used._raw, target_gap, goal_tolerance, time_limit, watch
            )
        search, path, reached, nearest, reachable, *ways, optimum, note = fields
        crossings = [None if way is None else Crossing(*way) for way in ways]
        others = (path, reached, nearest, reachable, *crossings, optimum, note, used, self._world)
        return finish(error, answer(Result, search, *others))

    def batch(
        self,
        starts: npt.ArrayLike,
        goals: npt.ArrayLike,
        params: Union[None, str, Params] = None,
        *,
        threads: int = 0,
        seeds: int = 1,
        time_limit: Optional[float] = None,
        target_gap: float = 0.0,
        goal_tolerance: float = 0.0,
        progress: Shown = None,
        **settings: Any,
    ) -> BatchResult:
        """Answers many questions side by side; as lasius.Planner.batch, lengths in the world's unit.

        >>> world = World([[0, 0], [10, 0], [10, 10], [0, 10]], [[[4, 2], [6, 2], [6, 9], [4, 9]]])
        >>> Planner(world).batch([[1, 5], [5, 5]], [[9, 5], [9, 5]])
        <BatchResult: 2 answers: 1 invalid, 1 solved>

        Args:
            starts: finite numbers (n, 2), points (x, y).
            goals: likewise.
            goal_tolerance: as of `plan`.
        """
        used = chosen(Params, params, settings)
        starts, goals = unmasked(starts, "starts"), unmasked(goals, "goals")
        with counted(progress, np.asarray(starts).size // 2 * max(seeds, 1)) as tell:
            return batch_result(
                *self._raw.batch(
                    starts, goals, used._raw, threads, seeds, time_limit, target_gap, goal_tolerance, tell
                )
            )

    @property
    def world(self) -> World:
        return self._world

    @property
    def margin(self) -> float:
        """In force."""
        return float(self._raw.margin)

    @property
    def components(self) -> int:
        """Pieces of free space that are not joined."""
        return int(self._raw.components)

    @property
    def free_space(self) -> List[Area]:
        """What the margin leaves of the boundary's inside."""
        return self._raw.free_space()

    @property
    def grown_obstacles(self) -> List[Area]:
        """As grown, merged and clipped."""
        return self._raw.grown_obstacles()

    @property
    def lines(self) -> FloatArray:
        """The free MAKLINK lines, (n, 4): x and y of both ends."""
        return self._raw.lines()[0]

    def free(self, point: Point) -> bool:
        """Is it in free space, its edges included?"""
        return bool(self._raw.free(point))

    def nearest_free(self, point: Point) -> Optional[Point]:
        """The point of free space nearest to one, if there is one."""
        return self._raw.nearest_free(point)
