"""Algorithm 1 and the interpolating definition, loop by loop: the oracle for everything fast.

With plain floats it is what the paper prints; with Fractions throughout it is exact.
"""

from math import trunc


def inverse_kernel(k, cut):
    rows = [
        [1 / k, 1 / (k * (k - 1)), 1 / (1 - k)],
        [-(k + 1) / k, 1 / (k * (1 - k)), k / (k - 1)],
        [k / k, 0 * k, 0 * k],
    ]
    if not cut:
        return rows
    return [[type(x)(trunc(10_000 * x + type(x)(1e-9 if x >= 0 else -1e-9))) / 10_000 for x in row] for row in rows]


def parabola(kernel, x, points):
    powers = [x * x, x, 1]
    total = 0
    for row in range(3):
        for column in range(3):
            total += powers[row] * kernel[row][column] * points[column]
    return total


def curve(u, knots, points, cut=False):
    """Return one coordinate of C(u) of (23); ``knots`` is (r, s, u, t), ``points`` five numbers."""
    r_ip, s_ip, u_ip, t_ip = knots
    r = (1 - r_ip) / u_ip * u + r_ip
    a = (s_ip - u_ip) / (u_ip * u_ip - u_ip)
    s = a * u * u + (1 - a) * u
    t = t_ip / (1 - u_ip) * u - u_ip * t_ip / (1 - u_ip)
    return (
        (1 - u) ** 2 * parabola(inverse_kernel(r_ip, cut), r, points[0:3])
        + 2 * u * (1 - u) * parabola(inverse_kernel(s_ip, cut), s, points[1:4])
        + u * u * parabola(inverse_kernel(t_ip, cut), t, points[2:5])
    )


def point(net, rows, columns, formulation, u, v):
    """Return S(u, v) as three floats; ``net[i][j]`` are points, ``rows`` and ``columns`` five knots each."""
    if formulation == "interpolating":
        return [_interpolating(net, rows, columns, axis, u, v) for axis in range(3)]
    cut = formulation == "published"
    result = []
    for axis in range(3):
        total = 0
        for i in range(5):
            if formulation == "published":
                total = 0
            c = curve(u, rows[i], [net[i][j][axis] for j in range(5)], cut)
            for j in range(5):
                k = curve(v, columns[j], [net[i2][j][axis] for i2 in range(5)], cut)
                total += c * k
        result.append(total)
    return result


def _mean(knots):
    return [sum(curve_knots[k] for curve_knots in knots) / 5 for k in range(4)]


def _interpolating(net, rows, columns, axis, u, v):
    unit = [[int(a == b) for b in range(5)] for a in range(5)]
    beta = [curve(v, _mean(columns), unit[i]) for i in range(5)]
    bbar = [curve(u, _mean(rows), unit[j]) for j in range(5)]
    total = 0
    for i in range(5):
        total += beta[i] * curve(u, rows[i], [net[i][j][axis] for j in range(5)])
    for j in range(5):
        total += bbar[j] * curve(v, columns[j], [net[i][j][axis] for i in range(5)])
    for i in range(5):
        for j in range(5):
            total -= bbar[j] * beta[i] * net[i][j][axis]
    return total
