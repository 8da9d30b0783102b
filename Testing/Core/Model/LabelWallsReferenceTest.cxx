// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares walls between labels with a slow reference, in random volumes.
 *
 * The reference is written from the equations of LabelWalls.h and GradientKernel.h and shares no
 * code with the module. It computes the window at each tap with exp(), sums the fraction of each
 * label in a map, voxel by voxel, and computes the slopes of the weights by central differences.
 */

#include "Core/Law/MaterialLaw.h"
#include "Core/Model/LabelWalls.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

using namespace coretest;

namespace
{
using Index = std::array<std::int64_t, 3>;
using Entries = std::map<std::int64_t, LabelledMaterial>;

/// Sort key of labels from soft to hard: first labels that are not felt, then labels without an
/// entry, then labels with an entry; among these, by surface strength T_N, stiffness k and label.
using Hardness = std::tuple<int, double, double, std::int64_t>;

Hardness HardnessOf(const Entries& entries, std::int64_t label)
{
  const auto entry = entries.find(label);
  if (entry == entries.end())
  {
    return { 1, 0.0, 0.0, label };
  }
  const LabelMaterial& material = entry->second.Material;
  const auto value = [&](int c) { return material.IsSet[c] ? material.Value[c] : -1.0; };
  return material.IsFelt ? Hardness{ 2, value(2), value(0), label } : Hardness{ 0, 0.0, 0.0, 0 };
}

/// Returns the smoothing weights of a Gaussian that is lowered so that it ends at c, with a slope
/// of zero there.
std::vector<double> Weights(int radius, double fraction)
{
  const double c = radius + 1.0;
  const double s = 0.55 * c;
  const double end = c * c / (2.0 * s * s);
  std::vector<double> w;
  double sum = 0.0;
  double mean = 0.0;
  for (int i = 0; i < 2 * (radius + 1); ++i)
  {
    const double t = i - radius - fraction;
    const double u = t * t / (2.0 * s * s);
    w.push_back(u < end ? std::exp(-u) - std::exp(-end) * (1.0 + end - u) : 0.0);
    sum += w.back();
    mean += w.back() * t;
  }
  mean /= sum;
  double variance = 0.0;
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    const double t = double(i) - radius - fraction - mean;
    variance += w[i] * t * t;
  }
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    const double t = double(i) - radius - fraction - mean;
    w[i] = w[i] / sum - mean * w[i] * t / variance;
  }
  return w;
}

struct Axis
{
  std::int64_t First;
  std::vector<double> Value;
  std::vector<double> Slope;
};

Axis AxisAt(int radius, double x)
{
  const double cell = std::floor(x);
  constexpr double h = 1e-6;
  Axis axis{ static_cast<std::int64_t>(cell) - radius, Weights(radius, x - cell), {} };
  const std::vector<double> ahead = Weights(radius, x - cell + h);
  const std::vector<double> behind = Weights(radius, x - cell - h);
  for (std::size_t i = 0; i < ahead.size(); ++i)
  {
    axis.Slope.push_back((ahead[i] - behind[i]) / (2.0 * h));
  }
  return axis;
}

struct ReferenceWall
{
  bool IsThere = false;
  double Value = 2.0;
  Vector3 Gradient;
  double SecondValue = 2.0; ///< absolute value of the second nearest wall
};

ReferenceWall ComputeReference(
  const TestVolume& volume, const Entries& entries, int radius, const Vector3& x)
{
  struct Part
  {
    double Fraction = 0.0;
    Vector3 Gradient;
  };
  std::map<Hardness, Part, std::greater<>> parts;
  const Axis axes[3] = { AxisAt(radius, x.X), AxisAt(radius, x.Y), AxisAt(radius, x.Z) };
  const int taps = 2 * (radius + 1);
  for (int k = 0; k < taps; ++k)
  {
    for (int j = 0; j < taps; ++j)
    {
      for (int i = 0; i < taps; ++i)
      {
        const auto label = static_cast<std::int64_t>(
          volume(axes[0].First + i, axes[1].First + j, axes[2].First + k));
        Part& part = parts[HardnessOf(entries, label)];
        const double w[3] = { axes[0].Value[i], axes[1].Value[j], axes[2].Value[k] };
        part.Fraction += w[0] * w[1] * w[2];
        part.Gradient += { axes[0].Slope[i] * w[1] * w[2], w[0] * axes[1].Slope[j] * w[2],
          w[0] * w[1] * axes[2].Slope[k] };
      }
    }
  }
  ReferenceWall wall;
  double share = 0.0;
  Vector3 gradient;
  std::size_t count = 0;
  for (const auto& [hardness, part] : parts)
  {
    if (++count == parts.size())
    {
      break;
    }
    share += part.Fraction;
    gradient += part.Gradient;
    const double value = 2.0 * share - 1.0;
    if (std::abs(value) < std::abs(wall.Value))
    {
      wall = { true, value, 2.0 * gradient, std::abs(wall.Value) };
    }
    else
    {
      wall.SecondValue = std::min(wall.SecondValue, std::abs(value));
    }
  }
  return wall;
}

