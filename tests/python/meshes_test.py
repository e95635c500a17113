"""Meshes as arrays: shared memory, read only, kept alive; bad ones refused with what is wrong."""
import gc
import pathlib
import tempfile
import unittest

from support import Case, glisson, np

CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
CELLS = [[0, 1, 2, 3], [1, 2, 3, 4]]


def two_cells(**fields):
    return glisson.TetMesh(10 * np.array(CORNERS, float), CELLS, **fields)


class Meshes(Case):
    def test_arrays_are_views_of_one_memory(self):
        mesh = two_cells(cell_fields={"youngs_modulus_kPa": [5.0, 6.0]}, point_fields={"u_mm": np.arange(15.0).reshape(5, 3)})
        for take in (lambda: mesh.points_mm, lambda: mesh.cells, lambda: mesh.cell_fields["youngs_modulus_kPa"],
                     lambda: mesh.point_fields["u_mm"]):
            self.assertTrue(np.shares_memory(take(), take()))
            self.assertFalse(take().flags.writeable)
        self.assertEqual((mesh.points_mm.dtype, mesh.points_mm.shape), (np.float64, (5, 3)))
        self.assertEqual((mesh.cells.dtype, mesh.cells.shape), (np.int32, (2, 4)))
        np.testing.assert_array_equal(mesh.point_fields["u_mm"], np.arange(15.0).reshape(5, 3))

    def test_arrays_outlive_their_mesh(self):
        mesh = two_cells(cell_fields={"label": [1, 2]})
        points, cells, label = mesh.points_mm, mesh.cells, mesh.cell_fields["label"]
        del mesh
        gc.collect()
        _ = [two_cells() for _ in range(100)]
        np.testing.assert_array_equal(points, 10 * np.array(CORNERS))
        np.testing.assert_array_equal(cells, CELLS)
        np.testing.assert_array_equal(label, [1, 2])

    def test_a_mesh_with_more_fields_is_another(self):
        mesh = two_cells()
        view = mesh.points_mm
        stiff = mesh.with_fields(cell_fields={"youngs_modulus_kPa": [5, 6]})
        self.assertEqual(mesh.cell_fields, {})
        self.assertEqual(list(stiff.cell_fields), ["youngs_modulus_kPa"])
        self.assertFalse(np.shares_memory(view, stiff.points_mm))

    def test_volume_and_boundary(self):
        mesh = two_cells()
        self.assertAlmostEqual(mesh.volume_mm3, 1000 / 6 + 2000 / 6)
        surface = glisson.boundary_surface(mesh)
        self.assertEqual(len(surface.triangles), 6)
        self.assertTrue(surface.is_watertight)
        self.assertAlmostEqual(surface.volume_mm3, mesh.volume_mm3)
        np.testing.assert_allclose(glisson.cell_centroids_mm(mesh)[0], [2.5, 2.5, 2.5])

    def test_files_bring_meshes_back(self):
        mesh = two_cells(cell_fields={"youngs_modulus_kPa": [5.0, 6.0]})
        surface = glisson.boundary_surface(mesh)
        with tempfile.TemporaryDirectory() as folder:
            body, skin = pathlib.Path(folder) / "body.vtu", pathlib.Path(folder) / "skin.vtp"
            glisson.write_tetrahedra(body, mesh)
            glisson.write_surface(skin, surface)
            again = glisson.read_tetrahedra(body)
            np.testing.assert_array_equal(again.cells, mesh.cells)
            np.testing.assert_array_equal(again.cell_fields["youngs_modulus_kPa"], [5, 6])
            np.testing.assert_array_equal(glisson.read_surface(skin).points_mm, surface.points_mm)

    def test_bad_meshes_are_refused(self):
        points = np.array(CORNERS, float)
        self.assertRefused("array-shape", glisson.TetMesh, points[:, :2], CELLS)
        self.assertRefused("array-shape", glisson.TetMesh, points, [[0, 1, 2]])
        self.assertRefused("array-not-whole", glisson.TetMesh, points, np.array(CELLS, float))
        self.assertRefused("array-not-whole", glisson.TetMesh, points, np.array(CELLS) + 2**40)
        for wrong in ([[0, 1, 2, 9]], [[0, 2, 1, 3]], [[0, 1, 2, -1]]):
            with self.assertRaises(glisson.Error):
                glisson.TetMesh(points, wrong)
        self.assertRefused("array-shape", glisson.TetMesh, points, "cells")
        points[0, 0] = np.nan
        with self.assertRaises(glisson.Error):
            glisson.TetMesh(points, CELLS)
        error = self.assertRefused("array-shape", two_cells, cell_fields={"E": [1, 2, 3]})
        self.assertIn('cell_fields["E"]', str(error))
        self.assertRefused("array-shape", glisson.Surface, CORNERS, CELLS)
        self.assertRefused("file-not-readable", glisson.read_surface, "/nowhere/liver.vtp")


if __name__ == "__main__":
    unittest.main()
