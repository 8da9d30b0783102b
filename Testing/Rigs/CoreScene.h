// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Makes models of small volumes in a world of millimetres, and a tip that moves randomly through
 * them.
 */
#ifndef CoreScene_h
#define CoreScene_h

#include "Core/Servo/ServoTick.h"
#include "TestVolume.h"

namespace coretest
{
/// Describes a volume of 1 mm voxels in a world of millimetres, with the default material.
inline HapticModelDescription Describe(const TestVolume& volume)
{
  HapticModelDescription description;
  description.View = volume.View;
  description.DeviceToWorld.Linear = 1000.0 * Matrix3{};
  return description;
}

/// Selects the paper's placement: surfaces begin at the first distinct gradient, and materials are
/// read one kernel radius ahead.
inline void PlaceAsThePaper(HapticModelDescription& description)
{
  description.Settings.Alignment = ContactAlignment::Distinctness;
  description.Settings.Placement = MaterialPlacement::Kernel;
}

/// Returns a volume with V = 100 z, where every point is on a surface with the normal z.
inline TestVolume MakeRamp(std::int64_t samples = 24)
{
  TestVolume volume(ScalarType::Float64, { samples, samples, samples });
  volume.Fill<double>([](std::int64_t, std::int64_t, std::int64_t k) { return 100.0 * double(k); });
  return volume;
}

/// A random walk (m) inside and outside of a volume of `size` voxels of 1 mm.
class Wanderer
{
public:
  explicit Wanderer(double size, unsigned seed = 1)
    : Size(size)
    , Engine(seed)
  {
  }

  Vector3 Next()
  {
    for (double* x : { &this->Tip.X, &this->Tip.Y, &this->Tip.Z })
    {
      *x += 2e-4 * (this->Uniform() - 0.5);
      // Reflect the walk at 5 mm outside of the volume. Let it jump in some ticks.
      const double low = -0.005;
      const double high = 0.001 * this->Size + 0.005;
      *x = *x < low ? 2.0 * low - *x : (*x > high ? 2.0 * high - *x : *x);
      *x = this->Uniform() < 0.002 ? low + this->Uniform() * (high - low) : *x;
    }
    return this->Tip;
  }

  double Uniform() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

private:
  double Size;
  std::mt19937_64 Engine;
  Vector3 Tip{ 0.001, 0.001, 0.001 };
};
} // namespace coretest

#endif
