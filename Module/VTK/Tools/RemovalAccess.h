// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of a vtkHapticRemoval that models and the servo use, and its files.
 *
 * Such a file is a .vti image of the fractions in the part of the volume that has lost tissue. The
 * volume's extent and AirValue are field arrays.
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
 * Sets the extent of an image, and copies the origin, spacing and direction of another image to it.
 */
void CopyGeometry(vtkImageData* from, const int extent[6], vtkImageData* to);

/** Makes an image of the fractions in an extent of a volume, with the volume's geometry. */
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

/** The data of a vtkHapticRemoval. */
struct RemovalData
{
  static RemovalData& Of(vtkHapticRemoval* removal);

  /**
   * The tissue. Null until a model of a volume is made with a tool that removes, or until fractions
   * are read.
   */
  std::shared_ptr<TissueRemoval> Tissue;
  vtkNew<vtkImageData> Geometry; ///< geometry of the volume, without scalars
  bool HasAir = false;           ///< whether the AirValue was computed from the volume or read from
                                 ///< a file
  const void* Holder = nullptr;  ///< owner of the servo that ticks with the removal; null if there
                                 ///< is none
  ///@{
  /**
   * Contents of the file that was read; null if there is none. Obsolete once the fractions change.
   */
  std::unique_ptr<RemovalContent> Read;
  std::uint64_t ReadChanges = 0;  ///< the bricks' number of changes when the file was read
  std::int64_t ReadFirst[3] = {}; ///< index of the volume's first sample among the file's samples
  ///@}

  /**
   * Carries out the waiting requests if no servo holds the removal. Returns whether there were any.
   */
  bool ServeAll() const;
  /** Sets the computed AirValue without changing the object's modification time. */
  static void SetFoundAir(vtkHapticRemoval* removal, double value);
  /**
   * Creates tissue with these fractions, for a volume with that geometry. Returns false if there
   * are too many fractions.
   */
  bool Replace(const std::vector<BrickTissue>& fractions, vtkImageData* geometry);
  /** Replaces the tissue by a file's contents. */
  void ApplyContent(std::unique_ptr<RemovalContent> content);
  /** Returns whether the fractions within the volume still equal those of the file. */
  bool IsAsRead() const;
  /**
   * Returns whether a volume with the last volume's extent is another part of the file's volume.
   */
  bool IsOtherPart(vtkImageData* geometry, const int extent[6]) const;
  /**
   * Fits the file's contents to another part of the file's volume. Returns false if the samples are
   * not at the positions of that volume's samples, or if there are too many fractions.
   */
  bool FitRead(vtkImageData* geometry, const int extent[6]);
};

/**
 * Returns the tissue, parts of which may be removed; null as long as nothing can have been removed.
 */
std::shared_ptr<TissueRemoval> GetTissueRemoval(vtkHapticRemoval* removal);

///@{
/**
 * Reserves a removal for one holder, so that only its servo may tick with it. Returns false if
 * there is another holder. The holder's ticks carry out all requests until LetRemovalGo().
 */
bool HoldRemoval(vtkHapticRemoval* removal, const void* holder);
void LetRemovalGo(vtkHapticRemoval* removal, const void* holder);
///@}

/**
 * Adds the removed tissue to the description of a model, if its tool removes tissue or if some was
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
