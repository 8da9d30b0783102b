# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What volume mappers show is felt where it is seen, to within a voxel. TestShownAndTold.py has the exceptions.

Each volume has a wall across x, seen from the side: the first red pixel of the row at y = 7.5 is where it begins.
The tip goes along x at y = z = 7.5, and the felt wall begins at the first force. The values are V = 100 (x - x0) / 2
+ 50, clamped to 0 to 100, and values above 50 are opaque, so that the wall is at x0; where masks and blanked voxels
hide a part of it, halfway between the last hidden voxel and the first shown one.
"""

import math

import numpy as np
import pytest
import vtkmodules.vtkInteractionStyle  # noqa: F401 - the interactors of windows
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - the windows
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray, vtkVersion
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkRectilinearGrid,
)
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import (
    vtkFixedPointVolumeRayCastMapper,
    vtkMultiVolume,
    vtkUnstructuredGridVolumeRayCastMapper,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper as vtkGPUMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkMultiBlockVolumeMapper, vtkSmartVolumeMapper
from volumehaptics import path, vtkHapticDevice, vtkHapticWidget, vtkInteractorStyleHaptic, vtkVolumeHapticsFilter
from volumehaptics._touch import Errors

X, Y = 24, 16  # voxels
PIXELS = 8  # a voxel
LEFT = -4  # of the picture
VOXEL = 1.0


def wall(x0, high=100.0, count=X, across=Y, shift=0.0):
    x = np.arange(count) + shift
    return np.broadcast_to(high * np.clip((x - x0) / 2.0 + 0.5, 0.0, 1.0), (across, across, count))


def add_array(data, name, values, active=True):
    """Adds an array of points or cells, with values of z, y, x and perhaps components."""
    array = numpy_to_vtk(np.ascontiguousarray(values).reshape(-1, *values.shape[3:]), deep=True)
    array.SetName(name)
    data.AddArray(array)
    if active:
        data.SetActiveScalars(name)


def image(values):
    made = vtkImageData()
    made.SetDimensions(values.shape[2], values.shape[1], values.shape[0])
    add_array(made.GetPointData(), "A", values)
    return made


def step(low, high):
    function = vtkPiecewiseFunction()
    function.AddPoint(low, 0.0)
    function.AddPoint(high, 1.0)
    return function


def fill(value):
    function = vtkPiecewiseFunction()
    function.AddPoint(0.0, value)
    return function


def look(opacity, prop=None):
    prop = prop or vtkVolumeProperty()
    red = vtkColorTransferFunction()
    red.AddRGBPoint(0.0, 1.0, 0.0, 0.0)
    for component in range(4):
        prop.SetScalarOpacity(component, opacity)
        prop.SetColor(component, red)
    prop.SetInterpolationTypeToLinear()
    return prop


WINDOW = vtkRenderWindow()  # one window for all tests, since opening one takes time
WINDOW.SetOffScreenRendering(True)
WINDOW.SetMultiSamples(0)
WINDOW.SetSize((X + 8) * PIXELS, 8 * PIXELS)


class Scene:
    """A volume in the window, which a style touches. Tests change the scene before the touch."""

    def __init__(self, data, mapper=None):
        self.data, self.mapper, self.volume = data, mapper or vtkGPUMapper(), vtkVolume()
        self.renderer, self.window, self.interactor = vtkRenderer(), WINDOW, vtkRenderWindowInteractor()
        self.device, self.style, self.filter = vtkHapticDevice(), vtkInteractorStyleHaptic(), vtkVolumeHapticsFilter()
        if data is not None:
            self.mapper.SetInputDataObject(data)
        if hasattr(self.mapper, "SetAutoAdjustSampleDistances"):
            self.mapper.SetAutoAdjustSampleDistances(False)  # on a busy machine, pictures are coarse
        self.volume.SetMapper(self.mapper)
        self.look = look(step(49.9, 50.1), self.volume.GetProperty())
        self.renderer.AddVolume(self.volume)
        while (last := self.window.GetRenderers().GetFirstRenderer()) is not None:
            self.window.RemoveRenderer(last)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetParallelProjection(True)
        camera.SetFocalPoint(LEFT + 0.5 * (X + 8), 7.5, 7.5)
        camera.SetPosition(LEFT + 0.5 * (X + 8), 7.5, 100.0)
        camera.SetParallelScale(4.0)
        self.filter.GetProperty().GetSurfaceStrength().AddPoint(0.0, 8.0)
        self.device.SetVolumeHaptics(self.filter)
        self.interactor.SetRenderWindow(self.window)
        self.style.SetDevice(self.device)
        self.style.SetDefaultRenderer(self.renderer)
        self.interactor.SetInteractorStyle(self.style)
        self.follows = True

    def told(self):
        """Returns the warnings and errors of touching the volume."""
        with Errors(self.style) as errors, Errors(self.style, event="WarningEvent") as warnings:
            if self.follows:
                assert self.style.TouchVolume(self.volume)
            if not self.device.IsOpen():
                assert self.device.Open("virtual") and self.device.Start()
            self.style.UpdateHaptics()
            self.style.UpdateHaptics()
        return [*errors, *warnings]

    def seen(self):
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        pixels, (width, height) = vtkUnsignedCharArray(), self.window.GetSize()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        row = vtk_to_numpy(pixels).reshape(height, width, -1)[height // 2].astype(int)
        lit = np.nonzero(row[:, 0] - row[:, 1] > 20)[0]
        return LEFT + lit[0] / PIXELS if lit.size else math.nan

    def felt(self):
        tip = np.full((601, 3), 7.5)
        tip[:, 0] = np.linspace(-5.0, 25.0, 601)
        self.filter.SetPathData(path(tip))
        with Errors(self.filter) as errors:
            self.filter.Update()
        assert not errors, errors
        force = vtk_to_numpy(self.filter.GetOutput().GetPointData().GetArray("Force"))[:, 0]
        held = np.nonzero(force < -0.005)[0]
        return tip[held[0], 0] if held.size else math.nan

    def check(self, most=VOXEL):
        """Checks that the volume is felt where it is seen, and that the touch does not change the picture."""
        before = self.seen()
        assert not self.told()
        seen, felt = self.seen(), self.felt()
        assert seen == before, "the touch changes the picture"
        assert abs(seen - felt) <= most, (seen, felt)
        return seen

    def end(self):
        self.interactor.SetInteractorStyle(None)
        self.device.Close()


def set_up(make):
    """Makes the scene again if the picture fails: one in twenty of VTK 9.1's new mappers on the processor paints the
    whole window, whatever follows."""
    for _ in range(10):
        s = make()
        if s.seen() != LEFT:
            break
        s.end()
    return s


FELT = {}


def felt(x0, drawn=0.25, most=VOXEL):
    """Registers a scene whose wall is felt where it is seen, at x0; VTK draws the wall within `drawn` of x0."""
    def keep(make):
        FELT[make.__name__] = make, x0, drawn, most
        return make
    return keep


@felt(8.0)
def gpu_mapper():
    return Scene(image(wall(8.0)))


@felt(8.0)
def cpu_mapper():
    return Scene(image(wall(8.0)), vtkFixedPointVolumeRayCastMapper())


@felt(8.0)
def smart_mapper():
    return Scene(image(wall(8.0)), vtkSmartVolumeMapper())


@felt(11.0)
def moved():
    s = gpu_mapper()
    s.volume.SetPosition(3.0, 0.0, 0.0)
    return s


@felt(12.0)
def clipped():
    s, plane = gpu_mapper(), vtkPlane()
    plane.SetOrigin(12.0, 0.0, 0.0)
    plane.SetNormal(1.0, 0.0, 0.0)
    s.mapper.AddClippingPlane(plane)
    s.filter.FeelCutFacesOn()
    return s


@felt(12.0)
def cropped():
    s = gpu_mapper()
    s.mapper.CroppingOn()
    s.mapper.SetCroppingRegionPlanes(12.0, 20.0, 0.0, 20.0, 0.0, 20.0)
    s.filter.FeelCutFacesOn()
    return s


def ramp(radius=2):
    """Makes a ramp: gradients everywhere, without an edge."""
    s = Scene(image(np.broadcast_to(50.0 + 2.5 * (np.arange(X) - 8.0), (Y, Y, X))))
    s.filter.SetKernelRadius(radius)
    return s


@felt(8.0)
def opacity_on_a_ramp():
    return ramp()


@felt(8.0)
def opacity_on_a_ramp_with_a_large_kernel():
    return ramp(radius=5)


@felt(8.0)
def opacity_on_a_steep_ramp():
    return Scene(image(np.broadcast_to(50.0 + 40.0 * (np.arange(X) - 8.0), (Y, Y, X))))


@felt(9.0)
def opacity_on_the_distance_from_an_axis():
    x, z = np.meshgrid(np.arange(X), np.arange(Y))
    return Scene(image(np.broadcast_to((50.0 + 5.0 * (6.0 - np.hypot(x - 15.0, z - 7.5)))[:, None, :], (Y, Y, X))))


@felt(15.0, drawn=1.05, most=1.1)
def gradient_opacity():
    """Only the steeper of two walls has opacity. VTK's gradients begin a voxel before a wall."""
    s = Scene(image(0.3 * wall(7.0) + 2.0 * wall(15.0)))
    steep = vtkPiecewiseFunction()
    steep.AddPoint(55.0, 0.0)
    steep.AddPoint(55.1, 1.0)
    s.look.SetScalarOpacity(step(10.0, 10.1))
    s.look.SetGradientOpacity(steep)
    return s


