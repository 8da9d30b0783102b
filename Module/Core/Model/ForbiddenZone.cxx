// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/ForbiddenZone.h"

#include "Core/Field/LabelSamples.h"
#include "Core/Model/LabelWalls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace VolumeHaptics
{
namespace
{

/** Kernel radius (voxels) of the walls that locate the boundary. */
constexpr int BoundaryRadius = 3;
/** s^2 / 2 in voxels squared, where s is the standard deviation of the walls' kernel. */
constexpr double HalfVariance = 0.5 * 0.355 * 0.355 * (BoundaryRadius + 1) * (BoundaryRadius + 1);
/** Number of voxels by which the box exceeds the stand-off. */
constexpr std::int64_t Margin = 6;
/**
 * Within this distance (voxels) from its nearest point, the boundary counts as its tangent plane.
 * Farther away, the distance is that to the point itself, as around an edge.
 */
constexpr double PlanePart = 0.75;
/** Smoothing has removed a forbidden voxel if its wall value is below this limit. */
constexpr double TakenAway = -0.38;

/** A box of voxels of the label image. `Is` is 1 for forbidden voxels. */
struct Mask
{
  std::int64_t First[3];
  std::int64_t Size[3];
  std::vector<std::uint8_t> Is;

  std::int64_t Index(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + this->Size[0] * (j + this->Size[1] * k);
  }
  VolumeView View() const
  {
    VolumeView view;
    view.Data = this->Is.data();
    view.Type = ScalarType::UInt8;
    std::copy(this->Size, this->Size + 3, view.Dimensions);
    view.Stride[0] = 1;
    view.Stride[1] = this->Size[0];
    view.Stride[2] = this->Size[0] * this->Size[1];
    return view;
  }
};

/** Thrown to cancel the work, and caught in this file. */
struct Ended
{
};

void Check(const ForbiddenZone::Progress& goesOn)
{
  if (goesOn && !goesOn())
  {
    throw Ended();
  }
}

/** Calls visit(i, j, k) for each forbidden voxel. */
template <typename Visit>
void VisitForbidden(const VolumeView& view, const LabelTable& table,
  const ForbiddenZone::Progress& goesOn, Visit&& visit)
{
  WithSampleType(view.Type,
    [&](auto sample)
    {
      using T = decltype(sample);
      T last{};
      bool isFirst = true;
      bool isForbidden = false;
      for (std::int64_t k = 0; k < view.Dimensions[2]; ++k)
      {
        Check(goesOn);
        for (std::int64_t j = 0; j < view.Dimensions[1]; ++j)
        {
          const T* const row =
            static_cast<const T*>(view.Data) + j * view.Stride[1] + k * view.Stride[2];
          for (std::int64_t i = 0; i < view.Dimensions[0]; ++i)
          {
            const T now = row[i * view.Stride[0]];
            if (isFirst || now != last)
            {
              const LabelMaterial* const material = table.Find(ToLabel(now));
              isForbidden = material && material->IsForbidden;
              last = now;
              isFirst = false;
            }
            if (isForbidden)
            {
              visit(i, j, k);
            }
          }
        }
      }
    });
}

/**
 * Makes the box that contains all forbidden voxels and everything within the stand-off. Returns
 * false if no voxel is forbidden.
 */
bool MakeMask(const VolumeView& view, const LabelTable& table, const Affine3& indexToWorld,
  double standOff, const ForbiddenZone::Progress& goesOn, Mask& mask)
{
  std::int64_t low[3];
  std::int64_t high[3];
  std::fill_n(low, 3, std::numeric_limits<std::int64_t>::max());
  std::fill_n(high, 3, -1);
  VisitForbidden(view, table, goesOn,
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const std::int64_t at[3] = { i, j, k };
      for (int a = 0; a < 3; ++a)
      {
        low[a] = std::min(low[a], at[a]);
        high[a] = std::max(high[a], at[a]);
      }
    });
  if (high[0] < 0)
  {
    return false;
  }
  // The rows of the inverse are index steps per world unit, even if the axes are not perpendicular.
  const Matrix3 steps = Inverse(indexToWorld.Linear);
  double voxels = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const double reach = std::ceil(standOff * Norm(steps.Row[a])) + Margin;
    const double size = static_cast<double>(high[a] - low[a] + 1) + 2.0 * reach;
    voxels *= size;
    if (!(voxels <= static_cast<double>(ForbiddenZone::MostVoxels)))
    {
      throw std::bad_alloc();
    }
    mask.First[a] = low[a] - static_cast<std::int64_t>(reach);
    mask.Size[a] = static_cast<std::int64_t>(size);
  }
  mask.Is.assign(static_cast<std::size_t>(mask.Size[0] * mask.Size[1] * mask.Size[2]), 0);
  VisitForbidden(view, table, goesOn,
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      mask.Is[static_cast<std::size_t>(
        mask.Index(i - mask.First[0], j - mask.First[1], k - mask.First[2]))] = 1;
    });
  return true;
}

