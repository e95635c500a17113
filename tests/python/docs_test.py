"""docs/python.md tells what there is, no more and no less, and its programs run."""
import inspect
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from support import Case, ROOT, ball, glisson, np

PROGRAMS = ROOT / "docs" / "examples" / "python"


def shown():
    """Public functions and classes of the package that need a line in the table."""
    answers = {"Error", "Grown", "LiverMesh", "PlacedTool", "RehearsalState", "SegmentedMask", "Series", "SessionState",
               "Simulation", "Study", "SurfaceMatch", "set_thread_count"}  # what functions answer with
    return {name for name, value in vars(glisson).items()
            if not name.startswith("_") and not inspect.ismodule(value) and name not in answers}


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


if __name__ == "__main__":
    unittest.main()
