"""Maps from arrays of any strides, and what says which values are free."""

import copy
import os
import pickle

import numpy as np
import pytest

import lasius

RANDOM = np.random.default_rng(5)


def views(array):
    """The same kind of cells with strides of every kind."""
    return [array, array[::-1], array[:, ::-1], array[:, ::2], array[1:, 3:], array.T, array[::-2, ::-3],
            np.asfortranarray(array), np.broadcast_to(array[:1], array.shape)]


@pytest.mark.parametrize("width", [1, 7, 8, 63, 64, 65, 130])
@pytest.mark.parametrize("free", [0, 1, -1, -128, 127, range(0, 50), range(-1, 50), range(-128, 128)])
def test_ros_occupancy_in_any_strides(width, free):
    array = RANDOM.integers(-128, 128, (71, width)).astype(np.int8)
    array[:, ::2] = RANDOM.integers(-1, 2, array[:, ::2].shape)
    wanted = list(free) if isinstance(free, range) else [free]
    for view in views(array):
        if view.size:
            assert np.array_equal(lasius.Grid(view, free=free).to_array(free=True), np.isin(view, wanted))


@pytest.mark.parametrize("free", [0, 1, 255, 128, range(0, 256), range(100, 200), True, False])
def test_bytes_in_any_strides(free):
    array = RANDOM.integers(0, 256, (9, 70)).astype(np.uint8)
    array[:, :30] = RANDOM.integers(0, 2, (9, 30))
    wanted = {True: array != 0, False: array == 0}.get(free) if isinstance(free, bool) else None
    if wanted is None:
        wanted = np.isin(array, list(free) if isinstance(free, range) else [free])
    assert np.array_equal(lasius.Grid(array, free=free).to_array(free=True), wanted)


def test_masks():
    mask = RANDOM.random((20, 33)) < 0.5
    assert np.array_equal(lasius.Grid(mask, free=True).to_array(free=True), mask)
    assert np.array_equal(lasius.Grid(mask, free=False).to_array(free=False), mask)
    wide = np.where(mask, np.uint8(255), np.uint8(0))  # numpy's booleans are as Python's
    assert np.array_equal(lasius.Grid(wide, free=np.True_).to_array(free=True), mask)
    assert np.array_equal(lasius.Grid(wide, free=np.False_).to_array(free=True), ~mask)
    assert lasius.Grid(mask, free=True).count_free() == mask.sum()


def test_axes_are_rows_and_columns():
    array = np.zeros((3, 5), np.uint8)
    array[1, 4] = 1
    grid = lasius.Grid(array, free=0)
    assert (grid.width, grid.height, grid.shape) == (5, 3, (3, 5))
    assert not grid.free((4, 1)) and grid.free((1, 2)) and not grid.free((5, 0))


def test_the_array_may_change_afterwards():
    array = np.zeros((4, 4), np.uint8)
    grid = lasius.Grid(array, free=0)
    array[:] = 1
    assert grid.count_free() == 16


@pytest.mark.parametrize("array, free, error, words", [
    (np.zeros((3, 3)), 0, TypeError, "float64"),
    (np.zeros((3, 3), np.int32), 0, TypeError, "int32"),
    (np.zeros(3, np.uint8), 0, ValueError, "dimensions"),
    (np.zeros((2, 2, 3), np.uint8), 0, ValueError, "dimensions"),
    (np.zeros((0, 3), np.uint8), 0, ValueError, "without cells"),
    (np.zeros((3, 3), np.uint8), -1, ValueError, "no such value"),
    (np.zeros((3, 3), np.int8), 200, ValueError, "no such value"),
    (np.zeros((3, 3), np.uint8), 256, ValueError, "no such value"),
    (np.zeros((3, 3), np.uint8), range(0, 9, 2), ValueError, "step 1"),
    (np.zeros((3, 3), np.uint8), 10**30, ValueError, "no such value"),
    (np.zeros((3, 3), np.uint8), range(0, 10**30), ValueError, "no such value"),
    (np.zeros((3, 3), np.uint8), range(0, 9, 10**30), ValueError, "step 1"),
    (np.zeros((3, 3), np.uint8), range(5, 5), ValueError, "not empty"),
    (np.zeros((3, 3), np.uint8), 0.5, TypeError, "free=0.5"),
    (np.zeros((3, 3), np.uint8), None, TypeError, "free=None"),
    (np.zeros((3, 3), bool), 2, ValueError, "free=2: the array has no such value"),
    (np.zeros((1, 40000), np.uint8), 0, lasius.InvalidParameter, "width"),
])
def test_what_is_no_map(array, free, error, words):
    with pytest.raises(error, match=words):
        lasius.Grid(array, free=free)


