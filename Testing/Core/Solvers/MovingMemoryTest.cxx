// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the samples which a tick in a moving volume stores for the next tick only save time.
 * Three hands must feel the same force, to the bit: without this memory, with a new memory for each
 * tick, and with one memory for all ticks.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <list>
#include <optional>
#include <random>
#include <utility>
#include <vector>

using namespace coretest;

namespace
{
/// Random time steps of 16^3 voxels, one unit of time apart. A few samples may be NaN.
class RandomMovie
{
public:
  explicit RandomMovie(ScalarType type, int timeSteps, bool hasMotion)
  {
    for (int timeStep = 0; timeStep < timeSteps; ++timeStep)
    {
      TestVolume& volume =
        this->Volumes.emplace_back(type, std::array<std::int64_t, 3>{ Size, Size, Size });
      volume.FillRandom(static_cast<unsigned>(timeStep + 1));
      this->TimeSteps.push_back({ static_cast<double>(timeStep), volume.View, nullptr });
      if (hasMotion && timeStep + 1 < timeSteps)
      {
        this->TimeSteps.back().Displacements = { this->Displace(timeStep), ScalarType::Float64 };
      }
    }
  }

  static constexpr std::int64_t Size = 16;
  std::vector<VolumeTimeStep> TimeSteps;
  std::list<TestVolume> Volumes;

private:
  /// Makes displacements of up to 0.8 voxels.
  const void* Displace(int timeStep)
  {
    std::vector<double>& motion = this->Motions.emplace_back();
    for (std::int64_t i = 0; i < 3 * Size * Size * Size; ++i)
    {
      motion.push_back(0.8 * std::sin(0.003 * static_cast<double>(i) + timeStep));
    }
    return motion.data();
  }

  std::list<std::vector<double>> Motions;
};

struct MemoryHand
{
  void Touch(const HapticModel& model, const Vector3& tip, double time, TickMemory* memory)
  {
    this->State.DataTime = time;
    Tick(model, this->State, tip, this->Record, LocalSurfaceResult::Simulated(), memory);
  }
  ServoState State;
  TickRecord Record;
};

bool IsSameTick(const TickRecord& a, const TickRecord& b)
{
  const auto numbers = [](const TickRecord& record)
  {
    return std::array<double, 15>{ record.Proxy.X, record.Proxy.Y, record.Proxy.Z, record.Force.X,
      record.Force.Y, record.Force.Z, record.Normal.X, record.Normal.Y, record.Normal.Z,
      record.GradientMagnitude, record.SurfaceValue, record.MediumValue, record.Stiffness,
      record.SurfaceStrength, record.WallWork };
  };
  const auto x = numbers(a);
  const auto y = numbers(b);
  return std::memcmp(x.data(), y.data(), sizeof(x)) == 0 && a.Contact == b.Contact;
}

/// Moves a hand slowly, so that it stays in one voxel for many ticks, while the data time moves to
/// and fro. Expects equal ticks without a memory, with a new memory, and with one that is kept.
void ExpectMemoriesChangeNothing(const HapticModelDescription& description, double last)
{
  const HapticModel model(description);
  MemoryHand plain;
  MemoryHand fresh;
  MemoryHand kept;
  TickMemory memory;
  Wanderer wanderer(RandomMovie::Size);
  int touched = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Vector3 tip = wanderer.Next();
    const double way = 0.0037 * i;
    // In some ticks, the data time is exactly that of a time step, or 0.
    const double time =
      i % 50 < 5 ? std::floor(way) : last * (0.5 - 0.5 * std::cos(way)) * (i % 97 == 0 ? 0.0 : 1.0);
    TickMemory anew;
    plain.Touch(model, tip, time, nullptr);
    fresh.Touch(model, tip, time, &anew);
    kept.Touch(model, tip, time, &memory);
    ASSERT_TRUE(IsSameTick(plain.Record, fresh.Record)) << i;
    ASSERT_TRUE(IsSameTick(plain.Record, kept.Record)) << i;
    touched += Norm(plain.Record.Force) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 200) << "the hand feels little";
}
} // namespace

