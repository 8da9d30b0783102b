// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The closed forms are played twice: by the module, and by the reference, which has to earn its
 * trust.
 */
#ifndef ClosedForms_h
#define ClosedForms_h

#include "SampledImage.h"
#include "Scene.h"

#include <gtest/gtest.h>

#include <tuple>

namespace reference
{
enum class Player
{
  Module,
  Reference
};

class ClosedForms : public testing::TestWithParam<std::tuple<Player, Estimator>>
{
protected:
  /// k = 500 N/m, T_N = 2 N, W_d = 1, R = mu = 0 in a field around the origin; the path has one
  /// point.
  void Begin(double halfSize, const Field& field, const Vec3& start, double spacing = 1.0);

  Trace Play();

  Scene TheScene;
};

inline std::string PlayerName(const testing::TestParamInfo<std::tuple<Player, Estimator>>& info)
{
  static const char* const players[] = { "Module", "Reference" };
  static const char* const estimators[] = { "CentralDifference", "Gaussian", "CubicBSpline" };
  return std::string(players[int(std::get<0>(info.param))]) +
    estimators[int(std::get<1>(info.param))];
}

inline const auto AllPlayers = testing::Combine(
  testing::Values(Player::Module, Player::Reference), testing::ValuesIn(AllEstimators));
} // namespace reference

#endif
