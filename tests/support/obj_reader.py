"""A strict reader of Wavefront OBJ with triangles of the form ``f v//vn``."""

import numpy as np


class ObjFile:
    """Points (k, 3), normals (l, 3), and per face their indices (f, 3) each."""

    def __init__(self, path):
        rows = {"v": [], "vn": [], "f": []}
        self.comments = []
        for line in path.read_text(encoding="ascii").splitlines():
            key, _, rest = line.partition(" ")
            if key == "#":
                self.comments.append(rest)
            elif key != "o":
                rows[key].append(rest.split())
        self.points, self.normals = (np.array(rows[key], dtype=float) for key in ("v", "vn"))
        indices = np.array([[corner.split("//") for corner in face] for face in rows["f"]], dtype=int) - 1
        self.faces, self.corners = indices[..., 0], indices[..., 1]
        assert indices.min() == 0
        assert self.faces.max() == len(self.points) - 1
        assert self.corners.max() == len(self.normals) - 1
