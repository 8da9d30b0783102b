// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares reading at many points with loops over the eight samples of a cell. The bits must be the
 * same on each processor.
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <iterator>

using namespace coretest;

namespace
{
/// Interpolates trilinearly by the definition (slow reference). Clamps the position to the samples.
double Naive(const TestVolume& volume, const Vector3& index)
{
  const double place[3] = { index.X, index.Y, index.Z };
  std::int64_t cell[3];
  double fraction[3];
  for (int a = 0; a < 3; ++a)
  {
    const double last = static_cast<double>(volume.View.Dimensions[a] - 1);
    const double inside = std::clamp(place[a], 0.0, last);
    cell[a] = static_cast<std::int64_t>(std::min(std::floor(inside), last - 1.0));
    fraction[a] = inside - static_cast<double>(cell[a]);
  }
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const int at[3] = { i & 1, i >> 1 & 1, i >> 2 };
    double weight = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      weight *= at[a] ? fraction[a] : 1.0 - fraction[a];
    }
    sum += weight == 0.0 ? 0.0 : weight * volume(cell[0] + at[0], cell[1] + at[1], cell[2] + at[2]);
  }
  return sum;
}

std::vector<Vector3> MakePlaces(double size)
{
  std::mt19937_64 engine(5);
  std::vector<Vector3> places;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 at = Vector3{ 0.5 * size, 0.5 * size, 0.5 * size } + RandomIn(engine, 0.6 * size);
    places.push_back(i % 7 == 0 ? Vector3{ std::round(at.X), at.Y, std::round(at.Z) } : at);
  }
  return places;
}

/// Reads the values at positions in index space.
ShellBatch ReadFeet(const ShellReader& reader, const Vector3* places, std::size_t count)
{
  const ShellFrame frame{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, 1.0, 1.0,
    2.0 };
  ShellBatch batch{};
  batch.Count = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double numbers[3] = { places[i].X, places[i].Y, places[i].Z };
    for (int a = 0; a < 3; ++a)
    {
      batch.Place[a][i] = batch.Index[a][i] = numbers[a];
    }
  }
  reader.ComputeAllFeet(frame, batch);
  return batch;
}

class ReadingOfShells : public testing::TestWithParam<ScalarType>
{
};
} // namespace

