// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the functions that an image suggests, and the image's edges, for vtkHapticFunctionEditor.
 * Searches at once, or in the background while a hand continues to feel.
 */
#ifndef FunctionSearch_h
#define FunctionSearch_h

#include "Core/Proposal/MaterialProposal.h"
#include "Core/Realtime/BackgroundWork.h"

#include "vtkType.h"

#include <optional>
#include <string>
#include <tuple>
#include <vector>

class vtkImageData;
class vtkTable;

namespace VolumeHaptics
{

struct HapticVolume;
struct SearchPart;

/**
 * Histogram of pairs of value and gradient magnitude in a volume, in which edges appear as arcs.
 */
struct EdgeHistogram
{
  static constexpr int Columns = 128; ///< columns, for values from Values[0] to Values[1]
  static constexpr int Rows = 64;     ///< rows, for gradient magnitudes from 0 to MostSlope

  double Values[2] = { 0.0, 1.0 };
  double MostSlope = 1.0; ///< largest gradient magnitude (scalar units per world unit)
  /**
   * Frequencies, row by row, beginning with gradient 0: log(1 + count), divided by the largest one
   * above the lowest gradients, at most 1. Empty without data.
   */
  std::vector<double> Fractions;
};

/**
 * Fills Fractions from some hundred thousand voxels of a volume, with the gradients of a kernel.
 * Ignores gradients above MostSlope. Leaves Fractions empty if the work is cancelled.
 */
void CountEdges(
  const HapticVolume& volume, int kernelRadius, const SearchPart& part, EdgeHistogram& histogram);

/** A component of an image, with the value range of its histogram of edges. */
struct SearchedData
{
  vtkImageData* Image = nullptr;
  int Component = 0;
  double Values[2] = { 0.0, 1.0 };
  double SlopeScale = 1.0; ///< factor that converts gradients in scalar units to the slopes of the
                           ///< boundaries
};

struct FoundFunctions
{
  std::optional<MaterialProposal> Proposal; ///< empty if nothing was found; Error then says why
  std::string Error;
  EdgeHistogram Edges; ///< counted with the kernel radius that was proposed
};

/**
 * Searches on a worker thread. Call its functions from the owner's thread. If the data change
 * during a search, it starts again.
 */
class FunctionSearch
{
public:
  /** Searches in this call and returns the result. */
  static FoundFunctions SearchNow(const SearchedData& data);

  ///@{
  /**
   * Begin() starts a search in the background. It returns false, with the reason and the cure in
   * `error`, if the image can't be searched. After the end of the search, Poll() returns the result
   * once.
   */
  bool Begin(const SearchedData& data, std::string& error);
  std::optional<FoundFunctions> Poll(const SearchedData& data);
  bool IsUnderWay() const { return this->IsWanted; }
  /** Cancels the search without waiting for it. */
  void Drop();
  ///@}

  /**
   * Returns the edges of the data, counted in the background with the boundaries and the kernel
   * radius of an earlier proposal. Returns null until they are counted.
   */
  const EdgeHistogram* PollEdges(const SearchedData& data, vtkTable* boundaries, int kernelRadius);

  /**
   * Cancels the work on all other images without waiting for it, so that the program may delete
   * them.
   */
  void EndUnless(vtkImageData* image);

  /** Returns the progress of the search, 0 to 1; 1 if no search is running. */
  double GetProgress() const;

private:
  using DataKey = std::tuple<const vtkImageData*, vtkMTimeType, int>;
  using EdgeKey = std::tuple<DataKey, const vtkTable*>;
  static DataKey MakeKey(const SearchedData& data);

  bool IsWanted = false;
  const vtkImageData* SearchedImage = nullptr; // only compared, not dereferenced
  const vtkImageData* CountedImage = nullptr;  // only compared, not dereferenced
  KeyedWork<DataKey, FoundFunctions> Search;
  KeyedWork<EdgeKey, EdgeHistogram> Count;
};

} // namespace VolumeHaptics

#endif
