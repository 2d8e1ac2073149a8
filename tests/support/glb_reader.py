"""A strict reader of binary glTF 2.0 with one mesh: what the specification demands is asserted."""

import json

import numpy as np

_TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


class GlbFile:
    """The JSON of a file and the arrays of its one primitive."""

    def __init__(self, path):
        content = path.read_bytes()
        magic, version, length = content[:4], *np.frombuffer(content, "<u4", 2, 4).tolist()
        assert (magic, version, length) == (b"glTF", 2, len(content))
        chunks, place = [], 12
        while place < length:
            size, kind = np.frombuffer(content, "<u4", 2, place).tolist()
            assert size % 4 == 0
            chunks.append((kind, content[place + 8 : place + 8 + size]))
            place += 8 + size
        assert place == length
        assert [kind for kind, _ in chunks] == [0x4E4F534A, 0x004E4942]
        self.json = json.loads(chunks[0][1].decode("utf-8"))
        self.binary = chunks[1][1]
        assert self.json["asset"]["version"] == "2.0"
        (buffer,) = self.json["buffers"]
        assert 0 <= len(self.binary) - buffer["byteLength"] < 4
        self.arrays = [self._array(accessor) for accessor in self.json["accessors"]]
        (mesh,) = self.json["meshes"]
        (self.primitive,) = mesh["primitives"]
        self.node = self.json["nodes"][self.json["scenes"][self.json["scene"]]["nodes"][0]]
        assert self.node["mesh"] == 0
        self._check_attributes()

    def attribute(self, name):
        return self.arrays[self.primitive["attributes"][name]]

    @property
    def indices(self):
        return self.arrays[self.primitive["indices"]].reshape(-1, 3)

    @property
    def positions(self):
        """Return the positions in the scene, in double precision."""
        return self.attribute("POSITION").astype(float) + np.array(self.node["translation"])

    def _array(self, accessor):
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(_TYPES[accessor["componentType"]]), _WIDTHS[accessor["type"]]
        start = view["byteOffset"] + accessor.get("byteOffset", 0)
        assert start % kind.itemsize == 0
        assert (kind.itemsize * width) % 4 == 0 or view["target"] == 34963
        assert accessor["count"] * width * kind.itemsize <= view["byteLength"]
        assert view["byteOffset"] + view["byteLength"] <= len(self.binary)
        values = np.frombuffer(self.binary, kind, accessor["count"] * width, start)
        return values.reshape(-1, width) if width > 1 else values

    def _check_attributes(self):
        views = [self.json["bufferViews"][a["bufferView"]] for a in self.json["accessors"]]
        position = self.json["accessors"][self.primitive["attributes"]["POSITION"]]
        assert np.array_equal(self.attribute("POSITION").min(axis=0), np.float32(position["min"]))
        assert np.array_equal(self.attribute("POSITION").max(axis=0), np.float32(position["max"]))
        assert np.allclose(np.linalg.norm(self.attribute("NORMAL"), axis=1), 1, rtol=0, atol=1e-6)
        assert {len(self.attribute(name)) for name in self.primitive["attributes"]} == {position["count"]}
        for name, index in self.primitive["attributes"].items():
            assert views[index]["target"] == 34962, name
        assert views[self.primitive["indices"]]["target"] == 34963
        assert self.indices.max() < position["count"]
        colour = self.json["accessors"][self.primitive["attributes"]["COLOR_0"]]
        assert colour["normalized"] is True
        assert self.primitive.get("mode", 4) == 4
