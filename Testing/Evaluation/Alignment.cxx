// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"
#include "Shapes.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Height = 10000.0;
}

Figures MeasureAlignment(const Candidate& candidate, const Effort& effort)
{
  Figures figures;
  std::vector<double> widths = { 0.5, 1.5, 4.0 };
  if (effort.IsFull)
  {
    widths = { 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0 };
  }
  double worst = 0.0;
  for (const double width : widths)
  {
    for (const Vector3& normal : { Vector3{ 0.0, 0.0, 1.0 }, OddNormal })
    {
      const Volume volume([&](const Vector3& x)
        { return BlurredStep(Dot(x - OddCentre, normal), width, Height); },
        { 20.0, { 1.0, 1.0, 1.0 }, ScalarType::Int16, 0.0, 1, false });
      Touching touching = TouchingOf(candidate, MakeMaterial());
      // A step of one scalar unit does not count as an edge.
      const double steepest = Height / (width * std::sqrt(TwoPi));
      touching.Material.Distinctness = { { 0.05 * steepest, 0.0 }, { 0.1 * steepest, 1.0 } };
      touching.Alignment = ContactAlignment::Edge;
      const auto model = volume.Bake(touching);
      Path path = { OddCentre - 12.0 * normal };
      MoveTo(path, OddCentre + 2.0 * normal, 0.05);
      const Trace trace = Play(*model, path);
      double contact = 12.0;
      for (std::size_t i = 0; i < trace.size(); ++i)
      {
        if (Norm(trace[i].Force) > 0.01)
        {
          contact = Dot(ProxyOf(trace[i]) - OddCentre, normal);
          break;
        }
      }
      worst = std::max(worst, std::abs(contact));
    }
  }
  figures.push_back(
    { "alignment Edge, first contact to the steepest point, worst", "voxel", worst, 0.1 });
  return figures;
}

} // namespace evaluation
