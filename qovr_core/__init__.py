"""Quartic Overhauser (QOVR) surfaces: documents, their exact patches, and the paper's pipeline.

``configure(document)`` runs the whole pipeline. Importing this package loads NumPy and nothing else;
files, figures and the command line live in ``qovr_core.files``, ``qovr_core.figures`` and ``qovr_core.cli``.
"""

from qovr_core.construction import CurveNetwork, build_patch, curve_network
from qovr_core.document import Document
from qovr_core.errors import DocumentError, EvaluationError, FileError, QovrError, SourceError
from qovr_core.evaluation import AlignedPatch, Surface, align_patch, configure
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.differential import Curvature, ParametricSurface
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.patch import Edge, Patch
from qovr_core.layer import Layer

__all__ = [
    "FORMULATIONS",
    "AlignedPatch",
    "Curvature",
    "CurveNetwork",
    "Document",
    "DocumentError",
    "Edge",
    "EvaluationError",
    "FileError",
    "Formulation",
    "Knots",
    "Layer",
    "ParametricSurface",
    "Patch",
    "QovrError",
    "SourceError",
    "Surface",
    "align_patch",
    "build_patch",
    "configure",
    "curve_network",
]
