# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A ball beats and pushes a resting hand. The servo plays the frames, and the window shows what the hand feels."""
import argparse
import math

import gallery
import numpy as np
import pyvista as pv
from volumehaptics.pyvista import add_haptics

RADIUS, STROKE, REST = 20.0, 2.0, 19.0  # mm: mean radius of the ball, amplitude of the radius, height of the hand
FRAMES = 24  # number of frames in a beat, which takes one second
STIFFNESS = 0.5  # N/mm

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
parser.add_argument("--movie", metavar="FILE", help="write a movie of a beat (.ogv), half as fast")
parser.add_argument("--pictures", type=int, default=FRAMES, help="of the movie (default: %(default)s)")
chosen = parser.parse_args()


def radius(at):
    return RADIUS + STROKE * math.sin(2.0 * math.pi * at)


def frame(at):
    """Returns the ball at a time (s): 1000 inside, 0 outside, with an edge of 1.5 mm."""
    grid = pv.ImageData(dimensions=(41, 41, 41), spacing=(1.5,) * 3, origin=(-30.0,) * 3)
    distance = np.linalg.norm(grid.points, axis=1)
    grid["value"] = (500.0 * (1.0 - np.tanh((distance - radius(at)) / 1.5))).astype(np.float32)
    return grid


times = [i / FRAMES for i in range(FRAMES)]
frames = [frame(at) for at in times]
hidden = chosen.picture is not None or chosen.movie is not None
plotter = gallery.make_plotter("" if hidden else None, (640, 480) if chosen.movie else (1000, 750))
ball = plotter.add_volume(
    frames[0], clim=(0, 1000), opacity=[0.0, 0.05, 0.5, 0.6, 0.7], cmap=["#3c4758", "#b13a4c", "#e0977d"], shade=True,
    opacity_unit_distance=3, show_scalar_bar=False)
ball.prop.interpolation_type = "linear"
haptics = add_haptics(plotter, frames, times, visibility=False)
# N, more than any force of the hand, so that the surface is never punctured
haptics.filter.GetProperty().GetSurfaceStrength().AddPoint(0.0, 3.0)
haptics.head_up_display.AddTissue("the ball", 400, 1000)
device = haptics.device
plotter.view_vector((0.3, -1.0, 0.25), (0, 0, 1))
plotter.camera.zoom(1.2)
plotter.camera.SetWindowCenter(-0.16, 0.0)  # leaves room for the diagrams
plotter.show(interactive_update=True)

device.GetVirtualHand().Place(REST, 0.0, 0.0)
device.Arm()

scene = gallery.Scene(plotter, haptics, hidden)
strongest = scene.strongest(2.5)
print(f"strongest {strongest:.3f} N of {STIFFNESS * (RADIUS + STROKE - REST):.3f} N")

if chosen.movie:
    scene.film(chosen.movie, chosen.pictures, span=1.0, rate=max(1, chosen.pictures // 2))
if chosen.picture:
    device.GetPlayback().SetSpeed(0.25)
    scene.watch(8.0, lambda: abs(device.GetPlayback().GetDataTime() - 0.25) < 0.02)  # when the ball is largest
    scene.take(chosen.picture)
elif not chosen.movie:
    plotter.show()  # press t with the pointer on the ball to touch it; space pauses
plotter.close()
