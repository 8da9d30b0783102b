// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data of a vtkHapticRemoval, which models and the servo use.
 */
#ifndef RemovalAccess_h
#define RemovalAccess_h

#include "Core/Carving/TissueRemoval.h"
#include "Core/Model/HapticModelDescription.h"
#include "VTK/Tools/RemovalFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkHapticRemoval;

namespace VolumeHaptics
{

/** The parts of a vtkHapticRemoval. */
struct RemovalData
{
  static RemovalData& Of(vtkHapticRemoval* removal);

  /** Null until a model was made of a volume with a tool that removes, or shares were read. */
  std::shared_ptr<TissueRemoval> Tissue;
  vtkNew<vtkImageData> Geometry; ///< that of the volume, without scalars
  bool HasAir = false;           ///< the AirValue is that of the volume, or of a file
  const void* Holder = nullptr;  ///< whose servo ticks with it; null: none
  ///@{
  /** What was read from a file; null if there is none, and of no use once the shares change. */
  std::unique_ptr<RemovalContent> Read;
  std::uint64_t ReadChanges = 0;  ///< of the bricks, as it left them
  std::int64_t ReadFirst[3] = {}; ///< of the volume, among the file's samples
  ///@}

  /**
   * Carries out the requests that wait, if no servo holds the removal. Returns whether there were
   * any.
   */
  bool ServeAll() const;
  /** Sets the AirValue that was found, which does not count as a change of the object. */
  static void SetFoundAir(vtkHapticRemoval* removal, double value);
  /** New tissue with these shares, for a volume of that geometry. False if they are too many. */
  bool Replace(const std::vector<BrickShares>& shares, vtkImageData* geometry);
  /** The same of a file. */
  void TakeRead(std::unique_ptr<RemovalContent> content);
  /** Whether the shares are those of a file, as far as the volume has them. */
  bool IsAsRead() const;
  /** Whether a volume with the extent of the last one is another part of the file's volume. */
  bool IsOtherPart(vtkImageData* geometry, const int extent[6]) const;
  /**
   * Fits what was read to another part of the file's volume. False if the samples do not lie where
   * those of that volume do, or there are too many shares.
   */
  bool FitRead(vtkImageData* geometry, const int extent[6]);
};

/** Null while nothing can have been removed. */
std::shared_ptr<TissueRemoval> GetTissueRemoval(vtkHapticRemoval* removal);

///@{
/**
 * Only one holder may tick with it. False if there is another one. Until it lets go, requests are
 * left to its ticks.
 */
bool HoldRemoval(vtkHapticRemoval* removal, const void* holder);
void LetRemovalGo(vtkHapticRemoval* removal, const void* holder);
///@}

/**
 * Adds to the description of a model what is removed from its volume, if its tool removes tissue,
 * or some was removed before. The description has its tool, its frames and its view. False, with
 * the reason and the cure in `error`, if that is of another volume.
 * @param geometry that of the volume: its origin, spacing and direction
 * @param extent that of the whole volume, of which the scalars may be a region
 * @param isRegion whether they are
 */
bool DescribeRemoval(vtkHapticRemoval* removal, vtkImageData* geometry, const int extent[6],
  vtkDataArray* scalars, int component, bool isRegion, HapticModelDescription& description,
  std::string& error);

} // namespace VolumeHaptics

#endif
