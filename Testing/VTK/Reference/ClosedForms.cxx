// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ClosedForms.h"

namespace reference
{
void ClosedForms::Begin(double halfSize, const Field& field, const Vec3& start, double spacing)
{
  this->TheScene.image = Sample(Cube(halfSize, spacing), field);
  this->TheScene.estimator = std::get<1>(this->GetParam());
  this->TheScene.path = { start };
  SetMaterial(this->TheScene, 500.0, 0.0, 0.0, 2.0);
}

Trace ClosedForms::Play()
{
  return std::get<0>(this->GetParam()) == Player::Module ? RunFilter(this->TheScene)
                                                         : RunReference(this->TheScene);
}
} // namespace reference
