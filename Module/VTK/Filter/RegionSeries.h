// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Models of regions of the same volume.
 */
#ifndef RegionSeries_h
#define RegionSeries_h

#include "Core/Model/HapticModel.h"
#include "VTK/Base/WholeFacts.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Gives models of regions of the same volume, with the same material and settings, the same number.
 */
class RegionSeries
{
public:
  /**
   * The number of one of the last models, if this is another region of the same volume; 0 if not.
   */
  std::uint64_t Find(const HapticModelDescription& description, const WholeFacts& facts,
    const std::string& array) const;
  void Note(const HapticModelDescription& description, const WholeFacts& facts,
    const std::string& array, std::uint64_t number);

private:
  struct Entry
  {
    HapticModelDescription Description;
    WholeFacts Facts;
    std::string Array;
    std::uint64_t Number = 0;
  };
  static bool IsSame(const Entry& entry, const HapticModelDescription& description,
    const WholeFacts& facts, const std::string& array);

  /** The latest is the last: models of a servo, and of other users of the same filter. */
  std::vector<Entry> Last;
};

} // namespace VolumeHaptics

#endif