TEST_P(ReadingOfShells, IsThatOfTheDefinition)
{
  for (const std::int64_t step : { 1, 3 })
  {
    TestVolume volume(this->GetParam(), { 12, 13, 14 }, step);
    volume.FillRandom(3);
    double scale = 0.0;
    for (std::int64_t i = 0; i < 12 * 13 * 14; ++i)
    {
      scale = std::max(scale, std::abs(volume(i % 12, i / 12 % 13, i / 156)));
    }
    const ShellReader reader(volume.View, 0.0, false);
    for (const Vector3& at : MakePlaces(13.0))
    {
      const double place[3] = { at.X, at.Y, at.Z };
      double value = 0.0;
      reader.ReadValues({ place, place + 1, place + 2, 1 }, &value);
      const ShellBatch foot = ReadFeet(reader, &at, 1);
      EXPECT_NEAR(value, Naive(volume, at), 1e-13 * scale);
      EXPECT_NEAR(foot.Value[0], Naive(volume, at), 1e-13 * scale);
      const Vector3 steps[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
      for (int a = 0; a < 3; ++a)
      {
        const double slope = 0.5 * (Naive(volume, at + steps[a]) - Naive(volume, at - steps[a]));
        EXPECT_NEAR(foot.Gradient[a][0], slope, 1e-13 * scale);
        const double place = (a == 0 ? at.X : (a == 1 ? at.Y : at.Z));
        const Vector3 whole = (std::floor(place) - place) * steps[a];
        const Vector3 begin = at + whole;
        if (std::min(std::min(at.X, at.Y), at.Z) >= 1.0 && at.X < 10.0 && at.Y < 11.0 &&
          at.Z < 12.0)
        {
          // Within a cell, the value along an axis is linear.
          const double own = Naive(volume, begin + steps[a]) - Naive(volume, begin);
          EXPECT_NEAR(foot.Cell[a][0], own, 1e-12 * scale);
        }
      }
    }
  }
}

TEST_P(ReadingOfShells, HasTheSameBitsOnEveryProcessor)
{
  if (DetectInstructionSet() != InstructionSet::AVX2)
  {
    GTEST_SKIP() << "this processor has no AVX2";
  }
  TestVolume volume(this->GetParam(), { 14, 14, 14 });
  volume.FillRandom(4);
  const std::vector<Vector3> places = MakePlaces(14.0);
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
  for (const Vector3& at : places)
  {
    x.push_back(at.X);
    y.push_back(at.Y);
    z.push_back(at.Z);
  }
  const auto read = [&](InstructionSet set)
  {
    const ShellReader reader(volume.View, 20.0, false, set);
    std::vector<double> all(places.size());
    reader.ReadValues({ x.data(), y.data(), z.data(), places.size() }, all.data());
    for (std::size_t i = 0; i < places.size(); i += 50)
    {
      const ShellBatch batch = ReadFeet(reader, places.data() + i, 50);
      const auto* const read = reinterpret_cast<const double*>(batch.Value);
      const auto* const end = reinterpret_cast<const double*>(&batch + 1);
      std::copy_if(read, end, std::back_inserter(all), [](double x) { return !std::isnan(x); });
      ShellPushes forces{};
      forces.Count = 52;
      for (std::size_t n = 0; n < 52; ++n)
      {
        const Vector3& at = places[(i + n) % places.size()];
        const double wrench[6] = { 0.1 * at.X, 0.2 * at.Y, 0.1 * at.Z, at.Y, at.Z, at.X };
        for (int a = 0; a < 6; ++a)
        {
          forces.Wrench[a][n] = wrench[a];
        }
        forces.Force[n] = at.X;
        forces.Stiffness[n] = at.Z;
      }
      double sums[27] = {};
      reader.Add(forces, sums, sums + 6);
      all.insert(all.end(), sums, sums + 27);
    }
    const double turned[12] = { 0.9, 0.1, -0.3, 0.2, 0.8, 0.1, 0.3, -0.1, 0.9, 0.3, 0.1, -0.2 };
    std::vector<std::uint64_t> marks;
    for (std::size_t i = 0; i < places.size(); i += 50)
    {
      marks.push_back(reader.Mark({ x.data() + i, y.data() + i, z.data() + i, 50 }, turned));
      marks.push_back(reader.MayBeSolid(places[i], { 1.5, 1.0, 0.2 }) ? 1 : 0);
      double slopes[3] = {};
      marks.push_back(reader.ComputeSlopes(places[i], { 1.5, 1.0, 0.2 }, slopes) ? 1 : 0);
      all.insert(all.end(), slopes, slopes + 3);
      std::vector<double> until(64, -1.0);
      marks.push_back(reader.MarkWhole({ x.data() + i, y.data() + i, z.data() + i, 50 }, turned,
        { 0, until.data(), 0.0, 0.0, 0.01 }));
      all.insert(all.end(), until.begin(), until.begin() + 50);
    }
    return std::make_pair(all, marks);
  };
  const auto baseline = read(InstructionSet::Baseline);
  const auto avx2 = read(InstructionSet::AVX2);
  ASSERT_EQ(baseline.first.size(), avx2.first.size());
  const std::size_t bytes = baseline.first.size() * sizeof(double);
  EXPECT_EQ(std::memcmp(baseline.first.data(), avx2.first.data(), bytes), 0);
  EXPECT_EQ(baseline.second, avx2.second);
}

/// The reader must return the same bits for a single point and for a point among others, even at
/// borders and next to samples that are NaN.
TEST_P(ReadingOfShells, OfSeveralPointsIsThatOfEach)
{
  constexpr std::size_t count = 61;
  for (const std::int64_t step : { 1, 3 })
  {
    TestVolume volume(this->GetParam(), { 14, 14, 14 }, step);
    volume.FillRandom(9);
    WithSampleType(this->GetParam(),
      [&volume](auto sample)
      {
        using T = decltype(sample);
        if constexpr (std::is_floating_point_v<T>)
        {
          volume.template Fill<T>([](std::int64_t i, std::int64_t j, std::int64_t k)
            { return (i + j + k) % 11 == 0 ? std::nan("") : std::sin(17.0 * i + 5.0 * j + k); });
        }
      });
    const std::vector<Vector3> places = MakePlaces(14.0);
    const ShellReader reader(volume.View, 20.0, false);
    const ShellBatch all = ReadFeet(reader, places.data(), count);
    std::vector<double> numbers[3];
    for (std::size_t i = 0; i < count; ++i)
    {
      numbers[0].push_back(places[i].X);
      numbers[1].push_back(places[i].Y);
      numbers[2].push_back(places[i].Z);
    }
    std::vector<double> values(count);
    reader.ReadValues({ numbers[0].data(), numbers[1].data(), numbers[2].data(), count }, //
      values.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      const ShellBatch one = ReadFeet(reader, &places[i], 1);
      double value = 0.0;
      reader.ReadValues({ &places[i].X, &places[i].Y, &places[i].Z, 1 }, &value);
      const auto numbersOf = [](const ShellBatch& batch, std::size_t n, double valueThere)
      {
        return std::array<double, 8>{ batch.Value[n], batch.Gradient[0][n], batch.Gradient[1][n],
          batch.Gradient[2][n], batch.Cell[0][n], batch.Cell[1][n], batch.Cell[2][n], valueThere };
      };
      const auto alone = numbersOf(one, 0, value);
      const auto among = numbersOf(all, i, values[i]);
      EXPECT_EQ(std::memcmp(alone.data(), among.data(), sizeof(alone)), 0);
    }
  }
}

TEST_P(ReadingOfShells, MarksWhatIsSolid)
{
  TestVolume volume(this->GetParam(), { 12, 12, 12 });
  volume.FillRandom(6);
  const std::vector<Vector3> places = MakePlaces(11.0);
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
  for (const Vector3& at : places)
  {
    x.push_back(at.X);
    y.push_back(at.Y);
    z.push_back(at.Z);
  }
  const double level = volume(6, 6, 6);
  for (const bool isBelow : { false, true })
  {
    const ShellReader reader(volume.View, level, isBelow);
    const double same[12] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      // The reader processes four points at a time, and then the remaining points one by one.
      const std::size_t first = i - i % 10;
      const std::uint64_t marks =
        reader.Mark({ x.data() + first, y.data() + first, z.data() + first, 10 }, same);
      const bool isMarked = (marks >> i % 10 & 1) != 0;
      const Vector3& at = places[i];
      const bool isInside =
        std::min(std::min(at.X, at.Y), at.Z) >= 0.0 && std::max(std::max(at.X, at.Y), at.Z) <= 11.0;
      const double value = Naive(volume, at);
      if (std::abs(value - level) > 1e-12 * std::abs(level))
      {
        EXPECT_EQ(isMarked, isInside && (value > level) != isBelow);
      }
    }
  }
}

