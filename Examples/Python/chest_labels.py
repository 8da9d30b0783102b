# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stroke the labelled organs of a chest CT: a hand moves down over lung, heart, liver and stomach.

python3 chest_labels.py FOLDER [--picture FILE]

FOLDER has a chest CT, cxr.nii.gz, the labels of its organs, mask.nii.gz, and their names, structures.csv, by
TotalSegmentator: `. Data/scans.sh; get_chest_ct FOLDER`. Bones and skin are shown, but not felt. The stiffnesses are
examples.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkBillboardTextActor3D
from volumehaptics import vtkHapticLabelTable, vtkVolumeHapticsFilter

from force_scene import make_actor, make_bar, make_colours, make_renderer, show
from scan_scene import make_image, make_surface, read_scan

# Colour and stiffness (N/m) of organs, by the beginning of the names of their labels.
ORGANS = {
    "lung": ((0.86, 0.66, 0.66), 200.0),
    "heart": ((0.80, 0.28, 0.26), 700.0),
    "liver": ((0.60, 0.30, 0.22), 500.0),
    "stomach": ((0.90, 0.72, 0.50), 300.0),
    "spleen": ((0.55, 0.32, 0.45), 400.0),
}
BONES = ("rib_", "vertebrae", "sternum", "clavicula", "scapula", "humerus")
BODY = -300  # HU
EVERY = 2  # number of voxels from one sample to the next along x and y
DEEP = 2.5  # mm: depth of the hand below the surface of the organs
STRENGTH = 3.0  # N, more than any force of the hand, so that no organ is punctured
SPEED = 60.0  # mm/s


def read(file):
    """Returns samples [z, y, x], with x to the left, y to the back and z to the top, and their spacing (mm)."""
    samples, spacing, place = read_scan(file)
    turned = [place is not None and place.GetElement(axis, axis) * wanted < 0 for axis, wanted in enumerate((-1, -1, 1))]
    samples = samples[tuple(slice(None, None, -1 if turn else 1) for turn in turned[::-1])][:, ::EVERY, ::EVERY]
    return np.ascontiguousarray(samples), spacing * (EVERY, EVERY, 1)


def name_labels(file):
    """Returns a table with materials for ORGANS, in which no other label is felt, and the labels of each organ and of
    bones."""
    table = vtkHapticLabelTable()
    if not table.ReadFile(str(file)):
        raise SystemExit(f"{file} has no names of labels.")
    members = {kind: [] for kind in (*ORGANS, "bone")}
    for index in range(table.GetNumberOfLabels()):
        label = table.GetLabel(index)
        name = table.GetLabelName(label)
        kind = next((kind for kind in ORGANS if name.startswith(kind)), None)
        table.SetFelt(label, kind is not None)
        if kind:
            table.SetStiffness(label, ORGANS[kind][1])
            table.SetFriction(label, 0.2)
            table.SetViscosity(label, 0.05)
            table.SetSurfaceStrength(label, STRENGTH)
        members[kind or "bone"] += [label] if kind or name.startswith(BONES) else []
    table.SetFelt(0, False)
    return table, members


def make_path(felt, across, spacing):
    """Makes the tip's path (mm), a point in each millisecond: from the top to the bottom of the felt organs, along
    their front."""
    slab = felt[:, :, across - 3:across + 4].any(axis=2)  # [z, y]
    rows = np.nonzero(slab.any(axis=1))[0]
    fronts = (slab[rows].argmax(axis=1) - 0.5) * spacing[1]  # walls are between voxels
    # half of the width of the moving mean, which turns steps into a smooth path
    width = max(1, int(6.0 / spacing[2]))
    fronts = np.convolve(np.pad(fronts, width, "edge"), np.full(2 * width + 1, 1.0 / (2 * width + 1)), "valid")
    z, y = rows[::-1] * spacing[2], fronts[::-1] + DEEP
    way = np.append(0.0, np.cumsum(np.hypot(np.diff(z), np.diff(y))))
    at = np.arange(0.0, way[-1], 1e-3 * SPEED)
    # lead-in and lead-out, in which the depth rises and falls
    lead = np.clip((20.0 - np.minimum(at, way[-1] - at)) / 20.0, 0.0, 1.0) * (DEEP + 10.0)
    points, path = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.stack(
        [np.full_like(at, across * spacing[0]), np.interp(at, way, y) - lead, np.interp(at, way, z)], -1), deep=True))
    path.SetPoints(points)
    return path


