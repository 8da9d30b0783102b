// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSurroundings.h"

#include "Core/Math/RootBracket.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/Solvers/Precise/PreciseSolver.h"

namespace VolumeHaptics
{
namespace
{

/** A motion may go too far by this fraction of the lag. */
constexpr double Tolerance = 2e-4;
/** A part of a direction below this fraction is rounding. */
constexpr double SmallPart = 1e-3;
/** Number of trials in the search that shortens a motion. */
constexpr int MostTrials = 10;
/**
 * At the middle of an edge, V(x_p) may be below the mean of V(x_s) and V(x_v) by this fraction of
 * their difference.
 */
constexpr double EdgeTolerance = 1e-3;
/** A graded edge gains its strength over this fraction of its height. */
constexpr double EdgeWidth = 0.5;
/** Initial growth (N) of the strength, per EdgeWidth. */
constexpr double EdgeStrength = 20.0;
/** Voxels cut by a wall are not as far in front of it as this value (LabelWall::Value). */
constexpr double BeforeStairs = -0.5;
/** The estimator's own value may be ahead of V(x_p) by this fraction of the edge's height. */
constexpr double OwnLead = 0.25;
/** An edge must be passed by half of this fraction of its height before its origin counts. */
constexpr double OriginMargin = 0.2;
/** Step (kernel radii) of the search for a rise behind an edge. */
constexpr double BankStep = 0.5;
///@{
/** Ratios of the strength behind an edge to the strength ahead, for ComputeLikeness(). */
constexpr double Unlike = 0.5;
constexpr double Alike = 0.65;
///@}
///@{
/** A hand gets into a tissue up to the first strength (N), and no longer from the second one on. */
constexpr double Soft = 5.0;
constexpr double Hard = 10.0;
///@}
///@{
/**
 * Rises behind an edge, as fractions of its height. Up to the first one the edge is no ripple, and
 * from the second one on it is nothing else.
 */
constexpr double RippleBegins = 0.2;
constexpr double Ripple = 0.6;
///@}

/** Returns 1 if the proxy is at or past the middle of an edge, and 0 if it is before. */
double AtEdge(const ValuePair& sides, double value, bool isDescending) noexcept
{
  const double above = value - 0.5 * (sides.Ahead + sides.Behind);
  const double width = EdgeTolerance * std::abs(sides.Ahead - sides.Behind);
  const double fraction = 1.0 + (isDescending ? -above : above) / std::max(width, 1e-300);
  return std::clamp(fraction, 0.0, 1.0);
}

/** Returns how much V rises across an edge towards the structure, or 0 if it falls. */
double ComputeHeight(const ValuePair& sides, bool isDescending) noexcept
{
  const double rise = sides.Ahead - sides.Behind;
  return std::max(0.0, isDescending ? -rise : rise);
}

/**
 * Returns the strength of a graded edge with the height h, whose material has the strength T:
 *
 *   T' = min(T, EdgeStrength s/(1 - s)),   s = (V - middle)/(EdgeWidth h),
 *
 * and 0 before the middle. The strength thus does not jump if the middle wanders along a surface.
 * If h is less than the `rise` that the gradient predicts, the edge is elsewhere, and s falls to 0.
 * s is also 0 if the structure's side has the lower value, because the walk has then met noise.
 * 0. It is 0, too, if the structure's side has the lower value: then the walk has met noise.
 *
 * V is V(x_p) or the estimator's own value, whichever is farther inside. The estimator's value has
 * less noise, but does not reach the middle in a sheet that is thinner than the kernel. It may be
 * ahead by at most OwnLead h: at the foot of an edge, where the walk sees only a part of it, the
 * mean of a wide kernel is past the middle of that part, although the whole edge is still ahead of
 * the proxy.
 */
double GradedStrength(const ValuePair& sides, double strength, double own, double value,
  double rise, bool isDescending) noexcept
{
  const double middle = 0.5 * (sides.Ahead + sides.Behind);
  const double height = ComputeHeight(sides, isDescending);
  const double lead = OwnLead * height;
  const double inside = isDescending ? std::min(value, std::max(own, value - lead))
                                     : std::max(value, std::min(own, value + lead));
  const double above = isDescending ? middle - inside : inside - middle;
  const double past = std::clamp(above / std::max(EdgeWidth * height, 1e-300), 0.0, 1.0);
  const double fraction = past * std::clamp(2.0 * height / std::max(rise, 1e-300) - 1.0, 0.0, 1.0);
  const double edge = EdgeStrength * fraction;
  const double whole = strength * AtEdge(sides, inside, isDescending);
  return std::min(whole, edge / std::max(1.0 - fraction, 1e-12));
}

/**
 * The medium is left between this fraction of the way from the middle of an edge to its end, and
 * the end.
 */
constexpr double LeavingBegins = 0.5;

} // namespace

void PassOn(PassiveSpring& spring, double stiffness, double lag) noexcept
{
  constexpr double least = HapticModel::MinimumStiffness;
  if (!(lag > 0.0))
  {
    spring.Relax(stiffness);
  }
  else if (stiffness > least && spring.Tissue > least)
  {
    spring.Pass(stiffness, lag);
  }
  else
  {
    // If nothing is felt, the spring has no energy to preserve. Its slack remains.
    spring.Tissue = stiffness;
    spring.DropReserve();
  }
}

PrecisePoint PreciseSurroundings::Look(
  const Vector3& proxy, const Vector3& lag, const TouchedMaterial& touched, double voxels) noexcept
{
  const Vector3 index = this->Model.DeviceToIndex(proxy);
  if (!this->IsPlain)
  {
    return this->LookAt(index, Law::ComputeSurface(this->Model, this->Field, index, this->Labels),
      lag, touched, voxels);
  }
  Law::Slope slope;
  FieldSample sample;
  if (!this->Field.IsInside(index) ||
    !Law::ComputeSlope(this->Model, sample = this->Field.Gradient(index), slope))
  {
    return this->LookAt(index, Law::MakeNoSurface(this->Model), lag, touched, voxels);
  }
  // This computes the result of LookAt(), to the bit, but without a Surface, because the processor
  // would have to wait for its numbers in memory.
  ++this->Looks;
  const BakedVolume& baked = *this->Model.Baked;
  const bool isDescending = Law::IsDescending(this->Model, lag, slope.Normal);
  if (isDescending)
  {
    slope.Normal = -slope.Normal;
    slope.Reach = -slope.Reach;
  }
  const DistinctnessTable::Values distinct =
    this->Model.DistinctnessOf(slope.Magnitude, slope.Normal);
  const double fade = this->Model.BorderFade(index);
  FarWalk walk;
  const ValuePair values =
    this->ComputeValues(index, slope, isDescending, distinct[0] * fade, touched, voxels, walk);
  const auto joinWith =
    [&](const DistinctnessTable::Values& factors, const ValuePair& sides, MaterialPoint& material)
  {
    Law::JoinMaterials(this->Model, sides, baked.Materials(sides.Ahead),
      baked.Materials(sides.Behind), factors, fade, 1.0, material);
  };
  const auto join = [&](const ValuePair& sides, MaterialPoint& material)
  { joinWith(distinct, sides, material); };
  MaterialPoint material;
  material.Normal = slope.Normal;
  material.GradientMagnitude = slope.Magnitude;
  join(values, material);
  const double rise = slope.Magnitude * this->Model.WorldUnitsPerMeter;
  PrecisePoint point{ material, sample.Value, isDescending ? -rise : rise, walk.Far, walk.Lasts };
  this->Hide(index, false, point);
  if (baked.Settings.Alignment == ContactAlignment::Edge && point.SurfaceStrength > 0.0)
  {
    this->Align(index, slope, isDescending, distinct[0], touched.IsContact, join, point);
  }
  if (this->Hides)
  {
    this->HoldWhatIsSeen(index, slope, { 1.0, distinct[1] }, joinWith, point);
  }
  if (this->LeavesMedium)
  {
    this->LeaveMedium(join, index, isDescending, point);
  }
  return point;
}

PrecisePoint PreciseSurroundings::Look(const Vector3& proxy, const Surface& surface,
  const Vector3& lag, const TouchedMaterial& touched, double voxels) noexcept
{
  return this->LookAt(this->Model.DeviceToIndex(proxy), surface, lag, touched, voxels);
}

PrecisePoint PreciseSurroundings::LookAt(const Vector3& index, Surface surface, const Vector3& lag,
  const TouchedMaterial& touched, double voxels) noexcept
{
  ++this->Looks;
  const bool isDescending = Law::Orient(this->Model, lag, surface);
  if (this->HasWalks && this->Model.Baked->Walls && !(surface.GradientMagnitude > 0.0))
  {
    surface.Reach = Vector3{}; // there is no wall, so use the labels around the proxy
  }
  if (this->Hides && surface.IsWall && !isDescending && this->IsThinAndSeen(index, surface))
  {
    surface.Depth = 0.0;
    surface.Reach = Vector3{};
  }
  const Law::Slope slope{ surface.Normal, surface.Reach, surface.GradientMagnitude };
  // Look up first, so that sampling the values hides the latency of the lookup.
  const DistinctnessTable::Values distinct = Law::ComputeDistinctness(this->Model, surface);
  const double fraction = surface.IsWall ? 0.0 : distinct[0] * surface.Fade;
  FarWalk walk;
  const ValuePair values =
    this->ComputeValues(index, slope, isDescending, fraction, touched, voxels, walk);
  const auto joinWith =
    [&](const DistinctnessTable::Values& factors, const ValuePair& sides, MaterialPoint& material)
  { Law::SetMaterials(this->Model, index, surface, factors, sides, this->Labels, material); };
  const auto join = [&](const ValuePair& sides, MaterialPoint& material)
  { joinWith(distinct, sides, material); };
  PrecisePoint point;
  join(values, point);
  point.Value = surface.Value;
  const double rise = surface.GradientMagnitude * this->Model.WorldUnitsPerMeter;
  point.Slope = isDescending ? -rise : rise;
  point.Far = walk.Far;
  point.FarLasts = walk.Lasts;
  this->Hide(index, surface.IsWall, point);
  if (this->Model.Baked->Settings.Alignment == ContactAlignment::Edge && !surface.IsWall &&
    point.SurfaceStrength > 0.0)
  {
    this->Align(index, slope, isDescending, distinct[0], touched.IsContact, join, point);
  }
  if (this->Hides && !surface.IsWall)
  {
    this->HoldWhatIsSeen(index, slope, { 1.0, distinct[1] }, joinWith, point);
  }
  if (this->HasWalks && surface.IsWall && !surface.IsOneSided)
  {
    this->LeaveWall(index, surface, distinct, values, point);
  }
  else if (this->LeavesMedium && !surface.IsWall)
  {
    this->LeaveMedium(join, index, isDescending, point);
  }
  return point;
}

void PreciseSurroundings::LeaveWall(const Vector3& index, const Surface& surface,
  const DistinctnessTable::Values& distinct, const ValuePair& values,
  PrecisePoint& point) const noexcept
{
  if (surface.Depth > 0.0 && point.Viscosity > 0.0)
  {
    Surface turned = surface;
    turned.Reach = -surface.Reach;
    MaterialPoint ahead;
    Law::SetMaterials(
      this->Model, index, turned, distinct, { values.Behind, values.Ahead }, this->Labels, ahead);
    if (ahead.Viscosity < point.Viscosity)
    {
      const double left = std::min(surface.Depth / Law::WallHolds, 1.0);
      point.Viscosity += left * (ahead.Viscosity - point.Viscosity);
    }
  }
}

template <typename Join>
void PreciseSurroundings::LeaveMedium(
  const Join& join, const Vector3& index, bool isDescending, PrecisePoint& point) const noexcept
{
  const bool isEdge = point.Viscosity > 0.0 && point.SurfaceValue != point.MediumValue;
  if (!isEdge || FarSide::ComputeEvenFraction(point.Far) >= 1.0)
  {
    return;
  }
  const double middle = 0.5 * (point.SurfaceValue + point.MediumValue);
  const double half = std::abs(point.SurfaceValue - middle);
  const double own = this->Field.Value(index);
  const double past = (isDescending ? middle - own : own - middle) / half;
  if (past > LeavingBegins)
  {
    MaterialPoint there;
    join({ point.MediumValue, point.SurfaceValue }, there);
    if (there.Viscosity < point.Viscosity)
    {
      const double left = std::min((past - LeavingBegins) / (1.0 - LeavingBegins), 1.0);
      point.Viscosity += left * (there.Viscosity - point.Viscosity);
    }
  }
}

double PreciseSurroundings::ComputeLikeness(const ValuePair& sides) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  const double ahead = baked.Materials(sides.Ahead)[2];
  const double behind = baked.Materials(sides.Behind)[2];
  const double soft = std::clamp((Hard - ahead) / (Hard - Soft), 0.0, 1.0);
  return ahead > 0.0 && soft > 0.0
    ? soft * std::clamp((behind / ahead - Unlike) / (Alike - Unlike), 0.0, 1.0)
    : 0.0;
}

