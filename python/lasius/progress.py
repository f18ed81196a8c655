"""Progress in a terminal and in a notebook."""

from __future__ import annotations

import contextlib
import sys
import time
from typing import Any, Callable, Iterator, Optional, TextIO, Union

from .parameters import ParameterSet

Receiver = Callable[[int, int, str], Any]
Shown = Union[None, bool, Receiver]


class TerminalBar:
    """A line that is drawn over and over; nothing where the stream is no terminal."""

    WIDTH = 30

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream if stream.isatty() else None
        self._next = 0.0

    def __call__(self, done: int, total: int, text: str) -> None:
        now = time.monotonic()
        if self._stream is None or (now < self._next and done < total):
            return
        self._next = now + 0.1
        filled = self.WIDTH * done // max(total, 1)
        bar = "#" * filled + "." * (self.WIDTH - filled)
        self._stream.write(f"\r\033[K[{bar}] {done}/{total} {text}")
        self._stream.flush()

    def close(self) -> None:
        if self._stream is not None:
            self._stream.write("\r\033[K")
            self._stream.flush()


class NotebookBar:
    """A bar below the cell, updated in place."""

    def __init__(self) -> None:
        self._handle: Any = None
        self._next = 0.0

    def __call__(self, done: int, total: int, text: str) -> None:
        now = time.monotonic()
        if now < self._next and done < total:
            return
        self._next = now + 0.2
        from IPython.display import HTML, display

        page = HTML(f'<progress value="{done}" max="{total}"></progress> {done}/{total} {text}')
        if self._handle is None:
            self._handle = display(page, display_id=True)
        else:
            self._handle.update(page)

    def close(self) -> None:
        """It stays where it is."""


def in_notebook() -> bool:
    """True below a kernel that shows HTML."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return shell is not None and getattr(shell, "kernel", None) is not None


def receiver(progress: Shown) -> Any:
    """What is called with (done, all, text), or None."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return NotebookBar() if in_notebook() else TerminalBar(sys.stderr)
    return progress


class Watch:
    """The one observer of a plan: the caller's, and what shows its progress."""

    def __init__(self, observer: Optional[Callable[[Any], Any]], show: Receiver, params: ParameterSet) -> None:
        self._observer = observer
        self._show = show
        self._total = int(getattr(params, "iterations", 0))

    def __call__(self, seen: Any) -> None:
        if self._observer is not None:
            self._observer(seen)
        done = seen.iteration + 1
        self._show(done, max(self._total, done), f"length {seen.best_length:.6g}")


def close(show: Any) -> None:
    """Ends a bar; a function of the caller's is left."""
    if hasattr(show, "close"):
        show.close()


@contextlib.contextmanager
def watched(
    observer: Optional[Callable[[Any], Any]], progress: Shown, params: ParameterSet
) -> Iterator[Optional[Callable[[Any], Any]]]:
    """The caller's observer; with progress a Watch."""
    show = receiver(progress)
    try:
        yield observer if show is None else Watch(observer, show, params)
    finally:
        close(show)


@contextlib.contextmanager
def counted(progress: Shown, total: int) -> Iterator[Optional[Callable[[int], Any]]]:
    """What a batch calls with the number of its answers."""
    show = receiver(progress)
    try:
        yield None if show is None else lambda done: show(done, total, "answers")
    finally:
        close(show)
