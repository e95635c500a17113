#!/usr/bin/python3
"""Makes guidance experiments with an undeclared effect: make_guidance.py OUT [--kinds a,b] [--sizes 8] [--seed N]
[--specimens tiny,tied,liver-SEED]. A tied block and a piece of a generated liver have a ligament besides. CalculiX moves the organ with other elements on another mesh; a camera sees clouds of the surface it
faces, without names, a few landmarks, and where hidden targets inside truly are, for judging. A case is named by its specimen, effect, size and seed; experiment.json,
heldout.json (pulls that explain never sees) and truth.json are what judge.py takes."""

import json
import os
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import calculix
from asked_cases import asked_cases
from generated_liver import liver
from make_palpation import SPECIMENS, inclusion, one_of, unit_vector
from palpation import Effects, ligament_nodes, read_force, setting, size_mm, truth
from shape_functions import Locator
from specimens import block, boundary_triangles, write_vtu

MINIMUM_NOISE_MM = 0.1  # a cloud from stereo is seldom better
REACH_MM = 6.0
SEEN, CLOUD, LANDMARKS, TARGETS = 400, 120, 10, 12
TOWARDS_CAMERA = np.array([0.5, 0.4, 0.77])
FRAMES = (2, 4, 7)  # which samples of a pull are frames: half, all, and some of its force

TIED = {"tied": (lambda: block((45, 45, 30), (4, 6, 3)), (6, 9, 6))}
LIVER_GRID = (6, 6, 3)  # its truth fills the same faces by finer tetrahedra
SMALLEST = 2  # noises: of what sits at a place less is not made
DRAWS = 8  # of a place where an effect shows at all


def side(unit):
    """The ligament: the middle third of one side, where the grids of either mesh have lines."""
    return (unit[:, 0] > 1 - 1e-9) & (np.abs(unit[:, 1] - 0.5) < 1 / 6 + 1e-9)


def adhesion(scene, rng):
    """On the surface beside the tools, from a spring to as good as held."""
    _, centroids, areas, _ = boundary_triangles(scene.experiment)
    height = scene.experiment.points[:, 2].max()
    radius = rng.uniform(0.25, 0.4) * height
    free = ~scene.experiment.held_faces & (centroids[:, 2] > 0.3 * height)
    for site in scene.sites:
        free &= np.linalg.norm(centroids - site.center_mm, axis=1) > radius + 0.5 * site.radius_mm
    if scene.ligament:
        tie = scene.experiment.points[ligament_nodes(scene, scene.experiment)]
        free &= np.min(np.linalg.norm(centroids[:, None] - tie, axis=2), axis=1) > radius
    if not free.any():
        raise ValueError("no place for an adhesion")
    center = centroids[rng.choice(np.flatnonzero(free), p=areas[free] / areas[free].sum())]
    return np.round(center, 2).tolist(), round(radius, 2), round(scene.youngs_kPa * one_of(rng, (0.03, 1)), 4)


INSIDE = {
    "stiffness-scale": lambda s, r: Effects(stiffness_factor=one_of(r, (0.5, 0.85), (1.2, 2))),
    "support-compliance": lambda s, r: Effects(foundation_kPa_per_mm=s.youngs_kPa * one_of(r, (0.02, 0.15))),
    "frame-misalignment": lambda s, r: Effects(rotation_deg=tuple(r.uniform(0.3, 1.5) * unit_vector(r)),
                                               translation_mm=tuple(r.uniform(0.2, 1) * unit_vector(r))),
    "force-bias": lambda s, r: Effects(gain=one_of(r, (0.7, 0.85), (1.15, 1.4))),
    "stiff-inclusion": inclusion,
    "undeclared-attachment": lambda s, r: Effects(adhesions=(adhesion(s, r),)),
    "missing-attachment": lambda s, r: Effects(untied=True),
}
# Not in the catalogue of guidance: to be called unexplained.
OUTSIDE = {"two-adhesions": lambda s, r: Effects(adhesions=(adhesion(s, r), adhesion(s, r))),
           "cut": lambda s, r: Effects(cut=(int(r.integers(0, 1 if s.ligament else 2)), 0.5, 0.7))}  # where grids have a plane

AT_A_PLACE = ("stiff-inclusion", "undeclared-attachment", "two-adhesions")

SCENES = {}


def scene_of(specimen):
    if specimen not in SCENES:
        body, ligament, truth_mesh = body_of(specimen)
        scene = setting(body, seed=len(specimen), reach_mm=REACH_MM, ligament=ligament, **truth_mesh)
        rng = np.random.default_rng(len(specimen) + 100)
        triangles, centroids, areas, normals = boundary_triangles(scene.experiment)
        free = np.flatnonzero(~scene.experiment.held_faces & (normals @ TOWARDS_CAMERA > 0.2))
        chosen = rng.choice(free, SEEN, p=areas[free] / areas[free].sum())
        seen_mm = np.einsum("nk,nkd->nd", rng.dirichlet([1, 1, 1], SEEN), triangles[chosen])
        scene.markers_mm = np.vstack([seen_mm, hidden_places(scene.experiment, rng)])
        scene.elements, scene.weights = Locator(scene.truth)(scene.markers_mm)
        SCENES[specimen] = scene
    return SCENES[specimen]


def body_of(specimen):
    if specimen in SPECIMENS:
        maker, grid, _ = SPECIMENS[specimen]
        return maker(), None, {"truth_cells": grid}
    if specimen in TIED:
        maker, grid = TIED[specimen]
        return maker(), side, {"truth_cells": grid}
    return liver(int(specimen.removeprefix("liver-")), LIVER_GRID), side, {"truth": "nested"}