# -- the array that the mapper chooses --

def two_arrays(mapper):
    s = Scene(image(wall(8.0)), mapper)
    add_array(s.data.GetPointData(), "B", wall(15.0), active=False)
    s.mapper.SetScalarModeToUsePointFieldData()
    return s


@felt(15.0)
def array_by_name():
    s = two_arrays(vtkGPUMapper())
    s.mapper.SelectScalarArray("B")
    return s


@felt(15.0)
def array_by_number():
    s = two_arrays(vtkSmartVolumeMapper())
    s.mapper.SelectScalarArray(1)
    return s


@felt(8.0)
def array_without_the_mode():
    s = two_arrays(vtkGPUMapper())
    s.mapper.SelectScalarArray("B")
    s.mapper.SetScalarModeToDefault()
    return s


def cells():
    """VTK draws the value of a cell at its centre."""
    return wall(15.0, count=X - 1, across=Y - 1, shift=0.5)


@felt(15.0)
def cell_array_by_name():
    s = gpu_mapper()
    add_array(s.data.GetCellData(), "C", cells(), active=False)
    s.mapper.SetScalarModeToUseCellFieldData()
    s.mapper.SelectScalarArray("C")
    return s


@felt(15.0)
def cell_data():
    s = gpu_mapper()
    add_array(s.data.GetCellData(), "C", cells())
    s.mapper.SetScalarModeToUseCellData()
    return s


