# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""add_haptics() works in windows of programs that keep their own style: windows of VTK itself, and objects shaped like
those of other libraries."""

import re
import time
import types
from pathlib import Path

import numpy
import pytest
import volumehaptics
from volumehaptics import _hosts
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkInteractionWidgets import vtkSliderRepresentation2D, vtkSliderWidget
from vtkmodules.vtkRenderingCore import (
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkTextActor,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  isort: skip
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  isort: skip

RADIUS = 30.0  # mm, of a ball in a cube of 96 mm


class Program:
    """A window off screen with a ball: the camera looks along -z, and a pixel is 0.2 mm."""

    def __init__(self):
        axis = numpy.arange(-48.0, 49.0)
        z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
        values = 100.0 * (RADIUS - numpy.sqrt(x * x + y * y + z * z))
        image = volumehaptics.image(values.astype(numpy.float32), origin=(-48.0, -48.0, -48.0))
        self.volume = vtkVolume()
        mapper = vtkFixedPointVolumeRayCastMapper()
        mapper.SetInputData(image)
        self.volume.SetMapper(mapper)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(-1.0, 0.0)
        opacity.AddPoint(1.0, 1.0)
        self.volume.GetProperty().SetScalarOpacity(opacity)
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.0, 0.0, 200.0)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(30.0)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(300, 300)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.style = vtkInteractorStyleTrackballCamera()
        self.interactor.SetInteractorStyle(self.style)

    def press(self, haptics):
        """Touches the middle of the ball with the key and the wheel; returns the largest force (N)."""
        self.interactor.SetEventInformation(150, 150)
        self.interactor.SetKeySym("t")
        self.interactor.InvokeEvent("KeyPressEvent")
        assert haptics.widget.GetTouchMode()
        force = 0.0
        end = time.monotonic() + 30.0
        steps = 0
        while force < 0.3 and time.monotonic() < end:
            if steps < 5:
                self.interactor.InvokeEvent("MouseWheelForwardEvent")
                steps += 1
            time.sleep(0.02)
            haptics.update()
            force = numpy.linalg.norm(haptics.device.GetState().GetForce())
        return force


@pytest.fixture
def program():
    return Program()


TARGETS = {
    "interactor": lambda p: p.interactor,
    "window": lambda p: p.window,
    "renderer": lambda p: p.renderer,
    "vedo.Plotter": lambda p: types.SimpleNamespace(interactor=p.interactor, window=p.window, renderer=p.renderer),
    "fury.window.ShowManager": lambda p: types.SimpleNamespace(iren=p.interactor, scene=p.renderer),
    # Traits objects return None for each name that begins with an underscore.
    "mayavi figure": lambda p: types.SimpleNamespace(scene=types.SimpleNamespace(
        _vtk_obj=None, interactor=types.SimpleNamespace(_vtk_obj=p.interactor))),
    "widget of Qt, Tk or wx": lambda p: types.SimpleNamespace(GetRenderWindow=lambda: p.window),
}


@pytest.mark.parametrize("target", TARGETS)
def test_one_line_makes_a_window_touchable(program, target):
    haptics = volumehaptics.add_haptics(TARGETS[target](program))
    assert program.press(haptics) > 0.3
    # The ball's surface (500 N/m) is visible at 30 mm and felt half a voxel inside.
    assert abs(numpy.linalg.norm(haptics.device.GetState().GetProxyPosition()) - RADIUS) < 0.51
    assert program.interactor.GetInteractorStyle() is program.style
    haptics.close()
    haptics.close()
    assert haptics.closed and not haptics.device.IsRunning()
    assert program.renderer.GetViewProps().GetNumberOfItems() == 1, "only the volume is left"


def test_the_line_of_the_page_does_it(program):
    page = Path(__file__).resolve().parents[2] / "Documentation" / "window.md"
    (block,) = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    names = {"volumehaptics": volumehaptics, "plotter": TARGETS["vedo.Plotter"](program)}
    exec(block, names)
    with names["haptics"] as haptics:
        assert program.press(haptics) > 0.3


def test_what_comes_back_has_the_parts_and_takes_settings(program):
    with volumehaptics.add_haptics(program.interactor, program.volume, "CT contrast", kernel_radius=3) as haptics:
        assert haptics.filter.GetKernelRadius() == 3
        assert haptics.filter is haptics.widget.GetVolumeHaptics()
        assert haptics.style.GetDevice() is haptics.device
        assert program.renderer.HasViewProp(haptics.representation)
        assert program.renderer.HasViewProp(haptics.head_up_display)
        assert haptics.style.GetTouchedVolume() is program.volume
        assert haptics.device.IsRunning()
    assert haptics.closed


def test_a_device_of_the_program_stays_open(program):
    device = volumehaptics.vtkHapticDevice()
    assert device.Open("virtual")
    with volumehaptics.add_haptics(program.interactor, device=device) as haptics:
        assert haptics.device is device
        assert program.press(haptics) > 0.3
    assert device.IsOpen()


def test_two_hands_on_one_volume(program, monkeypatch):
    attention = []
    open_one = _hosts.Haptics._open
    monkeypatch.setattr(_hosts.Haptics, "_open", lambda haptics, wanted, own: attention.append(own.GetAttentionTime())
                        or open_one(haptics, wanted, own))
    first, second = volumehaptics.vtkHapticDevice(), volumehaptics.vtkHapticDevice()
    assert first.Open("virtual") and second.Open("virtual")
    with volumehaptics.add_haptics(program.interactor, device=[first, second]) as haptics:
        assert haptics.device is first and haptics.second_device is second
        assert haptics.widget.GetSecondDevice() is second and not second.GetUseTool()
        assert second.IsRunning() and second.GetVolumeHaptics() is haptics.filter
        assert program.press(haptics) > 0.3
        haptics.style.UpdateHaptics()
        assert "Second hand: " in haptics.head_up_display.GetText()
        haptics.style.FadeOut()
        assert not haptics._holds
        second.Arm()
        assert haptics._holds
    assert attention == [10.0, 10.0]  # from devices that are opened by their ids, as from the widget's own
    assert second.IsOpen() and not second.IsRunning()
    for wrong, words in ((["virtual"], "give one, or "), (["falcon", "virtual"], r'device=\["virtual", the real one\]')):
        with pytest.raises(ValueError, match=words):
            volumehaptics.add_haptics(program.interactor, device=wrong)
    with volumehaptics.add_haptics(program.interactor, device=["virtual", second]) as haptics:  # the cure
        assert second.IsRunning()
    with pytest.raises(RuntimeError, match="nonsense"):
        volumehaptics.add_haptics(program.interactor, device=["virtual", "nonsense"])
    with pytest.raises(ValueError, match="which has one tip"):
        volumehaptics.add_haptics(program.interactor, device=[first, first])
    assert first.GetUseTool()


def test_what_leads_to_no_window_is_told_with_the_cure(program):
    with pytest.raises(TypeError, match=r"builtins\.dict leads to none.*Cure: give the vtkRenderWindowInteractor"):
        volumehaptics.add_haptics({})
    with pytest.raises(TypeError, match=r"What draws without VTK, as FURY 2 does, can't be touched"):
        volumehaptics.add_haptics({})
    lonely = vtkRenderWindowInteractor()
    with pytest.raises(TypeError, match=r"SetRenderWindow\(\)"):
        volumehaptics.add_haptics(lonely)
    lonely.SetRenderWindow(program.window)  # the cure
    with volumehaptics.add_haptics(lonely) as haptics:
        program.interactor = lonely
        assert program.press(haptics) > 0.3
    with pytest.raises(TypeError, match=r"builtins\.str\. Cure: give that volume, or none"):
        volumehaptics.add_haptics(program.window, "volume")
    with pytest.raises(RuntimeError, match="nonsense"):
        volumehaptics.add_haptics(program.window, device="nonsense")
    with pytest.raises(ValueError, match="no preset"):
        volumehaptics.add_haptics(program.window, preset="CT nonsense")


class Toolkit:
    """An event loop like that of VTK's wx widget: one timer that fires once and reports it to the interactor."""

    def __init__(self, program):
        self.interactor = program.interactor = vtkGenericRenderWindowInteractor()
        self.interactor.SetRenderWindow(program.window)
        self.interactor.SetInteractorStyle(program.style)
        self.interactor.AddObserver("CreateTimerEvent", self.start)
        self.is_started = False

    def start(self, *_):
        self.is_started = True

    def fire(self):
        if self.is_started:
            self.is_started = False
            self.interactor.TimerEvent()


