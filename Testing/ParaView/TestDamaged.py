# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are cut off, lie about themselves, or hold grids that no mesher writes: ParaView goes on, and a sentence says
what is wrong, from the sources of the plugin, along a path, and live."""

import gzip
import os
import struct
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402

SIDE = 16
SAMPLES = struct.pack(f"<{SIDE ** 3}h", *range(SIDE ** 3))
CUBE = "0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1"


def vti(samples, extent=SIDE - 1):
    head = (f'<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><ImageData '
            f'WholeExtent="0 {extent} 0 {extent} 0 {extent}" Origin="0 0 0" Spacing="1 1 1"><Piece '
            f'Extent="0 {extent} 0 {extent} 0 {extent}"><PointData Scalars="HU"><DataArray type="Int16" Name="HU" format="appended" '
            'offset="0"/></PointData></Piece></ImageData><AppendedData encoding="raw">_')
    return head.encode() + struct.pack("<Q", 2 * (extent + 1) ** 3) + samples + b"</AppendedData></VTKFile>"


def nrrd(samples, side=SIDE):
    return (f"NRRD0004\ntype: short\ndimension: 3\nsizes: {side} {side} {side}\nspacings: 1 1 1\nencoding: raw\n"
            "endian: little\n\n").encode() + samples


def mha(samples, side=SIDE):
    return (f"ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nElementSpacing = 1 1 1\n"
            f"DimSize = {side} {side} {side}\nElementType = MET_SHORT\nElementDataFile = LOCAL\n").encode() + samples


def nifti(samples, side=SIDE):
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, side, side, side, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 4, 16)
    struct.pack_into("<8f", head, 76, 1, 1, 1, 1, 1, 1, 1, 1)
    struct.pack_into("<f", head, 108, 352)
    head[344:348] = b"n+1\0"
    return bytes(head) + samples


def grid(connectivity, offsets, types):
    """A grid of a unit cube's corners, whose cells may be anything."""
    lists = "".join(f'<DataArray type="{kind}" Name="{name}" format="ascii">{text}</DataArray>' for kind, name, text in (
        ("Int64", "connectivity", connectivity), ("Int64", "offsets", offsets), ("UInt8", "types", types)))
    return ('<VTKFile type="UnstructuredGrid" version="1.0" header_type="UInt64"><UnstructuredGrid>'
            f'<Piece NumberOfPoints="8" NumberOfCells="{len(types.split())}"><PointData Scalars="HU"><DataArray type="Float64" Name="HU" '
            'format="ascii">0 1 2 3 4 5 6 7</DataArray></PointData><Points><DataArray type="Float64" NumberOfComponents="3" '
            f'format="ascii">{CUBE}</DataArray></Points><Cells>{lists}</Cells></Piece></UnstructuredGrid></VTKFile>').encode()


