# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Voxels that the volume rendering hides are not felt, as long as the device follows the rendering."""
from paraview import simple

import live

live.load_plugin()
wavelet = simple.Wavelet()
touch = simple.VolumeHaptics(Input=wavelet)
view = simple.CreateRenderView()
shown = simple.Show(wavelet, view, "UniformGridRepresentation")
shown.SetRepresentationType("Volume")
simple.ColorBy(shown, ("POINTS", "RTData"))
opacity = simple.GetOpacityTransferFunction("RTData")
HIDDEN, SEEN = [0, 0, 0.5, 0, 300, 0, 0.5, 0], [0, 1, 0.5, 0, 300, 1, 0.5, 0]
device = simple.HapticDevice(Touch=touch)


def felt():
    """Returns the force (N) of a hand that presses anew."""
    live.press(device, [-9, 0, 0], [-4, 0, 0], armed=False)
    live.poll_for(device, 0.1)
    return live.norm(device.ComputedForce)


opacity.Points = SEEN
seen = felt()
live.check(seen > 0.5, "what is seen is felt", seen)
opacity.Points = HIDDEN
live.check(felt() == 0.0, "what is hidden is not", list(device.ComputedForce))

# Cropped voxels are invisible, so they must not be felt. The cropping box has the bounds -10 to 10, scaled and moved.
opacity.Points = SEEN
shown.CroppingScale = [0.1, 1, 1]
live.check(abs(felt() - seen) < 0.01, "as long as it is not used", list(device.ComputedForce), seen)
shown.UseCropping = 1
live.check(felt() == 0.0, "the box ends at x = -1", list(device.ComputedForce))
shown.CroppingScale = [0.5, 1, 1]
shown.CroppingOrigin = [-5, 0, 0]
live.check(abs(felt() - seen) < 0.01, "the box goes from -10 to 0", list(device.ComputedForce), seen)
shown.CroppingOrigin = [5, 0, 0]
live.check(felt() == 0.0, "the box begins at 0", list(device.ComputedForce))
shown.UseCropping = 0
live.check(abs(felt() - seen) < 0.01, "all of it is there again", list(device.ComputedForce), seen)
opacity.Points = HIDDEN

device.FollowOpacity = 0
live.check(abs(felt() - seen) < 0.01, "unless the device does not follow", list(device.ComputedForce), seen)
device.FollowOpacity = 1
shown.SetRepresentationType("Outline")
live.check(abs(felt() - seen) < 0.01, "nor is what has no opacity hidden", list(device.ComputedForce), seen)
shown.SetRepresentationType("Volume")
live.check(felt() == 0.0, "it is looked for at every poll", list(device.ComputedForce))

# For an array with several components, the opacity applies to the touched component only if the view shows this
# component.
vectors = simple.Calculator(Input=wavelet, Function="RTData*iHat + RTData*jHat + 1000*kHat", ResultArrayName="Vectors")
touch = simple.VolumeHaptics(Input=vectors, Scalars=["POINTS", "Vectors"], Component=1)
simple.Hide(wavelet, view)
shown = simple.Show(vectors, view, "UniformGridRepresentation")
shown.SetRepresentationType("Volume")
simple.ColorBy(shown, ("POINTS", "Vectors"))
colors = simple.GetColorTransferFunction("Vectors")
simple.GetOpacityTransferFunction("Vectors").Points = [0, 0, 0.5, 0, 2000, 0, 0.5, 0]
colors.VectorMode = "Magnitude"
device.Touch = touch
live.check(felt() > 0.5, "the magnitude's opacity says nothing of a component", list(device.ComputedForce))
colors.VectorMode = "Component"
colors.VectorComponent = 0
live.check(felt() > 0.5, "nor does another component's", list(device.ComputedForce))
colors.VectorComponent = 1
live.check(felt() == 0.0, "its own hides it", list(device.ComputedForce))
