// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceTick.h"

#include <vtkPiecewiseFunction.h>

#include <algorithm>

namespace reference
{
enum Contact
{
  Free = 0,
  Sticking = 1,
  Sliding = 2,
  Penetrating = 3
};

static double Evaluate(vtkPiecewiseFunction* function, double x, double constantIfEmpty)
{
  return function->GetSize() == 0 ? constantIfEmpty : function->GetValue(x);
}

TickRecord ProxyTick(const ReferenceField& field, Scene& scene, const Vec3& proxy, const Vec3& tip,
  const Vec3& freeNormal)
{
  const double metres = scene.metersPerWorldUnit;
  vtkHapticProperty* property = scene.property;
  TickRecord out;
  out.tip = tip;

  // Surface: the gradient is read once per tick.
  const Vec3 g = field.Gradient(proxy);
  out.gradientMagnitude = Norm(g);
  const bool defined = out.gradientMagnitude > field.GradientFloor(proxy);
  Vec3 N = freeNormal;
  double w = 0.0;
  if (defined)
  {
    N = (1.0 / out.gradientMagnitude) * g;
    w = Evaluate(property->GetDistinctness(), out.gradientMagnitude, 1.0);
    const bool turn =
      scene.side == Side::Lower || (scene.side == Side::Both && Dot(tip - proxy, N) < 0.0);
    N = turn ? -1.0 * N : N;
  }
  out.normal = N;

  // Material: read inside the structure, and outside of it for the drag.
  const double r = field.KernelLength();
  out.surfaceValue = field.Value(proxy + r * N);
  out.mediumValue = field.Value(proxy - r * N);
  const double k = Evaluate(property->GetStiffness(), out.surfaceValue, 500.0);
  const double mu = Evaluate(property->GetFriction(), out.surfaceValue, 0.0);
  const double T =
    Evaluate(property->GetSurfaceStrength(), out.surfaceValue, 2.0) * w * field.BorderFade(proxy);
  const double R = Evaluate(property->GetViscosity(), out.mediumValue, 0.0);
  out.stiffness = k;
  out.friction = mu;
  out.surfaceStrength = T;
  out.viscosity = R;

  if (k <= 1e-3)
  {
    out.proxy = tip;
    out.value = field.Value(tip);
    return out;
  }

  const Vec3 xTip = metres * tip;
  const Vec3 x0 = metres * proxy;
  Vec3 x = x0;

  // Eq. 12, mirrored outwards with the threshold 0.
  const double dn = Dot(xTip - x, N);
  const double threshold = dn > 0.0 ? T : 0.0;
  if (k * std::abs(dn) > threshold)
  {
    x = x + (dn > 0.0 ? 1.0 : -1.0) * (std::abs(dn) - threshold / k) * N;
  }

  // Friction, by eqs. 8 to 10.
  Vec3 d = xTip - x;
  const double fN = k * std::abs(Dot(d, N));
  const Vec3 t = d - Dot(d, N) * N;
  const double lag = Norm(t);
  out.margin = std::min({ k * std::abs(dn), std::abs(k * dn - T), std::abs(k * lag - mu * fN) });
  const bool slides = lag > 0.0 && k * lag > mu * fN;
  if (slides)
  {
    x = x + ((lag - mu * fN / k) / lag) * t;
  }
  d = xTip - x;
  out.normalForce = fN;
  out.frictionForce = k * Norm(d - Dot(d, N) * N);

  // Eq. 14: Coulomb drag towards the proxy at the beginning of the tick.
  const Vec3 b = x0 - x;
  const double back = Norm(b);
  if (R / k < back)
  {
    x = x + (R / k / back) * b;
    out.dragForce = R;
  }
  else
  {
    x = x0;
    out.dragForce = k * back;
  }

  out.force = k * (x - xTip);
  out.proxy = (1.0 / metres) * x;
  out.value = field.Value(out.proxy);
  if (dn > 0.0 && T > 0.0)
  {
    out.contact = k * dn > T ? Penetrating : (slides ? Sliding : Sticking);
  }
  return out;
}

TickRecord ForceFieldTick(
  const ReferenceField& field, Scene& scene, const Vec3& previousTip, const Vec3& tip)
{
  TickRecord out;
  out.tip = tip;
  out.proxy = tip;
  const Vec3 g = field.Gradient(tip);
  const Vec3 velocity = (scene.metersPerWorldUnit * scene.servoRate) * (tip - previousTip);
  out.force = -scene.forceFieldGain * g - scene.forceFieldDamping * velocity;
  out.normalForce = Norm(scene.forceFieldGain * g);
  out.dragForce = Norm(scene.forceFieldDamping * velocity);
  out.gradientMagnitude = Norm(g);
  out.value = field.Value(tip);
  return out;
}
} // namespace reference
