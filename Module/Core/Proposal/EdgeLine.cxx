// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Proposal/EdgeLine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace VolumeHaptics
{
namespace
{
constexpr double StepsPerVoxel = 4.0;
constexpr int Reach = 48; // most steps to either side
/** The value of a plateau is averaged over this number of steps. */
constexpr int PlateauSteps = 8;
/**
 * A plateau begins where the slope is below this fraction of the largest slope, or below the noise.
 */
constexpr double PlateauFraction = 0.03;
/**
 * A plateau may drift, for example because of a bias field. It is recognized if its slope is below
 * DriftFraction of the largest slope, but above DriftFall of the slope DriftSteps (one voxel)
 * before.
 */
constexpr double DriftFraction = 0.15;
constexpr double DriftFall = 0.9;
constexpr int DriftSteps = 4;
/** Another edge begins where the slope rises again by this fraction of the largest slope. */
constexpr double RiseFraction = 0.25;
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int MostClimbs = 16; // limit of the steps from any place on an edge to its steepest place

struct LinePoint
{
  double Value;
  double Slope; // slope per world unit
};

} // namespace

struct EdgeTracer::Ray
{
  Vector3 Centre;    ///< index of the line's centre
  Vector3 Step;      ///< step along the line, in indices
  double StepLength; ///< length of a step in world units
  double Slope;      ///< slope at the centre, per world unit
};

struct EdgeTracer::Profile
{
  static constexpr std::ptrdiff_t Centre = Reach;

  LinePoint& At(int step) { return this->Points[static_cast<std::size_t>(Centre + step)]; }
  const LinePoint& At(int step) const
  {
    return this->Points[static_cast<std::size_t>(Centre + step)];
  }

  std::array<LinePoint, 2 * Reach + 1> Points;
  int End[2] = { 0, 0 }; ///< number of steps to either side: from -End[0] to End[1]
  double Plateau[2] = { 0.0, 0.0 };
  bool IsWide[2] = { true, true };
};

EdgeTracer::EdgeTracer(const FieldSampler& field, const Affine3& indexToWorld, double variance,
  const EdgeThresholds& thresholds)
  : Field(field)
  , WorldToIndex(Inverse(indexToWorld.Linear))
  , IndexToWorld(indexToWorld.Linear)
  , Variance(variance)
  , Thresholds(thresholds)
{
}

//------------------------------------------------------------------------------
bool EdgeTracer::Aim(Ray& ray) const noexcept
{
  const FieldSample sample = this->Field.Gradient(ray.Centre);
  const Vector3 world = Transpose(this->WorldToIndex) * sample.Gradient;
  const double slope = Norm(world);
  if (!(slope > 0.0) || !std::isfinite(slope))
  {
    return false;
  }
  const Vector3 ahead = this->WorldToIndex * ((1.0 / slope) * world);
  ray.StepLength = 1.0 / (StepsPerVoxel * Norm(ahead));
  ray.Step = ray.StepLength * ahead;
  ray.Slope = slope;
  return true;
}

//------------------------------------------------------------------------------
double EdgeTracer::Slope(const Vector3& index) const noexcept
{
  Ray ray;
  ray.Centre = index;
  return this->Aim(ray) ? ray.Slope * ray.StepLength * StepsPerVoxel : 0.0;
}

//------------------------------------------------------------------------------
bool EdgeTracer::Climb(Ray& ray) const noexcept
{
  const auto slopeAt = [&](const Vector3& index)
  {
    const double slope = this->Field.IsInside(index)
      ? Dot(this->Field.Gradient(index).Gradient, ray.Step) / ray.StepLength
      : 0.0;
    return std::isfinite(slope) ? slope : 0.0;
  };
  double best = ray.Slope;
  const double ahead = slopeAt(ray.Centre + ray.Step);
  const double sign = ahead > best ? 1.0 : -1.0;
  for (int i = 0; i < MostClimbs; ++i)
  {
    const Vector3 next = ray.Centre + sign * ray.Step;
    const double slope = slopeAt(next);
    if (slope <= best)
    {
      return true;
    }
    best = slope;
    ray.Centre = next;
  }
  return false; // no edge within reach: the slope only increases
}

//------------------------------------------------------------------------------
bool EdgeTracer::WalkSide(const Ray& ray, int side, Profile& profile) const noexcept
{
  const int sign = side == 0 ? -1 : 1;
  const double peak = profile.At(0).Slope;
  const double perVoxel = ray.StepLength * StepsPerVoxel;
  const double flat = std::max(this->Thresholds.Flat / perVoxel, PlateauFraction * peak);
  double lowest = peak;
  int lowestAt = 0;
  double sum = 0.0;
  int count = 0;
  for (int i = 1; i <= Reach; ++i)
  {
    const Vector3 index = ray.Centre + (sign * i) * ray.Step;
    const FieldSample sample =
      this->Field.IsInside(index) ? this->Field.Gradient(index) : FieldSample{ Unknown, {} };
    const double slope = Dot(sample.Gradient, ray.Step) / ray.StepLength;
    if (!std::isfinite(slope) || !std::isfinite(sample.Value))
    {
      break;
    }
    profile.At(sign * i) = { sample.Value, slope };
    profile.End[side] = i;
    if (count > 0 && std::abs(slope) > flat)
    {
      break;
    }
    if (slope < -flat)
    {
      // Behind a thin layer the slope is negative, so the middle of the layer counts as the
      // plateau.
      profile.IsWide[side] = false;
      profile.Plateau[side] = profile.At(sign * (i - 1)).Value;
      return true;
    }
    if (slope <= flat)
    {
      sum += sample.Value;
      if (++count == PlateauSteps)
      {
        break;
      }
    }
    else if (i > DriftSteps && slope < DriftFraction * peak &&
      slope > DriftFall * profile.At(sign * (i - DriftSteps)).Slope)
    {
      profile.Plateau[side] = sample.Value;
      return true;
    }
    else if (slope > lowest + std::max(2.0 * flat, RiseFraction * peak))
    {
      profile.IsWide[side] = false;
      profile.End[side] = lowestAt;
      profile.Plateau[side] = profile.At(sign * lowestAt).Value;
      return true;
    }
    if (slope < lowest)
    {
      lowest = slope;
      lowestAt = i;
    }
  }
  if (count == 0)
  {
    return false;
  }
  profile.Plateau[side] = sum / count;
  return true;
}

namespace
{

/** Returns the derivative of the slope at a step, computed from its neighbours. */
template <typename Profile>
double Curvature(const Profile& profile, int step, double length)
{
  const int first = -profile.End[0];
  const int last = profile.End[1];
  if (step - 2 >= first && step + 2 <= last)
  {
    return (8.0 * (profile.At(step + 1).Slope - profile.At(step - 1).Slope) -
             (profile.At(step + 2).Slope - profile.At(step - 2).Slope)) /
      (12.0 * length);
  }
  const int from = std::max(first, step - 1);
  const int to = std::min(last, step + 1);
  return to > from ? (profile.At(to).Slope - profile.At(from).Slope) / ((to - from) * length) : 0.0;
}

/**
 * Stores slope and curvature of a profile at the given fractions of its rise. Returns false if the
 * profile does not reach one of them.
 */
template <typename Profile>
bool KeepFractions(const Profile& profile, double length, EdgeLine& line)
{
  const double rise = line.High - line.Low;
  const auto shareAt = [&](int step) { return (profile.At(step).Value - line.Low) / rise; };
  const double middle = shareAt(0);
  for (int k = 0; k < EdgeLine::Fractions; ++k)
  {
    const double fraction = (k + 0.5) / EdgeLine::Fractions;
    const int sign = fraction < middle ? -1 : 1;
    const int end = sign < 0 ? profile.End[0] : profile.End[1];
    int step = 0;
    while (step < end && sign * (shareAt(sign * step) - fraction) < 0.0)
    {
      ++step;
    }
    if (step == 0 || sign * (shareAt(sign * step) - fraction) < 0.0)
    {
      return false;
    }
    const int to = sign * step;
    const int from = sign * (step - 1);
    const double u = (fraction - shareAt(from)) / (shareAt(to) - shareAt(from));
    const double slope = (1.0 - u) * profile.At(from).Slope + u * profile.At(to).Slope;
    const double curvature =
      (1.0 - u) * Curvature(profile, from, length) + u * Curvature(profile, to, length);
    line.Slope[k] = static_cast<float>(slope / rise);
    line.Curvature[k] = static_cast<float>(curvature / rise);
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool EdgeTracer::Trace(const Vector3& index, EdgeLine& line) const noexcept
{
  Ray ray;
  ray.Centre = index;
  if (!this->Aim(ray))
  {
    return false;
  }
  const double found = ray.Slope;
  // Climb twice, because the gradient's direction is most exact where the gradient is largest.
  if (!this->Climb(ray) || !this->Aim(ray) || !this->Climb(ray) || !this->Aim(ray) ||
    ray.Slope * ray.StepLength * StepsPerVoxel < this->Thresholds.Least)
  {
    return false;
  }
  Profile profile;
  profile.At(0) = { this->Field.Gradient(ray.Centre).Value, ray.Slope };
  if (!this->WalkSide(ray, 0, profile) || !this->WalkSide(ray, 1, profile))
  {
    return false;
  }
  line.Low = profile.Plateau[0];
  line.High = profile.Plateau[1];
  if (!(line.High > line.Low))
  {
    return false;
  }
  line.IsWide = profile.IsWide[0] && profile.IsWide[1];
  line.Weight = found / (line.High - line.Low);
  line.Centre = this->IndexToWorld * ray.Centre;
  line.Ahead = (1.0 / ray.StepLength) * (this->IndexToWorld * ray.Step);
  const Vector3 blur = Transpose(this->IndexToWorld) * line.Ahead;
  line.Blur = this->Variance * Dot(blur, blur);
  line.Voxel = ray.StepLength / Norm(ray.Step);
  return KeepFractions(profile, ray.StepLength, line);
}

//------------------------------------------------------------------------------
double MeasureKernelVariance(const GradientKernel& kernel)
{
  const int size = 4 * kernel.Radius + 8;
  std::vector<double> parabola;
  parabola.reserve(static_cast<std::size_t>(size) * size * size);
  for (int i = 0; i < size * size * size; ++i)
  {
    parabola.push_back(static_cast<double>(i % size) * (i % size));
  }
  VolumeView view;
  view.Data = parabola.data();
  view.Stride[0] = 1;
  for (int a = 0; a < 3; ++a)
  {
    view.Dimensions[a] = size;
    view.Stride[a] = a == 0 ? 1 : view.Stride[a - 1] * size;
  }
  const FieldSampler field(view, kernel);
  constexpr int positions = 8;
  double variance = 0.0;
  for (int i = 0; i < positions; ++i)
  {
    const double x = size / 2 + (i + 0.5) / positions;
    variance += (field.Gradient({ x, size / 2.0, size / 2.0 }).Value - x * x) / positions;
  }
  return variance;
}

} // namespace VolumeHaptics
