// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldStep_h
#define FieldStep_h

#include "Core/Field/FieldSampler.h"

namespace VolumeHaptics
{

/**
 * A moving volume at two instants between the same two time steps. The results equal those of two
 * FieldAtTime objects, to the bit, but cost less, because both instants read the same samples, and
 * the samples of the last gradient are stored. Neither instant may coincide with a time step.
 */
class FieldStep
{
public:
  /**
   * Stores references to the time steps, whose samples must be blended, and to a memory.
   * @param before, now fractions of the second time step, more than 0 and less than 1
   */
  FieldStep(const FieldSampler& first, const FieldSampler& second, double before, double now,
    TickMemory& memory) noexcept
    : First(first)
    , Second(second)
    , Before(before)
    , Now(now)
    , Memory(memory)
  {
  }

  bool IsInside(const Vector3& index) const noexcept { return this->First.IsInside(index); }

  /**
   * Returns value and gradient at the later instant. Call this function first, because it reads the
   * samples that the other functions use.
   */
  FieldSample Gradient(const Vector3& index) noexcept
  {
    const FieldSampler::OtherTimeStep now = this->GetNow();
    // Blended time steps use no memory of one time step.
    const FieldSample sample =
      this->First.Gradient(now, index, { nullptr, nullptr, &this->Memory });
    this->Taps = this->First.GetTaps(now, this->Memory);
    return sample;
  }

  /** Returns the values at both instants. */
  FractionPair Values(const Vector3& index) const noexcept
  {
    const FractionPair pair = this->First.Values(this->GetNow(), this->Before, index, this->Taps);
    return { pair.Second, pair.First };
  }

  ///@{
  /** Return what FieldAtTime's functions of the same names return at the later instant. */
  double Value(const Vector3& index) const noexcept
  {
    return this->First.Value(this->GetNow(), index, this->Taps);
  }
  ValuePair Values(const Vector3& index, const Vector3& offset) const noexcept
  {
    return this->First.Values(this->GetNow(), index, offset, this->Taps);
  }
  ///@}

private:
  FieldSampler::OtherTimeStep GetNow() const noexcept { return { this->Second, this->Now, true }; }

  const FieldSampler& First;
  const FieldSampler& Second;
  const double Before;
  const double Now;
  TickMemory& Memory;
  const TimeStepTaps* Taps = nullptr;
};

} // namespace VolumeHaptics

#endif