double PreciseSurroundings::ComputeHeldOfRipple(const Vector3& index, const Law::Slope& slope,
  double value, double height, bool isDescending, double distinctness) const noexcept
{
  const SurfaceSide side = this->Model.Baked->Settings.Side;
  const double reach = Norm(slope.Reach);
  if (side == SurfaceSide::Both || !(height > 0.0) || !(reach > 0.0))
  {
    return 1.0;
  }
  const Vector3 step = (-BankStep * this->Model.Baked->Kernel.Radius / reach) * slope.Reach;
  const double sign = isDescending ? -1.0 : 1.0;
  double valley = sign * value;
  double bank = 0.0;
  constexpr int steps = static_cast<int>(FarSide::FarthestRadii / BankStep);
  for (int j = 1; j <= steps; ++j)
  {
    const Vector3 behind = index + static_cast<double>(j) * step;
    if (!this->Field.IsInside(behind))
    {
      break;
    }
    const double there = sign * this->Field.Value(behind);
    valley = std::min(valley, there);
    bank = std::max(bank, there - valley);
  }
  const double ripple =
    std::clamp((bank / height - RippleBegins) / (Ripple - RippleBegins), 0.0, 1.0);
  const double held = std::max(0.0, 2.0 * distinctness - 1.0) / distinctness;
  return 1.0 + ripple * (held - 1.0);
}

