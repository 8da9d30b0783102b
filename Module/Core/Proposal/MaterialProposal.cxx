// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Proposal/MaterialProposal.h"

#include "Core/Math/PolylineMask.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{
/**
 * Boundaries matter if their area times rise is at least this fraction of the sum over all
 * boundaries.
 */
constexpr double LeastSalience = 0.03;
constexpr double Salient = 0.1;
/** Values that are closer than this fraction of the axis belong to one material. */
constexpr double MergeFraction = 0.06;
// Distinctness is 0 up to this fraction of the weakest boundary's slope.
constexpr double StartFraction = 0.2;
constexpr double FullFraction = 0.5; // distinctness is 1 from this fraction of the same slope on
/**
 * The strength rises over this fraction of the gap between the end of a noisy background and the
 * next material.
 */
constexpr double EmptyFraction = 0.15;
/** A boundary is felt if the noise is below this fraction of its slope. */
constexpr double NoiseFraction = 0.4;
/** The functions are constant around a material, over this fraction of the gap to the next one. */
constexpr double ConstantFraction = 0.2;
/**
 * Kernel radius divided by the width (standard deviation) of a boundary. Two widths behind the
 * boundary's middle, V has completed 97.7 % of its rise to the material's value.
 */
constexpr double RadiusPerWidth = 2.0;
constexpr int LeastRadius = 2;
constexpr int LargestRadius = 5; // larger radii smear thin parts and take long
/**
 * Limits of the fraction of lines whose values rise inward. Below DarkInside, the darker side
 * counts as the inside; above BrightInside, the brighter side does. Searching from only one side
 * would miss a boundary seen from the other.
 */
constexpr double DarkInside = 1.0 / 3.0;
constexpr double BrightInside = 2.0 / 3.0;
/**
 * Standard deviation per radius of an uncut Gaussian that blurs like the kernel (GradientKernel.h).
 */
constexpr double BlurPerRadius = 0.5;
constexpr double Friction[2] = { 0.1, 0.4 };
constexpr double Viscosity[2] = { 0.1, 0.4 }; // N

double Salience(const Boundary& boundary)
{
  return boundary.Fraction * (boundary.High - boundary.Low);
}

/**
 * Returns the largest slope (per world unit) of a boundary, as a kernel with the given radius
 * estimates it.
 */
double FeltSlope(const Boundary& boundary, int radius, double searchVariance)
{
  const double scale = BlurPerRadius * radius;
  const double blur = boundary.Blur * scale * scale / searchVariance;
  constexpr double rootTwoPi = 2.5066282746310002;
  return boundary.LeastRise / (rootTwoPi * std::sqrt(boundary.Width * boundary.Width + blur));
}

/** Returns the boundaries that matter, sorted by area times rise, the largest first. */
std::vector<Boundary> KeepSalient(const std::vector<Boundary>& all)
{
  double total = 0.0;
  for (const Boundary& boundary : all)
  {
    total += Salience(boundary);
  }
  std::vector<Boundary> kept;
  for (const Boundary& boundary : all)
  {
    if (Salience(boundary) >= LeastSalience * total)
    {
      kept.push_back(boundary);
    }
  }
  std::sort(kept.begin(), kept.end(),
    [](const Boundary& a, const Boundary& b) { return Salience(a) > Salience(b); });
  return kept;
}

/**
 * Returns the values of the materials, that is, of both sides of all boundaries. Close values are
 * merged into one material, and so are all values in the background.
 */
std::vector<double> MergeEnds(
  const std::vector<Boundary>& boundaries, const ValueAxis& axis, const ProposalFacts& facts)
{
  struct End
  {
    double Value;
    double Weight;
  };
  std::vector<End> ends;
  for (const Boundary& boundary : boundaries)
  {
    ends.push_back({ boundary.Low, Salience(boundary) });
    ends.push_back({ boundary.High, Salience(boundary) });
  }
  const auto byValue = [](const End& a, const End& b) { return a.Value < b.Value; };
  std::sort(ends.begin(), ends.end(), byValue);
  while (ends.size() > 1)
  {
    std::size_t closest = 0;
    const auto gap = [&](std::size_t i)
    {
      const double below = ends[i].Value;
      const double above = ends[i + 1].Value;
      return facts.Covers(below) && facts.Covers(above) ? 0.0 : axis(above) - axis(below);
    };
    for (std::size_t i = 1; i + 1 < ends.size(); ++i)
    {
      closest = gap(i) < gap(closest) ? i : closest;
    }
    if (gap(closest) > MergeFraction * axis.Span())
    {
      break;
    }
    End& one = ends[closest];
    const End& other = ends[closest + 1];
    const double weight = one.Weight + other.Weight;
    one = { (one.Weight * one.Value + other.Weight * other.Value) / weight, weight };
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(closest) + 1);
  }
  std::vector<double> values;
  values.reserve(ends.size());
  for (const End& end : ends)
  {
    values.push_back(end.Value);
  }
  return values;
}

