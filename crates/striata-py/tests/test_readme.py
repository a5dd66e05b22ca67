"""The examples of the README."""

import re
from pathlib import Path

import striata


def test_examples_run(terrain):
    text = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert blocks
    points, faces = terrain
    for block in blocks:
        names = {"points": points, "faces": faces, "mesh": striata.Mesh(points, faces)}
        exec(block, names)
        assert len(names["faces"]) <= 0.1 * len(faces)
