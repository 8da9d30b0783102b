// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"

#include <vtkPiecewiseFunction.h>

#include <algorithm>

namespace reference
{
void Scene::MoveTo(const Vec3& goal, double step)
{
  const Vec3 start = this->path.back();
  const int steps = std::max(1, int(std::lround(Norm(goal - start) / step)));
  for (int i = 1; i < steps; ++i)
  {
    this->path.push_back(start + (double(i) / steps) * (goal - start));
  }
  this->path.push_back(goal);
}

static void SetConstant(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

void SetMaterial(Scene& scene, double stiffness, double friction, double viscosity,
  double surfaceStrength, double distinctness)
{
  SetConstant(scene.property->GetStiffness(), stiffness);
  SetConstant(scene.property->GetFriction(), friction);
  SetConstant(scene.property->GetViscosity(), viscosity);
  SetConstant(scene.property->GetSurfaceStrength(), surfaceStrength);
  SetConstant(scene.property->GetDistinctness(), distinctness);
}
} // namespace reference
