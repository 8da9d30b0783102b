// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives the samples of arrays that are outside (OutsideSamples.h) the value with which they are
 * felt.
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
 * What is outside in a component of an image: of a region of a larger volume, what its field arrays
 * tell; nothing in what can't be touched.
 */
VTKVOLUMEHAPTICS_EXPORT OutsideSamples FindOutside(
  vtkImageData* image, vtkDataArray* scalars, int component);

///@{
/** Fills samples: those of a component, or so many of a scalar type one after another. */
void FillOutside(const OutsideSamples& outside, vtkDataArray* scalars, int component);
VTKVOLUMEHAPTICS_EXPORT void FillOutside(
  const OutsideSamples& outside, int scalarType, void* samples, std::int64_t count);
///@}

/** A filled copy of an array, with all components; the array itself if nothing is outside. */
VTKVOLUMEHAPTICS_EXPORT vtkSmartPointer<vtkDataArray> CopyFilled(
  const OutsideSamples& outside, vtkDataArray* scalars, int component);

/** Tells what was taken for outside, or for holes, and the cure; empty if nothing was. */
VTKVOLUMEHAPTICS_EXPORT std::string DescribeOutside(
  const OutsideSamples& outside, vtkDataArray* scalars);

/** Whether an array of so many components has scalars; vectors and tensors are read as they are. */
bool AreScalars(int components);

/** Keeps the last filled copy, which all bakes of an array share. */
class OutsideFiller
{
public:
  /** The array, or the copy in which its samples outside are filled. */
  vtkSmartPointer<vtkDataArray> Fill(vtkImageData* image, vtkDataArray* scalars, int component);
  /** What was outside in the last array. */
  const OutsideSamples& GetLast() const { return this->Last; }
  /** DescribeOutside() of the last array, once; else an empty text. */
  std::string TakeNotice();

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
