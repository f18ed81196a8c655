"""Pictures of maps and answers, through matplotlib where it is installed."""

from __future__ import annotations

import base64
import html
import io
from typing import TYPE_CHECKING, Any, List, Optional, Tuple

import numpy as np

from ._lasius import Grid, WorldFrame
from .arrays import BoolArray, End

if TYPE_CHECKING:
    from .maps import Map
    from .results import DriveResult, Result

MOST = 1024  # cells a side that are drawn one by one


def blocked_picture(grid: Grid) -> BoolArray:
    """The blocked cells [y, x]; of a large map squares of cells, blocked where one of them is."""
    cells = grid.to_array(free=False)
    side = -(-max(cells.shape) // MOST)
    if side == 1:
        return cells
    padding = [(0, -length % side) for length in cells.shape]
    rows, columns = ((length + add) // side for length, (_, add) in zip(cells.shape, padding))
    return np.pad(cells, padding).reshape(rows, side, columns, side).any(axis=(1, 3))


def new_axes(curves: bool) -> Tuple[Any, Any]:
    """Axes of a map, and of curves below or None."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot() needs matplotlib: apt install python3-matplotlib, or pip install matplotlib") from error
    return axes_of(plt.figure(figsize=(7, 6 if curves else 4.5), layout="constrained"), curves)


def axes_of(figure: Any, curves: bool) -> Tuple[Any, Any]:
    if not curves:
        return figure.add_subplot(), None
    upper, lower = figure.subplots(2, 1, height_ratios=(3, 1))
    return upper, lower


def draw_map(grid: Optional[Grid], axes: Any, map: Optional[Map] = None) -> Any:
    """Blocked cells dark, row 0 at the top, a cell from 0 to 1 along each axis; in metres where the map has a
    frame. No grid, of an answer that was parted from its map: the axes alone."""
    if grid is None:
        axes.yaxis.set_inverted(True)
    else:
        how = dict(extent=(0, grid.width, grid.height, 0), interpolation="nearest")
        images = [axes.imshow(blocked_picture(grid), cmap="Greys", vmin=0, vmax=1.4, **how)]
        if map is not None and map.unknown is not None:
            from matplotlib.colors import ListedColormap

            unknown = blocked_picture(map.unknown)
            tone = ListedColormap(["#dbc9a8"])
            images.append(axes.imshow(np.where(unknown, 1.0, np.nan), cmap=tone, **how))
        if map is not None and map.frame is not None:
            place_images(images, axes, map.frame, grid)
            return axes
    axes.set(aspect="equal", xlabel="x, cells", ylabel="y, cells")
    return axes


def place_images(images: List[Any], axes: Any, frame: WorldFrame, grid: Grid) -> None:
    """Moves images in cells to where they are in metres."""
    from matplotlib.transforms import Affine2D

    width, height = grid.width, grid.height
    origin, x, y = frame.to_world([[0, 0], [1, 0], [0, 1]], height)
    to_metres = Affine2D(np.vstack([np.column_stack([x - origin, y - origin, origin]), [0, 0, 1]]))
    for image in images:
        image.set_transform(to_metres + axes.transData)
    corners = to_metres.transform([[0, 0], [width, 0], [0, height], [width, height]])
    low, high = corners.min(axis=0), corners.max(axis=0)
    axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x, m", ylabel="y, m")


def draw_line(points: Any, axes: Any, goal: str = "goal") -> None:
    """A path, its start and its goal."""
    if len(points) == 0:
        return
    axes.plot(points[:, 0], points[:, 1], color="#d62728", linewidth=1.8)
    axes.plot(*points[0], "o", color="#2ca02c", label="start")
    axes.plot(*points[-1], "s", color="#1f77b4", label=goal)
    axes.legend(loc="upper right", fontsize="small")


def points_of(result: Result) -> Any:
    """The path; of a disc's curve the arcs as many short chords."""
    if not result.curve:
        return result.path
    points: List[Any] = []
    for piece in result.curve:
        if piece.centre is None:
            points += [piece.start, piece.end]
            continue
        centre = np.array(piece.centre)
        x, y = np.subtract(piece.start, centre)
        angles = np.arctan2(y, x) + piece.turn * np.linspace(0, piece.angle, 2 + int(64 * piece.angle))
        points += list(centre + piece.radius * np.column_stack([np.cos(angles), np.sin(angles)]))
    return np.array(points)


def draw_swept(points: Any, radius: float, axes: Any) -> None:
    """What a disc of that radius, in the axes' unit, sweeps on a path."""
    from matplotlib.lines import Line2D

    def draw(line: Any, renderer: Any) -> None:
        (left, _), (right, _) = axes.transData.transform([(0, 0), (2 * radius, 0)])
        line.set_linewidth(abs(right - left) / renderer.points_to_pixels(1))
        Line2D.draw(line, renderer)

    swept = type("Swept", (Line2D,), {"draw": draw})  # as wide as the axes show it
    axes.add_line(swept(points[:, 0], points[:, 1], color="#d62728", alpha=0.16, solid_capstyle="round",
                        solid_joinstyle="round", zorder=1.5, label="swept by the robot"))


def draw_curves(result: Any, axes: Any) -> None:
    """Best and mean length by iteration."""
    iterations = np.arange(1, len(result.curves) + 1)
    axes.plot(iterations, result.curves.mean, color="#7f7f7f", label="mean tour, as walked")
    axes.plot(iterations, result.curves.best, color="#d62728", label="best path")
    axes.set(xlabel="iteration", ylabel="length")
    axes.legend(fontsize="small")


def title(result: Any, frame: Optional[WorldFrame] = None) -> str:
    told = f"{result.length:.6g}" if frame is None else f"{result.length * frame.resolution:.6g} m"
    length = f", length {told}" if result.found else ""
    return f"{result.params.algorithm}: {result.status}{length}"


def centre_of(end: End) -> Any:
    """Where a start or goal is: a cell's centre, or the point."""
    is_cell = all(hasattr(part, "__index__") for part in end)
    return np.add(end, 0.5 if is_cell else 0.0)


def draw_result(result: Result, upper: Any, lower: Any, map: Optional[Map] = None) -> None:
    frame = map.frame if map is not None else None

    def placed(points: Any) -> Any:
        return frame.to_world(points, map.grid.height) if frame is not None and map is not None else np.asarray(points)

    path, goal = points_of(result), centre_of(result.goal)
    short = len(path) > 0 and not np.array_equal(path[-1], goal)
    draw_map(result.grid, upper, map)
    for other in result.alternatives:
        upper.plot(*placed(other.path).T, color="#ed9490", linewidth=1.5)
    if len(path) > 0:
        draw_line(placed(path), upper, "goal reached" if short else "goal")
        if short:
            upper.plot(*placed([goal])[0], "D", color="#1f77b4", fillstyle="none", label="goal asked")
        if result.way_out is not None:
            upper.plot(*placed([result.way_out])[0], ".", color="#2ca02c", label="way out")
        if result.radius > 0:
            draw_swept(placed(path), result.radius * (frame.resolution if frame is not None else 1), upper)
        upper.legend(loc="upper right", fontsize="small")
    upper.set_title(title(result, frame))
    if lower is not None:
        draw_curves(result, lower)


def plot_grid(grid: Grid, axes: Any = None) -> Any:
    """Draws the map; needs matplotlib. Returns the axes."""
    return draw_map(grid, axes if axes is not None else new_axes(False)[0])


def plot_result(result: Result, axes: Any, map: Optional[Map]) -> Any:
    upper, lower = (axes, None) if axes is not None else new_axes(result.curves is not None)
    draw_result(result, upper, lower, map)
    return upper


def plot_track(run: DriveResult, axes: Any) -> Any:
    axes = draw_map(run.truth, axes if axes is not None else new_axes(False)[0])
    draw_line(run.track + 0.5, axes)
    axes.set_title(f"{run.status}: {run.ticks} ticks, length {run.length:.6g}")
    return axes


def png_of_result(result: Result) -> Optional[bytes]:
    """The picture; None without matplotlib."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        return None
    curves = result.curves is not None
    figure = Figure(figsize=(7, 6 if curves else 4.5), layout="constrained")
    draw_result(result, *axes_of(figure, curves))
    return png_of_figure(figure)


def png_of_figure(figure: Any) -> bytes:
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=100)
    return data.getvalue()


def png_of_grid(grid: Grid) -> bytes:
    """The map, a pixel a cell or, of large ones, a square of cells; needs nothing."""
    import tempfile

    from . import _lasius

    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        _lasius.write_map(Grid(blocked_picture(grid), free=False), file.name.encode())
        with open(file.name, "rb") as written:
            return written.read()


def html_of_result(result: Result) -> str:
    """A table of what it says, and the picture."""
    rows = [("status", result.status), ("algorithm", result.params.algorithm)]
    if result.found:
        rows += [("length", f"{result.length:.6g} cells"), ("vertices", str(len(result.path)))]
    if result.gap is not None:
        rows.append(("certified gap", f"{100 * result.gap:.3g} %"))
    if result.error:
        rows.append(("error", result.error))
    cells = "".join(f"<tr><th>{name}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)
    png = png_of_result(result)
    picture = "" if png is None else image(png)
    return f"<table>{cells}</table>{picture}"


def image(png: bytes) -> str:
    data = base64.b64encode(png).decode()
    return f'<img alt="the map with the path" src="data:image/png;base64,{data}">'
