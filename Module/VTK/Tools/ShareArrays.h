// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads remaining tissue as field arrays of traces and recordings, and as plain
 * numbers for files.
 *
 * Two arrays have a tuple for each brick of 8 x 8 x 8 samples from which tissue was removed: its
 * position along each axis, in bricks from the volume's first sample, and the share of tissue that
 * remains at each sample, x first; 255 stands for all of it.
 */
#ifndef ShareArrays_h
#define ShareArrays_h

#include "Core/Carving/ShareSnapshot.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkFieldData;

namespace VolumeHaptics
{

constexpr int SharesOfBrick = CarvedBricks::Side * CarvedBricks::Rows;

/** The names of the two arrays. */
struct ShareArrayNames
{
  const char* Bricks;
  const char* Shares;
};

/** Arrays of the tick at which a recording begins. */
constexpr ShareArrayNames InitialShareNames{ "InitialBricks", "InitialShares" };
/** Arrays of the last tick of a trace. */
constexpr ShareArrayNames FinalShareNames{ "FinalBricks", "FinalShares" };

///@{
/** Return the two tuples of a brick. */
std::array<std::int32_t, 3> PlaceOfBrick(const BrickShares& brick);
std::array<unsigned char, SharesOfBrick> SharesAsBytes(const BrickShares& brick);
///@}

/** Adds the arrays; they have no tuples if there are no bricks. */
void AddShareArrays(
  const std::vector<BrickShares>& bricks, const ShareArrayNames& names, vtkFieldData* data);

/**
 * Reads the arrays; if both are missing, all tissue remains. False if they can't be read, with the
 * array and its fault in `flaw`, such as "its array "FinalShares" is missing".
 */
bool ReadShareArrays(vtkFieldData* data, const ShareArrayNames& names,
  std::vector<BrickShares>& bricks, std::string& flaw);

} // namespace VolumeHaptics

#endif
