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

/** Ways in which a hand presses while it strokes. */
enum class HandStrategy
{
  ConstantForce, ///< 1 N, or a depth of 10 mm where no surface holds 1 N
  ConstantDepth  ///< 2 mm deep
};

const char* NameOf(HandStrategy strategy);

/** Start of a hand. */
struct Spot
{
  Vector3 Surface;    ///< mm
  Vector3 Inward;     ///< unit
  Vector3 Along;      ///< unit, perpendicular to Inward
  double Above = 0.0; ///< mm outside of the surface: start of the hand
};

/**
 * Returns the cues of a spot: the depth (mm) under constant force, or the force (N) at constant
 * depth; the force against the stroke (N); and the force (N) at which the tissue yields, at most
 * 4 N.
 */
std::vector<double> Palpate(
  const VolumeHaptics::HapticModel& model, const Spot& spot, HandStrategy strategy);

/** Returns a hand with a Weber fraction for these cues. */
IdealHand MakeHand(HandStrategy strategy, double weberFraction = 0.1);

/** Returns air above a tissue of one value. The edge has a scale of one voxel of 1 mm. */
vtkSmartPointer<vtkImageData> MakeSlab(double outside, double inside);
/** Returns a spot on that slab. */
Spot OnSlab();

/**
 * A table of confusions, and the number of tissues that are named correctly under each strategy.
 */
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
 * places surrounded by 4 mm of one tissue. The surfaces are those of FindHeadSurfaces().
 */
Identification IdentifyOnHead(
  const std::vector<FeltSurface>& surfaces, const std::string& preset, const Effort& effort);

} // namespace evaluation

#endif
