"""Planning for a vehicle that drives, and what its sensors see as cells."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import DriveTick, Grid, WorldFrame
from .arguments import explained
from .arrays import FloatArray, flag_of, int_rows
from .errors import finish
from .navigator import Changes, costs_given, drive_result
from .parameters import whole
from .results import DriveResult
from .vehicle import Pose, Vehicle, VehicleResult, vehicle_values

if TYPE_CHECKING:
    from .costs import CostField, Inflation


@dataclass(eq=False, repr=False)
class VehicleWay(VehicleResult):
    """What is left of a vehicle's way from where it is."""

    replanned: bool  #: planned in this step; else what is left of an earlier plan
    way_out: int  #: so many of the first segments lead out of what it meets where it stands
    rejoined: int  #: so many of the first segments lead from beside the way back to it
    doubted: int  #: so many walls were taken for free in this step


@explained
class VehicleNavigator:
    """A planner that belongs to a vehicle: tell it what is seen, ask for the way again and again. The way is kept as
    long as its sweep meets no wall that was learned, and no wall that has gone could make it shorter.

    >>> grid = lasius.Grid(np.zeros((60, 80), np.uint8), free=0)
    >>> car = lasius.Vehicle.car(lasius.Vehicle.rectangle(1, 3, 1), 4.0)
    >>> navigator = VehicleNavigator(grid, car, goal=(70, 30, 0))
    >>> navigator.step((5, 30, 0)).length
    65.0
    >>> navigator.step((25, 30, 0)).replanned
    False
    >>> navigator.observe([[40, 30]], blocked=True)
    >>> way = navigator.step((25, 30, 0))
    >>> way.replanned, way.length > 45
    (True, True)

    Threads take turns: a call waits for the one before.

    Args:
        grid: what is known of the world.
        vehicle: as of VehiclePlanner.
        goal: x, y, yaw, or several, (n, 3), of which one is met.
        goal_tolerance: as of VehiclePlanner.plan, as `heading_tolerance`, `weight` and `smooth`.
        max_states: of the lattice, 1 to 100 million, in one plan.
        doubt_after: after so many steps without a way walls count as free that were learned, and not
            observed again in these steps; 0: never.
        costs: of the cells; then ways are the cheapest that are found, see `VehicleWay.cost`.
        inflation: costs around what is blocked, on top of `costs`; they follow what is observed.
    """

    __slots__ = ("_raw",)

    def __init__(
        self,
        grid: Grid,
        vehicle: Vehicle,
        goal: npt.ArrayLike,
        *,
        goal_tolerance: float = 0.0,
        heading_tolerance: float = 0.0,
        weight: float = 1.5,
        smooth: bool = True,
        max_states: int = 20_000_000,
        doubt_after: int = 16,
        costs: Optional[CostField] = None,
        inflation: Optional[Inflation] = None,
    ) -> None:
        options = _lasius.VehicleNavigatorOptions(
            goal_tolerance, heading_tolerance, weight, smooth, max_states, doubt_after, *costs_given(costs, inflation)
        )
        self._raw = _lasius.VehicleNavigator(grid, vehicle_values(vehicle), goal_rows(goal), options)

    def observe(self, cells: npt.ArrayLike, blocked: bool) -> None:
        """Each of these cells, integers (n, 2), is blocked or free. What lies outside is ignored."""
        self._raw.observe(int_rows(cells, "cells"), flag_of(blocked, "blocked"))

    def observe_rectangle(self, x: int, y: int, width: int, height: int, blocked: bool) -> None:
        """All cells from (x, y) to (x + width - 1, y + height - 1) are blocked or free."""
        self._raw.observe_rectangle(x, y, width, height, flag_of(blocked, "blocked"))

    def set_costs(self, costs: CostField) -> None:
        """In place of the former costs: from the next step on the cheapest way over these is looked for; the one that is
        kept stays where none is. Inflation is added to them."""
        self._raw.set_costs(costs._raw)

    def step(self, robot: Pose, *, time_limit: Optional[float] = None) -> VehicleWay:
        """The way from where the vehicle is. Ctrl-C as of VehiclePlanner.plan.

        Args:
            robot: x, y, yaw in cells and radians.
            time_limit: seconds.
        """
        error, (found, *going) = self._raw.step(tuple(robot), time_limit)
        return finish(error, VehicleWay(*found, *going))

    def set_goal(self, goal: npt.ArrayLike) -> None:
        """Another goal, or several; the way is planned anew."""
        self._raw.set_goals(goal_rows(goal))

    def forget(self) -> None:
        """The way kept so far is planned anew."""
        self._raw.forget()

    @property
    def map(self) -> Grid:
        """What is known now; a copy."""
        return self._raw.map()


