# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of a device in a render view."""

import sys
import time

from paraview import servermanager, simple

PATIENCE = 120.0  # s; the limit only ends a hang

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
    """Returns the class names of this plugin's props in a view."""
    props = view.SMProxy.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
    return sorted(prop.GetClassName() for prop in props if prop.GetClassName().startswith("vtkHaptic"))


def wait_until(view, is_so, what):
    """Processes the view's events, above all its timer, until `is_so` is true."""
    end = time.monotonic() + PATIENCE
    while not is_so():
        assert time.monotonic() < end, f"{what} within {PATIENCE:.0f} s"
        view.GetInteractor().ProcessEvents()
        time.sleep(0.005)


def lead_out(view, device, x=-25):
    """Moves the tip in front of the forehead."""
    device.VirtualTip = [x, -110, 45]
    wait_until(view, lambda: get(device, "TipPosition") == [x, -110, 45], "the tip did not get there")


def lead_in(view, device, x=-25):
    """Arms the device and moves the tip into the forehead. A wall that is pressed before the full force may act stays
    soft."""
    wait_until(view, lambda: "100 % of the force" in "".join(get(device, "StatusText")), "the ramp was not over")
    device.VirtualTip = [x, -70, 45]
    wait_until(view, lambda: force(device) > 0.5, "the skin was not felt")


def press(view, device, x=-25):
    """Moves the tip into the forehead from the front."""
    device.VirtualTip = [x, -110, 45]
    device.Running = 1
    device.UpdatePipeline()
    lead_out(view, device, x)
    device.Armed = 1
    lead_in(view, device, x)


def run(case):
    """Runs a case of a test with a view of a head, a device that touches the head, and the link between view and
    device."""
    head = simple.XMLImageDataReader(registrationName="Head", FileName=[sys.argv[2]])
    touch = simple.VolumeHaptics(Input=head, Preset="CT contrast")
    device = simple.HapticDevice(Touch=touch)
    view = simple.CreateRenderView(ViewSize=[300, 300])
    simple.Show(head, view, "UniformGridRepresentation")
    simple.Render(view)
    case(view, device, make_link(view, device))
