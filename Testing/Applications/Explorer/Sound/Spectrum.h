// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes spectra by the definition of the discrete Fourier transform, one frequency at a time.
 */
#ifndef Spectrum_h
#define Spectrum_h

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace soundtest
{

inline constexpr double PI = 3.14159265358979323846;
inline constexpr double RATE = 48000.0;

/** Returns |X(f)|^2 of `count` samples from `first` on, with a Hann window if `isWindowed`. */
inline double Density(const std::vector<float>& x, std::size_t first, std::size_t count, double f,
  bool isWindowed = false)
{
  std::complex<double> sum = 0.0;
  std::complex<double> at = 1.0;
  const std::complex<double> turn = std::polar(1.0, -2.0 * PI * f / RATE);
  for (std::size_t i = 0; i < count; ++i, at *= turn)
  {
    const double window = isWindowed
      ? 0.5 - 0.5 * std::cos(2.0 * PI * static_cast<double>(i) / static_cast<double>(count))
      : 1.0;
    sum += window * static_cast<double>(x[first + i]) * at;
  }
  return std::norm(sum);
}

/** Returns the frequency of the largest density in a range (Hz). */
inline double FindPeak(const std::vector<float>& x, double low, double high, double step)
{
  double best = low;
  double largest = 0.0;
  for (double f = low; f <= high; f += step)
  {
    const double density = Density(x, 0, x.size(), f);
    best = density > largest ? f : best;
    largest = std::max(largest, density);
  }
  return best;
}

/**
 * Returns the energy between two frequencies: the mean over frames of `length` samples, summed over
 * the frequencies of a frame's transform.
 */
inline double BandEnergy(
  const std::vector<float>& x, std::size_t length, double low, double high, double power = 0.0)
{
  const double step = RATE / static_cast<double>(length);
  double sum = 0.0;
  for (std::size_t first = 0; first + length <= x.size(); first += length)
  {
    for (double f = step * std::ceil(low / step); f < high; f += step)
    {
      sum += std::pow(f, power) * Density(x, first, length, f, true);
    }
  }
  return sum;
}

/** Returns the mean frequency (Hz) of the energy between 50 Hz and 10 kHz. */
inline double Centroid(const std::vector<float>& x, std::size_t length)
{
  return BandEnergy(x, length, 50.0, 10000.0, 1.0) / BandEnergy(x, length, 50.0, 10000.0);
}

} // namespace soundtest

#endif
