// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"
#include "Shapes.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Height = 1000.0;
constexpr double Blur = 1.0;    // mm, scale of the wall's edge
constexpr double Fastest = 3.0; // mm per tick, which is 3 m/s

/**
 * Returns a material that reaches its full strength at half of the steepest gradient, 1.18 mm in
 * front of the edge's middle.
 */
HapticMaterial WallMaterial()
{
  HapticMaterial material = MakeMaterial();
  const double steepest = Height / (Blur * std::sqrt(TwoPi));
  material.Distinctness = { { 0.1 * steepest, 0.0 }, { 0.5 * steepest, 1.0 } };
  return material;
}
constexpr double WholeFrom = -1.18;
/**
 * Returns the position where the wall reaches its full strength; with alignment Edge, this is the
 * edge's middle.
 */
double ComputeWhole(const HapticModel& model)
{
  return model.Baked->Settings.Alignment == ContactAlignment::Edge ? 0.0 : WholeFrom;
}
/**
 * Largest depth (mm) behind the position of full strength: 90 % of T_N/k, where the wall must still
 * resist.
 */
constexpr double Deepest = 0.9 * 4.0;
/**
 * A proxy that is more than this distance (mm) behind its rest position counts as fallen through.
 */
constexpr double Through = 0.3;

/**
 * Moves a tip into the wall, lets it rest, and slides it, all at random. Returns whether the proxy
 * falls through.
 */
bool FallsThrough(const HapticModel& model, std::mt19937& random)
{
  Uniform uniform(random);
  const double whole = ComputeWhole(model);
  const Vector3& u = OddAside;
  const Vector3& v = OddUp;
  Path path = { uniform(-8.0, 8.0) * u + uniform(-8.0, 8.0) * v + uniform(-8.0, -5.0) * OddNormal };
  const double speed = uniform(0.0, 1.0) * uniform(0.0, 1.0) * (Fastest - 0.2) + 0.2;
  const Vector3 goal =
    uniform(-8.0, 8.0) * u + uniform(-8.0, 8.0) * v + uniform(0.0, whole + Deepest) * OddNormal;
  MoveTo(path, goal, speed);
  path.push_back(goal);
  MoveTo(path, goal + uniform(-6.0, 6.0) * u + uniform(-6.0, 6.0) * v, Fastest);

  ServoState state;
  TickRecord tick;
  for (const Vector3& tip : path)
  {
    Tick(model, state, 0.001 * tip, tick);
    if (Dot(ProxyOf(tick), OddNormal) > whole + Through)
    {
      return true;
    }
  }
  return false;
}
} // namespace

Figures MeasureFallThrough(const Candidate& candidate, const Effort& effort)
{
  // Use a thick wall, and a plate so thin that the blurred edges of its two sides merge.
  const std::pair<const char*, double> walls[] = { { "thick wall", 1e9 }, { "plate", 2.0 } };
  Figures figures;
  const int crossings = effort.Pick(5000, 500000);
  for (const auto& [name, thickness] : walls)
  {
    const double end = thickness;
    const Volume volume(
      [end](const Vector3& x)
      {
        const double z = Dot(x, OddNormal);
        return BlurredStep(z, Blur, Height) - BlurredStep(z - end, Blur, Height);
      },
      { 20.0, { 1.0, 1.0, 1.0 }, ScalarType::Int16, 0.0, 1, false });
    const auto model = volume.Bake(TouchingOf(candidate, WallMaterial()));
    std::mt19937 random(7);
    int fallen = 0;
    for (int i = 0; i < crossings; ++i)
    {
      fallen += FallsThrough(*model, random) ? 1 : 0;
    }
    figures.push_back({ std::string("fall-throughs below T_N, ") + name + ", " +
        std::to_string(crossings) + " crossings up to 3 m/s",
      "", static_cast<double>(fallen), 0.0 });
  }
  return figures;
}

} // namespace evaluation
