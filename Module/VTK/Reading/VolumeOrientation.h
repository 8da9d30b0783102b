// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeOrientation_h
#define Explore_VolumeOrientation_h

#include "VTK/Base/NrrdHeader.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Meaning of the world axes according to a file.
enum class WorldAxes
{
  Unknown, // the file does not define them
  Patient, // a patient's left, posterior and superior, after conversion
  Other
};

/// Return the axes that a NRRD header's `space` or a MetaImage's `AnatomicalOrientation` names.
WorldAxes FindNrrdAxes(const VolumeHaptics::NrrdHeader& header);
WorldAxes ReadMetaImageAxes(const std::string& path);

/// Returns the axes that all files of a format share; Unknown if they depend on the file.
WorldAxes FindFormatAxes(const std::string& format);

/// Sets the axes of an image. Column c of `axes` (row-major 3x3, columns of any length) is the
/// direction of index axis c; `origin` is the position of voxel (0, 0, 0). Keeps the spacing.
void SetFrame(vtkImageData* image, const double axes[9], const double origin[3]);

/// Applies the TransformMatrix in the header, which VTK 9.1's MetaImage reader ignores. In ITK's
/// convention, row c of the matrix is the direction of index axis c, in left-posterior-superior.
void ApplyMetaImageOrientation(const std::string& path, vtkImageData* image);

/// Returns a note if a NRRD header's space is converted to left-posterior-superior; empty
/// otherwise.
std::string DescribeNrrdTurn(const VolumeHaptics::NrrdHeader& header);

/// Places a NIfTI image with its sform or qform matrix (millimetres to right-anterior-superior), if
/// it has one, and converts the result to left-posterior-superior.
void ApplyNiftiOrientation(vtkMatrix4x4* form, vtkImageData* image);

/// Scales the spacing and origin of an image.
void ScaleLengths(vtkImageData* image, double factor);

/// Permutes and flips the voxels' index axes, without interpolation or moving voxels, so that index
/// axis c is as close as possible to world axis c. Returns the input if nothing has to change.
vtkSmartPointer<vtkImageData> AlignToAxes(vtkImageData* image);
} // namespace Explore

#endif
