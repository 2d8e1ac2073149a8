"""Random nets of many windows."""

import numpy as np

from qovr_core import Document, Formulation
from qovr_core.geometry.knots import KNOT_NAMES
from qovr_core.geometry.nodes import knots_of_steps

R, S, U, T = range(len(KNOT_NAMES))


def random_net_document(
    seed, windows, *, formulation=Formulation.INTERPOLATING, smooth=1.0, flatness=1.0, samples=(61, 53), margin=0.2
):
    """Return a random document of m x n windows whose joints are smooth with a probability, and else sharp."""
    rng = np.random.default_rng(seed)
    m, n = windows
    rows, columns = 2 * m + 3, 2 * n + 3
    y, x = np.mgrid[:rows, :columns]
    net = np.stack([x, y, 0 * x], axis=-1) + flatness * rng.uniform(-0.4, 0.4, (rows, columns, 3))
    row_knots = _knots(rng, rows, n, smooth, margin)
    column_knots = _knots(rng, columns, m, smooth, margin)
    return Document(net, row_knots, column_knots, formulation, samples)


def _knots(rng, curves, windows, smooth, margin):
    knots = rng.uniform(margin, 1 - margin, (curves, windows, 4))
    for joint in range(windows - 1):
        if rng.random() < smooth:
            knots[:, joint, T] = knots[:, joint + 1, R] = rng.uniform(margin, 1 - margin)
            knots[:, joint, U] = knots[0, joint, U]
            knots[:, joint + 1, U] = knots[0, joint + 1, U]
    return knots


def closed_net(seed, windows, along):
    """Return a random document whose net closes along u, v or both."""
    document = random_net_document(seed, windows, smooth=0.0)
    net, rows, columns = (
        document.control_points.copy(),
        document.row_knots.array.copy(),
        document.column_knots.array.copy(),
    )
    if "u" in along:
        net[:, -3:], columns[-3:] = net[:, :3], columns[:3]
    if "v" in along:
        net[-3:], rows[-3:] = net[:3], rows[:3]
    if len(along) == 2:
        net[-3:, -3:] = net[:3, :3]
    return Document(net, rows, columns, document.formulation, document.samples, closed=along)


def node_net(seed, windows):
    """Return a document whose points are quadratic in random nodes, and whose knots are those of the nodes."""
    rng = np.random.default_rng(seed)
    m, n = windows
    y, x = (np.cumsum(rng.uniform(0.3, 1.0, 2 * count + 3)) for count in windows)
    powers = [np.stack([each**0, each, each**2], axis=-1) / np.abs(each).max() ** [0, 1, 2] for each in (y, x)]
    net = np.einsum("ia,jb,abd->ijd", *powers, rng.uniform(-1, 1, (3, 3, 3)))
    rows = np.broadcast_to(knots_of_nodes(x), (2 * m + 3, n, 4))
    columns = np.broadcast_to(knots_of_nodes(y), (2 * n + 3, m, 4))
    return Document(net, rows, columns, Formulation.INTERPOLATING, (61, 53))


def knots_of_nodes(nodes):
    """Return the knots (windows, 4), in the order r s u t, that belong to increasing nodes (2 windows + 3,)."""
    return knots_of_steps(np.diff(np.asarray(nodes, dtype=np.float64)))


def nodes_of_knots(knots):
    """Return the nodes (2 windows + 3,) that knots (windows, 4) of smooth joints say; the second is 0, the fourth 1."""
    r, _, u, t = np.asarray(knots, dtype=np.float64).T
    nodes = np.empty(2 * len(r) + 3)
    nodes[0], nodes[1] = -u[0] * r[0] / (1 - r[0]), 0.0
    length = 1.0
    for b in range(len(r)):
        start = nodes[2 * b + 1]
        if b:
            length = (start - nodes[2 * b]) * (1 - r[b]) / (r[b] * u[b])
        nodes[2 * b + 2], nodes[2 * b + 3] = start + u[b] * length, start + length
    nodes[-1] = nodes[-2] + (1 - u[-1]) * length * (1 - t[-1]) / t[-1]
    return nodes
