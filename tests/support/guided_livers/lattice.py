"""A real liver's mask as tetrahedra: a body-centred lattice cut to the shape, its boundary drawn onto the smoothed mask.

The lattice's cells are alike and well shaped (Labelle and Shewchuk 2007, ACM Trans. Graph. 26:57, use the same one).
"""

import nibabel
import numpy as np
from scipy import ndimage, sparse
from scipy.sparse.csgraph import connected_components

VOXEL_MM, BLUR_MM = 3.0, 5.0


class Shape:
    """A signed distance in mm, negative inside, in patient coordinates (LPS)."""

    def __init__(self, mask_file):
        image = nibabel.load(mask_file)
        mask = np.asanyarray(image.dataobj) > 0
        to_lps = np.diag([-1.0, -1, 1, 1]) @ image.affine
        corners = np.array([[a, b, c, 1] for a in (0, mask.shape[0]) for b in (0, mask.shape[1]) for c in (0, mask.shape[2])])
        box = corners @ to_lps.T
        self.low = box[:, :3].min(axis=0) - 6 * VOXEL_MM
        size = np.ceil((box[:, :3].max(axis=0) + 6 * VOXEL_MM - self.low) / VOXEL_MM).astype(int)
        places = np.stack(np.meshgrid(*(np.arange(n) for n in size), indexing="ij"), axis=-1).reshape(-1, 3)
        voxels = np.c_[places * VOXEL_MM + self.low, np.ones(len(places))] @ np.linalg.inv(to_lps).T
        inside = ndimage.map_coordinates(mask.astype(np.float32), voxels[:, :3].T, order=1).reshape(size) > 0.5
        labels, _ = ndimage.label(inside)
        inside = labels == 1 + np.argmax(np.bincount(labels.ravel())[1:])
        inside = ndimage.binary_fill_holes(inside)
        distance = ndimage.distance_transform_edt(~inside) - ndimage.distance_transform_edt(inside)
        self.distance = ndimage.gaussian_filter(distance * VOXEL_MM, BLUR_MM / VOXEL_MM)
        self.slopes = np.gradient(self.distance, VOXEL_MM)

    def _at(self, field, points):
        return ndimage.map_coordinates(field, ((points - self.low) / VOXEL_MM).T, order=1, mode="nearest")

    def __call__(self, points):
        return self._at(self.distance, points)

    def onto(self, points):
        for _ in range(4):
            slope = np.stack([self._at(s, points) for s in self.slopes], axis=1)
            points = points - (self(points) / np.maximum((slope**2).sum(axis=1), 0.1))[:, None] * slope
        return points


