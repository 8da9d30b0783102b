// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a hand explores a tissue to tell which it is, and whether it can: presses, strokes, then
 * presses until the tissue yields.
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
  ConstantForce, ///< 1 N, or 10 mm deep where nothing holds that
  ConstantDepth  ///< 2 mm
};

const char* NameOf(HandStrategy strategy);

/** Where a hand begins. */
struct Spot
{
  Vector3 Surface;    ///< mm
  Vector3 Inward;     ///< unit
  Vector3 Along;      ///< unit, at a right angle
  double Above = 0.0; ///< mm, how far outside of the surface the hand begins
};

/**
 * The cues of a spot: the depth (mm) under constant force, or the force (N) at constant depth; the
 * force against the stroke (N); and the force (N) at which the tissue yields, 4 N at most.
 */
std::vector<double> Palpate(
  const VolumeHaptics::HapticModel& model, const Spot& spot, HandStrategy strategy);

/** A hand with a Weber fraction for these cues. */
IdealHand MakeHand(HandStrategy strategy, double weberFraction = 0.1);

/** Air above a tissue of one value: the edge has a scale of one voxel of 1 mm. */
vtkSmartPointer<vtkImageData> MakeSlab(double outside, double inside);
/** On that slab. */
Spot OnSlab();

/** A table of confusions, and how many tissues are named right under each strategy. */
struct Identification
{
  Table Confusions;
  std::vector<double> Correct;
  std::size_t Tissues = 0;
};

/** The tissues of a preset for CT, each on a slab of its value under air. */
Identification IdentifyOnSlabs(const std::string& preset);

/**
 * Skin, muscle, fluid and bone where they are in a head CT: on its scalp and skull, and at random
 * places at which 4 mm around are of one tissue. The surfaces are those of FindHeadSurfaces().
 */
Identification IdentifyOnHead(
  const std::vector<FeltSurface>& surfaces, const std::string& preset, const Effort& effort);

} // namespace evaluation

#endif
