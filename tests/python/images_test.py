"""Images share their memory with numpy, lie where they should in space, and outlive nothing that they need."""
import gc
import pathlib
import pickle
import tempfile
import unittest
import weakref

from support import Case, DATA, glisson, np


def counted():
    """Values that tell their own index: 100 i + 10 j + k."""
    i, j, k = np.meshgrid(np.arange(4), np.arange(3), np.arange(2), indexing="ij")
    return (100 * i + 10 * j + k).astype(np.float32)


class Memory(Case):
    def test_the_array_is_the_images_own_memory(self):
        volume = glisson.Volume(counted())
        first, second = volume.array, volume.array
        self.assertTrue(np.shares_memory(first, second))
        first[1, 2, 0] = -7
        self.assertEqual(second[1, 2, 0], -7)
        self.assertEqual(np.asarray(volume)[1, 2, 0], -7)
        self.assertTrue(np.shares_memory(np.asarray(volume), first))

    def test_index_order_is_i_j_k_with_i_fastest(self):
        array = glisson.Volume(counted()).array
        self.assertEqual(array.shape, (4, 3, 2))
        self.assertEqual(array.dtype, np.float32)
        self.assertTrue(array.flags.f_contiguous)
        self.assertEqual(array.strides, (4, 16, 48))
        self.assertEqual(array[3, 2, 1], 321)
        self.assertTrue(array.T.flags.c_contiguous)

    def test_whatever_the_order_and_type_that_comes_in(self):
        for given in (counted(), np.asfortranarray(counted()), counted().astype(np.int16), counted()[::1].astype(float)):
            np.testing.assert_array_equal(glisson.Volume(given).array, counted())
        np.testing.assert_array_equal(glisson.Volume(counted()[::-1]).array, counted()[::-1])

    def test_an_image_made_empty_is_filled_without_a_copy(self):
        volume = glisson.Volume.empty((4, 3, 2), spacing_mm=[1, 2, 3], unit="kPa")
        address = volume.array.__array_interface__["data"][0]
        np.copyto(volume.array, counted())
        self.assertEqual(volume.array.__array_interface__["data"][0], address)
        np.testing.assert_array_equal(volume.array, counted())

    def test_an_array_outlives_its_image(self):
        volume = glisson.Volume(counted())
        array = volume.array
        gone = weakref.ref(array)
        del volume
        gc.collect()
        crowd = [glisson.Volume.empty((64, 64, 64)) for _ in range(8)]  # would take freed memory
        for image in crowd:
            image.array[...] = 9
        np.testing.assert_array_equal(array, counted())
        del array
        gc.collect()
        self.assertIsNone(gone())

    def test_what_comes_in_is_copied_once_and_then_apart(self):
        given = counted()
        volume = glisson.Volume(given)
        given[...] = 0
        self.assertEqual(volume.array[3, 2, 1], 321)


class Space(Case):
    def test_spacing_origin_and_direction_place_voxels(self):
        turned = [[0, 1, 0], [1, 0, 0], [0, 0, -1]]  # columns: i runs to the back, j to the left, k to the feet
        volume = glisson.Volume(counted(), spacing_mm=[1, 2, 3], origin_mm=[10, 20, 30], direction=turned)
        np.testing.assert_allclose(volume.position_mm([3, 1, 2]), [10 + 2, 20 + 3, 30 - 6])
        np.testing.assert_allclose(volume.index_of([12, 23, 24]), [3, 1, 2])
        self.assertEqual(volume.voxel_volume_mm3, 6)

    def test_files_bring_back_values_and_place(self):
        volume = glisson.Volume(counted(), spacing_mm=[1, 2, 3], origin_mm=[10, -20, 30])
        with tempfile.TemporaryDirectory() as folder:
            for name in ("v.nrrd", "v.nii", "v.nii.gz", "v.mha"):
                file = pathlib.Path(folder) / name
                glisson.write_volume_file(file, volume)
                again = glisson.read_volume_file(file)
                np.testing.assert_array_equal(again.array, volume.array, err_msg=name)
                np.testing.assert_allclose(again.spacing_mm, volume.spacing_mm, atol=1e-6)
                np.testing.assert_allclose(again.origin_mm, volume.origin_mm, atol=1e-4)
                np.testing.assert_allclose(again.direction, volume.direction, atol=1e-6)

    def test_a_mask_keeps_name_label_and_colour_in_its_file(self):
        mask = glisson.Mask(counted() > 100)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "liver.nrrd"
            glisson.write_mask_file(file, mask, "liver", label_value=3, color_rgb=(0.25, 0.5, 1))
            again = glisson.read_mask_file(file)
        self.assertEqual((again.name, again.label_value), ("liver", 3))
        np.testing.assert_allclose(again.color_rgb, (0.25, 0.5, 1), atol=1e-2)
        np.testing.assert_array_equal(again.mask.array, mask.array)


