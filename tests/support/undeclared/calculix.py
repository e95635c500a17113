"""A body in CalculiX (ccx, Debian's calculix-ccx): its input file, the run, the displacements that come back.

Units are mm, kg, s, hence mN and kPa; ccx reads no number longer than 20 characters and prints seven digits. What a
run gave is kept by the SHA-256 of its input, because many experiments share a body.
"""

import hashlib
import os
import pathlib
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

import numpy as np

from specimens import Mesh


@dataclass
class Body:
    mesh: Mesh
    youngs_kPa: np.ndarray                # an element
    poisson_ratio: float = 0.45
    density_kg_mm3: float = 1e-6
    hyperelastic: str = None              # CalculiX's card and its constants, instead of the two above
    fibres: tuple = None                  # axis, ratio of the moduli along and across, and of the shear moduli
    foundation_kPa_per_mm: float = None   # under the held faces, instead of holding them
    sideways_kPa_per_mm: float = None     # ... along x and y, where that is another
    capsule_N_per_mm: float = None        # on all other faces
    attached: list = None                 # (which faces, kPa/mm): springs to the ground besides
    held_too: np.ndarray = None           # nodes that are held besides


@dataclass
class Load:
    nodes: np.ndarray                     # (n, 3) mN
    gravity_mm_s2: np.ndarray = None


def available():
    return shutil.which("ccx") is not None


def displacements(body, paths):
    """`paths` are lists of loads, each reached from the one before; large strain where the body is hyperelastic. Gives
    (path, load, node, 3) mm for the nodes of the body's mesh."""
    if body.hyperelastic:
        return [run(input_of(body, path)).reshape(len(path), -1, 3)[:, :len(body.mesh.points)] for path in paths]
    flat = [load for path in paths for load in path]
    found = run(input_of(body, flat)).reshape(len(flat), -1, 3)[:, :len(body.mesh.points)]
    return np.split(found, np.cumsum([len(path) for path in paths])[:-1])


def input_of(body, loads):
    mesh = body.mesh
    points, blocks, held = mesh.points, [], mesh.held_nodes()
    blocks.append((mesh.kind, "BODY", mesh.elements))
    if body.foundation_kPa_per_mm:
        points, layer, held = with_layer(mesh, points, mesh.faces[mesh.held_faces], FOUNDATION_MM)
        blocks.append((layer_kind(mesh), "GROUND", layer))
    if body.capsule_N_per_mm:
        points, layer, outer = with_layer(mesh, points, mesh.faces[~mesh.held_faces], CAPSULE_MM)
        blocks.append((layer_kind(mesh), "CAPSULE", layer))
        rim = np.isin(outer_base(mesh), held) if not body.foundation_kPa_per_mm else np.zeros(len(outer), bool)
        held = np.concatenate([held, outer[rim]])

    for patch, (faces, _) in enumerate(body.attached or []):
        points, layer, far = with_layer(mesh, points, mesh.faces[faces], FOUNDATION_MM)
        blocks.append((layer_kind(mesh), f"PATCH{patch}", layer))
        held = np.concatenate([held, far])
    if body.held_too is not None:
        held = np.union1d(held, body.held_too)

    lines = ["*NODE, NSET=NALL"]
    lines += [f"{i}, {p[0]:.12g}, {p[1]:.12g}, {p[2]:.12g}" for i, p in enumerate(points, 1)]
    element = 0
    for kind, name, elements in blocks:
        lines.append(f"*ELEMENT, TYPE={kind}, ELSET={name}")
        for nodes in elements:
            element += 1
            lines += wrapped([element, *(nodes + 1)])
    lines += materials(body)
    lines.append("*BOUNDARY")
    lines += [f"{n + 1}, 1, 3" for n in held]
    for load in loads:
        lines += step(body, load)
    return "\n".join(lines) + "\n"


FOUNDATION_MM = 0.2
CAPSULE_MM = 0.3


