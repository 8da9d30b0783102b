// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The closed forms of Documentation/evaluation.md, with the exact force at every tick, even
 * where PAPER deviates from it.
 */
#ifndef Evaluation_ClosedForms_h
#define Evaluation_ClosedForms_h

#include "Figure.h"

namespace evaluation
{

struct Form
{
  std::string Name;
  Field TheField;
  VolumeHaptics::HapticMaterial Material;
  Path Tips;
  std::vector<Vector3> Forces; ///< N, one per tick
  std::size_t FirstJudged = 0; ///< first tick for which the closed form is valid
  /**
   * If true, the form is valid for alignment Distinctness with kernel materials: see
   * PlacedAsThePaper().
   */
  bool IsOfThePaper = false;
};

/** Returns the closed forms, among T1 to T13, that predict a force in a sampled field. */
std::vector<Form> MakeForms(const Effort& effort);

/** Errors, as fractions of the largest force of the closed form. */
struct ForceError
{
  double RootMeanSquare = 0.0;
  double Worst = 0.0;
};

ForceError Compare(const Form& form, const Volume& volume, const Candidate& candidate);

} // namespace evaluation

#endif
