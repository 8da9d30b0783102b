# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""add_haptics() of volumehaptics.pyvista warns of volumes that are felt otherwise than they are shown."""

import warnings

import numpy as np
import pytest
import pyvista as pv
import volumehaptics
from volumehaptics.pyvista import add_haptics
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkMultiVolume
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper


@pytest.fixture
def scene():
    """Returns a plotter, an image and the actor that shows it."""
    plotter = pv.Plotter(off_screen=True)
    grid = pv.ImageData(dimensions=(17, 17, 17))
    grid["value"] = 100.0 * grid.points[:, 2]
    yield plotter, grid, plotter.add_volume(grid, mapper="gpu")
    plotter.close()


def crop(grid, actor):
    actor.mapper.CroppingOn()
    actor.mapper.SetCroppingRegionPlanes(0, 8, 0, 16, 0, 16)


def clip(grid, actor):
    plane = vtkPlane()
    plane.SetOrigin(8, 8, 8)
    actor.mapper.AddClippingPlane(plane)


def mask(grid, actor):
    inside = pv.ImageData(dimensions=grid.dimensions)
    inside["mask"] = np.full(grid.n_points, 255, np.uint8)
    actor.mapper.SetMaskTypeToBinary()
    actor.mapper.SetMaskInput(inside)


def use_two_dimensions(grid, actor):
    function = pv.ImageData(dimensions=(2, 2, 1))
    function["rgba"] = np.ones((4, 4), np.float32)
    actor.prop.SetTransferFunction2D(function)
    actor.prop.SetTransferFunctionMode(vtkVolumeProperty.TF_2D)  # VTK 9.6 does not set this mode by itself


def move(grid, actor):
    actor.SetPosition(1, 2, 3)


WAYS = {crop: "crops", clip: "clipping planes", mask: "mask", use_two_dimensions: "2-D transfer function"}


@pytest.mark.parametrize("change, words", WAYS.items(), ids=lambda one: getattr(one, "__name__", None))
def test_volumes_that_are_not_felt_as_shown_warn(scene, change, words):
    plotter, grid, actor = scene
    change(grid, actor)
    with pytest.warns(UserWarning, match=f"{words}.*Cure: ") as caught:
        haptics = add_haptics(plotter, actor.mapper.GetInputDataObject(0, 0))
    assert len(caught) == 1 and caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        haptics.update()  # it was told


def test_moved_volumes_warn_where_the_image_is_given(scene):
    plotter, grid, actor = scene
    move(grid, actor)
    with pytest.warns(UserWarning, match="moved, turned or scaled.*Cure: "):
        add_haptics(plotter, actor.mapper.GetInputDataObject(0, 0))


def test_plain_volumes_do_not_warn_until_they_change(scene):
    plotter, grid, actor = scene
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        haptics = add_haptics(plotter, actor.mapper.GetInputDataObject(0, 0))
        haptics.update()
    for change, words in {clip: "clipping planes", move: "moved"}.items():
        change(grid, actor)
        with pytest.warns(UserWarning, match=words) as caught:
            haptics.update()
            haptics.update()
        assert len(caught) == 1


def strongest_force(haptics):
    """Returns the largest force (N) of a push along z at x = y = 10 in the present scene."""
    path = vtkPolyData()
    points = vtkPoints()
    for z in np.arange(6.0, 12.0, 0.1):
        points.InsertNextPoint(10.0, 10.0, z)
    path.SetPoints(points)
    haptics.update()
    haptics.filter.SetPathData(path)
    haptics.filter.Update()
    return np.abs(pv.wrap(haptics.filter.GetOutput())["Force"]).max()


def test_actors_are_felt_as_they_are_shown(scene):
    plotter, grid, actor = scene
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        haptics = add_haptics(plotter, actor)
        assert strongest_force(haptics) > 1.0
        haptics.filter.FeelCutFacesOn()
        clip(grid, actor)
        actor.mapper.GetClippingPlanes().GetItem(0).SetNormal(-1, 0, 0)
        assert strongest_force(haptics) == 0.0  # the cropping hides x = 10
        actor.mapper.RemoveAllClippingPlanes()
        assert strongest_force(haptics) > 1.0
        crop(grid, actor)  # keep what is beyond x = 8
        assert strongest_force(haptics) == 0.0
        actor.mapper.CroppingOff()
        mask(grid, actor)
        assert strongest_force(haptics) > 1.0  # which shows all
        pv.wrap(actor.mapper.GetMaskInput())["mask"][grid.points[:, 0] > 8] = 0
        actor.mapper.GetMaskInput().Modified()
        assert strongest_force(haptics) == 0.0
        actor.mapper.SetMaskInput(None)
        actor.SetPosition(12, 0, 0)
        assert strongest_force(haptics) == 0.0  # the volume now begins at 12
        actor.SetPosition(1, 2, 3)
        assert strongest_force(haptics) > 1.0
        assert haptics.filter.GetTouchedImage().GetOrigin() == pytest.approx((1, 2, 3))


def refuses(haptics, words):
    """Expects that touching is refused with a warning that contains `words`."""
    haptics.update()
    with pytest.warns(UserWarning, match=f"{words}.*Cure: "):
        haptics.style.SetTouchMode(True)
        haptics.update()
    return not haptics.style.GetTouchMode() and not haptics.device.IsArmOrdered()


def begins(haptics):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        haptics.style.SetTouchMode(True)
        haptics.update()
    return haptics.style.GetTouchMode()


