// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Facts about a whole volume that are attached to an image of one of its regions.
 */
#ifndef WholeFacts_h
#define WholeFacts_h

#include "Core/Field/Estimates/BackgroundLevel.h"
#include "Core/Field/Estimates/OutsideSamples.h"
#include "Core/Field/Estimates/StoredShift.h"

#include <string>
#include <vector>

class vtkImageData;

namespace VolumeHaptics
{

/** The names of the field arrays that vtkHapticRegionFilter documents. */
struct WholeFactNames
{
  static constexpr const char* WholeExtent = "HapticWholeExtent";
  static constexpr const char* Noise = "HapticNoise";
  static constexpr const char* BorderValue = "HapticBorderValue";
  static constexpr const char* WholeTime = "HapticWholeTime";
  static constexpr const char* Solid = "HapticSolid";
  static constexpr const char* Shift = "HapticShift";
  static constexpr const char* Share = "HapticShare";
  static constexpr const char* Outside = "HapticOutside";
};

/** Values of those field arrays for one component. */
struct WholeFacts
{
  bool IsThere = false; ///< whether the image has one of these arrays, and so is a region
  int Extent[6] = {};   ///< extent of the whole volume
  double Noise = 0.0;   ///< standard deviation of the component's noise (scalar units)
  double BorderValue = 0.0;
  BackgroundLevel Solid; ///< absent if the image lacks its array
  StoredShift Shift;     ///< 0 if the image lacks its array
  double Time = 0.0;     ///< a value that changes whenever the whole volume changes
  /**
   * Factor on the force; below 1 while the samples temporarily replace those of the whole volume.
   */
  double Share = 1.0;
  OutsideSamples Outside; ///< which samples still have to be filled, and the number of holes
};

/** Reads the field arrays. Returns false, with the cure in `error`, if they are malformed. */
bool ReadWholeFacts(vtkImageData* image, int component, WholeFacts& facts, std::string& error);

/** Facts about a whole volume, for all components of an image. */
struct WholeFields
{
  int Extent[6] = {};
  std::vector<double> Noise;
  std::vector<double> BorderValues;
  std::vector<BackgroundLevel> Solids;
  std::vector<StoredShift> Shifts;
  double Time = 0.0;
  double Share = 1.0;
  std::vector<OutsideSamples> Outside; ///< empty if the outside samples are already filled
};

/** Writes the facts about the whole volume into field arrays of a region's image. */
void WriteWholeFacts(const WholeFields& facts, vtkImageData* region);

} // namespace VolumeHaptics

#endif
