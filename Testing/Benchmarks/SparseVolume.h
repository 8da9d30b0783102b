// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A cubic image of int16 in a file that is mapped into memory and almost all hole, so that a volume
 * of any size takes neither memory nor disk until something reads it. It ends with its array.
 */
#ifndef SparseVolume_h
#define SparseVolume_h

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkShortArray.h>

#include <cstddef>

namespace benchmarks
{

/** 0 everywhere, and in its middle a cube of 64^3 samples in which the value is 20 k. */
class SparseVolume
{
public:
  /**
   * Throws std::runtime_error if there is no room for the file, which has no name. The array gets
   * the samples; null: an array of its own does.
   */
  explicit SparseVolume(int size, vtkShortArray* array = nullptr);
  SparseVolume(const SparseVolume&) = delete;
  SparseVolume& operator=(const SparseVolume&) = delete;

  vtkImageData* GetImage() const { return this->Image; }
  /** The middle of the cube, in indices along each axis, which are world units as well. */
  double GetMiddle() const { return 0.5 * this->Size; }
  /** Bytes that are in memory. */
  std::size_t GetResident() const;

private:
  const int Size;
  const std::size_t Bytes;
  void* Begin = nullptr;
  vtkNew<vtkImageData> Image;
};

} // namespace benchmarks

#endif