template <typename Join>
void PreciseSurroundings::Align(const Vector3& index, const Law::Slope& slope, bool isDescending,
  double distinctness, bool isContact, const Join& join, PrecisePoint& point) const noexcept
{
  const ValuePair sides{ point.SurfaceValue, point.MediumValue };
  if (this->Model.Baked->Settings.Placement == MaterialPlacement::Kernel)
  {
    point.SurfaceStrength *= AtEdge(sides, this->Field.Value(index), isDescending);
    return;
  }
  const double even = FarSide::ComputeEvenFraction(point.Far);
  const double value = this->Field.Value(index);
  double edge = point.SurfaceStrength;
  // An edge from hidden to visible values holds from the first visible value on. Its walk may end
  // at visible values between two edges.
  const bool isOfPicture = this->Hides &&
    (!this->IsSeen(sides.Behind) || !this->IsSeen(this->Field.Values(index, slope.Reach).Behind));
  if (even < 1.0 && !isOfPicture)
  {
    const auto grade = [&](const ValuePair& of)
    {
      return GradedStrength(
        of, point.SurfaceStrength, point.Value, value, this->ComputePromise(slope), isDescending);
    };
    edge = grade(sides);
    // The normal turns on the way to an edge, so that another structure may appear behind it. The
    // edge still rises from the values where the hand has come from.
    const ValuePair origin{ sides.Ahead, point.Far.Behind };
    const double held = edge > 0.0 || isContact || distinctness < 1.0
      ? 0.0
      : grade({ origin.Ahead, origin.Behind + OriginMargin * (origin.Ahead - origin.Behind) });
    if (held > 0.0)
    {
      MaterialPoint material;
      join(origin, material);
      edge = held;
      point.MediumValue = origin.Behind;
      point.Viscosity = material.Viscosity;
    }
    // A gap without drag, such as air, is no tissue, so its far side is a boundary.
    if (edge > 0.0 && distinctness < 1.0 && point.Viscosity > 0.0)
    {
      const double alike = this->ComputeLikeness(sides);
      const double held = alike > 0.0
        ? this->ComputeHeldOfRipple(
            index, slope, value, ComputeHeight(sides, isDescending), isDescending, distinctness)
        : 1.0;
      edge *= 1.0 + alike * (held - 1.0);
    }
  }
  // An even ramp has no middle. It holds as with the kernel's values, from the first visible value
  // on.
  double ramp = point.SurfaceStrength;
  if (even > 0.0 && even < 1.0)
  {
    MaterialPoint material;
    join(this->Field.Values(index, slope.Reach), material);
    ramp = material.SurfaceStrength;
  }
  point.SurfaceStrength = edge + even * (ramp - edge);
}

