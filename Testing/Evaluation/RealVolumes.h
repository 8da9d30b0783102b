// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All real volumes at hand, as the explorer shows and touches them.
 */
#ifndef Evaluation_RealVolumes_h
#define Evaluation_RealVolumes_h

#include "Figure.h"
#include "Table.h"

#include <string>

namespace evaluation
{

/** Where the volumes are; those without a place are left out. */
struct VolumePlaces
{
  std::string Head;   ///< file
  std::string Chest;  ///< folder, as for ReadChest()
  std::string Others; ///< folder that get_real_volumes of Data/scans.sh fills
  std::string Only;   ///< part of the names of the lines ("volume, preset") that are wanted
};

/**
 * A line for each volume and each preset that is meant for it: presses from all sides, and strokes
 * over the outer surface. Prints the lines as they come, and the table.
 */
Table MeasureRealVolumes(const VolumePlaces& places, const Effort& effort);

} // namespace evaluation

#endif
