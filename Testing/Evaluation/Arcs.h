// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Strokes along the surfaces of a scan. Each stroke lies in a plane and follows the surface's
 * course.
 */
#ifndef Evaluation_Arcs_h
#define Evaluation_Arcs_h

#include "Figure.h"

#include <vector>

class vtkImageData;

namespace evaluation
{

/** Depth (mm) of an arc below the smoothed course of the surface. */
constexpr double ArcDepth = 2.0;

/** A stroke at 50 mm/s along a surface, at constant depth under its smoothed course. */
struct Arc
{
  Path Tips;               ///< mm, one per tick
  std::size_t Pressed = 0; ///< number of tips that press before the stroke begins
  Vector3 Middle;          ///< mm: origin of the rays that search for the surface

  /** Returns the first tick that is evaluated, 200 ticks after the stroke's beginning. */
  std::size_t GetSettled() const { return this->Pressed + 200; }
};

/** Describes the surface of a scan, and the rays that search for it. */
struct Course
{
  double Level = 0.0; ///< value of the surface
  /// depth (mm) added to the first press, to pass through tissue above the surface
  double Beyond = 0.0;
  std::vector<Vector3> Middles; ///< mm: origin of the rays in each plane
  Vector3 Side = { 1.0, 0.0, 0.0 };
  /// unit vector, perpendicular to Side; Side and Up span the planes
  Vector3 Up = { 0.0, 1.0, 0.0 };
  double FirstAngle = 0.0; ///< angle between the first ray and Side, towards Up
  double LastAngle = 6.283185307179586;
  double Radius = 80.0; ///< mm: approximate radius of the surface
  /**
   * If true, the surface is the first place outwards from the middle where the value falls below
   * the level for at least 2 mm. If false, it is the outermost place where the value reaches the
   * level for at least 4 mm inwards, which excludes a head rest.
   */
  bool IsSeenFromInside = false;
};

/** Returns the course around a head: planes perpendicular to z in the upper half of its height. */
Course AroundHead(vtkImageData* volume, double level, double beyond, const Effort& effort);

/**
 * Returns arcs of at least 30 mm. An arc ends where the surface jumps (at ears). Returns no arcs if
 * the volume can't be touched.
 */
std::vector<Arc> FindArcs(vtkImageData* volume, const Course& course);

} // namespace evaluation

#endif
