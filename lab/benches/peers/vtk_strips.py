"""VTK's vtkStripper, without a length limit. Usage: vtk_strips.py IN.triangles OUT.strips"""

import sys

import numpy
import triangle_list
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkStripper


def main(source, target):
    positions, corners = triangle_list.read(source)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=True))
    cells = vtkCellArray()
    offsets = numpy.arange(0, corners.size + 1, 3, dtype=numpy.int64)
    connectivity = corners.ravel().astype(numpy.int64)
    cells.SetData(*(numpy_to_vtkIdTypeArray(array, deep=True) for array in (offsets, connectivity)))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    mesh.BuildLinks()

    def run():
        stripper = vtkStripper()
        stripper.SetInputData(mesh)
        stripper.SetMaximumLength(100_000_000)
        stripper.Update()
        return stripper.GetOutput()

    milliseconds, out = triangle_list.timed(run, runs=5)
    strips = []
    # Triangles that it leaves become strips of one triangle.
    for cells in (out.GetStrips(), out.GetPolys()):
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        indices = vtk_to_numpy(cells.GetConnectivityArray())
        strips += [indices[a:b].tolist() for a, b in zip(offsets[:-1], offsets[1:])]
    triangle_list.write(target, milliseconds, strips)


main(*sys.argv[1:])
