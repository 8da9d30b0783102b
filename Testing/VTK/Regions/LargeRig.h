// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with volumes for vtkHapticRegionSource: computed volumes, and the same volumes in memory.
 */
#ifndef LargeRig_h
#define LargeRig_h

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkHapticRegionSource.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

namespace largetest
{
using namespace apitest;

// Disables the thread sanitizer's checks of memory. Tests compute millions of values from constant
// tables, which takes minutes with these checks, and seconds without.
#if defined(__SANITIZE_THREAD__)
#define LARGE_RIG_UNWATCHED __attribute__((no_sanitize("thread")))
#else
#define LARGE_RIG_UNWATCHED
#endif

using Extent = std::array<int, 6>;
using ValueAt = std::function<double(int, int, int)>;

/// Returns a number from -1 to 1 without a pattern, as a hash of the indices.
LARGE_RIG_UNWATCHED inline double Noise(int i, int j, int k)
{
  std::uint64_t x = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U +
    static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4FU +
    static_cast<std::uint64_t>(k) * 0x165667B19E3779F9U;
  x = (x ^ (x >> 31)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 29)) * 0x94D049BB133111EBU;
  return static_cast<double>(x >> 11) / 4503599627370496.0 - 1.0;
}

/// A wave along an axis. Stored in a table, because tests evaluate it for millions of samples.
class Wave
{
public:
  Wave(double height, double turn)
  {
    for (int i = 0; i < Count; ++i)
    {
      this->Values[i] = height * std::sin(turn * (i + First));
    }
  }
  LARGE_RIG_UNWATCHED double At(int i) const { return this->Values[i - First]; }

private:
  static constexpr int First = -10;
  static constexpr int Count = 700;
  std::array<double, Count> Values;
};

/// Returns the height (index k) of the bed's surface.
LARGE_RIG_UNWATCHED inline double TopAt(int i, int j)
{
  static const Wave alongX(4.0, 0.05);
  static const Wave alongY(3.0, 0.07);
  return 50.0 + alongX.At(i) + alongY.At(j);
}

/// Returns the value of a wavy bed with noise, which fills the lower part of a long volume.
LARGE_RIG_UNWATCHED inline double BedAt(int i, int j, int k)
{
  const double above = k - TopAt(i, j);
  return std::round(500.0 - 500.0 * above / (1.0 + std::abs(above)) + 12.0 * Noise(i, j, k));
}

/// Fills a block of samples with values.
template <typename T>
LARGE_RIG_UNWATCHED void FillBox(const int extent[6], void* samples, const ValueAt& value)
{
  T* sample = static_cast<T*>(samples);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        *sample++ = static_cast<T>(value(i, j, k));
      }
    }
  }
}

inline void FillBox(int type, const int extent[6], void* samples, const ValueAt& value)
{
  switch (type)
  {
    vtkTemplateMacro(FillBox<VTK_TT>(extent, samples, value));
  }
}

/// Number of calls of a reader, and the largest number of samples per call.
struct Reads
{
  std::atomic<int> Calls{ 0 };
  std::atomic<std::int64_t> Most{ 0 };
};

/// Makes a source whose reader computes the values.
inline vtkSmartPointer<vtkHapticRegionSource> MakeSource(const Extent& extent, int type,
  const ValueAt& value, const std::shared_ptr<Reads>& reads = std::make_shared<Reads>())
{
  auto source = vtkSmartPointer<vtkHapticRegionSource>::New();
  source->SetWholeExtent(extent.data());
  source->SetScalarType(type);
  source->SetReader(
    [=](const int box[6], void* samples)
    {
      FillBox(type, box, samples, value);
      const std::int64_t count =
        std::int64_t{ box[1] - box[0] + 1 } * (box[3] - box[2] + 1) * (box[5] - box[4] + 1);
      reads->Most = std::max<std::int64_t>(reads->Most, count);
      ++reads->Calls;
      return true;
    });
  return source;
}

/// Makes the volume of a source in memory.
inline vtkSmartPointer<vtkImageData> MakeWhole(
  vtkHapticRegionSource* source, int type, const ValueAt& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(source->GetWholeExtent());
  image->SetOrigin(source->GetOrigin());
  image->SetSpacing(source->GetSpacing());
  image->SetDirectionMatrix(source->GetDirection());
  image->AllocateScalars(type, 1);
  FillBox(type, image->GetExtent(), image->GetScalarPointer(), value);
  return image;
}
} // namespace largetest

#endif