class Draw
{
public:
  explicit Draw(unsigned seed)
    : Engine(seed)
  {
  }

  double Between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine() >> 11) * 0x1p-53;
  }
  std::int64_t Below(std::int64_t count)
  {
    return static_cast<std::int64_t>(this->Engine() % static_cast<std::uint64_t>(count));
  }

private:
  std::mt19937_64 Engine;
};

/// Returns a position anywhere in an image, including voxels, faces, edges and corners.
Vector3 DrawPosition(Draw& draw, const Index& size)
{
  double x[3];
  for (int a = 0; a < 3; ++a)
  {
    const auto last = static_cast<double>(size[a] - 1);
    const double free = draw.Between(0.0, last);
    const std::int64_t dice = draw.Below(8);
    x[a] = dice == 0 ? std::round(free) : dice == 1 ? 0.0 : dice == 2 ? last : free;
  }
  return { x[0], x[1], x[2] };
}

LabelTable MakeTable(const Entries& entries)
{
  std::vector<LabelledMaterial> list;
  list.reserve(entries.size());
  for (const auto& entry : entries)
  {
    list.push_back(entry.second);
  }
  return LabelTable(list);
}

LabelledMaterial Entry(std::int64_t label, Draw& draw)
{
  LabelledMaterial entry;
  entry.Label = label;
  // Draw from few values, so that some labels differ in only one value, or in none.
  entry.Material.Value = { 100.0 * double(draw.Below(3)), 0.0, 0.5 * double(draw.Below(3)), 0.0 };
  entry.Material.IsSet = { draw.Below(4) > 0, false, draw.Below(4) > 0, false };
  entry.Material.IsFelt = draw.Below(5) > 0;
  return entry;
}

/// Compares LabelWalls with the reference at random positions. Returns the number of positions with
/// a wall.
int Compare(
  const TestVolume& volume, const Entries& entries, int radius, int positions, unsigned seed)
{
  const LabelView view(volume.View);
  const LabelTable table = MakeTable(entries);
  const LabelWalls walls(view, table, radius);
  const std::int64_t* const n = volume.View.Dimensions;
  Draw draw(seed);
  int there = 0;
  for (int i = 0; i < positions; ++i)
  {
    const Vector3 x = DrawPosition(draw, { n[0], n[1], n[2] });
    const ReferenceWall expected = ComputeReference(volume, entries, radius, x);
    const LabelWall wall = walls.Compute(x);
    SCOPED_TRACE(testing::Message() << "at " << x.X << " " << x.Y << " " << x.Z);
    EXPECT_EQ(wall.IsThere, expected.IsThere);
    if (!wall.IsThere || !expected.IsThere)
    {
      continue;
    }
    ++there;
    EXPECT_NEAR(std::abs(wall.Value), std::abs(expected.Value), 1e-8);
    // If two walls are equally near, either may be found.
    if (expected.SecondValue - std::abs(expected.Value) > 1e-7)
    {
      EXPECT_NEAR(wall.Value, expected.Value, 1e-8);
      EXPECT_LT(Norm(wall.Gradient - expected.Gradient), 1e-6);
    }
  }
  return there;
}

