#!/usr/bin/python3
"""Makes elastography experiments whose waves do something that their law does not declare: make_waves.py OUT [--kinds a,b]
[--sizes 2,4,8] [--noise stated|x0.7|x1.5] [--seed N] [--count N]. Waves in closed form (waves.py), or of a finer grid's solution in a
single slice; white noise, so large that the effect is of the asked size: what the declared equation leaves of the noiseless
field over what it leaves of the noise, both seen through a Gaussian of an eighth of a wavelength (root mean square). Noise is
0.3 to 20 % of the wave; where that is too little or too much, truth.json says the size that came of it. Three frequencies;
heldout.json has two more. Kinds: in a volume null, stiffness-scale, viscosity, anisotropy, compression-waves, slice-timing,
stiff-inclusion, each `-free` where a pressure is declared to be free; in a slice null-slice, viscosity-slice,
boundary-layer-slice. Outside of the catalogue: graded-slice, rings-slice, jump, jump-free. `--count` makes so many seeds."""

import argparse
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import waves
from noise import noise

INSIDE = ["null", "stiffness-scale", "viscosity", "anisotropy", "compression-waves", "slice-timing", "stiff-inclusion",
          "null-free", "stiffness-scale-free", "viscosity-free", "anisotropy-free", "slice-timing-free",
          "null-slice", "viscosity-slice", "boundary-layer-slice"]
OUTSIDE = ["graded-slice", "rings-slice", "jump", "jump-free"]
SMALLEST_NOISE, LARGEST_NOISE = 0.003, 0.2


def write_image(file, values, spacing):
    """NRRD, in the patient's axes (LPS)."""
    nx, ny, nz = values.shape
    header = (f"NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: {nx} {ny} {nz}\n"
              f"space directions: ({spacing[0]},0,0) (0,{spacing[1]},0) (0,0,{spacing[2]})\nspace origin: (0,0,0)\n"
              "kinds: domain domain domain\nendian: little\nencoding: raw\n\n")
    file.write_bytes(header.encode() + values.astype("<f4").tobytes(order="F"))


class Body:
    """Where it is seen, and by which law it is declared to move."""

    def __init__(self, kind, rng):
        self.rng = rng
        self.free, self.slice = kind.endswith("-free"), kind.endswith("-slice")
        self.shape = (56, 52, 1) if self.slice else (40, 36, 26)
        self.spacing = (2.0, 2.0, 2.0) if self.slice else (2.5, 2.5, 2.5)
        self.modulus = rng.uniform(2.0, 4.0)
        f = rng.uniform(48, 56)
        self.fitted, self.unseen = [f, 1.25 * f, 1.5 * f], [1.12 * f, 1.38 * f]
        axes = [np.arange(n) * s for n, s in zip(self.shape, self.spacing)]
        grid = np.stack(np.meshgrid(*axes, indexing="ij"), -1)
        self.middle = grid.reshape(-1, 3).mean(axis=0)
        self.points = grid.reshape(-1, 3) - self.middle
        self.components = "z" if self.slice else "xyz"

    def field(self, values):
        return values.reshape(*self.shape, 3)


def own_kind(kind):
    return kind.removesuffix("-free").removesuffix("-slice")


