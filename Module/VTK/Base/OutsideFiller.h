// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fills the outside samples of arrays (OutsideSamples.h) with the value that is felt there.
 */
#ifndef OutsideFiller_h
#define OutsideFiller_h

#include "Core/Field/Estimates/OutsideSamples.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <string>
#include <tuple>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Finds which samples of a component are outside the measured data. For a region of a larger
 * volume, reads this from the image's field arrays. In data that can't be touched, no sample is
 * outside.
 */
VTKVOLUMEHAPTICS_EXPORT OutsideSamples DetectOutside(
  vtkImageData* image, vtkDataArray* scalars, int component);

///@{
/** Fills the outside samples of a component, or of `count` consecutive samples of a scalar type. */
void FillOutside(const OutsideSamples& outside, vtkDataArray* scalars, int component);
VTKVOLUMEHAPTICS_EXPORT void FillOutside(
  const OutsideSamples& outside, int scalarType, void* samples, std::int64_t count);
///@}

/**
 * Returns a copy of an array with its outside samples filled, in all components. Returns the array
 * itself if nothing is outside.
 */
VTKVOLUMEHAPTICS_EXPORT vtkSmartPointer<vtkDataArray> CopyFilled(
  const OutsideSamples& outside, vtkDataArray* scalars, int component);

/**
 * Describes which values are treated as outside or as holes, with the cure; empty if there are
 * none.
 */
VTKVOLUMEHAPTICS_EXPORT std::string DescribeOutside(
  const OutsideSamples& outside, vtkDataArray* scalars);

/**
 * Returns whether an array with this many components holds scalars; vectors and tensors are read
 * unchanged.
 */
bool AreScalars(int components);

/** Caches the last filled copy, which all bakes of an array share. */
class OutsideFiller
{
public:
  /** Returns the array, or its cached copy with filled outside samples. */
  vtkSmartPointer<vtkDataArray> Fill(vtkImageData* image, vtkDataArray* scalars, int component);
  /** Returns which samples of the last array were outside. */
  const OutsideSamples& GetLast() const { return this->Last; }
  /** Returns DescribeOutside() of the last array on the first call, then an empty text. */
  std::string DrainNotice();

private:
  using Key = std::tuple<const void*, const void*, int, vtkMTimeType>;

  Key Of{};
  OutsideSamples Last;
  vtkSmartPointer<vtkDataArray> Filled;
  std::string Notice;
  std::string Told;
};

} // namespace VolumeHaptics

#endif
