// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The trace: the record of every tick, as a polyline of proxy positions with point arrays.
 */
#ifndef HapticTrace_h
#define HapticTrace_h

#include "VTK/Trace/TraceRow.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkLongLongArray;
class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

/** Collects records in device space and transforms them into the world of the model's image. */
class HapticTrace
{
public:
  HapticTrace();
  ~HapticTrace();
  HapticTrace(const HapticTrace&) = delete;
  HapticTrace& operator=(const HapticTrace&) = delete;

  void Reserve(vtkIdType ticks);
  void Append(const HapticModel& model, double time, const TickRecord& record);

  /** Passes the points and arrays to a polydata, with one polyline through all points. */
  void WriteTo(vtkPolyData* output);

private:
  vtkNew<vtkPoints> Proxies;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; // of GetTraceColumns
  vtkSmartPointer<vtkLongLongArray> Labels;          // null without a label image
  WorkMeter Work;
};

} // namespace VolumeHaptics

#endif
