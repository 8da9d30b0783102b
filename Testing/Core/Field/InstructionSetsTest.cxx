// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that all instruction sets compute the same bits, so that a trace does not depend on the
 * processor.
 */

#include "Core/Field/LabelSampler.h"
#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Returns whether two numbers have equal bits. All NaNs count as equal.
bool IsSame(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b));
}

bool IsSame(const FieldSample& a, const FieldSample& b)
{
  return IsSame(a.Value, b.Value) && IsSame(a.Gradient.X, b.Gradient.X) &&
    IsSame(a.Gradient.Y, b.Gradient.Y) && IsSame(a.Gradient.Z, b.Gradient.Z);
}

class InstructionSets : public testing::TestWithParam<GradientEstimator>
{
protected:
  void SetUp() override
  {
    if (DetectInstructionSet() != InstructionSet::AVX2)
    {
      GTEST_SKIP() << "this processor has no AVX2";
    }
  }

  void Compare(const TestVolume& volume, int radius)
  {
    const GradientKernel kernel(this->GetParam(), radius);
    const FieldSampler baseline(volume.View, kernel, InstructionSet::Baseline);
    const FieldSampler avx2(volume.View, kernel, InstructionSet::AVX2);
    const std::int64_t* const n = volume.View.Dimensions;
    TapMemory ofBaseline;
    TapMemory ofAvx2;
    TapMemory ofBoth;
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 400; ++i)
    {
      const auto along = [&](std::int64_t samples)
      {
        const double x = uniform(engine) * static_cast<double>(samples - 1);
        return uniform(engine) < 0.2 ? std::round(x) : x;
      };
      const Vector3 inside{ along(n[0]), along(n[1]), along(n[2]) };
      const Vector3 around = 1.5 * inside + Vector3{ -3.0, -3.0, -3.0 };
      ASSERT_TRUE(IsSame(baseline.Gradient(inside), avx2.Gradient(inside)));
      // A memory of taps must not change the results. Test it at two consecutive positions, and at
      // two positions in the same voxel.
      const auto beside = [&](double x, std::int64_t samples)
      { return std::min(std::floor(x) + uniform(engine), static_cast<double>(samples - 1)); };
      for (const Vector3& at : { inside,
             Vector3{ beside(inside.X, n[0]), beside(inside.Y, n[1]), beside(inside.Z, n[2]) } })
      {
        const FieldSample expected = baseline.Gradient(at);
        ASSERT_TRUE(IsSame(expected, baseline.Gradient(at, &ofBaseline)));
        ASSERT_TRUE(IsSame(expected, avx2.Gradient(at, &ofAvx2)));
        ASSERT_TRUE(IsSame(expected, (i % 2 == 0 ? baseline : avx2).Gradient(at, &ofBoth)));
      }
      ASSERT_TRUE(IsSame(baseline.Value(inside), avx2.Value(inside)));
      ASSERT_TRUE(IsSame(baseline.Value(around), avx2.Value(around)));
    }
  }
};
FieldSampler::OtherTimeStep With(
  const FieldSampler& first, const FieldSampler& second, double fraction)
{
  return { second, fraction, first.BlendsSamples(second) };
}

} // namespace

TEST_P(InstructionSets, AgreeForEveryTypeAndLayout)
{
  for (const ScalarType type : AllScalarTypes)
  {
    for (const std::int64_t step : { 1, 3 })
    {
      // The kernels of small radii are unrolled for their number of taps; the largest radius here
      // uses the general kernel.
      for (const int radius : { 1, 2, 3, 4 })
      {
        SCOPED_TRACE(testing::Message()
          << "type " << static_cast<int>(type) << " step " << step << " radius " << radius);
        TestVolume volume(type, { 14, 13, 12 }, step);
        volume.FillRandom(static_cast<unsigned>(radius));
        this->Compare(volume, radius);
      }
    }
  }
}

TEST_P(InstructionSets, AgreeWhereSamplesAreNotFinite)
{
  TestVolume volume(ScalarType::Float32, { 14, 13, 12 });
  std::mt19937_64 engine(5);
  volume.Fill<float>(
    [&](std::int64_t, std::int64_t, std::int64_t)
    {
      const auto dice = engine() % 200;
      return dice == 0
        ? std::numeric_limits<float>::quiet_NaN()
        : (dice == 1 ? -std::numeric_limits<float>::infinity() : static_cast<float>(dice) * 1e36F);
    });
  for (const int radius : { 1, 2, 3, 4 })
  {
    this->Compare(volume, radius);
  }
}

