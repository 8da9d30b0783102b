// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the default settings hold a hand on a bumpy ball, whose true surface is known.
 *
 * The value is 100 (1 + tanh((90 + 2 sin(x/5) cos(y/6) - r) / 2)) at a distance r from the middle,
 * in voxels of 1 mm: the true surface has the value 100, where the edge is steepest.
 */
#ifndef Evaluation_BumpyBall_h
#define Evaluation_BumpyBall_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** The field. */
double BumpyBallValue(const Vector3& x);

struct SurfacePoint
{
  Vector3 Position;
  Vector3 Outward; ///< unit normal
};

/** The point of the true surface that is nearest to a position some mm off, by Newton's method. */
SurfacePoint NearestOnBumpyBall(const Vector3& x);

/** Of a hand that strokes the ball, 2 mm deep. */
struct BumpyBallFeel
{
  double Distance = 0.0; ///< voxels, from the proxy to the true surface, mean magnitude
  double Angle = 0.0;    ///< degrees, of the frictionless force to the true normal, mean
  std::size_t Ticks = 0; ///< with force
};

/** With the settings of a filter, whose input it sets. */
BumpyBallFeel FeelBumpyBall(vtkVolumeHapticsFilter* filter, const Effort& effort);

/** For the default settings, each contact alignment, and PAPER. */
Table CompareOnBumpyBall(const Effort& effort);

/** The same for the default settings, as figures with bounds. */
Figures MeasureBumpyBall(const Effort& effort);

} // namespace evaluation

#endif
