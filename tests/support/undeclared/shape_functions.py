"""Where a point lies in a mesh of C3D10 or C3D20, and the shape functions there (any text on finite elements)."""

import numpy as np

from specimens import BRICK_EDGES, TET_EDGES

BRICK_CORNERS = np.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
                          (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)], float)
BRICK_MIDDLES = np.array([(BRICK_CORNERS[a] + BRICK_CORNERS[b]) / 2 for a, b in BRICK_EDGES])


def tet_values(local):
    """(n, 3) -> (n, 10), in the order of CalculiX."""
    bary = np.column_stack([1 - local.sum(axis=1), local])
    corners = bary * (2 * bary - 1)
    return np.hstack([corners, np.column_stack([4 * bary[:, a] * bary[:, b] for a, b in TET_EDGES])])


def brick_values(local):
    """(n, 3) in [-1, 1] -> (n, 20)."""
    at_corners = local[:, None] * BRICK_CORNERS
    at_middles = local[:, None] * BRICK_MIDDLES
    along = np.where(BRICK_MIDDLES == 0, 1 - local[:, None] ** 2, 1 + at_middles)
    return np.hstack([(1 + at_corners).prod(axis=2) * (at_corners.sum(axis=2) - 2) / 8, along.prod(axis=2) / 4])


QUAD_CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
QUAD_MIDDLES = np.array([(0, -1), (1, 0), (0, 1), (-1, 0)], float)


def face_values(place):
    """At a place in [-1, 1] x [-1, 1] of a face with eight nodes, in the order of Mesh.faces."""
    at_corners, at_middles = place * QUAD_CORNERS, place * QUAD_MIDDLES
    along = np.where(QUAD_MIDDLES == 0, 1 - place ** 2, 1 + at_middles)
    return np.concatenate([(1 + at_corners).prod(axis=1) * (at_corners.sum(axis=1) - 1) / 4, along.prod(axis=1) / 2])


def face_rule():
    """Places and weights of Gauss's rule on it, three each way."""
    line = [(-np.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (np.sqrt(0.6), 5 / 9)]
    return [(np.array([u, v]), a * b) for u, a in line for v, b in line]


class Locator:
    """Elements and weights of points: `nodes` (n, k), `weights` (n, k). A point just outside takes the nearest place."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.values = brick_values if mesh.kind == "C3D20" else tet_values
        corners = 8 if mesh.kind == "C3D20" else 4
        self.centroids = mesh.points[mesh.elements[:, :corners]].mean(axis=1)
        self.size = np.linalg.norm(mesh.points[mesh.elements[:, :corners]] - self.centroids[:, None], axis=2).max(axis=1)

    def __call__(self, points):
        found = self.nearest(points, 8)
        lost = found[0] < -1e-9
        if lost.any() and len(self.centroids) > 8:
            for kept, better in zip(found, self.nearest(points[lost], 48)):
                kept[lost] = better
        _, elements, local = found
        weights = self.values(self.clipped(local))
        nodes = self.mesh.elements[elements]
        miss = np.linalg.norm(np.einsum("nk,nkd->nd", weights, self.mesh.points[nodes]) - points, axis=1)
        if (miss > 0.05 * self.size[elements]).any():
            raise ValueError(f"the point {points[np.argmax(miss)]} lies outside the mesh")
        return nodes, weights

    def nearest(self, points, candidates):
        """Of so many elements nearby the one that the point lies deepest in: how deep, which, where in it."""
        candidates = min(candidates, len(self.centroids))
        distance = np.linalg.norm(points[:, None] - self.centroids, axis=2) / self.size
        some = np.argpartition(distance, candidates - 1, axis=1)[:, :candidates]
        local = self.local(some.ravel(), np.repeat(points, candidates, axis=0))
        inside = self.inside(local).reshape(some.shape)
        best = np.argmax(inside, axis=1)
        rows = np.arange(len(points))
        return inside[rows, best], some[rows, best], local.reshape(*some.shape, 3)[rows, best]

    def local(self, elements, points):
        """By Newton's method, for each element and point."""
        found = np.zeros((len(elements), 3)) if self.mesh.kind == "C3D20" else np.full((len(elements), 3), 0.25)
        nodes = self.mesh.points[self.mesh.elements[elements]]
        for _ in range(6):
            miss = np.einsum("nk,nkd->nd", self.values(found), nodes) - points
            if np.abs(miss).max() < 1e-9:
                break
            slope = np.empty((len(elements), 3, 3))
            for axis in range(3):
                step = np.zeros(3)
                step[axis] = 1e-6
                slope[:, :, axis] = np.einsum("nk,nkd->nd", self.values(found + step) - self.values(found - step),
                                              nodes) / 2e-6
            found = np.clip(found - np.linalg.solve(slope, miss[:, :, None])[:, :, 0], -3, 3)
        return found

    def inside(self, local):
        """How far inside: negative outside."""
        if self.mesh.kind == "C3D20":
            return 1 - np.abs(local).max(axis=1)
        return np.minimum(local.min(axis=1), 1 - local.sum(axis=1))

    def clipped(self, local):
        if self.mesh.kind == "C3D20":
            return np.clip(local, -1, 1)
        bary = np.clip(np.column_stack([1 - local.sum(axis=1), local]), 0, None)
        return (bary / bary.sum(axis=1)[:, None])[:, 1:]
