"""Types: what a type checker infers for typed code that uses the package."""

import subprocess
import sys
from pathlib import Path

import pytest

CONSUMER = Path(__file__).with_name("typed_consumer.py")


def test_typed_code_passes_strict_checks(tmp_path):
    pytest.importorskip("mypy")
    # From another folder, so that the installed package is found as users find it.
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", CONSUMER]
    run = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
