// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values and gradients of a volume at continuous positions.
 *
 * The kernels are compiled once for each instruction set, in separate translation units, and chosen
 * at run time, so that the code around them (and VTK) needs only the baseline. All variants carry
 * out the same operations in the same order, without fused multiply-add, so that a trace does not
 * depend on the processor.
 */
#ifndef FieldSampler_h
#define FieldSampler_h

#include "Core/Field/CarvedSamples.h"
#include "Core/Field/GradientKernel.h"
#include "Core/Field/TapMemory.h"
#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

struct FieldSample
{
  /**
   * The estimator's own (smoothed) value. With CubicBSpline and with
   * GaussianWeights::OwnDerivative, the gradient is its derivative. Otherwise the value only shows
   * how large values are.
   */
  double Value = 0.0;
  /** Derivative per index step, along the index axes. */
  Vector3 Gradient;
};

/** The samples and the weights of a kernel. Owns none of them. */
struct FieldView
{
  /** The samples. Data points to the volume's first sample, even if only a region is resident. */
  VolumeView Volume;
  KernelView Kernel;
  double First[3] = { 0.0, 0.0, 0.0 }; ///< smallest resident index along each axis
  double Last[3] = { 0.0, 0.0, 0.0 };  ///< largest resident index along each axis
  std::uint64_t Number = 0;            ///< unique number of the field
};

/** The values on both sides of a position, at +offset and -offset. A tick always needs both. */
struct ValuePair
{
  double Ahead;
  double Behind;
};

/** Two time steps, blended. Fraction (0 to 1) is the weight of the second one. */
struct TimeStepBlend
{
  const FieldView& First;
  const FieldView& Second;
  double Fraction;
};

/** The values of a blend for two fractions. */
struct FractionPair
{
  double First = std::numeric_limits<double>::quiet_NaN();
  double Second = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Memories in which ticks keep samples for later ticks. First and Second are for time steps that
 * are read separately. All may be null.
 */
struct BlendMemories
{
  TapMemory* First = nullptr;
  TapMemory* Second = nullptr;
  TickMemory* Tick = nullptr;
};

// Positions are passed as three numbers, which the compiler keeps in registers.
using ValueFunction = double (*)(const FieldView&, double x, double y, double z) noexcept;
using PairFunction = ValuePair (*)(
  const FieldView&, double x, double y, double z, double dx, double dy, double dz) noexcept;
using GradientFunction = FieldSample (*)(const FieldView&, double x, double y, double z) noexcept;
///@{
/**
 * Types of the same functions for a blend of two time steps with the same geometry, type and
 * kernel.
 */
using BlendedValueFunction = double (*)(
  const TimeStepBlend&, double x, double y, double z) noexcept;
using SharedValuesFunction = FractionPair (*)(
  const TimeStepBlend&, double fraction, double x, double y, double z) noexcept;
using BlendedPairFunction = ValuePair (*)(
  const TimeStepBlend&, double x, double y, double z, double dx, double dy, double dz) noexcept;
using BlendedGradientFunction = FieldSample (*)(
  const TimeStepBlend&, double x, double y, double z, const BlendMemories& memories) noexcept;
///@}
///@{
/**
 * Types of the same functions for values of a blend that are read from a memory of both time steps.
 */
using TapValueFunction = double (*)(
  const TimeStepTaps&, const FieldView&, double fraction, double x, double y, double z) noexcept;
using SharedTapValuesFunction = FractionPair (*)(const TimeStepTaps&, const FieldView&,
  const FractionPair& fractions, double x, double y, double z) noexcept;
using TapPairFunction = ValuePair (*)(const TimeStepTaps&, const FieldView&, double fraction,
  double x, double y, double z, double dx, double dy, double dz) noexcept;
///@}
/**
 * Reads all taps into a memory, beginning with the tap at `first`. Returns false if some taps are
 * outside the samples.
 */
using FillFunction = bool (*)(
  const VolumeView&, const std::int64_t* first, TapMemory& memory) noexcept;
/**
 * Computes the gradient from the taps in a memory, which it fills first if necessary. Returns false
 * if a memory can't be used for this gradient.
 */
using RememberedFunction = bool (*)(const FieldView&, double x, double y, double z, FillFunction,
  TapMemory& memory, FieldSample& sample) noexcept;

/** The kernels for one scalar type and one estimator. Any except the first three may be null. */
struct FieldFunctions
{
  ValueFunction Value = nullptr;
  PairFunction Pair = nullptr;
  GradientFunction Gradient = nullptr;
  BlendedValueFunction BlendedValue = nullptr;
  /** Values at one position for the blend's fraction and for another fraction. */
  SharedValuesFunction SharedValues = nullptr;
  BlendedPairFunction BlendedPair = nullptr;
  /** The blended gradient; null for kernels with many taps. */
  BlendedGradientFunction BlendedGradient = nullptr;
  ///@{
  /** Functions for gradients from a memory; null for estimators that it does not make faster. */
  FillFunction Fill = nullptr;
  RememberedFunction Remembered = nullptr;
  ///@}
  ///@{
  /**
   * Functions for values from a memory of both time steps; null for estimators without this memory,
   * or whose values are not trilinear.
   */
  TapValueFunction TapValue = nullptr;
  SharedTapValuesFunction SharedTapValues = nullptr;
  TapPairFunction TapPair = nullptr;
  ///@}
};

enum class InstructionSet : std::uint8_t
{
  Baseline,
  AVX2
};

/** Returns the best instruction set for which kernels were compiled and that this processor has. */
InstructionSet DetectInstructionSet();

/**
 * Samples a volume with an estimator. The caller owns the samples, the kernel's table and the
 * remaining fractions of tissue.
 */
class FieldSampler
{
public:
  /** Another time step of the volume, and its weight in the blend, from 0 to 1. */
  struct OtherTimeStep
  {
    const FieldSampler& Field;
    double Fraction;
    bool AreSamplesBlended; ///< whether BlendsSamples() holds for this time step
  };

