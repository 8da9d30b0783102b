// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures a tip that circles inside a spherical wall of 20 voxels, 2 voxels deep, at 0.2 m/s.
 */
#ifndef Evaluation_Tracking_h
#define Evaluation_Tracking_h

#include "Figure.h"

namespace evaluation
{

constexpr double SphereRadius = 20.0; // mm, with voxels of 1 mm
/** Number of ticks per turn: 0.2 mm per tick. */
constexpr int TicksPerTurn = 565;

struct Wall
{
  std::string Name;
  std::function<double(double)> TheField; ///< field, as a function of the radius
  VolumeHaptics::ScalarType Type;
  double TipRadius;    ///< mm, radius of the tip's circle
  bool IsEdge = false; ///< plateau on each side of an edge; otherwise a ramp
};

/** Returns the balls and cavities to track. */
std::vector<Wall> GetWalls();

/** Returns the proxy's radius (mm) after each tick. */
std::vector<double> TrackSphere(const Candidate& candidate, const Wall& wall, int turns);

} // namespace evaluation

#endif
