"""Bodies to be palpated, and their meshes: tetrahedra for the experiment's file, finer or other ones for the truth.

A specimen is a map of the unit cube to mm. Its bottom (third coordinate 0) or a part of that is what holds it. The
experiment sees linear tetrahedra, six to each cell of a grid (Kuhn); the truth is computed on C3D10 or C3D20. Kuhn's
tetrahedra of a grid twice as fine lie inside those of the coarse one, so that a fine mesh fills exactly the body that
the experiment's file describes ("nested"); a box may be filled by any other grid ("other"), a round body only about
("own": the smooth shape itself, which the file's flat faces approximate).
"""

import itertools
from dataclasses import dataclass, field

import numpy as np

KUHN = [(0, *path) for path in ((1, 3, 7), (1, 5, 7), (2, 3, 7), (2, 6, 7), (4, 5, 7), (4, 6, 7))]


@dataclass
class Specimen:
    name: str
    to_mm: object              # (n, 3) in the unit cube -> (n, 3) mm
    cells: tuple               # the experiment's grid
    held: object = None        # (n, 3) of the unit cube's bottom -> which are held; None: all of it

    def is_held(self, unit):
        bottom = unit[:, 2] < 1e-9
        return bottom if self.held is None else bottom & self.held(unit)


def block(size_mm, cells):
    return Specimen("block", lambda unit: unit * np.asarray(size_mm, float), cells)


def pillar(diameter_mm, height_mm, cells):
    """A cylinder whose outline is rounded by nine tenths: a disc's corners would make flat cells."""
    def to_mm(unit):
        a, b = 2 * unit[:, 0] - 1, 2 * unit[:, 1] - 1
        disc = np.stack([a * np.sqrt(1 - b * b / 2), b * np.sqrt(1 - a * a / 2)], axis=1)
        square = np.stack([a, b], axis=1) * np.sqrt(np.pi) / 2
        plan = 0.5 * diameter_mm * (0.9 * disc + 0.1 * square)
        return np.column_stack([plan, height_mm * unit[:, 2]])
    return Specimen("pillar", to_mm, cells)


def lobe(length_mm, width_mm, height_mm, cells):
    """Like a liver on a table: rounded, thick on one side and thin on the other, held on two thirds of its flat
    bottom: grids have a multiple of three cells along it."""
    def to_mm(unit):
        a, b = 2 * unit[:, 0] - 1, 2 * unit[:, 1] - 1
        x = a * np.sqrt(1 - 0.4 * b * b)
        y = b * np.sqrt(1 - 0.4 * a * a)
        top = (1 - 0.35 * (x + 0.8 * y * y)) * (1 - 0.25 * x * x - 0.25 * y * y)
        return np.column_stack([0.5 * length_mm * x, 0.5 * width_mm * (y + 0.15 * x * x), height_mm * unit[:, 2] * top])
    return Specimen("lobe", to_mm, cells, held=lambda unit: unit[:, 0] < 2 / 3 + 1e-9)


@dataclass
class Mesh:
    kind: str                          # "C3D4" (only for files), "C3D10", "C3D20"
    points: np.ndarray                 # mm
    elements: np.ndarray               # in the order of CalculiX
    faces: np.ndarray                  # of the boundary: 3, 6 or 8 nodes, looking outwards
    held_faces: np.ndarray             # which of them
    unit: np.ndarray = field(default=None)  # where each node was in the unit cube

    def held_nodes(self):
        return np.unique(self.faces[self.held_faces])


def grid(cells):
    """Nodes of a grid in the unit cube, and its cells' eight corners; corner k is at (k & 1, k & 2, k & 4)."""
    nx, ny, nz = cells
    axes = [np.linspace(0, 1, n + 1) for n in cells]
    unit = np.array(list(itertools.product(*axes)))
    number = lambda i, j, k: (i * (ny + 1) + j) * (nz + 1) + k
    corners = [[number(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1)) for c in range(8)]
               for i in range(nx) for j in range(ny) for k in range(nz)]
    return unit, np.array(corners)


def tetrahedra_of(corners, points):
    cells = np.concatenate([corners[:, list(path)] for path in KUHN])
    a, b, c, d = (points[cells[:, i]] for i in range(4))
    turned = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0
    cells[turned] = cells[turned][:, [0, 2, 1, 3]]
    return cells


def experiment_mesh(specimen):
    unit, corners = grid(specimen.cells)
    points = specimen.to_mm(unit)
    cells = tetrahedra_of(corners, points)
    return with_boundary(specimen, "C3D4", points, cells, unit)


