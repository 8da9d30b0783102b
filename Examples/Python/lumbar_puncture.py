# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A lumbar puncture on a CT with labels: a needle between two vertebrae into the spinal canal, and the force on it.

python3 lumbar_puncture.py FOLDER [--picture FILE]

FOLDER has a chest CT, cxr.nii.gz, and the labels of its organs, mask.nii.gz, by TotalSegmentator: `. Data/scans.sh;
get_chest_ct FOLDER`. This script adds tissues without labels: skin, fat and muscle by their Hounsfield units, the canal
as a tube through the holes of the vertebrae, and the ligament behind it, 3 mm thick. The needle takes the path between
the vertebrae L1 and L2 that stays farthest from bone. Strengths and frictions are examples.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkImageSlice, vtkImageSliceMapper, vtkPolyDataMapper, vtkRenderer
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
from volumehaptics import vtkHapticLabelTable, vtkHapticNeedle, vtkVolumeHapticsFilter

from force_scene import make_renderer, show
from scan_scene import make_image, make_surface, read_scan

L2, L1, T12 = 30, 31, 32
# Tissues by label: name, colour, T (N) to puncture, R (N) to cut, tau (N per metre) along the shaft.
TISSUES = {
    1: ("skin", (0.93, 0.73, 0.60), 1.2, 0.3, 20.0),
    2: ("fat", (0.98, 0.90, 0.55), 0.0, 0.1, 5.0),
    3: ("muscle and ligaments between the spines", (0.78, 0.36, 0.34), 0.3, 0.35, 25.0),
    4: ("ligamentum flavum", (0.95, 0.62, 0.15), 0.8, 0.9, 60.0),
    5: ("spinal canal", (0.45, 0.75, 0.95), 0.0, 0.0, 2.0),
    6: ("bone", (0.96, 0.95, 0.88), 30.0, 5.0, 200.0),
}
SKIN, FAT, MUSCLE, LIGAMENT, CANAL, BONE = TISSUES
CANAL_RADIUS, LIGAMENT_THICKNESS, SKIN_THICKNESS = 8.0, 3.0, 2.5  # mm
SPEED = 8.0  # mm/s


def crop(hu, organs):
    """Returns the region around the first lumbar vertebrae, from the skin of the back forwards."""
    z, _, x = np.nonzero((organs == L1) | (organs == L2))
    left = int(x.mean()) - 75
    part = np.s_[z.min():, 60:290, left:left + 150]
    return hu[part], organs[part]


def refine(hu, organs, spacing):
    """Resamples to slices as close as pixels, because skin is thin and a surface needs two voxels to be felt."""
    parts = int(np.ceil(spacing[2] / spacing[0]))
    at = np.arange((len(hu) - 1) * parts + 1) / parts
    below = np.minimum(at.astype(int), len(hu) - 2)
    share = (at - below)[:, None, None]
    between = (1.0 - share) * hu[below] + share * hu[below + 1]
    return between.astype(np.int16), organs[np.round(at).astype(int)], spacing / [1, 1, parts]


def find_canal(organs, spacing):
    """Returns the middle (mm; x, y) of the spinal canal in each slice."""
    middles = {}
    for k, slab in enumerate(organs):
        bone = (slab >= L2) & (slab <= T12)
        # The canal is an empty space that has bone on all four sides.
        hole = ~bone
        for axis in (0, 1):
            before = np.maximum.accumulate(bone, axis)
            behind = np.flip(np.maximum.accumulate(np.flip(bone, axis), axis), axis)
            hole &= before & behind
        if hole.sum() * spacing[0] * spacing[1] > 0.5 * np.pi * CANAL_RADIUS**2:
            y, x = np.nonzero(hole)
            middles[k] = np.median(x) * spacing[0], np.median(y) * spacing[1]
    known = sorted(middles)
    slices = np.arange(len(organs))
    return np.stack([np.interp(slices, known, [middles[k][c] for k in known]) for c in (0, 1)], -1)


