// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticCut.h"

#include "Core/Model/CutAway.h"
#include "VTK/Baking/HapticTuples.h"

#include "vtkImageData.h"
#include "vtkPlane.h"

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
      // False for NaN, too.
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
      // As the mappers do, along the axes of the data.
      const double first = extent[2 * axis];
      const auto toIndex = [&](double x)
      { return (x - image->GetOrigin()[axis]) / image->GetSpacing()[axis] - first; };
      const auto ends = std::minmax({ toIndex(low), toIndex(high) });
      regions.Low[axis] = ends.first;
      regions.High[axis] = ends.second;
    }
  }
  if (planes.empty() && regions.Kept == CutRegions::All)
  {
    return nullptr;
  }
  return std::make_shared<const CutAway>(
    std::move(planes), regions, indexToWorld, this->HasSolidFaces);
}

} // namespace VolumeHaptics