HALF = SAMPLES[:len(SAMPLES) // 2]
VOLUMES = {
    "cut.vti": vti(HALF)[:-40],
    "lies.vti": vti(SAMPLES, 5000),
    "empty.vti": b"",
    "cut.nrrd": nrrd(HALF),
    "promises.nrrd": nrrd(SAMPLES, 20000),
    "cut.mha": mha(HALF),
    "promises.mha": mha(SAMPLES, 20000),
    "cut.nii": nifti(HALF),
    "promises.nii": nifti(SAMPLES, 30000),
    "cut.nii.gz": gzip.compress(nifti(SAMPLES))[:2000],
    "cut.tif": struct.pack("<2sHIHHHIIHHII", b"II", 42, 8, 2, 256, 4, 1, 60000, 257, 4, 1, 60000),
    "cut.vtkhdf": b"\x89HDF\r\n\x1a\n" + bytes(40),
    "cut.mnc": b"CDF\x01" + bytes(3),
}
GRIDS = {  # a cell's number of corners is the difference of two offsets; 12 is a hexahedron
    "no-corners.vtu": grid("", "0 0", "12 12"),
    "few-corners.vtu": grid("0 1 2", "3", "12"),
    "far-corner.vtu": grid("0 1 2 3 4 5 6 99999999", "8", "12"),
    "negative-corner.vtu": grid("0 1 2 3 4 5 6 -7", "8", "12"),
    "far-offset.vtu": grid("0 1 2 3 4 5 6 7", "800", "12"),
    "falling-offsets.vtu": grid("0 1 2 3 4 5 6 7", "8 -4", "12 12"),
}


def write(name, content):
    path = os.path.join(rig.OUTPUT, name)
    with open(path, "wb") as file:
        file.write(content)
    return path


def check_live(volume, name):
    """A device that starts on it says why there is nothing to feel, and gives no force."""
    status = []
    rig.report_of(lambda: status.append(touch_live(volume)))
    print(name, "live:", status[0], flush=True)
    assert "()" not in status[0] and "Ready" not in status[0], (name, status)
    assert any(words in status[0] for words in ("no image", "cell", "Input")), (name, status)


def touch_live(volume):
    touch = simple.VolumeHaptics(Input=volume, Preset="CT contrast")
    device = simple.HapticDevice(Touch=touch)
    device.Running = 1
    device.Armed = 1
    for _ in range(20):
        device.UpdatePipeline()
        time.sleep(0.005)
    device.UpdatePropertyInformation()
    status, force = "".join(device.GetPropertyValue("StatusText")), list(device.GetPropertyValue("ComputedForce"))
    device.Running = 0
    device.UpdatePipeline()
    for proxy in (device, touch):
        simple.Delete(proxy)
    assert force == [0, 0, 0], force
    return status


simple.LoadPlugin(rig.PLUGIN, remote=False, ns=vars(simple))
line = simple.HapticPath(Point1=[-2, 0.5, 0.5], Point2=[0.5, 0.5, 0.5])

for name, content in VOLUMES.items():
    path = write(name, content)
    for source in (simple.HapticVolume(), simple.HapticLargeFile()):
        if name.endswith(("nii", "gz")) and source.GetXMLName() == "HapticLargeFile":
            continue  # not a format of that one
        said = rig.report_of_update(source, FileName=path)
        print(name, source.GetXMLName(), said, flush=True)
        assert "ERR" in said and name in said, (name, source.GetXMLName(), said)
        assert "Cure" in said or said.rstrip().endswith("."), said
        assert source.GetDataInformation().GetNumberOfPoints() == 0, name
        check_live(source, name)
        simple.Delete(source)

for name, content in GRIDS.items():
    reader = simple.XMLUnstructuredGridReader(FileName=[write(name, content)])
    said = rig.report_of(reader.UpdatePipeline)
    touch = simple.VolumeHaptics(Input=reader, Path=line, Preset="CT contrast")
    said += rig.report_of(touch.UpdatePipeline)
    print(name, said, flush=True)
    assert "ERR" in said, (name, said)
    assert touch.GetDataInformation().GetNumberOfPoints() == 0, name
    check_live(reader, name)
    for proxy in (touch, reader):
        simple.Delete(proxy)

# ParaView must survive the damaged files: an intact file of each kind can still be touched.
for name, content in (("whole.vti", vti(SAMPLES)), ("whole.nrrd", nrrd(SAMPLES)), ("whole.mha", mha(SAMPLES)), ("whole.nii", nifti(SAMPLES))):
    source = simple.HapticVolume(FileName=write(name, content))
    assert "ERR" not in rig.report_of(source.UpdatePipeline) and source.GetDataInformation().GetNumberOfPoints() == SIDE ** 3, name
reader = simple.XMLUnstructuredGridReader(FileName=[write("whole.vtu", grid("0 1 2 3 4 5 6 7", "8", "12"))])
touch = simple.VolumeHaptics(Input=reader, Path=line, Preset="CT contrast")
assert "ERR" not in rig.report_of(touch.UpdatePipeline) and touch.GetDataInformation().GetNumberOfPoints() > 0
