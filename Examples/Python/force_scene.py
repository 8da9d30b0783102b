# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that the demonstrations of felt fields share: lines coloured by the force, in a window or a picture."""
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
    vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

STRONGEST = 2.0  # N, largest force on the colour scale
GREY = (0.6, 0.66, 0.74)


def make_colours():
    """Returns colours for forces from zero to STRONGEST."""
    colours = vtkColorTransferFunction()
    for share, name in ((0.0, "RoyalBlue"), (0.35, "MediumSeaGreen"), (0.65, "Gold"), (1.0, "OrangeRed")):
        colours.AddRGBPoint(share * STRONGEST, *vtkNamedColors().GetColor3d(name))
    return colours


def connect(consumer, source):
    """Connects a filter to data, or to the output of another filter."""
    if hasattr(source, "GetOutputPort"):
        consumer.SetInputConnection(source.GetOutputPort())
    else:
        consumer.SetInputData(source)


def make_actor(source, radius=0.0, colours=None, opacity=1.0):
    """Returns an actor of surfaces, or of lines as tubes of a radius, in one colour or coloured by the force."""
    mapper = vtkPolyDataMapper()
    if radius > 0.0:
        tube = vtkTubeFilter()
        connect(tube, source)
        tube.SetRadius(radius)
        tube.SetNumberOfSides(12)
        source = tube
    connect(mapper, source)
    mapper.SetScalarVisibility(colours is not None)
    if colours:
        mapper.SetLookupTable(colours)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("NormalForce")
        mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(GREY)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def make_bar(colours):
    """Returns the colour scale, which shows the force for each colour."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle("Force (N)")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().SetFontSize(16)
    bar.GetTitleTextProperty().SetFontSize(17)
    bar.SetVerticalTitleSeparation(10)
    bar.SetPosition(0.91, 0.2)
    bar.SetHeight(0.6)
    bar.SetWidth(0.08)
    return bar


def trace_stream(flow, array, seeds, longest):
    """Returns lines along the vectors of an array, which begin at the points of a filter or polydata."""
    lines = vtkStreamTracer()
    lines.SetInputData(flow)
    lines.SetInputArrayToProcess(0, 0, 0, 0, array)
    if hasattr(seeds, "GetOutputPort"):
        lines.SetSourceConnection(seeds.GetOutputPort())
    else:
        lines.SetSourceData(seeds)
    lines.SetMaximumPropagation(longest)
    return lines


def make_renderer(*actors):
    renderer = vtkRenderer()
    renderer.SetBackground(0.07, 0.08, 0.11)
    for actor in actors:
        renderer.AddActor(actor)
    return renderer


def show(renderers, picture=None, size=(1000, 700)):
    """Shows one or several renderers in a window until it is closed, or writes a PNG file."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(picture is not None)
    window.SetSize(size)
    for renderer in renderers if isinstance(renderers, list) else [renderers]:
        window.AddRenderer(renderer)
    if picture:
        window.Render()
        grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
        grab.SetInput(window)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(picture)
        writer.Write()
        return
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.Start()
