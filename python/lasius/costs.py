"""Planning over costs on a bitmap."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, NamedTuple, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from ._lasius import Grid, Progress
from .arguments import explained
from .arrays import Cell, FloatArray
from .errors import finish
from .parameters import Params, chosen
from .planner import Planner
from .progress import Shown, watched
from .results import Result, TourResult, answer


class Inflation(NamedTuple):
    """Costs near blocked cells, see CostField.inflate."""

    radius: float  #: in cells, from centre to centre
    scaling: float  #: per cell
    weight: float = 2.0  #: what is added beside a blocked cell
    inscribed: float = 1.0  #: the robot's radius in cells


@explained
class CostField:
    """A weight for each cell: what one cell's length in it costs.

    >>> grid = lasius.Grid(np.zeros((60, 80), np.uint8), free=0)
    >>> costs = CostField(grid)
    >>> costs.add(np.fromfunction(lambda y, x: x > 40, (60, 80)), factor=2.0)
    >>> costs.weights[0, [40, 41]].tolist()
    [1.0, 3.0]

    Args:
        grid: the map; each cell has the weight 1 until layers are added.
    """

    __slots__ = ("_raw",)

    def __init__(self, grid: Grid) -> None:
        self._raw = _lasius.CostField(grid.width, grid.height)

    @classmethod
    def of(cls, weights: npt.ArrayLike) -> CostField:
        """The weights themselves, (height, width), from 1e-6 to 1e6."""
        return cls._of(_lasius.CostField.of_weights(np.asarray(weights, dtype=np.float64)))

    @classmethod
    def _of(cls, raw: Any) -> CostField:
        costs = cls.__new__(cls)
        costs._raw = raw
        return costs

    def add(self, values: npt.ArrayLike, factor: float = 1.0) -> None:
        """Adds a layer, (height, width): factor * value to each cell's weight. Both are at least 0."""
        self._raw.add(np.asarray(values, dtype=np.float64), factor)

    def inflate(
        self, grid: Grid, radius: float, scaling: float, *, weight: float = 2.0, inscribed: float = 1.0
    ) -> None:
        """Adds costs near blocked cells, as Nav2's inflation layer has them.

        Args:
            grid: whose blocked cells; of the same size.
            radius: in cells, from centre to centre; farther away nothing is added.
            scaling: per cell: weight * exp(-scaling * (distance - inscribed)) is added, at most `weight`.
            weight: what is added beside a blocked cell.
            inscribed: the robot's radius in cells; less than 1 counts as 1.
        """
        self._raw.inflate(grid, radius, scaling, weight, inscribed)

    @property
    def weights(self) -> FloatArray:
        """(height, width), a copy."""
        return np.asarray(self._raw.weights())

    def __reduce__(self) -> Tuple[Any, ...]:
        return CostField.of, (self.weights,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CostField) and np.array_equal(self.weights, other.weights)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        height, width = self.weights.shape
        return f"<CostField: {width} x {height}, weights {self.weights.min():.6g} to {self.weights.max():.6g}>"


@explained
def read_costmap(values: npt.ArrayLike, *, weight: float = 2.0, unknown_is_free: bool = False) -> Tuple[Grid, CostField]:
    """A ROS costmap as a map and its costs.

    >>> grid, costs = read_costmap(np.array([[0, 126, 252, 253, 255]], np.uint8))
    >>> costs.weights[0, :3].tolist(), [grid.free((x, 0)) for x in range(5)]
    ([1.0, 2.0, 3.0], [True, True, True, False, False])

    Args:
        values: (height, width) of 0 to 255, row 0 at the top: of a message, whose rows begin at the bottom,
            `np.flipud(np.asarray(message.data, np.uint8).reshape(height, width))`.
        weight: a cell costs 1 + weight * value / 252; 253 and 254 block it.
        unknown_is_free: 255 costs 1, where else it blocks.
    """
    cells = np.asarray(values)
    if cells.dtype != np.uint8:
        raise TypeError(f"values are {cells.dtype}: give numpy.uint8, 0 to 255")
    grid, costs = _lasius.read_costmap(cells, weight, unknown_is_free)
    return grid, CostField._of(costs)


