// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Stores the trace: the records of all ticks, as point arrays on polylines of proxy positions.
 */
#ifndef HapticTrace_h
#define HapticTrace_h

#include "Core/Model/BakedTool.h"
#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "Core/State/TickRecord.h"
#include "VTK/Trace/TraceArrayChoice.h"
#include "VTK/Trace/TraceRow.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

struct BakedVolume;

/**
 * Memory for the ticks of all paths, filled by TracePart. It is allocated once; each page is first
 * touched by the thread that writes it.
 */
class HapticTrace
{
public:
  HapticTrace(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume);
  ~HapticTrace();
  HapticTrace(const HapticTrace&) = delete;
  HapticTrace& operator=(const HapticTrace&) = delete;

  /**
   * Returns the tuples of the column for the TraceRow member at this offset (bytes): the proxy, or
   * a chosen array. Null if the array is not chosen.
   */
  unsigned char* GetColumn(std::size_t offset) const { return this->Columns[offset]; }
  /** Returns the labels; null if they are not chosen. */
  long long* GetLabels() const { return this->LabelNumbers; }
  /**
   * Returns the forces of the modes, three numbers per tick; null for a mode that is not chosen.
   */
  const std::vector<double*>& GetModeForces() const { return this->ModeNumbers; }

  /** Returns the orientations of the stylus, four numbers per tick; null if they are not chosen. */
  double* GetOrientations() const { return this->OrientationNumbers; }
  /** A chosen array that only some tools have. */
  struct ToolArray
  {
    const ToolColumn* Column;
    double* Numbers;
  };
  const std::vector<ToolArray>& GetArraysOfTool() const { return this->ToolArrays; }

  /** Range of rows of the trace with the ticks of one path. */
  struct Rows
  {
    vtkIdType First;
    vtkIdType Count;
  };

  /**
   * Moves the rows of these paths to a polydata: points, arrays, and a polyline per path. A single
   * path with fewer than two ticks gets no polyline. The rows must be in ascending order; gaps
   * between them are closed. `areSeveral`: there are several paths, so that each gets a polyline.
   */
  void WriteTo(vtkPolyData* output, const std::vector<Rows>& paths, bool areSeveral);

private:
  void AddToolArrays(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume);
  void CloseGaps(const std::vector<Rows>& paths);

  vtkNew<vtkPoints> Proxies;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::array<unsigned char*, sizeof(TraceRow)> Columns{}; ///< by the offset in a TraceRow
  long long* LabelNumbers = nullptr;
  std::vector<double*> ModeNumbers; ///< empty if no mode is chosen
  double* OrientationNumbers = nullptr;
  std::vector<ToolArray> ToolArrays;
};

/** Number of records that fit into the CPU cache together with the data that a tick reads. */
constexpr std::size_t FewRecords = 32;

/**
 * Collects a few records of consecutive ticks, and then writes them to the trace on the same
 * thread. Several threads may write different parts.
 */
class TracePart
{
public:
  /** `work` passes its sum from one part of a path to the next. */
  TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work);

  /** Returns the record that the next Append() adds. Write all of its members first. */
  TickRecord& GetNext() { return this->Records[this->Filled]; }
  /**
   * Adds the record of GetNext(). `forces` are the forces of the modes (device axes), if the trace
   * has modes.
   */
  void Append(const std::shared_ptr<const HapticModel>& model, double time,
    const ModeForces* forces = nullptr)
  {
    if (this->Model != model)
    {
      this->Replace(model);
    }
    if (forces)
    {
      this->WriteModeForces(*forces);
    }
    this->Times[this->Filled] = time;
    if (++this->Filled == FewRecords)
    {
      this->Flush();
    }
  }
  /** Writes the records that are still buffered. */
  void Flush();

private:
  /** Sets the model of the next records, after writing the records that used the previous one. */
  void Replace(const std::shared_ptr<const HapticModel>& model);
  void WriteModeForces(const ModeForces& forces);

  const HapticTrace& Trace;
  vtkIdType Next;
  std::size_t Filled = 0;
  std::shared_ptr<const HapticModel> Model; ///< model of the buffered records
  std::array<TickRecord, FewRecords> Records;
  std::array<double, FewRecords> Times; ///< s
  WorkMeter& Work;
};

} // namespace VolumeHaptics

#endif
