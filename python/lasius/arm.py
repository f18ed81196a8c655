"""Motions of robot arms among obstacles that they learn of by trying positions. Metres, radians, seconds.

>>> robot = Robot.read(maps / "arms/planar3.json")
>>> query = robot.random_query(seed=4, obstacles=3)
>>> result = plan(robot, query.scene, query.start, [Goal.position(query.goal)], seed=2)
>>> result.status, result.joints.shape[1]
('solved', 3)
>>> result.trajectory.at([0.0]).q.shape
(1, 3)
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _lasius
from .arguments import explained, shown
from .arrays import FloatArray, Path, file_name, numbers_of, reduced
from .errors import finish
from .parameters import Algorithm, ParameterSet, chosen, described
from .progress import Shown, watched
from .results import Record, SearchResult, answer

if not hasattr(_lasius, "arm"):
    raise ImportError("lasius was built without its component arm")
_raw: Any = _lasius.arm

Progress = _raw.Progress
LEAST_CLEARANCE = 0.002
TOLERANCE: float = _raw.Goal.tolerance


def _warned(raw: Any) -> Any:
    """What was read, after warnings of what is likely a mistake in its files."""
    for text in raw.warnings:
        warnings.warn(text, stacklevel=4)
    return raw


@explained
class Goal:
    """What the arm is to reach."""

    __slots__ = ("_raw",)

    def __init__(self, raw: Any) -> None:
        self._raw = raw

    @classmethod
    def position(cls, position: npt.ArrayLike) -> Goal:
        """The tip at a point (3,), metres, its orientation free."""
        return cls(_raw.Goal.position(numbers_of(position, (3,), "position")))

    @classmethod
    def pose(
        cls, pose: npt.ArrayLike, position_tolerance: float = TOLERANCE, angle_tolerance: float = TOLERANCE
    ) -> Goal:
        """The tip's frame at a pose (4, 4), as Robot.tip_pose gives it.

        Args:
            position_tolerance: metres that it may be away, 1e-7 or more.
            angle_tolerance: radians that it may be turned, likewise; pi or more: any orientation.
        """
        return cls(_raw.Goal.pose(numbers_of(pose, (4, 4), "pose"), position_tolerance, angle_tolerance))

    @classmethod
    def joints(cls, joints: npt.ArrayLike) -> Goal:
        """A value for each joint, (joints,); one that turns freely may get there by any number of turns."""
        return cls(_raw.Goal.joints(numbers_of(joints, (-1,), "joints")))


@explained
class Solid:
    """A body: of a scene, placed in the world, or held, placed in the tip's frame. Poses are (4, 4), metres; none
    is the frame itself."""

    __slots__ = ("_raw",)

    def __init__(self, raw: Any) -> None:
        self._raw = raw

    @classmethod
    def _of(cls, name: str, shape: str, pose: Optional[npt.ArrayLike], size: npt.ArrayLike = (0, 0, 0),
            radius: float = 0.0, length: float = 0.0, corners: Optional[FloatArray] = None) -> Solid:
        placed = np.eye(4) if pose is None else numbers_of(pose, (4, 4), "pose")
        rows = np.zeros((0, 3)) if corners is None else corners
        return cls(_raw.Solid(name, shape, numbers_of(size, (3,), "size"), radius, length, placed, rows))

    @classmethod
    def box(cls, size: npt.ArrayLike, pose: Optional[npt.ArrayLike] = None, name: str = "") -> Solid:
        """Of these lengths (3,), its middle at the pose."""
        return cls._of(name, "box", pose, size=size)

    @classmethod
    def sphere(cls, radius: float, pose: Optional[npt.ArrayLike] = None, name: str = "") -> Solid:
        """Its middle at the pose."""
        return cls._of(name, "sphere", pose, radius=radius)

    @classmethod
    def cylinder(cls, radius: float, length: float, pose: Optional[npt.ArrayLike] = None, name: str = "") -> Solid:
        """Along the z of the pose, its middle there."""
        return cls._of(name, "cylinder", pose, radius=radius, length=length)

    @classmethod
    def capsule(cls, radius: float, axis: npt.ArrayLike, pose: Optional[npt.ArrayLike] = None, name: str = "") -> Solid:
        """Around the way from the pose's origin to `axis` (3,) in its frame."""
        return cls._of(name, "capsule", pose, size=axis, radius=radius)

    @classmethod
    def mesh(cls, triangles: npt.ArrayLike, pose: Optional[npt.ArrayLike] = None, name: str = "") -> Solid:
        """A surface of triangles (n, 3, 3), their corners; what is inside of it is free."""
        corners = np.asarray(triangles, np.float64)
        if corners.ndim != 3 or corners.shape[1:] != (3, 3):
            raise ValueError(f"triangles has the shape {corners.shape}: give (n, 3, 3)")
        return cls._of(name, "mesh", pose, corners=corners.reshape(-1, 3))


