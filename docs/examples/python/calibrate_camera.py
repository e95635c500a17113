"""A stereo laparoscope from pictures of a dotted board.   calibrate_camera.py COLUMNS ROWS SPACING_MM OUT.json FOLDER ...

Each FOLDER holds one pair, left_image.png and right_image.png. Prints the reprojection error of both eyes.
"""
import pathlib
import sys

import glisson

columns, rows, spacing_mm = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
pairs = [[glisson.read_picture(pathlib.Path(folder) / f"{side}_image.png") for folder in sys.argv[5:]]
         for side in ("left", "right")]
made = glisson.calibrate(*pairs, board="dots", columns=columns, rows=rows, spacing_mm=spacing_mm)
print(f"{made['pairs']} pairs, {made['points']} dots: off by {made['rms_px']:.2f} px; "
      f"the eyes are {made['calibration'].baseline_mm:.1f} mm apart")
glisson.write_calibration(sys.argv[4], made["calibration"])
