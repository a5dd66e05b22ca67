"""The two formats of list.hpp, for peers called from Python."""

import struct
import sys
import time

import numpy

RESTART = 0xFFFFFFFF


def read(path):
    """Reads the positions (n, 3) and corners (m, 3) of a triangle list."""
    with open(path, "rb") as file:
        data = file.read()
    if len(data) < 8:
        sys.exit(f"{path} is not a triangle list")
    vertex_count, triangle_count = struct.unpack_from("<2I", data)
    if len(data) != 8 + 12 * (vertex_count + triangle_count):
        sys.exit(f"{path} is not a triangle list, or is truncated")
    positions = numpy.frombuffer(data, "<f4", 3 * vertex_count, 8).reshape(-1, 3)
    corners = numpy.frombuffer(data, "<u4", 3 * triangle_count, 8 + 12 * vertex_count).reshape(-1, 3)
    return positions, corners


def write(path, milliseconds, strips):
    """Writes strips as one list of indices with restarts."""
    indices = []
    for strip in strips:
        if indices:
            indices.append(RESTART)
        indices.extend(strip)
    with open(path, "wb") as file:
        file.write(struct.pack("<dI", milliseconds, len(indices)))
        file.write(numpy.asarray(indices, "<u4").tobytes())


def timed(work, runs=1):
    """Returns the fastest of some runs in milliseconds, and the result of the last one."""
    best = float("inf")
    for _ in range(runs):
        start = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - start)
    return 1e3 * best, result