def _solids(solids: Sequence[Solid]) -> List[Any]:
    for solid in solids:
        if not isinstance(solid, Solid):
            raise TypeError(f"a solid is {shown(solid)}: give Solid.box(size) or its like")
    return [solid._raw for solid in solids]


@explained
class Scene:
    """What stands around a robot; without a file nothing.

    >>> len(Scene.of([Solid.box([0.4, 0.4, 0.02]), Solid.sphere(0.1, name="ball")]))
    2
    """

    __slots__ = ("_raw",)

    def __init__(self, raw: Any = None) -> None:
        self._raw = raw if raw is not None else _raw.Scene()

    @classmethod
    def of(cls, solids: Sequence[Solid], name: str = "") -> Scene:
        """Of these solids, in their order."""
        return cls(_raw.Scene(_solids(solids), name))

    @classmethod
    def read(cls, path: Path) -> Scene:
        """From JSON, see docs/worlds.md. Warns of a mesh that seems to be in millimetres."""
        return cls(_warned(_raw.read_scene(file_name(path))))

    @property
    def name(self) -> str:
        return str(self._raw.name)

    def __len__(self) -> int:
        return len(self._raw)

    def __repr__(self) -> str:
        return f"<Scene: {len(self)} obstacles>"


@explained
class Robot:
    """A chain of joints on a base that stands still; read from a file."""

    __slots__ = ("_raw",)

    def __init__(self, raw: Any) -> None:
        self._raw = raw

    @classmethod
    def read(
        cls,
        path: Path,
        *,
        base: str = "",
        tip: str = "",
        set_joints: Optional[Dict[str, float]] = None,
        srdf: Path = "",
        joint_limits: Path = "",
        packages: Optional[Dict[str, Path]] = None,
        use_visual: bool = False,
        bodiless: bool = False,
    ) -> Robot:
        """From URDF or the short description in JSON, see docs/worlds.md. Warns of a mesh that seems to be
        in millimetres.

        Args:
            base: link that stands still; empty: the root.
            tip: link at the end of the chain; empty: the only leaf.
            set_joints: values of joints beside the chain.
            srdf: file of pairs that may touch and of named postures.
            joint_limits: file of MoveIt's joint_limits.yaml.
            packages: folders by the names in package://NAME/.
            use_visual: links without collision geometry take what is drawn of them.
            bodiless: no link has a body, whatever the file says.
        """
        raw = _raw.read_robot(
            file_name(path), base, tip, set_joints or {}, file_name(srdf), file_name(joint_limits),
            {name: file_name(folder) for name, folder in (packages or {}).items()}, use_visual, bodiless,
        )
        return cls(_warned(raw))

    @property
    def name(self) -> str:
        return str(self._raw.name)

    @property
    def notes(self) -> List[str]:
        """What was assumed in reading it."""
        return list(self._raw.notes)

    @property
    def joint_names(self) -> List[str]:
        return list(self._raw.joint_names())

    @property
    def states(self) -> Dict[str, FloatArray]:
        """Postures that its files name, (joints,) each."""
        return dict(self._raw.states)

    @property
    def limits(self) -> Tuple[FloatArray, FloatArray]:
        """Least and largest values, (joints,) each."""
        return self._raw.low(), self._raw.high()

    def __len__(self) -> int:
        return len(self._raw)

    def tip_position(self, joints: npt.ArrayLike) -> FloatArray:
        """Where the tip is at joint values (joints,): (3,), metres."""
        return self._raw.tip_position(joints)

    def tip_pose(self, joints: npt.ArrayLike) -> FloatArray:
        """Where the tip's frame is: (4, 4)."""
        return self._raw.tip_pose(joints)

    def holding(self, solids: Sequence[Solid], name: str = "held", may_touch: Sequence[str] = ()) -> Robot:
        """This robot with something in its gripper, placed in the tip's frame. It is checked as the links are, but
        for those that move with the last joint and those named."""
        return Robot(_raw.holding(self._raw, _solids(solids), name, list(may_touch)))

    def inverse(self, goal: Goal, near: npt.ArrayLike, most: int = 8, seed: int = 1) -> FloatArray:
        """Joint values within the limits that reach the goal, (n, joints), those nearest to `near` first; none where
        none was found, which is no proof. What is in the way is not looked at."""
        return _raw.inverse(self._raw, goal._raw, near, most, seed)

    def random_query(
        self, *, seed: int = 1, obstacles: int = 20, wall: float = 0.0, least_distance: float = 0.3
    ) -> Query:
        """A scene, a start and a goal from a seed.

        Args:
            obstacles: besides the wall; 0 to 1000.
            wall: a plate between start and goal, so many times as wide as they are apart; 0: none.
            least_distance: of start and goal, as a share of the arm's reach.
        """
        scene, *values = _raw.generate_query(self._raw, seed, obstacles, wall, least_distance)
        return Query(Scene(scene), *values)

    def __repr__(self) -> str:
        return f"<Robot: {self.name or 'without a name'}, {len(self)} joints>"


