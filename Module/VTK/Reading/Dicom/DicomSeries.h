// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomSeries_h
#define Explore_DicomSeries_h

#include "VTK/Reading/Dicom/DicomHeader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Slices of the same size and orientation that a scanner has made as one series.
struct DicomSeries
{
  std::vector<DicomHeader> Slices; // in the order of their positions along the normal
  // For a moving volume: the slices of the later phases, the times of all phases (s, or their
  // numbers if the files have no times), and the fact in which the phases differ.
  std::vector<std::vector<DicomHeader>> MorePhases = {};
  std::vector<double> Times = {};
  std::string PhasesBy = {};
  bool HaveTimes = false;
  // fact in which volumes of the same series differ, such as "EchoTime 4.6"
  std::string Kind = {};
  std::size_t Copies = 0;          // number of slices that were found twice
  bool IsPlacedByLocation = false; // whether positions come from SliceLocation

  /// Returns whether a file belongs to the series.
  bool Holds(const std::string& file) const;
  /// Returns a text such as `4 "Thorax", CT, 133 slices of 512 x 512`, which begins with the number
  /// in a list.
  std::string Describe(std::size_t number) const;
};

/// What a folder has beside slices.
struct DicomFolderFacts
{
  bool HasFolders = false;
  std::string Device = {}; // first pipe or device, as DetectDevice() tells it
};

/// Lists all series in a folder and the folders below it, in the order of the numbers that the
/// scanner has given them. Sets what else was found. See SortDicomSlices() for `named`.
std::vector<DicomSeries> ListDicomSeries(
  const std::string& folder, DicomFolderFacts& facts, const std::string& named = {});

/// Sorts slices into series, and removes copies: keeps the copy in the file `named`, or otherwise a
/// complete copy. Slices of several volumes become several series.
std::vector<DicomSeries> SortDicomSlices(
  const std::vector<DicomHeader>& slices, const std::string& named = {});

/// Returns the series with most pixels, among those with enough slices for a volume.
std::size_t FindLargest(const std::vector<DicomSeries>& series);

/// Returns whether each folder contains one series, with slices of the same size at the same
/// positions: the phases of a moving volume.
bool ArePhases(const std::vector<std::string>& folders);
} // namespace Explore

#endif