TEST_P(InstructionSets, StridedAndContiguousSamplesAgree)
{
  for (const ScalarType type : AllScalarTypes)
  {
    TestVolume near(type, { 12, 11, 10 });
    TestVolume far(type, { 12, 11, 10 }, 4);
    near.FillRandom(1);
    far.FillRandom(1);
    for (const int radius : { 1, 2, 3, 4 })
    {
      const GradientKernel kernel(this->GetParam(), radius);
      const FieldSampler a(near.View, kernel);
      const FieldSampler b(far.View, kernel);
      std::mt19937_64 engine(9);
      std::uniform_real_distribution<double> uniform(0.0, 9.0);
      for (int i = 0; i < 100; ++i)
      {
        const Vector3 p{ uniform(engine), uniform(engine), uniform(engine) };
        ASSERT_TRUE(IsSame(a.Gradient(p), b.Gradient(p)) && IsSame(a.Value(p), b.Value(p)))
          << "type " << static_cast<int>(type) << " radius " << radius;
      }
    }
  }
}

TEST_P(InstructionSets, MemoriesAreOfOneField)
{
  // Use one memory with other samples, as when one model replaces another.
  TestVolume volume(ScalarType::Int16, { 12, 11, 10 });
  const GradientKernel kernel(this->GetParam(), 2);
  TapMemory memory;
  const Vector3 p{ 5.3, 5.6, 4.2 };
  for (const unsigned seed : { 1U, 2U })
  {
    volume.FillRandom(seed);
    const FieldSampler field(volume.View, kernel);
    EXPECT_TRUE(IsSame(field.Gradient(p, &memory), field.Gradient(p))) << "seed " << seed;
  }
}

TEST_P(InstructionSets, ABlendIsAsAVolumeOfBlendedSamples)
{
  // Kernels with few taps blend the samples before summing. Kernels with many taps blend the two
  // sums.
  const auto isBefore = [this](int radius)
  { return this->GetParam() != GradientEstimator::Gaussian || radius < 4; };
  const auto hasTaps = [this](int radius)
  { return this->GetParam() == GradientEstimator::Gaussian && radius < 3; };
  int tapCount = 0;
  const auto isNear = [](const FieldSample& a, const FieldSample& b, double scale)
  {
    return std::abs(a.Value - b.Value) <= 1e-12 * scale &&
      Norm(a.Gradient - b.Gradient) <= 1e-12 * scale;
  };
  const auto compare =
    [&](const TestVolume& first, const TestVolume& second, double fraction, int radius)
  {
    TestVolume blended(ScalarType::Float64, { 12, 11, 10 });
    double largest = 0.0;
    blended.Fill<double>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const double a = first(i, j, k);
        const double b = second(i, j, k);
        largest = std::max({ largest, std::abs(a), std::abs(b) });
        return a + fraction * (b - a);
      });
    const GradientKernel kernel(this->GetParam(), radius);
    const FieldSampler expected(blended.View, kernel);
    for (const InstructionSet set : { InstructionSet::Baseline, InstructionSet::AVX2 })
    {
      const FieldSampler a(first.View, kernel, set);
      const FieldSampler b(second.View, kernel, set);
      TickMemory memory;
      std::mt19937_64 engine(11);
      std::uniform_real_distribution<double> uniform(0.0, 9.0);
      for (int i = 0; i < 100; ++i)
      {
        const Vector3 p{ uniform(engine), uniform(engine), uniform(engine) };
        const Vector3 near{ std::floor(p.X) + 0.3, std::floor(p.Y) + 0.9, std::floor(p.Z) };
        for (const Vector3& at : { p, near, p })
        {
          const FieldSampler::OtherTimeStep other = With(a, b, fraction);
          const FieldSampler::OtherTimeStep own = With(a, a, fraction);
          const double half = 0.5 * fraction;
          const FieldSampler::OtherTimeStep before = With(a, b, half);
          const FieldSample sample = a.Gradient(other, at);
          const FieldSample blend = expected.Gradient(at);
          ASSERT_TRUE(isBefore(radius) ? IsSame(sample, blend) : isNear(sample, blend, largest));
          const BlendMemories memories{ &memory.Of(0), &memory.Of(1), &memory };
          ASSERT_TRUE(IsSame(a.Gradient(other, at, memories), sample));
          // Read at another instant, with the memories of the first instant.
          ASSERT_TRUE(IsSame(a.Gradient(before, at, memories), a.Gradient(before, at)));
          ASSERT_TRUE(IsSame(a.Gradient(other, at, memories), sample));
          ASSERT_TRUE(IsSame(a.Gradient(own, at), a.Gradient(at)));
          ASSERT_TRUE(IsSame(a.Value(other, at), expected.Value(at)));
          const FractionPair pair = a.Values(other, half, at);
          ASSERT_TRUE(IsSame(pair.First, a.Value(other, at)));
          ASSERT_TRUE(IsSame(pair.Second, a.Value(before, at)));
          // Compute the values from the samples that the gradient has read, where these samples
          // suffice.
          const TimeStepTaps* const taps = a.GetTaps(other, memory);
          ASSERT_TRUE(!taps || hasTaps(radius));
          const FractionPair tapped = a.Values(other, half, at, taps);
          ASSERT_TRUE(IsSame(tapped.First, pair.First) && IsSame(tapped.Second, pair.Second));
          const Vector3 aside{ 3.0 * uniform(engine), -2.0 * uniform(engine), uniform(engine) };
          const ValuePair expectedSides = a.Values(other, at, aside);
          const ValuePair sides = a.Values(other, at, aside, taps);
          ASSERT_TRUE(IsSame(sides.Ahead, expectedSides.Ahead));
          ASSERT_TRUE(IsSame(sides.Behind, expectedSides.Behind));
          ASSERT_TRUE(IsSame(a.Value(other, at + aside, taps), a.Value(other, at + aside)));
          tapCount += taps ? 1 : 0;
        }
      }
    }
  };
  for (const int radius : { 1, 2, 3, 4 })
  {
    for (const ScalarType type : AllScalarTypes)
    {
      SCOPED_TRACE(testing::Message() << "radius " << radius << " type " << static_cast<int>(type));
      TestVolume first(type, { 12, 11, 10 });
      TestVolume second(type, { 12, 11, 10 });
      TestVolume strided(type, { 12, 11, 10 }, 3);
      first.FillRandom(1);
      second.FillRandom(2);
      strided.FillRandom(3);
      tapCount = 0;
      compare(first, second, 0.3, radius);
      EXPECT_EQ(tapCount > 100, hasTaps(radius)) << "gradients leave samples for values";
      compare(first, strided, 0.9, radius);
    }
  }
}

