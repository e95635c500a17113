"""Made by packaging/dev/stubs from the package's own docstrings."""
import os
import pathlib
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, overload

import numpy
import numpy.typing

from . import exchange as exchange

__version__: str

class Error(Exception):
    """Something from outside that cannot be used, or an answer that was not found.

    code       stable, for programs: "volume-file-truncated"
    message    what is wrong and where: one English sentence
    hint       what to do; may be empty
    arguments  the values in the message, in order: a list of texts
    file       the file that it is about, or ""
    """
    code: str
    message: str
    hint: str
    arguments: List[str]
    file: str

class Case:
    """A case: the folder NAME.glisson with everything known of one patient, and where it came from.

    Case(folder) opens one. The folder is the state, a Case a view of it; each change is one transaction.

    Raises glisson.Error: what is wrong with the folder or its case.json."""
    def __init__(self, folder: str | os.PathLike[str]) -> None:
        ...

    def assign_stiffness(self, *, uniform_kPa: Optional[float] = ..., atlas_kPa: Optional[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> numpy.typing.NDArray[Any]:
        """Gives each cell its Young's modulus (kPa), from the case's stiffness map, one value, or the atlas's mean shear stiffness (2.1 or 2.6), saves the model and returns them: float64, (cells,).

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels."""

    @staticmethod
    def create(folder: str | os.PathLike[str]) -> Case:
        """A new case; the folder must not exist or be empty, and should end in ".glisson"."""

    def drop_plan(self, name: str) -> None:
        """Takes a plan out of the case.

        Raises glisson.Error: plan-unknown."""

    @property
    def entries(self) -> List[Any]:
        """What the case holds and how each was made: a list of dicts with id, file, sha256, by, options, from, notes, version, when_utc."""

    def file_of(self, id: str) -> pathlib.Path:
        """The full path of an entry's file.

        Raises glisson.Error: case-lacks-entry."""

    def find_liver(self, seeds_mm: numpy.typing.ArrayLike = ..., *, outside_mm: numpy.typing.ArrayLike = ..., shapes: str = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Finds the liver of the anatomy by brightness and shape together, from points inside it (n x 3, LPS, mm) or from none, and saves it. outside_mm: points in what was wrongly taken for it. shapes: the file of a shape model, or "simulated", nobody's.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: shapes-not-a-model, shapes-no-liver-found, shapes-outside, grow-seed-outside."""

    def find_territories(self, *, by: str = ..., borders: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Which tissue belongs to which branch, and Couinaud's segments, saved in the case: what couinaud_segments answers, with "portal-vein" and "hepatic-vein" (LabelMaps of the number of the branch + 1, or None). by: "tree", or "prior" for the liver's shape alone. borders: (border, place) each, for "prior"; trees have theirs from find_vessels.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: vessels-missing, choice-unknown."""

    def find_vessels(self, *, structure: Optional[str] = ..., portal_mm: Optional[numpy.typing.ArrayLike] = ..., hepatic_mm: Optional[numpy.typing.ArrayLike] = ..., clicks: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., borders: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> VesselTrees:
        """The VesselTrees of the case, saved in it: of the structures portal-vein and hepatic-vein, or of one that holds both; with trees of the arteries and bile ducts that it has outlined. portal_mm, hepatic_mm: a place (LPS, mm) on each main stem, where the first guess is wrong. clicks: (vessel, place) each, borders: (border, place) each, as for vessel_trees().

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: vessels-missing, labels-grids-differ."""

    @property
    def folder(self) -> pathlib.Path:
        """Where it lies."""

    def freshness(self, id: str) -> str:
        """"current", "stale" (what it was made from has changed), "changed-outside" or "missing"."""

    def grow_structure(self, name: str, seeds_mm: numpy.typing.ArrayLike, *, within: Optional[str] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Grows a structure from points inside it (n x 3, LPS, mm) on the anatomy and saves it. How follows from the name: vessels and lesions by contrast, organs as the liver.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels."""

    def guide(self, sequence: str | os.PathLike[str], *, pose: Optional[numpy.typing.ArrayLike] = ..., frame: int = ..., noise_mm: float = ..., sequence_sha256: str = ..., lines: Any = ..., folder: Optional[str | os.PathLike[str]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Any:
        """The patient's liver, its structures and landmarks on the frames of a laparoscope's sequence.json.

        pose      about where it lies in that frame, scan to camera, mm: (4, 4), or 16 numbers row by row; else searched for
        frame     which is answered first, from 0; the others follow from it
        noise_mm  standard deviation of each coordinate of the clouds
        sequence_sha256   of sequence.json, where another one is to be refused
        lines     marked on the model and on frames, as the workspace Guide keeps them (glisson-marked-lines/1)
        folder    where given, guidance.json, a mesh a frame and pictures with outlines are written there

        A dict, as guide() answers. Raises glisson.Error: pose-not-rigid, lines-invalid, guide-no-frame, guide-other-sequence, case-lacks-entry."""

    def import_study(self, path: str | os.PathLike[str], *, anatomy_uid: Optional[str] = ..., stiffness_uid: Optional[str] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Takes the series of a folder or file into the case: id -> notes of each volume.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: import-no-anatomy, import-ambiguous, import-unknown-uid, import-would-replace."""

    def invert_waves(self, *, method: str = ..., long_waves: str = ..., directional: bool = ..., frequency_Hz: Optional[float] = ..., directions: Optional[int] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Computes the shear stiffness from the case's waves; the maps take their places in it.

        method        "direct" or "lfe"; long_waves: "high-pass", "curl" or "keep"; directional: waves of each direction by
                      themselves
        frequency_Hz, directions   where the headers say nothing

        A dict: mean_kPa, confident_fraction, frequencies_Hz, notes.
        Raises glisson.Error: waves-none, choice-unknown."""

    def keep_plan(self, name: str, cuts: Any, *, progress: Optional[Callable[[float, str], Any]] = ...) -> str:
        """Answers a plan (cuts as Planner.answer takes them) and keeps it in the case: the id of its entry."""

    def macro(self, language: str = ...) -> str:
        """What was done to this case in the window, as a program that does it again: "python", or "command-line" for a shell."""

    def mask(self, structure: str = ...) -> Mask:
        """A structure's mask: "liver", "tumour-1", ..."""

    def mesh(self, id: str = ...) -> TetMesh:
        """The liver's tetrahedra; "meshes/model" has the cell field "youngs_modulus_kPa"."""

    def mesh_liver(self, *, target_cells: int = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> TetMesh:
        """Meshes the liver with the structures inside it, saves the mesh and the surfaces, and returns the TetMesh.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels."""

    @property
    def origin(self) -> str:
        """"SIMULATED ...", or empty for a real patient: to be shown beside anything of it."""

    def outline_by_program(self, command: str, *, names: Mapping[int, str] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> List[Any]:
        """Hands the anatomy to another program, as a segmentation network, and saves what it outlines.

        command  its words, as "TotalSegmentator -i {image} -o {folder}": {image} is the anatomy as .nii.gz (float; HU, or as
                 measured), {image_folder} the folder in which it lies alone, {folder} an empty one for what the program
                 writes, {labels} a file in it for a program that writes one. No shell reads them.
        names    value -> name, as {1: "liver"}, where its label maps and their files' names do not say

        A list of dicts: name, id, volume_ml, notes. Structures of the same names are replaced; where it fails the case stays
        as it was.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: command-no-image, command-no-labels, program-no-labels, program-not-found, program-failed, case-lacks-entry."""

    def planner(self, *, progress: Optional[Callable[[float, str], Any]] = ...) -> Planner:
        """A Planner for this patient: with its trees and territories where it has them."""

    @property
    def plans(self) -> List[Any]:
        """The resection plans that it keeps: a list of dicts with id, name, cuts, answer (as it was then), remarks."""

    def question(self, scenario: Any = ...) -> Dict[str, Any]:
        """What simulate(), StaticRehearsal or Session are asked of this patient: a dict.

        mesh              the TetMesh with the patient's own stiffness
        scenario          as given, with what the case brings where it says nothing: supports, landmarks, accepted evidence
        atlas_youngs_kPa  of the reference body that it is compared with
        remarks           what was assumed, left out, or is stale

        Raises glisson.Error: case-lacks-entry before there is a model; scenario-invalid."""

    def redo(self, recorded: str | os.PathLike[str], step: int) -> None:
        """Does a step again that was done by hand in the window, from the history of the case folder `recorded`. This case
        must be as that one was before the step; its files come out the same, byte for byte.

        Raises glisson.Error: step-unknown, step-does-not-fit, step-content-gone, step-changes-nothing."""

    def segment_vessels(self, name: str, seeds_mm: numpy.typing.ArrayLike = ..., *, within: str = ..., brightness: Optional[str] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
        """Finds the vessels of the anatomy inside of a structure by their shape and saves them. With points (n x 3, LPS, mm) only those that hang on one. brightness "bright" or "dark"; without it, what more of the tubes are.

        progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
        Raises glisson.Error: choice-unknown, structure-unknown, vessels-no-organ, vessels-none, vessels-seed-off."""

    def session(self, *, material: str = ..., engine: str = ..., step_s: Optional[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Session:
        """A Session of this patient as the window rehearses, so that its recordings replay to the bit.

        material  "linear" (small strain), "neo-hookean" or "corotational" (large)
        engine    "fem", or "meshfree": linear alone, with finite elements beside it (SessionState.beside_elements)
        step_s    in motion, by steps of so many seconds: linear, by "fem" and uncut; tissue that creeps does so

        The reference body, where there is one, comes with the command {"compare": True}.
        Raises glisson.Error: case-lacks-entry before there is a model; choice-unknown; not-available."""

    @property
    def structures(self) -> List[str]:
        """Names of its structures."""

    def surface(self, structure: str = ...) -> Surface:
        """A structure's smooth surface."""

    def volume(self, id: str = ...) -> Volume:
        """A measured quantity of the case: "volumes/anatomy", "volumes/stiffness" (kPa)."""

class Grown:
    """A structure grown from seeds."""

    @property
    def brightness(self) -> float:
        """Mean of the structure, in the image's unit."""

    @property
    def doubts(self) -> List[str]:
        """Why it may not be what was meant, and what to do: one sentence each."""

    @property
    def mask(self) -> Mask:
        """On the grid of the image."""

    @property
    def probably_leaked(self) -> bool:
        """Into a neighbour: not to be used unseen."""

    @property
    def volume_ml(self) -> float:
        """ml."""

class LabelMap:
    """Which of several structures each voxel belongs to; 0 is none.

    array       uint16, shape (i, j, k): the image's own memory, without a copy; writing to it changes the image, and it lives
                on when the image is gone. i runs along a row of pixels and is fastest in memory. array.T is [k, j, i], as
                SimpleITK has it.
    spacing_mm  (3,): between the centres of voxels along i, j, k, mm
    origin_mm   (3,): centre of voxel (0, 0, 0), patient coordinates LPS (x to the left, y to the back, z to the head), mm
    direction   (3, 3): its columns are the unit vectors of the axes i, j, k in LPS

    Made of an array, whose values are copied once into memory of the core; LabelMap.empty() makes an image to be filled in
    place. numpy.asarray(image) is image.array.

    Raises glisson.Error: array-shape, grid-size, grid-spacing, grid-origin, grid-direction, labels-values."""
    def __init__(self, array: numpy.typing.ArrayLike, *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ...) -> None:
        ...

    def __array__(self, dtype: Any = ...) -> Any:
        """The values as numpy wants them."""

    @property
    def array(self) -> numpy.typing.NDArray[Any]:
        """The values, shape (i, j, k), in the image's unit (kPa, HU, 0 or 1, ...), without a copy."""

    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3, 3): its columns are the unit vectors of the axes i, j, k in LPS."""

    @staticmethod
    def empty(size: Sequence[int], *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ...) -> LabelMap:
        """All zero, to be filled in place through its array; size is (i, j, k)."""

    def index_of(self, position_mm: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): the voxel index [i, j, k], fractional, at a position (3,), LPS, mm."""

    @property
    def origin_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): centre of voxel (0, 0, 0), LPS, mm."""

    def position_mm(self, index: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): where a voxel index (3,), which may be fractional, lies: LPS, mm."""

    @property
    def spacing_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): between voxels along i, j, k, mm."""

    @property
    def voxel_volume_mm3(self) -> float:
        """mm3."""

class LiverMesh:
    """What mesh_labels made."""

    @property
    def body(self) -> TetMesh:
        """The TetMesh; cell field "region": the label of each cell."""

    @property
    def hausdorff_mm(self) -> float:
        """The largest distance between the surface and the boundary of the labelled voxels, mm."""

    @property
    def mean_distance_mm(self) -> float:
        """mm."""

    @property
    def notes(self) -> List[str]:
        """What was cut, left out, filled, or got no cells of its own: one sentence each."""

    @property
    def regions(self) -> List[Any]:
        """A dict a label: label, label_volume_ml, mesh_volume_ml."""

    @property
    def surface(self) -> Surface:
        """Its boundary, a Surface: watertight, manifold."""

class Mask:
    """Which voxels belong to something: 0 or 1.

    array       uint8, shape (i, j, k): the image's own memory, without a copy; writing to it changes the image, and it lives
                on when the image is gone. i runs along a row of pixels and is fastest in memory. array.T is [k, j, i], as
                SimpleITK has it.
    spacing_mm  (3,): between the centres of voxels along i, j, k, mm
    origin_mm   (3,): centre of voxel (0, 0, 0), patient coordinates LPS (x to the left, y to the back, z to the head), mm
    direction   (3, 3): its columns are the unit vectors of the axes i, j, k in LPS

    Made of an array, whose values are copied once into memory of the core; Mask.empty() makes an image to be filled in
    place. numpy.asarray(image) is image.array.

    Raises glisson.Error: array-shape, grid-size, grid-spacing, grid-origin, grid-direction, mask-values."""
    def __init__(self, array: numpy.typing.ArrayLike, *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ...) -> None:
        ...

    def __array__(self, dtype: Any = ...) -> Any:
        """The values as numpy wants them."""

    @property
    def array(self) -> numpy.typing.NDArray[Any]:
        """The values, shape (i, j, k), in the image's unit (kPa, HU, 0 or 1, ...), without a copy."""

    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3, 3): its columns are the unit vectors of the axes i, j, k in LPS."""

    @staticmethod
    def empty(size: Sequence[int], *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ...) -> Mask:
        """All zero, to be filled in place through its array; size is (i, j, k)."""

    def index_of(self, position_mm: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): the voxel index [i, j, k], fractional, at a position (3,), LPS, mm."""

    @property
    def origin_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): centre of voxel (0, 0, 0), LPS, mm."""

    def position_mm(self, index: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): where a voxel index (3,), which may be fractional, lies: LPS, mm."""

    @property
    def spacing_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): between voxels along i, j, k, mm."""

    @property
    def voxel_volume_mm3(self) -> float:
        """mm3."""

class PlacedTool:
    """A tool on the surface; only its force is free."""

    def answer(self, force_N: numpy.typing.ArrayLike) -> RehearsalState:
        """The body under that force (3,), N, LPS: well under a millisecond."""

    @property
    def center_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,), LPS, mm."""

    def displacement_mm(self, force_N: numpy.typing.ArrayLike) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): of every point of the mesh, mm."""

    @property
    def radius_mm(self) -> float:
        """Of the disc that it touches, mm."""

    @property
    def touched_faces(self) -> int:
        """Faces of the surface under it."""

class Planner:
    """What a plan takes out of one liver and what it leaves; Case.planner() makes one of a patient.

    liver           a Mask; tumours: name -> Mask
    segments        LabelMap of Couinaud's segments, 1 to 8
    trees           VesselTrees, with portal and hepatic: LabelMaps of the number of the branch + 1
    youngs_kPa      Volume, positive where it is to be trusted

    Each may be left out but the liver, and lie on a grid of its own.
    Raises glisson.Error: liver-empty, plan-too-many-tumours."""
    def __init__(self, liver: Mask, *, tumours: Mapping[str, Mask] = ..., segments: Optional[LabelMap] = ..., trees: Optional[VesselTrees] = ..., portal: Optional[LabelMap] = ..., hepatic: Optional[LabelMap] = ..., youngs_kPa: Optional[Volume] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> None:
        ...

    def answer(self, cuts: Any) -> Any:
        """What is taken and what is left: a dict as the command line's `plan --json` has it (removed_ml, remnant_ml,
        remnant_percent, perfused_ml, drained_ml, living_ml, margin_mm, tumours, segments, branches, ...).

        cuts  a dict, or a list of them, whose union is taken out: {"plane": {"point_mm", "normal", "removed"}}, {"sheet":
              {"through_mm"}}, {"segments": [6, 7]}, {"territory": "portal/right"}, {"around": "tumour-1", "margin_mm": 10},
              {"ablation": {"center_mm", "direction", "radius_along_mm", "radius_across_mm"}}

        Raises glisson.Error: plan-invalid, plan-empty, cut-invalid, cut-misses, segment-unknown, segments-missing,
        branch-unknown, territory-empty, tumour-unknown, margin-invalid, ablation-invalid, nothing-left."""

    def parts(self, cuts: Any) -> Mask:
        """A Mask's voxels on the part of the grid around the liver: 1 stays, 2 goes."""

    @property
    def trees(self) -> VesselTrees:
        """The VesselTrees that it counts by."""

    @property
    def tumours(self) -> List[str]:
        """Names of the tumours."""

    def unrolled(self, cuts: Any, *, step_mm: float = ...) -> List[Any]:
        """Each plane and sheet among the cuts, unrolled: a dict with step_mm, margin_mm (rows, columns; to the nearest tumour, NaN beside the liver) and vessels (name, column, row, radius_mm)."""

class RehearsalState:
    """The body under a force on a placed tool."""

    @property
    def answer_ms(self) -> float:
        """What the answer took, ms."""

    @property
    def force_N(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,), N."""

    @property
    def landmarks(self) -> List[Any]:
        """A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm."""

    @property
    def max_difference_mm(self) -> float:
        """Between patient and atlas over the surface, mm; 0 without an atlas."""

    @property
    def max_displacement_mm(self) -> float:
        """Over the surface, mm."""

    @property
    def relative_residual(self) -> float:
        """The larger of the solves that it is made from: a ratio."""

    @property
    def state(self) -> str:
        """As Simulation.state."""

    @property
    def surface_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): the displaced points of the rehearsal's surface, LPS, mm. Without a copy."""

class SegmentedMask:
    """A mask with its name, label and colour, as 3D Slicer and DICOM SEG have it."""

    @property
    def color_rgb(self) -> List[float]:
        """sRGB, each 0..1."""

    @property
    def label_value(self) -> int:
        """In the file, 1..255."""

    @property
    def mask(self) -> Mask:
        """Which voxels belong to it: a copy."""

    @property
    def name(self) -> str:
        """"liver"."""

class Series:
    """A stack of parallel slices, taken once or several times; scan() finds them."""

    @property
    def description(self) -> str:
        """As the scanner called it."""

    @property
    def files(self) -> List[pathlib.Path]:
        """Volume after volume, by position along the normal in each."""

    @property
    def modality(self) -> str:
        """"MR", "CT", ..."""

    @property
    def problems(self) -> List[str]:
        """One sentence each."""

    @property
    def role(self) -> str:
        """What it is for: "anatomy", "mre-stiffness", ..., "other"."""

    @property
    def role_evidence(self) -> str:
        """The header fields that decided."""

    @property
    def size(self) -> List[int]:
        """(i, j, k) of one volume."""

    @property
    def spacing_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): between voxels along i, j, k, mm."""

    @property
    def uid(self) -> str:
        """SeriesInstanceUID; a path for a volume file."""

    @property
    def unit(self) -> str:
        """Of the voxels once read."""

    @property
    def volumes(self) -> int:
        """How many complete volumes there are."""

class Session:
    """A rehearsal with tools in contact, command by command, recorded.

    Made of a TetMesh and a scenario as StaticRehearsal is. The same commands give the same states, to the bit."""
    def __init__(self, mesh: TetMesh, scenario: Any, *, atlas_youngs_kPa: Optional[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> None:
        ...

    def displacement_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): of every point of the mesh in the present state, mm, by a solve of its own."""

    def recording(self) -> Any:
        """What was carried out with each state's digest, as files of sessions have it."""

    def replay(self, recording: Any, *, progress: Optional[Callable[[float, str], Any]] = ...) -> Optional[int]:
        """Carries all commands of a recording out (a dict, or its JSON text). The first, from 0, whose state is not the one recorded; None where all are.

        Raises glisson.Error: session-invalid."""

    @property
    def state(self) -> SessionState:
        """The present one."""

    def step(self, command: Any) -> SessionState:
        """Carries a command out and returns the SessionState: a dict as files of sessions have it.

        {"hold": {"id": "probe", "shape": "palpation-probe", "position_mm": [...], "direction": [...], "push_mN": 500}}
        {"hold": {"id": "jaws", "grasp": {"at_rest_mm": [...], "radius_mm": 5}, "displacement_mm": [...]}}
        {"release": "probe"}, {"undo": True}, {"settle": True}

        Raises glisson.Error: session-invalid, document-invalid. What cannot be carried out is said in `refused`."""

    @property
    def surface(self) -> Surface:
        """The outer surface at rest: a copy."""

class SessionState:
    """A session after a command."""

    @property
    def beside_elements(self) -> Any:
        """Of the meshfree engine: how far finite elements are apart at most, and what both took; None otherwise."""

    @property
    def digest(self) -> str:
        """SHA-256 of every displacement and force: equal for equal bits."""

    @property
    def landmarks(self) -> List[Any]:
        """A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm."""

    @property
    def max_displacement_mm(self) -> float:
        """Over the surface, mm."""

    @property
    def number(self) -> int:
        """Of the commands that led here."""

    @property
    def refused(self) -> str:
        """Why the last command was not carried out; empty where it was."""

    @property
    def settled(self) -> bool:
        """At rest, which at large strain takes time."""

    @property
    def state(self) -> str:
        """As Simulation.state; "not-converged" too."""

    @property
    def step_ms(self) -> float:
        """What the command took, ms."""

    @property
    def surface_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): displaced points of the session's surface, LPS, mm. Without a copy."""

    @property
    def tools(self) -> List[Any]:
        """A dict each: id, force_N (on the body), contacts, advance_mm, penetration_mm."""

class Simulation:
    """What simulate() found: an equilibrium, or a motion's end."""

    @property
    def displacement_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): of each point of the mesh, LPS, mm. Without a copy, read only."""

    @property
    def landmarks(self) -> List[Any]:
        """A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm."""

    @property
    def largest_strain(self) -> float:
        """Largest principal strain in magnitude: a ratio."""

    @property
    def max_displacement_mm(self) -> float:
        """mm."""

    @property
    def mesh(self) -> TetMesh:
        """The rest mesh with point field "displacement_mm" and cell fields "youngs_modulus_kPa" and "von_mises_kPa"."""

    @property
    def notes(self) -> List[str]:
        """What a person should know before trusting the numbers."""

    @property
    def reactions_N(self) -> Dict[str, Any]:
        """Sums, N: "applied" by the loads; by "fixed" points, "foundations", "ligaments"."""

    @property
    def relative_residual(self) -> float:
        """|K u - f| / |f| over what is free to move: a ratio."""

    @property
    def sentence(self) -> str:
        """The same, for a person."""

    @property
    def state(self) -> str:
        """"within" what the model is made for, "outside-of-the-model" (strained beyond it), or "unusable" (cells turned inside out)."""

    @property
    def steps(self) -> List[Any]:
        """Of a motion, a dict a step: time_s, landmarks_mm (landmarks, 3), largest_strain."""

    @property
    def strain_energy_uJ(self) -> float:
        """uJ."""

class StaticRehearsal:
    """A liver ready for a tool: its stiffness is factorised once.

    Made of a TetMesh and a scenario (supports, moduli, landmarks; its loads stand), as simulate() takes it. With
    atlas_youngs_kPa a reference body of that one modulus is computed beside it.

    Raises glisson.Error: as simulate, landmark-outside; place_tool: tool-touches-nothing, not-converged."""
    def __init__(self, mesh: TetMesh, scenario: Any, *, atlas_youngs_kPa: Optional[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> None:
        ...

    def place_tool(self, center_mm: numpy.typing.ArrayLike, radius_mm: float) -> PlacedTool:
        """A PlacedTool on the disc of surface around that place (LPS, mm)."""

    @property
    def surface(self) -> Surface:
        """The outer surface at rest: a copy."""

class StereoCalibration:
    """A stereo camera: what each lens does, and where the right eye is.

    left, right     dicts: matrix (3 x 3, pixels), distortion (k1, k2, p1, p2, k3, ..., as OpenCV numbers them)
    left_to_right   4 x 4: takes a point in left-camera mm to right-camera mm

    Raises glisson.Error: calibration-invalid, calibration-not-rotation, calibration-no-baseline."""
    def __init__(self, left: Mapping[str, Any], right: Mapping[str, Any], left_to_right: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def baseline_mm(self) -> float:
        """Between the eyes, mm."""

    @property
    def left(self) -> Dict[str, Any]:
        """Lens of the left eye: a dict."""

    @property
    def left_to_right(self) -> numpy.typing.NDArray[numpy.float64]:
        """4 x 4, mm."""

    @property
    def notes(self) -> List[str]:
        """What was put right, and why."""

    @property
    def right(self) -> Dict[str, Any]:
        """Lens of the right eye: a dict."""

class Study:
    """What scan() found."""

    @property
    def series(self) -> List[Series]:
        """By series number."""

    @property
    def skipped(self) -> List[Tuple[str, str]]:
        """Files that could not be used: (path, reason)."""

class Surface:
    """A triangle surface in patient coordinates (LPS, mm), with quantities on its points and triangles.

    Made of points_mm (points, 3) and triangles (triangles, 3), whole numbers from 0, counter-clockwise seen from outside.
    It never changes once it is made: its arrays are read only, share its memory, and live on when it is gone.

    Raises glisson.Error: array-shape, array-not-whole, and what check_surface of the core refuses."""
    def __init__(self, points_mm: numpy.typing.ArrayLike, triangles: numpy.typing.ArrayLike, *, point_fields: Mapping[str, Any] = ..., cell_fields: Mapping[str, Any] = ...) -> None:
        ...

    @property
    def area_mm2(self) -> float:
        """mm2."""

    @property
    def cell_fields(self) -> Dict[str, Any]:
        """The same, one item a cell."""

    @property
    def is_watertight(self) -> bool:
        """Every edge is shared by exactly two triangles that run along it in opposite directions."""

    @property
    def point_fields(self) -> Dict[str, Any]:
        """Quantities on the points by name: float64, (points,) or (points, components). Without a copy, read only."""

    @property
    def points_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): patient coordinates LPS, mm. Without a copy, read only."""

    @property
    def triangles(self) -> numpy.typing.NDArray[Any]:
        """int32, shape (triangles, 3). Without a copy, read only."""

    @property
    def volume_mm3(self) -> float:
        """Enclosed, mm3; meaningful only when watertight, negative for a surface turned inside out."""

class SurfaceMatch:
    """Point source_points[i] of the source belongs to target_points[i]."""

    def densify(self) -> numpy.typing.NDArray[Any]:
        """int32, (points of the source,): a target point for each of them."""

    @property
    def orientation_kept(self) -> float:
        """Share of neighbours that turn the same way: 1 for a good match, 0 for a mirrored one."""

    @property
    def solution(self) -> Dict[str, Any]:
        """As trwls() answers."""

    @property
    def source_points(self) -> numpy.typing.NDArray[Any]:
        """int32, (matches,)."""

    @property
    def target_distances_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """float64, (samples, points of the target): along the surface; a copy."""

    @property
    def target_points(self) -> numpy.typing.NDArray[Any]:
        """int32, (matches,)."""

    @property
    def target_samples(self) -> numpy.typing.NDArray[Any]:
        """int32, (samples,): the target's points among which it chose."""

class TetMesh:
    """A body of tetrahedra in patient coordinates (LPS, mm), with quantities on its points and cells.

    Made of points_mm (points, 3) and cells (cells, 4), whole numbers from 0; each cell has a positive volume:
    (p1 - p0) x (p2 - p0) . (p3 - p0) > 0. It never changes once it is made: its arrays are read only, share its memory,
    and live on when it is gone.

    Raises glisson.Error: array-shape, array-not-whole, and what makes a body useless (an index out of range, a flat or
    turned cell, a point that is not finite)."""
    def __init__(self, points_mm: numpy.typing.ArrayLike, cells: numpy.typing.ArrayLike, *, point_fields: Mapping[str, Any] = ..., cell_fields: Mapping[str, Any] = ...) -> None:
        ...

    @property
    def cell_fields(self) -> Dict[str, Any]:
        """The same, one item a cell."""

    @property
    def cells(self) -> numpy.typing.NDArray[Any]:
        """int32, shape (cells, 4): points of each tetrahedron. Without a copy, read only."""

    @property
    def point_fields(self) -> Dict[str, Any]:
        """Quantities on the points by name: float64, (points,) or (points, components). Without a copy, read only."""

    @property
    def points_mm(self) -> numpy.typing.NDArray[Any]:
        """float64, shape (points, 3): patient coordinates LPS, mm. Without a copy, read only."""

    def quality(self) -> Dict[str, Any]:
        """Dihedral angles (degrees) and aspect (longest edge over shortest height, 1 for the regular tetrahedron)."""

    @property
    def volume_mm3(self) -> float:
        """mm3."""

    def with_fields(self, *, point_fields: Mapping[str, Any] = ..., cell_fields: Mapping[str, Any] = ...) -> TetMesh:
        """A copy with these fields, in place of those of the same name."""

class VesselTrees:
    """Portal and hepatic veins, arteries and bile ducts, each as a tree; vessel_trees() and Case.find_vessels() make one."""

    @property
    def border_doubts(self) -> List[Any]:
        """(vessel, ml) each, the largest first: how much is in doubt along the border where that vessel runs."""

    @property
    def branches(self) -> List[Any]:
        """Parents first, a dict each: name ("portal/right/posterior/VI/2"), system ("portal-vein", "hepatic-vein", "artery",
        "biliary-tract"), parent (an earlier branch, or -1), generation, confidence of the system (0.5 to 1), length_mm,
        radius_mm (median), points_mm (n, 3) and radii_mm (n,), outwards."""

    @property
    def hepatic_entry_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): where the hepatic veins meet the vena cava, LPS, mm."""

    @property
    def portal_entry_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): where the portal vein divides, LPS, mm."""

