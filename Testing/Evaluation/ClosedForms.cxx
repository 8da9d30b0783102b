// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedForms.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
double Slab(const Vector3& x)
{
  return 100.0 * x.Z;
}

double Uniform(const Vector3&)
{
  return 100.0;
}

double GrowingSlope(const Vector3& x)
{
  return 0.5 * x.Z * x.Z;
}

double Ball(const Vector3& x)
{
  return -0.5 * Dot(x, x);
}

double Cavity(const Vector3& x)
{
  return 0.5 * Dot(x, x);
}

Vector3 OnCircle(double radius, double angle)
{
  return { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
}

/**
 * The position where slabs are touched. It is between voxels, so that all taps of the kernel have a
 * weight.
 */
constexpr Vector3 Start = { 0.3, 0.2, 0.0 };
constexpr double Step = 0.1; // mm

Form Push()
{
  // T1 and T2: press 10 mm deep and return.
  Form form{ "T1, T2", Slab, MakeMaterial(), { Start }, {} };
  for (const double depth : { 10.0, 0.0 })
  {
    MoveTo(form.Tips, { Start.X, Start.Y, depth }, Step);
  }
  double proxy = 0.0;
  for (const Vector3& tip : form.Tips)
  {
    proxy = std::clamp(proxy, tip.Z - 4.0, tip.Z);
    form.Forces.push_back({ 0.0, 0.0, 0.5 * (proxy - tip.Z) });
  }
  return form;
}

Form PushWithDrag()
{
  // T3: the surface resists inwards with 2 N; the drag resists in both directions with 0.5 N.
  Form form{ "T3", Slab, MakeMaterial(500.0, 0.0, 0.5), { Start }, {} };
  for (const double depth : { 10.0, 0.0 })
  {
    MoveTo(form.Tips, { Start.X, Start.Y, depth }, Step);
  }
  double proxy = 0.0;
  for (const Vector3& tip : form.Tips)
  {
    proxy = std::clamp(proxy, tip.Z - 5.0, tip.Z + 1.0);
    form.Forces.push_back({ 0.0, 0.0, 0.5 * (proxy - tip.Z) });
  }
  return form;
}

Form Friction()
{
  // T4 and T5 at a depth of 3 mm.
  Form form{ "T4, T5", Slab, MakeMaterial(500.0, 0.4), { Start }, {} };
  MoveTo(form.Tips, { Start.X, Start.Y, 3.0 }, Step);
  MoveTo(form.Tips, { Start.X + 10.0, Start.Y, 3.0 }, Step);
  MoveTo(form.Tips, { Start.X, Start.Y, 3.0 }, Step);
  double proxy = Start.X;
  for (const Vector3& tip : form.Tips)
  {
    const double most = 0.4 * tip.Z;
    proxy = std::clamp(proxy, tip.X - most, tip.X + most);
    form.Forces.push_back({ 0.5 * (proxy - tip.X), 0.0, -0.5 * tip.Z });
  }
  return form;
}

Form Tractrix()
{
  // T6 and T7: the angle psi between the lag and the motion decreases as tan(psi / 2) = exp(-s /
  // a).
  Form form{ "T6, T7", Uniform, MakeMaterial(500.0, 0.0, 0.5), { Start }, {} };
  MoveTo(form.Tips, { Start.X, Start.Y, 3.0 }, Step);
  const std::size_t corner = form.Tips.size();
  MoveTo(form.Tips, { Start.X + 3.0, Start.Y, 3.0 }, Step);
  for (std::size_t i = 0; i < form.Tips.size(); ++i)
  {
    const Vector3& tip = form.Tips[i];
    const double s = i < corner ? 0.0 : tip.X - Start.X;
    const Vector3 lag = i < corner ? Vector3{ 0.0, 0.0, std::min(1.0, tip.Z) }
                                   : Vector3{ std::tanh(s), 0.0, 1.0 / std::cosh(s) };
    form.Forces.push_back(-0.5 * lag);
  }
  return form;
}

HapticMaterial Distinct()
{
  HapticMaterial material = MakeMaterial();
  material.Distinctness = { { 0.0, 0.0 }, { 4.0, 1.0 } };
  return material;
}

Form TwoSprings(bool jumps)
{
  // T8, and T9 in one tick: 500 N/m in series with 500 N/m, up to 2 N. From a depth of 4 mm
  // onwards, neither the kernel nor the proxy's look-ahead reaches the field's lowest point. A
  // growing slope is the foot of an edge; with alignment Edge, the surface begins only in the
  // edge's middle.
  Form form{ jumps ? "T9" : "T8", GrowingSlope, Distinct(), { { Start.X, Start.Y, 0.0 } }, {} };
  form.IsOfThePaper = true;
  if (jumps)
  {
    form.Tips.push_back({ Start.X, Start.Y, 4.0 });
    form.Tips.push_back({ Start.X, Start.Y, 4.0 });
  }
  else
  {
    MoveTo(form.Tips, { Start.X, Start.Y, 10.0 }, Step);
  }
  for (const Vector3& tip : form.Tips)
  {
    form.Forces.push_back({ 0.0, 0.0, -std::min(2.0, 0.25 * tip.Z) });
  }
  return form;
}

Form Round(
  const char* name, const Field& field, double radius, double friction, int ticks, int turns)
{
  // T10 to T12: the proxy stays at a radius of 20 mm. With friction, it lags by asin(20/rho sin
  // phi) - phi after the first quarter of a turn.
  Form form{ name, field, MakeMaterial(500.0, friction, 0.0, Impenetrable), { OnCircle(20.0, 0.0) },
    { Vector3{} } };
  const double phi = std::atan(friction);
  const double lag = std::asin(20.0 / radius * std::sin(phi)) - phi;
  constexpr double twoPi = 6.283185307179586;
  for (int tick = 0; tick <= ticks * turns; ++tick)
  {
    const double angle = twoPi * tick / ticks;
    form.Tips.push_back(OnCircle(radius, angle));
    form.Forces.push_back(0.5 * (OnCircle(20.0, angle - lag) - form.Tips.back()));
  }
  form.FirstJudged = friction > 0.0 ? ticks / 4 : 0;
  return form;
}

Form DeepCavity()
{
  // T13: the proxy rests at the nearest point of the wall. The way to the far side is longer than
  // the radius.
  Form form{ "T13", Cavity, MakeMaterial(500.0, 0.0, 0.0, Impenetrable), { OnCircle(5.0, 0.0) },
    { Vector3{} } };
  form.IsOfThePaper = true;
  for (int tick = 0; tick < 12; ++tick)
  {
    form.Tips.push_back(OnCircle(12.0, 0.01));
    form.Forces.push_back(0.5 * (OnCircle(5.0, 0.01) - form.Tips.back()));
  }
  form.FirstJudged = 3;
  return form;
}

} // namespace

