// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects PRECISE to reach every figure of the specification on a reduced run. PAPER must miss some
 * figures, which shows that they can fail.
 */

#include "Figure.h"

#include <gtest/gtest.h>

using namespace evaluation;
using namespace VolumeHaptics;

namespace
{
using Measure = Figures (*)(const Candidate&, const Effort&);

struct Subject
{
  const char* Name;
  Measure Figures;
  bool PaperFails; ///< whether PAPER misses at least one of the figures
};

std::ostream& operator<<(std::ostream& os, const Subject& subject)
{
  return os << subject.Name;
}

class EvaluationFigures : public testing::TestWithParam<std::tuple<Subject, GradientEstimator>>
{
};

TEST_P(EvaluationFigures, AreReachedByPrecise)
{
  const auto& [subject, estimator] = this->GetParam();
  for (const Figure& figure : subject.Figures({ HapticSolver::Precise, estimator }, {}))
  {
    EXPECT_TRUE(figure.IsReached()) << figure.Name << ": " << figure.Value << " " << figure.Unit
                                    << " is not below " << figure.Bound;
  }
}

TEST_P(EvaluationFigures, AreReachedWithThePapersSurfaces)
{
  const auto& [subject, estimator] = this->GetParam();
  const Candidate candidate = PlacedAsThePaper({ HapticSolver::Precise, estimator });
  for (const Figure& figure : subject.Figures(candidate, {}))
  {
    EXPECT_TRUE(figure.IsReached()) << figure.Name << ": " << figure.Value << " " << figure.Unit
                                    << " is not below " << figure.Bound;
  }
}

// With constant functions, the far side's materials equal those of the closed forms.
TEST_P(EvaluationFigures, AreReachedWithTheFarSide)
{
  const auto& [subject, estimator] = this->GetParam();
  const Candidate candidate{ HapticSolver::Precise, estimator, MaterialPlacement::FarSide,
    ContactAlignment::Distinctness };
  for (const Figure& figure : subject.Figures(candidate, {}))
  {
    EXPECT_TRUE(figure.IsReached()) << figure.Name << ": " << figure.Value << " " << figure.Unit
                                    << " is not below " << figure.Bound;
  }
}

TEST_P(EvaluationFigures, TellPaperFromPrecise)
{
  const auto& [subject, estimator] = this->GetParam();
  bool fails = false;
  for (const Figure& figure : subject.Figures({ HapticSolver::Paper, estimator }, {}))
  {
    fails = fails || !figure.IsReached();
  }
  EXPECT_EQ(fails, subject.PaperFails);
}

const Subject Subjects[] = {
  { "ClosedForms", MeasureClosedForms, true },
  { "Tracking", MeasureTracking, true },
  { "FallThrough", MeasureFallThrough, true },
  { "Ripple", MeasureRipple, false },
  { "Energy", MeasureEnergy, true },
  { "Angle", MeasureAngle, true },
  { "Alignment", MeasureAlignment, true },
  { "Bumps", MeasureBumps, true },
  { "MovingWall", MeasureMovingWall, true },
};

INSTANTIATE_TEST_SUITE_P(All, EvaluationFigures,
  testing::Combine(testing::ValuesIn(Subjects),
    testing::Values(GradientEstimator::Gaussian, GradientEstimator::CubicBSpline)),
  [](const testing::TestParamInfo<EvaluationFigures::ParamType>& info)
  {
    return std::string(std::get<0>(info.param).Name) +
      (std::get<1>(info.param) == GradientEstimator::Gaussian ? "Gaussian" : "CubicBSpline");
  });
} // namespace