class Volume:
    """A measured quantity on a grid in space.

    array       float32, shape (i, j, k): the image's own memory, without a copy; writing to it changes the image, and it lives
                on when the image is gone. i runs along a row of pixels and is fastest in memory. array.T is [k, j, i], as
                SimpleITK has it.
    spacing_mm  (3,): between the centres of voxels along i, j, k, mm
    origin_mm   (3,): centre of voxel (0, 0, 0), patient coordinates LPS (x to the left, y to the back, z to the head), mm
    direction   (3, 3): its columns are the unit vectors of the axes i, j, k in LPS

    Made of an array, whose values are copied once into memory of the core; Volume.empty() makes an image to be filled in
    place. numpy.asarray(image) is image.array.

    Raises glisson.Error: array-shape, grid-size, grid-spacing, grid-origin, grid-direction."""
    def __init__(self, array: numpy.typing.ArrayLike, *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ..., unit: str = ...) -> None:
        ...

    def __array__(self, dtype: Any = ...) -> Any:
        """The values as numpy wants them."""

    @property
    def array(self) -> numpy.typing.NDArray[Any]:
        """The values, shape (i, j, k), in the image's unit (kPa, HU, 0 or 1, ...), without a copy."""

    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3, 3): its columns are the unit vectors of the axes i, j, k in LPS."""

    @staticmethod
    def empty(size: Sequence[int], *, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ..., unit: str = ...) -> Volume:
        """All zero, to be filled in place through its array; size is (i, j, k)."""

    def index_of(self, position_mm: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): the voxel index [i, j, k], fractional, at a position (3,), LPS, mm."""

    @property
    def origin_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): centre of voxel (0, 0, 0), LPS, mm."""

    def position_mm(self, index: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): where a voxel index (3,), which may be fractional, lies: LPS, mm."""

    @property
    def spacing_mm(self) -> numpy.typing.NDArray[numpy.float64]:
        """(3,): between voxels along i, j, k, mm."""

    @property
    def unit(self) -> str:
        """"HU", "kPa", "Pa", "rad", "um", or empty for arbitrary units."""
    @unit.setter
    def unit(self, value: str) -> None: ...

    @property
    def voxel_volume_mm3(self) -> float:
        """mm3."""

