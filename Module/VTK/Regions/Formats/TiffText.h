// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses the descriptions that programs write to TIFF files: axes of the pages, sizes and names.
 */
#ifndef TiffText_h
#define TiffText_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** Facts in a description about the pages and the distances between voxels. */
struct TiffText
{
  bool IsImageJ = false;
  double Spacing[3] = { 0.0, 0.0, 0.0 }; ///< mm; 0: not given
  std::size_t Slices = 0;                ///< 0: not given
  std::size_t Channels = 1;
  std::size_t Times = 1;
  std::string TimeName = "time"; ///< name of the time axis, such as "volume" if its meaning is
                                 ///< unknown
  std::vector<std::string> ChannelNames;
  ///@{
  /** Number of pages between neighbouring slices, channels or times. */
  std::size_t SliceStep = 1;
  std::size_t ChannelStep = 1;
  std::size_t TimeStep = 1;
  ///@}
  double PerUnit = 0.0; ///< mm per unit of ImageJ's resolution
  /** Slope and offset of ImageJ's calibration: value = Line[0] + Line[1] * sample. */
  double Line[2] = { 0.0, 1.0 };
  bool IsCurved = false; ///< whether ImageJ's calibration is not linear
  std::size_t Whole = 0; ///< number of images after the first that have no directory
  /** All pages in order if they are in several files: the file's name and the page's index. */
  std::vector<std::pair<std::string, std::size_t>> Planes;

  /** Sets the steps of slices, channels and times from the order of these axes, fastest first. */
  void SetOrder(const std::string& order);
};

/** Parses a number in any locale; returns `other` if the text has none. */
double ReadNumberOr(const char* text, double other);

/** Parses the description by ImageJ, tifffile or OME; returns no facts for other programs. */
TiffText ReadTiffText(const std::string& description, const std::string& file);

} // namespace VolumeHaptics

#endif
