// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchAnything.h"

#include "Core/Servo/ServoTick.h"
#include "Core/State/ServoStateNumbers.h"
#include "Dealer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr int MostTicks = 400;
constexpr double Rounding = 1e-6; // relative rounding error of a force

/**
 * Draws a function of one to four points in ascending order. Points may have the same X, which is a
 * step.
 */
Polyline Function(Dealer& dealer, double most)
{
  Polyline line;
  double x = dealer.Between(-1000.0, 1000.0);
  for (int points = 1 + dealer.Choose(4); points > 0; --points)
  {
    line.push_back({ x, dealer.Between(0.0, most) });
    x += dealer.Choose(3) == 0 ? 0.0 : dealer.Between(0.0, 500.0);
  }
  return line;
}

constexpr std::size_t Sizes[] = { 1, 1, 2, 2, 4, 4, 8, 8, 4, 8 };
constexpr int MostSamples = 12;

struct Scene
{
  HapticModelDescription Description;
  std::vector<char> Samples;
  std::vector<char> LaterSamples;
  std::vector<float> Displacements;
  std::vector<char> LabelSamples;
};

void Deal(Dealer& dealer, Scene& scene)
{
  HapticModelDescription& d = scene.Description;
  d.View.Type = static_cast<ScalarType>(dealer.Choose(10));
  d.KernelRadius = 1 + dealer.Choose(3);
  std::int64_t count = 1;
  for (int a = 0; a < 3; ++a)
  {
    d.View.Dimensions[a] = 2 * d.KernelRadius + 1 + dealer.Choose(MostSamples - 6);
    d.View.Stride[a] = count;
    count *= d.View.Dimensions[a];
  }
  d.Estimator = static_cast<GradientEstimator>(dealer.Choose(3));
  d.Settings.Solver = dealer.Choose(4) == 0 ? HapticSolver::Paper : HapticSolver::Precise;
  d.Settings.Method = dealer.Choose(4) == 0 ? HapticMethod::LocalSurface : HapticMethod::Proxy;
  d.Settings.IsoValue = dealer.Between(-1000.0, 1000.0);
  d.Settings.LocalSurfaceRate = dealer.Between(1.0, 1000.0);
  d.Settings.RecoveryTime = dealer.Between(0.0, 0.1);
  d.Settings.ReleaseTime = dealer.Between(0.0, 0.1);
  d.Settings.LocalShape = static_cast<LocalSurfaceShape>(dealer.Choose(2));
  d.Settings.Side = static_cast<SurfaceSide>(dealer.Choose(3));
  d.Settings.SameShape = dealer.Choose(2) == 1;
  d.Settings.CouplingStiffness = dealer.Between(0.0, 3000.0);
  d.Settings.Alignment = static_cast<ContactAlignment>(dealer.Choose(2));
  d.Settings.Placement = static_cast<MaterialPlacement>(dealer.Choose(2));
  d.IndexToWorld.Linear = Matrix3::FromColumns({ dealer.Between(0.1, 3.0), 0.0, 0.0 },
    { dealer.Between(-1.0, 1.0), dealer.Between(0.1, 3.0), 0.0 },
    { 0.0, dealer.Between(-1.0, 1.0), dealer.Between(0.1, 3.0) });
  d.DeviceToWorld.Linear = 1000.0 * Matrix3{};
  HapticMaterial& m = d.Material;
  m.Stiffness = Function(dealer, 3000.0);
  m.Friction = Function(dealer, 2.0);
  m.SurfaceStrength = Function(dealer, dealer.Choose(3) == 0 ? 1e9 : 5.0);
  m.Viscosity = Function(dealer, 2.0);
  m.Distinctness = Function(dealer, 1.0);
  const std::size_t size = Sizes[static_cast<int>(d.View.Type)];
  scene.Samples.resize(count * size);
  if (dealer.Choose(2))
  {
    // Use the raw bytes, so that every number of the type can occur.
    dealer.Fill(scene.Samples.data(), scene.Samples.size() / 2);
  }
  else
  {
    // Fill the samples with a pattern made from a few bytes, which resembles a volume.
    const std::uint8_t seed = dealer.Byte();
    for (std::size_t i = 0; i < scene.Samples.size(); i += size)
    {
      scene.Samples[i] = static_cast<char>((i / size) * seed + (i / size) / 7);
    }
  }
  d.View.Data = scene.Samples.data();
}

