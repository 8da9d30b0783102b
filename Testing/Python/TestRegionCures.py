# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures of errors about data that are read region by region, but not about one format: raw samples, files
that change, grids, and too little memory.
"""

import os
import subprocess
import sys

import numpy as np
import pytest
from TestLargeCures import ARRAY, raw_source, tiff
from TestLargeFiles import EXTENT, region_of
from cure_bench import Bench, Calls, told, try_calls
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_SHORT, VTK_STRING, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkDelaunay3D
from vtkmodules.vtkFiltersPoints import vtkPointInterpolator
from volumehaptics import vtkHapticRegionSource

result = Calls()


@result("Give the name of the file of samples", "Check the extent of the volume, its scalar type and the size of the header",
        "Set it to VTK_SHORT, VTK_FLOAT or another one", "Check its numbers", "Give an extent within WholeExtent")
def raw_files(folder):
    def refuses(source, word):
        with told(source, word):
            assert not source.ReadRegion(source.GetWholeExtent(), vtkImageData())

    path = folder / "a.raw"
    ARRAY.tofile(path)
    refuses(raw_source(folder), "Give the name of the file of samples")
    longer = raw_source(path, (*EXTENT[:4], EXTENT[4], EXTENT[5] + 1))
    refuses(longer, "Check the extent of the volume, its scalar type and the size of the header")
    longer.SetWholeExtent(*EXTENT)
    typed, counted = raw_source(path), raw_source(path, (0, 2**31 - 2) * 3)
    for wrong in (VTK_STRING, 77):
        typed.SetScalarType(wrong)
        refuses(typed, "Set it to VTK_SHORT, VTK_FLOAT or another one")
    typed.SetScalarType(VTK_SHORT)
    refuses(counted, "Check its numbers")
    counted.SetWholeExtent(*EXTENT)
    with told(typed, "Give an extent within WholeExtent"):
        assert not typed.ReadRegion((-9, -5, 0, 1, 0, 1), vtkImageData())
    for source in longer, typed, counted:
        assert np.array_equal(region_of(source, EXTENT), ARRAY)


@result("it has changed since it was opened. Open it again")
def changed_tiff(folder):
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(tiff(folder / "a.tif")))
    tiff(folder / "a.tif", t256=19, t279=19 * 24)
    with told(source, "it has changed since it was opened. Open it again"):
        assert not source.ReadRegion(source.GetWholeExtent(), vtkImageData())
    assert source.OpenFile(str(tiff(folder / "a.tif")))
    assert np.array_equal(region_of(source, source.GetWholeExtent()), ARRAY)


# Grids: V = 100 z, of 500 N/m, pressed 2 mm from z = 10 on.

def grid_of_points():
    cloud, z = vtkPoints(), []
    for k in range(0, 33, 4):
        for j in range(0, 25, 4):
            for i in range(0, 25, 4):
                cloud.InsertNextPoint(i, j, k + 0.01 * ((i + j) % 3))
                z.append(100.0 * (k + 0.01 * ((i + j) % 3)))
    grid, values = vtkUnstructuredGrid(), numpy_to_vtk(np.array(z), deep=True)
    values.SetName("V")
    grid.SetPoints(cloud)
    grid.GetPointData().SetScalars(values)
    return grid


def rectilinear(heights=32, name="V", components=1):
    grid = vtkRectilinearGrid()
    grid.SetDimensions(24, 17, heights)
    for axis, count in zip("XYZ", (24, 17, heights)):
        getattr(grid, f"Set{axis}Coordinates")(numpy_to_vtk(np.arange(float(count)), deep=True))
    values = np.repeat(100.0 * np.arange(float(heights)), 24 * 17 * components).reshape(-1, components)
    values = numpy_to_vtk(values, deep=True)
    values.SetName(name)
    grid.GetPointData().SetScalars(values)
    return grid


@result("for example with vtkDelaunay3D, or an image with vtkPointInterpolator",
        "Give it cells in three dimensions, or set another SampleSpacing",
        "Correct its cells, or make tetrahedra where they come from", "there is nothing to touch. Give it one",
        "Name one of these: ")
def grids(_):
    b = Bench()

    def refuses(grid, word, spacing=0.0):
        b.haptics.SetInputDataObject(0, grid)
        with told(b.haptics, word, b.haptics.GetExecutive()):
            b.haptics.Update()

    def feels(grid):
        b.haptics.SetInputDataObject(0, grid)
        assert b.force() == pytest.approx(1.0, abs=0.02)

    refuses(grid_of_points(), "for example with vtkDelaunay3D, or an image with vtkPointInterpolator")
    mesh, sampled = vtkDelaunay3D(), vtkPointInterpolator()
    mesh.SetInputData(grid_of_points())
    mesh.Update()
    false = vtkUnstructuredGrid()
    false.DeepCopy(mesh.GetOutput())
    false.GetCells().GetConnectivityArray().SetComponent(0, 0, 999999999)
    refuses(false, "Correct its cells, or make tetrahedra where they come from")
    feels(mesh.GetOutput())
    place = vtkImageData()
    place.SetDimensions(24, 17, 32)
    sampled.SetInputData(place)
    sampled.SetSourceData(grid_of_points())
    sampled.GetKernel().SetRadius(6.0)
    sampled.Update()
    b.haptics.SetInputDataObject(0, sampled.GetOutput())
    assert 0.5 < b.force() < 1.5  # within the blur of the kernel's radius
    refuses(rectilinear(1), "Give it cells in three dimensions, or set another SampleSpacing")
    feels(rectilinear())
    source = vtkHapticRegionSource()
    with told(source, "Give it cells in three dimensions, or set another SampleSpacing"):
        assert not source.OpenDataSet(rectilinear(), 1e-7)
    assert source.OpenDataSet(rectilinear(), 1.0)
    refuses(rectilinear(components=2), "there is nothing to touch. Give it one")
    feels(rectilinear())
    with told(source, "Name one of these: "):
        assert not source.OpenDataSet(rectilinear(), 1.0, "W")
    assert source.OpenDataSet(rectilinear(), 1.0, "V")


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)


# A process with little memory reads a file of 64 GiB, but touches only one layer. A region of 267^3 numbers takes 145
# MiB.
SCARCE = """
import resource, sys, time
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData
from volumehaptics import vtkHapticDevice, vtkHapticRegionSource, vtkVolumeHapticsFilter
from volumehaptics._touch import Errors

