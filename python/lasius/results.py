"""Answers: dataclasses of plain values and numpy arrays; pickled, copied and compared like any other."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, Hashable, List, NamedTuple, Optional, Sequence, Tuple, Type, TypeVar

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import Grid, status_names
from .arguments import explained
from .arrays import BoolArray, Cell, End, FloatArray, IntArray, LongArray, same
from .errors import finish
from .parameters import ParameterSet

if TYPE_CHECKING:
    from .maps import Map

T = TypeVar("T")


class Record:
    """A dataclass whose arrays are compared as a whole."""

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        names = [field.name for field in dataclasses.fields(self)]
        return all(same(getattr(self, n), getattr(other, n)) for n in names)

    __hash__ = None  # type: ignore[assignment]


@dataclass(eq=False, repr=False)
class Curves(Record):
    """The course of a search, an entry an iteration; NaN where nothing arrived. Lengths are in cells,
    or the world's unit. What a world does not measure is empty."""

    best: FloatArray  #: shortest final path up to then
    mean: FloatArray  #: mean raw tour of the ants that arrived
    arrived: IntArray  #: ants that reached the goal
    raw_best: FloatArray  #: its shortest raw tour
    cut_mean: FloatArray  #: mean of its tours after `walk_cut`
    cut_best: FloatArray  #: the shortest of them
    iteration_best: FloatArray  #: the shortest path that it offered
    steps: LongArray  #: moves of all ants
    band: FloatArray  #: share of cells on its tours near the straight line, 0 to 1
    trail_entropy: FloatArray  #: how open the trail leaves the choice, 0 to 1

    def __len__(self) -> int:
        return len(self.best)


def curves_of(progress: Any) -> Optional[Curves]:
    """The curves of a search under way, this iteration's entries last; None of `exact`."""
    told = progress._curves
    return None if told is None else Curves(*told)


@dataclass(eq=False, repr=False)
class SearchResult(Record):
    """How a search ended, in any world."""

    status: str  #: "solved", "limit", "interrupted", "unreachable", "no_path" or "invalid"
    limit: str  #: which one ended it: "none", "time" or, of an arm, "questions"
    fault: str  #: why it is invalid, unreachable or trapped: "none", "start_blocked", "disconnected", ...
    error: str  #: the same in a sentence; empty for none
    length: float  #: of the path; NaN without one
    lower_bound: Optional[float]  #: certified: no path is shorter
    gap: Optional[float]  #: certified, (length - lower_bound) / lower_bound, a fraction
    optimal: bool  #: proven shortest
    iterations: int  #: done
    curves: Optional[Curves]  #: None for an algorithm without iterations

    @property
    def found(self) -> bool:
        """True when there is a path."""
        return self.length == self.length

    def _summary(self) -> str:
        words = [self.status]
        if self.found:
            words.append(f"length {self.length:.6g}" + (", optimal" if self.optimal else ""))
        if self.curves is not None:
            words.append(f"{self.iterations} iterations")
        return ", ".join(words + ([self.error] if self.error else []))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._summary()}>"


def answer(kind: Callable[..., T], search: Tuple[Any, ...], *others: Any) -> T:
    """A SearchResult of some kind, of the fields that the extension gives."""
    *told, curves = search
    return kind(*told, None if curves is None else Curves(*curves), *others)


class CurvePiece(NamedTuple):
    """A straight piece of a disc's path, or an arc about a corner of a blocked cell."""

    start: Tuple[float, float]  #: where it begins, x and y as of `Result.path`
    end: Tuple[float, float]  #: and ends
    turn: int  #: 0: straight; 1: an arc that turns from the x axis to the y axis, -1: back
    centre: Optional[Tuple[float, float]]  #: of an arc
    radius: float  #: of an arc: the disc's
    angle: float  #: of an arc, in radians, at most pi / 2


@dataclass(eq=False)
class Alternative(Record):
    """Another way than the shortest one."""

    path: FloatArray  #: as of Result
    length: float  #: in cells


