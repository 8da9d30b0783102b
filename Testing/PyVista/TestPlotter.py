# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests add_haptics() of volumehaptics.pyvista off screen: the force in a plotter, and what ends together with the
plotter."""

import gc
import time

import numpy as np
import pytest
import pyvista as pv
from volumehaptics import open_large, vtkHapticDevice, vtkInteractorStyleHaptic
from volumehaptics.pyvista import add_haptics


def test_nothing_is_felt_before_the_user_touches(window, hands):
    hand = hands()
    device = hand.device
    assert device.IsRunning() and device.GetDeviceId() == "virtual" and device.GetAttentionTime() == 10.0
    device.GetVirtualHand().SetPosition(0, 0, 15)  # in the ball
    hand.wait(lambda: device.GetState().GetTick() > 100)
    assert device.GetStatus() == vtkHapticDevice.READY and device.GetState().GetForce() == (0, 0, 0)


@pytest.mark.parametrize("columns", (1, 2))
def test_mouse_touches(window, hands, columns):
    hand = hands(columns=columns)
    hand.push(steps=2)  # the strength of 2 N holds 500 N/m up to 4 mm; a deeper push goes through
    # The force points towards the viewer, opposite to the line of sight.
    sight = np.array(hand.plotter.camera.direction)
    assert np.dot(hand.device.GetState().GetForce(), sight) < -0.1
    tick = hand.device.GetState().GetTick()
    hand.wait(lambda: hand.device.GetState().GetTick() > tick + 200)
    assert 19.8 < np.linalg.norm(hand.device.GetState().GetProxyPosition()) < 20.2  # the visible surface of the ball
    hand.press("Escape")
    hand.wait(lambda: hand.device.GetState().GetForce() == (0, 0, 0))
    assert not hand.haptics.style.GetTouchMode()


def press_ball(hand):
    """Presses the armed tip into the ball from outside, and returns the force (N)."""
    device, sight = hand.device, hand.plotter.camera.direction
    for distance in (24, 15):
        device.GetVirtualHand().SetPosition(*(-distance * x for x in sight))
        hand.wait(lambda: np.linalg.norm(np.add(device.GetState().GetTipPosition(), distance * np.array(sight))) < 1e-6)
        device.Arm()
        hand.wait(lambda: "100 % of the force" in device.GetStatusText())
    tick = device.GetState().GetTick()
    hand.wait(lambda: device.GetState().GetTick() > tick + 700)
    return np.linalg.norm(device.GetState().GetForce())


@pytest.mark.parametrize("visibility, felt", ((True, False), (False, True)))
def test_what_is_hidden_is_not_felt(window, hands, visibility, felt):
    hand = hands(visibility=visibility)
    hand.volume.prop.apply_lookup_table(pv.LookupTable(scalar_range=(-1, 1)))
    hand.volume.prop.GetScalarOpacity().RemoveAllPoints()
    hand.volume.prop.GetScalarOpacity().AddPoint(0, 0.0)
    assert (press_ball(hand) > 0.5) == felt


def test_the_flow_of_a_grid_is_followed(window):
    """The vectors run along x, in two blocks. There is no force along them; across them acts a spring of 500 N/m, here
    3 mm long."""
    blocks = pv.MultiBlock()
    for first in (-12.0, 0.0):
        block = pv.RectilinearGrid(first + np.arange(0.0, 13.0, 2.0), np.linspace(-9, 9, 8), np.linspace(-9, 9, 4))
        block.cell_data["U"] = np.tile([3.0, 0.0, 0.0], (block.n_cells, 1))
        blocks.append(block)
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
    plotter.add_mesh(blocks, style="wireframe")
    with add_haptics(plotter, blocks) as haptics:
        device, end = haptics.device, time.monotonic() + 30.0
        assert haptics.filter.GetMode(0).GetText() == "vector follow, U"
        plotter.show(auto_close=False)

        def wait(holds):
            while not holds():
                assert time.monotonic() < end, device.GetStatusText()
                haptics.update()
                time.sleep(0.002)

        device.GetVirtualHand().SetPosition(-3, 0, 0)
        wait(lambda: device.GetState().GetTick() > 50)
        device.Arm()
        wait(lambda: "100 % of the force" in device.GetStatusText())
        for step in range(1, 31):
            device.GetVirtualHand().SetPosition(-3 + 0.2 * step, 0.1 * step, 0)
            tick = device.GetState().GetTick()
            wait(lambda: device.GetState().GetTick() > tick + 5)
        wait(lambda: np.allclose(device.GetState().GetForce(), (0, -1.5, 0), atol=0.02))
    plotter.close()


def test_labels_have_materials(window, hands):
    """The tip passes through a label that is not felt, until the table of labels changes that."""
    hand = hands(labels=np.ones((33, 33, 33), np.uint8), materials={1: {"name": "ball", "felt": False}})
    table = hand.haptics.filter.GetLabelTable()
    assert table.GetLabelName(1) == "ball"
    for felt in (False, True):
        table.SetFelt(1, felt)
        assert (press_ball(hand) > 0.1) == felt


def test_a_volume_larger_than_memory_is_shown_by_its_coarse_level(window):
    z, y, x = np.meshgrid(*[np.arange(-32, 33, 2.0)] * 3, indexing="ij")
    ball = (100 * (20 - np.sqrt(x * x + y * y + z * z))).astype(np.float32)
    large = open_large(ball, (2, 2, 2), (-32, -32, -32), coarse=ball[::2, ::2, ::2])
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
    haptics = add_haptics(plotter, large, visibility=False)
    (shown,) = (one for one in plotter.actors.values() if isinstance(one, pv.Volume))
    assert shown.mapper.GetInputDataObject(0, 0).GetDimensions() == (17, 17, 17)
    device = haptics.device

    def wait(holds):
        end = time.monotonic() + 20
        while not holds() and time.monotonic() < end:
            haptics.update()
            time.sleep(0.002)
        assert holds(), device.GetStatusText()

    device.GetVirtualHand().SetPosition(0, 0, 24)
    wait(lambda: device.GetState().GetTipPosition()[2] == 24 and device.GetState().GetResidency() == 1)
    device.Arm()
    wait(lambda: "100 % of the force" in device.GetStatusText())
    device.GetVirtualHand().SetPosition(0, 0, 15)
    wait(lambda: device.GetState().GetForce()[2] > 0.5)
    def find_fine():
        plotter.render_window.Render()
        return [one.GetMapper().GetInputDataObject(0, 0) for one in plotter.renderer.GetVolumes()
                if one.GetVisibility() and one.GetMapper() is not shown.mapper]

    wait(find_fine)
    assert find_fine()[0].GetSpacing() == (2, 2, 2)
    assert list(shown.mapper.GetCroppingRegionPlanes()) == pytest.approx(large.GetOutput().GetBounds())
    plotter.close()
    assert haptics.closed and haptics.style.GetCoarseVolume() is None


def test_slices_lie_beside_the_scene(window, hands):
    hand = hands(slices=True)
    hand.plotter.show(auto_close=False)
    slices, interactor = hand.haptics.slices, hand.plotter.iren.interactor
    assert hand.plotter.renderer.GetViewport() == (0.0, 0.0, 0.7, 1.0)
    x, y = 170, 160  # 30 pixels left of the edge, in the uppermost of three slices
    assert slices.FindSlice(x, y) == 0
    position = [0.0, 0.0, 0.0]
    assert slices.FindPosition(0, x, y, position)
    interactor.SetEventInformation(x, y, 0, 0)
    interactor.LeftButtonPressEvent()
    interactor.LeftButtonReleaseEvent()
    hand.wait(lambda: hand.device.GetState().GetTipPosition() == pytest.approx(position))
    assert hand.haptics.style.GetTouchMode()
    hand.haptics.close()
    assert hand.plotter.renderer.GetViewport() == (0.0, 0.0, 1.0, 1.0)


def test_keys_measure_where_the_ball_is_touched(window, hands, tmp_path):
    hand = hands()
    hand.push(steps=2)
    hand.press("1")
    measurements = hand.haptics.measurements
    assert measurements.GetNumberOfMeasurements() == 1
    point = [0.0, 0.0, 0.0]
    measurements.GetPoint(0, 0, point)
    assert 19 < np.linalg.norm(point) < 21
    assert measurements.WriteFile(str(tmp_path / "ball.mrk.json"))
    assert hand.plotter.renderer.HasViewProp(hand.haptics.measured)
    hand.haptics.close()
    assert not hand.plotter.renderer.HasViewProp(hand.haptics.measured)


def test_closing_the_plotter_stops_everything(window, hands):
    hand = hands()
    hand.push()
    hand.plotter.close()
    assert hand.haptics.closed and not hand.device.IsRunning() and not hand.device.IsOpen()
    hand.haptics.close()  # again


def test_another_style_of_the_plotter_ends_nothing(window, hands):
    hand = hands()
    hand.push()
    hand.plotter.enable_trackball_actor_style()
    assert hand.haptics.style.GetTouchMode() and not hand.haptics.closed
    tick = hand.device.GetState().GetTick()
    hand.wait(lambda: hand.device.GetState().GetTick() > tick + 20)
    assert np.linalg.norm(hand.device.GetState().GetForce()) > 0.1
    hand.press("Escape")
    hand.wait(lambda: hand.device.GetState().GetForce() == (0, 0, 0))
    hand.plotter.close()
    assert hand.haptics.closed and not hand.device.IsOpen()


def test_the_plotters_style_lives_on(window, hands):
    """Tests PyVista's own style: a drag with the left button turns the camera, but not while the hand has the mouse."""
    hand = hands()
    style = hand.plotter.iren.style
    assert not isinstance(style, vtkInteractorStyleHaptic) and style is not None

    def drag():
        interactor, before = hand.plotter.iren.interactor, hand.plotter.camera.position
        for event, x in (("LeftButtonPressEvent", 100), ("MouseMoveEvent", 140), ("LeftButtonReleaseEvent", 140)):
            interactor.SetEventInformation(x, 100, 0, 0)
            interactor.InvokeEvent(event)
        return hand.plotter.camera.position != before

    hand.plotter.show(auto_close=False)
    assert drag()
    hand.push()
    assert not drag()
    hand.press("Escape")
    assert drag()
    assert hand.plotter.iren.style is style


