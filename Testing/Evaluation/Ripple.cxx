// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ripple.h"

#include "Shapes.h"

#include <complex>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr int Ticks = 1000;       // per turn, which takes a second
constexpr double Radius = 15.915; // mm: 0.1 mm per tick
constexpr double Depth = 2.0;     // mm below the surface

/** Returns the magnitude of the force during the second turn of a circle in a plane. */
std::vector<double> SlideOnPlane(const Candidate& candidate, bool isEdge)
{
  const Volume volume(
    [isEdge](const Vector3& x)
    {
      const double z = Dot(x - OddCentre, OddNormal);
      return isEdge ? BlurredStep(z, 1.5, 1000.0) : 100.0 * z;
    },
    { 24.0, { 1.0, 1.0, 1.0 }, ScalarType::Int16, 0.0, 1, false });
  const auto model =
    volume.Bake(TouchingOf(candidate, MakeMaterial(500.0, 0.0, 0.0, Impenetrable)));
  Path path = { OnOddCircle(Radius, 0.0) };
  for (int tick = 0; tick < 2 * Ticks; ++tick)
  {
    path.push_back(OnOddCircle(Radius, TwoPi * tick / Ticks) + Depth * OddNormal);
  }
  const Trace trace = Play(*model, path);
  std::vector<double> forces;
  for (std::size_t i = trace.size() - Ticks; i < trace.size(); ++i)
  {
    forces.push_back(Norm(trace[i].Force));
  }
  return forces;
}
} // namespace

std::vector<double> MeasureSpectrum(const Candidate& candidate, bool isEdge)
{
  const std::vector<double> forces = SlideOnPlane(candidate, isEdge);
  const int count = static_cast<int>(forces.size());
  std::vector<double> spectrum;
  for (int frequency = 0; frequency <= count / 2; ++frequency)
  {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const auto turn = static_cast<double>((static_cast<long long>(frequency) * i) % count);
      sum += forces[i] * std::polar(1.0, -TwoPi * turn / count);
    }
    // Root mean square of the spectral line together with its mirror image.
    const bool hasImage = frequency > 0 && 2 * frequency < count;
    spectrum.push_back(std::abs(sum) / count * (hasImage ? std::sqrt(2.0) : 1.0));
  }
  return spectrum;
}

Figures MeasureRipple(const Candidate& candidate, const Effort&)
{
  Figures figures;
  for (const bool isEdge : { false, true })
  {
    const std::vector<double> spectrum = MeasureSpectrum(candidate, isEdge);
    double power = 0.0;
    for (int frequency = 100; frequency <= 500; ++frequency)
    {
      power += spectrum[frequency] * spectrum[frequency];
    }
    figures.push_back({ std::string("ripple 100-500 Hz, ") + (isEdge ? "blurred edge" : "ramp"),
      "mN RMS", 1000.0 * std::sqrt(power), 1.0 });
  }
  return figures;
}

} // namespace evaluation