TEST_P(InstructionSets, TwoTimeStepsAtOnceAreAsEachAlone)
{
  const auto compare = [this](const TestVolume& first, const TestVolume& second, int radius)
  {
    const GradientKernel kernel(this->GetParam(), radius);
    for (const InstructionSet set : { InstructionSet::Baseline, InstructionSet::AVX2 })
    {
      const FieldSampler a(first.View, kernel, set);
      const FieldSampler b(second.View, kernel, set);
      std::mt19937_64 engine(11);
      std::uniform_real_distribution<double> uniform(0.0, 9.0);
      for (int i = 0; i < 100; ++i)
      {
        const Vector3 p{ uniform(engine), uniform(engine), uniform(engine) };
        const FieldSample gradients[2] = { a.Gradient(p), b.Gradient(p) };
        const FieldSample blend = a.Gradient(With(a, b, 0.5), p);
        const double scale = std::abs(gradients[0].Value) + std::abs(gradients[1].Value) +
          Norm(gradients[0].Gradient) + Norm(gradients[1].Gradient);
        ASSERT_NEAR(blend.Value, 0.5 * (gradients[0].Value + gradients[1].Value), 1e-10 * scale);
        ASSERT_LE(Norm(blend.Gradient - 0.5 * (gradients[0].Gradient + gradients[1].Gradient)),
          1e-10 * scale);
        const Vector3 offset{ 2.0, -3.0, 0.7 }; // extends beyond the border at many positions
        const ValuePair values = a.Values(With(a, b, 0.5), p, offset);
        const auto expectMean = [&](double value, const Vector3& at)
        {
          const double first = a.Value(at);
          const double second = b.Value(at);
          ASSERT_NEAR(value, 0.5 * (first + second), 1e-10 * (std::abs(first) + std::abs(second)));
        };
        expectMean(values.Ahead, p + offset);
        expectMean(values.Behind, p - offset);
        expectMean(a.Value(With(a, b, 0.5), p), p);
      }
    }
  };
  for (const int radius : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(testing::Message() << "radius " << radius);
    for (const ScalarType type : AllScalarTypes)
    {
      TestVolume first(type, { 12, 11, 10 });
      TestVolume second(type, { 12, 11, 10 });
      TestVolume strided(type, { 12, 11, 10 }, 3);
      first.FillRandom(1);
      second.FillRandom(2);
      strided.FillRandom(3);
      compare(first, second, radius);
      compare(first, strided, radius);
    }
    // Time steps with different types or sizes can't share their weights.
    TestVolume shorts(ScalarType::Int16, { 12, 11, 10 });
    TestVolume floats(ScalarType::Float32, { 12, 11, 10 });
    TestVolume smaller(ScalarType::Int16, { 10, 10, 10 });
    shorts.FillRandom(4);
    floats.FillRandom(5);
    smaller.FillRandom(6);
    compare(shorts, floats, radius);
    compare(shorts, smaller, radius);
  }
}

