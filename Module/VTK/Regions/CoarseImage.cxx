// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/CoarseImage.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Regions/VolumeSurvey.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Indices of the samples before and after a position along an axis, and the weight of the latter.
 */
struct AxisPlace
{
  AxisPlace(double at, std::int64_t last)
  {
    // Maps NaN to 0.
    const double inside = at > 0.0 ? std::min(at, static_cast<double>(last)) : 0.0;
    this->Before = std::min(static_cast<std::int64_t>(inside), std::max<std::int64_t>(last - 1, 0));
    this->Behind = std::min(this->Before + 1, last);
    this->Fraction = inside - static_cast<double>(this->Before);
  }
  std::int64_t Before;
  std::int64_t Behind;
  double Fraction;
};

template <typename T>
void PutRow(const std::vector<double>& values, T* samples)
{
  if constexpr (std::is_integral_v<T>)
  {
    // The largest 64-bit integers can't be represented as doubles, so use the next lower double.
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

std::int64_t DivideUp(std::int64_t number, std::int64_t by)
{
  return (number + by - 1) / by;
}

/** Sum and number of the samples in each coarse voxel of a box. */
struct CoarseSums
{
  explicit CoarseSums(const BoxExtent& box)
    : Box(box)
    , Sums(static_cast<std::size_t>(CountSamples(box)))
    , Counts(Sums.size())
  {
  }
  std::size_t At(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const std::int64_t nx = this->Box[1] - this->Box[0] + 1;
    const std::int64_t ny = this->Box[3] - this->Box[2] + 1;
    return static_cast<std::size_t>(
      i - this->Box[0] + nx * (j - this->Box[2] + ny * (k - this->Box[4])));
  }
  void Add(const CoarseSums& part)
  {
    std::size_t from = 0;
    for (int k = part.Box[4]; k <= part.Box[5]; ++k)
    {
      for (int j = part.Box[2]; j <= part.Box[3]; ++j)
      {
        for (int i = part.Box[0]; i <= part.Box[1]; ++i, ++from)
        {
          const std::size_t to = this->At(i, j, k);
          this->Sums[to] += part.Sums[from];
          this->Counts[to] += part.Counts[from];
        }
      }
    }
  }

  BoxExtent Box;
  std::vector<double> Sums;
  std::vector<float> Counts;
};

/** Plans which boxes are read at once, and which samples belong to each coarse voxel. */
class CoarsePlan
{
public:
  CoarsePlan(const LargeVolume& volume, vtkIdType mostVoxels)
    : Volume(volume)
    , Outside(Survey(volume))
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = std::int64_t{ volume.Extent[2 * a + 1] } - volume.Extent[2 * a] + 1;
    }
    while (this->CountVoxels() > static_cast<double>(mostVoxels))
    {
      ++this->Step;
    }
    const bool hasChunks = volume.ChunkSize[0] > 0;
    this->BoxSize = hasChunks
      ? volume.ChunkSize
      : std::array<std::int64_t, 3>{ this->Size[0], this->Step, this->Step };
    this->IsSparse = !hasChunks && this->Step > 1;
    for (int a = 0; a < 3; ++a)
    {
      this->Boxes[a] = DivideUp(this->Size[a], this->BoxSize[a]);
    }
  }

  double CountVoxels() const
  {
    return static_cast<double>(DivideUp(this->Size[0], this->Step)) *
      static_cast<double>(DivideUp(this->Size[1], this->Step)) *
      static_cast<double>(DivideUp(this->Size[2], this->Step));
  }
  std::int64_t CountBoxes() const { return this->Boxes[0] * this->Boxes[1] * this->Boxes[2]; }
  BoxExtent GetVoxels() const
  {
    BoxExtent voxels;
    for (int a = 0; a < 3; ++a)
    {
      voxels[2 * a] = 0;
      voxels[2 * a + 1] = static_cast<int>(DivideUp(this->Size[a], this->Step) - 1);
    }
    return voxels;
  }
  /** Returns a box in sample indices, relative to the volume's first sample. */
  std::array<std::int64_t, 6> GetBox(std::int64_t number) const
  {
    const std::int64_t place[3] = { number % this->Boxes[0],
      number / this->Boxes[0] % this->Boxes[1], number / (this->Boxes[0] * this->Boxes[1]) };
    std::array<std::int64_t, 6> box;
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = place[a] * this->BoxSize[a];
      box[2 * a + 1] = std::min(box[2 * a] + this->BoxSize[a], this->Size[a]) - 1;
      if (this->IsSparse && a > 0)
      {
        box[2 * a] = (box[2 * a] + box[2 * a + 1]) / 2;
        box[2 * a + 1] = box[2 * a];
      }
    }
    return box;
  }

  template <typename T>
  CoarseSums Average(const std::array<std::int64_t, 6>& box, std::vector<char>& bytes) const
  {
    BoxExtent samples;
    BoxExtent voxels;
    for (int b = 0; b < 6; ++b)
    {
      samples[b] = static_cast<int>(box[b] + this->Volume.Extent[b / 2 * 2]);
      voxels[b] = static_cast<int>(box[b] / this->Step);
    }
    bytes.resize(static_cast<std::size_t>(CountSamples(samples)) * sizeof(T));
    std::string error;
    if (!ReadSamples(this->Volume, samples, bytes.data(), error))
    {
      throw std::runtime_error(error);
    }
    CoarseSums sums(voxels);
    const T* sample = reinterpret_cast<const T*>(bytes.data());
    for (std::int64_t k = box[4]; k <= box[5]; ++k)
    {
      for (std::int64_t j = box[2]; j <= box[3]; ++j)
      {
        const std::size_t row = sums.At(voxels[0], j / this->Step, k / this->Step);
        for (std::int64_t i = box[0]; i <= box[1]; ++i)
        {
          const auto read = static_cast<double>(*sample++);
          const double value = this->Outside.Has(read) ? this->Outside.Fill : read;
          if (std::isfinite(value))
          {
            const std::size_t at = row + static_cast<std::size_t>(i / this->Step - voxels[0]);
            sums.Sums[at] += value;
            sums.Counts[at] += 1.0F;
          }
        }
      }
    }
    return sums;
  }

  const LargeVolume& Volume;
  std::array<std::int64_t, 3> Size{};
  std::int64_t Step = 1;

