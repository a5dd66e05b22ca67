"""Compares striata with other packages: time, error and memory of one level and of ten levels.

    python benchmarks/peers.py MESH... [--repeat N] [--repeat-ten N] [--only NAME...] [--rust PROGRAM]

Each package simplifies each mesh to a share of its triangles, from arrays to arrays, conversion included. Ten
levels are 100 %, 90 %, ... 10 % of the triangles; packages that make one level at a time make each from the
full mesh. Runs of all packages alternate, so that a busy machine slows all of them down alike. Packages that
are not installed are left out. The error is the RMS distance by `striata.distance`, divided by the diagonal,
times 100,000. Peak memory is what a process of its own needs above the loaded mesh and package.

PROGRAM is the benchmark of the library without Python (`cargo bench -p striata-py --bench one_level --no-run`
prints its path); the overhead of the package is measured with it.
"""

from __future__ import annotations

import argparse
import importlib
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import striata

SHARES = [share / 10 for share in range(10, 0, -1)]


def by_striata(points, faces, ratio):
    return tuple(striata.simplify(points, faces, ratio=ratio))


def by_striata_optimal(points, faces, ratio):
    return tuple(striata.simplify(points, faces, ratio=ratio, placement="optimal"))


def levels_by_striata(points, faces):
    lod = striata.build(points, faces)
    return [level.to_mesh() for level in lod.levels(SHARES)]


def by_fast_simplification(points, faces, ratio):
    import fast_simplification

    return fast_simplification.simplify(points, faces, target_reduction=1 - ratio)


def poly_data(points, faces):
    import pyvista

    return pyvista.PolyData.from_regular_faces(points, faces)


def by_pyvista(points, faces, ratio):
    made = poly_data(points, faces).decimate(1 - ratio)
    return made.points, made.regular_faces


def by_pyvista_pro(points, faces, ratio):
    made = poly_data(points, faces).decimate_pro(1 - ratio)
    return made.points, made.regular_faces


def by_open3d(points, faces, ratio):
    import open3d

    vector = open3d.utility
    mesh = open3d.geometry.TriangleMesh(
        vector.Vector3dVector(points.astype(np.float64)), vector.Vector3iVector(faces)
    )
    made = mesh.simplify_quadric_decimation(int(ratio * len(faces)))
    return np.asarray(made.vertices), np.asarray(made.triangles)


def by_trimesh(points, faces, ratio):
    import trimesh

    mesh = trimesh.Trimesh(points, faces, process=False)
    made = mesh.simplify_quadric_decimation(face_count=int(ratio * len(faces)))
    return made.vertices, made.faces


def by_pymeshlab(points, faces, ratio):
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points, faces))
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=int(ratio * len(faces)))
    made = meshes.current_mesh()
    return made.vertex_matrix(), made.face_matrix()


#: Name, module that must be installed, and function for one level.
TOOLS = [
    ("striata", "striata", by_striata),
    ("striata, optimal placement", "striata", by_striata_optimal),
    ("fast-simplification", "fast_simplification", by_fast_simplification),
    ("PyVista decimate (VTK)", "pyvista", by_pyvista),
    ("PyVista decimate_pro (VTK)", "pyvista", by_pyvista_pro),
    ("Open3D", "open3d", by_open3d),
    ("trimesh", "trimesh", by_trimesh),
    ("pymeshlab", "pymeshlab", by_pymeshlab),
]


def ten_levels(name, tool, points, faces):
    if name == "striata":
        return levels_by_striata(points, faces)
    return [(points, faces), *(tool(points, faces, share) for share in SHARES[1:])]


def load(path):
    mesh = striata.open(path)
    mesh = mesh.flattened() if isinstance(mesh, striata.Scene) else mesh
    # Other packages do not merge equal points or drop unused ones, so all get the same clean mesh.
    points, faces = mesh.points, mesh.faces
    unique, inverse = np.unique(points, axis=0, return_inverse=True)
    faces = inverse.reshape(-1)[faces]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    used, faces = np.unique(faces, return_inverse=True)
    return np.ascontiguousarray(unique[used]), np.ascontiguousarray(faces.reshape(-1, 3).astype(np.int32))


def seconds(work):
    started = time.perf_counter()
    made = work()
    return time.perf_counter() - started, made


def peak_memory():
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) / 1024
    return float("nan")


