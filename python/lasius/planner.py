"""Planning on a bitmap."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Dict, Hashable, List, Mapping, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import Grid, Progress, Workspace
from .arguments import explained
from .arrays import Cell, End, IntArray, cells_or_points, flags_of, int_rows
from .errors import finish, invalid, made
from .maps import Map
from .parameters import OptionalParams, Params, chosen, text_of, whole
from .progress import Shown, counted, watched
from .results import BatchResult, CoverResult, Result, TourResult, answer, batch_result, numbered, tour_result
from .rules import Heuristic, OwnRules, Schedule, Update, named, own_rules
from .vehicle import Stops, Vehicle, VehiclePlanner, VehicleTourResult

if TYPE_CHECKING:
    from .costs import CostField, CostPlanner, Inflation

Observer = Callable[[Progress], Any]


class Preparation:
    """What came of a map's visibility graph, and of hub labels of its vertices."""

    def __init__(
        self,
        state: str,
        vertices: int,
        edges: int,
        bytes: int,
        seconds: float,
        labels: str = "none",
        label_entries: int = 0,
        label_bytes: int = 0,
        label_seconds: float = 0.0,
    ) -> None:
        self.state = state  #: "none", "ready", "too_large" or "stopped"
        self.vertices = vertices  #: corners at which a path may bend
        self.edges = edges  #: from vertex to vertex in sight
        self.bytes = bytes  #: held
        self.seconds = seconds  #: spent
        self.labels = labels  #: as state
        self.label_entries = label_entries  #: hubs that vertices know
        self.label_bytes = label_bytes  #: held
        self.label_seconds = label_seconds  #: spent on labels

    def __repr__(self) -> str:
        return f"<Preparation: {self.state}, {self.vertices} vertices, {self.edges} edges, {self.bytes} bytes>"