  FieldSampler() = default;
  FieldSampler(const VolumeView& view, const GradientKernel& kernel,
    InstructionSet instructions = DetectInstructionSet());
  FieldSampler(const VolumeView& view, const GradientKernel& kernel, const CarvedView& carved,
    InstructionSet instructions = DetectInstructionSet());

  /**
   * Returns V at a continuous index, which is clamped to the resident samples. Returns BorderValue
   * if a sample is not finite.
   */
  double Value(const Vector3& index) const noexcept
  {
    if (this->Carved.HasAny())
    {
      return this->Checked(this->CarvedValue(index));
    }
    return this->Checked(this->Functions.Value(this->View, index.X, index.Y, index.Z));
  }

  /** Returns V at index + offset and at index - offset, faster than two calls of Value() would. */
  ValuePair Values(const Vector3& index, const Vector3& offset) const noexcept
  {
    if (this->Carved.HasAny())
    {
      return { this->Checked(this->CarvedValue(index + offset)),
        this->Checked(this->CarvedValue(index - offset)) };
    }
    const ValuePair pair =
      this->Functions.Pair(this->View, index.X, index.Y, index.Z, offset.X, offset.Y, offset.Z);
    return { this->Checked(pair.Ahead), this->Checked(pair.Behind) };
  }

  /**
   * Returns value and gradient at a continuous index, which must be inside. They may be NaN. With a
   * memory, this is faster if the previous gradient was computed nearby.
   */
  FieldSample Gradient(const Vector3& index, TapMemory* memory = nullptr) const noexcept
  {
    FieldSample sample;
    if (this->Carved.HasAny() && this->ReadCarved(index, sample))
    {
      return sample;
    }
    if (memory && this->Functions.Remembered &&
      this->Functions.Remembered(
        this->View, index.X, index.Y, index.Z, this->Functions.Fill, *memory, sample))
    {
      return sample;
    }
    return this->Functions.Gradient(this->View, index.X, index.Y, index.Z);
  }

