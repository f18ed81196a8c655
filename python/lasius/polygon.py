"""Planning among polygons. Coordinates are plain planar ones, y up, in any unit.

An area is a ring (an array (n, 2), the first vertex not repeated or repeated), a pair (ring, [hole,
...]), or anything with `__geo_interface__`: shapely's geometries and GeoJSON-like objects, whose lines are walls
of no width.

>>> world = World([[0, 0], [10, 0], [10, 10], [0, 10]], [[[4, 2], [6, 2], [6, 9], [4, 9]]])
>>> result = Planner(world).plan((1, 5), (9, 5))
>>> result.status, round(result.length, 4)
('solved', 10.4853)
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from .arguments import explained
from .arrays import FloatArray, IntArray, Path, Point, file_name, unmasked
from .errors import finish, invalid, made
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


def points_of(points: Any, name: str) -> FloatArray:
    """Points as an array (n, 2); of 3-D coordinates x and y."""
    if isinstance(points, (list, tuple)) and all(isinstance(point, (list, tuple)) for point in points):
        points = [point[:2] for point in points]  # GeoJSON's may have more, each as many as it likes
    array = np.asarray(unmasked(points, name), np.float64)
    if array.ndim != 2 or array.shape[1] < 2:
        raise ValueError(f"{name} of the shape {array.shape}: give (n, 2)")
    return np.ascontiguousarray(array[:, :2])


def ring_of(points: Any) -> Ring:
    """A ring, its first vertex not repeated."""
    ring = points_of(points, "a ring")
    closed = len(ring) > 1 and bool((ring[0] == ring[-1]).all())
    return np.ascontiguousarray(ring[:-1] if closed else ring)


PARTS = {"FeatureCollection": "features", "GeometryCollection": "geometries"}


def geometry_of(source: Any) -> Optional[Dict[str, Any]]:
    """What shapely's geometries and GeoJSON-like objects are as a dictionary; None of all others."""
    if getattr(source, "is_empty", False) is True:  # an empty point of shapely 1.8 cannot say so itself
        return {"type": source.geom_type, PARTS.get(source.geom_type, "coordinates"): ()}
    geometry = source if isinstance(source, dict) else getattr(source, "__geo_interface__", None)
    if geometry is not None and not isinstance(geometry.get("type"), str):
        raise ValueError("a geometry without type: give one of GeoJSON's")
    return geometry


def parts_of(geometry: Dict[str, Any], name: str) -> Iterator[Tuple[str, Any]]:
    """The parts of a GeoJSON object that are not empty, each with its kind: Polygon, LineString, LinearRing, Point."""
    kind = geometry["type"]
    member = PARTS.get(kind, "geometry" if kind == "Feature" else "coordinates")
    content = geometry.get(member)
    if content is None:
        raise invalid(f"{name}: a {kind} without {member}", "give it some, or leave it out")
    if kind == "Feature":
        yield from parts_of(content, name)
    elif kind in PARTS:
        for part in content:
            yield from parts_of(part, name)
    elif kind in ("MultiPolygon", "MultiLineString", "MultiPoint"):
        yield from ((kind[5:], part) for part in content if len(part) > 0)
    elif kind not in ("Polygon", "LineString", "LinearRing", "Point"):
        raise invalid(f"{name}: a geometry of type {kind}", "give one of GeoJSON's")
    elif len(content) > 0:
        yield kind, content


def area_of(rings: Any) -> Area:
    outer, *holes = rings
    return ring_of(outer), [ring_of(hole) for hole in holes]


def shapes_of(source: Any, name: str) -> Iterator[Tuple[str, Any]]:
    """The areas and lines of anything that stands for some, each with its kind, Polygon or LineString."""
    geometry = geometry_of(source)
    if geometry is None:
        pair = isinstance(source, tuple) and len(source) == 2 and np.ndim(source[0]) == 2
        yield "Polygon", area_of((source[0], *source[1])) if pair else (ring_of(source), [])
        return
    for kind, content in parts_of(geometry, name):
        if kind == "Point":
            raise invalid(f"{name}: a point is no obstacle", "give polygons or lines")
        yield ("Polygon", area_of(content)) if kind == "Polygon" else ("LineString", points_of(content, "a line"))


def boundary_of(source: AreaLike) -> Area:
    geometry = geometry_of(source)
    if geometry is None:
        return next(shapes_of(source, "boundary"))[1]
    parts = list(parts_of(geometry, "boundary"))
    kinds = [kind for kind, _ in parts if kind != "Polygon"]
    if len(parts) != 1 or kinds:
        what = f"a {kinds[0]}" if kinds else f"of {len(parts)} areas" if parts else "empty"
        raise invalid(f"boundary is {what}", "give one polygon")
    return area_of(parts[0][1])


def point_of(source: Any, name: str) -> Any:
    """A shapely point as (x, y); all else as it is."""
    geometry = None if source is None else geometry_of(source)
    if geometry is None:
        return source
    parts = list(parts_of(geometry, name))
    if [kind for kind, _ in parts] != ["Point"]:
        what = "empty" if not parts else f"a {geometry['type']}"
        raise invalid(f"{name} is {what}", "give one point")
    return tuple(float(value) for value in parts[0][1][:2])


@explained
class World:
    """A boundary, obstacles in it, perhaps a start and a goal.

    Args:
        boundary: one area; its holes are obstacles.
        obstacles: areas and lines, which may overlap, or one geometry with several. A line is a wall of no
            width: paths may touch it, but not cross it. Empty ones are passed over.
        start: point (x, y), shapely's too, of requests that name none; likewise goal.
        margin: of the robot, a disc: its centre keeps that distance from obstacles and from the boundary.
    Raises:
        InvalidParameter: for rings that cross themselves or have no area, and geometries that cannot be what
            they are given as.
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
        whole = geometry_of(obstacles)
        parts = [whole] if whole is not None else list(obstacles)
        names = ["obstacles"] if whole is not None else [f"obstacles[{i}]" for i in range(len(parts))]
        shapes = [shape for part, name in zip(parts, names) for shape in shapes_of(part, name)]
        areas, walls = ([shape for kind, shape in shapes if kind == k] for k in ("Polygon", "LineString"))
        ends = point_of(start, "start"), point_of(goal, "goal")
        self._raw = _raw.World(boundary_of(boundary), areas, walls, *ends, margin)

    @classmethod
    def _of(cls, raw: Any) -> World:
        world = cls.__new__(cls)
        world._raw = raw
        for note in raw.notes:
            warnings.warn(note, stacklevel=4)
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
    def walls(self) -> List[FloatArray]:
        """Obstacles of no width: lines."""
        return self._raw.walls()

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
        walls = f"{len(self.walls)} walls, " if self.walls else ""
        return f"<World: {len(self.obstacles)} obstacles, {walls}margin {self.margin:g}>"


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
        for wall in world.walls:
            axes.plot(*wall.T, color="#8c8c8c", linewidth=2)
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
            start: point (x, y), shapely's too; None: the world's; likewise goal.
            goal_tolerance: where the goal cannot be reached, the path ends at the point nearest to it that can
                be, at most so far from it; `goal_reached` of the result tells where.
        """
        used = chosen(Params, params, settings)
        start, goal = point_of(start, "start"), point_of(goal, "goal")
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
