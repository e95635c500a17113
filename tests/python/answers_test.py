"""Explanations, predictions, plans and pictures as Python's own values."""
import json
import pathlib
import tempfile
import unittest

from support import Case, ROOT, ball, glisson, np

TISSUE = ROOT / "resources" / "examples" / "tissue"


class ClosedLoop(Case):
    def test_what_was_explained_predicts_better(self):
        explained = glisson.explain(TISSUE / "experiment.json")
        self.assertEqual(explained["report"]["verdict"], "explained")
        declared = glisson.predict(TISSUE / "experiment.json")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "model.json"
            file.write_text(json.dumps(explained["model"]))
            better = glisson.predict(TISSUE / "experiment.json", file)
        self.assertLess(better["error"]["rms"], 0.1 * declared["error"]["rms"])
        self.assertAlmostEqual(declared["error"]["rms"], explained["report"]["before"]["rms"])
        self.assertEqual(sum(len(trial["predicted"]) for trial in better["trials"]), len(better["predicted"]))

    def test_what_is_no_experiment_is_refused(self):
        self.assertRefused("file-not-readable", glisson.explain, "/nowhere/experiment.json")
        with self.assertRaises(glisson.Error):
            glisson.predict(TISSUE / "truth.json")


class Hardware(Case):
    def test_a_plan_says_who_holds_and_why_others_fail(self):
        plan = glisson.plan_hardware(liver_volume_cm3=1500, accuracy_mm=5)
        ids = {platform["id"] for platform in plan["platforms"]}
        self.assertIn(plan["recommended"], ids | {None})
        for platform in plan["platforms"]:
            self.assertEqual(platform["feasible"], not platform["reasons"])
        self.assertRefused("volume-not-a-liver", glisson.plan_hardware, liver_volume_cm3=1, accuracy_mm=5)
        self.assertRefused("request-invalid", glisson.plan_hardware, liver_volume_cm3=1500, accuracy_mm=5, frames_per_s=0)


class Pictures(Case):
    def setUp(self):
        self.surface = glisson.mask_surface(ball())

    def draw(self, **named):
        try:
            return glisson.draw_surface(self.surface, width=160, height=120, **named)
        except glisson.Error as error:
            if error.code == "drawing-unavailable":
                self.skipTest(str(error))
            raise

    def test_a_surface_is_drawn_into_an_array(self):
        red, green = self.draw(color_rgb=(0.9, 0.1, 0.1)), self.draw(color_rgb=(0.1, 0.9, 0.1))
        self.assertEqual((red.shape, red.dtype), ((120, 160, 3), np.uint8))
        self.assertGreater(int(red[60, 80, 0]), int(red[60, 80, 1]))
        self.assertGreater(int(green[60, 80, 1]), int(green[60, 80, 0]))
        np.testing.assert_array_equal(red, self.draw(color_rgb=(0.9, 0.1, 0.1)))

    def test_what_cannot_be_drawn_is_refused(self):
        self.assertRefused("picture-size", glisson.draw_surface, self.surface, width=1, height=1)
        self.assertRefused("scene-invalid", glisson.draw_surface, self.surface, field="nothing")
        self.assertRefused("colour-map-unknown", glisson.draw_surface, self.surface, field="x", colour_map="jet")


if __name__ == "__main__":
    unittest.main()