def test_free_must_be_said():
    with pytest.raises(TypeError, match="missing 1 required keyword-only argument: 'free'"):
        lasius.Grid(np.zeros((3, 3), np.uint8))


def test_arrays_that_are_none_and_that_have_a_mask():
    with pytest.raises(TypeError, match="array is a list: give one of numpy"):
        lasius.Grid([[0, 1]], free=0)
    masked = np.ma.masked_array(np.zeros((2, 2), np.uint8), [[True, False], [False, False]])
    with pytest.raises(TypeError, match="array is a masked array.*filled"):
        lasius.Grid(masked, free=0)
    assert lasius.Grid(masked.filled(1), free=0).count_free() == 3


@pytest.mark.parametrize("width", [1, 64, 65])
def test_pickled_and_copied(width):
    grid = lasius.Grid(RANDOM.random((7, width)) < 0.5, free=True)
    assert pickle.loads(pickle.dumps(grid)) == grid
    assert copy.copy(grid) == copy.deepcopy(grid) == grid
    assert hash(grid) == hash(pickle.loads(pickle.dumps(grid)))
    assert grid != lasius.Grid(~grid.to_array(free=True), free=True) and grid != 3


def test_files_round_trip(tmp_path):
    grid = lasius.generate("rooms", width=60, height=50, seed=2)
    for ending in ("map", "pbm", "png"):
        lasius.write_map(grid, tmp_path / f"it.{ending}")
        read = lasius.read_map(tmp_path / f"it.{ending}")
        assert read.grid == grid and read.frame is None