@felt(17.0)
def cell_data_alone_and_moved():
    s = Scene(image(wall(8.0)))
    s.data.GetPointData().Initialize()
    add_array(s.data.GetCellData(), "C", cells())
    s.volume.SetPosition(2.0, 0.0, 0.0)
    return s


@felt(19.0)
def cell_data_cropped():
    s = cell_data()
    s.mapper.CroppingOn()
    s.mapper.SetCroppingRegionPlanes(19.0, 21.0, 0.0, 20.0, 0.0, 20.0)
    s.filter.FeelCutFacesOn()
    return s


# Components.

def components(walls, mapper=None, kind=float):
    values = np.stack([wall(x0, high=255.0) for x0 in walls], axis=-1).astype(kind)
    s = Scene(image(values), mapper)
    look(step(127.0, 128.0), s.look)
    return s


@felt(15.0)
def two_dependent_components():
    s = components((8.0, 15.0), kind=np.uint8)
    s.look.IndependentComponentsOff()
    return s


@felt(15.0)
def two_dependent_components_by_cpu():
    s = components((8.0, 15.0), vtkFixedPointVolumeRayCastMapper(), np.uint8)
    s.look.IndependentComponentsOff()
    return s


@felt(15.0)
def four_dependent_components():
    s = components((0.0, 99.0, 99.0, 15.0), kind=np.uint8)
    s.look.IndependentComponentsOff()
    return s


@felt(15.0)
def one_component_with_weight():
    s = components((8.0, 15.0))
    s.look.SetComponentWeight(0, 0.0)
    return s


@felt(15.0)
def one_component_with_opacity():
    s = components((8.0, 15.0))
    s.look.SetScalarOpacity(0, fill(0.0))
    return s


def vectors(component):
    s = components((8.0, 13.0, 17.0), vtkSmartVolumeMapper())
    s.mapper.SetVectorMode(vtkSmartVolumeMapper.COMPONENT)
    s.mapper.SetVectorComponent(component)
    return s


@felt(8.0)
def first_vector_component():
    return vectors(0)


@felt(17.0)
def last_vector_component():
    return vectors(2)


# -- data other than images, and several volumes in one mapper --

def rectilinear(mapper):
    grid = vtkRectilinearGrid()
    grid.SetDimensions(X, Y, Y)
    for put, count in ((grid.SetXCoordinates, X), (grid.SetYCoordinates, Y), (grid.SetZCoordinates, Y)):
        put(numpy_to_vtk(np.arange(count, dtype=float), deep=True))
    add_array(grid.GetPointData(), "A", wall(9.0))
    return Scene(grid, mapper)