def feel(hu, labels, spacing, table, path):
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(0, make_image(hu, spacing))
    haptics.SetInputData(1, path)
    haptics.SetLabelData(make_image(labels, spacing))
    haptics.SetLabelTable(table)
    haptics.SetGeometryFromLabels()
    haptics.Update()
    return haptics.GetOutput()


def surface(inside, spacing, colour, opacity=1.0):
    # padded, so that the surface is closed at the volume's border
    actor = make_surface(np.pad(inside, 2), spacing, colour, opacity, deviation=1.2)
    actor.SetPosition(-2.0 * spacing)
    return actor


def write_name(text, place):
    name = vtkBillboardTextActor3D()
    name.SetInput(text)
    name.SetPosition(place)
    name.SetDisplayOffset(30, 0)
    look = name.GetTextProperty()
    look.SetFontSize(20)
    look.SetColor(1.0, 1.0, 1.0)
    look.SetBackgroundColor(0.07, 0.08, 0.11)
    look.SetBackgroundOpacity(0.75)
    return name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="with cxr.nii.gz, mask.nii.gz and structures.csv")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    chosen = parser.parse_args()
    files = [chosen.folder / name for name in ("cxr.nii.gz", "mask.nii.gz", "structures.csv")]
    if not all(file.exists() for file in files):
        parser.error(f"{chosen.folder} lacks one of {', '.join(file.name for file in files)}: get them with "
                     "`. Data/scans.sh; get_chest_ct FOLDER`")
    (hu, spacing), (labels, _) = read(files[0]), read(files[1])
    table, members = name_labels(files[2])
    inside = {kind: np.isin(labels, members[kind]) for kind in members}
    felt = np.logical_or.reduce([inside[kind] for kind in ORGANS])
    if not inside["heart"].any():
        raise SystemExit("There is no heart among the labels.")
    path = make_path(felt, int(np.median(np.nonzero(inside["heart"].any(axis=(0, 1)))[0])), spacing)
    trace = feel(hu, labels, spacing, table, path)

    data = trace.GetPointData()
    force, touched = np.linalg.norm(vtk_to_numpy(data.GetArray("Force")), axis=1), vtk_to_numpy(data.GetArray("Label"))
    proxy, held = vtk_to_numpy(trace.GetPoints().GetData()), vtk_to_numpy(data.GetArray("Contact")) > 0
    colours, names = make_colours(), []
    for kind in ORGANS:
        here = np.nonzero(np.isin(touched, members[kind]) & held)[0]
        if len(here):
            print(f"{kind}: {np.median(force[here]):.2f} N as a median, {force[here].max():.2f} N at most")
            names.append((f"{kind}, {np.median(force[here]):.1f} N", proxy[here[len(here) // 2]]))
    line = make_actor(trace, radius=3.0, colours=colours)
    line.SetPosition(0.0, -6.0, 0.0)  # in front of the organs, at the depth of the proxy
    scene = make_renderer(
        *[surface(inside[kind], spacing, colour) for kind, (colour, _) in ORGANS.items() if inside[kind].any()],
        surface(inside["bone"], spacing, (0.95, 0.92, 0.84), 0.25), surface(hu > BODY, spacing, (0.93, 0.73, 0.62), 0.07),
        line, make_bar(colours))
    camera = scene.GetActiveCamera()
    middle = 0.5 * spacing * (np.array(hu.shape[::-1]) - 1)
    camera.SetFocalPoint(middle)
    camera.SetPosition(middle + [120.0, -900.0, 160.0])
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(22.0)
    for name, place in names:  # moves the name towards the eye on its line of sight, so that nothing hides it
        scene.AddViewProp(write_name(name, 0.6 * place + 0.4 * np.array(camera.GetPosition())))
    scene.ResetCameraClippingRange()
    show(scene, chosen.picture)


if __name__ == "__main__":
    main()
