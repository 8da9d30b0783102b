# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of a device in a render view."""

import sys
import time

from paraview import servermanager, simple

PATIENCE = 120.0  # s; only so that nothing hangs

simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))


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
    """The props of this plugin in a view."""
    props = view.SMProxy.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
    return sorted(prop.GetClassName() for prop in props if prop.GetClassName().startswith("vtkHaptic"))


def wait_until(view, is_so, what):
    """While the view's own events, its timer above all, move it all."""
    end = time.monotonic() + PATIENCE
    while not is_so():
        assert time.monotonic() < end, f"{what} within {PATIENCE:.0f} s"
        view.GetInteractor().ProcessEvents()
        time.sleep(0.005)


def lead_out(view, device):
    """In front of the forehead."""
    device.VirtualTip = [-25, -110, 45]
    wait_until(view, lambda: get(device, "TipPosition") == [-25, -110, 45], "the tip did not get there")


def lead_in(view, device):
    """Into the forehead, armed. A wall that is pressed before all of the force may flow stays soft."""
    wait_until(view, lambda: "100 % of the force" in "".join(get(device, "StatusText")), "the ramp was not over")
    device.VirtualTip = [-25, -70, 45]
    wait_until(view, lambda: force(device) > 0.5, "the skin was not felt")


def press(view, device):
    """Into the forehead from the front."""
    device.VirtualTip = [-25, -110, 45]
    device.Running = 1
    device.UpdatePipeline()
    lead_out(view, device)
    device.Armed = 1
    lead_in(view, device)


def run(case):
    """A case of a test, with a view of a head, a device that touches that, and the link between them."""
    head = simple.XMLImageDataReader(registrationName="Head", FileName=[sys.argv[2]])
    touch = simple.VolumeHaptics(Input=head, Preset="CT contrast")
    device = simple.HapticDevice(Touch=touch)
    view = simple.CreateRenderView(ViewSize=[300, 300])
    simple.Show(head, view, "UniformGridRepresentation")
    simple.Render(view)
    case(view, device, make_link(view, device))
