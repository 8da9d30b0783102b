# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes DICOM as scanners, archives and anonymisers do, by pydicom."""

import os
import shutil

import numpy as np

from cases import case
from phantom import CENTRE, Grid, turned, values
from pydicom import config, dcmwrite
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import (
    CTImageStorage,
    DeflatedExplicitVRLittleEndian,
    EnhancedCTImageStorage,
    ExplicitVRBigEndian,
    ExplicitVRLittleEndian,
    ImplicitVRLittleEndian,
    MRImageStorage,
    PositronEmissionTomographyImageStorage,
    RLELossless,
    RTDoseStorage,
    RTPlanStorage,
    RTStructureSetStorage,
    SecondaryCaptureImageStorage,
    SegmentationStorage,
    SpatialRegistrationStorage,
    TwelveLeadECGWaveformStorage,
    XRayRadiationDoseSRStorage,
    generate_uid,
)

config.settings.writing_validation_mode = config.IGNORE  # ignoring takes a quarter of the time
_PREFIX = "1.2.826.0.1.3680043.10.1.7."


def uid(*parts):
    """Returns a UID that is the same in each run."""
    return generate_uid(prefix=_PREFIX, entropy_srcs=[str(part) for part in parts])


def header(sop_class, modality, *names, syntax=ExplicitVRLittleEndian):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = sop_class
    meta.MediaStorageSOPInstanceUID = uid("instance", *names)
    meta.TransferSyntaxUID = syntax
    data = FileDataset(None, {}, file_meta=meta, preamble=b"\0" * 128)
    data.SOPClassUID = sop_class
    data.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    data.StudyInstanceUID = uid("study")
    data.SeriesInstanceUID = uid("series", names[0])
    data.FrameOfReferenceUID = uid("frame")
    data.PatientName = "Phantom"
    data.PatientID = "1"
    data.Modality = modality
    data.SeriesDescription = names[0]
    data.SeriesNumber = 1
    data.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
    return data


def put_pixels(data, plane, intercept=-1024.0, slope=1.0, bits=16, signed=False):
    """Stores `plane`: rows x columns (preceded by frames) of real values."""
    data.RescaleIntercept = f"{intercept:.10g}"
    data.RescaleSlope = f"{slope:.10g}"
    data.SamplesPerPixel = 1
    data.PhotometricInterpretation = "MONOCHROME2"
    data.Rows, data.Columns = plane.shape[-2:]
    data.BitsAllocated = bits
    data.BitsStored = bits
    data.HighBit = bits - 1
    data.PixelRepresentation = int(signed)
    stored = np.round((plane - intercept) / slope)
    kind = f"<{'i' if signed else 'u'}{bits // 8}"
    limits = np.iinfo(kind)
    assert limits.min <= stored.min() and stored.max() <= limits.max, "values don't fit"
    data.PixelData = stored.astype(kind).tobytes()


def slices(grid, name="head", sop_class=CTImageStorage, modality="CT", sampled=None, **pixels):
    """Yields a data set for each slice of a grid."""
    voxels = grid.sample(float) if sampled is None else sampled
    made = []
    for k in range(grid.size[2]):
        data = header(sop_class, modality, name, k)
        data.InstanceNumber = k + 1
        data.ImageOrientationPatient = [f"{number:.8f}" for number in (*grid.axes[:, 0], *grid.axes[:, 1])]
        position = grid.affine @ np.array([0.0, 0.0, k, 1.0])
        data.ImagePositionPatient = [f"{number:.6f}" for number in position[:3]]
        data.PixelSpacing = [f"{grid.spacing[1]:.6f}", f"{grid.spacing[0]:.6f}"]
        data.SliceThickness = f"{grid.spacing[2]:.6f}"
        put_pixels(data, voxels[:, :, k].T, **pixels)
        made.append(data)
    return made


def save(folder, data, name=None):
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / (name or f"IM{int(data.get('InstanceNumber', 1)):04}.dcm")
    if data.file_meta.TransferSyntaxUID == ExplicitVRBigEndian:
        dcmwrite(path, data, implicit_vr=False, little_endian=False, force_encoding=True)
    else:
        data.save_as(path, enforce_file_format=True)
    return path


def save_all(folder, sets):
    for data in sets:
        save(folder, data)
    return folder


GRID = Grid()


@case("dicom-plain")
def plain(folder):
    return save_all(folder, slices(GRID))


