# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the contents of the installed wheel: it has all that it needs besides VTK's wheel, and no path of the machine that built it."""

import importlib.metadata
import os
import re
import struct
import subprocess
import sys
from pathlib import Path

import pytest

SITE = Path(os.environ["VOLUMEHAPTICS_BUILD"])
PACKAGE = SITE / "volumehaptics"
# Libraries that are present on every Linux with Python and OpenGL, and that PEP 600 also lists. GDCM's process needs
# libexpat; every manylinux system has it (PEP 599), so auditwheel leaves it out.
SYSTEM = re.compile(r"(ld-linux-x86-64|libc|libdl|libexpat|libgcc_s|libm|libpthread|librt|libstdc\+\+|libz)\.so\.\d+")

# Licences of the linked libraries and headers, as Debian's packages of these libraries state them.
LICENCES = {
    "boost": "BSL-1.0",
    "libblosc": "BSD-3-Clause AND MIT AND Zlib",
    "libcharls": "BSD-3-Clause",
    "libcrypto": "Apache-2.0",
    "libgdcm": "BSD-3-Clause AND Apache-2.0",
    "libgdcmjpeg": "IJG",
    "libhidapi": "BSD-3-Clause",
    "libjson": "MIT",
    "liblz4": "BSD-2-Clause",
    "libopenjp2": "BSD-2-Clause",
    "libsnappy": "BSD-3-Clause",
    "libudev": "LGPL-2.1-or-later",
    "libusb": "LGPL-2.1-or-later",
    "libuuid": "BSD-3-Clause",
    "libzstd": "BSD-3-Clause",
    "nlohmann": "MIT",
}


def binaries():
    return [path for path in [*SITE.glob("volumehaptics*/*.so*"), *PACKAGE.glob("bin/*")] if path.is_file()]


def dynamic(path):
    """Returns the libraries that a program or library needs, and the folders in which they are searched."""
    text = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", text)
    places = re.findall(r"\((?:RUNPATH|RPATH)\).*\[(.*)\]", text)
    return needed, places[0].split(":") if places else []


def test_has_what_is_promised():
    names = {path.name for path in binaries()}
    assert {"libvtkVolumeHaptics.so", "volumehaptics-device", "volumehaptics-explore", "volumehaptics-guard",
            "volumehaptics-dicom", "volumehaptics-read"} <= names
    for name in (
        "__main__.py", "data/HeadPhantom.vti", "py.typed", "udev/70-volume-haptics.rules", "vtkVolumeHaptics.pyi",
    ):
        assert (PACKAGE / name).is_file(), name
    hooks = importlib.metadata.distribution("volumehaptics").entry_points
    assert [(hook.group, hook.name) for hook in hooks if hook.group.startswith("pyvista")] == [
        ("pyvista.jupyter_backends", "haptics")]
    assert any("license" in str(file).lower() for file in importlib.metadata.files("volumehaptics"))


@pytest.mark.parametrize("path", binaries(), ids=lambda path: path.name)
def test_finds_all_libraries_beside_it(path):
    needed, places = dynamic(path)
    assert all(place.startswith("$ORIGIN") for place in places), places
    for library in needed:
        found = any((Path(place.replace("$ORIGIN", str(path.parent))) / library).exists() for place in places)
        assert found or SYSTEM.fullmatch(library), f"{path.name} needs {library}"


def test_carries_the_libraries_of_devices_and_codecs():
    """Expects that the kinds of devices which need a library are there, and report the error if no device is plugged in."""
    from volumehaptics import vtkHapticDevice

    carried = {path.name.split("-")[0] for path in SITE.glob("volumehaptics.libs/*")}
    assert {"libblosc", "libusb", "libhidapi", "libgdcmMSFF"} <= carried, carried
    notices = " ".join(path.name for path in PACKAGE.glob("licenses/*.txt"))
    packages = {re.sub("^libgdcm.*", "libgdcm", library.replace("libcrypto", "libssl")) for library in carried}
    assert all(package in notices for package in packages), (carried, notices)
    device = vtkHapticDevice()
    device.AddObserver("ErrorEvent", lambda *_: None)
    for name in ("falcon", "wooden", "haply"):
        assert not device.Open(name)
        assert "built without" not in device.GetStatusText(), device.GetStatusText()


