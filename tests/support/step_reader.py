"""A reader of ISO 10303-21 files, written from the standard's grammar; it knows nothing of the program's writer."""

import re
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import BSpline, NdBSpline

_TOKEN = re.compile(
    r"\s*(?:(?P<string>'(?:[^']|'')*')|(?P<reference>\#\d+)|(?P<enum>\.[A-Z_0-9]+\.)"
    r"|(?P<real>[+-]?\d+\.\d*(?:E[+-]?\d+)?)|(?P<integer>[+-]?\d+)|(?P<name>[A-Z_][A-Z_0-9]*)|(?P<mark>[(),;=$*]))"
)


@dataclass
class Reference:
    """A pointer to an entity."""

    number: int


def tokens(text):
    place = 0
    while text[place:].strip():
        match = _TOKEN.match(text, place)
        assert match, f"no token of Part 21: {text[place : place + 40]!r}"
        yield match.lastgroup, match[match.lastgroup]
        place = match.end()


def decoded(text):
    """Return the text of a string token."""
    text = text[1:-1].replace("''", "'")
    text = re.sub(r"\\X2\\((?:[0-9A-F]{4})+)\\X0\\", lambda m: bytes.fromhex(m[1]).decode("utf-16-be"), text)
    text = re.sub(r"\\X4\\((?:[0-9A-F]{8})+)\\X0\\", lambda m: bytes.fromhex(m[1]).decode("utf-32-be"), text)
    return text.replace("\\\\", "\\")


class _Parser:
    def __init__(self, text):
        self.stream = list(tokens(text))
        self.place = 0

    def next(self, expected=None):
        kind, text = self.stream[self.place]
        assert expected is None or text == expected, (text, expected)
        self.place += 1
        return kind, text

    def peek(self):
        return self.stream[self.place][1]

    def arguments(self):
        self.next("(")
        values = []
        while self.peek() != ")":
            values.append(self.value())
            if self.peek() == ",":
                self.next()
                assert self.peek() != ")"
        self.next(")")
        return values

    def value(self):
        if self.peek() == "(":
            return self.arguments()
        kind, text = self.next()
        if kind == "name":
            return text, self.arguments()
        readers = {"string": decoded, "reference": lambda t: Reference(int(t[1:])), "real": float, "integer": int}
        return readers.get(kind, str)(text)

    def entity(self):
        if self.peek() == "(":
            self.next()
            parts = {}
            while self.peek() != ")":
                name = self.next()[1]
                parts[name] = self.arguments()
            self.next(")")
            return parts
        name = self.next()[1]
        return {name: self.arguments()}


class StepFile:
    """The header and the entities of a file; every reference is known to lead somewhere."""

    def __init__(self, path):
        text = path.read_text(encoding="ascii")
        match = re.fullmatch(
            r"ISO-10303-21;\s*HEADER;(.*?)ENDSEC;\s*DATA;(.*)ENDSEC;\s*END-ISO-10303-21;\s*", text, re.DOTALL
        )
        assert match, "the sections of a Part 21 file"
        head = _Parser(match[1])
        self.header = {}
        while head.place < len(head.stream):
            self.header |= head.entity()
            head.next(";")
        body = _Parser(match[2])
        self.entities = {}
        while body.place < len(body.stream):
            number = int(body.next()[1][1:])
            body.next("=")
            assert number not in self.entities
            self.entities[number] = body.entity()
            body.next(";")
        for entity in self.entities.values():
            for arguments in entity.values():
                self._check(arguments)

    def _check(self, value):
        if isinstance(value, Reference):
            assert value.number in self.entities
        elif isinstance(value, (list, tuple)):
            for entry in value:
                self._check(entry)

    def all(self, name):
        return [entity[name] for entity in self.entities.values() if name in entity]

    def one(self, name):
        (arguments,) = self.all(name)
        return arguments

    def one_entity(self, name):
        """Return all parts of the one entity that has a part of this name."""
        (entity,) = (entity for entity in self.entities.values() if name in entity)
        return entity

    def of(self, reference):
        """Return the name and the arguments of a simple entity."""
        ((name, arguments),) = self.entities[reference.number].items()
        return name, arguments

    def coordinates(self, reference):
        name, arguments = self.of(reference)
        assert name == "CARTESIAN_POINT"
        return arguments[1]

    def surface(self):
        """Return the degrees and a function of the one B-spline surface."""
        _, p, q, rows, _, _, _, _, count_u, count_v, knots_u, knots_v, _ = self.one("B_SPLINE_SURFACE_WITH_KNOTS")
        points = np.array([[self.coordinates(point) for point in row] for row in rows])
        knots = tuple(np.repeat(values, counts) for values, counts in ((knots_u, count_u), (knots_v, count_v)))
        assert [len(k) for k in knots] == [points.shape[0] + p + 1, points.shape[1] + q + 1]
        return (p, q), NdBSpline(knots, points, k=(p, q))

    def boundary(self):
        """Return the curves of the face's loop in its order, each a function of 0..1 in the loop's direction."""
        face = self.one("ADVANCED_FACE")
        (bound,) = face[1]
        _, loop = self.of(self.of(bound)[1][1])
        curves = []
        for oriented in loop[1]:
            _, (_, _, _, edge, sense) = self.of(oriented)
            _, (_, start, end, curve, same) = self.of(edge)
            assert same == ".T."
            kind, (_, in_space, in_plane, _) = self.of(curve)
            assert (kind, len(in_plane)) in (("SURFACE_CURVE", 1), ("SEAM_CURVE", 2))
            _, (_, degree, points, _, _, _, counts, knots, _) = self.of(in_space)
            spline = BSpline(np.repeat(knots, counts), np.array([self.coordinates(p) for p in points]), degree)
            within = 1e-8 * np.abs(spline.c).max()
            for vertex, t in ((start, 0.0), (end, 1.0)):
                place = self.coordinates(self.of(vertex)[1][1])
                assert np.allclose(spline(t), place, rtol=0, atol=within)
            for line in map(self.parameter_line, in_plane):
                t = np.linspace(0, 1, 21)
                assert np.allclose(self.surface()[1](line(t)), spline(t), rtol=0, atol=within)
            curves.append(spline if sense == ".T." else lambda t, spline=spline: spline(1 - t))
        return curves

    def pcurves(self):
        """Return the references to all lines in the parameters."""
        return [Reference(number) for number, entity in self.entities.items() if "PCURVE" in entity]

    def parameter_line(self, reference):
        """Return the line along which an edge runs in the surface's parameters, a function of 0..1."""
        name, (_, surface, content) = self.of(reference)
        assert name == "PCURVE"
        assert self.of(surface)[0] == "B_SPLINE_SURFACE_WITH_KNOTS"
        name, (_, (line,), context) = self.of(content)
        assert name == "DEFINITIONAL_REPRESENTATION"
        assert self.entities[context.number]["GEOMETRIC_REPRESENTATION_CONTEXT"] == [2]
        _, (_, start, vector) = self.of(line)
        _, (_, direction, length) = self.of(vector)
        start, direction = np.array(self.coordinates(start)), np.array(self.of(direction)[1][1])
        assert len(start) == len(direction) == 2
        return lambda t: start + length * np.asarray(t)[:, None] * direction
