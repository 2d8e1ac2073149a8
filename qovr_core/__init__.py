"""Quartic Overhauser (QOVR) surfaces: documents, their exact patches, and the paper's pipeline.

``configure(document)`` runs the whole pipeline. Importing this package loads NumPy and nothing else;
files, figures and the command line live in ``qovr_core.files``, ``qovr_core.figures`` and ``qovr_core.cli``.

>>> net = [[[j, i, i * j / 4] for j in range(5)] for i in range(5)]
>>> surface = configure(Document(net, formulation="interpolating", samples=(3, 3)))
>>> surface.raw[0, 0], surface.raw[-1, -1]  # P_{1,1} and P_{3,3}: points are indexed [iu, iv]
(array([1.  , 1.  , 0.25]), array([3.  , 3.  , 2.25]))
>>> surface.matrix[0].round(9)  # T, which stretches x from 1..3 onto the control points' 0..4
array([ 2.,  0.,  0., -2.])

An odd number of rows and of columns, 5 or more, makes a net of several windows; only under ``interpolating`` do these
meet. The surface runs through all points but the outermost ring, which shapes its edges: a grid of data gets one.

>>> import numpy as np
>>> y, x = np.mgrid[:21, :31]
>>> heights = np.sin(x / 5) * np.cos(y / 4)  # or np.loadtxt("heights.csv", delimiter=",")
>>> data = np.stack([x, y, heights], axis=-1)
>>> net = np.pad(data, ((1, 1), (1, 1), (0, 0)), mode="reflect", reflect_type="odd")
>>> document = Document(net, formulation="interpolating", samples=(10 * 30 + 1, 10 * 20 + 1))
>>> document.windows  # along v and along u
(10, 15)
>>> surface = configure(document)
>>> bool(np.allclose(surface.raw[::10, ::10].swapaxes(0, 1), data))
True

``qovr_core.structure.resampling.resample`` runs a net of other windows through a surface:

>>> from qovr_core.structure.resampling import resample
>>> change = resample(surface.patch, (5, 8))
>>> change.document.control_points.shape, change.motion < 0.01  # the largest distance between the two surfaces
((13, 19, 3), True)

``qovr_core.files.write_document(document, path)`` saves a ``.qovr`` file, which the editor and all commands open, and
``qovr_core.files.export(document, path)`` writes any other format.
"""

from qovr_core.construction import CurveNetwork, build_patch, curve_network
from qovr_core.document import Document
from qovr_core.errors import DocumentError, EvaluationError, FileError, QovrError, SourceError
from qovr_core.evaluation import Evaluation, configure
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.differential import Curvature, ParametricSurface
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.patch import Patch
from qovr_core.layer import Layer

__all__ = [
    "FORMULATIONS",
    "Curvature",
    "CurveNetwork",
    "Document",
    "DocumentError",
    "Edge",
    "Evaluation",
    "EvaluationError",
    "FileError",
    "Formulation",
    "Knots",
    "Layer",
    "ParametricSurface",
    "Patch",
    "QovrError",
    "SourceError",
    "build_patch",
    "configure",
    "curve_network",
]