@dataclass(eq=False, repr=False)
class Result(SearchResult):
    """One answer on a bitmap; lengths in cells."""

    path: FloatArray  #: (n, 2), x and y in continuous cell coordinates: (0.5, 0.5) is cell (0, 0)'s centre
    #: of a disc that stands nearer than its radius to what is blocked: where a straight leg leads it first; path,
    #: curve and lengths begin with that, and nothing is certified of the whole (None: no leg is needed)
    way_out: Optional[Tuple[float, float]]
    #: with a goal tolerance: the cell where the path ends, or is to end: at its centre or, for a disc by `exact`, at
    #: the point nearest to the goal, `path[-1]`
    goal_reached: Optional[Cell]
    nearest_free: Optional[Cell]  #: to a start or goal that is blocked or outside
    #: the same, joined to the other end; with a goal tolerance also of a goal in another region
    nearest_reachable: Optional[Cell]
    own_rules: bool  #: rules of your own took part: parameters and seed alone do not give it again
    #: of `exact` for a disc: the path as it is, of which `path` is a polyline that keeps the radius, too,
    #: and is at most a thousandth longer than `length`; else empty
    curve: Tuple[CurvePiece, ...]
    alternatives: Tuple[Alternative, ...]  #: other ways, where they were asked for, in the order of their lengths
    start: End  #: as asked
    goal: End  #: as asked
    params: ParameterSet  #: as asked
    radius: float  #: of the robot, a disc, in cells; 0: a point
    grid: Grid  #: the map; None where it was left out by dataclasses.replace

    def __post_init__(self) -> None:
        self.curve = tuple(CurvePiece(*piece) for piece in self.curve)
        told: Tuple[Any, ...] = self.alternatives
        self.alternatives = tuple(other if isinstance(other, Alternative) else Alternative(*other) for other in told)

    @explained
    def poses(self, spacing: float, *, map: Optional[Map] = None) -> FloatArray:
        """Places along the path with their headings, as robots take them; of a disc's curve on its arcs.

        Args:
            spacing: how far apart they are at most; the path's vertices are among them.
            map: as read_map gave it: where it has a frame, spacing and poses are in metres, y up.
        Returns:
            (n, 3), x, y and yaw in radians, from +x towards +y; (0, 3) without a path.
        """
        frame = None if map is None else map.frame
        height = 0 if map is None else map.grid.height
        apart = spacing if frame is None else spacing / frame.resolution
        return _lasius.poses(self.path, self.curve, apart, frame, height)

    def plot(self, axes: Any = None, *, map: Optional[Map] = None) -> Any:
        """Draws map, path, what the robot's disc sweeps on it and, of a colony, its curves. Needs matplotlib.

        Args:
            axes: matplotlib's, to draw map and path in; None: a new figure.
            map: as read_map gave it: draws in metres where it has a frame, and its unknown cells in a
                tone of their own.
        Returns:
            The axes of the map.
        """
        from . import plots

        return plots.plot_result(self, axes, map)

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The path as a GeoJSON LineString, in cells."""
        return {"type": "LineString", "coordinates": self.path.tolist()}

    def _repr_html_(self) -> str:
        from . import plots

        return plots.html_of_result(self)

    def _repr_png_(self) -> Optional[bytes]:
        from . import plots

        return plots.png_of_result(self)


@dataclass(eq=False, repr=False)
class Way(Result):
    """The way that a robot is to go on, see Navigator."""

    replanned: bool  #: planned in this step; else `path` is what is left of an earlier one that still holds
    walk: IntArray  #: (n, 2), the next cells, the robot's own first; empty without a path
    doubted: int  #: walls taken for free in this step, see `doubt_after`
    cost: float  #: over costs: of the path, from the way out on where there is one; else NaN


@dataclass(eq=False, repr=False)
class BatchResult(Record):
    """The answers of a batch by column, a row for each request and seed, in order."""

    index: LongArray  #: of the request
    seed: npt.NDArray[np.uint64]  #: that it was planned with
    status: npt.NDArray[np.str_]  #: as of Result
    length: FloatArray  #: in cells, or the world's unit; NaN without a path
    lower_bound: FloatArray  #: certified; NaN where nothing is
    optimal: BoolArray  #: proven shortest
    iterations: IntArray  #: done
    elapsed: FloatArray  #: seconds taken by this one
    points: FloatArray  #: (m, 2), the vertices of all paths, one after another
    offsets: LongArray  #: (rows + 1), where each path begins in `points`
    errors: Dict[int, str]  #: sentences by row, of those that are invalid or unreachable

    def __len__(self) -> int:
        return len(self.index)

    def path(self, row: int) -> FloatArray:
        """The path of one row, (n, 2), a view of `points`; empty without a path."""
        row = range(len(self))[row]
        return self.points[self.offsets[row] : self.offsets[row + 1]]

    @property
    def paths(self) -> List[FloatArray]:
        """All of them."""
        return [self.path(row) for row in range(len(self))]

    def __repr__(self) -> str:
        names, counts = np.unique(self.status, return_counts=True)
        parts = ", ".join(f"{count} {name}" for name, count in zip(names, counts))
        return f"<BatchResult: {len(self)} answers: {parts}>"


def batch_result(error: Optional[BaseException], columns: Tuple[Any, ...]) -> BatchResult:
    """What the extension gives of a batch; or raises what was raised meanwhile, which carries it."""
    index, seed, status, length, bound, optimal, *others = columns
    names = np.array(status_names)[status]
    return finish(error, BatchResult(index, seed, names, length, bound, optimal.view(np.bool_), *others))


@dataclass(eq=False)
class RobotTour(Record):
    """What one of several robots does."""

    start: int  #: stop
    order: IntArray  #: its stops, the start first
    legs: range  #: places of its legs among all; empty where it stays
    length: float  #: sum of these, in cells
    cost: float  #: the same over costs; else NaN


@dataclass(eq=False, repr=False)
class TourResult(Record):
    """A tour; lengths in cells."""

    status: str  #: "solved", "limit", "interrupted", "unreachable", "no_path" or "invalid"
    error: str  #: why there is no tour, in a sentence
    order: IntArray  #: stops by their index, of robots one after another; closed: the first not again; empty without a tour
    length: float  #: sum of the legs'; NaN without a tour
    lower_bound: Optional[float]  #: certified: no tour over these stops is shorter, over costs cheaper
    gap: Optional[float]  #: certified, (length - lower_bound) / lower_bound, a fraction; over costs of `cost`
    optimal: bool  #: proven shortest, where lengths are told apart by thousandths of a cell
    left_out: Dict[int, str]  #: stops that no tour visits, each with the reason
    priced: int  #: legs planned to find the order and the bound
    lengths: FloatArray  #: of the legs in order, of a closed tour with the way back
    points: FloatArray  #: (m, 2), the vertices of all legs, one after another
    offsets: LongArray  #: (legs + 1), where each leg begins in `points`
    cost: float  #: over costs, sum of the legs'; else NaN
    costs: FloatArray  #: of the legs, over costs; else empty
    tours: List[RobotTour]  #: of robots, in their order; else empty

    def leg(self, place: int) -> FloatArray:
        """The path of the leg from stop `order[place]`, (n, 2), a view of `points`."""
        place = range(len(self.lengths))[place]
        return self.points[self.offsets[place] : self.offsets[place + 1]]

    @property
    def legs(self) -> List[FloatArray]:
        """All of them."""
        return [self.leg(place) for place in range(len(self.lengths))]

    def __repr__(self) -> str:
        out = f", {len(self.left_out)} left out" if self.left_out else ""
        return f"<TourResult: {self.status}, {len(self.order)} stops{out}, length {self.length:.6g}>"


OfTour = TypeVar("OfTour", bound=TourResult)


def tour_result(kind: Type[OfTour], fields: Tuple[Any, ...]) -> OfTour:
    """A TourResult of some kind, of the fields that the extension gives."""
    found = kind(*fields)
    robots: List[Any] = found.tours
    found.tours = [RobotTour(start, order, range(*legs), *sums) for start, order, legs, *sums in robots]
    return found


def numbered(group: Optional[Sequence[Hashable]]) -> List[int]:
    """Groups of stops as whole numbers, by their first stop; -1: none."""
    known: Dict[Hashable, int] = {}
    return [-1 if name is None else known.setdefault(name, len(known)) for name in ([] if group is None else group)]


@dataclass(eq=False, repr=False)
class CoverResult(TourResult):
    """A tour that covers a map; its stops are the ends of swaths, 2 i and 2 i + 1 those of swath i."""

    stops: FloatArray  #: (n, 2), ends of swaths in cells; where there is a start it is the last
    swaths: int  #: how many
    angle: float  #: what most swaths are parallel to: degrees from +x towards +y, 0 to 180
    swept: float  #: length of all swaths, cells
    covered: float  #: share of what the tool can come to that is within half a width of the tour, 0 to 1
    overlap: float  #: share of what swaths cover that two or more do
    unreachable: float  #: share of the free area that the tool cannot come to
    resolution: float  #: cells from one sample of area to the next

    def __repr__(self) -> str:
        return f"<CoverResult: {self.status}, {self.swaths} swaths, length {self.length:.6g}, {self.covered:.2%} covered>"


@dataclass(eq=False, repr=False)
class Replans(Record):
    """The ways that were planned in a drive, in order."""

    tick: LongArray  #: when
    ms: FloatArray  #: spent on planning in this tick
    length: FloatArray  #: of the way that came of it, in cells; NaN where there is none
    cost: FloatArray  #: of that way, over costs; else NaN

    def __len__(self) -> int:
        return len(self.tick)


@dataclass(eq=False, repr=False)
class DriveResult(Record):
    """How a drive went."""

    status: str  #: "solved" on arrival; else as of Result, "no_path" when trapped
    limit: str  #: which one ended it: "none", "time" or "ticks"
    fault: str  #: why it is invalid, unreachable or trapped
    error: str  #: the same in a sentence; empty for none
    track: IntArray  #: (ticks + 1, 2), where the robot was, the start first
    ticks: int  #: moves and waits
    replans: Replans
    seen: int  #: cells learned to be other than they were known
    length: float  #: travelled, in cells
    planning_ms: float  #: in all ticks
    waits: int  #: ticks in which the robot stood
    deferred_changes: int  #: sum over ticks of cells whose change waits for the robot
    goal_reached: Optional[Cell]  #: with a goal tolerance: where the robot arrived
    cost: float  #: of the moves, each as the robot knew it; without costs their length
    truth: Grid  #: the world in the beginning

    def plot(self, axes: Any = None) -> Any:
        """Draws the world and the robot's track; as Result.plot."""
        from . import plots

        return plots.plot_track(self, axes)

    def __repr__(self) -> str:
        return f"<DriveResult: {self.status}, {self.ticks} ticks, length {self.length:.6g}, {len(self.replans)} replans>"