std::vector<Form> MakeForms(const Effort& effort)
{
  const int turns = effort.Pick(1, 8);
  return { Push(), PushWithDrag(), Friction(), Tractrix(), TwoSprings(false), TwoSprings(true),
    Round("T10", Ball, 18.0, 0.0, 1000, turns), Round("T11", Cavity, 22.0, 0.0, 1257, turns),
    Round("T12", Ball, 18.0, 0.3, 10000, 1), DeepCavity() };
}

ForceError Compare(const Form& form, const Volume& volume, const Candidate& candidate)
{
  const Candidate who = form.IsOfThePaper ? PlacedAsThePaper(candidate) : candidate;
  const auto model = volume.Bake(TouchingOf(who, form.Material));
  const Trace trace = Play(*model, form.Tips);
  double largest = 0.0;
  double sum = 0.0;
  ForceError error;
  std::size_t judged = 0;
  for (std::size_t i = form.FirstJudged; i < trace.size(); ++i)
  {
    const Vector3 wrong = trace[i].Force - form.Forces[i];
    largest = std::max(largest, Norm(form.Forces[i]));
    error.Worst = std::max(error.Worst, Norm(wrong));
    sum += Dot(wrong, wrong);
    ++judged;
  }
  error.RootMeanSquare = std::sqrt(sum / static_cast<double>(judged)) / largest;
  error.Worst /= largest;
  return error;
}

Figures MeasureClosedForms(const Candidate& candidate, const Effort& effort)
{
  std::vector<Sampling> samplings(1);
  samplings[0].Spacing = { 0.5, 0.5, 0.5 };
  if (effort.IsFull)
  {
    samplings.push_back(samplings[0]);
    samplings.back().IsTurned = true;
    samplings.push_back(samplings[0]);
    samplings.back().Type = ScalarType::Float32;
    samplings.push_back(samplings[0]);
    samplings.back().Spacing = { 0.5, 0.5, 1.0 };
  }
  Figures figures;
  for (const Form& form : MakeForms(effort))
  {
    ForceError worst;
    for (const Sampling& sampling : samplings)
    {
      const ForceError error = Compare(form, Volume(form.TheField, sampling), candidate);
      worst.RootMeanSquare = std::max(worst.RootMeanSquare, error.RootMeanSquare);
      worst.Worst = std::max(worst.Worst, error.Worst);
    }
    const std::string name = form.Name + (form.IsOfThePaper ? " (Distinctness, Kernel)" : "");
    figures.push_back({ name + ", force RMS", "%", 100.0 * worst.RootMeanSquare, 0.2 });
    figures.push_back({ name + ", force worst", "%", 100.0 * worst.Worst, 1.0 });
  }
  return figures;
}

} // namespace evaluation
