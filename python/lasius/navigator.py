"""Planning for a robot that drives, and drives through worlds that change."""

from __future__ import annotations

from typing import Any, Callable, Optional, Tuple, Type, TypeVar

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import DriveTick, Grid
from .arguments import explained
from .arrays import Cell, Path, file_name, flag_of, int_rows
from .costs import CostField, Inflation
from .errors import finish
from .parameters import OptionalParams, Params, chosen
from .results import DriveResult, Replans, Way, answer

Driven = TypeVar("Driven", bound=DriveResult)


@explained
class Navigator:
    """A planner that belongs to a robot: tell it what is seen, ask for the way again and again. An
    observation costs what has changed, not the size of the map.

    >>> navigator = Navigator(lasius.Grid(np.zeros((9, 9), np.uint8), free=0), goal=(8, 4))
    >>> navigator.step((0, 4)).length
    8.0
    >>> navigator.observe([[4, 4]], blocked=True)
    >>> way = navigator.step((1, 4))
    >>> way.replanned, way.walk[0].tolist(), way.length > 7
    (True, [1, 4], True)

    Threads take turns: a call waits for the one before.

    Args:
        grid: what is known of the world.
        goal: cell (x, y).
        params: an algorithm's name or Params; None: `exact`. A colony goes on with its pheromone.
        radius: of the robot, in cells.
        prepare: makes the visibility graph of the map once; after changes its answers are used where they are
                proven to hold still; for `exact` only.
        target_gap: as of Planner.plan.
        search_on: goes on searching in every step; for colonies only.
        goal_tolerance: as of Planner.plan.
        costs: of the cells; then the way is the cheapest that is found at once, see `Way.cost`. For
            `exact` only, without `prepare` and `target_gap`.
        inflation: costs around what is blocked, on top of `costs`; they follow what is observed.
        doubt_after: after so many steps without a way walls count as free that were learned, and not
            observed again in these steps; 0: never.
        **settings: parameters by name.
    """

    __slots__ = ("_raw", "_params", "_radius")

    def __init__(
        self,
        grid: Grid,
        goal: Cell,
        params: OptionalParams = None,
        *,
        radius: float = 0.0,
        prepare: bool = False,
        target_gap: float = 0.0,
        search_on: bool = False,
        goal_tolerance: float = 0.0,
        doubt_after: int = 16,
        costs: Optional[CostField] = None,
        inflation: Optional[Inflation] = None,
        **settings: Any,
    ) -> None:
        self._params, self._radius = chosen(Params, params, settings), radius
        options = _lasius.NavigatorOptions(
            self._params._raw, radius, prepare, target_gap, search_on, goal_tolerance, doubt_after,
            *costs_given(costs, inflation),
        )
        self._raw = _lasius.Navigator(grid, goal, options)

    def observe(self, cells: npt.ArrayLike, blocked: bool) -> None:
        """Each of these cells, integers (n, 2), is blocked or free. What lies outside is ignored."""
        self._raw.observe(int_rows(cells, "cells"), flag_of(blocked, "blocked"))

    def observe_rectangle(self, x: int, y: int, width: int, height: int, blocked: bool) -> None:
        """All cells from (x, y) to (x + width - 1, y + height - 1) are blocked or free."""
        self._raw.observe_rectangle(x, y, width, height, flag_of(blocked, "blocked"))

    def set_costs(self, x: int, y: int, weights: npt.ArrayLike) -> None:
        """The costs of the cells from (x, y) on, (height, width), are others; inflation is added to them."""
        self._raw.set_costs(x, y, np.asarray(weights, dtype=np.float64))

    def step(self, robot: Cell, *, time_limit: Optional[float] = None) -> Way:
        """The way to the goal from where the robot is now. Ctrl-C as of Planner.plan.

        Args:
            robot: its cell (x, y).
            time_limit: seconds.
        """
        error, ((search, *found), *going) = self._raw.step(robot, time_limit)
        grid, goal = self._raw.map(), self._raw.goal()
        way = answer(Way, search, *found, robot, goal, self._params, self._radius, grid, *going)
        return finish(error, way)

    @property
    def goal(self) -> Cell:
        """Where it leads."""
        return self._raw.goal()

    @goal.setter
    def goal(self, goal: Cell) -> None:
        self._raw.set_goal(goal)

    def forget(self) -> None:
        """A colony's trail, and the way kept so far, are forgotten."""
        self._raw.forget()

    @property
    def map(self) -> Grid:
        """What is known now; a copy."""
        return self._raw.map()

    @property
    def passable(self) -> Grid:
        """Where the robot's centre may be: cells whose centres keep its radius; a copy."""
        return self._raw.passable()

    def connected(self, a: Cell, b: Cell) -> bool:
        """True when the robot could get from a to b, as far as is known."""
        return bool(self._raw.connected(a, b))


