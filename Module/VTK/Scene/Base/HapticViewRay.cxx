// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/HapticViewRay.h"

#include "Core/Regions/Residency.h"
#include "Core/Servo/ServoTick.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"
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

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Properties of a surface at a contact. */
struct Felt
{
  Vector3 Normal;                ///< unit vector, outwards; zero if unknown
  double Force = VTK_DOUBLE_MAX; ///< N; the largest number while the mesh is still being made
};

/**
 * Function that returns whether something is felt at a position (world) when the tip comes from the
 * previous position. Sets `felt` to the properties of a felt surface.
 */
using Probe = std::function<bool(const Vector3& position, Felt& felt)>;

/** Makes a probe that runs the servo's own tick. Returns null if the filter can't be touched. */
Probe MakeFeelingProbe(vtkVolumeHapticsFilter* filter)
{
  // Bake without a device's placement, which does not matter here.
  std::shared_ptr<const HapticModel> model =
    filter->GetBaker().Bake(filter->GetServoRate(), ForceCaps{}, nullptr);
  if (!model)
  {
    return nullptr;
  }
  return [model = std::move(model), state = ServoState(), record = TickRecord()](
           const Vector3& tip, Felt& felt) mutable
  {
    if (ComputeResidency(*model, state, model->WorldToDevice(tip)) == 0.0)
    {
      // Skip positions without data, where nothing is felt.
      state.Enabled = false;
      return false;
    }
    Tick(*model, state, model->WorldToDevice(tip), record);
    felt = { -1.0 * record.Normal, Norm(record.Force) };
    return record.Contact != ContactState::Free;
  };
}

/**
 * Makes a probe that reports a contact where the nearest sample crosses the value of the
 * isosurface.
 */
