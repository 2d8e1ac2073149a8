"""What is measured, beside what, and the goal it is held against: a record a line, and no goal stands elsewhere."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Goal:
    """One line of the table.

    Parameters
    ----------
    key : by which a benchmark reports
    what : what is measured
    peer : what stands beside it; empty where the figure itself is held against the limit
    direction : ``<=`` for ours over the peer, at most the limit; ``>=`` for the peer over ours, at least the limit
    limit : the goal; None where the line only informs
    unit : of the figure and of the peer's: ms, s or min where it is a time
    is_long : measured by ``make bench-long``: its test carries the marker ``long``
    """

    key: str
    what: str
    peer: str = ""
    direction: str = "<="
    limit: float | None = None
    unit: str = "ms"
    is_long: bool = False

    def value(self, figure, peer):
        """Return what is held against the limit: the ratio, or the figure where nothing stands beside it."""
        if not self.peer:
            return figure
        return peer / figure if self.direction == ">=" else figure / peer

    def is_met(self, value):
        """Return whether a value keeps the limit; None where there is none."""
        if self.limit is None:
            return None
        return value >= self.limit if self.direction == ">=" else value <= self.limit


WRITERS = {".obj": "trimesh", ".stl": "trimesh", ".ply": "trimesh", ".glb": "trimesh", ".npz": "NumPy", ".mat": "SciPy"}
"""The libraries that write the same files."""

ROWS = (
    # Evaluation
    Goal("raw/copy 101", "raw samples, 101 x 101, fresh array", "np.copyto"),
    Goal("raw/copy 501", "raw samples, 501 x 501, fresh array", "np.copyto"),
    Goal("raw/copy 1001", "raw samples, 1001 x 1001, fresh array", "np.copyto", "<=", 2),
    Goal("raw/copy 2001", "raw samples, 2001 x 2001, fresh array", "np.copyto"),
    Goal("out/matmul 1001", "raw samples, 1001 x 1001, given array", "blocked np.matmul", "<=", 1.1),
    Goal("out/matmul 2001", "raw samples, 2001 x 2001, given array", "blocked np.matmul", "<=", 1.1),
    Goal("out/copy 1001", "raw samples, 1001 x 1001, given array", "np.copyto"),
    Goal("out/copy 2001", "raw samples, 2001 x 2001, given array", "np.copyto"),
    Goal("splipy 101", "raw samples, 101 x 101, fresh array", "Splipy", ">="),
    Goal("splipy 501", "raw samples, 501 x 501, fresh array", "Splipy", ">="),
    Goal("splipy 1001", "raw samples, 1001 x 1001, fresh array", "Splipy", ">=", 2),
    Goal("splipy 2001", "raw samples, 2001 x 2001, fresh array", "Splipy", ">="),
    Goal("scipy 101", "raw samples, 101 x 101, fresh array", "SciPy NdBSpline", ">="),
    Goal("scipy 501", "raw samples, 501 x 501, fresh array", "SciPy NdBSpline", ">="),
    Goal("scipy 1001", "raw samples, 1001 x 1001, fresh array", "SciPy NdBSpline", ">=", 50),
    Goal("scipy grid 1001", "raw samples, 1001 x 1001, fresh array", "SciPy BSpline, u then v", ">="),
    Goal("algorithm 1", "raw samples, 31 x 31", "Algorithm 1 as printed", ">=", 2000),
    Goal("time per point", "time per point, slowest of 501 to 4096", "the fastest", "<=", 1.5, "ns"),
    Goal("configure/copy", "raw, T and transformed, 1001 x 1001", "np.copyto", "<=", 6),
    Goal("configure/splipy", "raw, T and transformed, 101 x 101", "Splipy, samples alone", "<=", 3),
    Goal("configure memory 1001", "peak memory of configure, 1001 x 1001", "its results", "<=", 1.25, "MB"),
    Goal("configure memory 4096", "peak memory of configure, 4096 x 4096", "its results", "<=", 1.25, "MB"),
    # Boxes and T
    Goal("box/all 101", "box of the samples, 101 x 101", "box of all samples", "<=", 1),
    Goal("box/all 501", "box of the samples, 501 x 501", "box of all samples", "<=", 1),
    Goal("box/all 1001", "box of the samples, 1001 x 1001", "box of all samples", "<=", 1),
    Goal("box/all 2001", "box of the samples, 2001 x 2001", "box of all samples", "<=", 1),
    Goal("box/all 4096", "box of the samples, 4096 x 4096", "box of all samples", "<=", 1),
    Goal("box/screen 1001", "box of the samples, 1001 x 1001", "201 x 201 points of the screen"),
    Goal("box/screen 4096", "box of the samples, 4096 x 4096", "201 x 201 points of the screen"),
    Goal("box ridge 101", "box of an oblique ridge, 101 x 101", "", "<=", 1),
    Goal("box ridge 501", "box of an oblique ridge, 501 x 501", "", "<=", 1),
    Goal("box ridge 1001", "box of an oblique ridge, 1001 x 1001", "", "<=", 1),
    Goal("box ridge 2001", "box of an oblique ridge, 2001 x 2001", "", "<=", 2),
    Goal("box ridge 4096", "box of an oblique ridge, 4096 x 4096", "", "<=", 2),
    Goal("box net 2500", "box after one point moved, 2,500 windows", "", "<=", 1),
    Goal("box net 10000", "box after one point moved, 10,000 windows", "", "<=", 2),
    # Nets
    Goal("samples 100", "1001 x 1001 samples, 100 windows", "one window", "<=", 1.5),
    Goal("samples 2500", "1001 x 1001 samples, 2,500 windows", "one window", "<=", 4),
    Goal("samples 10000", "1001 x 1001 samples, 10,000 windows", "one window"),
    Goal("patches 2500", "the patches of 2,500 windows", "", "<=", 40),
    Goal("moved 100", "one point moved, with T, 100 windows", "one window"),
    Goal("moved 2500", "one point moved, with T, 2,500 windows", "one window"),
    Goal("moved 10000", "one point moved, with T, 10,000 windows", "one window"),
    Goal("splipy net 100", "1001 x 1001 samples, 100 windows", "Splipy, as many points", ">=", 2),
    Goal("splipy net 2500", "1001 x 1001 samples, 2,500 windows", "Splipy, as many points", ">=", 2),
    Goal("splipy net 10000", "1001 x 1001 samples, 10,000 windows", "Splipy, as many points", ">=", 2),
    Goal("splipy whole 100", "document to samples, 100 windows", "Splipy, samples alone", ">="),
    Goal("splipy whole 2500", "document to samples, 2,500 windows", "Splipy, samples alone", ">="),
    Goal("splipy whole 10000", "document to samples, 10,000 windows", "Splipy, samples alone", ">="),
    Goal("net file", "file to evaluation, 203 x 203 points", "", "<=", 0.8, "s"),
    Goal("net memory", "peak memory, 2,500 windows, 1001 x 1001", "its samples", "<=", 1.25, "MB"),
    Goal("net history", "2,000 moves in the history, 203 x 203 points", "", "<=", 50, "MB"),
    # Files
    *(Goal(f"write {suffix}", f"{suffix} of 501 x 501 samples", peer, "<=", 1.25) for suffix, peer in WRITERS.items()),
    Goal("write large .ply", ".ply of 1001 x 1001 samples", "", "<=", 5, "s"),
    Goal("write large .glb", ".glb of 1001 x 1001 samples", "", "<=", 5, "s"),
    Goal("memory .ply", "peak memory of .ply, 1001 x 1001 samples", "", "<=", None, "MB"),
    Goal("memory .glb", "peak memory of .glb, 1001 x 1001 samples", "", "<=", None, "MB"),
    Goal("write .3dm", ".3dm with net, points and text", "rhino3dm, the surface alone"),
    Goal("write .step", ".step", ".3dm of rhino3dm"),
    Goal("write .iges", ".iges", ".3dm of rhino3dm"),
    # Laboratory
    Goal("verify wait fig5", "longest wait for a verdict, fig5", "", "<=", 10),
    Goal("verify wait fig6c", "longest wait for a verdict, fig6c", "", "<=", 10),
    Goal("verify fig5", "all verdicts, fig5"),
    Goal("verify fig6c", "all verdicts, fig6c"),
    Goal("verify command", "qovr verify paper:fig5", "", "<=", 2, "s"),
    Goal("closest points", "closest points of 101 x 101", "", "<=", 100),
    Goal("compare wait fig5", "longest wait for a surface's measures, fig5", "", "<=", 50),
    Goal("compare wait fig6c", "longest wait for a surface's measures, fig6c", "", "<=", 50),
    Goal("compare wait fig8", "longest wait for a surface's measures, fig8", "", "<=", 50),
    Goal("compare fig5", "all measures, fig5"),
    Goal("compare fig6c", "all measures, fig6c"),
    Goal("compare fig8", "all measures, fig8"),
    Goal("compare command", "qovr compare paper:fig5", "", "<=", 2, "s"),
    Goal("influence point raw", "influence of a point, raw", "", "<=", 10),
    Goal("influence point transformed", "influence of a point, transformed", "", "<=", 10),
    Goal("influence knot raw", "influence of a knot, raw", "", "<=", 10),
    Goal("influence knot transformed", "influence of a knot, transformed", "", "<=", 10),
    # The view
    Goal("frame", "finished frame, 800 x 600, the camera moving", "an empty QOpenGLWidget", "<=", 1.8),
    Goal("edit/orbit 101", "edit with redraw, 101 x 101", "a step of an orbit", ">=", 0.85),
    Goal("edit/orbit 401", "edit with redraw, 401 x 401", "a step of an orbit", ">="),
    Goal("edit/orbit 1001", "edit with redraw, 1001 x 1001", "a step of an orbit", ">="),
    Goal("stock 101", "edit with redraw, 101 x 101, display grid", "GLSurfacePlotItem, all samples", ">=", 4),
    Goal("stock 401", "edit with redraw, 401 x 401, display grid", "GLSurfacePlotItem, all samples", ">=", 40),
    Goal("stock 1001", "edit with redraw, 1001 x 1001, display grid", "GLSurfacePlotItem, all samples", ">=", 200),
    Goal("stock mesh 101", "edit with redraw, the 101 x 101 samples", "GLSurfacePlotItem, same mesh", ">="),
    Goal("stock mesh 401", "edit with redraw, the 401 x 401 samples", "GLSurfacePlotItem, same mesh", ">="),
    Goal("stock mesh 1001", "edit with redraw, the 1001 x 1001 samples", "GLSurfacePlotItem, same mesh", ">="),
    Goal("bare mesh 1001", "edit with redraw, the 1001 x 1001 samples", "bare QOpenGLWidget", "<=", 1.2),
    Goal("pyvista mesh 101", "edit with redraw, the 101 x 101 samples", "PyVista, same mesh", ">="),
    Goal("pyvista mesh 1001", "edit with redraw, the 1001 x 1001 samples", "PyVista, same mesh", ">="),
    Goal("pyvista 1001", "edit with redraw, 1001 x 1001, display grid", "PyVista, all samples", ">="),
    Goal("switch gaussian", "switch the colours to gaussian", "the same picture again", "<=", 2),
    Goal("switch sensitivity", "switch the colours to sensitivity", "the same picture again", "<=", 2),
    Goal("switch zebra", "switch the colours to zebra", "the same picture again", "<=", 2),
    Goal("switch isophotes", "switch the colours to isophotes", "the same picture again", "<=", 2),
    Goal("edit gaussian", "edit with redraw, coloured by gaussian", "by height", "<=", 1.5),
    Goal("edit sensitivity", "edit with redraw, coloured by sensitivity", "by height", "<=", 1.5),
    Goal("edit zebra", "edit with redraw, coloured by zebra", "by height", "<=", 1.5),
    Goal("edit isophotes", "edit with redraw, coloured by isophotes", "by height", "<=", 1.5),
    Goal("edit distance", "edit with redraw, coloured by distance", "by height"),
    Goal("drag median", "drag event to finished frame, median"),
    Goal("drag 99", "drag event to finished frame, 99 of 100"),
    Goal("net edit", "one point moved with redraw, 2,401 windows", "one window, as many vertices", "<=", 1.3),
    Goal("net first frame", "first frame of 203 x 203 points", "", "<=", 1.5, "s"),
    Goal("net orbit", "step of an orbit, 203 x 203 points", "25 points", "<=", 1.5),
    Goal("net pick", "pick a point of 203 x 203, hidden ones left out", "", "<=", 5),
    # The window
    Goal("panels hidden wall", "200 edits, panels hidden", "200 steps of an orbit", "<=", 1.25),
    Goal("panels hidden CPU", "200 edits, panels hidden, main thread's CPU", "200 steps of an orbit", "<=", 1.25),
    Goal("panels open wall", "200 edits, panels open and current at the end", "200 steps of an orbit", "<=", 1.5),
    Goal("panels open CPU", "200 edits, panels open, main thread's CPU", "200 steps of an orbit", "<=", 1.5),
    Goal("panels behind", "how far a panel is behind the surface, longest", "", "<=", 100),
    Goal("frames alone", "frame of an orbit, median"),
    Goal("frames beside", "frame of an orbit beside panels and exports, 99 of 100", "", "<=", 30),
    Goal("frames longest", "frame of an orbit beside panels and exports, longest"),
    Goal("start", "start of qovr to its first finished frame", "an empty GLViewWidget", "<=", 1.15, "s"),
    Goal("info", "qovr info paper:fig5", "python -c 'import numpy'", "<=", 1.25, "s"),
    Goal("export .step", "qovr export of a .step", "qovr info", "<=", 1.5, "s"),
    Goal("export .qovr", "qovr export of a .qovr", "qovr info", "<=", 1.5, "s"),
    # Long
    Goal("growth resident", "resident memory after 20,000 edits more", "", "<=", 5, "MB", True),
    Goal("growth in use", "bytes in use after 20,000 edits more", "", "<=", None, "MB", True),
    Goal("growth openings", "resident memory after 20,000 edits and 200 openings", "", "<=", 10, "MB", True),
    Goal("make test", "make test", "", "<=", 6, "min", True),
    Goal("make bench", "make bench", "", "<=", 10, "min"),
)

GOALS = {goal.key: goal for goal in ROWS}
