// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Bakes a label image and a vtkHapticLabelTable into the core's BakedLabels.
 */
#ifndef HapticLabels_h
#define HapticLabels_h

#include "Core/Model/BakedLabels.h"
#include "Core/Realtime/BackgroundWork.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkHapticLabelTable;
class vtkHapticProperty;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Stores the labels that were baked last, and bakes them again only after a change. If only
 * materials have changed, keeps the results that are slow to compute: the checks of the image, and
 * the distances to forbidden labels.
 */
class HapticLabels
{
public:
  /**
   * Bakes labels, which keep the array alive. If the table is null, no label has a material. If the
   * labels can't be used, returns null, and `error` names the input and the cure.
   * @param isFine whether labels with thick slices get a finer grid, which walls need
   */
  std::shared_ptr<const BakedLabels> Get(vtkImageData* image, vtkDataArray* labels,
    vtkHapticLabelTable* table, bool isFine, std::string& error);

  /**
   * Bakes scalars that are labels themselves, with the materials that the property defines for
   * them. Returns null, without an error, if the scalars can't be labels, for example if they are
   * fractions.
   */
  std::shared_ptr<const BakedLabels> GetOfScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property, bool isFine);

  /**
   * Returns a warning about the labels that were baked last, and clears it; empty if there is none.
   */
  std::string DrainWarning() { return std::exchange(this->Warning, std::string()); }

  /**
   * Prepares in the background what a quick Get() needs. Returns the name of the work that is under
   * way: measuring the distances to forbidden labels, or making the finer grid of thick slices.
   * Returns null if there is none.
   */
  const char* Prepare(
    vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, bool isFine);
  /**
   * Prepares a quick GetOfScalars() with a finer grid in the background. Returns the same as
   * Prepare().
   */
  const char* PrepareScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property);
  /** Ends the work that Prepare() began. */
  void EndPreparing();

private:
  ///@{
  /**
   * ImageKey: the image and the array (or the property), and their modification times. TableKey:
   * the same for a table.
   */
  using ImageKey = std::tuple<const void*, const void*, vtkMTimeType, vtkMTimeType>;
  using TableKey = std::tuple<const void*, vtkMTimeType>;
  ///@}
  /** Identifies a forbidden zone: the forbidden labels, in ascending order, and the stand-off. */
  using ZoneKey = std::tuple<std::vector<int>, double>;
  /** The zone around forbidden labels; null if no voxel is forbidden. */
  using Zone = std::shared_ptr<const ForbiddenZone>;
  /** The finer grid; null if there are too many voxels or labels. */
  using Fine = std::shared_ptr<const FineLabels>;

  /**
   * Makes the finer grid of labels with thick slices. Computes only what has changed since `last`.
   */
  void Refine(const ImageKey& key, const BakedLabels* last, BakedLabels& made);
  ///@{
  /** Steps of Prepare(). They return false while a result is being computed. */
  bool PrepareZone(vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table);
  bool PrepareFine(vtkImageData* image, vtkDataArray* labels, bool isFine);
  ///@}
  vtkHapticLabelTable* GetScalarTable(vtkDataArray* scalars, vtkHapticProperty* property);

  ImageKey BakedImage{};
  TableKey BakedTable{};
  ZoneKey BakedZone{};
  bool BakedFine = false;
  std::string Warning;
  std::weak_ptr<const BakedLabels> Baked;           ///< last result; valid as long as a model uses
                                                    ///< it
  vtkSmartPointer<vtkHapticLabelTable> ScalarTable; ///< table of GetOfScalars()
  ImageKey ScalarKey{};                             ///< array and property of ScalarTable
  KeyedWork<std::tuple<ImageKey, ZoneKey>, Zone> Measuring;
  KeyedWork<ImageKey, Fine> Refining;
};

} // namespace VolumeHaptics

#endif
