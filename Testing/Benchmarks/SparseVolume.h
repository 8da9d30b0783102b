// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a cubic int16 image in a memory-mapped sparse file. A volume of any size takes neither
 * memory nor disk space until its samples are read. The mapping ends with its array.
 */
#ifndef SparseVolume_h
#define SparseVolume_h

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkShortArray.h>

#include <cstddef>

namespace benchmarks
{

/**
 * A volume with the value 0, except for a cube of 64^3 samples in the middle, where the value is 20
 * k.
 */
class SparseVolume
{
public:
  /**
   * Stores the samples in `array`, or in a new array if `array` is null. The file has no name.
   * Throws std::runtime_error if there is no room for the file.
   */
  explicit SparseVolume(int size, vtkShortArray* array = nullptr);
  SparseVolume(const SparseVolume&) = delete;
  SparseVolume& operator=(const SparseVolume&) = delete;

  vtkImageData* GetImage() const { return this->Image; }
  /**
   * Returns the coordinate of the cube's middle along each axis, in indices (which are also world
   * units).
   */
  double GetMiddle() const { return 0.5 * this->Size; }
  /** Returns how many bytes of the volume are resident in memory. */
  std::size_t GetResident() const;

private:
  const int Size;
  const std::size_t Bytes;
  void* Begin = nullptr;
  vtkNew<vtkImageData> Image;
};

} // namespace benchmarks

#endif
