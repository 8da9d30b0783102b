# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tools with a shape in touch(): meshes, files, a burr, and inputs that can't be a tool."""

import math
import re

import numpy as np
import pytest
from demonstration import run
from ramp import make_ramp
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter

import volumehaptics
from volumehaptics.arrays import arrays

RADIUS = 3.0
LEVEL = 800.0


def ball():
    sphere = vtkSphereSource()
    sphere.SetRadius(RADIUS)
    sphere.SetThetaResolution(200)
    sphere.SetPhiResolution(100)
    sphere.Update()
    return sphere.GetOutput()


def above():
    """Returns a material that is solid above the value LEVEL."""
    material = volumehaptics.vtkHapticProperty()
    material.GetSurfaceStrength().AddPoint(LEVEL - 1.0, 0.0)
    material.GetSurfaceStrength().AddPoint(LEVEL + 1.0, 5.0)
    return material


def press(tool):
    """Returns the force (N) with the hand 2 mm deep, and the trace."""
    down = np.linspace(4.0, LEVEL / 100.0 - RADIUS + 2.0, 100)
    depth = np.concatenate([down, np.full(60, down[-1])])
    tip = np.column_stack([np.full(160, 7.0), np.full(160, 7.0), depth])
    trace = volumehaptics.touch(make_ramp(16), tip, tool=tool, property=above())
    return arrays(trace)["Force"][-1, 2], trace


def expected():
    """Solves k (2 mm - delta) = pi kappa a delta^2, with 500 N/m and kappa = 500 N/m / 25 mm^2."""
    b = 500.0 / (math.pi * 2e7 * 1e-3 * RADIUS)
    delta = 0.5 * (math.sqrt(b * b + 4.0 * b * 2e-3) - b)
    return -500.0 * (2e-3 - delta)


def test_a_mesh_is_a_tool():
    force, trace = press(ball())
    assert force == pytest.approx(expected(), rel=0.01)
    felt = arrays(trace)
    assert felt["Torque"].shape == (160, 3)
    assert np.allclose(np.linalg.norm(felt["ToolOrientation"], axis=1), 1.0)


def test_a_file_is_a_tool(tmp_path):
    writer = vtkSTLWriter()
    writer.SetFileName(str(tmp_path / "ball.stl"))
    writer.SetInputData(ball())
    writer.Write()
    for name in (tmp_path / "ball.stl", str(tmp_path / "ball.stl")):
        force, _ = press(name)
        assert force == pytest.approx(expected(), rel=0.01)


def test_a_shell_of_ones_own_is_a_tool():
    shell = volumehaptics.vtkHapticPointShell()
    shell.SetMesh(ball())
    shell.SetNumberOfPoints(500)
    shell.SetSolidToAbove()
    shell.SetContactValue(LEVEL)
    force, _ = press(shell)
    assert force == pytest.approx(expected(), rel=0.02)
    assert shell.GetText() == "tool with a shape"


@pytest.mark.parametrize("name, words", [("no.stl", "no such file"), ("tool.step", "unknown extension")])
def test_files_that_are_no_tools(name, words):
    with pytest.raises(ValueError, match=words):
        press(name)


def test_a_file_without_a_surface(tmp_path):
    path = tmp_path / "empty.stl"
    path.write_text("solid empty\nendsolid empty\n")
    with pytest.raises(ValueError, match="no surface"):
        press(path)


def test_a_file_that_ends_its_reader_ends_nothing(tmp_path):
    """The file names texture coordinates that it does not have; VTK's reader looks for them and crashes."""
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 1 1\nv 2 4 2\nf 1/1/1 2/1/1 3/1/1\n")
    with pytest.raises(ValueError, match="no surface: its reader ended"):
        press(path)


def test_an_open_mesh_is_refused():
    plane = vtkPlaneSource()
    plane.Update()
    with pytest.raises(ValueError, match="is not closed"):
        press(plane.GetOutput())


