"""What the package raises for bad input and failed input or output."""

from __future__ import annotations

from typing import Dict, Optional, Type, TypeVar

T = TypeVar("T")


class Error(Exception):
    """Raised by the library. The message is one sentence that names the value, the place and the remedy.

    Attributes:
        problem: what is wrong.
        remedy: what to do about it.
        file: the file that it is in, or None.
        line: of a text file, counted from 1, or None.
        offset: of a binary file, in bytes from 0, or None.
    """

    problem: str = ""
    remedy: str = ""
    file: Optional[str] = None
    line: Optional[int] = None
    offset: Optional[int] = None


class InvalidParameter(Error, ValueError):
    """A value is out of its range, or does not compose with another."""


class FileMissing(Error, FileNotFoundError):
    """A file cannot be opened for reading."""


class FileBroken(Error, ValueError):
    """A file's content is not what its format asks for."""


class FileUnsupported(Error, ValueError):
    """A well-formed file of a kind that is not read, or too large."""


class OutputFailed(Error, OSError):
    """A file cannot be written."""


KINDS: Dict[str, Type[Error]] = {
    "invalid_parameter": InvalidParameter,
    "file_missing": FileMissing,
    "file_broken": FileBroken,
    "file_unsupported": FileUnsupported,
    "output_failed": OutputFailed,
}


def invalid(problem: str, remedy: str) -> InvalidParameter:
    """As the library makes them."""
    error = InvalidParameter(f"{problem}; {remedy}")
    error.problem, error.remedy = problem, remedy
    return error


def finish(error: Optional[BaseException], result: T) -> T:
    """`result`; or raises what a callback or a signal handler raised meanwhile, which carries it."""
    if error is None:
        return result
    try:
        error.result = result  # type: ignore[attr-defined]
    except AttributeError:
        pass  # an exception without room for it
    raise error


def made(error: Optional[BaseException], value: Optional[T]) -> T:
    """`value`; or raises what stopped its making."""
    if error is not None:
        raise error
    if value is None:
        raise KeyboardInterrupt("stopped before it was done")
    return value
