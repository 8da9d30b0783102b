// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the sampler reads nothing before the first sample or after the last one. The volume
 * is placed once at the end of the accessible memory and once at its beginning, so that a stray
 * read crashes the test.
 */

#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"
#else
#include <sys/mman.h>
#endif

#include "Core/Platform/Pages.h"

using namespace coretest;

namespace
{
/// A block of memory between two pages that cannot be accessed.
class GuardedMemory
{
public:
  explicit GuardedMemory(std::size_t bytes)
    : Page(Pages::GetSize())
    , Inner((bytes + this->Page - 1) / this->Page * this->Page)
  {
#if defined(_WIN32)
    void* const all =
      VirtualAlloc(nullptr, this->Inner + 2 * this->Page, MEM_RESERVE, PAGE_NOACCESS);
    this->All = static_cast<std::byte*>(all);
    if (!all || !VirtualAlloc(this->Begin(), this->Inner, MEM_COMMIT, PAGE_READWRITE))
    {
      throw std::bad_alloc();
    }
#else
    void* const all =
      mmap(nullptr, this->Inner + 2 * this->Page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    this->All = static_cast<std::byte*>(all);
    mprotect(this->Begin(), this->Inner, PROT_READ | PROT_WRITE);
#endif
  }
  ~GuardedMemory()
  {
#if defined(_WIN32)
    VirtualFree(this->All, 0, MEM_RELEASE);
#else
    munmap(this->All, this->Inner + 2 * this->Page);
#endif
  }
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  std::byte* Begin() const
  {
    return this->All + this->Page;
  }
  std::byte* End() const
  {
    return this->Begin() + this->Inner;
  }

private:
  std::size_t Page;
  std::size_t Inner;
  std::byte* All = nullptr;
};

/// Reads samples at corners, on voxels, at random positions inside, and far outside the volume.
double SampleEverywhere(const FieldSampler& sampler)
{
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const std::int64_t* const n = sampler.GetView().Dimensions;
  double sum = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    double at[3];
    for (int a = 0; a < 3; ++a)
    {
      const double last = static_cast<double>(n[a] - 1);
      const double x = uniform(engine) * last;
      const double dice = uniform(engine);
      at[a] = dice < 0.2 ? 0.0 : (dice < 0.4 ? last : (dice < 0.5 ? std::round(x) : x));
    }
    const Vector3 inside{ at[0], at[1], at[2] };
    sum += sampler.Gradient(inside).Value + sampler.Value(inside);
    sum += sampler.Value(3.0 * inside + Vector3{ -4.0, -4.0, -4.0 });
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : { 1e300, -1e300, HUGE_VAL, -HUGE_VAL, nan })
  {
    sum += sampler.Value({ x, x, x }) + sampler.Value({ 0.5, x, 0.0 });
  }
  return sum;
}
} // namespace

class ReadBounds : public testing::TestWithParam<ScalarType>
{
};

TEST_P(ReadBounds, NothingButTheSamplesIsRead)
{
  const TestVolume::Size sizes[] = { { 2, 2, 2 }, { 3, 2, 4 }, { 5, 6, 7 }, { 9, 9, 10 } };
  for (const TestVolume::Size& size : sizes)
  {
    for (const std::int64_t step : { 1, 3 })
    {
      const std::size_t bytes = TestVolume::Bytes(this->GetParam(), size, step);
      const GuardedMemory memory(bytes);
      for (std::byte* const place : { memory.End() - bytes, memory.Begin() })
      {
        TestVolume volume(this->GetParam(), size, step, place);
        volume.FillRandom(1);
        for (const GradientEstimator estimator : AllEstimators)
        {
          for (const int radius : { 1, 2, 3, 4, GradientKernel::MaximumRadius })
          {
            if (radius > 4 && size[0] > 3)
            {
              continue; // large kernels read the same range as in small volumes, but are slow
            }
            const GradientKernel kernel(estimator, radius);
            for (const InstructionSet set : { InstructionSet::Baseline, DetectInstructionSet() })
            {
              EXPECT_TRUE(std::isfinite(SampleEverywhere({ volume.View, kernel, set })));
            }
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReadBounds, testing::ValuesIn(AllScalarTypes));