class Loop:
    """What Program.press() updates."""

    def __init__(self, haptics, toolkit):
        self.widget, self.device, self.update = haptics.widget, haptics.device, toolkit.fire


def test_a_timer_that_fires_before_the_window_is_drawn_goes_on_afterwards(program):
    """wx's timers fire once. An interactor whose first frame has not yet enabled it ignores that event, so the timer
    must be started again."""
    toolkit = Toolkit(program)
    with volumehaptics.add_haptics(program.interactor) as haptics:
        toolkit.fire()  # ignored: VTK's GenericRenderWindowInteractor returns unless Enabled
        assert not toolkit.is_started
        program.interactor.Enable()  # as Render() of the window does
        assert toolkit.is_started
        assert program.press(Loop(haptics, toolkit)) > 0.3


def test_timers_of_the_program_go_on_where_vtk_does_not_tell_whose_has_fired(program):
    """vtkGenericRenderWindowInteractor (VTK's widgets for Qt, Tk and wx in Python) always reports the timer that was
    created last."""
    toolkit = Toolkit(program)
    program.interactor.Enable()
    ticks = []
    program.interactor.AddObserver("TimerEvent", lambda *_: ticks.append(1))
    with volumehaptics.add_haptics(program.interactor) as haptics:
        toolkit.fire()
        assert len(ticks) == 1
        program.interactor.CreateRepeatingTimer(10)  # the program's timer; VTK reports its id from now on
        toolkit.fire()
        assert len(ticks) == 2
        assert program.press(Loop(haptics, toolkit)) > 0.3


