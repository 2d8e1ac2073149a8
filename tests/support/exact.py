"""A QOVR curve in exact rational arithmetic, transcribed from the definition and sharing nothing with the program."""

from fractions import Fraction


def parabola_weights(knot, x):
    """Return the weights of three points on the parabola that meets them at 0, the knot and 1."""
    return [
        x * x / knot - (knot + 1) / knot * x + 1,
        x * x / (knot * (knot - 1)) + x / (knot * (1 - knot)),
        x * x / (1 - knot) + knot / (knot - 1) * x,
    ]


def weights(r, s, u_ip, t, u):
    """Return b_0..b_4 at u as Fractions."""
    r, s, u_ip, t, u = (Fraction(value) for value in (r, s, u_ip, t, u))
    a = (s - u_ip) / (u_ip * u_ip - u_ip)
    places = [
        (1 - r) / u_ip * u + r,
        a * u * u + (1 - a) * u,
        t / (1 - u_ip) * u - u_ip * t / (1 - u_ip),
    ]
    blends = [(1 - u) ** 2, 2 * u * (1 - u), u * u]
    result = [Fraction(0)] * 5
    for first, (blend, knot, place) in enumerate(zip(blends, (r, s, t), places, strict=True)):
        for k, weight in enumerate(parabola_weights(knot, place)):
            result[first + k] += blend * weight
    return result
