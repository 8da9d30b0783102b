// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/HapticViewRay.h"

#include "Core/Regions/Residency.h"
#include "Core/Servo/ServoTick.h"
#include "VTK/Baking/HapticBaker.h"
#include "VTK/Baking/HapticVolume.h"

#include "vtkBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInteractorObserver.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{
namespace
{

Vector3 FromArray(const double* v)
{
  return { v[0], v[1], v[2] };
}

} // namespace

Vector3 UnderPointer(vtkRenderer* renderer, const int pointer[2], const Vector3& depth)
{
  double display[3];
  double world[4];
  vtkInteractorObserver::ComputeWorldToDisplay(renderer, depth.X, depth.Y, depth.Z, display);
  vtkInteractorObserver::ComputeDisplayToWorld(renderer, pointer[0], pointer[1], display[2], world);
  return FromArray(world);
}

Vector3 LineOfSight(vtkRenderer* renderer, const Vector3& position)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Vector3 way = position - FromArray(camera->GetPosition());
  const double length = Norm(way);
  return camera->GetParallelProjection() || !(length > 0.0)
    ? FromArray(camera->GetDirectionOfProjection())
    : (1.0 / length) * way;
}

bool FindFirstContact(
  vtkRenderer* renderer, const int pointer[2], vtkVolumeHapticsFilter* filter, Vector3& position)
{
  // The device's placement does not matter here, so the filter's own scale is enough.
  const auto model = HapticBaker(filter).Bake(filter->GetServoRate(), ForceCaps{}, nullptr);
  vtkImageData* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (!model || !image)
  {
    return false;
  }
  double bounds[6];
  image->GetBounds(bounds);
  const Vector3 focus = FromArray(renderer->GetActiveCamera()->GetFocalPoint());
  const Vector3 middle = UnderPointer(renderer, pointer, focus);
  const Vector3 sight = LineOfSight(renderer, middle);
  const double reach = image->GetLength() + Norm(middle - FromArray(image->GetCenter()));
  const Vector3 ends[2] = { middle - reach * sight, middle + reach * sight };
  double from[3] = { ends[0].X, ends[0].Y, ends[0].Z };
  double to[3] = { ends[1].X, ends[1].Y, ends[1].Z };
  double enters = 0.0;
  double leaves = 0.0;
  double x[3];
  double y[3];
  int planes[2];
  if (!vtkBox::IntersectWithLine(bounds, from, to, enters, leaves, x, y, planes[0], planes[1]))
  {
    return false;
  }
  const double step = 0.25 * SmallestSpacing(image);
  const Vector3 start = ends[0] + (2.0 * reach * enters) * sight;
  const auto steps = static_cast<int>(2.0 * reach * (leaves - enters) / step);
  ServoState state;
  TickRecord record;
  for (int i = 0; i <= steps; ++i)
  {
    const Vector3 tip = start + (i * step) * sight;
    if (FindResidency(*model, state, model->WorldToDevice(tip)) == 0.0)
    {
      // A position without its data is not felt.
      state.Enabled = false;
      continue;
    }
    Tick(*model, state, model->WorldToDevice(tip), record);
    if (record.Contact != ContactState::Free)
    {
      position = tip - (2.0 * step) * sight;
      return true;
    }
  }
  return false;
}

} // namespace VolumeHaptics
