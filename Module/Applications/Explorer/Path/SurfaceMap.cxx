// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Path/SurfaceMap.h"

#include "Applications/Explorer/Analysis/ValueProbe.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr int SMOOTHING_PASSES = 2;

/// Computes the Catmull-Rom weights of the four nodes around a position. t is the fraction between
/// the middle two nodes.
void CubicWeights(double t, double weights[4])
{
  weights[0] = 0.5 * t * (t * (2.0 - t) - 1.0);
  weights[1] = 0.5 * (t * t * (3.0 * t - 5.0) + 2.0);
  weights[2] = 0.5 * t * (t * (4.0 - 3.0 * t) + 1.0);
  weights[3] = 0.5 * t * t * (t - 1.0);
}
} // namespace

namespace Explore
{
namespace
{
/// A regular grid over two angles, with operations on maps of distances.
class PolarGrid
{
public:
  static constexpr double STEP = 4.0; // degrees

  PolarGrid(double rightLimit, double upLimit);

  int Size() const { return this->Columns * this->Rows; }
  double Right(int node) const { return (node % this->Columns) * STEP - this->RightLimit; }
  double Up(int node) const { return (node / this->Columns) * STEP - this->UpLimit; }

  /// Fills negative nodes, at which no surface was found, from their neighbours, applies a 3 x 3
  /// median filter, and smooths. At least one node must be positive.
  void Clean(std::vector<double>& map) const;
  void Smooth(std::vector<double>& map) const;

  /// Interpolates by Catmull-Rom splines. Angles beyond the grid are clamped.
  double Interpolate(const std::vector<double>& map, double right, double up) const;

private:
  template <typename Visitor>
  void VisitNeighbours(int node, Visitor visit) const;
  void Fill(std::vector<double>& map) const;

  double RightLimit, UpLimit;
  int Columns, Rows;
};

PolarGrid::PolarGrid(double rightLimit, double upLimit)
  : RightLimit(rightLimit)
  , UpLimit(upLimit)
  , Columns(static_cast<int>(2.0 * rightLimit / STEP) + 1)
  , Rows(static_cast<int>(2.0 * upLimit / STEP) + 1)
{
}

template <typename Visitor>
void PolarGrid::VisitNeighbours(int node, Visitor visit) const
{
  const int column = node % this->Columns, row = node / this->Columns;
  for (int r = std::max(0, row - 1); r <= std::min(this->Rows - 1, row + 1); ++r)
  {
    for (int c = std::max(0, column - 1); c <= std::min(this->Columns - 1, column + 1); ++c)
    {
      visit(r * this->Columns + c);
    }
  }
}

void PolarGrid::Fill(std::vector<double>& map) const
{
  bool hole = true;
  while (hole)
  {
    hole = false;
    const std::vector<double> before = map;
    for (int node = 0; node < this->Size(); ++node)
    {
      if (before[node] > 0.0)
      {
        continue;
      }
      double sum = 0.0;
      int count = 0;
      this->VisitNeighbours(node,
        [&](int other)
        {
          sum += before[other] > 0.0 ? before[other] : 0.0;
          count += before[other] > 0.0 ? 1 : 0;
        });
      map[node] = count > 0 ? sum / count : map[node];
      hole = hole || count == 0;
    }
  }
}

void PolarGrid::Smooth(std::vector<double>& map) const
{
  const std::vector<double> before = map;
  for (int node = 0; node < this->Size(); ++node)
  {
    double sum = 0.0;
    int count = 0;
    this->VisitNeighbours(node,
      [&](int other)
      {
        sum += before[other];
        count += 1;
      });
    map[node] = sum / count;
  }
}

void PolarGrid::Clean(std::vector<double>& map) const
{
  this->Fill(map);
  const std::vector<double> before = map;
  for (int node = 0; node < this->Size(); ++node)
  {
    std::vector<double> around;
    this->VisitNeighbours(node, [&](int other) { around.push_back(before[other]); });
    std::nth_element(around.begin(), around.begin() + around.size() / 2, around.end());
    map[node] = around[around.size() / 2];
  }
  for (int pass = 0; pass < SMOOTHING_PASSES; ++pass)
  {
    this->Smooth(map);
  }
}

double PolarGrid::Interpolate(const std::vector<double>& map, double right, double up) const
{
  const double x = std::clamp((right + this->RightLimit) / STEP, 0.0, this->Columns - 1.0);
  const double y = std::clamp((up + this->UpLimit) / STEP, 0.0, this->Rows - 1.0);
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  double across[4], along[4], sum = 0.0;
  CubicWeights(x - column, across);
  CubicWeights(y - row, along);
  for (int j = 0; j < 4; ++j)
  {
    const int r = std::clamp(row - 1 + j, 0, this->Rows - 1);
    for (int i = 0; i < 4; ++i)
    {
      const int c = std::clamp(column - 1 + i, 0, this->Columns - 1);
      sum += along[j] * across[i] * map[r * this->Columns + c];
    }
  }
  return sum;
}
} // namespace
} // namespace Explore