def test_a_ros_map_has_a_frame(tmp_path):
    lasius.write_map(lasius.Grid(np.zeros((4, 6), np.uint8), free=0), tmp_path / "it.png")
    (tmp_path / "it.yaml").write_text(
        "image: it.png\nresolution: 0.5\norigin: [1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
    frame = lasius.read_map(tmp_path / "it.yaml").frame
    assert frame.resolution == 0.5
    assert np.array_equal(frame.to_world([[0, 4], [6, 0]], 4), [[1, 2], [4, 4]])
    assert np.array_equal(frame.to_cells([[1, 2]], 4), [[0, 4]])
    assert pickle.loads(pickle.dumps(frame)).origin_y == 2
    read = lasius.read_map(tmp_path / "it.yaml")
    assert read == lasius.read_map(tmp_path / "it.yaml")
    assert read.unknown.count_free() == 24 and lasius.read_map(tmp_path / "it.png").unknown is None
    (tmp_path / "it.pgm").write_bytes(b"P5 3 1 255\n\x00\xcd\xfe")
    (tmp_path / "it.yaml").write_text((tmp_path / "it.yaml").read_text().replace("it.png", "it.pgm"))
    for free in (False, True):
        read = lasius.read_map(tmp_path / "it.yaml", unknown_is_free=free)
        assert read.unknown.to_array(free=False).tolist() == [[False, True, False]]
        assert read.grid.to_array(free=True).tolist() == [[False, free, True]]


def test_frames_are_values():
    frame = lasius.WorldFrame(0.5, 1, yaw=2)
    assert frame == eval(repr(frame), {"WorldFrame": lasius.WorldFrame}) != lasius.WorldFrame(0.5, 1, yaw=2.5)
    assert hash(frame) == hash(copy.copy(frame)) and frame != (0.5, 1.0, 0.0, 2.0)
    for numbers in ((0,), (-1,), (np.nan,), (np.inf,), (1, np.nan), (1, 0, np.inf), (1, 0, 0, np.nan)):
        with pytest.raises(lasius.InvalidParameter, match="resolution must be above 0"):
            lasius.WorldFrame(*numbers)
    with pytest.raises(TypeError, match="yaw is 'north': give a number"):
        lasius.WorldFrame(1, yaw="north")


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(lasius.FileMissing) as caught:
        lasius.read_map(tmp_path / "none.map")
    assert isinstance(caught.value, (FileNotFoundError, lasius.Error)) and "none.map" in str(caught.value)
    (tmp_path / "broken.map").write_text("type octile\nheight x\n")
    with pytest.raises(lasius.FileBroken) as caught:
        lasius.read_map(tmp_path / "broken.map")
    assert caught.value.line == 2 and caught.value.file.endswith("broken.map") and caught.value.remedy
    copied = pickle.loads(pickle.dumps(caught.value))
    assert type(copied) is lasius.FileBroken and copied.line == 2 and str(copied) == str(caught.value)


def test_names_that_are_no_text(tmp_path):
    names = [os.fsencode(tmp_path) + b"/caf\xe9.png", os.fsdecode(os.fsencode(tmp_path) + b"/caf\xe9.png")]
    grid = lasius.generate("rooms", width=60, height=50, seed=2)
    for name in names:
        lasius.write_map(grid, name)
        assert os.listdir(os.fsencode(tmp_path)) == [b"caf\xe9.png"] and lasius.read_map(name).grid == grid
        os.remove(name)
        with pytest.raises(lasius.FileMissing) as missing:
            lasius.read_map(name)
        assert missing.value.file == names[1] and names[1] in str(missing.value)
    lasius.write_map(grid, names[0])
    (tmp_path / "it.yaml").write_bytes(b"image: caf\xe9.png\nresolution: 0.5\norigin: [1.0, 2.0, 0.0]\n"
                                       b"negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
    assert lasius.read_map(tmp_path / "it.yaml").image.endswith("caf\udce9.png")
    for name in ("a\0b.png", b"a\0b.png"):
        with pytest.raises(ValueError, match="NUL"):
            lasius.read_map(name)


def test_clearance_by_hand():
    array = np.zeros((9, 9), np.uint8)
    array[4, 4] = 1
    distances = lasius.clearance(lasius.Grid(array, free=0))
    assert distances.shape == (9, 9) and distances[4, 4] == 0
    assert distances[4, 2] == 1.5 and distances[2, 2] == pytest.approx(np.hypot(1.5, 1.5)) and distances[0, 0] == 0.5
    grown = lasius.grow_obstacles(lasius.Grid(array, free=0), 1)
    near = np.pad(np.zeros((7, 7), bool), 1, constant_values=True)
    near[3:6, 3:6] = True
    assert np.array_equal(grown.to_array(free=False), near)
    with pytest.raises(lasius.InvalidParameter):
        lasius.grow_obstacles(grown, -1)


def test_generated_maps():
    grid = lasius.generate("random", width=300, height=200, density=0.1, seed=3)
    assert grid.shape == (200, 300) and 0.88 < grid.count_free() / 60000 < 0.92
    assert lasius.generate("random", width=300, height=200, density=0.1, seed=3) == grid
    for kind in lasius.map_kinds():
        assert lasius.generate(kind, width=40, height=40).shape == (40, 40)
    with pytest.raises(lasius.InvalidParameter, match="blobs"):
        lasius.generate("blob")
    with pytest.raises(ValueError):
        lasius.generate("blobs", density=-0.1)


def test_paths_of_ones_own():
    array = np.zeros((5, 5), np.uint8)
    array[1:4, 2] = 1
    grid = lasius.Grid(array, free=0)
    bent = [[0.5, 2.5], [0.5, 0.5], [4.5, 0.5], [4.5, 2.5]]
    assert lasius.path_fault(grid, bent) is None and lasius.path_length(bent) == 8
    assert "(2, 2)" in lasius.path_fault(grid, [[0.5, 2.5], [4.5, 2.5]])
    taut = lasius.pull_taut(grid, bent)
    assert lasius.path_fault(grid, taut) is None and lasius.path_length(taut) < 8
    assert lasius.visible(grid, (0, 0), (4, 0)) and not lasius.visible(grid, (0, 2), (4, 2))
    assert lasius.shortest_walk(grid, (0, 2), (4, 2), "4") == 8
    assert lasius.shortest_walk(grid, (0, 2), (4, 2), neighbours=4) == 8
    with pytest.raises(ValueError, match="shape"):
        lasius.path_length([[1, 2, 3]])
    with pytest.raises(TypeError, match="path is a masked array"):
        lasius.path_length(np.ma.masked_array(bent, np.array(bent) < 1))
