// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/GuideSurface.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * If a position is nearer to the mesh than this fraction of the rounding, the direction from the
 * mesh to it is not defined.
 */
constexpr double LeastAway = 1e-9;
/** Distance (voxels) from the field's border within which the hold fades. */
constexpr double FieldFade = 2.0;

} // namespace

GuideSurface::GuideSurface(std::shared_ptr<const GuideMesh> mesh, double distance)
  : Mesh(std::move(mesh))
  , Distance(distance)
{
}

GuideSurface::GuideSurface(const VolumeView& view, std::shared_ptr<const void> samples,
  const Affine3& indexToWorld, double distance)
  : Samples(std::move(samples))
  , Kernel(GradientEstimator::CubicBSpline, 1)
  , Field(view, this->Kernel)
  , WorldToIndex(Inverse(indexToWorld))
  , Distance(distance)
{
}

bool GuideSurface::IsSame(const GuideSurface& other) const noexcept
{
  return this->Mesh == other.Mesh && this->Field.GetView().Data == other.Field.GetView().Data &&
    IsIdentical(this->WorldToIndex, other.WorldToIndex) && this->Distance == other.Distance;
}

std::size_t GuideSurface::GetMemorySize() const noexcept
{
  return sizeof(*this) + this->Kernel.Table.capacity() * sizeof(double) +
    (this->Mesh ? this->Mesh->GetMemorySize() : 0);
}

GuideSurfacePlace GuideSurface::Find(const Vector3& position) const noexcept
{
  if (!IsFinite(position))
  {
    return {};
  }
  return this->Mesh ? this->FindOnMesh(position) : this->FindInField(position);
}

GuideSurfacePlace GuideSurface::FindOnMesh(const Vector3& position) const noexcept
{
  const GuideMeshPlace found = this->Mesh->Find(position);
  if (!found.IsThere)
  {
    return {};
  }
  GuideSurfacePlace place{ found.Nearest, found.Normal, 0.0, 1.0 };
  const Vector3 away = position - found.Nearest;
  const double length = Norm(away);
  if (this->Distance != 0.0)
  {
    const double side = std::copysign(1.0, Dot(away, found.Normal));
    if (length > LeastAway * this->Mesh->GetRounding())
    {
      place.Normal = (side / length) * away;
    }
    place.Anchor += this->Distance * place.Normal;
    place.Distance = std::abs(side * length - this->Distance);
  }
  else
  {
    place.Distance = length;
  }
  return place;
}

GuideSurfacePlace GuideSurface::FindInField(const Vector3& position) const noexcept
{
  const Vector3 index = this->WorldToIndex(position);
  const double fade = std::clamp(this->Field.DistanceToBorder(index) / FieldFade, 0.0, 1.0);
  if (!(fade > 0.0))
  {
    return {};
  }
  const FieldSample sample = this->Field.Gradient(index);
  const Vector3 gradient = Transpose(this->WorldToIndex.Linear) * sample.Gradient;
  const double slope = Norm(gradient);
  const double fraction = std::clamp(4.0 * slope - 1.0, 0.0, 1.0);
  // The comparison is false for NaN, too.
  if (!(fraction > 0.0 && std::isfinite(slope) && std::isfinite(sample.Value)))
  {
    return {};
  }
  GuideSurfacePlace place;
  place.Normal = (1.0 / slope) * gradient;
  const double way = (this->Distance - sample.Value) / slope;
  place.Anchor = position + way * place.Normal;
  place.Distance = std::abs(way);
  place.Fraction = fade * fraction;
  return place;
}

} // namespace VolumeHaptics
