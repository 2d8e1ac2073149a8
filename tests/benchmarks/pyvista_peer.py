"""PyVista as the peer of an edit: at each line that comes it moves a point of the paper's net, evaluates the surface by
this library, draws all samples again, and answers when the frame is finished.

    python -m benchmarks.pyvista_peer SAMPLES ANTIALIASING
"""

import sys

import numpy as np
import pyvista

from qovr_core.evaluation import Evaluation

from .peers import SIZE, moved_samples, regular_document


def triangles(n):
    """Return two triangles a cell of n x n samples, (k, 3)."""
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def main(size, antialiasing):
    document = regular_document(size)
    mesh = pyvista.PolyData.from_regular_faces(Evaluation(document).raw.reshape(-1, 3), triangles(size))
    mesh["height"] = mesh.points[:, 2]
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    if antialiasing == "none":
        plotter.disable_anti_aliasing()
    plotter.add_mesh(mesh, scalars="height", lighting=False, show_scalar_bar=False)
    plotter.show(auto_close=False, interactive=False)
    for k, _ in enumerate(sys.stdin):
        mesh.points = moved_samples(document, k).reshape(-1, 3)
        mesh["height"] = mesh.points[:, 2]
        plotter.render()
        plotter.render_window.WaitForCompletion()
        print("drawn", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2])
