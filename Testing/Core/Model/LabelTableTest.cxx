// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the table of labels finds exactly the labels that were put into it, by comparison
 * with std::map.
 */

#include "Core/Model/BakedLabels.h"
#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace coretest;

namespace
{
LabelledMaterial Stiff(std::int64_t label, double stiffness)
{
  LabelledMaterial entry;
  entry.Label = label;
  entry.Material.Value[0] = stiffness;
  entry.Material.IsSet[0] = true;
  return entry;
}
} // namespace

TEST(LabelTable, FindsNothingWithoutEntries)
{
  EXPECT_EQ(LabelTable().Find(0), nullptr);
  EXPECT_EQ(LabelTable(std::vector<LabelledMaterial>()).Find(NoLabel), nullptr);
}

TEST(LabelTable, FindsAMillionLabelsOfAllSignsAndSizes)
{
  std::mt19937_64 engine(5);
  std::map<std::int64_t, double> model;
  // Consecutive labels, as in segmentations; multiples of a power of two, which collide in a poor
  // hash table; and random labels.
  for (std::int64_t i = 0; i < 400000; ++i)
  {
    model[i - 200000] = static_cast<double>(i);
    model[(i + 1) << 40] = static_cast<double>(-i);
  }
  for (int i = 0; i < 200000; ++i)
  {
    model[static_cast<std::int64_t>(engine())] = 0.5 + i;
  }
  model[std::numeric_limits<std::int64_t>::max()] = 7.0;
  std::vector<LabelledMaterial> entries;
  for (const auto& [label, stiffness] : model)
  {
    entries.push_back(Stiff(label, stiffness));
  }
  const LabelTable table(entries);
  for (const auto& [label, stiffness] : model)
  {
    const LabelMaterial* const found = table.Find(label);
    ASSERT_NE(found, nullptr) << label;
    ASSERT_EQ(found->Value[0], stiffness) << label;
  }
  for (int i = 0; i < 200000; ++i)
  {
    const auto label = static_cast<std::int64_t>(engine());
    ASSERT_EQ(table.Find(label) != nullptr, model.count(label) > 0) << label;
  }
}

TEST(LabelTable, MixesByFractionsAndLeavesTheRestToTheFunctions)
{
  TestVolume volume(ScalarType::Int32, { 3, 2, 2 });
  volume.Fill<std::int32_t>(
    [](std::int64_t i, std::int64_t, std::int64_t) { return 10 * static_cast<int>(i); });
  LabelledMaterial soft = Stiff(10, 200.0);
  soft.Material.Value[2] = 1.0;
  soft.Material.IsSet[2] = true;
  LabelledMaterial numb = Stiff(20, 900.0);
  numb.Material.IsFelt = false;
  BakedLabels labels;
  labels.View = LabelView(volume.View);
  labels.Table = LabelTable({ soft, numb });
  const MaterialTable::Values functions{ 500.0, 0.3, 2.0, 0.7, 1.0 };
  const auto mixed = [&](double x)
  {
    MaterialTable::Values values = functions;
    MixMemory memory;
    labels.Mix({ x, 0.5, 0.5 }, 1, memory, values);
    return values;
  };
  // Label 0 has no entry, label 10 sets the stiffness k and the surface strength T_N, and label 20
  // is not felt.
  EXPECT_EQ(mixed(0.0), functions);
  EXPECT_EQ(mixed(1.0), (MaterialTable::Values{ 200.0, 0.3, 1.0, 0.7, 1.0 }));
  EXPECT_EQ(mixed(2.0), (MaterialTable::Values{ 900.0, 0.3, 0.0, 0.0, 1.0 }));
  EXPECT_EQ(mixed(5.0), functions) << "beyond the image";
  const MaterialTable::Values quarter = mixed(0.25);
  const MaterialTable::Values half = mixed(1.5);
  const double expectedQuarter[] = { 425.0, 0.3, 1.75, 0.7, 1.0 };
  const double expectedHalf[] = { 550.0, 0.3, 0.5, 0.35, 1.0 };
  for (int c = 0; c < 5; ++c)
  {
    EXPECT_NEAR(quarter[c], expectedQuarter[c], 1e-12) << c;
    EXPECT_NEAR(half[c], expectedHalf[c], 1e-12) << c;
  }
}

TEST(LabelTable, RemembersACellOnlyIfItIsStillTheSame)
{
  // Two label images, each with its own label table. Blocks of 3^3 voxels have one label.
  constexpr std::int64_t side = 12;
  std::vector<TestVolume> volumes;
  std::vector<BakedLabels> labels(2);
  for (int image = 0; image < 2; ++image)
  {
    volumes.emplace_back(ScalarType::Int16, std::array<std::int64_t, 3>{ side, side, side });
    volumes.back().Fill<std::int16_t>([image](std::int64_t i, std::int64_t j, std::int64_t k)
      { return static_cast<int>((i / 3 + 2 * (j / 3) + 3 * (k / 3) + image) % 4); });
    labels[image].View = LabelView(volumes.back().View);
    labels[image].Table = LabelTable({ Stiff(1, 100.0 + image), Stiff(3, 300.0 + image) });
  }
  const MaterialTable::Values functions{ 500.0, 0.3, 2.0, 0.7, 1.0 };
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> step(-0.4, 0.4);
  std::uniform_int_distribution<int> dice(0, 99);
  Vector3 at{ 1.2, 4.7, 8.1 };
  int image = 0;
  MixMemory memory;
  int known = 0;
  for (int i = 0; i < 100000; ++i)
  {
    at += { step(engine), step(engine), step(engine) };
    double* const axes[] = { &at.X, &at.Y, &at.Z };
    for (double* const axis : axes)
    {
      // Reverse the walk at two voxels beyond the image. Sometimes round the position to a voxel.
      *axis = *axis < -2.0 ? -1.0 : *axis > side + 1.0 ? side - 1.0 : *axis;
      *axis = dice(engine) == 0 ? std::round(*axis) : *axis;
    }
    image = dice(engine) == 0 ? 1 - image : image;
    const auto number = static_cast<std::uint64_t>(image + 1);
    known += memory.Knows(number, at) ? 1 : 0;
    MaterialTable::Values values = functions;
    labels[image].Mix(at, number, memory, values);
    MixMemory none;
    MaterialTable::Values anew = functions;
    labels[image].Mix(at, number, none, anew);
    ASSERT_EQ(values, anew) << at.X << ' ' << at.Y << ' ' << at.Z;
  }
  EXPECT_GT(known, 1000);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(memory.Knows(memory.Baked, { nan, nan, nan }));
}
