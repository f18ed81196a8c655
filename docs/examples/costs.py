"""A nav_msgs/OccupancyGrid to the poses of a path that keeps away from walls, its distance from the best proven."""

import sys

import numpy as np

import lasius


def plan(data, width, height, start, goal, radius):
    """`data`: of the message, row by row from the bottom, -1 to 100; `start`, `goal`: cells from the top left."""
    cells = np.flipud(np.asarray(data, np.int8).reshape(height, width))
    grid = lasius.Grid((cells < 0) | (cells >= 65), free=False)
    costs = lasius.CostField(grid)
    costs.inflate(grid, radius=3 * radius, scaling=0.5, weight=3, inscribed=radius)
    return lasius.CostPlanner(grid, costs, radius=radius).plan(start, goal, target_gap=0.01)


if __name__ == "__main__":
    room = np.zeros((120, 160), np.int8)
    room[40:80, 60:64] = room[60:64, 60:120] = 100
    path = plan(room.ravel(), 160, 120, (10, 60), (150, 58), radius=4.0)
    assert path.gap < 0.01
    print(path, f"at most {100 * path.gap:.2f}% above the best", file=sys.stderr)
    print(path.poses(spacing=5)[:3])
