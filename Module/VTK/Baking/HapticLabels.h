// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a label image and a vtkHapticLabelTable to the core's BakedLabels.
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
 * The labels that were baked last; baked again only after a change. If only materials have changed,
 * what takes long is kept: the checks of the image, and the distances to forbidden labels.
 */
class HapticLabels
{
public:
  /**
   * Bakes labels that keep the array alive. The table may be null: then no label has a material. If
   * the labels can't be used, returns null, and `error` names the input and the cure.
   * @param isFine whether they get a finer grid if they have thick slices: for walls
   */
  std::shared_ptr<const BakedLabels> Get(vtkImageData* image, vtkDataArray* labels,
    vtkHapticLabelTable* table, bool isFine, std::string& error);

  /**
   * The same of scalars that are labels themselves, with the materials that the property gives
   * them. Null, without an error, if they can't be labels, such as fractions.
   */
  std::shared_ptr<const BakedLabels> GetOfScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property, bool isFine);

  /** What the user should know of the labels that were baked last; empty when it was taken. */
  std::string TakeWarning() { return std::exchange(this->Warning, std::string()); }

  /**
   * What is made in the background before Get() is quick, in words: the distances to forbidden
   * labels, and the finer grid of thick slices. Null if nothing is.
   */
  const char* Prepare(
    vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, bool isFine);
  /** The same before GetOfScalars() with a finer grid. */
  const char* PrepareScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property);
  /** Ends what Prepare() began. */
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

  /** Gives labels with thick slices a finer grid, of which only what has changed is made anew. */
  void Refine(const ImageKey& key, const BakedLabels* last, BakedLabels& made);
  ///@{
  /** Parts of Prepare(): false while something is made. */
  bool PrepareZone(vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table);
  bool PrepareFine(vtkImageData* image, vtkDataArray* labels, bool isFine);
  ///@}
  vtkHapticLabelTable* FindScalarTable(vtkDataArray* scalars, vtkHapticProperty* property);

  ImageKey BakedImage{};
  TableKey BakedTable{};
  ZoneKey BakedZone{};
  bool BakedFine = false;
  std::string Warning;
  std::weak_ptr<const BakedLabels> Baked;           ///< valid while a model uses it
  vtkSmartPointer<vtkHapticLabelTable> ScalarTable; ///< of GetOfScalars
  ImageKey ScalarKey{};                             ///< array and property of ScalarTable
  KeyedWork<std::tuple<ImageKey, ZoneKey>, Zone> Measuring;
  KeyedWork<ImageKey, Fine> Refining;
};

} // namespace VolumeHaptics

#endif