private:
  /** Finds which samples are outside, so that the value felt there is averaged instead. */
  static OutsideSamples Survey(const LargeVolume& volume)
  {
    VolumeSurvey survey(volume);
    std::string error;
    while (!volume.IsSmooth && !survey.IsDone())
    {
      if (!survey.Advance(error))
      {
        throw std::runtime_error(error);
      }
    }
    return volume.IsSmooth ? OutsideSamples{} : survey.GetFacts().Outside;
  }

  OutsideSamples Outside;
  std::array<std::int64_t, 3> BoxSize{};
  std::array<std::int64_t, 3> Boxes{};
  bool IsSparse = false; ///< whether only the middle row of a box is read
};

template <typename T>
CoarseSums SumUp(const CoarsePlan& plan)
{
  CoarseSums all(plan.GetVoxels());
  std::mutex mutex;
  std::string error;
  std::atomic<bool> hasFailed{ false };
  vtkSMPTools::For(0, static_cast<vtkIdType>(plan.CountBoxes()), 1,
    [&](vtkIdType first, vtkIdType end)
    {
      std::vector<char> bytes;
      for (vtkIdType box = first; box < end && !hasFailed; ++box)
      {
        try
        {
          const CoarseSums part = plan.Average<T>(plan.GetBox(box), bytes);
          const std::lock_guard<std::mutex> lock(mutex);
          all.Add(part);
        }
        catch (const std::exception& failure)
        {
          const std::lock_guard<std::mutex> lock(mutex);
          error = failure.what();
          hasFailed = true;
        }
      }
    });
  if (hasFailed)
  {
    throw std::runtime_error(error);
  }
  return all;
}

template <typename T>
void WriteMeans(const CoarsePlan& plan, T* values)
{
  const CoarseSums all = SumUp<T>(plan);
  for (std::size_t i = 0; i < all.Sums.size(); ++i)
  {
    const double mean = all.Counts[i] > 0.0F ? all.Sums[i] / static_cast<double>(all.Counts[i])
                                             : std::numeric_limits<double>::quiet_NaN();
    values[i] = static_cast<T>(std::is_integral<T>::value ? std::round(mean) : mean);
  }
}

} // namespace

std::shared_ptr<const CoarseLevel> CoarseLevel::Make(
  vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error)
{
  std::shared_ptr<CoarseLevel> level(new CoarseLevel);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  constexpr int kernelRadius = 0; // no kernel is evaluated in this image
  HapticVolume volume;
  if (!scalars)
  {
    error = "The CoarseImage has no point scalars. Give its point data active scalars.";
    return nullptr;
  }
  const OutsideSamples outside = areLabels ? OutsideSamples{} : DetectOutside(image, scalars, 0);
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
      return first + x.Fraction * (static_cast<double>(row[x.Behind * stride[0]]) - first);
    };
    const auto across = [&](std::int64_t c)
    {
      const double first = along(y.Before, c);
      return first + y.Fraction * (along(y.Behind, c) - first);
    };
    const double first = across(z.Before);
    const double value = first + z.Fraction * (across(z.Behind) - first);
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

vtkSmartPointer<vtkImageData> AverageVolume(
  const LargeVolume& volume, const VolumePlace& place, vtkIdType mostVoxels)
{
  const CoarsePlan plan(volume, std::max<vtkIdType>(mostVoxels, 8));
  const auto step = static_cast<double>(plan.Step);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(plan.GetVoxels().data());
  double origin[3];
  std::copy_n(place.Origin, 3, origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    // The first coarse voxel is at the centre of its samples.
    const double index = volume.Extent[2 * axis] + 0.5 * (step - 1.0);
    for (int row = 0; row < 3; ++row)
    {
      origin[row] += place.Direction[3 * row + axis] * place.Spacing[axis] * index;
    }
  }
  image->SetOrigin(origin);
  image->SetSpacing(step * place.Spacing[0], step * place.Spacing[1], step * place.Spacing[2]);
  image->SetDirectionMatrix(place.Direction);
  AllocateScalars(image, volume.ScalarType, 1);
  image->GetPointData()->GetScalars()->SetName("Scalars");
  switch (volume.ScalarType)
  {
    vtkTemplateMacro(WriteMeans(plan, static_cast<VTK_TT*>(image->GetScalarPointer())));
    default:
      throw std::runtime_error("The samples are no numbers.");
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadCoarserLevel(const LargeFile& file, vtkIdType mostVoxels)
{
  for (const LargeFile& level : file.Coarser)
  {
    if (CountSamples(level.Extent) > static_cast<double>(mostVoxels))
    {
      continue;
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    BoxExtent extent = level.Extent;
    image->SetExtent(extent.data());
    image->SetOrigin(level.Origin.data());
    image->SetSpacing(level.Spacing.data());
    image->SetDirectionMatrix(level.Direction.data());
    AllocateScalars(image, level.ScalarType, 1);
    image->GetPointData()->GetScalars()->SetName("Scalars");
    if (!level.Read(level.Extent.data(), image->GetScalarPointer()))
    {
      throw std::runtime_error("a coarser level gives no samples.");
    }
    return image;
  }
  return nullptr;
}

} // namespace VolumeHaptics