std::size_t FindNearest(const std::vector<double>& values, const ValueAxis& axis, double value)
{
  const auto distance = [&](double other) { return std::abs(axis(other) - axis(value)); };
  const auto nearest = std::min_element(
    values.begin(), values.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - values.begin());
}

/** The indices of the materials on both sides of a boundary. */
struct Sides
{
  std::size_t Low;
  std::size_t High;
};

ProposedSide ChooseSide(const MaterialProposal& proposal, const std::vector<Sides>& sides)
{
  const std::size_t last = proposal.Materials.size() - 1;
  bool isMixed = false;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const double inward = proposal.Boundaries[i].Inward;
    isMixed = isMixed || (proposal.Background == 0 && inward < DarkInside && sides[i].Low != 0) ||
      (proposal.Background == last && inward > BrightInside && sides[i].High != last);
  }
  if (isMixed || (proposal.Background > 0 && proposal.Background < last))
  {
    return ProposedSide::Both;
  }
  return proposal.Background == 0 ? ProposedSide::Higher : ProposedSide::Lower;
}

/** Makes a function that is constant around each material, and blended in between. */
Polyline Blend(const std::vector<double>& values, const std::vector<double>& quantity)
{
  Polyline line;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double below = i > 0 ? values[i] - values[i - 1] : 0.0;
    const double above = i + 1 < values.size() ? values[i + 1] - values[i] : 0.0;
    line.push_back({ values[i] - ConstantFraction * (i > 0 ? below : above), quantity[i] });
    line.push_back(
      { values[i] + ConstantFraction * (i + 1 < values.size() ? above : below), quantity[i] });
  }
  return line;
}

std::vector<double> ChooseStrengths(
  const MaterialProposal& proposal, const std::vector<Sides>& sides)
{
  const std::size_t count = proposal.Materials.size();
  const bool down = proposal.Side == ProposedSide::Lower;
  std::vector<double> rise(count, 0.0); // largest rise of the boundaries into a material
  // isLast: no other material is behind this one. isBehind: a material other than the background is
  // in front of it, or there are only two materials. Only a material with both gets the Ceiling,
  // because a material that is met directly from outside may hide others.
  std::vector<bool> isLast(count, proposal.Side != ProposedSide::Both);
  std::vector<bool> isBehind(count, count == 2);
  double largest = 0.0;
  double smallest = 0.0;
  for (const Sides& side : sides)
  {
    const std::size_t into = down ? side.Low : side.High;
    const std::size_t from = down ? side.High : side.Low;
    const double height = proposal.Materials[side.High] - proposal.Materials[side.Low];
    rise[into] = std::max(rise[into], height);
    isLast[from] = false;
    isBehind[into] = isBehind[into] || from != proposal.Background;
    if (proposal.Side == ProposedSide::Both)
    {
      rise[from] = std::max(rise[from], height);
    }
    largest = std::max(largest, height);
    smallest = smallest > 0.0 ? std::min(smallest, height) : height;
  }
  std::vector<double> strength(count);
  std::size_t strongest = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    strength[i] = MaterialProposal::Strongest * (rise[i] > 0.0 ? rise[i] : smallest) / largest;
    if (isLast[i] && isBehind[i] && (strongest == count || rise[i] > rise[strongest]))
    {
      strongest = i;
    }
  }
  if (strongest < count)
  {
    strength[strongest] = MaterialProposal::Ceiling;
  }
  strength[proposal.Background] = 0.0;
  return strength;
}

/** Returns the polyline f(-x) of a polyline f(x). */
Polyline Mirror(const Polyline& line)
{
  Polyline mirrored;
  for (auto vertex = line.rbegin(); vertex != line.rend(); ++vertex)
  {
    mirrored.push_back({ -vertex->X, vertex->Y });
  }
  return mirrored;
}

/**
 * Removes strength, friction and drag from a noisy background, where the blends between materials
 * would be felt.
 */
