"""Cases from Python: made, filled, read back, and refused where they are none."""
import json
import pathlib
import sys
import tempfile
import unittest

from support import Case, ball, glisson, np


def image_of(mask, inside=200.0, outside=60.0):
    """A Volume with even noise about two values."""
    values = np.where(mask.array, inside, outside) + np.random.default_rng(7).normal(0, 8, mask.array.shape)
    return glisson.Volume(values, spacing_mm=mask.spacing_mm, origin_mm=mask.origin_mm)


class Cases(Case):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def test_from_an_image_to_a_model(self):
        liver = ball(56, 60.0, 2.5)
        glisson.write_volume_file(self.root / "anatomy.nrrd", image_of(liver))
        case = glisson.Case.create(self.root / "patient.glisson")
        case.import_study(self.root / "anatomy.nrrd")
        anatomy = case.volume("volumes/anatomy")
        self.assertEqual(anatomy.array.shape, liver.array.shape)
        grown = case.grow_structure("liver", [[0, 0, 0]])
        self.assertEqual(grown["id"], "labels/liver")
        self.assertGreater(glisson.dice(case.mask("liver"), liver), 0.95)
        mesh = case.mesh_liver(target_cells=1500)
        youngs = case.assign_stiffness(uniform_kPa=6.1)
        self.assertEqual(youngs.shape, (len(mesh.cells),))
        self.assertTrue((youngs == 6.1).all())
        self.assertEqual(case.structures, ["liver"])
        again = glisson.Case(self.root / "patient.glisson")
        np.testing.assert_array_equal(again.mesh("meshes/model").cell_fields["youngs_modulus_kPa"], youngs)
        self.assertTrue(again.surface("liver").is_watertight)
        self.assertEqual(again.freshness("meshes/model"), "current")
        asked = again.question({"loads": [{"gravity_m_s2": [0, 9.81, 0]}]})
        self.assertTrue(asked["scenario"]["supports"])
        found = glisson.simulate(asked["mesh"], asked["scenario"])
        self.assertGreater(found.max_displacement_mm, 0.1)
        np.testing.assert_allclose(found.reactions_N["applied"][1], 9.81e-6 * asked["mesh"].volume_mm3, rtol=1e-6)
        entry = next(e for e in again.entries if e["id"] == "meshes/liver")
        self.assertIn("labels/liver", entry["from"])

    def test_it_finds_vessels_by_their_shape(self):
        case = glisson.Case.create(self.root / "patient.glisson")
        liver = ball(56, 60.0, 2.5)
        image = image_of(liver)
        image.array[25:31, 26:30, :] += 90 * liver.array[25:31, 26:30, :]
        glisson.write_volume_file(self.root / "anatomy.nrrd", image)
        case.import_study(self.root / "anatomy.nrrd")
        self.assertRefused("structure-unknown", case.segment_vessels, "vessels")
        case.grow_structure("liver", [[-30, 0, 0]])
        found = case.segment_vessels("vessels")
        self.assertEqual(found["id"], "labels/vessels")
        self.assertIn("brighter", found["notes"][0])
        self.assertGreater(case.mask("vessels").array[25:31, 26:30, 10:-10].mean(), 0.7)
        self.assertRefused("vessels-seed-off", case.segment_vessels, "vessels", [[-30, 30, 0]])

    def test_its_page_says_who_only_if_told(self):
        case = glisson.Case.create(self.root / "mrs-smith.glisson")
        glisson.write_volume_file(self.root / "anatomy.nrrd", image_of(ball(56, 60.0, 2.5)))
        case.import_study(self.root / "anatomy.nrrd")
        case.grow_structure("liver", [[0, 0, 0]])
        for name in (None, "Mrs Smith"):
            glisson.write_patient_page(case, self.root / "page.html", name=name)
            page = (self.root / "page.html").read_text()
            self.assertEqual("Smith" in page, name is not None)
            self.assertNotIn("mrs-smith", page)
            self.assertIn("iver", page)

    def test_it_keeps_plans_by_its_segments(self):
        case = glisson.Case.create(self.root / "patient.glisson")
        glisson.write_volume_file(self.root / "anatomy.nrrd", image_of(ball(56, 60.0, 2.5)))
        case.import_study(self.root / "anatomy.nrrd")
        case.grow_structure("liver", [[0, 0, 0]])
        plane = {"plane": {"point_mm": [20, 0, 0], "normal": [1, 0, 0]}}
        kept = case.keep_plan("Left side", plane)
        self.assertEqual([(plan["id"], plan["name"]) for plan in case.plans], [(kept, "Left side")])
        again = case.planner().answer(case.plans[0]["cuts"])
        self.assertEqual(again["removed_ml"], case.plans[0]["answer"]["removed_ml"])
        self.assertRefused("plan-unknown", case.drop_plan, "right side")
        case.drop_plan("Left side")
        self.assertEqual(case.plans, [])
        self.assertRefused("vessels-missing", case.find_vessels)
        self.assertRefused("waves-none", case.invert_waves)
        self.assertRefused("step-unknown", case.redo, case.folder, 1)
        self.assertIn("import glisson", case.macro())
        self.assertIn("CASE=", case.macro("command-line"))
        self.assertRefused("choice-unknown", case.macro, "cobol")

    def patient_with_liver(self, name, liver):
        glisson.write_volume_file(self.root / f"{name}.nrrd", image_of(liver))
        case = glisson.Case.create(self.root / f"{name}.glisson")
        case.import_study(self.root / f"{name}.nrrd")
        case.grow_structure("liver", [[0, 0, 0]])
        return case

    def test_another_program_outlines_and_its_values_are_named(self):
        glisson.write_volume_file(self.root / "anatomy.nrrd", image_of(ball(40, 40.0, 2.5)))
        case = glisson.Case.create(self.root / "patient.glisson")
        case.import_study(self.root / "anatomy.nrrd")
        network = self.root / "network.py"  # whatever is bright is a 3
        network.write_text("import sys, glisson\nimage = glisson.read_volume_file(sys.argv[1])\n"
                           "glisson.write_volume_file(sys.argv[2], glisson.Volume(3.0 * (image.array > 130), "
                           "spacing_mm=image.spacing_mm, origin_mm=image.origin_mm, direction=image.direction))\n")
        command = f"{sys.executable} {network} {{image}} {{labels}}"
        outlined = case.outline_by_program(command, names={3: "liver"})
        self.assertEqual([one["name"] for one in outlined], ["liver"])
        self.assertGreater(glisson.dice(case.mask("liver"), ball(40, 40.0, 2.5)), 0.95)
        self.assertAlmostEqual(outlined[0]["volume_ml"], glisson.volume_ml(case.mask("liver")), delta=1e-6)
        before = case.entries
        self.assertRefused("command-no-image", case.outline_by_program, "network {folder}")
        self.assertRefused("program-not-found", case.outline_by_program, "no-such-network {image} {folder}")
        self.assertRefused("program-failed", case.outline_by_program, f"{sys.executable} {network} {{image}} {{folder}}/x/y")
        self.assertEqual(case.entries, before)

    def test_two_studies_are_compared_segment_by_segment(self):
        before = self.patient_with_liver("before", ball(56, 60.0, 2.5))
        after = self.patient_with_liver("after", ball(56, 66.0, 2.5))
        self.assertRefused("growth-segments-missing", glisson.compare_studies, before, after)
        for case in (before, after):
            case.find_territories(by="prior")
        before.keep_plan("Right side", {"segments": [5, 6, 7, 8]})
        grown = glisson.compare_studies(before, after, plan="Right side", days=28, folder=self.root / "growth")
        ml = [glisson.volume_ml(case.mask("liver")) for case in (before, after)]
        self.assertAlmostEqual(grown["liver"]["before_ml"], ml[0], delta=1e-6)
        self.assertAlmostEqual(grown["liver"]["change_percent"], 100 * (ml[1] / ml[0] - 1), delta=1e-6)
        self.assertAlmostEqual(sum(one["after_ml"] for one in grown["segments"]), ml[1], delta=1e-6)
        self.assertIn("kinetic_growth_rate_points_per_week", grown["remnant"])
        self.assertEqual(json.loads((self.root / "growth" / "growth.json").read_text()), grown)
        page = (self.root / "growth" / "growth.html").read_text()
        self.assertIn(f"{grown['liver']['change_percent']:+.1f}", page)
        self.assertIn("what the plan Right side leaves", page)
        self.assertRefused("growth-same-case", glisson.compare_studies, before, before)

    def test_it_is_rehearsed_as_the_window_does_and_to_the_bit(self):
        case = self.patient_with_liver("patient", ball(40, 40.0, 2.5))
        case.mesh_liver(target_cells=800)
        case.assign_stiffness(uniform_kPa=6.1)
        hold = {"hold": {"id": "jaws", "grasp": {"at_rest_mm": [0, -40, 0], "radius_mm": 12}, "displacement_mm": [0, -3, 0]}}
        for material in ("linear", "neo-hookean"):
            session = case.session(material=material)
            for command in (hold, {"settle": True}):
                self.assertEqual(session.step(command).refused, "")
            self.assertGreater(session.state.max_displacement_mm, 2)
            again = case.session(material=material)
            self.assertIsNone(again.replay(session.recording()))
            self.assertEqual(again.state.digest, session.state.digest)
        self.assertRefused("choice-unknown", case.session, material="rubber")

    def test_what_is_no_case_is_refused(self):
        with self.assertRaises(glisson.Error):
            glisson.Case(self.root / "nothing.glisson")
        case = glisson.Case.create(self.root / "empty.glisson")
        error = self.assertRefused("case-lacks-entry", case.volume, "volumes/anatomy")
        self.assertTrue(error.hint)
        self.assertRefused("case-lacks-entry", case.mesh)
        self.assertRefused("case-exists", glisson.Case.create, self.root / "empty.glisson")


if __name__ == "__main__":
    unittest.main()