template <typename JoinWith>
void PreciseSurroundings::HoldWhatIsSeen(const Vector3& index, const Law::Slope& slope,
  const DistinctnessTable::Values& whole, const JoinWith& joinWith,
  PrecisePoint& point) const noexcept
{
  if (point.SurfaceStrength >= LeastSeen || !(slope.Magnitude > 0.0) || !this->IsShown(index) ||
    this->IsSeen(this->Field.Values(index, slope.Reach).Behind))
  {
    return;
  }
  MaterialPoint there;
  joinWith(whole, { point.SurfaceValue, point.MediumValue }, there);
  point.SurfaceStrength =
    std::max(point.SurfaceStrength, std::min(there.SurfaceStrength, LeastSeen));
}

bool PreciseSurroundings::IsSeen(double value) const noexcept
{
  return this->Model.Baked->Materials(value)[VisibilityChannel] > 0.0;
}

bool PreciseSurroundings::IsShown(const Vector3& index) const noexcept
{
  if (!this->Field.IsInside(index))
  {
    return false;
  }
  return this->IsSeen(this->Field.Value(this->Model.Baked->IsSeenByNearest
      ? Vector3{ std::round(index.X), std::round(index.Y), std::round(index.Z) }
      : index));
}

bool PreciseSurroundings::IsThinAndSeen(const Vector3& index, const Surface& surface) const noexcept
{
  if (surface.IsOneSided || !(surface.Depth < 0.0) || !this->IsShown(index))
  {
    return false;
  }
  if (surface.Depth < BeforeStairs)
  {
    return true;
  }
  const auto isBehindWall = [&](double fraction)
  {
    const Vector3 ahead = this->Model.IndexToLabel(index + fraction * surface.Reach);
    return this->Model.Baked->Walls->Compute(ahead).Value > 0.0;
  };
  return !isBehindWall(1.0 / 3.0) && !isBehindWall(2.0 / 3.0) && !isBehindWall(1.0);
}

