"""Runs plans: here, or on any executor."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from os import cpu_count
from typing import Any

from ._plan import Path, Plan
from ._progress import Progress, reporting

#: Runs tasks of a stage and yields the number of each when it is done.
_Runner = Callable[[str, list[int]], Iterator[int]]


def run(plan: Plan | Path, *, executor: Any = None, progress: Progress = False) -> Plan:
    """Run all tasks of a plan that have not been run.

    The result is the same for every executor and number of workers. If a task fails, its error is raised when
    the other tasks that have begun are done; a later call goes on from there.

    Parameters
    ----------
    plan : Plan or path
        What `plan` returned, or its folder.
    executor : optional
        ``dask.distributed.Client``, any ``concurrent.futures.Executor``, or the module ``ray``. Default: threads
        of this process, one per core. Workers of other machines must see the folders of the plan, the inputs and
        the output under the same paths.
    progress : bool or callable
        Show a bar, or call with phase, tasks done and all tasks.

    Returns
    -------
    Plan

    Raises
    ------
    OSError
        If something cannot be read or written, such as on a full disk.
    TypeError
        If the executor is of no known kind.
    """
    plan = plan if isinstance(plan, Plan) else Plan.open(plan)
    if executor is None:
        with ThreadPoolExecutor(cpu_count() or 1) as pool:
            return _run_stages(plan, _of_futures(pool), progress)
    return _run_stages(plan, _runner_of(executor), progress)


def _run_stages(plan: Plan, runner: _Runner, progress: Progress) -> Plan:
    total, done = plan.task_count, 0
    with reporting(progress) as report:
        for name, tasks in plan.stages:
            open_tasks = [task for task in tasks if not plan.is_done(task)]
            done += len(tasks) - len(open_tasks)
            for _ in runner(str(plan.folder), open_tasks):
                done += 1
                if report is not None:
                    report(name, done, total)
    return plan


def run_task(folder: str, task: int) -> int:
    """Run one task in a worker, and return its number."""
    Plan.open(folder).run_task(task)
    return task


def _runner_of(executor: Any) -> _Runner:
    if isinstance(executor, Executor):
        return _of_futures(executor)
    if hasattr(executor, "submit") and hasattr(executor, "scheduler_info"):
        return _of_dask(executor)
    if getattr(executor, "__name__", "") == "ray":
        return _of_ray(executor)
    kind = type(executor).__name__
    raise TypeError(f"executor is a {kind}; pass a dask.distributed.Client, a concurrent.futures.Executor or ray")


def _of_futures(executor: Executor) -> _Runner:
    def results(folder: str, tasks: list[int]) -> Iterator[int]:
        futures: set[Future[int]] = {executor.submit(run_task, folder, task) for task in tasks}
        error: BaseException | None = None
        while futures:
            finished, futures = wait(futures, return_when=FIRST_COMPLETED)
            for future in finished:
                if future.cancelled():
                    continue
                if future.exception() is None:
                    yield future.result()
                elif error is None:
                    error = future.exception()
                    for other in futures:
                        other.cancel()
        if error is not None:
            raise error

    return results


def _of_dask(client: Any) -> _Runner:
    from distributed import as_completed

    def results(folder: str, tasks: list[int]) -> Iterator[int]:
        # Tasks write files, so that equal calls are not pure: each is run, on another worker if one dies.
        futures = [client.submit(run_task, folder, task, pure=False, retries=2) for task in tasks]
        try:
            for future in as_completed(futures):
                yield future.result()
        finally:
            client.cancel(futures)

    return results


def _of_ray(ray: Any) -> _Runner:
    def results(folder: str, tasks: Iterable[int]) -> Iterator[int]:
        remote = ray.remote(max_retries=2)(run_task)
        waiting = [remote.remote(folder, task) for task in tasks]
        while waiting:
            finished, waiting = ray.wait(waiting, num_returns=1)
            for done in finished:
                yield ray.get(done)

    return results
