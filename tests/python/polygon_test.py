"""Worlds of polygons, in any shape that they come in."""

import json
import pickle

import numpy as np
import pytest

import lasius

pg = pytest.importorskip("lasius.polygon", reason="built without the component polygon")

SQUARE = [[0, 0], [10, 0], [10, 10], [0, 10]]
BLOCK = [[4, 2], [6, 2], [6, 9], [4, 9]]
LENGTH = 2 * np.hypot(3, 3) + 2  # around the lower end of the block, worked by hand


def geometry(ring):
    return {"type": "Polygon", "coordinates": [ring + ring[:1]]}


@pytest.mark.parametrize("boundary", [SQUARE, SQUARE + SQUARE[:1], np.array(SQUARE), geometry(SQUARE), SQUARE[::-1]])
@pytest.mark.parametrize("obstacles", [
    [BLOCK], [np.array(BLOCK, np.float32)], [(BLOCK, [])], [geometry(BLOCK)], geometry(BLOCK),
    {"type": "MultiPolygon", "coordinates": [[BLOCK + BLOCK[:1]]]},
    {"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": geometry(BLOCK), "properties": {}}]},
])
def test_areas_of_every_kind(boundary, obstacles):
    result = pg.Planner(pg.World(boundary, obstacles)).plan((1, 5), (9, 5))
    assert result.status == "solved" and result.optimal and result.length == pytest.approx(LENGTH, abs=1e-9)
    assert result.path == pytest.approx(np.array([[1, 5], [4, 2], [6, 2], [9, 5]]))


def test_shapely():
    shapely = pytest.importorskip("shapely.geometry", reason="needs shapely")
    world = pg.World(shapely.box(0, 0, 10, 10), shapely.MultiPolygon([shapely.box(4, 2, 6, 9), shapely.box(8, 8, 9, 9)]))
    assert len(world.obstacles) == 2
    line = shapely.shape(pg.Planner(world).plan((1, 5), (9, 5)))
    assert line.length == pytest.approx(LENGTH) and line.geom_type == "LineString"
    grown = shapely.Polygon(*pg.Planner(world, margin=0.5, join="mitre").grown_obstacles[0])
    assert grown.area == pytest.approx(3 * 8) or grown.area == pytest.approx(4)


POINT, EMPTY = {"type": "Point", "coordinates": [1, 5]}, {"type": "Polygon", "coordinates": []}
WALL = {"type": "LineString", "coordinates": [[5, 0], [5, 8, 3]]}
MIXED = {"type": "GeometryCollection", "geometries": [WALL, EMPTY, geometry([[7, 1], [8, 1], [8, 2]])]}


@pytest.mark.parametrize("obstacles, areas, walls", [
    ([EMPTY], 0, 0), (EMPTY, 0, 0), ([geometry(BLOCK), EMPTY, geometry(BLOCK)], 2, 0), (WALL, 0, 1), ([WALL, BLOCK], 1, 1),
    (MIXED, 1, 1), ([MIXED, {"type": "Feature", "geometry": MIXED}], 2, 2),
    ({"type": "MultiPolygon", "coordinates": [[], [BLOCK + BLOCK[:1]], []]}, 1, 0),
    ({"type": "MultiLineString", "coordinates": [[], [[1, 1], [2, 2]], [[3, 3], [4, 3]]]}, 0, 2),
    *[({"type": kind, "coordinates": []}, 0, 0) for kind in ("Point", "LineString", "LinearRing", "MultiPoint",
                                                            "MultiLineString", "MultiPolygon")],
    ({"type": "GeometryCollection", "geometries": []}, 0, 0), ({"type": "FeatureCollection", "features": []}, 0, 0),
])
def test_every_geometry_is_read_as_an_obstacle(obstacles, areas, walls):
    world = pg.World(SQUARE, obstacles)
    assert (len(world.obstacles), len(world.walls)) == (areas, walls)
    assert pg.World.from_geojson(world.to_geojson()) == world and pickle.loads(pickle.dumps(world)) == world
    pytest.importorskip("matplotlib")
    assert len(pg.plot_world(world).lines) == 1 + walls


