// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomSeries_h
#define Explore_DicomSeries_h

#include "VTK/Reading/Dicom/DicomHeader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Slices of one DICOM series with the same size and orientation.
struct DicomSeries
{
  std::vector<DicomHeader> Slices; // sorted by their positions along the normal
  // For a moving volume: the slices of the later phases, the times (s) of all phases (or their
  // indices if the files state no times), and the fact in which the phases differ.
  std::vector<std::vector<DicomHeader>> MorePhases = {};
  std::vector<double> Times = {};
  std::string PhasesBy = {};
  bool HaveTimes = false;
  // Fact in which volumes of the same DICOM series differ, such as "EchoTime 4.6".
  std::string Kind = {};
  std::size_t Copies = 0;          // number of duplicate slices that were removed
  bool IsPlacedByLocation = false; // whether positions come from SliceLocation

  /// Returns whether a file contains a slice of this series.
  bool Holds(const std::string& file) const;
  /// Returns a text such as `4 "Thorax", CT, 133 slices of 512 x 512`, with the series' number
  /// first.
  std::string Describe(std::size_t number) const;
};

/// What a folder contains in addition to slices.
struct DicomFolderFacts
{
  bool HasFolders = false;
  std::string Device = {}; // first pipe or device, as described by DetectDevice()
};

/// Lists all series in a folder and the folders below it, in the order of the scanner's series
/// numbers. Sets `facts` to what else was found. For `named`, see SortDicomSlices().
std::vector<DicomSeries> ListDicomSeries(
  const std::string& folder, DicomFolderFacts& facts, const std::string& named = {});

/// Sorts slices into series and removes duplicates: keeps the one in the file `named`, or otherwise
/// one that is complete. Slices of several volumes become several series.
std::vector<DicomSeries> SortDicomSlices(
  const std::vector<DicomHeader>& slices, const std::string& named = {});

/// Returns the index of the series with the most pixels among those with enough slices for a
/// volume.
std::size_t FindLargest(const std::vector<DicomSeries>& series);

/// Returns whether each folder contains exactly one series, with slices of the same size at the
/// same positions, so that the folders are the phases of a moving volume.
bool ArePhases(const std::vector<std::string>& folders);
} // namespace Explore

#endif
