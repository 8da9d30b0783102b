# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that the gallery's scripts share: options, paths over a head, the look of a picture, and how to show it."""
import argparse
import time

import numpy as np
import pyvista as pv
from matplotlib.colors import LinearSegmentedColormap
from volumehaptics import examples
from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

# Colours and opacities from -600 to 1000 HU: skin, soft tissue, bone.
SKIN = LinearSegmentedColormap.from_list(
    "skin", ["#d8997a", "#edb08f", "#e5a083", "#e0977d", "#e6b9a0", "#f5ebd8", "#faf2e4", "#ffffff"])
OPACITY = [0.0, 0.35, 0.35, 0.2, 0.14, 0.6, 0.9, 0.98]
# Colours and opacities from -1000 to 1000 HU: the lung's surface, translucent soft tissue, and bone.
CHEST = LinearSegmentedColormap.from_list(
    "chest", ["#6a5560", "#c98f86", "#d8997a", "#e0977d", "#d9725f", "#f0dcc0", "#faf2e4", "#ffffff", "#ffffff"])
CHEST_OPACITY = [0.0, 0.0, 0.07, 0.05, 0.03, 0.45, 0.8, 0.95, 0.98]
COLOURS = ["#1f6fb4", "#e0701a", "#2a9d4f", "#b13a7c", "#6b57b8"]


def options(about, volume=True):
    """Reads the options. Returns the head, if the script needs one, and the picture's file (None for a window)."""
    parser = argparse.ArgumentParser(description=about)
    if volume:
        parser.add_argument(
            "volume", nargs="?", help="a CT in Hounsfield units that PyVista reads (default: the package's phantom)")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    chosen = parser.parse_args()
    if not volume:
        return chosen.picture
    return pv.read(chosen.volume) if chosen.volume else pv.wrap(examples.phantom()), chosen.picture


def over_skin(head, directions, depth, speed=80.0):
    """Returns a path at a speed (mm/s), below those points of the skin where rays from the middle leave the head.

    depth: depth below the skin (mm) for each direction; negative in the air.
    """
    skin = head.contour([-300.0])
    middle = np.asarray(head.center)
    ways = np.asarray(directions, float)
    ways /= np.linalg.norm(ways, axis=1)[:, None]
    ends = [skin.ray_trace(middle + head.length * way, middle, first_point=True)[0] for way in ways]
    return at_speed(np.array(ends) - np.broadcast_to(depth, len(ways))[:, None] * ways, speed)


def at_speed(points, speed):
    """Returns a smooth path through points (mm) at a speed (mm/s), with the array Time (s)."""
    way = pv.Spline(np.asarray(points, float), 20 * len(points))
    way["Time"] = way["arc_length"].astype(float) / speed
    return way


def strength(trace):
    """Returns the magnitude of the force in each tick (N)."""
    return np.linalg.norm(trace["Force"], axis=1)


def make_plotter(picture, size=(1000, 750), shape=(1, 1)):
    plotter = pv.Plotter(off_screen=picture is not None, shape=shape, window_size=size, border=False)
    plotter.set_background("#12151b", top="#3c4758")
    return plotter


def add_head(plotter, head, opacity=OPACITY):
    """Adds the head to a plotter. Returns what plotter.add_volume() returns."""
    skin = plotter.add_volume(
        head, clim=(-600, 1000), opacity=opacity, cmap=SKIN, shade=True, ambient=0.2, diffuse=0.85, specular=0.2,
        opacity_unit_distance=4, show_scalar_bar=False)
    skin.prop.interpolation_type = "linear"
    return skin


def add_trail(plotter, trace, largest=None, bar=True, width=9):
    """Adds the trail of the proxy, coloured by the force on the hand, up to the largest force (N)."""
    # Drop repeated points: a proxy in static friction stays in place for many ticks.
    steps = np.floor(np.append(0, np.cumsum(np.linalg.norm(np.diff(trace.points, axis=0), axis=1))) / 0.3)
    kept = np.append(True, np.diff(steps) > 0)
    trail = pv.MultipleLines(points=trace.points[kept])
    trail["newtons"] = strength(trace)[kept]
    where = {"title": "Force (N)", "vertical": True, "color": "white", "position_x": 0.87, "position_y": 0.22,
             "height": 0.56, "width": 0.06, "n_labels": 6, "fmt": "%.1f", "title_font_size": 20,
             "label_font_size": 17}
    plotter.add_mesh(
        trail, scalars="newtons", cmap="turbo", clim=(0, largest or np.ceil(trail["newtons"].max())), line_width=width,
        render_lines_as_tubes=True, show_scalar_bar=bar, scalar_bar_args=where if bar else None)
    if bar:
        plotter.scalar_bars["Force (N)"].SetVerticalTitleSeparation(12)


def add_title(plotter, text, colour="white"):
    title = plotter.add_text(text, position=(0.018, 0.945), viewport=True, font_size=11, color=colour, shadow=True)
    if colour == "white":  # background that keeps the text readable in front of bright objects
        title.prop.background_color, title.prop.background_opacity = "#12151b", 0.75


