"""Structures grown from seeds, meshed, and given their stiffness."""
import unittest

from support import Case, ball, glisson, np


def image_of(mask):
    values = np.where(mask.array, 200.0, 60.0) + np.random.default_rng(7).normal(0, 8, mask.array.shape)
    return glisson.Volume(values, spacing_mm=mask.spacing_mm, origin_mm=mask.origin_mm)


class Segmentation(Case):
    def test_a_ball_is_grown_from_a_point_inside(self):
        truth = ball(56, 60.0, 2.5)
        grown = glisson.grow_from_seeds(image_of(truth), [[0, 0, 0]])
        self.assertGreater(glisson.dice(grown.mask, truth), 0.95)
        self.assertAlmostEqual(grown.volume_ml, glisson.volume_ml(grown.mask))
        self.assertAlmostEqual(grown.brightness, 200, delta=5)

    def test_a_lesion_stands_out_from_what_is_around(self):
        liver, lesion = ball(56, 60.0, 2.5), ball(56, 12.0, 2.5)
        image = image_of(liver)
        image.array[...] -= 80 * lesion.array
        grown = glisson.grow_contrast(image, [[0, 0, 0]], "lesion", within=liver)
        self.assertGreater(glisson.dice(grown.mask, lesion), 0.85)

    def test_vessels_are_found_by_their_shape(self):
        liver = ball(56, 60.0, 2.5)
        image = image_of(liver)
        tube = np.zeros(liver.array.shape, bool)
        tube[25:31, 26:30, 4:-4] = True
        image.array[...] += 90 * (tube & (liver.array > 0))
        found = glisson.segment_vessels(image, liver)
        self.assertGreater((found.mask.array > 0)[tube].sum(), 0.7 * (tube & (liver.array > 0)).sum())
        self.assertLess((found.mask.array > 0)[~tube].sum(), 0.5 * tube.sum())
        self.assertGreater(found.brightness, 250)
        self.assertRefused("vessels-none", glisson.segment_vessels, image, liver, brightness="dark")
        self.assertRefused("choice-unknown", glisson.segment_vessels, image, liver, brightness="green")
        self.assertRefused("grids-differ", glisson.segment_vessels, image, ball(16))

    def test_bad_seeds_and_kinds_are_refused(self):
        image = image_of(ball())
        self.assertRefused("grow-no-seeds", glisson.grow_from_seeds, image, np.zeros((0, 3)))
        self.assertRefused("array-shape", glisson.grow_from_seeds, image, [0, 0, 0])
        error = self.assertRefused("grow-seed-outside", glisson.grow_from_seeds, image, [[1000, 0, 0]])
        self.assertTrue(error.arguments)
        self.assertRefused("kind-unknown", glisson.grow_contrast, image, [[0, 0, 0]], "organ")
        self.assertRefused("grids-differ", glisson.grow_contrast, image, [[0, 0, 0]], "lesion", within=ball(16))
        self.assertRefused("masks-grids-differ", glisson.dice, ball(16), ball(32))


class Meshing(Case):
    def test_a_mask_becomes_tetrahedra_of_its_volume(self):
        mask = ball(32, 24.0)
        made = glisson.mesh_labels(mask, target_cells=3000)
        self.assertAlmostEqual(made.body.volume_mm3 / 1000, glisson.volume_ml(mask), delta=0.05 * glisson.volume_ml(mask))
        self.assertTrue(made.surface.is_watertight)
        self.assertLess(made.hausdorff_mm, 6)
        self.assertEqual(made.regions[0]["label"], 1)
        self.assertGreater(made.body.quality()["min_dihedral_deg"], 3)

    def test_what_is_made_outlives_what_made_it(self):
        body = glisson.mesh_labels(ball(), target_cells=1000).body
        points = body.points_mm
        del body
        self.assertTrue(np.isfinite(points).all())

    def test_empty_masks_and_options_are_refused(self):
        nothing = glisson.Mask.empty((8, 8, 8))
        self.assertRefused("mask-empty", glisson.mask_surface, nothing)
        self.assertRefused("labels-empty", glisson.mesh_labels, nothing)
        self.assertRefused("mesh-options", glisson.mesh_labels, ball(), target_cells=-1)


class Stiffness(Case):
    def test_each_cell_takes_its_own_voxel(self):
        mask = ball(32, 24.0)
        body = glisson.mesh_labels(mask, target_cells=1500).body
        shear = glisson.Volume(np.full((32, 32, 32), 2.1), spacing_mm=mask.spacing_mm, origin_mm=mask.origin_mm, unit="kPa")
        shear.array[16:] = 4.2
        found = glisson.cell_stiffness(body, shear, organ=mask, poisson_ratio=0.45)
        x_mm = glisson.cell_centroids_mm(body)[:, 0]
        at = found["measured"]
        self.assertTrue(at.any() and not at.all())
        np.testing.assert_allclose(found["youngs_kPa"][at & (x_mm < -2)], 2 * 2.1 * 1.45, rtol=1e-6)
        np.testing.assert_allclose(found["youngs_kPa"][at & (x_mm > 2)], 2 * 4.2 * 1.45, rtol=1e-6)
        self.assertAlmostEqual(found["filled_fraction"], 1 - at.mean())

    def test_maps_elsewhere_are_refused(self):
        body = glisson.mesh_labels(ball(), target_cells=1000).body
        elsewhere = glisson.Volume(np.ones((8, 8, 8)), origin_mm=[1000, 0, 0])
        self.assertRefused("stiffness-no-overlap", glisson.cell_stiffness, body, elsewhere)
        self.assertRefused("array-shape", glisson.invert, np.zeros((8, 4, 4, 4)), frequency_Hz=60)
        self.assertRefused("waves-no-frequency", glisson.invert, np.zeros((1, 8, 4, 4, 4)), frequency_Hz=0)
        self.assertRefused("waves-too-few-offsets", glisson.invert, np.zeros((1, 2, 4, 4, 4)), frequency_Hz=60)


if __name__ == "__main__":
    unittest.main()
