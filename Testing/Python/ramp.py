# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData


def make_ramp(size):
    """V = 100 z on size^3 voxels of 1 world unit."""
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.AllocateScalars(VTK_DOUBLE, 1)
    scalars = image.GetPointData().GetScalars()
    for i in range(image.GetNumberOfPoints()):
        scalars.SetTuple1(i, 100.0 * image.GetPoint(i)[2])
    return image