  ///@{
  /**
   * The same functions for a blend with another time step of the volume. Where possible, the
   * samples are blended before they are summed; otherwise the sums are blended. If `taps` (from
   * GetTaps() of a gradient's memory) has the samples, values are computed from it.
   */
  double Value(const OtherTimeStep& other, const Vector3& index,
    const TimeStepTaps* taps = nullptr) const noexcept
  {
    if (taps)
    {
      const double value =
        this->Functions.TapValue(*taps, this->View, other.Fraction, index.X, index.Y, index.Z);
      if (std::isfinite(value))
      {
        return value;
      }
    }
    if (other.AreSamplesBlended)
    {
      const double value =
        this->Functions.BlendedValue(this->Blended(other), index.X, index.Y, index.Z);
      if (std::isfinite(value))
      {
        return value;
      }
    }
    return this->BlendValue(other, other.Fraction, index);
  }
  /**
   * Returns the values for the other time step's fraction and for a second fraction, faster than
   * two calls of Value() would.
   */
  FractionPair Values(const OtherTimeStep& other, double fraction, const Vector3& index,
    const TimeStepTaps* taps = nullptr) const noexcept
  {
    FractionPair pair;
    if (taps)
    {
      pair = this->Functions.SharedTapValues(
        *taps, this->View, { other.Fraction, fraction }, index.X, index.Y, index.Z);
      if (std::isfinite(pair.First) && std::isfinite(pair.Second))
      {
        return pair;
      }
    }
    if (other.AreSamplesBlended)
    {
      pair =
        this->Functions.SharedValues(this->Blended(other), fraction, index.X, index.Y, index.Z);
    }
    return { std::isfinite(pair.First) ? pair.First
                                       : this->BlendValue(other, other.Fraction, index),
      std::isfinite(pair.Second) ? pair.Second : this->BlendValue(other, fraction, index) };
  }
  ValuePair Values(const OtherTimeStep& other, const Vector3& index, const Vector3& offset,
    const TimeStepTaps* taps = nullptr) const noexcept
  {
    if (taps)
    {
      const ValuePair pair = this->Functions.TapPair(
        *taps, this->View, other.Fraction, index.X, index.Y, index.Z, offset.X, offset.Y, offset.Z);
      if (std::isfinite(pair.Ahead) && std::isfinite(pair.Behind))
      {
        return pair;
      }
    }
    if (other.AreSamplesBlended)
    {
      const ValuePair pair = this->Functions.BlendedPair(
        this->Blended(other), index.X, index.Y, index.Z, offset.X, offset.Y, offset.Z);
      if (std::isfinite(pair.Ahead) && std::isfinite(pair.Behind))
      {
        return pair;
      }
    }
    const ValuePair first = this->Values(index, offset);
    const ValuePair second = other.Field.Values(index, offset);
    return { Blend(first.Ahead, second.Ahead, other.Fraction),
      Blend(first.Behind, second.Behind, other.Fraction) };
  }
  /**
   * Returns the samples of both time steps that a gradient has stored in a memory, or null if the
   * memory belongs to other time steps or the samples are not blended.
   */
  const TimeStepTaps* GetTaps(const OtherTimeStep& other, const TickMemory& memory) const noexcept
  {
    const TimeStepTaps& taps = memory.Pair;
    const bool isOfBoth =
      taps.Field == this->View.Number && taps.SecondField == other.Field.View.Number;
    return isOfBoth && this->Functions.TapValue && other.AreSamplesBlended ? &taps : nullptr;
  }
  FieldSample Gradient(const OtherTimeStep& other, const Vector3& index,
    const BlendMemories& memories = {}) const noexcept
  {
    if (!this->Functions.BlendedGradient || !other.AreSamplesBlended)
    {
      return Blend(this->Gradient(index, memories.First),
        other.Field.Gradient(index, memories.Second), other.Fraction);
    }
    return this->Functions.BlendedGradient(
      this->Blended(other), index.X, index.Y, index.Z, memories);
  }
  static double Blend(double first, double second, double fraction) noexcept
  {
    return first + fraction * (second - first);
  }
  static FieldSample Blend(
    const FieldSample& first, const FieldSample& second, double fraction) noexcept
  {
    return { Blend(first.Value, second.Value, fraction),
      first.Gradient + fraction * (second.Gradient - first.Gradient) };
  }
  ///@}
  /**
   * Returns whether a continuous index is inside the bounding box of the volume's samples, whether
   * they are resident or not.
   */
  bool IsInside(const Vector3& index) const noexcept
  {
    const double* const last = this->Border;
    return index.X >= 0.0 && index.Y >= 0.0 && index.Z >= 0.0 && index.X <= last[0] &&
      index.Y <= last[1] && index.Z <= last[2];
  }

