# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A device in a render view, without Qt: pvpython TestView.py PLUGIN VOLUME CASE.

One view a process: if pvpython of ParaView 5.11 has closed a view, ProcessEvents() of the next one crashes, with or
without this plugin.
"""

import sys
import time

from paraview import simple

from view import force, hands, lead_out, make_link, press, run, wait_until


def detach(view, device, link):
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    assert view.GetInteractor().GetInteractorStyle() is not style, "nothing is attached"
    assert hands(view) == ["vtkHapticHeadUpDisplay", "vtkHapticRepresentation"], "the hand is not shown"
    press(view, device)
    link.Attached = 0
    assert view.GetInteractor().GetInteractorStyle() is style, "the view has not got its own style back"
    assert not hands(view), "something is left in the view"
    assert device.Armed == 0 and force(device) == 0.0, "a detached device has force"


def refuse_second(view, device, link):
    link.Attached = 1
    haptic = view.GetInteractor().GetInteractorStyle()
    other = make_link(view, device)
    other.Attached = 1
    assert other.Attached == 0 and link.Attached == 1
    assert view.GetInteractor().GetInteractorStyle() is haptic


def change_style(view, device, link):
    """ParaView takes the view for something else: that stays."""
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    haptic = view.GetInteractor().GetInteractorStyle()
    press(view, device)
    view.InteractionMode = "2D"
    assert view.GetInteractor().GetInteractorStyle() not in (style, haptic)
    assert link.Attached == 0 and not hands(view)
    assert device.Armed == 0 and force(device) == 0.0, "force, and no hand in the view"
    view.InteractionMode = "3D"
    assert view.GetInteractor().GetInteractorStyle() is style


def close_view(view, device, link):
    link.Attached = 1
    press(view, device)
    simple.Delete(view)
    assert link.Attached == 0 and device.Armed == 0 and force(device) == 0.0, "the view is closed, and force is left"
    assert link.View is None, "a closed view is kept"


def delete_device(view, device, link):
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    press(view, device)
    simple.Delete(device)
    assert link.Attached == 0 and force(device) == 0.0, "the device is deleted, and force is left"
    assert view.GetInteractor().GetInteractorStyle() is style and not hands(view)


def slices(view, device, link):
    """Those of an Orthographic Slice View follow the tip within the volume, and stay at rest."""
    sliced = simple.CreateView("OrthographicSliceView", ViewSize=[200, 200])
    simple.Show(simple.FindSource("Head"), sliced)
    simple.Render(sliced)
    link.Attached = 1
    press(view, device)
    wait_until(view, lambda: list(sliced.SlicePosition) == [-25, -70, 45], "the slices did not follow the tip")
    bounds = simple.FindSource("Head").GetDataInformation().GetBounds()
    device.Armed = 0
    device.VirtualTip = [-25, bounds[2] - 20, 45]
    wait_until(view, lambda: list(sliced.SlicePosition) == [-25, bounds[2], 45], "the slices left the volume")
    sliced.SlicePosition = [0, 0, 0]
    for _ in range(50):
        view.GetInteractor().ProcessEvents()
        time.sleep(0.005)
    assert list(sliced.SlicePosition) == [0, 0, 0], "a tip at rest has moved the slices"
    link.SlicesFollowTip = 0
    lead_out(view, device)
    assert list(sliced.SlicePosition) == [0, 0, 0], "the slices follow although they should not"


def end_session(view, device, link):
    link.Attached = 1
    press(view, device)
    simple.Disconnect()


run(globals()[sys.argv[3]])
