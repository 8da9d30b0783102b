// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The facts about a large volume, from some of its samples.
 */
#ifndef VolumeSurvey_h
#define VolumeSurvey_h

#include "Core/Field/Estimates/BackgroundLevel.h"
#include "Core/Field/Estimates/OutsideSamples.h"
#include "Core/Field/Estimates/StoredShift.h"
#include "Core/Field/NoiseSamples.h"
#include "VTK/Regions/Formats/LargeVolume.h"

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** See the field arrays of vtkHapticRegionFilter. */
struct VolumeFacts
{
  double Noise = 0.0;
  double BorderValue = 0.0;
  OutsideSamples Outside; ///< with which each region is filled
  BackgroundLevel Solid;
  StoredShift Shift;
};

/**
 * Reads the boxes from which the noise is estimated (NoiseEstimate.h), one after another: 512
 * blocks of 5^3 samples and the corners. If the volume is not large, that is all of it, in boxes of
 * a million samples at most. The result is that of the whole in memory, to the bit.
 */
class VolumeSurvey
{
public:
  /** The volume has to live longer. */
  explicit VolumeSurvey(const LargeVolume& volume);

  bool IsDone() const { return this->Next == this->Boxes.size(); }
  /** Reads a box. False, with an error, if that fails; it may be tried again. */
  bool Advance(std::string& error);
  /** If it is done. */
  VolumeFacts GetFacts() const;

private:
  template <typename T>
  void Collect(const BoxExtent& box);

  const LargeVolume& Volume;
  std::vector<BoxExtent> Boxes;
  std::size_t Next = 0;
  std::vector<char> Bytes; // of the last box
  NoiseSamples Samples;
};

} // namespace VolumeHaptics

#endif