@case("dicom-signed")
def signed(folder):
    return save_all(folder, slices(GRID, intercept=0.0, signed=True))


@case("dicom-ybr-full-422", source="pydicom's SC_ybr_full_422_uncompressed.dcm: PS3.3 C.7.6.3.1.2, two pixels share differences",
      scale=0.2, offset=210.0, tolerance=1.6, told=("colours: their brightness is used",), options=("--preset", "histogram"))
def ybr_full_422(folder):
    sets = slices(GRID, sampled=np.round(0.2 * GRID.sample(float) + 210.0), intercept=0.0, bits=8)
    for data in sets:
        luminance = np.frombuffer(data.PixelData, np.uint8).reshape(-1, 2)
        data.PixelData = np.concatenate([luminance, np.full_like(luminance, 128)], axis=1).tobytes()
        data.SamplesPerPixel, data.PlanarConfiguration, data.PhotometricInterpretation = 3, 0, "YBR_FULL_422"
    return save_all(folder, sets)


@case("dicom-no-suffix")
def no_suffix(folder):
    for k, data in enumerate(slices(GRID)):
        save(folder, data, f"I{k}")
    return folder


@case("dicom-one-slice-named", source="README: a DICOM slice, for its series")
def one_slice_named(folder):
    save_all(folder, slices(GRID))
    return folder / "IM0003.dcm"


@case("dicom-folders-of-folders")
def folders_of_folders(folder):
    for k, data in enumerate(slices(GRID)):
        save(folder / f"S{k % 3}" / "DICOM", data, f"{k:08}")
    return folder


@case("dicom-name-with-spaces-and-accents")
def accents(folder):
    return save_all(folder / "Müller Kopf, 3 mm", slices(GRID))


def frame_case(name, axes, **facts):
    @case(f"dicom-{name}", **facts)
    def write(folder):
        return save_all(folder, slices(Grid(axes=axes)))


frame_case("sagittal", np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]).T @ np.eye(3))
frame_case("coronal", np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]))
frame_case("oblique", turned(30.0))
frame_case("head-to-feet", np.diag([1.0, -1.0, -1.0]), source="dcmstack#55")
frame_case("rows-from-the-left", np.diag([-1.0, -1.0, 1.0]))


@case("dicom-descending", source="Slicer#4409: the order of files says nothing")
def descending(folder):
    sets = slices(GRID)
    for k, data in enumerate(sets):
        data.InstanceNumber = len(sets) - k
    return save_all(folder, sets)


def tilt(name, degrees):
    @case(f"dicom-tilted-{name}", source="Slicer#4409, dcm2niix#253, cornerstone3D#227", told=("tilt|shear|slant",),
          tolerance=120.0, outside=True)
    def write(folder):
        # The slices stay parallel to x and rotate about it, while the table moves along z.
        angle = np.radians(degrees)
        row, column = np.array([1.0, 0.0, 0.0]), np.array([0.0, np.cos(angle), np.sin(angle)])
        grid = Grid(size=(44, 44, 50))
        sets = slices(grid)
        for k, data in enumerate(sets):
            corner = CENTRE + np.array([0.0, 0.0, (k - 24.5) * 1.7]) - row * 1.5 * 21.5 - column * 1.6 * 21.5
            i, j = np.meshgrid(np.arange(44), np.arange(44))
            points = corner + i[..., None] * 1.5 * row + j[..., None] * 1.6 * column
            data.ImageOrientationPatient = [f"{number:.8f}" for number in (*row, *column)]
            data.ImagePositionPatient = [f"{number:.6f}" for number in corner]
            data.GantryDetectorTilt = f"{-degrees:.1f}"
            put_pixels(data, values(points))
        return save_all(folder, sets)


tilt("20", 20.0)
tilt("minus-12", -12.0)


@case("dicom-lost-slice", source="dcmstack#55, panimg#7", told=("missing|lost|gap",), tolerance=400.0)
def lost_slice(folder):
    sets = slices(GRID)
    del sets[17]
    return save_all(folder, sets)


