// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes from theory whether a sampled spring is unstable. The spring has the stiffness k, is
 * sampled with the period T, and acts on a mass m with damping b.
 *
 * Over a period with a constant force f, position and velocity become A (x, v) + B f with e =
 * exp(-bT/m), A = (1, (1 - e) m/b; 0, e), B = (T/b - (1 - e) m/b^2; (1 - e)/b). With f = -k x from
 * `delay` ticks ago, the loop is unstable if an eigenvalue of the whole system has a modulus above
 * 1.
 */
#ifndef SampledLoop_h
#define SampledLoop_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace servotest
{
inline constexpr double Mass = 0.1;
inline constexpr double Damping = 0.5;
inline constexpr double Period = 1e-3;

using Square = std::vector<std::vector<double>>;

inline Square Multiply(const Square& a, const Square& b)
{
  Square product(a.size(), std::vector<double>(a.size(), 0.0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < a.size(); ++j)
    {
      for (std::size_t l = 0; l < a.size(); ++l)
      {
        product[i][j] += a[i][l] * b[l][j];
      }
    }
  }
  return product;
}

/// Returns the largest modulus of the matrix's eigenvalues, as |M^n|^(1/n) with n = 2^40.
inline double SpectralRadius(Square matrix)
{
  double logarithm = 0.0;
  for (int i = 0; i < 40; ++i)
  {
    double largest = 0.0;
    for (const std::vector<double>& row : matrix)
    {
      for (const double x : row)
      {
        largest = std::max(largest, std::abs(x));
      }
    }
    for (std::vector<double>& row : matrix)
    {
      for (double& x : row)
      {
        x /= largest;
      }
    }
    logarithm += std::log(largest) / std::ldexp(1.0, i);
    matrix = Multiply(matrix, matrix);
  }
  return std::exp(logarithm);
}

/// Returns the matrix of one period of a mass on a sampled spring. Its state consists of the
/// position, the velocity and the pending forces, with the next force first.
inline Square MakeLoop(double k, int delay)
{
  const double e = std::exp(-Damping * Period / Mass);
  const double drift = (1.0 - e) * Mass / Damping;
  const double push[2] = { (Period - drift) / Damping, (1.0 - e) / Damping };
  const auto size = static_cast<std::size_t>(2 + delay);
  Square loop(size, std::vector<double>(size, 0.0));
  loop[0][0] = 1.0;
  loop[0][1] = drift;
  loop[1][1] = e;
  for (std::size_t row = 0; row < 2; ++row)
  {
    delay == 0 ? loop[row][0] -= push[row] * k : loop[row][2] = push[row];
  }
  for (std::size_t i = 3; i < size; ++i)
  {
    loop[i - 1][i] = 1.0;
  }
  if (delay > 0)
  {
    loop[size - 1][0] = -k;
  }
  return loop;
}

inline double ComputeLimit(int delay)
{
  double low = 1.0;
  double high = 5000.0;
  while (high - low > 1e-6)
  {
    const double k = 0.5 * (low + high);
    (SpectralRadius(MakeLoop(k, delay)) > 1.0 ? high : low) = k;
  }
  return low;
}
} // namespace servotest

#endif
