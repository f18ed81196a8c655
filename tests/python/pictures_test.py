"""Pictures, pages in notebooks, progress."""

import dataclasses
import io
import sys
import types

import numpy as np
import pytest

import lasius
from conftest import GOAL, START
from lasius import plots, progress

PNG = b"\x89PNG\r\n"


@pytest.fixture(scope="module")
def pyplot():
    pyplot = pytest.importorskip("matplotlib.pyplot", reason="needs matplotlib")
    yield pyplot
    pyplot.close("all")


def test_a_plot_shows_map_path_and_curves(planner, pyplot):
    result = planner.plan(START, GOAL, "fan2004", iterations=5)
    axes = result.plot()
    assert len(axes.figure.axes) == 2 and "fan2004" in axes.get_title()
    drawn = np.column_stack(axes.lines[0].get_data())
    assert np.array_equal(drawn, result.path)
    assert axes.get_ylim() == (200, 0), "row 0 is at the top"
    own = pyplot.figure().add_subplot()
    assert planner.plan(START, GOAL).plot(own) is own
    assert len(planner.grid.plot().images) == 1
    assert len(planner.plan(START, (999, 0)).plot().lines) == 0, "no path, no line"


def test_a_plot_in_metres_with_unknown_cells(pyplot):
    cells = np.zeros((4, 6), np.uint8)
    unknown = lasius.Grid(np.arange(24).reshape(4, 6) > 20, free=False)
    for yaw, x, y in ((0, (1, 4), (2, 4)), (np.pi / 2, (-1, 1), (2, 5))):
        frame = lasius.WorldFrame(0.5, 1, 2, yaw)
        grid = lasius.Grid(cells, free=0)
        read = lasius.Map(grid, frame, "", unknown)
        result = lasius.Planner(grid).plan((0, 0), (5, 3))
        axes = result.plot(map=read)
        assert np.allclose(np.column_stack(axes.lines[0].get_data()), frame.to_world(result.path, 4))
        assert np.allclose([axes.get_xlim(), axes.get_ylim()], [x, y]) and axes.get_xlabel() == "x, m"
        assert axes.get_title().endswith(f"length {result.length / 2:.6g} m")
        assert len(axes.images) == 2 and axes.images[1].get_array().count() == 3
        placed = (axes.images[0].get_transform() - axes.transData).transform([[0, 0], [6, 4]])
        assert np.allclose(placed, frame.to_world([[0, 0], [6, 4]], 4))
    without = result.plot(map=lasius.Map(grid, None, "", unknown))
    assert without.get_xlabel() == "x, cells" and len(without.images) == 2


def test_a_plot_of_a_disc(pyplot):
    cells = np.zeros((18, 30), np.uint8)
    cells[8:14, 9:11] = 1
    grid = lasius.Grid(cells, free=0)
    result = lasius.Planner(grid, radius=2.3).plan((8, 10), (12, 9), goal_tolerance=2)
    for read, size in ((None, 1), (lasius.Map(grid, lasius.WorldFrame(0.5, 1, 2, 0), "", None), 0.5)):
        axes = result.plot(map=read)
        told = [text.get_text() for text in axes.get_legend().get_texts()]
        assert told == ["start", "goal reached", "goal asked", "way out", "swept by the robot"]
        drawn = np.column_stack(axes.lines[0].get_data())
        chords = np.hypot(*np.diff(drawn, axis=0).T)
        assert abs(chords.sum() - size * result.length) < 1e-3 and len(drawn) > len(result.path), "arcs"
        axes.figure.savefig(io.BytesIO(), dpi=100)
        ends = axes.transData.transform([(0, 0), (2 * 2.3 * size, 0)])
        assert np.isclose(axes.lines[-1].get_linewidth(), (ends[1] - ends[0])[0] * 72 / 100)


