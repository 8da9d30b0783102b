// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture that runs solver PRECISE on a field, with each estimator as a parameter. */
#ifndef Evaluation_RobustnessRig_h
#define Evaluation_RobustnessRig_h

#include "Figure.h"

#include <gtest/gtest.h>

namespace evaluation
{
class Robustness : public testing::TestWithParam<VolumeHaptics::GradientEstimator>
{
protected:
  Trace Feel(const Field& field, const Sampling& sampling,
    const VolumeHaptics::HapticMaterial& material, const Path& path)
  {
    const Volume volume(field, sampling);
    return Play(*volume.Bake(
                  TouchingOf({ VolumeHaptics::HapticSolver::Precise, this->GetParam() }, material)),
      path);
  }
};

inline Path Press(double depth, double step = 0.05)
{
  Path path = { { 0.3, 0.2, -8.0 } };
  MoveTo(path, { 0.3, 0.2, depth }, step);
  return path;
}

inline const auto AllEstimators =
  testing::Values(VolumeHaptics::GradientEstimator::CentralDifference,
    VolumeHaptics::GradientEstimator::Gaussian, VolumeHaptics::GradientEstimator::CubicBSpline);
} // namespace evaluation

#endif
