#!/usr/bin/python3
"""The waves in a volunteer's brain as an elastography experiment: brain_waves.py OUT [--data DIR] [--modulus kPa]

DIR is mre_brain_ir_charite of the shared data (its SOURCE.txt says what was measured): 20 Hz, three directions, eight instants of
a period, five slices of 2 mm with gaps of 2 mm between, once without and once with an inversion pulse. Five slices are fewer than
patches need, so that the middle one is taken by itself, as if all went on alike through it: that is a law that a brain breaks.
The two series are two trials; each direction is a component (which one is x is not said, and does not matter where components
are judged one by one). Phase is unwrapped by its Laplacian in time (differences from one instant to the next, each modulo a
turn) and in space by subtracting a plane; the complex wave is the first harmonic. Noise is what the second to fourth
harmonics hold. Declared: an elastic brain of --modulus (1.2 kPa, of the order of published moduli at 20 Hz)."""

import json
import pathlib
import struct
import sys

sys.dont_write_bytecode = True
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "undeclared"))
from make_waves import write_image
from recordings import asked_for

LONG = {b"OB", b"OW", b"OF", b"SQ", b"UT", b"UN"}
SLICES, MOSAIC, WIDTH, HEIGHT = 5, 3, 108, 110


def pixels(file):
    """Of an uncompressed DICOM file with explicit types: a row a line of the mosaic."""
    data, at, rows, columns = file.read_bytes(), 132, 0, 0
    while at + 8 <= len(data):
        group, element = struct.unpack_from("<HH", data, at)
        kind = data[at + 4:at + 6]
        if kind in LONG:
            length, at = struct.unpack_from("<I", data, at + 8)[0], at + 12
        else:
            length, at = struct.unpack_from("<H", data, at + 6)[0], at + 8
        if (group, element) == (0x0028, 0x0010):
            rows = struct.unpack_from("<H", data, at)[0]
        elif (group, element) == (0x0028, 0x0011):
            columns = struct.unpack_from("<H", data, at)[0]
        elif (group, element) == (0x7FE0, 0x0010):
            return np.frombuffer(data, "<u2", rows * columns, at).reshape(rows, columns).astype(float)
        if length == 0xFFFFFFFF:  # a sequence of no stated length: its items are read through
            length = 0
        elif (group, element) == (0xFFFE, 0xE000):
            length = 0
        at += length
    sys.exit(f"{file} holds no picture that is read here")


def slice_of(mosaic, number):
    row, column = divmod(number, MOSAIC)
    return mosaic[row * HEIGHT:(row + 1) * HEIGHT, column * WIDTH:(column + 1) * WIDTH]


def wave_of(phase):
    """Of eight instants (first axis), wrapped: the first harmonic, and the noise of its parts from the higher ones."""
    steps = np.angle(np.exp(1j * (np.roll(phase, -1, axis=0) - phase)))
    harmonics = np.fft.fft(steps, axis=0) / len(phase)
    turn = np.exp(2j * np.pi * np.arange(len(phase)) / len(phase))
    # A step is the phase times (turn - 1) at each harmonic.
    of_phase = {h: harmonics[h] / (turn[h] - 1) for h in (1, 2, 3)}
    return 2 * of_phase[1], 2 * np.sqrt((np.abs(of_phase[2]) ** 2 + np.abs(of_phase[3]) ** 2) / 4)


def without_plane(wave, inside):
    y, x = np.nonzero(inside)
    basis = np.c_[np.ones(len(x)), x, y]
    rest = np.full(wave.shape, np.nan, complex)
    rest[inside] = wave[inside] - basis @ np.linalg.lstsq(basis, wave[inside], rcond=None)[0]
    return rest


def main():
    asked = asked_for(__doc__, "mre_brain_ir_charite", lambda ask: ask.add_argument("--modulus", type=float, default=1.2))
    trials = []
    for name, magnitude, series in (("without inversion", "series_045_mre_noInv_mag", "series_046_mre_noInv_phase"),
                                    ("with inversion", "series_047_mre_Inv2900_mag", "series_048_mre_Inv2900_phase")):
        folder = asked.data / "volunteer_A"
        stack = lambda which: np.array([slice_of(pixels(f), SLICES // 2) for f in sorted((folder / which).glob("*.dcm"))])
        bright = stack(magnitude).mean(axis=0)
        phase = (2 * stack(series) - 4096) / 4096 * np.pi
        inside = bright > 0.25 * np.percentile(bright, 98)
        parts, noises, strengths = {}, [], []
        for c, component in enumerate("xyz"):
            wave, noise = wave_of(phase[8 * c:8 * c + 8])
            wave = without_plane(wave, inside)
            noises.append(np.sqrt(np.mean(noise[inside] ** 2) / 2))
            strengths.append(np.sqrt(np.nanmean(np.abs(wave) ** 2)))
            parts[component] = {}
            for part, values in (("real", wave.real), ("imaginary", wave.imag)):
                file = f"{name.replace(' ', '_')}_{component}_{part}.nrrd"
                write_image(asked.out / file, values.T[:, :, None], (2.0, 2.0, 4.0))
                parts[component][part] = file
        trials.append({"id": name, "frequency_Hz": 20, "noise": float(np.sqrt(np.mean(np.square(noises)))), "components": parts})
        print(f"{name}: {inside.sum()} voxels, waves of {', '.join(f'{s:.2f}' for s in strengths)} rad,"
              f" noise {', '.join(f'{n:.3f}' for n in noises)}")
    document = {"format": "glisson-experiment/1", "kind": "elastography", "title": "a brain at 20 Hz",
                "declared": {"law": "elastic", "shear_modulus_kPa": asked.modulus}}
    (asked.out / "experiment.json").write_text(json.dumps({**document, "trials": trials}, indent=1) + "\n")


if __name__ == "__main__":
    main()
