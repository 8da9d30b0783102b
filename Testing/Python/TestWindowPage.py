# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the C++ blocks of window.md on other images, meshes, several windows and windows off the screen, and checks what
the page says of them. Their calls are the same in Python. Testing/Package/snippets.py compiles them as they stand."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest
import vtkmodules.vtkInteractionStyle  # noqa: F401 - the interactors of windows
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - the windows
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 - the mappers
import volumehaptics
from conftest import ROOT
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from volumehaptics import vtkHapticDevice, vtkHapticRepresentation, vtkInteractorStyleHaptic, vtkVolumeHapticsFilter

PAGE = (ROOT / "Documentation" / "window.md").read_text(encoding="utf-8")
CLASSES = {"vtkHapticRepresentation": vtkHapticRepresentation, "vtkInteractorStyleHaptic": vtkInteractorStyleHaptic}


def floor(height):
    """Returns an image of 40 x 40 x 40 mm that is solid below a height (mm)."""
    z = np.arange(41.0).reshape(-1, 1, 1)
    return volumehaptics.image(np.broadcast_to(100.0 * np.clip(height + 1.0 - z, 0.0, 2.0), (41, 41, 41)).copy())


class Window(dict):
    """A window of the page's names, with a volume whose floor is at z = 20."""

    def __init__(self):
        super().__init__(
            CLASSES, renderer=vtkRenderer(), window=vtkRenderWindow(), interactor=vtkRenderWindowInteractor(), volume=vtkVolume(),
            mapper=vtkGPUVolumeRayCastMapper(), touch=vtkVolumeHapticsFilter(), device=vtkHapticDevice(),
            style=vtkInteractorStyleHaptic(), image=floor(20.0))
        self["mapper"].SetInputData(self["image"])
        self["volume"].SetMapper(self["mapper"])
        self["renderer"].AddVolume(self["volume"])
        self["window"].SetOffScreenRendering(True)
        self["window"].AddRenderer(self["renderer"])
        self["interactor"].SetRenderWindow(self["window"])
        self["touch"].SetInputData(self["image"])
        self["device"].SetVolumeHaptics(self["touch"])
        self["device"].SetAttentionTime(0.0)
        assert self["device"].Open("virtual") and self["device"].Start()
        self["style"].SetDevice(self["device"])
        self["style"].SetDefaultRenderer(self["renderer"])
        self["interactor"].SetInteractorStyle(self["style"])

    def run_block(self, heading, number=0):
        block = re.findall(r"```cpp\n(.*?)```", PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0], re.DOTALL)[number]
        block = re.sub(r"vtkNew<(\w+)> (\w+);", r"\2 = \1()", block).replace("//", "#").replace("true", "True")
        exec(compile(block.replace("->", ".").replace(";", ""), heading, "exec"), self)

    def run(self, ticks=600):
        tick = self["device"].GetState().GetTick()
        while self["device"].GetState().GetTick() < tick + ticks:
            self["style"].UpdateHaptics()

    def press(self, z):
        """Arms the device, leads the tip from 5 mm above a height down to it, and returns the force upwards."""
        hand = self["device"].GetVirtualHand()
        hand.SetPosition(20.0, 20.0, z + 5.0)
        self.run(100)
        self["device"].Arm()
        self.run()
        for step in np.linspace(z + 5.0, z, 50):
            hand.SetPosition(20.0, 20.0, step)
            self.run(5)
        self.run()
        return self.force()

    def force(self):
        return self["device"].GetState().GetForce()[2]


@pytest.fixture
def scene():
    window = Window()
    yield window
    window["interactor"].SetInteractorStyle(None)
    window["device"].Close()


def test_another_image_is_felt_while_the_hand_presses(scene):
    scene["nextImage"] = floor(10.0)
    scene["style"].TouchVolume(scene["volume"])
    felt = scene.press(18.0)
    assert felt == pytest.approx(1.0, rel=0.2), "500 N/m, 2 mm below the floor"
    scene.run_block("Another image in the same window")
    scene.run()
    assert scene.force() == 0.0 and scene["device"].GetStatus() >= vtkHapticDevice.ARMED, "the floor is lower"
    scene["nextImage"] = None
    again = scene["image"]
    scene["mapper"].SetInputData(again)
    scene.run()
    assert scene["device"].GetStatus() >= vtkHapticDevice.ARMED, scene["device"].GetStatusText()


def test_a_mesh_is_felt_in_place_of_the_volume(scene):
    sphere = vtkSphereSource()
    sphere.SetCenter(20.0, 20.0, 20.0)
    sphere.SetRadius(15.0)
    sphere.SetThetaResolution(60)
    sphere.SetPhiResolution(60)
    sphere.Update()
    scene["mesh"] = sphere.GetOutput()
    assert scene.press(33.0) == 0.0, "the mesh is not felt yet"
    scene["device"].Disarm()
    scene.run_block("Meshes beside volumes")
    scene["device"].Publish()
    assert scene.press(33.0) == pytest.approx(1.0, rel=0.3), "500 N/m, 2 mm inside the sphere"


def test_windows_share_a_device(scene):
    other = Window()
    other["device"].Close()
    scene["otherRenderer"], scene["otherInteractor"] = other["renderer"], other["interactor"]
    scene.run_block("Several windows")
    for style in (scene["style"], scene["otherStyle"]):
        style.TouchModeOn()
        assert scene["device"].GetStatus() >= vtkHapticDevice.ARMED, "each of them begins the touch"
        style.TouchModeOff()
        scene.run(1000)
        assert scene["device"].GetStatus() < vtkHapticDevice.ARMED
    scene["otherStyle"].SetDevice(None)
    other["interactor"].SetInteractorStyle(None)


def test_a_program_leads_the_hand_off_the_screen(scene):
    scene.update(x=20.0, y=20.0, z=25.0)
    scene.run_block("Without a screen: EGL and OSMesa")
    scene.run()
    for scene["z"] in np.linspace(25.0, 18.0, 100):
        scene.run_block("Without a screen: EGL and OSMesa", 1)
        scene.run(5)
    scene.run()
    assert scene.force() == pytest.approx(1.0, rel=0.2)


@pytest.mark.skipif(vtkVersion.GetVTKMinorVersion() < 4, reason="VTK before 9.4 opens windows of X11 alone, unless built otherwise")
def test_windows_of_egl_need_no_display():
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    program = "import vtkmodules.vtkRenderingOpenGL2, vtkmodules.vtkRenderingCore as c; print(c.vtkRenderWindow().GetClassName())"
    shown = subprocess.run([sys.executable, "-c", program], env=environment, check=True, capture_output=True, text=True).stdout
    assert shown.strip() == "vtkEGLRenderWindow"
    subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", __file__, "-k", "not egl"], env=environment, check=True)
