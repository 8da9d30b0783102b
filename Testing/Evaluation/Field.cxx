// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Field.h"

#include <cstring>
#include <random>
#include <type_traits>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double MetersPerMillimeter = 0.001;

template <typename T>
void Store(double value, char* to)
{
  T stored;
  if constexpr (std::is_integral_v<T>)
  {
    const double low = static_cast<double>(std::numeric_limits<T>::lowest());
    const double high = static_cast<double>(std::numeric_limits<T>::max());
    stored = value >= high ? std::numeric_limits<T>::max()
                           : static_cast<T>(std::max(low, std::round(value)));
  }
  else
  {
    stored = static_cast<T>(value);
  }
  std::memcpy(to, &stored, sizeof(T));
}

struct Storing
{
  std::size_t Size;
  void (*Store)(double, char*);
};

template <typename T>
constexpr Storing StoringAs()
{
  return { sizeof(T), &Store<T> };
}

Storing GetStoring(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return StoringAs<std::int8_t>();
    case ScalarType::UInt8:
      return StoringAs<std::uint8_t>();
    case ScalarType::Int16:
      return StoringAs<std::int16_t>();
    case ScalarType::UInt16:
      return StoringAs<std::uint16_t>();
    case ScalarType::Int32:
      return StoringAs<std::int32_t>();
    case ScalarType::UInt32:
      return StoringAs<std::uint32_t>();
    case ScalarType::Int64:
      return StoringAs<std::int64_t>();
    case ScalarType::UInt64:
      return StoringAs<std::uint64_t>();
    case ScalarType::Float32:
      return StoringAs<float>();
    case ScalarType::Float64:
      break;
  }
  return StoringAs<double>();
}

/** Returns a rotation about an odd axis by an odd angle (Rodrigues' formula). */
Matrix3 OddRotation()
{
  const Vector3 axis = (1.0 / std::sqrt(14.0)) * Vector3{ 1.0, 2.0, 3.0 };
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const auto turned = [&](const Vector3& v)
  { return c * v + s * Cross(axis, v) + ((1.0 - c) * Dot(axis, v)) * axis; };
  return Matrix3::FromColumns(turned({ 1, 0, 0 }), turned({ 0, 1, 0 }), turned({ 0, 0, 1 }));
}
} // namespace

HapticMaterial MakeMaterial(
  double stiffness, double friction, double viscosity, double surfaceStrength, double distinctness)
{
  HapticMaterial material;
  material.Stiffness = ConstantPolyline(stiffness);
  material.Friction = ConstantPolyline(friction);
  material.Viscosity = ConstantPolyline(viscosity);
  material.SurfaceStrength = ConstantPolyline(surfaceStrength);
  material.Distinctness = ConstantPolyline(distinctness);
  return material;
}

Volume::Volume(const Field& field, const Sampling& sampling)
{
  const double spacing[3] = { sampling.Spacing.X, sampling.Spacing.Y, sampling.Spacing.Z };
  std::int64_t* const n = this->View.Dimensions;
  std::int64_t count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    n[axis] = 2 * static_cast<std::int64_t>(std::ceil(sampling.HalfSize / spacing[axis])) + 1;
    this->View.Stride[axis] = count;
    count *= n[axis];
  }
  const Matrix3 scale =
    Matrix3::FromColumns({ spacing[0], 0, 0 }, { 0, spacing[1], 0 }, { 0, 0, spacing[2] });
  this->IndexToWorld.Linear = sampling.IsTurned ? OddRotation() * scale : scale;
  const Vector3 centre = { 0.5 * (n[0] - 1), 0.5 * (n[1] - 1), 0.5 * (n[2] - 1) };
  const Vector3 odd = sampling.IsTurned ? Vector3{ 0.31, -0.17, 0.23 } : Vector3{};
  this->IndexToWorld.Offset = odd - this->IndexToWorld.Linear * centre;

  const Storing storing = GetStoring(sampling.Type);
  this->Samples = std::make_shared<std::vector<char>>(count * storing.Size);
  std::mt19937 random(sampling.Seed);
  std::normal_distribution<double> noise;
  char* to = this->Samples->data();
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const Vector3 index = { static_cast<double>(i), static_cast<double>(j),
          static_cast<double>(k) };
        const double clean = field(this->IndexToWorld(index));
        storing.Store(sampling.Noise > 0.0 ? clean + sampling.Noise * noise(random) : clean, to);
        to += storing.Size;
      }
    }
  }
  this->View.Data = this->Samples->data();
  this->View.Type = sampling.Type;
}

HapticModelDescription Volume::Describe(const Touching& touching) const
{
  HapticModelDescription d;
  d.View = this->View;
  d.Samples = this->Samples;
  d.IndexToWorld = this->IndexToWorld;
  const double scale = 1.0 / MetersPerMillimeter;
  d.DeviceToWorld.Linear = scale * Matrix3{};
  d.Estimator = touching.Estimator;
  d.KernelRadius = touching.KernelRadius;
  d.Material = touching.Material;
  d.Settings.Solver = touching.Solver;
  d.Settings.Alignment = touching.Alignment;
  d.Settings.Placement = touching.Placement;
  d.Settings.ReleaseTime = touching.ReleaseTime;
  d.Settings.Side = touching.Side;
  return d;
}

std::unique_ptr<HapticModel> Volume::Bake(const Touching& touching) const
{
  return std::make_unique<HapticModel>(this->Describe(touching));
}

void MoveTo(Path& path, const Vector3& goal, double step)
{
  const Vector3 start = path.back();
  const double steps = std::max(1.0, std::round(Norm(goal - start) / step));
  for (double i = 1.0; i < steps; i += 1.0)
  {
    path.push_back(start + (i / steps) * (goal - start));
  }
  path.push_back(goal);
}

Trace Play(const HapticModel& model, const Path& path)
{
  Trace trace(path.size());
  ServoState state;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    Tick(model, state, MetersPerMillimeter * path[i], trace[i]);
  }
  return trace;
}

} // namespace evaluation
