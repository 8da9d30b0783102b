// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"
#include "ZWidth.h"

#include "vtkImageData.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Slope = 100.0; // value per mm
/**
 * Distance (mm) of a surface in front of the device. The device rests at about this depth (10 um)
 * and swings no further. From a longer distance, it would bounce on the wall at any stiffness.
 */
constexpr double Ahead = 1e-4;

/** Returns the theoretical limit 2 b / T. */
Curve Theory()
{
  return { "2 b / T", { 0.0, 1.0 }, { 0.0, 2000.0 }, 4 };
}
} // namespace

Table CompareStability(const Effort& effort, std::vector<Plot>& plots)
{
  Table table{ "Stability: the stiffest wall on which a device comes to rest",
    "The paper: \"The behaviour with high stiffness of surfaces is similar to the behaviour "
    "of systems using proxy-based surface haptics.\" Here a device of 0.1 kg, 1 kHz, is let "
    "go at a plane wall; entries are the stiffness (N/m) up to which it comes to rest. "
    "Theory without delay: 2 b / T. FORCE_FIELD has no wall.",
    { "damping (N s/m)", "delay (ticks)", "2 b / T" }, {} };
  const auto slab = SampleImage([](const Vector3& x) { return Slope * x.Z; }, 24.0);
  std::vector<Method> methods;
  for (const Method& method : AllMethods())
  {
    if (method.HasSurface())
    {
      methods.push_back(method);
      table.Columns.push_back(method.Name);
    }
  }
  const int points = effort.Pick(2, 10);
  for (const int delay : { 0, 1 })
  {
    Plot plot{ delay ? "zwidth-delayed" : "zwidth",
      std::string("Stiffest stable wall, 0.1 kg at 1 kHz, ") +
        (delay ? "force one tick late" : "no delay"),
      "damping (N s/m)", "stiffness (N/m)", {} };
    std::vector<std::vector<std::string>> rows;
    for (int i = 1; i <= points; ++i)
    {
      const double damping = 1.0 * i / points;
      rows.push_back({ Number(damping), std::to_string(delay), Number(2000.0 * damping) });
    }
    // Draw the first curves wider, so that they stay visible where methods agree.
    float width = 5.0f + 4.0f * static_cast<float>(methods.size() - 1);
    for (const Method& method : methods)
    {
      Scene scene(slab, Slope * (method.Offset() + Ahead));
      const WallMaker makeWall = [&](double stiffness)
      {
        scene.SetMaterial(stiffness, 0.0);
        return scene.Bake(method);
      };
      Curve curve{ method.Name, {}, {}, method.Colour, false, width };
      for (int i = 1; i <= points; ++i)
      {
        curve.X.push_back(1.0 * i / points);
        curve.Y.push_back(FindStiffestWall(makeWall, curve.X.back(), delay));
        rows[i - 1].push_back(Number(curve.Y.back()));
      }
      width -= 4.0f;
      plot.Curves.push_back(std::move(curve));
    }
    plot.Curves.push_back(Theory());
    plots.push_back(std::move(plot));
    table.Rows.insert(table.Rows.end(), rows.begin(), rows.end());
  }
  return table;
}

} // namespace evaluation
