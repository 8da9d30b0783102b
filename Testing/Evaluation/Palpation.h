// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simulates how a hand explores a tissue, and whether it can recognise the tissue: the hand
 * presses, strokes, and then presses until the tissue yields.
 */
#ifndef Evaluation_Palpation_h
#define Evaluation_Palpation_h

#include "Feel.h"
#include "IdealHand.h"

namespace evaluation
{

/** How a hand presses while it strokes. */
enum class HandStrategy
{
  ConstantForce, ///< 1 N, or a depth of 10 mm where no surface resists with 1 N
  ConstantDepth  ///< 2 mm deep
};

const char* NameOf(HandStrategy strategy);

/** Position and direction in which a hand starts. */
struct Spot
{
  Vector3 Surface;    ///< mm
  Vector3 Inward;     ///< unit
  Vector3 Along;      ///< unit vector, perpendicular to Inward
  double Above = 0.0; ///< mm outside of the surface: start of the hand
};

/**
 * Returns the cues of a spot: the depth (mm) under constant force, or the force (N) at constant
 * depth; the force against the stroke (N); and the force (N) at which the tissue yields, at most
 * 4 N.
 */
std::vector<double> Palpate(
  const VolumeHaptics::HapticModel& model, const Spot& spot, HandStrategy strategy);

/** Returns an ideal hand for the cues of Palpate(), with a Weber fraction. */
IdealHand MakeHand(HandStrategy strategy, double weberFraction = 0.1);

/** Returns air above a tissue of one value. The edge has a scale of 1 mm, which is one voxel. */
vtkSmartPointer<vtkImageData> MakeSlab(double outside, double inside);
/** Returns a spot on the surface of MakeSlab(). */
Spot OnSlab();

/** A table of confusions, and the number of correctly identified tissues for each strategy. */
struct Identification
{
  Table Confusions;
  std::vector<double> Correct;
  std::size_t Tissues = 0;
};

/** Identifies the tissues of a CT preset, each on a slab of its value under air. */
Identification IdentifyOnSlabs(const std::string& preset);

/**
 * Identifies skin, muscle, fluid and bone in a head CT: on its scalp and skull, and at random
 * places at least 4 mm inside one tissue. The surfaces are those of FindHeadSurfaces().
 */
Identification IdentifyOnHead(
  const std::vector<FeltSurface>& surfaces, const std::string& preset, const Effort& effort);

} // namespace evaluation

#endif