def layer_kind(mesh):
    return {"C3D10": "C3D15", "C3D20": "C3D20"}[mesh.kind]


def outer_base(mesh):
    return np.unique(mesh.faces[~mesh.held_faces])


def with_layer(mesh, points, faces, thickness_mm):
    """A layer of wedges or bricks grown outwards on faces: all points, the layer's elements, the nodes of its far side.
    Far nodes stand over np.unique(faces), in that order; the nodes half way over the corners follow."""
    corners = faces.shape[1] // 2
    base = np.unique(faces)
    normals = np.zeros((len(points), 3))
    for k in range(corners):
        a, b, c = (points[faces[:, (k + s) % corners]] for s in (0, 1, -1))
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        np.add.at(normals, faces[:, k], normal)
        np.add.at(normals, faces[:, corners + k], normal)
    up = normals[base] / np.linalg.norm(normals[base], axis=1)[:, None]
    corner_nodes = np.unique(faces[:, :corners])
    far = np.full(len(points), -1)
    far[base] = len(points) + np.arange(len(base))
    half = np.full(len(points), -1)
    half[corner_nodes] = len(points) + len(base) + np.arange(len(corner_nodes))
    up_of = np.zeros((len(points), 3))
    up_of[base] = up
    grown = np.concatenate([points, points[base] + thickness_mm * up,
                            points[corner_nodes] + 0.5 * thickness_mm * up_of[corner_nodes]])
    c, m = faces[:, :corners], faces[:, corners:]
    return grown, np.hstack([c, far[c], m, far[m], half[c]]), far[base]


def materials(body):
    lines = []
    moduli, which = np.unique(np.round(body.youngs_kPa, 9), return_inverse=True)
    for m, youngs in enumerate(moduli):
        members = np.flatnonzero(which == m) + 1
        lines.append(f"*ELSET, ELSET=E{m}")
        lines += [f"{e}," for e in members]
        lines.append(f"*MATERIAL, NAME=M{m}")
        lines += elastic_card(body, youngs, moduli[0])
        lines += ["*DENSITY", f"{body.density_kg_mm3:.6g}"]
        orientation = ", ORIENTATION=FIBRES" if body.fibres else ""
        lines.append(f"*SOLID SECTION, ELSET=E{m}, MATERIAL=M{m}{orientation}")
    if body.fibres:
        axis = np.asarray(body.fibres[0], float) / np.linalg.norm(body.fibres[0])
        other = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
        lines += ["*ORIENTATION, NAME=FIBRES", ", ".join(f"{x:.9g}" for x in (*axis, *(other / np.linalg.norm(other))))]
    springs = []
    if body.foundation_kPa_per_mm:
        springs = [("GROUND", body.foundation_kPa_per_mm, body.sideways_kPa_per_mm or body.foundation_kPa_per_mm)]
    springs += [(f"PATCH{patch}", stiffness, stiffness) for patch, (_, stiffness) in enumerate(body.attached or [])]
    for name, kPa_per_mm, sideways_kPa_per_mm in springs:
        # A thin layer with no cross effect between directions gives each square mm one spring along z and one along x
        # and y, where the ground is flat and along the axes.
        stiffness, shear = kPa_per_mm * FOUNDATION_MM, sideways_kPa_per_mm * FOUNDATION_MM
        lines += [f"*MATERIAL, NAME=SPRINGS{name}", "*ELASTIC, TYPE=ENGINEERING CONSTANTS",
                  f"{stiffness:.9g}, {stiffness:.9g}, {stiffness:.9g}, 0., 0., 0., {shear:.9g}, {shear:.9g},",
                  f"{shear:.9g}", "*DENSITY", "1e-12", f"*SOLID SECTION, ELSET={name}, MATERIAL=SPRINGS{name}"]
    if body.capsule_N_per_mm:
        lines += ["*MATERIAL, NAME=SKIN", "*ELASTIC", f"{1000 * body.capsule_N_per_mm / CAPSULE_MM:.9g}, 0.4", "*DENSITY",
                  "1e-12", "*SOLID SECTION, ELSET=CAPSULE, MATERIAL=SKIN"]
    return lines


