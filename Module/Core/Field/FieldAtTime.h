// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The field of a moving volume at one instant: a blend of two time steps,
 *
 *   V(x) = V_a(x) + share (V_b(x) - V_a(x))
 *
 * and its gradient likewise. If the motion of the material is known (DisplacementField.h), the
 * blend is
 *
 *   V(x) = V_a(X) + share (V_b(X + u(X)) - V_a(X)),   X + share u(X) = x.
 *
 * Where both time steps have the same samples, the blend equals either time step, to the bit,
 * unless the material moves elsewhere. A volume that does not move has one time step.
 */
#ifndef FieldAtTime_h
#define FieldAtTime_h

#include "Core/Field/DisplacementField.h"
#include "Core/Field/FieldSampler.h"

namespace VolumeHaptics
{

/**
 * The field at one instant. Stores references to the time steps, which must have the same geometry.
 */
class FieldAtTime
{
public:
  /** @param memory stores the last gradients; may be null */
  explicit FieldAtTime(const FieldSampler& field, TickMemory* memory = nullptr) noexcept
    : First(field)
    , Memories(MakeMemories(memory, 0))
  {
  }
  /**
   * @param fraction position between the first time step (0) and the second one (1)
   * @param motion motion of the material from the first time step to the second one; null if it is
   * not known
   * @param memory stores the last gradients; may be null
   * @param timeStep index of the first time step, for the memory
   */
  FieldAtTime(const FieldSampler& first, const FieldSampler& second, double fraction,
    const DisplacementField* motion = nullptr, TickMemory* memory = nullptr,
    std::size_t timeStep = 0) noexcept
    : FieldAtTime(
        first, { second, fraction, first.BlendsSamples(second) }, motion, memory, timeStep)
  {
  }
  /** Blends a time step with `second`. */
  FieldAtTime(const FieldSampler& first, const FieldSampler::OtherTimeStep& second,
    const DisplacementField* motion, TickMemory* memory, std::size_t timeStep) noexcept
    : First(second.Fraction < 1.0 ? first : second.Field)
    , Second(second.Fraction > 0.0 && second.Fraction < 1.0 ? &second.Field : nullptr)
    , Fraction(second.Fraction)
    , AreSamplesBlended(this->Second && second.AreSamplesBlended)
    , Motion(motion)
    , Memories(MakeMemories(memory, second.Fraction < 1.0 ? timeStep : timeStep + 1))
  {
  }

  // These functions return what FieldSampler's functions of the same names return.
  double Value(const Vector3& index) const noexcept
  {
    if (this->FollowsMaterial())
    {
      const MaterialPlace at = this->Motion->Compute(index, this->Fraction);
      return FieldSampler::Blend(this->First.Value(this->First.Nearest(at.First)),
        this->Second->Value(this->First.Nearest(at.Second)), this->Fraction);
    }
    return this->Second ? this->First.Value(this->GetOther(), index) : this->First.Value(index);
  }
  /** Returns the values at one index and two instants, faster than two calls of Value() would. */
  static FractionPair Values(
    const FieldAtTime& a, const FieldAtTime& b, const Vector3& index) noexcept
  {
    const bool isOneBlend =
      a.Second && a.Second == b.Second && !a.FollowsMaterial() && !b.FollowsMaterial();
    return isOneBlend ? a.First.Values(a.GetOther(), b.Fraction, index)
                      : FractionPair{ a.Value(index), b.Value(index) };
  }

  ValuePair Values(const Vector3& index, const Vector3& offset) const noexcept
  {
    if (this->FollowsMaterial())
    {
      return this->ValuesOfMaterial(index, offset);
    }
    return this->Second ? this->First.Values(this->GetOther(), index, offset)
                        : this->First.Values(index, offset);
  }

  FieldSample Gradient(const Vector3& index) const noexcept
  {
    if (this->FollowsMaterial())
    {
      return this->GradientOfMaterial(index);
    }
    return this->Second ? this->First.Gradient(this->GetOther(), index, this->Memories)
                        : this->First.Gradient(index, this->Memories.First);
  }

  bool IsInside(const Vector3& index) const noexcept { return this->First.IsInside(index); }

  /** Returns whether both time steps have the same value at a place, or there is only one. */
  bool IsStill(const Vector3& index) const noexcept
  {
    return !this->Second || this->First.Value(index) == this->Second->Value(index);
  }

private:
  /** Returns whether each time step is read where the material is in it. */
  bool FollowsMaterial() const noexcept { return this->Motion && this->Second; }

  FieldSampler::OtherTimeStep GetOther() const noexcept
  {
    return { *this->Second, this->Fraction, this->AreSamplesBlended };
  }

  static BlendMemories MakeMemories(TickMemory* memory, std::size_t timeStep) noexcept
  {
    return memory ? BlendMemories{ &memory->Of(timeStep), &memory->Of(timeStep + 1), memory }
                  : BlendMemories{};
  }

  FieldSample GradientOfMaterial(const Vector3& index) const noexcept
  {
    const MaterialPlace at = this->Motion->Compute(index, this->Fraction);
    const FieldSample first =
      ReadMaterial(this->First, at.First, at.FirstSlope, this->Memories.First);
    const FieldSample second =
      ReadMaterial(*this->Second, at.Second, at.SecondSlope, this->Memories.Second);
    return FieldSampler::Blend(first, second, this->Fraction);
  }

  /**
   * Reads a time step where the material is in it. The gradient is with respect to the place at the
   * instant.
   */
  static FieldSample ReadMaterial(const FieldSampler& timeStep, const Vector3& place,
    const Matrix3& slope, TapMemory* memory) noexcept
  {
    const Vector3 inside = timeStep.Nearest(place);
    const FieldSample sample = timeStep.Gradient(inside, memory);
    // Outside the border the value is constant.
    const Vector3 gradient{ inside.X == place.X ? sample.Gradient.X : 0.0,
      inside.Y == place.Y ? sample.Gradient.Y : 0.0,
      inside.Z == place.Z ? sample.Gradient.Z : 0.0 };
    return { sample.Value, Transpose(slope) * gradient };
  }

  /**
   * Returns the values on both sides of a place in the material. The offset rotates and stretches
   * with the material.
   */
  ValuePair ValuesOfMaterial(const Vector3& index, const Vector3& offset) const noexcept
  {
    const MaterialPlace at = this->Motion->Compute(index, this->Fraction);
    const ValuePair first =
      this->First.Values(this->First.Nearest(at.First), at.FirstSlope * offset);
    const ValuePair second =
      this->Second->Values(this->First.Nearest(at.Second), at.SecondSlope * offset);
    return { FieldSampler::Blend(first.Ahead, second.Ahead, this->Fraction),
      FieldSampler::Blend(first.Behind, second.Behind, this->Fraction) };
  }

  const FieldSampler& First;
  const FieldSampler* const Second = nullptr; ///< null if the instant is the time of one time step
  const double Fraction = 0.0;
  const bool AreSamplesBlended = false;
  const DisplacementField* const Motion = nullptr; ///< null if the motion is not known
  const BlendMemories Memories;
};

} // namespace VolumeHaptics

#endif