TEST(MovingMemory, ChangesNothingOfABlend)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    for (const GradientEstimator estimator : { GradientEstimator::Gaussian,
           GradientEstimator::CubicBSpline, GradientEstimator::CentralDifference })
    {
      for (const bool hasMotion : { false, true })
      {
        SCOPED_TRACE(testing::Message() << "solver " << static_cast<int>(solver) << " estimator "
                                        << static_cast<int>(estimator) << " motion " << hasMotion);
        const RandomMovie movie(ScalarType::Int16, 4, hasMotion);
        HapticModelDescription description = Describe(movie.Volumes.front());
        description.TimeSteps = movie.TimeSteps;
        description.Estimator = estimator;
        description.Settings.Solver = solver;
        description.Material.Friction = ConstantPolyline(0.3);
        ExpectMemoriesChangeNothing(description, 3.0);
      }
    }
  }
}

/// A memory must not keep samples that are NaN.
TEST(MovingMemory, ChangesNothingWhereSamplesAreMissing)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    RandomMovie movie(ScalarType::Float32, 3, false);
    std::mt19937_64 engine(7);
    for (TestVolume& volume : movie.Volumes)
    {
      volume.Fill<float>(
        [&](std::int64_t, std::int64_t, std::int64_t)
        {
          const auto dice = engine() % 2000;
          return dice == 0 ? std::nanf("") : static_cast<float>(dice);
        });
    }
    for (const GradientEstimator estimator :
      { GradientEstimator::Gaussian, GradientEstimator::CubicBSpline })
    {
      HapticModelDescription description = Describe(movie.Volumes.front());
      description.TimeSteps = movie.TimeSteps;
      description.Estimator = estimator;
      description.Settings.Solver = solver;
      ExpectMemoriesChangeNothing(description, 2.0);
    }
  }
}

/// The solver Paper reads the values before and after a motion together. The two instants are
/// between the same time steps, in different intervals, or at time steps.
TEST(MovingMemory, ValuesAtTwoInstantsAreThoseOfEachToTheBit)
{
  RandomMovie movie(ScalarType::Float32, 3, false);
  std::mt19937_64 engine(11);
  for (TestVolume& volume : movie.Volumes)
  {
    volume.Fill<float>(
      [&](std::int64_t, std::int64_t, std::int64_t)
      {
        const auto dice = engine() % 500;
        return dice == 0 ? std::nanf("") : static_cast<float>(dice);
      });
  }
  for (const GradientEstimator estimator : { GradientEstimator::Gaussian,
         GradientEstimator::CubicBSpline, GradientEstimator::CentralDifference })
  {
    HapticModelDescription description = Describe(movie.Volumes.front());
    description.TimeSteps = movie.TimeSteps;
    description.Estimator = estimator;
    const HapticModel model(description);
    std::uniform_real_distribution<double> place(0.0, RandomMovie::Size - 1.0);
    std::uniform_real_distribution<double> instant(0.0, 2.0);
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 at{ place(engine), place(engine), place(engine) };
      const double first = i % 7 == 0 ? 1.0 : instant(engine);
      const double second = i % 2 == 0 ? std::min(2.0, first + 0.01) : instant(engine);
      const FieldAtTime a = model.Baked->At(first);
      const FieldAtTime b = model.Baked->At(second);
      const FractionPair pair = FieldAtTime::Values(a, b, at);
      ASSERT_EQ(pair.First, a.Value(at)) << first << " and " << second;
      ASSERT_EQ(pair.Second, b.Value(at)) << first << " and " << second;
      ASSERT_TRUE(std::isfinite(pair.First));
    }
  }
}

