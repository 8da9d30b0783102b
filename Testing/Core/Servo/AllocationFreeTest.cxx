// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that ticks never allocate memory.
 */

#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "Core/Tools/Needle/BakedNeedle.h"
#include "Rigs/AllocationCounter.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <tuple>

using namespace coretest;

namespace
{
class AllocationFree
  : public testing::TestWithParam<
      std::tuple<HapticMethod, GradientEstimator, int, MaterialPlacement>>
{
};

/// Returns material functions with many break points, so that all branches of the tables are used.
HapticMaterial RichMaterial()
{
  HapticMaterial material;
  material.Stiffness = { { 50.0, 0.0 }, { 50.0, 80.0 }, { 400.0, 600.0 }, { 1200.0, 900.0 } };
  material.Friction = { { 0.0, 0.0 }, { 1500.0, 0.8 } };
  material.SurfaceStrength = { { 200.0, 0.5 }, { 900.0, 2.0 }, { 900.0, 1e6 } };
  material.Viscosity = { { 100.0, 0.5 }, { 700.0, 0.0 } };
  material.Distinctness = { { 10.0, 0.0 }, { 80.0, 1.0 } };
  for (int i = 0; i < 500; ++i)
  {
    material.ScalarVisibility.push_back({ 500.0 + 1e-3 * i, i % 2 ? 1.0 : 0.0 });
  }
  return material;
}
} // namespace

TEST_P(AllocationFree, NoTickAllocates)
{
  const auto [method, estimator, radius, placement] = this->GetParam();
  TestVolume volume(ScalarType::Float32, { 20, 20, 20 });
  std::mt19937_64 engine(3);
  volume.Fill<float>(
    [&](std::int64_t, std::int64_t, std::int64_t k)
    {
      const auto dice = engine() % 1000;
      return dice == 0 ? std::numeric_limits<float>::quiet_NaN() : 70.0F * k + 0.1F * dice;
    });
  HapticModelDescription description = Describe(volume);
  description.Estimator = estimator;
  description.KernelRadius = radius;
  description.Material = RichMaterial();
  description.Settings.Method = method;
  description.Settings.Placement = placement;
  description.Settings.Side = SurfaceSide::Both;
  description.Settings.MaximumForce = 3.0;
  description.Settings.ForceFieldGain = 0.01;
  description.Settings.IsoValue = 700.0;
  description.Settings.LocalShape = LocalSurfaceShape::Quadric;
  description.Settings.ForceFieldDamping = 1.0;
  const HapticModel model(description);
  Wanderer wanderer(20.0);
  ServoState state;
  TickRecord record;
  const int ticks = radius > 4 ? 5000 : 100000;
  int contacts[4] = {};
  double work = 0.0;
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < ticks; ++i)
  {
    Vector3 tip = wanderer.Next();
    tip.X = i % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : tip.X;
    Tick(model, state, tip, record);
    ++contacts[static_cast<int>(record.Contact)];
    work += Norm(record.Force);
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  // Only a fit with a kernel of more than 4 voxels may produce no force: the kernel covers the
  // whole volume, meets a NaN everywhere, and finds no surface.
  EXPECT_TRUE(work > 0.0 || (method == HapticMethod::LocalSurface && radius > 4));
  for (int contact = 0; contact < 4 && method == HapticMethod::Proxy && radius <= 4; ++contact)
  {
    EXPECT_GT(contacts[contact], 0) << "the walk never met contact state " << contact;
  }
}

INSTANTIATE_TEST_SUITE_P(All, AllocationFree,
  testing::Combine(
    testing::Values(HapticMethod::Proxy, HapticMethod::ForceField, HapticMethod::LocalSurface),
    testing::ValuesIn(AllEstimators), testing::Values(1, 2, 3, 4, 9),
    testing::Values(MaterialPlacement::Kernel)));
INSTANTIATE_TEST_SUITE_P(FarSide, AllocationFree,
  testing::Combine(testing::Values(HapticMethod::Proxy), testing::ValuesIn(AllEstimators),
    testing::Values(1, 2, 9), testing::Values(MaterialPlacement::FarSide)));

