// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The material law: what a place in the volume does to a spring that pulls a proxy.
 *
 * With N the normal into the structure, d = x_tip - x_p the spring and F = k d its force, the
 * surface takes F.N up to T = T_N W_d (eqs. 12, 13; nothing outward), friction takes the rest up to
 * mu times that (eqs. 8 to 10), and the drag up to R of what then remains (eq. 14). What nobody
 * takes moves the proxy. All solvers share this; they differ in where they look a place up, and how
 * often.
 *
 * Everything is inlined: the law is a small part of a tick that has to stay small.
 */
#ifndef MaterialLaw_h
#define MaterialLaw_h

#include "Core/Model/HapticModel.h"

namespace VolumeHaptics
{

/** A place of the volume as the law knows it. */
struct Place
{
  Vector3 Normal;                 ///< unit, into the structure
  double GradientMagnitude = 0.0; ///< scalar units per world unit
  double SurfaceValue = 0.0;      ///< V(x_s)
  double MediumValue = 0.0;       ///< V(x_v)
  double Stiffness = 0.0;         ///< k, N/m
  double Friction = 0.0;          ///< mu
  double Viscosity = 0.0;         ///< R, N
  double SurfaceStrength = 0.0;   ///< T_N W_d, N
};

/** Where a surface lies through a position. */
struct Surface
{
  Vector3 Normal; ///< unit, into the structure
  Vector3 Reach;  ///< x_s - x_p, as index steps
  double GradientMagnitude = 0.0;
  double Value = 0.0; ///< the estimator's own, of which the gradient is taken
  double Fade = 0.0;  ///< by how much the border lets it be felt; 0 without a gradient
};

/** What the tip asks for: how far along the normal, and the rest. */
struct SplitLag
{
  double Push;
  Vector3 Tangent;
  double Length; ///< of Tangent
};

/** Who takes how much of the spring's force (N), and what is left to move the proxy. */
struct Balance
{
  double Normal;        ///< taken by the surface
  double Friction;      ///< taken by friction
  double NormalExcess;  ///< left along the normal
  double TangentExcess; ///< left across it
  double Pull;          ///< the tangential force
  double Excess;        ///< of both, before the drag
  double ExcessSquare;
  bool IsThrough; ///< more normal force than the surface takes
  bool Slides;    ///< more tangential force than friction takes
};

namespace Law
{
/** A gradient below this share of the value per voxel is rounding. */
constexpr double RelativeGradientEpsilon = 1e-12;
constexpr double SmallestSquare = std::numeric_limits<double>::min();
/** Distances (m) and forces (N) below these are zero. */
constexpr double DistanceEpsilon = 1e-15;
constexpr double ForceEpsilon = 1e-9;

inline double Capped(double value, double cap) noexcept
{
  return cap > 0.0 ? std::min(value, cap) : value;
}

/** The surface through an index, with an ascending normal. */
inline Surface FindSurface(const HapticModel& model, const Vector3& index) noexcept
{
  Surface surface;
  surface.Normal = model.FallbackNormal;
  surface.Reach = model.FallbackReach;
  if (!model.Field.IsInside(index))
  {
    return surface;
  }
  const FieldSample sample = model.Field.Gradient(index);
  const double floor = RelativeGradientEpsilon * sample.Value;
  const Vector3 gradient = model.GradientToDevice * sample.Gradient;
  const double square = Dot(gradient, gradient);
  // False for NaN, too: no surface where a sample is not finite.
  if (Dot(sample.Gradient, sample.Gradient) > floor * floor && square > SmallestSquare &&
    std::isfinite(square))
  {
    // Root and reciprocal do not wait for each other.
    const double magnitude = std::sqrt(square);
    const double inverse = (1.0 / square) * magnitude;
    surface.Normal = inverse * gradient;
    surface.Reach = inverse * (model.GradientToReach * sample.Gradient);
    surface.GradientMagnitude = magnitude;
    surface.Value = sample.Value;
    surface.Fade = model.BorderFade(index);
  }
  return surface;
}

/** Whether the structure lies against the gradient, as the settings say. */
inline bool IsDescending(
  const HapticModel& model, const Vector3& lag, const Vector3& normal) noexcept
{
  const SurfaceSide side = model.Settings.Side;
  return side == SurfaceSide::Lower || (side == SurfaceSide::Both && Dot(lag, normal) < 0.0);
}

/** Turns a surface towards its structure; whether that is against the gradient. */
inline bool Orient(const HapticModel& model, const Vector3& lag, Surface& surface) noexcept
{
  const bool isDescending = IsDescending(model, lag, surface.Normal);
  if (isDescending)
  {
    surface.Normal = -surface.Normal;
    surface.Reach = -surface.Reach;
  }
  return isDescending;
}

inline SplitLag Split(const Vector3& lag, const Vector3& normal) noexcept
{
  const double push = Dot(lag, normal);
  const Vector3 tangent = lag - push * normal;
  return { push, tangent, Norm(tangent) };
}

/** Materials at x_s and x_v of an index (eq. 13, section 3.3). */
inline void ReadMaterials(
  const HapticModel& model, const Vector3& index, const Surface& surface, Place& place) noexcept
{
  // Before the values, whose sampling hides it.
  const DistinctnessTable::Values distinct = model.Distinctness(surface.GradientMagnitude);
  const ValuePair values = model.Field.Values(index, surface.Reach);
  const MaterialTable::Values inside = model.Materials(values.Ahead);
  const MaterialTable::Values outside = model.Materials(values.Behind);
  place.Normal = surface.Normal;
  place.GradientMagnitude = surface.GradientMagnitude;
  place.SurfaceValue = values.Ahead;
  place.MediumValue = values.Behind;
  place.Stiffness = Capped(inside[0], model.Settings.Caps.Stiffness);
  place.Friction = inside[1];
  place.SurfaceStrength = inside[2] * (distinct[0] * surface.Fade) * (inside[4] * distinct[1]);
  place.Viscosity = outside[3] * (outside[4] * distinct[1]);
}

/**
 * For methods whose surface is that of one value: its material; whether anything at all is felt
 * there.
 */
inline bool ReadIsoMaterial(const HapticModel& model, Place& place) noexcept
{
  const double iso = model.Settings.IsoValue;
  const MaterialTable::Values material = model.Materials(iso);
  place = Place{};
  place.Normal = model.FallbackNormal;
  place.SurfaceValue = place.MediumValue = iso;
  place.Stiffness = Capped(material[0], model.Settings.Caps.Stiffness);
  place.Friction = material[1];
  return place.Stiffness > HapticModel::MinimumStiffness && material[4] > 0.0;
}

/** Whether anything at all is felt here; where not, the proxy goes with the tip. */
inline bool IsFelt(const Place& place) noexcept
{
  return place.Stiffness > HapticModel::MinimumStiffness;
}

/** Eqs. 8 to 13, for a spring of stiffness k (N/m). */
inline Balance Weigh(const Place& place, double k, const SplitLag& lag) noexcept
{
  Balance b;
  const double threshold = lag.Push > 0.0 ? place.SurfaceStrength : 0.0;
  const double pushForce = k * std::abs(lag.Push);
  b.IsThrough = pushForce > threshold;
  b.Normal = b.IsThrough ? threshold : pushForce;
  b.NormalExcess = pushForce - b.Normal;
  b.Pull = k * lag.Length;
  const double grip = place.Friction * b.Normal;
  b.Slides = lag.Length > DistanceEpsilon && b.Pull > grip;
  b.Friction = b.Slides ? grip : b.Pull;
  b.TangentExcess = b.Pull - b.Friction;
  b.ExcessSquare = b.NormalExcess * b.NormalExcess + b.TangentExcess * b.TangentExcess;
  b.Excess = std::sqrt(b.ExcessSquare);
  return b;
}

/** Eq. 14: the motion that is left of the excess. */
inline Vector3 Move(const Place& place, double k, const SplitLag& lag, const Balance& b,
  const Vector3& start) noexcept
{
  const double drag = place.Viscosity;
  Vector3 proxy = start;
  if (drag < b.Excess)
  {
    const double share = 1.0 - drag / b.ExcessSquare * b.Excess;
    proxy += (share * (std::copysign(b.NormalExcess, lag.Push) / k)) * place.Normal;
    if (b.Slides)
    {
      proxy += (share * (b.TangentExcess / b.Pull)) * lag.Tangent;
    }
  }
  return proxy;
}
} // namespace Law

} // namespace VolumeHaptics

#endif
