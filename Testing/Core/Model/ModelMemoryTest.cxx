// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests how much memory a model needs besides the image: less than 1 MiB, whatever the size of the
 * image.
 */

#include "Rigs/AllocationCounter.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace coretest;

namespace
{
constexpr std::size_t MiB = 1048576;
/// Number of bytes that the allocator may add to the few blocks of a model.
constexpr std::size_t Rounding = 8192;

class ModelMemory : public testing::TestWithParam<std::tuple<GradientEstimator, int>>
{
protected:
  /// Makes a model. Returns its number of bytes, as counted by the allocator.
  std::size_t Measure(const HapticModelDescription& description)
  {
    const std::size_t before = CountAllocations().LiveBytes;
    const auto model = std::make_unique<const HapticModel>(description);
    const std::size_t bytes = CountAllocations().LiveBytes - before;
    // GetMemorySize() must agree with the allocator's count, except for rounding.
    EXPECT_LE(model->GetMemorySize(), bytes);
    EXPECT_GE(model->GetMemorySize() + Rounding, bytes);
    return bytes;
  }
};
} // namespace

TEST_P(ModelMemory, UnderOneMebibyteWhateverTheImage)
{
  const auto [estimator, radius] = this->GetParam();
  TestVolume volume(ScalarType::Int16, { 4, 4, 4 });
  HapticModelDescription description = Describe(volume);
  description.Estimator = estimator;
  description.KernelRadius = radius;
  const std::size_t small = this->Measure(description);
  EXPECT_LT(small, MiB);

  // Describe 2048^3 samples without allocating them. The model only refers to samples, and nothing
  // reads them here.
  for (std::int64_t& n : description.View.Dimensions)
  {
    n = 2048;
  }
  description.View.Stride[1] = 2048;
  description.View.Stride[2] = 2048 * 2048;
  EXPECT_LE(this->Measure(description), small + Rounding);
}

TEST_P(ModelMemory, UnderOneMebibyteWithDetailedMaterials)
{
  const auto [estimator, radius] = this->GetParam();
  const TestVolume volume = MakeRamp(4);
  HapticModelDescription description = Describe(volume);
  description.Estimator = estimator;
  description.KernelRadius = radius;
  HapticMaterial& material = description.Material;
  int shift = 0;
  for (Polyline* line : { &material.Stiffness, &material.Friction, &material.SurfaceStrength,
         &material.Viscosity, &material.Distinctness })
  {
    line->clear();
    ++shift;
    // Give each function 256 of its own break points, far more than a person draws.
    for (int i = 0; i < 256; ++i)
    {
      line->push_back({ 10.0 * i + shift, (i % 10) * 0.1 });
    }
  }
  EXPECT_LT(this->Measure(description), MiB);
}

INSTANTIATE_TEST_SUITE_P(All, ModelMemory,
  testing::Combine(
    testing::ValuesIn(AllEstimators), testing::Range(1, GradientKernel::MaximumRadius + 1)));

TEST(HapticModel, KeepsTheSamplesAlive)
{
  const TestVolume volume = MakeRamp(8);
  HapticModelDescription description = Describe(volume);
  auto owner = std::make_shared<const int>(0);
  const std::weak_ptr<const int> watched = owner;
  description.Samples = std::move(owner);
  auto model = std::make_unique<const HapticModel>(description);
  description.Samples.reset();
  EXPECT_FALSE(watched.expired());
  model.reset();
  EXPECT_TRUE(watched.expired());
}
