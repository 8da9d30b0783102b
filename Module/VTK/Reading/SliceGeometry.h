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
/// Makes an image with evenly spaced slices from an image with slices at any positions. `along` has
/// the position (mm) of each slice, in rising order. The new distance is the smallest one, and
/// samples between two slices are interpolated linearly. Needs at least two slices.
vtkSmartPointer<vtkImageData> SpaceSlicesEvenly(
  vtkImageData* image, const std::vector<double>& along);

/// Returns the shear of an image (degrees): the angle between its third axis and the normal of its
/// slices, or the deviation of its first two axes from a right angle, whichever is larger.
double MeasureShear(vtkImageData* image);

/// Straightens an image if its axes are sheared. Returns a note for the user; empty if it did
/// nothing. Throws InputError if the axes are nearly in one plane.
std::string StraightenIfSheared(vtkSmartPointer<vtkImageData>& image, bool areLabels);

/// Resamples an image whose direction matrix is not a rotation, such as a CT with a tilted gantry,
/// to straight axes. The first axis and the plane of the slices are kept. The new box contains the
/// old one; samples outside the slices get the least value. Samples are interpolated cubically, or
/// taken from the nearest voxel if they are labels. Returns null if the box would have more than
/// eight times the voxels.
vtkSmartPointer<vtkImageData> StraightenAxes(vtkImageData* image, bool areLabels);
} // namespace Explore

#endif
