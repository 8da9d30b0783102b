// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cost of a tick as a function of the radius of the gradient kernel: a constant and a cubic
 * term.
 *
 * The paper: "While the rest of the algorithm yields a constant delay of about 35 us, the time
 * delay of the gradient estimation has cubic growth with respect to the radius of the gradient
 * estimation kernel."
 */
#ifndef Evaluation_CostFit_h
#define Evaluation_CostFit_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

constexpr double PaperConstant = 35.0; // us, on a Pentium II at 800 MHz

/** The line y = Constant + Slope x. */
struct LineFit
{
  double Constant = 0.0;
  double Slope = 0.0;
  double Residual = 0.0; ///< root mean square of (fit - y) / y
  double Worst = 0.0;    ///< largest magnitude of (fit - y) / y
};

/**
 * Fits the line with the least squares of relative errors, since the times differ by orders of
 * magnitude. Returns zeros for fewer than two different x, or if any y is not positive.
 */
LineFit FitLine(const std::vector<double>& x, const std::vector<double>& y);

/** Returns the number of taps of GAUSSIAN: (2 r + 2)^3. */
constexpr double TapsOf(double radius)
{
  return (2.0 * radius + 2.0) * (2.0 * radius + 2.0) * (2.0 * radius + 2.0);
}

/**
 * Measures PROXY with both solvers and radii 1 to 6; adds a plot. The times depend on the machine
 * and vary from run to run.
 */
Table MeasureCost(const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
