"""Plans of builds that are larger than memory."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path as _PathClass
from typing import Any

from . import _striata
from ._progress import Progress, reporting
from ._targets import number

Path = str | os.PathLike[str]


@dataclass(frozen=True)
class Simulation:
    """Time and size of a simulated build."""

    #: Seconds from the first task to the last.
    seconds: float
    #: Seconds of all workers with a task.
    core_seconds: float
    #: Number of tasks that were started, with those that failed.
    attempts: int
    #: Bytes of the work folder when it is largest.
    work_bytes: int
    #: Name, seconds, and share of the workers' time with a task, of each stage.
    stages: list[tuple[str, float, float]]


class Plan:
    """A build in tasks, as `plan` makes it. It is a folder on disk that all workers must see."""

    def __init__(self, data: _striata.PlanData) -> None:
        self._data = data

    @classmethod
    def open(cls, path: Path) -> Plan:
        """Open a plan by its folder or its file ``plan.json``.

        Raises
        ------
        OSError
            If it cannot be read.
        DecodeError
            If it is not a plan of this version.
        """
        return cls(_striata.PlanData.open(os.fspath(path)))

    @property
    def folder(self) -> _PathClass:
        """Folder of the plan and of everything that tasks pass to each other."""
        return _PathClass(self._data.folder)

    @property
    def output(self) -> _PathClass:
        """The paged file, or folder of pages, that is built."""
        return _PathClass(self._data.output)

    @property
    def triangle_count(self) -> int:
        """Number of triangles of the input."""
        return self._data.triangle_count

    @property
    def stages(self) -> list[tuple[str, list[int]]]:
        """Name and task numbers of each stage. A stage may begin when the stages before it are complete."""
        return self._data.stages()

    @property
    def task_count(self) -> int:
        """Number of tasks; they are numbered from 0."""
        return sum(len(tasks) for _, tasks in self.stages)

    @property
    def estimate(self) -> dict[str, int]:
        """Estimated ``work_bytes`` and ``result_bytes`` on disk, and the largest possible ``page_count``."""
        return dict(zip(("work_bytes", "result_bytes", "page_count"), self._data.estimate, strict=True))

    @property
    def is_finished(self) -> bool:
        """Whether the result is complete."""
        return self._data.is_finished

    def is_done(self, task: int) -> bool:
        """Whether a task has been run."""
        return self._data.is_done(task)

    def run_task(self, task: int) -> None:
        """Run one task. Running it again, or twice at once, gives the same bytes.

        Raises
        ------
        ValueError
            If the task does not exist, or an earlier stage is not complete.
        OSError
            If something cannot be read or written, such as on a full disk.
        """
        self._data.run_task(task)

    def simulate(self, workers: int, *, failing_share: float = 0.0, seed: int = 1) -> Simulation:
        """Run all tasks in simulated time.

        Parameters
        ----------
        workers : int
            Number of workers, each with one core.
        failing_share : float
            Share of the attempts that fail after a random part of their time and are repeated, 0 to 0.9.
        seed : int
            Seed of these failures.
        """
        if workers < 1:
            raise ValueError(f"workers is {workers}, but must be at least 1")
        if not 0.0 <= failing_share <= 0.9:
            raise ValueError(f"failing_share is {failing_share}, but must be from 0 to 0.9")
        return Simulation(*self._data.simulate(workers, failing_share, seed))

    def remove_work(self) -> None:
        """Remove the plan and everything that tasks passed to each other; the result stays."""
        self._data.remove_work()

    def __reduce__(self) -> tuple[Any, ...]:
        return (Plan.open, (str(self.folder),))

    def __repr__(self) -> str:
        state = "finished" if self.is_finished else f"{self.task_count} tasks"
        return f"<striata.Plan: {self.triangle_count:,} triangles, {state}, {self.output}>"


def plan(
    inputs: Path | Iterable[Path],
    output: Path,
    *,
    work: Path | None = None,
    cell: int = 65_536,
    exact: bool = False,
    weld_distance: float | None = None,
    allow_merging: bool = False,
    nodata: float | None = None,
    z_scale: float = 1.0,
    base: int | str | None = None,
    max_error: float | str | None = None,
    strict: bool = False,
    task_size: int = 16,
    normal_weight: float = 0.007,
    texcoord_weight: float = 0.02,
    color_weight: float = 0.003,
    progress: Progress = False,
) -> Plan:
    """Plan the build of a mesh that does not fit into memory.

    The inputs are read once. The plan is a folder; `run` runs its tasks, here or on a cluster.

    Parameters
    ----------
    inputs : path, pattern such as ``"scans/*.ply"``, or several of these
        Files that are one mesh.
    output : path
        Paged file to write; a path without extension becomes a folder with one object per page.
    work : path, optional
        Folder for the plan and for what tasks pass to each other, on a disk that all workers see. Default: the
        output with ``.work`` appended.
    cell : int
        Triangles per page.
    exact : bool
        Keep positions and attributes bit for bit instead of rounding them to 1/256 of an edge.
    weld_distance : float, optional
        Join files whose borders differ by less than this, in mesh units.
    allow_merging : bool
        Build even if rounding positions merges more than one in a thousand vertices.
    nodata : float, optional
        Sample of a raster that stands for no height, besides the one that the file names.
    z_scale : float
        Factor on the heights of a terrain.
    base : int or str, optional
        Triangles of the base mesh, or a share of those of the input such as ``"1%"``. Default: as few as possible.
    max_error : float or str, optional
        Largest error of a level in mesh units, or a share of the diagonal such as ``"0.1%"``. It is an estimate.
    strict : bool
        Fail if `base` cannot be reached.
    task_size : int
        Cells per task. A cell takes about an eighth of a second.
    normal_weight, texcoord_weight, color_weight : float
        Weights of attributes, as in `build`.
    progress : bool or callable
        Show a bar, or call with phase, work done and all work.

    Returns
    -------
    Plan

    Raises
    ------
    OSError
        If an input cannot be read, or the folder cannot be written.
    DecodeError
        If an input is damaged.
    ValueError
        If an option is out of range or no file matches.
    """
    output = os.path.abspath(os.fspath(output))
    folder = os.path.abspath(os.fspath(work)) if work is not None else output + ".work"
    options = {
        "cell": cell,
        "exact": exact,
        "weld_distance": weld_distance,
        "allow_merging": allow_merging,
        "nodata": nodata,
        "z_scale": z_scale,
        "task_size": task_size,
        "weights": (normal_weight, texcoord_weight, color_weight),
        "base": _limit(base, "base"),
        "max_error": _limit(max_error, "max_error"),
        "strict": strict,
    }
    with reporting(progress) as report:
        data = _striata.PlanData.make(_files(inputs), (output, folder), options, report)
    return Plan(data)


def _limit(value: float | str | None, name: str) -> tuple[float, bool] | None:
    """Return a number, and whether it is a share, from a number or text such as ``"1%"``."""
    if value is None:
        return None
    if isinstance(value, str) and value.strip().endswith("%"):
        return number(value.strip()[:-1], name) / 100, True
    return number(value, name), False


def _files(inputs: Path | Iterable[Path]) -> list[str]:
    """All files that paths and patterns name, patterns in sorted order."""
    given: list[Path] = [inputs] if isinstance(inputs, (str, os.PathLike)) else list(inputs)
    files: list[str] = []
    for path in [os.fspath(one) for one in given]:
        if path.startswith("shape:"):
            files.append(path)
        elif glob.has_magic(path) and not os.path.exists(path):
            found = sorted(glob.glob(path))
            if not found:
                raise ValueError(f"no file matches {path}")
            files.extend(os.path.abspath(file) for file in found)
        else:
            files.append(os.path.abspath(path))
    if not files:
        raise ValueError("no input")
    return files
