// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that moves, at one instant: two frames, blended.
 *
 *   V(x) = (1 - share) V_a(x) + share V_b(x)
 *
 * and its gradient alike. Where both frames have the same samples, the values are those of either
 * frame, to the bit. A volume that does not move has one frame.
 */
#ifndef FieldAtTime_h
#define FieldAtTime_h

#include "Core/Field/FieldSampler.h"

namespace VolumeHaptics
{

/** Borrows the frames, which have the same geometry. */
class FieldAtTime
{
public:
  explicit FieldAtTime(const FieldSampler& field) noexcept
    : First(field)
  {
  }
  /** @param share of the second frame, 0 to 1 */
  FieldAtTime(const FieldSampler& first, const FieldSampler& second, double share) noexcept
    : First(share < 1.0 ? first : second)
    , Second(share > 0.0 && share < 1.0 ? &second : nullptr)
    , Share(share)
  {
  }

  // As those of FieldSampler.
  double Value(const Vector3& index) const noexcept
  {
    const double value = this->First.Value(index);
    return this->Second ? this->Blend(value, this->Second->Value(index)) : value;
  }

  ValuePair Values(const Vector3& index, const Vector3& offset) const noexcept
  {
    const ValuePair values = this->First.Values(index, offset);
    if (!this->Second)
    {
      return values;
    }
    const ValuePair second = this->Second->Values(index, offset);
    return { this->Blend(values.Ahead, second.Ahead), this->Blend(values.Behind, second.Behind) };
  }

  FieldSample Gradient(const Vector3& index) const noexcept
  {
    return this->Second ? this->Blend(this->ReadFrames(index)) : this->First.Gradient(index);
  }

  ///@{
  /** Two instants between the same frames may share what is read of them. */
  struct FramePair
  {
    FieldSample First;
    FieldSample Second;
  };
  bool HasFramesOf(const FieldAtTime& other) const noexcept
  {
    return this->Second && this->Second == other.Second && &this->First == &other.First;
  }
  FramePair ReadFrames(const Vector3& index) const noexcept
  {
    return { this->First.Gradient(index), this->Second->Gradient(index) };
  }
  FieldSample Blend(const FramePair& pair) const noexcept
  {
    const auto& [first, second] = pair;
    return { this->Blend(first.Value, second.Value),
      first.Gradient + this->Share * (second.Gradient - first.Gradient) };
  }
  ///@}

  bool IsInside(const Vector3& index) const noexcept { return this->First.IsInside(index); }

private:
  double Blend(double first, double second) const noexcept
  {
    return first + this->Share * (second - first);
  }

  const FieldSampler& First;
  const FieldSampler* const Second = nullptr; ///< null if the instant is that of a frame
  const double Share = 0.0;
};

} // namespace VolumeHaptics

#endif
