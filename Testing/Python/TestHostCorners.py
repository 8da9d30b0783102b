# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plot, texts and scale of the touch avoid everything that a program draws over its scene: actors, widgets and
renderers of VTK, and shapes as other libraries draw them. The test compares the pixels that each of them changes."""

import time

import numpy
import pytest
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 - draws charts
import volumehaptics
from TestHosts import Program, changed, make_slider, make_text
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkChartXY
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectf, vtkTable
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkInteractionWidgets import (
    vtkButtonWidget,
    vtkCameraOrientationWidget,
    vtkLogoRepresentation,
    vtkLogoWidget,
    vtkOrientationMarkerWidget,
    vtkScalarBarRepresentation,
    vtkScalarBarWidget,
    vtkSliderWidget,
    vtkTextRepresentation,
    vtkTextWidget,
    vtkTexturedButtonRepresentation2D,
)
from vtkmodules.vtkRenderingAnnotation import (
    vtkAxesActor,
    vtkAxisActor2D,
    vtkCaptionActor2D,
    vtkCornerAnnotation,
    vtkLegendBoxActor,
    vtkLegendScaleActor,
    vtkScalarBarActor,
)
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkImageMapper, vtkPolyDataMapper2D, vtkTextMapper

CORNERS = {"lower left": (10, 10), "lower right": (190, 5), "upper left": (5, 230), "top": (90, 240)}


@pytest.fixture
def program():
    return Program()


def show(program, prop):
    """Adds a prop, and returns the function that shows and hides it."""
    program.renderer.AddViewProp(prop)
    return prop.SetVisibility


def show_widget(program, widget, representation):
    widget.SetInteractor(program.interactor)
    widget.SetRepresentation(representation)
    widget.EnabledOn()
    program.widget = widget  # keeps it
    return representation.SetVisibility


def show_border(program, widget, representation, x, y, width=90, height=40):
    """Places a vtkBorderWidget with a visible border."""
    representation.SetShowBorderToOn()
    representation.SetPosition(x / 300.0, y / 300.0)
    representation.SetPosition2(width / 300.0, height / 300.0)
    return show_widget(program, widget, representation)


def make_picture(width=40, height=40):
    picture = vtkImageData()
    picture.SetDimensions(width, height, 1)
    colors = numpy.full((width * height, 3), 200, numpy.uint8)
    picture.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    return picture


def put_text(program, x, y):
    return show(program, make_text(x, y))


def put_mapped_text(program, x, y):
    """Places a centred text, as vedo's Text2D does."""
    actor, mapper = vtkActor2D(), vtkTextMapper()
    mapper.SetInput("two lines\nof vedo")
    mapper.GetTextProperty().SetFontSize(18)
    mapper.GetTextProperty().SetJustificationToCentered()
    mapper.GetTextProperty().SetVerticalJustificationToTop()
    actor.SetMapper(mapper)
    actor.SetPosition(x + 45, y + 45)
    return show(program, actor)


def put_bar(program, x, y):
    """Places a scalar bar, as vedo does."""
    actor, table = vtkScalarBarActor(), vtkLookupTable()
    table.SetTableRange(0.0, 1.0)
    actor.SetLookupTable(table)
    actor.SetPosition(x / 300.0, y / 300.0)
    actor.SetWidth(0.2)
    actor.SetHeight(0.4)
    return show(program, actor)


def put_rectangle(program, x, y):
    """Places a rectangle, as FURY's user interface does."""
    actor, mapper, plane = vtkActor2D(), vtkPolyDataMapper2D(), vtkPlaneSource()
    plane.SetOrigin(0.0, 0.0, 0.0)
    plane.SetPoint1(90.0, 0.0, 0.0)
    plane.SetPoint2(0.0, 40.0, 0.0)
    mapper.SetInputConnection(plane.GetOutputPort())
    actor.SetMapper(mapper)
    actor.SetPosition(x, y)
    return show(program, actor)


def put_slider(program, x, y):
    return show_widget(program, vtkSliderWidget(), make_slider(x, y))


def put_corner_annotation(program, x, y):
    """Places a corner annotation, as viewers of medical images do. The window is too small for large letters and a
    plot."""
    annotation, place = vtkCornerAnnotation(), list(CORNERS.values()).index((x, y))
    kinds = (annotation.LowerLeft, annotation.LowerRight, annotation.UpperLeft, annotation.UpperEdge)
    annotation.SetText(kinds[place], "Slice 17\nW 400 L 40")
    annotation.SetMaximumFontSize(14)
    return show(program, annotation)


def put_legend_box(program, x, y):
    legend, plane = vtkLegendBoxActor(), vtkPlaneSource()
    plane.Update()
    legend.SetNumberOfEntries(2)
    for entry, word in enumerate(("bone", "skin")):
        legend.SetEntry(entry, plane.GetOutput(), word, (1.0, 1.0, 1.0))
    legend.GetPositionCoordinate().SetValue(x / 300.0, y / 300.0)
    legend.GetPosition2Coordinate().SetValue(0.3, 0.15)
    return show(program, legend)


def put_axis(program, x, y):
    axis = vtkAxisActor2D()
    axis.GetPositionCoordinate().SetCoordinateSystemToDisplay()
    axis.GetPositionCoordinate().SetValue(x + 5, y + 30)
    axis.GetPosition2Coordinate().SetCoordinateSystemToDisplay()
    axis.GetPosition2Coordinate().SetValue(x + 85, y + 30)
    axis.SetTitle("mm")
    return show(program, axis)