def measure_memory(path, name, share):
    """Run one tool in this process, and print the memory that it needs above what was loaded, in MB."""
    tool = next(function for tool_name, _, function in TOOLS if tool_name == name)
    points, faces = load(path)
    small = striata.shapes.torus(16, 8)
    tool(*small, 0.5)  # loads the package
    Path("/proc/self/clear_refs").write_text("5")  # resets the peak
    before = peak_memory()
    tool(points, faces, share)
    print(peak_memory() - before)


def memory(path, name, share):
    command = [sys.executable, __file__, "--memory-of", name, "--share", str(share), path]
    run = subprocess.run(command, capture_output=True, text=True)
    return float(run.stdout.split()[-1]) if run.returncode == 0 else float("nan")


def rust_seconds(program, points, faces, triangles, repeat):
    with tempfile.TemporaryDirectory() as folder:
        files = [str(Path(folder) / name) for name in ("points", "faces")]
        points.astype("<f4").tofile(files[0])
        faces.astype("<u4").tofile(files[1])
        run = subprocess.run([program, *files, str(triangles), str(repeat)], capture_output=True, text=True, check=True)
    one, every = ([float(word) for word in line.split()] for line in run.stdout.splitlines())
    return one, every


def is_installed(module):
    try:
        importlib.import_module(module)
    except ImportError:
        return False
    return True


def table(path, arguments):
    points, faces = load(path)
    tools = [(name, tool) for name, module, tool in TOOLS if is_installed(module)]
    tools = [(name, tool) for name, tool in tools if name in (arguments.only or [name]) or name == "striata"]
    print(f"\n{Path(path).name}: {len(points):,} points, {len(faces):,} triangles\n", flush=True)
    one = {name: [] for name, _ in tools}
    ten = {name: [] for name, _ in tools}
    made = {}
    rust = []
    for _ in range(arguments.repeat):
        for name, tool in tools:
            took, made[name] = seconds(lambda: tool(points, faces, arguments.share))
            one[name].append(took)
        if arguments.rust:
            count = int(arguments.share * len(faces))
            rust.append(rust_seconds(arguments.rust, points, faces, count, 1))
    for _ in range(arguments.repeat_ten):
        for name, tool in tools:
            ten[name].append(seconds(lambda: ten_levels(name, tool, points, faces))[0])
    print("| package | one level, ms | ratio | ten levels, ms | ratio | triangles | RMS | memory, MB |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name, _ in tools:
        small = made[name]
        d = striata.distance((points, faces), (small[0], small[1]), samples=200_000)
        rms = d.rms / d.diagonal * 1e5
        cells = [
            name,
            spread(one[name]),
            ratio_of(one[name], one["striata"]),
            spread(ten[name]),
            ratio_of(ten[name], ten["striata"]),
            f"{len(small[1]):,}",
            f"{rms:.1f}",
            f"{memory(path, name, arguments.share):.0f}",
        ]
        print(f"| {' | '.join(cells)} |", flush=True)
    if rust:
        report_overhead(one["striata"], [run[0][0] for run in rust])


def ratio_of(times, reference):
    return f"{min(times) / min(reference):.2f}" if times and reference else "-"


def spread(times):
    """Best, and mean with standard deviation, in milliseconds."""
    if not times:
        return "-"
    milliseconds = [1000 * took for took in times]
    deviation = statistics.stdev(milliseconds) if len(milliseconds) > 1 else 0.0
    return f"{min(milliseconds):.0f} ({statistics.mean(milliseconds):.0f} ± {deviation:.0f})"


def report_overhead(python, rust):
    share = 100 * (min(python) / min(rust) - 1)
    print(f"\nOne level in Rust: {spread(rust)} ms; the package takes {share:+.1f} %.", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--repeat-ten", type=int, default=2)
    parser.add_argument("--only", nargs="+", help="names of the packages, besides striata")
    parser.add_argument("--share", type=float, default=0.1)
    parser.add_argument("--rust", help="program of the benchmark `one_level`")
    parser.add_argument("--memory-of", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.memory_of:
        measure_memory(arguments.meshes[0], arguments.memory_of, arguments.share)
        return
    versions = {module: getattr(importlib.import_module(module), "__version__", "") for _, module, _ in TOOLS if is_installed(module)}
    print(json.dumps(versions))
    for path in arguments.meshes:
        table(path, arguments)


if __name__ == "__main__":
    main()
