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
 * Caches the baked labels, and bakes them again only after a change. If only materials have
 * changed, reuses the results that are slow to compute: the checks of the image, and the distances
 * to forbidden labels.
 */
class HapticLabels
{
public:
  /**
   * Bakes labels. The result holds a reference to the array. Without a table, no label has a
   * material. If the labels can't be used, returns null, with the faulty input and the cure in
   * `error`.
   * @param isFine whether to refine the grid of labels with thick slices, which walls need
   */
  std::shared_ptr<const BakedLabels> Get(vtkImageData* image, vtkDataArray* labels,
    vtkHapticLabelTable* table, bool isFine, std::string& error);

  /**
   * Bakes touched scalars as labels, with the materials that the property's functions assign to
   * them. Returns null, without an error, if the scalars can't be labels, for example if they are
   * fractions.
   */
  std::shared_ptr<const BakedLabels> GetOfScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property, bool isFine);

  /** Returns the warning about the last baked labels and clears it; empty if there is none. */
  std::string DrainWarning() { return std::exchange(this->Warning, std::string()); }

  /**
   * Computes the slow parts of Get() in the background. Returns the name of the work in progress:
   * measuring the distances to forbidden labels, or making the finer grid of thick slices. Returns
   * null when Get() would be quick.
   */
  const char* Prepare(
    vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, bool isFine);
  /**
   * Computes the slow parts of GetOfScalars() with a finer grid in the background. Returns a name
   * or null, as Prepare() does.
   */
  const char* PrepareScalars(
    vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property);
  /** Stops the background work of Prepare(). */
  void EndPreparing();

private:
  ///@{
  /**
   * ImageKey identifies the image and its array (or the property), with their modification times.
   * TableKey does so for a table.
   */
  using ImageKey = std::tuple<const void*, const void*, vtkMTimeType, vtkMTimeType>;
  using TableKey = std::tuple<const void*, vtkMTimeType>;
  ///@}
  /**
   * Key of a cached forbidden zone: the forbidden labels, in ascending order, and the stand-off.
   */
  using ZoneKey = std::tuple<std::vector<int>, double>;
  /** Zone around forbidden labels; null if no voxel is forbidden. */
  using Zone = std::shared_ptr<const ForbiddenZone>;
  /** Finer grid; null if it would have too many voxels or labels. */
  using Fine = std::shared_ptr<const FineLabels>;

  /**
   * Makes the finer grid of labels with thick slices. Reuses the parts of `last` that are still
   * valid.
   */
  void Refine(const ImageKey& key, const BakedLabels* last, BakedLabels& made);
  ///@{
  /** Steps of Prepare(). Each returns false while it computes its result in the background. */
  bool PrepareZone(vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table);
  bool PrepareFine(vtkImageData* image, vtkDataArray* labels, bool isFine);
  ///@}
  vtkHapticLabelTable* GetScalarTable(vtkDataArray* scalars, vtkHapticProperty* property);

  ImageKey BakedImage{};
  TableKey BakedTable{};
  ZoneKey BakedZone{};
  bool BakedFine = false;
  std::string Warning;
  std::weak_ptr<const BakedLabels> Baked;           ///< last result; valid while a model uses it
  vtkSmartPointer<vtkHapticLabelTable> ScalarTable; ///< table that GetOfScalars() made
  ImageKey ScalarKey{};                             ///< array and property of ScalarTable
  KeyedWork<std::tuple<ImageKey, ZoneKey>, Zone> Measuring;
  KeyedWork<ImageKey, Fine> Refining;
};

} // namespace VolumeHaptics

#endif
