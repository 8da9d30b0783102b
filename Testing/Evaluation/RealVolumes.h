// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All available real volumes, as the explorer shows and touches them.
 */
#ifndef Evaluation_RealVolumes_h
#define Evaluation_RealVolumes_h

#include "Figure.h"
#include "Table.h"

#include <string>

namespace evaluation
{

/** Paths of the volumes. A volume with an empty path is left out. */
struct VolumePlaces
{
  std::string Head;   ///< file
  std::string Chest;  ///< folder, as for ReadChest()
  std::string Others; ///< folder that get_real_volumes of Data/scans.sh fills
  std::string Only;   ///< part of the names ("volume, preset") of the lines to measure
};

/**
 * Measures a line for each combination of a volume and one of its presets: presses from all sides,
 * and strokes over the outer surface. Prints each line as soon as it is complete. Returns the
 * table.
 */
Table MeasureRealVolumes(const VolumePlaces& places, const Effort& effort);

} // namespace evaluation

#endif
