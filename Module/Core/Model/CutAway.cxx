// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/CutAway.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

// Steps between the numbers of neighbouring regions along each axis.
constexpr int Strides[3] = { 1, 3, 9 };

double ComponentOf(const Vector3& v, int axis) noexcept
{
  return axis == 0 ? v.X : (axis == 1 ? v.Y : v.Z);
}

} // namespace

double CutAway::Beyond::Distance() const noexcept
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double aside = std::max({ this->Low[axis], this->High[axis], 0.0 });
    square += aside * aside;
  }
  return std::sqrt(square);
}

Vector3 CutAway::Beyond::Direction(const Axis (&axes)[3]) const noexcept
{
  Vector3 direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double aside = std::max(this->High[axis], 0.0) - std::max(this->Low[axis], 0.0);
    direction += aside * axes[axis].Normal;
  }
  return direction;
}

CutAway::CutAway(std::vector<CutPlane> planes, const CutRegions& regions,
  const Affine3& indexToWorld, bool isSolid, HiddenVoxels hidden)
  : Planes(std::move(planes))
  , Regions(regions)
  , IndexToWorld(indexToWorld)
  , WorldToIndex(Inverse(indexToWorld.Linear))
  , HasSolidFaces(isSolid)
  , Hidden(std::move(hidden))
{
  for (const CutPlane& plane : this->Planes)
  {
    this->Voxels.push_back(1.0 / Norm(this->WorldToIndex * plane.Normal));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3& row = this->WorldToIndex.Row[axis];
    this->Axes[axis] = { (1.0 / Norm(row)) * row, 1.0 / Norm(row) };
  }
}

CutPlace CutAway::Compute(const Vector3& index) const noexcept
{
  CutPlace nearest =
    this->Regions.Kept == CutRegions::All ? CutPlace{} : this->ComputeRegion(index);
  const Vector3 world = this->IndexToWorld(index);
  for (std::size_t i = 0; i < this->Planes.size(); ++i)
  {
    const CutPlane& plane = this->Planes[i];
    const double depth = Dot(plane.Normal, world) - plane.Offset;
    if (depth < nearest.Depth)
    {
      nearest = { depth, plane.Normal, this->Voxels[i] };
    }
  }
  if (this->Hidden.Flags)
  {
    const CutPlace hidden = this->ComputeHidden(index);
    nearest = hidden.Depth < nearest.Depth ? hidden : nearest;
  }
  return nearest;
}

double HiddenVoxels::IsKept(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept
{
  const std::int64_t at[3] = { i, j, k };
  std::int64_t offset = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const std::int64_t last = this->Dimensions[axis] - 1;
    offset = offset * this->Dimensions[axis] +
      std::clamp<std::int64_t>(at[axis] - this->First[axis], 0, last);
  }
  return (this->Flags[offset] & this->Hidden) != 0 ? 0.0 : 1.0;
}

CutPlace CutAway::ComputeHidden(const Vector3& index) const noexcept
{
  const double low[3] = { std::floor(index.X), std::floor(index.Y), std::floor(index.Z) };
  const double u[3] = { index.X - low[0], index.Y - low[1], index.Z - low[2] };
  const std::int64_t at[3] = { static_cast<std::int64_t>(low[0]), static_cast<std::int64_t>(low[1]),
    static_cast<std::int64_t>(low[2]) };
  double kept = 0.0;
  double slope[3] = {};
  for (int corner = 0; corner < 8; ++corner)
  {
    const int c[3] = { corner & 1, corner >> 1 & 1, corner >> 2 & 1 };
    const double fraction = this->Hidden.IsKept(at[0] + c[0], at[1] + c[1], at[2] + c[2]);
    const double w[3] = { c[0] ? u[0] : 1.0 - u[0], c[1] ? u[1] : 1.0 - u[1],
      c[2] ? u[2] : 1.0 - u[2] };
    kept += fraction * (w[0] * w[1] * w[2]);
    slope[0] += (c[0] ? fraction : -fraction) * (w[1] * w[2]);
    slope[1] += (c[1] ? fraction : -fraction) * (w[0] * w[2]);
    slope[2] += (c[2] ? fraction : -fraction) * (w[0] * w[1]);
  }
  const Vector3 gradient = Transpose(this->WorldToIndex) * Vector3{ slope[0], slope[1], slope[2] };
  const double steepness = Norm(gradient);
  CutPlace place;
  constexpr double flat = 1e-6; // tolerance of t for 0 and 1
  if (!(steepness > 0.0) || kept < flat || kept > 1.0 - flat)
  {
    place.Depth = kept > 0.5 ? HUGE_VAL : -HUGE_VAL;
    return place;
  }
  place.Normal = (1.0 / steepness) * gradient;
  // At half a voxel behind the face, t is 1, and the full force acts.
  place.Voxel = 0.5 / Norm(this->WorldToIndex * place.Normal);
  place.Depth = (2.0 * kept - 1.0) * place.Voxel;
  return place;
}

