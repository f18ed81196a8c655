"""lasius: exact and ant-colony motion planning on bitmaps, among polygons and for arms.

Cells are (x, y), column and row from the top left; arrays of cells are [y, x]. The centre of cell
(0, 0) is (0.5, 0.5). Lengths are in cells.

>>> grid = lasius.generate("blobs", width=400, height=200, seed=61)
>>> planner = lasius.Planner(grid)
>>> result = planner.plan((14, 14), (380, 179))
>>> result.status
'solved'

`lasius.polygon` plans among polygons, `lasius.arm` for robot arms.
"""

from . import _lasius, plots
from ._lasius import DriveTick, Grid, IterationTours, Pheromone, Progress, WorldFrame, Workspace
from ._lasius import version as __version__
from .arguments import told
from .arrays import reduced
from .costs import CostField, CostPlanner, CostResult, Inflation, path_cost, read_costmap
from .errors import Error, FileBroken, FileMissing, FileUnsupported, InvalidParameter, OutputFailed
from .maps import (
    Map,
    clearance,
    generate,
    grow_obstacles,
    map_kinds,
    path_fault,
    path_length,
    pull_taut,
    read_map,
    shortest_walk,
    visible,
    write_map,
)
from .navigator import Changes, Navigator, drive
from .parameters import Algorithm, Parameter, Params, algorithms
from .planner import Planner, Preparation, plan, tour
from .results import Alternative, BatchResult, CoverResult, CurvePiece, Curves, DriveResult, Replans, Result, RobotTour, SearchResult, TourResult, Way, curves_of
from .vehicle import Contact, SpeedLimits, Vehicle, VehiclePlanner, VehicleResult, VehicleTourResult, plan_vehicle
from .vehicle_navigator import VehicleDriveResult, VehicleNavigator, VehicleWay, cells_of_points, cells_of_scan, drive_vehicle

__all__ = [
    "Algorithm",
    "Alternative",
    "BatchResult",
    "Changes",
    "Contact",
    "CostField",
    "CostPlanner",
    "CostResult",
    "CoverResult",
    "CurvePiece",
    "Curves",
    "DriveResult",
    "DriveTick",
    "Error",
    "FileBroken",
    "FileMissing",
    "FileUnsupported",
    "Grid",
    "Inflation",
    "IterationTours",
    "InvalidParameter",
    "Map",
    "Navigator",
    "OutputFailed",
    "Parameter",
    "Params",
    "Pheromone",
    "Planner",
    "Preparation",
    "Progress",
    "Replans",
    "Result",
    "SearchResult",
    "SpeedLimits",
    "RobotTour",
    "TourResult",
    "Vehicle",
    "VehicleDriveResult",
    "VehicleNavigator",
    "VehiclePlanner",
    "VehicleResult",
    "VehicleTourResult",
    "VehicleWay",
    "Way",
    "Workspace",
    "WorldFrame",
    "__version__",
    "algorithms",
    "cells_of_points",
    "cells_of_scan",
    "clearance",
    "drive",
    "drive_vehicle",
    "generate",
    "grow_obstacles",
    "map_kinds",
    "path_cost",
    "path_fault",
    "path_length",
    "plan",
    "plan_vehicle",
    "pull_taut",
    "read_costmap",
    "read_map",
    "shortest_walk",
    "tour",
    "visible",
    "write_map",
]

# What is written in Python of classes of the extension.
for _module in (_lasius, getattr(_lasius, "polygon", None), getattr(_lasius, "arm", None)):
    if _module is not None:
        setattr(_module.Progress, "curves", property(curves_of))
        told(_module.Progress)
        for _class in vars(_module).values():
            if isinstance(_class, type):
                setattr(_class, "__reduce_ex__", reduced)
for _class in (DriveTick, Grid, IterationTours, Pheromone, WorldFrame):
    told(_class)
setattr(Grid, "plot", plots.plot_grid)
setattr(Grid, "_repr_png_", plots.png_of_grid)
