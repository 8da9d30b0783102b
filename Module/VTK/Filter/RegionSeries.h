// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects models of regions that belong to the same volume.
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
 * Numbers models. Models of regions of the same volume with the same material and settings get the
 * same number.
 */
class RegionSeries
{
public:
  /**
   * Returns the number of an earlier model of another region of the same volume; 0 if there is
   * none.
   */
  std::uint64_t Find(const HapticModelDescription& description, const WholeFacts& facts,
    const std::string& array) const;
  void Record(const HapticModelDescription& description, const WholeFacts& facts,
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

  /** Recent models of all users of the same filter, such as several servos; the latest is last. */
  std::vector<Entry> Last;
};

} // namespace VolumeHaptics

#endif
