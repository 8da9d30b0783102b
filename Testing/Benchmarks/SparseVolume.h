// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A cubic int16 image in a memory-mapped file that is almost all hole, so that a volume of any size
 * takes neither memory nor disk space until something reads it. The mapping ends with its array.
 */
#ifndef SparseVolume_h
#define SparseVolume_h

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkShortArray.h>

#include <cstddef>

namespace benchmarks
{

/** The value is 0 everywhere but in a cube of 64^3 samples in the middle, where it is 20 k. */
class SparseVolume
{
public:
  /**
   * Throws std::runtime_error if there is no room for the file, which has no name. Puts the samples
   * into `array`, or into an array of its own if it is null.
   */
  explicit SparseVolume(int size, vtkShortArray* array = nullptr);
  SparseVolume(const SparseVolume&) = delete;
  SparseVolume& operator=(const SparseVolume&) = delete;

  vtkImageData* GetImage() const { return this->Image; }
  /** Returns the middle of the cube, in indices along each axis, which are also world units. */
  double GetMiddle() const { return 0.5 * this->Size; }
  /** Returns the number of bytes that are in memory. */
  std::size_t GetResident() const;

private:
  const int Size;
  const std::size_t Bytes;
  void* Begin = nullptr;
  vtkNew<vtkImageData> Image;
};

} // namespace benchmarks

#endif
