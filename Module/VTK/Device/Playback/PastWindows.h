// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PastWindows_h
#define PastWindows_h

#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
struct BakedVolume;

/**
 * Earlier windows of a volume that moves. While the servo uses one of them, the frames that were
 * released with it are still in memory.
 */
class PastWindows
{
public:
  void Note(const std::shared_ptr<const BakedVolume>& window);
  /** Whether no earlier window is in use any more, or a reader of states holds one for too long. */
  bool AreGone() const;

private:
  std::vector<std::weak_ptr<const BakedVolume>> Windows;
  std::int64_t Since = 0; ///< time when the last window was added (ns)
};

} // namespace VolumeHaptics

#endif
