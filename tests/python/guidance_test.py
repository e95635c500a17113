"""An organ found in a camera's frames, beside where it truly is."""
import json
import unittest

from support import Case, DATA, glisson, np


class Guidance(Case):
    def test_targets_are_found_where_they_are(self):
        folder = DATA / "guidance_examples" / "example-a"
        if not folder.exists():
            self.skipTest(f"{folder} is not there")
        found = glisson.guide(folder / "guidance.json")
        truth = {frame["id"]: frame["targets"] for frame in json.loads((folder / "truth.json").read_text())["frames"]}
        self.assertEqual({frame["id"] for frame in found["frames"]}, set(truth))
        for frame in found["frames"]:
            self.assertTrue(frame["converged"])
            self.assertEqual(frame["displacement_mm"].shape, found["mesh"].points_mm.shape)
            rotation = frame["pose"][:3, :3]
            np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-9)
            true_mm = {target["id"]: np.array(target["position_mm"]) for target in truth[frame["id"]]}
            off_mm = [np.linalg.norm(target["position_mm"] - true_mm[target["id"]]) for target in frame["targets"]]
            self.assertLess(np.median(off_mm), 10)  # the method is judged in tests/guidance

    def test_what_is_no_guidance_case_is_refused(self):
        self.assertRefused("file-not-readable", glisson.guide, "/nowhere/guidance.json")


if __name__ == "__main__":
    unittest.main()
