"""What a user writes, for mypy: it is checked, never run."""

from typing import List, Optional

import numpy as np

import lasius
from lasius import arm, polygon

grid: lasius.Grid = lasius.Grid(np.zeros((4, 4), np.uint8), free=0)
planner = lasius.Planner(grid, prepare=True)
lengths: List[float] = []


def observe(progress: lasius.Progress) -> None:
    lengths.append(progress.best_length)
    if progress.iteration > 3:
        progress.stop()


result: lasius.Result = planner.plan((0, 0), (3, 3), lasius.Params("mmas", ants=3), observer=observe)
gap: Optional[float] = result.gap
answers: lasius.BatchResult = planner.batch([[0, 0]], [[3, 3]], "exact", threads=1)
first: float = float(answers.length[0])


def persist(trail: lasius.Pheromone, tours: lasius.IterationTours) -> None:
    trail.persist(0.9)
    trail.add(tours.best_places(), 1 / tours.best_length)


own: lasius.Result = planner.plan((0, 0), (3, 3), "ras", update=persist, heuristic=np.ones((4, 4)))
world = polygon.World([[0, 0], [1, 0], [1, 1]])
way: polygon.Result = polygon.Planner(world).plan((0.1, 0.1), (0.5, 0.2))
ways: lasius.BatchResult = polygon.Planner(world).batch([[0.1, 0.1]], [[0.5, 0.2]], seeds=2)
motion: arm.Trajectory = arm.plan(arm.Robot.read("a.urdf"), arm.Scene(), [0.0], arm.Goal.joints([1.0])).trajectory
pose: arm.Goal = arm.Goal.pose(np.eye(4), angle_tolerance=0.1)
frame: bool = lasius.WorldFrame(0.05) == lasius.WorldFrame(0.1)
walk: Optional[float] = lasius.shortest_walk(grid, (0, 0), (3, 3), neighbours=8)
round_trip: lasius.TourResult = lasius.tour(grid, [[0, 0], [3, 3]], radius=0.0, algorithm="mmas", settings={"ants": 3})
shared: List[lasius.RobotTour] = planner.tour([[0, 0], [3, 3]], robots=[0], group=["a", None], costs=np.ones((4, 4))).tours
rounds: lasius.VehicleTourResult = lasius.tour(grid, [[0, 0, None]], vehicle=lasius.Vehicle.differential([[0, 0], [1, 0], [0, 1]]))
driven: lasius.VehicleDriveResult = lasius.drive_vehicle(grid, grid, lasius.Vehicle.omni([[0, 0], [1, 0], [0, 1]]), (1, 1, 0), (2, 2, 0))
dear: float = lasius.CostPlanner(planner, np.ones((4, 4))).tour([[0, 0], [3, 3]], open=True).cost
planner.tour([[0, 0]], robots=0.5)  # type: ignore[arg-type]
lasius.tour(grid, [[0, 0]], vehicle=3)  # type: ignore[call-overload]
planner.plan((0, 0), 3)  # type: ignore[arg-type]
planner.plan((0, 0), (3, 3), observer=3)  # type: ignore[arg-type]
planner.plan((0, 0), (3, 3), "ras", update=3)  # type: ignore[arg-type]