namespace
{
// Depths in metres. Smallest depth of a solid deep structure; a thinner layer may be noise, hair,
// or a sinus.
constexpr double SURE_DEPTH = 0.004;
constexpr double THINNEST = 0.002; // smallest distance between the outer and the deep surface
// assumed depth below the outer surface where no deep surface is found
constexpr double DEFAULT_DEEP = 0.010;
} // namespace

namespace Explore
{
SurfaceMap::SurfaceMap(vtkImageData* image, const Analysis& analysis, const ViewFrame& view)
  : Centre(view.Centre)
{
  double bounds[6];
  image->GetBounds(bounds);
  const vtkBoundingBox box(bounds);
  const double* spacing = image->GetSpacing();
  this->Start = box.GetDiagonalLength();
  this->Step = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });

  const PolarGrid grid(RIGHT_LIMIT, UP_LIMIT);
  this->OuterMap.resize(grid.Size());
  this->DeepMap.resize(grid.Size());
  this->QualityMap.resize(grid.Size());
  for (int node = 0; node < grid.Size(); ++node)
  {
    const Ray ray = this->Cast(image, analysis, view.Direction(grid.Right(node), grid.Up(node)));
    this->OuterMap[node] = ray.Outer;
    this->DeepMap[node] = ray.Deep;
    this->QualityMap[node] = (ray.Clean ? 0.5 : 0.0) + (ray.Solid ? 0.5 : 0.0);
    this->Hits += ray.Outer > 0.0 ? 1 : 0;
  }
  if (this->IsEmpty())
  {
    return;
  }
  grid.Clean(this->OuterMap);
  const double byDefault = DEFAULT_DEEP / analysis.MetersPerWorldUnit;
  for (int node = 0; node < grid.Size(); ++node)
  {
    double& deep = this->DeepMap[node];
    // Clean the depth below the skin instead of the distance, because it varies little between
    // neighbours, so a hole gets a similar depth.
    deep = deep > 0.0 ? std::max(0.0, this->OuterMap[node] - deep) : -1.0;
  }
  if (std::any_of(this->DeepMap.begin(), this->DeepMap.end(), [](double d) { return d > 0.0; }))
  {
    grid.Clean(this->DeepMap);
  }
  else
  {
    std::fill(this->DeepMap.begin(), this->DeepMap.end(), byDefault);
  }
  grid.Smooth(this->QualityMap);
}

SurfaceMap::Ray SurfaceMap::Cast(
  vtkImageData* image, const Analysis& analysis, const vtkVector3d& direction) const
{
  const ValueProbe probe(image, analysis.Range[0]);
  const int sure =
    std::max(2, static_cast<int>(SURE_DEPTH / analysis.MetersPerWorldUnit / this->Step));
  const double thinnest = THINNEST / analysis.MetersPerWorldUnit;
  Ray ray;
  bool wasInside = false, dipped = false;
  int run = 0;
  for (double distance = this->Start; distance > 0.0; distance -= this->Step)
  {
    const vtkVector3d position = this->Centre + distance * direction;
    bool inside = false;
    const double value = probe.Value(position.GetData(), inside);
    if (ray.Outer < 0.0)
    {
      if (value > analysis.OuterThreshold)
      {
        // If the first sample inside the volume is already body, the scan is truncated at this
        // face.
        ray.Clean = run == 0 ? wasInside : ray.Clean;
        run += 1;
      }
      else
      {
        run = 0;
      }
      ray.Outer = run > sure ? distance + run * this->Step : ray.Outer;
    }
    else if (ray.Outer - distance > thinnest)
    {
      // Require a rise of the value, because a threshold fails in T1 MRI: fat is as bright as
      // brain, and the dark skull is between them.
      dipped = dipped || value < analysis.DeepThreshold;
      if (dipped && value > analysis.DeepThreshold)
      {
        ray.Deep = distance;
        ray.Solid = this->IsSolid(probe, analysis.DeepThreshold, distance, sure, direction);
        break;
      }
    }
    wasInside = inside;
  }
  return ray;
}

bool SurfaceMap::IsSolid(const ValueProbe& probe, double threshold, double distance, int steps,
  const vtkVector3d& direction) const
{
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const vtkVector3d position = this->Centre + (distance - i * this->Step) * direction;
    bool inside = false;
    sum += probe.Value(position.GetData(), inside);
  }
  return sum > steps * threshold;
}

double SurfaceMap::Interpolate(const std::vector<double>& map, double right, double up) const
{
  return PolarGrid(RIGHT_LIMIT, UP_LIMIT).Interpolate(map, right, up);
}

double SurfaceMap::Outer(double right, double up) const
{
  return this->Interpolate(this->OuterMap, right, up);
}

double SurfaceMap::Deep(double right, double up) const
{
  return this->Outer(right, up) - this->Interpolate(this->DeepMap, right, up);
}

double SurfaceMap::Quality(double right, double up) const
{
  return this->Interpolate(this->QualityMap, right, up);
}

} // namespace Explore