/**
 * A point of the boundary (index steps of the box) and the outward normal (world). In a speck or a
 * thin vessel, smoothing would remove the voxel. Its point is then a ball with a diameter of one
 * voxel, and the normal is 0.
 */
struct BoundaryPoint
{
  Vector3 Position;
  Vector3 Normal;
};

/** Returns the outward direction (index steps) at a position, or zero if there is no wall. */
Vector3 OutwardAt(const LabelWalls& walls, const Vector3& at)
{
  const LabelWall wall = walls.Compute(at);
  const double norm = Norm(wall.Gradient);
  return wall.IsThere && norm > 0.0 ? (-1.0 / norm) * wall.Gradient : Vector3{};
}

/**
 * Returns the sum of the principal curvatures (1 / voxel) of the boundary, which has this normal.
 */
double ComputeCurvature(const LabelWalls& walls, const Vector3& at, const Vector3& normal)
{
  constexpr double h = 3.0;
  constexpr double most = 0.5;
  // Differentiate only along the boundary, because a thin part has a second boundary behind it.
  const Vector3 u = UnitAcross(normal);
  const Vector3 v = Cross(normal, u);
  double divergence = 0.0;
  for (const Vector3& tangent : { u, v })
  {
    const Vector3 step = h * tangent;
    divergence +=
      Dot(OutwardAt(walls, at + step) - OutwardAt(walls, at - step), tangent) / (2.0 * h);
  }
  return std::clamp(divergence, -most, most);
}

/** Moves from a voxel along the gradient to the boundary. Returns false if no boundary is near. */
bool FindBoundary(const LabelWalls& walls, const Vector3& voxel, const Matrix3& gradientToWorld,
  BoundaryPoint& point)
{
  constexpr int trials = 5;
  constexpr double farthest = 2.0; // voxels
  Vector3 at = voxel;
  for (int trial = 0; trial < trials; ++trial)
  {
    const LabelWall wall = walls.Compute(at);
    const double square = Dot(wall.Gradient, wall.Gradient);
    if (!wall.IsThere || !(square > 1e-6))
    {
      return false;
    }
    at += ClampNorm((-wall.Value / square) * wall.Gradient, 1.0);
  }
  const LabelWall wall = walls.Compute(at);
  if (!wall.IsThere || std::abs(wall.Value) > 0.05 || Norm(at - voxel) > farthest)
  {
    return false;
  }
  const Vector3 normal = gradientToWorld * wall.Gradient;
  point.Normal = (-1.0 / Norm(normal)) * normal;
  const Vector3 outward = OutwardAt(walls, at);
  point.Position = at + (HalfVariance * ComputeCurvature(walls, at, outward)) * outward;
  return true;
}

/**
 * Finds the boundary point nearest to each voxel in a box, by passing points from voxel to voxel.
 */