def test_a_wall_is_gone_round():
    world = pg.World(SQUARE, WALL, start=POINT, goal={"type": "Point", "coordinates": [9, 5, 1]})
    result = pg.Planner(world).plan()
    assert world.start == (1, 5) and result.path.tolist() == [[1, 5], [5, 8], [9, 5]] and "1 walls" in repr(world)
    assert pg.Planner(world).plan(POINT, POINT).length == 0


@pytest.mark.parametrize("make, says", [
    (lambda: pg.World(EMPTY), "boundary is empty; give one polygon"),
    (lambda: pg.World({"type": "GeometryCollection", "geometries": []}), "boundary is empty"),
    (lambda: pg.World(WALL), "boundary is a LineString"),
    (lambda: pg.World({"type": "MultiPolygon", "coordinates": [[SQUARE], [BLOCK]]}), "boundary is of 2 areas"),
    (lambda: pg.World(SQUARE, [BLOCK, POINT]), "obstacles[1]: a point is no obstacle; give polygons or lines"),
    (lambda: pg.World(SQUARE, {"type": "MultiPoint", "coordinates": [[1, 1]]}), "obstacles: a point is no obstacle"),
    (lambda: pg.World(SQUARE, {"type": "Polygon"}), "obstacles: a Polygon without coordinates"),
    (lambda: pg.World(SQUARE, {"type": "Feature", "geometry": None}), "obstacles: a Feature without geometry"),
    (lambda: pg.World(SQUARE, {"type": "Circle", "coordinates": [1, 2]}), "obstacles: a geometry of type Circle"),
    (lambda: pg.World(SQUARE, [{"type": "LineString", "coordinates": [[1, 1], [1, 1]]}]), "wall 0: the line has only 1 distinct point"),
    (lambda: pg.World(SQUARE, start=geometry(BLOCK)), "start is a Polygon; give one point"),
    (lambda: pg.World(SQUARE, goal={"type": "Point", "coordinates": []}), "goal is empty; give one point"),
    (lambda: pg.Planner(pg.World(SQUARE)).plan((1, 1), WALL), "goal is a LineString"),
])
def test_what_a_geometry_cannot_be(make, says):
    with pytest.raises(lasius.InvalidParameter) as refused:
        make()
    assert says in str(refused.value)


def test_shapely_objects_of_every_kind():
    shapely = pytest.importorskip("shapely.geometry", reason="needs shapely")
    box = shapely.box(0, 0, 10, 10)
    block = shapely.Polygon([(4, 2, 5), (6, 2, 5), (6, 9, 5), (4, 9, 5)])
    wall = shapely.LineString([(1, 1, 7), (2, 2, 7)])
    ring = shapely.LinearRing([(1, 1), (2, 2), (2, 1)])
    kinds = [  # areas and walls as an obstacle, or None
        (block, (1, 0)), (wall, (0, 1)), (ring, (0, 1)), (shapely.Point(1, 2, 3), None), (shapely.MultiPoint([(1, 2)]), None),
        (shapely.MultiPolygon([block, shapely.box(8, 8, 9, 9)]), (2, 0)), (shapely.MultiLineString([wall, ring]), (0, 2)),
        (shapely.GeometryCollection([block, wall]), (1, 1)), (shapely.GeometryCollection([shapely.Point(1, 2)]), None),
        (block.buffer(-5), (0, 0)), *[(getattr(shapely, kind)(), (0, 0)) for kind in (
            "Point", "LineString", "LinearRing", "Polygon", "MultiPoint", "MultiLineString", "MultiPolygon",
            "GeometryCollection")]]
    for shape, holds in kinds:
        for obstacles in (shape, [shape], [shapely.Polygon(), shape]):
            if holds is None:
                with pytest.raises(lasius.InvalidParameter, match="a point is no obstacle"):
                    pg.World(box, obstacles)
            else:
                world = pg.World(box, obstacles)
                assert (len(world.obstacles), len(world.walls)) == holds, shape
        if holds == (1, 0):
            assert len(pg.World(shape).boundary[0]) == 4
        else:
            with pytest.raises(lasius.InvalidParameter, match="boundary is "):
                pg.World(shape)
        if shape.geom_type in ("Point", "MultiPoint") and not shape.is_empty:
            assert pg.World(box, start=shape).start == (1, 2)
        elif holds is not None:
            for end in ("start", "goal"):
                with pytest.raises(lasius.InvalidParameter, match=end + " is "):
                    pg.World(box, **{end: shape})