SIDE, LAYER = 2048, 900
with open(sys.argv[1], "wb") as file:
    for z, value in ((LAYER - 1, 5.0), (LAYER, 10.0), (LAYER + 1, 15.0)):
        file.seek(8 * SIDE * (SIDE * z + 1000))
        for row in range(30):
            file.write(np.full(SIDE, value).tobytes())
    file.truncate(8 * SIDE**3)
source = vtkHapticRegionSource()
source.SetFileName(sys.argv[1])
source.SetScalarType(VTK_DOUBLE)
source.SetWholeExtent(0, SIDE - 1, 0, SIDE - 1, 0, SIDE - 1)
source.SetMemoryLimit(4 << 20)
haptics = vtkVolumeHapticsFilter()
haptics.SetInputConnection(source.GetOutputPort())
haptics.SetMethodToForceField()
haptics.GetProperty().GetStiffness().AddPoint(0, 100)
device = vtkHapticDevice()
device.SetVolumeHaptics(haptics)
device.Open("virtual")

def wait(is_so, what):
    end = time.time() + 60
    while not is_so():
        assert time.time() < end, (what, device.GetStatusText())
        device.UpdateState()
        time.sleep(0.005)

device.GetVirtualHand().SetPosition(1000, 1015, 100)
assert device.Start()
wait(lambda: device.GetState().GetResidency() == 1.0, "what is around the tip is here")
with open("/proc/self/statm", encoding="ascii") as file:
    used = int(file.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (110 << 20), resource.getrlimit(resource.RLIMIT_AS)[1]))

image = vtkImageData()
with Errors(source) as errors:
    assert not source.ReadRegion(source.GetWholeExtent(), image)
assert len(errors) == 1 and "Read a smaller one" in errors[0], errors
assert source.ReadRegion((5, 9, 1003, 1004, LAYER, LAYER + 1), image)
assert sorted(set(vtk_to_numpy(image.GetPointData().GetScalars()))) == [10.0, 15.0]

with Errors(source) as errors:
    source.SetMemoryLimit(1 << 40)
    device.GetVirtualHand().SetPosition(1000, 1015, LAYER)
    wait(lambda: "bytes. Lower MemoryLimit" in source.GetStatusText(), "there is no memory for it")
    assert device.GetState().GetResidency() < 1.0
    source.SetMemoryLimit(4 << 20)
    wait(lambda: device.GetState().GetResidency() == 1.0 and not source.GetStatusText(), "a smaller region is here")
assert len(errors) == 1, errors
assert np.ptp(source.GetOutput().GetExtent()[4:]) < 60
device.Arm()
wait(lambda: device.GetState().GetForce()[2] < -0.01, "values rise along z, and a hand is pushed to lower ones")
device.Stop()
"""


def test_less_memory(tmp_path):
    # glibc reserves 64 MiB of addresses for each thread that allocates, which would leave no room for another thread
    # within the limit.
    env = {**os.environ, "MALLOC_ARENA_MAX": "1"}
    done = subprocess.run([sys.executable, "-c", SCARCE, str(tmp_path / "a.raw")], capture_output=True, text=True, timeout=300,
                          env=env)
    assert done.returncode == 0, done.stdout + done.stderr