/// Returns cubes of a few voxels with random labels from a list.
TestVolume MakeCubes(ScalarType type, const Index& size, std::int64_t step, std::int64_t cube,
  const std::function<std::int64_t(std::int64_t)>& label)
{
  TestVolume volume(type, size, step);
  WithSampleType(type,
    [&](auto t)
    {
      volume.Fill<decltype(t)>([&](std::int64_t i, std::int64_t j, std::int64_t k)
        { return label((i / cube) + 1000 * (j / cube) + 1000000 * (k / cube)); });
    });
  return volume;
}

std::int64_t Mix(std::int64_t x)
{
  return static_cast<std::int64_t>((static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U) >> 33);
}

bool IsSigned(ScalarType type)
{
  return WithSampleType(type, [](auto t) { return std::is_signed_v<decltype(t)>; });
}
} // namespace

TEST(LabelWallsReference, AgreesForEveryTypeAndLayout)
{
  constexpr Index size{ 15, 14, 13 };
  unsigned seed = 0;
  for (const ScalarType type : AllScalarTypes)
  {
    for (const std::int64_t step : { 1, 3 })
    {
      for (const std::int64_t labels : { 2, 3, 9 })
      {
        ++seed;
        SCOPED_TRACE(testing::Message()
          << "type " << static_cast<int>(type) << " step " << step << " labels " << labels);
        // Include negative labels, if the type has them.
        const std::int64_t least = IsSigned(type) ? -(labels / 2) : 0;
        const TestVolume volume = MakeCubes(type, size, step, 4,
          [&](std::int64_t cube) { return least + Mix(cube + seed) % labels; });
        Draw draw(seed);
        Entries entries;
        for (std::int64_t label = least; label < least + labels; ++label)
        {
          if (draw.Below(3) > 0)
          {
            entries[label] = Entry(label, draw);
          }
        }
        Compare(volume, entries, 3, 60, seed);
        EXPECT_GT(Compare(volume, {}, 3, 60, seed), 20);
      }
    }
  }
}

TEST(LabelWallsReference, AgreesForOtherRadii)
{
  for (const int radius : { 2, 4, 7 })
  {
    SCOPED_TRACE(radius);
    const TestVolume volume = MakeCubes(
      ScalarType::Int16, { 17, 16, 18 }, 1, 5, [](std::int64_t cube) { return Mix(cube) % 4 - 2; });
    EXPECT_GT(Compare(volume, {}, radius, 80, 5), 40);
  }
}

TEST(LabelWallsReference, AgreesInNoise)
{
  // Labels that change from voxel to voxel: 2 labels, and 30 labels, most of which one evaluation
  // meets.
  for (const std::int64_t labels : { 2, 30 })
  {
    SCOPED_TRACE(labels);
    const TestVolume volume = MakeCubes(ScalarType::UInt8, { 20, 20, 20 }, 1, 1,
      [labels](std::int64_t cube) { return Mix(cube) % labels; });
    EXPECT_EQ(Compare(volume, {}, 3, 300, 11), 300);
  }
}

TEST(LabelWallsReference, AgreesInImagesThatAreSmallerThanTheKernel)
{
  for (const Index& size :
    { Index{ 5, 9, 1 }, Index{ 1, 1, 6 }, Index{ 8, 8, 8 }, Index{ 3, 20, 7 } })
  {
    SCOPED_TRACE(testing::Message() << size[0] << " " << size[1] << " " << size[2]);
    const TestVolume volume = MakeCubes(ScalarType::Int32, size, 1, 2,
      [](std::int64_t cube) { return Mix(cube) % 2 == 0 ? -7 : 70000; });
    EXPECT_GT(Compare(volume, {}, 3, 100, 13), 20);
  }
}

TEST(LabelWallsReference, AgreesWithAMillionLabelsInTheTable)
{
  constexpr std::int64_t count = 1000000;
  Draw draw(17);
  Entries entries;
  for (std::int64_t label = -count / 2; label < count / 2; ++label)
  {
    entries.emplace_hint(entries.end(), label, Entry(label, draw));
  }
  // One evaluation meets at most 27 of these labels.
  const TestVolume volume = MakeCubes(ScalarType::Int32, { 40, 40, 40 }, 1, 4,
    [](std::int64_t cube) { return Mix(cube) % count - count / 2; });
  EXPECT_GT(Compare(volume, entries, 3, 200, 19), 190);
}

