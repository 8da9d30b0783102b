// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomSeries_h
#define Explore_DicomSeries_h

#include "VTK/Reading/Dicom/DicomHeader.h"

#include <string>
#include <vector>

namespace Explore
{
/// The slices of one size and orientation that a scanner has made as one series.
struct DicomSeries
{
  std::vector<DicomHeader> Slices; // in the order of their positions along the normal
  // If the volume moves: the slices of the later phases, the times of all phases (s, or numbers
  // from 0 on if the files have no time), and the fact that tells the phases apart.
  std::vector<std::vector<DicomHeader>> MorePhases = {};
  std::vector<double> Times = {};
  std::string PhasesBy = {};
  bool HaveTimes = false;
  std::string Kind = {};           // tells volumes in a series apart, such as "EchoTime 4.6"
  std::size_t Copies = 0;          // slices that were found twice
  bool IsPlacedByLocation = false; // whether places are from SliceLocation

  /// Whether a file belongs to the series.
  bool Holds(const std::string& file) const;
  /// Returns a text such as `4 "Thorax", CT, 133 slices of 512 x 512`, with the number in a list.
  std::string Describe(std::size_t number) const;
};

/// Lists all series in a folder and the folders below it, in the order of the numbers that the
/// scanner has given them. `hasFolders` is set if there were folders.
std::vector<DicomSeries> ListDicomSeries(const std::string& folder, bool& hasFolders);

/// Sorts slices into series, without copies. Slices of several volumes become several series.
std::vector<DicomSeries> SortDicomSlices(const std::vector<DicomHeader>& slices);

/// Returns the series with most pixels, among those with enough slices for a volume.
std::size_t FindLargest(const std::vector<DicomSeries>& series);

/// Whether each folder holds one series, with slices of the same size at the same places: the
/// phases of a moving volume.
bool ArePhases(const std::vector<std::string>& folders);
} // namespace Explore

#endif
