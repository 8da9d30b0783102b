// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An array that a filter touches, with the facts that show whether it has changed.
 */
#ifndef TouchedArray_h
#define TouchedArray_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <tuple>

namespace VolumeHaptics
{

struct TouchedArray
{
  vtkSmartPointer<vtkDataArray> Array; ///< null if there is none
  std::array<int, 3> Dimensions{};     ///< number of points along each axis of its image
  vtkMTimeType Time = 0;               ///< later modification time of image and array

  /** Identifies the array in its present state. Modification times are unique among all objects. */
  using Key = std::tuple<const void*, std::array<int, 3>, vtkMTimeType>;
  Key GetKey() const { return { this->Array.Get(), this->Dimensions, this->Time }; }
};

} // namespace VolumeHaptics

#endif