def classify(hu, organs, canal, spacing):
    """Returns an image of the labels of TISSUES."""
    labels = np.zeros(hu.shape, np.uint8)
    labels[hu > -250] = FAT
    labels[hu > -30] = MUSCLE
    # Remove the patient's table: everything behind the air that is closest to the back.
    back = np.array([[find_back(row) for row in slab.T] for slab in hu])  # [z, x]
    y = np.arange(hu.shape[1])[None, :, None]
    labels[y < back[:, None, :]] = 0
    below = y - back[:, None, :]
    labels[(below >= 0) & (below < SKIN_THICKNESS / spacing[1])] = SKIN
    x = np.arange(hu.shape[2])[None, None, :] * spacing[0] - canal[:, None, None, 0]
    away = np.hypot(x, y * spacing[1] - canal[:, None, None, 1])
    labels[(away < CANAL_RADIUS + LIGAMENT_THICKNESS) & (y * spacing[1] < canal[:, None, None, 1])] = LIGAMENT
    labels[away < CANAL_RADIUS] = CANAL
    bone = ((organs >= L2 - 1) & (organs <= T12)) | (hu > 300)
    labels[bone & (labels != CANAL) & (labels != 0)] = BONE
    labels[(labels == LIGAMENT) & (organs >= L2 - 1) & (organs <= T12)] = BONE
    return labels


def find_back(values):
    """Returns the index at which the body begins, on a line from the table to the front."""
    body = values > -250
    inside = len(body) - 1
    air = np.nonzero(~body[:inside])[0]
    # Treat the longest run without air as the body.
    edges = np.concatenate([[-1], air, [inside]])
    widest = np.argmax(np.diff(edges))
    return edges[widest] + 1