@explained
class Changes:
    """What happens to a world in a drive.

    >>> changes = Changes()
    >>> changes.add_change(tick=30, x=10, y=0, width=1, height=8, blocked=True)
    >>> changes.add_obstacle(width=2, height=2, speed=0.5, track=[[3, 3], [20, 3]])
    """

    __slots__ = ("_raw",)

    def __init__(self) -> None:
        self._raw = _lasius.Changes()

    def add_change(self, tick: int, x: int, y: int, width: int = 1, height: int = 1, *, blocked: bool) -> None:
        """At the beginning of a tick the cells of a rectangle become blocked or free."""
        self._raw.add_change(tick, x, y, width, height, flag_of(blocked, "blocked"))

    def add_obstacle(
        self, *, width: int, height: int, speed: float, track: npt.ArrayLike, tick: int = 0
    ) -> None:
        """A rectangle that moves along its track to the end and back, for ever.

        Args:
            speed: moves a tick, 0 to 64.
            track: integers (n, 2), its top left cell at each point.
            tick: when it appears.
        """
        self._raw.add_obstacle(tick, width, height, speed, int_rows(track, "track"))

    @classmethod
    def read(cls, path: Path, grid: Grid) -> Changes:
        """From a file as `lasius drive --changes` takes it, see docs/driving.md.

        Raises:
            FileMissing, FileBroken: as of read_map.
        """
        changes = cls()
        changes._raw = _lasius.read_changes(file_name(path), grid.width, grid.height)
        return changes


@explained
def drive(
    grid: Grid,
    truth: Grid,
    start: Cell,
    goal: Cell,
    params: OptionalParams = None,
    *,
    changes: Optional[Changes] = None,
    sense: float = 20.0,
    max_ticks: int = 1_000_000,
    seconds_per_tick: Optional[float] = None,
    time_limit: Optional[float] = None,
    radius: float = 0.0,
    prepare: bool = False,
    target_gap: float = 0.0,
    search_on: bool = False,
    goal_tolerance: float = 0.0,
    costs: Optional[CostField] = None,
    inflation: Optional[Inflation] = None,
    observer: Optional[Callable[[DriveTick], Any]] = None,
    **settings: Any,
) -> DriveResult:
    """Drives a robot through a world that is not as its map has it, a move to a neighbour a tick.

    >>> grid = lasius.Grid(np.zeros((20, 20), np.uint8), free=0)
    >>> truth = np.zeros((20, 20), np.uint8)
    >>> truth[:15, 10] = 1
    >>> run = drive(grid, lasius.Grid(truth, free=0), (2, 2), (18, 2), sense=5)
    >>> run.status, run.track[-1].tolist(), run.seen > 0
    ('solved', [18, 2], True)

    Args:
        grid: what the robot knows in the beginning.
        truth: what is there, of the same size.
        params: as of Navigator, as `radius`, `prepare`, `target_gap`, `search_on`, `goal_tolerance`, `costs`,
            `inflation` and settings.
        changes: what happens meanwhile.
        sense: how far it sees, in cells.
        max_ticks: then it ends with the status "limit", its `limit` "ticks".
        seconds_per_tick: time for planning in a tick; None: any.
        time_limit: seconds for all.
        observer: called with a DriveTick at each tick; its stop() ends the drive there.
    """
    used = chosen(Params, params, settings)
    weighed = costs_given(costs, inflation)
    options = _lasius.NavigatorOptions(
        used._raw, radius, prepare, target_gap, search_on, goal_tolerance, 0, *weighed
    )
    happening = (changes if changes is not None else Changes())._raw
    error, fields = _lasius.drive(
        grid, truth, start, goal, happening, options, sense, max_ticks, seconds_per_tick, time_limit, observer
    )
    return finish(error, drive_result(DriveResult, fields, truth))


def costs_given(costs: Optional[CostField], inflation: Optional[Inflation]) -> Tuple[Any, ...]:
    """What the extension takes."""
    return None if costs is None else costs._raw, None if inflation is None else Inflation(*inflation)


def drive_result(kind: Type[Driven], fields: Tuple[Any, ...], truth: Grid, *others: Any) -> Driven:
    """A DriveResult of some kind, of what the extension gives."""
    values = [*fields, truth, *others]
    values[6] = Replans(*values[6])
    return kind(*values)