@felt(9.0, drawn=0.65)  # VTK draws it a little too small
def rectilinear_grid():
    return rectilinear(vtkGPUMapper())


@felt(15.0, drawn=0.65)
def array_of_a_rectilinear_grid():
    s = rectilinear(vtkSmartVolumeMapper())
    add_array(s.data.GetPointData(), "B", wall(15.0), active=False)
    s.mapper.SetScalarModeToUsePointFieldData()
    s.mapper.SelectScalarArray("B")
    return s


@felt(9.0)
def two_blocks():
    blocks = vtkMultiBlockDataSet()
    for number, extent in enumerate(((0, 12, 0, 15, 0, 15), (12, 23, 0, 15, 0, 15))):
        block = image(wall(9.0))
        block.Crop(extent)
        blocks.SetBlock(number, block)
    return Scene(blocks, vtkMultiBlockVolumeMapper())


@felt(9.0)
def unstructured_grid():
    tetrahedra = vtkDataSetTriangleFilter()
    tetrahedra.SetInputData(image(wall(9.0)))
    tetrahedra.TetrahedraOnlyOn()
    tetrahedra.Update()
    return Scene(tetrahedra.GetOutput(), vtkUnstructuredGridVolumeRayCastMapper())


def port(number):
    """Makes a vtkMultiVolume of two volumes, only one of which has opacity."""
    s, multi = Scene(None), vtkMultiVolume()
    s.renderer.RemoveVolume(s.volume)
    multi.SetMapper(s.mapper)
    s.parts = []
    for i, x0 in enumerate((9.0, 15.0)):
        part = vtkVolume()
        part.SetProperty(look(step(49.9, 50.1) if i == number else fill(0.0)))
        s.mapper.SetInputDataObject(i, image(wall(x0)))
        multi.SetVolume(part, i)
        s.parts.append(part)
    s.renderer.AddVolume(multi)
    s.volume, s.multi = s.parts[number], multi
    return s


@felt(9.0)
def first_port():
    return port(0)


@felt(15.0)
def second_port():
    return port(1)


@felt(9.0)
def multi_volume():
    s = port(0)
    s.volume = s.multi
    return s


# -- voxels that are hidden individually --

def mask(first, shown=255, hidden=0):
    """Returns a mask that shows the voxels from the index `first` on."""
    return image(np.broadcast_to(np.where(np.arange(X) < first, hidden, shown).astype(np.uint8), (Y, Y, X)))


def masked(s, first, radius=2):
    s.mapper.SetMaskTypeToBinary()
    s.mapper.SetMaskInput(mask(first))
    s.filter.SetKernelRadius(radius)
    s.filter.FeelCutFacesOn()
    return s


@felt(8.0)
def mask_before_the_wall():
    return masked(gpu_mapper(), 5)


@felt(8.5)
def mask_in_the_wall():
    return masked(gpu_mapper(), 9)


@felt(13.5)
def mask_behind_the_wall():
    return masked(gpu_mapper(), 14)


@felt(16.5)
def mask_behind_the_wall_and_moved():
    s = masked(gpu_mapper(), 14)
    s.volume.SetPosition(3.0, 0.0, 0.0)
    return s


@felt(13.5)
def mask_on_a_ramp():
    """Makes gradients everywhere; a larger kernel sees more of them."""
    return masked(Scene(image(np.broadcast_to(40.0 + 2.0 * np.arange(X), (Y, Y, X)))), 14, radius=5)


@felt(8.0)
def labels_with_colours():
    s = gpu_mapper()
    s.mapper.SetMaskTypeToLabelMap()
    s.mapper.SetMaskInput(mask(14, shown=1))
    s.look.SetLabelColor(1, s.look.GetRGBTransferFunction(0))
    return s


@felt(13.5)
def label_without_opacity():
    s = labels_with_colours()
    s.mapper.SetMaskInput(mask(14, shown=0, hidden=1))
    s.look.SetLabelScalarOpacity(1, fill(0.0))
    s.filter.FeelCutFacesOn()
    return s


@felt(13.5)
def label_that_alone_has_opacity():
    s = labels_with_colours()
    s.look.SetLabelScalarOpacity(1, step(49.9, 50.1))
    s.look.SetScalarOpacity(fill(0.0))
    s.filter.FeelCutFacesOn()
    return s


