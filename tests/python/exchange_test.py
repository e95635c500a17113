"""Images and meshes of other packages, to Glisson and back, in the right place."""
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
try:
    import SimpleITK
except ImportError:
    SimpleITK = None
try:
    from vtkmodules import vtkCommonDataModel, vtkFiltersCore, vtkFiltersSources, vtkIOImage
except ImportError:
    vtkCommonDataModel = None
try:
    import pyvista
except ImportError:
    pyvista = None


class Placed(Case):
    """An image on a grid that no two axes of which are alike."""

    def setUp(self):
        values = np.arange(24, dtype=np.float32).reshape(4, 3, 2)
        turned = [[0, 1, 0], [1, 0, 0], [0, 0, -1]]
        self.volume = glisson.Volume(values, spacing_mm=[1, 2, 3], origin_mm=[10, 20, 30], direction=turned)

    def assertSame(self, a, b):
        np.testing.assert_array_equal(a.array, b.array)
        np.testing.assert_allclose(a.spacing_mm, b.spacing_mm, atol=1e-5)
        np.testing.assert_allclose(a.origin_mm, b.origin_mm, atol=1e-4)
        np.testing.assert_allclose(a.direction, b.direction, atol=1e-6)


@unittest.skipIf(nibabel is None, "nibabel is not there (python3-nibabel)")
class Nibabel(Placed):
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


@unittest.skipIf(SimpleITK is None, "SimpleITK is not there (not in Debian 12; pip install SimpleITK)")
class ItkImages(Placed):
    def test_there_and_back(self):
        self.assertSame(glisson.exchange.from_simpleitk(glisson.exchange.to_simpleitk(self.volume)), self.volume)

    def test_both_place_the_same_file_alike(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "ours.nrrd"
            glisson.write_volume_file(file, self.volume)
            self.assertSame(glisson.exchange.from_simpleitk(SimpleITK.ReadImage(str(file))), self.volume)

    def test_what_is_no_volume(self):
        self.assertRefused("array-shape", glisson.exchange.from_simpleitk, SimpleITK.Image([4, 4], SimpleITK.sitkUInt8))


@unittest.skipIf(vtkCommonDataModel is None, "VTK's package is not there (python3-vtk9)")
class Vtk(Placed):
    def test_an_image_there_and_back(self):
        image = glisson.exchange.to_vtk(self.volume)
        self.assertSame(glisson.exchange.from_vtk(image), self.volume)
        image.GetPointData().GetScalars().SetTuple1(0, 77)
        self.assertEqual(self.volume.array[0, 0, 0], 77)

    def test_vtk_has_each_voxel_at_the_same_place(self):
        image, turned = glisson.exchange.to_vtk(self.volume), self.volume.direction
        for voxel in ([0, 0, 0], [3, 0, 0], [0, 2, 0], [1, 1, 1]):
            place = image.GetPoint(image.ComputePointId(voxel))
            np.testing.assert_allclose(place, self.volume.origin_mm + turned @ (self.volume.spacing_mm * voxel))
            self.assertEqual(image.GetScalarComponentAsDouble(*voxel, 0), self.volume.array[tuple(voxel)])

    def test_both_place_the_same_file_alike(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "ours.nii"
            straight = glisson.Volume(self.volume.array, spacing_mm=[1, 2, 3])
            glisson.write_volume_file(file, straight)
            reader = vtkIOImage.vtkNIFTIImageReader()
            reader.SetFileName(str(file))
            reader.Update()
            np.testing.assert_array_equal(glisson.exchange.from_vtk(reader.GetOutput()).array, straight.array)

    def test_meshes_there_and_back_with_fields(self):
        solid = glisson.mesh_labels(ball(), target_cells=1000).body
        solid = solid.with_fields(cell_fields={"youngs_modulus_kPa": np.linspace(4, 8, len(solid.cells))},
                                  point_fields={"displacement_mm": 2 * solid.points_mm})
        again = glisson.exchange.from_vtk(glisson.exchange.to_vtk(solid))
        for name in ("points_mm", "cells"):
            np.testing.assert_array_equal(getattr(again, name), getattr(solid, name))
        np.testing.assert_array_equal(again.cell_fields["youngs_modulus_kPa"], solid.cell_fields["youngs_modulus_kPa"])
        np.testing.assert_array_equal(again.point_fields["displacement_mm"], solid.point_fields["displacement_mm"])
        surface = glisson.boundary_surface(solid)
        np.testing.assert_array_equal(glisson.exchange.from_vtk(glisson.exchange.to_vtk(surface)).triangles, surface.triangles)

    def test_vtk_measures_the_same_body(self):
        solid = glisson.mesh_labels(ball(), target_cells=1000).body
        sizes = vtkFiltersCore.vtkMassProperties()
        sizes.SetInputData(glisson.exchange.to_vtk(glisson.boundary_surface(solid)))
        self.assertAlmostEqual(sizes.GetVolume() / solid.volume_mm3, 1, delta=1e-6)

    def test_lines_alone_are_refused(self):
        sphere = vtkFiltersSources.vtkSphereSource()
        sphere.Update()
        surface = glisson.exchange.from_vtk(sphere.GetOutput())
        self.assertEqual(len(surface.triangles), sphere.GetOutput().GetNumberOfCells())
        line = vtkFiltersSources.vtkLineSource()
        line.Update()
        self.assertIn("3", str(self.assertRefused("mesh-cell-type", glisson.exchange.from_vtk, line.GetOutput())))

    @unittest.skipIf(pyvista is None, "PyVista is not there (not in Debian 12; pip install pyvista)")
    def test_pyvistas_types_are_vtks(self):
        surface = glisson.boundary_surface(glisson.mesh_labels(ball(), target_cells=1000).body)
        wrapped = pyvista.wrap(glisson.exchange.to_vtk(surface))
        np.testing.assert_array_equal(glisson.exchange.from_vtk(wrapped).triangles, surface.triangles)
        self.assertSame(glisson.exchange.from_vtk(pyvista.wrap(glisson.exchange.to_vtk(self.volume))), self.volume)


if __name__ == "__main__":
    unittest.main()
