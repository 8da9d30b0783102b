// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedImage.h"

#include "Core/Field/CarvedSamples.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Scene/Volumes/CarvedArray.h"
#include "VTK/Tools/RemovalAccess.h"

#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Returns whether an image's extent is inside a volume's extent. */
bool IsPartOf(vtkImageData* image, vtkImageData* volume)
{
  const int* const part = image->GetExtent();
  const int* const whole = volume->GetExtent();
  return part[0] >= whole[0] && part[1] <= whole[1] && part[2] >= whole[2] && part[3] <= whole[3] &&
    part[4] >= whole[4] && part[5] <= whole[5];
}

/** A range of tissue fractions along an axis; End is excluded. */
struct SampleSpan
{
  std::int64_t Begin;
  std::int64_t End;
};

/** Assigns the removal's tissue fractions to the samples of a part of an image, axis by axis. */
class TissueRaster
{
public:
  /**
   * Computes the assignment for a part of an image. Returns false if the axes of image and volume
   * are not parallel.
   */
  bool Compute(vtkImageData* place, vtkImageData* volume, const int part[6], CarvedCover cover)
  {
    const double first[3] = { static_cast<double>(part[0]), static_cast<double>(part[2]),
      static_cast<double>(part[4]) };
    double origin[3];
    Map(place, volume, first, origin);
    for (int a = 0; a < 3; ++a)
    {
      double next[3] = { first[0], first[1], first[2] };
      next[a] += 1.0;
      double step[3];
      Map(place, volume, next, step);
      for (int b = 0; b < 3; ++b)
      {
        step[b] -= origin[b];
      }
      const double across = std::abs(step[(a + 1) % 3]) + std::abs(step[(a + 2) % 3]);
      // The negated comparison also refuses NaN.
      if (!(across <= Rounding * step[a]))
      {
        return false;
      }
      const int* const extent = volume->GetExtent();
      this->SetAxis(a, origin[a] - extent[2 * a], step[a], part[2 * a + 1] - part[2 * a] + 1,
        extent[2 * a + 1] - extent[2 * a] + 1, cover);
    }
    return true;
  }
  /** Returns the image's samples along an axis that have any fraction in a range. */
  SampleSpan ComputeSamples(int axis, std::int64_t begin, std::int64_t end) const
  {
    const std::vector<SampleSpan>& all = this->Axes[axis];
    const auto first = std::partition_point(
      all.begin(), all.end(), [begin](const SampleSpan& one) { return one.End <= begin; });
    const auto last = std::partition_point(
      first, all.end(), [end](const SampleSpan& one) { return one.Begin < end; });
    return { first - all.begin(), last - all.begin() };
  }
  /** Returns the mean of a sample's fractions, from 0 to CarvedBricks::Whole. */
  double ComputeFraction(
    const CarvedBricks& bricks, std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const SampleSpan& x = this->Axes[0][static_cast<std::size_t>(i)];
    const SampleSpan& y = this->Axes[1][static_cast<std::size_t>(j)];
    const SampleSpan& z = this->Axes[2][static_cast<std::size_t>(k)];
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t c = z.Begin; c < z.End; ++c)
    {
      for (std::int64_t b = y.Begin; b < y.End; ++b)
      {
        for (std::int64_t a = x.Begin; a < x.End; ++a, ++count)
        {
          sum += bricks.GetFraction(a, b, c);
        }
      }
    }
    return count > 0.0 ? sum / count : CarvedBricks::Whole;
  }