class NearestPoints
{
public:
  NearestPoints(const Mask& mask, const Matrix3& toWorld, const ForbiddenZone::Progress& goesOn)
    : Box(mask)
    , ToWorld(toWorld)
    , GoesOn(goesOn)
    , Nearest(mask.Is.size(), -1)
    , Square(mask.Is.size(), std::numeric_limits<float>::max())
  {
    const Matrix3 gradientToWorld = Transpose(Inverse(toWorld));
    const LabelView view(mask.View());
    const LabelTable table;
    const LabelWalls walls(view, table, BoundaryRadius);
    this->Visit(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        BoundaryPoint point;
        const Vector3 voxel{ double(i), double(j), double(k) };
        if (!this->IsAtBoundary(i, j, k))
        {
          return;
        }
        const bool isForbidden = mask.Is[static_cast<std::size_t>(mask.Index(i, j, k))] != 0;
        // Without a boundary nearby, the voxel belongs to a thin part that smoothing has removed.
        const bool isTaken = isForbidden && walls.Compute(voxel).Value < TakenAway;
        if (isTaken || !FindBoundary(walls, voxel, gradientToWorld, point))
        {
          if (!isForbidden)
          {
            return;
          }
          point = { voxel, {} };
        }
        this->Points.push_back(point);
        this->Offer(mask.Index(i, j, k), voxel, static_cast<std::int32_t>(this->Points.size() - 1));
      },
      false);
    for (int sweep = 0; sweep < 2; ++sweep)
    {
      this->Sweep(false);
      this->Sweep(true);
    }
  }

  bool IsEmpty() const { return this->Points.empty(); }

  /** Returns the distance (world units) of a voxel from the boundary; negative inside a label. */
  double DistanceAt(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const BoundaryPoint& point = this->Points[static_cast<std::size_t>(
      this->Nearest[static_cast<std::size_t>(this->Box.Index(i, j, k))])];
    const Vector3 way =
      this->ToWorld * (Vector3{ double(i), double(j), double(k) } - point.Position);
    if (Norm(point.Normal) == 0.0)
    {
      return Norm(way) - 0.5 * LargestColumn(this->ToWorld);
    }
    const double height = Dot(way, point.Normal);
    const double part = PlanePart * LargestColumn(this->ToWorld);
    const double beyond = std::max(0.0, Norm(way - height * point.Normal) - part);
    return std::copysign(std::sqrt(height * height + beyond * beyond), height);
  }

private:
  bool IsAtBoundary(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z)
    { return this->Box.Is[static_cast<std::size_t>(this->Box.Index(x, y, z))]; };
    const std::int64_t* const n = this->Box.Size;
    if (i < 1 || j < 1 || k < 1 || i + 1 >= n[0] || j + 1 >= n[1] || k + 1 >= n[2])
    {
      return false; // the outermost voxels are all in the margin
    }
    const std::uint8_t here = at(i, j, k);
    return at(i - 1, j, k) != here || at(i + 1, j, k) != here || at(i, j - 1, k) != here ||
      at(i, j + 1, k) != here || at(i, j, k - 1) != here || at(i, j, k + 1) != here;
  }

  void Offer(std::int64_t index, const Vector3& voxel, std::int32_t point)
  {
    const Vector3 way =
      this->ToWorld * (voxel - this->Points[static_cast<std::size_t>(point)].Position);
    const auto square = static_cast<float>(Dot(way, way));
    const auto at = static_cast<std::size_t>(index);
    if (square < this->Square[at])
    {
      this->Square[at] = square;
      this->Nearest[at] = point;
    }
  }

  template <typename F>
  void Visit(F&& visit, bool isBackward) const
  {
    const std::int64_t* const n = this->Box.Size;
    for (std::int64_t z = 0; z < n[2]; ++z)
    {
      Check(this->GoesOn);
      for (std::int64_t y = 0; y < n[1]; ++y)
      {
        for (std::int64_t x = 0; x < n[0]; ++x)
        {
          isBackward ? visit(n[0] - 1 - x, n[1] - 1 - y, n[2] - 1 - z) : visit(x, y, z);
        }
      }
    }
  }

  /** For each voxel, takes over the neighbours' nearest points that are nearer than its own. */
  void Sweep(bool isBackward)
  {
    const std::int64_t* const n = this->Box.Size;
    this->Visit(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const Vector3 voxel{ double(i), double(j), double(k) };
        const std::int64_t index = this->Box.Index(i, j, k);
        for (std::int64_t z = std::max<std::int64_t>(k - 1, 0); z <= std::min(k + 1, n[2] - 1); ++z)
        {
          for (std::int64_t y = std::max<std::int64_t>(j - 1, 0); y <= std::min(j + 1, n[1] - 1);
               ++y)
          {
            for (std::int64_t x = std::max<std::int64_t>(i - 1, 0); x <= std::min(i + 1, n[0] - 1);
                 ++x)
            {
              const std::int32_t point =
                this->Nearest[static_cast<std::size_t>(this->Box.Index(x, y, z))];
              if (point >= 0 && point != this->Nearest[static_cast<std::size_t>(index)])
              {
                this->Offer(index, voxel, point);
              }
            }
          }
        }
      },
      isBackward);
  }

  const Mask& Box;
  const Matrix3 ToWorld;
  const ForbiddenZone::Progress& GoesOn;
  std::vector<BoundaryPoint> Points;
  std::vector<std::int32_t> Nearest;
  std::vector<float> Square;
};

} // namespace