@pytest.mark.parametrize("is_file", [False, True])
def test_a_spoon_lies_on_the_head(is_file, tmp_path):
    """The spoon turns by less than the hand goes around the head (1 rad), with the torque of its spring, 30 mN
    m/rad."""
    words = []
    if is_file:
        writer = vtkSTLWriter()
        writer.SetFileName(str(tmp_path / "ball.stl"))
        writer.SetInputData(ball())
        writer.Write()
        words = ["--tool", tmp_path / "ball.stl"]
    said = run("shaped_tool.py", tmp_path / "picture.png", *words)
    found = re.match(r"at most ([\d.]+) N, ([\d.]+) mN m, and ([\d.]+) degrees out of the hand", said)
    assert found, said
    force, torque, tilt = map(float, found.groups())
    assert 0.5 < force < 4.0, said
    assert torque == pytest.approx(30.0 * math.sin(math.radians(tilt)), abs=0.1), said
    assert (25.0 < tilt < 57.3) if not is_file else tilt < 57.3, said


def test_a_burr_removes_by_its_energy():
    """Checks Q = mu F v/U with the force F of the trace (Archard's law by energy)."""
    image = vtkImageData()
    image.SetDimensions(32, 32, 32)
    image.SetSpacing(0.5, 0.5, 0.5)
    image.GetPointData().SetScalars(numpy_to_vtk(np.repeat(1000.0 * (np.arange(32) > 15.5), 32 * 32), deep=True))
    burr = volumehaptics.vtkHapticBurr()
    burr.SetRadius(RADIUS)
    burr.SetSpeed(30000.0)
    burr.SetSolidToAbove()
    burr.SetContactValue(500.0)
    burr.GetSpecificEnergy().AddPoint(0.0, 5.0)
    depth = np.concatenate([np.linspace(4.0, 8.0, 2000), np.full(4000, 8.0)])
    tip = np.column_stack([np.full(6000, 7.1), np.full(6000, 7.2), depth])
    felt = arrays(volumehaptics.touch(image, tip, tool=burr, property=above()))
    rim = 2.0 * math.pi * 1e-3 * RADIUS * 30000.0 / 60.0
    expected_volume = 0.3 * rim * 1e-3 * felt["NormalForce"].sum() / 5.0
    assert expected_volume > 0.5
    assert felt["RemovedVolume"].sum() == pytest.approx(expected_volume, rel=0.02)
    # Assign a separate specific energy U to a label.
    labels = np.full((32, 32, 32), 3, np.uint8)
    felt = arrays(volumehaptics.touch(image, tip, tool=burr, property=above(), labels=labels,
                                      materials={3: dict(specific_energy=2.5)}))
    expected_volume = 0.3 * rim * 1e-3 * felt["NormalForce"].sum() / 2.5
    assert felt["RemovedVolume"].sum() == pytest.approx(expected_volume, rel=0.02)
    assert burr.GetText() == "burr"


def test_a_skull_is_drilled(tmp_path):
    said = run("drilling.py", tmp_path / "picture.png")
    found = re.match(r"(\d+) mm\^3 in (\d+) s, with ([\d.]+) N on average, ([\d.]+) N at most", said)
    assert found, said
    volume, _, average, most = map(float, found.groups())
    assert volume > 500.0, said
    assert 0.2 < average < most < 10.0, said


def test_settings_are_set_by_their_names():
    burr = volumehaptics.vtkHapticTool.Make("Burr")
    assert isinstance(burr, volumehaptics.vtkHapticBurr)
    assert burr.SetNumber("Radius", 3.0) and burr.GetRadius() == 3.0
    assert burr.SetNumber("ContactArea", 0.2) and burr.GetContactArea() == 0.2
    assert burr.GetFunction("SpecificEnergy") is burr.GetSpecificEnergy()
    assert not burr.SetNumber("LateralStrength", 1.0) and burr.GetFunction("CuttingForce") is None
    assert volumehaptics.vtkHapticTool.Make("Spoon") is None