def align_points(from_mm: numpy.typing.ArrayLike, to_mm: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """The rotation and translation (4 x 4) that bring points (n x 3, mm) nearest to others, pair by pair (Kabsch).

    Raises glisson.Error: alignment-too-few-points, alignment-sizes."""

def atlas_youngs_kPa(poisson_ratio: float = ...) -> float:
    """Young's modulus (kPa) of healthy adults' livers: a mean shear modulus of 2.1 kPa."""

def boundary_surface(mesh: TetMesh) -> Surface:
    """The outer surface of a TetMesh, counter-clockwise from outside. Its point field "mesh_point" says which point of the mesh each one is, its cell field "mesh_cell" which tetrahedron lies behind each triangle."""

def calibrate(left: Sequence[numpy.typing.ArrayLike], right: Sequence[numpy.typing.ArrayLike], *, board: str, columns: int, rows: int, spacing_mm: float) -> Dict[str, Any]:
    """A StereoCalibration from pictures of a board that both eyes took at once.

    left, right     lists of pictures: uint8, (height, width, 3)
    board           "chessboard" (columns x rows inner corners), "circles", or "dots" (circles, four of them larger)

    A dict: calibration, rms_px (reprojection, both eyes together), pair_rms_px, pairs, points, left_rms_px, right_rms_px,
    notes. Raises glisson.Error: board-invalid, calibration-too-few-views, stereo-image-sizes, calibration-failed."""

def cell_centroids_mm(mesh: TetMesh) -> numpy.typing.NDArray[Any]:
    """float64, shape (cells, 3): LPS, mm."""

def cell_stiffness(mesh: TetMesh, shear_kPa: Volume, *, confident: Optional[Mask] = ..., organ: Optional[Mask] = ..., poisson_ratio: float = ..., unreliable_border_mm: float = ...) -> Dict[str, Any]:
    """Young's modulus of each cell of a TetMesh from a map of the shear modulus (a Volume, kPa), E = 2 G (1 + nu).

    Each cell takes the voxel nearest to its centroid; cells without a reliable voxel are filled from around. Not reliable
    is what is not positive, not in the mask `confident`, outside of the mask `organ` or within unreliable_border_mm of its
    border.
    A dict: youngs_kPa (float64, (cells,)), measured (bool, (cells,)), mean_kPa, sd_kPa, min_kPa, max_kPa,
    cells_without_data, filled_fraction.

    Raises glisson.Error: stiffness-no-cells, stiffness-empty-map, stiffness-bad-grid, stiffness-bad-options,
    stiffness-no-overlap, stiffness-nothing-reliable."""

def compare_studies(before: Case, after: Case, *, plan: Optional[str] = ..., days: Optional[float] = ..., standard_liver_ml: Optional[float] = ..., same_patient: bool = ..., folder: Optional[str | os.PathLike[str]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Any:
    """What grew between two studies of one patient, as before and after an embolisation: two Cases with segments.

    plan               whose remnant is followed: each case's own of that name
    days               between the studies, where their images have no dates
    standard_liver_ml  of which the per cent are in both; None: of each study's own liver
    same_patient       the images name two patients, and they are of one all the same
    folder             where given, growth.json, growth.csv and growth.html are written there

    A dict as growth.json ("glisson-growth/1"): liver, segments, remnant (before_ml, after_ml, change_percent, ...), days,
    sentences. Neither case is changed.
    Raises glisson.Error: growth-same-case, growth-not-one-patient, growth-order, growth-days, growth-days-differ,
    growth-segments-missing, growth-segments-stale, growth-standard-volume, growth-plan-in-one-study, plan-unknown."""

def couinaud_segments(liver: Mask, trees: Optional[VesselTrees] = ..., *, borders: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """Couinaud's eight segments of a liver, from its VesselTrees or, without, from its shape alone.
    borders: ("V-VIII", place in LPS, mm) each, through which the border of those two segments runs, besides those that the
    trees were told.

    A dict: segment (LabelMap: 1 to 8, 0 outside), doubt (uint8, [i, j, k]: percent), volume_ml and confidence (9 numbers: of
    all, then of segments 1 to 8), from ("tree" or "prior").
    Raises glisson.Error: liver-empty, vessels-outside, border-outside, borders-contradict, choice-unknown, and what a liver's shape refuses."""

def dice(a: Mask, b: Mask) -> float:
    """Dice's overlap of two masks: 1 the same, 0 apart.

    Raises glisson.Error: masks-grids-differ."""

def draw_case(case: Case, scene: str, *, width: int = ..., height: int = ...) -> numpy.typing.NDArray[Any]:
    """A scene of a Case, drawn with no window: uint8, shape (height, width, 3), rows from the top.

    scene  "anatomy", "liver", "stiffness", "model"; "waves" and "confidence" where waves were inverted; "resection"

    Raises glisson.Error: scene-unknown, case-lacks-entry, picture-size, drawing-unavailable."""

def draw_result(folder: str | os.PathLike[str], *, width: int = ..., height: int = ...) -> numpy.typing.NDArray[Any]:
    """The moved liver of a result's folder, coloured by displacement: uint8, shape (height, width, 3), as draw_case.

    Raises glisson.Error: picture-size, drawing-unavailable, and what is wrong with the folder."""

def draw_surface(surface: Surface, *, field: Optional[str] = ..., range: Sequence[float] = ..., title: str = ..., colour_map: str = ..., color_rgb: Sequence[float] = ..., width: int = ..., height: int = ...) -> numpy.typing.NDArray[Any]:
    """A Surface from the surgeon's side, drawn with no window: uint8, shape (height, width, 3), rows from the top.

    field  a point or cell field to colour it by, over `range`, with `title` (and the unit) for the legend

    Raises glisson.Error: scene-invalid, picture-size, drawing-unavailable, colour-map-unknown."""

def explain(experiment: str | os.PathLike[str], *, progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """What the declared model of an experiment (a JSON file) lacks.

    A dict: report (verdict, errors before and after, effects with their parameters and evidence, as report.json has it)
    and model (the better model, as model.json has it; written to a file, predict() takes it up).

    progress is told (fraction, stage); KeyboardInterrupt cancels.
    Raises glisson.Error: what is wrong with the experiment, or "cancelled"."""

def grow_contrast(image: Volume, seeds_mm: numpy.typing.ArrayLike, kind: str, *, within: Optional[Mask] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Grown:
    """A "vessel" or a "lesion" from points inside it (n x 3, LPS, mm): what stands out from the tissue around,
    inside of the mask `within` where it is given.

    Raises glisson.Error: kind-unknown, grids-differ, grow-no-seeds, grow-bad-image, grow-seed-outside,
    grow-seed-on-nothing, grow-no-contrast, grow-only-thick."""

def grow_from_seeds(image: Volume, seeds_mm: numpy.typing.ArrayLike, *, progress: Optional[Callable[[float, str], Any]] = ...) -> Grown:
    """The liver from points inside it (n x 3, LPS, mm), in MR or CT.

    progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
    Raises glisson.Error: grow-no-seeds, grow-bad-image, grow-seed-outside, grow-seed-on-nothing, grow-constant-image,
    grow-nothing-found."""

def guide(file: str | os.PathLike[str], *, progress: Optional[Callable[[float, str], Any]] = ...) -> Any:
    """The organ and its hidden targets in each frame of a guidance case (guidance.json, "glisson-guidance/1").

    A dict: mesh (the TetMesh at rest); frames, a dict each: id, converged (where not, a note says why), residual_rms_mm,
    seconds; and where it did: pose (4 x 4, scan to camera, mm); displacement_mm (points, 3), in the scan's frame: a place x of the scan lies
    at pose (x + displacement); targets (id, position_mm in the camera's frame, sd_mm), tools (id, force_N, sd_N); notes.

    progress is told (fraction, stage); KeyboardInterrupt cancels.
    Raises glisson.Error: what is wrong with the case."""

def hoist_segment_vi(liver: TetMesh) -> Dict[str, Any]:
    """Where a retractor lifts segment VI: a dict of tool, center_mm (LPS), direction (unit), radius_mm, usual_force_N. A scenario's load: {"tool": {"center_mm": ..., "radius_mm": ..., "force_N": ...}}."""

def invert(phase_rad: numpy.typing.ArrayLike, *, frequency_Hz: float, spacing_mm: numpy.typing.ArrayLike = ..., origin_mm: numpy.typing.ArrayLike = ..., direction: numpy.typing.ArrayLike = ..., along: numpy.typing.ArrayLike = ..., organ: Optional[Mask] = ..., method: str = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """The shear modulus from phase images of one vibration.

    phase_rad     float32, shape (directions, instants, i, j, k): wrapped phase, instants evenly spread over one period
    frequency_Hz  of the vibration
    along         (directions, 3): unit vectors of the directions in LPS, or empty where they are not known
    organ         a Mask: only its voxels are inverted
    method        "direct" (the complex modulus) or "lfe" (local frequency estimation)

    A dict: magnitude_kPa, storage_kPa, loss_kPa, confidence (0 to 1): Volumes; region: the Mask of what could be inverted;
    mean_kPa, confident_fraction, notes.

    Raises glisson.Error: array-shape, waves-none, waves-no-frequency, waves-too-few-offsets, waves-empty-organ,
    waves-nothing-confident."""

def make_sequence(left: str | os.PathLike[str], right: str | os.PathLike[str], calibration: StereoCalibration, folder: str | os.PathLike[str], *, every: int = ..., frames: int = ..., step_px: int = ..., model: Optional[str | os.PathLike[str]] = ..., landmarks: Optional[str | os.PathLike[str]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """A stereo video (files, or folders of pictures) to a sequence on disk for sirgn_of_sequence: a cloud a frame, tracked
    landmarks and a model, in a new folder.

    every, frames  one frame of so many, at most so many; step_px: a point every so many pixels
    model          a surface file to register to; without, the frames' own, aligned globally
    landmarks      tracks.csv of an expert; without, tracked features

    A dict: file (sequence.json), frames, landmarks, mean_points, valid_fraction, epipolar_px, alignment_rms_mm (how well
    the frames' landmarks agree before, as rigid bodies, and aligned; None with a model), notes.
    progress is told (fraction, stage); KeyboardInterrupt cancels.
    Raises glisson.Error: video-not-readable, video-no-frames, sequence-folder-not-empty, sequence-lengths,
    sequence-too-few-frames, sequence-no-landmarks."""

def mark_attachments(liver: TetMesh) -> TetMesh:
    """The liver with the point fields "bare_area" and "diaphragm" (0 or 1), found by its shape: what holds it in the body.

    Raises glisson.Error: liver-no-attachment."""

def mask_surface(mask: Mask, *, smoothing_iterations: int = ..., pass_band: float = ...) -> Surface:
    """A smooth closed surface around a mask's voxels, by default as for organs; vessels of two voxels keep their shape with smoothing_iterations=20, pass_band=0.1.

    Raises glisson.Error: mask-empty."""

def match_surfaces(source: Surface, target: Surface, *, points: int = ..., solver: str = ..., prior: str = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> SurfaceMatch:
    """GEO: two Surfaces matched by geodesic distances, however they bend and wherever they lie.

    points  of each surface; solver "trwls", or "trws" (the slow one in double precision)
    prior   "none": any pose; "positions": roughly aligned; "auto": positions for a part of a whole

    Raises glisson.Error: too-few-points, matching-too-few-points, matching-too-many-points, mrf-too-large, solver-unknown,
    prior-unknown."""



def plan_hardware(*, liver_volume_cm3: float, accuracy_mm: float, youngs_kPa: Optional[float] = ..., duration_h: float = ..., frames_per_s: float = ..., ambient_C: float = ..., limit_C: float = ..., devices: Sequence[str | os.PathLike[str]] = ...) -> Dict[str, Any]:
    """The least obtrusive wearable computer that holds for a case, and why others fail.

    A dict: platforms, a dict each (id, name, worn, feasible, fps: what it can hold, power_W, battery_h, temperature_C,
    headroom_W, reasons, assumed); recommended (an id or None); nodes, frame_flops, frame_bytes; notes.
    devices: further device tables (JSON files).

    Raises glisson.Error: request-invalid, volume-not-a-liver, accuracy-not-reached, resources-missing."""

def predict(experiment: str | os.PathLike[str], better: Optional[str | os.PathLike[str]] = ..., *, progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """The trials of an experiment (a JSON file) as its declared model predicts them, or a better one (model.json).

    A dict: unit; trials, a dict each: id, predicted (float64), error (None where nobody measured); error of all that was
    measured: rms, mean, p95, max, noise, reduced_chi2; predicted, a number a row of all of them.

    Raises glisson.Error: what is wrong with the experiment, model-invalid."""

def read_calibration(file: str | os.PathLike[str]) -> StereoCalibration:
    """A StereoCalibration of JSON, OpenCV's YAML, or a folder of text files.

    Raises glisson.Error: calibration-invalid, calibration-not-rotation, calibration-no-baseline."""

def read_dicom_seg(file: str | os.PathLike[str]) -> List[SegmentedMask]:
    """The segments of a DICOM SEG file: a list of SegmentedMask."""

def read_labels_file(file: str | os.PathLike[str]) -> LabelMap:
    """The same for whole numbers 0..65535, as a LabelMap.

    Raises glisson.Error: as read_volume_file, and volume-file-not-labels."""

def read_mask_file(file: str | os.PathLike[str]) -> SegmentedMask:
    """The first segment of a label file; all that is not zero where it names none.

    Raises glisson.Error: as read_labels_file."""

def read_picture(file: str | os.PathLike[str]) -> numpy.typing.NDArray[Any]:
    """PNG, JPEG, TIFF, BMP or PNM: uint8, (height, width, 3), red, green, blue."""

def read_series(series: Series, volume: int = ..., *, progress: Optional[Callable[[float, str], Any]] = ...) -> Volume:
    """One volume of a series, with its rescaling applied.

    Raises glisson.Error: file-not-readable, dicom-truncated, dicom-changed, dicom-pixels-damaged, dicom-compression-unknown, dicom-colour."""

def read_surface(file: str | os.PathLike[str]) -> Surface:
    """A .vtp, .vtk, .stl, .obj, .off or .ply file as a Surface; numeric arrays become fields.

    Raises glisson.Error: file-not-readable, mesh-format-unknown, mesh-file-invalid, mesh-cell-type, mesh-too-large."""

def read_tetrahedra(file: str | os.PathLike[str]) -> TetMesh:
    """A .vtu or .vtk file as a TetMesh.

    Raises glisson.Error: file-not-readable, mesh-format-unknown, mesh-file-invalid, mesh-cell-type, mesh-too-large."""

def read_trees(file: str | os.PathLike[str]) -> VesselTrees:
    """VesselTrees of a file (glisson-vessel-trees/1).

    Raises glisson.Error: trees-unreadable."""

def read_volume_file(file: str | os.PathLike[str]) -> Volume:
    """A NIfTI, NRRD or MetaImage file as a Volume, in LPS.

    Raises glisson.Error: volume-file-unknown-type, -unreadable, -not-scalar, -not-3d, -bad-grid, -too-large, -truncated, -longer, -damaged."""

def register_surfaces(source: Surface, target: Surface, *, method: str = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """One Surface moved onto another, rigidly first, then as it bends.

    method  "icp": from where they lie; "geo": by distances along them, so that they may lie anywhere
    A dict: surface (the source moved, its points in their order), rms_mm, iterations, orientation_kept (for "geo": below
    0.6 it should not be trusted).

    Raises glisson.Error: registration-no-pairs, registration-mirrored, registration-singular, method-unknown."""

def rigid_icp(source: Surface, target: Surface, *, progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """Rigid alignment by closest points, from where the Surfaces lie. A dict: transform (4 x 4, source to target), rms_mm, iterations, converged."""

def scan(path: str | os.PathLike[str], *, progress: Optional[Callable[[float, str], Any]] = ...) -> Study:
    """All series under a folder, in the files of a DICOMDIR, or in one file; slices are ordered by where they stand.

    progress(fraction, stage) is told how far it is.
    Raises glisson.Error: path-not-found, path-not-readable, dicomdir-damaged."""

def segment_vessels(image: Volume, organ: Mask, seeds_mm: numpy.typing.ArrayLike = ..., *, brightness: Optional[str] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Grown:
    """The vessels of an organ by their shape, without a point; with points (n x 3, LPS, mm) those that hang on one.
    brightness "bright" or "dark"; without it, what more of the tubes are.

    Raises glisson.Error: choice-unknown, grids-differ, grow-bad-image, grow-seed-outside, vessels-no-organ, vessels-none,
    vessels-seed-off."""

def set_thread_count(threads: int) -> None:
    """How many threads loops use; 0 means as many as the machine has."""

def simulate(mesh: TetMesh, scenario: Any, *, progress: Optional[Callable[[float, str], Any]] = ...) -> Simulation:
    """A TetMesh under supports, loads and tools: its equilibrium, or its motion.

    scenario  a dict (or JSON text) as scenario files have it: lengths mm, forces N, moduli and pressures kPa, densities
              kg/m3; numpy arrays and numbers may stand in it
    progress  is told (fraction, stage); KeyboardInterrupt cancels

    Raises glisson.Error: scenario-invalid, landmark-outside, modulus-missing, not-converged, not-available, cut-invalid,
    cut-misses, document-invalid, and what a model refuses (no supports, no cells)."""

def sirgn(frames: Sequence[Tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike]], landmarks: Mapping[str, numpy.typing.ArrayLike], *, model: Optional[Surface] = ..., tolerances_mm: Sequence[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """How good a registration of a video is, triangle by triangle, by landmarks alone (SIRGn).

    frames     a pair a frame: the cloud as seen (n x 3, in the frame's space) and where the registration put it (n x 3, in
               the model's), point for point, mm
    landmarks  id -> (frames, 3): where each was seen, in the frame's space, mm; NaN where it was not
    model      a Surface, or None

    A dict: mesh (the correlation mesh, a Surface), correlation (-1..1), error_mm, doubt_mm, frames_seen: one a triangle;
    mean_correlation; rejected_fraction, one a tolerance; rmse_mm, tre_mm, one a frame; notes.

    Raises glisson.Error: sirgn-too-few-frames, sirgn-too-few-landmarks, sirgn-landmarks-off, sirgn-not-point-for-point,
    sirgn-tracks, sirgn-empty-frame, sirgn-tolerance."""

def sirgn_of_sequence(file: str | os.PathLike[str], method: str, *, tolerances_mm: Sequence[float] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """The same of a sequence on disk, as it was registered ("given") or by "icp", "geo" or "gnra"."""

def stereo_cloud(left: numpy.typing.ArrayLike, right: numpy.typing.ArrayLike, calibration: StereoCalibration, *, nearest_mm: float = ..., farthest_mm: float = ..., step_px: int = ...) -> Dict[str, Any]:
    """A pair of pictures (uint8, (height, width, 3)) to points in left-camera mm.

    A dict: surface (a Surface between neighbouring pixels), confidence (0..1, one a point), colour (n, 3), pixels (n, 2: x,
    y in `picture`), picture (the rectified left one), valid_fraction (of what is not masked).
    Raises glisson.Error: stereo-range, stereo-calibration-size, stereo-image-sizes, stereo-eyes-exchanged,
    calibration-not-of-pictures, stereo-failed."""

def territories(trees: VesselTrees, system: str, liver: Mask) -> Dict[str, Any]:
    """Which tissue belongs to which branch of "portal-vein" or "hepatic-vein": nearest wall, along ways in the liver.

    A dict: branch (int32, [i, j, k] on the liver's grid: of trees.branches, -1 where none), distance_mm (float32, from its
    wall), volume_ml (of each branch by itself), volume_beyond_ml (with all that grows from it).
    Raises glisson.Error: territories-no-branch, liver-empty, choice-unknown."""

def track_landmarks(pairs: Iterable, calibration: StereoCalibration) -> Dict[str, Any]:
    """Landmarks of a stereo video, followed in both eyes at once.

    pairs  (left, right) a frame, pictures each; any iterable, read one by one

    id -> (frames, 3): left-camera mm, NaN where it was not seen; the longest first, as sirgn() takes them.
    Raises glisson.Error: stereo-image-sizes, stereo-failed."""

def trwls(source_mm: numpy.typing.ArrayLike, target_mm: numpy.typing.ArrayLike, *, sigma_mm: float, tau_mm: float, passes: int = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> Dict[str, Any]:
    """Matches nodes to labels by their distances, (nodes, nodes) and (labels, labels), mm: TRWL-S.

    A pair of nodes at x that gets labels at y costs exp(-min(x, y) / sigma) min(|x - y|, tau).
    A dict: labels (int32, (nodes,)), energy, lower_bound, passes, stopped, solve_ms.

    Raises glisson.Error: matching-distances, matching-too-few-points, matching-too-many-points, matching-constants,
    matching-passes."""

def usual_supports() -> List[Any]:
    """The supports of a scenario that go with mark_attachments: the bare area held, the diaphragm on a foundation."""

def vessel_trees(vessels: Mask, liver: Mask, *, portal_mm: Optional[numpy.typing.ArrayLike] = ..., hepatic_mm: Optional[numpy.typing.ArrayLike] = ..., clicks: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., borders: Sequence[Tuple[str, numpy.typing.ArrayLike]] = ..., arteries: Optional[Mask] = ..., bile_ducts: Optional[Mask] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> VesselTrees:
    """VesselTrees of a Mask that holds portal and hepatic veins together: centre lines, the two told apart by the liver's shape,
    branches named. portal_mm, hepatic_mm: a place (LPS, mm) on each main stem, where the first guess is wrong.
    clicks: (vessel, place) each, what the vessel there is: "portal-vein", "hepatic-vein", "middle-hepatic-vein",
    "right-hepatic-vein", "umbilical-portion" or "left-hepatic-vein".
    borders: ("V-VIII", place) each, through which the border of those two segments runs.
    arteries, bile_ducts: a Mask of each, which get trees of their own and change nothing of the veins.

    progress is told (fraction, stage); KeyboardInterrupt cancels.
    Raises glisson.Error: choice-unknown, click-beside, border-outside, borders-contradict, vessels-empty, vessels-one-blob, vessels-grid, vessels-outside, liver-empty."""

def volume_ml(mask: Mask) -> float:
    """Of a mask's voxels, ml."""

def write_calibration(file: str | os.PathLike[str], calibration: StereoCalibration) -> None:
    """Writes a StereoCalibration as JSON, all or nothing."""

def write_explanation(experiment: str | os.PathLike[str], folder: str | os.PathLike[str], *, progress: Optional[Callable[[float, str], Any]] = ...) -> None:
    """Explains an experiment, as explain(), into a folder: report.json, report.html for people, and model.json for predict() and for rehearsals.

    Raises glisson.Error: what is wrong with the experiment, file-not-writable."""

def write_mask_file(file: str | os.PathLike[str], mask: Mask, name: str, *, label_value: int = ..., color_rgb: Sequence[float] = ...) -> None:
    """Writes a .nrrd that 3D Slicer opens as one named, coloured segment, all or nothing."""

def write_patient_page(case: Case, file: str | os.PathLike[str], *, name: Optional[str] = ..., figures: Sequence[Tuple[str | os.PathLike[str], str]] = ..., progress: Optional[Callable[[float, str], Any]] = ...) -> None:
    """What was done for the patient of a Case, as one HTML file that needs nothing beside it.

    name     the patient's, which the page otherwise withholds
    figures  (PNG file, caption) each, as draw_case and write_picture make them; the first large

    Raises glisson.Error: case-lacks-entry, file-not-readable, file-not-writable."""

def write_picture(file: str | os.PathLike[str], picture: numpy.typing.ArrayLike) -> None:
    """Writes uint8 of (height, width, 3), by the extension, all or nothing."""

def write_surface(file: str | os.PathLike[str], surface: Surface) -> None:
    """Writes .vtp (with all fields), .stl, .obj or .ply, all or nothing."""

def write_tetrahedra(file: str | os.PathLike[str], mesh: TetMesh) -> None:
    """Writes .vtu with all fields, all or nothing."""

def write_trees(file: str | os.PathLike[str], trees: VesselTrees) -> None:
    """Writes VesselTrees as JSON, all or nothing."""

def write_volume_file(file: str | os.PathLike[str], volume: Volume) -> None:
    """Writes .nrrd, .nii, .nii.gz or .mha, 32-bit floats, all or nothing."""