private:
  static constexpr double Rounding = 1e-6; ///< voxels: tolerance for parallel axes

  static void Map(vtkImageData* from, vtkImageData* to, const double index[3], double mapped[3])
  {
    double world[3];
    from->TransformContinuousIndexToPhysicalPoint(index, world);
    to->TransformPhysicalPointToContinuousIndex(world, mapped);
  }
  void SetAxis(
    int axis, double first, double step, int count, std::int64_t fractions, CarvedCover cover)
  {
    this->Axes[axis].clear();
    for (int n = 0; n < count; ++n)
    {
      const double middle = first + n * step;
      SampleSpan range{ std::llround(middle), std::llround(middle) + 1 };
      if (cover == CarvedCover::Voxel && step > 1.0)
      {
        range = { std::llround(std::ceil(middle - 0.5 * step - Rounding)),
          std::llround(std::ceil(middle + 0.5 * step - Rounding)) };
      }
      range.Begin = std::clamp<std::int64_t>(range.Begin, 0, fractions);
      range.End = std::clamp<std::int64_t>(range.End, range.Begin, fractions);
      this->Axes[axis].push_back(range);
    }
  }

  std::vector<SampleSpan> Axes[3];
};

/**
 * Calls f for each row of a part of an image, with the index of the row's first sample in the image
 * and in the part, and the row's length.
 */
template <typename F>
void ForEachRow(const int extent[6], const int part[6], F&& f)
{
  const vtkIdType nx = extent[1] - extent[0] + 1;
  const vtkIdType ny = extent[3] - extent[2] + 1;
  const vtkIdType length = part[1] - part[0] + 1;
  vtkIdType to = 0;
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j, to += length)
    {
      f(part[0] - extent[0] + nx * (j - extent[2] + ny * (k - extent[4])), to, length);
    }
  }
}

void CopyPart(vtkDataArray* whole, const int extent[6], const int part[6], vtkDataArray* left)
{
  left->SetNumberOfComponents(whole->GetNumberOfComponents());
  AllocateTuples(left,
    static_cast<vtkIdType>(part[1] - part[0] + 1) * (part[3] - part[2] + 1) *
      (part[5] - part[4] + 1));
  if (!whole->HasStandardMemoryLayout())
  {
    ForEachRow(extent, part,
      [&](vtkIdType from, vtkIdType to, vtkIdType count)
      { left->InsertTuples(to, count, from, whole); });
    return;
  }
  const auto tuple =
    static_cast<vtkIdType>(whole->GetDataTypeSize()) * whole->GetNumberOfComponents();
  const auto* const source = static_cast<const char*>(whole->GetVoidPointer(0));
  auto* const target = static_cast<char*>(left->GetVoidPointer(0));
  ForEachRow(extent, part,
    [=](vtkIdType from, vtkIdType to, vtkIdType count)
    {
      std::memcpy(
        target + tuple * to, source + tuple * from, static_cast<std::size_t>(tuple * count));
    });
}

/** Subtracts the removed tissue from one component of the affected samples. */
template <typename T>
void CarvePart(
  const RemovedTissue& removed, const TissueRaster& raster, const int part[6], vtkDataArray* left)
{
  const CarvedBricks& bricks = removed.Removal->Bricks;
  const CarvedView view{ &bricks, removed.Air };
  const std::int64_t nx = part[1] - part[0] + 1;
  const std::int64_t ny = part[3] - part[2] + 1;
  const int components = left->GetNumberOfComponents();
  auto* const values = static_cast<T*>(left->GetVoidPointer(0)) + removed.Component;
  // Mark finished samples, because the fractions of one sample may be in several bricks.
  std::vector<bool> isDone(static_cast<std::size_t>(left->GetNumberOfTuples()), false);
  const std::uint32_t count = bricks.GetCount();
  for (std::uint32_t brick = 0; brick < count; ++brick)
  {
    const BrickPlace place = CarvedBricks::PlaceOf(bricks.GetKey(brick));
    const std::int64_t at[3] = { place.X, place.Y, place.Z };
    SampleSpan box[3];
    for (int a = 0; a < 3; ++a)
    {
      const std::int64_t begin = CarvedBricks::Side * at[a];
      box[a] = raster.ComputeSamples(a, begin, begin + CarvedBricks::Side);
    }
    for (std::int64_t k = box[2].Begin; k < box[2].End; ++k)
    {
      for (std::int64_t j = box[1].Begin; j < box[1].End; ++j)
      {
        for (std::int64_t i = box[0].Begin; i < box[0].End; ++i)
        {
          const std::int64_t sample = i + nx * (j + ny * k);
          if (isDone[static_cast<std::size_t>(sample)])
          {
            continue;
          }
          isDone[static_cast<std::size_t>(sample)] = true;
          const double fraction = raster.ComputeFraction(bricks, i, j, k);
          if (fraction < CarvedBricks::Whole)
          {
            T& value = values[sample * components];
            value = NearestOf<T>(view.Left(static_cast<double>(value), fraction));
          }
        }
      }
    }
  }
}

} // namespace

