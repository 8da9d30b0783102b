# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A device in a render view, without Qt: pvpython TestView.py PLUGIN VOLUME CASE.

One view a process: where pvpython of ParaView 5.11 has closed a view, ProcessEvents() of the next one crashes, with or
without this plugin.
"""

import sys
import time

from paraview import servermanager, simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())


def get(device, name):
    device.UpdatePropertyInformation()
    return list(device.GetPropertyValue(name))


def force(device):
    return sum(x * x for x in get(device, "Force")) ** 0.5


def make_link(view, device):
    proxy = servermanager.ProxyManager().NewProxy("misc", "HapticView")
    link = servermanager._getPyProxy(proxy)
    link.View = view
    link.Device = device
    return link


def hands(view):
    """What of this plugin is in a view."""
    props = view.SMProxy.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
    return sorted(prop.GetClassName() for prop in props if prop.GetClassName().startswith("vtkHaptic"))


def wait_until(view, is_so, what):
    """While the view's own events, its timer above all, move it all."""
    end = time.monotonic() + 30
    while not is_so():
        assert time.monotonic() < end, f"{what} within 30 s"
        view.GetInteractor().ProcessEvents()
        time.sleep(0.005)


def press(view, device):
    """Into the forehead from the front."""
    device.VirtualTip = [-25, -110, 45]
    device.Running = 1
    device.UpdatePipeline()
    wait_until(view, lambda: get(device, "TipPosition") == [-25, -110, 45], "the tip did not get there")
    device.Armed = 1
    device.VirtualTip = [-25, -70, 45]
    wait_until(view, lambda: force(device) > 0.5, "the skin was not felt")


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


def main(case):
    head = simple.XMLImageDataReader(FileName=[sys.argv[2]])
    touch = VolumeHaptics(Input=head, Preset="CT contrast")  # noqa: F821, from the plugin
    device = HapticDevice(Touch=touch)  # noqa: F821
    view = simple.CreateRenderView(ViewSize=[300, 300])
    simple.Show(head, view, "UniformGridRepresentation")
    simple.Render(view)
    case(view, device, make_link(view, device))


main(globals()[sys.argv[3]])
