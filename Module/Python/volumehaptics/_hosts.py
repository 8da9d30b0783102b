# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the volumes in the window of any VTK program touchable. Imports none of these programs."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Sequence
from typing import Any, Union

import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 (for the plot of the display)
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (for the texts of the plot)
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor, vtkRenderer, vtkVolume

from . import _trame
from ._qt import watch_widget
from ._touch import Errors, configure
from .vtkVolumeHaptics import (
    vtkHapticDevice,
    vtkHapticHeadUpDisplay,
    vtkHapticRepresentation,
    vtkHapticWidget,
    vtkInteractorStyleHaptic,
    vtkVolumeHapticsFilter,
)

# A device, by its id or as an object, or one device for each hand.
Devices = Union[str, vtkHapticDevice, Sequence[Union[str, vtkHapticDevice]]]

# Attributes that lead to a window in VTK's Qt, Tk and wx widgets, vedo, FURY and Mayavi.
_NAMES = ("interactor", "iren", "_Iren", "render_window", "window", "scene", "renderer")
# Keys that scenes of tvtk.pyface use themselves.
_KEPT_BY_TVTK = ("Escape", "s", "p", "l", "Left", "Right", "plus", "KP_Add", "minus", "KP_Subtract")
_DEPTH = 4  # longest chain of attributes, such as figure.scene.interactor


class Haptics:
    """The objects that add_haptics() has added to a window, until close() is called, the window ends, or this object is
    deleted.

    widget: the vtkHapticWidget that observes the window's interactor.
    device: the vtkHapticDevice in the hand, whose servo runs once there is a volume.
    filter: the vtkVolumeHapticsFilter that defines what is felt. Changes are felt at once.
    style: the vtkInteractorStyleHaptic of the widget, for keys, measurements, slices and events.
    representation: the vtkHapticRepresentation that shows the hand in the scene.
    head_up_display: the vtkHapticHeadUpDisplay with figures and a plot over the scene.
    second_device: the vtkHapticDevice in the other hand, or None.
    """

    closed = True  # until the constructor has made all parts
    _leave_widget: Callable[[], bool] | None = None

    def __init__(self) -> None:
        self.widget = vtkHapticWidget()
        self.device: vtkHapticDevice = self.widget.GetDevice()
        self.filter: vtkVolumeHapticsFilter = self.widget.GetVolumeHaptics()
        self.style: vtkInteractorStyleHaptic = self.widget.GetStyle()
        self.representation: vtkHapticRepresentation = self.widget.GetRepresentation()
        self.head_up_display: vtkHapticHeadUpDisplay = self.widget.GetHeadUpDisplay()
        self.second_device: vtkHapticDevice | None = None
        self._owned = [self.device]  # the devices that close() closes
        self.closed = False

    @property
    def _devices(self) -> list[vtkHapticDevice]:
        """The device in each hand."""
        return [self.device] + ([] if self.second_device is None else [self.second_device])

    @property
    def _holds(self) -> bool:
        """Whether there may be force now or soon."""
        return self.style.GetTouchMode() or any(device.IsArmOrdered() for device in self._devices)

    def update(self) -> bool:
        """Does one step of the window's timer, for programs whose loop has none. Returns whether there is something new
        to draw."""
        return not self.closed and self.style.UpdateHaptics()

    def close(self) -> None:
        """Ends all force, stops the device, and restores the window. May be called twice."""
        if self.closed:
            return
        self.closed = True
        if self._leave_widget is not None:
            if not self._leave_widget():
                # The timer has ended with the Qt widget, but VTK's widget would still stop it.
                interactor = self.widget.GetInteractor()
                if interactor is not None:
                    interactor.RemoveObservers("DestroyTimerEvent")
            self._leave_widget = None
        self.widget.SetInteractor(None)
        for device in self._devices:
            device.Stop()
        for device in self._owned:
            device.Close()

    def __del__(self) -> None:
        self.close()

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _choose_device(self, wanted: Devices | None) -> None:
        """Sets one device, or two in a list. A device of the user's own stays open when this object is closed."""
        if isinstance(wanted, (list, tuple)):
            if len(wanted) != 2:
                raise ValueError(f"device gives at most two devices, one for each hand, not {len(wanted)} devices. Cure: give one, or "
                                 "[first, second]")
            first, second = wanted
            if second == "virtual":
                raise ValueError("the mouse leads the first hand. Cure: device=[\"virtual\", the real one]")
            own = vtkHapticDevice()
            own.SetAttentionTime(self.device.GetAttentionTime())  # before another device replaces this one
            self._choose_device(first)
            device = self._open(second, own)
            with Errors(self.style) as errors:
                self.widget.SetSecondDevice(device)
            if errors:
                raise ValueError("; ".join(errors))
            device.UseToolOff()  # only the first hand uses the tool
            device.SetVolumeHaptics(self.filter)
            self.second_device = device
        elif wanted is not None:
            device = self._open(wanted, self.device)
            if device is not self.device:
                self.widget.SetDevice(device)
                self.device = device

    def _open(self, wanted: str | vtkHapticDevice, own: vtkHapticDevice) -> vtkHapticDevice:
        """Returns a device of the user's own, which is open, or opens another one by its id."""
        if isinstance(wanted, vtkHapticDevice):
            with Errors(wanted) as errors:
                if not wanted.IsOpen() and not wanted.Start():  # Start() reports why a device is not open
                    raise ValueError("; ".join(errors))
            wanted.Stop()  # the device may still be armed on another volume
            return wanted
        with Errors(own) as errors:
            if not own.Open(wanted):
                raise RuntimeError("; ".join(errors))
        if own is not self.device:
            self._owned.append(own)
        return own

    def _watch_widget(self, target: Any) -> None:
        """Ends the touch when the view is no longer seen, if it is a view of Qt."""
        itself = weakref.ref(self)

        def let_go() -> None:
            haptics = itself()
            if haptics is not None and not haptics.closed:
                haptics.style.FadeOut()

        self._leave_widget = watch_widget(target, let_go)