void EmptyBackground(MaterialProposal& proposal, const ProposalFacts& facts)
{
  const std::vector<double>& values = proposal.Materials;
  const double outside = values[proposal.Background];
  if (!facts.Covers(outside) || proposal.Side == ProposedSide::Both)
  {
    return;
  }
  const bool isDark = proposal.Side == ProposedSide::Higher;
  const double end = *facts.BackgroundEnd;
  const double next = isDark ? values[1] : values[values.size() - 2];
  const double rise = EmptyFraction * (next - end);
  const double full = end + rise;
  const double constant = next - ConstantFraction * (next - outside); // begin of the next material
  const auto empty = [&](Polyline& line, double from, double to)
  { line = isDark ? CutBelow(line, from, to) : Mirror(CutBelow(Mirror(line), -from, -to)); };
  empty(proposal.SurfaceStrength, end + 0.5 * rise, full);
  empty(proposal.Friction, end, full);
  // Move the rise of the drag, too. Otherwise a small, dim material would drag a hand as much as a
  // large one does.
  empty(proposal.Viscosity, full,
    isDark ? std::max(constant, full + rise) : std::min(constant, full + rise));
}

void FillFunctions(MaterialProposal& proposal, const std::vector<Sides>& sides)
{
  const std::size_t count = proposal.Materials.size();
  std::vector<double> friction(count), viscosity(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    friction[i] = Friction[0] + share * (Friction[1] - Friction[0]);
    viscosity[i] = Viscosity[0] + share * (Viscosity[1] - Viscosity[0]);
  }
  friction[proposal.Background] = 0.0;
  viscosity[proposal.Background] = 0.0;
  proposal.SurfaceStrength = Blend(proposal.Materials, ChooseStrengths(proposal, sides));
  proposal.Friction = Blend(proposal.Materials, friction);
  proposal.Viscosity = Blend(proposal.Materials, viscosity);
}

int ChooseRadius(const std::vector<Boundary>& boundaries, const ProposalFacts& facts)
{
  double total = 0.0;
  for (const Boundary& boundary : boundaries)
  {
    total += Salience(boundary);
  }
  double width = 0.0; // width of the widest salient boundary, in voxels along its lines
  for (const Boundary& boundary : boundaries)
  {
    const double voxels = boundary.Width / boundary.Voxel;
    width = Salience(boundary) >= Salient * total ? std::max(width, voxels) : width;
  }
  const double radius = std::ceil(RadiusPerWidth * width);
  const int wanted = static_cast<int>(std::clamp<double>(radius, LeastRadius, LargestRadius));
  return std::max(1, std::min(wanted, facts.MostRadius));
}

} // namespace

//------------------------------------------------------------------------------
bool ProposalFacts::Covers(double value) const noexcept
{
  if (!this->BackgroundEnd)
  {
    return false;
  }
  const double end = *this->BackgroundEnd;
  return this->Outside <= end ? value <= end : value >= end;
}

//------------------------------------------------------------------------------
MaterialProposal ProposeMaterials(
  const std::vector<Boundary>& boundaries, const ValueAxis& axis, const ProposalFacts& facts)
{
  MaterialProposal proposal;
  std::vector<Boundary> salient = KeepSalient(boundaries);
  proposal.KernelRadius = ChooseRadius(salient, facts);
  const double noise = facts.NoiseGradient(proposal.KernelRadius);
  const auto slope = [&](const Boundary& boundary)
  { return FeltSlope(boundary, proposal.KernelRadius, facts.SearchVariance); };
  const auto isNoise = [&](const Boundary& boundary)
  { return noise > NoiseFraction * slope(boundary); };
  salient.erase(std::remove_if(salient.begin(), salient.end(), isNoise), salient.end());
  if (salient.empty())
  {
    return proposal;
  }
  proposal.Materials = MergeEnds(salient, axis, facts);
  proposal.Background = FindNearest(proposal.Materials, axis, facts.Outside);
  std::vector<Sides> sides;
  double weakest = slope(salient.front());
  for (const Boundary& boundary : salient)
  {
    const std::size_t low = FindNearest(proposal.Materials, axis, boundary.Low);
    const std::size_t high = FindNearest(proposal.Materials, axis, boundary.High);
    if (low != high)
    {
      sides.push_back({ low, high });
      proposal.Boundaries.push_back(boundary);
      proposal.Slopes.push_back(slope(boundary));
      weakest = std::min(weakest, slope(boundary));
    }
  }
  if (proposal.Boundaries.empty())
  {
    return proposal;
  }
  proposal.Side = ChooseSide(proposal, sides);
  FillFunctions(proposal, sides);
  EmptyBackground(proposal, facts);
  proposal.Distinctness = { { std::max(noise, StartFraction * weakest), 0.0 },
    { FullFraction * weakest, 1.0 } };
  return proposal;
}

} // namespace VolumeHaptics
