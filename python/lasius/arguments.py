"""What is wrong with the arguments of a call, in the caller's words: the extension tells of them by types and
places, the library of parameters alone."""

from __future__ import annotations

import difflib
import functools
import inspect
import operator
import re
import sys
import types
from typing import Any, Callable, Dict, Optional, Tuple, Type, TypeVar

import numpy as np

from .errors import InvalidParameter, invalid

T = TypeVar("T")

#: Parts of what Python and the extension say where a value does not fit.
UNFIT = "The following argument types are supported"
RAW = (UNFIT, "has no attribute '_raw'", "as an integer", "not supported between", "not callable")
LONG = (0, 2**63 - 1)
RANGES = {"threads": (0, 1024), "seed": (0, 2**64 - 1), "max_bytes": LONG, "tick": LONG, "max_ticks": LONG}


def shown(value: Any) -> str:
    """A value as a message names it: short ones as they are, others by their type."""
    plain = value is None or isinstance(value, (bool, int, float, str, list, tuple, np.generic))
    words = repr(value) if plain else ""
    return words if 0 < len(words) <= 60 else f"a {type(value).__name__}"


def fits_int(value: Any) -> bool:
    try:
        return operator.index(value) is not None
    except TypeError:
        return False


def fits_float(value: Any) -> bool:
    return not isinstance(value, str) and (hasattr(value, "__float__") or hasattr(value, "__index__"))


def fits_array(value: Any) -> bool:
    try:
        return np.asarray(value).dtype.kind in "biuf"
    except (TypeError, ValueError):  # rows of different lengths
        return False


FITS: Dict[str, Tuple[Callable[[Any], bool], str]] = {
    "int": (fits_int, "an integer"),
    "float": (fits_float, "a number"),
    "bool": (lambda value: isinstance(value, (bool, np.bool_)), "True or False"),
    "str": (lambda value: isinstance(value, str), "a string"),
    "npt.ArrayLike": (fits_array, "an array of numbers"),
    "Pose": (lambda value: fits_array(value) and np.shape(value) == (3,), "x, y and yaw"),
    "Observer": (callable, "a function"),
    "Schedule": (callable, "a function"),
    "Shown": (lambda v: v is None or isinstance(v, bool) or callable(v), "True or a function"),
    "Union[None, str, Update]": (lambda v: v is None or isinstance(v, str) or callable(v), "a name or a function"),
}


def fault_of(name: str, value: Any, annotation: str, known: Dict[str, Any]) -> Optional[Exception]:
    """What is wrong with one argument, or None. `known` are the names that annotations use."""
    optional = annotation.startswith("Optional[")
    kind = annotation[len("Optional[") : -1] if optional else annotation
    if optional and value is None:
        return None
    kind = "Observer" if kind.startswith("Callable") else kind
    asked = known.get(kind, Any)
    fits, wanted = FITS.get(kind, (lambda _: True, ""))
    if kind not in FITS and isinstance(asked, type) and asked is not Any:
        if isinstance(value, asked):
            return None
        public = getattr(sys.modules[str(__package__)], kind, None) is asked
        wanted = f"a {__package__ if public else asked.__module__}.{kind}"
    elif fits(value):
        least, most = RANGES.get(name, (-(2**31), 2**31 - 1))
        if kind != "int" or least <= operator.index(value) <= most:
            return None
        remedy = f"it must be {least} .. {most}" if name in RANGES else "it must fit into 32 bits"
        return invalid(f"{name} is {value}", remedy)
    return TypeError(f"{name} is {shown(value)}: give {wanted}{', or None' if optional else ''}")


def fault_of_call(function: Callable[..., Any], args: Tuple[Any, ...], keywords: Dict[str, Any]) -> Optional[Exception]:
    """What is wrong with the arguments of a call, or None."""
    signature = inspect.signature(function)
    try:
        bound = signature.bind(*args, **keywords)
    except TypeError:
        return None  # too many or too few: Python has said so
    for name, value in bound.arguments.items():
        if fault := fault_of(name, value, str(signature.parameters[name].annotation), function.__globals__):
            return fault
    return None


def likeness(name: str, known: str) -> Tuple[bool, float]:
    return known.startswith(name), difflib.SequenceMatcher(None, name, known).ratio()


def suggested(error: InvalidParameter, function: Callable[..., Any]) -> Optional[InvalidParameter]:
    """For an unknown keyword that the library took for a parameter: what of the function's own it may mean."""
    parameters = inspect.signature(function).parameters
    found = re.fullmatch(r'unknown parameter "(.*)"', error.problem)
    guess = re.search(r'did you mean "(.*?)"', error.remedy)
    if not found or "settings" not in parameters:
        return None
    name = found[1]
    own = [n for n in dict.fromkeys([*parameters, "seed", "threads"]) if n not in ("self", "settings")]
    nearest = max(own, key=lambda known: likeness(name, known))
    like, like_guess = likeness(name, nearest), likeness(name, guess[1]) if guess else (False, 0.0)
    if like > like_guess and (like[0] or like[1] >= 0.6):
        return invalid(error.problem, f'did you mean "{nearest}"?')
    if len(name) > 4 and like_guess < (False, 0.5):  # short ones may be a paper's symbols
        whose = function.__qualname__.replace(".__init__", "")
        return invalid(error.problem, f"{whose} takes {', '.join(own)} and the algorithm's parameters")
    return None


def explained(target: T) -> T:
    """The function, which names what is wrong with its arguments; of a class all public ones."""
    if isinstance(target, type):
        for name, member in list(vars(target).items()):
            if name.startswith("_") and name != "__init__":
                continue
            if isinstance(member, classmethod):
                setattr(target, name, classmethod(explained(member.__func__)))
            elif isinstance(member, types.FunctionType):
                setattr(target, name, explained(member))
        return target  # type: ignore[return-value]
    function: Any = target

    @functools.wraps(function)
    def call(*args: Any, **keywords: Any) -> Any:
        try:
            return function(*args, **keywords)
        except InvalidParameter as error:
            fault: Optional[Exception] = suggested(error, function)
            if fault is None:
                raise
        except (TypeError, AttributeError) as error:
            text = str(error)
            if not within(error) or not any(part in text for part in RAW):
                raise
            fault = fault_of_call(function, args, keywords)
            if fault is None and UNFIT in text:
                kinds = [type(value).__name__ for value in (*args, *keywords.values())]
                fault = TypeError(f"{function.__qualname__} takes no such values: {', '.join(kinds)}")
            if fault is None:
                raise
        raise fault from None

    return call  # type: ignore[return-value]


def told(kind: Type[Any]) -> None:
    """Lets the methods of a class of the extension say how they are called, where arguments do not fit."""
    for name, method in list(vars(kind).items()):
        if not name.startswith("_") and callable(method):
            setattr(kind, name, told_method(f"{kind.__name__}.{name}", method))


def told_method(name: str, method: Any) -> Any:
    @functools.wraps(method)
    def call(*args: Any, **keywords: Any) -> Any:
        try:
            return method(*args, **keywords)
        except TypeError as error:
            if UNFIT not in str(error):
                raise
        form = re.sub(r"^\w+\(self[^,)]*(, )?", "", str(method.__doc__).splitlines()[0].split(" -> ")[0])
        given = [shown(value) for value in args[1:]] + [f"{key}={shown(value)}" for key, value in keywords.items()]
        raise TypeError(f"{name} was given ({', '.join(given)}): call it as {name}({form}") from None

    return call


def within(error: BaseException) -> bool:
    """Raised by the package, not by a function of the caller's that it called."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace is not None and trace.tb_frame.f_globals.get("__package__") == __package__
