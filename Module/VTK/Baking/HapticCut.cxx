// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticCut.h"

#include "Core/Model/CutAway.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticTuples.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

bool ReadPlanes(vtkPlaneCollection* planes, std::vector<CutPlane>& cuts, std::string& error)
{
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* const plane = planes->GetItem(i);
    const Vector3 normal = FromArray(plane->GetNormal());
    const Vector3 origin = FromArray(plane->GetOrigin());
    const double length = Norm(normal);
    const double offset = Dot(normal, origin) / length;
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(offset))
    {
      std::ostringstream message;
      message << "Clipping plane " << i << " of vtkVolumeHapticsFilter has the normal (" << normal.X
              << ", " << normal.Y << ", " << normal.Z << ") and the origin (" << origin.X << ", "
              << origin.Y << ", " << origin.Z
              << "): a normal must not be zero, and all numbers have to be finite. Correct them "
                 "with vtkPlane::SetNormal() and SetOrigin(), or call "
                 "RemoveClippingPlane().";
      error = message.str();
      return false;
    }
    cuts.push_back({ (1.0 / length) * normal, offset });
  }
  return true;
}

bool HasFlag(vtkUnsignedCharArray* flags, int flag, vtkIdType count)
{
  const unsigned char* const first =
    flags && flags->GetNumberOfTuples() == count ? flags->GetPointer(0) : nullptr;
  return first &&
    std::any_of(first, first + count, [flag](unsigned char one) { return (one & flag) != 0; });
}

/** Marks each point as hidden unless at least one of the cells around it is visible. */
void HideByCells(vtkImageData* image, vtkUnsignedCharArray* cells, vtkUnsignedCharArray* points)
{
  int size[3];
  image->GetDimensions(size);
  const unsigned char* const hidden = cells->GetPointer(0);
  unsigned char* point = points->GetPointer(0);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++point)
      {
        bool isShown = false;
        for (int corner = 0; corner < 8 && !isShown; ++corner)
        {
          const vtkIdType at[3] = { i - (corner & 1), j - (corner >> 1 & 1), k - (corner >> 2) };
          const bool isCell = at[0] >= 0 && at[0] < size[0] - 1 && at[1] >= 0 &&
            at[1] < size[1] - 1 && at[2] >= 0 && at[2] < size[2] - 1;
          isShown = isCell &&
            (hidden[at[0] + (size[0] - 1) * (at[1] + (size[1] - 1) * at[2])] &
              vtkDataSetAttributes::HIDDENCELL) == 0;
        }
        *point |= isShown ? 0 : static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
      }
    }
  }
}

/** Lists the points to hide: blanked points, and points whose cells are all blanked. */
HiddenVoxels CollectBlanked(vtkImageData* image, const int extent[6])
{
  HiddenVoxels hidden;
  vtkSmartPointer<vtkUnsignedCharArray> points = image->GetPointGhostArray();
  vtkUnsignedCharArray* const cells = image->GetCellGhostArray();
  const bool hasPoints =
    HasFlag(points, vtkDataSetAttributes::HIDDENPOINT, image->GetNumberOfPoints());
  const bool hasCells = HasFlag(cells, vtkDataSetAttributes::HIDDENCELL, image->GetNumberOfCells());
  if (!hasPoints && !hasCells)
  {
    return hidden;
  }
  hidden.Version = std::max(points ? points->GetMTime() : 0, cells ? cells->GetMTime() : 0);
  if (hasCells)
  {
    vtkNew<vtkUnsignedCharArray> both;
    AllocateTuples(both, image->GetNumberOfPoints());
    hasPoints ? both->DeepCopy(points) : both->FillValue(0);
    HideByCells(image, cells, both);
    points = both;
  }
  vtkUnsignedCharArray* const array = points;
  array->Register(nullptr);
  hidden.Holder = { static_cast<const void*>(array),
    [array](const void*) { array->UnRegister(nullptr); } };
  hidden.Flags = array->GetPointer(0);
  hidden.Hidden = vtkDataSetAttributes::HIDDENPOINT;
  for (int axis = 0; axis < 3; ++axis)
  {
    hidden.First[axis] = image->GetExtent()[2 * axis] - extent[2 * axis];
    hidden.Dimensions[axis] = image->GetDimensions()[axis];
  }
  return hidden;
}

} // namespace

void HapticCut::Print(ostream& os, vtkIndent indent) const
{
  const int count = this->Planes ? this->Planes->GetNumberOfItems() : 0;
  os << indent << "ClippingPlanes: " << (count > 0 ? "\n" : "(none)\n");
  for (int i = 0; i < count; ++i)
  {
    const double* const n = this->Planes->GetItem(i)->GetNormal();
    const double* const x = this->Planes->GetItem(i)->GetOrigin();
    os << indent.GetNextIndent() << "normal (" << n[0] << ", " << n[1] << ", " << n[2]
       << "), origin (" << x[0] << ", " << x[1] << ", " << x[2] << ")\n";
  }
  const double* const r = this->RegionPlanes;
  os << indent << "Cropping: " << (this->Cropping ? "on" : "off") << "\n";
  os << indent << "CroppingRegionPlanes: (" << r[0] << ", " << r[1] << ", " << r[2] << ", " << r[3]
     << ", " << r[4] << ", " << r[5] << ")\n";
  os << indent << "CroppingRegionFlags: " << this->RegionFlags << "\n";
  os << indent << "FeelCutFaces: " << (this->HasSolidFaces ? "on" : "off") << "\n";
}

vtkMTimeType HapticCut::GetMTime() const
{
  vtkMTimeType time = this->Planes ? this->Planes->GetMTime() : 0;
  for (int i = 0; this->Planes && i < this->Planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, this->Planes->GetItem(i)->GetMTime());
  }
  return time;
}

std::shared_ptr<const CutAway> HapticCut::Make(
  vtkImageData* image, const int extent[6], const Affine3& indexToWorld, std::string& error) const
{
  std::vector<CutPlane> planes;
  if (!ReadPlanes(this->Planes, planes, error))
  {
    return nullptr;
  }
  CutRegions regions;
  regions.Kept = this->Cropping ? static_cast<std::uint32_t>(this->RegionFlags) & CutRegions::All
                                : CutRegions::All;
  if (regions.Kept != CutRegions::All)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->RegionPlanes[2 * axis];
      const double high = this->RegionPlanes[2 * axis + 1];
      // The negated comparison also refuses NaN.
      if (!(low <= high))
      {
        std::ostringstream message;
        message << "The cropping region planes of vtkVolumeHapticsFilter along axis " << axis
                << " are " << low << " and " << high
                << ": the first must not be above the second. Correct them with "
                   "SetCroppingRegionPlanes(), or call CroppingOff().";
        error = message.str();
        return nullptr;
      }
      // Crop along the axes of the image, even if the image is rotated, as VTK's volume mappers do.
      const double first = extent[2 * axis];
      const auto toIndex = [&](double x)
      { return (x - image->GetOrigin()[axis]) / image->GetSpacing()[axis] - first; };
      const auto ends = std::minmax({ toIndex(low), toIndex(high) });
      regions.Low[axis] = ends.first;
      regions.High[axis] = ends.second;
    }
  }
  HiddenVoxels hidden = CollectBlanked(image, extent);
  if (planes.empty() && regions.Kept == CutRegions::All && !hidden.Flags)
  {
    return nullptr;
  }
  return std::make_shared<const CutAway>(
    std::move(planes), regions, indexToWorld, this->HasSolidFaces, std::move(hidden));
}

} // namespace VolumeHaptics