def test_answers_in_a_notebook(planner, pyplot):
    result = planner.plan(START, GOAL)
    assert result._repr_png_().startswith(PNG) and planner.grid._repr_png_().startswith(PNG)
    page = result._repr_html_()
    assert "445.001" in page and "data:image/png;base64," in page
    bad = planner.plan(START, (999, 0))._repr_html_()
    assert "is outside the map" in bad and "<script" not in bad


def test_an_answer_without_its_map(planner, pyplot):
    for result in (planner.plan(START, GOAL), planner.plan(START, GOAL, "fan2004", iterations=2), planner.plan(START, (999, 0))):
        bare = dataclasses.replace(result, grid=None)
        axes = bare.plot()
        below, above = axes.get_ylim()
        assert len(axes.images) == 0 and below > above, "row 0 is at the top"
        assert bare._repr_png_().startswith(PNG) and "data:image/png" in bare._repr_html_()
    drive = lasius.drive(planner.grid, planner.grid, START, (20, 14))
    assert len(dataclasses.replace(drive, truth=None).plot().lines) == 3
    polygon = pytest.importorskip("lasius.polygon", reason="built without the component polygon")
    way = polygon.Planner(polygon.World([[0, 0], [9, 0], [9, 9], [0, 9]])).plan((1, 1), (8, 8))
    assert len(dataclasses.replace(way, world=None).plot().lines) == 3


def test_without_matplotlib(planner, monkeypatch):
    result = planner.plan(START, GOAL)
    for name in ("matplotlib", "matplotlib.figure", "matplotlib.pyplot"):
        monkeypatch.setitem(sys.modules, name, None)
    assert result._repr_png_() is None and "445.001" in result._repr_html_()
    with pytest.raises(ImportError, match="python3-matplotlib"):
        result.plot()


def test_a_large_map_is_drawn_smaller_and_keeps_thin_walls():
    cells = np.zeros((50, 5000), np.uint8)
    cells[:, 4321] = 1
    small = plots.blocked_picture(lasius.Grid(cells, free=0))
    assert small.shape == (10, 1000) and small[:, 864].all() and small.sum() == 10


def test_drives_and_worlds(pyplot):
    grid = lasius.Grid(np.zeros((20, 20), np.uint8), free=0)
    assert "solved" in lasius.drive(grid, grid, (1, 1), (9, 9)).plot().get_title()
    polygon = pytest.importorskip("lasius.polygon", reason="built without the component polygon")
    world = polygon.World([[0, 0], [9, 0], [9, 9], [0, 9]], [[[3, 3], [5, 3], [5, 5]]])
    assert "exact" in polygon.Planner(world).plan((1, 1), (8, 8)).plot().get_title()


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_a_bar_in_a_terminal_only(planner, monkeypatch):
    for stream, shown in ((Terminal(), True), (io.StringIO(), False)):
        monkeypatch.setattr(sys, "stderr", stream)
        planner.plan(START, GOAL, "mmas", iterations=4, progress=True)
        planner.batch([START] * 3, [GOAL] * 3, progress=True)
        assert ("4/4" in stream.getvalue() and "3/3 answers" in stream.getvalue()) == shown
        assert stream.getvalue().endswith("\r\033[K") == shown, "the line is left clean"


def test_a_bar_in_a_notebook(planner, monkeypatch):
    pages = []

    class Handle:
        def update(self, page):
            pages.append(page)

    display = types.ModuleType("IPython.display")
    display.HTML = str
    display.display = lambda page, display_id: pages.append(page) or Handle()
    package = types.ModuleType("IPython")
    package.get_ipython = lambda: types.SimpleNamespace(kernel=object())
    package.display = display
    monkeypatch.setitem(sys.modules, "IPython", package)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    assert progress.in_notebook()
    planner.plan(START, GOAL, "mmas", iterations=3, progress=True)
    assert '<progress value="3" max="3">' in pages[-1]


def test_a_function_is_told(planner):
    told = []
    planner.plan(START, GOAL, "mmas", iterations=3, progress=lambda *now: told.append(now), observer=lambda p: None)
    assert [t[:2] for t in told] == [(1, 3), (2, 3), (3, 3)] and told[0][2].startswith("length")
