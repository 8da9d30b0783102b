// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Likeness.h"
#include "Shapes.h"
#include "SmoothedVolume.h"

#include "vtkImageData.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Height = 1000.0;
constexpr double Blur = 1.5;       // mm, scale of the edges
constexpr double Depth = 1.5;      // mm below the surface
constexpr double PressStep = 0.02; // mm per tick
constexpr double SlideStep = 0.1;  // mm per tick
constexpr double Radius = 20.0;    // mm, of ball and cavity
constexpr double HalfWidth = 14.0; // mm, half of the bar's width
constexpr double Rounding = 4.0;   // mm, radius of the bar's edges

Stroke PressAt(const Vector3& start, const Vector3& outward)
{
  Stroke stroke{ start, outward, { start }, 0 };
  MoveTo(stroke.Tips, start - Depth * outward, PressStep);
  stroke.Pressed = stroke.Tips.size();
  return stroke;
}

/** Returns a stroke through half a turn of the circle about OddCentre with radius `tip`. */
Stroke SlideRound(double surface, double tip)
{
  const double sign = surface > tip ? 1.0 : -1.0;
  Stroke stroke = PressAt(OnOddCircle(surface, 0.0), sign * OddAside);
  const int ticks = static_cast<int>(0.5 * TwoPi * tip / SlideStep);
  for (int i = 1; i <= ticks; ++i)
  {
    stroke.Tips.push_back(OnOddCircle(tip, i * SlideStep / tip));
  }
  return stroke;
}

Stroke SlideOnPlane()
{
  constexpr double radius = 8.0;
  Stroke stroke = PressAt(OnOddCircle(radius, 0.0), -1.0 * OddNormal);
  for (double angle = 0.0; angle < TwoPi; angle += SlideStep / radius)
  {
    stroke.Tips.push_back(OnOddCircle(radius, angle) + Depth * OddNormal);
  }
  return stroke;
}

/** Returns the depth (mm) inside an infinitely long bar along OddNormal. */
double InsideBar(const Vector3& x)
{
  const double u = std::abs(Dot(x - OddCentre, OddAside)) - (HalfWidth - Rounding);
  const double v = std::abs(Dot(x - OddCentre, OddUp)) - (HalfWidth - Rounding);
  const double outside = std::hypot(std::max(u, 0.0), std::max(v, 0.0));
  return Rounding - outside - std::min(std::max(u, v), 0.0);
}

/** Returns a stroke from the middle of one side around an edge to the middle of the next side. */
Stroke SlideOverEdge()
{
  const auto at = [](double u, double v) { return OddCentre + u * OddAside + v * OddUp; };
  Stroke stroke = PressAt(at(HalfWidth, 0.0), OddAside);
  constexpr double flat = HalfWidth - Rounding;
  constexpr double tip = Rounding - Depth;
  MoveTo(stroke.Tips, at(flat + tip, flat), SlideStep);
  for (double angle = 0.0; angle < 0.25 * TwoPi; angle += SlideStep / tip)
  {
    stroke.Tips.push_back(at(flat + tip * std::cos(angle), flat + tip * std::sin(angle)));
  }
  MoveTo(stroke.Tips, at(0.0, flat + tip), SlideStep);
  return stroke;
}

Subject MakeSubject(const char* name, const Field& inside, Stroke stroke)
{
  const auto image =
    SampleImage([&](const Vector3& x) { return BlurredStep(inside(x), Blur, Height); }, 26.0);
  Subject subject{ name, std::make_unique<Scene>(image, 0.5 * Height), {}, inside };
  subject.Strokes.push_back(std::move(stroke));
  return subject;
}

/** Returns the smoothed volume, and its isosurface through the first contact. */
Subject MakeSmoothed(const char* name, const Field& inside, Stroke stroke)
{
  const auto image =
    SampleImage([&](const Vector3& x) { return BlurredStep(inside(x), Blur, Height); }, 26.0);
  const SmoothedVolume smoothed(image);
  const double level = smoothed.Value(stroke.Start);
  Subject subject{ name, std::make_unique<Scene>(image, level, smoothed.ComputeSurface(level)), {},
    smoothed.Off(level) };
  subject.Strokes.push_back(std::move(stroke));
  return subject;
}
} // namespace

std::vector<Subject> MakeShapes()
{
  const Field plane = [](const Vector3& x) { return Dot(x - OddCentre, OddNormal); };
  const Field ball = [](const Vector3& x) { return Radius - Norm(x - OddCentre); };
  const Field cavity = [](const Vector3& x) { return Norm(x - OddCentre) - Radius; };
  std::vector<Subject> shapes;
  shapes.push_back(MakeSubject("plane", plane, SlideOnPlane()));
  shapes.push_back(MakeSubject("ball, 20 mm", ball, SlideRound(Radius, Radius - Depth)));
  shapes.push_back(MakeSubject("cavity, 20 mm", cavity, SlideRound(Radius, Radius + Depth)));
  shapes.push_back(MakeSubject("edge rounded by 4 mm", InsideBar, SlideOverEdge()));
  shapes.push_back(MakeSmoothed("the same edge, smoothed", InsideBar, SlideOverEdge()));
  return shapes;
}

} // namespace evaluation
