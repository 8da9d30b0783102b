// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of the solver Precise from tick to tick.
 */
#ifndef PreciseState_h
#define PreciseState_h

#include "Core/Law/MaterialPoint.h"
#include "Core/Law/PassiveSpring.h"

#include <limits>

namespace VolumeHaptics
{

/** The values at both ends of a walk along the normal (FarSide.h). */
struct FarValues
{
  double Ahead = 0.0;
  double Behind = 0.0;
  /**
   * Evenness of the rise of V: 1 if V rises evenly over the whole walk, so that there is no edge; 0
   * if a plateau or another edge ends the walk on one side.
   */
  double Evenness = 0.0;
};

/** A material point with the estimator's value and its slope. */
struct PrecisePoint : MaterialPoint
{
  double Value = 0.0; ///< the estimator's own value
  double Slope = 0.0; ///< derivative of Value along the normal, per metre; 0 without a gradient
  FarValues Far;      ///< values from the last walk
  /**
   * Length (voxels) of the proxy's path over which Far remains valid; 0 if the values do not depend
   * on the path.
   */
  double FarLasts = 0.0;
};

struct PreciseState
{
  static constexpr double Unknown = std::numeric_limits<double>::max();

  /**
   * Tip of the last tick. If the tick used up its budget, the position of the tip that it has
   * reached.
   */
  Vector3 ReachedTip;
  double Level = 0.0;  ///< the estimator's value on the surface that holds the proxy
  bool IsHeld = false; ///< whether a surface holds the proxy, so that Level is valid
  PassiveSpring Spring;
  /**
   * Factor of the first step in a tick, learned from the last ticks. 1 leaves the step unchanged.
   */
  double StepPrediction = 1.0;
  PrecisePoint Here; ///< the last sampled material point
  /** Upper bound of the distance (voxels) between the proxy and the position of Here. */
  double CachedSampleDistance = Unknown;
};

} // namespace VolumeHaptics

#endif