  /**
   * Returns the nearest index in the bounding box. If the index is NaN along an axis, the result is
   * 0 along it.
   */
  Vector3 Nearest(const Vector3& index) const noexcept
  {
    const double* const last = this->Border;
    return { index.X > 0.0 ? std::min(index.X, last[0]) : 0.0,
      index.Y > 0.0 ? std::min(index.Y, last[1]) : 0.0,
      index.Z > 0.0 ? std::min(index.Z, last[2]) : 0.0 };
  }

  /** Returns the distance (voxels) along each axis from an index to the volume's nearer border. */
  Vector3 DistancesToBorder(const Vector3& index) const noexcept
  {
    const double* const last = this->Border;
    return { std::min(index.X, last[0] - index.X), std::min(index.Y, last[1] - index.Y),
      std::min(index.Z, last[2] - index.Z) };
  }
  /** Returns the distance (voxels) from an index to the volume's nearest border. */
  double DistanceToBorder(const Vector3& index) const noexcept
  {
    const Vector3 distances = this->DistancesToBorder(index);
    return std::min(std::min(distances.X, distances.Y), distances.Z);
  }

  /**
   * Returns whether the samples of this time step and another one can be blended. Both must have
   * the same kernel, type and resident samples, and no tissue may have been removed.
   */
  bool BlendsSamples(const FieldSampler& other) const noexcept
  {
    const FieldView& a = this->View;
    const FieldView& b = other.View;
    return this->Functions.Gradient == other.Functions.Gradient &&
      a.Kernel.Table == b.Kernel.Table && a.Kernel.Radius == b.Kernel.Radius &&
      std::equal(a.First, a.First + 3, b.First) && std::equal(a.Last, a.Last + 3, b.Last) &&
      !this->Carved.HasAny() && !other.Carved.HasAny();
  }
  /** Return the view of the samples as it was given, and the tissue that was removed from them. */
  const VolumeView& GetView() const noexcept { return this->Given; }
  const CarvedView& GetCarved() const noexcept { return this->Carved; }

private:
  TimeStepBlend Blended(const OtherTimeStep& other) const noexcept
  {
    return { this->View, other.Field.View, other.Fraction };
  }
  double BlendValue(
    const OtherTimeStep& other, double fraction, const Vector3& index) const noexcept
  {
    return Blend(this->Value(index), other.Field.Value(index), fraction);
  }
  double Checked(double value) const noexcept
  {
    return std::isfinite(value) ? value : this->View.Volume.BorderValue;
  }

  /** Returns the value at an index near which tissue may have been removed. */
  double CarvedValue(const Vector3& index) const noexcept;
  /** Computes the gradient if tissue was removed around the index. Otherwise returns false. */
  bool ReadCarved(const Vector3& index, FieldSample& sample) const noexcept;

  FieldView View;
  VolumeView Given;
  CarvedView Carved;
  double Border[3] = { 0.0, 0.0, 0.0 }; ///< largest index of the volume along each axis
  FieldFunctions Functions;
  FieldFunctions OfCopies; ///< functions for copies of samples, which are doubles
  int ValueReach = 0;      ///< number of samples behind a position's cell that a value needs
};

} // namespace VolumeHaptics

#endif