def test_degrees_are_warned_of(tmp_path):
    text = pg.World(SQUARE, [BLOCK]).to_geojson()
    crs = '"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}, "features"'
    (tmp_path / "it.geojson").write_text(text.replace('"features"', crs))
    for read in (lambda: pg.World.from_geojson(text.replace('"features"', crs)), lambda: pg.World.read(tmp_path / "it.geojson")):
        with pytest.warns(UserWarning, match="degrees .*CRS84.*project them first") as warned:
            assert read() == pg.World.from_geojson(text)
        assert warned[0].filename == __file__


def test_holes_are_obstacles_of_a_boundary():
    result = pg.Planner(pg.World((SQUARE, [BLOCK]))).plan((1, 5), (9, 5))
    assert result.length == pytest.approx(LENGTH)


@pytest.mark.parametrize("make, error", [
    (lambda: pg.World([[0, 0], [1, 1]]), lasius.InvalidParameter),
    (lambda: pg.World([[0, 0], [2, 2], [2, 0], [0, 2]]), lasius.InvalidParameter),
    (lambda: pg.World([0, 1, 2]), ValueError),
    (lambda: pg.World(SQUARE, {"type": "Point", "coordinates": [1, 2]}), ValueError),
    (lambda: pg.World({"type": "MultiPolygon", "coordinates": []}), ValueError),
    (lambda: pg.World(SQUARE, margin=-1), lasius.InvalidParameter),
    (lambda: pg.Planner(pg.World(SQUARE), join="sharp"), lasius.InvalidParameter),
    (lambda: pg.Planner(pg.World(SQUARE)).plan((1, 1)), lasius.InvalidParameter),
    (lambda: pg.Params("maklink"), lasius.InvalidParameter),
])
def test_what_is_refused(make, error):
    with pytest.raises(error):
        make()


def test_the_source_world(maps):
    world = pg.World.read(maps / "maklink200.geojson")
    planner = pg.Planner(world)
    seen = []
    result = planner.plan(params="maklink-acs", iterations=20, observer=lambda p: seen.append(p.best_length))
    assert result.found and result.optimum <= result.length and len(seen) > 0
    assert len(result.crossing.path) == len(result.crossing.lines) + 2
    assert result.discrete_optimum.length <= result.dijkstra.length + 1e-9
    assert planner.lines.shape[1] == 4 and planner.components == 1 and len(planner.free_space) >= 1
    assert pickle.loads(pickle.dumps(result)) == result and pickle.loads(pickle.dumps(world)) == world
    assert planner.free(world.start) and planner.nearest_free(world.goal) == pytest.approx(world.goal)


def test_text_and_files(tmp_path):
    world = pg.World(SQUARE, [BLOCK], start=(1, 5), goal=(9, 5), margin=0.25)
    assert pg.World.from_geojson(world.to_geojson()) == world
    json.loads(world.to_geojson())
    for name in ("it.geojson", "it.wkt"):
        world.write(tmp_path / name)
        assert pg.World.read(tmp_path / name) == world
    assert world.start == (1, 5) and world.margin == 0.25 and pg.Planner(world).margin == 0.25
    with pytest.raises(lasius.FileMissing):
        pg.World.read(tmp_path / "none.wkt")


