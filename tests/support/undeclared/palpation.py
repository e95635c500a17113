"""Palpation experiments with an effect in them that their file does not declare, and what really happened beside them.

The truth is computed by CalculiX on another mesh of the same specimen; force, footprint and markers are carried over by
shape functions. A case is a folder:

    experiment.json   what `explain` is given
    heldout.json      further trials of the same specimen, which it never sees
    truth.json        the effects, how large they are against the noise, and what a right answer is
"""

import json
import math
from dataclasses import dataclass, field

import numpy as np

import calculix
from noise import noise
from shape_functions import Locator, face_rule, face_values
from specimens import boundary_triangles, brick_mesh, experiment_mesh, nested_mesh, write_vtu


@dataclass
class Site:
    """One trial: where and how the tool presses, and when it was read."""
    name: str
    center_mm: np.ndarray
    radius_mm: float
    direction: np.ndarray
    times_s: list
    levels: list              # of the largest force
    measured: list            # which samples have markers
    largest_N: float = 0.0
    held_out: bool = False


@dataclass
class Setting:
    specimen: object
    experiment: object
    truth: object
    youngs_kPa: float
    poisson_ratio: float
    markers_mm: np.ndarray
    sites: list
    elements: object = None   # where the markers are in the truth's mesh
    weights: object = None
    ligament: object = None   # where in the unit cube a second support holds; none where there is none
    footprints: dict = field(default_factory=dict)


@dataclass
class Effects:
    """What is switched on. The defaults are the declared model."""
    stiffness_factor: float = 1.0
    foundation_kPa_per_mm: float = None
    sideways_kPa_per_mm: float = None      # of the foundation, where it is another along the ground
    inclusion: tuple = None                # centre, radius, ratio
    creep: list = field(default_factory=list)       # (amplitude, time_s) of the compliance's terms
    gain: float = 1.0
    zero_N: float = 0.0
    rotation_deg: tuple = (0, 0, 0)
    translation_mm: tuple = (0, 0, 0)
    fibres: tuple = None                   # axis, ratio, ratio of the shear moduli where it is not 1
    capsule_N_per_mm: float = None
    gravity_m_s2: tuple = None
    pressure_kPa: float = 0.0
    hyperelastic: str = None
    adhesions: tuple = ()                  # (centre, radius, kPa/mm) of parts of the surface
    untied: bool = False                   # the ligament is declared and not there
    # Outside the catalogue:
    cut: tuple = None                      # a point, a normal and how deep from the top, in the unit cube
    slip_mm: tuple = None                  # the tool's way at the largest force
    tilt_deg: float = 0.0                  # of the force, at the largest force
    drying_per_s: float = 0.0              # shrinking of the whole with time


def setting(specimen, seed, youngs_kPa=10.0, poisson_ratio=0.45, truth="brick", truth_cells=(8, 8, 6), markers=40,
            fitted=5, held_out=2, reach_mm=6.0, radius_mm=(9, 13), ligament=None):
    rng = np.random.default_rng(seed)
    body = experiment_mesh(specimen)
    mesh = nested_mesh(specimen) if truth == "nested" else brick_mesh(specimen, truth_cells)
    result = Setting(specimen, body, mesh, youngs_kPa, poisson_ratio, scattered_markers(body, markers, rng),
                     tool_sites(body, fitted, held_out, radius_mm, rng))
    result.ligament = ligament
    result.elements, result.weights = Locator(mesh)(result.markers_mm)
    for site, moved in zip(result.sites, unit_answers(result, Effects())):
        site.largest_N = float(np.round(reach_mm / np.linalg.norm(moved, axis=1).max(), 3))
    return result