def drawn(scene, kind, least_mm, rng):
    """The effect; of those at a place the first that shows as much as was asked for, or the one that shows most."""
    draw = (INSIDE | OUTSIDE)[kind]
    best = draw(scene, rng)
    for _ in range(DRAWS if kind in AT_A_PLACE else 0):
        if size_mm(scene, best) >= least_mm:
            break
        best = max(best, draw(scene, rng), key=lambda effects: size_mm(scene, effects))
    return best


def hidden_places(mesh, rng):
    """Evenly over the volume."""
    corners = mesh.points[mesh.elements[:, :4]]
    volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1]))
    chosen = rng.choice(len(corners), TARGETS, p=volume / volume.sum())
    return np.einsum("nk,nkd->nd", rng.dirichlet([1, 1, 1, 1], TARGETS), corners[chosen])


def make(folder, specimen, kinds, size, seed):
    if (folder / "truth.json").exists():
        return
    scene = scene_of(specimen)
    rng = np.random.default_rng([seed, 77, *map(ord, "".join(kinds))])
    if "missing-attachment" in kinds and not scene.ligament:
        return print(f"{folder.name}: is not made, there is no ligament", flush=True)
    effects = drawn(scene, kinds[0], size * MINIMUM_NOISE_MM, rng) if kinds else Effects()
    if kinds and kinds[0] in AT_A_PLACE and size_mm(scene, effects) < SMALLEST * MINIMUM_NOISE_MM:
        return print(f"{folder.name}: is not made, it shows {size_mm(scene, effects):.3f} mm", flush=True)
    noise = round(float(rng.choice([0.15, 0.3])) if not kinds else max(size_mm(scene, effects) / size, MINIMUM_NOISE_MM), 4)
    folder.mkdir(parents=True, exist_ok=True)
    held = {"fixed": scene.experiment.held_nodes()}
    if scene.ligament:
        held["ligament"] = ligament_nodes(scene, scene.experiment)
    write_vtu(folder / "organ.vtu", scene.experiment,
              **{name: np.isin(np.arange(len(scene.experiment.points)), nodes) for name, nodes in held.items()})
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn, [12.0, -30.0, 140.0]
    paths = truth(scene, effects)
    for file, held_out in (("experiment.json", False), ("heldout.json", True)):
        frames, trials = [], []
        for site, path in zip(scene.sites, paths):
            if site.held_out != held_out:
                continue
            trials.append({"id": site.name, "frames": []})
            for k in FRAMES:
                frames.append(write_frame(folder, scene, effects, site, k, path[k], noise, pose, rng))
                trials[-1]["frames"].append(frames[-1]["id"])
        (folder / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "guidance", "title": folder.name,
            "model": {"mesh": "organ.vtu", "youngs_modulus_kPa": scene.youngs_kPa, "poisson_ratio": scene.poisson_ratio},
            "supports": [{"point_array": name} for name in held], "noise_mm": noise, "frames": frames, "trials": trials}, indent=1) + "\n")
    shown = {k: v for k, v in vars(effects).items() if v != getattr(Effects(), k)}
    (folder / "truth.json").write_text(json.dumps({
        "kinds": kinds, "outside": bool(kinds) and kinds[0] in OUTSIDE, "parameters": shown, "noise_mm": noise,
        "size": round(size_mm(scene, effects) / noise, 2) if kinds else 0.0}, indent=1) + "\n")
    print(f"{folder.name}: a noise of {noise} mm", flush=True)


def write_frame(folder, scene, effects, site, k, moved, noise, pose, rng):
    name = f"{site.name}-{k}"
    in_camera = lambda points: points @ pose[:3, :3].T + pose[:3, 3]
    true = in_camera(scene.markers_mm + moved)
    seen = true[:SEEN] + rng.normal(0, noise, (SEEN, 3))
    cloud = seen[LANDMARKS + rng.choice(SEEN - LANDMARKS, CLOUD, replace=False)]
    header = f"ply\nformat ascii 1.0\nelement vertex {CLOUD}\nproperty double x\nproperty double y\nproperty double z\n"
    (folder / f"{name}.ply").write_text(header + "end_header\n" + "".join("%.5f %.5f %.5f\n" % tuple(p) for p in cloud))
    write_places(folder / f"{name}.csv", "m", scene.markers_mm[:LANDMARKS], seen)
    write_places(folder / f"{name}-targets.csv", "t", scene.markers_mm[SEEN:], true[SEEN:])
    force = read_force(effects, site)[k] * pose[:3, :3] @ site.direction
    return {"id": name, "time_s": site.times_s[k], "points": f"{name}.ply", "landmarks": f"{name}.csv", "targets": f"{name}-targets.csv",
            "pose_guess": pose.ravel().round(12).tolist(),
            "tools": [{"id": "retractor", "at_rest_mm": list(site.center_mm), "radius_mm": site.radius_mm,
                       "force_N": force.round(9).tolist()}]}


def write_places(file, prefix, rest_mm, now_mm):
    rows = [",".join([f"{prefix}{m}", *("%.5f" % x for x in (*rest, *now))])
            for m, (rest, now) in enumerate(zip(rest_mm, now_mm), 1)]
    file.write_text("id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")


def main():
    if not calculix.available():
        sys.exit("CalculiX (ccx) is not installed: apt-get install calculix-ccx")
    for *case, _ in asked_cases(__doc__, [*INSIDE, *OUTSIDE], (), "specimens", "tiny"):
        make(*case)


if __name__ == "__main__":
    main()
