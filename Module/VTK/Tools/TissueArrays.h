// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads remaining tissue as field arrays of traces and recordings, and as plain
 * numbers for files.
 *
 * Two arrays have a tuple for each brick of 8 x 8 x 8 samples from which tissue was removed: its
 * position along each axis, in bricks from the volume's first sample, and the fraction of tissue
 * that remains at each sample, x first; 255 stands for all of it.
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

/** The names of the two arrays. */
struct TissueArrayNames
{
  const char* Bricks;
  const char* Fractions;
};

/** Arrays of the tick at which a recording begins. */
constexpr TissueArrayNames InitialTissueNames{ "InitialBricks", "InitialShares" };
/** Arrays of the last tick of a trace. */
constexpr TissueArrayNames FinalTissueNames{ "FinalBricks", "FinalShares" };

///@{
/** Return the two tuples of a brick. */
std::array<std::int32_t, 3> PlaceOfBrick(const BrickTissue& brick);
std::array<unsigned char, SamplesOfBrick> TissueAsBytes(const BrickTissue& brick);
///@}

/** Adds the arrays; they have no tuples if there are no bricks. */
void AddTissueArrays(
  const std::vector<BrickTissue>& bricks, const TissueArrayNames& names, vtkFieldData* data);

/**
 * Reads the arrays; if both are missing, all tissue remains. Returns false if they can't be read,
 * with the array and its fault in `flaw`, such as "its array "FinalShares" is missing".
 */
bool ReadTissueArrays(vtkFieldData* data, const TissueArrayNames& names,
  std::vector<BrickTissue>& bricks, std::string& flaw);

} // namespace VolumeHaptics

#endif