def test_the_volume_under_the_pointer_is_touched(window):
    """Two balls lie beside each other; later the program puts a third ball in place of both. Each has 500 N/m."""
    plotter = pv.Plotter(off_screen=True, window_size=(300, 200))

    def add(x):
        grid = ball(20.0)
        grid.origin = (x - 32.0, -32.0, -32.0)
        return plotter.add_volume(grid, clim=(-1, 1), opacity=[0, 0, 1, 1], show_scalar_bar=False)

    actors = [add(x) for x in (-40.0, 40.0)]
    haptics = add_haptics(plotter)
    plotter.view_xy()
    plotter.show(auto_close=False)
    interactor, device = plotter.iren.interactor, haptics.device

    def feel(x):
        """Waits for the force of a spring; returns the proxy's position then."""
        renderer = plotter.renderer
        renderer.SetWorldPoint(x, 0.0, 20.0, 1.0)
        renderer.WorldToDisplay()
        interactor.SetEventInformation(*(int(part) for part in renderer.GetDisplayPoint()[:2]), 0, 0)
        interactor.SetKeySym("t")
        interactor.KeyPressEvent()
        interactor.KeyReleaseEvent()
        assert haptics.widget.GetTouchMode()
        # Move out and in again, because a wall that is pressed before the full force is active feels soft.
        for turn in [interactor.MouseWheelBackwardEvent] * 3 + [interactor.MouseWheelForwardEvent] * 5:
            wait(haptics, lambda: "100 % of the force" in device.GetStatusText())
            tick = device.GetState().GetTick()
            turn()
            wait(haptics, lambda: device.GetState().GetTick() > tick + 50)

        def is_spring():
            force, proxy, tip = map(np.array, (device.GetState().GetForce(), device.GetState().GetProxyPosition(), device.GetState().GetTipPosition()))
            return np.linalg.norm(force) > 0.5 and np.abs(force - 0.5 * (proxy - tip)).max() < 0.02

        wait(haptics, is_spring)
        proxy = np.array(device.GetState().GetProxyPosition())
        haptics.widget.SetTouchMode(False)
        wait(haptics, lambda: device.GetState().GetForce() == (0, 0, 0))
        return proxy

    for x in (-40.0, 40.0):
        assert np.linalg.norm(feel(x) - (x, 0.0, 0.0)) == pytest.approx(22.5, abs=3.0)
    for actor in actors:
        plotter.remove_actor(actor)
    add(0.0)
    assert np.linalg.norm(feel(0.0)) == pytest.approx(22.5, abs=3.0)
    plotter.clear()
    interactor.SetKeySym("t")
    with pytest.warns(UserWarning, match="shows no volume.*Cure: "):
        interactor.KeyPressEvent()
    assert not haptics.widget.GetTouchMode()
    plotter.close()