def test_metadata_names_the_licences_of_what_is_inside():
    carried = {path.name.split("-")[0] for path in SITE.glob("volumehaptics.libs/*")} | {"boost", "nlohmann"}
    kinds = {re.sub(r"^libgdcm(jpeg)?.*", r"libgdcm\1", library) for library in carried}
    assert kinds <= LICENCES.keys(), kinds
    needed = {licence for kind in kinds for licence in LICENCES[kind].split(" AND ")} | {"BSD-3-Clause"}
    named = importlib.metadata.metadata("volumehaptics")["License-Expression"].split(" AND ")
    assert set(named) == needed and len(set(named)) == len(named), named


def test_names_no_place_of_the_machine_that_built_it():
    sources = str(Path(__file__).resolve().parents[2]).encode()
    for path in binaries():
        assert b"pip-build-env" not in path.read_bytes() and sources not in path.read_bytes(), path


def test_requires_its_own_vtk():
    from vtkmodules.vtkCommonCore import vtkVersion

    requirements = importlib.metadata.requires("volumehaptics")
    assert f"vtk=={vtkVersion.GetVTKVersion()}" in [text.replace(" ", "") for text in requirements]


def test_programs_run():
    for program, word in (("volumehaptics-explore", "--preset"), ("volumehaptics-device", "monitor")):
        command = [PACKAGE / "bin" / program, "--help"]
        run = subprocess.run(command, capture_output=True, text=True, check=False, cwd="/")
        assert word in run.stdout + run.stderr, (program, run)
        beside_python = Path(sys.executable).parent / program
        again = subprocess.run([beside_python, "--help"], capture_output=True, text=True, check=False, cwd="/")
        assert run.stdout + run.stderr in again.stdout + again.stderr and again.returncode == run.returncode, again
    run = subprocess.run([sys.executable, "-m", "volumehaptics"], capture_output=True, text=True, check=False, cwd="/")
    assert run.returncode == 2 and "Usage" in run.stderr


def write_slice(file, z):
    """Writes a slice of 8 x 8 pixels, by PS3.5 (implicit VR, little endian) and PS3.10. Its middle has the value 1000."""
    def element(group, number, value):
        value = value.encode() if isinstance(value, str) else value
        value += b"" if len(value) % 2 == 0 else b" "
        return struct.pack("<HHI", group, number, len(value)) + value

    syntax = struct.pack("<HH2sH", 2, 0x10, b"UI", 18) + b"1.2.840.10008.1.2\0"
    pixels = [1000 * (2 <= x < 6 and 2 <= y < 6 and 2 <= z < 6) for y in range(8) for x in range(8)]
    file.write_bytes(bytes(128) + b"DICM" + struct.pack("<HH2sHI", 2, 0, b"UL", 4, len(syntax)) + syntax + b"".join([
        element(8, 0x16, "1.2.840.10008.5.1.4.1.1.2"), element(8, 0x18, f"1.2.3.{z}"), element(8, 0x60, "CT"),
        element(0x20, 0xe, "1.2.3"), element(0x20, 0x32, f"0\\0\\{2 * z}"), element(0x20, 0x37, "1\\0\\0\\0\\1\\0"),
        element(0x28, 2, struct.pack("<H", 1)), element(0x28, 4, "MONOCHROME2"), element(0x28, 0x10, struct.pack("<H", 8)),
        element(0x28, 0x11, struct.pack("<H", 8)), element(0x28, 0x30, "3\\3"), element(0x28, 0x100, struct.pack("<H", 16)),
        element(0x28, 0x101, struct.pack("<H", 16)), element(0x28, 0x102, struct.pack("<H", 15)),
        element(0x28, 0x103, struct.pack("<H", 0)), element(0x7fe0, 0x10, struct.pack("<64H", *pixels))]))


def test_its_process_reads_grids():
    """Reads a file that would end this process if volumehaptics-read could not load the library."""
    from volumehaptics import _files

    with pytest.raises(ValueError, match="its reader ended"):
        _files.read(Path(__file__).resolve().parents[1] / "Data" / "FarPoint.vtk")


def test_reads_dicom_with_the_libraries_that_it_carries(tmp_path):
    import volumehaptics

    for z in range(8):
        write_slice(tmp_path / f"{z}.dcm", z)
    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(str(tmp_path))
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (8, 8, 8) and image.GetSpacing() == (3.0, 3.0, 2.0)
    assert [image.GetScalarComponentAsDouble(i, i, i, 0) for i in range(8)] == [0, 0, 1000, 1000, 1000, 1000, 0, 0]
    press = [[10.5, 10.5, z] for z in range(30, 6, -1)]
    force = volumehaptics.arrays.arrays(volumehaptics.touch(str(tmp_path), press, property=volumehaptics.vtkHapticProperty()))
    assert force["Force"][-1][2] > 0.1 and not force["Force"][0].any()