def _plain_vtk(wrapped: Any) -> Any:
    """Returns VTK's object inside a tvtk object (Mayavi). Returns None for other objects of tvtk."""
    inner = getattr(wrapped, "_vtk_obj", None)
    return wrapped if inner is None else inner


def _find_interactor(target: Any, depth: int = _DEPTH) -> vtkRenderWindowInteractor | None:
    """Returns the interactor of a program's window object, which is found through its attributes."""
    target = _trame.window_of(target) if _trame.is_view(target) else _plain_vtk(target)
    if isinstance(target, vtkRenderWindowInteractor):
        return target
    if isinstance(target, vtkRenderWindow):
        return target.GetInteractor()
    if isinstance(target, vtkRenderer):
        return _find_interactor(target.GetRenderWindow(), depth)
    if target is None or depth == 0 or callable(target):
        return None
    window = getattr(target, "GetRenderWindow", None)
    candidates = [getattr(target, name, None) for name in _NAMES] + [window() if callable(window) else None]
    return next(filter(None, (_find_interactor(one, depth - 1) for one in candidates)), None)


def _remove_kept_keys(target: Any, style: vtkInteractorStyleHaptic) -> None:
    """Removes the keys that a scene of tvtk (Mayavi) handles before VTK, so that the display lists only keys that arrive."""
    scenes = (target, getattr(target, "scene", None))
    if not any(kind.__module__.split(".")[0] == "tvtk" for scene in scenes for kind in type(scene).__mro__):
        return
    actions = style.GetKeyActions()
    for action in map(actions.GetValue, range(actions.GetNumberOfValues())):
        style.SetKey(action, " ".join(key for key in style.GetKey(action).split() if key not in _KEPT_BY_TVTK))


def _find_volume(volume: Any) -> vtkVolume:
    """Returns the volume inside a program's object, which is found through its attributes."""
    for one in (volume, getattr(volume, "actor", None)):  # objects of vedo have the attribute actor
        if isinstance(_plain_vtk(one), vtkVolume):
            return _plain_vtk(one)
    raise TypeError(f"only a vtkVolume that the window shows can be touched, not {_describe(volume)}. Cure: give that "
                    "volume, or none: then it is what the window shows under the pointer")


def _describe(thing: Any) -> str:
    return f"{type(thing).__module__}.{type(thing).__qualname__}"