def test_close_gives_the_plotter_back(window, hands):
    hand = hands()
    style = hand.plotter.iren.style
    with hand.haptics as haptics:
        assert hand.plotter.renderer.HasViewProp(haptics.representation)
    assert hand.plotter.iren.style is style
    for prop in (haptics.representation, haptics.head_up_display):
        assert not hand.plotter.renderer.HasViewProp(prop)
    with add_haptics(hand.plotter) as again:  # add_haptics() finds the only volume
        assert again.device.IsRunning()
    assert not again.device.IsRunning()


def test_garbage_stops_the_device(window):
    plotter = pv.Plotter(off_screen=True)
    grid = pv.ImageData(dimensions=(9, 9, 9))
    grid["value"] = 100.0 * grid.points[:, 2]
    device = add_haptics(plotter, plotter.add_volume(grid)).device
    gc.collect()
    assert device.IsRunning()  # the plotter keeps the device
    pv.plotting.plotter._ALL_PLOTTERS.clear()  # PyVista's own list of open plotters
    del plotter
    gc.collect()
    assert not device.IsRunning() and not device.IsOpen()


def test_device_of_ones_own_stays_open(window, hands):
    device = vtkHapticDevice()
    assert device.Open("virtual")
    device.SetAttentionTime(3.0)
    hand = hands(device=device)
    assert hand.device is device and device.GetAttentionTime() == 3.0
    hand.plotter.close()
    assert device.IsOpen() and not device.IsRunning()


