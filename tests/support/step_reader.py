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


class SplineSurface:
    """A B-spline surface, called with parameters (k, 2)."""

    def __init__(self, file, arguments):
        _, p, q, rows, _, self.closed_u, self.closed_v, _, count_u, count_v, knots_u, knots_v, _ = arguments
        points = np.array([[file.coordinates(point) for point in row] for row in rows])
        knots = tuple(np.repeat(values, counts) for values, counts in ((knots_u, count_u), (knots_v, count_v)))
        assert [len(k) for k in knots] == [points.shape[0] + p + 1, points.shape[1] + q + 1]
        self.degree, self.multiplicities = (p, q), (count_u, count_v)
        self.domain = (knots_u[0], knots_u[-1]), (knots_v[0], knots_v[-1])
        self._spline = NdBSpline(knots, points, k=(p, q))

    def __call__(self, parameters):
        return self._spline(parameters)


def _run(spline, knots, is_forward):
    """Return a curve as a function of 0..1, in its own direction or against it."""
    start, end = (knots[0], knots[-1]) if is_forward else (knots[-1], knots[0])
    return lambda t: spline(start + (end - start) * np.asarray(t))


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
        (surface,) = self.surfaces()
        return surface.degree, surface

    def surfaces(self):
        """Return all B-spline surfaces."""
        return [SplineSurface(self, arguments) for arguments in self.all("B_SPLINE_SURFACE_WITH_KNOTS")]

    def boundary(self):
        """Return the curves around the one face; see ``boundary_of``."""
        return self.boundary_of(self.one("ADVANCED_FACE"))

    def boundary_of(self, face):
        """Return the curves of a face's loop in its order, each a function of 0..1 in the loop's direction."""
        (bound,) = face[1]
        _, loop = self.of(self.of(bound)[1][1])
        curves = []
        for oriented in loop[1]:
            _, (_, _, _, edge, sense) = self.of(oriented)
            _, (_, start, end, curve, same) = self.of(edge)
            assert same == ".T."
            kind, (_, in_space, in_plane, _) = self.of(curve)
            surfaces = [self.of(line)[1][1].number for line in in_plane]
            assert face[2].number in surfaces
            assert len(surfaces) <= 2
            assert kind == ("SEAM_CURVE" if len(set(surfaces)) < len(surfaces) else "SURFACE_CURVE")
            _, (_, degree, points, _, _, _, counts, knots, _) = self.of(in_space)
            spline = BSpline(np.repeat(knots, counts), np.array([self.coordinates(p) for p in points]), degree)
            within = 1e-8 * np.abs(spline.c).max()
            for vertex, t in ((start, knots[0]), (end, knots[-1])):
                place = self.coordinates(self.of(vertex)[1][1])
                assert np.allclose(spline(t), place, rtol=0, atol=within)
            for reference, surface in zip(in_plane, surfaces, strict=True):
                t = np.linspace(knots[0], knots[-1], 21)
                of_surface = SplineSurface(self, self.entities[surface]["B_SPLINE_SURFACE_WITH_KNOTS"])
                assert np.allclose(of_surface(self.parameter_line(reference)(t)), spline(t), rtol=0, atol=within)
            curves.append(_run(spline, knots, sense == ".T."))
        return curves

    def edge_uses(self):
        """Return for every edge the senses in which the faces' loops run along it."""
        uses = {}
        for _, _, _, edge, sense in self.all("ORIENTED_EDGE"):
            uses.setdefault(edge.number, []).append(sense)
        return uses

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
