// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a label image and a vtkHapticLabelTable to the core's BakedLabels.
 */
#ifndef HapticLabels_h
#define HapticLabels_h

#include "Core/Model/BakedLabels.h"
#include "VTK/Work/BackgroundWork.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>
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
   */
  std::shared_ptr<const BakedLabels> Get(
    vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, std::string& error);

  /**
   * The same of scalars that are labels themselves, with the materials that the property gives
   * them. Null, without an error, if they can't be labels, such as fractions.
   */
  std::shared_ptr<const BakedLabels> GetOfScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property);

  /**
   * Whether Get() would be quick now. If not, because other labels are forbidden, or farther away,
   * the distances to them are measured in the background.
   */
  bool Prepare(vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table);
  /** Ends what Prepare() began. */
  void EndPreparing() { this->Measuring.Forget(); }

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

  ImageKey BakedImage{};
  TableKey BakedTable{};
  ZoneKey BakedZone{};
  std::weak_ptr<const BakedLabels> Baked;           ///< valid while a model uses it
  vtkSmartPointer<vtkHapticLabelTable> ScalarTable; ///< of GetOfScalars
  ImageKey ScalarKey{};                             ///< array and property of ScalarTable
  KeyedWork<std::tuple<ImageKey, ZoneKey>, Zone> Measuring;
};

} // namespace VolumeHaptics

#endif
