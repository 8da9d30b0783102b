# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a pyvista.Plotter touchable, using only the plotter's public attributes."""

from __future__ import annotations

import atexit
import math
import warnings
import weakref
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet, vtkImageData
from vtkmodules.vtkFiltersModeling import vtkOutlineFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkVolume

from ._grids import is_grid, overview
from ._hosts import Devices
from ._hosts import Haptics as HostHaptics
from ._labels import Labels, Materials, set_labels
from ._touch import Errors, choose_mode, configure, frame_of, plain
from .vtkVolumeHaptics import (
    vtkHapticTimeStepSource,
    vtkHapticMeasurementRepresentation,
    vtkHapticMeasurements,
    vtkHapticRegionSource,
    vtkHapticSliceView,
    vtkInteractorStyleHaptic,
)

if TYPE_CHECKING:
    import pyvista as pv

# The plotter keeps its touchable parts alive, but not vice versa.
_touchable: weakref.WeakKeyDictionary[pv.Plotter, Haptics] = weakref.WeakKeyDictionary()

SIZE = 0.007  # radius of the proxy, as a fraction of the volume's diagonal
ARROW = 0.05  # length of an arrow of 1 N, as a fraction of the volume's diagonal


class Haptics(HostHaptics):
    """The objects that add_haptics() has added to a plotter, until the plotter is closed, or close() is called.

    widget: the vtkHapticWidget, which observes the plotter's mouse and keys beside the plotter's own style.
    device: the vtkHapticDevice in the hand, whose servo runs.
    second_device: the vtkHapticDevice in the other hand, or None.
    filter: the vtkVolumeHapticsFilter that defines what is felt. Changes are felt at once.
    style: the vtkInteractorStyleHaptic of the widget, for keys, slices and events. It is not the plotter's style.
    representation: the vtkHapticRepresentation that shows the hand in the scene.
    head_up_display: the vtkHapticHeadUpDisplay with figures and a plot over the scene.
    frames: the vtkHapticTimeStepSource of a moving volume; None for other volumes.
    slices: the vtkHapticSliceView beside the scene; None without slices=True.
    measurements: the vtkHapticMeasurements that are taken by touch and keys.
    measured: the vtkHapticMeasurementRepresentation, which shows them in the scene.

    PyVista's enable_*_style() and charts that use the mouse do not end the touch.
    """

    def __init__(self, plotter: pv.Plotter, renderer: pv.Renderer | None = None) -> None:
        super().__init__()
        self.frames: vtkHapticTimeStepSource | None = None
        self.slices: vtkHapticSliceView | None = None
        self.measurements = vtkHapticMeasurements()
        self.measured = vtkHapticMeasurementRepresentation()
        self._plotter = weakref.ref(plotter)
        self._renderer = weakref.ref(renderer or plotter.renderer)
        self._in_scene: list[Any] = []
        self._missing = 0  # number of props that were missing from the scene at the last check
        self._feels_hidden = False  # whether invisible props can be felt, too
        self._outline: vtkActor | None = None

    def close(self) -> None:
        """Stops the servo, closes the device, and restores the plotter. May be called twice."""
        if self.closed:
            return
        super().close()
        plotter, renderer = self._plotter(), self._renderer()
        if renderer is not None:
            renderer.RemoveViewProp(self.measured)
            if self._outline is not None:
                renderer.RemoveViewProp(self._outline)
        self.style.SetCoarseVolume(None)
        if self.slices is not None:
            self.slices.SetRenderWindow(None)
        if plotter is not None:
            _touchable.pop(plotter, None)
            if plotter.iren is not None:
                vars(plotter.iren).pop("close", None)

    def _attach(self, plotter: pv.Plotter, touched: list[vtkVolume]) -> None:
        renderer = self._renderer()
        self.measured.UseBoundsOff()  # cameras and axes frame only the volume, not the measurements
        self.measured.SetMeasurements(self.measurements)
        self.measured.SetHeadUpDisplay(self.head_up_display)
        self.head_up_display.SetMeasurements(self.measurements)
        renderer.AddViewProp(self.measured)
        self.style.SetMeasurements(self.measurements)
        self.widget.SetInteractor(plotter.iren.interactor)
        self.widget.SetDefaultRenderer(renderer)
        with Errors(self.widget, self.style, self.device, self.filter) as errors:
            self.widget.On()
        if errors:
            raise ValueError("; ".join(errors))
        # reports later errors, for example if a volume can't be touched after pressing t
        self.widget.AddObserver("ErrorEvent", _warn)
        self._in_scene = [prop for prop in (self.representation, *touched) if self._is_in_scene(prop)]
        self._watch(plotter)
        _touchable[plotter] = self

    def _frame(self, large: vtkHapticRegionSource) -> None:
        """Shows the region that is in memory in fine detail, and its outline."""
        outline, mapper, self._outline = vtkOutlineFilter(), vtkPolyDataMapper(), vtkActor()
        outline.SetInputConnection(large.GetOutputPort())
        mapper.SetInputConnection(outline.GetOutputPort())
        self._outline.SetMapper(mapper)
        self._outline.UseBoundsOff()
        self._outline.PickableOff()
        self._outline.GetProperty().SetColor(1.0, 0.8, 0.2)
        self._renderer().AddViewProp(self._outline)
        shown = [prop for prop in self._in_scene if isinstance(prop, vtkVolume)]
        if shown:
            self.style.SetCoarseVolume(shown[0])

    def _show_slices(self, plotter: pv.Plotter, image: vtkImageData | None) -> None:
        """Shows slices through the tip beside the scene: slices of an image, or of the felt data."""
        self.slices = vtkHapticSliceView()
        self.slices.SetDevice(self.device)
        self.slices.SetHeadUpDisplay(self.head_up_display)
        self.slices.SetImage(image)
        self.slices.SetRenderWindow(plotter.render_window)
        self.style.SetSliceView(self.slices)

    def _check_scene(self) -> None:
        """Ends the touch if the volume or the hand has been removed from the scene."""
        before, self._missing = self._missing, self._count_missing()
        if self._missing > before:
            self.style.FadeOut()

    def _is_in_scene(self, prop: Any) -> bool:
        plotter = self._plotter()
        return plotter is not None and any(renderer.HasViewProp(prop) for renderer in plotter.renderers)

    def _count_missing(self) -> int:
        return sum(not self._is_in_scene(prop) or not (self._feels_hidden or prop.GetVisibility())
                   for prop in self._in_scene)

    def _refuse(self) -> None:
        """Prevents touching a volume that is invisible or not in the scene."""
        if self._count_missing() and self._holds:
            self.style.FadeOut()
            warnings.warn("what is touched was taken out of the plotter or made invisible, so that it is not felt. Cure: "
                          "VisibilityOn() of the actor, or close() of what add_haptics() has returned, and add_haptics() "
                          "with what is shown now", stacklevel=2)

    def _watch(self, plotter: pv.Plotter) -> None:
        """Closes this object when the plotter closes. Observes the plotter's interactor and scene instead of the plotter,
        because show() replaces the plotter's own hooks."""
        itself = weakref.ref(self)

        def close(*_: object) -> None:
            haptics = itself()
            if haptics is not None:
                haptics.close()

        def look(*_: object) -> None:
            haptics = itself()
            if haptics is not None and not haptics.closed:
                haptics._refuse()

        interactor, end = plotter.iren, type(plotter.iren).close

        def close_first() -> None:
            close()
            end(interactor)

        def check(*_: object) -> None:
            haptics = itself()
            if haptics is not None and not haptics.closed:
                haptics._check_scene()

        self._renderer().GetViewProps().AddObserver("ModifiedEvent", check)
        self.style.AddObserver("ModifiedEvent", look)
        self.style.AddObserver(vtkInteractorStyleHaptic.ArmedEvent, look)
        self.style.AddObserver(vtkInteractorStyleHaptic.StatesEvent, look)
        # before VTK's own close, because other owners may keep VTK's interactor alive longer than the plotter
        interactor.close = close_first
        interactor.interactor.AddObserver("DeleteEvent", close)
        weakref.finalize(plotter, close)
        self._watch_widget(plotter)

    def _check_volumes(self) -> list[str]:
        """Returns warnings about volumes that are shown differently from how they are felt. Later ones become Python
        warnings."""
        with Errors(self.style, event="WarningEvent") as found:
            self.style.CheckShownVolumes()
        self.style.AddObserver("WarningEvent", _warn)
        return found


