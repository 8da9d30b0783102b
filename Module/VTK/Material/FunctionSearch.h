// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The functions that an image suggests, and its edges, for vtkHapticFunctionEditor: at once, or in
 * the background while a hand goes on to feel.
 */
#ifndef FunctionSearch_h
#define FunctionSearch_h

#include "Core/Proposal/MaterialProposal.h"
#include "VTK/Base/BackgroundWork.h"
#include "VTK/Material/EdgeHistogram.h"

#include "vtkType.h"

#include <optional>
#include <string>
#include <tuple>

class vtkImageData;
class vtkTable;

namespace VolumeHaptics
{

/** A component of an image, and the range of values of its histogram of edges. */
struct SearchedData
{
  vtkImageData* Image = nullptr;
  int Component = 0;
  double Values[2] = { 0.0, 1.0 };
  double SlopeScale = 1.0; ///< of boundaries, from scalar units
};

struct FoundFunctions
{
  std::optional<MaterialProposal> Proposal; ///< none: Error tells why
  std::string Error;
  EdgeHistogram Edges; ///< with the kernel that the proposal suggests
};

/** For the owner's thread. Data that have changed meanwhile are looked at again. */
class FunctionSearch
{
public:
  /** Waits for the end of the search. */
  static FoundFunctions FindNow(const SearchedData& data);

  ///@{
  /**
   * Begin() starts a search in the background; false, with the reason and the cure in `error`, if
   * the image can't be looked at. Follow() returns once what was found.
   */
  bool Begin(const SearchedData& data, std::string& error);
  std::optional<FoundFunctions> Follow(const SearchedData& data);
  bool IsUnderWay() const { return this->IsWanted; }
  /** Ends it, and does not wait. */
  void Drop();
  ///@}

  /**
   * The edges of the data, with the boundaries and the kernel's radius of an older proposal; null
   * until they are counted, in the background.
   */
  const EdgeHistogram* FollowEdges(
    const SearchedData& data, vtkTable* boundaries, int kernelRadius);

  /** Waits until no work goes on with another image, which the program may remove. */
  void EndUnless(vtkImageData* image);

  /** 0 to 1; 1 if nothing is under way. */
  double GetProgress() const;

private:
  using DataKey = std::tuple<const vtkImageData*, vtkMTimeType, int>;
  using EdgeKey = std::tuple<DataKey, const vtkTable*>;
  static DataKey MakeKey(const SearchedData& data);

  bool IsWanted = false;
  const vtkImageData* SearchedImage = nullptr; // only compared
  const vtkImageData* CountedImage = nullptr;  // only compared
  KeyedWork<DataKey, FoundFunctions> Search;
  KeyedWork<EdgeKey, EdgeHistogram> Count;
};

} // namespace VolumeHaptics

#endif