@dataclass(eq=False)
class Query:
    """A question for the planner, with its world."""

    scene: Scene
    start: FloatArray  #: (joints,)
    goal: FloatArray  #: (3,), of the tip
    goal_joints: FloatArray  #: (joints,), a posture that reaches it


def algorithms() -> Dict[str, Algorithm]:
    """All algorithms for arms by name, the default first.

    >>> list(algorithms())
    ['postures', 'goritov2020']
    """
    return described(_raw.algorithms())


@explained
class Params(ParameterSet):
    """The parameters of one algorithm for arms."""

    __slots__ = ()
    _known = staticmethod(algorithms)

    def __init__(self, algorithm: str = "postures", **settings: Any) -> None:
        self._set(_raw.Params(algorithm), settings)


@dataclass(eq=False)
class State(Record):
    """Where all joints are at some times, and how they move: (n, joints) each."""

    q: FloatArray  #: values
    dq: FloatArray  #: velocities
    ddq: FloatArray  #: accelerations


@explained
class Trajectory:
    """A motion in time, at rest at both ends; accelerations may jump, unless jerk is limited."""

    __slots__ = ("_raw",)
    __reduce_ex__ = reduced

    def __init__(self, raw: Any) -> None:
        self._raw = raw

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self._raw.duration)

    def at(self, times: npt.ArrayLike) -> State:
        """The states at times (n,), in seconds from the start, clamped to it and the end."""
        return State(*self._raw.states(np.atleast_1d(np.asarray(times, np.float64))))

    def __bool__(self) -> bool:
        return bool(self._raw)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Trajectory) and self._knots() == other._knots()

    def _knots(self) -> List[Tuple[float, List[float], List[float]]]:
        return [(time, q.tolist(), ddq.tolist()) for time, q, ddq in self._raw.__getstate__()]

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Trajectory: {self.duration:.3g} s>"


