// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/HapticViewRay.h"

#include "Core/Regions/Residency.h"
#include "Core/Servo/ServoTick.h"
#include "VTK/Baking/HapticVolume.h"
#include "VTK/Filter/HapticBaker.h"

#include "vtkBox.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkInteractorObserver.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <functional>
#include <memory>
#include <utility>

namespace VolumeHaptics
{
namespace
{

Vector3 FromArray(const double* v)
{
  return { v[0], v[1], v[2] };
}

/** Whether there is something at a position (world), coming from the one before. */
using Probe = std::function<bool(const Vector3&)>;

/** Feels with the servo's own tick; nothing if the filter can't be touched. */
Probe MakeFeelingProbe(vtkVolumeHapticsFilter* filter)
{
  // The device's placement does not matter here, so the filter's own scale is enough.
  std::shared_ptr<const HapticModel> model =
    HapticBaker(filter).Bake(filter->GetServoRate(), ForceCaps{}, nullptr);
  if (!model)
  {
    return nullptr;
  }
  return [model = std::move(model), state = ServoState(), record = TickRecord()](
           const Vector3& tip) mutable
  {
    if (FindResidency(*model, state, model->WorldToDevice(tip)) == 0.0)
    {
      // A position without its data is not felt.
      state.Enabled = false;
      return false;
    }
    Tick(*model, state, model->WorldToDevice(tip), record);
    return record.Contact != ContactState::Free;
  };
}

/** Sees where the nearest sample passes the value of the isosurface. */
Probe MakeValueProbe(vtkVolumeHapticsFilter* filter, vtkImageData* image)
{
  const vtkSmartPointer<vtkDataArray> scalars = HapticBaker(filter).GetTouched()[0].Array;
  const int component = filter->GetProperty()->GetComponent();
  const double value = filter->GetIsoValue();
  return [=, isFirst = true, wasInside = false](const Vector3& tip) mutable
  {
    const double at[3] = { tip.X, tip.Y, tip.Z };
    const vtkIdType point = image->FindPoint(at[0], at[1], at[2]);
    if (point < 0)
    {
      return false;
    }
    const bool isInside = scalars->GetComponent(point, component) >= value;
    const bool passes = !isFirst && isInside != wasInside;
    isFirst = false;
    wasInside = isInside;
    return passes;
  };
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
  vtkRenderer* renderer, const Vector3& through, vtkVolumeHapticsFilter* filter, Vector3& position)
{
  const char* const awaited = HapticBaker(filter).Prepare();
  vtkImageData* const image = filter->GetTouchedImage();
  const bool isIsoSurface = image && awaited == MeshingWork && !filter->GetInputDataObject(2, 0);
  Probe probe;
  if (isIsoSurface)
  {
    probe = MakeValueProbe(filter, image);
  }
  else if (image && !awaited)
  {
    probe = MakeFeelingProbe(filter);
  }
  if (!probe)
  {
    return false;
  }
  double bounds[6];
  image->GetBounds(bounds);
  const Vector3 sight = LineOfSight(renderer, through);
  const double reach = image->GetLength() + Norm(through - FromArray(image->GetCenter()));
  const Vector3 ends[2] = { through - reach * sight, through + reach * sight };
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
  // In coarse steps, and again in fine ones shortly before the contact.
  constexpr int fineness = 16;
  constexpr int before = 2; // coarse steps
  Probe again = probe;
  const double step = 0.25 * SmallestSpacing(image);
  const Vector3 start = ends[0] + (2.0 * reach * enters) * sight;
  const auto steps = static_cast<int>(2.0 * reach * (leaves - enters) / step);
  for (int i = 0; i <= steps; ++i)
  {
    if (probe(start + (i * step) * sight))
    {
      position = start + ((i - before) * step) * sight;
      for (int fine = 1 - before * fineness; fine <= 0; ++fine)
      {
        const Vector3 tip = start + ((i + static_cast<double>(fine) / fineness) * step) * sight;
        if (again(tip))
        {
          position = tip - (before * step) * sight;
          break;
        }
      }
      return true;
    }
  }
  return false;
}

} // namespace VolumeHaptics