def scattered_markers(body, count, rng):
    """Half on the free surface, half inside; none at the support, where nothing moves."""
    triangles, centroids, areas, _ = boundary_triangles(body)
    free = ~body.held_faces & (centroids[:, 2] > 0.15 * body.points[:, 2].max())
    chosen = rng.choice(np.flatnonzero(free), count // 2, p=areas[free] / areas[free].sum())
    on_surface = np.einsum("nk,nkd->nd", rng.dirichlet([1, 1, 1], count // 2), triangles[chosen])
    cells = body.points[body.elements]
    size = np.abs(np.linalg.det(cells[:, 1:] - cells[:, :1]))
    size[cells[:, :, 2].mean(axis=1) < 0.15 * body.points[:, 2].max()] = 0
    chosen = rng.choice(len(cells), count - count // 2, p=size / size.sum())
    inside = np.einsum("nk,nkd->nd", rng.dirichlet([1, 1, 1, 1], len(chosen)), cells[chosen])
    return np.round(np.concatenate([on_surface, inside]), 5)


def tool_sites(body, fitted, held_out, radius_mm, rng):
    """Places on the upper side, far from each other; mostly pressed, some of them obliquely, one pulled."""
    _, centroids, _, normals = boundary_triangles(body)
    low, high = body.points.min(axis=0), body.points.max(axis=0)
    middle, half = (low + high)[:2] / 2, (high - low)[:2] / 2
    top = np.flatnonzero((normals[:, 2] > 0.6) & (np.abs(centroids[:, :2] - middle) < 0.62 * half).all(axis=1))
    chosen = [int(rng.choice(top))]
    while len(chosen) < fitted + held_out:
        gap = np.min([np.linalg.norm(centroids[top] - centroids[c], axis=1) for c in chosen], axis=0)
        chosen.append(int(top[np.argmax(gap + rng.uniform(0, 6, len(top)))]))
    sites = []
    for i, triangle in enumerate(chosen):
        sideways = rng.normal(size=3) * (0.5 if i % 3 == 1 else 0.1)
        direction = np.array([0, 0, -1.0]) + sideways * [1, 1, 0]
        if i == 3:
            direction *= -1
        times, levels, measured = protocol(i, rng)
        sites.append(Site(f"{'h' if i >= fitted else 'p'}{i + 1:02d}", np.round(centroids[triangle], 3),
                          round(rng.uniform(*radius_mm), 1), np.round(direction / np.linalg.norm(direction), 6), times,
                          levels, measured, held_out=i >= fitted))
    return sites


def protocol(number, rng):
    """Steps up, a hold, a step down; every second trial faster, and one that pauses unloaded with nothing read."""
    pace = (2.0, 0.7, 4.0)[number % 3]
    levels = [0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0, 0.4]
    steps = [0, 1, 1, 1, 1, 3, 6, 1]
    measured = [number % 2 == 0] + [True] * 7
    if number == 2:
        levels, steps, measured = levels + [0, 0.6], steps + [1, 2], measured + [False, True]
    times = np.cumsum(np.array(steps) * pace * rng.uniform(0.9, 1.1, len(steps)))
    return [round(float(t - times[0]), 3) for t in times], levels, measured


# What the specimen does.

def truth(scene, effects):
    """(trial, sample, marker, 3) displacements in mm as a perfect camera would give them."""
    if effects.hyperelastic:
        moved = nonlinear_paths(scene, effects)
    else:
        moved = linear_paths(scene, effects)
    return [seen(scene, effects, site, path) for site, path in zip(scene.sites, moved)]


def linear_paths(scene, effects):
    preload = preload_answer(scene, effects)
    forces = [np.array(site.levels) * site.largest_N for site in scene.sites]
    if effects.slip_mm or effects.tilt_deg:
        return [preload + wandering(scene, effects, site) for site in scene.sites]
    units = unit_answers(scene, effects)
    return [preload + delayed(site.times_s, force, effects.creep)[:, None, None] * unit
            for site, force, unit in zip(scene.sites, forces, units)]


def delayed(times_s, force_N, terms):
    """The force as a linear viscoelastic body answers it, by superposition: int J(t - s) dF(s) with the compliance
    J(t) = 1 + sum a (1 - exp(-t / tau)), the force being linear between the samples."""
    answer = np.array(force_N, float)
    for amplitude, tau in terms:
        for k in range(len(times_s) - 1):
            a, b = times_s[k], times_s[k + 1]
            slope = (force_N[k + 1] - force_N[k]) / (b - a)
            for j in range(k + 1, len(times_s)):
                t = times_s[j]
                answer[j] += amplitude * slope * ((b - a) - tau * (math.exp(-(t - b) / tau) - math.exp(-(t - a) / tau)))
    return answer


def unit_answers(scene, effects):
    """Markers' displacements under 1 N at each site."""
    body = truth_body(scene, effects)
    loads = [[calculix.Load(footprint_load(scene, body.mesh, site.center_mm, site.radius_mm, site.direction))]
             for site in scene.sites]
    return [at_markers(scene, body, path)[0] for path in calculix.displacements(body, loads)]


def preload_answer(scene, effects):
    load = preload(scene, effects)
    if load is None:
        return 0.0
    body = truth_body(scene, effects)
    return at_markers(scene, body, calculix.displacements(body, [[load]])[0])


def preload(scene, effects):
    if effects.gravity_m_s2 is None and not effects.pressure_kPa:
        return None
    nodes = np.zeros_like(scene.truth.points)
    if effects.pressure_kPa:
        nodes = effects.pressure_kPa * even_pressure(scene.truth)
    gravity = None if effects.gravity_m_s2 is None else 1000 * np.asarray(effects.gravity_m_s2, float)
    return calculix.Load(nodes, gravity)


def even_pressure(mesh):
    """mN on the nodes of bricks for 1 kPa on all of the surface, curved as their faces are: -int N n dA."""
    nodes = np.zeros_like(mesh.points)
    points = mesh.points[mesh.faces]
    for place, weight in face_rule():
        along, across = (np.einsum("k,nkd->nd", (face_values(place + step) - face_values(place - step)) / 2e-5, points)
                         for step in (np.array([1e-5, 0]), np.array([0, 1e-5])))
        np.add.at(nodes, mesh.faces, -weight * face_values(place)[:, None] * np.cross(along, across)[:, None])
    return nodes


def wandering(scene, effects, site):
    """A tool that slips or tilts as it presses harder; no creep with it."""
    body = truth_body(scene, effects)
    rows = []
    for level in site.levels:
        center, direction = site.center_mm, site.direction
        if effects.slip_mm:
            center = center + level * np.asarray(effects.slip_mm)
        if effects.tilt_deg:
            across = np.cross(direction, [0.6, 0.8, 0])
            angle = math.radians(effects.tilt_deg) * level
            direction = math.cos(angle) * direction + math.sin(angle) * across / np.linalg.norm(across)
        load = calculix.Load(footprint_load(scene, body.mesh, center, site.radius_mm, direction))
        rows.append(level * site.largest_N * at_markers(scene, body, calculix.displacements(body, [[load]])[0])[0]
                    if level else np.zeros_like(scene.markers_mm))
    return np.array(rows)


def nonlinear_paths(scene, effects):
    body = truth_body(scene, effects)
    resting = preload(scene, effects)
    paths = []
    for site in scene.sites:
        unit = footprint_load(scene, body.mesh, site.center_mm, site.radius_mm, site.direction)
        forces = sorted({level * site.largest_N for level in site.levels if level})
        loads = [calculix.Load(f * unit + (resting.nodes if resting else 0), resting and resting.gravity_mm_s2)
                 for f in forces]
        at = {f: at_markers(scene, body, u[None])[0]
              for f, u in zip(forces, calculix.displacements(body, [loads])[0])}
        at[0.0] = (at_markers(scene, body, calculix.displacements(body, [[resting]])[0])[0] if resting
                   else np.zeros_like(scene.markers_mm))
        paths.append(np.array([at[level * site.largest_N if level else 0.0] for level in site.levels]))
    return paths


def truth_body(scene, effects):
    mesh = scene.truth if effects.cut is None else cut_open(scene.truth, effects.cut)
    youngs = np.full(len(mesh.elements), scene.youngs_kPa * effects.stiffness_factor)
    if effects.inclusion:
        center, radius, ratio = effects.inclusion
        corners = mesh.elements[:, :8 if mesh.kind == "C3D20" else 4]
        youngs[np.linalg.norm(mesh.points[corners].mean(axis=1) - center, axis=1) < radius] *= ratio
    attached = [(faces_within(mesh, center, radius), stiffness) for center, radius, stiffness in effects.adhesions]
    tied = None
    if scene.ligament and not effects.untied:
        if effects.foundation_kPa_per_mm:  # all that holds gives way
            attached.append((ligament_faces(scene, mesh) & ~mesh.held_faces, effects.foundation_kPa_per_mm))
        else:
            tied = ligament_nodes(scene, mesh)
    return calculix.Body(mesh, youngs, scene.poisson_ratio, 1e-6, effects.hyperelastic, effects.fibres,
                         effects.foundation_kPa_per_mm, effects.sideways_kPa_per_mm, effects.capsule_N_per_mm, attached,
                         tied)


def faces_within(mesh, center, radius):
    """Faces that are not held, with their middle in a ball."""
    near = np.linalg.norm(mesh.points[mesh.faces].mean(axis=1) - center, axis=1) <= radius
    if not (near & ~mesh.held_faces).any():
        raise ValueError("the attachment holds nothing")
    return near & ~mesh.held_faces


def ligament_faces(scene, mesh):
    return scene.ligament(mesh.unit[mesh.faces].reshape(-1, 3)).reshape(mesh.faces.shape).all(axis=1)


def ligament_nodes(scene, mesh):
    return np.unique(mesh.faces[ligament_faces(scene, mesh)])


def cut_open(mesh, cut):
    """A crack from the top: the nodes of a plane of faces are doubled for the elements behind it."""
    import copy
    across, where, depth = cut
    corners = 8 if mesh.kind == "C3D20" else 4
    behind = mesh.unit[mesh.elements[:, :corners]].mean(axis=1)[:, across] > where
    on_plane = (np.abs(mesh.unit[:, across] - where) < 1e-9) & (mesh.unit[:, 2] > 1 - depth + 1e-9)
    if not on_plane.any():
        raise ValueError("no plane of the grid lies where the cut should be")
    twin = np.arange(len(mesh.points))
    twin[on_plane] = len(mesh.points) + np.arange(on_plane.sum())
    opened = copy.copy(mesh)
    opened.points = np.concatenate([mesh.points, mesh.points[on_plane]])
    opened.unit = np.concatenate([mesh.unit, mesh.unit[on_plane]])
    opened.elements = mesh.elements.copy()
    opened.elements[behind] = twin[mesh.elements[behind]]
    face_behind = mesh.unit[mesh.faces].mean(axis=1)[:, across] > where
    opened.faces = mesh.faces.copy()
    opened.faces[face_behind] = twin[mesh.faces[face_behind]]
    return opened


def footprint_load(scene, mesh, center, radius, direction):
    """mN on the truth's nodes for 1 N over the faces of the experiment's mesh that the tool touches."""
    triangles, centroids, areas, _ = boundary_triangles(scene.experiment)
    touched = np.linalg.norm(centroids - center, axis=1) <= radius
    if not touched.any():
        raise ValueError("the tool touches nothing")
    key = (len(mesh.points), tuple(touched))
    if key not in scene.footprints:
        scene.footprints[key] = spread(mesh, triangles[touched], 1000 * areas[touched, None] / areas[touched].sum())
    return scene.footprints[key] * direction


def spread(mesh, triangles, forces):
    """Even tractions, given as a force a triangle (of any number of components), onto nodes by the shape functions at
    16 points of each triangle."""
    n = 4
    places = [(i + 1 / 3, j + 1 / 3) for i in range(n) for j in range(n - i)]
    places += [(i + 2 / 3, j + 2 / 3) for i in range(n - 1) for j in range(n - 1 - i)]
    places = np.array(places) / n
    bary = np.column_stack([1 - places.sum(axis=1), places])
    elements, weights = Locator(mesh)((bary @ triangles).reshape(-1, 3))
    nodes = np.zeros((len(mesh.points), forces.shape[1]))
    shares = np.repeat(forces / len(places), len(places), axis=0)
    np.add.at(nodes, elements, weights[:, :, None] * shares[:, None])
    return nodes


def at_markers(scene, body, displacements):
    # A cut doubles nodes behind the others: what lies before it is still found by the old numbers.
    if len(body.mesh.points) != len(scene.truth.points):
        elements, weights = Locator(body.mesh)(scene.markers_mm)
    else:
        elements, weights = scene.elements, scene.weights
    return np.einsum("mk,lmkd->lmd", weights, displacements[:, elements])


def seen(scene, effects, site, path):
    """Drying, then the camera's frame."""
    center = (scene.experiment.points.min(axis=0) + scene.experiment.points.max(axis=0)) / 2
    placed = scene.markers_mm + path
    if effects.drying_per_s:
        shrink = effects.drying_per_s * np.array(site.times_s)[:, None, None]
        placed = placed - shrink * (scene.markers_mm - center * [1, 1, 0])
    placed = (placed - center) @ rotation(effects.rotation_deg).T + center + np.asarray(effects.translation_mm)
    return placed - scene.markers_mm


def rotation(degrees):
    angle = np.radians(degrees)
    size = np.linalg.norm(angle)
    if size == 0:
        return np.eye(3)
    x, y, z = angle / size
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(size) * cross + (1 - math.cos(size)) * cross @ cross


# What the files say.

def read_force(effects, site):
    """What the load cell shows of the force along the tool."""
    return [round(effects.zero_N + effects.gain * level * site.largest_N, 6) for level in site.levels]


def size_mm(scene, effects, without=Effects()):
    """How far the effects move what the fitted trials measure, root mean square over coordinates, from what `without`
    predicts at the same readings of the load cell."""
    differences = []
    for site, there, here in zip(scene.sites, against_reading(scene, effects), against_reading(scene, without, effects)):
        if not site.held_out:
            differences.append((there - here)[np.array(site.measured)])
    return float(np.sqrt(np.mean(np.concatenate(differences) ** 2)))


def against_reading(scene, effects, reading=None):
    """The truth under `effects`, had the load cell with the bias of `reading` shown what it showed."""
    reading = reading or effects
    same = (effects.gain, effects.zero_N) == (reading.gain, reading.zero_N)
    paths = truth(scene, effects)
    if same:
        return paths
    if effects.hyperelastic or effects.slip_mm or effects.tilt_deg:
        raise ValueError("a biased force is compared with linear effects only")
    preload = preload_answer(scene, effects)
    result = []
    for site, unit in zip(scene.sites, unit_answers(scene, effects)):
        force = (np.array(read_force(reading, site)) - effects.zero_N) / effects.gain
        moved = preload + delayed(site.times_s, force, effects.creep)[:, None, None] * unit
        result.append(seen(scene, effects, site, moved))
    return result


def write_case(folder, scene, effects, noise_mm, seed, answer):
    """`answer` goes into truth.json: kinds, outside, size, noise (noise.py), ..."""
    folder.mkdir(parents=True, exist_ok=True)
    rng = np.random.default_rng([seed, *map(ord, folder.name)])
    paths = truth(scene, effects)
    for file, held_out in (("experiment.json", False), ("heldout.json", True)):
        trials = []
        for site, path in zip(scene.sites, paths):
            if site.held_out == held_out:
                trials.append(write_trial(folder, scene, effects, site, path, noise_mm, rng, answer["noise"]))
        write_experiment(folder, file, scene, noise_mm, trials)
    (folder / "truth.json").write_text(json.dumps({**answer, "noise_mm": noise_mm}, indent=1) + "\n")


def write_experiment(folder, file, scene, noise_mm, trials):
    """Trials as write_trial gives them, and the specimen's mesh beside them."""
    fixed = np.zeros(len(scene.experiment.points))
    fixed[scene.experiment.held_nodes()] = 1
    write_vtu(folder / "specimen.vtu", scene.experiment, fixed=fixed)
    (folder / file).write_text(json.dumps({
        "format": "glisson-experiment/1", "kind": "palpation", "title": folder.name,
        "specimen": {"mesh": "specimen.vtu", "youngs_modulus_kPa": scene.youngs_kPa,
                     "poisson_ratio": scene.poisson_ratio, "density_kg_m3": 1000},
        "supports": [{"point_array": "fixed"}], "gravity_m_s2": [0, 0, 0], "noise_mm": noise_mm,
        "trials": trials}, indent=1) + "\n")


def write_trial(folder, scene, effects, site, path, noise_mm, rng, noise_is):
    samples = []
    measured = np.flatnonzero(site.measured)
    off_mm = dict(zip(measured, noise(rng, noise_mm, (len(measured), *scene.markers_mm.shape), noise_is)))
    for k, (time, force) in enumerate(zip(site.times_s, read_force(effects, site))):
        sample = {"time_s": time, "force_N": force}
        if site.measured[k]:
            sample["markers"] = f"{site.name}_{k}.csv"
            now = scene.markers_mm + path[k] + off_mm[k]
            rows = [",".join([f"m{m}", *(f"{x:.5f}" for x in (*rest, *moved))])
                    for m, (rest, moved) in enumerate(zip(scene.markers_mm, now), 1)]
            (folder / sample["markers"]).write_text(
                "id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")
        samples.append(sample)
    return {"id": site.name,
            "tool": {"center_mm": list(site.center_mm), "radius_mm": site.radius_mm, "direction": list(site.direction)},
            "samples": samples}