@case("dicom-2-mm-then-5-mm", source="VolView#291, Slicer#7339", told=("resampled|uneven|spacing",), tolerance=1100.0)
def uneven(folder):
    positions = np.concatenate([np.arange(-35.0, 1.0, 2.0), np.arange(5.0, 36.0, 5.0)])
    sets = slices(Grid(size=(44, 40, len(positions))))
    for z, data in zip(positions, sets):
        grid = Grid(size=(44, 40, 1), at_centre=CENTRE + [0.0, 0.0, z])
        data.ImagePositionPatient = [f"{number:.6f}" for number in grid.origin]
        put_pixels(data, grid.sample(float)[:, :, 0].T)
    return save_all(folder, sets)


@case("dicom-first-gap-is-the-mean", source="places 0, 2, 3, 6 steps", told=("resampled|missing",), tolerance=1100.0)
def first_gap(folder):
    sets = slices(Grid(size=(44, 40, 64), spacing=(1.5, 1.6, 1.0)))
    kept = [data for k, data in enumerate(sets) if k % 6 in (0, 2, 3)]
    return save_all(folder, kept)


@case("dicom-two-stacks-in-a-series", source="neck and pelvis", refused="several volumes in one series")
def two_stacks(folder):
    sets = slices(GRID)
    for data in sets[20:]:
        x, y, z = data.ImagePositionPatient
        data.ImagePositionPatient = [x, y, float(z) + 300.0]
    return save_all(folder, sets)


@case("dicom-values-of-a-micro-ct", source="PS3.3 C.8.2.1: rescaled values of a CT may be no HU", scale=10.0, offset=-5000.0,
      tolerance=8.0, options=("--preset", "histogram"), told=("not Hounsfield units",))
def micro_ct(folder):
    return save_all(folder, slices(GRID, sampled=10.0 * GRID.sample(float) - 5000.0, intercept=-32768.0))


@case("dicom-topogram-in-the-series", source="SlicerRT#272", told=("left out|not part|apart|away",))
def topogram(folder):
    sets = slices(GRID)
    far = slices(GRID)[0]
    far.InstanceNumber = len(sets) + 1
    far.SOPInstanceUID = far.file_meta.MediaStorageSOPInstanceUID = uid("topogram")
    far.ImageType = ["ORIGINAL", "PRIMARY", "LOCALIZER"]
    far.ImagePositionPatient = [*far.ImagePositionPatient[:2], float(far.ImagePositionPatient[2]) - 260.0]
    return save_all(folder, [*sets, far])


@case("dicom-positions-rounded", source="DATA.md: within rounding is even", tolerance=30.0)
def rounded(folder):
    sets = slices(GRID)
    for data in sets:
        data.ImagePositionPatient = [f"{float(number):.1f}" for number in data.ImagePositionPatient]
    return save_all(folder, sets)


@case("dicom-each-file-twice", source="rt-utils#122, dicom2nifti#21", told=("twice|copies|same",))
def twice(folder):
    sets = slices(GRID)
    save_all(folder / "a", sets)
    save_all(folder / "b", sets)
    return folder


@case("dicom-only-slice-location", source="dwv#586, dcm2niix#186", told=("SliceLocation|slice location",),
      steps=tuple(GRID.spacing), first=(0.0, 0.0, GRID.origin[2]))
def slice_location(folder):
    sets = slices(GRID)
    for data in sets:
        data.SliceLocation = data.ImagePositionPatient[2]
        del data.ImagePositionPatient, data.ImageOrientationPatient
    return save_all(folder, sets)


@case("dicom-no-position", source="dwv#586, dcm2niix#186", refused="ImagePositionPatient")
def no_position(folder):
    sets = slices(GRID)
    for data in sets:
        del data.ImagePositionPatient, data.ImageOrientationPatient, data.SliceThickness
    return save_all(folder, sets)


def dose(name, absolute, scale=2.5e-8):
    @case(f"dicom-rt-dose-{name}", source="dicompyler#78, amide#1; DICOM PS3.3 C.8.8.3.2: GridFrameOffsetVector",
          tolerance=1e-3, scale=0.05, offset=50.0, told=("doses in Gy",), options=("--preset", "histogram"))
    def write(folder):
        grid = GRID
        data = header(RTDoseStorage, "RTDOSE", "dose")
        data.DoseUnits, data.DoseType, data.DoseSummationType = "GY", "PHYSICAL", "PLAN"
        data.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
        data.ImagePositionPatient = [f"{number:.6f}" for number in grid.origin]
        data.PixelSpacing = [grid.spacing[1], grid.spacing[0]]
        data.NumberOfFrames = grid.size[2]
        offsets = grid.spacing[2] * np.arange(grid.size[2]) + (grid.origin[2] if absolute else 0.0)
        data.GridFrameOffsetVector = [f"{number:.6f}" for number in offsets]
        data.FrameIncrementPointer = 0x3004000C
        frames = np.moveaxis(50.0 + 0.05 * values(grid.points()), 2, 0).transpose(0, 2, 1)
        put_pixels(data, frames, intercept=0.0, slope=scale, bits=32)
        del data.RescaleIntercept, data.RescaleSlope
        data.DoseGridScaling = f"{scale:.10g}"
        return save(folder, data, "dose.dcm")


