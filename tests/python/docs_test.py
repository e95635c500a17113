"""docs/python.md tells what there is, no more and no less, and its programs run."""
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from support import Case, DATA, ROOT, ball, glisson, np

PROGRAMS = ROOT / "docs" / "examples" / "python"
LIVER = pathlib.Path(os.environ.get("GLISSON_LIVER", "/nowhere"))
CLI = os.environ.get("GLISSON_CLI", "/nowhere")


def shown():
    """Public functions and classes of the package that need a line in the table."""
    answers = {"Error", "Grown", "LiverMesh", "PlacedTool", "RehearsalState", "SegmentedMask", "Series", "SessionState",
               "Simulation", "Study", "SurfaceMatch", "set_thread_count"}  # what functions answer with
    return {name for name, value in vars(glisson).items()
            if not name.startswith("_") and not inspect.ismodule(value) and name not in answers}


def documented():
    """(name, pybind11's signature, text) of each function, method and value of the package."""
    for name, made in vars(glisson).items():
        if name.startswith("_") or inspect.ismodule(made):
            continue
        members = vars(made).items() if inspect.isclass(made) else [("", made)]
        for member, value in members:
            if member.startswith("_") and member != "__init__":
                continue
            if isinstance(value, property):
                signature, text = (value.fget.__doc__ or "").split("\n")[0], value.__doc__ or ""
            elif callable(value) or isinstance(value, staticmethod):
                signature, _, text = (getattr(value, "__func__", value).__doc__ or "").partition("\n")
                text += (made.__doc__ or "") if member == "__init__" else ""
            else:
                continue
            yield f"{name}.{member}".strip("."), signature, text


