// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"

#include "Core/Model/HapticModel.h"

namespace VolumeHaptics
{
namespace
{

/** Step of the search along a ray (voxels). */
constexpr double RayStep = 0.5;
/**
 * Two feet count as one within the first distance (voxels), and a crossing is narrow enough if its
 * ends are within the second one.
 */
constexpr double SameFoot = 1e-3;
constexpr double SameCrossing = 1e-7;
/**
 * V is compared at this distance (voxels) to both sides of a foot, to find the direction in which
 * it rises.
 */
constexpr double RiseStep = 0.25;
constexpr int MostFeet = 6;
constexpr int MostHalvings = 60;

/** Returns the symmetric matrix factor (a b' + b a'). */
Symmetric3 Product(const Vector3& a, const Vector3& b, double factor) noexcept
{
  return { (2.0 * factor) * Vector3{ a.X * b.X, a.Y * b.Y, a.Z * b.Z },
    factor * Vector3{ a.Y * b.Z + a.Z * b.Y, a.X * b.Z + a.Z * b.X, a.X * b.Y + a.Y * b.X } };
}

Symmetric3 Sum(const Symmetric3& a, const Symmetric3& b) noexcept
{
  return { a.Diagonal + b.Diagonal, a.Mixed + b.Mixed };
}

/** Finds the isosurface of a model in the world. */
class IsoSurfaceFinder
{
public:
  IsoSurfaceFinder(const HapticModel& model, const LocalSurfaceRequest& request) noexcept
    : Model(model)
    , Field(model.Baked->At(request.DataTime))
    , Request(request)
    , IndexToWorld(model.Baked->IndexToWorld)
    , WorldToIndex(Inverse(model.Baked->IndexToWorld))
    , GradientToWorld(Transpose(this->WorldToIndex.Linear))
    , Voxel(1.0 / LargestColumn(this->GradientToWorld))
    , IsKnown(Dot(request.Normal, request.Normal) > 0.0)
  {
    const SurfaceSide side = model.Baked->Settings.Side;
    const bool isHigh = this->Excess(request.Position) > 0.0;
    this->Sign = side == SurfaceSide::Lower || (side == SurfaceSide::Both && isHigh) ? -1.0 : 1.0;
  }

  LocalSurface Solve() noexcept
  {
    LocalSurface found;
    if (!IsFinite(this->Request.Position) ||
      (!this->IsKnown && this->Sign * this->Excess(this->Request.Position) > 0.0))
    {
      return found;
    }
    Vector3 foot;
    Vector3 normal;
    if (!this->FindCrossing(foot) || !this->ComputeNormal(foot, normal))
    {
      return found;
    }
    this->SolveFoot(foot, normal);
    const bool isBoth = this->Model.Baked->Settings.Side == SurfaceSide::Both;
    // Because of rounding, the proxy may be on either side of the surface that holds it. If a
    // structure is thinner than the kernel, the gradient may belong to the structure behind it.
    const bool isTurned = this->IsKnown && isBoth ? Dot(normal, this->Request.Normal) < 0.0
                                                  : this->Sign * this->Rise(foot, normal) < 0.0;
    if (isTurned)
    {
      this->Sign = -this->Sign;
      normal = -normal;
    }
    found.IsThere = true;
    found.Shape.Centre = foot;
    found.Shape.Gradient = normal;
    if (this->Model.Baked->Settings.LocalShape == LocalSurfaceShape::Quadric)
    {
      found.Shape.Curvature = this->ComputeCurvature(foot, normal);
    }
    return found;
  }

private:
  double Excess(const Vector3& x) const noexcept
  {
    return this->Field.Value(this->WorldToIndex(x)) - this->Model.Baked->Settings.IsoValue;
  }

  /** Computes the unit normal into the structure. Returns false if there is no gradient. */
  bool ComputeNormal(const Vector3& x, Vector3& normal) const noexcept
  {
    const Vector3 index = this->WorldToIndex(x);
    if (!this->Field.IsInside(index))
    {
      return false;
    }
    const Vector3 gradient = this->GradientToWorld * this->Field.Gradient(index).Gradient;
    const double norm = Norm(gradient);
    // The comparison is false for NaN, too.
    if (!(norm > 0.0 && std::isfinite(norm)))
    {
      return false;
    }
    normal = (this->Sign / norm) * gradient;
    return true;
  }

  /** Returns how much V rises along the normal at a position. */
  double Rise(const Vector3& x, const Vector3& normal) const noexcept
  {
    const Vector3 step = (RiseStep * this->Voxel) * normal;
    return this->Excess(x + step) - this->Excess(x - step);
  }

  /**
   * Returns where the isosurface is between two positions whose excesses have different signs, by
   * bisection.
   */
  Vector3 Narrow(Vector3 a, Vector3 b, double atA) const noexcept
  {
    for (int i = 0; i < MostHalvings && Norm(b - a) > SameCrossing * this->Voxel; ++i)
    {
      const Vector3 middle = 0.5 * (a + b);
      const double atMiddle = this->Excess(middle);
      ((atMiddle > 0.0) == (atA > 0.0) ? a : b) = middle;
    }
    return 0.5 * (a + b);
  }