/// The value changes continuously from one time step's value to the next one's, even if one time
/// step lacks a sample.
TEST_P(InstructionSets, ASampleThatOneTimeStepLacksMakesNoStep)
{
  const GradientKernel kernel(this->GetParam(), 2);
  TestVolume frames[2] = { { ScalarType::Float32, { 12, 11, 10 } },
    { ScalarType::Float32, { 12, 11, 10 } } };
  for (const int lacking : { 0, 1 })
  {
    for (int i = 0; i < 2; ++i)
    {
      frames[i].Fill<float>(
        [&](std::int64_t x, std::int64_t y, std::int64_t z)
        {
          const bool isThere = i != lacking || x != 5 || y != 5 || z != 5;
          return isThere ? 100.0F + static_cast<float>(10 * i + x) : std::nanf("");
        });
    }
    const FieldSampler first(frames[0].View, kernel);
    const FieldSampler second(frames[1].View, kernel);
    const Vector3 at{ 5.4, 5.2, 4.7 };
    const Vector3 offset{ 0.2, 0.1, -0.1 };
    double before = first.Value(at);
    double ahead = first.Values(at, offset).Ahead;
    const double whole = std::abs(second.Value(at) - before) + std::abs(ahead) + 1.0;
    constexpr int steps = 1000;
    for (int i = 1; i <= steps; ++i)
    {
      const double fraction = static_cast<double>(i) / steps;
      const double now =
        i < steps ? first.Value(With(first, second, fraction), at) : second.Value(at);
      const double nowAhead = i < steps
        ? first.Values(With(first, second, fraction), at, offset).Ahead
        : second.Values(at, offset).Ahead;
      EXPECT_LE(std::abs(now - before), 2.0 * whole / steps) << fraction;
      EXPECT_LE(std::abs(nowAhead - ahead), 2.0 * whole / steps) << fraction;
      before = now;
      ahead = nowAhead;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, InstructionSets, testing::ValuesIn(AllEstimators));

TEST(InstructionSetsOfLabels, AgreeForEveryTypeAndLayout)
{
  if (DetectInstructionSet() != InstructionSet::AVX2)
  {
    GTEST_SKIP() << "this processor has no AVX2";
  }
  const GradientKernel kernel(GradientEstimator::Gaussian, 3, GaussianWeights::OwnDerivative, 2.2);
  ASSERT_EQ(kernel.Taps, LabelBlock::Taps);
  std::mt19937_64 engine(7);
  int stepped = 0;
  for (const ScalarType type : AllScalarTypes)
  {
    for (const std::int64_t step : { 1, 3 })
    {
      for (const std::int64_t labels : { 1, 2, 5, 100 })
      {
        SCOPED_TRACE(testing::Message()
          << "type " << static_cast<int>(type) << " step " << step << " labels " << labels);
        TestVolume volume(type, { 14, 13, 12 }, step);
        WithSampleType(type,
          [&](auto t)
          {
            using T = decltype(t);
            // A few labels form slabs; many labels change randomly from voxel to voxel.
            volume.Fill<T>(
              [&](std::int64_t i, std::int64_t j, std::int64_t k) {
                return labels < 100 ? (i + j / 2 + k) / 7 % labels : std::int64_t(engine() % 100);
              });
          });
        const LabelSampler baseline(volume.View, kernel, InstructionSet::Baseline);
        const LabelSampler avx2(volume.View, kernel, InstructionSet::AVX2);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        for (int i = 0; i < 100; ++i)
        {
          const Vector3 p{ 13.0 * uniform(engine), 12.0 * uniform(engine), 11.0 * uniform(engine) };
          LabelBlock blocks[2];
          LabelWeights weights[2];
          baseline.Collect(p, blocks[0]);
          baseline.Weigh(p, weights[0]);
          avx2.Collect(p, blocks[1]);
          avx2.Weigh(p, weights[1]);
          ASSERT_EQ(blocks[0].Count, blocks[1].Count);
          for (int l = 0; l < blocks[0].Count; ++l)
          {
            ASSERT_EQ(blocks[0].Label[l], blocks[1].Label[l]);
            const FieldSample fraction = baseline.Fraction(weights[0], blocks[0].Planes[l]);
            ASSERT_TRUE(IsSame(fraction, avx2.Fraction(weights[1], blocks[1].Planes[l])));
            LabelSteps steps;
            if (steps.Set(blocks[0].Planes[l]))
            {
              ++stepped;
              const FieldSample other = baseline.Fraction(p, steps);
              ASSERT_TRUE(IsSame(other, avx2.Fraction(p, steps)));
              ASSERT_NEAR(other.Value, fraction.Value, 1e-14);
              ASSERT_NEAR(Norm(other.Gradient - fraction.Gradient), 0.0, 1e-14);
            }
          }
        }
      }
    }
  }
  EXPECT_GT(stepped, 1000);
}
