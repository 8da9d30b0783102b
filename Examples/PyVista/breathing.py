# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A scan that breathes: displacements describe its motion, and rising tissue pushes a hand that rests in the air above.

The breath is the formula in Data/moving.py: everything moves down by up to 12 mm, and back. The hand rests where a
surface below air, such as the diaphragm of a chest CT, is at the end of breathing out.
"""
import argparse
import pathlib
import sys

import gallery
import numpy as np
import pyvista as pv
from volumehaptics import examples
from volumehaptics.pyvista import add_haptics
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Data"))
import moving  # noqa: E402

SECONDS = 2.0  # duration of breathing in
STIFFNESS, STRENGTH = 0.5, 3.0  # N/mm, N
AIR, TISSUE = -600, -200  # HU, below and above the surface
DEEP = 4.0  # mm: depth of the hand below the moving surface, at most half of the surface's motion

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("volume", nargs="?", help="a NIfTI file of a CT, or what PyVista reads (default: the phantom)")
parser.add_argument("--every", type=int, default=1, help="takes every so manieth voxel along x and y")
parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
parser.add_argument("--movie", metavar="FILE", help="write a movie of a breath (.ogv)")
parser.add_argument("--pictures", type=int, default=24, help="of the movie (default: %(default)s)")
chosen = parser.parse_args()
FRAMES = 13 if chosen.movie else 5  # number of frames of breathing in


def read(file):
    """Returns values (HU) [z, y, x], with x to the left, y to the back and z to the top, and their spacing (mm)."""
    if not str(file).endswith((".nii", ".nii.gz")):
        scan = pv.read(file) if file else pv.wrap(examples.phantom())
        return np.asarray(scan.active_scalars).reshape(scan.dimensions[::-1]), scan.spacing
    reader = vtkNIFTIImageReader()
    reader.SetFileName(file)
    reader.Update()
    scan = pv.wrap(reader.GetOutput())
    hu = np.asarray(scan.active_scalars).reshape(scan.dimensions[::-1]) + reader.GetRescaleIntercept()
    # signs that turn the image's axes to the right, the front and the top
    to_patient = reader.GetSFormMatrix() or reader.GetQFormMatrix()
    signs = [to_patient.GetElement(axis, axis) if to_patient else 1.0 for axis in range(3)]
    return hu[::1 if signs[2] > 0 else -1, ::-1 if signs[1] > 0 else 1, ::-1 if signs[0] > 0 else 1], scan.spacing


values, spacing = read(chosen.volume)
values = np.ascontiguousarray(values[:, ::chosen.every, ::chosen.every], np.int16)
spacing = np.multiply(spacing, (chosen.every, chosen.every, 1))
origin = -0.5 * spacing * (np.array(values.shape[::-1]) - 1)
breath = moving.Breath(values, origin, spacing)


def frame(number):
    """Returns the scan at a frame, with the displacements to the next frame."""
    image = pv.ImageData(dimensions=values.shape[::-1], spacing=spacing, origin=origin)
    hu, motion = breath.frame(number, 2 * FRAMES - 2)
    image["HU"], image["motion"] = hu.ravel(), motion.reshape(-1, 3)
    image.set_active_scalars("HU")
    return image


def gaussian(volume):
    """Smooths a volume, so that noise does not disturb the direction of its surfaces."""
    for axis in (0, 1, 2):
        for _ in range(4):
            volume = 0.5 * volume + 0.25 * (np.roll(volume, 1, axis) + np.roll(volume, -1, axis))
    return volume


def find_surface():
    """Finds the level tissue below air that moves down most. Returns its position, and how far it moves down (mm)."""
    # Select voxels of tissue that have air in the four voxels above them.
    above = np.stack([values[1 + i:values.shape[0] - 3 + i] < AIR for i in range(4)]).all(axis=0)
    depth = breath.depth(np.broadcast_to(breath.axes[2][:, None, None], values.shape))
    across = gaussian(values.astype(np.float32))
    slopes = [np.abs(np.gradient(across, step, axis=axis)) for axis, step in enumerate(spacing[::-1])]
    level = slopes[0] > 0.98 * np.sqrt(sum(slope * slope for slope in slopes))
    falls = np.where(above & level[:-4] & (values[:-4] >= AIR), depth[:-4], 0.0)
    k, j, i = np.unravel_index(falls.argmax(), falls.shape)
    middle = 0.5 * (AIR + TISSUE)
    below = next(z for z in range(k + 1, -1, -1) if values[z, j, i] >= middle)
    share = (values[below, j, i] - middle) / (float(values[below, j, i]) - values[below + 1, j, i])
    z = np.interp(below + share, np.arange(values.shape[0]), breath.axes[2])
    return (breath.axes[0][i], breath.axes[1][j], z), falls.max()


hidden = chosen.picture is not None or chosen.movie is not None
frames = [frame(number) for number in range(FRAMES)]
place, fall = find_surface()
deep = min(DEEP, 0.5 * fall)
rest = (place[0], place[1], place[2] - deep)

plotter = gallery.make_plotter("" if hidden else None, (640, 480) if chosen.movie else (1000, 750))
body = plotter.add_volume(
    frames[0], clim=(-1000, 1000), cmap=gallery.CHEST, opacity=gallery.CHEST_OPACITY, shade=True, ambient=0.25,
    diffuse=0.8, specular=0.15, opacity_unit_distance=6, show_scalar_bar=False)
body.prop.interpolation_type = "linear"
haptics = add_haptics(plotter, frames, np.linspace(0.0, SECONDS, FRAMES), visibility=False)
haptics.filter.SetDisplacementArrayName("motion")
# Faint edges inside the lung would push the hand before it reaches the surface, so give them no strength.
haptics.filter.GetProperty().GetSurfaceStrength().AddPoint(AIR, 0.0)
haptics.filter.GetProperty().GetSurfaceStrength().AddPoint(TISSUE, STRENGTH)
for tissue, low, high in (("lung", -950, -600), ("fat", -150, -20), ("muscle or an organ", -20, 150), ("bone", 150, 3000)):
    haptics.head_up_display.AddTissue(tissue, low, high)  # HU
device = haptics.device
device.GetPlayback().SetModeToPingPong()
device.GetPlayback().SetDataTime(SECONDS)
plotter.view_vector((0.25, -1.0, 0.15), (0, 0, 1))
plotter.camera.zoom(1.5)
plotter.camera.SetWindowCenter(-0.26, 0.0)  # leaves room for the diagrams
plotter.show(interactive_update=True)
device.GetVirtualHand().Place(*rest)
device.Arm()

scene = gallery.Scene(plotter, haptics, hidden)
strongest = scene.strongest(2.0 * SECONDS + 1.0)
print(f"strongest {strongest:.3f} N of {STIFFNESS * deep:.3f} N, by what goes down by {fall:.1f} mm")
if chosen.movie:
    scene.film(chosen.movie, chosen.pictures, span=2.0 * SECONDS, rate=max(1, chosen.pictures // 3))
    device.GetPlayback().SetSpeed(1.0)
if chosen.picture:
    scene.watch(8.0, lambda: device.GetPlayback().GetDataTime() < 0.02 * SECONDS)  # after breathing out
    scene.take(chosen.picture)
elif not chosen.movie:
    plotter.show()  # press t with the pointer on the surface to touch it; space pauses
plotter.close()
