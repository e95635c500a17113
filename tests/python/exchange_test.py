"""Images of nibabel and meshes of meshio, to Glisson and back, in the right place."""
import pathlib
import tempfile
import unittest

from support import Case, ball, glisson, np

try:
    import nibabel
except ImportError:
    nibabel = None
try:
    import meshio
except ImportError:
    meshio = None


@unittest.skipIf(nibabel is None, "nibabel is not there (python3-nibabel)")
class Nibabel(Case):
    def setUp(self):
        values = np.arange(24, dtype=np.float32).reshape(4, 3, 2)
        turned = [[0, 1, 0], [1, 0, 0], [0, 0, -1]]
        self.volume = glisson.Volume(values, spacing_mm=[1, 2, 3], origin_mm=[10, 20, 30], direction=turned)

    def assertSame(self, a, b):
        np.testing.assert_array_equal(a.array, b.array)
        np.testing.assert_allclose(a.spacing_mm, b.spacing_mm, atol=1e-5)
        np.testing.assert_allclose(a.origin_mm, b.origin_mm, atol=1e-4)
        np.testing.assert_allclose(a.direction, b.direction, atol=1e-6)

    def test_there_and_back(self):
        image = glisson.exchange.to_nibabel(self.volume)
        self.assertTrue(np.shares_memory(image.dataobj, self.volume.array))
        self.assertSame(glisson.exchange.from_nibabel(image), self.volume)

    def test_both_place_the_same_file_alike(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder) / "ours.nii.gz", pathlib.Path(folder) / "theirs.nii.gz"
            glisson.write_volume_file(ours, self.volume)
            self.assertSame(glisson.exchange.from_nibabel(nibabel.load(ours)), self.volume)
            nibabel.save(glisson.exchange.to_nibabel(self.volume), theirs)
            self.assertSame(glisson.read_volume_file(theirs), self.volume)

    def test_masks_and_what_is_no_volume(self):
        image = nibabel.Nifti1Image(np.ones((2, 2, 2, 1), np.uint8), np.eye(4))
        self.assertIsInstance(glisson.exchange.from_nibabel(image, glisson.Mask), glisson.Mask)
        self.assertRefused("array-shape", glisson.exchange.from_nibabel, nibabel.Nifti1Image(np.zeros((2, 2, 2, 5)), np.eye(4)))


@unittest.skipIf(meshio is None, "meshio is not there (python3-meshio)")
class Meshio(Case):
    def test_there_and_back_with_fields(self):
        mesh = glisson.mesh_labels(ball(), target_cells=1000).body
        mesh = mesh.with_fields(cell_fields={"youngs_modulus_kPa": np.linspace(4, 8, len(mesh.cells))})
        given = glisson.exchange.to_meshio(mesh)
        self.assertTrue(np.shares_memory(given.points, mesh.points_mm))
        again = glisson.exchange.from_meshio(given)
        np.testing.assert_array_equal(again.points_mm, mesh.points_mm)
        np.testing.assert_array_equal(again.cells, mesh.cells)
        np.testing.assert_array_equal(again.cell_fields["youngs_modulus_kPa"], mesh.cell_fields["youngs_modulus_kPa"])

    def test_points_of_other_cells_are_left_out(self):
        points = [[0, 0, 0], [9, 9, 9], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        mixed = meshio.Mesh(np.array(points, float), [("line", [[0, 1]]), ("tetra", [[0, 2, 3, 4]])])
        self.assertEqual(len(glisson.exchange.from_meshio(mixed).points_mm), 4)
        only_lines = meshio.Mesh(np.array(points, float), [("line", [[0, 1]])])
        error = self.assertRefused("mesh-cell-type", glisson.exchange.from_meshio, only_lines)
        self.assertIn("line", str(error))


if __name__ == "__main__":
    unittest.main()
