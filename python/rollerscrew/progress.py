"""How far long work is."""

from __future__ import annotations

import sys
from collections.abc import Callable

#: Called with what is done and with all of it; True: a line on a terminal or in a notebook; None:
#: quiet.
Progress = Callable[[int, int], object] | bool | None


def progress_callback(progress: Progress) -> Callable[[int, int], object] | None:
    """The function to call; nothing where nobody would see it."""
    if callable(progress):
        return progress
    if not (progress is None or isinstance(progress, bool)):
        raise TypeError(f"progress: got {progress!r}; expected a function, True, or nothing")
    if progress and (sys.stderr.isatty() or _in_notebook()):
        return _show_line
    return None


def _in_notebook() -> bool:
    """Whether this process is a notebook's kernel; who merely imported its library is none."""
    kernel = getattr(sys.modules.get("ipykernel.kernelapp"), "IPKernelApp", None)
    return kernel is not None and bool(kernel.initialized())


def _show_line(done: int, total: int) -> None:
    end = "\n" if done >= total else ""
    print(f"\r{done} of {total} designs", end=end, file=sys.stderr, flush=True)