/** Draws two or three time steps, one of which has different samples. */
void DealTimeSteps(Dealer& dealer, Scene& scene)
{
  HapticModelDescription& d = scene.Description;
  scene.LaterSamples = scene.Samples;
  dealer.Fill(scene.LaterSamples.data(), scene.LaterSamples.size() / 2);
  VolumeView later = d.View;
  later.Data = scene.LaterSamples.data();
  d.TimeSteps = { { dealer.Between(-1.0, 0.0), d.View, nullptr },
    { dealer.Between(0.001, 1.0), later, nullptr } };
  if (dealer.Choose(2) == 1)
  {
    d.TimeSteps.push_back({ dealer.Between(1.001, 2.0), d.View, nullptr });
  }
  if (dealer.Choose(2) == 1)
  {
    // Draw displacements of all sizes, including NaN and infinities.
    const std::int64_t* const n = d.View.Dimensions;
    scene.Displacements.resize(static_cast<std::size_t>(3 * n[0] * n[1] * n[2]));
    dealer.Fill(reinterpret_cast<char*>(scene.Displacements.data()),
      scene.Displacements.size() * sizeof(float));
    d.TimeSteps.front().Displacements = { scene.Displacements.data(), ScalarType::Float32 };
  }
}

/**
 * Rounds label samples down to whole numbers, and replaces too large numbers by 0, because baking
 * refuses others.
 */
template <typename T>
void MakeWhole(std::vector<char>& samples)
{
  constexpr T most = T(9007199254740992.0);
  T* const values = reinterpret_cast<T*>(samples.data());
  for (std::size_t i = 0; i < samples.size() / sizeof(T); ++i)
  {
    values[i] = std::abs(values[i]) <= most ? std::floor(values[i]) : T(0);
  }
}

/** Draws a material with arbitrary numbers, for a label that the image may contain. */
LabelledMaterial DealEntry(Dealer& dealer, const LabelView& view, std::int64_t otherwise)
{
  LabelledMaterial entry;
  const std::int64_t* const n = view.GetView().Dimensions;
  const auto at = [&dealer](std::int64_t samples)
  { return static_cast<double>(dealer.Choose(static_cast<int>(samples))); };
  const double x = at(n[0]);
  const double y = at(n[1]);
  entry.Label = dealer.Choose(4) == 0 ? otherwise : view.Nearest({ x, y, at(n[2]) });
  LabelMaterial& m = entry.Material;
  m.Value = { dealer.Between(0.0, 3000.0), dealer.Between(0.0, 2.0),
    dealer.Between(0.0, dealer.Choose(3) == 0 ? 1e9 : 5.0), dealer.Between(0.0, 2.0) };
  for (bool& isSet : m.IsSet)
  {
    isSet = dealer.Choose(4) != 0;
  }
  m.IsFelt = dealer.Choose(4) != 0;
  m.IsForbidden = dealer.Choose(8) == 0;
  return entry;
}

