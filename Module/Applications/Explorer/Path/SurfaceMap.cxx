// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Path/SurfaceMap.h"

#include "Applications/Explorer/Analysis/ValueProbe.h"
#include "Applications/Explorer/Path/PolarGrid.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>

namespace
{
// In metres.
constexpr double SURE_DEPTH = 0.004;   // of a surface; a thinner layer may be noise, hair, a sinus
constexpr double THINNEST = 0.002;     // from the outer to the deep surface
constexpr double DEFAULT_DEEP = 0.010; // from the outer surface, if no deep surface is found
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
    // Depth below the skin, which varies little between neighbours; a hole gets its neighbours'
    // depth.
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
        // The first sample inside the volume that is already body: a face that cuts the scan.
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
      // A rise, not a height: in T1 MRI fat is as bright as brain, and the dark skull between.
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