void PreciseSurroundings::Hide(
  const Vector3& index, bool isWall, PrecisePoint& point) const noexcept
{
  if (this->Hides && point.SurfaceStrength + point.Viscosity > 0.0 && !this->IsShown(index))
  {
    point.Viscosity = 0.0;
    point.SurfaceStrength = isWall ? point.SurfaceStrength : 0.0;
  }
}

double PreciseSurroundings::ComputeRise(const Law::Slope& slope) const noexcept
{
  return slope.Magnitude * this->Model.KernelLengthAlong(slope.Normal) *
    this->Model.WorldUnitsPerMeter;
}

double PreciseSurroundings::ComputePromise(const Law::Slope& slope) const noexcept
{
  const GradientKernel& kernel = this->Model.Baked->Kernel;
  const bool isSpline = kernel.Estimator == GradientEstimator::CubicBSpline;
  return (isSpline ? this->Model.InverseRadius : 1.0) * this->ComputeRise(slope);
}

ValuePair PreciseSurroundings::ComputeValues(const Vector3& index, const Law::Slope& slope,
  bool isDescending, double fraction, const TouchedMaterial& touched, double voxels,
  FarWalk& walk) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  if (baked.Settings.Placement == MaterialPlacement::Kernel || fraction <= 0.0)
  {
    return this->Field.Values(index, slope.Reach);
  }
  const PrecisePoint* const before = touched.Point;
  const bool isAlike = before && Dot(before->Normal, slope.Normal) > 0.0;
  const bool isOn = isAlike && touched.IsContact;
  double lasts = FarSide::WalkInterval;
  if (isOn && touched.IsSurface && voxels < before->FarLasts)
  {
    walk.Far = before->Far;
    lasts = before->FarLasts - voxels;
  }
  else
  {
    const double rise = this->ComputeRise(slope);
    walk.Far =
      MeasureFarSide(this->Field, index, slope.Reach, baked.Kernel.Radius, rise, isDescending);
    const double edge = fraction * (1.0 - FarSide::ComputeEvenFraction(walk.Far));
    if (edge < 1.0)
    {
      const ValuePair nearby = this->Field.Values(index, slope.Reach);
      walk.Far.Ahead = nearby.Ahead + edge * (walk.Far.Ahead - nearby.Ahead);
      walk.Far.Behind = nearby.Behind + edge * (walk.Far.Behind - nearby.Behind);
    }
  }
  if (FarSide::ComputeEvenFraction(walk.Far) >= 1.0)
  {
    walk.Lasts = lasts;
    return this->Field.Values(index, slope.Reach);
  }
  if (!isOn || !IsSameEdge(*before, walk.Far))
  {
    const ValuePair sides{ walk.Far.Ahead, walk.Far.Behind };
    // If values change with time, a stored value may be out of date.
    if (isAlike && !isOn && this->Field.IsStill(index) && IsSameEdge(before->Far, walk.Far))
    {
      walk.Far.Behind = ComputeOrigin(before->Far, walk.Far, voxels);
    }
    return sides;
  }
  walk.Lasts = lasts;
  const ValuePair followed = ComputeFarSide(*before, walk.Far, voxels);
  return { touched.IsSurface ? followed.Ahead : walk.Far.Ahead, followed.Behind };
}

