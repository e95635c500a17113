"""A piece of a generated liver as a specimen: what lies about the thickest place of its front, cut off flat behind and
laid on the cut. The seed of `glisson-cli study anatomy` says which liver."""

import gzip
import os
import pathlib
import subprocess
import tempfile

import numpy as np

from specimens import Specimen

REACH_MM = 50.0      # from the middle to the rim, at most
THINNEST_MM = 25.0   # of the piece, at its rim
BLUR_MM = 7.0        # what is smaller than the cells of any mesh


def liver(seed, cells):
    front, spacing_mm = thickness_in_front(liver_mask(seed))
    middle = np.array(np.unravel_index(np.argmax(blurred(front, 15 / spacing_mm)), front.shape), float)
    front = blurred(front, BLUR_MM / spacing_mm)
    rim = rim_of(front, middle, spacing_mm)

    def to_mm(unit):
        a, b = 2 * unit[:, 0] - 1, 2 * unit[:, 1] - 1
        # A rounded square: a disc's corners would make flat cells.
        plan = np.stack([a * np.sqrt(1 - 0.4 * b * b), b * np.sqrt(1 - 0.4 * a * a)], axis=1) / np.sqrt(1.2)
        plan *= rim(np.arctan2(plan[:, 1], plan[:, 0]))[:, None]
        height = interpolated(front, middle + plan / spacing_mm) * spacing_mm
        return np.column_stack([plan, height * unit[:, 2]])
    return Specimen(f"liver-{seed}", to_mm, cells)


def liver_mask(seed):
    """Which voxels lie inside, along x, z and y (to the back), and the edge of a voxel in mm."""
    program = os.environ.get("GLISSON_CLI", pathlib.Path(__file__).parents[3] / "build/release/bin/glisson-cli")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "study", "anatomy", "--seed", str(seed), "--out", folder, "--label-spacing-mm", "1.5",
                        "--quiet"], check=True)
        header, _, voxels = (pathlib.Path(folder) / "labels/couinaud.nrrd").read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    kind = {"float": "<f4", "short": "<i2", "unsigned short": "<u2", "unsigned char": "u1"}[fields["type"]]
    size = [int(n) for n in fields["sizes"].split()]
    labels = np.frombuffer(gzip.decompress(voxels), kind).reshape(size, order="F")
    return labels.transpose(0, 2, 1) > 0.5, 1.5


def thickness_in_front(mask):
    """In voxels, of what lies before the plane that goes through the middle of the liver from left to right."""
    mask, spacing_mm = mask
    cut = int(np.average(np.arange(mask.shape[2]), weights=mask.sum(axis=(0, 1))))
    before = mask[:, :, :cut]
    # From the foremost voxel on: holes behind it would be no part of a body without folds.
    return np.where(before.any(axis=2), cut - before.argmax(axis=2), 0).astype(float), spacing_mm


def rim_of(front, middle, spacing_mm):
    """How far the piece reaches in mm, as a smooth function of the angle: as long as it is thick enough."""
    angles = np.linspace(-np.pi, np.pi, 72, endpoint=False)
    steps = np.arange(0, REACH_MM / spacing_mm, 0.5)
    reach = []
    for angle in angles:
        places = middle + steps[:, None] * [np.cos(angle), np.sin(angle)]
        thick = interpolated(front, places) * spacing_mm > THINNEST_MM
        reach.append(steps[len(steps) - 1 if thick.all() else max(1, thick.argmin() - 1)] * spacing_mm)
    waves = np.fft.rfft(reach) / len(reach)
    shape = lambda angle: waves[0].real + 2 * sum(
        (waves[n] * np.exp(1j * n * (angle + np.pi))).real for n in (1, 2, 3))
    shrunk = min(1.0, *(np.array(reach) / shape(angles)))
    return lambda angle: shrunk * shape(angle)


def blurred(values, sd):
    reach = np.arange(-int(3 * sd) - 1, int(3 * sd) + 2)
    weights = np.exp(-0.5 * (reach / sd) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        values = np.apply_along_axis(np.convolve, axis, values, weights, mode="same")
    return values


def interpolated(values, at):
    """Bilinear; beside the picture as at its border."""
    at = np.clip(at, 0, np.array(values.shape) - 1.001)
    low = at.astype(int)
    (u, v), (i, j) = (at - low).T, low.T
    return ((1 - u) * (1 - v) * values[i, j] + u * (1 - v) * values[i + 1, j] + (1 - u) * v * values[i, j + 1]
            + u * v * values[i + 1, j + 1])
