# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feel a head with a spoon: a tool with a shape moves around the head, and turns in the hand to lie flat on the skin.

python3 shaped_tool.py [--tool FILE.stl] [--picture FILE]

The spoon is an ellipsoid; --tool uses any closed mesh (mm) instead. The hand moves around the head without
turning: the tool turns against a spring of 30 mN m per radian until it lies flat on the skin.
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkProbeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader
from volumehaptics import examples, vtkHapticPointShell, vtkVolumeHapticsFilter

from force_scene import STRONGEST, make_actor, make_bar, make_colours, make_renderer, show

SIZE = (14.0, 7.0, 2.5)  # mm: half of the spoon's length, width and thickness
SKIN = -300.0  # HU
TURNING = 0.03  # N m per radian: stiffness of the rotational spring between hand and tool
SHOWN = 7  # number of spoons that are drawn on the path


def make_spoon():
    ball, stretch, spoon = vtkSphereSource(), vtkTransform(), vtkTransformPolyDataFilter()
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(32)
    ball.SetRadius(1.0)
    stretch.Translate(0.0, 0.0, SIZE[2])  # moves the lowest point to the tip
    stretch.Scale(*SIZE)
    spoon.SetInputConnection(ball.GetOutputPort())
    spoon.SetTransform(stretch)
    spoon.Update()
    return spoon.GetOutput()


def read(file):
    reader = vtkSTLReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def find_skin(head, angles):
    """Returns where rays in a plane from ear to ear, from the head's middle, leave it (mm), and their directions."""
    directions = np.stack([np.sin(angles), np.zeros_like(angles), np.cos(angles)], axis=-1)
    reaches = np.arange(60.0, 112.0, 0.25)  # mm, within the volume
    points, data, probe = vtkPoints(), vtkPolyData(), vtkProbeFilter()
    points.SetData(numpy_to_vtk((directions[:, None] * reaches[:, None]).reshape(-1, 3), deep=True))
    data.SetPoints(points)
    probe.SetInputData(data)
    probe.SetSourceData(head)
    probe.Update()
    inside = vtk_to_numpy(probe.GetOutput().GetPointData().GetScalars()).reshape(len(angles), -1) > SKIN
    last = inside.shape[1] - 1 - inside[:, ::-1].argmax(axis=1)
    width = 200  # half of the width of the moving mean, which turns steps into a smooth path
    smooth = np.convolve(np.pad(reaches[last], width, "edge"), np.full(2 * width + 1, 1.0 / (2 * width + 1)), "valid")
    return directions * smooth[:, None], directions


def feel(head, mesh):
    """Returns the trace of a tool that a hand leads around the head, 3 mm deep, without turning it."""
    angles = np.linspace(-1.0, 1.0, 2500)
    skin, outward = find_skin(head, angles)
    path, points = vtkPolyData(), vtkPoints()
    depth = 3.0 - 12.0 * np.clip((np.abs(angles) - 0.85) / 0.15, 0.0, 1.0)
    points.SetData(numpy_to_vtk(skin - depth[:, None] * outward, deep=True))
    path.SetPoints(points)
    flat = numpy_to_vtk(np.tile([1.0, 0.0, 0.0, 0.0], (len(angles), 1)), deep=True)
    flat.SetName("Orientation")
    path.GetPointData().AddArray(flat)
    tool = vtkHapticPointShell()
    tool.SetMesh(mesh)
    tool.SetSolidToAbove()
    tool.SetContactValue(SKIN)
    tool.SetTurningStiffness(TURNING)
    touch = vtkVolumeHapticsFilter()
    touch.SetInputData(0, head)
    touch.SetPathData(path)
    touch.GetProperty().ApplyPreset("CT contrast")
    touch.SetTool(tool)
    touch.Update()
    return touch.GetOutput()


def draw_skin(head):
    skin = vtkFlyingEdges3D()
    skin.SetInputData(head)
    skin.SetValue(0, SKIN)
    actor = make_actor(skin)
    actor.GetProperty().SetColor(0.93, 0.73, 0.62)
    return actor


def draw_tool(mesh, place, turn, force, colours):
    """Returns an actor of the tool at a pose, in the colour of the force on the hand."""
    pose, moved = vtkTransform(), vtkTransformPolyDataFilter()
    pose.Translate(place)
    angle = 2.0 * np.degrees(np.arctan2(np.linalg.norm(turn[1:]), turn[0]))
    if angle > 0.0:
        pose.RotateWXYZ(angle, turn[1:])
    moved.SetInputData(mesh)
    moved.SetTransform(pose)
    actor = make_actor(moved)
    actor.GetProperty().SetColor(colours.GetColor(force))
    actor.GetProperty().SetSpecular(0.3)
    return actor


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tool", metavar="FILE.stl", help="a closed mesh in mm, with its origin at the hand's tip")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    chosen = parser.parse_args()
    head = examples.phantom()
    mesh = read(chosen.tool) if chosen.tool else make_spoon()
    trace = feel(head, mesh)
    data = trace.GetPointData()
    force, torque, turns = (vtk_to_numpy(data.GetArray(name)) for name in ("Force", "Torque", "ToolOrientation"))
    place = vtk_to_numpy(trace.GetPoints().GetData())
    newtons = np.linalg.norm(force, axis=1)
    tilt = 2.0 * np.degrees(np.arccos(np.clip(np.abs(turns[:, 0]), 0.0, 1.0)))
    print(f"at most {newtons.max():.2f} N, {1e3 * np.linalg.norm(torque, axis=1).max():.1f} mN m, "
          f"and {tilt.max():.1f} degrees out of the hand")

    colours = make_colours()
    held = np.nonzero(newtons > 0.0)[0]
    ticks = held[np.linspace(0, len(held) - 1, SHOWN + 2).astype(int)[1:-1]]
    tools = [draw_tool(mesh, place[i], turns[i], min(newtons[i], STRONGEST), colours) for i in ticks]
    scene = make_renderer(draw_skin(head), *tools, make_bar(colours))
    camera = scene.GetActiveCamera()
    middle = place[held].mean(axis=0)
    camera.SetFocalPoint(middle - [0.0, 0.0, 28.0])
    camera.SetPosition(middle + [0.0, -300.0, 60.0])
    camera.SetViewUp(0.0, 0.0, 1.0)
    scene.ResetCameraClippingRange()
    show(scene, chosen.picture)


if __name__ == "__main__":
    main()