  /**
   * Stores the first crossing along a ray from Position, if it is nearer than the nearest one so
   * far.
   */
  void LookAlong(const Vector3& ray, int steps, double& nearest, Vector3& crossing) const noexcept
  {
    const Vector3& start = this->Request.Position;
    double before = this->Excess(start);
    for (int i = 1; i <= steps; ++i)
    {
      const Vector3 x = start + (static_cast<double>(i) / steps) * ray;
      const Vector3 last = start + (static_cast<double>(i - 1) / steps) * ray;
      if (Norm(last - start) >= nearest)
      {
        return;
      }
      const double now = this->Excess(x);
      if ((now > 0.0) != (before > 0.0))
      {
        const Vector3 found = this->Narrow(last, x, before);
        const double distance = Norm(found - start);
        if (distance < nearest)
        {
          nearest = distance;
          crossing = found;
        }
        return;
      }
      before = now;
    }
  }

  bool FindCrossing(Vector3& crossing) const noexcept
  {
    double nearest = HUGE_VAL;
    constexpr int steps = static_cast<int>(LocalReach / RayStep);
    for (int direction = 0; direction < 27; ++direction)
    {
      const Vector3 offset{ direction % 3 - 1.0, direction / 3 % 3 - 1.0, direction / 9 - 1.0 };
      if (direction != 13)
      {
        this->LookAlong(
          this->IndexToWorld.Linear * (LocalReach * offset), steps, nearest, crossing);
      }
    }
    const double voxels = Norm(this->WorldToIndex.Linear * this->Request.Ahead);
    if (nearest == HUGE_VAL && voxels > 0.0 && std::isfinite(voxels))
    {
      const double reach = std::min<double>(voxels, LocalReachAhead);
      this->LookAlong((reach / voxels) * this->Request.Ahead,
        static_cast<int>(std::ceil(reach / RayStep)), nearest, crossing);
    }
    return nearest < HUGE_VAL;
  }

  /** Moves from a crossing to the point of the surface that is nearest to Position. */
  void SolveFoot(Vector3& foot, Vector3& normal) const noexcept
  {
    const Vector3& start = this->Request.Position;
    for (int i = 0; i < MostFeet; ++i)
    {
      const double along = Dot(foot - start, normal);
      const Vector3 before = start + (along - this->Voxel) * normal;
      const Vector3 behind = start + (along + this->Voxel) * normal;
      const double atBefore = this->Excess(before);
      if ((atBefore > 0.0) == (this->Excess(behind) > 0.0))
      {
        return;
      }
      const Vector3 next = this->Narrow(before, behind, atBefore);
      Vector3 nextNormal;
      if (Norm(next - start) > Norm(foot - start) || !this->ComputeNormal(next, nextNormal))
      {
        return;
      }
      const bool isSame = Norm(next - foot) < SameFoot * this->Voxel;
      foot = next;
      normal = nextNormal;
      if (isSame)
      {
        return;
      }
    }
  }

  /**
   * Returns the change of the normal along the surface at the foot, or 0 if there is no normal at
   * one kernel radius from it.
   */
  Symmetric3 ComputeCurvature(const Vector3& foot, const Vector3& normal) const noexcept
  {
    const double step = this->Model.Baked->Kernel.Radius * this->Model.Baked->LargestSpacing;
    // Two directions perpendicular to the normal, away from its largest component.
    const bool isAlongX = std::abs(normal.X) > 0.7;
    const Vector3 side = Cross(normal, isAlongX ? Vector3{ 0, 1, 0 } : Vector3{ 1, 0, 0 });
    const Vector3 first = (1.0 / Norm(side)) * side;
    const Vector3 axes[2] = { first, Cross(normal, first) };
    Vector3 change[2];
    double reach[2]; // length of the kernel along each direction
    for (int i = 0; i < 2; ++i)
    {
      reach[i] = this->Model.HasLengthByDirection
        ? this->Model.KernelLengthOf(this->WorldToIndex.Linear * axes[i])
        : step;
      Vector3 ahead;
      Vector3 behind;
      if (!this->ComputeNormal(foot + reach[i] * axes[i], ahead) ||
        !this->ComputeNormal(foot - reach[i] * axes[i], behind))
      {
        return {};
      }
      change[i] = (0.5 / reach[i]) * (ahead - behind);
    }
    const double a = Dot(change[0], axes[0]);
    const double b = Dot(change[1], axes[1]);
    const double mixed = 0.5 * (Dot(change[0], axes[1]) + Dot(change[1], axes[0]));
    const Symmetric3 curvature =
      Sum(Sum(Product(axes[0], axes[0], 0.5 * a), Product(axes[1], axes[1], 0.5 * b)),
        Product(axes[0], axes[1], mixed));
    // A surface that bends more tightly than the kernel is noise.
    const double bendA = a * (reach[0] / step);
    const double bendB = b * (reach[1] / step);
    const double twist = mixed * (std::sqrt(reach[0] * reach[1]) / step);
    const double most = std::sqrt(bendA * bendA + bendB * bendB + 2.0 * twist * twist) * step;
    const double fraction = std::min(1.0, 1.0 / most);
    return { fraction * curvature.Diagonal, fraction * curvature.Mixed };
  }

  const HapticModel& Model;
  const FieldAtTime Field;
  const LocalSurfaceRequest& Request;
  const Affine3 IndexToWorld;
  const Affine3 WorldToIndex;
  const Matrix3 GradientToWorld;
  const double Voxel; ///< smallest spacing of the samples
  const bool IsKnown;
  double Sign = 1.0; ///< 1 or -1, so that Sign times the gradient points into the structure
};

} // namespace

LocalSurface FitLocalSurface(const HapticModel& model, const LocalSurfaceRequest& request) noexcept
{
  return IsoSurfaceFinder(model, request).Solve();
}

} // namespace VolumeHaptics
