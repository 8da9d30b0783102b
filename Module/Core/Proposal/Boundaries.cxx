// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Proposal/Boundaries.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace VolumeHaptics
{
namespace
{
constexpr int Bins = 128;
constexpr int Cells = Bins * Bins;
constexpr double BlurBins = 3.0; // standard deviation (bins) of the blur of the histogram
/**
 * Two peaks are merged if the saddle between them is higher than this fraction of the lower peak.
 */
constexpr double SaddleFraction = 0.6;
constexpr double LeastFraction = 0.02;
constexpr std::size_t LeastLines = 8;
/** The axis is logarithmic above this fraction of the largest value. */
constexpr double LinearFraction = 0.05;
constexpr double NoiseReach = 4.0; // reach of noise in standard deviations

using Histogram = std::vector<double>;

struct Weighted
{
  double Value;
  double Weight;
};

/** Returns the value below which the given fraction of the total weight lies. */
double Quantile(std::vector<Weighted> values, double fraction)
{
  std::sort(values.begin(), values.end(),
    [](const Weighted& a, const Weighted& b) { return a.Value < b.Value; });
  double left = 0.0;
  for (const Weighted& value : values)
  {
    left += fraction * value.Weight;
  }
  for (const Weighted& value : values)
  {
    left -= value.Weight;
    if (left <= 0.0)
    {
      return value.Value;
    }
  }
  return values.back().Value;
}

/**
 * Blurs a histogram along an axis. Weight that would leave the histogram stays in the bin at its
 * border.
 */
Histogram BlurAlong(const Histogram& histogram, int stride)
{
  constexpr int reach = 9;
  double weights[2 * reach + 1];
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i)
  {
    sum += weights[i + reach] = std::exp(-i * i / (2.0 * BlurBins * BlurBins));
  }
  Histogram blurred(Cells, 0.0);
  for (int cell = 0; cell < Cells; ++cell)
  {
    const int bin = cell / stride % Bins;
    for (int i = -reach; i <= reach && histogram[cell] > 0.0; ++i)
    {
      const int to = std::clamp(bin + i, 0, Bins - 1);
      blurred[cell + (to - bin) * stride] += histogram[cell] * weights[i + reach] / sum;
    }
  }
  return blurred;
}

/** Returns the peak to which each cell belongs, or -1 for cells without lines nearby. */
std::vector<int> AssignPeaks(const Histogram& histogram)
{
  std::vector<int> order(Cells);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return histogram[a] > histogram[b]; });
  std::vector<int> parent(Cells, -1);
  const auto find = [&](int cell)
  {
    while (parent[cell] != cell)
    {
      cell = parent[cell] = parent[parent[cell]];
    }
    return cell;
  };
  for (const int cell : order)
  {
    if (!(histogram[cell] > 0.0))
    {
      break;
    }
    // Find the peaks of the higher neighbours. If two peaks meet in this cell, merge the lower one
    // into the higher one, unless it stands out enough.
    int best = -1;
    for (int neighbour = 0; neighbour < 9; ++neighbour)
    {
      const int x = cell % Bins + neighbour % 3 - 1;
      const int y = cell / Bins + neighbour / 3 - 1;
      const int other = y * Bins + x;
      if (x < 0 || y < 0 || x >= Bins || y >= Bins || parent[other] < 0)
      {
        continue;
      }
      const int peak = find(other);
      if (best < 0 || peak == best)
      {
        best = peak;
        continue;
      }
      const bool isLower = histogram[peak] < histogram[best];
      const int lower = isLower ? peak : best;
      const int higher = isLower ? best : peak;
      if (histogram[cell] > SaddleFraction * histogram[lower])
      {
        parent[lower] = higher;
      }
      best = higher;
    }
    parent[cell] = best < 0 ? cell : best;
  }
  for (int cell = 0; cell < Cells; ++cell)
  {
    parent[cell] = parent[cell] < 0 ? -1 : find(cell);
  }
  return parent;
}

/** Returns the extremum of the parabola through a sample and its two neighbours. */
double Extreme(const std::vector<double>& curve, std::size_t at)
{
  if (at == 0 || at + 1 == curve.size())
  {
    return curve[at];
  }
  const double slope = 0.5 * (curve[at + 1] - curve[at - 1]);
  const double bend = curve[at + 1] - 2.0 * curve[at] + curve[at - 1];
  return bend == 0.0 ? curve[at] : curve[at] - 0.5 * slope * slope / bend;
}

/**
 * Returns the width of an edge after Kindlmann and Durkin, g_max / (sqrt(e) h_max), from the lines'
 * mean slope g and mean curvature h.
 */