/// A box counts as clear only if none of its cells has a solid sample.
TEST_P(ReadingOfShells, FindsOutWhatCannotBeSolid)
{
  TestVolume volume(this->GetParam(), { 12, 12, 12 });
  volume.FillRandom(8);
  // Use a level that few samples exceed.
  std::vector<double> samples;
  for (std::int64_t i = 0; i < 1728; ++i)
  {
    samples.push_back(volume(i % 12, i / 12 % 12, i / 144));
  }
  std::sort(samples.begin(), samples.end());
  const double level = samples[1700];
  const ShellReader reader(volume.View, level, false);
  const Vector3 half{ 0.7, 1.3, 1.0 };
  int clear = 0;
  for (const Vector3& at : MakePlaces(11.0))
  {
    bool isAny = false;
    const auto cells = [](double middle, double size, const auto& visit)
    {
      for (double i = std::floor(middle - size); i <= std::floor(middle + size) + 1.0; i += 1.0)
      {
        visit(static_cast<std::int64_t>(std::clamp(i, 0.0, 11.0)));
      }
    };
    cells(at.X, half.X,
      [&](std::int64_t i)
      {
        cells(at.Y, half.Y,
          [&](std::int64_t j) {
            cells(at.Z, half.Z, [&](std::int64_t k) { isAny = isAny || volume(i, j, k) >= level; });
          });
      });
    EXPECT_EQ(reader.MayBeSolid(at, half), isAny);
    clear += isAny ? 0 : 1;
  }
  EXPECT_GT(clear, 100);
  EXPECT_TRUE(reader.MayBeSolid({ 6.0, 6.0, 6.0 }, { 1e9, 1.0, 1.0 })) << "too many samples";
}

/// Compare sums of forces with their definition, for a number of points that is not a multiple of
/// four.
TEST(ShellSums, AreThoseOfTheDefinition)
{
  std::mt19937_64 engine(2);
  ShellPushes forces{};
  forces.Count = 57;
  double gradient[6] = {};
  double curvature[6][6] = {};
  for (std::size_t i = 0; i < forces.Count; ++i)
  {
    const Vector3 n = RandomIn(engine, 1.0);
    const Vector3 arm = RandomIn(engine, 1.0);
    const Vector3 turn = Cross(arm, n);
    const double w[6] = { n.X, n.Y, n.Z, turn.X, turn.Y, turn.Z };
    const Vector3 strength = RandomIn(engine, 1.0);
    for (int a = 0; a < 6; ++a)
    {
      forces.Wrench[a][i] = w[a];
    }
    forces.Force[i] = strength.X;
    forces.Stiffness[i] = strength.Y;
    for (int row = 0; row < 6; ++row)
    {
      gradient[row] += strength.X * w[row];
      for (int column = 0; column < 6; ++column)
      {
        curvature[row][column] += strength.Y * w[row] * w[column];
      }
    }
  }
  const TestVolume volume = MakeRamp(4);
  double sums[6] = {};
  double triangle[21] = {};
  ShellReader(volume.View, 0.0, false).Add(forces, sums, triangle);
  const double* next = triangle;
  for (int row = 0; row < 6; ++row)
  {
    EXPECT_NEAR(sums[row], gradient[row], 1e-13);
    for (int column = 0; column <= row; ++column)
    {
      EXPECT_NEAR(*next++, curvature[row][column], 1e-13);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReadingOfShells, testing::ValuesIn(AllScalarTypes));
