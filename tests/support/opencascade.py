"""Files as OpenCASCADE, the kernel that most CAD programs share, reads them; imported only where it is installed."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Face:
    """One face of a file."""

    surface: object
    area: float
    shape: object

    @property
    def domain(self):
        u0, u1, v0, v1 = self.surface.Bounds()
        return (u0, u1), (v0, v1)

    def __call__(self, parameters):
        return np.array([[p.X(), p.Y(), p.Z()] for p in (self.surface.Value(u, v) for u, v in parameters)])


@dataclass
class Model:
    """What a file holds; edges and vertices that faces share are counted once."""

    is_valid: bool
    faces: list
    edges: int
    vertices: int
    shells: int
    roots: int


def read(path):
    from OCP.BRep import BRep_Tool
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.IGESControl import IGESControl_Reader
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopoDS import TopoDS

    reader = STEPControl_Reader() if path.suffix == ".step" else IGESControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone
    roots = reader.TransferRoots()
    shape = reader.OneShape()
    faces = []
    for found in parts(shape, TopAbs_ShapeEnum.TopAbs_FACE):
        face, properties = TopoDS.Face(found), GProp_GProps()
        BRepGProp.SurfaceProperties_s(face, properties, 1e-7)
        faces.append(Face(BRep_Tool.Surface_s(face), properties.Mass(), face))
    kinds = (TopAbs_ShapeEnum.TopAbs_EDGE, TopAbs_ShapeEnum.TopAbs_VERTEX, TopAbs_ShapeEnum.TopAbs_SHELL)
    counts = [len(parts(shape, kind)) for kind in kinds]
    return Model(BRepCheck_Analyzer(shape).IsValid(), faces, *counts, roots)


def parts(shape, kind):
    """Return the parts of a kind, each once."""
    from OCP.TopExp import TopExp_Explorer

    explorer, found = TopExp_Explorer(shape, kind), []
    while explorer.More():
        part = explorer.Current()
        if not any(part.IsSame(other) for other in found):
            found.append(part)
        explorer.Next()
    return found


def area(patch):
    """Return the area by Gauss-Legendre quadrature on 20 x 20 pieces."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    starts = np.arange(20) / 20
    t = (starts[:, None] + (nodes + 1) / 40).ravel()
    w = np.tile(weights / 40, 20)
    normals = np.cross(patch.derivative(t, t, 1, 0), patch.derivative(t, t, 0, 1))
    return float(w @ np.linalg.norm(normals, axis=-1) @ w)