double MeasureWidth(const std::vector<const EdgeLine*>& lines)
{
  // If there are enough lines with wide layers, use only these, because a thin layer makes an edge
  // look sharper than it is.
  const auto wide = static_cast<std::size_t>(
    std::count_if(lines.begin(), lines.end(), [](const EdgeLine* line) { return line->IsWide; }));
  const bool onlyWide = wide >= LeastLines;
  std::vector<double> slope(EdgeLine::Fractions, 0.0);
  std::vector<double> bend(EdgeLine::Fractions, 0.0);
  for (const EdgeLine* line : lines)
  {
    if (onlyWide && !line->IsWide)
    {
      continue;
    }
    for (int k = 0; k < EdgeLine::Fractions; ++k)
    {
      // The profile of an edge is symmetric, so average it with its mirror image.
      const int mirrored = EdgeLine::Fractions - 1 - k;
      slope[k] += line->Slope[k] + line->Slope[mirrored];
      bend[k] += line->Curvature[k] - line->Curvature[mirrored];
    }
  }
  const auto steepest = std::max_element(slope.begin(), slope.end()) - slope.begin();
  const auto bent = std::max_element(bend.begin(), bend.end()) - bend.begin();
  const double g = Extreme(slope, static_cast<std::size_t>(steepest));
  const double h = Extreme(bend, static_cast<std::size_t>(bent));
  return h > 0.0 ? g / (std::sqrt(std::exp(1.0)) * h) : 0.0;
}

Boundary Describe(const std::vector<const EdgeLine*>& lines, const Vector3& middle)
{
  Boundary boundary;
  std::vector<Weighted> low, high, rise;
  double inward = 0.0;
  for (const EdgeLine* line : lines)
  {
    low.push_back({ line->Low, line->Weight });
    high.push_back({ line->High, line->Weight });
    rise.push_back({ line->High - line->Low, line->Weight });
    boundary.Blur += line->Blur / static_cast<double>(lines.size());
    boundary.Voxel += line->Voxel / static_cast<double>(lines.size());
    boundary.Fraction += line->Weight;
    inward += Dot(middle - line->Centre, line->Ahead) > 0.0 ? line->Weight : 0.0;
  }
  boundary.Low = Quantile(low, 0.5);
  boundary.High = Quantile(high, 0.5);
  boundary.LeastRise = Quantile(rise, 0.25);
  boundary.Inward = inward / boundary.Fraction;
  const double width = MeasureWidth(lines);
  boundary.Width = std::sqrt(std::max(0.0, width * width - boundary.Blur));
  return boundary;
}

} // namespace

//------------------------------------------------------------------------------
ValueAxis::ValueAxis(const std::vector<EdgeLine>& lines, double noise)
{
  std::vector<Weighted> low, high;
  for (const EdgeLine& line : lines)
  {
    low.push_back({ line.Low, line.Weight });
    high.push_back({ line.High, line.Weight });
  }
  if (lines.empty())
  {
    return;
  }
  constexpr double rare = 0.002;
  const double first = Quantile(low, rare);
  const double last = Quantile(high, 1.0 - rare);
  const double linear = LinearFraction * last;
  this->Scale = first >= -std::max(NoiseReach * noise, linear) ? linear : 0.0;
  this->First = (*this)(first);
  this->Last = (*this)(last);
}

double ValueAxis::operator()(double value) const noexcept
{
  return this->Scale > 0.0 ? std::asinh(value / this->Scale) : value;
}

//------------------------------------------------------------------------------
std::vector<Boundary> DetectBoundaries(const std::vector<EdgeLine>& lines, const ValueAxis& axis)
{
  // Make the histogram wider than the range of values, so that the blur stays inside.
  const double origin = axis.First - 0.1 * axis.Span();
  const double width = 1.2 * axis.Span() / Bins;
  const auto bin = [&](double value)
  { return static_cast<int>(std::clamp((axis(value) - origin) / width, 0.0, Bins - 1.0)); };
  const auto cell = [&](const EdgeLine& line) { return bin(line.High) * Bins + bin(line.Low); };
  if (lines.empty() || !(width > 0.0))
  {
    return {};
  }
  Histogram histogram(Cells, 0.0);
  Vector3 middle;
  double total = 0.0;
  for (const EdgeLine& line : lines)
  {
    histogram[cell(line)] += line.Weight;
    middle += line.Weight * line.Centre;
    total += line.Weight;
  }
  middle = (1.0 / total) * middle;
  const std::vector<int> peaks = AssignPeaks(BlurAlong(BlurAlong(histogram, 1), Bins));
  std::vector<std::vector<const EdgeLine*>> clusters(Cells);
  for (const EdgeLine& line : lines)
  {
    clusters[peaks[cell(line)]].push_back(&line);
  }
  std::vector<Boundary> boundaries;
  for (const auto& cluster : clusters)
  {
    if (cluster.size() < LeastLines)
    {
      continue;
    }
    Boundary boundary = Describe(cluster, middle);
    boundary.Fraction /= total;
    if (boundary.Fraction >= LeastFraction)
    {
      boundaries.push_back(boundary);
    }
  }
  std::sort(boundaries.begin(), boundaries.end(),
    [](const Boundary& a, const Boundary& b) { return a.Fraction > b.Fraction; });
  return boundaries;
}

} // namespace VolumeHaptics