def plan(kind, body):
    """{parameters}, and the noiseless field (x, y, z, component) of a frequency in Hz."""
    rng, g = body.rng, body.modulus
    plane = lambda omega, modulus: body.field(waves.plane_waves(body.points, omega, modulus, rng))
    cut = lambda modulus: lambda omega: waves.in_a_slice(body.shape, body.spacing[0], omega, lambda at: modulus(at, omega), rng
                                                         )[:, :, None, None]
    extent = np.array(body.shape[:2]) * body.spacing[0] - body.spacing[0]
    name = own_kind(kind)
    if name == "null":
        return {}, cut(lambda at, omega: np.full(len(at), g)) if body.slice else lambda omega: plane(omega, g)
    if name == "stiffness-scale":
        factor = rng.choice([rng.uniform(0.7, 0.9), rng.uniform(1.1, 1.4)])
        return {"factor": factor}, lambda omega: plane(omega, g * factor)
    if name == "viscosity":
        middle = 2 * np.pi * np.mean(body.fitted)
        loss = rng.uniform(0.1, 0.4)
        law = {"kelvin-voigt": lambda omega: g * (1 + 1j * loss * omega / middle), "structural": lambda omega: g * (1 + 1j * loss),
               "springpot": lambda omega: g * (1j * omega / middle) ** loss}
        form = rng.choice(sorted(law))
        if body.slice:
            return {"form": form, "loss": loss}, cut(lambda at, omega: np.full(len(at), law[form](omega)))
        return {"form": form, "loss": loss}, lambda omega: plane(omega, law[form](omega))
    if name == "anisotropy":
        axis = waves.directions(rng, 1)[0]
        ratio = rng.choice([rng.uniform(0.6, 0.8), rng.uniform(1.25, 1.8)])
        return {"axis": axis.tolist(), "ratio": ratio}, lambda omega: body.field(
            waves.fibre_waves(body.points, omega, g, ratio * g, axis, rng, body.free))
    if name == "compression-waves":
        modulus, share = waves.DENSITY * rng.uniform(1.4e6, 1.6e6) ** 2, rng.uniform(0.3, 1.0)  # as fast as sound in tissue

        def both(omega):
            shear, long = plane(omega, g), body.field(waves.compression(body.points, omega, modulus, rng))
            return shear + long * share * size_of(shear) / size_of(long)
        return {"longitudinal_modulus_kPa": modulus, "share": share}, both
    if name == "slice-timing":
        form = rng.choice(["sequential", "interleaved"])
        delay = rng.uniform(0.2, 0.8) * rng.choice([-1, 1]) if form == "sequential" else rng.uniform(0.02, 0.1)
        n = body.shape[2]
        order = np.arange(n) if form == "sequential" else np.argsort(np.r_[np.arange(0, n, 2), np.arange(1, n, 2)])
        return {"form": form, "delay_ms": delay}, lambda omega: plane(omega, g) * np.exp(
            1j * omega * delay * 1e-3 * order)[None, None, :, None]
    if name == "stiff-inclusion":
        ratio = rng.choice([rng.uniform(0.4, 0.7), rng.uniform(1.5, 3.0)])
        radius, centre = rng.uniform(10, 18), rng.uniform(-0.2, 0.2, 3) * np.array(body.shape) * body.spacing
        return {"ratio": ratio, "radius_mm": radius, "center_mm": (centre + body.middle).tolist()}, lambda omega: body.field(
            waves.sphere_waves(body.points, omega, g, g * ratio, centre, radius, rng))
    edge = lambda at: np.minimum(np.minimum(at[:, 0], extent[0] - at[:, 0]), np.minimum(at[:, 1], extent[1] - at[:, 1]))
    if name == "boundary-layer":
        depth, ratio = rng.uniform(14, 22), rng.choice([rng.uniform(0.5, 0.7), rng.uniform(1.4, 2.0)])
        return {"depth_mm": depth, "ratio": ratio}, cut(lambda at, omega: np.where(edge(at) < depth, ratio * g, g))
    if name == "graded":
        steep = rng.uniform(0.5, 0.9)
        return {"steep": steep}, cut(lambda at, omega: g * (1 + steep * (at[:, 0] / extent[0] - 0.5)))
    if name == "rings":
        period, swing = rng.uniform(18, 30), rng.uniform(0.3, 0.5)
        return {"period_mm": period, "swing": swing}, cut(
            lambda at, omega: g * (1 + swing * np.sin(2 * np.pi * np.hypot(*(at - extent / 2).T) / period)))
    if name == "jump":  # the body moved between two blocks of slices: the second was seen displaced
        shift = rng.uniform(4, 8) * waves.directions(rng, 1)[0]

        def torn(omega):
            state = rng.bit_generator.state
            first = plane(omega, g)
            rng.bit_generator.state = state
            second = body.field(waves.plane_waves(body.points + shift, omega, g, rng))
            first[:, :, body.shape[2] // 2:] = second[:, :, body.shape[2] // 2:]
            return first
        return {"shift_mm": shift.tolist()}, torn
    sys.exit(f"there is no kind {kind}: known are {', '.join([*INSIDE, *OUTSIDE])}")


def size_of(field):
    return np.sqrt(np.mean(np.abs(field) ** 2))


def seen(field, body, omega):
    """What the declared equation leaves of a field over what it leaves of noise of 1, through a Gaussian."""
    sd = waves.DENSITY ** -0.5 * np.sqrt(body.modulus) * 2 * np.pi / omega / 8
    frequencies = [2 * np.pi * np.fft.fftfreq(n + 24 if n > 1 else 1, s) for n, s in zip(body.shape, body.spacing)]
    k2 = sum(f ** 2 for f in np.meshgrid(*frequencies, indexing="ij"))
    operator = (waves.DENSITY * omega ** 2 - body.modulus * k2) * np.exp(-k2 * sd ** 2 / 2)
    inner = tuple(slice(7, -7) if n > 1 else slice(None) for n in body.shape)
    of_noise = np.sqrt(np.mean(operator ** 2))
    squares = []
    for c in range(field.shape[3]):
        padded = np.zeros(k2.shape, complex)
        padded[tuple(slice(0, n) for n in body.shape)] = field[..., c]
        left = np.fft.ifftn(operator * np.fft.fftn(padded))[tuple(slice(0, n) for n in body.shape)][inner]
        squares.append(np.mean(np.abs(left) ** 2) / of_noise ** 2)
    return np.sqrt(np.mean(squares) / 2)  # of the real and of the imaginary part each


def make(out, kind, size, seed, noise_is):
    name = f"waves-{kind}" + (f"-{size:g}x" if own_kind(kind) != "null" else "")
    folder = out / f"{name}{'' if noise_is == 'stated' else '-' + noise_is}-s{seed}"
    if (folder / "truth.json").exists():
        return
    rng = np.random.default_rng([seed, *map(ord, kind)])
    body = Body(kind, rng)
    parameters, field = plan(kind, body)
    made = {f: field(2 * np.pi * f) for f in [*body.fitted, *body.unseen]}
    made = {f: u / size_of(u) for f, u in made.items()}
    of_effect = np.sqrt(np.mean([seen(made[f], body, 2 * np.pi * f) ** 2 for f in body.fitted]))
    wanted = rng.uniform(0.02, 0.05) if own_kind(kind) == "null" else of_effect / size
    sd = float(np.clip(wanted, SMALLEST_NOISE, LARGEST_NOISE))
    folder.mkdir(parents=True, exist_ok=True)
    trials = {}
    for f, u in made.items():
        parts = {}
        for c, component in enumerate(body.components):
            for part, values in (("real", u[..., c].real), ("imaginary", u[..., c].imag)):
                file = f"{f:.0f}{component}_{part[0]}.nrrd"
                write_image(folder / file, values + noise(rng, sd, values.shape, noise_is), body.spacing)
                parts.setdefault(component, {})[part] = file
        trials[f] = {"id": f"{f:.0f} Hz", "frequency_Hz": round(f, 6), "components": parts}
    for file, chosen in (("experiment.json", body.fitted), ("heldout.json", body.unseen)):
        (folder / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "elastography", "title": folder.name,
            "declared": {"law": "elastic", "shear_modulus_kPa": body.modulus, "density_kg_m3": 1000,
                         "pressure": "free" if body.free else "none"},
            "noise": sd, "trials": [trials[f] for f in chosen]}, indent=1) + "\n")
    is_null, outside = own_kind(kind) == "null", kind in OUTSIDE
    (folder / "truth.json").write_text(json.dumps({
        "kinds": [] if is_null else [own_kind(kind)], "outside": outside, "parameters": parameters, "noise": noise_is,
        "size": 0.0 if is_null else of_effect / sd}, indent=1, default=float) + "\n")
    print(f"{folder.name}: noise {100 * sd:.2g} % of the wave, effect of {of_effect / sd:.3g} noises", flush=True)


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("out", type=pathlib.Path)
    ask.add_argument("--kinds", default=",".join([*INSIDE, *OUTSIDE]))
    ask.add_argument("--sizes", default="2,4,8")
    ask.add_argument("--noise", default="stated", choices=["stated", "x0.7", "x1.5"])
    ask.add_argument("--seed", type=int, default=1)
    ask.add_argument("--count", type=int, default=1)
    asked = ask.parse_args()
    for seed in range(asked.seed, asked.seed + asked.count):
        for kind in asked.kinds.split(","):
            for size in [0.0] if own_kind(kind) == "null" else [float(s) for s in asked.sizes.split(",")]:
                make(asked.out, kind, size, seed, asked.noise)


if __name__ == "__main__":
    main()