namespace
{
/// Returns blocks of 4^3 voxels with the labels -2 to 2. All labels except 0 have a material. With
/// `isForbidden`, label -1 is forbidden.
std::shared_ptr<const BakedLabels> MakeLabels(const TestVolume& volume, bool isForbidden)
{
  auto labels = std::make_shared<BakedLabels>();
  labels->View = LabelView(volume.View);
  labels->IndexToWorld.Linear = 0.7 * Matrix3{};
  std::vector<LabelledMaterial> entries(4);
  for (int i = 0; i < 4; ++i)
  {
    entries[i].Label = i < 2 ? i - 2 : i - 1;
    entries[i].Material.Value = { 300.0 + 100.0 * i, 0.2, 0.5 + 0.5 * i, 0.1 };
    entries[i].Material.IsSet.fill(true);
    entries[i].Material.IsFelt = i != 3;
    entries[i].Material.IsForbidden = isForbidden && i == 1;
  }
  labels->Table = LabelTable(entries);
  constexpr double standOff = 0.5; // world units
  labels->Zone = ForbiddenZone::Make(labels->View, labels->Table, labels->IndexToWorld, standOff);
  return labels;
}

class AllocationFreeLabels
  : public testing::TestWithParam<std::tuple<HapticSolver, SurfaceGeometry, bool>>
{
};
} // namespace

TEST_P(AllocationFreeLabels, NoTickAllocates)
{
  const auto [solver, geometry, isForbidden] = this->GetParam();
  const TestVolume volume = MakeRamp(20);
  TestVolume labels(ScalarType::Int16, { 24, 24, 24 });
  labels.Fill<std::int16_t>([](std::int64_t i, std::int64_t j, std::int64_t k)
    { return (i / 4 + 2 * (j / 4) + 3 * (k / 4)) % 5 - 2; });
  HapticModelDescription description = Describe(volume);
  description.Labels = MakeLabels(labels, isForbidden);
  description.Settings.Solver = solver;
  description.Settings.Geometry = geometry;
  const HapticModel model(description);
  ASSERT_EQ(model.Baked->GetZone() != nullptr, isForbidden);
  Wanderer wanderer(20.0);
  ServoState state;
  TickRecord record;
  int held = 0;
  int near = 0;
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < 50000; ++i)
  {
    Tick(model, state, wanderer.Next(), record);
    held += record.NormalForce > 0.0 ? 1 : 0;
    near += isForbidden && model.Baked->GetZone()->Compute(model.DeviceToLabel(record.Proxy)).IsNear
      ? 1
      : 0;
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  EXPECT_GT(held, 0) << "no surface was met";
  EXPECT_EQ(near > 0, isForbidden) << "whether a forbidden label was met";
}

INSTANTIATE_TEST_SUITE_P(All, AllocationFreeLabels,
  testing::Combine(testing::Values(HapticSolver::Paper, HapticSolver::Precise),
    testing::Values(SurfaceGeometry::Scalars, SurfaceGeometry::Labels, SurfaceGeometry::Both),
    testing::Bool()));

/// The needle is pushed in and out, turned and pushed aside, through more tissues than its track
/// can store.
TEST(AllocationFreeNeedle, NoTickAllocates)
{
  const TestVolume volume = MakeRamp(40);
  TestVolume samples(ScalarType::Int16, { 58, 58, 58 });
  samples.Fill<std::int16_t>([](std::int64_t i, std::int64_t j, std::int64_t k)
    { return (i / 4 + 2 * (j / 4) + 3 * k) % 5 - 2; });
  for (const bool hasLabels : { false, true })
  {
    HapticModelDescription description = Describe(volume);
    description.Material.SurfaceStrength = ConstantPolyline(0.2);
    description.Material.Viscosity = { { 500.0, 0.0 }, { 600.0, 0.1 } };
    NeedleDescription needle;
    needle.ShaftFriction = { { 0.0, 5.0 }, { 4000.0, 60.0 } };
    description.Tool = std::make_shared<const BakedNeedle>(needle);
    description.Labels = hasLabels ? MakeLabels(samples, false) : nullptr;
    const HapticModel model(description);
    ServoState state;
    TickRecord record;
    int inserted = 0;
    int most = 0;
    const std::size_t before = CountAllocations().Calls;
    for (int i = 0; i < 50000; ++i)
    {
      const double turn = 1e-4 * i;
      state.HasOrientation = i % 20000 < 10000;
      state.Orientation = { std::sin(turn / 50.0), std::cos(turn / 50.0), 0.0, 0.0 };
      const double depth = 0.018 - 0.024 * std::cos(3.0 * turn);
      Tick(model, state, { 0.02 + 0.002 * std::sin(7.0 * turn), 0.02, depth }, record);
      inserted += record.Depth > 0.0 ? 1 : 0;
      most = std::max(most, state.Needle.Track.GetSize());
    }
    EXPECT_EQ(CountAllocations().Calls, before);
    EXPECT_GT(inserted, 5000);
    EXPECT_GT(most, 10);
  }
}

