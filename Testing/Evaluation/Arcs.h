// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Strokes along the surfaces of a scan, which lie in planes and follow the surface's course.
 */
#ifndef Evaluation_Arcs_h
#define Evaluation_Arcs_h

#include "Figure.h"

#include <vector>

class vtkImageData;

namespace evaluation
{

/** How deep (mm) under the smoothed course of the surface an arc lies. */
constexpr double ArcDepth = 2.0;

/** A stroke along a surface at constant depth under its smoothed course, at 50 mm/s. */
struct Arc
{
  Path Tips;               ///< mm, one a tick
  std::size_t Pressed = 0; ///< how many of these press, before the others stroke
  Vector3 Middle;          ///< mm, where the rays to the surface begin

  /** The first tick that is judged: the stroke begins 200 ticks before. */
  std::size_t GetSettled() const { return this->Pressed + 200; }
};

/** The surface of a scan, and the rays on which it is looked for. */
struct Course
{
  double Level = 0.0; ///< value of the surface
  /// mm, by how much deeper the hand first presses, through what lies above the surface
  double Beyond = 0.0;
  std::vector<Vector3> Middles; ///< mm, a plane of rays begins at each
  Vector3 Side = { 1.0, 0.0, 0.0 };
  Vector3 Up = { 0.0, 1.0, 0.0 }; ///< with Side, spans the planes: unit vectors at right angles
  double FirstAngle = 0.0;        ///< of a ray to Side, towards Up
  double LastAngle = 6.283185307179586;
  double Radius = 80.0; ///< mm, about that of the surface
  /**
   * Whether the surface is the first at which the value falls below the level, seen from the
   * middle, and stays below for 2 mm; else it is the outermost at which the level is reached, and
   * stays so for 4 mm inwards: a head rest is thinner.
   */
  bool IsSeenFromInside = false;
};

/** The course around a head: planes at right angles to z in the upper half of its height. */
Course AroundHead(vtkImageData* volume, double level, double beyond, const Effort& effort);

/**
 * Arcs of 30 mm at least. They end where the surface leaps (ears). None if the volume can't be
 * touched.
 */
std::vector<Arc> FindArcs(vtkImageData* volume, const Course& course);

} // namespace evaluation

#endif
