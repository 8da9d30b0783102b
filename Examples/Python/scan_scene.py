# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that the demonstrations on scans share: files, images and surfaces."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

from force_scene import make_actor


def read_scan(file):
    """Returns a NIfTI file's samples [z, y, x], their spacing (mm), and the matrix to the patient's axes or None."""
    reader = vtkNIFTIImageReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    samples = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    return (samples + np.int16(reader.GetRescaleIntercept()), np.array(image.GetSpacing()),
            reader.GetSFormMatrix() or reader.GetQFormMatrix())


def make_image(samples, spacing):
    image = vtkImageData()
    image.SetDimensions(samples.shape[::-1])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(samples).ravel(), deep=True))
    return image


def make_surface(inside, spacing, colour, opacity=1.0, deviation=1.5):
    """Returns an actor of the smooth surface of a mask, blurred by a Gaussian with a standard deviation (voxels)."""
    soft, edges, smooth = vtkImageGaussianSmooth(), vtkFlyingEdges3D(), vtkWindowedSincPolyDataFilter()
    soft.SetInputData(make_image(inside.astype(np.float32), spacing))
    soft.SetStandardDeviation(deviation)
    edges.SetInputConnection(soft.GetOutputPort())
    edges.SetValue(0, 0.5)
    smooth.SetInputConnection(edges.GetOutputPort())
    smooth.SetNumberOfIterations(30)
    smooth.SetPassBand(0.03)
    actor = make_actor(smooth, opacity=opacity)
    actor.GetProperty().SetColor(colour)
    return actor
