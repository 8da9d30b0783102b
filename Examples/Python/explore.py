# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Touches a CT with the mouse: explore.py VOLUME (.vti, .mha, .mhd, .nii, .nii.gz). Press t with the pointer on it, and
m for the next method."""
import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingContextOpenGL2
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import (
    vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper
from volumehaptics import (
    vtkHapticDevice, vtkHapticHeadUpDisplay, vtkHapticRepresentation, vtkInteractorStyleHaptic,
    vtkVolumeHapticsFilter)

READERS = {"vti": vtkXMLImageDataReader, "mha": vtkMetaImageReader, "mhd": vtkMetaImageReader,
           "nii": vtkNIFTIImageReader}


def main(path):
    reader = READERS[path.removesuffix(".gz").rsplit(".", 1)[-1]]()
    reader.SetFileName(path)
    volume, mapper = vtkVolume(), vtkSmartVolumeMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    volume.SetMapper(mapper)
    look = volume.GetProperty()
    look.ShadeOn()
    look.GetScalarOpacity().AddSegment(-500, 0.0, 1000, 0.6)
    look.GetRGBTransferFunction().AddRGBSegment(-500, 0.9, 0.6, 0.5, 1000, 1.0, 1.0, 0.9)

    touch, device = vtkVolumeHapticsFilter(), vtkHapticDevice()
    touch.SetInputConnection(reader.GetOutputPort())
    touch.GetProperty().ApplyPreset("CT contrast")
    touch.GetProperty().SetVisibilityFrom(look)  # hidden tissue can't be felt
    touch.SetIsoValue(-300)  # the skin, for the methods that feel an isosurface
    touch.SetForceFieldGain(1 / 450)  # 1 N at 450 HU/mm, the gradient at the skin
    device.SetVolumeHaptics(touch)
    device.Open("virtual")
    device.Start()

    hand, display, style = vtkHapticRepresentation(), vtkHapticHeadUpDisplay(), vtkInteractorStyleHaptic()
    for part in (hand, display, style):
        part.SetDevice(device)
    style.SetHeadUpDisplay(display)
    renderer, window, interactor = vtkRenderer(), vtkRenderWindow(), vtkRenderWindowInteractor()
    for prop in (volume, hand, display):
        renderer.AddViewProp(prop)
    window.AddRenderer(renderer)
    window.SetSize(900, 700)
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(style)
    window.Render()
    interactor.Start()


main(sys.argv[1])