dose("relative", False)
dose("absolute", True)


@case("dicom-phases", source="SimpleITK#879, Weasis#701", told=("2 phases", "2 frames"))
def phases(folder):
    for phase in range(2):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            data.TemporalPositionIdentifier = phase + 1
            data.NumberOfTemporalPositions = 2
            data.InstanceNumber = phase * len(sets) + k + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("phase", phase, k)
        save_all(folder, sets)
    return folder


@case("dicom-phases-by-trigger-time", source="Weasis#701", told=("2 phases", "times 0 to 0.3 s"))
def trigger_time(folder):
    for phase in range(2):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            data.TriggerTime = f"{300.0 * phase:.1f}"
            data.InstanceNumber = 2 * k + phase + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("trigger", phase, k)
        save_all(folder, sets)
    return folder


def segmentation(grid, bits=1, overlapping=False):
    """Returns a SEG of two segments, the ball with its upper knob, and the left knob: PS3.3 C.8.20.2. If they overlap,
    the first segment also contains the left knob."""
    data = header(SegmentationStorage, "SEG", "seg")
    data.SegmentationType = "BINARY" if bits == 1 else "FRACTIONAL"
    body = grid.sample(float) > -470.0
    left = grid.points()[..., 0] > CENTRE[0] + 20.5
    masks = [body if overlapping else body & ~left, body & left]
    data.SegmentSequence = Sequence()
    for number, label in enumerate(("ball", "knob"), 1):
        segment = Dataset()
        segment.SegmentNumber, segment.SegmentLabel, segment.SegmentAlgorithmType = number, label, "MANUAL"
        code = Dataset()
        code.CodeValue, code.CodingSchemeDesignator, code.CodeMeaning = "T-D0050", "SRT", "Tissue"
        segment.SegmentedPropertyCategoryCodeSequence = Sequence([code])
        segment.SegmentedPropertyTypeCodeSequence = Sequence([code])
        data.SegmentSequence.append(segment)
    shared = Dataset()
    measures, orientation = Dataset(), Dataset()
    measures.PixelSpacing = [grid.spacing[1], grid.spacing[0]]
    measures.SliceThickness = measures.SpacingBetweenSlices = grid.spacing[2]
    orientation.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
    shared.PixelMeasuresSequence = Sequence([measures])
    shared.PlaneOrientationSequence = Sequence([orientation])
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    data.PerFrameFunctionalGroupsSequence = Sequence()
    frames = []
    for number, mask in enumerate(masks, 1):
        for k in range(grid.size[2]):
            if mask[:, :, k].any():  # empty frames are left out, as the standard allows
                item, place, which = Dataset(), Dataset(), Dataset()
                place.ImagePositionPatient = [f"{x:.6f}" for x in (grid.affine @ [0, 0, k, 1])[:3]]
                which.ReferencedSegmentNumber = number
                item.PlanePositionSequence = Sequence([place])
                item.SegmentIdentificationSequence = Sequence([which])
                data.PerFrameFunctionalGroupsSequence.append(item)
                frames.append(mask[:, :, k].T)
    data.NumberOfFrames = len(frames)
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.Rows, data.Columns = grid.size[1], grid.size[0]
    data.BitsAllocated = data.BitsStored = bits
    data.HighBit, data.PixelRepresentation = bits - 1, 0
    flat = np.array(frames, dtype=np.uint8).ravel()
    packed = np.packbits(flat, bitorder="little") if bits == 1 else 255 * flat
    if bits > 1:
        data.MaximumFractionalValue, data.SegmentationFractionalType = 255, "PROBABILITY"
    data.PixelData = packed.tobytes() + b"\0" * (len(packed) % 2)
    return data


