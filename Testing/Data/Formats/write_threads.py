# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM as further public threads tell of it, by pydicom. `source` names each thread; where it complains of a wrong
volume, the case here is right at every voxel, and where nothing can be right, it is refused."""

import numpy as np
from cases import case
from phantom import Grid, values
from pydicom.dataset import Dataset
from pydicom.sequence import Sequence
from pydicom.uid import MRImageStorage, RTDoseStorage
from write_dicom import GRID, enhanced, header, put_pixels, save, save_all, segmentation, slices, uid


@case("dicom-names-in-reverse", source="Slicer/Slicer#7730: a file of a series named, whose names don't follow the slices")
def names_in_reverse(folder):
    for data in slices(GRID):
        save(folder, data, f"a{99 - data.InstanceNumber}.dcm")
    return folder / "a60.dcm"


@case("dicom-enhanced-in-stacks", source="rordenlab/dcm2niix#839: three interleaved stacks are one volume")
def in_stacks(folder):
    order = [k for stack in range(3) for k in range(stack, GRID.size[2], 3)]
    data = enhanced(GRID, order)
    for frame, (item, k) in enumerate(zip(data.PerFrameFunctionalGroupsSequence, order)):
        content = Dataset()
        content.StackID, content.InStackPositionNumber = str(k % 3 + 1), k // 3 + 1
        content.DimensionIndexValues = [k % 3 + 1, k // 3 + 1]
        content.FrameAcquisitionNumber = frame + 1
        item.FrameContentSequence = Sequence([content])
    return save(folder, data, "stacks.dcm")


@case("dicom-bits-differ", source="dgobbi/vtk-dicom#211: the outer slices have 8 bits, those in the middle 16",
      scale=0.1, offset=100.0, tolerance=0.2, options=("--preset", "histogram"))
def bits_differ(folder):
    voxels = 100.0 + 0.1 * GRID.sample(float)
    sets = slices(GRID, sampled=voxels, intercept=0.0, slope=0.01)
    for k in (0, 1, -2, -1):
        put_pixels(sets[k], voxels[:, :, k].T, intercept=0.0, slope=0.5, bits=8)
    return save_all(folder, sets)


@case("dicom-16-bits-8-stored", source="InsightSoftwareConsortium/ITK#851", scale=0.1, offset=100.0, tolerance=0.6,
      options=("--preset", "histogram"))
def eight_stored(folder):
    sets = slices(GRID, sampled=100.0 + 0.1 * GRID.sample(float), intercept=0.0)
    for data in sets:
        data.BitsStored, data.HighBit = 8, 7
    return save_all(folder, sets)


@case("dicom-perfusion", source="cornerstonejs/cornerstone3D#555: times of a CT perfusion, told by AcquisitionTime alone",
      told=("3 phases", "times 0 to 3 s"))
def perfusion(folder):
    for phase in range(3):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            data.AcquisitionTime = f"1059{58 + phase}.{10 * k:06}" if phase < 2 else f"110001.{10 * k:06}"
            data.InstanceNumber = phase * len(sets) + k + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("perfusion", phase, k)
            put_pixels(data, GRID.sample(float)[:, :, k].T + 10.0 * phase)
        save_all(folder, sets)
    return folder


@case("dicom-two-orientations", source="ivmartel/dwv#462, Slicer/Slicer#1007: axial and coronal slices in one series",
      told=("12 slices of 44 x 40",))
def two_orientations(folder):
    axial = slices(GRID)
    coronal = slices(Grid(size=(44, 40, 12), axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])))
    for k, data in enumerate(coronal):
        data.InstanceNumber = len(axial) + k + 1
        data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("coronal", k)
    return save_all(folder, [*axial, *coronal])


def frames(spacing_between):
    """All slices in a file of CT Image Storage, which may have one only, without the places of frames."""
    data = slices(GRID)[0]
    put_pixels(data, np.moveaxis(GRID.sample(float), 2, 0).transpose(0, 2, 1))
    data.NumberOfFrames = GRID.size[2]
    if spacing_between:
        data.SpacingBetweenSlices = f"{GRID.spacing[2]:.6f}"
    return data


@case("dicom-frames-with-a-spacing", source="Slicer/Slicer#6773: the third spacing was 1 instead")
def frames_with_spacing(folder):
    return save(folder, frames(True), "frames.dcm")


@case("dicom-frames-with-a-thickness", source="Slicer/Slicer#7496: thickness is no distance", refused="does not tell where")
def frames_with_thickness(folder):
    return save(folder, frames(False), "frames.dcm")


def complex_parts(name, parts, **facts):
    @case(f"dicom-{name}", **facts)
    def write(folder):
        for number, (kind, offset) in enumerate(parts):
            sets = slices(GRID, "complex", MRImageStorage, "MR", GRID.sample(float) + offset, intercept=-5000.0)
            for k, data in enumerate(sets):
                data.ImageType = ["ORIGINAL", "PRIMARY", kind, "ND"]
                data.InstanceNumber = number * len(sets) + k + 1
                data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid(kind, k)
            save_all(folder, sets)
        return folder


MAGNITUDE_AND_PHASE = (("M", 0.0), ("P", 2000.0))
complex_parts("magnitude-and-phase", MAGNITUDE_AND_PHASE, source="rordenlab/dcm2niix#219", told=("ImageType ORIGINAL.PRIMARY.P",))
complex_parts("the-phase-chosen", MAGNITUDE_AND_PHASE, source="rordenlab/dcm2niix#219", offset=2000.0, options=("--series", "2"))


@case("dicom-enhanced-slope-per-frame", source="pydicom/pydicom#2353: slope and intercept of each frame", scale=10.0,
      offset=10000.0, tolerance=8.0, options=("--preset", "histogram"))
def slope_per_frame(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    del data.SharedFunctionalGroupsSequence[0].PixelValueTransformationSequence
    voxels, stored = 10000.0 + 10.0 * GRID.sample(float), []
    for k, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        rescale = Dataset()
        rescale.RescaleIntercept, rescale.RescaleSlope, rescale.RescaleType = -k, f"{1.0 + 0.05 * k:.4g}", "US"
        item.PixelValueTransformationSequence = Sequence([rescale])
        stored.append(np.round((voxels[:, :, k].T + k) / (1.0 + 0.05 * k)))
    data.PixelData = np.array(stored).astype("<u2").tobytes()
    return save(folder, data, "slopes.dcm")


@case("dicom-padded-numbers", source="fo-dicom/fo-dicom#1078, Enet4/dicom-rs#618: numbers that end in a zero byte or blanks")
def padded_numbers(folder):
    save_all(folder, slices(GRID))
    for path in folder.iterdir():
        data = path.read_bytes()
        for number, padded in ((b"1.600000\\1.500000 ", b"1.600000\\1.500000\0"), (b"-1024 ", b"-1024\0")):
            assert number in data
            data = data.replace(number, padded)
        path.write_bytes(data)
    return folder


@case("dicom-seg-of-odd-frames", labels=("ball", "knob"),
      source="InsightSoftwareConsortium/ITK#6639, razorx89/pydicom-seg#53: frames of one bit begin anywhere in a byte, empty ones "
             "are left out")
def odd_frames(folder):
    return save(folder, segmentation(Grid(size=(43, 41, 42))), "seg.dcm")


@case("dicom-one-of-two-series-named", source="pyushkevich/itksnap#132: another series of the folder was opened")
def one_of_two_named(folder):
    for data in slices(Grid(size=(60, 60, 60)), "larger"):
        save(folder, data, f"a{data.InstanceNumber}.dcm")
    for data in slices(GRID, "meant"):
        save(folder, data, f"b{data.InstanceNumber}.dcm")
    return folder / "b7.dcm"


@case("dicom-one-number-for-two", source="pydicom/pydicom#173, InsightSoftwareConsortium/ITK#6639: a PixelSpacing of one number",
      refused="PixelSpacing")
def one_number(folder):
    sets = slices(GRID)
    for data in sets:
        data.PixelSpacing = None
        data.add_new(0x00280030, "LO", "1.6,1.5")  # a comma for the backslash
    return save_all(folder, sets)


@case("dicom-flipped-normal-of-a-dose", source="PS3.3 C.8.8.3.2: offsets are z in the patient, whatever the normal", scale=0.05,
      offset=50.0, tolerance=1e-3, told=("doses in Gy",), options=("--preset", "histogram"))
def flipped_dose(folder):

    grid = Grid(axes=np.diag([1.0, -1.0, 1.0]))  # rows to the left, columns to the front: the normal is to the feet
    data = header(RTDoseStorage, "RTDOSE", "dose")
    data.DoseUnits, data.DoseType, data.DoseSummationType = "GY", "PHYSICAL", "PLAN"
    data.ImageOrientationPatient = [1, 0, 0, 0, -1, 0]
    data.ImagePositionPatient = [f"{number:.6f}" for number in grid.origin]
    data.PixelSpacing = [grid.spacing[1], grid.spacing[0]]
    data.NumberOfFrames = grid.size[2]
    data.GridFrameOffsetVector = [f"{grid.origin[2] + grid.spacing[2] * k:.6f}" for k in range(grid.size[2])]
    doses = 50.0 + 0.05 * values(grid.points())
    put_pixels(data, np.moveaxis(doses, 2, 0).transpose(0, 2, 1), intercept=0.0, slope=2.5e-8, bits=32)
    del data.RescaleIntercept, data.RescaleSlope
    data.DoseGridScaling = "2.5e-08"
    return save(folder, data, "dose.dcm")


