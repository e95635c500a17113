"""Plates in plane strain whose law is known: quadratic triangles, Newton's method, laws as functions of F. Shares nothing with
core/. Stress is derived by hand, its slope by complex steps."""

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve


# Laws: dW by I1, I2, J and by the squared stretches along fibres, each isochoric part by the chain rule.

def isochoric(by_k1, by_k2, volume, fibre=None, angles_deg=()):
    """P(F) for W(K1, K2) + U(J) + sum w(Ia): `by_k1(k1, k2)`, `by_k2(k1, k2)`, `volume(J)`, `fibre(Ia)` are slopes of the energy."""
    def stress(f):
        a, b, c, d = (f[..., i] for i in range(4))
        j = a * d - b * c
        by_j = np.stack([d, -c, -b, a], -1)
        i1 = a * a + b * b + c * c + d * d + 1
        i2 = i1 + j * j - 1
        k1, k2 = i1 * j ** (-2 / 3) - 3, i2 * j ** (-4 / 3) - 3
        d_k1 = 2 * f * (j ** (-2 / 3))[..., None] - (2 / 3 * i1 * j ** (-5 / 3))[..., None] * by_j
        d_i2 = 2 * f + (2 * j)[..., None] * by_j
        d_k2 = d_i2 * (j ** (-4 / 3))[..., None] - (4 / 3 * i2 * j ** (-7 / 3))[..., None] * by_j
        p = (by_k1(k1, k2) + 0 * j)[..., None] * d_k1 + (by_k2(k1, k2) + 0 * j)[..., None] * d_k2
        p = p + (volume(j) + 0 * j)[..., None] * by_j
        for angle in np.deg2rad(angles_deg):
            x, y = np.cos(angle), np.sin(angle)
            along = np.stack([a * x + b * y, c * x + d * y], -1)
            i4 = (along ** 2).sum(-1)
            ia = i4 * j ** (-2 / 3)
            d_i4 = 2 * np.stack([along[..., 0] * x, along[..., 0] * y, along[..., 1] * x, along[..., 1] * y], -1)
            d_ia = d_i4 * (j ** (-2 / 3))[..., None] - (2 / 3 * i4 * j ** (-5 / 3))[..., None] * by_j
            p = p + fibre(ia)[..., None] * d_ia
        return p
    return stress


def ogden(mu, alpha, volume):
    """By principal stretches, apart by a little where they are equal."""
    def stress(f):
        a, b, c, d = (f[..., i] for i in range(4))
        j = a * d - b * c
        total = a * a + b * b + c * c + d * d
        root = np.sqrt(total * total - 4 * j * j + 1e-10 * total * total)
        p, q = (total + root) / 2, (total - root) / 2
        s = alpha / 2
        powers = p ** s + q ** s + 1
        by_total = s * (p ** s - q ** s) / root
        by_square = -s * (p ** (s - 1) - q ** (s - 1)) / root  # of J^2
        shape = 2 * mu / alpha ** 2 * j ** (-alpha / 3)
        by_j = np.stack([d, -c, -b, a], -1)
        return ((shape * by_total)[..., None] * 2 * f
                + (shape * (by_square * 2 * j - alpha / 3 * powers / j) + volume(j))[..., None] * by_j)
    return stress


def neo_hookean(c10, d):
    return isochoric(lambda k1, k2: c10 + 0 * k1, lambda k1, k2: 0 * k1, lambda j: 2 * d * (j - 1))


# Bodies.

