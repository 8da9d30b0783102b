// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SliceGeometry_h
#define Explore_SliceGeometry_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Resamples an image, whose slices may be at any positions, to evenly spaced slices. `along` has
/// the ascending positions (mm) of at least two slices. The new spacing is the smallest old one.
/// Samples between two slices are interpolated linearly.
vtkSmartPointer<vtkImageData> SpaceSlicesEvenly(
  vtkImageData* image, const std::vector<double>& along);

/// Returns the shear of an image in degrees: the angle between its third axis and the normal of its
/// slices, or the deviation of its first two axes from a right angle, whichever is larger.
double MeasureShear(vtkImageData* image);

/// Straightens an image with sheared axes. Returns a note for the user; empty if the axes are not
/// sheared. Throws InputError if the axes are nearly in one plane.
std::string StraightenIfSheared(vtkSmartPointer<vtkImageData>& image, bool areLabels);

/// Resamples an image whose direction matrix is not a rotation, such as a CT with a tilted gantry,
/// to perpendicular axes. Keeps the first axis and the plane of the slices. The new box contains
/// the old one; samples outside the slices get the smallest value. Interpolates cubically; labels
/// are taken from the nearest voxel. Returns null if the box would have more than eight times as
/// many voxels.
vtkSmartPointer<vtkImageData> StraightenAxes(vtkImageData* image, bool areLabels);
} // namespace Explore

#endif
