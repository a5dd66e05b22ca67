"""NvTriStrip, in PyFFI's port to Python (its times say nothing about the original's).

Usage: nvtristrip.py IN.triangles OUT.strips
"""

import random
import sys

import triangle_list
from pyffi.utils.tristrip import stripify

# Above this limit the port takes many minutes.
TRIANGLE_LIMIT = 200_000


def main(source, target):
    _, corners = triangle_list.read(source)
    if len(corners) > TRIANGLE_LIMIT:
        sys.exit(f"nvtristrip: {len(corners)} triangles would take the Python port too long")
    random.seed(0)
    triangles = [tuple(corner) for corner in corners.tolist()]
    milliseconds, strips = triangle_list.timed(lambda: stripify(triangles))
    triangle_list.write(target, milliseconds, strips)


main(*sys.argv[1:])
