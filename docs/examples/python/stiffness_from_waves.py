"""How stiff is tissue through which this wave runs?

Makes the phase images of a plane shear wave of 60 Hz in tissue of 3 kPa, wrapped as a scanner gives them, and inverts
them: the wavelength is sqrt(3 kPa / 1000 kg/m3) / 60 Hz = 28.9 mm.
"""
import numpy as np

import glisson

wavelength_mm = 1000 * np.sqrt(3e3 / 1000) / 60
x_mm = 2.0 * np.arange(48)
instants = np.arange(8)
moved = 2.0 * np.cos(2 * np.pi * (x_mm[None, :] / wavelength_mm - instants[:, None] / 8))  # rad
wrapped = (moved + np.pi) % (2 * np.pi) - np.pi
phase_rad = np.broadcast_to(wrapped[None, :, :, None, None], (1, 8, 48, 48, 12))

stiffness = glisson.invert(phase_rad, frequency_Hz=60, spacing_mm=[2, 2, 2], along=[[0, 0, 1]])
print(f"{stiffness['mean_kPa']:.2f} kPa over the {100 * stiffness['confident_fraction']:.0f} % of the voxels that are to "
      "be believed; the truth is 3 kPa.")
