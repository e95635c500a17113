"""Stereo video from Python: a camera found again from a board, clouds as the command line makes them, landmarks that
stay where nothing moves."""
import pathlib
import tempfile
import unittest

from support import Case, DATA, glisson, np

WIDTH, HEIGHT, FOCAL = 480, 360, 520.0
MATRIX = np.array([[FOCAL, 0, 239.5], [0, FOCAL, 179.5], [0, 0, 1]])


def board_seen_by(rotation, place_mm, eye_mm):
    """A chessboard of 8 x 6 fields of 6 mm, seen by a pinhole camera that stands at eye_mm: each pixel's own ray."""
    x, y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    picture = np.zeros((HEIGHT, WIDTH))
    for dx, dy in [(-0.25, -0.25), (0.25, -0.25), (-0.25, 0.25), (0.25, 0.25)]:  # four samples a pixel
        rays = np.stack([(x + dx - 239.5) / FOCAL, (y + dy - 179.5) / FOCAL, np.ones_like(x, float)], axis=-1)
        to_board = rotation.T
        origin = to_board @ (np.array(eye_mm, float) - place_mm)
        along = rays @ rotation
        hit = origin + along * (-origin[2] / along[..., 2])[..., None]
        column, row = np.floor(hit[..., 0] / 6), np.floor(hit[..., 1] / 6)
        on = (column >= 0) & (column < 8) & (row >= 0) & (row < 6)
        picture += np.where(on, np.where((column + row) % 2 == 0, 30, 220), 240) / 4
    return np.repeat(picture.astype(np.uint8)[..., None], 3, axis=2)


def turned(x, y):
    cx, sx, cy, sy = np.cos(x), np.sin(x), np.cos(y), np.sin(y)
    return np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]]) @ np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])


class Video(Case):
    def test_a_camera_is_found_again_from_a_board(self):
        views = [(0.3, 0.2), (-0.3, 0.25), (0.35, -0.3), (-0.2, -0.35), (0.05, 0.4), (0.4, 0.0)]
        left, right = [], []
        for n, (x, y) in enumerate(views):
            place = np.array([-24 + 2 * n, -18 - n, 70 + 4 * n], float)
            left.append(board_seen_by(turned(x, y), place, [0, 0, 0]))
            right.append(board_seen_by(turned(x, y), place, [5, 0, 0]))
        found = glisson.calibrate(left, right, board="chessboard", columns=7, rows=5, spacing_mm=6)
        self.assertEqual(found["pairs"], 6)
        self.assertLess(found["rms_px"], 0.3)
        camera = found["calibration"]
        np.testing.assert_allclose(np.diag(camera.left["matrix"])[:2], FOCAL, rtol=0.02)
        self.assertAlmostEqual(camera.baseline_mm, 5, delta=0.1)
        with tempfile.TemporaryDirectory() as folder:
            glisson.write_calibration(pathlib.Path(folder) / "camera.json", camera)
            again = glisson.read_calibration(pathlib.Path(folder) / "camera.json")
        np.testing.assert_allclose(again.left_to_right, camera.left_to_right, atol=1e-12)

    def test_a_heart_is_seen_and_what_rests_stays(self):
        folder = DATA / "hamlyn_heart_stereo"
        if not folder.exists():
            self.skipTest(f"{folder} is not there")
        camera = glisson.read_calibration(folder)
        left, right = (glisson.read_picture(folder / f"f7_dynamic_deint_{side}_0100.png") for side in "LR")
        cloud = glisson.stereo_cloud(left, right, camera, step_px=2)
        points = cloud["surface"].points_mm
        self.assertEqual(cloud["picture"].shape, left.shape)
        self.assertEqual(points.shape, (len(cloud["confidence"]), 3))
        self.assertGreater(len(points), 5000)
        self.assertTrue((points[:, 2] >= 30).all() and (points[:, 2] <= 300).all())
        tracks = glisson.track_landmarks([(left, right)] * 6, camera)
        self.assertGreater(len(tracks), 20)
        for track in tracks.values():
            self.assertEqual(track.shape, (6, 3))
            np.testing.assert_allclose(track, np.broadcast_to(track[0], (6, 3)), atol=1e-9)

    def test_what_is_no_picture_or_camera_is_refused(self):
        eye = {"matrix": MATRIX}
        camera = glisson.StereoCalibration(eye, eye, np.array([[1, 0, 0, -5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], float))
        self.assertAlmostEqual(camera.baseline_mm, 5)
        self.assertRefused("array-shape", glisson.stereo_cloud, np.zeros((4, 4), np.uint8), np.zeros((4, 4), np.uint8), camera)
        self.assertRefused("calibration-invalid", glisson.StereoCalibration, {}, eye, np.eye(4))
        self.assertRefused("calibration-no-baseline", glisson.StereoCalibration, eye, eye, np.eye(4))
        self.assertRefused("calibration-not-paired", glisson.calibrate, [], [np.zeros((4, 4, 3), np.uint8)],
                           board="chessboard", columns=7, rows=5, spacing_mm=6)
        self.assertRefused("choice-unknown", glisson.calibrate, [], [], board="stripes", columns=7, rows=5, spacing_mm=6)
        self.assertRefused("image-not-readable", glisson.read_picture, "/nowhere.png")


if __name__ == "__main__":
    unittest.main()
