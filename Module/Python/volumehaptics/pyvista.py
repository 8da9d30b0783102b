# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volume haptics for PyVista: PyVista's data in, PyVista's data out, and plotters whose volume can be touched.

    import pyvista as pv
    from volumehaptics.pyvista import add_haptics, touch

    path = pv.Line(pointa=(0, -120, 60), pointb=(0, -75, 60), resolution=1000)
    trace = touch(head, path, "CT contrast")
    trace.plot(scalars="Force", line_width=5)        # N

    plotter = pv.Plotter()
    add_haptics(plotter, plotter.add_volume(head), "CT contrast")
    plotter.show()                                   # press t with the pointer on the volume

    plotter.add_volume(beats[0])                     # or images in a list, the frames of a volume that moves
    add_haptics(plotter, beats, [0.0, 0.1, 0.2])     # and their times (s): it plays

Needs PyVista 0.47 or later, which `import volumehaptics` alone does not: pip install pyvista.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

try:
    import pyvista as pv
except ImportError as error:
    raise ImportError("volumehaptics.pyvista needs PyVista. Cure: pip install pyvista") from error
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from ._plotting import Haptics, _touchable, add_haptics
from ._touch import touch as _touch

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Haptics", "add_haptics", "touch"]

BACKEND = "haptics"

def show_in_notebook(plotter: pv.Plotter, **settings: Any) -> Any:
    """Shows a plotter in a notebook, as PyVista's back end "haptics". A touchable plotter is shown as by
    volumehaptics.web.show(), other plotters as PyVista would show them without this back end. PyVista calls this
    function; an entry point registers it."""
    if plotter in _touchable:
        from .web import show_plotter

        return show_plotter(plotter, **settings)
    from pyvista.jupyter.notebook import handle_plotter

    # Follow PyVista's own order: a back end that the program has registered, "trame", then one from another package.
    others = {one.name: ":" in one.source for one in pv.registered_jupyter_backends() if one.name != BACKEND}
    ranked = sorted(others, key=lambda name: (others[name], name != "trame"))
    return handle_plotter(plotter, backend=ranked[0] if ranked else "static", **settings)


if hasattr(pv, "register_jupyter_backend"):  # available since PyVista 0.48
    from importlib.metadata import entry_points

    # Register the back end if the package was not installed by pip, because its entry points are then missing.
    if BACKEND not in entry_points(group="pyvista.jupyter_backends").names:
        pv.register_jupyter_backend(BACKEND, show_in_notebook, override=True)


@overload
def touch(
    volume: vtkImageData | np.ndarray,
    tip: vtkPolyData | np.ndarray,
    preset: str | None = None,
    *,
    scalars: str | None = None,
    **settings: Any,
) -> pv.PolyData: ...


@overload
def touch(
    volume: vtkImageData | np.ndarray,
    tip: Sequence[vtkPolyData | np.ndarray],
    preset: str | None = None,
    *,
    scalars: str | None = None,
    **settings: Any,
) -> list[pv.PolyData]: ...


def touch(
    volume: vtkImageData | np.ndarray,
    tip: vtkPolyData | np.ndarray | Sequence[vtkPolyData | np.ndarray],
    preset: str | None = None,
    *,
    scalars: str | None = None,
    **settings: Any,
) -> pv.PolyData | list[pv.PolyData]:
    """Computes the forces on a hand whose stylus moves through a volume, as pyvista.PolyData: volumehaptics.touch().

    volume: a pyvista.ImageData with point data, or a NumPy array [z, y, x]. It is not copied.
    tip: positions of the stylus in world units (mm), one point a tick, 1 ms: a pyvista.PolyData, such as from
        pyvista.Line or pyvista.Spline, or an array of shape (N, 3). With a point array "Time" (s), ticks are
        made along it: spline["Time"] = spline["arc_length"] / 80 is 80 mm/s. A list of these is several paths, which
        are felt as if each were alone, and on all cores: the result is the list of their traces, in this order.
    preset: how the tissues feel: see vtkHapticProperty. Default: 500 N/m everywhere. "propose": as the volume's
        own edges suggest; or a file ".json": both as in volumehaptics.touch().
    scalars: the name of the point array that is felt. Default: the active scalars.
    settings: of vtkVolumeHapticsFilter, in snake_case, and labels and materials, as for volumehaptics.touch().

    The trace has a point for each tick, at the proxy (world units), in one polyline; trace["Force"] is the force on the
    hand (N), and vtkVolumeHapticsFilter lists the other arrays. Errors: as for volumehaptics.touch(), and KeyError for
    unknown scalars.

    >>> from volumehaptics import examples
    >>> from volumehaptics.pyvista import touch
    >>> touch(examples.phantom(), examples.stroke(), "CT contrast")["Force"].shape[1]
    3
    """
    if scalars is not None:
        volume = pv.wrap(volume)
        if scalars not in volume.point_data:
            there = ", ".join(map(repr, volume.point_data.keys())) or "none"
            raise KeyError(f"the volume has no point array {scalars!r}. There are: {there}")
        settings["input_array_to_process"] = (0, 0, 0, 0, scalars)
    if isinstance(volume, vtkImageData) and not volume.GetPointData().GetNumberOfArrays() and \
            volume.GetCellData().GetNumberOfArrays():
        raise ValueError("the volume has cell data only. Cure: volume.cell_data_to_point_data(), or "
                         "volume.cells_to_points(), which copies nothing")
    trace = _touch(volume, tip, preset, **settings)
    return [pv.wrap(one) for one in trace] if isinstance(trace, list) else pv.wrap(trace)