def tetrahedra(shape, edge_mm, rng):
    """Points and cells of about this edge; the lattice lies anyhow, so that two meshes share nothing."""
    side = edge_mm * 1.08
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    high = shape.low + VOXEL_MM * np.array(shape.distance.shape)
    middle, reach = 0.5 * (shape.low + high), np.linalg.norm(high - shape.low) / 2
    n = int(reach / side) + 2
    grid = np.stack(np.meshgrid(*[np.arange(-n, n + 1)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    corner_id = lambda g: ((g[:, 0] + n + 1) * (2 * n + 4) + g[:, 1] + n + 1) * (2 * n + 4) + g[:, 2] + n + 1
    count = (2 * n + 4) ** 3
    offset = rng.uniform(0, 1, 3)
    place = lambda g: middle + side * (g + offset) @ turn.T
    grid = grid[shape(place(grid + 0.5)) < 2 * side]
    found = []
    for axis in range(3):
        one, two, three = np.eye(3, dtype=int)[[axis, (axis + 1) % 3, (axis + 2) % 3]]
        ring = [one, one + two, one + two + three, one + three]
        for k in range(4):
            a, b = ring[k], ring[(k + 1) % 4]
            cells = np.stack([count + corner_id(grid), count + corner_id(grid + one), corner_id(grid + a), corner_id(grid + b)], axis=1)
            middles = 0.25 * ((grid + 0.5) + (grid + one + 0.5) + (grid + a) + (grid + b))
            found.append(cells[shape(place(middles)) < 0])
    cells = np.concatenate(found)
    names, cells = np.unique(cells, return_inverse=True)
    cells = cells.reshape(-1, 4)
    is_middle = names >= count
    left = np.where(is_middle, names - count, names)
    g = np.stack([left // (2 * n + 4) ** 2, left // (2 * n + 4) % (2 * n + 4), left % (2 * n + 4)], axis=1) - n - 1
    points = place(g + 0.5 * is_middle[:, None])
    flip = volumes(points, cells) < 0
    cells[flip] = cells[flip][:, [1, 0, 2, 3]]
    points, cells = largest_part(points, cells)
    return fitted(shape, points, cells, edge_mm)


def volumes(points, cells):
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    return np.linalg.det(edges) / 6


def boundary(cells):
    """Faces that one cell alone has, looking outwards."""
    faces = np.concatenate([cells[:, f] for f in ([1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1])])
    _, first, counts = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[counts == 1]]


def largest_part(points, cells):
    """Without cells that hang on by a corner or an edge, as far as sharing faces tells."""
    faces = np.sort(np.concatenate([cells[:, f] for f in ([1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1])]), axis=1)
    owner = np.tile(np.arange(len(cells)), 4)
    order = np.lexsort(faces.T)
    same = (faces[order][1:] == faces[order][:-1]).all(axis=1)
    a, b = owner[order][1:][same], owner[order][:-1][same]
    neighbours = np.bincount(np.r_[a, b], minlength=len(cells))
    keep = neighbours >= 2
    link = sparse.coo_matrix((np.ones(len(a)), (a, b)), shape=(len(cells),) * 2)
    link = link.tocsr()[keep][:, keep]
    _, part = connected_components(link, directed=False)
    cells = cells[keep][part == np.argmax(np.bincount(part))]
    names, cells = np.unique(cells, return_inverse=True)
    return points[names], cells.reshape(-1, 4)


def fitted(shape, points, cells, edge_mm):
    faces = boundary(cells)
    on_boundary = np.unique(faces)
    n = len(points)
    def averages(pairs):
        matrix = sparse.coo_matrix((np.ones(2 * len(pairs)), (np.r_[pairs[:, 0], pairs[:, 1]], np.r_[pairs[:, 1], pairs[:, 0]])), shape=(n, n)).tocsr()
        matrix.data[:] = 1
        return sparse.diags(1 / np.maximum(matrix.sum(axis=1).A1 if hasattr(matrix.sum(axis=1), "A1") else np.asarray(matrix.sum(axis=1)).ravel(), 1)) @ matrix
    inner = averages(np.concatenate([cells[:, [i, j]] for i in range(4) for j in range(i + 1, 4)]))
    outer = averages(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))
    smallest = 0.12 * edge_mm**3 / (6 * np.sqrt(2))
    for step in range(40):
        wanted = points + 0.5 * (inner @ points - points)
        wanted[on_boundary] = shape.onto(points[on_boundary] + 0.4 * (outer @ points - points)[on_boundary])
        move = np.clip(wanted - points, -0.35 * edge_mm, 0.35 * edge_mm)
        scale = np.ones(n)
        for _ in range(6):
            bad = volumes(points + scale[:, None] * move, cells) < smallest
            if not bad.any():
                break
            scale[np.unique(cells[bad])] *= 0.5
        else:
            scale[np.unique(cells[bad])] = 0
            while (bad := volumes(points + scale[:, None] * move, cells) < smallest * 0.5).any() and scale.any():
                before = scale.sum()
                scale[np.unique(cells[bad])] = 0
                if scale.sum() == before:
                    break
        points = points + scale[:, None] * move
    return points, cells
