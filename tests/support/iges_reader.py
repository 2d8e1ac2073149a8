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
    """The sections of a file and its one entity."""

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
        first, second = ([line[k : k + 8].strip() for k in range(0, 72, 8)] for line in self.sections["D"])
        assert first[0] == second[0] == "128"
        assert int(first[1]) == 1
        assert int(second[3]) == len(self.sections["P"])
        assert re.fullmatch(r"\d{8}", first[8])
        for line in self.sections["P"]:
            assert line[64] == " "
            assert int(line[65:]) == 1
        self.parameters = fields("".join(line[:64] for line in self.sections["P"]))

    def surface(self):
        """Return the degrees, the closed flags and a function of the surface."""
        kind, k1, k2, p, q, closed_u, closed_v, polynomial, *_ = map(int, self.parameters[:10])
        assert (kind, polynomial) == (128, 1)
        n, m = k1 + 1, k2 + 1
        reals = [number(text) for text in self.parameters[10:]]
        lengths = (n + p + 1, m + q + 1, n * m, 3 * n * m, 4)
        assert len(reals) == sum(lengths)
        knots_u, knots_v, weights, coordinates, domain = np.split(np.array(reals), np.cumsum(lengths)[:-1])
        assert (weights == 1).all()
        assert domain.tolist() == [0, 1, 0, 1]
        points = coordinates.reshape(m, n, 3).transpose(1, 0, 2)
        return (p, q), (bool(closed_u), bool(closed_v)), NdBSpline((knots_u, knots_v), points, k=(p, q))
