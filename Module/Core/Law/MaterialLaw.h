// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The material law: how the material at a point balances the spring that pulls the proxy.
 *
 * With N the normal into the structure, d = x_tip - x_p the lag and F = k d the spring's force:
 * - the surface carries F.N up to T = T_N W_d (eqs. 12, 13), and no outward force;
 * - friction carries the tangential force up to mu times that (eqs. 8 to 10);
 * - the drag carries up to R of the remainder (eq. 14);
 * - the rest moves the proxy.
 *
 * All solvers share this law. They differ in where and how often they read the material.
 *
 * Everything is inlined: the law is a small part of a tick, and a tick has to be short.
 */
#ifndef MaterialLaw_h
#define MaterialLaw_h

#include "Core/Law/MaterialPoint.h"
#include "Core/Math/KernelInline.h"
#include "Core/Model/HapticModel.h"
#include "Core/Model/LabelMemory.h"

namespace VolumeHaptics
{

/** The surface through a position. */
struct Surface
{
  Vector3 Normal; ///< unit vector into the structure
  Vector3 Reach;  ///< x_s - x_p in index steps
  double GradientMagnitude = 0.0;
  double Value = 0.0; ///< the estimator's own value; the normal is the direction of its gradient
  /**
   * Factor of the surface's strength, 0 to 1. It falls to 0 at the border, and is 0 without a
   * gradient.
   */
  double Fade = 0.0;
  /** Fraction of the medium's drag that is felt; 0 in a part that is cut away. */
  double DragFraction = 1.0;
  /** Whether the surface is a cut's face or a wall between labels (Value: LabelWall's). */
  bool IsWall = false;
  double Depth = 0.0; ///< value of a wall, with the sign of the normal
  /** Whether the normal points into the structure wherever the tip is. */
  bool IsOneSided = false;
  /** The faces of a cut here (CutPlace::Faces). In a hollow corner there are several. */
  std::uint32_t CutFaces = 0;
  /** Whether the wall is in front of a forbidden label; Value is then in world units. */
  bool IsForbidden = false;
};

/** A lag, split into its length along the normal and its tangential part. */
struct SplitLag
{
  double Push;
  Vector3 Tangent;
  double Length; ///< length of Tangent
};

/**
 * How the spring's force (N) is shared between the surface, the friction, and the excess that moves
 * the proxy.
 */
struct Balance
{
  double Normal;        ///< force that the surface carries
  double Friction;      ///< force that friction carries
  double NormalExcess;  ///< remaining force along the normal
  double TangentExcess; ///< remaining tangential force
  double Pull;          ///< tangential force of the spring
  double Excess;        ///< magnitude of both excesses together, before the drag
  double ExcessSquare;
  bool IsThrough; ///< whether the normal force exceeds the surface's strength
  bool Slides;    ///< whether the tangential force exceeds the friction
};

namespace Law
{
/** A gradient below this fraction of the value per voxel counts as rounding. */
constexpr double RelativeGradientEpsilon = 1e-12;
constexpr double SmallestSquare = std::numeric_limits<double>::min();
/** Distances (m) and forces (N) below these limits count as zero. */
constexpr double DistanceEpsilon = 1e-15;
constexpr double ForceEpsilon = 1e-9;

inline double Capped(double value, double cap) noexcept
{
  return cap > 0.0 ? std::min(value, cap) : value;
}

/** Makes a surface without strength, with the model's fallback normal. */
inline Surface MakeNoSurface(const HapticModel& model) noexcept
{
  Surface surface;
  surface.Normal = model.FallbackNormal;
  surface.Reach = model.FallbackReach;
  return surface;
}

/** The direction in which the scalars rise. */
struct Slope
{
  Vector3 Normal;   ///< unit vector
  Vector3 Reach;    ///< see Surface::Reach
  double Magnitude; ///< see MaterialPoint::GradientMagnitude
};

/** Computes the slope of a sample. Returns false if there is no gradient. */
VOLUME_HAPTICS_INLINE bool ComputeSlope(
  const HapticModel& model, const FieldSample& sample, Slope& slope) noexcept
{
  const double floor = RelativeGradientEpsilon * sample.Value;
  const Vector3 gradient = model.GradientToDevice * sample.Gradient;
  const double square = Dot(gradient, gradient);
  // The comparison is false for NaN, too: where a sample is not finite, there is no surface.
  if (!(Dot(sample.Gradient, sample.Gradient) > floor * floor && square > SmallestSquare &&
        std::isfinite(square)))
  {
    return false;
  }
  // Root and reciprocal are independent, so that the processor can compute them in parallel.
  slope.Magnitude = std::sqrt(square);
  const double inverse = (1.0 / square) * slope.Magnitude;
  slope.Normal = inverse * gradient;
  slope.Reach = model.ComputeReach(inverse * (model.GradientToReach * sample.Gradient));
  return true;
}

/**
 * Makes the scalars' surface through an index from the gradient there. The normal points to higher
 * values.
 */
inline Surface MakeFieldSurface(
  const HapticModel& model, const Vector3& index, const FieldSample& sample) noexcept
{
  Surface surface = MakeNoSurface(model);
  Slope slope;
  if (ComputeSlope(model, sample, slope))
  {
    surface.Normal = slope.Normal;
    surface.Reach = slope.Reach;
    surface.GradientMagnitude = slope.Magnitude;
    surface.Value = sample.Value;
    surface.Fade = model.BorderFade(index);
  }
  return surface;
}

/** Computes the scalars' surface through an index. The normal points to higher values. */
inline Surface ComputeFieldSurface(
  const HapticModel& model, const FieldAtTime& field, const Vector3& index) noexcept
{
  return field.IsInside(index) ? MakeFieldSurface(model, index, field.Gradient(index))
                               : MakeNoSurface(model);
}

/**
 * Computes the surface through an index of a model with labels or a cut. Defined in
 * FieldSurface.cxx.
 */
Surface ComputeOtherSurface(const HapticModel& model, const FieldAtTime& field,
  const Vector3& index, LabelMemory& memory) noexcept;

/**
 * Computes the surface through an index, whatever it comes from. The normal of the scalars' surface
 * points to higher values.
 */
inline Surface ComputeSurface(const HapticModel& model, const FieldAtTime& field,
  const Vector3& index, LabelMemory& memory) noexcept
{
  return model.Baked->HasOtherSurfaces ? ComputeOtherSurface(model, field, index, memory)
                                       : ComputeFieldSurface(model, field, index);
}

/**
 * Distance (voxels along the normal) within which the drag may hold a proxy, however soft the
 * material is.
 */
constexpr double DragVoxels = 3.0;

/**
 * Limits the drag R: it holds the proxy at most as far behind the tip as with the coupling
 * stiffness, or three voxels along the normal, whichever is longer.
 *
 * A stiffness near 0 with a drag above 0 is a mistake in the functions, or noise on a ramp of the
 * stiffness. Without the limit, the proxy would stay R/k behind, and the hand would pass through a
 * surface without feeling it. The solver Paper does not limit the drag.
 *
 * @param slack the part (m) of the lag over which the spring (PassiveSpring.h) does not pull
 */
inline void LimitDrag(const HapticModel& model, double slack, MaterialPoint& point) noexcept
{
  const double k = point.Stiffness;
  const double drag = point.Viscosity;
  // For most materials, a comparison with the smallest spacing shows that the limit does not apply,
  // and saves the root below.
  if (!(drag > k * (DragVoxels / model.MostVoxelsPerMeter - slack)))
  {
    return;
  }
  // Without a gradient the normal has no meaning, so use the smallest spacing.
  const double voxelsPerMeter = point.GradientMagnitude > 0.0
    ? Norm(model.DeviceToIndex.Linear * point.Normal)
    : model.MostVoxelsPerMeter;
  double longest = DragVoxels / voxelsPerMeter;
  const double coupling = Capped(model.Baked->Settings.CouplingStiffness, model.Caps.Stiffness);
  if (coupling > 0.0)
  {
    if (slack == 0.0 && k >= coupling)
    {
      return; // no limit: drag / coupling is R/k or longer, apart from rounding
    }
    longest = std::max(longest, drag / coupling);
  }
  point.Viscosity = std::clamp(k * (longest - slack), 0.0, drag);
}

/** Strength (N) and least stiffness (N/m) of the wall in front of a forbidden label. */
constexpr double ForbiddenStrength = 1e6;
constexpr double ForbiddenStiffness = 500.0;

/**
 * Depths (as LabelWall::Value): a wall has its full strength up to WallHolds, and none from
 * WallEnds on.
 */
constexpr double WallHolds = 0.5;
constexpr double WallEnds = 0.9;
/**
 * Distance in front of a wall over which its strength rises, so that a proxy comes to rest in front
 * of the wall.
 */
constexpr double WallBegins = 5e-3;

/**
 * Returns the distinctness of a wall: 1 from the wall down to WallHolds, 0 in front of WallBegins
 * and below WallEnds, with linear ramps between.
 */
inline double DistinctnessOfWall(double depth) noexcept
{
  const double before = 1.0 + depth / WallBegins;
  const double behind = (WallEnds - depth) / (WallEnds - WallHolds);
  return std::clamp(std::min(before, behind), 0.0, 1.0);
}

/** Returns W_d and the visibility, which depend on the gradient, or on the depth in a wall. */
inline DistinctnessTable::Values ComputeDistinctness(
  const HapticModel& model, const Surface& surface) noexcept
{
  return surface.IsWall ? DistinctnessTable::Values{ DistinctnessOfWall(surface.Depth), 1.0 }
                        : model.DistinctnessOf(surface.GradientMagnitude, surface.Normal);
}

/**
 * Returns whether the structure is on the side of the lower values. The settings decide this, or
 * the lag if both sides are felt.
 */
inline bool IsDescending(
  const HapticModel& model, const Vector3& lag, const Vector3& normal) noexcept
{
  const SurfaceSide side = model.Baked->Settings.Side;
  return side == SurfaceSide::Lower || (side == SurfaceSide::Both && Dot(lag, normal) < 0.0);
}

/**
 * In a hollow corner between faces of a cut, turns the normal to the direction of the lag's joint
 * push against these faces. Defined in FieldSurface.cxx.
 */
void TurnIntoCorner(const HapticModel& model, const Vector3& lag, Surface& surface) noexcept;

/**
 * Turns a surface's normal towards its structure. Returns whether the normal then points against
 * the gradient.
 */
inline bool Orient(const HapticModel& model, const Vector3& lag, Surface& surface) noexcept
{
  if (surface.IsOneSided)
  {
    if ((surface.CutFaces & (surface.CutFaces - 1)) != 0)
    {
      TurnIntoCorner(model, lag, surface);
    }
    return false;
  }
  const bool isDescending = IsDescending(model, lag, surface.Normal);
  if (isDescending)
  {
    surface.Normal = -surface.Normal;
    surface.Reach = -surface.Reach;
    surface.Depth = -surface.Depth;
  }
  return isDescending;
}

inline SplitLag Split(const Vector3& lag, const Vector3& normal) noexcept
{
  const double push = Dot(lag, normal);
  const Vector3 tangent = lag - push * normal;
  return { push, tangent, Norm(tangent) };
}

/**
 * Sets the material of a point from the values and materials inside and outside a surface (eq. 13).
 */
inline void JoinMaterials(const HapticModel& model, const ValuePair& values,
  const MaterialTable::Values& inside, const MaterialTable::Values& outside,
  const DistinctnessTable::Values& distinct, double fade, double dragFraction,
  MaterialPoint& point) noexcept
{
  point.SurfaceValue = values.Ahead;
  point.MediumValue = values.Behind;
  point.Stiffness = Capped(inside[0], model.Caps.Stiffness);
  point.Friction = inside[1];
  point.SurfaceStrength = inside[2] * (distinct[0] * fade) * (inside[4] * distinct[1]);
  point.Viscosity = outside[3] * (outside[4] * distinct[1]) * dragFraction;
}

/**
 * Sets the material at an index from the values inside and outside the surface and from the labels
 * at x_s and x_v (eq. 13, section 3.3).
 */
inline void SetMaterials(const HapticModel& model, const Vector3& index, const Surface& surface,
  const DistinctnessTable::Values& distinct, const ValuePair& values, LabelMemory& memory,
  MaterialPoint& point) noexcept
{
  MaterialTable::Values inside = model.Baked->Materials(values.Ahead);
  MaterialTable::Values outside = model.Baked->Materials(values.Behind);
  if (const BakedLabels* const labels = model.Baked->Labels.get())
  {
    const std::uint64_t number = model.Baked->Number;
    labels->Mix(model.IndexToLabel(index + surface.Reach), number, memory.Ahead, inside);
    labels->Mix(model.IndexToLabel(index - surface.Reach), number, memory.Behind, outside);
  }
  point.Normal = surface.Normal;
  point.GradientMagnitude = surface.GradientMagnitude;
  JoinMaterials(
    model, values, inside, outside, distinct, surface.Fade, surface.DragFraction, point);
  if (surface.IsForbidden)
  {
    point.Stiffness = Capped(std::max(inside[0], ForbiddenStiffness), model.Caps.Stiffness);
    point.SurfaceStrength = ForbiddenStrength * surface.Fade;
  }
}

/** Reads the material at an index, by value and by label: from x_s and x_v (section 3.3). */
inline void ReadMaterials(const HapticModel& model, const FieldAtTime& field, const Vector3& index,
  const Surface& surface, LabelMemory& memory, MaterialPoint& point) noexcept
{
  // Look up the distinctness first, so that sampling the values hides the latency of the lookup.
  const DistinctnessTable::Values distinct = ComputeDistinctness(model, surface);
  SetMaterials(model, index, surface, distinct, field.Values(index, surface.Reach), memory, point);
}

/**
 * Reads the material at the isovalue, for methods with an isosurface. Returns false if that
 * material is not felt.
 */
inline bool ReadIsoMaterial(const HapticModel& model, MaterialPoint& point) noexcept
{
  const double iso = model.Baked->Settings.IsoValue;
  const MaterialTable::Values material = model.Baked->Materials(iso);
  point = MaterialPoint{};
  point.Normal = model.FallbackNormal;
  point.SurfaceValue = point.MediumValue = iso;
  point.Stiffness = Capped(material[0], model.Caps.Stiffness);
  point.Friction = material[1];
  return point.Stiffness > HapticModel::MinimumStiffness && material[4] > 0.0;
}

/** Returns whether the material is felt. If not, the proxy moves with the tip. */
inline bool IsFelt(const MaterialPoint& point) noexcept
{
  return point.Stiffness > HapticModel::MinimumStiffness;
}

/**
 * Computes the forces of surface and friction against a spring of stiffness k (N/m), and the
 * excess, from which Move() computes the proxy's motion (eqs. 8 to 12).
 */
inline Balance Weigh(const MaterialPoint& point, double k, const SplitLag& lag) noexcept
{
  Balance b;
  // Eqs. 11 and 12. Outward motion is free.
  const double threshold = lag.Push > 0.0 ? point.SurfaceStrength : 0.0;
  const double pushForce = k * std::abs(lag.Push);
  b.IsThrough = pushForce > threshold;
  b.Normal = b.IsThrough ? threshold : pushForce;
  b.NormalExcess = pushForce - b.Normal;
  // Eqs. 8 to 10.
  b.Pull = k * lag.Length;
  const double grip = point.Friction * b.Normal;
  b.Slides = lag.Length > DistanceEpsilon && b.Pull > grip;
  b.Friction = b.Slides ? grip : b.Pull;
  b.TangentExcess = b.Pull - b.Friction;
  b.ExcessSquare = b.NormalExcess * b.NormalExcess + b.TangentExcess * b.TangentExcess;
  b.Excess = std::sqrt(b.ExcessSquare);
  return b;
}

/**
 * Returns where a motion (m) of the proxy ends in a volume with a cut: at `to`, or at the first
 * solid face of the cut.
 */
Vector3 StopAtFaces(const HapticModel& model, const Vector3& from, const Vector3& to) noexcept;

/** Returns where a motion (m) of the proxy ends: at `to`, or at the first solid face of a cut. */
inline Vector3 StopAtCut(const HapticModel& model, const Vector3& from, const Vector3& to) noexcept
{
  return model.Baked->Cut ? StopAtFaces(model, from, to) : to;
}

/**
 * Returns the proxy's position after eq. 14: the part of the excess that the drag does not hold
 * moves the proxy.
 */
inline Vector3 Move(const MaterialPoint& point, double k, const SplitLag& lag, const Balance& b,
  const Vector3& start) noexcept
{
  const double drag = point.Viscosity;
  Vector3 proxy = start;
  if (drag < b.Excess)
  {
    const double fraction = 1.0 - drag / b.ExcessSquare * b.Excess;
    proxy += (fraction * (std::copysign(b.NormalExcess, lag.Push) / k)) * point.Normal;
    if (b.Slides)
    {
      proxy += (fraction * (b.TangentExcess / b.Pull)) * lag.Tangent;
    }
  }
  return proxy;
}
} // namespace Law

} // namespace VolumeHaptics

#endif
