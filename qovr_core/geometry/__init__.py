"""The mathematics of curves and patches: knots, kernels, weights, Bernstein forms, grids, curvature, distance."""