@dataclass(eq=False, repr=False)
class VehicleDriveResult(DriveResult):
    """How a vehicle's drive went; its track has the cells of the reference point."""

    poses: FloatArray  #: (ticks + 1, 3), x, y, yaw, the start first
    moves: FloatArray  #: (m, 8), of each tick in which it moved, as VehicleResult.segments


@explained
def drive_vehicle(
    grid: Grid,
    truth: Grid,
    vehicle: Vehicle,
    start: Pose,
    goal: npt.ArrayLike,
    *,
    changes: Optional[Changes] = None,
    sense: float = 20.0,
    max_ticks: int = 1_000_000,
    seconds_per_tick: Optional[float] = None,
    time_limit: Optional[float] = None,
    goal_tolerance: float = 0.0,
    heading_tolerance: float = 0.0,
    weight: float = 1.5,
    smooth: bool = True,
    max_states: int = 20_000_000,
    costs: Optional[CostField] = None,
    inflation: Optional[Inflation] = None,
    seed: int = 1,
    observer: Optional[Callable[[DriveTick], Any]] = None,
) -> VehicleDriveResult:
    """Drives a vehicle through a world that is not as its map has it, at most a cell a tick, by motions that meet nothing
    in the world as it is then.

    >>> grid = lasius.Grid(np.zeros((30, 40), np.uint8), free=0)
    >>> truth = np.zeros((30, 40), np.uint8)
    >>> truth[:20, 20] = 1
    >>> robot = lasius.Vehicle.differential(lasius.Vehicle.rectangle(1, 1, 1))
    >>> run = drive_vehicle(grid, lasius.Grid(truth, free=0), robot, (5, 5, 0), (35, 5, 0), sense=8)
    >>> run.status, run.poses[-1, :2].round(6).tolist(), run.seen > 0
    ('solved', [35.0, 5.0], True)

    Args:
        grid: what is known in the beginning.
        truth: what is there, of the same size.
        vehicle: as of VehiclePlanner.
        start: x, y, yaw in cells and radians.
        goal: likewise; or several, (n, 3), of which one is met.
        changes: as of drive, as `sense`, `max_ticks`, `seconds_per_tick`, `time_limit` and `observer`.
        goal_tolerance: as of VehicleNavigator, as `heading_tolerance`, `weight`, `smooth`, `max_states`, `costs` and
            `inflation`.
        seed: draws the motions by which it makes room for moving obstacles.
    """
    happening = (changes if changes is not None else Changes())._raw
    options = _lasius.VehicleNavigatorOptions(
        goal_tolerance, heading_tolerance, weight, smooth, max_states, 0, *costs_given(costs, inflation)
    )
    error, fields, poses, moves = _lasius.drive_vehicle(
        grid, truth, vehicle_values(vehicle), tuple(start), goal_rows(goal), happening, options, sense, max_ticks,
        seconds_per_tick, whole("seed", seed), time_limit, observer,
    )
    return finish(error, drive_result(VehicleDriveResult, fields, truth, poses, moves))


def goal_rows(goal: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """A pose or several as rows."""
    return np.atleast_2d(np.asarray(goal, dtype=np.float64))


@explained
def cells_of_scan(
    sensor: Pose,
    ranges: npt.ArrayLike,
    first_angle: float,
    step: float,
    most: float,
    frame: WorldFrame,
    grid: Grid,
    *,
    least: float = 0.0,
) -> Tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
    """The free and the blocked cells that a scan saw, (n, 2) each: what `observe` takes of any navigator.

    >>> frame = lasius.WorldFrame(0.5)
    >>> grid = lasius.Grid(np.zeros((4, 6), np.uint8), free=0)
    >>> free, blocked = cells_of_scan((0.25, 0.25, 0), [1.5], 0, 0.1, 5, frame, grid)
    >>> blocked.tolist(), len(free)
    ([[3, 3]], 3)

    Args:
        sensor: x, y, yaw in metres of the map's frame, y up.
        ranges: metres; not a number: nothing is said.
        first_angle: of the first range from where the sensor looks, radians.
        step: from a range to the next, radians.
        most: metres; a range from there on met nothing.
        frame: the map's, as `read_map` gives it.
        grid: the map; only its size matters.
        least: nearer ranges say nothing.
    """
    values = np.asarray(ranges, dtype=np.float64).ravel()
    return _lasius.cells_of_scan(tuple(sensor), values, first_angle, step, least, most, frame, grid.width, grid.height)


@explained
def cells_of_points(
    sensor: Tuple[float, float], points: npt.ArrayLike, most: float, frame: WorldFrame, grid: Grid
) -> Tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
    """The same of points that were met, (n, 2), in metres of the map's frame.

    Args:
        sensor: x, y, where they were seen from.
        most: of what is farther only the way there is told, so far.
    """
    rows = np.asarray(points, dtype=np.float64)
    return _lasius.cells_of_points(tuple(sensor), rows, most, frame, grid.width, grid.height)
