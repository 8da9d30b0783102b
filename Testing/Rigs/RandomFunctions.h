// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Makes random vtkPiecewiseFunctions of all kinds, and critical arguments for them. */
#ifndef RandomFunctions_h
#define RandomFunctions_h

#include "FunctionChecks.h"

#include <vtkSmartPointer.h>

#include <random>

namespace apitest
{
struct Shape
{
  double Sharpness; ///< sharpness of all pieces; negative: random, often exactly 0 or 1
  bool Duplicates;
  bool Clamping;
  bool LogScale;
};

/// Returns a random function on [low, low + width] with values from 0 to `height`. With a log
/// scale, low must be positive.
inline vtkSmartPointer<vtkPiecewiseFunction> RandomFunction(
  std::mt19937_64& engine, const Shape& shape, double low, double width, double height)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto corner = [&](double x) { return x < 0.2 ? 0.0 : (x > 0.8 ? 1.0 : uniform(engine)); };
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->SetAllowDuplicateScalars(shape.Duplicates);
  function->SetClamping(shape.Clamping);
  function->SetUseLogScale(shape.LogScale);
  const int nodes = 1 + static_cast<int>(engine() % 8);
  for (int i = 0; i < nodes; ++i)
  {
    // Put nodes on a grid, so that duplicate nodes and steep edges occur. With a log scale, make
    // edges less steep, because VTK's difference of two logarithms would lose all digits there.
    double share = std::floor(8.0 * uniform(engine)) / 8.0;
    share += uniform(engine) < 0.3 ? (shape.LogScale ? 1e-3 : 1e-6) * uniform(engine) : 0.0;
    const double sharpness = shape.Sharpness < 0.0 ? corner(uniform(engine)) : shape.Sharpness;
    function->AddPoint(
      low + share * width, height * uniform(engine), corner(uniform(engine)), sharpness);
  }
  return function;
}

/// Returns the arguments to test: nodes and their neighbours, and positions inside and outside of
/// all pieces.
inline std::vector<double> ArgumentsOf(vtkPiecewiseFunction* function, std::mt19937_64& engine)
{
  const std::vector<Node> nodes = NodesOf(function);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> arguments = { nodes.front().X - 1e6, nodes.back().X + 1e6 };
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Node& a = nodes[i];
    const double width = nodes[std::min(i + 1, nodes.size() - 1)].X - a.X;
    arguments.insert(
      arguments.end(), { a.X, std::nextafter(a.X, -HUGE_VAL), std::nextafter(a.X, HUGE_VAL) });
    for (int n = 0; n < 300; ++n)
    {
      // Put half of the positions near the ends and near the midpoint.
      const double far = n % 2 ? std::pow(uniform(engine), 12.0) : 1.0;
      const double anchor = n % 2 ? std::vector<double>{ 0.0, 1.0, a.Midpoint }[engine() % 3] : 0.0;
      const double share = anchor + (anchor > 0.5 ? -far : far) * uniform(engine);
      arguments.push_back(a.X + share * width);
    }
  }
  return arguments;
}
} // namespace apitest

#endif
