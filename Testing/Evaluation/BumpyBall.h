// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures where the default settings place the surface of a bumpy ball, whose true surface
 * is known.
 *
 * The value is 100 (1 + tanh((90 + 2 sin(x/5) cos(y/6) - r) / 2)) at a distance r from the middle,
 * in voxels of 1 mm. The true surface has the value 100, where the edge is steepest.
 */
#ifndef Evaluation_BumpyBall_h
#define Evaluation_BumpyBall_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** Returns the value of the ball at a position (mm). */
double BumpyBallValue(const Vector3& x);

struct SurfacePoint
{
  Vector3 Position;
  Vector3 Outward; ///< unit normal
};

/** Returns the point of the true surface nearest to a position some mm away, by Newton's method. */
SurfacePoint NearestOnBumpyBall(const Vector3& x);

/** Results of strokes over the ball at a depth of 2 mm. */
struct BumpyBallFeel
{
  double Distance = 0.0; ///< voxels: mean distance between proxy and true surface
  double Angle = 0.0;    ///< degrees: mean angle between frictionless force and true normal
  std::size_t Ticks = 0; ///< number of ticks with force
};

/** Measures a filter's settings on the ball. Sets the filter's input. */
BumpyBallFeel FeelBumpyBall(vtkVolumeHapticsFilter* filter, const Effort& effort);

/** Compares the default settings, the other contact alignments, and PAPER. */
Table CompareOnBumpyBall(const Effort& effort);

/** Returns the results of the default settings as figures with bounds. */
Figures MeasureBumpyBall(const Effort& effort);

} // namespace evaluation

#endif