@pytest.mark.parametrize("visibility", (True, False))
def test_what_another_actor_of_its_name_replaces_is_not_felt(window, hands, visibility):
    hand = hands(visibility=visibility)
    hand.push()
    new = hand.plotter.add_volume(pv.ImageData(hand.volume.mapper.dataset), name=hand.volume.name)
    hand.wait(lambda: hand.device.GetState().GetForce() == (0, 0, 0))
    assert refuses(hand.haptics, "not felt")
    hand.haptics.close()
    hand.haptics = add_haptics(hand.plotter, new, visibility=visibility)
    hand.push()


def test_what_is_made_invisible_is_not_felt(window, hands):
    hand = hands()
    hand.push()
    hand.volume.visibility = False
    with pytest.warns(UserWarning, match="hidden.*Cure: VisibilityOn"):
        hand.haptics.update()
    hand.wait(lambda: hand.device.GetState().GetForce() == (0, 0, 0))
    assert refuses(hand.haptics, "hidden")
    hand.volume.VisibilityOn()
    hand.push()


def test_frames_that_are_made_invisible_are_not_felt(window):
    plotter = pv.Plotter(off_screen=True)
    frames = []
    for shift in (0.0, 1.0):
        frames.append(pv.ImageData(dimensions=(17, 17, 17)))
        frames[-1]["value"] = 100.0 * (frames[-1].points[:, 2] + shift)
    actor = plotter.add_volume(frames[0])
    haptics = add_haptics(plotter, frames)
    plotter.show(auto_close=False)
    assert begins(haptics)
    actor.VisibilityOff()
    end = haptics.device.GetState().GetTick() + 50
    with pytest.warns(UserWarning, match="invisible.*Cure: VisibilityOn"):
        while haptics.device.GetState().GetTick() < end:
            haptics.update()
    assert not haptics.style.GetTouchMode() and not haptics.device.IsArmOrdered()
    assert refuses(haptics, "invisible")
    actor.VisibilityOn()
    haptics.update()
    assert begins(haptics)
    plotter.close()


def test_the_actor_of_another_subplot_is_felt_there(window):
    plotter = pv.Plotter(off_screen=True, shape=(1, 2))
    grid = pv.ImageData(dimensions=(17, 17, 17))
    grid["value"] = 100.0 * grid.points[:, 2]
    plotter.subplot(0, 0)
    actor = plotter.add_volume(grid)
    plotter.subplot(0, 1)
    plotter.add_mesh(pv.Sphere())
    haptics = add_haptics(plotter, actor)
    assert haptics.style.GetDefaultRenderer() is plotter.renderers[0]
    assert plotter.renderers[0].HasViewProp(haptics.representation)
    plotter.show(auto_close=False)
    assert begins(haptics)
    plotter.subplot(0, 0)
    plotter.remove_actor(actor)
    assert not haptics.style.GetTouchMode() and refuses(haptics, "not felt")
    plotter.close()


def test_what_nobody_sees_is_refused(scene):
    plotter, grid, actor = scene
    plotter.remove_actor(actor)
    with pytest.raises(ValueError, match="not in the plotter.*Cure: .*plotter.add_actor") as error:
        add_haptics(plotter, actor)
    assert error
    plotter.add_actor(actor)
    assert add_haptics(plotter, actor).device.IsRunning()


def test_the_second_hand_lets_go_of_what_nobody_sees(scene):
    plotter, _, actor = scene
    second = volumehaptics.vtkHapticDevice()
    assert second.Open("virtual")
    with add_haptics(plotter, actor, device=["virtual", second]) as haptics:
        second.Arm()
        actor.VisibilityOff()
        with pytest.warns(UserWarning, match="taken out of the plotter"):
            haptics.style.Modified()
        assert not second.IsArmOrdered()


def test_multi_volumes_are_touched(scene):
    plotter, grid, actor = scene
    image = actor.mapper.GetInputDataObject(0, 0)
    multi, mapper = vtkMultiVolume(), vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputDataObject(0, image)
    multi.SetMapper(mapper)
    multi.SetVolume(actor, 0)
    plotter.renderer.AddVolume(multi)
    for volume in multi, multi.GetVolume(0):
        with add_haptics(plotter, volume) as haptics:
            assert haptics.device.IsRunning()
            assert haptics.style.GetTouchedVolume() is actor


def test_a_sheared_actor_warns(scene):
    plotter, grid, actor = scene
    shear = vtkMatrix4x4()
    shear.SetElement(0, 1, 0.5)
    actor.SetUserMatrix(shear)
    with pytest.warns(UserWarning, match="moved, turned or scaled"):
        add_haptics(plotter, actor)


def test_warnings_that_are_errors_leave_nothing_behind(scene):
    plotter, grid, actor = scene
    crop(grid, actor)
    image = actor.mapper.GetInputDataObject(0, 0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="crops"):
            add_haptics(plotter, image)
    with pytest.warns(UserWarning, match="crops"):
        assert add_haptics(plotter, image).device.IsRunning()  # the plotter is unchanged


def test_another_volume_is_felt_by_its_own_filter(scene):
    plotter, grid, actor = scene
    other = plotter.add_volume(grid.copy(), mapper="gpu")
    other.SetPosition(40, 0, 0)
    haptics = add_haptics(plotter, actor)
    touch = type(haptics.filter)()
    assert haptics.style.AddTouchedVolume(other, touch)
    assert haptics.style.GetNumberOfTouchedVolumes() == 2
    haptics.update()
    assert touch.GetTouchedImage().GetOrigin()[0] == 40.0
    assert haptics.style.GetTouchedVolume() is actor
