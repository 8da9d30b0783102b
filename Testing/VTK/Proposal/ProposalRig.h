// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Balls in balls with blurred edges, and what a proposal says about them.
 *
 * An edge blurred by a Gaussian of scale s is V1 + (V2 - V1) Phi(x/s), Phi the normal distribution:
 * the closed form of Kindlmann and Durkin, "Semi-automatic generation of transfer functions for
 * direct volume rendering", 1998. Nothing here uses the project's own kernels.
 */
#ifndef ProposalRig_h
#define ProposalRig_h

#include "Rigs/ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkTable.h>

#include <cmath>
#include <random>

namespace proposaltest
{
using apitest::Point;

/// A ball around the middle of the image: a step of the value, blurred.
struct Ball
{
  double Radius;
  double Step;
  double Width; // s
};

constexpr int Size = 80; // voxels of an image along an axis
constexpr double Middle = 0.5 * (Size - 1);

inline double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// In an image of `size` voxels along an axis.
inline double Value(const std::vector<Ball>& balls, const Point& x, int size = Size)
{
  const double middle = 0.5 * (size - 1);
  const double r = std::hypot(x[0] - middle, x[1] - middle, x[2] - middle);
  double value = 0.0;
  for (const Ball& ball : balls)
  {
    value += ball.Step * Phi((ball.Radius - r) / ball.Width);
  }
  return value;
}

/// Three materials, 0, 100 and 250; edges of widths s.
inline std::vector<Ball> ThreeMaterials(double outer, double inner)
{
  return { { 34.0, 100.0, outer }, { 18.0, 150.0, inner } };
}

/// Normal noise, always the same.
class Noise
{
public:
  explicit Noise(double sigma)
    : Sigma(sigma)
  {
  }
  double operator()() { return this->Sigma * this->Normal(this->Random); }

private:
  double Sigma;
  std::mt19937 Random{ 7 };
  std::normal_distribution<double> Normal;
};

/// A row of vtkHapticProperty::GetProposedBoundaries.
struct Found
{
  double Low;
  double High;
  double Width;
  double Slope;
  double Share;
};

/// The boundaries in ascending order of their lower value.
inline std::vector<Found> Boundaries(vtkHapticProperty* property)
{
  std::vector<Found> all;
  vtkTable* const table = property->GetProposedBoundaries();
  for (vtkIdType i = 0; table && i < table->GetNumberOfRows(); ++i)
  {
    const auto get = [&](const char* name)
    { return vtkDoubleArray::SafeDownCast(table->GetColumnByName(name))->GetValue(i); };
    all.push_back({ get("Low"), get("High"), get("Width"), get("Slope"), get("Share") });
  }
  std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.Low < b.Low; });
  return all;
}

/// The value of the n-th point of a function, and what it is there.
inline std::array<double, 2> NodeOf(vtkPiecewiseFunction* function, int n)
{
  double node[4] = { std::nan(""), std::nan(""), 0.0, 0.0 };
  function->GetNodeValue(n, node);
  return { node[0], node[1] };
}
} // namespace proposaltest

#endif