for name, chosen, alone in (("body", "1", "body"), ("knob", "2", "knob")):

    @case(f"dicom-seg-overlapping-{name}", source="dcmqi#462: segments that overlap, of which one is wanted",
          labels=("ball", "knob"), alone=alone, options=("--series", chosen), told=(f"segment {chosen} .* is read alone",))
    def overlapping_segment(folder):
        return save(folder, segmentation(GRID, overlapping=True), "seg.dcm")


@case("dicom-seg-overlapping", source="dcmqi#462: segments that overlap", labels=("ball", "knob"),
      told=("voxels are in several segments: they belong to the one with the highest number; .* 1 to .* 2 read one",))
def overlapping_segments(folder):
    return save(folder, segmentation(GRID, overlapping=True), "seg.dcm")


@case("dicom-seg-overlapping-none", refused="has 2 segments, and none with the number 3", options=("--series", "3"))
def overlapping_none(folder):
    return save(folder, segmentation(GRID, overlapping=True), "seg.dcm")


@case("dicom-seg-beside-ct", source="dcmqi#462, OHIF#2164", told=("seg.dcm is a segmentation",))
def seg_beside(folder):
    save_all(folder, slices(GRID))
    save(folder, segmentation(Grid(size=(88, 80, 84), spacing=(0.75, 0.8, 0.85))), "seg.dcm")
    return folder


@case("dicom-capture-with-more-pixels", source="SlicerRT#272")
def capture(folder):
    save_all(folder, slices(GRID))
    data = header(SecondaryCaptureImageStorage, "XC", "capture")
    put_pixels(data, np.zeros((1024, 1024)), intercept=0.0)
    save(folder, data, "capture.dcm")
    return folder


@case("dicom-localizer-with-more-pixels", source="SlicerRT#272")
def localizer(folder):
    save_all(folder, slices(GRID))
    for k in range(2):
        data = slices(Grid(size=(512, 888, 1)), "scout", sampled=np.zeros((512, 888, 1)))[0]
        data.ImageType = ["ORIGINAL", "PRIMARY", "LOCALIZER"]
        data.InstanceNumber = k + 1
        data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("scout", k)
        data.ImageOrientationPatient = [[1, 0, 0, 0, 0, -1], [0, 1, 0, 0, 0, -1]][k]
        save(folder, data, f"scout{k}.dcm")
    return folder


def spacing_case(name, change, **facts):
    @case(f"dicom-{name}", source="cornerstoneWADOImageLoader#207", **facts)
    def write(folder):
        sets = slices(GRID)
        for data in sets:
            change(data)
        return save_all(folder, sets)


def only_imager_spacing(data):
    data.ImagerPixelSpacing = data.PixelSpacing
    del data.PixelSpacing


def no_spacing(data):
    del data.PixelSpacing


def comma_spacing(data):
    del data.PixelSpacing
    data.add_new(0x00280030, "LO", ["1,6", "1,5"])  # bytes of a wrong DS


spacing_case("only-imager-spacing", only_imager_spacing, told=("ImagerPixelSpacing|imager",))
spacing_case("no-pixel-spacing", no_spacing, refused="spacing|PixelSpacing")
spacing_case("comma-in-spacing", comma_spacing, refused="spacing|PixelSpacing")


def padding_case(number, tag):
    @case(f"dicom-padding-{-number}{'-in-tag' if tag else ''}", source="vtk-dicom#173, dcm2niix#262", outside=True,
          told=("outside",))
    def write(folder):
        voxels = GRID.sample(float)
        x = GRID.points()
        beside = np.hypot(x[..., 0] - CENTRE[0], x[..., 1] - CENTRE[1]) > 31.0  # the scanner's round field of view
        voxels[beside] = number
        sets = slices(GRID, sampled=voxels, intercept=0.0, signed=True)
        if tag:
            for data in sets:
                data.add_new(0x00280120, "SS", number)
        return save_all(folder, sets)


for padding in (-2000, -3024, -32768, -31744):
    padding_case(padding, False)
    padding_case(padding, True)


@case("dicom-mr-phase", source="DATA.md: Modality decides", scale=0.0, tolerance=5000.0)
def mr_phase(folder):
    voxels = np.round(4000.0 * np.sin(GRID.points()[..., 0] / 9.0))
    return save_all(folder, slices(GRID, "phase", MRImageStorage, "MR", voxels, intercept=-4096.0))


