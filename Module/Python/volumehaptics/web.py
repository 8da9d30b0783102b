# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Touch in a browser or in a notebook: the mouse of the page leads the hand, and the page shows what the hand touches.

    python -m volumehaptics --web head.nii.gz        # in the default browser

    haptics = add_haptics(plotter, plotter.add_volume(head), "CT contrast")
    plotter.show(jupyter_backend="haptics")          # in a notebook, or: await volumehaptics.web.show(haptics)
    volumehaptics.web.serve(haptics)                 # in a script; the plotter is not shown before

The servo runs beside the server at its own rate: the connection to the browser delays pictures and the mouse, but never
the force. If the leading page closes or is hidden, or does not answer for 3 s, the touch ends.

Needs PyVista, and trame: pip install pyvista trame trame-vuetify trame-rca.
"""

from __future__ import annotations

import argparse
import asyncio
import socket
import sys
import webbrowser
from typing import TYPE_CHECKING, Any

from ._files import read
from ._webview import View, names_of  # before trame, because its error contains the cure if trame is missing
from ._webdoor import HERE, door_of
from .vtkVolumeHaptics import vtkHapticProperty, vtkVolumeHapticsFilter

from trame.app import get_server

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkImageData

    from ._plotting import Haptics

__all__ = ["View", "main", "serve", "show"]

EVERYWHERE = ("0.0.0.0", "::")
NOTEBOOK = "volumehaptics"  # name of the server that all notebook views share
OPACITY = [0, 0.35, 0.35, 0.2, 0.14, 0.6, 0.9, 1]  # opacities of a head CT between -600 and 1000 HU
MOST_TOLD = 6  # largest number of lines over the picture about assumptions, and about dropped, filled or rotated parts
COLORS = ["#edb08f", "#e0977d", "#f5ebd8", "#ffffff"]


def serve(haptics: Haptics, port: int = 0, host: str = "localhost", open_browser: bool = True) -> None:
    """Serves a touchable plotter to browsers until Ctrl-C.

    haptics: the result of add_haptics() for a plotter that was not shown.
    port: the port; 0 chooses a free one. The address is printed.
        It contains the secret of this server, without which nobody can lead the hand or see anything.
    host: "localhost", or "0.0.0.0" for the whole network, with a UserWarning: the traffic is not encrypted, not even
        the secret.
    """
    server = get_server("volumehaptics-serve", client_type="vue3")
    door_of(server)
    view = View(haptics, server, "main")

    def tell(**_: object) -> None:
        named = "localhost" if host in HERE else socket.gethostname() if host in EVERYWHERE else host
        address = view.get_address(named)
        print(f"Touch it at {address} (Ctrl-C ends)", flush=True)
        if open_browser:
            asyncio.get_running_loop().call_later(0.1, webbrowser.open, address)

    server.controller.on_server_ready.add(tell)
    try:
        server.start(port=port, host=host, open_browser=False, show_connection_info=False, timeout=0, backend="aiohttp")
    finally:
        server.controller.on_server_ready.discard(tell)
        view.close()


class Frame:
    """The HTML that shows a view in a notebook: a frame with the view's page."""

    def __init__(self, view: View, height: int) -> None:
        self.view = view
        self.height = height

    def _repr_html_(self) -> str:
        address = self.view.get_address("localhost", "reconnect=auto")
        return (f'<iframe src="{address}" style="width: 100%; height: {self.height}px; border: 1px solid #ddd">'
                "</iframe>")


async def show(haptics: Haptics, height: int = 600) -> Frame:
    """Shows a touchable plotter in a notebook: await show(haptics) as the last line of a cell.

    The notebook's browser has to reach this computer as localhost. height: height of the frame in pixels."""
    server = get_server(NOTEBOOK, client_type="vue3")
    door_of(server, in_frames=True)
    view = View(haptics, server)
    if not server.running:
        server.start(exec_mode="task", port=0, host="localhost", open_browser=False, show_connection_info=False,
                     disable_logging=True, timeout=0, backend="aiohttp")
    await server.ready
    return Frame(view, height)


def show_plotter(plotter: Any, **_: Any) -> Any:
    """Implements plotter.show(jupyter_backend="haptics") for a touchable plotter: see
    volumehaptics.pyvista.show_in_notebook()."""
    from ._plotting import _touchable

    if plotter not in _touchable:
        raise ValueError('jupyter_backend="haptics" shows touchable plotters. Cure: add_haptics(plotter) before')
    try:
        loop = asyncio.get_running_loop()
    except RuntimeError:
        raise RuntimeError('jupyter_backend="haptics" is for notebooks, whose loop serves the page. Cure: '
                           "volumehaptics.web.serve(haptics)") from None
    try:
        import nest_asyncio2 as nest
    except ImportError:
        try:
            import nest_asyncio as nest
        except ImportError:
            raise ImportError('jupyter_backend="haptics" waits within the notebook\'s loop, which needs nest_asyncio2. '
                              "Cure: pip install nest_asyncio2, or await volumehaptics.web.show(haptics)") from None
    nest.apply()
    return loop.run_until_complete(show(_touchable[plotter], plotter.window_size[1]))