std::shared_ptr<const ForbiddenZone> ForbiddenZone::Make(const LabelView& view,
  const LabelTable& table, const Affine3& indexToWorld, double standOff, const Progress& goesOn)
{
  try
  {
    return MakeWhole(view, table, indexToWorld, standOff, goesOn);
  }
  catch (const Ended&)
  {
    return nullptr;
  }
}

std::shared_ptr<const ForbiddenZone> ForbiddenZone::MakeWhole(const LabelView& view,
  const LabelTable& table, const Affine3& indexToWorld, double standOff, const Progress& goesOn)
{
  Mask mask;
  if (!MakeMask(view.GetView(), table, indexToWorld, standOff, goesOn, mask))
  {
    return nullptr;
  }
  const NearestPoints points(mask, indexToWorld.Linear, goesOn);
  if (points.IsEmpty())
  {
    return nullptr;
  }
  const std::shared_ptr<ForbiddenZone> zone(new ForbiddenZone);
  zone->StandOff = standOff;
  constexpr double fraction = 5e-3;
  const Matrix3 columns = Transpose(indexToWorld.Linear);
  zone->Tolerance =
    fraction * std::min({ Norm(columns.Row[0]), Norm(columns.Row[1]), Norm(columns.Row[2]) });
  std::copy(mask.First, mask.First + 3, zone->First);
  zone->Distances.reserve(mask.Is.size());
  for (std::int64_t k = 0; k < mask.Size[2]; ++k)
  {
    Check(goesOn);
    for (std::int64_t j = 0; j < mask.Size[1]; ++j)
    {
      for (std::int64_t i = 0; i < mask.Size[0]; ++i)
      {
        zone->Distances.push_back(static_cast<float>(points.DistanceAt(i, j, k)));
      }
    }
  }
  VolumeView distances = mask.View();
  distances.Data = zone->Distances.data();
  distances.Type = ScalarType::Float32;
  zone->Field = FieldSampler(distances, zone->Kernel);
  return zone;
}

ForbiddenPlace ForbiddenZone::Compute(const Vector3& labelIndex) const noexcept
{
  const Vector3 index = labelIndex -
    Vector3{ static_cast<double>(this->First[0]), static_cast<double>(this->First[1]),
      static_cast<double>(this->First[2]) };
  // IsInside() is false for NaN.
  if (!this->Field.IsInside(index))
  {
    return {};
  }
  const FieldSample sample = this->Field.Gradient(index);
  return { true, sample.Value, sample.Gradient };
}

} // namespace VolumeHaptics
