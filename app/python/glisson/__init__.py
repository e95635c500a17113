"""Glisson's core: images, meshes, mechanics and registration of livers, as values and functions over numpy arrays.

Lengths are mm, moduli and pressures kPa, forces N where a name says so. Positions are patient coordinates as DICOM has
them, LPS: x to the patient's left, y to the back, z to the head. What goes wrong raises glisson.Error, with a code.
"""
from . import exchange  # noqa: F401
from ._core import *  # noqa: F401,F403
from ._core import __version__  # noqa: F401