def blanked(s, first, flags, flag):
    shape = (Y, Y, X) if flags.GetNumberOfTuples() == Y * Y * X else (Y - 1, Y - 1, X - 1)
    vtk_to_numpy(flags)[:] = np.broadcast_to(np.where(np.arange(shape[2]) < first, flag, 0), shape).ravel()
    s.filter.FeelCutFacesOn()
    return s


@felt(14.0)
def blanked_points():
    s = gpu_mapper()
    return blanked(s, 14, s.data.AllocatePointGhostArray(), 2)


@felt(14.0)
def blanked_cells():
    s = gpu_mapper()
    return blanked(s, 14, s.data.AllocateCellGhostArray(), 32)


@felt(18.5 if vtkVersion().GetVTKVersion() >= "9.2" else 15.0)
def blanked_cells_of_cell_data():
    """VTK 9.1 draws blanked cells of cell data."""
    s = cell_data()
    return blanked(s, 18, s.data.AllocateCellGhostArray(), 32)


@felt(15.0)
def blanked_points_of_cell_data():
    s = cell_data()
    return blanked(s, 18, s.data.AllocatePointGhostArray(), 2)


@felt(15.0)
def blanked_cells_of_cell_data_in_front_of_the_wall():
    s = cell_data()
    return blanked(s, 5, s.data.AllocateCellGhostArray(), 32)


@felt(14.0)
def points_with_another_flag():
    """The mapper hides points with any flag, for example DUPLICATEPOINT."""
    s = gpu_mapper()
    return blanked(s, 14, s.data.AllocatePointGhostArray(), 1)


@felt(14.0)
def cells_with_another_flag():
    """REFINEDCELL."""
    s = gpu_mapper()
    return blanked(s, 14, s.data.AllocateCellGhostArray(), 8)


@felt(18.5 if vtkVersion().GetVTKVersion() >= "9.2" else 15.0)
def cells_of_cell_data_with_another_flag():
    """HIGHCONNECTIVITYCELL has the same number as HIDDENPOINT."""
    s = cell_data()
    return blanked(s, 18, s.data.AllocateCellGhostArray(), 2)


@felt(8.0)
def points_with_another_flag_that_cpu_draws():
    s = cpu_mapper()
    return blanked(s, 14, s.data.AllocatePointGhostArray(), 1)


@felt(8.0)
def blanked_points_that_cpu_draws():
    s = cpu_mapper()
    return blanked(s, 14, s.data.AllocatePointGhostArray(), 2)


@felt(8.0)
def blanked_cells_that_cpu_draws():
    s = cpu_mapper()
    return blanked(s, 14, s.data.AllocateCellGhostArray(), 32)


@pytest.mark.parametrize("row", FELT)
def test_is_felt_where_it_is_seen(row):
    make, x0, drawn, most = FELT[row]
    s = set_up(make)
    assert s.check(most) == pytest.approx(x0, abs=drawn)
    # Allow for half a voxel: VTK draws none of the cells around a blanked point.
    assert s.felt() == pytest.approx(x0, abs=0.55)
    s.end()


def test_is_followed_when_it_changes():
    """Changes of the array, the component and the mask are followed, to and fro."""
    s = array_by_name()
    assert s.check() == pytest.approx(15.0, abs=0.25)
    s.mapper.SelectScalarArray("A")
    assert s.check() == pytest.approx(8.0, abs=0.25)
    masked(s, 14)
    assert s.check() == pytest.approx(13.5, abs=0.25)
    s.mapper.SetMaskInput(None)
    s.mapper.SetScalarModeToDefault()
    assert s.check() == pytest.approx(8.0, abs=0.25)
    s.end()


@pytest.mark.parametrize("make", [array_by_name, two_dependent_components, second_port, multi_volume, rectilinear_grid,
                                  mask_behind_the_wall])
def test_a_widget_feels_it_too(make):
    s = make()
    s.interactor.SetInteractorStyle(None)
    widget = vtkHapticWidget()
    widget.SetVolumeHaptics(s.filter)
    if s.volume.GetMapper() is not None:
        widget.SetVolume(s.volume)
    widget.SetInteractor(s.interactor)
    with Errors(widget, widget.GetStyle()) as errors:
        widget.On()
        widget.UpdateHaptics()
    assert not errors, errors
    if make in (second_port, multi_volume):
        assert widget.GetStyle().GetNumberOfTouchedVolumes() == 2
    if make is not second_port:  # the first port has its own filter, too
        assert s.seen() == pytest.approx(s.felt(), abs=VOXEL)
    widget.SetInteractor(None)
    s.end()
