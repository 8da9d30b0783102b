# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--web FILE shows a volume where the file places it. The files are written here byte by byte, as MetaImage (itk.org,
MetaIO) and NIfTI-1 (nifti1.h) are defined; the expected positions follow from these definitions."""

import gzip
import struct

import numpy as np
import pytest

pv = pytest.importorskip("pyvista", reason="needs PyVista: pip install pyvista")
web = pytest.importorskip("volumehaptics.web", reason="needs trame: pip install trame trame-vuetify trame-rca")
import volumehaptics  # noqa: E402 after the skip
from volumehaptics import _files  # noqa: E402
from volumehaptics.vtkVolumeHaptics import vtkHapticLabelTable  # noqa: E402

SIZE = (6, 7, 8)
BRIGHT = (1, 5, 2)  # index of the one voxel that is not 0
SPACING = (1.0, 1.5, 2.0)
ORIGIN = (10.0, -20.0, 30.0)
# The columns are the directions of the index axes in the world: mirrored; rotated by 90 degrees; rotated by 30 degrees
# about z and mirrored.
FRAMES = {
    "plain": np.eye(3),
    "mirrored": np.diag([-1.0, 1.0, 1.0]),
    "turned": np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]),
    "oblique": np.array([[np.cos(np.pi / 6), -np.sin(np.pi / 6), 0], [np.sin(np.pi / 6), np.cos(np.pi / 6), 0], [0, 0, -1.0]]),
}


def voxels():
    values = np.zeros(SIZE[::-1], dtype="<i2")
    values[BRIGHT[::-1]] = 1000
    return values.tobytes()


def write_meta_image(path, frame):
    words = {"ObjectType": "Image", "NDims": 3, "BinaryData": "True", "BinaryDataByteOrderMSB": "False",
             "TransformMatrix": " ".join(f"{number:.17g}" for number in frame.T.ravel()),
             "Offset": " ".join(map(str, ORIGIN)), "ElementSpacing": " ".join(map(str, SPACING)),
             "DimSize": " ".join(map(str, SIZE)), "ElementType": "MET_SHORT", "ElementDataFile": "LOCAL"}
    header = "".join(f"{key} = {value}\n" for key, value in words.items())
    path.write_bytes(header.encode() + voxels())
    return frame @ (np.array(SPACING) * BRIGHT) + ORIGIN  # left, posterior, superior


def write_nifti(path, frame):
    header = bytearray(348)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 4, 16)  # signed short (16 bits)
    struct.pack_into("<4f", header, 76, 1.0, *SPACING)
    struct.pack_into("<3f", header, 108, 352.0, 1.0, 0.0)  # offset of the voxels, slope, intercept
    header[123] = 2  # mm
    struct.pack_into("<hh", header, 252, 0, 1)  # sform of the scanner
    for row in range(3):
        struct.pack_into("<4f", header, 280 + 16 * row, *(frame[row] * SPACING), ORIGIN[row])
    header[344:348] = b"n+1\0"
    with (gzip.open if path.suffix == ".gz" else open)(path, "wb") as file:
        file.write(bytes(header) + bytes(4) + voxels())
    # NIfTI's world axes point right, anterior, superior; the volume's axes point left, posterior, superior.
    return np.diag([-1, -1, 1]) @ (frame @ (np.array(SPACING) * BRIGHT) + ORIGIN)


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize(("ending", "write"), [("mhd", write_meta_image), ("mha", write_meta_image),
                                               ("nii", write_nifti), ("nii.gz", write_nifti)])
def test_a_volume_lies_where_its_file_says(tmp_path, ending, write, frame):
    path = tmp_path / f"volume.{ending}"
    place = write(path, FRAMES[frame])
    image = pv.wrap(_files.read(path)[0])
    assert isinstance(image, pv.ImageData)
    assert sorted(image.dimensions) == sorted(SIZE)
    found = image.points[np.flatnonzero(image.active_scalars == 1000)]
    np.testing.assert_allclose(found, [place], atol=1e-4)


def test_what_is_shown_and_felt_is_the_volume_with_its_frame(window, tmp_path):
    path = tmp_path / "volume.mha"
    write_meta_image(path, FRAMES["oblique"])
    image = pv.wrap(_files.read(path)[0])
    haptics = web.make_plotter(image)
    try:
        direction = np.array(image.direction_matrix)
        assert not np.allclose(direction, np.eye(3))
        shown = next(actor for actor in haptics._plotter().actors.values() if isinstance(actor, pv.Volume))
        for used in (pv.wrap(haptics.filter.GetInputDataObject(0, 0)), pv.wrap(shown.mapper.GetInputDataObject(0, 0))):
            np.testing.assert_allclose(np.array(used.direction_matrix), direction)
            np.testing.assert_allclose(used.origin, image.origin)
        corners = np.array(image.points)
        np.testing.assert_allclose(shown.GetBounds(), np.stack([corners.min(0), corners.max(0)], 1).ravel(), atol=1e-6)
    finally:
        haptics.close()


def test_labels_of_a_file_are_felt_as_labels(window):
    numbers = np.zeros((12, 12, 12), np.uint16)
    numbers[2:10, 2:10, 2:6], numbers[2:10, 2:10, 6:10] = 1, 30
    image = pv.wrap(volumehaptics.image(numbers, name="Labels"))
    table = vtkHapticLabelTable()
    table.SetLabelName(1, "skin")
    table.SetLabelName(30, "bone")
    table.WriteFieldData(image.GetFieldData())
    haptics = web.make_plotter(image)
    try:
        felt = haptics.filter.GetLabelTable()
        assert [felt.GetLabelName(number) for number in (1, 30)] == ["skin", "bone"]
        shown = next(actor for actor in haptics._plotter().actors.values() if isinstance(actor, pv.Volume))
        assert shown.prop.GetScalarOpacity().GetValue(1.0) > 0.9
        assert shown.prop.GetScalarOpacity().GetValue(0.0) == 0.0
    finally:
        haptics.close()


def test_what_can_not_be_read_is_told(tmp_path):
    (tmp_path / "head.doc").write_text("no volume", encoding="utf-8")
    with pytest.raises(ValueError, match="Cure"):
        _files.read(tmp_path / "head.doc")
