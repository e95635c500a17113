"""Images and meshes of other packages, by their own types, to Glisson's and back. Each is imported when it is asked for.

    volume = glisson.exchange.from_nibabel(nibabel.load("liver.nii.gz"))
    meshio.write("liver.vtk", glisson.exchange.to_meshio(mesh))

nibabel's affines speak RAS: the signs of x and y are turned. meshio's meshes are taken and given in LPS. What is shared
and what is copied stands at each function.
"""
import numpy as np

from ._core import Error, Surface, TetMesh, Volume

_RAS_TO_LPS = np.diag([-1.0, -1.0, 1.0, 1.0])


def _refused(code, message, *arguments):
    error = Error(message)
    error.code, error.message, error.hint = code, message, ""
    error.arguments, error.file = [str(each) for each in arguments], ""
    return error


def _filled(values, kind, **grid):
    """An image of that kind; a Volume is filled in place, in one pass."""
    if kind is not Volume:
        return kind(values, **grid)
    image = Volume.empty(values.shape, **grid)
    np.copyto(image.array, values, casting="unsafe")
    return image


def _three_axes(values):
    """The array with further axes of length one dropped."""
    while values.ndim > 3 and values.shape[-1] == 1:
        values = values[..., 0]
    if values.ndim != 3:
        shape = " x ".join(str(n) for n in values.shape)
        raise _refused("array-shape", f"An image has three axes; this one has {shape} voxels.", shape)
    return values


def _grid_of(affine):
    """Of a matrix (4 x 4) from indices to LPS."""
    steps = affine[:3, :3]
    spacing_mm = np.linalg.norm(steps, axis=0)
    if not (np.isfinite(affine).all() and (spacing_mm > 0).all()):
        raise _refused("grid-spacing", "The affine of this image places no voxels: it is not finite, or an axis has no length.")
    return {"spacing_mm": spacing_mm, "origin_mm": affine[:3, 3], "direction": steps / spacing_mm}


def from_nibabel(image, kind=Volume):
    """A Volume, Mask or LabelMap of a nibabel image; scaled values are copied once."""
    values = _three_axes(np.asanyarray(image.dataobj))
    return _filled(values, kind, **_grid_of(_RAS_TO_LPS @ image.affine))


def to_nibabel(image):
    """A nibabel.Nifti1Image that shares the memory of a Volume, Mask or LabelMap."""
    import nibabel

    affine = np.eye(4)
    affine[:3, :3] = image.direction * image.spacing_mm
    affine[:3, 3] = image.origin_mm
    made = nibabel.Nifti1Image(image.array, _RAS_TO_LPS @ affine)
    made.header.set_xyzt_units("mm")
    return made


def _cells_of(shape):
    return ("tetra", shape.cells) if isinstance(shape, TetMesh) else ("triangle", shape.triangles)


def to_meshio(shape):
    """A meshio.Mesh that shares the arrays of a TetMesh or Surface (read only), with its fields."""
    import meshio

    return meshio.Mesh(shape.points_mm, [_cells_of(shape)], point_data=shape.point_fields,
                       cell_data={name: [values] for name, values in shape.cell_fields.items()})


def from_meshio(mesh):
    """A TetMesh of the tetrahedra of a meshio.Mesh, with its fields; without any, a Surface of its triangles."""
    for kind, made in (("tetra", TetMesh), ("triangle", Surface)):
        blocks = [n for n, block in enumerate(mesh.cells) if block.type == kind]
        if not blocks:
            continue
        cells = np.concatenate([mesh.cells[n].data for n in blocks])
        cell_fields = {name: np.concatenate([each[n] for n in blocks]) for name, each in mesh.cell_data.items()}
        used = np.unique(cells)  # points of other cells are left out
        numbers = np.full(len(mesh.points), -1)
        numbers[used] = np.arange(len(used))
        return made(np.asarray(mesh.points, float)[used], numbers[cells],
                    point_fields={name: np.asarray(values)[used] for name, values in mesh.point_data.items()},
                    cell_fields=cell_fields)
    kinds = ", ".join(sorted({block.type for block in mesh.cells})) or "none"
    raise _refused("mesh-cell-type", f"This mesh has no tetrahedra and no triangles; its cells are: {kinds}.", kinds)


__all__ = ["from_meshio", "from_nibabel", "to_meshio", "to_nibabel"]
