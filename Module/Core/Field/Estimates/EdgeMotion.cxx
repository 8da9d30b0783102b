// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/EdgeMotion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace VolumeHaptics
{
namespace
{

using LatticePlace = std::array<std::int64_t, 3>;

constexpr double MostPlaces = 8000.0;
constexpr std::size_t MostEdges = 256;
/**
 * Distance (samples) to either side within which an edge's plateaus, and the edge in the other time
 * step, are searched.
 */
constexpr std::int64_t EdgeReach = 64;
/**
 * Least rise of an edge as a fraction of the range of values: from one sample to the next, and in
 * total.
 */
constexpr double LeastEdgeSlope = 0.03;
constexpr double LeastEdgeRise = 0.1;
/** Least rise of an edge as a multiple of the noise: from one sample to the next, and in total. */
constexpr double SlopeOverNoise = 4.0;
constexpr double RiseOverNoise = 10.0;
/** A plateau begins where the remaining rise is less than this fraction of the range. */
constexpr double EdgeTail = 1e-3;
/**
 * Tolerance of a plateau's value in the other time step (as a fraction of the rise), and the
 * distance (widths) from the edge's middle at which it is compared.
 */
constexpr double SamePlateau = 0.3;
constexpr double PlateauDistance = 3.0;
constexpr double SqrtTwoPi = 2.50662827463100050242;

/** Reads the samples of a volume by their indices. */
class EdgeSamples
{
public:
  explicit EdgeSamples(const VolumeView& view)
    : View(view)
    , Read(WithSampleType(view.Type,
        [](auto type) -> double (*)(const void*, std::int64_t)
        {
          using T = decltype(type);
          return [](const void* data, std::int64_t element)
          { return static_cast<double>(static_cast<const T*>(data)[element]); };
        }))
  {
  }

  double At(const LatticePlace& place) const
  {
    std::int64_t element = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      element += place[a] * this->View.Stride[a];
    }
    return this->Read(this->View.Data, element);
  }

  std::int64_t Size(std::size_t axis) const { return this->View.Dimensions[axis]; }

private:
  const VolumeView& View;
  double (*const Read)(const void*, std::int64_t);
};

/** The samples on a line through a place, along an axis. */
class SampleLine
{
public:
  SampleLine(const EdgeSamples& samples, const LatticePlace& through, std::size_t axis)
    : From(samples)
    , Through(through)
    , Axis(axis)
  {
  }
  bool Has(std::int64_t i) const { return i >= 0 && i < this->From.Size(this->Axis); }
  double operator()(std::int64_t i) const
  {
    LatticePlace place = this->Through;
    place[this->Axis] = i;
    return this->From.At(place);
  }

private:
  const EdgeSamples& From;
  const LatticePlace Through;
  const std::size_t Axis;
};

/** An edge that was found on a line of samples. */
struct FoundEdge
{
  double Low;    ///< V1, the value of the plateau at lower indices
  double High;   ///< V2, the value of the plateau at higher indices
  double Middle; ///< index of the edge's middle
  double Width;  ///< width in samples
  double Rising; ///< 1 if the edge rises, else -1
};

/** A place of the lattice where the gradient is steep enough for an edge. */
struct SteepPlace
{
  LatticePlace At;
  std::size_t Axis; ///< axis along which the slope is steepest
  double Rising;    ///< 1 if the values rise along the axis, else -1
  double Cosine;    ///< cosine between the gradient and the axis, 0 to 1
};

/**
 * Walks from a steep place to the beginning of a plateau. Returns false if no plateau is within
 * reach.
 */
bool WalkToPlateau(const SampleLine& line, std::int64_t direction, double upward, double tolerance,
  std::int64_t& at, double& steepest)
{
  const std::int64_t begin = at;
  for (;;)
  {
    if (!line.Has(at + 2 * direction) || std::abs(at - begin) > EdgeReach)
    {
      return false;
    }
    const double here = line(at);
    const double next = line(at + direction);
    const double afterNext = line(at + 2 * direction);
    if (!(std::max(upward * (next - here), upward * (afterNext - here)) > tolerance))
    {
      return std::isfinite(here);
    }
    steepest = std::max(steepest, upward * (next - here));
    at += direction;
  }
}

/** Returns the position between the indices i and i + 1 at which a line has a value. */
double FindCrossing(const SampleLine& line, std::int64_t i, double value)
{
  const double a = line(i);
  const double b = line(i + 1);
  return static_cast<double>(i) + std::clamp((value - a) / (b - a), 0.0, 1.0);
}

bool IsCrossing(const SampleLine& line, std::int64_t i, double value, double rising)
{
  return line.Has(i) && line.Has(i + 1) && rising * (line(i) - value) < 0.0 &&
    rising * (line(i + 1) - value) >= 0.0;
}

bool FindEdge(const SampleLine& line, const SteepPlace& steep, double tolerance, double leastRise,
  FoundEdge& edge)
{
  const auto begin = steep.At[steep.Axis];
  std::int64_t low = begin;
  std::int64_t high = begin;
  double steepest = 0.0;
  if (!WalkToPlateau(line, -1, -steep.Rising, tolerance, low, steepest) ||
    !WalkToPlateau(line, 1, steep.Rising, tolerance, high, steepest))
  {
    return false;
  }
  edge.Low = line(low);
  edge.High = line(high);
  edge.Rising = steep.Rising;
  const double rise = steep.Rising * (edge.High - edge.Low);
  if (!(rise > leastRise && steepest > 0.0))
  {
    return false;
  }
  edge.Width = rise / (steepest * SqrtTwoPi);
  const double value = 0.5 * (edge.Low + edge.High);
  for (std::int64_t i = low; i < high; ++i)
  {
    if (IsCrossing(line, i, value, edge.Rising))
    {
      edge.Middle = FindCrossing(line, i, value);
      return true;
    }
  }
  return false;
}

/** Returns whether a line has both plateaus of an edge around a crossing at `middle`. */
bool HasPlateaus(const SampleLine& line, const FoundEdge& edge, double middle)
{
  const auto distance = static_cast<std::int64_t>(std::ceil(PlateauDistance * edge.Width));
  const auto before = static_cast<std::int64_t>(std::floor(middle)) - distance;
  const auto behind = static_cast<std::int64_t>(std::ceil(middle)) + distance;
  const double most = SamePlateau * std::abs(edge.High - edge.Low);
  return line.Has(before) && line.Has(behind) && std::abs(line(before) - edge.Low) < most &&
    std::abs(line(behind) - edge.High) < most;
}

/**
 * Returns the distance (samples) from an edge to the nearest place on a line that has this edge, or
 * -1 if there is none.
 */
double MeasureMotion(const SampleLine& line, const FoundEdge& edge)
{
  const double value = 0.5 * (edge.Low + edge.High);
  const auto begin = static_cast<std::int64_t>(std::floor(edge.Middle));
  double nearest = std::numeric_limits<double>::max();
  // Search one sample farther, because a crossing on the other side may be nearer.
  for (std::int64_t i = 0; i <= EdgeReach && static_cast<double>(i) <= nearest + 1.0; ++i)
  {
    for (const std::int64_t at : { begin - i, begin + i })
    {
      if (!IsCrossing(line, at, value, edge.Rising))
      {
        continue;
      }
      const double middle = FindCrossing(line, at, value);
      if (HasPlateaus(line, edge, middle))
      {
        nearest = std::min(nearest, std::abs(middle - edge.Middle));
      }
    }
  }
  return nearest < static_cast<double>(EdgeReach) ? nearest : -1.0;
}

double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/**
 * Collects the places of a lattice where gradients are steep. Writes the difference between the
 * largest and the smallest value to `range`.
 */
std::vector<SteepPlace> CollectSteepPlaces(
  const EdgeSamples& samples, const Vector3& spacing, double noise, double& range)
{
  const double all = static_cast<double>(samples.Size(0)) * static_cast<double>(samples.Size(1)) *
    static_cast<double>(samples.Size(2));
  const auto step =
    std::max(std::int64_t{ 1 }, static_cast<std::int64_t>(std::ceil(std::cbrt(all / MostPlaces))));
  const double h[] = { spacing.X, spacing.Y, spacing.Z };
  std::vector<SteepPlace> places;
  std::vector<double> slopes;
  double least = std::numeric_limits<double>::max();
  double most = -least;
  for (std::int64_t k = 1 + step / 2; k + 1 < samples.Size(2); k += step)
  {
    for (std::int64_t j = 1 + step / 2; j + 1 < samples.Size(1); j += step)
    {
      for (std::int64_t i = 1 + step / 2; i + 1 < samples.Size(0); i += step)
      {
        SteepPlace steep{ { i, j, k }, 0, 1.0, 0.0 };
        double square = 0.0;
        double steepest = 0.0;
        double slope = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          LatticePlace next = steep.At;
          LatticePlace before = steep.At;
          ++next[axis];
          --before[axis];
          const double rise = 0.5 * (samples.At(next) - samples.At(before));
          square += rise * rise / (h[axis] * h[axis]);
          if (std::abs(rise) / h[axis] > steepest)
          {
            steepest = std::abs(rise) / h[axis];
            slope = std::abs(rise);
            steep.Axis = axis;
            steep.Rising = rise > 0.0 ? 1.0 : -1.0;
          }
        }
        const double value = samples.At(steep.At);
        if (std::isfinite(value) && std::isfinite(square))
        {
          least = std::min(least, value);
          most = std::max(most, value);
          steep.Cosine = square > 0.0 ? steepest / std::sqrt(square) : 0.0;
          places.push_back(steep);
          slopes.push_back(slope);
        }
      }
    }
  }
  range = std::max(0.0, most - least);
  const double wanted = std::max(LeastEdgeSlope * range, SlopeOverNoise * noise);
  std::vector<SteepPlace> found;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (slopes[i] > wanted)
    {
      found.push_back(places[i]);
    }
  }
  return found;
}

} // namespace

