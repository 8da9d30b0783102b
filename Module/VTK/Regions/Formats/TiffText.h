// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What programs write into the description of TIFF files: the axes of the pages, sizes, names.
 */
#ifndef TiffText_h
#define TiffText_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** The facts that a description states about the pages and the distances between voxels. */
struct TiffText
{
  bool IsImageJ = false;
  double Spacing[3] = { 0.0, 0.0, 0.0 }; ///< mm; 0: not given
  std::size_t Slices = 0;                ///< 0: not given
  std::size_t Channels = 1;
  std::size_t Times = 1;
  std::string TimeName = "time"; ///< meaning of the times, if the description does not name it
  std::vector<std::string> ChannelNames;
  ///@{
  /** Number of pages from one slice, channel or time to the next. */
  std::size_t SliceStep = 1;
  std::size_t ChannelStep = 1;
  std::size_t TimeStep = 1;
  ///@}
  double PerUnit = 0.0; ///< mm for each unit of ImageJ's resolution
  /** ImageJ shows the value Line[0] + Line[1] * sample. */
  double Line[2] = { 0.0, 1.0 };
  bool IsCurved = false; ///< whether ImageJ's values follow another function
  std::size_t Whole = 0; ///< number of images after the first one that have no directory of
                         ///< their own
  /** All pages in their order, if they are in several files: names and numbers. */
  std::vector<std::pair<std::string, std::size_t>> Planes;

  /** Sets the steps along slices, channels and times; `order` begins with the fastest of them. */
  void SetOrder(const std::string& order);
};

/** Reads a number, whatever the user's locale is; `other` if the text has none. */
double ReadNumberOr(const char* text, double other);

/**
 * Reads the facts that ImageJ, tifffile or OME have written into the description; empty for other
 * programs.
 */
TiffText ReadTiffText(const std::string& description, const std::string& file);

} // namespace VolumeHaptics

#endif
