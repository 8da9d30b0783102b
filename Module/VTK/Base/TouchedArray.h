// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An array that a filter touches, with what tells whether it is still the same.
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
  vtkSmartPointer<vtkDataArray> Array; ///< null: there is none
  std::array<int, 3> Dimensions{};     ///< of its image
  vtkMTimeType Time = 0;               ///< when image or array was last modified

  /** Tells the array, as it is now, from all others: no two objects ever have the same time. */
  using Key = std::tuple<const void*, std::array<int, 3>, vtkMTimeType>;
  Key GetKey() const { return { this->Array.Get(), this->Dimensions, this->Time }; }
};

} // namespace VolumeHaptics

#endif