RemovedTissue GetRemoved(vtkVolumeHapticsFilter* filter)
{
  vtkHapticRemoval* const removal = filter ? filter->GetRemoval() : nullptr;
  RemovedTissue found;
  found.Removal = GetTissueRemoval(removal);
  if (!found.Removal || found.Removal->Bricks.IsEmpty())
  {
    return {};
  }
  found.Volume = RemovalData::Of(removal).Geometry;
  vtkImageData* const image = filter->GetTouchedImage();
  if (image && !IsPartOf(image, found.Volume))
  {
    return {};
  }
  found.VolumeTime = found.Volume->GetMTime();
  found.Component = filter->GetProperty()->GetComponent();
  found.Air = removal->GetAirValue();
  found.Changes = found.Removal->Bricks.GetChanges();
  return found;
}

bool CollectCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved)
{
  vtkHapticRemoval* const removal = filter->GetRemoval();
  carved.Removal = GetTissueRemoval(removal);
  vtkImageData* const image = carved.Removal ? filter->GetTouchedImage() : nullptr;
  carved.Array = image ? filter->GetBaker().GetTouched()[0].Array : nullptr;
  carved.Component = filter->GetProperty()->GetComponent();
  if (!carved.Array || carved.Array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    carved.Component >= carved.Array->GetNumberOfComponents())
  {
    return false;
  }
  // Compare with the whole volume of the last model, of which the image may be a region.
  vtkImageData* const volume = RemovalData::Of(removal).Geometry;
  if (!IsPartOf(image, volume))
  {
    return false; // a new volume, which has no model yet
  }
  const int* const whole = volume->GetExtent();
  const int* const extent = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    carved.First[a] = extent[2 * a] - whole[2 * a];
    carved.Dimensions[a] = extent[2 * a + 1] - extent[2 * a] + 1;
  }
  carved.Air = removal->GetAirValue();
  return true;
}

void CopyLeft(const RemovedTissue& removed, CarvedCover cover, vtkImageData* place,
  vtkDataArray* whole, const int part[6], vtkDataArray* left)
{
  CopyPart(whole, place->GetExtent(), part, left);
  TissueRaster raster;
  if (!removed.Removal || removed.Component >= whole->GetNumberOfComponents() ||
    !raster.Compute(place, removed.Volume, part, cover))
  {
    return;
  }
  switch (left->GetDataType())
  {
    vtkTemplateMacro(CarvePart<VTK_TT>(removed, raster, part, left));
    default:
      break;
  }
}

bool CarvedImage::Update(
  vtkImageData* image, vtkImageData* place, const RemovedTissue& removed, CarvedCover cover)
{
  const vtkMTimeType time = image ? image->GetMTime() : 0;
  if (image == this->Image && time == this->Time && removed.IsSame(this->Removed))
  {
    return false;
  }
  this->Image = image;
  this->Time = time;
  this->Removed = removed;
  vtkDataArray* const whole = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!whole || !removed.Removal || whole->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    const bool isOther = this->Left != image;
    this->Left = image;
    return isOther;
  }
  const auto left =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(whole->GetDataType()));
  left->SetName(whole->GetName());
  CopyLeft(removed, cover, place, whole, image->GetExtent(), left);
  this->Left = vtkSmartPointer<vtkImageData>::New();
  this->Left->CopyStructure(image);
  this->Left->GetPointData()->SetScalars(left);
  return true;
}

} // namespace VolumeHaptics
