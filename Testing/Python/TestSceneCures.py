# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures of warnings about differences between what is seen and felt, and of errors of devices, on the bench
of cure_bench.py."""

import numpy as np
import pytest
import vtkmodules.vtkInteractionStyle  # noqa: F401 - the interactors of windows
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - the windows
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 - the mappers
from TestCures import RAMP
from TestFileCures import drilled, recorder, wait
from cure_bench import TOLD, Bench, Calls, told, try_calls
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkImageMask
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from volumehaptics import (
    image,
    open_large,
    vtkHapticDevice,
    vtkHapticTimeStepSource,
    vtkHapticLabelTable,
    vtkHapticProperty,
    vtkHapticRegionFilter,
    vtkHapticRemoval,
    vtkInteractorStyleHaptic,
    vtkVolumeHapticsFilter,
)
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays

result = Calls()


class Scene(Bench):
    """A window with the ramp as a volume. Until the style touches it, the volume is felt where its image is."""

    def __init__(self):
        super().__init__()
        self.device, self.style, self.volume = vtkHapticDevice(), vtkInteractorStyleHaptic(), vtkVolume()
        self.mapper, self.renderer, self.window = vtkGPUVolumeRayCastMapper(), vtkRenderer(), vtkRenderWindow()
        self.interactor = vtkRenderWindowInteractor()
        self.mapper.SetInputData(self.image)
        self.volume.SetMapper(self.mapper)
        opacity = vtkPiecewiseFunction()  # one face of the image is transparent
        opacity.AddPoint(0.0, 0.0)
        opacity.AddPoint(1.0, 1.0)
        self.volume.GetProperty().SetScalarOpacity(opacity)
        self.renderer.AddVolume(self.volume)
        self.window.SetOffScreenRendering(True)
        self.window.AddRenderer(self.renderer)
        self.interactor.SetRenderWindow(self.window)
        self.device.SetVolumeHaptics(self.haptics)
        self.style.SetDevice(self.device)
        self.style.SetDefaultRenderer(self.renderer)
        self.interactor.SetInteractorStyle(self.style)
        assert self.device.Open("virtual") and self.device.Start()

    def warnings(self):
        with Errors(self.style, event="WarningEvent") as warnings:
            for _ in range(3):
                self.style.UpdateHaptics()
        return warnings

    def end(self):
        self.interactor.SetInteractorStyle(None)
        self.device.Close()


SHOWN = {}


def shown(words, *cures):
    """Registers a function that makes a scene show something else than is felt, and for each cure the force at x = 5
    after it."""
    def keep(spoil):
        SHOWN[words] = spoil, cures
        return spoil
    return keep


def touch(s):
    s.style.TouchVolume(s.volume)


def touch_with_faces(s):
    touch(s)
    s.haptics.FeelCutFacesOn()


def moved_image(s):
    change = vtkImageChangeInformation()
    change.SetInputData(s.image)
    change.SetOriginTranslation(10.0, 0.0, 0.0)
    s.volume.SetPosition(0.0, 0.0, 0.0)
    s.mapper.SetInputConnection(change.GetOutputPort())
    s.haptics.SetInputConnection(change.GetOutputPort())


@shown("which follows all but shears, or change the origin", touch, moved_image, 0.0)
def _(s):
    """The press now goes past the volume."""
    s.volume.SetPosition(10.0, 0.0, 0.0)


def crop(s):
    s.haptics.CroppingOn()
    s.haptics.SetCroppingRegionPlanes(s.mapper.GetCroppingRegionPlanes())


@shown("or give vtkVolumeHapticsFilter the same regions with CroppingOn() and SetCroppingRegionPlanes()", touch_with_faces, crop,
       0.0)
def _(s):
    s.mapper.CroppingOn()
    s.mapper.SetCroppingRegionPlanes(10.0, 23.0, 0.0, 16.0, 0.0, 31.0)


@shown("or give vtkVolumeHapticsFilter the mapper's planes with SetClippingPlanes()", touch_with_faces,
       lambda s: s.haptics.SetClippingPlanes(s.mapper.GetClippingPlanes()), 0.0)
def _(s):
    plane = vtkPlane()
    plane.SetOrigin(10.0, 0.0, 0.0)
    plane.SetNormal(1.0, 0.0, 0.0)
    s.mapper.AddClippingPlane(plane)


def half_mask():
    return image(np.broadcast_to(np.where(np.arange(24) < 10, 0, 255).astype(np.uint8), RAMP.shape).copy())


def labels(s):
    table = vtkHapticLabelTable()
    table.SetFelt(0, False)
    s.haptics.SetLabelTable(table)
    s.haptics.SetLabelData(half_mask())
    s.mapper.SetMaskInput(None)


def masked(s):
    mask = vtkImageMask()
    mask.SetInputData(0, s.image)
    mask.SetInputData(1, half_mask())
    mask.SetMaskedOutputValue(0.0)
    mask.Update()
    s.mapper.SetInputData(mask.GetOutput())
    s.mapper.SetMaskInput(None)
    s.haptics.SetInputData(mask.GetOutput())


@shown("or, with vtkImageMask, a value that is not felt", touch_with_faces, labels, masked, 0.0)
def _(s):
    s.mapper.SetMaskInput(half_mask())
    s.mapper.SetMaskTypeToBinary()


def one_dimension(s):
    s.volume.GetProperty().SetTransferFunctionMode(vtkVolumeProperty.TF_1D)


def visible(s):
    """Values below 2000, at z < 20, are hidden."""
    seen = vtkVolumeProperty()
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 1.0)
    opacity.AddPoint(4000.0, 1.0)
    seen.SetScalarOpacity(opacity)
    s.feel.SetVisibilityFrom(seen)
    s.volume.GetProperty().SetTransferFunctionMode(vtkVolumeProperty.TF_1D)


@shown("Cure: SetTransferFunctionMode(vtkVolumeProperty::TF_1D)", one_dimension, 1.0)
@shown("or SetVisibilityFrom() of the haptic property with a volume property", visible, 1.0)
def _(s):
    function = vtkImageData()
    function.SetDimensions(2, 2, 1)
    function.AllocateScalars(VTK_UNSIGNED_CHAR, 4)
    s.volume.GetProperty().SetTransferFunction2D(function)
    s.volume.GetProperty().SetTransferFunctionMode(vtkVolumeProperty.TF_2D)


@pytest.mark.parametrize("words", SHOWN)
def test_cures_of_what_is_shown(words):
    spoil, (*cures, force) = SHOWN[words]
    for cure in cures:
        scene = Scene()
        assert not scene.warnings() and scene.force() == pytest.approx(1.0, abs=1e-6)
        spoil(scene)
        warnings = scene.warnings()
        assert len(warnings) == 1 and words in warnings[0], warnings
        cure(scene)
        assert not scene.warnings(), cure
        assert scene.force() == pytest.approx(force, abs=1e-6), cure
        scene.end()


NOTHING = [f"There {what}: call SetDevice()" for what in ("is no method to change", "are no settings to compare", "is nothing to touch with")]


@result("Cure: use one of these:", 'Cure: call SetKey("…", "") before, or choose another key', "pass the style to SetInteractorStyle() of the window's interactor",
        "call SetDevice() before TouchVolume()", "call vtkVolume::SetMapper(), for example with a vtkGPUVolumeRayCastMapper",
        *NOTHING, "Cure: AddTouchedVolume(volume, filter)", "Cure: use one vtkVolumeHapticsFilter for each volume")
def styles(_):
    s, style, bare = Scene(), vtkInteractorStyleHaptic(), vtkVolume()
    action = next(a for a in map(s.style.GetKeyActions().GetValue, range(s.style.GetKeyActions().GetNumberOfValues()))
                  if a != "Touch" and s.style.GetKey(a))
    taken = s.style.GetKey("Touch")
    with told(s.style, "Cure: use one of these:"):
        assert not s.style.SetKey("Feel", "F11")
    with Errors(s.style) as errors:
        assert not s.style.SetKey(action, taken)
    assert len(errors) == 1 and 'Cure: call SetKey("Touch", "") before, or choose another key' in errors[0], errors
    TOLD.add('Cure: call SetKey("…", "") before, or choose another key')
    assert s.style.SetKey(action, "F11") and s.style.SetKey("Touch", "") and s.style.SetKey(action, taken)
    for words, act in zip(NOTHING, (style.NextMethod, style.SwapSettings, style.TouchModeOn)):
        with told(style, words):
            act()
    with told(style, "call SetDevice() before TouchVolume()"):
        style.TouchVolume(s.volume)
    style.SetDevice(s.device)
    with told(style, "pass the style to SetInteractorStyle() of the window's interactor"):
        style.TouchModeOn()
    with told(s.style, "call vtkVolume::SetMapper(), for example with a vtkGPUVolumeRayCastMapper"):
        assert not s.style.TouchVolume(bare)
    bare.SetMapper(s.mapper)
    s.renderer.AddVolume(bare)
    assert s.style.TouchVolume(bare)
    assert s.style.GetTouchedVolume() is bare
    s.style.TouchVolume(s.volume)
    with told(s.style, "Cure: AddTouchedVolume(volume, filter)"):
        assert not s.style.AddTouchedVolume(bare, None)
    with told(s.style, "Cure: use one vtkVolumeHapticsFilter for each volume"):
        assert not s.style.AddTouchedVolume(bare, s.haptics)
    assert s.style.AddTouchedVolume(bare, vtkVolumeHapticsFilter()) and s.style.GetNumberOfTouchedVolumes() == 2
    s.interactor.SetInteractorStyle(style)
    style.TouchVolume(s.volume)
    style.TouchModeOn()
    assert style.GetTouchMode()
    s.end()


# Devices.

@result("ForgetConfirmation() is for an open device whose servo does not run", 'There is no virtual device to turn: Open("virtual") first',
        "Closed. Open() a device", "Start() the servo.", "Give the filter of this device one of its own with SetRemoval(nullptr)",
        "Arm() lets force through")
def orders(_):
    device, removal = vtkHapticDevice(), vtkHapticRemoval()
    bench = Bench()
    with told(device, 'There is no virtual device to turn: Open("virtual") first'):
        device.GetVirtualHand().SetOrientation(1.0, 0.0, 0.0, 0.0)
    with told(device, "ForgetConfirmation() is for an open device whose servo does not run"):
        device.ForgetConfirmation()
    for word, order in (("Closed. Open() a device", lambda: device.Open("virtual")), ("Start() the servo.", device.Start),
                        ("Arm() lets force through", lambda: (device.Arm(), True)[1])):
        assert word in device.GetStatusText(), device.GetStatusText()
        TOLD.add(word)
        device.SetVolumeHaptics(bench.haptics)
        device.SetAttentionTime(0.0)
        assert order()
        device.UpdateState()
    wait(device, 50)
    assert "% of the force passes" in device.GetStatusText()
    device.GetVirtualHand().SetOrientation(1.0, 0.0, 0.0, 0.0)
    device.GetVirtualHand().SetPosition(5.0, 8.0, 10.0)
    wait(device)
    device.GetVirtualHand().SetPosition(5.0, 8.0, 12.0)
    wait(device, 800)
    assert -device.GetState().GetComputedForce()[2] == pytest.approx(1.0, abs=0.01)
    with told(device, "ForgetConfirmation() is for an open device whose servo does not run"):
        device.ForgetConfirmation()
    device.Stop()
    device.ForgetConfirmation()
    first, second = recorder(), vtkHapticDevice()
    first.Stop()
    benches = Bench(), Bench()
    for one, b in zip((first, second), benches):
        drilled(b)
        b.haptics.SetRemoval(removal)
        one.SetVolumeHaptics(b.haptics)
    assert second.Open("virtual") and first.Start()
    with told(second, "Give the filter of this device one of its own with SetRemoval(nullptr)", benches[1].haptics):
        assert not second.Start()
    benches[1].haptics.SetRemoval(None)
    assert second.Start()
    second.Stop()
    benches[1].haptics.SetRemoval(removal)
    first.Stop()
    assert second.Start()
    second.Close()


class Half(VTKPythonAlgorithmBase):
    """Produces half of the extent that it promises."""

    def __init__(self, given):
        super().__init__(nInputPorts=0, outputType="vtkImageData")
        self.given = given

    def RequestInformation(self, request, inputs, outputs):  # noqa: N802 - VTK's name
        outputs.GetInformationObject(0).Set(self.GetExecutive().WHOLE_EXTENT(), (0, 23, 0, 16, 0, 31), 6)
        return 1

    def RequestData(self, request, inputs, outputs):  # noqa: N802 - VTK's name
        vtkImageData.GetData(outputs).DeepCopy(image(RAMP[:self.given]))
        return 1


@result("Use a source that gives its whole extent, or lower Region to what it gives",
        ", whose noise has a standard deviation of …. Smooth it, for example with vtkImageGaussianSmooth",
        "Connect the source of its time steps, with a TimeUnitsPerSecond that is not 0",
        "connect the whole image that it was made with")
def sources(folder):
    crop, half = vtkHapticRegionFilter(), Half(16)
    crop.SetInputConnection(half.GetOutputPort())
    crop.SetRegion(0, 23, 0, 16, 0, 31)
    with told(crop, "Use a source that gives its whole extent, or lower Region to what it gives", crop.GetExecutive()):
        crop.Update()
    crop.SetRegion(0, 23, 0, 16, 0, 15)
    crop.Update()
    assert crop.GetOutput().GetDimensions() == (24, 17, 16)
    half.given = 32
    half.Modified()
    crop.SetRegion(0, 23, 0, 16, 0, 31)
    crop.Update()
    assert crop.GetOutput().GetDimensions() == (24, 17, 32)

    rng = np.random.default_rng(3)
    noisy = image(np.where(RAMP < 1550.0, 0.0, 100.0) + rng.normal(0.0, 45.0, RAMP.shape))
    feel = vtkHapticProperty()
    with Errors(feel) as errors:
        assert not feel.ProposeFromImage(noisy)
    assert len(errors) == 1 and "Smooth it, for example with vtkImageGaussianSmooth" in errors[0], errors
    TOLD.add(", whose noise has a standard deviation of …. Smooth it, for example with vtkImageGaussianSmooth")
    smooth = vtkImageGaussianSmooth()
    smooth.SetInputData(noisy)
    smooth.SetStandardDeviation(2.0)
    smooth.Update()
    assert feel.ProposeFromImage(smooth.GetOutput())

    # -- recording a moving volume --
    b, source, device = Bench(), vtkHapticTimeStepSource(), vtkHapticDevice()
    for time in (0.0, 100.0):
        source.AddTimeStep(b.image, time)
    b.haptics.SetInputConnection(source.GetOutputPort())
    b.haptics.SetTimeUnitsPerSecond(1.0)
    device.SetVolumeHaptics(b.haptics)
    device.SetAttentionTime(0.0)
    assert device.Open("virtual") and device.Start()
    device.GetPlayback().Play()
    device.GetVirtualHand().SetPosition(5.0, 8.0, 10.0)
    wait(device)
    assert device.GetRecorder().Start(str(folder / "moves.vtp"))
    device.GetVirtualHand().SetPosition(5.0, 8.0, 12.0)
    wait(device, 400)
    assert device.GetRecorder().Stop()
    device.Close()
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(folder / "moves.vtp"))
    reader.Update()
    recorded = arrays(reader.GetOutput())["Force"][-1][2]
    still = Bench()
    still.haptics.SetPathData(reader.GetOutput())
    with told(still.haptics, "Connect the source of its time steps, with a TimeUnitsPerSecond that is not 0",
              still.haptics.GetExecutive()):
        still.haptics.Update()
    still.haptics.SetInputConnection(source.GetOutputPort())
    still.haptics.SetTimeUnitsPerSecond(1.0)
    assert -still.force() == recorded == pytest.approx(-1.0, abs=0.05)

    # A recording that can't be replayed with volumes read by regions can be replayed with whole volumes.
    large, whole = open_large(RAMP, spacing=(1, 1, 1)), Bench()
    device, path = recorder(), folder / "still.vtp"
    assert device.GetRecorder().Start(str(path))
    wait(device, 50)
    assert device.GetRecorder().Stop()
    device.Close()
    reader.SetFileName(str(path))
    whole.haptics.SetPathConnection(reader.GetOutputPort())
    whole.haptics.SetInputConnection(large.GetOutputPort())
    with told(whole.haptics, "connect the whole image that it was made with", whole.haptics.GetExecutive()):
        whole.haptics.Update()
    whole.haptics.SetInputData(whole.image)
    whole.haptics.Update()
    assert whole.haptics.GetOutput().GetNumberOfPoints() > 20


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)
