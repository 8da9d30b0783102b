// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fields with edges, and circles around them.
 */
#ifndef Evaluation_Shapes_h
#define Evaluation_Shapes_h

#include "Field.h"

#include <random>

namespace evaluation
{

/** Unit normal that is not parallel to any axis of the samples. */
const Vector3 OddNormal = (1.0 / 3.0) * Vector3{ 1.0, -2.0, 2.0 };
/** Unit vectors perpendicular to OddNormal and to each other. */
const Vector3 OddAside = (1.0 / std::sqrt(5.0)) * Vector3{ 2.0, 1.0, 0.0 };
const Vector3 OddUp = Cross(OddNormal, OddAside);
/** Centre of the balls, away from all samples. */
constexpr Vector3 OddCentre = { 0.37, -0.21, 0.43 };

/**
 * Returns the value of a blurred step at a distance (mm) from its middle; `blur` (mm) is the scale
 * of the Gaussian.
 */
inline double BlurredStep(double distance, double blur, double height)
{
  return 0.5 * height * (1.0 + std::erf(distance / (blur * std::sqrt(2.0))));
}

/** Returns a point on a circle about OddCentre, whose plane contains no axis. */
inline Vector3 OnOddCircle(double radius, double angle)
{
  return OddCentre + (radius * std::cos(angle)) * OddAside + (radius * std::sin(angle)) * OddUp;
}

constexpr double TwoPi = 6.283185307179586;

/** Draws uniformly distributed numbers between two bounds. */
class Uniform
{
public:
  explicit Uniform(std::mt19937& random)
    : Random(random)
  {
  }

  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

private:
  std::mt19937& Random;
};

} // namespace evaluation

#endif
