"""Planning for vehicles on a bitmap: a footprint, a heading, a smallest turn."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any, Callable, Hashable, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import Grid
from .arguments import explained
from .arrays import Cell, FloatArray, IntArray, cells_or_points, numbers_of, unmasked
from .errors import finish, made
from .parameters import whole
from .results import Record, TourResult, numbered, tour_result

if TYPE_CHECKING:
    from .costs import CostField

#: x, y and yaw, in cells and radians; yaw turns from +x towards +y, which points down.
Pose = Tuple[float, float, float]
#: Of a tour: (n, 3), where a yaw may be None, or (n, 2).
Stops = Union[npt.ArrayLike, Sequence[Sequence[Optional[float]]]]


@dataclass(frozen=True, eq=False)
class Vehicle:
    """What moves; lengths in cells. `car`, `differential`, `omni` and `rectangle` make usual ones.

    >>> Vehicle.car(Vehicle.rectangle(1, 3, 1), 4.0).reverse
    True
    """

    footprint: npt.ArrayLike  #: (n, 2), corners about the reference point: x forward, y to the side that yaw grows to
    turning_radius: float = 0.0  #: least, of the reference point; 0: it turns in place alone
    reverse: bool = False  #: may drive backwards
    reverse_cost: float = 2.0  #: of a cell backwards
    cusp_cost: float = 0.0  #: of each change between forwards and backwards, cells
    rotate_in_place: bool = False  #: may turn where it stands
    rotation_cost: float = 3.0  #: of a radian in place, cells
    sideways: bool = False  #: drives to any side with its heading kept, at the same price
    curvature_rate: float = 0.0  #: by how much its curvature may change for each cell driven; 0: without limit

    @classmethod
    def car(cls, footprint: npt.ArrayLike, turning_radius: float, *, reverse: bool = True) -> Vehicle:
        """One that steers."""
        return cls(footprint, turning_radius, reverse)

    @classmethod
    def differential(cls, footprint: npt.ArrayLike) -> Vehicle:
        """One that turns where it stands and drives straight."""
        return cls(footprint, rotate_in_place=True)

    @classmethod
    def omni(cls, footprint: npt.ArrayLike) -> Vehicle:
        """One that drives to any side with its heading kept, and turns where it stands."""
        return cls(footprint, rotate_in_place=True, sideways=True)

    @staticmethod
    def rectangle(back: float, front: float, half_width: float) -> FloatArray:
        """A footprint from `back` behind the reference point to `front` before it."""
        return np.array([[-back, -half_width], [front, -half_width], [front, half_width], [-back, half_width]])


@dataclass(frozen=True)
class SpeedLimits:
    """Of a vehicle; cells, seconds, radians. `inf`: no limit."""

    speed: float = 1.0  #: forwards
    reverse_speed: float = 1.0  #: backwards
    acceleration: float = inf  #: of the speed
    braking: float = inf  #: likewise
    lateral_acceleration: float = inf  #: speed^2 * |curvature|
    turn_rate: float = 1.0  #: in place, radians a second
    turn_acceleration: float = inf  #: and braking, radians / s^2
    steady_curvature: bool = False  #: it rests where the curvature jumps


@dataclass(eq=False, repr=False)
class VehicleResult(Record):
    """A plan of a vehicle."""

    status: str  #: "solved", "limit", "interrupted", "unreachable" (proven), "no_path" (none in the lattice) or "invalid"
    fault: str  #: why it is invalid or unreachable
    error: str  #: why there is no path, in a sentence
    #: (n, 8), a motion a row: x, y, yaw where it begins, curvature (of yaw for each cell forwards), curvature rate,
    #: length, gear (1, -1, or 0 in place), angle (of one in place, or from its yaw to the side it drives to)
    segments: FloatArray
    length: float  #: driven, cells; NaN without a path
    cost: float  #: by the vehicle's prices, over costs times the weights along it; NaN without a path
    cusps: int  #: changes between forwards and backwards
    corners: int  #: of a vehicle with a curvature rate: where the curvature jumps nevertheless
    goal: int  #: which of the goals is met; -1 without a path
    lower_bound: Optional[float]  #: certified: no way of this vehicle is shorter, over costs cheaper
    gap: Optional[float]  #: certified, a fraction
    touched: Optional[Cell]  #: of a start or goal that meets something: what
    expanded: int  #: states of the lattice

    def poses(self, spacing: float = 0.5, limits: SpeedLimits = SpeedLimits()) -> FloatArray:
        """(n, 7), at most `spacing` cells apart: x, y, yaw, curvature, gear, speed, time of the fastest drive."""
        row = (limits.speed, limits.reverse_speed, limits.acceleration, limits.braking, limits.lateral_acceleration,
               limits.turn_rate, limits.turn_acceleration, float(limits.steady_curvature))
        return _lasius.vehicle_timed_poses(self.segments, spacing, row)

    def __repr__(self) -> str:
        return f"<VehicleResult: {self.status}, length {self.length:.6g}, {self.cusps} cusps>"


@dataclass(eq=False, repr=False)
class VehicleTourResult(TourResult):
    """A tour of a vehicle: its legs are certified plans, which are not the shortest ways."""

    poses: FloatArray  #: (k, 3), x, y, yaw at each stop of `order`, the same on arrival and departure
    plans: List[VehicleResult]  #: of the legs, whose paths have points each half a cell


@dataclass
class Contact:
    """Where a footprint first meets something along poses."""

    place: float  #: index of the pose before, and the share of the way to the next
    pose: Pose
    cell: Cell  #: blocked or outside
    proven: bool  #: False: it comes nearer than 0.001 cells


def vehicle_values(vehicle: Vehicle) -> _lasius.VehicleValues:
    """What the extension takes."""
    return _lasius.VehicleValues(
        np.asarray(vehicle.footprint, dtype=np.float64), vehicle.turning_radius, vehicle.reverse, vehicle.reverse_cost,
        vehicle.cusp_cost, vehicle.rotate_in_place, vehicle.rotation_cost, vehicle.sideways,
        vehicle.curvature_rate,
    )


@explained
class VehiclePlanner:
    """A map made ready for a vehicle. It never changes: use one from many threads.

    >>> grid = lasius.Grid(np.zeros((60, 80), np.uint8), free=0)
    >>> planner = VehiclePlanner(grid, Vehicle.car(Vehicle.rectangle(1, 3, 1), 4.0))
    >>> result = planner.plan((5, 5, 0), (60, 40, np.pi / 2))
    >>> result.status, result.cusps
    ('solved', 0)

    Args:
        grid: the map; what is outside is blocked.
        vehicle: its footprint keeps from blocked cells, which are closed squares, over the whole sweep of each motion.
        costs: the cheapest path over these is looked for; None: by length.
    """

    __slots__ = ("_raw",)

    def __init__(self, grid: Grid, vehicle: Vehicle, costs: Optional[CostField] = None) -> None:
        self._raw = made(*_lasius.make_vehicle_planner(
            grid, vehicle_values(vehicle), None if costs is None else costs._raw))

    def plan(
        self,
        start: Pose,
        goal: npt.ArrayLike,
        *,
        goal_tolerance: float = 0.0,
        heading_tolerance: float = 0.0,
        weight: float = 1.5,
        smooth: bool = True,
        time_limit: Optional[float] = None,
    ) -> VehicleResult:
        """A path from pose to pose.

        Args:
            start: x, y, yaw in cells and radians, met exactly.
            goal: likewise; or several, (n, 3), of which one is met.
            goal_tolerance: cells that the path may end from the goal's point.
            heading_tolerance: radians that it may end turned from its yaw; pi: any heading.
            weight: at least 1; the search is within this factor of the lattice's best.
            smooth: shorten what the search finds.
            time_limit: seconds; then the best so far is the answer, its status "limit".
        Raises:
            KeyboardInterrupt: with Ctrl-C; its `result` holds the answer so far.
        """
        error, fields = self._raw.plan(
            tuple(start), np.atleast_2d(np.asarray(goal, dtype=np.float64)), goal_tolerance, heading_tolerance, weight,
            smooth, time_limit,
        )
        return finish(error, VehicleResult(*fields))

    def tour(
        self,
        stops: Stops,
        *,
        open: bool = False,
        start: Optional[int] = None,
        goal: Optional[int] = None,
        group: Optional[Sequence[Hashable]] = None,
        robots: Optional[Sequence[int]] = None,
        most_stops: int = 0,
        seed: int = 1,
        generations: int = 20,
        target_gap: float = 0.0,
        threads: int = 0,
        time_limit: Optional[float] = None,
        observer: Optional[Callable[[IntArray, float], Any]] = None,
    ) -> VehicleTourResult:
        """Visits all stops by certified plans, in a short order, with a bound that no order and no way is below.

        >>> planner = VehiclePlanner(lasius.Grid(np.zeros((60, 80), np.uint8), free=0), Vehicle.car([[-1, -1], [3, 0], [-1, 1]], 4.0))
        >>> run = planner.tour([(10, 30, 0), (60, 30, 0), (30, 30, None)], open=True, start=0)
        >>> run.order.tolist(), round(run.length, 6), run.poses[:, 2].tolist()
        ([0, 2, 1], 50.0, [0.0, 0.0, 0.0])

        Args:
            stops: (n, 3), x, y, yaw in cells and radians; a yaw that is None or NaN is that of eight headings, every 45
                degrees, with which the tour is shortest; so are all of (n, 2), cells or points as of Planner.tour.
            open: as of Planner.tour, as the options not told here.
            start: index of the first stop, which has a yaw; None: any.
            goal: of the last one, of an open tour, likewise.
            robots: stops with yaws where robots begin, one each, in place of `start`.
            time_limit: seconds; then the best so far is the answer. The legs of the first order are planned all the same.
        Raises:
            KeyboardInterrupt: with Ctrl-C; its `result` holds the answer so far.
        """
        given: Any = stops
        rows = np.asarray(unmasked(given, "stops"))
        yaws: List[Optional[float]] = []
        if rows.ndim == 2 and rows.shape[1] == 3:
            poses = numbers_of(rows, (-1, 3), "stops")
            yaws = [None if np.isnan(yaw) else float(yaw) for yaw in poses[:, 2]]
            given = poses[:, :2]
        cells, points = cells_or_points(given, "stops")
        error, fields = _lasius.tour(
            self._raw, cells, points, yaws, open, start, goal, [], [], None, numbered(group),
            [] if robots is None else list(robots), most_stops, "exact", [], whole("seed", seed), generations, target_gap,
            whole("threads", threads), time_limit, observer,
        )
        found = tour_result(VehicleTourResult, fields)
        plans: List[Any] = found.plans
        found.plans = [VehicleResult(*plan) for plan in plans]
        return finish(error, found)

    def free(self, pose: Pose) -> bool:
        """Whether the footprint meets nothing there."""
        return bool(self._raw.free(tuple(pose)))

    def first_contact(self, poses: npt.ArrayLike) -> Optional[Contact]:
        """The first contact along poses (n, 3), between which x, y and yaw change in proportion; None where all of it
        is proven free."""
        met = self._raw.first_contact(np.asarray(poses, dtype=np.float64))
        return None if met is None else Contact(*met)


def plan_vehicle(
    grid: Grid, vehicle: Vehicle, start: Pose, goal: npt.ArrayLike, *, costs: Optional[CostField] = None, **options: Any
) -> VehicleResult:
    """Plans for a vehicle on a map, over costs where they are given, as `VehiclePlanner.plan`.

    >>> grid = lasius.Grid(np.zeros((60, 80), np.uint8), free=0)
    >>> robot = Vehicle.differential(Vehicle.rectangle(2, 2, 1.5))
    >>> result = plan_vehicle(grid, robot, (10, 10, 0), (50, 40, 0))
    >>> result.status, round(result.length, 6)
    ('solved', 50.0)
    """
    return VehiclePlanner(grid, vehicle, costs).plan(start, goal, **options)