@case("dicom-mosaic", source="dcm2niix#482", refused="[Mm]osaic")
def mosaic(folder):
    data = slices(Grid(size=(264, 280, 1)), "mosaic", MRImageStorage, "MR", np.ones((264, 280, 1)), intercept=0.0)[0]
    data.ImageType = ["ORIGINAL", "PRIMARY", "M", "ND", "MOSAIC"]
    return save(folder, data, "mosaic.dcm")


def float_pixels(name, tag, vr, kind):
    @case(f"dicom-{name}", source="pydicom#452; PS3.3 C.7.6.24")
    def write(folder):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            del data.PixelData, data.RescaleIntercept, data.RescaleSlope
            data.BitsAllocated = 8 * np.dtype(kind).itemsize
            del data.BitsStored, data.HighBit, data.PixelRepresentation
            data.add_new(tag, vr, GRID.sample(kind)[:, :, k].T.tobytes())
        return save_all(folder, sets)


float_pixels("float-pixel-data", 0x7FE00008, "OF", "<f4")
float_pixels("double-float-pixel-data", 0x7FE00009, "OD", "<f8")


@case("dicom-linked-folder", source="DATA.md: linked folders")
def linked(folder):
    save_all(folder / "real", slices(GRID))
    (folder / "study").mkdir()
    os.symlink(folder / "real", folder / "study" / "series")
    return folder / "study"


@case("dicom-folder-linked-to-itself", source="DATA.md: linked folders")
def loop(folder):
    save_all(folder, slices(GRID))
    os.symlink(folder, folder / "again")
    return folder


