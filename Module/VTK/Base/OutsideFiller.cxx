// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/OutsideFiller.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/WholeFacts.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Fraction of holes among the examined samples above which they are reported. */
constexpr double MostHoles = 0.01;

/**
 * Returns whether a corner sample may be outside or samples may be NaN. If not, the samples need
 * not be read.
 */
bool MayHaveOutside(vtkImageData* image, vtkDataArray* scalars, int component)
{
  const int type = scalars->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return true;
  }
  const int* const n = image->GetDimensions();
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType i = (corner & 1) ? n[0] - 1 : 0;
    const vtkIdType j = (corner & 2) ? n[1] - 1 : 0;
    const vtkIdType k = (corner & 4) ? n[2] - 1 : 0;
    const double value = scalars->GetComponent(i + n[0] * (j + n[1] * k), component);
    if (MayBeMissing(value))
    {
      return true;
    }
  }
  return false;
}

/** Returns whether all values of a component are in readable memory. */
bool HasMemory(vtkDataArray* scalars, int component)
{
  VolumeView view;
  vtkSmartPointer<vtkDataArray> holder;
  const int any[3] = { 1, 1, 1 };
  return LocateSamples(scalars, component, any, view, holder) && view.Data;
}

template <typename T>
void Fill(const OutsideSamples& outside, T* samples, std::int64_t stride, std::int64_t count)
{
  using Limits = std::numeric_limits<T>;
  const auto fill = static_cast<T>(std::clamp(
    outside.Fill, static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max())));
  for (std::int64_t i = 0; i < count; ++i)
  {
    T& sample = samples[i * stride];
    sample = outside.Has(static_cast<double>(sample)) ? fill : sample;
  }
}

void Fill(const OutsideSamples& outside, int scalarType, void* samples, std::int64_t stride,
  std::int64_t count)
{
  switch (outside.HasAny() ? scalarType : VTK_VOID)
  {
    vtkTemplateMacro(Fill(outside, static_cast<VTK_TT*>(samples), stride, count));
    default:
      break;
  }
}

} // namespace

OutsideSamples DetectOutside(vtkImageData* image, vtkDataArray* scalars, int component)
{
  if (component < 0 || component >= scalars->GetNumberOfComponents() ||
    image->GetNumberOfPoints() == 0 || scalars->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    !HasMemory(scalars, component))
  {
    return {};
  }
  WholeFacts whole;
  std::string error; // ignored: the bake reports this error
  if (!ReadWholeFacts(image, component, whole, error) || whole.IsThere ||
    !MayHaveOutside(image, scalars, component))
  {
    return whole.Outside;
  }
  NoiseSamples samples;
  int* const extent = image->GetExtent();
  CollectNoiseSamples(scalars, component, extent, extent, samples);
  return DetectOutside(samples);
}

void FillOutside(const OutsideSamples& outside, vtkDataArray* scalars, int component)
{
  VolumeView view;
  vtkSmartPointer<vtkDataArray> holder;
  const int row[3] = { 1, 1, 1 }; // only the stride along the row is used
  if (outside.HasAny() && LocateSamples(scalars, component, row, view, holder) && view.Data)
  {
    Fill(outside, scalars->GetDataType(), const_cast<void*>(view.Data), view.Stride[0],
      scalars->GetNumberOfTuples());
    scalars->Modified();
  }
}

void FillOutside(const OutsideSamples& outside, int scalarType, void* samples, std::int64_t count)
{
  Fill(outside, scalarType, samples, 1, count);
}

vtkSmartPointer<vtkDataArray> CopyFilled(
  const OutsideSamples& outside, vtkDataArray* scalars, int component)
{
  if (!outside.HasAny())
  {
    return scalars;
  }
  auto copy = CopyArray(scalars);
  FillOutside(outside, copy, component);
  return copy;
}

std::string DescribeOutside(const OutsideSamples& outside, vtkDataArray* scalars)
{
  const bool hasHoles = outside.Holes > MostHoles;
  if (!outside.HasAny() && !hasHoles)
  {
    return {};
  }
  std::ostringstream text;
  text << "The " << DescribeArray(scalars) << " of the input image has ";
  if (hasHoles)
  {
    text << "samples that are no numbers (" << std::lround(100.0 * outside.Holes)
         << " %), and none in a corner: they are holes, at which no surface is felt. If they are "
            "outside, give them the value of what is there.";
  }
  if (!outside.HasAny())
  {
    return text.str();
  }
  text << (hasHoles ? " It has " : "");
  if (outside.AreNonFinite)
  {
    text << "samples that are no numbers in a corner";
  }
  if (!std::isnan(outside.Missing))
  {
    text << (outside.AreNonFinite ? ", and " : "") << "the value " << outside.Missing
         << ", which is taken for \"missing\"";
  }
  text << ": all such samples are outside, and felt as " << outside.Fill << ".";
  if (!std::isnan(outside.Missing))
  {
    text << " If it was measured, shift all values by 1, and the functions with them.";
  }
  return text.str();
}

bool AreScalars(int components)
{
  return components != 3 && components != 6 && components != 9;
}

vtkSmartPointer<vtkDataArray> OutsideFiller::Fill(
  vtkImageData* image, vtkDataArray* scalars, int component)
{
  const Key key{ scalars, image, component, std::max(image->GetMTime(), scalars->GetMTime()) };
  if (this->Of != key)
  {
    this->Filled = nullptr; // release the old copy first, so that only one copy is in memory at a
                            // time
    this->Of = {};
    this->Last = DetectOutside(image, scalars, component);
    if (this->Last.HasAny())
    {
      this->Filled = CopyFilled(this->Last, scalars, component);
    }
    this->Of = key;
    this->Notice = DescribeOutside(this->Last, scalars);
  }
  return this->Filled ? this->Filled : vtkSmartPointer<vtkDataArray>(scalars);
}

std::string OutsideFiller::DrainNotice()
{
  // Report a text only once: the time steps of a moving volume often yield the same one.
  const std::string notice = std::exchange(this->Notice, {});
  const bool isNew = !notice.empty() && notice != this->Told;
  this->Told = notice.empty() ? this->Told : notice;
  return isNew ? notice : std::string();
}

} // namespace VolumeHaptics
