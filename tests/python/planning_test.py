"""Vessels, territories and resection plans from Python: figures add up, and are those that numpy counts itself."""
import os
import pathlib
import tempfile
import unittest

from support import Case, ball, glisson, np

LIVER = pathlib.Path(os.environ.get("GLISSON_LIVER", "/nowhere"))


class Planning(Case):
    @classmethod
    def setUpClass(cls):
        if not (LIVER / "labels" / "liver.nrrd").exists():
            raise unittest.SkipTest("the generated liver is not there (test 'example: a liver')")
        cls.liver = glisson.read_mask_file(LIVER / "labels" / "liver.nrrd").mask
        cls.portal = glisson.read_mask_file(LIVER / "labels" / "portal-vein.nrrd").mask
        hepatic = glisson.read_mask_file(LIVER / "labels" / "hepatic-vein.nrrd").mask
        both = np.maximum(cls.portal.array, hepatic.array)
        cls.vessels = glisson.Mask(both, spacing_mm=cls.liver.spacing_mm, origin_mm=cls.liver.origin_mm,
                                   direction=cls.liver.direction)
        cls.trees = glisson.vessel_trees(cls.vessels, cls.liver)
        cls.segments = glisson.couinaud_segments(cls.liver, cls.trees)

    def test_trees_follow_the_vessels_and_come_back_from_a_file(self):
        points = np.vstack([b["points_mm"] for b in self.trees.branches])
        index = np.rint([self.liver.index_of(p) for p in points[::50]]).astype(int)
        beside = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
        near = np.max([self.vessels.array[tuple((index + step).T)] for step in beside], axis=0)
        self.assertGreater(near.mean(), 0.95)  # within a voxel; the rest bridges gaps
        for number, branch in enumerate(self.trees.branches):
            self.assertLess(branch["parent"], number)
            self.assertEqual(branch["points_mm"].shape, (len(branch["radii_mm"]), 3))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "trees.json"
            glisson.write_trees(file, self.trees)
            again = glisson.read_trees(file)
        self.assertEqual([b["name"] for b in again.branches], [b["name"] for b in self.trees.branches])

    def test_arteries_get_trees_and_change_nothing_of_the_veins(self):
        artery = glisson.read_mask_file(LIVER / "labels" / "artery.nrrd").mask
        trees = glisson.vessel_trees(self.vessels, self.liver, arteries=artery)
        self.assertEqual({b["system"] for b in trees.branches}, {"portal-vein", "hepatic-vein", "artery"})
        veins = [b["name"] for b in trees.branches if b["system"] != "artery"]
        self.assertEqual(veins, [b["name"] for b in self.trees.branches])
        planner = glisson.Planner(self.liver, trees=trees)
        middle = [float(x) for x in np.mean([b["points_mm"][0] for b in trees.branches if b["system"] == "artery"], axis=0)]
        cut = planner.answer({"plane": {"point_mm": middle, "normal": [1, 0, 0]}})
        arteries = [b for b in cut["branches"] if b["system"] == "artery"]
        self.assertGreater(max(b["beyond_mm"] for b in arteries), 10)
        self.assertTrue(all(b["beyond_ml"] == 0 and b["name"].startswith("hepatic-artery/") for b in arteries))

    def test_each_voxel_belongs_to_one_branch_and_one_segment(self):
        found = glisson.territories(self.trees, "portal-vein", self.liver)
        inside = self.liver.array == 1
        self.assertTrue((found["branch"][~inside] == -1).all())
        ml = self.liver.voxel_volume_mm3 / 1000
        counted = np.bincount(found["branch"][found["branch"] >= 0], minlength=len(self.trees.branches)) * ml
        np.testing.assert_allclose(found["volume_ml"], counted, atol=1e-9)
        segment = self.segments["segment"].array
        self.assertTrue(((segment > 0) == inside).all())
        counted = np.bincount(segment[inside], minlength=9)[1:] * ml
        np.testing.assert_allclose(self.segments["volume_ml"][1:], counted, rtol=1e-9)

    def test_a_border_passes_where_a_hand_set_it(self):
        segment = self.segments["segment"].array
        above = np.argwhere((segment[:, :, :-1] == 5) & (segment[:, :, 1:] == 8))
        i, j, k = above[len(above) // 2]
        place = self.liver.position_mm(np.array([i, j, k + 0.5])) + np.array([0.0, 0.0, 5.0])
        set_by_hand = glisson.couinaud_segments(self.liver, borders=[("V-VIII", place)])["segment"].array
        index = np.floor(self.liver.index_of(place)).astype(int)
        around = set_by_hand[tuple(slice(n, n + 2) for n in index)]
        self.assertLessEqual({5, 8}, set(np.unique(around)))
        for border, where, code in [("II-VII", place, "choice-unknown"), ("V-VIII", [0, 0, 9e3], "border-outside")]:
            with self.assertRaises(glisson.Error) as refused:
                glisson.couinaud_segments(self.liver, borders=[(border, where)])
            self.assertEqual(refused.exception.code, code)

    def test_what_a_plan_takes_is_what_it_names(self):
        planner = glisson.Planner(self.liver, segments=self.segments["segment"])
        plan = planner.answer({"segments": [6, 7]})
        self.assertAlmostEqual(plan["removed_ml"], sum(self.segments["volume_ml"][6:8]), delta=1e-6)
        self.assertAlmostEqual(plan["removed_ml"] + plan["remnant_ml"], plan["liver_ml"], delta=1e-6)
        parts = planner.parts({"segments": [6, 7]})
        self.assertAlmostEqual((parts.array == 2).sum() * parts.voxel_volume_mm3 / 1000, plan["removed_ml"], delta=1e-6)

    def test_a_plane_parts_the_voxels_as_numpy_does(self):
        mask = ball(40, 30.0, 2.0)
        planner = glisson.Planner(mask, tumours={"tumour-1": ball(40, 6.0, 2.0)})
        cut = {"plane": {"point_mm": [0, 0, 9], "normal": [0, 0, 1], "removed": "above"}}
        plan = planner.answer([cut])
        z = mask.origin_mm[2] + np.arange(40) * 2.0
        above = mask.array[:, :, z > 9].sum() * 0.008
        self.assertAlmostEqual(plan["removed_ml"], above, delta=1e-6)
        self.assertAlmostEqual(plan["tumours"][0]["margin_mm"], 4, delta=1.0)  # within half a voxel, from 5 mm on
        unrolled = planner.unrolled(cut)[0]
        self.assertEqual(unrolled["margin_mm"].ndim, 2)
        self.assertAlmostEqual(np.nanmin(unrolled["margin_mm"]), plan["tumours"][0]["margin_mm"], delta=1.5)

    def test_what_is_no_plan_is_refused(self):
        planner = glisson.Planner(ball())
        self.assertRefused("plan-invalid", planner.answer, {"segment": 6})
        self.assertRefused("segments-missing", planner.answer, {"segments": [6]})
        self.assertRefused("tumour-unknown", planner.answer, {"around": "tumour-9", "margin_mm": 5})
        self.assertRefused("choice-unknown", glisson.territories, self.trees, "bile-duct", self.liver)


if __name__ == "__main__":
    unittest.main()
