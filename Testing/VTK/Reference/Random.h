// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Makes random numbers and rotations that are the same with every standard library, unlike those of
 * the std distributions.
 */
#ifndef Random_h
#define Random_h

#include "Vec3.h"

#include <cstdint>
#include <random>

namespace reference
{
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  double Uniform(double low, double high)
  {
    return low + (high - low) * double(this->Engine() >> 11) * 0x1p-53;
  }

  /// Returns a random number from `low` to `high`, including both.
  int Integer(int low, int high)
  {
    return low + int(this->Engine() % std::uint64_t(high - low + 1));
  }

  bool Chance(double probability) { return this->Uniform(0.0, 1.0) < probability; }

  double Normal()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - this->Uniform(0.0, 1.0)));
    return radius * std::cos(6.283185307179586 * this->Uniform(0.0, 1.0));
  }

  Vec3 UnitVector()
  {
    const Vec3 v = { { this->Normal(), this->Normal(), this->Normal() } };
    return (1.0 / Norm(v)) * v;
  }

  /// Returns a matrix that is orthonormal within rounding errors.
  Mat3 Rotation(bool leftHanded = false)
  {
    const Vec3 a = this->UnitVector();
    Vec3 b = Cross(a, this->UnitVector());
    b = (1.0 / Norm(b)) * b;
    const Vec3 c = Cross(a, b);
    return { { a, b, (leftHanded ? -1.0 : 1.0) * c } };
  }

private:
  std::mt19937_64 Engine;
};
} // namespace reference

#endif
