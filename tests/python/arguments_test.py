"""What is said of arguments that do not fit: name, value and remedy, never the extension's own words."""

import numpy as np
import pytest

import lasius
from conftest import GOAL, START

CAR = lasius.Vehicle.differential([[0, 0], [1, 0], [0, 1]])


@pytest.mark.parametrize("use, meant", [
    (lambda p: p.plan(START, GOAL, time_limt=1), "time_limit"),
    (lambda p: p.plan(START, GOAL, "as", target_gp=1), "target_gap"),
    (lambda p: p.plan(START, GOAL, time=1), "time_limit"),
    (lambda p: p.plan(START, GOAL, sed=1), "seed"),
    (lambda p: lasius.plan(p.grid, START, GOAL, obsever=1), "observer"),
    (lambda p: p.batch([START], [GOAL], threds=1), "threads"),
    (lambda p: lasius.drive(p.grid, p.grid, START, GOAL, sens=1), "sense"),
    (lambda p: lasius.Navigator(p.grid, GOAL, radus=1), "radius"),
    (lambda p: lasius.Params("mmas", prest="book"), "preset"),
    (lambda p: lasius.Params("mmas").replace(sed=1), "seed"),
    (lambda p: p.plan(START, GOAL, "mmas", antz=1), "ants"),
    (lambda p: p.plan(START, GOAL, "mmas", m=1), "ants"),  # its symbol in the source
])
def test_misspelt_keywords(planner, use, meant):
    with pytest.raises(lasius.InvalidParameter, match=f'did you mean "{meant}"') as caught:
        use(planner)
    assert caught.value.problem.startswith("unknown parameter") and caught.value.remedy


def test_a_keyword_of_another_function(planner):
    with pytest.raises(lasius.InvalidParameter, match="Planner.batch takes starts, goals, .*schedule") as caught:
        planner.batch([START], [GOAL], workspace=lasius.Workspace())
    assert "did you mean" not in str(caught.value)


@pytest.mark.parametrize("use, error, words", [
    (lambda p: lasius.Planner(lasius.Map(p.grid, None, "")), TypeError, "grid is a Map: give its .grid"),
    (lambda p: p.plan(START, GOAL, radius=2), lasius.InvalidParameter, "make a Planner(grid, radius"),
    (lambda p: p.plan(START, GOAL, time_limit="1"), TypeError, "time_limit is '1': give a number, or None"),
    (lambda p: p.plan(START, GOAL, target_gap=None), TypeError, "target_gap is None: give a number"),
    (lambda p: p.plan(START, GOAL, observer=3), TypeError, "observer is 3: give a function"),
    (lambda p: p.plan(START, GOAL, progress=3), TypeError, "progress is 3: give True or a function"),
    (lambda p: p.plan(START, GOAL, "as", update=3), TypeError, "update is 3: give a name or a function"),
    (lambda p: p.plan(START, GOAL, "as", schedule=3), TypeError, "schedule is 3: give a function"),
    (lambda p: p.plan(START, GOAL, workspace=3), TypeError, "workspace is 3: give a lasius.Workspace"),
    (lambda p: p.plan(START, GOAL, threads="2"), TypeError, "threads is '2': give an integer"),
    (lambda p: p.batch([START], [GOAL], seeds="2"), TypeError, "seeds is '2': give an integer"),
    (lambda p: p.batch([START], [GOAL], seeds=2**40), lasius.InvalidParameter, "seeds is 1099511627776"),
    (lambda p: lasius.generate("maze", seed=-1), lasius.InvalidParameter, "seed is -1; it must be 0"),
    (lambda p: lasius.generate("maze", width=9.5), TypeError, "width is 9.5: give an integer"),
    (lambda p: lasius.generate("maze", width=np.array([9, 9])), TypeError, "width is a ndarray: give an integer"),
    (lambda p: p.plan(START, GOAL, progress=1), TypeError, "progress is 1: give True or a function"),
    (lambda p: p.plan(START, GOAL, progress=np.zeros(2)), TypeError, "progress is a ndarray: give True or a function"),
    (lambda p: lasius.plan_vehicle(p.grid, CAR, (2, 3), (9, 3, 0)), TypeError, "start is (2, 3): give x, y and yaw"),
    (lambda p: lasius.generate(5), TypeError, "kind is 5: give a string"),
    (lambda p: lasius.clearance(np.zeros((999, 9))), TypeError, "grid is a ndarray: give a lasius.Grid"),
    (lambda p: lasius.path_length("x"), TypeError, "path is 'x': give an array of numbers"),
    (lambda p: lasius.drive(p, p.grid, START, GOAL), TypeError, "grid is a Planner: give a lasius.Grid"),
    (lambda p: lasius.drive(p.grid, p.grid, START, GOAL, changes=5), TypeError, "changes is 5: give a lasius.Changes, or None"),
    (lambda p: lasius.Navigator(p, GOAL), TypeError, "grid is a Planner: give a lasius.Grid"),
    (lambda p: lasius.read_map("x", unknown_is_free=None), TypeError, "unknown_is_free is None: give True or False"),
    (lambda p: p.grid.to_array(), TypeError, "Grid.to_array was given (): call it as Grid.to_array(*, free: bool)"),
    (lambda p: p.grid.free(1, 2), TypeError, "Grid.free was given (1, 2): call it as Grid.free(cell: "),
    (lambda p: lasius.WorldFrame(1).to_world([[1, 2]], height="x"), TypeError, "WorldFrame.to_world was given ([[1, 2]], height='x')"),
    (lambda p: lasius.Workspace(3), TypeError, "Workspace() takes 1 positional argument but 2 were given"),
])
def test_values_that_do_not_fit(planner, use, error, words):
    with pytest.raises(error) as caught:
        use(planner)
    assert words in str(caught.value) and "argument types" not in str(caught.value)
    assert caught.value.__context__ is None or caught.value.__suppress_context__


def test_what_a_callback_raises_stays_what_it_is(planner):
    def fail(progress):
        raise TypeError("'int' object is not callable")

    with pytest.raises(TypeError, match="not callable") as caught:
        planner.plan(START, GOAL, "mmas", observer=fail)
    assert caught.traceback[-1].name == "fail" and caught.value.result.status == "interrupted"
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'goal'"):
        planner.plan(START)