def add_chart(plotter, title, x_label, y_label, curves, legend=("left", "top")):
    """Fills the active subplot with a chart of curves, {label: (x, y)} or {label: (x, y, colour)}."""
    plotter.set_background("white", all_renderers=False)
    chart = pv.Chart2D(size=(0.97, 0.95), loc=(0.0, 0.02), x_label=x_label, y_label=y_label)
    chart.title = title + "\n"  # an empty line separates the title from the legend
    chart.border_color = "white"
    for colour, (label, curve) in zip(COLOURS, curves.items()):
        chart.line(curve[0], curve[1], color=curve[2] if len(curve) > 2 else colour, width=2.5, label=label)
    lowest, highest = (limit([limit(curve[1]) for curve in curves.values()]) for limit in (np.nanmin, np.nanmax))
    chart.y_range = (min(0.0, 1.3 * lowest), 1.3 * highest)  # leave room for the legend
    for axis in (chart.x_axis, chart.y_axis):
        axis.label_size, axis.tick_label_size = 17, 14
    chart.GetTitleProperties().SetFontSize(19)
    chart.legend_visible = len(curves) > 1
    chart.GetLegend().SetLabelSize(15)
    chart.GetLegend().SetHorizontalAlignment(("left", "center", "right").index(legend[0]))
    chart.GetLegend().SetVerticalAlignment({"top": 3, "bottom": 4}[legend[1]])
    plotter.add_chart(chart)
    return chart


class Movie:
    """A movie of a plotter (.ogv), written by VTK's own writer with a number of pictures per second."""

    def __init__(self, plotter, file, rate):
        self.plotter = plotter
        self.capture = vtkWindowToImageFilter()
        self.capture.SetInput(plotter.render_window)
        self.capture.ReadFrontBufferOff()
        self.writer = vtkOggTheoraWriter()
        self.writer.SetFileName(str(file))
        self.writer.SetInputConnection(self.capture.GetOutputPort())
        self.writer.SetRate(rate)

    def __enter__(self):
        self.writer.Start()
        return self

    def __exit__(self, *_):
        self.writer.End()

    def add(self):
        """Adds the picture that is shown now."""
        self.plotter.render()
        self.capture.Modified()
        self.writer.Write()


class Scene:
    """A plotter with haptics, for a program that updates both while it waits."""

    def __init__(self, plotter, haptics, hidden):
        self.plotter, self.haptics, self.hidden = plotter, haptics, hidden

    def watch(self, seconds, see=lambda: False):
        """Updates both for a time (s), as a program with a timer does, or until `see` returns true."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and not self.haptics.closed:
            self.haptics.update()
            if self.haptics.device.GetPlayback().HasTimeSteps() and see():
                break
            time.sleep(0.005) if self.hidden else self.plotter.update()

    def strongest(self, seconds):
        """Returns the largest force (N) within a time (s)."""
        forces = [0.0]
        self.watch(seconds, lambda: forces.append(np.linalg.norm(self.haptics.device.GetState().GetComputedForce())))
        return max(forces)

    def film(self, file, pictures, span, rate):
        """Makes a movie of one loop or ping-pong of the data time, in evenly spaced pictures.

        Time stands still while a picture is taken, however long that takes. Each picture is taken a little more than a
        whole span after the last one, so that the hand touches the moving surface again: while the computer draws a
        picture, the servo may stand still for so long that a contact ends.
        """
        device = self.haptics.device
        # the plot's axis is the time of the hand, not that of the data
        self.haptics.head_up_display.PlotVisibilityOff()
        step = span / pictures
        # so slow that a step takes 0.15 s, in which the data time is polled often
        device.GetPlayback().SetSpeed(step / 0.15)
        attention = device.GetAttentionTime()
        device.SetAttentionTime(600.0)  # a frame takes seconds without a graphics card, longer than the default allows
        last, gone = device.GetPlayback().GetDataTime(), 0.0

        def has_come(place):
            nonlocal last, gone
            way = abs(device.GetPlayback().GetDataTime() - last)
            gone += min(way, span - way)  # the shortest difference, also across the end of a loop
            last = device.GetPlayback().GetDataTime()
            return gone >= place

        with Movie(self.plotter, file, rate) as movie:
            for number in range(pictures):
                device.GetPlayback().Play()
                self.watch(60.0, lambda place=number * (span + step): has_come(place))
                device.GetPlayback().Hold()
                self.watch(0.1)
                movie.add()
        device.SetAttentionTime(attention)
        device.GetPlayback().Play()
        self.haptics.head_up_display.PlotVisibilityOn()

    def take(self, picture):
        """Stops the data time, and writes its picture, without the hint on keys."""
        self.haptics.head_up_display.HintVisibilityOff()
        self.haptics.device.GetPlayback().Hold()
        self.watch(0.3)
        self.plotter.render()
        self.plotter.screenshot(picture)


def show(plotter, picture, direction=None, zoom=1.4):
    """Sets the direction of view, then shows the plotter or writes the picture."""
    if direction is not None:
        plotter.view_vector(direction, (0, 0, 1))
        plotter.camera.zoom(zoom)
    plotter.show(screenshot=picture or False)
