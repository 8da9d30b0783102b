// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A hand that knows how each tissue feels, and errs only because its senses are coarse.
 *
 * A cue x, such as a force, is perceived as u = ln(1 + x/x0) / ln(1 + w) with Gaussian noise of
 * unit variance: w is the Weber fraction, and x0 the floor under which the senses do not follow
 * Weber's law. So a difference of one Weber fraction has d' = 1, wherever x is far above x0. The
 * distance of two tissues is d' = |u1 - u2| over all cues. The hand names the likeliest tissue; of
 * two that are equally likely, the right one with probability Phi(d'/2).
 *
 * Green and Swets, "Signal Detection Theory and Psychophysics", 1966, has the model.
 */
#ifndef Evaluation_IdealHand_h
#define Evaluation_IdealHand_h

#include "Table.h"

#include <string>
#include <vector>

namespace evaluation
{

/** A tissue, as it is felt at one or several places: a value of each cue, 0 or more. */
struct FeltTissue
{
  std::string Name;
  std::vector<std::vector<double>> Places;
};

class IdealHand
{
public:
  /** A Weber fraction above 0, and the floor of each cue, in its unit. */
  IdealHand(double weberFraction, std::vector<double> floors);

  /** A cue as it is perceived: in units of the noise. */
  double Perceive(double cue, std::size_t index) const;

  /** d' of two tissues, each the mean of its places. */
  double Distance(const FeltTissue& one, const FeltTissue& other) const;

  /**
   * The probability that the tissue of a row is named as that of a column. Each place of a tissue
   * is as likely; beside the noise of the senses the hand knows how much a tissue's places differ.
   * By 100 000 draws with a fixed seed, for a standard error below 0.002.
   */
  std::vector<std::vector<double>> ComputeConfusion(const std::vector<FeltTissue>& tissues) const;

private:
  std::vector<double> MeanOf(const FeltTissue& tissue) const;

  double WeberFraction;
  std::vector<double> Floors;
};

/** The expected number of tissues that are named right: the sum of the diagonal. */
double CountCorrect(const std::vector<std::vector<double>>& confusion);

/** A row a tissue, in percent. */
void AddConfusion(const std::string& heading, const std::vector<FeltTissue>& tissues,
  const std::vector<std::vector<double>>& confusion, Table& table);

} // namespace evaluation

#endif
