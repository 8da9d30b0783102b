// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/HandTurn.h"

namespace VolumeHaptics
{

bool HandTurn::Update(double period, Quaternion& orientation, bool isMeasured) noexcept
{
  this->Orders.Update();
  const Wish& wish = this->Orders.Read();
  if (isMeasured)
  {
    this->Now = orientation;
    this->IsNow = true;
    return true;
  }
  if (!wish.IsThere)
  {
    this->IsNow = false;
    return false;
  }
  if (!this->IsNow)
  {
    this->Now = wish.Orientation;
    this->IsNow = true;
  }
  Quaternion turn = wish.Orientation * Conjugate(this->Now);
  turn = turn.W < 0.0 ? -1.0 * turn : turn;
  const Vector3 axis{ turn.X, turn.Y, turn.Z };
  const double sine = Norm(axis); // sine of half the remaining angle
  const double most = 0.5 * FastestTurn * period;
  if (sine <= most)
  {
    this->Now = wish.Orientation;
  }
  else
  {
    const Vector3 step = (most / sine) * axis;
    const Quaternion turned = Quaternion{ 1.0, step.X, step.Y, step.Z } * this->Now;
    this->Now = (1.0 / std::sqrt(SquaredNorm(turned))) * turned;
  }
  orientation = this->Now;
  return true;
}

} // namespace VolumeHaptics
