// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether a hand can tell a method from proxy-based surface haptics: differences beside what people
 * notice.
 *
 * Just noticeable are differences of 7 to 10 % of a force (Jones 1989; Pang, Tan and Durlach 1991),
 * of 8 to 22 % of a stiffness (Tan et al. 1995) and of some 25 degrees of a force's direction
 * (Barbagli et al. 2006). They were found for steady forces, one after the other: they say nothing
 * about vibration.
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
constexpr Thresholds ForceThresholds{ 7.0, 10.0 };     // %
constexpr Thresholds StiffnessThresholds{ 8.0, 22.0 }; // %
constexpr double DirectionThreshold = 25.0;            // degrees
/** Below this force (N) of the reference a tick is not compared: the hand does not press. */
constexpr double LeastForce = 0.1;

struct Spread
{
  double RootMeanSquare = 0.0;
  double Median = 0.0;
  double P95 = 0.0; ///< the 95th percentile
};
Spread SpreadOf(std::vector<double> values);
/** The share (%) of values below a bound. */
double FractionBelow(const std::vector<double>& values, double bound);

/** How far traces of the same strokes differ. */
struct Differences
{
  std::vector<double> Newtons;     ///< of the magnitudes of the force
  std::vector<double> Percent;     ///< the same beside the reference's force
  std::vector<double> Sliding;     ///< of these, the ticks at which strokes slide
  std::vector<double> Degrees;     ///< between the forces; 180 if one is 0
  std::vector<double> Millimeters; ///< between the proxies
  std::vector<double> Stiffness;   ///< %, between the forces' slopes while a stroke presses

  void Add(const Stroke& stroke, const Trace& reference, const Trace& other);
};

/** A surface to compare on. */
struct Subject
{
  std::string Name;
  std::unique_ptr<Scene> TheScene;
  std::vector<Stroke> Strokes;
  Field Off; ///< how far (mm) a position is off the surface, in either direction
};

/**
 * Root mean square (mm), over the ticks with more than LeastForce, of how far the proxy is off the
 * surface.
 */
double OffSurface(const Subject& subject, const std::vector<Trace>& traces);

/** The share (%) of ticks that left a part of their motion to the next. */
double UnfinishedFraction(const std::vector<Trace>& traces);

/**
 * Adds a row for each friction and each method that has a surface; the reference is
 * SurfaceHaptics(). A plot gets a curve for each of these methods, without friction: the fraction
 * of ticks below a difference of force.
 */
void CompareOn(const Subject& subject, Table& table, Plot* plot = nullptr);
/** The plot without curves. */
Plot MakeLikenessPlot(const std::string& file, const std::string& surface);
/** The table without rows. */
Table MakeLikenessTable();

/** Plane, ball, cavity and rounded edge, all as blurred edges. */
std::vector<Subject> MakeShapes();

/**
 * Bone. Strokes of 12 mm from all sides of the upper half, 1.5 mm deep, wherever the surface goes
 * on and its gradient is at least the 40 HU/mm from which the preset "CT contrast" holds it for
 * distinct: on the isosurface as it is, and on that of the scan smoothed by the weights with which
 * PRECISE reads it. Empty, with the reason and the cure in `error`, if there is no volume or no
 * such surface.
 */
std::vector<Subject> MakeBone(
  vtkImageData* volume, double isoValue, const Effort& effort, std::string& error);

} // namespace evaluation

#endif