def test_screenshot_shows_the_hand(window, hands):
    hand = hands()
    hand.plotter.show(auto_close=False)
    before = hand.plotter.screenshot()
    hand.push()
    hand.plotter.render()
    after = hand.plotter.screenshot()
    assert (before != after).any() and not hand.haptics.closed


def ball(radius):
    """Returns a ball around the origin."""
    grid = pv.ImageData(dimensions=(33, 33, 33), spacing=(2, 2, 2), origin=(-32, -32, -32))
    grid["inside"] = 100.0 * (radius - (grid.points.astype(float) ** 2).sum(axis=1) ** 0.5)
    return grid


@pytest.fixture
def beating(window):
    """Returns a plotter with the first of four balls whose radii grow by a millimetre, and the balls."""
    balls = [ball(radius) for radius in (18.0, 19.0, 20.0, 21.0)]
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
    plotter.add_volume(balls[0], clim=(-1, 1), opacity=[0, 0, 1, 1], show_scalar_bar=False)
    yield plotter, balls
    plotter.close()


def wait(haptics, holds):
    end = time.monotonic() + 30.0
    while not holds():
        assert time.monotonic() < end, haptics.device.GetStatusText()
        haptics.update()
        time.sleep(0.002)


def test_frames_play_and_are_seen(beating):
    plotter, balls = beating
    haptics = add_haptics(plotter, balls, [0.0, 0.1, 0.2, 0.3])
    device, mapper = haptics.device, next(iter(plotter.actors.values())).GetMapper()
    assert device.GetPlayback().IsPlaying() and haptics.frames.GetNumberOfTimeSteps() == 4
    seen = set()

    def all_are_seen():
        if device.GetPlayback().HasTimeSteps():
            shown = mapper.GetInputDataObject(0, 0).GetScalarComponentAsDouble(16, 16, 16, 0)
            # value in the middle of a ball
            assert shown == pytest.approx(1800.0 + 1000.0 * device.GetPlayback().GetTimeStepValue())
            assert abs(device.GetPlayback().GetTimeStepValue() - device.GetPlayback().GetDataTime()) < 0.0501 or device.GetPlayback().GetDataTime() > 0.3
            seen.add(round(shown))
        return len(seen) == 4

    wait(haptics, all_are_seen)
    device.GetPlayback().Hold()
    haptics.close()


def test_frames_push_a_hand_that_rests(beating):
    plotter, balls = beating
    haptics = add_haptics(plotter, balls, times=[0.0, 1.0, 2.0, 3.0], visibility=False, time_units_per_second=10.0)
    device = haptics.device
    device.GetVirtualHand().SetPosition(0, 0, 19)
    device.GetPlayback().SetModeToOnce()
    device.GetPlayback().SetDataTime(0.0)
    wait(haptics, lambda: device.GetPlayback().GetDataTime() == 3.0)
    # Values rise linearly, so the level at the tip moves outwards by 3 mm wherever the tip is, and the spring of 500
    # N/m pushes the tip.
    assert device.GetState().GetComputedForce()[2] == pytest.approx(0.5 * 3.0, abs=0.05)


@pytest.mark.parametrize("frames, times, error", (
    ([0], None, "two frames at least"),
    ([0, 1], [0.0, 0.0], "a finite time of its own"),
    ([0, 1], [0.0], "a finite time of its own"),
    ([0, "smaller"], None, "the extent, spacing, origin and direction"),
))
def test_frames_that_are_none(beating, frames, times, error):
    plotter, balls = beating
    smaller = pv.ImageData(dimensions=(9, 9, 9))
    with pytest.raises(ValueError, match=error):
        add_haptics(plotter, [smaller if frame == "smaller" else balls[frame] for frame in frames], times)