def _warn(_caller: Any, _event: str, text: str) -> None:
    warnings.warn(plain(text), stacklevel=2)


_warn.CallDataType = VTK_STRING  # type: ignore[attr-defined]


@atexit.register
def _close_all() -> None:
    for haptics in list(_touchable.values()):
        haptics.close()


def _renderer_of(plotter: pv.Plotter, volume: Any) -> pv.Renderer:
    """Returns the subplot that shows an actor, preferably the active one. For other objects, returns the active one."""
    if not isinstance(volume, vtkVolume):
        return plotter.renderer
    for renderer in (plotter.renderer, *plotter.renderers):
        if renderer.HasViewProp(volume) or renderer.GetVolumes().IsItemPresent(volume):
            return renderer
    raise ValueError("the volume's actor is not in the plotter, so that nobody would see what is felt. Cure: "
                     "add_haptics() with what this plotter's add_volume() has returned last, or "
                     "plotter.add_actor(volume) before it")


def _find_volume(plotter: pv.Plotter, is_alone: bool) -> vtkVolume:
    """Returns the plotter's first volume. If is_alone, it must be the only one."""
    volumes = {name: actor for name, actor in plotter.actors.items() if isinstance(actor, vtkVolume)}
    if not volumes:
        raise ValueError("the plotter has no volume. Cure: add_haptics(plotter, plotter.add_volume(image))")
    if len(volumes) > 1 and is_alone:
        raise ValueError(f"the plotter has {len(volumes)} volumes: {', '.join(volumes)}, and mode, labels, visibility and "
                         "a preset that is proposed are for one. Cure: give the one to be touched, as "
                         "plotter.add_volume() returned it")
    return next(iter(volumes.values()))


