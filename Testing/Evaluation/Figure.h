// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The figures of the evaluation, each measured for one solver. They are deterministic: seeds are
 * fixed.
 */
#ifndef Evaluation_Figure_h
#define Evaluation_Figure_h

#include "Field.h"

#include <string>
#include <vector>

namespace evaluation
{

/** A measured number with an upper bound. */
struct Figure
{
  std::string Name;
  std::string Unit;
  double Value = 0.0;
  double Bound = 0.0;
  bool IsTime = false; ///< depends on the machine and the run, so tests ignore it
  /**
   * Returns whether the value is below the bound. A value equal to the bound fails, unless both are
   * 0.
   */
  bool IsReached() const
  {
    return this->Value < this->Bound || (this->Bound == 0.0 && this->Value == 0.0);
  }
};

using Figures = std::vector<Figure>;

/** Amount of measurement: a reduced run or a full run. */
struct Effort
{
  bool IsFull = false;
  int Pick(int reduced, int full) const { return this->IsFull ? full : reduced; }
};

struct Curve
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  int Colour = -1;       ///< index in the plots' palette; a negative number selects the next colour
  bool IsMarked = false; ///< only points, no line
  float Width = 2.0f;
};

/** Position of a plot's legend, which should not cover a curve. */
enum class LegendPlace
{
  Right, ///< at half height
  TopLeft,
  TopRight
};

/** A plot in the report. */
struct Plot
{
  std::string File; ///< without extension
  std::string Title;
  std::string XLabel;
  std::string YLabel;
  std::vector<Curve> Curves;
  LegendPlace Legend = LegendPlace::Right;
  /// labels of an axis without evenly spaced numbers
  std::vector<std::pair<double, std::string>> XTicks = {};
};

/** Solver and settings whose figures are measured. */
struct Candidate
{
  VolumeHaptics::HapticSolver Solver;
  VolumeHaptics::GradientEstimator Estimator;
  VolumeHaptics::MaterialPlacement Placement = VolumeHaptics::MaterialPlacement::FarSide;
  VolumeHaptics::ContactAlignment Alignment = VolumeHaptics::ContactAlignment::Edge;
};

/**
 * Returns the candidate with surfaces as in the paper: alignment Distinctness, materials from the
 * kernel.
 */
inline Candidate PlacedAsThePaper(Candidate candidate)
{
  candidate.Placement = VolumeHaptics::MaterialPlacement::Kernel;
  candidate.Alignment = VolumeHaptics::ContactAlignment::Distinctness;
  return candidate;
}

inline Touching TouchingOf(const Candidate& candidate, const VolumeHaptics::HapticMaterial& m)
{
  Touching touching;
  touching.Solver = candidate.Solver;
  touching.Estimator = candidate.Estimator;
  touching.Placement = candidate.Placement;
  touching.Alignment = candidate.Alignment;
  touching.Material = m;
  return touching;
}

/**
 * Measures the error of the force against the closed forms T1 to T13, as fractions of each form's
 * largest force.
 */
Figures MeasureClosedForms(const Candidate& candidate, const Effort& effort);
/**
 * Measures how well the proxy tracks an iso-level, and how far it drifts, on balls and in cavities
 * of 20 voxels.
 */
Figures MeasureTracking(const Candidate& candidate, const Effort& effort);
/** Counts how often a tip falls through a blurred wall. */
Figures MeasureFallThrough(const Candidate& candidate, const Effort& effort);
/** Measures the ripple of the force on a clean plane, between 100 and 500 Hz. */
Figures MeasureRipple(const Candidate& candidate, const Effort& effort);
/** Measures the energy that the hand gains in closed cycles. */
Figures MeasureEnergy(const Candidate& candidate, const Effort& effort);
/** Measures the angle between the frictionless force and the normal of an 8-bit sphere. */
Figures MeasureAngle(const Candidate& candidate, const Effort& effort);
/** Measures the position at which alignment Edge places the surface of a blurred step. */
Figures MeasureAlignment(const Candidate& candidate, const Effort& effort);
/** Measures proxy and force on a bumpy ball, with alignment Edge. */
Figures MeasureBumps(const Candidate& candidate, const Effort& effort);
/** Measures the force of a moving volume on a resting tip, compared with closed forms. */
Figures MeasureMovingWall(const Candidate& candidate, const Effort& effort);
/** Measures the cost of a tick, which only the report uses. */
Figures MeasureSpeed(const Candidate& candidate, const Effort& effort);

/** Returns the report's plots, with curves for both solvers. */
std::vector<Plot> MakePlots(const Effort& effort);
/** Plots the forces that MeasureMovingWall() compares. */
std::vector<Plot> PlotMovingWalls();

} // namespace evaluation

#endif
