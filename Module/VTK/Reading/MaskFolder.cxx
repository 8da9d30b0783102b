// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/MaskFolder.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace
{
using Explore::InputError;
using Explore::Volume;
using Files = vtksys::SystemTools;

/// Returns a file's name without folder and extensions, such as "liver" for liver.nii.gz.
std::string NameOrgan(const std::string& path)
{
  const std::string name = Files::GetFilenameName(path);
  return name.substr(0, name.find('.'));
}

/// Returns whether an image contains only 0 and at most one other value.
bool IsMask(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  double other = 0.0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (value != 0.0 && value != other)
    {
      if (other != 0.0)
      {
        return false;
      }
      other = value;
    }
  }
  return values && values->GetNumberOfComponents() == 1;
}

/// Returns whether two images have the same voxel grid, apart from rounding in their headers.
bool HaveSameVoxels(vtkImageData* a, vtkImageData* b)
{
  constexpr double rounding = 1e-3; // voxels
  bool isSame = std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent());
  for (int corner = 0; corner < 8 && isSame; ++corner)
  {
    int index[3];
    double there[2][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = a->GetExtent()[2 * axis + (corner >> axis & 1)];
    }
    a->TransformIndexToPhysicalPoint(index, there[0]);
    b->TransformIndexToPhysicalPoint(index, there[1]);
    for (int axis = 0; axis < 3; ++axis)
    {
      isSame =
        isSame && std::abs(there[0][axis] - there[1][axis]) <= rounding * a->GetSpacing()[axis];
    }
  }
  return isSame;
}
} // namespace

namespace Explore
{
std::vector<std::string> ListMasks(const std::string& folder)
{
  const std::vector<std::string> files = ListVolumeFiles(folder);
  std::set<std::string> names; // names with the digits removed
  for (const std::string& file : files)
  {
    std::string name = NameOrgan(file);
    name.erase(std::remove_if(name.begin(), name.end(),
                 [](unsigned char letter) { return std::isdigit(letter) != 0; }),
      name.end());
    names.insert(name);
  }
  return names.size() > 1 && IsMask(ReadVolume(files.front()).Image) ? files
                                                                     : std::vector<std::string>();
}

Volume ReadMasks(const std::string& folder, const std::vector<std::string>& masks, int series)
{
  const auto count = static_cast<int>(masks.size());
  if (series > count)
  {
    throw InputError(folder,
      "has " + std::to_string(count) + " masks, and none with the number " + std::to_string(series),
      "use Series = 1 to Series = " + std::to_string(count));
  }
  Volume all;
  vtkIdType shared = 0;
  unsigned short* labels = nullptr;
  for (int number = 1; number <= count; ++number)
  {
    const std::string& path = masks[static_cast<std::size_t>(number - 1)];
    const Volume mask = ReadVolume(path);
    if (!IsMask(mask.Image))
    {
      throw InputError(path, "is not a mask, unlike the others in its folder",
        "put it into another folder, or open it alone");
    }
    if (!all.Image)
    {
      all = mask;
      all.Image = vtkSmartPointer<vtkImageData>::New();
      all.Image->CopyStructure(mask.Image);
      VolumeHaptics::AllocateScalars(all.Image, VTK_UNSIGNED_SHORT, 1);
      all.Image->GetPointData()->GetScalars()->SetName("Labels");
      all.Image->GetPointData()->GetScalars()->Fill(0.0);
      all.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
      labels = static_cast<unsigned short*>(all.Image->GetScalarPointer());
    }
    else if (!HaveSameVoxels(mask.Image, all.Image))
    {
      throw InputError(path, "has a different grid from the mask " + masks.front() + " beside it",
        "write all masks on the voxels of their scan, or choose one of them");
    }
    all.LabelTable->SetLabelName(number, NameOrgan(path));
    vtkDataArray* const values = mask.Image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples() && (series == 0 || series == number); ++i)
    {
      if (values->GetComponent(i, 0) != 0.0)
      {
        shared += labels[i] > 0;
        labels[i] = static_cast<unsigned short>(number);
      }
    }
  }
  all.Notes.push_back(std::to_string(count) + " masks are used as labels, named like their files");
  if (shared > 0)
  {
    all.Notes.push_back(
      std::to_string(shared) + " voxels are in several masks: they belong to the last of these");
  }
  ListSegments(all, series);
  return all;
}
} // namespace Explore