def test_an_end_in_an_obstacle():
    result = pg.Planner(pg.World(SQUARE, [BLOCK])).plan((5, 5), (9, 5))
    assert (result.status, result.fault) == ("invalid", "start_blocked") and result.nearest_free[0] in (4, 6)
    assert result.nearest_reachable == result.nearest_free


def test_a_goal_that_cannot_be_reached():
    shelf = [[[3, 3], [7, 3], [7, 4], [3, 4]], [[3, 6], [7, 6], [7, 7], [3, 7]], [[3, 3], [4, 3], [4, 7], [3, 7]],
             [[6, 3], [7, 3], [7, 7], [6, 7]], [[4.4, 4.4], [5.5, 4.4], [5.5, 5.5], [4.4, 5.5]]]
    planner = pg.Planner(pg.World(SQUARE, shelf))
    result = planner.plan((1, 5), (4.6, 5))
    assert result.nearest_free == (4.4, 5) and result.nearest_reachable == (3, 5)
    assert "can be reached from the start is (3, 5); (4.4, 5) is nearer, but cannot be reached" in result.error
    for goal in (4.6, 5), (4.2, 5):  # blocked, and free but walled in
        near = planner.plan((1, 5), goal, goal_tolerance=1.7)
        assert near.goal_reached == (3, 5) and near.length == 2 and near.path.tolist() == [[1, 5], [3, 5]]
        far = planner.plan((1, 5), goal, goal_tolerance=1)
        assert not far.found and far.goal_reached is None and "(3, 5), is 1." in far.error
    batch = planner.batch([[1, 5]], [[4.6, 5]], goal_tolerance=2)
    assert batch.length.tolist() == [2]
    assert planner.plan((1, 5), (1, 6), goal_tolerance=1).goal_reached == (1, 6)


def test_no_space_is_free():
    planner = pg.Planner(pg.World(SQUARE), margin=6)
    result = planner.plan((1, 5), (9, 5))
    assert result.status == "invalid" and result.nearest_free is None and planner.nearest_free((1, 5)) is None
    assert planner.components == 0 and "no space is free" in result.error


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_a_batch_is_as_one_by_one(maps, threads):
    planner = pg.Planner(pg.World.read(maps / "maklink200.geojson"))
    points = np.random.default_rng(3).uniform(0, 200, (2, 12, 2))
    told = []
    answers = planner.batch(*points, "maklink-acs", iterations=3, seed=5, seeds=2, threads=threads,
                            progress=lambda done, total, text: told.append((done, total)))
    assert answers.index.tolist() == [i for i in range(12) for _ in range(2)] and told[-1] == (24, 24)
    assert answers.seed.tolist() == [5, 6] * 12 and {"invalid"} < set(answers.status.tolist())
    for row in range(24):
        one = planner.plan(*points[:, row // 2], "maklink-acs", iterations=3, seed=5 + row % 2)
        assert answers.status[row] == one.status and np.array_equal(answers.path(row), one.path)
        assert answers.length[row] == one.length or not one.found
        assert answers.errors.get(row, "") == one.error


def test_what_a_batch_refuses():
    planner = pg.Planner(pg.World(SQUARE, [BLOCK]))
    assert len(planner.batch([], [])) == 0
    for starts, goals, options, error in [([[1, 1]], [[1, 1], [2, 2]], {}, ValueError), ([1, 1], [1, 1], {}, ValueError),
                                          (5, 5, {}, ValueError), (np.ma.masked_array([[1, 1]], True), [[1, 1]], {}, TypeError), ((p for p in [[1, 1]]), [[1, 1]], {}, TypeError),
                                          ([[1, np.nan]], [[1, 1]], {}, lasius.InvalidParameter),
                                          ([[1, 1]], [[1, 1]], {"seeds": 0}, lasius.InvalidParameter)]:
        with pytest.raises(error) as refused:
            planner.batch(starts, goals, **options)
        assert "unsized" not in str(refused.value)
