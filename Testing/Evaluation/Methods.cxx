// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
using Filter = vtkVolumeHapticsFilter;

/**
 * Distance (mm) from the level at which the tip starts outside of a mesh, whose triangles can be
 * off the level by a tenth of a voxel.
 */
constexpr double Approach = 0.5;
/**
 * Number of ticks that the tip waits at the start, until the slow loop has fitted a local surface.
 */
constexpr std::size_t Wait = 50;
} // namespace

void SetConstant(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

const std::vector<Method>& AllMethods()
{
  static const std::vector<Method> methods = {
    { "PAPER", Filter::PROXY, Filter::PAPER, 0 },
    { "PRECISE", Filter::PROXY, Filter::PRECISE, 1 },
    { "SURFACE_PROXY", Filter::SURFACE_PROXY, Filter::PRECISE, 5 },
    { "LOCAL_SURFACE", Filter::LOCAL_SURFACE, Filter::PRECISE, 6 },
    { "FORCE_FIELD", Filter::FORCE_FIELD, Filter::PRECISE, 4 },
  };
  return methods;
}

const Method& SurfaceHaptics()
{
  for (const Method& method : AllMethods())
  {
    if (method.Kind == Filter::SURFACE_PROXY)
    {
      return method;
    }
  }
  return AllMethods().front();
}

vtkSmartPointer<vtkImageData> SampleImage(const Field& field, double halfSize)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int half = static_cast<int>(std::ceil(halfSize));
  const int n = 2 * half + 1;
  image->SetDimensions(n, n, n);
  image->SetOrigin(-half, -half, -half);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* to = static_cast<double*>(image->GetScalarPointer());
  for (int k = -half; k <= half; ++k)
  {
    for (int j = -half; j <= half; ++j)
    {
      for (int i = -half; i <= half; ++i)
      {
        *to++ = field({ 1.0 * i, 1.0 * j, 1.0 * k });
      }
    }
  }
  return image;
}

Scene::Scene(vtkImageData* image, double isoValue, vtkPolyData* surface)
  : IsGiven(surface != nullptr)
{
  this->Filter->SetInputDataObject(0, image);
  this->Filter->SetIsoValue(isoValue);
  this->Filter->SetProxyRadius(ProbeRadius);
  if (surface)
  {
    this->Filter->SetSurfaceData(surface);
  }
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), Impenetrable);
  SetConstant(this->Filter->GetProperty()->GetDistinctness(), 1.0);
  this->SetMaterial(500.0, 0.0);
}

void Scene::SetMaterial(double stiffness, double friction)
{
  SetConstant(this->Filter->GetProperty()->GetStiffness(), stiffness);
  SetConstant(this->Filter->GetProperty()->GetFriction(), friction);
}

std::shared_ptr<const HapticModel> Scene::Bake(const Method& method)
{
  this->Filter->SetMethod(method.Kind);
  this->Filter->SetSolver(method.Solver);
  return this->Filter->GetBaker().Bake(1000.0, {}, nullptr);
}

Trace Scene::Feel(const Method& method, const Stroke& stroke)
{
  const auto model = this->Bake(method);
  if (!model)
  {
    return {};
  }
  const bool isProxy = method.Kind == Filter::PROXY;
  Path path(isProxy ? 1 : Wait, isProxy ? stroke.Start : stroke.Start + Approach * stroke.Outward);
  const auto before = static_cast<std::ptrdiff_t>(path.size());
  path.insert(path.end(), stroke.Tips.begin(), stroke.Tips.end());
  Trace trace = Play(*model, path);
  trace.erase(trace.begin(), trace.begin() + before);
  for (TickRecord& tick : trace)
  {
    if (method.Offset() > 0.0 && tick.NormalForce > 0.0)
    {
      tick.Proxy += 0.001 * method.Offset() * tick.Normal;
      tick.Force = tick.Stiffness * (tick.Proxy - tick.Tip);
    }
  }
  return trace;
}

} // namespace evaluation