@case("dicom-enhanced-beside-siblings", source="pydicom's rtdose.dcm in its folder")
def enhanced_beside(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    save(folder, data, "whole.dcm")
    shutil.copy(folder / "whole.dcm", folder / "copy of whole.dcm")
    save_all(folder, slices(GRID, "other"))
    return folder / "whole.dcm"


@case("dicom-one-damaged-another-named", source="DATA.md", told=("damaged|missing",),
      tolerance=400.0)
def damaged(folder):
    save_all(folder, slices(GRID))
    (folder / "IM0020.dcm").write_bytes((folder / "IM0020.dcm").read_bytes()[:900])
    return folder / "IM0003.dcm"


@case("dicom-foreign-file-in-the-folder", source="DATA.md")
def foreign(folder):
    save_all(folder, slices(GRID))
    (folder / "notes.dcm").write_text("no DICOM at all")
    (folder / ".DS_Store").write_bytes(b"\0\0\0\1Bud1")
    (folder / "Thumbs.db").write_bytes(bytes(range(256)))
    return folder / "IM0003.dcm"


@case("dicom-a-pipe-among-slices", source="mkfifo(1)", told=("aside is a pipe, not a file: left out",))
def pipe(folder):
    save_all(folder, slices(GRID))
    (folder / "export").mkdir()
    os.mkfifo(folder / "export" / "aside")
    return folder


@case("dicom-a-device-beside-a-named-slice", source="null(4)", told=("IM0099.dcm is a device or a socket, not a file: left out",))
def device(folder):
    save_all(folder, slices(GRID))
    os.symlink("/dev/zero", folder / "IM0099.dcm")
    return folder / "IM0003.dcm"


def bare_file(name, syntax):
    @case(f"dicom-{name}", source="pydicom's no_meta.dcm, ExplVR_LitEndNoMeta.dcm")
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        for k, data in enumerate(slices(GRID)):
            plain_set = Dataset(data)
            plain_set.save_as(folder / f"{k}.dcm", enforce_file_format=False,
                              implicit_vr=syntax.is_implicit_VR, little_endian=True)
        return folder


bare_file("no-meta-implicit", ImplicitVRLittleEndian)
bare_file("no-meta-explicit", ExplicitVRLittleEndian)


@case("dicom-no-preamble", source="old exports")
def no_preamble(folder):
    save_all(folder, slices(GRID))
    for path in folder.iterdir():
        path.write_bytes(path.read_bytes()[132:])
    return folder


def other_object(name, sop_class, modality, refused):
    @case(f"dicom-{name}-alone", source="DATA.md: called what they are", refused=refused)
    def write(folder):
        return save(folder, header(sop_class, modality, name), f"{name}.dcm")

    @case(f"dicom-{name}-beside-ct", source="DATA.md")
    def beside(folder):
        save_all(folder, slices(GRID))
        save(folder, header(sop_class, modality, name), f"{name}.dcm")
        return folder


other_object("rtplan", RTPlanStorage, "RTPLAN", "RT plan|RTPLAN|treatment plan")
other_object("rtstruct", RTStructureSetStorage, "RTSTRUCT", "RTSTRUCT|structure set|[Cc]ontours")
other_object("report", XRayRadiationDoseSRStorage, "SR", "report|SR")
other_object("waveform", TwelveLeadECGWaveformStorage, "ECG", "[Ww]aveform|ECG")
other_object("registration", SpatialRegistrationStorage, "REG", "[Rr]egistration|REG")


def syntax_case(name, syntax):
    @case(f"dicom-{name}")
    def write(folder):
        sets = slices(GRID)
        for data in sets:
            data.file_meta.TransferSyntaxUID = syntax
            if syntax == RLELossless:
                data.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
                data.compress(RLELossless)
            elif syntax == ExplicitVRBigEndian:
                data.PixelData = np.frombuffer(data.PixelData, "<u2").astype(">u2").tobytes()
        return save_all(folder, sets)


syntax_case("implicit", ImplicitVRLittleEndian)
syntax_case("big-endian", ExplicitVRBigEndian)
syntax_case("deflated", DeflatedExplicitVRLittleEndian)
syntax_case("rle", RLELossless)


@case("dicom-slope-per-slice", source="PET: PS3.3 C.8.9.4", scale=10.0, offset=10000.0, tolerance=8.0,
      options=("--preset", "histogram"))
def pet(folder):
    voxels = 10000.0 + 10.0 * GRID.sample(float)
    sets = slices(GRID, "pet", PositronEmissionTomographyImageStorage, "PT", voxels, intercept=0.0)
    for k, data in enumerate(sets):
        data.Units = "BQML"
        put_pixels(data, voxels[:, :, k].T, intercept=0.0, slope=1.0 + 0.01 * k)
    return save_all(folder, sets)


@case("dicom-12-bits-with-garbage-above", source="PS3.5 8.1.1: bits beyond BitsStored say nothing")
def garbage(folder):
    sets = slices(GRID)
    for data in sets:
        stored = np.frombuffer(data.PixelData, "<u2")
        data.BitsStored, data.HighBit = 12, 11
        data.PixelData = (stored | np.uint16(0x5000)).tobytes()
    return save_all(folder, sets)


@case("dicom-signed-12-bits-with-garbage-above", source="PS3.5 8.1.1")
def signed_garbage(folder):
    sets = slices(GRID, intercept=0.0, signed=True)
    for data in sets:
        stored = np.frombuffer(data.PixelData, "<u2")
        data.BitsStored, data.HighBit = 12, 11
        data.PixelData = (stored & np.uint16(0x0FFF) | np.uint16(0x5000)).tobytes()
    return save_all(folder, sets)


def enhanced(grid, order):
    data = header(EnhancedCTImageStorage, "CT", "enhanced")
    voxels = grid.sample(float)
    shared, measures, orientation, rescale = Dataset(), Dataset(), Dataset(), Dataset()
    measures.PixelSpacing = [grid.spacing[1], grid.spacing[0]]
    measures.SliceThickness = grid.spacing[2]
    orientation.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
    rescale.RescaleIntercept, rescale.RescaleSlope, rescale.RescaleType = -1024, 1, "HU"
    shared.PixelMeasuresSequence = Sequence([measures])
    shared.PlaneOrientationSequence = Sequence([orientation])
    shared.PixelValueTransformationSequence = Sequence([rescale])
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    data.PerFrameFunctionalGroupsSequence = Sequence()
    for k in order:
        item, place = Dataset(), Dataset()
        place.ImagePositionPatient = [f"{x:.6f}" for x in (grid.affine @ [0, 0, k, 1])[:3]]
        item.PlanePositionSequence = Sequence([place])
        data.PerFrameFunctionalGroupsSequence.append(item)
    put_pixels(data, np.stack([voxels[:, :, k].T for k in order]))
    del data.RescaleIntercept, data.RescaleSlope
    data.NumberOfFrames = len(list(order))
    return data


@case("dicom-enhanced")
def enhanced_plain(folder):
    return save(folder, enhanced(GRID, range(GRID.size[2])), "enhanced.dcm")


@case("dicom-enhanced-shuffled", source="PS3.3 C.7.6.16: positions place frames")
def enhanced_shuffled(folder):
    order = np.random.default_rng(7).permutation(GRID.size[2])
    return save(folder, enhanced(GRID, [int(k) for k in order]), "enhanced.dcm")


@case("dicom-overlapping-slices")
def overlapping(folder):
    sets = slices(Grid(spacing=(1.5, 1.6, 1.7)))
    for data in sets:
        data.SliceThickness = "5.0"
    return save_all(folder, sets)


@case("dicom-wrong-thickness", source="PS3.3 C.7.6.2.1.1: positions, not SliceThickness, place slices")
def wrong_thickness(folder):
    sets = slices(GRID)
    for data in sets:
        data.SliceThickness = "0.625"
        data.SpacingBetweenSlices = "0.625"
    return save_all(folder, sets)


@case("dicom-monochrome1", source="PS3.3 C.7.6.3.1.2: inverts what is shown, not what was measured")
def monochrome1(folder):
    sets = slices(GRID)
    for data in sets:
        data.PhotometricInterpretation = "MONOCHROME1"
    return save_all(folder, sets)


@case("dicom-two-series", source="--series N")
def two_series(folder):
    save_all(folder / "a", slices(GRID))
    save_all(folder / "b", slices(Grid(size=(20, 20, 20)), "small"))
    return folder


@case("dicom-single-slice", refused="single slice|one slice")
def single(folder):
    return save_all(folder, slices(GRID)[:1])


@case("dicom-sizes-differ", told=("21 slices of 30 x 30",), scale=0.0)
def sizes_differ(folder):
    sets = slices(GRID)
    other = slices(Grid(size=(30, 30, 42)))
    return save_all(folder, sets[:21] + other[21:])


@case("dicom-pixels-cut-off", refused="damaged|cut off|truncated|announces|fewer|short")
def cut_off(folder):
    save_all(folder, slices(GRID))
    path = folder / "IM0010.dcm"
    path.write_bytes(path.read_bytes()[:-1000])
    return folder


@case("dicom-no-rescale", source="raw numbers of a CT: + 1024", offset=1024.0)
def no_rescale(folder):
    sets = slices(GRID)
    for data in sets:
        del data.RescaleIntercept, data.RescaleSlope
    return save_all(folder, sets)




def seg_alone(name, bits):
    @case(f"dicom-seg-{name}-alone", source="dcmqi#462; liver_1frame.dcm of pydicom", labels=("ball", "knob"))
    def write(folder):
        return save(folder, segmentation(GRID, bits), "seg.dcm")


@case("dicom-seg-labelmap-palette", labels=("ball", "knob"), source="Supplement 243: a label map may be PALETTE COLOR")
def seg_labelmap(folder):
    data = segmentation(GRID, bits=8)
    data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.66.7"
    body = GRID.sample(float) > -470.0
    labels = np.where(body, 1 + (GRID.points()[..., 0] > CENTRE[0] + 20.5), 0).transpose(2, 1, 0)
    data.PerFrameFunctionalGroupsSequence = Sequence()
    for k in range(GRID.size[2]):
        item, place = Dataset(), Dataset()
        place.ImagePositionPatient = [f"{x:.6f}" for x in (GRID.affine @ [0, 0, k, 1])[:3]]
        item.PlanePositionSequence = Sequence([place])
        data.PerFrameFunctionalGroupsSequence.append(item)
    data.SegmentationType, data.PhotometricInterpretation = "LABELMAP", "PALETTE COLOR"
    for color in ("Red", "Green", "Blue"):
        setattr(data, f"{color}PaletteColorLookupTableDescriptor", [3, 0, 16])
        setattr(data, f"{color}PaletteColorLookupTableData", np.array([0, 30000, 60000], "<u2").tobytes())
    data.NumberOfFrames, data.PixelData = GRID.size[2], labels.astype(np.uint8).tobytes()
    return save(folder, data, "seg.dcm")


@case("dicom-seg-spacing-negative", labels=("ball", "knob"),
      source="PS3.3 C.7.6.2: SpacingBetweenSlices may be negative where slices follow each other against the normal")
def seg_negative(folder):
    data = segmentation(GRID)
    measures = data.SharedFunctionalGroupsSequence[0].PixelMeasuresSequence[0]
    measures.SpacingBetweenSlices, measures.SliceThickness = -GRID.spacing[2], 0.5 * GRID.spacing[2]
    return save(folder, data, "seg.dcm")


seg_alone("binary", 1)
seg_alone("fractional", 8)