EdgeMotion MeasureEdgeMotion(const VolumeView& first, const VolumeView& second,
  const Matrix3& indexToWorld, double blur, double noise)
{
  const EdgeSamples before(first);
  const EdgeSamples after(second);
  const Matrix3 columns = Transpose(indexToWorld);
  const Vector3 spacing{ Norm(columns.Row[0]), Norm(columns.Row[1]), Norm(columns.Row[2]) };
  const double h[] = { spacing.X, spacing.Y, spacing.Z };
  double range = 0.0;
  const std::vector<SteepPlace> places = CollectSteepPlaces(before, spacing, noise, range);
  const double tolerance = std::max(EdgeTail * range, noise);
  const double leastRise = std::max(LeastEdgeRise * range, RiseOverNoise * noise);
  EdgeMotion found;
  std::vector<double> motions;
  std::vector<double> widths;
  const std::size_t step = places.size() / MostEdges + 1;
  for (std::size_t i = 0; i < places.size(); i += step)
  {
    const SteepPlace& steep = places[i];
    FoundEdge edge;
    if (!FindEdge(SampleLine(before, steep.At, steep.Axis), steep, tolerance, leastRise, edge))
    {
      continue;
    }
    const double moved = MeasureMotion(SampleLine(after, steep.At, steep.Axis), edge);
    if (moved < 0.0)
    {
      continue;
    }
    ++found.Edges;
    const double across = h[steep.Axis] * steep.Cosine;
    const double width = std::hypot(edge.Width * across, blur * h[steep.Axis]);
    if (moved * across > 2.0 * width)
    {
      motions.push_back(moved * across);
      widths.push_back(width);
    }
  }
  found.Fast = static_cast<int>(motions.size());
  if (found.Fast > 0)
  {
    found.Motion = Median(motions);
    found.Width = Median(widths);
  }
  return found;
}

} // namespace VolumeHaptics