class Docs(Case):
    def test_the_table_names_what_there_is(self):
        page = (ROOT / "docs" / "python.md").read_text()
        table = page[page.index("## What there is"):]
        named = set(re.findall(r"`(?:exchange\.)?(\w+)`", table))
        self.assertEqual(shown() - named, set(), "not in the table")
        there = set(dir(glisson)) | set(dir(glisson.exchange))
        self.assertEqual(named - there, set(), "not in the package")

    def test_each_function_says_what_it_does(self):
        for name in shown():
            self.assertGreater(len(inspect.getdoc(getattr(glisson, name)) or ""), 20, name)

    def test_each_value_of_each_class_says_what_it_is(self):
        silent = [f"{name}.{member}" for name, made in vars(glisson).items() if inspect.isclass(made)
                  for member, value in vars(made).items() if isinstance(value, property) and not value.__doc__]
        self.assertEqual(silent, [])

    def test_each_function_and_method_says_something(self):
        silent = [name for name, _, text in documented() if not text.strip()]
        self.assertEqual(silent, [])

    def test_each_array_says_its_shape(self):
        shape = re.compile(r"\([^()]*\w, ?[^()]*\)|\(\w+,\)|\w+ x \w+")
        self.assertEqual([name for name, signature, text in documented() if "numpy" in signature and not shape.search(text)], [])

    def test_each_number_says_its_unit(self):
        in_name = re.compile(r"_(mm|mm2|mm3|ml|kPa|N|uJ|ms|px|percent|fraction)$")
        in_text = re.compile(r"\b(mm|mm2|kPa|N|ml|ms|uJ|px)\b|\d\.\.1|[Ss]hare|overlap|ratio|unit|uint8|int32|4 x 4")
        silent = [name for name, signature, text in documented()
                  if re.search(r"-> (float|numpy.*float64.*|numpy.ndarray)$", signature)
                  and not (in_name.search(name.split(".")[-1]) or in_text.search(text))]
        self.assertEqual(silent, [])

    def test_each_program_is_quoted_or_has_a_twin(self):
        page = (ROOT / "docs" / "python.md").read_text()
        for program in PROGRAMS.glob("*.py"):
            twin = PROGRAMS.parent / f"{program.stem}.cpp"
            self.assertTrue(twin.exists() or f"quote:docs/examples/python/{program.name}" in page, program)

    def test_a_liver_comes_out_of_an_image(self):
        liver = ball(56, 60.0, 2.5)
        values = np.where(liver.array, 200.0, 60.0) + np.random.default_rng(7).normal(0, 8, liver.array.shape)
        with tempfile.TemporaryDirectory() as folder:
            image, body = pathlib.Path(folder) / "image.nii.gz", pathlib.Path(folder) / "body.vtu"
            glisson.write_volume_file(image, glisson.Volume(values, spacing_mm=liver.spacing_mm, origin_mm=liver.origin_mm))
            done = subprocess.run([sys.executable, PROGRAMS / "liver_from_image.py", image, "0", "0", "0", body],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            mesh = glisson.read_tetrahedra(body)
        self.assertAlmostEqual(mesh.volume_mm3 / 1000, glisson.volume_ml(liver), delta=0.05 * glisson.volume_ml(liver))
        self.assertTrue((mesh.cell_fields["youngs_modulus_kPa"] == 6.1).all())

    def said_by(self, program, *words):
        done = subprocess.run([sys.executable, PROGRAMS / program, *map(str, words)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def data(self, *parts):
        path = DATA.joinpath(*parts)
        if not path.exists():
            self.skipTest(f"{path} is not there")
        return path

    def test_the_table_of_guidance(self):
        page = re.sub(r"<!--.*?-->", "", (ROOT / "docs" / "guidance.md").read_text())  # without the figures' markers
        examples = [self.data("guidance_examples", f"example-{letter}") for letter in "abcd"]
        said = self.said_by("guidance_table.py", *examples).splitlines()
        self.assertEqual(len(said), len(re.findall(r"^\| `[a-d]` \|", page, re.MULTILINE)))
        for row in said:
            case, frame, *figures = (cell.strip() for cell in row.strip("|").split("|"))
            on_page = next(line for line in page.splitlines() if f"| `{case[-1]}` |" in line and f"| {frame} |" in line)
            self.assertEqual([cell.strip() for cell in on_page.strip("|").split("|")][3:], figures)

    def test_a_row_of_the_table_of_the_closed_loop(self):
        self.data("silicone_phantom_compression")
        table = json.loads((ROOT / "docs" / "figures" / "recordings.json").read_text())["figures"]["table"]["text"]
        declared, better = re.search(r"`silicone.py` .* \| ([\d.]+) / ([\d.]+) kPa", table).groups()
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            maker = ROOT / "tests" / "support" / "measured" / "silicone.py"
            subprocess.run([sys.executable, maker, folder, "--data", DATA / "silicone_phantom_compression"], check=True,
                           capture_output=True)
            said = self.said_by("explain_and_predict.py", folder / "experiment.json", folder / "heldout.json", folder / "out")
            self.assertTrue((folder / "out" / "report.html").exists())
        self.assertIn("strain-stiffening", said)
        self.assertIn(f"{declared} / {float(better):.2g} kPa", said)  # as the example rounds

    def test_a_video_is_judged(self):
        if not pathlib.Path(CLI).exists():
            self.skipTest("glisson-cli is not there")
        with tempfile.TemporaryDirectory() as folder:
            video = pathlib.Path(folder) / "video"
            subprocess.run([CLI, "study", "example-sequence", "--frames", "6", "--out", video, "--quiet"], check=True,
                           capture_output=True)
            said = self.said_by("judge_video.py", video / "sequence.json", "given")
        found = re.fullmatch(r"given: correlation (0\.\d+), ([\d.]+) % rejected at 5 mm, RMSE ([\d.]+) mm, "
                             r"TRE ([\d.]+) mm\n", said)
        self.assertIsNotNone(found, said)
        self.assertGreater(float(found[1]), 0.5)

    def test_a_resection_is_planned(self):
        labels = LIVER / "labels"
        if not labels.exists():
            self.skipTest("the generated liver is not there")
        portal, hepatic = (glisson.read_mask_file(labels / f"{name}-vein.nrrd").mask for name in ("portal", "hepatic"))
        with tempfile.TemporaryDirectory() as folder:
            both = pathlib.Path(folder) / "vessels.nrrd"
            glisson.write_mask_file(both, glisson.Mask(np.maximum(portal.array, hepatic.array), spacing_mm=portal.spacing_mm,
                                                       origin_mm=portal.origin_mm, direction=portal.direction), "vessels")
            said = self.said_by("plan_resection.py", labels / "liver.nrrd", both, labels / "tumour-1.nrrd")
        gone, stays = re.search(r"(\d+) ml go, ([\d.]+) % stay", said).groups()
        self.assertTrue(100 < float(gone) < 900 and 40 < float(stays) < 95, said)
        self.assertIn("cuts portal/", said)

    def test_a_stereo_pair_gives_the_points_that_the_page_names(self):
        heart = self.data("hamlyn_heart_stereo")
        figures = json.loads((ROOT / "docs" / "figures" / "heart.json").read_text())["figures"]
        with tempfile.TemporaryDirectory() as folder:
            cloud = pathlib.Path(folder) / "cloud.ply"
            pair = [heart / f"f7_dynamic_deint_{side}_0100.png" for side in "LR"]
            said = self.said_by("stereo_cloud.py", heart, *pair, cloud)
            self.assertEqual(len(glisson.read_surface(cloud).points_mm), int(figures["points"]["text"].replace(",", "")))
        self.assertIn(f"{figures['points']['text']} points, {figures['seen']['text']} % seen", said)

    def test_a_liver_is_registered_as_the_page_says(self):
        liver = self.data("pbsm_liver_insilico") / "Liver1"
        said = self.said_by("register_liver.py", *(liver / f"{name}.ply" for name in ("src", "tgt", "gt")), "icp", "geo")
        figures = json.loads((ROOT / "docs" / "figures" / "hidden-surface.json").read_text())["figures"]
        before_mm, icp_mm, geo_mm = re.search(r"before: ([\d.]+) mm\nicp: ([\d.]+) mm.*\ngeo: ([\d.]+) mm", said).groups()
        self.assertAlmostEqual(float(before_mm), figures["before"]["value"], delta=0.06)
        self.assertEqual(icp_mm, figures["after"]["text"])
        self.assertLess(float(geo_mm), figures["best"]["value"])

    def test_shapes_are_matched_in_other_poses_as_the_page_says(self):
        shapes = self.data("tosca_nonrigid_shapes")
        page = (ROOT / "docs" / "real-data.md").read_text()
        poses = re.findall(r"^\| (wolf|cat) (\d) to (\d) \|", page, re.MULTILINE)
        self.assertEqual(len(poses), 6)
        for shape, one, other in poses:
            said = self.said_by("match_poses.py", shapes / f"{shape}{one}.off", shapes / f"{shape}{other}.off")
            off, sampling, within = re.search(r"([\d.]+) %, sampling ([\d.]+) %, within (.*)", said).groups()
            shares = "; ".join(f"{share} within {limit} %" for share, limit in zip(within.split(), (5, 10, 15, 25)))
            self.assertIn(f"| {shape} {one} to {other} | {off} % off; {sampling} by sampling; {shares} |", page)

    def kept_sequences(self, folder, test):
        """Those that a test of the core judges, as files."""
        program = pathlib.Path(os.environ.get("GLISSON_TEST_SEQUENCES", "/nowhere"))
        if not program.exists():
            self.skipTest("test_registration_quality is not there")
        subprocess.run([program, f"--gtest_filter={test}"], check=True, capture_output=True,
                       env={**os.environ, "GLISSON_KEEP_SEQUENCES": str(folder)})

    def test_known_faults_are_found_as_the_page_says(self):
        self.data("pbsm_liver_insilico")
        page = (ROOT / "docs" / "real-data.md").read_text()
        rows = re.findall(r"^\| ([^|]*landmarks[^|]*) \|(.*/.*/.*/.*/.*)\|$", re.sub(r"<!--.*?-->", "", page), re.MULTILINE)
        with tempfile.TemporaryDirectory() as folder:
            self.kept_sequences(folder, "Sirgn.JudgesTheSameSequencesFromDisk")
            names = ["growing-200", "jumps-200", "jumps-60", "constant-200", "constant-60"]
            said = self.said_by("judge_known_fault.py", *(pathlib.Path(folder) / name for name in names)).splitlines()
        self.assertEqual(len(rows), len(said))
        for (what, on_page), row in zip(rows, said):
            figures = [[float(number) for number in re.findall(r"[\d.]+", cell)] for cell in on_page.split("|")]
            found = [[float(number) for number in re.findall(r"[\d.]+", cell)] for cell in row.split("|")[1:]]
            np.testing.assert_allclose(found, figures, atol=0.011, err_msg=what)  # clouds on disk have 32 bits

    def test_a_stereo_video_becomes_a_sequence_and_is_judged_as_the_page_says(self):
        self.data("hamlyn_heart_stereo")
        figures = json.loads((ROOT / "docs" / "figures" / "stereo-video.json").read_text())["figures"]
        with tempfile.TemporaryDirectory() as folder:
            self.kept_sequences(folder, "VideoSequence.GoesFrom*")
            video, out = pathlib.Path(folder) / "video", pathlib.Path(folder) / "sequence"
            said = self.said_by("sequence_from_video.py", video / "left", video / "right", video / "camera.json", out)
            judged = self.said_by("judge_video.py", out / "sequence.json", "icp", "gnra")
        self.assertIn(f"{figures['landmarks']['text']} landmarks agree within {figures['aligned']['text']} mm", said)
        self.assertIn(f"({figures['before']['text']} before)", said)
        icp, held_out, held_out_mm = re.search(r"icp: correlation ([\d.]+).*\ngnra: correlation ([\d.]+).*TRE ([\d.]+) mm",
                                               judged).groups()
        for found, name in ((icp, "icp"), (held_out, "held-out"), (held_out_mm, "held-out-mm")):
            self.assertEqual(f"{float(found):.2f}", figures[name]["text"], name)

    def test_a_camera_is_calibrated_as_the_page_says(self):
        pairs = sorted(self.data("ucl_stereo_laparoscope_calib").glob("08_*"))
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder) / "camera.json"
            said = self.said_by("calibrate_camera.py", 25, 18, 5, made, *pairs)
            self.assertAlmostEqual(glisson.read_calibration(made).baseline_mm, 4.7, delta=0.05)
        error_px, baseline_mm = re.search(r"off by ([\d.]+) px; the eyes are ([\d.]+) mm", said).groups()
        figures = json.loads((ROOT / "docs" / "figures" / "calibration.json").read_text())["figures"]
        self.assertEqual([error_px, baseline_mm], [figures[name]["text"] for name in ("error", "baseline")])


if __name__ == "__main__":
    unittest.main()
