// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeOrientation.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/NrrdHeader.h"
#include "VTK/Regions/Formats/HeaderText.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace
{
/// Mirrors x and y of the world, to convert right-anterior-superior to left-posterior-superior or
/// back.
void TurnAboutZ(double axes[9], double origin[3])
{
  for (int axis = 0; axis < 2; ++axis)
  {
    origin[axis] = -origin[axis];
    for (int c = 0; c < 3; ++c)
    {
      axes[3 * axis + c] = -axes[3 * axis + c];
    }
  }
}

/// Finds the index axis that is closest to each world axis, using each index axis once.
std::array<int, 3> BestPermutation(const double axes[9])
{
  std::array<int, 3> order{ 0, 1, 2 }, best = order;
  double bestSum = -1.0;
  do
  {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += std::abs(axes[3 * axis + order[axis]]);
    }
    // With this margin, the natural order, which is tried first, wins ties.
    if (sum > bestSum + 1e-9)
    {
      bestSum = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}
} // namespace

namespace Explore
{
WorldAxes FindNrrdAxes(const VolumeHaptics::NrrdHeader& header)
{
  return VolumeHaptics::FindNrrdSpace(header).IsPatient ? WorldAxes::Patient
    : header.GetField("space").empty()                  ? WorldAxes::Unknown
                                                        : WorldAxes::Other;
}

WorldAxes FindFormatAxes(const std::string& format)
{
  return format == "FreeSurfer" || format == "MINC" ? WorldAxes::Patient : WorldAxes::Unknown;
}

WorldAxes ReadMetaImageAxes(const std::string& path)
{
  const std::string letters = VolumeHaptics::HeaderText(path).Value({ "AnatomicalOrientation" });
  // Valid letters are one from each of these pairs. MetaIO writes ??? for unknown axes.
  const bool isPatient = letters.size() == 3 && letters.find_first_of("RL") != std::string::npos &&
    letters.find_first_of("AP") != std::string::npos &&
    letters.find_first_of("SI") != std::string::npos;
  return isPatient ? WorldAxes::Patient : WorldAxes::Unknown;
}

void SetFrame(vtkImageData* image, const double axes[9], const double origin[3])
{
  double unit[9];
  for (int c = 0; c < 3; ++c)
  {
    double column[3] = { axes[c], axes[3 + c], axes[6 + c] };
    vtkMath::Normalize(column);
    for (int row = 0; row < 3; ++row)
    {
      unit[3 * row + c] = column[row];
    }
  }
  if (std::abs(vtkMatrix3x3::Determinant(unit)) < 1e-6)
  {
    return; // the header is wrong, so keep the identity
  }
  image->SetDirectionMatrix(unit);
  image->SetOrigin(origin);
}

void ApplyMetaImageOrientation(const std::string& path, vtkImageData* image)
{
  const VolumeHaptics::HeaderText header(path);
  std::vector<double> matrix = header.Numbers({ "TransformMatrix", "Orientation", "Rotation" });
  if (matrix.size() != 9)
  {
    return;
  }
  const double axes[9] = { matrix[0], matrix[3], matrix[6], matrix[1], matrix[4], matrix[7],
    matrix[2], matrix[5], matrix[8] };
  SetFrame(image, axes, image->GetOrigin());
}

std::string DescribeNrrdTurn(const VolumeHaptics::NrrdHeader& header)
{
  const VolumeHaptics::NrrdVector signs = VolumeHaptics::FindNrrdSpace(header).Signs;
  return !VolumeHaptics::FindNrrdSteps(header) ? std::string()
    : signs[1] < 0.0
    ? "orientation turned from " + header.GetField("space") + " to left-posterior-superior"
    : signs[2] < 0.0
    ? "the file's space is left-handed: its z is flipped, so that nothing is mirrored"
    : std::string();
}

void ApplyNiftiOrientation(vtkMatrix4x4* form, vtkImageData* image)
{
  double axes[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  double origin[3] = { 0, 0, 0 };
  if (form)
  {
    for (int row = 0; row < 3; ++row)
    {
      origin[row] = form->GetElement(row, 3);
      for (int c = 0; c < 3; ++c)
      {
        axes[3 * row + c] = form->GetElement(row, c);
      }
    }
  }
  TurnAboutZ(axes, origin);
  SetFrame(image, axes, origin);
}

void ScaleLengths(vtkImageData* image, double factor)
{
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  image->SetSpacing(factor * spacing[0], factor * spacing[1], factor * spacing[2]);
  image->SetOrigin(factor * origin[0], factor * origin[1], factor * origin[2]);
}

vtkSmartPointer<vtkImageData> AlignToAxes(vtkImageData* image)
{
  double axes[9];
  const double* stored = image->GetDirectionMatrix()->GetData();
  double spacing[3];
  for (int c = 0; c < 3; ++c)
  {
    spacing[c] = std::abs(image->GetSpacing()[c]);
    for (int row = 0; row < 3; ++row)
    {
      axes[3 * row + c] = image->GetSpacing()[c] < 0.0 ? -stored[3 * row + c] : stored[3 * row + c];
    }
  }
  const std::array<int, 3> from = BestPermutation(axes);
  int first[3], step[3], size[3];
  const int* extent = image->GetExtent();
  bool asIs = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int source = from[axis];
    const bool backward = axes[3 * axis + source] < 0.0;
    first[source] = backward ? extent[2 * source + 1] : extent[2 * source];
    step[source] = backward ? -1 : 1;
    size[axis] = extent[2 * source + 1] - extent[2 * source] + 1;
    asIs = asIs && source == axis && !backward && image->GetSpacing()[axis] > 0.0;
  }
  if (asIs)
  {
    return image;
  }

  vtkNew<vtkImageData> aligned;
  aligned->SetDimensions(size);
  aligned->SetSpacing(spacing[from[0]], spacing[from[1]], spacing[from[2]]);
  double direction[9], origin[3];
  for (int c = 0; c < 3; ++c)
  {
    for (int row = 0; row < 3; ++row)
    {
      direction[3 * row + c] = step[from[c]] * axes[3 * row + from[c]];
    }
  }
  image->TransformIndexToPhysicalPoint(first, origin);
  aligned->SetDirectionMatrix(direction);
  aligned->SetOrigin(origin);

  vtkDataArray* source = image->GetPointData()->GetScalars();
  auto target = VolumeHaptics::NewArray(
    source->GetDataType(), source->GetNumberOfComponents(), source->GetNumberOfTuples());
  target->SetName(source->GetName());
  vtkIdType out = 0;
  int index[3];
  for (int k = 0; k < size[2]; ++k)
  {
    index[from[2]] = first[from[2]] + k * step[from[2]];
    for (int j = 0; j < size[1]; ++j)
    {
      index[from[1]] = first[from[1]] + j * step[from[1]];
      for (int i = 0; i < size[0]; ++i)
      {
        index[from[0]] = first[from[0]] + i * step[from[0]];
        target->SetTuple(out++, image->ComputePointId(index), source);
      }
    }
  }
  aligned->GetPointData()->SetScalars(target);
  return aligned;
}
} // namespace Explore
