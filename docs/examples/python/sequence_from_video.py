"""A stereo video to a sequence that registrations can be judged on.   sequence_from_video.py LEFT RIGHT CAMERA.json OUT

LEFT and RIGHT are videos or folders of pictures. OUT is new, and then holds clouds, tracked landmarks and their alignment.
"""
import sys

import glisson

left, right, camera, out = sys.argv[1:5]
made = glisson.make_sequence(left, right, glisson.read_calibration(camera), out, step_px=8)
before_mm, _, aligned_mm = made["alignment_rms_mm"]
print(f"{made['landmarks']} landmarks agree within {aligned_mm:.1f} mm once all frames are aligned ({before_mm:.1f} before)")
