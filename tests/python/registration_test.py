"""Surfaces brought back from where they were moved, matched, and judged."""
import unittest

from support import Case, ball, glisson, np


def lump(size=40):
    """A surface without symmetry: a ball with bumps of three sizes."""
    axis = (np.arange(size) - (size - 1) / 2) * 2.0
    i, j, k = np.meshgrid(axis, axis, axis, indexing="ij")
    inside = (i / 1.3) ** 2 + j**2 + (k / 0.8) ** 2 < 20**2
    for x, y, z, r in ((22, 8, 0, 10), (-8, 16, 8, 8), (0, -10, 14, 6)):
        inside |= (i - x) ** 2 + (j - y) ** 2 + (k - z) ** 2 < r * r
    return glisson.mask_surface(glisson.Mask(inside, spacing_mm=[2, 2, 2], origin_mm=[axis[0]] * 3))


def turned(points, degrees, shift):
    a = np.radians(degrees)
    rotation = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    return points @ rotation.T + shift, rotation


class Registration(Case):
    def test_matched_points_give_the_motion(self):
        points = np.random.default_rng(3).normal(0, 30, (20, 3))
        moved, rotation = turned(points, 30, [5, -3, 2])
        transform = glisson.align_points(points, moved)
        np.testing.assert_allclose(transform[:3, :3], rotation, atol=1e-9)
        np.testing.assert_allclose(transform[:3, 3], [5, -3, 2], atol=1e-9)
        self.assertRefused("alignment-sizes", glisson.align_points, points, moved[:-1])
        self.assertRefused("alignment-too-few-points", glisson.align_points, points[:2], moved[:2])

    def test_a_moved_surface_is_brought_back(self):
        source = lump()
        moved, rotation = turned(source.points_mm, 12, [4, 2, -3])
        target = glisson.Surface(moved, source.triangles)
        rigid = glisson.rigid_icp(source, target)
        np.testing.assert_allclose(rigid["transform"][:3, :3], rotation, atol=0.02)
        bent = glisson.register_surfaces(source, target)
        self.assertLess(bent["rms_mm"], 0.5)
        self.assertEqual(bent["surface"].points_mm.shape, source.points_mm.shape)
        self.assertRefused("method-unknown", glisson.register_surfaces, source, target, method="magic")

    def test_surfaces_match_in_any_pose(self):
        source = lump()
        moved, _ = turned(source.points_mm, 150, [200, 0, 0])
        match = glisson.match_surfaces(source, glisson.Surface(moved, source.triangles), points=64)
        off_mm = np.linalg.norm(source.points_mm[match.source_points] - source.points_mm[match.target_points], axis=1)
        self.assertLess(np.median(off_mm), 6)
        self.assertGreater(match.orientation_kept, 0.6)
        self.assertEqual(match.densify().shape, (len(source.points_mm),))
        self.assertLessEqual(match.solution["lower_bound"], match.solution["energy"])
        self.assertRefused("solver-unknown", glisson.match_surfaces, source, source, solver="magic")

    def test_distances_alone_bring_nodes_to_labels(self):
        points = np.random.default_rng(5).normal(0, 30, (24, 3))
        between = np.linalg.norm(points[:, None] - points[None], axis=2)
        order = np.random.default_rng(6).permutation(24)
        found = glisson.trwls(between, between[np.ix_(order, order)], sigma_mm=50, tau_mm=20)
        np.testing.assert_array_equal(order[found["labels"]], np.arange(24))
        self.assertAlmostEqual(found["energy"], 0, delta=1e-6)
        self.assertRefused("matching-distances", glisson.trwls, -between, between, sigma_mm=50, tau_mm=20)
        self.assertRefused("matching-constants", glisson.trwls, between, between, sigma_mm=0, tau_mm=20)
        self.assertRefused("matching-passes", glisson.trwls, between, between, sigma_mm=50, tau_mm=20, passes=0)


class Judgement(Case):
    def test_bad_sequences_are_refused(self):
        cloud = np.random.default_rng(1).normal(0, 30, (50, 3))
        track = {"a": np.zeros((2, 3))}
        self.assertRefused("sirgn-too-few-frames", glisson.sirgn, [(cloud, cloud)] * 2, track)
        self.assertRefused("sirgn-not-point-for-point", glisson.sirgn, [(cloud, cloud[1:])] * 3,
                           {n: np.tile(cloud[k], (3, 1)) for k, n in enumerate("abcde")})
        self.assertRefused("array-shape", glisson.sirgn, [(cloud, cloud)] * 3, {"a": np.zeros(3)})
        self.assertRefused("method-unknown", glisson.sirgn_of_sequence, "s.json", "magic")


if __name__ == "__main__":
    unittest.main()
