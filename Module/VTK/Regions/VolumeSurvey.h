// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the facts about a large volume from some of its samples.
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

/** Facts about a volume that vtkHapticRegionFilter stores as field arrays. */
struct VolumeFacts
{
  double Noise = 0.0;
  double BorderValue = 0.0;
  OutsideSamples Outside; ///< outside samples that each region has to fill
  BackgroundLevel Solid;
  StoredShift Shift;
};

/**
 * Reads the boxes from which the noise is estimated (NoiseEstimate.h), one after another: 512
 * blocks of 5^3 samples and the corners. Reads a volume that is not large completely, in boxes of
 * at most a million samples. The result is bit-identical to that for the whole volume in memory.
 */
class VolumeSurvey
{
public:
  /** Prepares the survey of a volume. The volume must outlive this object. */
  explicit VolumeSurvey(const LargeVolume& volume);

  bool IsDone() const { return this->Next == this->Boxes.size(); }
  /** Reads the next box. On failure, returns false with an error, and may be called again. */
  bool Advance(std::string& error);
  /** Returns the facts; valid once all boxes are read. */
  VolumeFacts GetFacts() const;

private:
  template <typename T>
  void Collect(const BoxExtent& box);

  const LargeVolume& Volume;
  std::vector<BoxExtent> Boxes;
  std::size_t Next = 0;
  std::vector<char> Bytes; // samples of the last box
  NoiseSamples Samples;
};

} // namespace VolumeHaptics

#endif
