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
/// Makes an image with slices at even distances from one with slices at any distances; `along` has
/// the position (mm, rising) of each slice. The new distance is the smallest one, and samples
/// between two slices are linear in their positions. Needs at least two slices.
vtkSmartPointer<vtkImageData> SpaceSlicesEvenly(
  vtkImageData* image, const std::vector<double>& along);

/// Returns the angle (degrees) by which the third axis of an image is off the normal of its slices,
/// or the first two axes off a right angle, whichever is larger.
double MeasureShear(vtkImageData* image);

/// Straightens an image where its axes are sheared. Returns a note for the user; empty if it did
/// nothing. Throws InputError if the axes are nearly in one plane.
std::string StraightenIfSheared(vtkSmartPointer<vtkImageData>& image, bool areLabels);

/// Resamples an image whose direction matrix is no rotation, such as a CT with a tilted gantry, to
/// straight axes. The first axis and the plane of the slices stay. The new box contains the old
/// one; samples outside of the slices have the least value. Samples are interpolated cubically, or
/// taken from the nearest voxel if they are labels. Returns null if the box would have more than
/// eight times the voxels.
vtkSmartPointer<vtkImageData> StraightenAxes(vtkImageData* image, bool areLabels);
} // namespace Explore

#endif