def _threshold(image: Any) -> float:
    """Returns the value that best separates the object from its surroundings, by Otsu's method."""
    import numpy as np

    count, edges = np.histogram(image.active_scalars[::max(1, image.n_points // 1_000_000)], 256)
    middle = 0.5 * (edges[:-1] + edges[1:])
    below = np.cumsum(count)
    above = below[-1] - below
    sums = np.cumsum(count * middle)
    with np.errstate(divide="ignore", invalid="ignore"):
        parted = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
    return float(edges[1 + np.nanargmax(parted[:-1])])


def make_plotter(image: vtkImageData, preset: str | None = None, **settings: Any) -> Haptics:
    """Makes a touchable plotter with a volume. A CT gets the look of its tissues; labels of a file are shown and felt as such;
    any other volume is shown above the value that best separates it from its surroundings."""
    import pyvista as pv

    from .pyvista import add_haptics

    image = pv.wrap(image)
    low, high = map(float, image.get_data_range())
    is_ct = low <= -900 and high >= 1000 and preset in (None, "CT contrast")
    plotter = pv.Plotter(off_screen=True, window_size=(1000, 700))
    plotter.set_background("black", top="slategray")
    if is_ct:
        actor = plotter.add_volume(image, clim=(-600, 1000), opacity=OPACITY, cmap=COLORS, shade=True,
                                   opacity_unit_distance=4, show_scalar_bar=False)
    else:
        has_labels = image.GetFieldData().HasArray("Label") and "labels" not in settings
        if has_labels:
            settings["labels"] = image
        value = 0.5 if has_labels else _threshold(image)
        ramp = 0.1 * (1.0 if has_labels else high - value)
        actor = plotter.add_volume(image, clim=(value - ramp, value + ramp), opacity=[0, 0, 0.3, 0.8, 1], cmap=COLORS,
                                   shade=True, opacity_unit_distance=2 * min(image.spacing), show_scalar_bar=False)
    actor.prop.interpolation_type = "linear"
    if settings.get("iso_value") is None:
        settings["iso_value"] = -300.0 if is_ct else value
    haptics = add_haptics(plotter, actor, preset or ("CT contrast" if is_ct else "propose"), **settings)
    plotter.view_vector((1, -0.8, 0.35), (0, 0, 1))
    return haptics


def main(arguments: list[str]) -> int:
    """Runs python -m volumehaptics --web."""
    parser = argparse.ArgumentParser(prog="python -m volumehaptics --web", description=(
        "Touch a volume in a browser. The mouse of the page leads the hand; the servo runs here."))
    parser.add_argument("volume", nargs="?", help="whatever volumehaptics-explore reads: .vti .mhd .mha .nii .nii.gz .nrrd "
                                                    ".mgz .mnc .tif .zarr, a folder of DICOM slices, a grid, ...")
    parser.add_argument("--demo", action="store_true", help="the head phantom that comes with the package")
    parser.add_argument("--series", type=int, default=0, metavar="N", help="which series of a DICOM folder, segment, channel, time or component of a file, from 1 on")
    parser.add_argument("--preset", choices=[*names_of(vtkHapticProperty.GetPresetNames()), "propose"],
                        help="what the tissues feel like (default: by the values)")
    parser.add_argument("--method", choices=names_of(vtkVolumeHapticsFilter.GetMethodNames()), help="(default: proxy)")
    parser.add_argument("--device", default="virtual", help="the hand (default: virtual, which the mouse leads)")
    parser.add_argument("--port", type=int, default=0, help="(default: a free one)")
    parser.add_argument("--host", default="localhost",
                        help="localhost, or 0.0.0.0 for the whole network, where anyone who listens gets the secret")
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")
    options = parser.parse_args(arguments)
    if options.demo == bool(options.volume):
        parser.error("give one volume, or --demo")
    try:
        told: list[str] = []
        if options.demo:
            from .examples import phantom

            image = phantom()
        else:
            image, told = read(options.volume, options.series, "--series ")
            for note in told:
                print(note)
        haptics = make_plotter(image, options.preset, device=options.device)
        more = [f"and {len(told) - MOST_TOLD} more"] if len(told) > MOST_TOLD else []
        haptics.head_up_display.SetNotice("\n".join(told[:MOST_TOLD] + more))
        if options.method and not haptics.filter.SetMethodByName(options.method):
            return 2
    except (RuntimeError, TypeError, ValueError) as error:
        sys.stderr.write(f"python -m volumehaptics --web: {error}\n")
        return 2
    serve(haptics, options.port, options.host, not options.no_browser)
    haptics.close()
    return 0
