"""Algorithms and their parameters, in any world."""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple, Type, TypeVar, Union

import numpy as np

from . import _lasius
from .arguments import explained
from .errors import invalid

Value = Union[bool, int, float, str]
MOST_SEED = 2**53 - 1
MOST_THREADS = 1024


@dataclass(frozen=True)
class Parameter:
    """One parameter of an algorithm."""

    name: str
    type: str  #: "integer", "number" or "choice"
    range: str  #: "1 .. 1000000", "a|b|c"
    summary: str  #: a line
    only_with: str  #: the settings of others with which it is read, as "update=rank"; "": with all
    choices: Tuple[str, ...]  #: of a choice: its values; ("off", "on") is a bool
    least: float  #: of an integer or number, included
    most: float  #: likewise


@dataclass(frozen=True)
class Algorithm:
    """One algorithm: where it comes from, and what it reads."""

    name: str
    summary: str  #: a line
    source: str  #: citation; please cite it when you use the algorithm
    kind: str  #: "exact", "colony" or "genetic"
    parameters: Tuple[Parameter, ...]

    def __getitem__(self, name: str) -> Parameter:
        """The parameter of this name."""
        for parameter in self.parameters:
            if parameter.name == name:
                return parameter
        raise KeyError(name)


def described(rows: List[Any]) -> Dict[str, Algorithm]:
    """Algorithms by name, of what the extension says of them."""
    return {
        name: Algorithm(name, summary, source, kind, tuple(Parameter(*p) for p in parameters))
        for name, summary, source, kind, parameters in rows
    }


def text_of(value: Any) -> str:
    """A value as the library reads it; floats to the last bit."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return "on" if value else "off"
    return value if isinstance(value, str) else repr(value)


def whole(name: str, value: Any) -> int:
    """A seed or a number of threads, which are no text and no float."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r:.60}: give an integer") from None
    if name == "seed" and not 0 <= number <= MOST_SEED:
        raise invalid(f"seed is {number}", f"it must be 0 .. {MOST_SEED}")
    if name == "threads" and not 0 <= number <= MOST_THREADS:
        raise invalid(f"threads is {number}", f"it must be 0 (all cores) to {MOST_THREADS}")
    return number


def value_of(parameter: Parameter, text: str) -> Value:
    """The other way round."""
    if parameter.choices == ("off", "on"):
        return text == "on"
    if parameter.type == "integer":
        return int(text)
    return float(text) if parameter.type == "number" else text


Self = TypeVar("Self", bound="ParameterSet")


@explained
class ParameterSet:
    """The parameters of one algorithm of one world. They never change; `replace` makes others."""

    __slots__ = ("_raw",)
    _known: Callable[[], Dict[str, Algorithm]]  # of each world
    _raw: Any

    def __init__(self, algorithm: str, **settings: Any) -> None:
        raise NotImplementedError

    def _set(self, raw: Any, settings: Dict[str, Any]) -> None:
        self._raw = raw
        if "evaporation" in settings and "persistence" in settings:
            raise invalid("evaporation and persistence are both given", "persistence is 1 - evaporation: give one")
        for name, value in settings.items():
            if name in ("seed", "threads"):
                setattr(self._raw, name, whole(name, value))
            else:
                self._raw.set(name, text_of(value))

    def _refuse_unread(self, settings: Dict[str, Any], before: Any) -> None:
        """Raises InvalidParameter for one of `settings` that the others leave unread, though it was another before."""

    @property
    def algorithm(self) -> str:
        """Its name."""
        return str(self._raw.algorithm)

    @property
    def seed(self) -> int:
        """Of all random numbers; another seed, another run."""
        return int(self._raw.seed)

    @property
    def threads(self) -> int:
        """0: as many as OpenMP gives; never changes the answer."""
        return int(self._raw.threads)

    def _described(self) -> Algorithm:
        return type(self)._known()[self.algorithm]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            parameter = self._described()[name]
        except KeyError:
            raise AttributeError(f"{self.algorithm} has no parameter {name!r}") from None
        return value_of(parameter, self._raw.get(name))

    def __setattr__(self, name: str, value: Any) -> None:
        if name != "_raw":
            raise AttributeError(f"parameters never change: make others by .replace({name}={value!r})")
        object.__setattr__(self, name, value)

    def __dir__(self) -> Iterator[str]:
        return iter([*super().__dir__(), *self.to_dict()])

    def to_dict(self) -> Dict[str, Value]:
        """All that the algorithm reads, by name; seed and threads are not among them."""
        return {p.name: value_of(p, self._raw.get(p.name)) for p in self._described().parameters}

    def replace(self: Self, **settings: Any) -> Self:
        """The same with other values, `seed` and `threads` among them.

        Raises:
            InvalidParameter: for an unknown name (with the nearest known one), a value out of range, or one that the
                others leave unread.
        """
        return chosen(type(self), self, settings)

    def _with(self: Self, settings: Dict[str, Any]) -> Self:
        other = object.__new__(type(self))
        other._set(self._raw.copy(), settings)
        return other

    def validate(self) -> None:
        """Raises InvalidParameter where they do not compose or one was changed that the algorithm does not read. Planning does that, too."""
        self._raw.validate()

    def formulas(self) -> List[str]:
        """The rules of a colony in a line each; empty for others."""
        return list(self._raw.formulas())

    def _all(self) -> Tuple[Any, ...]:
        return (self.algorithm, self.seed, self.threads, self.to_dict())

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._all() == other._all()  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        return hash((self.algorithm, self.seed))

    def __reduce__(self) -> Tuple[Any, ...]:
        return (restored, (type(self), *self._all()))

    def __repr__(self) -> str:
        usual = type(self)(self.algorithm).to_dict()
        changed = {n: v for n, v in self.to_dict().items() if v != usual[n]}
        seed = {} if self.seed == 1 else {"seed": self.seed}
        settings = "".join(f", {n}={v!r}" for n, v in {**changed, **seed}.items())
        return f"{type(self).__name__}({self.algorithm!r}{settings})"


