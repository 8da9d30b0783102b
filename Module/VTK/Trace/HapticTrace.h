// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The trace: the record of every tick, as polylines of proxy positions with point arrays.
 */
#ifndef HapticTrace_h
#define HapticTrace_h

#include "VTK/Trace/TraceArrayChoice.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

/** A column of a trace in memory. */
struct TraceMemory
{
  unsigned char* Tuples;
  std::size_t Width;  ///< bytes of a tuple
  std::size_t Offset; ///< of a tuple in a TraceRow
};

struct BakedVolume;

/**
 * Memory for the ticks of all paths, which TracePart fills. It is allocated once, and its pages are
 * first touched by the thread that writes them.
 */
class HapticTrace
{
public:
  HapticTrace(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume);
  ~HapticTrace();
  HapticTrace(const HapticTrace&) = delete;
  HapticTrace& operator=(const HapticTrace&) = delete;

  /** The proxy and the chosen arrays but the labels. */
  const std::vector<TraceMemory>& GetMemory() const { return this->Memory; }
  /** The labels; null if they are not chosen. */
  long long* GetLabels() const { return this->LabelNumbers; }
  /** Whether the values at the proxy are chosen. */
  bool HasValues() const { return this->Values; }
  /** The forces of each mode, three numbers a tick; null for those that are not chosen. */
  const std::vector<double*>& GetModeForces() const { return this->ModeNumbers; }

  /** Some rows of the trace: the ticks of one path. */
  struct Rows
  {
    vtkIdType First;
    vtkIdType Count;
  };

  /**
   * Passes these rows of points and arrays to a polydata, with a polyline for each path. A single
   * path has none if it has less than two ticks. The rows come in rising order; gaps between them
   * are closed.
   */
  void WriteTo(vtkPolyData* output, const std::vector<Rows>& paths, bool areSeveral);

private:
  void CloseGaps(const std::vector<Rows>& paths);

  vtkNew<vtkPoints> Proxies;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::vector<TraceMemory> Memory;
  long long* LabelNumbers = nullptr;
  bool Values = false;
  std::vector<double*> ModeNumbers; ///< none if no mode is chosen
};

} // namespace VolumeHaptics

#endif