@dataclass(eq=False)
class Questions(Record):
    """What the sensor was asked."""

    positions: int  #: by the search
    motions: int  #: by the search
    trajectory: int  #: motions, in making the trajectory


@dataclass(eq=False, repr=False)
class Result(SearchResult):
    """One answer for an arm; `length` in the unit of the objective, for "duration" seconds at the joints' largest
    velocities throughout: what the motion takes is `duration`."""

    joints: FloatArray  #: (n, joints), the lattice points of the path; no rows without one
    tips: FloatArray  #: (n, 3), where the tip is then
    trajectory: Trajectory  #: the motion; empty where none was asked for
    waypoints: int  #: of the motion
    stops: bool  #: it rests at each waypoint
    goal: int  #: which of the request's was reached, from 0; -1: none
    direct: bool  #: the straight joint-space line was free
    trees: bool  #: two trees met
    tip_travel: float  #: metres
    joint_travel: float  #: how long the way is in joint space
    duration: float  #: of the motion, seconds
    pitch: float  #: of the lattice, metres
    points: List[int]  #: of the lattice, by axis
    questions: Questions
    steps: int  #: of all ants
    notes: List[str]  #: what of the request was changed: values a hair outside of a joint's limits
    params: ParameterSet  #: as asked


@dataclass(eq=False)
class Recheck(Record):
    """What a second look at a finished motion found."""

    samples: int  #: times that were looked at
    contacts: int  #: samples at which something is touched
    unproven: int  #: pieces between samples not shown to touch nothing
    limits: int  #: samples at which a limit is broken
    nearest: float  #: least distance to anything, metres
    tip_error: float  #: largest distance between KDL's tip and ours


@explained
def plan(
    robot: Robot,
    scene: Scene,
    start: npt.ArrayLike,
    goals: Union[Goal, Sequence[Goal]],
    params: Union[None, str, Params] = None,
    *,
    motion: bool = True,
    duration: float = 0.0,
    clearance: float = LEAST_CLEARANCE,
    time_limit: Optional[float] = None,
    target_gap: float = 0.0,
    observer: Optional[Callable[[Any], Any]] = None,
    progress: Shown = None,
    **settings: Any,
) -> Result:
    """A short way of the arm from where it stands to a goal, and a motion along it.

    Args:
        start: (joints,), where it stands. Values outside of a joint's limits by at most 0.001 are taken at the
            limit, which Result.notes tells; of Goal.joints, too.
        goals: one Goal or several, any of which is to be reached: Goal.position(p) of the tip,
            (3,); Goal.pose(T), (4, 4), within tolerances; Goal.joints(q), (joints,).
        params: an algorithm's name or Params; None: `postures`.
        motion: makes the motion, too.
        duration: seconds that it is to take; 0: as few as the limits allow.
        clearance: that the arm keeps from everything, its own links too, metres. What comes nearer than twice
            as much counts as touched.
        time_limit, target_gap, observer, progress: as of lasius.Planner.plan.
        **settings: parameters by name.
    """
    used = chosen(Params, params, settings)
    sensor = _raw.SceneSensor(robot._raw, scene._raw, clearance)
    wanted = [goals] if isinstance(goals, Goal) else list(goals)
    for goal in wanted:
        if not isinstance(goal, Goal):
            raise TypeError(f"goals has {shown(goal)}: give Goal.position(p), Goal.pose(T) or Goal.joints(q)")
    raw = [goal._raw for goal in wanted]
    with watched(observer, progress, used) as watch:
        error, fields = _raw.plan(
            robot._raw, sensor, start, raw, used._raw, target_gap, motion, duration, time_limit, watch
        )
    search, joints, tips, trajectory, *others, questions, steps, notes = fields
    values = (joints, tips, Trajectory(trajectory), *others, Questions(*questions), steps, notes, used)
    return finish(error, answer(Result, search, *values))


