// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Bakes a label image and a vtkHapticLabelTable into the core's BakedLabels.
 */
#ifndef HapticLabels_h
#define HapticLabels_h

#include "Core/Model/BakedLabels.h"
#include "VTK/Base/BackgroundWork.h"

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
 * Keeps the labels that were baked last, and bakes them again only after a change. If only
 * materials have changed, the slow results are kept: the checks of the image, and the distances to
 * forbidden labels.
 */
class HapticLabels
{
public:
  /**
   * Bakes labels, which keep the array alive. The table may be null: then no label has a material.
   * If the labels can't be used, returns null, and `error` names the input and the cure.
   * @param isFine whether labels with thick slices get a finer grid, as walls need it
   */
  std::shared_ptr<const BakedLabels> Get(vtkImageData* image, vtkDataArray* labels,
    vtkHapticLabelTable* table, bool isFine, std::string& error);

  /**
   * Bakes scalars that are labels themselves, with the materials that the property gives them.
   * Null, without an error, if the scalars can't be labels, for example fractions.
   */
  std::shared_ptr<const BakedLabels> GetOfScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property, bool isFine);

  /** Returns a warning about the labels that were baked last; empty once it was taken. */
  std::string DrainWarning() { return std::exchange(this->Warning, std::string()); }

  /**
   * Prepares a quick Get() in the background. Returns in words what is under way: the distances to
   * forbidden labels, or the finer grid of thick slices. Returns null if nothing is.
   */
  const char* Prepare(
    vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, bool isFine);
  /** Prepares a quick GetOfScalars() with a finer grid, as Prepare() does. */
  const char* PrepareScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property);
  /** Ends the work that Prepare() began. */
  void EndPreparing();

private:
  ///@{
  /** Image and array, or the table, and the last change of each. */
  using ImageKey = std::tuple<const void*, const void*, vtkMTimeType, vtkMTimeType>;
  using TableKey = std::tuple<const void*, vtkMTimeType>;
  ///@}
  /** The forbidden labels, in rising order, and the stand-off. */
  using ZoneKey = std::tuple<std::vector<int>, double>;
  /** Null if no voxel is forbidden. */
  using Zone = std::shared_ptr<const ForbiddenZone>;
  /** Null if there are too many voxels or labels. */
  using Fine = std::shared_ptr<const FineLabels>;

  /** Gives labels with thick slices a finer grid; computes only the parts that have changed. */
  void Refine(const ImageKey& key, const BakedLabels* last, BakedLabels& made);
  ///@{
  /** Prepare() calls these. They return false while a result is being computed. */
  bool PrepareZone(vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table);
  bool PrepareFine(vtkImageData* image, vtkDataArray* labels, bool isFine);
  ///@}
  vtkHapticLabelTable* GetScalarTable(vtkDataArray* scalars, vtkHapticProperty* property);

  ImageKey BakedImage{};
  TableKey BakedTable{};
  ZoneKey BakedZone{};
  bool BakedFine = false;
  std::string Warning;
  std::weak_ptr<const BakedLabels> Baked;           ///< valid while a model uses it
  vtkSmartPointer<vtkHapticLabelTable> ScalarTable; ///< table of GetOfScalars()
  ImageKey ScalarKey{};                             ///< array and property of ScalarTable
  KeyedWork<std::tuple<ImageKey, ZoneKey>, Zone> Measuring;
  KeyedWork<ImageKey, Fine> Refining;
};

} // namespace VolumeHaptics

#endif