bool PreciseSurroundings::CanGoOn() const noexcept
{
  return this->Looks + MostTrials + 2 <= MaximumLooks;
}

bool PreciseSurroundings::IsBeyond(const Vector3& a, const Vector3& b) const noexcept
{
  const Vector3 i = this->Model.DeviceToIndex(a);
  const Vector3 j = this->Model.DeviceToIndex(b);
  const VolumeView& view = this->Model.Baked->Field.GetView();
  const auto beyond = [&](double u, double v, int axis)
  {
    const double last = static_cast<double>(view.Border(axis));
    return (u < 0.0 && v < 0.0) || (u > last && v > last);
  };
  return beyond(i.X, j.X, 0) || beyond(i.Y, j.Y, 1) || beyond(i.Z, j.Z, 2);
}

Arrival PreciseSurroundings::Arrive(
  const Departure& start, const Motion& motion, double fraction, const Vector3& tip) noexcept
{
  const Vector3 displacement = fraction * motion.Displacement;
  Arrival end = this->Try(start, motion, displacement, tip);
  const Remainder rest = this->Judge(motion, displacement, tip, end);
  const double tolerance = -Tolerance * Norm(tip - end.Proxy);
  if (rest.Normal < tolerance || rest.Tangent < tolerance)
  {
    end = this->DrawBack(start, motion, displacement, tip, end, rest);
  }
  return end;
}

Arrival PreciseSurroundings::Try(const Departure& start, const Motion& motion,
  const Vector3& displacement, const Vector3& tip) noexcept
{
  const Vector3 proxy = Law::StopAtCut(this->Model, start.Proxy, start.Proxy + displacement);
  const Vector3 lag = tip - proxy;
  // The point is made in place, because a copy would have to wait until it is in the cache.
  const double voxels = this->HasWalks ? this->Voxels(displacement) : 0.0;
  Arrival end{ proxy, this->Look(proxy, lag, start.Touched, voxels), 0.0, start.Spring };
  const double length = Norm(lag);
  PassOn(end.Spring, end.There.Stiffness, length);
  this->LimitDrag(end.Spring, length, end.There);
  if (motion.IsHeld && end.There.Slope != 0.0)
  {
    const double back = this->ToLevel(end.There, end.Spring.GetEffective(), start.Level, lag);
    end.Proxy += back * end.There.Normal;
    end.CachedSampleDistance = this->Model.MostVoxelsPerMeter * std::abs(back);
    end.There.Value += end.There.Slope * back;
  }
  return end;
}