def restored(kind: Type[Self], algorithm: str, seed: int, threads: int, values: Dict[str, Value]) -> Self:
    """Parameters that were pickled."""
    return kind(algorithm)._with({"seed": seed, "threads": threads, **values})


def chosen(kind: Type[Self], params: Union[None, str, Self], settings: Dict[str, Any], own: bool = False) -> Self:
    """The parameters that a call names: none, an algorithm, or some; and what it sets beside, which own rules may read."""
    if params is None:
        params = kind(next(iter(kind._known())))
    elif isinstance(params, str):
        params = kind(params)
    elif not isinstance(params, kind):
        raise TypeError(f"params is {params!r}: give an algorithm's name or a {kind.__module__}.Params")
    if not settings:
        return params
    other = params._with(settings)
    if not own:
        other._refuse_unread(settings, params._raw)
    return other


def algorithms() -> Dict[str, Algorithm]:
    """All algorithms on bitmaps by name, the default first.

    >>> list(algorithms())[:3]
    ['exact', 'fan2004', 'as']
    >>> algorithms()["mmas"]["ants"].range
    '1 .. 1000000'
    """
    return described(_lasius.algorithms())


_table: Dict[str, Algorithm] = {}


def _known() -> Dict[str, Algorithm]:
    if not _table:
        _table.update(algorithms())
    return _table


@explained
class Params(ParameterSet):
    """The parameters of one algorithm on bitmaps, its published values where nothing else is said.

    >>> params = Params("mmas", ants=20, seed=7)
    >>> params.ants, params.seed, params.update
    (20, 7, 'max-min')
    >>> params.replace(ants=30)
    Params('mmas', ants=30, seed=7)
    >>> Params("mmas", antz=20)
    Traceback (most recent call last):
        ...
    lasius.errors.InvalidParameter: unknown parameter "antz"; did you mean "ants"?

    Args:
        algorithm: its name, see `algorithms()`.
        preset: "usual", or "book": the textbook's numbers, of algorithms that have them; what is
            raised for another one names them.
        **settings: any parameter by name; `seed` (to 2**53 - 1) and `threads` (0: as many as OpenMP
            gives; never changes the answer).
    """

    __slots__ = ()
    _known = staticmethod(_known)

    def __init__(self, algorithm: str = "exact", *, preset: str = "usual", **settings: Any) -> None:
        raw = _lasius.Params(algorithm, preset)
        self._set(raw.copy(), settings)
        self._refuse_unread(settings, raw)

    def why_unread(self, name: str) -> str:
        """Why a run does not read a parameter, as "it is read only with update=rank"; "" where it does."""
        return str(self._raw.why_unread(name))

    def _refuse_unread(self, settings: Dict[str, Any], before: Any) -> None:
        names = {"persistence" if name == "evaporation" else name for name in settings} - {"straight_deposit"}
        for name in [p.name for p in self._described().parameters if p.name in names]:
            value, usual, why = self._raw.get(name), before.get(name), self.why_unread(name)
            if why and value != usual:
                told = f"{name} (1 - evaporation)" if name == "persistence" else name
                raise invalid(f"{told} is {value}, but {why}", f"set it to {usual}, or change that setting, too")


OptionalParams = Optional[Union[str, Params]]