def test_a_preset_needs_a_volume_to_be_checked_against(program):
    program.renderer.RemoveVolume(program.volume)
    with pytest.raises(ValueError, match="Cure: add_haptics.. after the volume was added"):
        volumehaptics.add_haptics(program.window, preset="CT contrast")
    with volumehaptics.add_haptics(program.window) as haptics:
        program.renderer.AddVolume(program.volume)
        assert program.press(haptics) > 0.3


def make_text(x, y):
    """Returns an actor with a text, as in VTK's documentation."""
    actor = vtkTextActor()
    actor.SetInput("a text of the program")
    actor.GetTextProperty().SetFontSize(18)
    actor.SetPosition(x, y)
    return actor


def make_slider(x, y):
    """Returns a slider like those of PyVista and vedo."""
    slider = vtkSliderRepresentation2D()
    for coordinate, at in ((slider.GetPoint1Coordinate(), x), (slider.GetPoint2Coordinate(), x + 100)):
        coordinate.SetCoordinateSystemToDisplay()
        coordinate.SetValue(at, y + 20)
    return slider


def changed(program, switch):
    """Returns the box (left, right, bottom, top) of the pixels that change when an object is shown; None if no pixel
    changes."""
    pictures = []
    for on in (True, False, True):
        switch(on)
        for _ in range(2):  # the second rendering sees the layout that the first has made
            program.window.Render()
        shot = vtkWindowToImageFilter()
        shot.SetInput(program.window)
        shot.ReadFrontBufferOff()
        shot.Update()
        picture = shot.GetOutput()
        width, height, _ = picture.GetDimensions()
        pictures.append(vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, 3).astype(int))
    rows, columns = numpy.nonzero((pictures[0] != pictures[1]).any(axis=2))
    return (columns.min(), columns.max(), rows.min(), rows.max()) if rows.size else None


def test_the_hint_names_each_key_that_lets_go(program):
    """The hint names each key that ends the touch. A program's toolkit may keep one of these keys, as Mayavi keeps
    Escape."""
    with volumehaptics.add_haptics(program.window) as haptics:
        program.interactor.SetEventInformation(2, 2)  # beside the ball
        program.interactor.SetKeySym("t")
        program.interactor.InvokeEvent("KeyPressEvent")
        for keys, words in ("Escape End", "Escape or End lets go"), ("F9", "F9 lets go"), ("", "to press"):
            assert haptics.style.SetKey("LetGo", keys)
            haptics.update()
            assert haptics.head_up_display.GetHint().endswith(words)


