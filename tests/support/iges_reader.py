"""A reader of IGES 5.3 files by their columns, written from the standard; it knows nothing of the program's writer."""

import re

import numpy as np
from scipy.interpolate import NdBSpline


def fields(text):
    """Return the delimited fields of a section; string constants are counted, not searched."""
    values, place = [], 0
    while True:
        match = re.compile(r"\s*(\d+)H").match(text, place)
        if match:
            end = match.end() + int(match[1])
            values.append(text[match.end() : end])
        else:
            end = min(k for k in (text.find(",", place), text.find(";", place)) if k >= 0)
            values.append(text[place:end].strip())
        assert text[end] in ",;", text[end - 20 : end + 1]
        if text[end] == ";":
            assert not text[end + 1 :].strip()
            return values
        place = end + 1


def number(text):
    assert "." in text, f"{text} is no real constant"
    return float(text.replace("D", "E"))


class IgesFile:
    """The sections of a file and its entities."""

    def __init__(self, path):
        lines = path.read_bytes().decode("ascii").split("\n")
        assert lines.pop() == ""
        assert {len(line) for line in lines} == {80}
        self.sections = {}
        for line in lines:
            section = self.sections.setdefault(line[72], [])
            section.append(line[:72])
            assert int(line[73:]) == len(section)
        assert list(self.sections) == ["S", "G", "D", "P", "T"]
        counts = re.findall(r"([SGDP]) *(\d+)", self.sections["T"][0])
        assert [(name, int(count)) for name, count in counts] == [(name, len(self.sections[name])) for name in "SGDP"]
        self.start = "".join(self.sections["S"])
        self.globals = fields("".join(self.sections["G"]))
        directory = [[line[k : k + 8].strip() for k in range(0, 72, 8)] for line in self.sections["D"]]
        self.entities, end = [], 0
        for entry, (first, second) in enumerate(zip(directory[::2], directory[1::2], strict=True)):
            assert first[0] == second[0] == "128"
            assert int(first[1]) == end + 1
            assert re.fullmatch(r"\d{8}", first[8])
            start, end = end, end + int(second[3])
            lines = self.sections["P"][start:end]
            assert {line[64:] for line in lines} == {f"{2 * entry + 1:>8}"}
            self.entities.append(fields("".join(line[:64] for line in lines)))
        assert end == len(self.sections["P"])

    def surface(self):
        """Return the degrees, the closed flags and a function of the one surface."""
        (surface,) = self.surfaces()
        return surface.degree, surface.closed, surface

    def surfaces(self):
        """Return all surfaces."""
        return [SplineSurface(parameters) for parameters in self.entities]


class SplineSurface:
    """Entity 128, called with parameters (k, 2)."""

    def __init__(self, parameters):
        kind, k1, k2, p, q, closed_u, closed_v, polynomial, *periodic = map(int, parameters[:10])
        assert (kind, polynomial, periodic) == (128, 1, [0, 0])
        n, m = k1 + 1, k2 + 1
        reals = [number(text) for text in parameters[10:]]
        lengths = (n + p + 1, m + q + 1, n * m, 3 * n * m, 4)
        assert len(reals) == sum(lengths)
        knots_u, knots_v, weights, coordinates, domain = np.split(np.array(reals), np.cumsum(lengths)[:-1])
        assert (weights == 1).all()
        assert domain.tolist() == [knots_u[0], knots_u[-1], knots_v[0], knots_v[-1]]
        points = coordinates.reshape(m, n, 3).transpose(1, 0, 2)
        self.degree, self.closed = (p, q), (bool(closed_u), bool(closed_v))
        self.domain = tuple(domain[:2]), tuple(domain[2:])
        self._spline = NdBSpline((knots_u, knots_v), points, k=(p, q))

    def __call__(self, parameters):
        return self._spline(parameters)
