// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Resamples a data set that is not an image onto a regular grid.
 */
#ifndef DataSetSampler_h
#define DataSetSampler_h

#include "VTK/Regions/DataSetParts.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

class vtkDataObject;

namespace VolumeHaptics
{

/** A sampled array, with the data set's name and number of components. */
struct SampledArray
{
  std::string Name;
  int Components = 1;
};

/**
 * Owns a copy of the data, with cell arrays averaged to the points, and resamples boxes of the grid
 * with VTK's probe. Any thread may call it; a mutex serialises the reads.
 */
class DataSetSampler
{
public:
  /**
   * Copies a vtkDataSet, or the volumetric data sets of a vtkCompositeDataSet.
   *
   * @param wanted arrays to sample in addition to the active scalars, vectors and tensors
   * @param spacing spacing of the grid; 0 stands for ComputeSampleSpacing()
   * @return null, with the reason and the cure in `error`, on failure, such as for data without
   * volume or arrays
   */
  static std::shared_ptr<DataSetSampler> Make(vtkDataObject* data,
    const std::vector<std::string>& wanted, double spacing, std::string& error);
  ~DataSetSampler();
  DataSetSampler(const DataSetSampler&) = delete;
  DataSetSampler& operator=(const DataSetSampler&) = delete;

  /**
   * Returns the sampled arrays. The first one has the scalars of the data, or, without scalars, the
   * magnitude of the second array.
   */
  const std::vector<SampledArray>& GetArrays() const { return this->Arrays; }
  int CountValues() const;
  const SamplingGrid& GetGrid() const { return this->Grid; }
  /** Returns the smallest scalar, which is used outside all cells. */
  double GetLeastScalar() const { return this->LeastScalar; }

  /**
   * Samples a box, array after array, with the components of a sample side by side. Outside all
   * cells, scalars are NaN, and vectors and tensors are 0. Throws std::runtime_error on failure.
   */
  void Read(const int box[6], float* samples);

private:
  DataSetSampler();

  vtkSmartPointer<vtkDataObject> Data;
  std::vector<SampledArray> Arrays;
  SamplingGrid Grid;
  double LeastScalar = 0.0;
  bool HasOwnScalars = true; ///< false: the first array is the magnitude of the second
  std::mutex Mutex;          ///< held while reading, because the probe caches data
};

} // namespace VolumeHaptics

#endif