def _show_coarse(plotter: pv.Plotter, large: vtkHapticRegionSource) -> vtkVolume | vtkHapticRegionSource:
    """Returns the actor that shows a volume larger than memory; if there is none, the volume itself."""
    shown = [actor for actor in plotter.actors.values() if isinstance(actor, vtkVolume)]
    if not shown and large.GetCoarseImage() is not None:
        import pyvista

        return plotter.add_volume(pyvista.wrap(large.GetCoarseImage()))
    return shown[0] if len(shown) == 1 else large


def _image_of(volume: Any) -> vtkImageData:
    """Returns the image to be touched: that of an actor, or the given one."""
    image = volume
    if isinstance(volume, vtkVolume):
        image = volume.GetMapper().GetInputDataObject(0, 0) if volume.GetMapper() else None
    if not isinstance(image, vtkImageData):
        cure = ". Cure: give the grid itself instead of its actor" if is_grid(image) else ""
        raise TypeError("what is touched is a pyvista.ImageData, what plotter.add_volume() returned for one, or a grid "
                        f"of cells in space, not {type(image).__name__}{cure}")
    return image


def _geometry(image: vtkImageData) -> tuple[Any, ...]:
    matrix = image.GetDirectionMatrix()
    direction = tuple(matrix.GetElement(i, j) for i in range(3) for j in range(3))
    return image.GetExtent(), image.GetSpacing(), image.GetOrigin(), direction


