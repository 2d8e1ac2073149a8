"""A piece of a sphere in closed form, and curvatures by another way than the program's."""

from dataclasses import dataclass, replace

import numpy as np

from qovr_core.geometry.differential import curvature


@dataclass(frozen=True)
class SphericalPatch:
    """Longitudes and latitudes from 0 at u, v = 0 to the given angles at u, v = 1; the normals point outward."""

    radius: float = 1.0
    longitude: float = np.pi / 2
    latitude: float = np.pi / 3

    def derivative_at(self, u, v, order_u, order_v):
        east = self.longitude * np.asarray(u)
        north = self.latitude * np.asarray(v)
        turned = order_v * np.pi / 2
        around = order_u * np.pi / 2
        flat = np.cos(north + turned)
        z = np.sin(north + turned) if order_u == 0 else 0 * north
        points = np.stack([flat * np.cos(east + around), flat * np.sin(east + around), z], axis=-1)
        return self.radius * self.longitude**order_u * self.latitude**order_v * points

    def derivative(self, u, v, order_u, order_v):
        u, v = np.meshgrid(u, v, indexing="ij")
        return self.derivative_at(u, v, order_u, order_v)

    @property
    def domain(self):
        return (0.0, 1.0), (0.0, 1.0)

    @property
    def breaks(self):
        return np.empty(0), np.empty(0)

    def points(self, u, v):
        return self.derivative(u, v, 0, 0)

    def normals(self, u, v):
        return self.points(u, v) / self.radius

    def transformed(self, matrix):
        return replace(self, radius=self.radius * matrix[0][0])  # the same factor along every axis is all it knows

    def curvature(self, u, v):
        orders = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
        return curvature(*(self.derivative(u, v, *order) for order in orders), singular=1e-12 * self.radius**2)


def principal_curvatures(surface, u, v, step=1e-5):
    """Return k_2 and k_1 on a grid: the eigenvalues of minus the derivative of the unit normal along the surface."""

    def unit_normal(u, v):
        normal = np.cross(surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1))
        return normal / np.linalg.norm(normal, axis=-1, keepdims=True)

    turned = np.stack(
        [
            (unit_normal(u + step, v) - unit_normal(u - step, v)) / (2 * step),
            (unit_normal(u, v + step) - unit_normal(u, v - step)) / (2 * step),
        ],
        axis=-1,
    )
    tangents = np.stack([surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)], axis=-1)
    shape = -np.linalg.pinv(tangents) @ turned
    principal = np.sort(np.linalg.eigvals(shape).real, axis=-1)
    return principal[..., 0], principal[..., 1]
