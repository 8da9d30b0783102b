// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The trace: what every tick did, as a polyline of proxy positions with point arrays.
 */
#ifndef HapticTrace_h
#define HapticTrace_h

#include "ServoTick.h"

#include "vtkNew.h"
#include "vtkType.h"

class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace VolumeHaptics
{

/** Collects records in device space and turns them into the world of the model's image. */
class HapticTrace
{
public:
  HapticTrace();
  ~HapticTrace();
  HapticTrace(const HapticTrace&) = delete;
  HapticTrace& operator=(const HapticTrace&) = delete;

  void Reserve(vtkIdType ticks);
  void Append(const HapticModel& model, double time, const TickRecord& record);

  /** Hand the points and arrays to a polydata, with one polyline through all points. */
  void WriteTo(vtkPolyData* output);

private:
  /** Work (J) that the hand has been given, up to a tick. */
  double AddWork(const TickRecord& record);

  vtkNew<vtkPoints> Proxies;
  vtkNew<vtkDoubleArray> Time;
  vtkNew<vtkDoubleArray> Tip;
  vtkNew<vtkDoubleArray> Force;
  vtkNew<vtkDoubleArray> NormalForce;
  vtkNew<vtkDoubleArray> FrictionForce;
  vtkNew<vtkDoubleArray> DragForce;
  vtkNew<vtkDoubleArray> Normal;
  vtkNew<vtkDoubleArray> Value;
  vtkNew<vtkDoubleArray> GradientMagnitude;
  vtkNew<vtkDoubleArray> SurfaceValue;
  vtkNew<vtkDoubleArray> MediumValue;
  vtkNew<vtkDoubleArray> Stiffness;
  vtkNew<vtkDoubleArray> Friction;
  vtkNew<vtkDoubleArray> Viscosity;
  vtkNew<vtkDoubleArray> SurfaceStrength;
  vtkNew<vtkUnsignedCharArray> Contact;
  vtkNew<vtkUnsignedCharArray> Unfinished;
  vtkNew<vtkUnsignedCharArray> Renewed;
  vtkNew<vtkDoubleArray> Energy;
  Vector3 LastTip;
  Vector3 LastForce;
  double Work = 0.0;
};

} // namespace VolumeHaptics

#endif