class BadInput(Case):
    def test_errors_carry_code_message_arguments_and_file(self):
        error = self.assertRefused("volume-file-unreadable", glisson.read_volume_file, "/nowhere/liver.nrrd")
        self.assertIn("liver.nrrd", str(error))
        self.assertTrue(error.message)
        self.assertTrue(all(isinstance(argument, str) for argument in error.arguments))
        again = pickle.loads(pickle.dumps(error))  # as other processes hand it back
        self.assertEqual((again.code, again.arguments, str(again)), (error.code, error.arguments, str(error)))

    def test_arrays_that_are_no_image_are_refused(self):
        error = self.assertRefused("array-shape", glisson.Volume, np.zeros((4, 4)))
        self.assertEqual(error.arguments, ["4 x 4"])
        self.assertRefused("grid-size", glisson.Volume, np.zeros((4, 0, 4)))
        self.assertRefused("grid-size", glisson.Volume.empty, (1 << 20, 1 << 20, 1 << 20))
        self.assertRefused("grid-spacing", glisson.Volume, counted(), spacing_mm=[1, 0, 1])
        self.assertRefused("grid-origin", glisson.Volume, counted(), origin_mm=[1, np.nan, 1])
        self.assertRefused("grid-direction", glisson.Volume, counted(), direction=np.zeros((3, 3)))
        self.assertRefused("grid-direction", glisson.Volume, counted(), direction=np.ones((3, 3)) / np.sqrt(3))

    def test_masks_and_labels_hold_whole_numbers(self):
        self.assertEqual(glisson.Mask(counted() > 100).array.dtype, np.uint8)
        self.assertEqual(glisson.LabelMap(counted()).array.dtype, np.uint16)
        self.assertRefused("mask-values", glisson.Mask, counted())
        self.assertRefused("mask-values", glisson.Mask, np.full((2, 2, 2), 0.5))
        self.assertRefused("labels-values", glisson.LabelMap, -counted())
        self.assertRefused("labels-values", glisson.LabelMap, np.full((2, 2, 2), np.nan))

    def test_a_label_value_out_of_range_is_refused(self):
        self.assertRefused("label-value", glisson.write_mask_file, "m.nrrd", glisson.Mask(counted() > 1), "m", label_value=0)


class Dicom(Case):
    def test_a_study_is_scanned_and_its_series_read(self):
        folder = DATA / "mouse_abdomen_mr_dicom"
        if not folder.exists():
            self.skipTest(f"{folder} is not there")
        study = glisson.scan(folder)
        self.assertTrue(study.series)
        series = study.series[0]
        volume = glisson.read_series(series)
        self.assertEqual(volume.array.shape, tuple(series.size))
        self.assertGreater(volume.array.max(), volume.array.min())
        self.assertRefused("series-volume", glisson.read_series, series, series.volumes)

    def test_a_path_that_is_not_there_is_said(self):
        self.assertRefused("path-not-found", glisson.scan, "/nowhere/study")


if __name__ == "__main__":
    unittest.main()
