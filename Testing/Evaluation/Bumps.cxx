// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"
#include "Shapes.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Radius = 90.0; // mm
/** The centre of the touched patch. */
const Vector3 Pole = Radius * OddNormal;

/** Returns the approximate depth (mm) of a position below the ball's surface; negative outside. */
double Height(const Vector3& x)
{
  return Radius + 2.0 * std::sin(x.X / 5.0) * std::cos(x.Y / 6.0) - Norm(x);
}

/** Returns the gradient of Height(). */
Vector3 Inward(const Vector3& x)
{
  const Vector3 bump = { 0.4 * std::cos(x.X / 5.0) * std::cos(x.Y / 6.0),
    -2.0 / 6.0 * std::sin(x.X / 5.0) * std::sin(x.Y / 6.0), 0.0 };
  return bump - (1.0 / Norm(x)) * x;
}

/** Returns the point at a depth (mm) below the surface in a direction from the centre. */
Vector3 Beneath(const Vector3& direction, double depth)
{
  Vector3 x = (Radius / Norm(direction)) * direction;
  for (int i = 0; i < 20; ++i)
  {
    x = ((Norm(x) + Height(x)) / Norm(direction)) * direction;
  }
  const Vector3 n = Inward(x);
  return x + (depth / Norm(n)) * n;
}
} // namespace

Figures MeasureBumps(const Candidate& candidate, const Effort& effort)
{
  const Volume volume([](const Vector3& x)
    { return 100.0 * (1.0 + std::tanh(0.5 * Height(x + Pole))); },
    { 24.0, { 1.0, 1.0, 1.0 }, ScalarType::Float32, 0.0, 1, false });
  Touching touching = TouchingOf(candidate, MakeMaterial());
  touching.Alignment = ContactAlignment::Edge;
  const auto model = volume.Bake(touching);
  double angles = 0.0;
  double distances = 0.0;
  int ticks = 0;
  for (int stroke = 0; stroke < effort.Pick(2, 12); ++stroke)
  {
    const double turn = TwoPi * stroke / 12.0;
    const Vector3 along = std::cos(turn) * OddAside + std::sin(turn) * OddUp;
    const Vector3 start = Pole - 14.0 * along;
    Path path = { Beneath(start, -6.0) - Pole };
    MoveTo(path, Beneath(start, 2.0) - Pole, 0.05);
    const std::size_t pressed = path.size();
    for (double way = 0.05; way < 28.0; way += 0.05)
    {
      path.push_back(Beneath(start + way * along, 2.0) - Pole);
    }
    const Trace trace = Play(*model, path);
    for (std::size_t i = pressed; i < trace.size(); ++i)
    {
      const Vector3 proxy = ProxyOf(trace[i]) + Pole;
      const Vector3 n = Inward(proxy);
      const double force = Norm(trace[i].Force);
      const double cosine = force > 0.0 ? -Dot(trace[i].Force, n) / (force * Norm(n)) : -1.0;
      angles += 360.0 / TwoPi * std::acos(std::min(1.0, cosine));
      distances += std::abs(Height(proxy)) / Norm(n);
      ++ticks;
    }
  }
  return { { "bumpy ball, alignment Edge, proxy to the surface, mean", "voxel", distances / ticks,
             0.2 },
    { "bumpy ball, alignment Edge, force to the normal, mean", "degree", angles / ticks, 0.5 } };
}

} // namespace evaluation
