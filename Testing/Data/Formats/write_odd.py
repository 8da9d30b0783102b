# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes features that formats allow and few files have: other axes, units, types and compressions, by the libraries of
the other writers."""

import json
import zipfile

import nibabel
import numcodecs
import numpy as np
import SimpleITK
import tifffile
import zarr
from cases import case
from phantom import CENTRE, Grid, turned
from pydicom import dcmread
from pydicom.dataset import Dataset
from pydicom.sequence import Sequence
from pydicom.uid import NuclearMedicineImageStorage
from write_dicom import GRID, enhanced, header, put_pixels, save, save_all, slices, uid
from write_images import CUBES, UNSIGNED, itk_image, meta_case, ngff, refused_case, replace, tiff_case

STEPS = tuple(GRID.spacing)
TO_RAS = np.diag([-1.0, -1.0, 1.0, 1.0])


# DICOM


@case("dicom-modality-lut", source="PS3.3 C.11.1: a table instead of slope and intercept", refused="ModalityLUTSequence")
def modality_lut(folder):
    sets = slices(GRID, intercept=-1024.0)
    for data in sets:
        del data.RescaleIntercept, data.RescaleSlope
        table = Dataset()
        table.LUTDescriptor = [2048, 0, 16]
        table.ModalityLUTType = "HU"
        table.LUTData = np.clip(np.arange(2048) * 2 - 2048 + 5000, 0, 65535).astype("<u2").tobytes()
        data.ModalityLUTSequence = Sequence([table])
    return save_all(folder, sets)


@case("dicom-modality-lut-without-items", source="pydicom and anonymisers leave empty sequences")
def modality_lut_empty(folder):
    sets = slices(GRID)
    for data in sets:
        data.ModalityLUTSequence = Sequence([])
    return save_all(folder, sets)


def high_bits(name, change, told=(), **pixels):
    @case(f"dicom-high-bit-15-{name}", source="PS3.5 8.1.1: 12 bits stored, of which the highest is bit 15", told=told)
    def write(folder):
        sets = slices(GRID, **pixels)
        for data in sets:
            stored = np.frombuffer(data.PixelData, data.PixelRepresentation and "<i2" or "<u2")
            data.BitsStored, data.HighBit = 12, 15
            data.PixelData = change(stored).astype(stored.dtype).tobytes()
        return save_all(folder, sets)


# The outer slices contain only air, which is stored as 16: its four lowest bits are 0, as if the values were shifted.
high_bits("and-samples-below", lambda stored: stored, ("not where HighBit says",), intercept=-1016.0)
high_bits("and-signed-samples-below", lambda stored: stored, ("not where HighBit says",), intercept=0.0, signed=True)
high_bits("and-an-overlay", lambda stored: stored << 4 | np.arange(stored.size) % 3, ("may be an overlay",))


@case("dicom-high-bit-15-in-phases", source="PS3.5 8.1.1: decided once, also where a phase has no low bits", tolerance=9.0,
      told=("not where HighBit says", "2 phases"))
def high_bit_phases(folder):
    for phase in range(2):
        # All samples of the first phase are multiples of 16, as if 12 bits of 16 were shifted.
        voxels = GRID.sample(float) if phase else np.round((GRID.sample(float) + 1024.0) / 16.0) * 16.0 - 1024.0
        sets = slices(GRID, sampled=voxels)
        for k, data in enumerate(sets):
            data.BitsStored, data.HighBit = 12, 15
            data.TemporalPositionIdentifier = phase + 1
            data.InstanceNumber = phase * len(sets) + k + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("high bit", phase, k)
        save_all(folder, sets)
    return folder


@case("dicom-high-bit-15", source="PS3.5 8.1.1: 12 bits stored, of which the highest is bit 15")
def high_bit(folder):
    sets = slices(GRID)
    for data in sets:
        stored = np.frombuffer(data.PixelData, "<u2")
        data.BitsStored, data.HighBit = 12, 15
        data.PixelData = (stored << 4).astype("<u2").tobytes()
    return save_all(folder, sets)


def noisy(deviation):
    """The phantom as a scanner has it: with noise in air and tissue, which shows where zero is."""
    voxels = GRID.sample(float)
    noise = np.random.default_rng(5).normal(0.0, deviation, voxels.shape).round().clip(-90, 90)
    return np.maximum(voxels + noise, -1024.0)


STORED_HIGHER = {"source": "Modality CT without a rescale: stored as HU + 1024", "tolerance": 95.0,
                 "told": ("taken for Hounsfield units .*1024",)}


@case("dicom-phases-stored-higher", **STORED_HIGHER)
def phases_stored_higher(folder):
    """In the second phase, the soft tissue alone does not show that it is stored so."""
    for phase in range(2):
        sets = slices(GRID, sampled=1024.0 + noisy(deviation=0.0 if phase else 20.0), intercept=0.0)
        for k, data in enumerate(sets):
            del data.RescaleIntercept, data.RescaleSlope
            data.TemporalPositionIdentifier = phase + 1
            data.InstanceNumber = phase * len(sets) + k + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("higher", phase, k)
        save_all(folder, sets)
    return folder


@case("nifti-4d-stored-higher", **STORED_HIGHER)
def times_stored_higher(folder):
    folder.mkdir(parents=True, exist_ok=True)
    voxels = np.stack([1024.0 + noisy(deviation=one) for one in (20.0, 0.0)], axis=3)
    made = nibabel.Nifti1Image(voxels.astype(np.int16), TO_RAS @ GRID.affine)
    made.header.set_xyzt_units("mm", "sec")
    nibabel.save(made, folder / "head.nii.gz")
    return folder / "head.nii.gz"


@case("nifti-files-stored-higher", **STORED_HIGHER)
def files_stored_higher(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for number, deviation in enumerate((20.0, 0.0)):
        voxels = (1024.0 + noisy(deviation=deviation)).astype(np.int16)
        nibabel.save(nibabel.Nifti1Image(voxels, TO_RAS @ GRID.affine), folder / f"{number}.nii.gz")
    return folder


@case("dicom-ct-of-8-bits", scale=0.1, offset=110.0, tolerance=0.6, told=("can't be|not Hounsfield units",),
      source="PS3.3 C.8.2.1: a windowed picture of a CT has no HU", options=("--preset", "histogram"))
def ct_of_8_bits(folder):
    return save_all(folder, slices(GRID, sampled=110.0 + 0.1 * GRID.sample(float), intercept=0.0, bits=8))


@case("dicom-spacing-between-slices-negative", source="Slicer/Slicer#7987: a negative SpacingBetweenSlices of a CT")
def spacing_negative(folder):
    sets = slices(GRID)
    for data in sets:
        data.SpacingBetweenSlices = "-5.0"
    return save_all(folder, sets)


@case("dicom-32-bits", source="PS3.5 8.1.1: 32 bits")
def bits32(folder):
    return save_all(folder, slices(GRID, bits=32, signed=True, intercept=0.0))


@case("dicom-padding-range", source="PS3.3 C.7.5.1.1.2: PixelPaddingRangeLimit", outside=True, told=("outside",))
def padding_range(folder):
    voxels = GRID.sample(float)
    x = GRID.points()
    beside = np.hypot(x[..., 0] - CENTRE[0], x[..., 1] - CENTRE[1]) > 31.0
    voxels[beside] = -2000.0 + np.arange(beside.sum()) % 50
    sets = slices(GRID, sampled=voxels, intercept=0.0, signed=True)
    for data in sets:
        data.add_new(0x00280120, "SS", -2000)
        data.add_new(0x00280121, "SS", -1950)
    return save_all(folder, sets)


@case("dicom-nuclear-medicine", source="PS3.3 C.8.4.11: places are in DetectorInformationSequence", scale=1.0, offset=1100.0,
      options=("--preset", "histogram"))
def nuclear(folder):
    data = header(NuclearMedicineImageStorage, "NM", "spect")
    data.ImageType = ["ORIGINAL", "PRIMARY", "RECON TOMO", "EMISSION"]
    detector = Dataset()
    detector.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
    detector.ImagePositionPatient = [f"{x:.6f}" for x in GRID.origin]
    data.DetectorInformationSequence = Sequence([detector])
    data.PixelSpacing = [GRID.spacing[1], GRID.spacing[0]]
    data.SpacingBetweenSlices = data.SliceThickness = GRID.spacing[2]
    put_pixels(data, np.moveaxis(GRID.sample(float) + 1100.0, 2, 0).transpose(0, 2, 1), intercept=0.0)
    data.NumberOfFrames, data.NumberOfSlices = GRID.size[2], GRID.size[2]
    data.FrameIncrementPointer = 0x00540080
    data.SliceVector = list(range(1, GRID.size[2] + 1))
    return save(folder, data, "spect.dcm")


@case("dicom-nuclear-medicine-from-head-to-feet", source="PS3.3 C.8.4.15: SpacingBetweenSlices may be negative", offset=1100.0,
      options=("--preset", "histogram"))
def nuclear_down(folder):
    path = nuclear(folder)
    data = dcmread(path)
    end = (GRID.affine @ [0, 0, GRID.size[2] - 1, 1])[:3]
    data.DetectorInformationSequence[0].ImagePositionPatient = [f"{x:.6f}" for x in end]
    data.SpacingBetweenSlices = -GRID.spacing[2]
    frames = np.frombuffer(data.PixelData, "<u2").reshape(GRID.size[2], -1)
    data.PixelData = frames[::-1].tobytes()
    data.save_as(path)
    return path


@case("dicom-enhanced-orientation-per-frame", source="PS3.3 C.7.6.16.2.4: each frame has its own orientation",
      refused="turned against each other, by up to 17[0-9.]+ degrees")
def orientation_per_frame(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    del data.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence
    for k, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        plane, angle = Dataset(), np.radians(180.0 * k / GRID.size[2])
        plane.ImageOrientationPatient = [f"{x:.8f}" for x in (np.cos(angle), np.sin(angle), 0, 0, 0, -1)]
        item.PlaneOrientationSequence = Sequence([plane])
        item.PlanePositionSequence[0].ImagePositionPatient = [f"{x:.6f}" for x in CENTRE]
    return save(folder, data, "radial.dcm")


def turned_case(name, step, **facts):
    """Slices at even places, each turned by some degrees against the one before it."""

    @case(f"dicom-{name}", refused="turned against each other", **facts)
    def write(folder):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            c, s = np.cos(np.radians(step * k)), np.sin(np.radians(step * k))
            data.ImageOrientationPatient = [f"{x:.8f}" for x in (c, 0, s, 0, 1, 0)]
        return save_all(folder, sets)


turned_case("slices-of-a-fan", 2.0, source="PS3.3 C.7.6.2: each slice has its own orientation")
turned_case("slices-turned-little", 0.05, source="PS3.3 C.7.6.2: each slice has its own orientation")


@case("dicom-slices-turned-in-their-plane", source="PS3.3 C.7.6.2: rows may have any direction in one plane",
      told=("22 slices of 40 x 40, .*of 2 series|of 2 series",), scale=0.0)
def turned_in_plane(folder):
    grid = Grid(size=(40, 40, 42))
    sets = slices(grid)
    for data in sets[:20]:
        data.ImageOrientationPatient = [0, 1, 0, -1, 0, 0]
    return save_all(folder, sets)


@case("dicom-enhanced-times", source="PS3.3 C.7.6.16.2.2: TemporalPositionIndex", told=("2 phases",))
def enhanced_times(folder):
    order = [k for _ in range(2) for k in range(GRID.size[2])]
    data = enhanced(GRID, order)
    for frame, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        content = Dataset()
        content.TemporalPositionIndex = frame // GRID.size[2] + 1
        content.DimensionIndexValues = [frame // GRID.size[2] + 1, frame % GRID.size[2] + 1]
        item.FrameContentSequence = Sequence([content])
    return save(folder, data, "times.dcm")


@case("dicom-enhanced-bvalues", source="PS3.3 C.8.13.5.9: diffusion", told=("DiffusionBValue 0, of 2 series",))
def enhanced_diffusion(folder):
    order = [k for _ in range(2) for k in range(GRID.size[2])]
    data = enhanced(GRID, order)
    for frame, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        diffusion = Dataset()
        diffusion.DiffusionBValue = float(1000 * (frame // GRID.size[2]))
        item.MRDiffusionSequence = Sequence([diffusion])
    return save(folder, data, "diffusion.dcm")


@case("dicom-rgb", source="PS3.3 C.7.6.3.1.2: colours", scale=0.2, offset=210.0, tolerance=1.6, told=("brightness",),
      options=("--preset", "histogram"))
def rgb(folder):
    sets = slices(GRID, sampled=np.round(0.2 * GRID.sample(float) + 210.0), intercept=0.0, bits=8)
    for data in sets:
        grey = np.frombuffer(data.PixelData, np.uint8)
        data.PixelData = np.repeat(grey, 3).tobytes()
        data.SamplesPerPixel, data.PlanarConfiguration, data.PhotometricInterpretation = 3, 0, "RGB"
    return save_all(folder, sets)


@case("dicom-palette", source="PS3.3 C.7.6.3.1.5: numbers of colours are no values", refused="PALETTE COLOR")
def palette(folder):
    sets = slices(GRID, sampled=np.round(0.2 * GRID.sample(float) + 210.0), intercept=0.0, bits=8)
    table = np.random.default_rng(1).integers(0, 65535, 256).astype("<u2").tobytes()
    for data in sets:
        data.PhotometricInterpretation = "PALETTE COLOR"
        for tag in range(0x00281101, 0x00281104):
            data.add_new(tag, "US", [256, 0, 16])
            data.add_new(tag + 0x100, "OW", table)
    return save_all(folder, sets)


@case("dicom-orientation-of-three-digits", source="orientation rounded by an anonymiser", tolerance=60.0)
def rounded_orientation(folder):
    sets = slices(Grid(axes=turned(30.0)))
    for data in sets:
        data.ImageOrientationPatient = [f"{float(x):.3f}" for x in data.ImageOrientationPatient]
    return save_all(folder, sets)


@case("dicom-in-a-zip", refused="packed folder")
def dicom_zip(folder):
    save_all(folder / "in", slices(GRID))
    with zipfile.ZipFile(folder / "series.zip", "w") as packed:
        for path in (folder / "in").iterdir():
            packed.write(path, path.name)
    return folder / "series.zip"


@case("dicom-two-pixel-spacings", source="two reconstructions with one SeriesInstanceUID", told=("of 2 series",), scale=0.0)
def two_pixel_spacings(folder):
    sets = slices(GRID)
    for data in sets[20:]:
        data.PixelSpacing = [3.2, 3.0]
    return save_all(folder, sets)


@case("dicom-enhanced-two-pixel-spacings", source="PS3.3 C.7.6.16.2.1: each frame has its own", told=("of 2 series",), scale=0.0)
def two_pixel_spacings_of_frames(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    del data.SharedFunctionalGroupsSequence[0].PixelMeasuresSequence
    for k, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        measures = Dataset()
        measures.PixelSpacing, measures.SliceThickness = ([1.6, 1.5] if k < 20 else [3.2, 3.0]), 1.7
        item.PixelMeasuresSequence = Sequence([measures])
    return save(folder, data, "enhanced.dcm")


@case("dicom-two-patients", source="two patients with one SeriesInstanceUID, after an anonymiser", told=("of 2 series",))
def two_patients(folder):
    for number in range(2):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            data.PatientID = data.PatientName = str(number)
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("patient", number, k)
        save_all(folder / str(number), sets)
    return folder


# NIfTI


def nifti(folder, voxels, name="head.nii", change=None):
    folder.mkdir(parents=True, exist_ok=True)
    image = nibabel.Nifti1Image(voxels, TO_RAS @ GRID.affine, dtype=voxels.dtype)
    image.header.set_xyzt_units("mm", "sec")
    if change:
        change(image)
    nibabel.save(image, folder / name)
    return folder / name


def nifti_case(name, voxels=GRID.sample, file="head.nii", change=None, **facts):
    @case(f"nifti-{name}", **facts)
    def write(folder):
        return nifti(folder, voxels(), file, change)


def both_forms(image):
    """Writes a qform for the scanner, and an sform for a template."""
    image.set_qform(TO_RAS @ Grid(axes=turned(50.0), at_centre=(0, 0, 0)).affine, 1)
    image.set_sform(TO_RAS @ GRID.affine, 4)


def singular(image):
    image.header["sform_code"] = 2
    image.header["srow_x"], image.header["srow_y"], image.header["srow_z"] = 0, 0, 0


nifti_case("both-forms-that-differ", change=both_forms, source="nifti1.h: method 3 before method 2")
nifti_case("int64", lambda: GRID.sample(np.int64), source="nifti1.h: DT_INT64")
nifti_case("bzip2", file="head.nii.bz2", refused="bzip2|bunzip2|packed", source="nibabel writes it")
nifti_case("extension", change=lambda image: image.header.extensions.append(
    nibabel.nifti1.Nifti1Extension("comment", b"what the scanner knew, " * 40)), source="nifti1.h: vox_offset is behind extensions")
nifti_case("5d-times-of-one-slice", lambda: GRID.sample()[:, :, 20][:, :, None, None], refused="single slice|one slice|thin")
nifti_case("2d", lambda: GRID.sample()[:, :, 20], refused="single slice|one slice|two dimensions|thin")


@case("nifti-singular-sform", source="an sform_code of 2 with rows of zeros", told=("sform",))
def singular_sform(folder):
    return nifti(folder, GRID.sample(), change=singular)


@case("nifti-pixdim-0", source="dcm2niix: pixdim[3] = 0 for a lost distance of slices", told=("no voxel spacing along index axis 3",), steps=(-1.5, -1.6, 1.0))
def pixdim0(folder):
    path = nifti(folder, GRID.sample())
    raw = bytearray(path.read_bytes())
    raw[88:92] = np.float32(0).tobytes()
    raw[252:256] = bytes(4)  # neither form
    path.write_bytes(raw)
    return path


@case("nifti-cifti", refused="CIFTI", source="the Human Connectome Project: vertices, no voxels")
def cifti(folder):
    folder.mkdir(parents=True, exist_ok=True)
    axis = nibabel.cifti2.BrainModelAxis.from_mask(GRID.sample() > -470, affine=TO_RAS @ GRID.affine)
    scalars = nibabel.cifti2.ScalarAxis(["ct"])
    image = nibabel.Cifti2Image(np.zeros((1, len(axis)), np.float32), (scalars, axis))
    nibabel.save(image, folder / "head.dscalar.nii")
    return folder / "head.dscalar.nii"


# NRRD


def text_nrrd(folder, lines, data, name="head.nrrd"):
    folder.mkdir(parents=True, exist_ok=True)
    head = "\n".join(["NRRD0004", *lines])
    (folder / name).write_bytes((head + ("\n" if head.endswith("\r") else "\n\n")).encode() + data)
    return folder / name


def vector(numbers):
    return "(" + ",".join(f"{float(x):.12g}" for x in numbers) + ")"


PLACE = [f"space directions: {' '.join(vector(column) for column in GRID.affine[:3, :3].T)}", f"space origin: {vector(GRID.origin)}"]
SIZES = [f"sizes: {' '.join(str(n) for n in GRID.size)}", "dimension: 3"]
RAW = GRID.sample().tobytes(order="F")


RAS = Grid(axes=np.diag([-1.0, -1.0, 1.0]))


def nrrd_text_case(name, lines, data=RAW, **facts):
    @case(f"nrrd-{name}", **facts)
    def write(folder):
        return text_nrrd(folder, lines, data)


nrrd_text_case("hex", ["type: short", *SIZES, "space: left-posterior-superior", *PLACE, "endian: little", "encoding: hex"],
               RAW.hex().encode(), source="teem: encoding hex", refused="hex")
nrrd_text_case("crlf", ["type: short\r", *[line + "\r" for line in SIZES], "space: LPS\r", *[line + "\r" for line in PLACE],
                        "endian: little\r", "encoding: raw\r", "\r"], source="a header that Windows wrote")
nrrd_text_case("lps-abbreviated", ["type: signed short int", *SIZES, "space: LPS", *PLACE, "endian: little", "encoding: raw"],
               source="teem: abbreviated spaces and C's names of types")
nrrd_text_case("space-dimension", ["type: int16_t", *SIZES, "space dimension: 3", *PLACE, "endian: little", "encoding: raw"],
               steps=STEPS, first=tuple(GRID.origin), source="teem: a space without a name")
nrrd_text_case("scanner-xyz", ["type: int16", *SIZES, "space: scanner-xyz", *PLACE, "endian: little", "encoding: raw"],
               steps=STEPS, first=tuple(GRID.origin), source="teem: the scanner's space, not the patient's")
nrrd_text_case("left-handed-space", ["type: int16", *SIZES, "space: 3D-left-handed", *PLACE, "endian: little", "encoding: raw"],
               steps=(1.5, 1.6, -1.7), first=(GRID.origin[0], GRID.origin[1], -GRID.origin[2]), told=("left-handed",),
               source="teem: 3D-left-handed")
nrrd_text_case("left-handed-spacings", ["type: int16", *SIZES, "space: 3D-left-handed", "spacings: 1.5 1.6 1.7", "axis mins: 3 4 5",
                                        "endian: little", "encoding: raw"],
               steps=(1.5, 1.6, -1.7), first=(3.0, 4.0, -5.0), told=("left-handed",), source="teem: 3D-left-handed, no directions")
nrrd_text_case("ras-spacings", ["type: int16", *SIZES, "space: RAS", "spacings: 1.5 1.6 1.7", f"space origin: {vector(RAS.origin * [-1, -1, 1])}",
                                "endian: little", "encoding: raw"], RAS.sample().tobytes(order="F"), told=("turned from RAS",),
               source="teem: axes of RAS, no directions")
nrrd_text_case("maxs-alone", ["type: int16", *SIZES, "spacings: 1.5 1.6 nan", "axis maxs: nan nan 70", "endian: little", "encoding: raw"],
               told=("1 mm is assumed",), steps=(1.5, 1.6, 1.0), source="teem: axis maxs without axis mins")
nrrd_text_case("quoted-units", ["type: int16", *SIZES, "space: LPS", f"space directions: {' '.join(vector(c / 10) for c in GRID.affine[:3, :3].T)}",
                                f"space origin: {vector(GRID.origin / 10)}", 'space units: "cm" "cm" "cm"', "endian: little",
                                "encoding: raw"], source="teem: space units are quoted")
nrrd_text_case("units-differ", ["type: int16", *SIZES, "space: LPS",
                                f"space directions: {' '.join(vector(c * [1, 1, 1000]) for c in GRID.affine[:3, :3].T)}",
                                f"space origin: {vector(GRID.origin * [1, 1, 1000])}", 'space units: "mm" "mm" "um"', "endian: little",
                                "encoding: raw"], told=("unit um",), source="teem: a unit for each axis of space")
nrrd_text_case("nan-spacing", ["type: int16", *SIZES, "spacings: 1.5 1.6 nan", "endian: little", "encoding: raw"],
               told=("1 mm is assumed",), steps=(1.5, 1.6, 1.0), source="teem: an unknown spacing is nan")
nrrd_text_case("spacing-negative", ["type: int16", *SIZES, "spacings: 1.5 1.6 -1.7", "endian: little", "encoding: raw"],
               refused="spacing is no finite number above zero", source="teem allows negative spacings")
nrrd_text_case("rgb-color", ["type: uint8", "dimension: 4", "sizes: 3 44 40 42", "kinds: RGB-color domain domain domain", "space: LPS",
                             "space directions: none " + PLACE[0].split(": ")[1], PLACE[1], "encoding: raw"],
               np.repeat(np.round(GRID.sample(float) * 0.2 + 210.0).astype(np.uint8).ravel(order="F"), 3).tobytes(),
               scale=0.2, offset=210.0, options=("--preset", "histogram"), told=("of 3 components the first one is used",), source="teem: RGB-color")
nrrd_text_case("without-endian", ["type: int16", *SIZES, "space: LPS", *PLACE, "encoding: raw"], told=("no order of bytes",),
               source="teem: endian is needed for samples of several bytes")


# MetaImage

UM = Grid(spacing=tuple(1000.0 * step for step in GRID.spacing), at_centre=1000.0 * CENTRE)
for name, kind in (("", np.int16), ("-of-int64", np.int64)):
    meta_case(f"distance-units{name}", lambda kind=kind: itk_image(UM, GRID.sample(kind)), told=("unit um",),
              change=replace((b"NDims = 3\n", b"NDims = 3\nDistanceUnits = um\n")), source="MetaIO: DistanceUnits")
meta_case("big-endian", lambda: itk_image(voxels=GRID.sample().byteswap()),
          change=replace((b"BinaryDataByteOrderMSB = False", b"BinaryDataByteOrderMSB = True")), source="MetaIO")
meta_case("names-of-old", itk_image, change=replace((b"Offset = ", b"Position = "), (b"TransformMatrix = ", b"Orientation = ")),
          source="MetaIO: Position, Origin, Rotation and Orientation are other names")
meta_case("element-size-alone", itk_image, change=replace((b"ElementSpacing = ", b"ElementSize = ")), source="MetaIO: ElementSize")
meta_case("intensity-scale", itk_image, change=replace((b"NDims = 3\n", b"NDims = 3\nElementToIntensityFunctionSlope = 2\nElementToIntensityFunctionOffset = -1000\n")),
          told=("ElementToIntensityFunction",), source="MetaIO; ITK does not use it either")
meta_case("ascii", itk_image, "head.mha", change=lambda path: path.write_bytes(
    path.read_bytes().split(b"ElementDataFile")[0].replace(b"BinaryData = True", b"BinaryData = False") +
    b"ElementDataFile = LOCAL\n" + b" ".join(str(x).encode() for x in GRID.sample().ravel(order="F"))), source="MetaIO: BinaryData = False")


@case("meta-header-size", source="MetaIO: HeaderSize = -1, samples are at the end of the file")
def header_size(folder):
    folder.mkdir(parents=True, exist_ok=True)
    SimpleITK.WriteImage(itk_image(), str(folder / "head.mhd"))
    raw = folder / "head.raw"
    raw.write_bytes(b"some other header" + raw.read_bytes())
    text = (folder / "head.mhd").read_text()
    (folder / "head.mhd").write_text(text.replace("ElementDataFile", "HeaderSize = -1\nElementDataFile"))
    return folder / "head.mhd"


def meta_slices(name, line):
    @case(f"meta-{name}", source="MetaIO: ElementDataFile = LIST, or a pattern")
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        SimpleITK.WriteImage(itk_image(), str(folder / "head.mhd"))
        names = [f"slice{k:03d}.raw" for k in range(GRID.size[2])]
        for k, one in enumerate(names):
            GRID.sample()[:, :, k].T.astype("<i2").tofile(folder / one)
        text = (folder / "head.mhd").read_text().replace("ElementDataFile = head.raw", line(names))
        (folder / "head.mhd").write_text(text)
        (folder / "head.raw").unlink()
        return folder / "head.mhd"


meta_slices("files-listed", lambda names: "\n".join(["ElementDataFile = LIST", *names]))
meta_slices("files-numbered", lambda names: f"ElementDataFile = slice%03d.raw 0 {len(names) - 1} 1")


# TIFF

tiff_case("predictor", compression="zlib", predictor=True, **CUBES)
tiff_case("float-predictor", UNSIGNED.astype(np.float32), compression="zlib", predictor=True, **CUBES)
tiff_case("float16", UNSIGNED.astype(np.float16), metadata=None, refused="16 bits")
tiff_case("int8", np.round(GRID.sample(float) * 0.1).astype(np.int8), 0.1, 0.0, **CUBES)
tiff_case("zstd", compression="zstd", **CUBES)
tiff_case("lzma", compression="lzma", **CUBES)
tiff_case("imagej-inch", imagej=True, resolution=(25.4 / 1.5, 25.4 / 1.6), metadata={"spacing": 1.7 / 25.4, "unit": "inch", "axes": "ZYX"})
tiff_case("imagej-nm", imagej=True, resolution=(1e-6 / 1.5, 1e-6 / 1.6), metadata={"spacing": 1.7e6, "unit": "nm", "axes": "ZYX"})
tiff_case("imagej-micro-escaped", imagej=True, resolution=(0.001 / 1.5, 0.001 / 1.6),
          metadata={"spacing": 1700.0, "unit": "\\u00B5m", "axes": "ZYX"}, source="ImageJ escapes the micro sign")
tiff_case("imagej-pixel", imagej=True, resolution=(1.0, 1.0), metadata={"spacing": 1.0, "unit": "pixel", "axes": "ZYX"},
          steps=(1.0, 1.0, 1.0), told=("voxel|distance|cubes",))
tiff_case("imagej-negative-spacing", imagej=True, resolution=(1.0 / 1.5, 1.0 / 1.6), metadata={"spacing": -1.7, "unit": "mm", "axes": "ZYX"},
          source="Fiji writes negative spacings for stacks from top to bottom", told=())


@case("tiff-rgb", refused="3 samples a pixel")
def tiff_rgb(folder):
    folder.mkdir(parents=True, exist_ok=True)
    grey = np.round(0.2 * GRID.sample(float) + 210.0).astype(np.uint8).transpose(2, 1, 0)
    tifffile.imwrite(folder / "stack.tif", np.repeat(grey[..., None], 3, axis=3), photometric="rgb")
    return folder / "stack.tif"


@case("tiff-min-is-white", refused="inverted", source="TIFF 6: PhotometricInterpretation 0")
def min_is_white(folder):
    folder.mkdir(parents=True, exist_ok=True)
    grey = np.round(0.2 * GRID.sample(float) + 210.0).astype(np.uint8).transpose(2, 1, 0)
    tifffile.imwrite(folder / "stack.tif", 255 - grey, photometric="miniswhite")
    return folder / "stack.tif"


@case("tiff-mask-of-one-bit", refused="have 1 bits")
def one_bit(folder):
    folder.mkdir(parents=True, exist_ok=True)
    tifffile.imwrite(folder / "stack.tif", (GRID.sample(float) > -470.0).transpose(2, 1, 0), photometric="minisblack")
    return folder / "stack.tif"


@case("tiff-pyramid", steps=(1.5, 1.6, 1.7), offset=1000.0, options=("--preset", "histogram"), source="OME-TIFF's SubIFDs")
def pyramid(folder):
    folder.mkdir(parents=True, exist_ok=True)
    pages = UNSIGNED.transpose(2, 1, 0)
    with tifffile.TiffWriter(folder / "stack.ome.tif", ome=True) as writer:
        options = {"photometric": "minisblack"}
        writer.write(pages, subifds=1, metadata={"axes": "ZYX", "PhysicalSizeX": 1.5, "PhysicalSizeXUnit": "mm", "PhysicalSizeY": 1.6,
                     "PhysicalSizeYUnit": "mm", "PhysicalSizeZ": 1.7, "PhysicalSizeZUnit": "mm"}, **options)
        writer.write(pages[:, ::2, ::2], subfiletype=1, **options)
    return folder / "stack.ome.tif"


@case("tiff-folder-with-another-size-second", refused="several sizes or types", source="a page, a picture, and the rest of the stack")
def another_size_second(folder):
    folder.mkdir(parents=True, exist_ok=True)
    pages = UNSIGNED.transpose(2, 1, 0)
    for k, written in enumerate((pages[0], pages[1, ::2, ::2], pages[1:])):
        tifffile.imwrite(folder / f"slice{k}.tif", written, photometric="minisblack")
    return folder


@case("tiff-folder-with-preview-first", steps=(1.0, 1.0, 1.0), offset=1000.0, options=("--preset", "histogram"),
      told=("1 TIFF pages .* left out",), source="TIFF 6.0, NewSubfileType: a reduced image")
def preview_first(folder):
    folder.mkdir(parents=True, exist_ok=True)
    tifffile.imwrite(folder / "slice000.tif", UNSIGNED[::2, ::2, 0].T, subfiletype=1)
    for k in range(GRID.size[2]):
        tifffile.imwrite(folder / f"slice{k + 1:03}.tif", UNSIGNED[:, :, k].T)
    return folder


@case("tiff-thumbnail-first", refused="the first page has its own", source="scanners write a small picture before the stack")
def thumbnail(folder):
    folder.mkdir(parents=True, exist_ok=True)
    with tifffile.TiffWriter(folder / "stack.tif") as writer:
        writer.write(np.zeros((9, 9), np.uint8), photometric="minisblack", metadata=None)
        for k in range(GRID.size[2]):
            writer.write(UNSIGNED[:, :, k].T, photometric="minisblack", metadata=None)
    return folder / "stack.tif"


@case("tiff-orientation-bottom-left", steps=(1.0, 1.0, 1.0), offset=1000.0, options=("--preset", "histogram"),
      source="TIFF 6: Orientation 4; tifffile and ImageJ read the rows as stored", told=(r"Orientation \(4\) is not used",))
def bottom_left(folder):
    folder.mkdir(parents=True, exist_ok=True)
    tifffile.imwrite(folder / "stack.tif", UNSIGNED.transpose(2, 1, 0), photometric="minisblack",
                     extratags=[(274, "H", 1, 4, False)])
    return folder / "stack.tif"


@case("tiff-folder-with-another-size", refused="slice20.tif, between others, has its own")
def other_page(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for k in range(GRID.size[2]):
        tifffile.imwrite(folder / f"slice{k + 1}.tif", UNSIGNED[:, :, k].T)
    tifffile.imwrite(folder / "slice20.tif", UNSIGNED[:20, :, 20].T)
    return folder


@case("tiff-folder-with-a-number-lost", steps=(1.0, 1.0, 1.0), offset=1000.0, options=("--preset", "histogram"), scale=0.0,
      told=("names of the slices have gaps",))
def number_lost(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for k in range(GRID.size[2]):
        if k != 20:
            tifffile.imwrite(folder / f"slice{k + 1}.tif", UNSIGNED[:, :, k].T)
    return folder


@case("tiff-folder-of-stacks", told=("files of several pages: they are put one behind the other",), scale=0.0,
      source="a folder with a stack for each time")
def stacks(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for time in range(3):
        tifffile.imwrite(folder / f"t{time}.tif", UNSIGNED.transpose(2, 1, 0), photometric="minisblack")
    return folder


# Zarr


@case("zarr-no-unit", source="OME-NGFF 0.4: the unit may be missing", told=("axes have no unit",))
def no_unit(folder):
    path = ngff(folder, "0.4")
    text = json.loads((path / ".zattrs").read_text())
    for axis in text["multiscales"][0]["axes"]:
        del axis["unit"]
    (path / ".zattrs").write_text(json.dumps(text))
    return path


@case("zarr-big-endian", steps=(1.0, 1.0, 1.0), source="Zarr 2: >i2", told=("voxel|spacing",))
def zarr_big(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype=">i2", chunks=(16, 16, 16), zarr_format=2)
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


@case("zarr-order-f", refused="order F", steps=(1.0, 1.0, 1.0), source="Zarr 2: Python reads it by open_large()")
def zarr_f(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype="i2", chunks=(16, 16, 16), zarr_format=2, order="F")
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


@case("zarr-transposed", refused="stored with transpose", steps=(1.0, 1.0, 1.0), source="Zarr 3")
def zarr_transposed(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype="i2", chunks=(16, 16, 16),
                             filters=[zarr.codecs.TransposeCodec(order=(2, 0, 1))])
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


@case("zarr-delta", refused="has filters", steps=(1.0, 1.0, 1.0), source="Zarr 2: Python reads it by open_large()")
def zarr_delta(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype="i2", chunks=(16, 16, 16), zarr_format=2,
                             filters=[numcodecs.Delta("i2")])
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


@case("zarr-missing-chunks", steps=(1.0, 1.0, 1.0), source="Zarr: a chunk that is not there is fill_value", told=("voxel|spacing",))
def zarr_missing(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype="i2", chunks=(8, 8, 8), fill_value=-1000)
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


for kind in ("bool", "float16", "complex64"):

    @case(f"zarr-{kind}", refused=f"is of type {kind}, which no volume has")
    def zarr_kind(folder, kind=kind):
        folder.mkdir(parents=True, exist_ok=True)
        made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype=kind, chunks=(16, 16, 16))
        made[...] = 1
        return folder / "head.zarr"


@case("zarr-axes-xyz", refused="axes are xyz, and a volume needs z, y and x, as the last ones", source="OME-NGFF 0.4 allows any order of space axes; z, y, x is recommended")
def zarr_xyz(folder):
    path = ngff(folder, "0.4")
    text = json.loads((path / ".zattrs").read_text())
    text["multiscales"][0]["axes"] = text["multiscales"][0]["axes"][::-1]
    (path / ".zattrs").write_text(json.dumps(text))
    return path


@case("zarr-in-a-zip", refused="packed folder", source="zarr-python's ZipStore")
def zarr_zip(folder):
    folder.mkdir(parents=True, exist_ok=True)
    with zarr.storage.ZipStore(folder / "head.zarr.zip", mode="w") as store:
        made = zarr.create_array(store, shape=GRID.size[::-1], dtype="i2", chunks=(16, 16, 16))
        made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr.zip"


@case("zarr-plate", refused="plate of wells", source="OME-NGFF: a plate of wells")
def zarr_plate(folder):
    folder.mkdir(parents=True, exist_ok=True)
    group = zarr.open_group(str(folder / "head.zarr"), mode="w", zarr_format=2)
    group.attrs["plate"] = {"columns": [{"name": "1"}], "rows": [{"name": "A"}], "wells": [{"path": "A/1"}]}
    return folder / "head.zarr"


# Files that the reader refuses because of their names.

for name, file, content, refused in (
        ("numpy", "head.npy", b"\x93NUMPY\1\0" + bytes(100), "NumPy array"),
        ("matlab", "head.mat", b"MATLAB 5.0 MAT-file" + bytes(200), "MATLAB file"),
        ("mrc", "head.mrc", bytes(208) + b"MAP DA\0\0" + bytes(2000), "density map"),
        ("microscope", "head.czi", b"ZISRAWFILE" + bytes(600), "microscope's own format"),
        ("raw", "head.raw", bytes(4000), "has no header"),
        ("hdf5", "head.h5", b"\x89HDF\r\n\x1a\n" + bytes(600), "is HDF5"),
        ("gifti", "head.gii", b"<?xml version='1.0'?><GIFTI/>", "surface of a brain")):
    refused_case(name, file, content, refused)