def find_way(labels, canal, spacing):
    """Returns the entry on the skin and the target in the canal (mm) of the path that stays farthest from bone."""
    bone = np.argwhere(labels == BONE)[:, ::-1] * spacing
    bone = bone[:: max(1, len(bone) // 6000)]
    best = (-1.0, None, None)
    margin, step = (int(np.ceil(reach / spacing[2])) for reach in (12.0, 2.5))
    for k in range(margin, len(labels) - margin, step):
        target = np.array([*canal[k], k * spacing[2]])
        for tilt in np.radians(np.arange(-40.0, 41.0, 4.0)):
            for turn in np.radians((-6.0, 0.0, 6.0)):
                way = np.array([np.sin(turn), np.cos(turn) * np.cos(tilt), np.sin(tilt)])
                there = [target - reach * way for reach in np.arange(0.0, 90.0, 1.0)]
                index = np.round(np.array(there) / spacing).astype(int)
                isin = np.all((index >= 0) & (index < labels.shape[::-1]), axis=1)
                tissue = np.zeros(len(index), int)
                tissue[isin] = labels[tuple(index[isin].T[::-1])]
                out = np.nonzero(tissue == 0)[0]
                if not len(out) or not isin[: out[0] + 1].all() or (tissue[: out[0]] == BONE).any():
                    continue
                line = np.array(there[CANAL_STEPS: out[0]])
                near = bone[np.abs(bone[:, 2] - target[2]) < 60.0]
                clearance = min(np.min(np.linalg.norm(near - p, axis=1)) for p in line[::3])
                if clearance > best[0]:
                    best = clearance, there[out[0]], target
    if best[1] is None:
        raise SystemExit("There is no way between the vertebrae that bone leaves free.")
    return best


CANAL_STEPS = 10  # mm from the canal's centre, within which there is always bone


def make_path(entry, target):
    """Returns the tip's path (mm), a point per millisecond: from 10 mm outside to 8 mm beyond the target, and back."""
    way = (target - entry) / np.linalg.norm(target - entry)
    begin, end = entry - 10.0 * way, target + 8.0 * way
    there = np.arange(0.0, np.linalg.norm(end - begin), 1e-3 * SPEED)
    along = np.concatenate([there, there[::-1]])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(begin + along[:, None] * way, deep=True))
    path = vtkPolyData()
    path.SetPoints(points)
    return path


def feel(hu, labels, spacing, path):
    """Returns the trace of a needle, and the table of tissues."""
    table = vtkHapticLabelTable()
    for label, (name, colour, puncture, cutting, shaft) in TISSUES.items():
        table.SetLabelName(label, name)
        table.SetColor(label, colour)
        table.SetStiffness(label, 500.0)
        table.SetSurfaceStrength(label, puncture)
        table.SetViscosity(label, cutting)
        table.SetShaftFriction(label, shaft)
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(0, make_image(hu, spacing))
    haptics.SetInputData(1, path)
    haptics.SetLabelData(make_image(labels, spacing))
    haptics.SetLabelTable(table)
    haptics.SetGeometryFromLabels()
    haptics.SetTool(vtkHapticNeedle())
    haptics.Update()
    return haptics.GetOutput(), table


def tell(track, table):
    """Prints the tissues that the needle has passed."""
    labels, lengths = (vtk_to_numpy(track.GetCellData().GetArray(name)) for name in ("Label", "Length"))
    for label, length in zip(labels, lengths):
        print(f"{length:6.1f} mm  {table.GetLabelName(int(label)) or 'nothing'}")
    depth, angle = (track.GetFieldData().GetArray(name).GetValue(0) for name in ("Depth", "Angle"))
    print(f"{depth:.1f} mm deep" + (f", {angle:.0f} degrees to the normal of the skin" if angle >= 0.0 else ""))


def draw_needle(track, table):
    """Returns actors of the needle's track, in the colours of the tissues, and of its shaft outside."""
    points = vtk_to_numpy(track.GetPoints().GetData())
    back = points[0] - 60.0 * (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
    labels = vtk_to_numpy(track.GetCellData().GetArray("Label"))
    stretches = [(a, b, table.GetColor(int(label))) for a, b, label in zip(points, points[1:], labels)]
    actors = []
    for a, b, colour in [*stretches, (back, points[0], (0.85, 0.87, 0.9))]:
        line, tube = vtkLineSource(), vtkTubeFilter()
        line.SetPoint1(a)
        line.SetPoint2(b)
        tube.SetInputConnection(line.GetOutputPort())
        tube.SetRadius(1.0)
        tube.SetNumberOfSides(16)
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(tube.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetAmbient(0.35)
        actors.append(actor)
    return actors


def draw_slice(hu, spacing, index):
    """Returns the sagittal slice of the CT through the needle."""
    mapper, slab = vtkImageSliceMapper(), vtkImageSlice()
    mapper.SetInputData(make_image(hu, spacing))
    mapper.SetOrientationToX()
    mapper.SetSliceNumber(index)
    slab.SetMapper(mapper)
    slab.GetProperty().SetColorWindow(500.0)
    slab.GetProperty().SetColorLevel(60.0)
    return slab


def draw_chart(trace, table):
    """Plots the force along the needle against the depth of its tip, in and out, over the tissues in their colours."""
    depth, label = (vtk_to_numpy(trace.GetPointData().GetArray(name)) for name in ("Depth", "Label"))
    force = vtk_to_numpy(trace.GetPointData().GetArray("NormalForce"))
    deepest = int(np.argmax(depth))
    chart = vtkChartXY()
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(0)
    for axis, title in ((vtkAxis.BOTTOM, "depth of the tip (mm)"), (vtkAxis.LEFT, "force along the needle (N)")):
        chart.GetAxis(axis).SetTitle(title)
        for look in (chart.GetAxis(axis).GetTitleProperties(), chart.GetAxis(axis).GetLabelProperties()):
            look.SetColor(0.9, 0.92, 0.95)
            look.SetFontSize(15)
        chart.GetAxis(axis).GetPen().SetColor(200, 205, 215)
        chart.GetAxis(axis).GetGridPen().SetColor(70, 76, 90)
    chart.GetLegend().GetBrush().SetColor(25, 28, 36)
    chart.GetLegend().GetLabelProperties().SetColor(0.9, 0.92, 0.95)
    chart.GetLegend().GetLabelProperties().SetFontSize(14)

    def add(kind, x, y, name, colour, width=2.0, opacity=255):
        data = vtkTable()
        for column, values in (("x", x), (name, y)):
            array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=True)
            array.SetName(column)
            data.AddColumn(array)
        plot = chart.AddPlot(kind)
        plot.SetInputData(data, 0, 1)
        plot.SetColor(*(int(255 * c) for c in colour), opacity)
        plot.SetWidth(width)

    inside = np.arange(len(depth)) <= deepest
    inside &= depth > 0
    changes = np.nonzero(np.diff(label[inside]))[0]
    steps = depth[inside]
    borders = [0.0, *steps[changes + 1], steps[-1]]
    kinds = [label[inside][0], *label[inside][changes + 1]]
    named = set()
    for begin, end, kind in zip(borders, borders[1:], kinds):
        name = table.GetLabelName(int(kind)) or "outside"
        add(vtkChart.LINE, [begin, end], [-0.1, -0.1], "" if kind in named else name, table.GetColor(int(kind)), 14.0)
        named.add(kind)
    add(vtkChart.LINE, depth[: deepest + 1], force[: deepest + 1], "pushed in", (0.98, 0.98, 0.98), 2.5)
    back = np.arange(len(depth)) > deepest
    back &= depth > 0
    add(vtkChart.LINE, depth[back], force[back], "drawn out", (0.35, 0.7, 1.0), 2.0)
    return chart


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="with cxr.nii.gz and mask.nii.gz, of Data/scans.sh")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    chosen = parser.parse_args()
    folder = pathlib.Path(chosen.folder)
    if not (folder / "cxr.nii.gz").exists() or not (folder / "mask.nii.gz").exists():
        parser.error(f"{folder} lacks cxr.nii.gz or mask.nii.gz: get both with `. Data/scans.sh; get_chest_ct FOLDER`")
    hu, spacing, _ = read_scan(folder / "cxr.nii.gz")
    organs, _, _ = read_scan(folder / "mask.nii.gz")
    hu, organs, spacing = refine(*crop(hu, organs), spacing)
    canal = find_canal(organs, spacing)
    labels = classify(hu, organs, canal, spacing)
    clearance, entry, target = find_way(labels, canal, spacing)
    print(f"The way in stays {clearance:.1f} mm from bone.")
    trace, table = feel(hu, labels, spacing, make_path(entry, target))
    track = vtkPolyData()
    if not vtkHapticNeedle.MakeTrack(trace, track) or not track.GetNumberOfCells():
        raise SystemExit("The needle was not inserted.")
    tell(track, table)

    scene = make_renderer(
        make_surface(labels == BONE, spacing, TISSUES[BONE][1], 1.0),
        make_surface(labels == CANAL, spacing, TISSUES[CANAL][1], 0.35),
        make_surface(labels != 0, spacing, TISSUES[SKIN][1], 0.12), *draw_needle(track, table))
    scene.AddViewProp(draw_slice(hu, spacing, int(round(target[0] / spacing[0])) - 12))
    scene.SetViewport(0.0, 0.0, 0.52, 1.0)
    camera = scene.GetActiveCamera()
    camera.SetFocalPoint(target - [0.0, 24.0, 0.0])
    camera.SetPosition(target + [330.0, -150.0, -60.0])
    camera.SetViewUp(0.0, 0.0, -1.0)  # slices run downwards
    camera.SetViewAngle(20.0)
    scene.ResetCameraClippingRange()
    chart = vtkRenderer()
    chart.SetBackground(0.07, 0.08, 0.11)
    chart.SetViewport(0.52, 0.0, 1.0, 1.0)
    actor = vtkContextActor()
    actor.GetScene().AddItem(draw_chart(trace, table))
    chart.AddActor(actor)
    show([scene, chart], chosen.picture, (1500, 700))


if __name__ == "__main__":
    main()