def nested_mesh(specimen, times=2):
    """C3D10 that fill exactly what the experiment's tetrahedra fill: a grid `times` as fine, placed linearly in them."""
    unit, corners = grid(tuple(times * n for n in specimen.cells))
    points = kuhn_interpolated(specimen, unit)
    cells = tetrahedra_of(corners, points)
    points, unit, cells = with_mid_sides(points, unit, cells, TET_EDGES)
    return with_boundary(specimen, "C3D10", points, cells, unit)


def brick_mesh(specimen, cells):
    """C3D20 of the smooth shape: of a block, the same body in another grid, with thin cells under the tools."""
    unit, corners = grid(cells)
    unit[:, 2] = 1 - (1 - unit[:, 2]) ** 1.5
    corners = corners[:, [0, 1, 3, 2, 4, 5, 7, 6]]
    _, unit, elements = with_mid_sides(unit, unit, corners, BRICK_EDGES)
    return with_boundary(specimen, "C3D20", specimen.to_mm(unit), elements, unit)


def kuhn_interpolated(specimen, unit):
    n = np.asarray(specimen.cells)
    low = np.minimum((unit * n + 1e-9).astype(int), n - 1)
    at = unit * n - low
    order = np.argsort(-at, axis=1, kind="stable")
    corner, value = low.copy(), None
    sorted_at = np.take_along_axis(at, order, axis=1)
    weights = np.column_stack([1 - sorted_at[:, 0], sorted_at[:, :-1] - sorted_at[:, 1:], sorted_at[:, -1]])
    value = weights[:, :1] * specimen.to_mm(corner / n)
    for step in range(3):
        corner[np.arange(len(corner)), order[:, step]] += 1
        value = value + weights[:, step + 1: step + 2] * specimen.to_mm(corner / n)
    return value


TET_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
BRICK_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
# Faces as corners, outwards.
TET_FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
BRICK_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def with_mid_sides(points, unit, corners, edges):
    ends = np.sort(np.concatenate([corners[:, list(e)] for e in edges]), axis=1)
    unique, which = np.unique(ends, axis=0, return_inverse=True)
    middles = len(points) + which.reshape(len(edges), -1).T
    halfway = lambda x: np.concatenate([x, x[unique].mean(axis=1)])
    return halfway(points), halfway(unit), np.hstack([corners, middles])


def with_boundary(specimen, kind, points, elements, unit):
    corner_faces, edges = (BRICK_FACES, BRICK_EDGES) if kind == "C3D20" else (TET_FACES, TET_EDGES)
    columns = []
    for face in corner_faces:
        middles = []
        if kind != "C3D4":
            first_middle = 8 if kind == "C3D20" else 4
            for a, b in zip(face, face[1:] + face[:1]):
                middles.append(first_middle + next(i for i, e in enumerate(edges) if set(e) == {a, b}))
        columns.append(list(face) + middles)
    faces = np.concatenate([elements[:, c] for c in columns])
    corners = len(corner_faces[0])
    _, first, count = np.unique(np.sort(faces[:, :corners], axis=1), axis=0, return_index=True, return_counts=True)
    faces = faces[first[count == 1]]
    held = specimen.is_held(unit[faces.ravel()]).reshape(faces.shape).all(axis=1)
    return Mesh(kind, points, elements, faces, held, unit)


def boundary_triangles(mesh):
    """Of an experiment's mesh: corners (n, 3, 3), centroids, areas, outward normals."""
    corners = mesh.points[mesh.faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    twice = np.linalg.norm(cross, axis=1)
    return corners, corners.mean(axis=1), 0.5 * twice, cross / twice[:, None]


def write_vtu(path, mesh, **arrays):
    """VTK's XML, plain text, with arrays of a number a node."""
    n, cells = len(mesh.points), mesh.elements[:, :4]
    text = lambda rows, form: "\n".join(" ".join(form % x for x in row) for row in rows)
    fields = "\n".join(f'<DataArray type="Float64" Name="{name}" format="ascii">\n'
                       + text(values.astype(float).reshape(-1, 1), "%g") + "\n</DataArray>" for name, values in arrays.items())
    path.write_text(f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid><Piece NumberOfPoints="{n}" NumberOfCells="{len(cells)}">
<PointData>
{fields}
</PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
{text(mesh.points, "%.17g")}
</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">
{text(cells, "%d")}
</DataArray><DataArray type="Int64" Name="offsets" format="ascii">
{text((4 + 4 * np.arange(len(cells))).reshape(-1, 1), "%d")}
</DataArray><DataArray type="UInt8" Name="types" format="ascii">
{text(np.full((len(cells), 1), 10), "%d")}
</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
""")
