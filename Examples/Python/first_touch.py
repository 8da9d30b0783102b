# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's first example: press a stylus against the forehead of the phantom."""
import sys

from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from volumehaptics import vtkVolumeHapticsFilter

head, path, touch = vtkXMLImageDataReader(), vtkLineSource(), vtkVolumeHapticsFilter()
head.SetFileName(sys.argv[1])  # Data/HeadPhantom.vti
path.SetPoint1(0, -120, 60)  # one point for each tick: 80 mm in a second
path.SetPoint2(0, -40, 60)
path.SetResolution(1000)
touch.SetInputConnection(head.GetOutputPort())
touch.SetPathConnection(path.GetOutputPort())
touch.GetProperty().ApplyPreset("CT contrast")
touch.Update()
print(touch.GetOutput().GetPointData().GetArray("Force").GetMaxNorm(), "N")
