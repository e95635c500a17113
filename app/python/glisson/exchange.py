"""Images and meshes of other packages, by their own types, to Glisson's and back. Each is imported when it is asked for.

    volume = glisson.exchange.from_nibabel(nibabel.load("liver.nii.gz"))
    meshio.write("liver.vtk", glisson.exchange.to_meshio(mesh))
    pyvista.wrap(glisson.exchange.to_vtk(mesh)).plot()

nibabel's affines speak RAS: the signs of x and y are turned. SimpleITK's images are LPS as Glisson's are; meshes and
all of VTK's (PyVista's classes are VTK's) are taken and given in LPS. What is shared and what is copied stands at each
function.
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


def from_simpleitk(image, kind=Volume):
    """A Volume, Mask or LabelMap of a SimpleITK.Image of three axes and one value a voxel; copied once."""
    import SimpleITK

    values = SimpleITK.GetArrayViewFromImage(image).T
    if image.GetDimension() != 3 or values.ndim != 3:
        shape = " x ".join(str(n) for n in values.shape)
        raise _refused("array-shape", f"An image has three axes; this one has {shape} voxels.", shape)
    return _filled(values, kind, spacing_mm=image.GetSpacing(), origin_mm=image.GetOrigin(),
                   direction=np.reshape(image.GetDirection(), (3, 3)))


def to_simpleitk(image):
    """A SimpleITK.Image of a Volume, Mask or LabelMap; copied once, as SimpleITK owns what it works on."""
    import SimpleITK

    made = SimpleITK.GetImageFromArray(image.array.T)
    made.SetSpacing([float(mm) for mm in image.spacing_mm])
    made.SetOrigin([float(mm) for mm in image.origin_mm])
    made.SetDirection([float(cosine) for cosine in np.ravel(image.direction)])
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
    numbers = np.cumsum([0] + [len(block.data) for block in mesh.cells])
    cells = {kind: [(np.asarray(block.data), np.arange(first, first + len(block.data)))
                    for block, first in zip(mesh.cells, numbers) if block.type == kind] for kind in ("tetra", "triangle")}
    return _shape_of(mesh.points, cells, mesh.point_data,
                     {name: np.concatenate(values) for name, values in mesh.cell_data.items()},
                     {block.type for block in mesh.cells})


def to_vtk(value):
    """A vtkImageData of an image, vtkPolyData of a Surface, vtkUnstructuredGrid of a TetMesh, with its fields; it shares the
    arrays. VTK cannot know that those of meshes are read only."""
    from vtkmodules import vtkCommonCore, vtkCommonDataModel
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    def field(name, values):
        made = numpy_to_vtk(values)
        made.SetName(name)
        return made

    if not isinstance(value, (TetMesh, Surface)):
        made = vtkCommonDataModel.vtkImageData()
        made.SetDimensions(value.array.shape)
        made.SetSpacing(value.spacing_mm)
        made.SetOrigin(value.origin_mm)
        made.SetDirectionMatrix(np.ravel(value.direction).tolist())
        made.GetPointData().SetScalars(field("values", value.array.ravel(order="F")))
        return made
    solid = isinstance(value, TetMesh)
    made = vtkCommonDataModel.vtkUnstructuredGrid() if solid else vtkCommonDataModel.vtkPolyData()
    points = vtkCommonCore.vtkPoints()
    points.SetData(numpy_to_vtk(value.points_mm))
    made.SetPoints(points)
    corners = value.cells if solid else value.triangles
    cells = vtkCommonDataModel.vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, corners.size + 1, corners.shape[1], dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.ravel(corners).astype(np.int64), deep=True))
    if solid:
        made.SetCells(vtkCommonDataModel.VTK_TETRA, cells)
    else:
        made.SetPolys(cells)
    for fields, into in ((value.point_fields, made.GetPointData()), (value.cell_fields, made.GetCellData())):
        for name, values in fields.items():
            into.AddArray(field(name, values))
    return made


def from_vtk(value, kind=Volume):
    """A Volume, Mask or LabelMap of a vtkImageData's scalars; of other data sets a TetMesh of the tetrahedra with its
    fields, or, without any, a Surface of the triangles. PyVista's classes are VTK's."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if value.IsA("vtkImageData"):
        scalars = value.GetPointData().GetScalars()
        if scalars is None or scalars.GetNumberOfComponents() != 1:
            raise _refused("array-shape", "This image has not one value a point.")
        matrix = value.GetDirectionMatrix()
        direction = np.array([[matrix.GetElement(row, column) for column in range(3)] for row in range(3)])
        spacing_mm, first = np.array(value.GetSpacing()), np.array(value.GetExtent())[::2]
        return _filled(vtk_to_numpy(scalars).reshape(value.GetDimensions(), order="F"), kind, spacing_mm=spacing_mm,
                       origin_mm=np.array(value.GetOrigin()) + direction @ (spacing_mm * first), direction=direction)
    types = np.array([value.GetCellType(n) for n in range(value.GetNumberOfCells())], int)
    solid = value.IsA("vtkUnstructuredGrid")
    lists = value.GetCells() if solid else value.GetPolys()
    first = 0 if solid else value.GetVerts().GetNumberOfCells() + value.GetLines().GetNumberOfCells()
    offsets, connectivity = (vtk_to_numpy(each) for each in (lists.GetOffsetsArray(), lists.GetConnectivityArray()))
    cells = {}
    for name, number, corners in (("tetra", 10, 4), ("triangle", 5, 3)):
        which = np.flatnonzero(types == number)
        starts = offsets[which - first]
        cells[name] = [(connectivity[starts[:, None] + np.arange(corners)], which)] if len(which) else []

    def fields(of):
        arrays = [of.GetArray(n) for n in range(of.GetNumberOfArrays())]
        return {each.GetName(): vtk_to_numpy(each) for each in arrays if each is not None and each.GetName()}

    points = value.GetPoints()
    return _shape_of(vtk_to_numpy(points.GetData()) if points is not None else np.empty((0, 3)), cells,
                     fields(value.GetPointData()), fields(value.GetCellData()), {f"VTK's {n}" for n in set(types.tolist())})


def _cells_of(shape):
    return ("tetra", shape.cells) if isinstance(shape, TetMesh) else ("triangle", shape.triangles)


def _shape_of(points_mm, cells, point_fields, cell_fields, kinds):
    """Of cells by kind, each a list of corners and of the numbers that they have in cell_fields."""
    for kind, made in (("tetra", TetMesh), ("triangle", Surface)):
        if not cells[kind]:
            continue
        corners, which = (np.concatenate(part) for part in zip(*cells[kind]))
        used = np.unique(corners)  # points of other cells are left out
        numbers = np.full(len(points_mm), -1)
        numbers[used] = np.arange(len(used))
        return made(np.asarray(points_mm, float)[used], numbers[corners],
                    point_fields={name: np.asarray(values)[used] for name, values in point_fields.items()},
                    cell_fields={name: np.asarray(values)[which] for name, values in cell_fields.items()})
    kinds = ", ".join(sorted(kinds)) or "none"
    raise _refused("mesh-cell-type", f"This mesh has no tetrahedra and no triangles; its cells are: {kinds}.", kinds)


__all__ = ["from_meshio", "from_nibabel", "from_simpleitk", "from_vtk", "to_meshio", "to_nibabel", "to_simpleitk", "to_vtk"]
