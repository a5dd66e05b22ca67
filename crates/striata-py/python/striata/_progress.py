"""Progress of long calls: a bar of tqdm, or a callback."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

#: Called with the phase, the work done and all work, in units of the phase.
ProgressCallback = Callable[[str, int, int], object]

Progress = bool | ProgressCallback


@contextmanager
def reporting(progress: Progress) -> Iterator[ProgressCallback | None]:
    """Yield what the extension calls: nothing, the caller's function, or one that moves a bar."""
    if callable(progress):
        yield progress
    elif not progress:
        yield None
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield _to_stderr
            print(file=sys.stderr)
            return
        with tqdm(unit="", unit_scale=True, leave=False) as bar:
            yield lambda phase, done, total: _move(bar, phase, done, total)


def _move(bar: Any, phase: str, done: int, total: int) -> None:
    if bar.desc != f"{phase}: ":
        bar.set_description(phase, refresh=False)
        bar.reset(total=total)
    bar.total = total
    bar.update(done - bar.n)


def _to_stderr(phase: str, done: int, total: int) -> None:
    share = 100 * done // total if total else 0
    print(f"\r{phase}: {share:3d} %", end="", file=sys.stderr, flush=True)