def _frames_of(frames: Sequence[Any], times: Sequence[float] | None) -> vtkHapticTimeStepSource:
    """Makes a source of images: each image is one time step of the same volume."""
    if len(frames) < 2:
        raise ValueError("a volume that moves has two frames at least. Cure: give one image alone, not in a list")
    for frame in frames:
        if not isinstance(frame, vtkImageData):
            raise TypeError(f"frames are pyvista.ImageData, not {type(frame).__name__}")
        if _geometry(frame) != _geometry(frames[0]):
            raise ValueError("all frames need the extent, spacing, origin and direction of the first one. Cure: "
                             "frame.sample() of the others on one grid")
    times = [float(time) for time in (range(len(frames)) if times is None else times)]
    if len(times) != len(frames) or len(set(times)) < len(times) or not all(map(math.isfinite, times)):
        raise ValueError(f"each of the {len(frames)} frames needs a finite time of its own, and times is {times}")
    source = vtkHapticTimeStepSource()
    for frame, time in sorted(zip(frames, times), key=lambda pair: pair[1]):
        source.AddTimeStep(frame, time)
    source.Update()
    return source


def _actor_of(plotter: pv.Plotter, first: vtkImageData) -> vtkVolume | vtkImageData:
    """Returns the actor that shows the first time step, or another image of its geometry; if there is none, the time
    step itself."""
    def shows(actor: Any) -> bool:
        mapper = actor.GetMapper() if isinstance(actor, vtkVolume) else None
        shown = mapper.GetInputDataObject(0, 0) if mapper else None
        return isinstance(shown, vtkImageData) and _geometry(shown) == _geometry(first)

    actors = [actor for actor in plotter.actors.values() if shows(actor)]
    if len(actors) != 1:
        return first
    # Set the image again: PyVista may have given the mapper a copy, which the style would not recognise as the felt
    # image.
    actors[0].GetMapper().SetInputDataObject(0, first)
    return actors[0]


