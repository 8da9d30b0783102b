// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angle.h"
#include "Shapes.h"
#include "Tracking.h"

using namespace VolumeHaptics;

namespace evaluation
{

std::vector<double> MeasureAngles(const Candidate& candidate)
{
  const Volume volume([](const Vector3& x)
    { return BlurredStep(SphereRadius - Norm(x - OddCentre), 1.5, 250.0); },
    { 27.0, { 1.0, 1.0, 1.0 }, ScalarType::UInt8, 0.0, 1, false });
  const auto model =
    volume.Bake(TouchingOf(candidate, MakeMaterial(500.0, 0.0, 0.0, Impenetrable)));
  // Descend from the pole in a narrow spiral, 0.1 mm per tick.
  Path path = { OddCentre + Vector3{ 0.0, 0.0, SphereRadius } };
  constexpr double depth = 2.0;
  constexpr double pitch = 0.02; // polar angle per turn, over 2 pi
  double around = 0.0;
  for (double polar = 0.0; polar < 0.25 * TwoPi; polar = pitch * around)
  {
    const Vector3 outward = { std::sin(polar) * std::cos(around),
      std::sin(polar) * std::sin(around), std::cos(polar) };
    path.push_back(OddCentre + (SphereRadius - depth) * outward);
    around += 0.1 / (SphereRadius - depth) / std::hypot(std::sin(polar), pitch);
  }
  std::vector<double> angles;
  const Trace trace = Play(*model, path);
  for (std::size_t i = 2; i < trace.size(); ++i)
  {
    const Vector3 outward = path[i] - OddCentre;
    const Vector3& force = trace[i].Force;
    const double across = Norm(Cross(force, outward));
    angles.push_back(360.0 / TwoPi * std::atan2(across, Dot(force, outward)));
  }
  return angles;
}

Figures MeasureAngle(const Candidate& candidate, const Effort&)
{
  const std::vector<double> angles = MeasureAngles(candidate);
  double sum = 0.0;
  for (const double angle : angles)
  {
    sum += angle;
  }
  return { { "angle to the true normal, 8-bit sphere, 2 voxels deep, mean", "degree",
    sum / static_cast<double>(angles.size()), 0.3 } };
}

} // namespace evaluation