/** Draws a label image of any type, extent, placement and direction, and a table of labels. */
void DealLabels(Dealer& dealer, Scene& scene)
{
  VolumeView view;
  view.Type = static_cast<ScalarType>(dealer.Choose(10));
  std::int64_t count = 1;
  for (int a = 0; a < 3; ++a)
  {
    view.Dimensions[a] = 1 + dealer.Choose(MostSamples);
    view.Stride[a] = count;
    count *= view.Dimensions[a];
  }
  const std::size_t size = Sizes[static_cast<int>(view.Type)];
  scene.LabelSamples.resize(count * size);
  const std::uint8_t kind = dealer.Byte();
  if (kind % 4 == 0)
  {
    dealer.Fill(scene.LabelSamples.data(), scene.LabelSamples.size() / 2);
  }
  else
  {
    // Fill the labels with runs of 1 to 16 equal samples. Runs cycle through three values: the last
    // (highest) byte of each sample is 0, 67 or 134. MakeWhole() below makes floating-point labels
    // whole numbers.
    for (std::size_t i = 0; i < scene.LabelSamples.size(); i += size)
    {
      scene.LabelSamples[i + size - 1] = static_cast<char>(i / size / (1 + kind % 16) % 3 * 67);
    }
  }
  if (view.Type == ScalarType::Float32)
  {
    MakeWhole<float>(scene.LabelSamples);
  }
  else if (view.Type == ScalarType::Float64)
  {
    MakeWhole<double>(scene.LabelSamples);
  }
  view.Data = scene.LabelSamples.data();
  const auto labels = std::make_shared<BakedLabels>();
  labels->View = LabelView(view);
  // Sometimes reverse an axis.
  const double side = dealer.Choose(2) == 0 ? 1.0 : -1.0;
  labels->IndexToWorld.Linear = Matrix3::FromColumns({ side * dealer.Between(0.1, 3.0), 0.0, 0.0 },
    { dealer.Between(-1.0, 1.0), dealer.Between(0.1, 3.0), 0.0 },
    { 0.0, dealer.Between(-1.0, 1.0), dealer.Between(0.1, 3.0) });
  labels->IndexToWorld.Offset = { dealer.Between(-10.0, 10.0), dealer.Between(-10.0, 10.0),
    dealer.Between(-10.0, 10.0) };
  std::vector<LabelledMaterial> entries;
  for (int i = dealer.Choose(5); i > 0; --i)
  {
    const LabelledMaterial entry = DealEntry(dealer, labels->View, i - 2);
    const bool isNew = std::none_of(entries.begin(), entries.end(),
      [&entry](const LabelledMaterial& e) { return e.Label == entry.Label; });
    if (isNew && entry.Label != NoLabel)
    {
      entries.push_back(entry);
    }
  }
  labels->Table = LabelTable(entries);
  labels->Zone = ForbiddenZone::Make(
    labels->View, labels->Table, labels->IndexToWorld, dealer.Between(0.0, 3.0));
  scene.Description.Labels = labels;
  scene.Description.Settings.Geometry = static_cast<SurfaceGeometry>(dealer.Choose(3));
}

Vector3 DealTip(Dealer& dealer, const Vector3& before)
{
  // A hand 100 m away is an extreme case. Draw larger numbers, too, which must be refused.
  constexpr double oddities[] = { HUGE_VAL, 1e300, 100.0, -100.0 };
  switch (dealer.Choose(16))
  {
    case 0:
      return { dealer.Between(-0.02, 0.05), dealer.Between(-0.02, 0.05),
        dealer.Between(-0.02, 0.05) };
    case 1:
      return { before.X, std::nan(""), before.Z };
    case 2:
      return { before.X, before.Y, oddities[dealer.Choose(4)] };
    case 3:
      return before;
    default:
      return before +
        Vector3{ dealer.Between(-0.003, 0.003), dealer.Between(-0.003, 0.003),
          dealer.Between(-0.003, 0.003) };
  }
}
} // namespace

void TouchAnything(const std::uint8_t* bytes, std::size_t size)
{
  Dealer dealer(bytes, size);
  Scene scene;
  Deal(dealer, scene);
  if (dealer.Choose(2) == 1)
  {
    DealLabels(dealer, scene);
  }
  if (dealer.Choose(3) == 1)
  {
    DealTimeSteps(dealer, scene);
  }
  const HapticModel model(scene.Description);
  ServoState state;
  TickRecord record;
  Vector3 tip = { 0.005, 0.005, 0.005 };
  for (int tick = 0; tick < MostTicks && dealer.HasMore(); ++tick)
  {
    const Vector3 next = DealTip(dealer, tip);
    state.DataTime += model.Baked->IsMoving() ? dealer.Between(-0.05, 0.1) : 0.0;
    ServoState stored = FromNumbers(ToNumbers(state));
    TickRecord again;
    Tick(model, state, next, record);
    Tick(model, stored, next, again);
    Check(IsFinite(record.Force) && IsFinite(record.Proxy), "force and proxy are finite");
    Check(Norm(record.Force - again.Force) == 0.0, "a stored state goes on the same");
    // Allow larger rounding errors for a tip far away.
    constexpr double far = 1e-9;
    const bool isLocal = model.Baked->Settings.Method == HapticMethod::LocalSurface;
    const double bound = isLocal
      ? std::hypot(record.NormalForce, record.FrictionForce)
      : record.SurfaceStrength * std::hypot(1.0, record.Friction) + record.Viscosity;
    // After a jump of the proxy, add the part of the earlier force that is still released.
    const double whole = bound + Norm(state.Release.Force);
    Check(Norm(record.Force) <= whole * (1.0 + Rounding) + far, "the material holds the force");
    tip = IsFinite(next) && Norm(next) < 1.0 ? next : tip;
  }
}