def add_haptics(
    plotter: pv.Plotter,
    volume: vtkVolume | vtkDataSet | vtkCompositeDataSet | Sequence[vtkImageData] | vtkHapticRegionSource | None = None,
    preset: str | Sequence[float] | None = None,
    *,
    times: Sequence[float] | None = None,
    device: Devices = "virtual",
    visibility: bool | vtkVolume = True,
    mode: str | None = None,
    labels: Labels | None = None,
    materials: Materials | None = None,
    slices: bool = False,
    **settings: Any,
) -> Haptics:
    """Makes a volume in a plotter touchable: press t with the pointer on it.

    plotter: a pyvista.Plotter with a window of its own, not shown yet or already. The subplot that shows the given
        actor is the one that is touched; for an image, grid or frames the active one, which also shows measurements.
    volume: what plotter.add_volume() returned, or a pyvista.ImageData with point data, in which case anything may show
        it, such as an isosurface. Default: the volume under the pointer, whichever the plotter shows when t is pressed;
        with mode, labels, visibility or "propose" its only one. Or a list of images of one geometry, the frames of a
        volume that moves: it plays in a loop at once, and an actor of the first frame shows what is felt; see
        vtkHapticPlayback.Play() and the keys of vtkInteractorStyleHaptic. Or one that is larger than memory, of
        open_large(): the plotter shows its coarse level, if it has one and the plotter has no volume, and the region
        that is in memory finely, in a frame. Or a rectilinear, structured or unstructured grid, or a MultiBlock of
        these: its arrays are felt, resampled around the hand, whatever shows it.
    times: times of the frames, in seconds, or in other units with time_units_per_second=...; times may take the
        place of preset: add_haptics(plotter, frames, times). Default: 0, 1, 2 ...
    preset: how the tissues feel, such as "CT contrast": see vtkHapticProperty. Default: 500 N/m everywhere.
        "propose": as the volume's own edges suggest; or a file ".json": both as in touch().
    device: "virtual", the mouse (default), "falcon" and so on: see vtkHapticDevice; or a vtkHapticDevice that is
        open and stays open. Two of these in a list are one in each hand: ["falcon:0", "falcon:1"]. The first holds
        the tool; the mouse, if there is one, is the first.
    visibility: True (default): what is not seen is not felt, by the opacity of the given actor, or of volume if it is
        an actor. A given actor is felt where its position, orientation and scale put it, without the parts that its
        mapper crops and clips, such as by plotter.add_volume_clip_plane(); see vtkInteractorStyleHaptic.TouchVolume().
        An actor is not felt any more when it becomes invisible, or when an actor of the same name replaces it.
        False: what is hidden is felt, too.
    mode: a way to feel vectors, tensors or vessels, such as "Find a vortex", as for volumehaptics.touch(). Default for
        a grid of vectors: "Follow the flow".
    labels, materials: a segmentation and the feel of its labels, as for volumehaptics.touch(). The table is
        haptics.filter.GetLabelTable(); changes are felt at once.
    slices: True shows three slices through the tip in a column beside the scene: see vtkHapticSliceView, and
        vtkInteractorStyleHaptic for the mouse there. All subplots get narrower. The key s hides and shows the slices.
    settings: of vtkVolumeHapticsFilter, in snake_case: iso_value=-300, kernel_radius=3, property=...,
        tool=vtkHapticNeedle(), tool="drill.stl" or a mesh: Alt + mouse turns it

    The servo starts at once, without force. Force flows when the user presses t: see vtkInteractorStyleHaptic for the
    keys from then on. It fades out when the plotter's timer stands still for 10 s (for a
    device that you pass, its own AttentionTime), and ends when the volume's actor is removed or, in pyvistaqt, when the
    widget or its window is hidden, minimised or closed. Closing the plotter stops everything. The plotter's style,
    keys and mouse remain its own until t is pressed, and then all that the touch does not use: haptics.style.SetKey("Compare",
    "") gives y, for example, back to PyVista.

    TypeError: no plotter or nothing that can be touched, or no such setting. ValueError: data or settings that
    can't be touched; the text has the reason and the cure. RuntimeError: the device does not open. UserWarning: the
    image is shown differently from how it is felt, for example masked or blanked: see
    vtkInteractorStyleHaptic.CheckShownVolumes(). The warning also comes if the plotter changes later.
    """
    if getattr(plotter, "iren", None) is None:
        if not hasattr(plotter, "iren"):
            raise TypeError(f"haptics are added to a pyvista.Plotter, not to {type(plotter).__name__}")
        raise ValueError("the plotter is closed. Cure: make a new one")
    if plotter in _touchable:
        raise ValueError("the plotter is touchable already. Cure: close() what add_haptics() has returned before")
    if preset is not None and not isinstance(preset, str):
        if times is not None:
            raise TypeError("add_haptics() takes the times of frames once")
        times, preset = preset, None
    if preset is not None and "property" in settings:
        raise TypeError("add_haptics() takes a preset or a property, not both: call the property's ApplyPreset()")
    frames = None
    if isinstance(volume, (list, tuple)):
        if isinstance(device, (list, tuple)):
            raise ValueError("a volume that moves is felt by one hand, because the other one would feel it at another "
                             "time. Cure: give one device")
        frames = _frames_of(volume, times)
        volume = _actor_of(plotter, frames.GetTimeStepImage(0))
    elif times is not None:
        raise TypeError("times are those of frames. Cure: add_haptics(plotter, [first, second, ...], times)")
    is_alone = mode is not None or labels is not None or visibility is not True or preset == "propose"
    takes_any = volume is None and not is_alone
    volume = _find_volume(plotter, is_alone) if volume is None else volume
    large = volume if isinstance(volume, vtkHapticRegionSource) else None
    if large is not None:
        volume = _show_coarse(plotter, large)
    grid = volume if is_grid(volume) else None
    if large is not None:
        image = frame_of(large)
    else:
        image = _image_of(volume) if grid is None else overview(grid)
    scalars = image.GetPointData().GetScalars()
    has_modes = mode is not None or grid is not None
    if large is None and not has_modes and scalars is None:
        raise ValueError("the volume has no active point scalars. Cure: image.set_active_scalars(NAME), or "
                         "image.cells_to_points() if it has cell data")
    if large is None and not has_modes and scalars.GetNumberOfComponents() > 1 and "property" not in settings:
        raise ValueError(f"the volume has {scalars.GetNumberOfComponents()} components, such as colours, and a hand "
                         "feels one. Cure: property=p, where p.SetComponent(0) of a vtkHapticProperty says which")
    haptics = Haptics(plotter, _renderer_of(plotter, volume))
    haptics._feels_hidden = visibility is not True
    # The widget itself finds volumes in the window; other data must be set in the filter.
    is_found = isinstance(volume, vtkVolume) and visibility is True and large is None and frames is None
    look = volume if visibility is True else visibility
    try:
        _prepare(haptics, large or (image if grid is None else grid), image, preset, mode, look.GetProperty() if isinstance(look, vtkVolume) else None,
                 settings, labels, materials)
        if frames is not None:
            haptics.frames = frames
            haptics.filter.SetInputConnection(0, frames.GetOutputPort())
        haptics._choose_device(device)
        length = image.GetLength()
        haptics.measured.SetRadius(0.6 * SIZE * length)
        haptics.measurements.SetPathSpacing(0.5 * min(image.GetSpacing()))
        if is_found:
            haptics.filter.SetInputDataObject(0, None)
            haptics.widget.SetVolume(None if takes_any else volume)
        else:
            haptics.representation.SetRadius(SIZE * length)
            # round the number, which is shown to the user
            haptics.representation.SetForceScale(1.0 / float(f"{ARROW * length:.1g}"))
        haptics._attach(plotter, [volume] if isinstance(volume, vtkVolume) and not takes_any else [])
        if is_found and haptics.style.GetTouchedVolume() is None:  # the volume is hidden, or can't be touched
            with Errors(haptics.style) as errors:
                haptics.style.TouchVolume(volume)
            if errors:
                raise ValueError("; ".join(errors))
        if large is not None:
            haptics._frame(large)
        if slices:
            haptics._show_slices(plotter, image if grid is not None else None)
        for text in haptics._check_volumes():
            warnings.warn(text, stacklevel=2)
        if frames is not None:
            haptics.device.GetPlayback().SetModeToLoop()
            haptics.device.GetPlayback().Play()
    except BaseException:
        haptics.close()  # otherwise, an interactive session would keep the exception and thus the plotter alive
        raise
    return haptics


def _prepare(
    haptics: Haptics,
    volume: vtkDataSet | vtkCompositeDataSet | vtkHapticRegionSource,
    image: vtkImageData,
    preset: str | None,
    mode: str | None,
    look: Any,
    settings: dict[str, Any],
    labels: Labels | None,
    materials: Materials | None,
) -> None:
    touch = haptics.filter
    is_large = isinstance(volume, vtkHapticRegionSource)
    known = volume.GetCoarseImage() if is_large else image
    with Errors(touch, touch.GetProperty()) as errors:
        large = volume if is_large else None
        configure(touch, known or image, preset, settings, errors, "add_haptics", large)
        if look is not None:
            touch.GetProperty().SetVisibilityFrom(look)
        if is_large:
            touch.SetInputConnection(volume.GetOutputPort())
        else:
            touch.SetInputDataObject(0, volume)
        choose_mode(touch, volume, known, mode, preset, settings, errors)
        set_labels(touch, image, labels, materials)
        touch.Update()  # without a path, this only validates the input
    if errors:
        raise ValueError("; ".join(errors))
