"""Builds in tasks, on threads, processes and a real local Dask cluster."""

import os
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context

import pytest
import striata
from distributed import Client, LocalCluster, Nanny

INPUT = "shape:terrain:260"
OPTIONS = {"cell": 4000, "task_size": 4}


def make(folder, name="terrain.striata", **options):
    return striata.plan(INPUT, folder / name, **{**OPTIONS, **options})


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Bytes that one thread builds."""
    plan = make(tmp_path_factory.mktemp("expected"))
    for _, tasks in plan.stages:
        for task in tasks:
            plan.run_task(task)
    assert plan.is_finished
    return plan.output.read_bytes()


@pytest.fixture
def cluster():
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        yield cluster, client


def test_a_plan_says_what_it_needs(tmp_path):
    plan = make(tmp_path)
    assert plan.triangle_count == 2 * 259 * 259
    names = [name for name, _ in plan.stages]
    assert names[0] == "sort" and names[-2:] == ["encode", "write"] and "simplify level 0" in names
    assert [task for _, tasks in plan.stages for task in tasks] == list(range(plan.task_count))
    assert plan.estimate["work_bytes"] > plan.estimate["result_bytes"] > 0
    assert "tasks" in repr(plan) and not plan.is_finished and not plan.output.exists()
    with pytest.raises(ValueError, match="needs the result of task 0"):
        plan.run_task(plan.task_count - 1)
    with pytest.raises(ValueError, match="does not exist"):
        plan.run_task(plan.task_count)


def test_the_base_mesh_is_limited(tmp_path):
    def base_of(name, **options):
        plan = striata.run(make(tmp_path, f"{name}.striata", **options))
        return striata.open(plan.output).level(triangles=1).face_count

    full = 2 * 259 * 259
    assert 690 <= base_of("a", base=700) <= 700
    assert 0.009 * full <= base_of("b", base="1%") <= 0.01 * full
    assert base_of("c", max_error="0.01%") > base_of("d", max_error="1%") > 0
    for options, name in [({"base": -1}, "base"), ({"max_error": "much"}, "max_error")]:
        with pytest.raises(ValueError, match=name):
            make(tmp_path, "no.striata", **options)


def test_a_plan_is_simulated(tmp_path):
    plan = make(tmp_path)
    one, four = plan.simulate(1), plan.simulate(4)
    assert one.attempts == plan.task_count
    assert one.seconds == pytest.approx(one.core_seconds) and four.seconds < one.seconds
    assert [name for name, _, _ in four.stages] == [name for name, _ in plan.stages]
    failing = plan.simulate(4, failing_share=0.3, seed=2)
    assert failing.attempts > plan.task_count and failing == plan.simulate(4, failing_share=0.3, seed=2)
    with pytest.raises(ValueError, match="workers is 0"):
        plan.simulate(0)
    with pytest.raises(ValueError, match="failing_share is 1"):
        plan.simulate(1, failing_share=1.0)


def test_bad_arguments_are_named(tmp_path):
    with pytest.raises(ValueError, match="no file matches"):
        striata.plan(tmp_path / "*.ply", tmp_path / "a.striata")
    with pytest.raises(FileNotFoundError):
        striata.plan(tmp_path / "missing.ply", tmp_path / "a.striata")
    with pytest.raises(ValueError, match="cell is 3"):
        striata.plan(INPUT, tmp_path / "a.striata", cell=3)
    with pytest.raises(TypeError, match="executor is a str"):
        striata.run(make(tmp_path), executor="dask")
    with pytest.raises(FileNotFoundError):
        striata.run(tmp_path / "no.work")


@pytest.mark.parametrize("kind", ["none", "threads", "processes"])
def test_executors_give_the_same_bytes(tmp_path, expected, kind):
    plan = make(tmp_path)
    steps = []
    report = lambda *step: steps.append(step)  # noqa: E731
    if kind == "none":
        striata.run(plan, progress=report)
    elif kind == "threads":
        with ThreadPoolExecutor(3) as pool:
            striata.run(plan, executor=pool, progress=report)
    else:
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
            striata.run(plan.folder, executor=pool, progress=report)
    assert plan.output.read_bytes() == expected
    assert [done for _, done, _ in steps] == list(range(1, plan.task_count + 1))
    plan.remove_work()
    assert not plan.folder.exists() and plan.output.exists()


def test_a_cluster_gives_the_same_bytes(tmp_path, expected, cluster):
    plan = striata.run(make(tmp_path), executor=cluster[1])
    assert plan.is_finished and plan.output.read_bytes() == expected


def test_a_killed_worker_is_replaced(tmp_path, expected, cluster):
    cluster, client = cluster
    plan = make(tmp_path, task_size=1)

    def kill():
        while not any(plan.is_done(task) for task in range(plan.task_count)):
            time.sleep(0.01)
        worker = next(iter(cluster.workers.values()))
        assert isinstance(worker, Nanny)
        os.kill(worker.pid, 9)

    killer = threading.Thread(target=kill)
    killer.start()
    striata.run(plan, executor=client)
    killer.join()
    # Tasks of another size are other tasks, but the bytes are the same.
    assert plan.output.read_bytes() == expected


def slow_task(folder, task):
    time.sleep(1.0)
    return striata._run.run_task(folder, task)


def test_a_slow_worker_and_tasks_run_twice_at_once(tmp_path, expected, cluster):
    plan = make(tmp_path)
    client = cluster[1]
    first = plan.stages[0][1]
    slow = client.map(slow_task, [str(plan.folder)] * len(first), first, pure=False)
    striata.run(plan, executor=client)
    client.gather(slow)
    assert plan.output.read_bytes() == expected
    # Everything again, by two processes at once.
    program = (
        "import sys, striata; plan = striata.Plan.open(sys.argv[1]); "
        "[plan.run_task(task) for _, tasks in plan.stages for task in tasks]"
    )
    arguments = [sys.executable, "-c", program, str(plan.folder)]
    for process in [subprocess.Popen(arguments) for _ in range(2)]:
        assert process.wait() == 0
    assert plan.output.read_bytes() == expected


def test_a_restarted_scheduler_goes_on(tmp_path, expected):
    plan = make(tmp_path, task_size=1)
    stop_after = plan.task_count // 3

    class Stop(Exception):
        pass

    def stop(_name, done, _total):
        if done >= stop_after:
            raise Stop

    with (
        LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
        pytest.raises(Stop),
    ):
        striata.run(plan, executor=client, progress=stop)
    assert not plan.output.exists()
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        striata.run(plan.folder, executor=client)
    assert plan.output.read_bytes() == expected


@pytest.mark.skipif(sys.platform != "linux", reason="limits sizes of files")
def test_a_full_disk_leaves_nothing_half_visible(tmp_path, expected):
    plan = make(tmp_path)
    program = (
        "import resource, signal, sys, striata; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); "
        "resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000)); striata.run(sys.argv[1])"
    )
    done = subprocess.run([sys.executable, "-c", program, str(plan.folder)], capture_output=True, text=True)
    assert done.returncode != 0 and "File too large" in done.stderr and str(plan.folder) in done.stderr
    assert not plan.output.exists()
    assert not [path for path in plan.folder.iterdir() if path.name.startswith(".part-")]
    striata.run(plan)
    assert plan.output.read_bytes() == expected