TEST(LabelWallsReference, MemoryOfTheLastLookChangesNothing)
{
  // Walk in small steps, and alternate between two images that share one memory.
  const auto make = [](std::int64_t labels)
  {
    return MakeCubes(ScalarType::UInt8, { 30, 30, 30 }, 1, 15,
      [labels](std::int64_t cube) { return Mix(cube) % labels; });
  };
  const TestVolume volumes[2] = { make(2), make(4) };
  const LabelView views[2] = { LabelView(volumes[0].View), LabelView(volumes[1].View) };
  const LabelTable table;
  const LabelWalls first(views[0], table, 3);
  const LabelWalls second(views[1], table, 3);
  Draw draw(29);
  WallMemory memory;
  Vector3 x{ 15, 15, 15 };
  int there = 0;
  for (int i = 0; i < 20000; ++i)
  {
    x += { draw.Between(-0.3, 0.3), draw.Between(-0.3, 0.3), draw.Between(-0.3, 0.3) };
    x = Least(Most(x, { 0, 0, 0 }), { 29, 29, 29 });
    const LabelWalls& walls = i / 50 % 2 == 0 ? first : second;
    const LabelWall fresh = walls.Compute(x);
    const LabelWall remembered = walls.Compute(x, memory);
    ASSERT_EQ(fresh.IsThere, remembered.IsThere);
    ASSERT_EQ(fresh.Value, remembered.Value);
    ASSERT_EQ(Norm(fresh.Gradient - remembered.Gradient), 0.0);
    there += fresh.IsThere ? 1 : 0;
  }
  EXPECT_GT(there, 5000);
  EXPECT_LT(there, 20000) << "some looks meet one label";
}

TEST(LabelWallsReference, AgreesWithTheSurfaceOfAnAnisotropicLabelImage)
{
  // A solver receives the wall along the device's axes, so the gradient is divided by the spacing.
  const Vector3 spacing{ 0.6, 1.0, 2.5 };
  const TestVolume scalars = MakeRamp(40);
  const TestVolume volume = MakeCubes(
    ScalarType::UInt16, { 50, 36, 14 }, 1, 6, [](std::int64_t cube) { return Mix(cube) % 3; });
  HapticModelDescription description = Describe(scalars);
  auto labels = std::make_shared<BakedLabels>();
  labels->View = LabelView(volume.View);
  labels->IndexToWorld.Linear = { { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 },
    { 0, 0, spacing.Z } } };
  labels->IndexToWorld.Offset = { 3.0, 1.5, 2.0 };
  description.Labels = labels;
  description.Settings.Geometry = SurfaceGeometry::Labels;
  const HapticModel model(description);
  Draw draw(23);
  int compared = 0;
  LabelMemory memory;
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 x{ draw.Between(5, 45), draw.Between(5, 30), draw.Between(2, 11) };
    const ReferenceWall expected = ComputeReference(volume, {}, 3, x);
    if (!expected.IsThere || expected.SecondValue - std::abs(expected.Value) < 1e-7 ||
      Norm(expected.Gradient) < 1e-3)
    {
      continue;
    }
    ++compared;
    const Vector3 world{ 3.0 + spacing.X * x.X, 1.5 + spacing.Y * x.Y, 2.0 + spacing.Z * x.Z };
    const Surface surface = Law::ComputeSurface(model, model.Baked->At(0.0), world, memory);
    const Vector3 gradient{ expected.Gradient.X / spacing.X, expected.Gradient.Y / spacing.Y,
      expected.Gradient.Z / spacing.Z };
    ASSERT_TRUE(surface.IsWall);
    EXPECT_NEAR(surface.Value, expected.Value, 1e-8);
    EXPECT_NEAR(surface.GradientMagnitude, Norm(gradient), 1e-6);
    EXPECT_LT(Norm(surface.Normal - (1.0 / Norm(gradient)) * gradient), 1e-4);
    // The reach is the kernel radius of 2 voxels. It is measured along the normal in the image with
    // the larger voxels.
    const Vector3 n = surface.Normal;
    const double voxels =
      std::min(1.0, Norm({ n.X / spacing.X, n.Y / spacing.Y, n.Z / spacing.Z }));
    EXPECT_LT(Norm(surface.Reach - (2.0 / voxels) * n), 1e-9);
  }
  EXPECT_GT(compared, 100);
}
