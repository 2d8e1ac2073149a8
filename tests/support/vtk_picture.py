"""Draw a STEP file with OpenCASCADE's own triangles and VTK's renderer: ``python vtk_picture.py IN.step OUT.png``."""

import sys
import tempfile
from pathlib import Path

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  VTK finds its renderer by this import
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.STEPControl import STEPControl_Reader
from OCP.StlAPI import StlAPI_Writer
from vtkmodules.vtkFiltersCore import vtkElevationFilter, vtkPolyDataNormals
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

DEFLECTION = 0.002
PAPERS_VIEW = (-8.0, -12.0, 9.0)


def triangulate(step, stl):
    reader = STEPControl_Reader()
    reader.ReadFile(str(step))
    reader.TransferRoots()
    shape = reader.OneShape()
    BRepMesh_IncrementalMesh(shape, DEFLECTION, False, 0.1, False)
    StlAPI_Writer().Write(shape, str(stl))


def draw(stl, png):
    reader = vtkSTLReader()
    reader.SetFileName(str(stl))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.Update()
    bounds = normals.GetOutput().GetBounds()
    heights = vtkElevationFilter()
    heights.SetInputConnection(normals.GetOutputPort())
    heights.SetLowPoint(0, 0, bounds[4])
    heights.SetHighPoint(0, 0, bounds[5])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(heights.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(900, 700)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetViewUp(0, 0, 1)
    camera.SetPosition(*PAPERS_VIEW)
    camera.SetFocalPoint(*((bounds[k] + bounds[k + 1]) / 2 for k in (0, 2, 4)))
    renderer.ResetCamera()
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(str(png))
    writer.Write()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        triangulate(Path(sys.argv[1]), Path(folder) / "a.stl")
        draw(Path(folder) / "a.stl", Path(sys.argv[2]))