@explained
class Planner:
    """A map made ready for planning. It never changes: use one from many threads.

    >>> grid = lasius.generate("blobs", width=400, height=200, seed=61)
    >>> planner = Planner(grid)
    >>> result = planner.plan((14, 14), (380, 179))
    >>> result.status, result.optimal, result.path.shape[1]
    ('solved', True, 2)

    Args:
        grid: the map.
        radius: of the robot, a disc, in cells: its centre keeps that distance from every blocked cell and
            from the outside. `exact` plans its curve, for radii of 0.05 to 54, and all doors are open that it
            passes; the other algorithms plan on `passable` cells, and keep the radius, too. 0: a point.
        prepare: also makes the visibility graph, so that `exact` answers faster; "labels": and hub labels of its
            vertices, of which answers are read; see `prepared`.
        threads: to prepare with, to 1024; 0: as many as OpenMP gives.
        max_bytes: a visibility graph that would take more is abandoned.
    """

    __slots__ = ("_raw", "_grid")

    def __init__(self, grid: Grid, *, radius: float = 0.0, prepare: Union[bool, str] = False, threads: int = 0, max_bytes: int = 1 << 30) -> None:
        if not isinstance(grid, Grid):
            remedy = "give its .grid" if isinstance(grid, Map) else "make one by lasius.Grid(array, free=...)"
            raise TypeError(f"grid is a {type(grid).__name__}: {remedy}")
        threads = whole("threads", threads)
        self._grid = grid
        self._raw = made(*_lasius.make_planner(grid, radius))
        if prepare not in (False, True, "graph", "labels"):
            raise invalid(f"prepare is {prepare!r}", 'it must be False, True, "graph" or "labels"')
        if prepare:
            self._raw = made(*self._raw.prepared(threads, max_bytes, prepare == "labels"))

    @classmethod
    def _of(cls, raw: Any) -> Planner:
        planner = cls.__new__(cls)
        planner._raw, planner._grid = raw, raw.grid
        return planner

    @property
    def grid(self) -> Grid:
        """The map."""
        return self._grid

    @property
    def radius(self) -> float:
        """Of the robot, in cells."""
        return float(self._raw.radius)

    @property
    def passable(self) -> Grid:
        """The cells that colonies plan on, which are free all over for the robot: `grow_obstacles(grid, radius)`."""
        return self._raw.passable

    def clear(self, cell: Cell) -> bool:
        """True when the robot's centre may be at the centre of a cell: `exact` plans from there."""
        return bool(self._raw.clear(cell))

    def widest_disc(self, a: Cell, b: Cell) -> Optional[float]:
        """The largest radius, at most 54, with which a disc can go from one cell to another; None: none can.

        >>> planner = Planner(lasius.Grid(np.zeros((3, 9), np.uint8), free=0))
        >>> planner.widest_disc((1, 1), (7, 1))
        1.5
        """
        return finish(*self._raw.widest_disc(a, b))

    def plan(
        self,
        start: End,
        goal: End,
        params: OptionalParams = None,
        *,
        time_limit: Optional[float] = None,
        target_gap: float = 0.0,
        goal_tolerance: float = 0.0,
        via: Sequence[End] = (),
        alternatives: int = 0,
        observer: Optional[Observer] = None,
        progress: Shown = None,
        workspace: Optional[Workspace] = None,
        update: Union[None, str, Update] = None,
        heuristic: Optional[Heuristic] = None,
        schedule: Optional[Schedule] = None,
        **settings: Any,
    ) -> Result:
        """Answers one question. The same input gives the same path bit for bit, with any number of threads.

        Other Python threads run meanwhile. Ctrl-C ends the search, and raises a KeyboardInterrupt whose
        `result` is the best so far; so does an exception of the observer.

        >>> planner = Planner(lasius.generate("blobs", width=400, height=200, seed=61))
        >>> planner.plan((14, 14), (380, 179), "fan2004", iterations=20, seed=3).status
        'solved'
        >>> [round(other.length) for other in planner.plan((14, 14), (380, 179), alternatives=2).alternatives]
        [447, 457]
        >>> planner.plan((14, 14), (9999, 0)).error
        'goal (9999, 0) is outside the map; the nearest free cell that can be reached from the start is (399, 9); (399, 0) is nearer, but cannot be reached'

        Args:
            start: cell (x, y), two integers, column and row from the top left: the path begins at its centre. Where
                one of the numbers is no integer, a point in continuous cell coordinates: it begins there.
            goal: likewise, where it ends.
            params: an algorithm's name or Params; None: `exact`.
            time_limit: seconds; then the answer is the best so far, with the status "limit".
            target_gap: `exact` stops at this certified gap, a fraction.
            goal_tolerance: where the goal cannot be reached, the path ends at the cell nearest to it that
                can be, at most so many cells away: `goal_reached`.
            via: cells or points that the path goes through on its way, in this order; the error of one that
                cannot be reached names it.
            alternatives: of `exact` for a point: so many other ways at most, to 100, that differ from the shortest
                one: `alternatives`, each taut, at most 1.3 times as long, and at most 70% of it near others.
            observer: called with a Progress once an iteration, of `exact` with every shorter path;
                `progress.stop()` ends the search.
            progress: True shows a bar in a terminal or notebook; or called with (done, all, text).
            workspace: scratch memory to use again.
            update: a colony's parameter; or your own update, called with (trail, tours), a Pheromone and
                IterationTours, once an iteration. Arrays of `tours` are read-only views.
            heuristic: a colony's parameter; or your own values, (height, width) by the cell that a move
                leads to, or (height, width, moves) by the move. The larger the better.
            schedule: your own: called with the iteration, it returns a dict of what differs from the
                parameters of alpha, beta, greedy, pheromone_rule, distance_rule, combined_rule.
            **settings: parameters by name, as of Params.
        Raises:
            InvalidParameter: for parameters out of range. A start or goal that is blocked or outside
                is an answer, with the status "invalid".
        """
        used, own = self._asked(params, settings, heuristic, update, schedule)
        with watched(observer, progress, used) as watch:
            error, (search, *found) = self._raw.plan(
                start, goal, used._raw, target_gap, goal_tolerance, time_limit, workspace, watch, *own, tuple(via),
                alternatives,
            )
        result = answer(Result, search, *found, start, goal, used, self.radius, self._grid)
        return result if error is None else finish(error, result)

    def batch(
        self,
        starts: npt.ArrayLike,
        goals: npt.ArrayLike,
        params: OptionalParams = None,
        *,
        threads: int = 0,
        seeds: int = 1,
        time_limit: Optional[float] = None,
        target_gap: float = 0.0,
        goal_tolerance: float = 0.0,
        progress: Shown = None,
        update: Union[None, str, Update] = None,
        heuristic: Optional[Heuristic] = None,
        schedule: Optional[Schedule] = None,
        **settings: Any,
    ) -> BatchResult:
        """Answers many questions side by side, each as `plan` does on one thread.

        >>> planner = Planner(lasius.generate("maze", width=100, height=100, seed=2))
        >>> answers = planner.batch([[1, 1], [1, 1]], [[90, 90], [1, 90]])
        >>> len(answers), answers.path(1).shape[1]
        (2, 2)

        Args:
            starts: integers (n, 2), cells (x, y).
            goals: likewise.
            params: as of `plan`.
            threads: to 1024; 0: as many as OpenMP gives; never changes an answer.
            seeds: each request is answered with `seed` and the seeds after it, as many as this.
            time_limit: seconds for each request.
            target_gap: as of `plan`.
            goal_tolerance: as of `plan`; a row's path tells where it ends.
            progress: True shows a bar; or called with (done, all, text), some times a second, on
                the thread that plans.
            update, heuristic, schedule: as of `plan`. Functions of yours are called from the threads
                of the batch, for a plan each, one at a time under the interpreter's lock.
            **settings: parameters by name.
        Raises:
            KeyboardInterrupt: with Ctrl-C; its `result` holds the answers so far, the last of them
                cut short.
        """
        used, own = self._asked(params, settings, heuristic, update, schedule)
        start_cells, goal_cells = int_rows(starts, "starts"), int_rows(goals, "goals")
        with counted(progress, len(start_cells) * max(seeds, 1)) as tell:
            columns = _lasius.batch(
                self._raw, start_cells, goal_cells, used._raw, threads, seeds, time_limit, target_gap,
                goal_tolerance, tell, *own,
            )
        return batch_result(*columns)

    def tour(
        self,
        stops: npt.ArrayLike,
        *,
        open: bool = False,
        start: Optional[int] = None,
        goal: Optional[int] = None,
        after: Optional[Mapping[int, Sequence[int]]] = None,
        load: Optional[Sequence[int]] = None,
        capacity: Optional[int] = None,
        group: Optional[Sequence[Hashable]] = None,
        robots: Optional[Sequence[int]] = None,
        most_stops: int = 0,
        costs: Union[None, CostField, CostPlanner, npt.ArrayLike] = None,
        inflation: Optional[Inflation] = None,
        algorithm: str = "exact",
        settings: Optional[Mapping[str, Any]] = None,
        seed: int = 1,
        generations: int = 20,
        target_gap: float = 0.0,
        threads: int = 0,
        time_limit: Optional[float] = None,
        observer: Optional[Callable[[IntArray, float], Any]] = None,
    ) -> TourResult:
        """Visits all stops by shortest paths, in a short order, with a bound that no order is below.

        >>> planner = Planner(lasius.Grid(np.zeros((20, 30), np.uint8), free=0))
        >>> run = planner.tour([[2, 2], [14, 7], [14, 2], [2, 7]], start=0)
        >>> run.order.tolist() in ([0, 2, 1, 3], [0, 3, 1, 2]), run.length, run.optimal
        (True, 34.0, True)
        >>> planner.tour([[2, 2], [14, 7], [14, 2], [2, 7]], start=0, after={2: [1], 3: [2]}).order.tolist()
        [0, 1, 2, 3]
        >>> planner.tour([[2.25, 2.0], [14.5, 2.0]], open=True).length
        12.25
        >>> planner.tour([[2, 2], [14, 7], [14, 2], [2, 7]], group=["a", "b", "b", None]).length
        30.0
        >>> [robot.order.tolist() for robot in planner.tour([[2, 2], [14, 7], [13, 7], [2, 3]], robots=[0, 1]).tours]
        [[0, 3], [1, 2]]

        Args:
            stops: integers (n, 2), cells (x, y), or floats, points as (12.5, 5.5), the centre of cell (12, 5). Those that
                are outside, blocked, or not joined to the start (without one: to most stops) are left out.
            open: no way back to the first stop.
            start: index of the first stop; None: any.
            goal: of the last one, of an open tour; None: any.
            after: by stop, the stops that come before it; a circle is refused.
            load: what each stop adds to what is carried, whole numbers, n of them.
            capacity: the most that is carried behind any stop; None: any load.
            group: what each stop's group is called, n of them; of a group one stop is visited. None: no group.
            robots: stops where robots begin, one each, in place of `start`: the sum of their tours is short.
            most_stops: that a robot visits, its start aside; 0: any.
            costs: for legs and an order of least cost: weights (height, width), a CostField or a CostPlanner of this map.
            inflation: costs near what is blocked, as Nav2's (radius, scaling[, weight[, inscribed]]), on top of `costs`.
            algorithm: "exact", or "as", "eas", "ras", "mmas", "acs": ants, in their native problem.
            settings: the ants' parameters by name, as {"ants": 10, "local_search": "two-edges"}.
            seed: of the search, above 12 stops; up to that the order is a shortest.
            generations: of tours that recombine, above 12 stops; 0: local search and its kicks alone.
            target_gap: ends the search at this certified gap, a fraction.
            threads: to 1024; 0: as many as OpenMP gives; never changes a tour.
            time_limit: seconds; then the best so far is the answer, its status "limit".
            observer: called with each better order and its length; where it returns False, the search ends.
        Raises:
            KeyboardInterrupt: with Ctrl-C; its `result` holds the answer so far.
        """
        cells, points = cells_or_points(stops, "stops")
        before: List[List[int]] = [[] for _ in range(len(cells) + len(points))] if after else []
        for stop, earlier in (after or {}).items():
            if not 0 <= stop < len(before):
                raise invalid(f"after: there is no stop {stop}", f"give indices of stops, 0 to {len(before) - 1}")
            before[stop] = list(earlier)
        over = self._over(costs, inflation)
        error, fields = _lasius.tour(
            self._raw if over is None else over, cells, points, [], open, start, goal, before,
            [] if load is None else list(load), capacity, numbered(group), [] if robots is None else list(robots),
            most_stops, algorithm, [(name, text_of(value)) for name, value in (settings or {}).items()],
            whole("seed", seed), generations, target_gap, whole("threads", threads), time_limit, observer,
        )
        return finish(error, tour_result(TourResult, fields))

    def _over(
        self, costs: Union[None, CostField, CostPlanner, npt.ArrayLike], inflation: Optional[Inflation]
    ) -> Optional[_lasius.CostPlanner]:
        """The planner over costs, if there are any."""
        from .costs import CostField, CostPlanner, Inflation

        if costs is None and inflation is None:
            return None
        if isinstance(costs, CostPlanner):
            if inflation is not None:
                raise invalid("inflation is given with a CostPlanner, which has its costs", "give a CostField")
            if costs.planner.grid != self.grid or costs.planner.radius != self.radius:
                raise invalid("the CostPlanner is of another map or radius", "give one of this planner's")
            return costs._raw
        if inflation is not None:
            given = CostField(self.grid) if costs is None else CostField.of(
                costs.weights if isinstance(costs, CostField) else costs)
            radius, scaling, weight, inscribed = Inflation(*inflation)
            given.inflate(self.grid, radius, scaling, weight=weight, inscribed=inscribed)
            costs = given
        assert costs is not None
        return CostPlanner(self, costs)._raw

    def cover(
        self,
        width: float,
        *,
        open: bool = False,
        start: Optional[Tuple[float, float]] = None,
        seed: int = 1,
        generations: int = 20,
        threads: int = 0,
        time_limit: Optional[float] = None,
        observer: Optional[Callable[[IntArray, float], Any]] = None,
    ) -> CoverResult:
        """Covers the map with a tool that works on `width` cells, by swaths in a short order.

        >>> planner = Planner(lasius.Grid(np.zeros((20, 30), np.uint8), free=0))
        >>> planner.cover(2, open=True)
        <CoverResult: solved, 10 swaths, length 318, 100.00% covered>

        Args:
            width: cells, more than 0, at most the map's longer side. The planner's radius is that of the tool's body.
            open: no way back to where the tour began.
            start: where it begins, a point (12.5, 5.5), the centre of cell (12, 5); None: anywhere.
            seed: of the search for the order, above 6 swaths.
            generations: of tours that recombine; 0: local search and its kicks alone.
            threads: to 1024; 0: as many as OpenMP gives; never changes a tour.
            time_limit: seconds; then the best so far is the answer, its status "limit".
            observer: called with each better order and its length; where it returns False, the search ends.
        Raises:
            InvalidParameter: for a width out of range, or that asks for more than 10 000 swaths.
            KeyboardInterrupt: with Ctrl-C; its `result` holds the answer so far.
        """
        begin = None if start is None else (float(start[0]), float(start[1]))
        error, tour, fields = _lasius.cover(
            self._raw, width, open, begin, whole("seed", seed), generations, whole("threads", threads), time_limit, observer
        )
        return finish(error, CoverResult(*tour, *fields))

    def _asked(
        self,
        params: OptionalParams,
        settings: Dict[str, Any],
        heuristic: Optional[Heuristic],
        update: Union[None, str, Update],
        schedule: Optional[Schedule],
    ) -> Tuple[Params, OwnRules]:
        """The parameters of a call, and what of a colony is the caller's own."""
        if "radius" in settings:
            raise invalid("radius is the planner's, not a plan's", "make a Planner(grid, radius=...)")
        own = own_rules(heuristic, update, schedule, self._grid)
        told = named(settings, update, heuristic)
        return chosen(Params, params, told, own=any(rule is not None for rule in own)), own

    def prepared(self, *, threads: int = 0, max_bytes: int = 1 << 30, labels: bool = False) -> Planner:
        """A planner for the same map with its visibility graph, in which `exact` answers faster.

        Args:
            labels: give vertices hub labels as well: answers of a point take some microseconds. Where labels
                would take too much, as in noise, the graph alone is used.
        """
        planner = Planner._of(made(*self._raw.prepared(threads, max_bytes, labels)))
        planner._grid = self._grid
        return planner

    def limit_own_graph(self, max_bytes: int) -> None:
        """Limits the visibility graph that `exact` makes for itself once so many plans were asked for that it pays, where
        nothing is prepared: 128 MiB unless told; 0: none is made. No answer depends on it.
        """
        self._raw.limit_own_graph(whole("max_bytes", max_bytes))

    def save_preparation(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes visibility graph and labels to a file, for `load_preparation` of the same map."""
        self._raw.save_preparation(os.fspath(file))

    def load_preparation(self, file: Union[str, "os.PathLike[str]"]) -> Planner:
        """A planner for the same map with what such a file holds; refused where it is of another map or damaged."""
        planner = Planner._of(made(*self._raw.load_preparation(os.fspath(file))))
        planner._grid = self._grid
        return planner

    def edited(self, cells: npt.ArrayLike, blocked: Union[bool, npt.ArrayLike]) -> Planner:
        """A planner for the map with some cells changed; this one stays as it is, the new one is not prepared.

        >>> planner = Planner(lasius.Grid(np.zeros((3, 3), np.uint8), free=0))
        >>> planner.edited([[1, 0], [1, 1], [1, 2]], blocked=True).connected((0, 0), (2, 0))
        False

        Args:
            cells: integers (n, 2), cells (x, y) of the map.
            blocked: what they become: one bool, or one for each.
        """
        rows = int_rows(cells, "cells")
        flags = np.ascontiguousarray(np.broadcast_to(flags_of(blocked, "blocked"), len(rows)))
        return Planner._of(made(*self._raw.edited(rows, flags)))

    def exclude(self, directions: npt.ArrayLike) -> Planner:
        """A planner whose paths keep out of directions in which a sensor reports an obstacle.

        Args:
            directions: integers (n, 4), x, y, dx, dy: out of cell (x, y) to one of its neighbours.
        """
        return Planner._of(made(*self._raw.exclude(directions_of(directions))))

    def allow(self, directions: npt.ArrayLike) -> Planner:
        """The same without these: the sensor has stopped reporting them."""
        return Planner._of(made(*self._raw.allow(directions_of(directions))))

    @property
    def excluded(self) -> IntArray:
        """What is excluded now, (n, 4)."""
        return np.asarray(self._raw.excluded())

    def connected(self, a: Cell, b: Cell, corners: str = "forbid") -> bool:
        """True when a path leads from a to b, by the rule of corners: "forbid", "one-side", "allow"."""
        return bool(self._raw.connected(a, b, corners))

    def nearest_free(self, cell: Cell) -> Optional[Cell]:
        """The free cell nearest to one, if there is any."""
        return self._raw.nearest_free(cell)

    def components(self, corners: str = "forbid") -> int:
        """Pieces of free space."""
        return int(self._raw.components(corners))

    @property
    def preparation(self) -> Preparation:
        """What came of the visibility graph."""
        return Preparation(*self._raw.preparation())

    @property
    def footprint(self) -> Tuple[int, int, int]:
        """Bytes held by the bitmap, its components and the visibility graph."""
        return self._raw.footprint()

    def __reduce__(self) -> Tuple[Any, ...]:
        excluded = self.excluded  # what they block counts as blocked in the planner's map
        grid = self.allow(excluded).grid if len(excluded) else self._grid
        return (restored, (grid, self._how_prepared, excluded, self.radius))

    @property
    def _how_prepared(self) -> Union[bool, str]:
        """As `prepare` of the constructor."""
        return "labels" if self.preparation.labels == "ready" else self.preparation.state == "ready"

    def __repr__(self) -> str:
        radius = f", radius={self.radius:g}" if self.radius else ""
        return f"Planner({self._grid!r}{radius}{f', prepare={self._how_prepared!r}' if self._how_prepared else ''})"


def restored(grid: Grid, prepare: Union[bool, str], excluded: IntArray, radius: float = 0.0) -> Planner:
    """A planner that was pickled: its map is labelled and prepared anew."""
    planner = Planner(grid, radius=radius)
    if len(excluded):
        planner = planner.exclude(excluded)
    return planner.prepared(labels=prepare == "labels") if prepare else planner


def directions_of(rows: npt.ArrayLike) -> IntArray:
    return int_rows(rows, "directions")


@explained
def plan(
    grid: Grid, start: End, goal: End, params: OptionalParams = None, *, radius: float = 0.0, **options: Any
) -> Result:
    """Answers one question on a map. For more than one make a Planner, whose `plan` this is.

    >>> grid = lasius.Grid(np.zeros((20, 30), np.uint8), free=0)
    >>> plan(grid, (0, 0), (29, 0)).length
    29.0
    >>> plan(grid, (2, 2), (27, 2), radius=2.5).length
    25.0
    """
    return Planner(grid, radius=radius).plan(start, goal, params, **options)


@overload
def tour(
    grid: Grid, stops: npt.ArrayLike, *, radius: float = ..., vehicle: None = ..., **options: Any
) -> TourResult: ...
@overload
def tour(grid: Grid, stops: Stops, *, vehicle: Vehicle, **options: Any) -> VehicleTourResult: ...
def tour(
    grid: Grid, stops: Any, *, radius: float = 0.0, vehicle: Optional[Vehicle] = None, **options: Any
) -> TourResult:
    """Orders many stops on a map, as `Planner.tour`; of a vehicle as `VehiclePlanner.tour`, over a CostField `costs` too.

    >>> grid = lasius.Grid(np.zeros((20, 30), np.uint8), free=0)
    >>> tour(grid, [[0, 0], [20, 0], [10, 0]], open=True).length
    20.0
    >>> robot = lasius.Vehicle.differential(lasius.Vehicle.rectangle(1, 1, 1))
    >>> tour(grid, [[5, 5, 0], [25, 5, None], [15, 5, 0]], vehicle=robot, open=True, start=0).order.tolist()
    [0, 2, 1]
    """
    if vehicle is None:
        return Planner(grid, radius=radius).tour(stops, **options)
    if radius != 0:
        raise invalid("radius is of a disc", "a vehicle has a footprint: leave it out")
    return VehiclePlanner(grid, vehicle, options.pop("costs", None)).tour(stops, **options)
