// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simulates a hand that knows how each tissue feels, and makes errors only because its senses
 * are coarse.
 *
 * A cue x, such as a force, is perceived as u = ln(1 + x/x0) / ln(1 + w) with Gaussian noise of
 * unit variance: w is the Weber fraction, and x0 is the floor below which the senses do not follow
 * Weber's law. So a difference of one Weber fraction has d' = 1 wherever x is far above x0. The
 * distance of two tissues is d' = |u1 - u2| over all cues. The hand names the likeliest tissue. If
 * two tissues are equally likely beforehand, the hand names the right tissue with probability
 * Phi(d'/2).
 *
 * Green and Swets, "Signal Detection Theory and Psychophysics", 1966, describe the model.
 */
#ifndef Evaluation_IdealHand_h
#define Evaluation_IdealHand_h

#include "Table.h"

#include <string>
#include <vector>

namespace evaluation
{

/**
 * The cues of a tissue at one or several places: for each place, a value (0 or more) of each cue.
 */
struct FeltTissue
{
  std::string Name;
  std::vector<std::vector<double>> Places;
};

class IdealHand
{
public:
  /** `weberFraction` is above 0. `floors` has the floor of each cue, in the cue's unit. */
  IdealHand(double weberFraction, std::vector<double> floors);

  /** Returns the perceived cue, with the noise's standard deviation as its unit. */
  double Perceive(double cue, std::size_t index) const;

  /**
   * Returns the discriminability d' of two tissues. Each tissue is represented by the mean of its
   * places.
   */
  double Distance(const FeltTissue& one, const FeltTissue& other) const;

  /**
   * Returns a matrix: the probability that the hand identifies the tissue of a row as the tissue of
   * a column. All places of a tissue are equally likely. The hand accounts for its sensory noise
   * and for the differences between a tissue's places. Uses 100 000 draws with a fixed seed, for a
   * standard error below 0.002.
   */
  std::vector<std::vector<double>> ComputeConfusion(const std::vector<FeltTissue>& tissues) const;

private:
  std::vector<double> MeanOf(const FeltTissue& tissue) const;

  double WeberFraction;
  std::vector<double> Floors;
};

/** Returns the expected number of correctly identified tissues: the sum of the diagonal. */
double CountCorrect(const std::vector<std::vector<double>>& confusion);

/** Adds a row for each tissue, in percent. */
void AddConfusion(const std::string& heading, const std::vector<FeltTissue>& tissues,
  const std::vector<std::vector<double>>& confusion, Table& table);

} // namespace evaluation

#endif
