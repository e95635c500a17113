"""Equilibria against closed forms, rehearsals and sessions that repeat to the bit."""
import json
import unittest

from support import Case, ball, glisson, np

# A bar along z, 10 x 10 x 40 mm: cubes of six tetrahedra each.
SIX = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def bar(edge_mm=5.0, size=(2, 2, 8)):
    nx, ny, nz = (n + 1 for n in size)
    k, j, i = np.meshgrid(np.arange(nz), np.arange(ny), np.arange(nx), indexing="ij")
    points = edge_mm * np.stack([i.ravel(), j.ravel(), k.ravel()], axis=1)
    cells = []
    for z in range(nz - 1):
        for y in range(ny - 1):
            for x in range(nx - 1):
                corner = [x + (n & 1) + nx * (y + (n >> 1 & 1) + ny * (z + (n >> 2))) for n in range(8)]
                cells += [[corner[n] for n in tet] for tet in SIX]
    points_at_foot = (points[:, 2] == 0).astype(float)
    return glisson.TetMesh(points, cells, point_fields={"foot": points_at_foot})


def stretched(force_N=0.01, **more):
    """The foot slides in its plane; the top is pulled along z. E = 10 kPa."""
    return {"youngs_modulus_kPa": 10.0, "poisson_ratio": 0.3,
            "supports": [{"point_array": "foot", "directions": ["z"]},
                         {"sphere": {"center_mm": [0, 0, 0], "radius_mm": 0.1}},
                         {"sphere": {"center_mm": [10, 0, 0], "radius_mm": 0.1}, "directions": ["y", "z"]}],
            "loads": [{"tool": {"center_mm": [5, 5, 40], "radius_mm": 4.9, "force_N": np.array([0, 0, force_N])}}],
            "landmarks": [{"id": "top", "position_mm": [5, 5, 40]}], **more}


class Equilibrium(Case):
    def test_a_bar_under_tension_grows_by_stress_over_modulus(self):
        # 10 mN over 100 mm2 is 0.1 kPa; over 10 kPa a strain of 0.01, and 0.4 mm over 40 mm. Uniform: exact.
        found = glisson.simulate(bar(), stretched())
        self.assertAlmostEqual(found.landmarks[0]["displaced_mm"][2] - 40, 0.4, delta=1e-6)
        self.assertEqual(found.state, "within")
        self.assertLess(found.relative_residual, 1e-8)
        np.testing.assert_allclose(found.reactions_N["fixed"], [0, 0, -0.01], atol=1e-8)
        np.testing.assert_allclose(found.displacement_mm[:, 2], 0.01 * bar().points_mm[:, 2], atol=1e-6)

    def test_displacements_are_a_view_that_lives_on(self):
        found = glisson.simulate(bar(), stretched())
        moved = found.displacement_mm
        self.assertTrue(np.shares_memory(moved, found.displacement_mm))
        before = moved.copy()
        field = found.mesh.point_fields["displacement_mm"]
        del found
        np.testing.assert_array_equal(moved, before)
        np.testing.assert_allclose(field, before)

    def test_a_scenario_may_be_text(self):
        text = json.dumps(stretched(), default=lambda array: array.tolist())
        self.assertEqual(glisson.simulate(bar(), text).max_displacement_mm,
                         glisson.simulate(bar(), stretched()).max_displacement_mm)

    def test_bad_scenarios_are_refused(self):
        error = self.assertRefused("scenario-invalid", glisson.simulate, bar(), {"suports": []})
        self.assertIn("suports", str(error))
        self.assertRefused("document-invalid", glisson.simulate, bar(), {"youngs_modulus_kPa": float("nan")})
        self.assertRefused("document-invalid", glisson.simulate, bar(), {"youngs_modulus_kPa": object()})
        self.assertRefused("landmark-outside", glisson.simulate, bar(),
                           stretched() | {"landmarks": [{"id": "far", "position_mm": [500, 0, 0]}]})
        without = stretched()
        del without["youngs_modulus_kPa"]
        self.assertRefused("modulus-missing", glisson.simulate, bar(), without)