CutAway::Beyond CutAway::ComputeBeyond(const Vector3& index, int region) const noexcept
{
  Beyond beyond;
  int rest = region;
  for (int axis = 0; axis < 3; ++axis, rest /= 3)
  {
    const double i = ComponentOf(index, axis);
    const double scale = this->Axes[axis].WorldPerIndex;
    const double planes[] = { -HUGE_VAL, this->Regions.Low[axis], this->Regions.High[axis],
      HUGE_VAL };
    const int step = rest % 3;
    beyond.Low[axis] = scale * (planes[step] - i);
    beyond.High[axis] = scale * (i - planes[step + 1]);
  }
  return beyond;
}

int CutAway::FindRegionOf(const Vector3& index) const noexcept
{
  int region = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double i = ComponentOf(index, axis);
    const int step = i < this->Regions.Low[axis] ? 0 : (i > this->Regions.High[axis] ? 2 : 1);
    region += Strides[axis] * step;
  }
  return region;
}

int CutAway::FindNearest(const Vector3& index, bool isKept, double& distance) const noexcept
{
  int nearest = -1;
  distance = HUGE_VAL;
  for (int region = 0; region < 27; ++region)
  {
    const double far =
      this->IsKept(region) == isKept ? this->ComputeBeyond(index, region).Distance() : HUGE_VAL;
    nearest = far < distance ? region : nearest;
    distance = std::min(far, distance);
  }
  return nearest;
}

bool CutAway::HasFace(int region, int face) const noexcept
{
  const int axis = face / 2;
  const bool isLow = face % 2 == 0;
  const int step = region / Strides[axis] % 3;
  return step != (isLow ? 0 : 2) &&
    this->IsKept(isLow ? region - Strides[axis] : region + Strides[axis]);
}

CutPlace CutAway::ComputeRegion(const Vector3& index) const noexcept
{
  const int here = this->FindRegionOf(index);
  const bool isKept = this->IsKept(here);
  double distance;
  const int there = this->FindNearest(index, !isKept, distance);
  CutPlace place;
  if (there < 0)
  {
    place.Depth = isKept ? HUGE_VAL : -HUGE_VAL;
    return place;
  }
  const int away = isKept ? there : here;
  const Beyond beyond = this->ComputeBeyond(index, away);
  double farthest = -HUGE_VAL;
  for (int face = 0; face < 6; ++face)
  {
    if (!this->HasFace(away, face))
    {
      continue;
    }
    const double aside = beyond.Behind(face);
    place.Faces |= this->IsAt(face, aside) ? 1U << face : 0U;
    place.Normal = aside > farthest ? this->GetNormal(face) : place.Normal;
    farthest = std::max(farthest, aside);
  }
  // Outside the faces, the normal is along the shortest path to the region. If this path ends on an
  // edge, the normal is oblique to the faces.
  if (distance > 0.0)
  {
    const Vector3 shortest = this->ComputeBeyond(index, there).Direction(this->Axes);
    place.Normal = ((isKept ? 1.0 : -1.0) / distance) * shortest;
  }
  place.Depth = isKept ? distance : -distance;
  place.Voxel = 1.0 / Norm(this->WorldToIndex * place.Normal);
  return place;
}

Vector3 CutAway::StopAtFaces(const Vector3& from, const Vector3& to) const noexcept
{
  if (!this->HasSolidFaces || this->Regions.Kept == CutRegions::All)
  {
    return to;
  }
  const int here = this->FindRegionOf(from);
  double distance = 0.0;
  const int away = this->IsKept(here) ? this->FindNearest(from, false, distance) : here;
  if (away < 0)
  {
    return to;
  }
  const Beyond beyond = this->ComputeBeyond(from, away);
  const Beyond after = this->ComputeBeyond(to, away);
  double stopped[3] = { to.X, to.Y, to.Z };
  for (int face = 0; face < 6; ++face)
  {
    const Axis& axis = this->Axes[face / 2];
    const double aside = beyond.Behind(face);
    if (aside > axis.WorldPerIndex)
    {
      return to; // `from` is in the kept part, not at a face
    }
    const double behind = after.Behind(face);
    if (this->HasFace(away, face) && !this->IsAt(face, aside) && behind > 0.0)
    {
      const double back = behind / axis.WorldPerIndex;
      stopped[face / 2] += face % 2 == 0 ? back : -back;
    }
  }
  return { stopped[0], stopped[1], stopped[2] };
}

} // namespace VolumeHaptics
