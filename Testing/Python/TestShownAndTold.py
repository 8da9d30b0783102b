# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where volume mappers show something that is not felt, or is felt elsewhere, one warning names the cures. After each
cure the volume is felt where it is seen, as in TestShownAndFelt.py, which has the volumes."""

import numpy as np
import pytest
from TestShownAndFelt import (
    Scene,
    X,
    Y,
    array_by_name,
    blanked_cells,
    blanked_points,
    blanked_points_that_cpu_draws,
    cells_with_another_flag,
    clipped,
    components,
    cropped,
    gpu_mapper,
    image,
    label_that_alone_has_opacity,
    label_without_opacity,
    look,
    mask_behind_the_wall,
    one_component_with_opacity,
    points_with_another_flag,
    rectilinear_grid,
    set_up,
    step,
    wall,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkFiltersCore import vtkResampleToImage
from vtkmodules.vtkImagingCore import vtkImageConstantPad, vtkImageExtractComponents
from vtkmodules.vtkImagingMath import vtkImageMagnitude
from vtkmodules.vtkRenderingCore import vtkVolume, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper as vtkGPUMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper
from volumehaptics import vtkVolumeHapticsFilter

TOLD = {}


def told(words, *cures):
    def keep(make):
        TOLD.setdefault(words, []).append((make, cures))
        return make
    return keep


def unfollowed(s):
    """Gives the filter the image directly, without the style."""
    s.follows = False
    s.filter.SetInputData(s.data)
    s.filter.GetProperty().SetVisibilityFrom(s.look)
    return s


def follow(s):
    s.follows = True


def touch_array(s):
    s.filter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "B")


@told("Its mapper draws another array than the one that is felt. Cure: TouchVolume()", follow, touch_array)
def _():
    return unfollowed(array_by_name())


@told("Its mapper draws another component of its array than the one that is felt", follow,
      lambda s: s.filter.GetProperty().SetComponent(1))
def _():
    return unfollowed(one_component_with_opacity())


def weight(s):
    s.look.SetComponentWeight(1, 0.0)


def both(s):
    """Makes a volume for each component; the first one is touched."""
    touched = s.style
    s.extracts, s.others = [], [s.volume, vtkVolume()]
    for component, volume in enumerate(s.others):
        extract, mapper = vtkImageExtractComponents(), vtkGPUMapper()
        extract.SetInputData(s.data)
        extract.SetComponents(component)
        extract.Update()
        mapper.SetInputConnection(extract.GetOutputPort())
        volume.SetMapper(mapper)
        volume.SetProperty(look(step(127.0, 128.0)))
        s.extracts.append(extract)
    s.renderer.AddVolume(s.others[1])
    s.second = vtkVolumeHapticsFilter()
    assert touched.TouchVolume(s.volume) and touched.AddTouchedVolume(s.others[1], s.second)
    s.follows = False


@told("Several components of its array have opacity, of which only one is felt", weight, both)
def _():
    return components((8.0, 15.0))


def magnitude(s):
    s.magnitude = vtkImageMagnitude()
    s.magnitude.SetInputData(s.data)
    s.mapper.SetInputConnection(s.magnitude.GetOutputPort())
    s.mapper.SetVectorMode(vtkSmartVolumeMapper.DISABLED)


@told("Its mapper draws the magnitude of vectors, but a component of them is felt. Cure: vtkImageMagnitude", magnitude)
def _():
    s = components((13.0, 9.0, 17.0), vtkSmartVolumeMapper())
    s.mapper.SetVectorMode(vtkSmartVolumeMapper.MAGNITUDE)
    return s


for mode in ("MaximumIntensity", "MinimumIntensity", "AverageIntensity", "Additive", "Slice"):
    @told("Its mapper projects or slices, so that also hidden parts in front of the picture are felt",
          lambda s: s.mapper.SetBlendModeToComposite())
    def _(mode=mode):
        s = gpu_mapper()
        getattr(s.mapper, f"SetBlendModeTo{mode}")()
        return s


def surface(s):
    s.filter.SetMethodToSurfaceProxy()
    s.filter.SetIsoValue(s.look.GetIsoSurfaceValues().GetValue(0))


def cylinder(values, iso):
    """Makes a cylinder around an axis along y at x = 15, since a flat wall can't be seen from the side. The values are
    those at the depth 6 - radius."""
    x, z = np.meshgrid(np.arange(X), np.arange(Y))
    s = Scene(image(np.broadcast_to(values(6.0 - np.hypot(x - 15.0, z - 7.5))[:, None, :], (Y, Y, X))))
    s.mapper.SetBlendModeToIsoSurface()
    s.look.GetIsoSurfaceValues().SetValue(0, iso)
    s.look.SetScalarOpacity(step(iso - 0.2, iso))
    return s


@told("Its mapper draws isosurfaces, but all of its edges are felt", surface, lambda s: s.mapper.SetBlendModeToComposite())
def _():
    return cylinder(lambda depth: 100.0 * np.clip(depth / 2.0 + 0.5, 0.0, 1.0), 50.0)


def test_nothing_is_felt_in_front_of_the_isosurfaces():
    """The volume is a ramp, which is steep everywhere."""
    s = cylinder(lambda depth: 60.0 + 5.0 * depth, 60.0)
    assert len(s.told()) == 1
    assert s.seen() == pytest.approx(9.0, abs=0.25)
    assert s.felt() == pytest.approx(9.0, abs=0.75)
    s.end()


def pad(s):
    s.pad, extra = vtkImageConstantPad(), s.filter.GetKernelRadius() + 1
    s.pad.SetInputData(s.data)
    s.pad.SetOutputWholeExtent(-extra, X - 1 + extra, -extra, Y - 1 + extra, -extra, Y - 1 + extra)
    s.pad.SetConstant(0.0)
    s.pad.Update()
    s.mapper.SetInputConnection(s.pad.GetOutputPort())


@told("It is opaque up to all faces of its image, behind which there is no surface to feel", pad)
def _():
    return Scene(image(wall(-9.0)))


def faces(s):
    s.filter.FeelCutFacesOn()


def passing(make):
    def made():
        s = make()
        s.filter.FeelCutFacesOff()
        return s
    return made


for row in (clipped, cropped, mask_behind_the_wall, label_without_opacity, label_that_alone_has_opacity, blanked_points,
            blanked_cells):
    told("its faces are not felt. Cure: FeelCutFacesOn() of vtkVolumeHapticsFilter", faces)(passing(row))


@told("Points or cells of the image are blanked (array vtkGhostType) and not felt, but its mapper draws them", follow,
      lambda s: s.data.GetPointData().RemoveArray("vtkGhostType"))
def _():
    return unfollowed(blanked_points_that_cpu_draws())


for row in (points_with_another_flag, cells_with_another_flag):
    told("hides points or cells by flags other than those of blanked ones (array vtkGhostType), but they are still felt",
         follow)(lambda row=row: unfollowed(row()))


def resampled(s):
    s.resample = vtkResampleToImage()
    s.resample.SetInputDataObject(s.data)
    s.resample.SetSamplingDimensions(X, Y, Y)
    s.resample.Update()
    s.mapper.SetInputConnection(s.resample.GetOutputPort())


@told("but its data are no image and felt where they are. Cure: vtkResampleToImage", resampled)
def _():
    s = rectilinear_grid()
    s.volume.SetPosition(4.0, 0.0, 0.0)
    return s


@told("Its property has a 2-D transfer function, but voxels that this hides are still felt",
      lambda s: s.look.SetTransferFunctionMode(vtkVolumeProperty.TF_1D))
def _():
    s, function = gpu_mapper(), vtkImageData()
    function.SetDimensions(64, 64, 1)
    function.AllocateScalars(VTK_FLOAT, 4)
    vtk_to_numpy(function.GetPointData().GetScalars())[:] = 1.0
    s.look.SetTransferFunction2D(function)
    s.look.SetTransferFunctionMode(vtkVolumeProperty.TF_2D)
    return s


@pytest.mark.parametrize("words,number", [(words, number) for words, rows in TOLD.items() for number in range(len(rows))])
def test_is_told_or_cured(words, number):
    make, cures = TOLD[words][number]
    for cure in cures:
        s = set_up(make)
        texts = s.told()
        assert len(texts) == 1 and words in texts[0] and "Cure:" in texts[0], texts
        assert texts == [*texts, *s.told()], "once"
        cure(s)
        s.check()
        s.end()
