# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes NIfTI and Analyze by nibabel. NIfTI uses right-anterior-superior; the phantom's grids use
left-posterior-superior."""

import gzip

import nibabel
import numpy as np
from cases import case
from phantom import TISSUE, Grid, turned, values

GRID = Grid()
TO_RAS = np.diag([-1.0, -1.0, 1.0, 1.0])


def image(grid=GRID, dtype=np.int16, kind=nibabel.Nifti1Image, voxels=None, affine=None):
    affine = TO_RAS @ grid.affine if affine is None else affine
    made = kind(grid.sample(dtype) if voxels is None else voxels, affine)
    made.header.set_xyzt_units("mm", "sec")
    return made


def save(folder, made, name="head.nii.gz"):
    folder.mkdir(parents=True, exist_ok=True)
    nibabel.save(made, folder / name)
    return folder / name


@case("nifti-plain")
def plain(folder):
    return save(folder, image())


@case("nifti-uncompressed")
def uncompressed(folder):
    return save(folder, image(), "head.nii")


def grid_case(name, grid, **facts):
    @case(f"nifti-{name}", **facts)
    def write(folder):
        return save(folder, image(grid))


grid_case("oblique", Grid(axes=turned(35.0)))
grid_case("right-anterior-superior", Grid(axes=np.diag([-1.0, -1.0, 1.0])))
grid_case("mirrored", Grid(axes=np.diag([-1.0, 1.0, 1.0])), source="a qform with qfac -1")
grid_case("sagittal", Grid(axes=np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])))


def type_case(dtype, **facts):
    @case(f"nifti-{np.dtype(dtype).name}", **facts)
    def write(folder):
        return save(folder, image(dtype=dtype, voxels=GRID.sample(float).astype(dtype)))


for number_type in (np.int32, np.float32, np.float64):
    type_case(number_type)


def unsigned_case(dtype, offset, scale):
    @case(f"nifti-{np.dtype(dtype).name}", offset=offset, scale=scale, options=("--preset", "histogram"))
    def write(folder):
        return save(folder, image(voxels=np.round(GRID.sample(float) * scale + offset).astype(dtype)))


unsigned_case(np.uint8, 200.0, 0.2)
unsigned_case(np.uint16, 1024.0, 1.0)
unsigned_case(np.uint32, 1024.0, 1.0)
unsigned_case(np.int8, 0.0, 0.1)


@case("nifti-2")
def nifti2(folder):
    return save(folder, image(kind=nibabel.Nifti2Image))


@case("nifti-big-endian")
def big_endian(folder):
    made = image()
    swapped = nibabel.Nifti1Image(np.asarray(made.dataobj), made.affine, made.header.as_byteswapped(">"))
    return save(folder, swapped, "head.nii")


def slope_case(name, slope, intercept, stored, **facts):
    @case(f"nifti-slope-{name}", **facts)
    def write(folder):
        path = save(folder, image(voxels=stored(GRID.sample(float)).astype(np.int16)), "head.nii")
        raw = bytearray(path.read_bytes())
        raw[112:120] = np.array([slope, intercept], "<f4").tobytes()  # scl_slope, scl_inter
        path.write_bytes(raw)
        return path


slope_case("0", 0.0, 0.0, np.round, source="nifti1.h: a slope of 0 scales nothing")
slope_case("nan", np.nan, np.nan, np.round, source="nibabel writes NaN for none")
slope_case("2-1024", 2.0, -1024.0, lambda v: np.round((v + 1024.0) / 2.0), tolerance=1.5)
slope_case("half", 0.5, 10.0, lambda v: np.round((v - 10.0) * 2.0))


@case("nifti-sform-longer-than-pixdim", source="MRtrix3#1439: method 3, the sform's length holds")
def long_sform(folder):
    path = save(folder, image(), "head.nii")
    raw = bytearray(path.read_bytes())
    raw[76 + 4:76 + 16] = np.array([1.2, 1.3, 1.4], "<f4").tobytes()  # pixdim
    raw[252:254] = np.array([0], "<i2").tobytes()  # no qform
    path.write_bytes(raw)
    return path


@case("nifti-sheared-sform", source="dcm2niix: pixdim is then the distance of planes", told=("shear|tilt|slant",),
      tolerance=120.0, outside=True)
def sheared(folder):
    grid = Grid(size=(44, 64, 42))
    affine = TO_RAS @ grid.affine
    affine[1, 2] = 0.36 * grid.spacing[2]
    affine[1, 3] -= 0.36 * grid.spacing[2] * 20.5  # the middle stays
    points = np.moveaxis(np.indices(grid.size, dtype=float), 0, -1) @ affine[:3, :3].T + affine[:3, 3]
    made = nibabel.Nifti1Image(np.round(values(points * [-1.0, -1.0, 1.0])).astype(np.int16), affine)
    made.set_qform(None, code=0)
    made.set_sform(affine, code=1)
    return save(folder, made)


@case("nifti-qform-only")
def qform_only(folder):
    made = image(Grid(axes=turned(20.0)))
    made.set_qform(made.affine, code=1)
    made.set_sform(None, code=0)
    return save(folder, made)


@case("nifti-neither-form", steps=(-1.5, -1.6, 1.7))
def neither(folder):
    made = image()
    made.set_qform(None, code=0)
    made.set_sform(None, code=0)
    return save(folder, made)


def unit_case(unit, per_mm):
    @case(f"nifti-{unit}", source="nifti1.h: xyzt_units")
    def write(folder):
        grid_affine = TO_RAS @ GRID.affine
        grid_affine[:3] *= per_mm
        made = image(affine=grid_affine)
        made.header.set_xyzt_units(unit, "sec")
        return save(folder, made)


unit_case("micron", 1000.0)
unit_case("meter", 0.001)


@case("nifti-4d-times", told=("frames|time",))
def times(folder):
    """Writes time steps in which the tissue becomes softer."""
    return save(folder, image(voxels=np.stack([GRID.sample(tissue=TISSUE - 100.0 * t) for t in range(3)], axis=3)))


@case("nifti-4d-channels", source="BraTS, MSD: channels in the 4th dimension", told=("channel",))
def channels(folder):
    voxels = np.repeat(GRID.sample()[..., None], 4, axis=3)
    voxels[..., 1:] = 0
    made = image(voxels=voxels)
    made.header["pixdim"][4] = 0.0
    made.header.set_xyzt_units("mm", "unknown")
    return save(folder, made)


@case("nifti-4d-none-chosen", refused="has 3 volumes along its fourth axis, and none with the number 4", options=("--series", "4"))
def none_chosen(folder):
    return save(folder, image(voxels=np.repeat(GRID.sample()[..., None], 3, axis=3)))


@case("nifti-4d-second-channel", source="DATA.md: one can be chosen", told=("volume 2 of 3",),
      options=("--series", "2"))
def second_channel(folder):
    voxels = np.repeat(GRID.sample()[..., None], 3, axis=3)
    voxels[..., [0, 2]] = 7
    return save(folder, image(voxels=voxels))


@case("nifti-5d-channels", source="nifti1.h: dim[5] has what is at a voxel", told=("channel|component|first",))
def channels5(folder):
    voxels = np.repeat(GRID.sample()[..., None, None], 2, axis=4)
    voxels[..., 1] = 0
    return save(folder, image(voxels=voxels))


@case("nifti-4d-of-one")
def one_time(folder):
    return save(folder, image(voxels=GRID.sample()[..., None]))


def stored_case(name, voxels, refused=None, **facts):
    @case(f"nifti-{name}", refused=refused, **facts)
    def write(folder):
        return save(folder, image(voxels=voxels))


GRAY = np.round((GRID.sample(float) + 1000.0) * 255.0 / 1060.0).astype(np.uint8)
RGB = np.zeros(GRID.size, dtype=[("R", "u1"), ("G", "u1"), ("B", "u1")])
for colour in "RGB":
    RGB[colour] = GRAY
stored_case("rgb", RGB, scale=255.0 / 1060.0, offset=1000.0 * 255.0 / 1060.0, tolerance=2.0,
            options=("--preset", "histogram"))
stored_case("complex", GRID.sample(float).astype(np.complex64), told=("component",))


def damaged_case(name, change, refused):
    @case(f"nifti-{name}", refused=refused)
    def write(folder):
        path = save(folder, image(), "head.nii")
        raw = bytearray(path.read_bytes())
        path.write_bytes(change(raw))
        return path


damaged_case("cut-off", lambda raw: raw[:-5000], "cut off|truncated|announces|damaged|fewer|not in the file|short|complete")
damaged_case("promises-more", lambda raw: raw[:42] + np.array([30000] * 3, "<i2").tobytes() + raw[48:],
             "cut off|truncated|announces|damaged|fewer|not in the file|short|complete")
damaged_case("negative-size", lambda raw: raw[:42] + np.array([-4], "<i2").tobytes() + raw[44:],
             "size|damaged|dimension|empty")


@case("nifti-gz-in-name-only", source="renamed by hand")
def gz_by_name(folder):
    path = save(folder, image(), "head.nii")
    return path.rename(folder / "head.nii.gz")


@case("nifti-gz-of-two-members", source="RFC 1952 2.2: a file may have several members")
def two_members(folder):
    path = save(folder, image(), "head.nii")
    raw = path.read_bytes()
    packed = folder / "two.nii.gz"
    packed.write_bytes(gzip.compress(raw[:40000]) + gzip.compress(raw[40000:]))
    path.unlink()
    return packed


@case("nifti-pair")
def pair(folder):
    save(folder, image(kind=nibabel.Nifti1Pair), "head.img")
    return folder / "head.hdr"


@case("nifti-pair-by-its-img")
def pair_img(folder):
    return save(folder, image(kind=nibabel.Nifti1Pair), "head.img")


@case("nifti-pair-compressed")
def pair_gz(folder):
    return save(folder, image(kind=nibabel.Nifti1Pair), "head.img.gz")


@case("analyze", source="Analyze 7.5 has no orientation", steps=(-1.5, -1.6, 1.7))
def analyze(folder):
    made = nibabel.AnalyzeImage(GRID.sample(), np.diag([*GRID.spacing, 1.0]))
    save(folder, made, "head.img")
    return folder / "head.hdr"


@case("nifti-nan-outside", source="SPM and FSL write masked maps", outside=True)
def nan_outside(folder):
    voxels = GRID.sample(float).astype(np.float32)
    voxels[np.linalg.norm(GRID.points() - GRID.points()[22, 20, 21], axis=-1) > 34.0] = np.nan
    return save(folder, image(voxels=voxels))


@case("nifti-one-infinity", source="DATA.md: one voxel of 1e38", outside=True)
def one_infinity(folder):
    voxels = GRID.sample(float).astype(np.float32)
    voxels[2, 2, 2] = np.inf
    return save(folder, image(voxels=voxels))