/// The solver Paper has a shorter code path for two instants between the same time steps. It must
/// compute the same values as reading each instant alone.
TEST(MovingMemory, AStepBetweenTimeStepsIsReadAsBothInstantsToTheBit)
{
  RandomMovie movie(ScalarType::Float32, 4, false);
  std::mt19937_64 engine(13);
  for (TestVolume& volume : movie.Volumes)
  {
    volume.Fill<float>(
      [&](std::int64_t, std::int64_t, std::int64_t)
      {
        const auto dice = engine() % 1000;
        return dice == 0 ? std::nanf("") : static_cast<float>(dice);
      });
  }
  for (const auto& [estimator, radius] :
    { std::pair{ GradientEstimator::Gaussian, 1 }, std::pair{ GradientEstimator::Gaussian, 2 },
      std::pair{ GradientEstimator::Gaussian, 3 }, std::pair{ GradientEstimator::Gaussian, 4 },
      std::pair{ GradientEstimator::CubicBSpline, 2 },
      std::pair{ GradientEstimator::CentralDifference, 2 } })
  {
    HapticModelDescription description = Describe(movie.Volumes.front());
    description.TimeSteps = movie.TimeSteps;
    description.Estimator = estimator;
    description.KernelRadius = radius;
    const HapticModel model(description);
    std::uniform_real_distribution<double> place(0.0, RandomMovie::Size - 1.0);
    std::uniform_real_distribution<double> instant(0.0, 3.0);
    TickMemory memory;
    int between = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 at{ place(engine), place(engine), place(engine) };
      const Vector3 aside{ 0.6 * radius, -0.7 * radius, 0.2 * radius };
      const double first = i % 7 == 0 ? 1.0 : instant(engine);
      const double second = i % 11 == 0 ? 2.0 : instant(engine);
      std::optional<FieldStep> step = model.Baked->ComputeStep(first, second, memory);
      const bool isBetween = std::floor(first) == std::floor(second) &&
        first != std::floor(first) && second != std::floor(second);
      ASSERT_EQ(step.has_value(), isBetween) << first << " and " << second;
      if (!step)
      {
        continue;
      }
      ++between;
      const FieldAtTime now = model.Baked->At(second);
      const FieldSample sample = step->Gradient(at);
      const FieldSample expected = now.Gradient(at);
      ASSERT_TRUE((std::isnan(sample.Value) && std::isnan(expected.Value)) ||
        std::memcmp(&sample, &expected, sizeof(sample)) == 0);
      const FractionPair values = step->Values(at);
      ASSERT_EQ(values.First, model.Baked->At(first).Value(at));
      ASSERT_EQ(values.Second, now.Value(at));
      ASSERT_EQ(step->Value(at + 0.1 * aside), now.Value(at + 0.1 * aside));
      const ValuePair sides = step->Values(at, aside);
      const ValuePair expectedSides = now.Values(at, aside);
      ASSERT_EQ(sides.Ahead, expectedSides.Ahead);
      ASSERT_EQ(sides.Behind, expectedSides.Behind);
    }
    EXPECT_GT(between, 400);
  }
}

/// The test publishes models with the next time steps, as a program does, and keeps the memory.
TEST(MovingMemory, GoesOnWithTheNextTimeSteps)
{
  RandomMovie movie(ScalarType::Int16, 5, false);
  HapticModelDescription description = Describe(movie.Volumes.front());
  MemoryHand plain;
  MemoryHand kept;
  TickMemory memory;
  Wanderer wanderer(RandomMovie::Size);
  for (std::size_t span = 0; span + 2 < movie.TimeSteps.size(); ++span)
  {
    const auto from = movie.TimeSteps.begin() + static_cast<std::ptrdiff_t>(span);
    description.TimeSteps.assign(from, from + 3);
    description.View = description.TimeSteps.front().View;
    const HapticModel model(description);
    for (int i = 0; i < 1000; ++i)
    {
      const Vector3 tip = wanderer.Next();
      const double time = static_cast<double>(span) + 0.001 * i;
      plain.Touch(model, tip, time, nullptr);
      kept.Touch(model, tip, time, &memory);
      ASSERT_TRUE(IsSameTick(plain.Record, kept.Record)) << span << ", " << i;
    }
  }
}