def elastic_card(body, youngs, softest):
    if body.hyperelastic:
        card, *constants = body.hyperelastic.split("\n")
        if youngs != softest:
            raise ValueError("a hyperelastic body is of one material here")
        return [card, *constants]
    if not body.fibres:
        return ["*ELASTIC", f"{youngs:.9g}, {body.poisson_ratio}"]
    nu, shear, along = body.poisson_ratio, youngs / (2 + 2 * body.poisson_ratio), youngs * body.fibres[1]
    sheared = shear * (body.fibres[2] if len(body.fibres) > 2 else 1)
    return ["*ELASTIC, TYPE=ENGINEERING CONSTANTS",
            f"{along:.9g}, {youngs:.9g}, {youngs:.9g}, {nu}, {nu}, {nu}, {sheared:.9g}, {sheared:.9g},", f"{shear:.9g}"]


def step(body, load):
    large = ", NLGEOM, INC=200" if body.hyperelastic else ""
    lines = [f"*STEP{large}", "*STATIC"]
    if body.hyperelastic:
        lines += ["1., 1., 1e-4, 1."]
    lines.append("*CLOAD, OP=NEW")
    for node in np.flatnonzero(np.abs(load.nodes).max(axis=1) > 0):
        lines += [f"{node + 1}, {axis + 1}, {load.nodes[node, axis]:.9g}" for axis in range(3) if load.nodes[node, axis]]
    if load.gravity_mm_s2 is not None and np.linalg.norm(load.gravity_mm_s2) > 0:
        size = np.linalg.norm(load.gravity_mm_s2)
        lines += ["*DLOAD, OP=NEW", f"BODY, GRAV, {size:.9g}, " + ", ".join(f"{g:.9g}" for g in load.gravity_mm_s2 / size)]
    return lines + ["*NODE PRINT, NSET=NALL, FREQUENCY=999", "U", "*END STEP"]


def wrapped(numbers):
    """CalculiX takes 16 numbers a line."""
    words = [str(int(n)) for n in numbers]
    lines = [", ".join(words[i:i + 15]) for i in range(0, len(words), 15)]
    return [line + "," for line in lines[:-1]] + lines[-1:]


def run(text):
    """All displacements in the order of printing."""
    cache = pathlib.Path(os.environ.get("GLISSON_TRUTH_CACHE", tempfile.gettempdir() + "/glisson-truth-cache"))
    cache.mkdir(parents=True, exist_ok=True)
    kept = cache / (hashlib.sha256(text.encode()).hexdigest() + ".npy")
    if kept.exists():
        return np.load(kept)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "body.inp").write_text(text)
        done = subprocess.run(["ccx", "body"], cwd=folder, capture_output=True, text=True,
                              env={**os.environ, "OMP_NUM_THREADS": "1"}, check=False)
        result = pathlib.Path(folder) / "body.dat"
        if not result.exists() or "*ERROR" in done.stdout:
            raise RuntimeError("CalculiX did not finish: " + done.stdout[-1500:])
        found = read_displacements(result, text.count("*END STEP"))
    partial = kept.with_suffix(f".{os.getpid()}.npy")
    np.save(partial, found)
    partial.rename(kept)
    return found


def read_displacements(path, steps):
    tables = []
    for line in path.read_text().splitlines():
        if line.lstrip().startswith("displacements"):
            tables.append([])
        elif tables and line.strip():
            tables[-1].append([float(x) for x in line.split()[1:4]])
    if len(tables) != steps:
        raise RuntimeError(f"CalculiX printed {len(tables)} of {steps} results")
    return np.array(tables)
