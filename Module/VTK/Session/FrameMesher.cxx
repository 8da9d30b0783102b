// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Session/FrameMesher.h"

#include "VTK/Baking/HapticSurface.h"

#include "vtkDataArray.h"

#include <optional>

namespace VolumeHaptics
{

bool FrameMesher::Follow(const BakedVolume& volume, int component, std::vector<VolumeFrame>& frames)
{
  for (std::size_t i = 0; volume.Mesh && i + 1 < frames.size(); ++i)
  {
    if (frames[i].Mesh)
    {
      continue;
    }
    const auto make = [frame = frames[i], next = frames[i + 1], component,
                        value = volume.Settings.IsoValue, map = volume.IndexToWorld]
    { return MeshFrame(frame, next, component, value, map); };
    // Arrays of another layout make a copy of their values for their readers, one for all threads.
    // See ShareArray of the model's builder.
    auto* const scalars = static_cast<vtkDataArray*>(const_cast<void*>(frames[i].Samples.get()));
    if (!scalars->HasStandardMemoryLayout())
    {
      frames[i].Mesh = make();
      continue;
    }
    const Key key{ frames[i].Samples.get(), frames[i + 1].Samples.get() };
    const auto* const made =
      this->Meshing.Follow(key, [make](WorkMonitor&) { return std::optional(make()); });
    if (!made)
    {
      return false;
    }
    frames[i].Mesh = *made;
    this->Meshing.Forget(); // other frames may come to the same place
  }
  return true;
}

} // namespace VolumeHaptics
