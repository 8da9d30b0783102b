// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/FrameMesher.h"

#include "VTK/Baking/HapticSurface.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <optional>

namespace VolumeHaptics
{

bool FrameMesher::Follow(std::vector<VolumeFrame>& frames, const std::vector<int>& components,
  double value, const Affine3& indexToWorld)
{
  for (std::size_t i = 0; i < frames.size() && (i + 1 < frames.size() || i == 0); ++i)
  {
    if (frames[i].Mesh)
    {
      continue;
    }
    const std::size_t after = std::min(i + 1, frames.size() - 1);
    const auto make =
      [frame = frames[i], next = frames[after], component = components[i], value, indexToWorld]
    { return MeshFrame(frame, next, component, value, indexToWorld); };
    // Arrays of other layouts copy their values for readers, into one copy for all threads. See
    // ShareArray() of the model's builder.
    auto* const scalars = static_cast<vtkDataArray*>(const_cast<void*>(frames[i].Samples.get()));
    if (!scalars->HasStandardMemoryLayout())
    {
      frames[i].Mesh = make();
      continue;
    }
    const Key key{ frames[i].Samples.get(), frames[after].Samples.get(), components[i] };
    if (!this->Meshing.IsOf(key) && this->Meshing.IsUnderWay())
    {
      this->Meshing.Abandon(); // ends without waiting
      return false;
    }
    const auto* const made =
      this->Meshing.Follow(key, [make](WorkMonitor&) { return std::optional(make()); });
    if (!made)
    {
      return false;
    }
    frames[i].Mesh = *made;
    this->Meshing.Forget(); // other frames may get the same address
  }
  return true;
}

} // namespace VolumeHaptics
