// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HeardTicks_h
#define Explore_HeardTicks_h

#include "Applications/Explorer/Sound/SoundTick.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVolumeHapticsFilter.h"

#include <cstdint>
#include <vector>

namespace Explore
{
/// Extracts from ticks the data that sound depends on. The forces are those sent to the device:
/// zero while it is not armed. Stiffness and strength come from the material, that is, from the
/// filter's functions of SurfaceValue or from its table of labels. The trace's own values can't be
/// used, because they are the felt values: capped, equalised by SameShape, and lowered by
/// distinctness.
class HeardTicks
{
public:
  explicit HeardTicks(vtkVolumeHapticsFilter* filter);

  /// Extracts the ticks of the states that were drained since the last call: see
  /// vtkHapticState::Drain. `label` is the label of the latest state.
  std::vector<SoundTick> Read(vtkTable* states, std::int64_t label);
  /// Extracts the ticks of a filter's trace, or of a recording.
  std::vector<SoundTick> Read(vtkPolyData* trace);

private:
  struct Columns;
  std::vector<SoundTick> Read(const Columns& columns, std::int64_t label);
  void SetMaterial(SoundTick& tick, double value, std::int64_t label) const;

  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  double Proxy[3] = { 0.0, 0.0, 0.0 }; // proxy of the last tick (world)
  double Time = 0.0;                   // time of the last tick (s)
  bool HasProxy = false;
};
} // namespace Explore

#endif
