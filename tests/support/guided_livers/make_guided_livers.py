#!/usr/bin/python3
"""Makes guidance cases of real livers, SIMULATED: make_guided_livers.py OUT --livers LiTS-10,LiTS-12 [--kinds a,b,d] [--seed N] [--whole]

Each is a folder with guidance.json and truth.json as guidance_judge.py reads them. CalculiX (C3D10, NLGEOM, neo-Hookean)
moves the liver on a mesh of its own: a back on springs, a place that is held, patches that are moved, gravity turned.
a: a stylus' swabs, the back pushed; b: a laparoscope's cloud, gravity and a retractor; d: a lobe mobilised and turned;
t: a laparoscope's cloud, one place pulled by a tool of known place whose force is asked for, the support declared.
--whole: the same organs, moved alike, whose whole surface is seen: what the hidden side costs.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import meshio
import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import lattice

LIVERS = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA", "../shared/data")) / "livers_couinaud"
TRUTH_EDGE_MM, DECLARED_EDGE_MM = 15.0, 12.5
DECLARED_NU, TRUE_NU = 0.45, 0.475
DENSITY = 1.05e-6
RIGHT, FRONT, UP = np.array([-1.0, 0, 0]), np.array([0, -1.0, 0]), np.array([0, 0, 1.0])


def unit(v):
    return v / np.linalg.norm(v)


class Organ:
    def __init__(self, points, cells):
        self.points, self.cells = points, cells
        self.faces = lattice.boundary(cells)
        self.surface = np.unique(self.faces)
        corner = points[self.faces]
        cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]) / 2
        self.face_area = np.linalg.norm(cross, axis=1)
        self.normals = np.zeros_like(points)
        self.area = np.zeros(len(points))
        for k in range(3):
            np.add.at(self.normals, self.faces[:, k], cross)
            np.add.at(self.area, self.faces[:, k], self.face_area / 3)
        self.normals[self.surface] /= np.linalg.norm(self.normals[self.surface], axis=1)[:, None]

    def nearest(self, place):
        return self.points[self.surface[np.argmin(np.linalg.norm(self.points[self.surface] - place, axis=1))]]


def design_of(kind, organ, rng):
    """What is done to the organ: places from the shape alone."""
    size = np.cbrt(lattice.volumes(organ.points, organ.cells).sum() / 1.5e6)
    middle = organ.points[organ.surface].mean(axis=0)
    back = organ.surface[(organ.normals[organ.surface] @ FRONT < -0.35)]
    any_of = lambda nodes: organ.points[rng.choice(nodes)]
    design = {"held_kPa_per_mm": 0.4, "steps": [0.5, 1.0], "moved": [], "gravity": [0, 0, 0], "held": []}
    def far_from(places, among, apart):
        for _ in range(200):
            place = any_of(among)
            if all(np.linalg.norm(place - p) > apart * size for p in places):
                return place
        return place
    hang = organ.nearest(middle + size * (40 * UP - 40 * FRONT + rng.normal(0, 15, 3)))
    design["held"] = [[hang, rng.uniform(20, 30) * size]]
    tilt = lambda amount: rng.normal(0, 1, 3) * amount
    if kind == "a":
        design["foundation"] = 10 ** rng.uniform(-3, -2)
        first = far_from([hang], back, 70)
        second = far_from([hang, first], back, 70)
        for place in (first, second):
            by = -organ.normals[organ.surface[np.argmin(np.linalg.norm(organ.points[organ.surface] - place, axis=1))]]
            by = unit(unit(by) + rng.normal(0, 0.45, 3)) * rng.uniform(14, 26) * rng.choice([1, 1, -1])
            design["moved"].append([place, rng.uniform(25, 45) * size, by, None])
    elif kind == "b":
        design["foundation"] = 10 ** rng.uniform(-2.0, -1.1)
        low = organ.surface[organ.points[organ.surface] @ UP < np.percentile(organ.points[organ.surface] @ UP, 35)]
        place = far_from([hang], low, 80)
        design["moved"] = [[place, rng.uniform(14, 22) * size, unit(FRONT + UP + rng.normal(0, 0.5, 3)) * rng.uniform(14, 28), None]]
        design["gravity"] = tilt(700)
    elif kind == "d":
        design["foundation"], design["mobilised"] = 10 ** rng.uniform(-1.6, -1), True
        design["held"] = [[organ.nearest(middle + size * (60 * -RIGHT + 20 * -FRONT + rng.normal(0, 12, 3))), 28 * size]]
        right = organ.surface[(organ.points[organ.surface] @ RIGHT > np.percentile(organ.points[organ.surface] @ RIGHT, 70))]
        place = any_of(right)
        turn = Rotation.from_rotvec(unit(UP + rng.normal(0, 0.5, 3)) * np.radians(rng.uniform(16, 32)) * rng.choice([-1, 1]))
        design["moved"] = [[place, rng.uniform(26, 36) * size, None, [design["held"][0][0], turn.as_matrix()]]]
        design["gravity"] = tilt(900)
    elif kind == "t":
        design["foundation"] = None
        design["held_kPa_per_mm"] = None  # fixed
        design["held"] = [[hang, rng.uniform(55, 80) * size]]
        front = organ.surface[(organ.normals[organ.surface] @ FRONT > 0.3) & (np.linalg.norm(organ.points[organ.surface] - hang, axis=1) > 90 * size)]
        place = any_of(front)
        normal = organ.normals[organ.surface[np.argmin(np.linalg.norm(organ.points[organ.surface] - place, axis=1))]]
        design["moved"] = [[place, rng.uniform(8, 14), unit(normal + rng.normal(0, 0.5, 3)) * rng.uniform(30, 55) * size, None]]
    return design


def solved(organ, youngs, design):
    """Displacements of the corners at each step, and the force on the nodes that are moved (N)."""
    points, cells = organ.points, organ.cells
    pairs = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
    edges = np.sort(np.concatenate([cells[:, p] for p in pairs]), axis=1)
    names, middle = np.unique(edges, axis=0, return_inverse=True)
    middle = middle.reshape(6, -1).T + len(points)
    nodes = np.vstack([points, points[names].mean(axis=1)])
    lines = ["*NODE, NSET=NALL"] + [f"{i}, {x:.10g}, {y:.10g}, {z:.10g}" for i, (x, y, z) in enumerate(nodes, 1)]
    groups = np.unique(youngs)
    for g, value in enumerate(groups):
        lines.append(f"*ELEMENT, TYPE=C3D10, ELSET=E{g}")
        lines += [", ".join(map(str, [e + 1, *(cells[e] + 1), *(middle[e] + 1)])) for e in np.flatnonzero(youngs == value)]
    number = len(cells)
    def springs(which, weights, k):
        nonlocal number
        for n, w in zip(which, weights):
            for axis in range(3):
                number += 1
                lines.extend([f"*ELEMENT, TYPE=SPRING1, ELSET=S{number}", f"{number}, {n + 1}", f"*SPRING, ELSET=S{number}", str(axis + 1), f"{k * w:.8g}"])
    fixed = set()
    if design["foundation"]:
        back = organ.surface[organ.normals[organ.surface] @ FRONT < -0.25]
        weight = organ.area[back].copy()
        if design.get("mobilised"):  # the right half hangs nearly free
            weight[organ.points[back] @ RIGHT > np.median(organ.points[organ.surface] @ RIGHT)] *= 0.01
        springs(back, weight, design["foundation"])
    for place, radius in design["held"]:
        near = organ.surface[np.linalg.norm(points[organ.surface] - place, axis=1) < radius]
        if design["held_kPa_per_mm"]:
            springs(near, organ.area[near], design["held_kPa_per_mm"])
        else:
            fixed |= set(near)
            fixed |= set(np.flatnonzero(np.isin(names, near).all(axis=1)) + len(points))
    mu = groups / (2 * (1 + TRUE_NU))
    bulk = groups / (3 * (1 - 2 * TRUE_NU))
    for g in range(len(groups)):
        lines += [f"*MATERIAL, NAME=M{g}", "*HYPERELASTIC, NEO HOOKE", f"{mu[g] / 2:.8g}, {2 / bulk[g]:.8g}", "*DENSITY", f"{DENSITY:.6g}", f"*SOLID SECTION, ELSET=E{g}, MATERIAL=M{g}"]
    moved = []
    for place, radius, by, about in design["moved"]:
        on = organ.surface[np.linalg.norm(points[organ.surface] - place, axis=1) < radius]
        if len(on) == 0:
            on = organ.surface[[np.argmin(np.linalg.norm(points[organ.surface] - place, axis=1))]]
        moved.append((on, np.broadcast_to(by, (len(on), 3)) if about is None else (points[on] - about[0]) @ about[1].T + about[0] - points[on]))
    lines.append("*BOUNDARY")
    lines += [f"{n + 1}, 1, 3" for n in sorted(fixed)]
    gravity = np.array(design["gravity"], float)
    for fraction in design["steps"]:
        lines += ["*STEP, NLGEOM, INC=100", "*STATIC", "0.25, 1., 1e-3, 1.", "*BOUNDARY"]
        for on, by in moved:
            lines += [f"{n + 1}, {axis + 1}, {axis + 1}, {fraction * by[i, axis]:.8g}" for i, n in enumerate(on) for axis in range(3)]
        if np.linalg.norm(gravity) > 0:
            size = np.linalg.norm(gravity)
            for g in range(len(groups)):
                lines += ["*DLOAD, OP=MOD", f"E{g}, GRAV, {size * fraction:.8g}, " + ", ".join(f"{x:.8g}" for x in gravity / size)]
        lines += ["*NODE PRINT, NSET=NALL, FREQUENCY=999", "U, RF", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "body.inp").write_text("\n".join(lines) + "\n")
        done = subprocess.run(["ccx", "body"], cwd=folder, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"}, check=False)
        text = (pathlib.Path(folder) / "body.dat").read_text() if (pathlib.Path(folder) / "body.dat").exists() else ""
    tables, forces = [], []
    for line in text.splitlines():
        if line.lstrip().startswith("displacements"):
            tables.append([]); into = tables
        elif line.lstrip().startswith("forces"):
            forces.append([]); into = forces
        elif line.strip():
            into[-1].append([float(x) for x in line.split()[1:4]])
    if len(tables) != len(design["steps"]):
        raise RuntimeError("CalculiX did not finish: " + done.stdout[-300:])
    on = np.concatenate([on for on, _ in moved])
    return [np.array(t)[:len(points)] for t in tables], [np.array(f)[on].sum(axis=0) / 1000 for f in forces]


def seen_from(eye, organ, now, rng, cone_deg, towards):
    """Points of the surface that a camera sees, as barycentric places: faces, weights."""
    corner = now[organ.faces]
    chosen = rng.choice(len(organ.faces), 40000, p=organ.face_area / organ.face_area.sum())
    weights = rng.dirichlet([1, 1, 1], len(chosen))
    places = np.einsum("nk,nkd->nd", weights, corner[chosen])
    normal = np.cross(corner[chosen, 1] - corner[chosen, 0], corner[chosen, 2] - corner[chosen, 0])
    ray = places - eye
    depth = np.linalg.norm(ray, axis=1)
    ray /= depth[:, None]
    facing = np.einsum("nd,nd->n", unit_rows(normal), -ray)
    axis = unit(towards - eye)
    along = ray @ axis
    side = unit(np.cross(axis, [0.3, 0.5, 0.8])); other = np.cross(axis, side)
    pixel = np.round(np.stack([ray @ side, ray @ other], axis=1) / along[:, None] / 0.02).astype(int)
    _, key = np.unique(pixel, axis=0, return_inverse=True)
    key = key.ravel()
    front = np.full(key.max() + 1, np.inf)
    np.minimum.at(front, key, depth)
    visible = (facing > 0.15) & (along > np.cos(np.radians(cone_deg))) & (depth < front[key] + 6)
    return chosen[visible], weights[visible], visible.mean()


def unit_rows(v):
    return v / np.linalg.norm(v, axis=1)[:, None]


def curves_of(organ):
    """Lines on the surface at rest that an anatomist would know, by the shape alone: the lower rim, right and left,
    and one from it up the front."""
    points = organ.points[organ.surface]
    low, high = np.percentile(points[:, 0], [6, 94])
    falciform_x = low + 0.62 * (high - low)  # LPS: x grows to the left
    rim = []
    for x in np.arange(low, high, 4):
        slab = points[np.abs(points[:, 0] - x) < 7]
        if len(slab):
            rim.append(slab[np.argmax(slab @ (-UP + 0.5 * FRONT))])
    rim = smooth(np.array(rim))
    slab = points[(np.abs(points[:, 0] - falciform_x) < 8) & (organ.normals[organ.surface] @ FRONT > 0.2)]
    front = []
    if len(slab):
        for z in np.arange(slab[:, 2].min(), slab[:, 2].max(), 5):
            near = slab[np.abs(slab[:, 2] - z) < 7]
            if len(near):
                front.append(near[np.argmax(near @ FRONT)])
    curves = {"ridge-right": rim[rim[:, 0] < falciform_x], "ridge-left": rim[rim[:, 0] >= falciform_x]}
    if len(front) > 3:
        curves["falciform"] = smooth(np.array(front))
    return {k: v for k, v in curves.items() if len(v) > 3}


def smooth(line):
    for _ in range(3):
        line = np.r_[line[:1], 0.25 * line[:-2] + 0.5 * line[1:-1] + 0.25 * line[2:], line[-1:]]
    return line


class Carried:
    """Places of the organ at rest, wherever it goes: by the nearest cell's shape functions."""

    def __init__(self, organ, places):
        tree = cKDTree(organ.points[organ.cells].mean(axis=1))
        _, near = tree.query(places, k=40)
        self.cells, self.weights = [], []
        for place, among in zip(places, near):
            corner = organ.points[organ.cells[among]]
            frame = np.linalg.inv((corner[:, 1:] - corner[:, :1]).transpose(0, 2, 1))
            inner = np.einsum("nij,nj->ni", frame, place - corner[:, 0])
            weights = np.c_[1 - inner.sum(axis=1), inner]
            best = np.argmax(weights.min(axis=1))
            self.cells.append(organ.cells[among[best]]); self.weights.append(weights[best])

    def at(self, now):
        return np.einsum("nk,nkd->nd", np.array(self.weights), now[np.array(self.cells)])