@explained
def recheck(robot: Robot, scene: Scene, trajectory: Trajectory, samples: int = 1000) -> Recheck:
    """Looks at a motion at so many times, and between them."""
    error, fields = _raw.recheck(robot._raw, scene._raw, trajectory._raw, samples)
    return finish(error, Recheck(*fields))


@explained
def position_free(robot: Robot, scene: Scene, joints: npt.ArrayLike, clearance: float = LEAST_CLEARANCE) -> bool:
    """True when nothing that the arm must not touch, obstacle or link, is nearer than twice the clearance at joint
    values (joints,): what a plan with this clearance counts as free. See contact and distance."""
    return bool(_raw.SceneSensor(robot._raw, scene._raw, clearance).position_free(joints))


@explained
def motion_free(
    robot: Robot, scene: Scene, start: npt.ArrayLike, end: npt.ArrayLike, clearance: float = LEAST_CLEARANCE
) -> bool:
    """True when nothing comes nearer than the clearance while every joint goes straight: shown by bounds, all along."""
    return bool(_raw.SceneSensor(robot._raw, scene._raw, clearance).motion_free(start, end))


@explained
def nearest(robot: Robot, scene: Scene, joints: npt.ArrayLike) -> Tuple[float, str, str]:
    """The distance, and the names of the two that are nearest of all that must not touch: a link, and a link or an
    obstacle; inf and empty names where there is nothing."""
    distance, link, other = _raw.SceneSensor(robot._raw, scene._raw, LEAST_CLEARANCE).nearest(joints)
    return float(distance), str(link), str(other)


@dataclass(eq=False)
class TipLine(Record):
    """A straight motion of the tip, as far as it goes."""

    status: str  #: "solved": all of the line; "no_path", "limit"; "invalid": start not free, pose out of reach
    joints: FloatArray  #: (n, joints), the waypoints, the start first
    reached: float  #: share of the line
    error: str  #: why it ends before its end
    trajectory: Trajectory  #: the motion in time; empty where none was asked for, or the line is not solved
    stops: bool  #: it rests at each waypoint


@explained
def tip_line(
    robot: Robot,
    scene: Scene,
    start: npt.ArrayLike,
    pose: npt.ArrayLike,
    *,
    tolerance: float = 1e-3,
    angle_tolerance: float = 0.01,
    joint_step: float = 0.3,
    motion: bool = False,
    duration: float = 0.0,
    clearance: float = LEAST_CLEARANCE,
    time_limit: Optional[float] = None,
) -> TipLine:
    """Straight with the tip from where it is to a pose (4, 4), turning evenly: waypoints between which joints go
    straight.

    Args:
        tolerance: metres that the tip may be off the line, anywhere between waypoints too.
        angle_tolerance: radians that it may be turned off; pi or more: as it likes.
        joint_step: how far a joint may go between waypoints.
        motion: makes the motion in time, too, its corners rounded, all of it within the tolerances.
        duration: as of plan.
        clearance: as of plan.
        time_limit: seconds.
    """
    sensor = _raw.SceneSensor(robot._raw, scene._raw, clearance)
    placed = numbers_of(pose, (4, 4), "pose")
    error, (status, joints, reached, why, made, stops) = _raw.tip_line(
        robot._raw, sensor, start, placed, tolerance, angle_tolerance, joint_step, motion, duration, time_limit
    )
    return finish(error, TipLine(status, joints, reached, why, Trajectory(made), stops))


@explained
def contact(robot: Robot, scene: Scene, joints: npt.ArrayLike, clearance: float = LEAST_CLEARANCE) -> str:
    """What is in the way where position_free is False, and how far apart the two are; "" where nothing is."""
    return str(_raw.SceneSensor(robot._raw, scene._raw, clearance).contact(joints))


@explained
def distance(robot: Robot, scene: Scene, joints: npt.ArrayLike) -> float:
    """Metres from what moves of the arm at joint values (joints,) to what it must not touch; inf where there is nothing."""
    return float(_raw.SceneSensor(robot._raw, scene._raw, LEAST_CLEARANCE).distance(joints))
