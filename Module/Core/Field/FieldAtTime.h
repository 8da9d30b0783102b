// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that moves, at one instant: two frames, blended.
 *
 *   V(x) = (1 - share) V_a(x) + share V_b(x)
 *
 * and its gradient alike; or, if it is known where the material goes (DisplacementField.h),
 *
 *   V(x) = (1 - share) V_a(X) + share V_b(X + u(X)),   X + share u(X) = x.
 *
 * Where both frames have the same samples, the values are those of either
 * frame, to the bit, unless the material goes elsewhere. A volume that does not move has one frame.
 */
#ifndef FieldAtTime_h
#define FieldAtTime_h

#include "Core/Field/DisplacementField.h"
#include "Core/Field/FieldSampler.h"

namespace VolumeHaptics
{

/** Borrows the frames, which have the same geometry. */
class FieldAtTime
{
public:
  /** @param memory of the last gradient, see FieldSampler; may be null */
  explicit FieldAtTime(const FieldSampler& field, TapMemory* memory = nullptr) noexcept
    : First(field)
    , Memories{ memory, nullptr }
  {
  }
  /**
   * @param share of the second frame, 0 to 1
   * @param motion of the material from the first frame to the second one; null if it is not known
   * @param memories of each frame; may be null
   */
  FieldAtTime(const FieldSampler& first, const FieldSampler& second, double share,
    const DisplacementField* motion = nullptr, const FramePair<TapMemory*>& memories = {}) noexcept
    : First(share < 1.0 ? first : second)
    , Second(share > 0.0 && share < 1.0 ? &second : nullptr)
    , Share(share)
    , Motion(motion)
    , Memories(share < 1.0 ? memories : FramePair<TapMemory*>{ memories.Second, nullptr })
  {
  }

  // As those of FieldSampler.
  double Value(const Vector3& index) const noexcept
  {
    if (this->FollowsMaterial())
    {
      const MaterialPlace at = this->Motion->Find(index, this->Share);
      return this->Blend(this->First.Value(this->First.Nearest(at.First)),
        this->Second->Value(this->First.Nearest(at.Second)));
    }
    const double value = this->First.Value(index);
    return this->Second ? this->Blend(value, this->Second->Value(index)) : value;
  }

  /** The same where the gradient was read, which may tell it. */
  double Value(const Vector3& index, const FieldSample& there) const noexcept
  {
    return this->First.TellsValue(there) ? there.Value : this->Value(index);
  }

  ValuePair Values(const Vector3& index, const Vector3& offset) const noexcept
  {
    if (this->FollowsMaterial())
    {
      return this->ValuesOfMaterial(index, offset);
    }
    return this->Second ? this->Blend(this->First.Values(*this->Second, index, offset))
                        : this->First.Values(index, offset);
  }

  FieldSample Gradient(const Vector3& index) const noexcept
  {
    return this->Second ? this->Blend(this->ReadFrames(index))
                        : this->First.Gradient(index, this->Memories.First);
  }

  ///@{
  /**
   * Two instants between the same frames may share what is read of them, unless the material goes
   * elsewhere in between.
   */
  bool HasFramesOf(const FieldAtTime& other) const noexcept
  {
    return this->Second && !this->Motion && this->Second == other.Second &&
      &this->First == &other.First;
  }
  FramePair<FieldSample> ReadFrames(const Vector3& index) const noexcept
  {
    if (this->FollowsMaterial())
    {
      const MaterialPlace at = this->Motion->Find(index, this->Share);
      return { ReadMaterial(this->First, at.First, at.FirstSlope, this->Memories.First),
        ReadMaterial(*this->Second, at.Second, at.SecondSlope, this->Memories.Second) };
    }
    return this->First.Gradients(*this->Second, index, this->Memories);
  }
  FieldSample Blend(const FramePair<FieldSample>& pair) const noexcept
  {
    const auto& [first, second] = pair;
    return { this->Blend(first.Value, second.Value),
      first.Gradient + this->Share * (second.Gradient - first.Gradient) };
  }
  /** V of each frame where the gradients were read. */
  FramePair<double> ReadValues(
    const Vector3& index, const FramePair<FieldSample>& there) const noexcept
  {
    const bool isTold =
      this->First.TellsValue(there.First) && this->Second->TellsValue(there.Second);
    return isTold ? FramePair<double>{ there.First.Value, there.Second.Value }
                  : FramePair<double>{ this->First.Value(index), this->Second->Value(index) };
  }
  double Blend(const FramePair<double>& pair) const noexcept
  {
    return this->Blend(pair.First, pair.Second);
  }
  ///@}

  bool IsInside(const Vector3& index) const noexcept { return this->First.IsInside(index); }

private:
  /** Whether each frame is read at a place of its own. */
  bool FollowsMaterial() const noexcept { return this->Motion && this->Second; }

  /** A frame at the place that stands for another one, with the gradient there. */
  static FieldSample ReadMaterial(const FieldSampler& frame, const Vector3& place,
    const Matrix3& slope, TapMemory* memory) noexcept
  {
    const Vector3 inside = frame.Nearest(place);
    const FieldSample sample = frame.Gradient(inside, memory);
    // Beyond the border, the value does not change.
    const Vector3 gradient{ inside.X == place.X ? sample.Gradient.X : 0.0,
      inside.Y == place.Y ? sample.Gradient.Y : 0.0,
      inside.Z == place.Z ? sample.Gradient.Z : 0.0 };
    return { sample.Value, Transpose(slope) * gradient };
  }

  /** The offset turns and stretches with the material. */
  ValuePair ValuesOfMaterial(const Vector3& index, const Vector3& offset) const noexcept
  {
    const MaterialPlace at = this->Motion->Find(index, this->Share);
    const ValuePair first =
      this->First.Values(this->First.Nearest(at.First), at.FirstSlope * offset);
    const ValuePair second =
      this->Second->Values(this->First.Nearest(at.Second), at.SecondSlope * offset);
    return this->Blend(FramePair<ValuePair>{ first, second });
  }

  ValuePair Blend(const FramePair<ValuePair>& pair) const noexcept
  {
    const auto& [first, second] = pair;
    return { this->Blend(first.Ahead, second.Ahead), this->Blend(first.Behind, second.Behind) };
  }
  double Blend(double first, double second) const noexcept
  {
    return first + this->Share * (second - first);
  }

  const FieldSampler& First;
  const FieldSampler* const Second = nullptr; ///< null if the instant is that of a frame
  const double Share = 0.0;
  const DisplacementField* const Motion = nullptr; ///< null if it is not known
  const FramePair<TapMemory*> Memories;            ///< may be null
};

} // namespace VolumeHaptics

#endif