@explained
def path_cost(grid: Grid, costs: CostField, path: npt.ArrayLike) -> Optional[float]:
    """The integral of the weight along a polyline (n, 2); None where it is not allowed."""
    cost = _lasius.path_cost(grid, costs._raw, np.asarray(path, dtype=np.float64))
    return None if cost is None else float(cost)


@dataclass(eq=False, repr=False)
class CostResult(Result):
    """One answer over costs: `lower_bound`, `gap` and `optimal` are about `cost`, `length` is the length."""

    cost: float  #: of the path; NaN without one
    proof: Optional[str]  #: of the bound, where it was asked for: "lasius-proof/1" as JSON

    def _summary(self) -> str:
        return super()._summary() + (f", cost {self.cost:.6g}" if self.found else "")


@explained
class CostPlanner:
    """A map and its costs made ready for planning: the cheapest path of any angle, with a proven gap.

    >>> grid = lasius.generate("blobs", width=200, height=100, seed=4)
    >>> costs = CostField(grid)
    >>> costs.inflate(grid, radius=8, scaling=0.4)
    >>> result = CostPlanner(grid, costs).plan((5, 5), (190, 90), target_gap=0.01)
    >>> result.status, result.gap <= 0.01, result.lower_bound <= result.cost
    ('solved', True, True)

    Args:
        grid: the map, or a Planner of it.
        costs: of the map's size: a CostField, or weights (height, width). Later changes of it are not seen.
        radius: of the robot, a disc, in cells, as of Planner; 0: a point.
    """

    __slots__ = ("_raw", "_planner")

    def __init__(
        self, grid: Union[Grid, Planner], costs: Union[CostField, npt.ArrayLike], *, radius: float = 0.0
    ) -> None:
        self._planner = grid if isinstance(grid, Planner) else Planner(grid, radius=radius)
        field = costs if isinstance(costs, CostField) else CostField.of(costs)
        self._raw = _lasius.CostPlanner(self._planner._raw, field._raw)

    @property
    def planner(self) -> Planner:
        """Of the map."""
        return self._planner

    def plan(
        self,
        start: Cell,
        goal: Cell,
        *,
        time_limit: Optional[float] = None,
        target_gap: float = 0.0,
        goal_tolerance: float = 0.0,
        eight_moves: bool = False,
        corners: str = "forbid",
        proof: bool = False,
        observer: Optional[Callable[[Progress], Any]] = None,
        progress: Shown = None,
    ) -> CostResult:
        """Answers one question, as Planner.plan does.

        Args:
            start: cell (x, y), column and row from the top left; the path begins at its centre.
            goal: the cell at whose centre it ends.
            time_limit: seconds; then the answer is the best so far, with the status "limit".
            target_gap: stop at this certified gap, a fraction; 0: at about 0.0003.
            goal_tolerance: as of Planner.plan.
            eight_moves: the cheapest walk by eight moves instead, for comparison.
            corners: of eight moves: "forbid", "one-side" or "allow".
            proof: keep what proves the bound.
            observer: called with a Progress with every cheaper path; its `best_length` is a cost.
            progress: True shows a bar; or called with (done, all, text).
        """
        params = chosen(Params, None, {})
        with watched(observer, progress, params) as watch:
            error, (search, *found), cost, gap, proven = self._raw.plan(
                start, goal, eight_moves, corners, proof, target_gap, goal_tolerance, time_limit, watch
            )
        others = (start, goal, params, self._planner.radius, self._planner.grid, cost, proven)
        result = answer(CostResult, search, *found, *others)
        result.gap = gap
        return result if error is None else finish(error, result)

    def tour(self, stops: npt.ArrayLike, **options: Any) -> TourResult:
        """Orders many stops so that all legs together cost least, as `Planner.tour`, whose options it takes.

        >>> planner = CostPlanner(lasius.Grid(np.zeros((20, 30), np.uint8), free=0), np.full((20, 30), 2.0))
        >>> run = planner.tour([[2, 2], [14, 2], [8, 2]], open=True)
        >>> run.length, run.cost
        (12.0, 24.0)
        """
        return self._planner.tour(stops, costs=self, **options)
