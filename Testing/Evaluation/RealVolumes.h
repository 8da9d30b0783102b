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

/** Paths of the volumes. Volumes without a path are left out. */
struct VolumePlaces
{
  std::string Head;   ///< file
  std::string Chest;  ///< folder, as for ReadChest()
  std::string Others; ///< folder that get_real_volumes in Data/scans.sh fills
  std::string Only;   ///< part of the names ("volume, preset") of the wanted lines
};

/**
 * Measures a line for each volume and each preset that is meant for it: presses from all sides, and
 * strokes over the outer surface. Prints each line when it is complete. Returns the table.
 */
Table MeasureRealVolumes(const VolumePlaces& places, const Effort& effort);

} // namespace evaluation

#endif
