#!/usr/bin/python3
"""Does `explain` say of waves in closed form what their declared law lacks, and where? Waves that obey it, a sphere inside, waves that
lose energy, and what is in no catalogue; what cannot be an experiment gets its sentence: undeclared_waves.py GLISSON_CLI. Nothing was
tuned on this seed."""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
UNDECLARED = pathlib.Path(__file__).parents[1] / "support" / "undeclared"
try:
    import numpy as np
    import scipy  # noqa: F401
except ModuleNotFoundError as missing:
    print(f"skipped: {missing.name} is not installed")
    sys.exit(77)

KINDS, SIZE, SEED = "null,null-free,stiff-inclusion,viscosity-slice,rings-slice", "4", "7"


def main():
    with tempfile.TemporaryDirectory() as folder:
        env = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        cases, judged_in = pathlib.Path(folder) / "cases", pathlib.Path(folder) / "judged"
        subprocess.run([sys.executable, UNDECLARED / "make_waves.py", cases, "--kinds", KINDS, "--sizes", SIZE, "--seed", SEED],
                       env=env, check=True)
        judged = subprocess.run([sys.executable, UNDECLARED / "judge.py", cases, "--cli", sys.argv[1], "--out", judged_in],
                                env=env, check=True, capture_output=True, text=True).stdout
        print(judged)
        maps(cases / f"waves-stiff-inclusion-4x-s{SEED}", judged_in / f"waves-stiff-inclusion-4x-s{SEED}")
        refuses(sys.argv[1], cases / f"waves-null-s{SEED}")
    lines = [line for line in judged.splitlines() if line.startswith(("ok ", "WRONG"))]
    sys.exit(len(lines) != len(KINDS.split(",")) or any(line.startswith("WRONG") for line in lines))


def image(file):
    header, _, data = file.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    if fields["encoding"].startswith("gz"):
        import gzip
        data = gzip.decompress(data)
    return np.frombuffer(data, "<f4").reshape([int(n) for n in fields["sizes"].split()], order="F")


def maps(case, answer):
    """The law is seen not to hold about the sphere and to hold away from it; with the better model it holds there too."""
    before, after = (image(answer / f"residual_{name}.nrrd") for name in ("before", "after"))
    truth = json.loads((case / "truth.json").read_text())["parameters"]
    places = np.stack(np.meshgrid(*[2.5 * np.arange(n) for n in before.shape], indexing="ij"), -1)
    away = np.linalg.norm(places - np.array(truth["center_mm"]), axis=-1)
    known = before > 0
    inside, far = known & (away < truth["radius_mm"]), known & (away > truth["radius_mm"] + 20)
    near = [float(np.sqrt(np.mean(image[inside] ** 2))) for image in (before, after)]
    print(f"about the sphere {near[0]:.2f} noises before, {near[1]:.2f} after; far from it {before[far].mean():.2f}")
    assert near[0] > 1.5 and near[0] > 1.3 * before[far].mean(), near
    assert near[1] < 1.25, near


def refuses(cli, case):
    good = json.loads((case / "experiment.json").read_text())

    def sentence(change):
        bad = copy.deepcopy(good)
        change(bad)
        (case / "bad.json").write_text(json.dumps(bad))
        done = subprocess.run([cli, "explain", case / "bad.json", "--out", case / "bad", "--json", "--quiet"],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 1, f"exit code {done.returncode}"
        return json.loads(done.stdout)["error"]["message"]

    first = next(iter(good["trials"][0]["components"].values()))["real"]
    header, _, data = (case / first).read_bytes().partition(b"\n\n")
    (case / "moved.nrrd").write_bytes(header.replace(b"space origin: (0,0,0)", b"space origin: (9,0,0)") + b"\n\n" + data)
    (case / "empty.nrrd").write_bytes(header + b"\n\n" + bytes(len(data)))
    (case / "cut.nrrd").write_bytes(header + b"\n\n" + data[:1000])
    component = lambda e: e["trials"][0]["components"]["x"]
    for change, expected in [
            (lambda e: e["declared"].update(law="solid"), '"elastic", "kelvin-voigt", "springpot"'),
            (lambda e: e["declared"].update(shear_modulus_kPa=3000000), "stiffer than any soft tissue"),
            (lambda e: e["declared"].update(law="kelvin-voigt"), "viscosity_Pa_s"),
            (lambda e: e["declared"].update(density_kg_m3=1), "density"),
            (lambda e: e["declared"].update(pressure="high"), '"none", "free"'),
            (lambda e: (e["declared"].update(pressure="free"), e["trials"][0]["components"].pop("z")), "free pressure"),
            (lambda e: e["trials"][1]["components"].pop("x"), "those of the first trial"),
            (lambda e: e["trials"][0].update(components={}), "none of x, y and z"),
            (lambda e: component(e).update(real="nowhere.nrrd"), "nowhere.nrrd"),
            (lambda e: component(e).update(imaginary="moved.nrrd"), "another grid"),
            (lambda e: component(e).update(imaginary="cut.nrrd"), "cut.nrrd"),
            (lambda e: e.update(region="empty.nrrd"), "no voxel"),
            (lambda e: e.update(patch_radius_mm=-1), "patch_radius_mm"),
            (lambda e: e["trials"][0].update(frequency_Hz=0), "frequency_Hz"),
            (lambda e: e.pop("noise"), "noise")]:
        said = sentence(change)
        assert expected in said, f"{said!r} does not say {expected!r}"


if __name__ == "__main__":
    main()
