"""Time the same build on one and on two Dask workers, and compare the bytes.

    python crates/striata-py/benchmarks/dask_workers.py --side 3001 --repeat 2
"""

import argparse
import tempfile
import time

import striata
from distributed import Client, LocalCluster


def build(side, workers):
    """Seconds and bytes of one build with the tasks of a terrain."""
    with tempfile.TemporaryDirectory() as folder:
        plan = striata.plan(f"shape:terrain:{side}", f"{folder}/terrain.striata", task_size=8)
        cluster = LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None)
        with cluster, Client(cluster) as client:
            started = time.perf_counter()
            striata.run(plan, executor=client)
            return time.perf_counter() - started, plan.output.read_bytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=3001)
    parser.add_argument("--repeat", type=int, default=2)
    options = parser.parse_args()
    expected = None
    for _ in range(options.repeat):
        (one, first), (two, second) = (build(options.side, workers) for workers in (1, 2))
        expected = expected or first
        assert first == second == expected, "the bytes differ"
        print(f"1 worker {one:.1f} s, 2 workers {two:.1f} s: {one / two:.2f} times as fast", flush=True)


if __name__ == "__main__":
    main()