Probe MakeValueProbe(vtkVolumeHapticsFilter* filter, vtkImageData* image)
{
  const vtkSmartPointer<vtkDataArray> scalars = filter->GetBaker().GetTouched()[0].Array;
  const int component = filter->GetProperty()->GetComponent();
  const double value = filter->GetIsoValue();
  return [=, isFirst = true, wasInside = false](const Vector3& tip, Felt&) mutable
  {
    double at[3] = { tip.X, tip.Y, tip.Z };
    const vtkIdType point = image->FindPoint(at); // an array, because ParaView 5.13 does not
                                                  // compile the overload with three numbers
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

/** A straight path through an image along a line of sight. */
struct Line
{
  Vector3 Start;
  Vector3 Sight;
  double Length = 0.0; ///< length of the path (world units)
  double Step = 0.0;   ///< step length (world units)
};

Line MakeLine(vtkRenderer* renderer, const Vector3& through, vtkImageData* image)
{
  Line line;
  line.Sight = LineOfSight(renderer, through);
  line.Step = 0.25 * SmallestSpacing(image);
  double bounds[6];
  image->GetBounds(bounds);
  const double reach = image->GetLength() + Norm(through - FromArray(image->GetCenter()));
  const Vector3 ends[2] = { through - reach * line.Sight, through + reach * line.Sight };
  const double from[3] = { ends[0].X, ends[0].Y, ends[0].Z };
  const double to[3] = { ends[1].X, ends[1].Y, ends[1].Z };
  double enters = 0.0;
  double leaves = 0.0;
  double x[3];
  double y[3];
  int planes[2];
  if (vtkBox::IntersectWithLine(bounds, from, to, enters, leaves, x, y, planes[0], planes[1]))
  {
    line.Start = ends[0] + (2.0 * reach * enters) * line.Sight;
    line.Length = 2.0 * reach * (leaves - enters);
  }
  return line;
}

/** Returns a probe for this filter; null if nothing can be felt. */
Probe MakeProbe(vtkVolumeHapticsFilter* filter)
{
  const char* const awaited = filter->GetBaker().GetPreparation().Prepare();
  vtkImageData* const image = filter->GetTouchedImage();
  const bool isIsoSurface = image && awaited == MeshingWork && !filter->GetInputDataObject(2, 0);
  if (isIsoSurface)
  {
    return MakeValueProbe(filter, image);
  }
  return image && !awaited ? MakeFeelingProbe(filter) : nullptr;
}

/**
 * Finds the first contact of a tip that moves along a line, and the force of a press beyond it.
 * Returns false if there is no contact.
 */
bool Walk(const Line& line, Probe probe, Vector3& contact, Vector3& normal, Press* press)
{
  // Move in coarse steps, then in fine ones from shortly before the contact.
  constexpr int fineness = 16;
  constexpr int before = 2; // number of coarse steps from the contact back to the first fine step
  Probe again = probe;
  Felt felt;
  const auto steps = static_cast<int>(line.Length / line.Step);
  for (int i = 0; i <= steps; ++i)
  {
    if (probe(line.Start + (i * line.Step) * line.Sight, felt))
    {
      contact = line.Start + (i * line.Step) * line.Sight;
      for (int fine = 1 - before * fineness; fine <= 0; ++fine)
      {
        const Vector3 tip =
          line.Start + ((i + static_cast<double>(fine) / fineness) * line.Step) * line.Sight;
        if (again(tip, felt))
        {
          contact = tip;
          break;
        }
      }
      normal = felt.Normal;
      for (double depth = 0.0; press && depth < press->Depth;)
      {
        depth = std::min(depth + line.Step, press->Depth);
        again(contact + depth * line.Sight, felt);
        press->Force = felt.Force;
      }
      return true;
    }
  }
  return false;
}

} // namespace

Vector3 UnderPointer(vtkRenderer* renderer, const int pointer[2], const Vector3& depth)
{
  const double exact[2] = { static_cast<double>(pointer[0]), static_cast<double>(pointer[1]) };
  return UnderPointer(renderer, exact, depth);
}

Vector3 UnderPointer(vtkRenderer* renderer, const double pointer[2], const Vector3& depth)
{
  double display[3];
  double world[4];
  vtkInteractorObserver::ComputeWorldToDisplay(renderer, depth.X, depth.Y, depth.Z, display);
  vtkInteractorObserver::ComputeDisplayToWorld(renderer, pointer[0], pointer[1], display[2], world);
  return FromArray(world);
}

double PixelSize(vtkRenderer* renderer, const Vector3& position)
{
  const int here[2] = { 0, 0 };
  const int beside[2] = { 1, 0 };
  return Norm(UnderPointer(renderer, beside, position) - UnderPointer(renderer, here, position));
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

bool FindFirstContact(vtkRenderer* renderer, const Vector3& through, vtkVolumeHapticsFilter* filter,
  Vector3& position, Press* press)
{
  const Probe probe = MakeProbe(filter);
  if (!probe)
  {
    return false;
  }
  const Line line = MakeLine(renderer, through, filter->GetTouchedImage());
  Vector3 contact;
  Vector3 normal;
  if (!(line.Length > 0.0) || !Walk(line, probe, contact, normal, press))
  {
    return false;
  }
  position = contact - (0.5 * SmallestSpacing(filter->GetTouchedImage())) * line.Sight;
  return true;
}

bool FindContactAhead(vtkRenderer* renderer, const Vector3& from, vtkVolumeHapticsFilter* filter,
  Vector3& contact, Vector3& normal, Press* press)
{
  const Probe probe = MakeProbe(filter);
  if (!probe)
  {
    return false;
  }
  Line line = MakeLine(renderer, from, filter->GetTouchedImage());
  // If `from` is in front of the image, start where the line enters the image.
  const double gone = std::max(0.0, Dot(from - line.Start, line.Sight));
  line.Start = line.Start + gone * line.Sight;
  line.Length -= gone;
  normal = {};
  return line.Length > 0.0 && Walk(line, probe, contact, normal, press);
}

} // namespace VolumeHaptics