def _find_plotter(target: Any) -> Any:
    """Returns PyVista's plotter: the object itself, or the plotter of MNE's figure. Returns None for other objects."""
    for one in (target, getattr(target, "plotter", None)):
        if hasattr(one, "iren") and any(kind.__module__.split(".")[0] == "pyvista" for kind in type(one).__mro__):
            return one
    return None


def _image_of(interactor: vtkRenderWindowInteractor, volume: vtkVolume | None) -> vtkImageData | None:
    """Returns the image that a volume shows, or the first image of a window."""
    shown = [volume] if volume is not None else []
    renderers = interactor.GetRenderWindow().GetRenderers()
    for renderer in map(renderers.GetItemAsObject, range(renderers.GetNumberOfItems())):
        volumes = renderer.GetVolumes()
        shown += map(volumes.GetItemAsObject, range(volumes.GetNumberOfItems()))
    images = (one.GetMapper().GetInputDataObject(0, 0) for one in shown if one.GetMapper() is not None)
    return next((image for image in images if isinstance(image, vtkImageData)), None)


def add_haptics(target: Any, volume: Any = None, preset: str | None = None, device: Devices | None = None, **settings: Any) -> Haptics:
    """Makes the volumes in a window touchable. The style, the widgets and the keys of the program continue to work.

    target: the window: a vtkRenderWindowInteractor, vtkRenderWindow or vtkRenderer; a widget of VTK for Qt, Tk or wx; a
        VtkRemoteView of trame; a plotter of PyVista or vedo, a show manager of FURY, a scene or figure of Mayavi, a
        figure of MNE; or any other object with one of their attributes. In trame, call widget.TouchModeOn() from a
        button, because no keys arrive; the touch ends when a browser leaves.
    volume: the touched vtkVolume, or an object that has one. Default: the volume under the pointer.
    preset: how the tissues feel, such as "CT contrast": see vtkHapticProperty. Default: 500 N/m everywhere.
        "propose": as the volume's own edges suggest; or a file ".json": both as in touch().
    device: "virtual", the mouse (default), "falcon" and so on: see vtkHapticDevice; or a vtkHapticDevice that is open
        and stays open. Two of these in a list are one in each hand: ["falcon:0", "falcon:1"].
    settings: of vtkVolumeHapticsFilter, in snake_case, as for touch().

    The key t with the pointer on a volume begins the touch, Escape ends it: see vtkHapticWidget. Keep the returned
    object: the touch ends when it is deleted.

    TypeError: target has no window, or volume is no volume. ValueError: the window has no interactor, or settings can't
    be felt; the text has the reason and the cure. RuntimeError: the device does not open.
    """
    plotter = _find_plotter(target)
    if plotter is not None:
        from .pyvista import add_haptics as add_to_plotter

        return add_to_plotter(plotter, volume, preset, device="virtual" if device is None else device, **settings)
    interactor = _find_interactor(target)
    if interactor is None or interactor.GetRenderWindow() is None:
        raise TypeError(f"haptics are added to a window, and {_describe(target)} leads to none that has an interactor. "
                        "Cure: give the vtkRenderWindowInteractor, after SetRenderWindow() of it. What draws without VTK, "
                        "as FURY 2 does, can't be touched: show its volume in a window of VTK")
    haptics = Haptics()
    widget = haptics.widget
    touched = None if volume is None else _find_volume(volume)
    image = _image_of(interactor, touched)
    try:
        with Errors(widget, haptics.filter, haptics.filter.GetProperty()) as errors:
            if preset is not None or settings:
                if image is None:
                    raise ValueError("the window shows no image yet, which is needed to check a preset or settings. "
                                     "Cure: add_haptics() after the volume was added")
                configure(haptics.filter, image, preset, settings, errors, "add_haptics")
            widget.SetVolume(touched)
            haptics._choose_device(device)
            widget.SetInteractor(interactor)
            widget.On()
            _remove_kept_keys(target, haptics.style)
        if errors:
            raise ValueError("; ".join(errors))
    except BaseException:
        haptics.close()
        raise
    haptics._watch_widget(target)
    if _trame.is_view(target):
        _trame.drive(target, haptics)
    return haptics
