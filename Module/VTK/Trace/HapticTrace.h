// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The trace: the record of every tick, as point arrays on polylines of proxy positions.
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
 * Memory for the ticks of all paths. TracePart fills it. It is allocated once; each of its pages is
 * first touched by the thread that writes it.
 */
class HapticTrace
{
public:
  HapticTrace(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume);
  ~HapticTrace();
  HapticTrace(const HapticTrace&) = delete;
  HapticTrace& operator=(const HapticTrace&) = delete;

  /**
   * Returns the tuples of the column whose numbers have this offset (bytes) in a TraceRow: the
   * proxy, or a chosen array. Null if the array is not chosen.
   */
  unsigned char* GetColumn(std::size_t offset) const { return this->Columns[offset]; }
  /** Returns the labels; null if they are not chosen. */
  long long* GetLabels() const { return this->LabelNumbers; }
  /**
   * Returns the forces of the modes, three numbers for each tick; null for a mode that is not
   * chosen.
   */
  const std::vector<double*>& GetModeForces() const { return this->ModeNumbers; }

  /**
   * Returns the orientations of the stylus, four numbers for each tick; null if they are not
   * chosen.
   */
  double* GetOrientations() const { return this->OrientationNumbers; }
  /** A chosen array of a tool. Only some tools have such arrays. */
  struct ToolArray
  {
    const ToolColumn* Column;
    double* Numbers;
  };
  const std::vector<ToolArray>& GetArraysOfTool() const { return this->ToolArrays; }

  /** Consecutive rows of the trace: the ticks of one path. */
  struct Rows
  {
    vtkIdType First;
    vtkIdType Count;
  };

  /**
   * Passes the rows of these paths to a polydata: points, arrays, and a polyline for each path. If
   * there is a single path with fewer than two ticks, it has no polyline. The rows must be in
   * ascending order; gaps between them are closed. `areSeveral` says that there are several
   * paths, so that each gets a polyline.
   */
  void WriteTo(vtkPolyData* output, const std::vector<Rows>& paths, bool areSeveral);

private:
  void AddToolArrays(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume);
  void CloseGaps(const std::vector<Rows>& paths);

  vtkNew<vtkPoints> Proxies;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::array<unsigned char*, sizeof(TraceRow)> Columns{}; ///< indexed by the offset in a TraceRow
  long long* LabelNumbers = nullptr;
  std::vector<double*> ModeNumbers; ///< empty if no mode is chosen
  double* OrientationNumbers = nullptr;
  std::vector<ToolArray> ToolArrays;
};

/** Number of records that fit into the CPU cache along with the data that a tick reads. */
constexpr std::size_t FewRecords = 32;

/**
 * Collects a few records of consecutive ticks, and then writes them to the trace on the same
 * thread. Several threads may each write a part.
 */
class TracePart
{
public:
  /** `work` carries its sum from one part of a path to the next. */
  TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work);

  /** Returns the record that the next Append() adds. Write all of its members before. */
  TickRecord& GetNext() { return this->Records[this->Filled]; }
  /**
   * Adds the record of GetNext(). `forces` are the modes' forces on device axes, if the trace has
   * modes.
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
  /** Writes the remaining records. */
  void Flush();

private:
  /** Sets another model for the next record, because its tick used that model. */
  void Replace(const std::shared_ptr<const HapticModel>& model);
  void WriteModeForces(const ModeForces& forces);

  const HapticTrace& Trace;
  vtkIdType Next;
  std::size_t Filled = 0;
  std::shared_ptr<const HapticModel> Model; ///< model of the records
  std::array<TickRecord, FewRecords> Records;
  std::array<double, FewRecords> Times; ///< s
  WorkMeter& Work;
};

} // namespace VolumeHaptics

#endif
