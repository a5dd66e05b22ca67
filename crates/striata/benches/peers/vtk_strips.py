"""VTK's vtkStripper, with strips as long as they come. Usage: vtk_strips.py IN.triangles OUT.strips"""

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
    rows = numpy.insert(corners.astype(numpy.int64), 0, 3, axis=1)
    cells.SetCells(len(corners), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
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
    # What it leaves as triangles becomes strips of one.
    for cells in (out.GetStrips(), out.GetPolys()):
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        indices = vtk_to_numpy(cells.GetConnectivityArray())
        strips += [indices[a:b].tolist() for a, b in zip(offsets[:-1], offsets[1:])]
    triangle_list.write(target, milliseconds, strips)


main(*sys.argv[1:])
