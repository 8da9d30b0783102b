// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts remaining tissue to field arrays of traces and recordings, or to plain numbers for
 * files, and back.
 *
 * Two arrays have a tuple for each brick of 8 x 8 x 8 samples from which tissue was removed. The
 * first array has the brick's position along each axis, in bricks from the volume's first sample.
 * The second one has the remaining fraction of tissue at each sample, x fastest; 255 stands for all
 * of it.
 */
#ifndef TissueArrays_h
#define TissueArrays_h

#include "Core/Carving/TissueSnapshot.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkFieldData;

namespace VolumeHaptics
{

constexpr int SamplesOfBrick = CarvedBricks::Side * CarvedBricks::Rows;

/** Names of the two arrays. */
struct TissueArrayNames
{
  const char* Bricks;
  const char* Fractions;
};

/** Names of the arrays for the tick at which a recording starts. */
constexpr TissueArrayNames InitialTissueNames{ "InitialBricks", "InitialShares" };
/** Names of the arrays for the last tick of a trace. */
constexpr TissueArrayNames FinalTissueNames{ "FinalBricks", "FinalShares" };

///@{
/** Return a brick's tuples in the two arrays. */
std::array<std::int32_t, 3> PlaceOfBrick(const BrickTissue& brick);
std::array<unsigned char, SamplesOfBrick> TissueAsBytes(const BrickTissue& brick);
///@}

/** Adds the arrays, which are empty if there are no bricks. */
void AddTissueArrays(
  const std::vector<BrickTissue>& bricks, const TissueArrayNames& names, vtkFieldData* data);

/**
 * Reads the arrays. If both are missing, all tissue remains. On failure, returns false, with the
 * array and its fault in `flaw`, such as "its array "FinalShares" is missing".
 */
bool ReadTissueArrays(vtkFieldData* data, const TissueArrayNames& names,
  std::vector<BrickTissue>& bricks, std::string& flaw);

} // namespace VolumeHaptics

#endif
