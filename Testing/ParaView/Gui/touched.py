# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A head to touch in ParaView, for Testing/Window/close.sh: paraview --script=touched.py, with the plugin as
$TOUCH_PLUGIN and the volume as $TOUCH_VOLUME. Writes "felt" when a surface first holds the hand."""

import os

from paraview import servermanager, simple

CONTACT_BEGIN = 1100  # vtkInteractorStyleHaptic::ContactBeginEvent

simple.LoadPlugin(os.environ["TOUCH_PLUGIN"], remote=False, ns=vars(simple))
head = simple.XMLImageDataReader(registrationName="Head", FileName=[os.environ["TOUCH_VOLUME"]])
view = simple.GetActiveViewOrCreate("RenderView")
shown = simple.Show(head, view, "UniformGridRepresentation")
simple.ColorBy(shown, ("POINTS", "HU"))
opacity = simple.GetOpacityTransferFunction("HU")
opacity.Points = [-1000, 0, 0.5, 0, -600, 0, 0.5, 0, -200, 0.35, 0.5, 0, 2000, 0.9, 0.5, 0]
shown.SetRepresentationType("Volume")
view.CameraPosition = [-315, -400, 60]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]
device = simple.HapticDevice(Touch=simple.VolumeHaptics(Input=head, Preset="CT contrast"))
device.Running = 1
device.UpdatePipeline()
simple.Render()
link = servermanager.misc.HapticView(View=view, Device=device)
link.Attached = 1
view.GetInteractor().GetInteractorStyle().AddObserver(CONTACT_BEGIN, lambda *_: print("felt", flush=True))
print("attached", flush=True)
