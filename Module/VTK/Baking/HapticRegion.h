// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What an image that is a region of a larger volume carries of the whole, as vtkHapticRegionFilter
 * documents it.
 */
#ifndef HapticRegion_h
#define HapticRegion_h

#include "Core/Model/HapticModel.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/** What a region knows of the whole. */
struct WholeFacts
{
  bool IsThere = false; ///< whether the image carries any of it
  int Extent[6] = {};   ///< of the whole volume
  double Noise = 0.0;   ///< scalar units, of the component
  double BorderValue = 0.0;
  double Time = 0.0; ///< another one when the whole has changed
};

/**
 * Reads the field arrays for a component. False, with the cure in `error`, where they are
 * malformed.
 */
bool ReadWholeFacts(vtkImageData* image, int component, WholeFacts& facts, std::string& error);

/** Lets a view of a region count its indices as the whole does. */
void PlaceInWhole(vtkImageData* image, const WholeFacts& facts, VolumeView& view);

/**
 * Gives models of regions of the same volume, with the same material and settings, the same number.
 */
class RegionSeries
{
public:
  /**
   * The number of one of the last models, if this is another region of what it was made of; 0 if
   * not.
   */
  std::uint64_t Find(const HapticModelDescription& description, const WholeFacts& facts,
    const std::string& array) const;
  void Note(const HapticModelDescription& description, const WholeFacts& facts,
    const std::string& array, std::uint64_t number);

private:
  struct Entry
  {
    HapticModelDescription Description;
    WholeFacts Facts;
    std::string Array;
    std::uint64_t Number = 0;
  };
  static bool IsSame(const Entry& a, const Entry& b);

  /** The latest last: a servo's and those of whoever else looks at the same filter. */
  std::vector<Entry> Last;
};

} // namespace VolumeHaptics

#endif