class Plate:
    """A plate around a quarter of an elliptic hole at the origin, 1 wide and `height` high; n triangles' sides around and
    m outwards, finer near the hole."""

    def __init__(self, radii, height, around, outwards, quadratic, weight=lambda places: 1 + 0 * places[..., 0]):
        step = 2 if quadratic else 1
        n, m = around * step, outwards * step
        grid = np.arange((n + 1) * (m + 1)).reshape(n + 1, m + 1)
        angle = np.linspace(0, np.pi / 2, n + 1)
        # As many sides on the plate's right border as fit its share of the corner.
        corner = n // 2 if not quadratic else 2 * (around // 2)
        border = np.concatenate([np.stack([np.ones(corner + 1), np.linspace(0, height, corner + 1)], 1),
                                 np.stack([np.linspace(1, 0, n - corner + 1)[1:], np.full(n - corner, height)], 1)])
        hole = np.stack([radii[0] * np.cos(angle), radii[1] * np.sin(angle)], 1)
        out = np.linspace(0, 1, m + 1) ** 1.6
        if quadratic:
            for k in range(1, m, 2):
                out[k] = (out[k - 1] + out[k + 1]) / 2
            for k in range(1, n, 2):
                hole[k] = (hole[k - 1] + hole[k + 1]) / 2
                border[k] = (border[k - 1] + border[k + 1]) / 2
        self.points = (hole[:, None] * (1 - out[:, None]) + border[:, None] * out[:, None]).reshape(-1, 2)
        self.triangles = []
        for i in range(0, n, step):
            for k in range(0, m, step):
                a, b, c, d = grid[i, k], grid[i, k + step], grid[i + step, k + step], grid[i + step, k]
                if not quadratic:
                    self.triangles += [[a, b, c], [a, c, d]]
                else:
                    mid = grid[i + 1, k + 1]
                    self.triangles += [[a, b, c, grid[i, k + 1], grid[i + 1, k + 2], mid],
                                       [a, c, d, mid, grid[i + 2, k + 1], grid[i + 1, k]]]
        self.triangles = np.array(self.triangles)
        self.height, self.weight = height, weight
        if quadratic:
            # Straight sides: a diagonal's middle is the middle of its ends.
            corners = self.points[self.triangles[:, :3]]
            for s in range(3):
                self.points[self.triangles[:, 3 + s]] = (corners[:, s] + corners[:, (s + 1) % 3]) / 2
            self._prepare()

    def side(self, name):
        x, y = self.points.T
        return np.flatnonzero({"left": np.abs(x) < 1e-9, "right": np.abs(x - 1) < 1e-9, "bottom": np.abs(y) < 1e-9,
                               "top": np.abs(y - self.height) < 1e-9}[name])

    def _prepare(self):
        gradients, areas, places = [], [], []
        for r, t in ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3)):
            l = 1 - r - t
            values = np.array([l * (2 * l - 1), r * (2 * r - 1), t * (2 * t - 1), 4 * l * r, 4 * r * t, 4 * t * l])
            slopes = np.array([[1 - 4 * l, 1 - 4 * l], [4 * r - 1, 0], [0, 4 * t - 1], [4 * (l - r), -4 * r], [4 * t, 4 * r],
                               [-4 * t, 4 * (l - t)]])
            nodes = self.points[self.triangles]
            jacobian = np.einsum("eai,aj->eij", nodes, slopes)
            by_place = np.einsum("aj,ejk->eak", slopes, np.linalg.inv(jacobian))
            g = np.zeros((len(nodes), 4, 6, 2))
            for i in range(2):
                for j in range(2):
                    g[:, 2 * i + j, :, i] = by_place[:, :, j]
            gradients.append(g.reshape(len(nodes), 4, 12))
            areas.append(np.linalg.det(jacobian) / 6)
            places.append(np.einsum("a,eai->ei", values, nodes))
        self.g, areas, places = np.stack(gradients, 1), np.stack(areas, 1), np.stack(places, 1)
        assert areas.min() > 0
        self.w = areas * self.weight(places)
        self.freedoms = (2 * self.triangles[:, :, None] + np.arange(2)).reshape(len(self.triangles), 12)
        self.rows, self.columns = np.repeat(self.freedoms, 12, 1).ravel(), np.tile(self.freedoms, (1, 12)).ravel()

    def forces(self, law, u):
        f = np.einsum("eqfd,ed->eqf", self.g, u[self.freedoms]) + np.array([1.0, 0, 0, 1])
        nodal = np.einsum("eq,eqf,eqfd->ed", self.w, law(f), self.g)
        return f, np.bincount(self.freedoms.ravel(), nodal.ravel(), 2 * len(self.points))

    def equilibrium(self, law, u, prescribed):
        """`prescribed`: {freedom: displacement}. From u, by Newton's method; None where it does not get there."""
        fixed = np.array(sorted(prescribed))
        free = np.setdiff1d(np.arange(len(u)), fixed)
        move = np.zeros(len(u))
        move[fixed] = [prescribed[i] for i in fixed] - u[fixed]
        for _ in range(25):
            with np.errstate(all="ignore"):
                f, force = self.forces(law, u)
                slope = np.stack([law(f + 1e-30j * np.eye(4)[i]).imag / 1e-30 for i in range(4)], -1)
            if not np.isfinite(force).all():
                return None
            blocks = np.einsum("eqfc,eqfd->ecd", self.g, np.matmul(slope * self.w[..., None, None], self.g))
            k = sparse.csc_matrix((blocks.ravel(), (self.rows, self.columns)), (len(u), len(u)))
            change = move.copy()
            change[free] = spsolve(k[free][:, free], -force[free] - (k @ move)[free])
            u, move = u + change, 0 * move
            if np.abs(change).max() < 1e-10:
                return u
        return None

    def pulled(self, law, right, top, u=None):
        """Displacement with the right side at ux = right, the top at uy = top, the others on rollers; forces of the sides."""
        sides = [("left", 0, 0.0), ("right", 0, right), ("bottom", 1, 0.0), ("top", 1, top)]
        start = np.zeros(2 * len(self.points)) if u is None else u
        reached, step = 0.0, 1.0
        begun = {2 * p + d: start[2 * p + d] for name, d, _ in sides for p in self.side(name)}
        while reached < 1:
            share = min(1.0, reached + step)
            goal = {2 * p + d: begun[2 * p + d] * (1 - share) + value * share for name, d, value in sides for p in self.side(name)}
            found = self.equilibrium(law, start, goal)
            if found is None:
                step /= 2
                if step < 0.02:
                    raise ArithmeticError("no equilibrium")
                continue
            start, reached = found, share
        forces = self.forces(law, start)[1].reshape(-1, 2)
        return start, {name: forces[self.side(name), d].sum() for name, d, _ in sides}

    def interpolation(self, points):
        """A matrix from this body's displacements, a row a point, to those at `points`."""
        corners = self.points[self.triangles[:, :3]]
        edge = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], -1)
        inverse = np.linalg.inv(edge)
        weights = sparse.lil_matrix((len(points), len(self.points)))
        for i, point in enumerate(points):
            r, t = np.einsum("eij,ej->ie", inverse, point - corners[:, 0])
            e = np.argmax(np.minimum(np.minimum(r, t), 1 - r - t))
            r, t = r[e], t[e]
            l = 1 - r - t
            weights[i, self.triangles[e]] = [l * (2 * l - 1), r * (2 * r - 1), t * (2 * t - 1), 4 * l * r, 4 * r * t, 4 * t * l]
        return weights.tocsr()


def write_plane(file, points, triangles, arrays=None):
    """Triangles as a .vtu in text; `arrays`: {name: integers, one a point}."""
    def data(kind, name, values, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                f'{" ".join(map(str, values))}</DataArray>\n')
    flat = [repr(float(x)) for p in points for x in (*p, 0.0)]
    file.write_text('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>\n'
                    f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(triangles)}">\n<PointData>\n'
                    + "".join(data("Int32", name, values) for name, values in (arrays or {}).items())
                    + "</PointData>\n<Points>\n" + data("Float64", "Points", flat, 3) + "</Points>\n<Cells>\n"
                    + data("Int64", "connectivity", [int(i) for t in triangles for i in t])
                    + data("Int64", "offsets", [3 * (i + 1) for i in range(len(triangles))])
                    + data("UInt8", "types", [5] * len(triangles))
                    + "</Cells>\n</Piece>\n</UnstructuredGrid></VTKFile>\n")
