// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceTick.h"

#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <stdexcept>

namespace reference
{
static Vec3 FreeNormal(vtkImageData* image, const Trace* played, std::size_t tick)
{
  if (!played)
  {
    // This normal rotates with the volume, because forces must not depend on the volume's
    // placement.
    Vec3 axis;
    for (int row = 0; row < 3; ++row)
    {
      axis[row] = image->GetDirectionMatrix()->GetElement(row, 0);
    }
    return (1.0 / Norm(axis)) * axis;
  }
  const Vec3 normal = (*played)[tick].normal;
  if (std::abs(Norm(normal) - 1.0) > 1e-12)
  {
    throw std::runtime_error("the trace's normal is not a unit vector");
  }
  return normal;
}

Trace RunReference(Scene& scene, const Trace* played, bool resume)
{
  vtkPointData* pointData = scene.image->GetPointData();
  vtkDataArray* scalars = scene.arrayName.empty() ? pointData->GetScalars()
                                                  : pointData->GetArray(scene.arrayName.c_str());
  const ReferenceField field(
    scene.image, scalars, scene.component, scene.estimator, scene.kernelRadius);
  Trace trace;
  for (std::size_t tick = 0; tick < scene.path.size(); ++tick)
  {
    // In the first tick, the proxy and the previous position are at the tip, so there is no motion.
    const Vec3 tip = scene.path[tick];
    const Vec3 previousTip = tick == 0 ? tip : scene.path[tick - 1];
    const Vec3 proxy = tick == 0 ? tip : (resume ? (*played)[tick - 1].proxy : trace.back().proxy);
    TickRecord record = scene.method == Method::ForceField
      ? ForceFieldTick(field, scene, previousTip, tip)
      : ProxyTick(field, scene, proxy, tip, FreeNormal(scene.image, played, tick));
    if (tick == 0)
    {
      record.force = Vec3();
      record.normalForce = 0.0;
      record.dragForce = 0.0;
    }
    record.time = tick / scene.servoRate;
    trace.push_back(record);
  }
  return trace;
}
} // namespace reference
