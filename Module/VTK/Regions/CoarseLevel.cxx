// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/CoarseLevel.h"

#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/OutsideFiller.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** The samples before and after a position on an axis, and the weight of the latter. */
struct AxisPlace
{
  AxisPlace(double at, std::int64_t last)
  {
    // The condition also covers NaN.
    const double inside = at > 0.0 ? std::min(at, static_cast<double>(last)) : 0.0;
    this->Before = std::min(static_cast<std::int64_t>(inside), std::max<std::int64_t>(last - 1, 0));
    this->Behind = std::min(this->Before + 1, last);
    this->Share = inside - static_cast<double>(this->Before);
  }
  std::int64_t Before;
  std::int64_t Behind;
  double Share;
};

template <typename T>
void PutRow(const std::vector<double>& values, T* samples)
{
  if constexpr (std::is_integral_v<T>)
  {
    // The largest 64-bit integers are not representable as doubles; the next lower doubles are
    // used.
    const auto least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double most = std::nextafter(static_cast<double>(std::numeric_limits<T>::max()), 0.0);
    const double limit =
      sizeof(T) < sizeof(double) ? static_cast<double>(std::numeric_limits<T>::max()) : most;
    std::transform(values.begin(), values.end(), samples,
      [=](double value) { return static_cast<T>(std::clamp(std::round(value), least, limit)); });
  }
  else
  {
    std::transform(
      values.begin(), values.end(), samples, [](double value) { return static_cast<T>(value); });
  }
}

} // namespace

std::shared_ptr<const CoarseLevel> CoarseLevel::Make(
  vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error)
{
  std::shared_ptr<CoarseLevel> level(new CoarseLevel);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  constexpr int kernelRadius = 0; // no kernel is placed in it
  HapticVolume volume;
  if (!scalars)
  {
    error = "The CoarseImage has no point scalars. Give its point data active scalars.";
    return nullptr;
  }
  const OutsideSamples outside = areLabels ? OutsideSamples{} : FindOutside(image, scalars, 0);
  const vtkSmartPointer<vtkDataArray> filled = CopyFilled(outside, scalars, 0);
  if (!ReadVolume(image, filled, 0, kernelRadius, volume, error))
  {
    error = "The CoarseImage can't stand in for the volume. " + error;
    return nullptr;
  }
  level->View = volume.View;
  level->Holder = volume.Holder;
  level->FromVolume = Compose(Inverse(volume.IndexToWorld), indexToWorld);
  return level;
}

template <typename T>
void CoarseLevel::FindRow(const BoxExtent& box, int j, int k, double* values) const
{
  const auto* const data = static_cast<const T*>(this->View.Data);
  const std::int64_t* const n = this->View.Dimensions;
  const std::int64_t* const stride = this->View.Stride;
  for (int i = box[0]; i <= box[1]; ++i)
  {
    const Vector3 at =
      this->FromVolume({ static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) });
    const AxisPlace x(at.X, n[0] - 1);
    const AxisPlace y(at.Y, n[1] - 1);
    const AxisPlace z(at.Z, n[2] - 1);
    const auto along = [&](std::int64_t b, std::int64_t c)
    {
      const T* const row = data + b * stride[1] + c * stride[2];
      const auto first = static_cast<double>(row[x.Before * stride[0]]);
      return first + x.Share * (static_cast<double>(row[x.Behind * stride[0]]) - first);
    };
    const auto across = [&](std::int64_t c)
    {
      const double first = along(y.Before, c);
      return first + y.Share * (along(y.Behind, c) - first);
    };
    const double first = across(z.Before);
    const double value = first + z.Share * (across(z.Behind) - first);
    *values++ = std::isfinite(value) ? value : this->View.BorderValue;
  }
}

void CoarseLevel::Fill(const BoxExtent& box, int scalarType, void* samples) const
{
  std::vector<double> row(static_cast<std::size_t>(box[1] - box[0] + 1));
  std::size_t done = 0;
  for (int k = box[4]; k <= box[5]; ++k)
  {
    for (int j = box[2]; j <= box[3]; ++j, done += row.size())
    {
      WithSampleType(this->View.Type,
        [&](auto sample) { this->FindRow<decltype(sample)>(box, j, k, row.data()); });
      switch (scalarType)
      {
        vtkTemplateMacro(PutRow(row, static_cast<VTK_TT*>(samples) + done));
        default:
          break;
      }
    }
  }
}

} // namespace VolumeHaptics