class Live(Case):
    def test_a_force_on_a_placed_tool_answers_as_an_equilibrium_does(self):
        scenario = stretched()
        del scenario["loads"]
        rehearsal = glisson.StaticRehearsal(bar(), scenario)
        tool = rehearsal.place_tool([5, 5, 40], 4.9)
        whole = glisson.simulate(bar(), stretched())
        np.testing.assert_allclose(tool.displacement_mm([0, 0, 0.01]), whole.displacement_mm, atol=1e-7)
        once, twice = tool.answer([0, 0, 0.01]), tool.answer([0, 0, 0.02])
        rest_mm = rehearsal.surface.points_mm
        np.testing.assert_allclose(twice.surface_mm - rest_mm, 2 * (once.surface_mm - rest_mm), atol=1e-7)
        self.assertAlmostEqual(once.landmarks[0]["displaced_mm"][2] - 40, 0.4, delta=1e-6)

    def test_bad_tools_are_refused(self):
        rehearsal = glisson.StaticRehearsal(bar(), stretched())
        self.assertRefused("tool-touches-nothing", rehearsal.place_tool, [500, 0, 0], 5)
        tool = rehearsal.place_tool([5, 5, 40], 4.9)
        self.assertRefused("array-not-finite", tool.answer, [0, 0, np.inf])
        self.assertRefused("array-shape", tool.answer, [0, 1])

    def test_a_session_is_replayed_to_the_bit(self):
        def pull(by_mm):
            return {"hold": {"id": "jaws", "grasp": {"at_rest_mm": [5, 5, 40], "radius_mm": 4},
                             "displacement_mm": [by_mm, 0, 0]}}

        scenario = stretched()
        del scenario["loads"]
        session = glisson.Session(bar(), scenario)
        for by_mm in (0.5, 1.0):
            state = session.step(pull(by_mm))
            self.assertEqual(state.refused, "")
        self.assertAlmostEqual(state.landmarks[0]["displaced_mm"][0] - 5, 1.0, delta=0.1)
        self.assertEqual(state.tools[0]["id"], "jaws")
        undone = session.step({"undo": True})
        self.assertLess(undone.max_displacement_mm, state.max_displacement_mm)

        recording = session.recording()
        self.assertEqual(len(recording["commands"]), 3)
        again = glisson.Session(bar(), scenario)
        self.assertIsNone(again.replay(recording))
        self.assertEqual(again.state.digest, undone.digest)
        np.testing.assert_array_equal(again.displacement_mm(), session.displacement_mm())
        recording["commands"][1]["digest"] = "0" * 64
        self.assertEqual(glisson.Session(bar(), scenario).replay(recording), 1)

    def test_bad_commands_are_refused(self):
        session = glisson.Session(bar(), stretched())
        self.assertRefused("session-invalid", session.step, {"hold": {"id": "jaws"}})
        self.assertRefused("session-invalid", session.step, {"jump": True})
        self.assertTrue(session.step({"release": "nobody"}).refused)


class Supports(Case):
    def test_a_liver_without_a_bare_area_is_refused(self):
        self.assertTrue(all("point_array" in support for support in glisson.usual_supports()))
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        self.assertRefused("liver-no-attachment", glisson.mark_attachments, glisson.TetMesh(points, [[0, 1, 2, 3]]))

    def test_a_ball_is_held_at_the_back_and_the_head(self):
        body = glisson.mark_attachments(glisson.mesh_labels(ball(), target_cells=1500).body)
        held = body.points_mm[body.point_fields["bare_area"] > 0]
        self.assertGreater(held[:, 1].min(), -5)
        self.assertGreater(held[:, 2].min(), -5)
        self.assertAlmostEqual(glisson.atlas_youngs_kPa(0.45), 2 * 2.1 * 1.45)


if __name__ == "__main__":
    unittest.main()
