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
 * The windows of a volume that moves before the present one. While the servo has one of them, the
 * frames that were given up with it are still in memory.
 */
class PastWindows
{
public:
  void Note(const std::shared_ptr<const BakedVolume>& window);
  /** Whether nobody has them any more, or a reader of states holds one for too long. */
  bool AreGone() const;

private:
  std::vector<std::weak_ptr<const BakedVolume>> Windows;
  std::int64_t Since = 0; ///< ns, of the last one
};

} // namespace VolumeHaptics

#endif