def put_caption(program, x, y):
    caption = vtkCaptionActor2D()
    caption.SetCaption("a tumour")
    caption.SetAttachmentPoint(0.0, 0.0, 0.0)
    caption.LeaderOff()
    caption.GetPositionCoordinate().SetCoordinateSystemToDisplay()
    caption.GetPositionCoordinate().SetReferenceCoordinate(None)
    caption.GetPositionCoordinate().SetValue(x, y)
    caption.SetWidth(0.3)
    caption.SetHeight(0.12)
    return show(program, caption)


def put_image(program, x, y):
    """Places a logo without a widget."""
    actor, mapper = vtkActor2D(), vtkImageMapper()
    mapper.SetInputData(make_picture())
    mapper.SetColorWindow(255.0)
    mapper.SetColorLevel(127.5)
    actor.SetMapper(mapper)
    actor.SetPosition(x, y)
    return show(program, actor)


def put_chart(program, x, y):
    """As PyVista's."""
    actor, chart, table = vtkContextActor(), vtkChartXY(), vtkTable()
    for name in "xy":
        column = numpy_to_vtk(numpy.arange(5.0), deep=True)
        column.SetName(name)
        table.AddColumn(column)
    chart.AddPlot(chart.LINE).SetInputData(table, 0, 1)
    chart.GetBackgroundBrush().SetColor(255, 255, 255, 255)
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(x, y, 100, 60))
    actor.GetScene().AddItem(chart)
    return show(program, actor)


def put_text_widget(program, x, y):
    text = vtkTextRepresentation()
    text.SetText("a text")
    return show_border(program, vtkTextWidget(), text, x, y)


def put_bar_widget(program, x, y):
    bar, table = vtkScalarBarRepresentation(), vtkLookupTable()
    table.SetTableRange(0.0, 1.0)
    bar.GetScalarBarActor().SetLookupTable(table)
    return show_border(program, vtkScalarBarWidget(), bar, x, y, 40, 60)


def put_logo_widget(program, x, y):
    logo = vtkLogoRepresentation()
    logo.SetImage(make_picture())
    return show_border(program, vtkLogoWidget(), logo, x, y)


def put_button(program, x, y):
    """As PyVista's."""
    button = vtkTexturedButtonRepresentation2D()
    button.SetNumberOfStates(1)
    button.SetButtonTexture(0, make_picture())
    button.PlaceWidget([x, x + 40, y, y + 40, 0.0, 0.0])
    return show_widget(program, vtkButtonWidget(), button)


def put_marker(program, x, y):
    """Places a marker in a renderer of its own, as the axes of ParaView and PyVista are."""
    marker = vtkOrientationMarkerWidget()
    marker.SetOrientationMarker(vtkAxesActor())
    marker.SetInteractor(program.interactor)
    marker.SetViewport(x / 300.0, y / 300.0, x / 300.0 + 0.2, y / 300.0 + 0.2)
    marker.EnabledOn()
    program.widget = marker
    return marker.SetEnabled


def put_orientation_cube(program, x, y):
    """Places the camera orientation widget in the upper right corner, as newer programs do, or in another corner."""
    if not hasattr(vtkCameraOrientationWidget, "SetParentRenderer"):
        pytest.skip("this VTK has none")
    cube = vtkCameraOrientationWidget()
    cube.SetParentRenderer(program.renderer)
    cube.SetInteractor(program.interactor)
    cube.EnabledOn()
    program.widget = cube
    return cube.SetEnabled


MAKERS = [make for name, make in sorted(globals().items()) if name.startswith("put_")]


def check(program, switch):
    """No part of the touch shares a pixel with the program's prop; each part is taken as the box of its pixels."""
    display, hand = program.haptics.head_up_display, program.haptics.representation
    display.SetNotice("a notice")
    program.volume.VisibilityOff()  # so that successive pictures are equal
    for prop in (display, hand):
        prop.SetVisibility(False)
    theirs = changed(program, switch)
    assert theirs is not None
    for prop in (display, hand):
        prop.SetVisibility(True)
    parts = {"plot": display.SetPlotVisibility, "text": display.SetTextVisibility, "hint": display.SetHintVisibility,
             "scale": hand.SetScaleTextVisibility}
    for name, switch_part in parts.items():
        for others in parts.values():
            others(False)
        ours = changed(program, switch_part)
        assert ours is not None, name
        assert ours[0] > theirs[1] or ours[1] < theirs[0] or ours[2] > theirs[3] or ours[3] < theirs[2], \
            f"{name} {ours} over {theirs}"


@pytest.fixture
def touched(program):
    with volumehaptics.add_haptics(program.window) as program.haptics:
        end = time.monotonic() + 30.0
        while not program.haptics.update() and time.monotonic() < end:  # the scale is shown once there is a state
            time.sleep(0.001)
        yield program


def test_the_display_keeps_off_axes_at_each_side_of_the_window(touched):
    touched.window.SetSize(600, 600)
    scale = vtkLegendScaleActor()
    touched.renderer.AddViewProp(scale)
    for _ in range(2):
        touched.window.Render()
    for others in ("Left", "Right", "Bottom", "Top"):
        getattr(scale, f"{others}AxisVisibilityOff")()
    scale.LegendVisibilityOff()
    for side in ("Left", "Right", "Bottom", "Top", "Legend"):
        name = "LegendVisibility" if side == "Legend" else f"{side}AxisVisibility"
        getattr(scale, f"{name}On")()
        check(touched, scale.SetVisibility)
        getattr(scale, f"{name}Off")()


@pytest.mark.parametrize("make", MAKERS, ids=lambda make: make.__name__[4:])
@pytest.mark.parametrize("corner", CORNERS)
def test_the_display_keeps_off_what_the_program_draws(touched, make, corner):
    switch = make(touched, *CORNERS[corner])
    touched.window.Render()
    check(touched, switch)