TEST(AllocationFreeModes, NoTickAllocates)
{
  // The vectors are random, so that the primitives are oblique and differ from voxel to voxel.
  TestVolume samples(ScalarType::Float32, { 60, 20, 20 });
  samples.FillRandom(7);
  ModeDescription mode;
  mode.View.Volume = samples.View;
  mode.View.Volume.Dimensions[0] = 20;
  mode.View.Volume.Stride[0] = 3;
  mode.Guide = std::make_shared<const GuidePath>(
    std::vector<GuidePath::Line>{ { { 2, 2, 2 }, { 15, 9, 4 }, { 8, 18, 12 } } }, 1.0);
  // A tent-shaped mesh and an isosurface, which together fill the volume.
  const std::vector<Vector3> corners{ { 0, 0, 5 }, { 20, 0, 5 }, { 20, 20, 5 }, { 0, 20, 5 },
    { 10, 10, 12 } };
  const std::vector<SurfaceMesh::Indices> faces{ { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
    { 3, 0, 4 } };
  const auto tent = std::make_shared<const SurfaceMesh>(corners, faces, std::vector<Vector3>());
  const auto mesh =
    std::make_shared<const GuideSurface>(std::make_shared<const GuideMesh>(tent, 0.5), 1.0);
  const auto field =
    std::make_shared<const GuideSurface>(mode.View.Volume, nullptr, Affine3{}, 0.0);
  mode.GuideSurface = mesh;
  using Kinds = std::vector<ModeKind>;
  for (const Kinds& kinds :
    { Kinds{ ModeKind::VectorFollow, ModeKind::VortexTube, ModeKind::Ridge, ModeKind::Guide },
      Kinds{ ModeKind::TwoSidedFront, ModeKind::VectorFront, ModeKind::Shear, ModeKind::Surface },
      Kinds{ ModeKind::GuideSurface, ModeKind::GuideSurface, ModeKind::VectorFollow } })
  {
    HapticModelDescription d;
    d.View = mode.View.Volume;
    d.DeviceToWorld = { 1000.0 * Matrix3{}, {} };
    d.Settings.Method = HapticMethod::Primitives;
    for (const ModeKind kind : kinds)
    {
      mode.Kind = kind;
      d.Modes.push_back(mode);
      mode.GuideSurface = mode.GuideSurface == mesh ? field : mesh;
    }
    const HapticModel model(d);
    Wanderer wanderer(20.0);
    ServoState state;
    TickRecord record;
    std::vector<double> work(kinds.size());
    const std::size_t before = CountAllocations().Calls;
    for (int i = 0; i < 6000; ++i)
    {
      Tick(model, state, wanderer.Next(), record);
      const ModeForces forces = ComputeModeForces(model, state);
      for (std::size_t at = 0; at < work.size(); ++at)
      {
        work[at] += Norm(forces[at]);
      }
    }
    EXPECT_EQ(CountAllocations().Calls, before);
    for (std::size_t at = 0; at < work.size(); ++at)
    {
      EXPECT_GT(work[at], 0.0) << "mode " << at << " of kind " << int(kinds[at]);
    }
  }
}

// Tests the allocation counter: if it counted nothing, the tests above would pass.
TEST(AllocationCounter, SeesNew)
{
  const std::size_t before = CountAllocations().Calls;
  void* const plain = ::operator new(80);
  void* const aligned = ::operator new (64, std::align_val_t{ 64 });
  EXPECT_EQ(CountAllocations().Calls, before + 2);
  EXPECT_GE(CountAllocations().LiveBytes, 144U);
  ::operator delete (aligned, std::align_val_t{ 64 });
  ::operator delete(plain);
}

TEST(AllocationCounter, SeesMalloc)
{
  if (!CountsMalloc())
  {
    GTEST_SKIP() << "a sanitizer owns malloc";
  }
  const std::size_t before = CountAllocations().Calls;
  void* volatile memory = std::malloc(100);
  EXPECT_GT(CountAllocations().Calls, before);
  std::free(memory);
}