def test_keys_that_a_scene_of_mayavi_keeps_to_itself_are_not_listed(program):
    scene = type("Scene", (), {"__module__": "tvtk.pyface.tvtk_scene", "interactor": program.interactor})()
    for target in (scene, types.SimpleNamespace(scene=scene)):
        with volumehaptics.add_haptics(target) as haptics:
            listed = [line.split("\t")[0] for line in haptics.style.GetKeys().splitlines()]
            assert "End" in listed and "t" in listed
            assert not any("Escape" in line for line in listed)
    with volumehaptics.add_haptics(types.SimpleNamespace(scene=program.interactor)) as haptics:
        assert "Escape  End\t" in haptics.style.GetKeys()


def luminance(color):
    """Returns the relative luminance by WCAG 2.1 (sRGB 0 to 255)."""
    share = numpy.asarray(color) / 255.0
    linear = numpy.where(share <= 0.03928, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    return linear @ (0.2126, 0.7152, 0.0722)


@pytest.mark.parametrize("part, letters", (("Plot", (230, 235, 242)), ("Hint", (255, 255, 255))))
@pytest.mark.parametrize("ground", (0.0, 0.5, 1.0))
def test_plot_and_hint_can_be_read_on_any_background(program, ground, part, letters):
    """The contrast of letters and background is at least 4.5 to 1, as WCAG 2.1 demands of text (1.4.3)."""
    program.renderer.SetBackground(ground, ground, ground)
    with volumehaptics.add_haptics(program.window) as haptics:
        program.volume.VisibilityOff()  # so that successive pictures are equal
        haptics.head_up_display.SetHint("a hint")
        left, right, bottom, top = changed(program, getattr(haptics.head_up_display, f"Set{part}Visibility"))
        shot = vtkWindowToImageFilter()
        shot.SetInput(program.window)
        shot.ReadFrontBufferOff()
        shot.Update()
        width, height, _ = shot.GetOutput().GetDimensions()
        picture = vtk_to_numpy(shot.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)
        pixels = picture[bottom:top + 1, left:right + 1].reshape(-1, 3)
        colors, counts = numpy.unique(pixels, axis=0, return_counts=True)
        assert (luminance(letters) + 0.05) / (luminance(colors[counts.argmax()]) + 0.05) >= 4.5


def test_the_plot_can_be_put_in_a_corner(program):
    """By default, the plot avoids a text at the lower left. Otherwise it is where the program puts it, above the
    scale."""
    with volumehaptics.add_haptics(program.window) as haptics:
        end = time.monotonic() + 30.0
        while not haptics.update() and time.monotonic() < end:  # the scale is shown once there is a state
            time.sleep(0.001)
        program.renderer.AddViewProp(make_text(10, 10))
        program.volume.VisibilityOff()  # so that successive pictures are equal
        display = haptics.head_up_display
        scale = changed(program, haptics.representation.SetScaleTextVisibility)
        boxes = {}
        for corner in ("Automatic", "LowerLeft", "LowerRight"):
            getattr(display, f"SetPlotCornerTo{corner}")()
            boxes[corner] = changed(program, display.SetPlotVisibility)
        assert boxes["Automatic"][2] > 20  # above the text
        assert boxes["LowerLeft"][0] < 20 and boxes["LowerLeft"][2] < 20
        assert boxes["LowerRight"][1] > 280 and scale[3] < boxes["LowerRight"][2] < 60


def test_a_click_on_a_slider_of_the_program_is_the_sliders(program):
    slider = vtkSliderWidget()
    slider.SetInteractor(program.interactor)
    slider.SetRepresentation(make_slider(10, 10))
    slider.GetRepresentation().SetValue(0.0)
    slider.SetAnimationModeToJump()
    slider.EnabledOn()
    moved = []
    slider.AddObserver("InteractionEvent", lambda *_: moved.append(slider.GetRepresentation().GetValue()))
    with volumehaptics.add_haptics(program.window) as haptics:
        program.window.Render()
        assert program.press(haptics) > 0.3
        force = haptics.device.GetState().GetForce()
        for event, x in (("LeftButtonPressEvent", 20), ("MouseMoveEvent", 60), ("MouseMoveEvent", 80),
                         ("LeftButtonReleaseEvent", 80)):
            program.interactor.SetEventInformation(x, 30)
            program.interactor.InvokeEvent(event)
        assert moved
        assert haptics.widget.GetTouchMode()
        assert haptics.device.GetState().GetForce() == force  # the tip has not moved
        program.interactor.SetEventInformation(150, 150)
        program.interactor.InvokeEvent("LeftButtonPressEvent")  # beside the ball; this click belongs to the hand
        assert program.style.GetState() == 0
