// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives models, the servo and files access to a vtkHapticRemoval.
 *
 * A file of removed tissue is a .vti image of the remaining fractions, in the part of the volume
 * from which tissue was removed. Its field arrays have the volume's extent and AirValue.
 */
#ifndef RemovalAccess_h
#define RemovalAccess_h

#include "Core/Carving/TissueRemoval.h"
#include "Core/Carving/TissueSnapshot.h"
#include "Core/Model/HapticModelDescription.h"

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

/**
 * Copies the origin, spacing and direction of an image to another one, and sets the other one's
 * extent.
 */
void CopyGeometry(vtkImageData* from, const int extent[6], vtkImageData* to);

/**
 * Makes an image of the remaining fractions in an extent of a volume, with the volume's geometry.
 */
void MakeTissueImage(
  const CarvedBricks* bricks, vtkImageData* geometry, const int extent[6], vtkImageData* fractions);

/** Writes a file. On failure, returns false, with the reason and the cure in `error`. */
bool WriteRemovalFile(const CarvedBricks& bricks, double airValue, vtkImageData* geometry,
  const std::string& file, std::string& error);

/** Contents of a file of removed tissue. */
struct RemovalContent
{
  vtkNew<vtkImageData> Geometry; ///< geometry of the volume
  std::vector<BrickTissue> Fractions;
  double AirValue = 0.0;
};

/** Reads a file. On failure, returns false, with the fault and the cure in `error`. */
bool ReadRemovalFile(const std::string& file, RemovalContent& content, std::string& error);

/** Data of a vtkHapticRemoval. */
struct RemovalData
{
  static RemovalData& Of(vtkHapticRemoval* removal);

  /**
   * Remaining tissue; null until a model of a volume is made with a tool that removes tissue, or
   * until fractions are read.
   */
  std::shared_ptr<TissueRemoval> Tissue;
  vtkNew<vtkImageData> Geometry; ///< geometry of the volume, without scalars
  bool HasAir = false;           ///< whether AirValue is known, from the volume or from a file
  const void* Holder = nullptr;  ///< owner of the servo that ticks with the removal; null without
                                 ///< one
  ///@{
  /**
   * Contents of the last file that was read; null without one. Obsolete once the fractions change.
   */
  std::unique_ptr<RemovalContent> Read;
  std::uint64_t ReadChanges = 0;  ///< the bricks' number of changes when the file was read
  std::int64_t ReadFirst[3] = {}; ///< index of the volume's first sample in the file
  ///@}

  /**
   * Carries out the waiting requests, provided that no servo holds the removal. Returns whether
   * there were any.
   */
  bool ServeAll() const;
  /** Sets the computed AirValue without changing the object's modification time. */
  static void SetFoundAir(vtkHapticRemoval* removal, double value);
  /**
   * Creates tissue with these fractions for a volume with that geometry. Returns false if there are
   * too many fractions.
   */
  bool Replace(const std::vector<BrickTissue>& fractions, vtkImageData* geometry);
  /** Replaces the tissue with the contents of a file. */
  void ApplyContent(std::unique_ptr<RemovalContent> content);
  /** Returns whether the fractions within the volume are still those of the file. */
  bool IsAsRead() const;
  /**
   * Returns whether a volume with the same extent as the last one is another part of the file's
   * volume.
   */
  bool IsOtherPart(vtkImageData* geometry, const int extent[6]) const;
  /**
   * Adapts the file's contents to another part of the file's volume. Returns false if the positions
   * of the samples do not match, or if there are too many fractions.
   */
  bool FitRead(vtkImageData* geometry, const int extent[6]);
};

/** Returns the tissue with removed parts; null while nothing can have been removed. */
std::shared_ptr<TissueRemoval> GetTissueRemoval(vtkHapticRemoval* removal);

///@{
/**
 * Reserves a removal for a holder, so that only the holder's servo may tick with it. Returns false
 * if another holder has it. The holder's ticks carry out all requests until LetRemovalGo().
 */
bool HoldRemoval(vtkHapticRemoval* removal, const void* holder);
void LetRemovalGo(vtkHapticRemoval* removal, const void* holder);
///@}

/**
 * Adds the remaining tissue to the description of a model if its tool removes tissue or if some was
 * removed before. The description already has its tool, its time steps and its view. Returns false,
 * with the reason and the cure in `error`, if the tissue belongs to another volume.
 * @param geometry origin, spacing and direction of the volume
 * @param extent extent of the whole volume; the scalars may be a region of it
 * @param isRegion whether the scalars are a region
 */
bool DescribeRemoval(vtkHapticRemoval* removal, vtkImageData* geometry, const int extent[6],
  vtkDataArray* scalars, int component, bool isRegion, HapticModelDescription& description,
  std::string& error);

} // namespace VolumeHaptics

#endif
