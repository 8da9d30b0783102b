# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import numpy
from mayavi import mlab
from tvtk.util.ctf import ColorTransferFunction, PiecewiseFunction

figure = mlab.figure("host", size=(600, 600))
values = numpy.asarray(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]).T
field = mlab.pipeline.scalar_field(values)
field.origin, field.spacing = image.GetOrigin(), image.GetSpacing()
volume = mlab.pipeline.volume(field)
function = PiecewiseFunction()
for value, part in opacity:
    function.add_point(value, part)
volume._volume_property.set_scalar_opacity(function)
color = ColorTransferFunction()
for value, rgb in colors:
    color.add_rgb_point(value, *rgb)
volume._volume_property.set_color(color)
volume._ctf = color
figure.scene.interactor.add_observer("KeyPressEvent", lambda caller, _: hear(caller.GetKeySym()), -1.0)
lets_go = "End"
# code of Documentation/hosts.md