PreciseSurroundings::Remainder PreciseSurroundings::Judge(const Motion& motion,
  const Vector3& displacement, const Vector3& tip, const Arrival& end) const noexcept
{
  const PrecisePoint& there = end.There;
  const bool isFelt = Law::IsFelt(there);
  const double compliance = isFelt ? 1.0 / end.Spring.GetEffective() : 0.0;
  const SplitLag lag = Law::Split(tip - end.Proxy, there.Normal);
  const Vector3 direction = (1.0 / Norm(displacement)) * displacement;
  const double inward = Dot(direction, there.Normal);
  const Vector3 aside = direction - inward * there.Normal;
  const double across = Norm(aside);
  const double drag = there.Viscosity * compliance;
  const double holds = there.SurfaceStrength * compliance;
  const double grip = there.Friction * std::clamp(lag.Push, 0.0, holds);

  // The rest of the spring after surface and friction. Outward there is no surface. The
  // perpendicular part of the spring is treated in the same way.
  const bool goesIn = !motion.IsHeld && inward > SmallPart;
  const bool goesOut = !motion.IsHeld && inward < -SmallPart;
  const bool goesAcross = across > SmallPart;
  const double pull = Dot(lag.Tangent, aside);
  const double normal = goesIn ? lag.Push - holds : (goesOut ? std::max(0.0, -lag.Push) : 0.0);
  const double tangent = goesAcross ? (pull > 0.0 ? lag.Length : pull / across) - grip : 0.0;
  // If neither part is negative, subtract the drag from the length of both parts combined.
  // Otherwise, subtract from each part the drag's component in that direction.
  const bool isWhole = normal >= 0.0 && tangent >= 0.0;
  const double total = std::sqrt(normal * normal + tangent * tangent) - drag;
  const bool saysNormal = goesIn || (goesOut && drag > 0.0);
  return { saysNormal ? (isWhole ? total : normal - drag * std::abs(inward)) : NoRoot,
    goesAcross ? (isWhole ? total : tangent - drag * across) : NoRoot, isWhole };
}

Arrival PreciseSurroundings::DrawBack(const Departure& start, const Motion& motion,
  const Vector3& displacement, const Vector3& tip, const Arrival& first,
  const Remainder& rest) noexcept
{
  const Vector3 normalPart =
    rest.IsWhole ? displacement : Dot(displacement, first.There.Normal) * first.There.Normal;
  const Vector3 tangentPart = displacement - normalPart;
  // If a motion is computed with the law at its beginning, its remainder at the end is 0.
  const auto along = [&](const Remainder& r)
  { return rest.IsWhole ? std::min(r.Normal, r.Tangent) : r.Normal; };
  RootBracket normal(Norm(normalPart), along(rest), this->Voxels(normalPart));
  RootBracket tangent(
    Norm(tangentPart), rest.IsWhole ? NoRoot : rest.Tangent, this->Voxels(tangentPart));
  Arrival end = first;
  for (int trial = 0; trial < MostTrials; ++trial)
  {
    const bool isLast = normal.IsNarrow() && tangent.IsNarrow();
    const Vector3 shorter = normal.Next(trial) * normalPart + tangent.Next(trial) * tangentPart;
    end = this->Try(start, motion, shorter, tip);
    const Remainder now = this->Judge(motion, displacement, tip, end);
    const double tolerance = Tolerance * Norm(tip - end.Proxy);
    const auto isDone = [&](const RootBracket& bracket, double value)
    { return bracket.IsNarrow() || std::abs(value) <= tolerance; };
    if (isLast || (isDone(normal, along(now)) && isDone(tangent, now.Tangent)))
    {
      return end;
    }
    normal.Narrow(along(now));
    tangent.Narrow(now.Tangent);
  }
  // This is the end at which the material holds.
  return this->Try(
    start, motion, normal.GetHigh() * normalPart + tangent.GetHigh() * tangentPart, tip);
}

} // namespace VolumeHaptics