def spread(points, count):
    chosen = [int(np.argmax(np.linalg.norm(points - points.mean(axis=0), axis=1)))]
    away = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < count:
        chosen.append(int(np.argmax(away)))
        away = np.minimum(away, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return points[chosen]


def best_rigid(rest, true):
    a, b = rest - rest.mean(axis=0), true - true.mean(axis=0)
    u, _, v = np.linalg.svd(a.T @ b)
    turn = v.T @ np.diag([1, 1, np.sign(np.linalg.det(v.T @ u.T))]) @ u.T
    return np.linalg.norm(a @ turn.T - b, axis=1)


def write_ply(file, points):
    header = f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    file.write_text(header + "".join("%.4f %.4f %.4f\n" % tuple(p) for p in points))


def write_table(file, points, ids=None):
    rows = [",".join(([ids[i]] if ids else []) + ["%.4f" % x for x in p]) for i, p in enumerate(points)]
    file.write_text(("id," if ids else "") + "x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")


def make(folder, liver, kind, seed, whole):
    if (folder / "truth.json").exists():
        return
    rng = np.random.default_rng([seed, ord(kind), *map(ord, liver)])
    shape = lattice.Shape(LIVERS / f"{liver}_liver.nii.gz")
    organ = Organ(*lattice.tetrahedra(shape, TRUTH_EDGE_MM, rng))
    points, cells = lattice.tetrahedra(shape, DECLARED_EDGE_MM, rng)
    design = design_of(kind, organ, rng)
    youngs = round(float(rng.uniform(4, 12)), 2)
    moduli, declared = np.full(len(organ.cells), youngs), np.full(len(cells), youngs)
    if kind in "bd":
        for _ in range(int(rng.integers(0, 3))):
            place, radius = organ.points[rng.integers(len(organ.points))], rng.uniform(14, 20)
            for field, nodes, tets in ((moduli, organ.points, organ.cells), (declared, points, cells)):
                field[np.linalg.norm(nodes[tets].mean(axis=1) - place, axis=1) < radius] = round(5 * youngs, 2)
    moved, pulls = solved(organ, moduli, design)
    folder.mkdir(parents=True, exist_ok=True)
    inner = points[np.setdiff1d(np.arange(len(points)), np.unique(lattice.boundary(cells)))]
    targets = spread(inner, 90)
    carried = Carried(organ, targets)
    curves = curves_of(organ)
    meshio.Mesh(points, [("tetra", cells)], cell_data={"youngs_modulus_kPa": [declared]}).write(folder / "liver.vtu", binary=False)
    names = [f"t{i:03}" for i in range(1, len(targets) + 1)]
    write_table(folder / "targets.csv", targets, names)
    for name, line in curves.items():
        write_table(folder / f"{name}.csv", line)
    frames, truths = [], []
    for f, u in enumerate(moved):
        now = organ.points + u
        noise = 0.85 if kind == "a" else 0.5
        middle = now[organ.surface].mean(axis=0)
        away = unit(FRONT + 0.5 * RIGHT - 0.3 * UP + rng.normal(0, 0.3, 3))
        towards = organ.nearest(middle + 60 * away) * 0.5 + 0.5 * middle + rng.normal(0, 20, 3)
        distance = 500 if kind == "a" else 160 + np.ptp(organ.points @ away) / 2
        faces, weights, share = seen_from(towards + distance * away, organ, now, rng, 12 if kind == "a" else 27, towards)
        if whole:
            faces, share = rng.choice(len(organ.faces), 3500, p=organ.face_area / organ.face_area.sum()), 1.0
            weights = rng.dirichlet([1, 1, 1], len(faces))
        if kind == "a" and not whole:
            places = np.einsum("nk,nkd->nd", weights, now[organ.faces[faces]])
            lines = [places[rng.integers(len(places))] for _ in range(8)]
            near = np.min([np.linalg.norm(np.cross(places - a, unit(b - a)), axis=1) for a, b in zip(lines[::2], lines[1::2])], axis=0)
            kept = np.flatnonzero(near < 12)
            kept = rng.choice(kept, min(len(kept), int(rng.integers(140, 190))), replace=False)
        else:
            kept = rng.choice(len(faces), min(len(faces), 3500), replace=False)
        faces, weights = faces[kept], weights[kept]
        true = np.einsum("nk,nkd->nd", weights, now[organ.faces[faces]])
        if kind != "a":
            hole = true[rng.integers(len(true))]
            true = true[np.linalg.norm(true - hole, axis=1) > rng.uniform(8, 22)]
        cloud = true + rng.normal(0, noise, true.shape)
        if kind != "a":
            off = rng.choice(len(cloud), len(cloud) // 50, replace=False)
            cloud[off] += rng.normal(0, 15, (len(off), 3))
        pose = np.eye(4)
        pose[:3, :3] = Rotation.random(random_state=int(rng.integers(1 << 30))).as_matrix()
        pose[:3, 3] = np.array([0, 0, 200.0]) + rng.normal(0, 15, 3) - pose[:3, :3] @ middle
        guess = np.eye(4)
        turn = Rotation.from_rotvec(unit(rng.normal(size=3)) * np.radians(rng.uniform(4, 9.5))).as_matrix()
        guess[:3, :3] = turn @ pose[:3, :3]
        shift = unit(rng.normal(size=3)) * rng.uniform(6, 14)
        centre = pose[:3, :3] @ organ.points.mean(axis=0) + pose[:3, 3]
        guess[:3, 3] = turn @ (pose[:3, 3] - centre) + centre + shift
        there = lambda p: p @ pose[:3, :3].T + pose[:3, 3]
        name = f"f{f}"
        write_ply(folder / f"{name}.ply", there(cloud))
        frame = {"id": name, "points": f"{name}.ply", "noise_mm": noise, "pose_guess": guess.ravel().round(9).tolist(), "features": []}
        tree = cKDTree(true)
        for curve, line in curves.items():
            if kind == "t":
                continue
            moved_line = Carried(organ, line).at(now)
            seen = moved_line[tree.query(moved_line)[0] < 7]
            if len(seen) > 4:
                write_table(folder / f"{name}_{curve}.csv", there(seen + rng.normal(0, 1.5, seen.shape)))
                frame["features"].append({"id": curve, "points": f"{name}_{curve}.csv", "noise_mm": 1.5})
        at = there(carried.at(now))
        off = best_rigid(targets, at)
        truth = {"id": name, "visible_share": round(float(share), 3), "pose_scan_to_camera": pose.ravel().round(9).tolist(),
                 "displacement_mm": {"targets_mean": round(float(np.linalg.norm(carried.at(now) - targets, axis=1).mean()), 3)},
                 "best_rigid_tre_mm": {"mean": round(float(off.mean()), 3), "max": round(float(off.max()), 3)},
                 "targets": [{"id": i, "position_mm": p.round(4).tolist()} for i, p in zip(names, at)]}
        if kind == "t":
            place, radius = design["moved"][0][:2]
            on = organ.surface[np.linalg.norm(organ.points[organ.surface] - place, axis=1) < radius]
            if len(on) == 0:
                on = organ.surface[[np.argmin(np.linalg.norm(organ.points[organ.surface] - place, axis=1))]]
            frame["tools"] = [{"id": "grasper", "contact_mm": (there(now[on]).mean(axis=0) + rng.normal(0, 1, 3)).round(3).tolist(), "radius_mm": 10}]
            truth["tools"] = [{"id": "grasper", "force_N": (pose[:3, :3] @ pulls[f]).round(5).tolist()}]
        frames.append(frame); truths.append(truth)
    document = {"format": "glisson-guidance/1", "title": f"{liver}, SIMULATED", "model": {"mesh": "liver.vtu", "youngs_modulus_kPa": "youngs_modulus_kPa", "poisson_ratio": DECLARED_NU},
                "features": [{"id": c, "points": f"{c}.csv"} for c in curves], "frames": frames, "targets": "targets.csv"}
    if kind == "t":
        document["supports"] = [{"sphere": {"center_mm": np.round(place, 3).tolist(), "radius_mm": round(float(radius), 3)}} for place, radius in design["held"]]
    (folder / "guidance.json").write_text(json.dumps(document, indent=1) + "\n")
    (folder / "truth.json").write_text(json.dumps({"case": folder.name, "kind": kind, "liver": liver, "seed": seed, "frames": truths}, indent=1) + "\n")
    print(folder.name, [(t["best_rigid_tre_mm"]["mean"], t["displacement_mm"]["targets_mean"], t["visible_share"]) for t in truths], flush=True)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("out", type=pathlib.Path)
    words.add_argument("--livers", required=True)
    words.add_argument("--kinds", default="a,b,d,t")
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--whole", action="store_true")
    asked = words.parse_args()
    for liver in asked.livers.split(","):
        for kind in asked.kinds.split(","):
            try:
                make(asked.out / f"{liver}-{kind}{asked.seed}", liver, kind, asked.seed, asked.whole)
            except RuntimeError as error:
                print(f"{liver}-{kind}{asked.seed}: {error}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
