"""Runs fast-simplification's own tests with striata behind its function names.

    python compat/run_peer_tests.py [FOLDER]

FOLDER contains the tests; by default they come from the last source distribution on PyPI that has tests.
Needs striata, pytest and pyvista.
"""

import os
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

#: The last release whose source distribution contains the tests.
RELEASE = "fast-simplification==0.1.12"

#: Tests that cannot pass, with the reason.
CANNOT_PASS = {
    "test_simplify_agg": "`agg` trades quality for speed in a loop over thresholds, which striata does not have",
    "test_simplify_trivial": "expects exactly 5 points of a flat square at 4 triangles; striata keeps 6, as flat",
    "test_collapses_louis": "downloads a mesh from a network",
    "test_human": "downloads a mesh from a network",
}



def download(folder):
    """Fetch the tests from PyPI; return their folder."""
    options = ["--quiet", "--no-deps", "--no-binary", "fast-simplification", "--dest", folder]
    subprocess.run([sys.executable, "-m", "pip", "download", *options, RELEASE], check=True)
    with tarfile.open(next(Path(folder).glob("*.tar.gz"))) as archive:
        archive.extractall(folder, filter="data")
    return next(Path(folder).glob("*/tests"))


def run(tests):
    """Run the tests; return the exit status of pytest."""
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parent)}
    for name, reason in CANNOT_PASS.items():
        print(f"left out: {name}: {reason}", flush=True)
    without = " and ".join(f"not {name}" for name in CANNOT_PASS)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", without, str(tests)]
    return subprocess.run(command, env=environment, cwd=tests).returncode


if len(sys.argv) > 1:
    sys.exit(run(Path(sys.argv[1]).resolve()))
with tempfile.TemporaryDirectory() as temporary:
    sys.exit(run(download(temporary)))
