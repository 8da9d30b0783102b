# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A device in a render view, without Qt: pvpython TestView.py PLUGIN VOLUME CASE.

One view a process: if pvpython of ParaView 5.11 has closed a view, ProcessEvents() of the next one crashes, with or
without this plugin.
"""

import sys

from paraview import simple

from view import force, hands, make_link, press, run


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


def end_session(view, device, link):
    link.Attached = 1
    press(view, device)
    simple.Disconnect()


run(globals()[sys.argv[3]])
