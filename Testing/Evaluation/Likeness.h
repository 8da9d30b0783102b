// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Estimates whether a hand can distinguish a method from proxy-based surface haptics, by
 * comparing differences with those that people notice.
 *
 * Just noticeable differences are 7 to 10 % of a force (Jones 1989; Pang, Tan and Durlach 1991), 8
 * to 22 % of a stiffness (Tan et al. 1995) and some 25 degrees of a force's direction (Barbagli et
 * al. 2006). These values were measured with steady forces, one after the other, and do not apply
 * to vibration.
 */
#ifndef Evaluation_Likeness_h
#define Evaluation_Likeness_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

struct Thresholds
{
  double Lower;
  double Upper;
};
constexpr Thresholds ForceThresholds{ 7.0, 10.0 };     // %, lowest and highest published threshold
constexpr Thresholds StiffnessThresholds{ 8.0, 22.0 }; // %, lowest and highest published threshold
constexpr double DirectionThreshold = 25.0;            // degrees
/**
 * Least force (N) of the reference in a tick that is compared. With less force, the hand does not
 * press.
 */
constexpr double LeastForce = 0.1;

struct Spread
{
  double RootMeanSquare = 0.0;
  double Median = 0.0;
  double P95 = 0.0; ///< the 95th percentile
};
Spread SpreadOf(std::vector<double> values);
/** Returns the percentage of values below a bound. */
double FractionBelow(const std::vector<double>& values, double bound);

/** Differences between traces of the same strokes. */
struct Differences
{
  std::vector<double> Newtons;     ///< N, between the magnitudes of the forces
  std::vector<double> Percent;     ///< %, relative to the reference's force
  std::vector<double> Sliding;     ///< %, only in ticks in which the strokes slide
  std::vector<double> Degrees;     ///< between the forces; 180 if one is 0
  std::vector<double> Millimeters; ///< mm, between the proxies
  std::vector<double> Stiffness;   ///< %, between the forces' slopes while a stroke presses

  void Add(const Stroke& stroke, const Trace& reference, const Trace& other);
};

/** A surface on which the methods are compared. */
struct Subject
{
  std::string Name;
  std::unique_ptr<Scene> TheScene;
  std::vector<Stroke> Strokes;
  Field Off; ///< distance (mm) of a position from the surface, on either side
};

/**
 * Returns the root mean square (mm) of the distance between proxy and surface, over the ticks with
 * more than LeastForce.
 */
double OffSurface(const Subject& subject, const std::vector<Trace>& traces);

/** Returns the percentage of ticks that postponed part of their motion to the next tick. */
double UnfinishedFraction(const std::vector<Trace>& traces);

/**
 * Adds a row for each friction and each method that has a surface. The reference is
 * SurfaceHaptics(). Adds a curve to the plot for each of these methods without friction: the
 * fraction of ticks below a difference of force.
 */
void CompareOn(const Subject& subject, Table& table, Plot* plot = nullptr);
/** Returns a plot without curves. */
Plot MakeLikenessPlot(const std::string& file, const std::string& surface);
/** Returns a table without rows. */
Table MakeLikenessTable();

/** Returns a plane, a ball, a cavity and a rounded edge, all with blurred edges. */
std::vector<Subject> MakeShapes();

/**
 * Returns strokes of 12 mm over bone from all sides of the upper half, 1.5 mm deep, where the
 * surface is continuous and its gradient is at least 40 HU/mm (the limit for distinct surfaces in
 * the preset "CT contrast"). One subject uses the isosurface of the original scan, the other that
 * of the scan smoothed by PRECISE's weights. Without a volume or such a surface, returns nothing,
 * and `error` describes the reason and the cure.
 */
std::vector<Subject> MakeBone(
  vtkImageData* volume, double isoValue, const Effort& effort, std::string& error);

} // namespace evaluation

#endif
