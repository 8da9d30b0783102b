// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels around a position and their fractions, weighted by a Gaussian of 8 taps.
 *
 * Collect() reads the 8^3 voxels and stores a bit for each label and voxel: whether the voxel has
 * the label. Fraction() sums the kernel's weights over the bits of a label. A row along x has 8
 * bits; the sums of its weights over all patterns of 4 bits are in a table (LabelWeights), so that
 * a row costs two lookups, for any labels.
 *
 * Across a wall, rows mostly begin or end with a label: then the sums over the first and over the
 * last voxels suffice, and a row costs one lookup (LabelSteps, StepWeights).
 *
 * The kernels are compiled once per instruction set, as for FieldSampler; all of them give the same
 * fractions, to the bit.
 */
#ifndef LabelSampler_h
#define LabelSampler_h

#include "Core/Field/FieldSampler.h"
#include "Core/Field/LabelView.h"

#include <vector>

namespace VolumeHaptics
{

/** The labels of the voxels around a position. */
struct LabelBlock
{
  static constexpr int Taps = 8;
  /** The most labels around one position; further ones count as the last of them. */
  static constexpr int Most = 32;

  int Count; ///< the number of labels
  std::int64_t Label[Most];
  /** For each label and plane k: bit i + 8 j is set if voxel (i, j, k) has the label. */
  std::uint64_t Planes[Most][Taps];
};

/**
 * The rows of a label, if each row begins or ends with the label, or has the label everywhere or
 * nowhere. Holds for each row the place in StepWeights::Sums, in bytes.
 */
struct LabelSteps
{
  std::uint16_t Place[LabelBlock::Taps][LabelBlock::Taps]; ///< the place for plane k, row j

  /** Sets the places from the planes of a label; returns false if a row has another form. */
  bool Set(const std::uint64_t* planes) noexcept;
};

/** The weights of a kernel at a position, prepared for rows of LabelSteps. */
struct StepWeights
{
  static constexpr int Ends = LabelBlock::Taps + 1;

  /** The sums over the first 0 to 8 weights of a row, then over the last 0 to 8: LabelWeights. */
  alignas(32) double Sums[2 * Ends][4];
  ///@{
  /** The factors of rows and planes: see LabelWeights. */
  alignas(32) double Across[LabelBlock::Taps][4];
  alignas(32) double Along[2 * LabelBlock::Taps];
  ///@}
};

/** The weights of a kernel at a position, prepared for sums over bits. */
struct LabelWeights
{
  static constexpr int Patterns = 16;

  /**
   * The sums for each pattern of the first and the last four bits of a row: the sums of the weights
   * of the value, of the slope, and of the value again.
   */
  alignas(32) double Low[Patterns][4];
  alignas(32) double High[Patterns][4];
  /** The factors of these sums for each row of a plane: value, value, slope. */
  alignas(32) double Across[LabelBlock::Taps][4];
  /** The factors for each plane: value, then slope. */
  alignas(32) double Along[2 * LabelBlock::Taps];
};

/** The samples and the weights of a kernel; borrows both. */
struct LabelField
{
  static constexpr int Intervals = 32; ///< intervals per voxel
  static constexpr int Coefficients = 4;

  VolumeView Volume;
  /**
   * Polynomials of the weights: for each interval the constant coefficients of all taps, and so on.
   */
  const double* Table = nullptr;
};

/** The kernels for one scalar type. */
struct LabelFunctions
{
  void (*Collect)(const LabelField&, double x, double y, double z, LabelBlock&) noexcept = nullptr;
  void (*Weigh)(const LabelField&, double x, double y, double z, LabelWeights&) noexcept = nullptr;
  FieldSample (*Fraction)(const LabelWeights&, const std::uint64_t* planes) noexcept = nullptr;
  FieldSample (*FractionSteps)(
    const LabelField&, double x, double y, double z, const LabelSteps&) noexcept = nullptr;
};

/**
 * A label image and a Gaussian of 8 taps (GaussianWeights::OwnDerivative). Borrows the samples.
 *
 * At 32 fractions of a voxel, the weights are the kernel's; in between, they are cubic Hermite
 * polynomials: so the weights and their slopes are continuous, and each slope is the derivative of
 * its weight. They differ from the kernel's own weights by less than 1e-8.
 */
class LabelSampler
{
public:
  LabelSampler(const VolumeView& view, const GradientKernel& kernel,
    InstructionSet instructions = DetectInstructionSet());
  LabelSampler(const LabelSampler&) = delete;
  LabelSampler& operator=(const LabelSampler&) = delete;

  /**
   * Collects the labels around a continuous index within the image, whose border repeats beyond it.
   */
  void Collect(const Vector3& index, LabelBlock& block) const noexcept
  {
    this->Functions.Collect(this->View, index.X, index.Y, index.Z, block);
  }

  /** Computes the weights at a continuous index within the image. */
  void Weigh(const Vector3& index, LabelWeights& weights) const noexcept
  {
    this->Functions.Weigh(this->View, index.X, index.Y, index.Z, weights);
  }

  /** Returns the fraction of a label around a position, and its gradient per index step. */
  FieldSample Fraction(const LabelWeights& weights, const std::uint64_t* planes) const noexcept
  {
    return this->Functions.Fraction(weights, planes);
  }

  /** Returns the same for a label whose rows are steps, at a continuous index within the image. */
  FieldSample Fraction(const Vector3& index, const LabelSteps& steps) const noexcept
  {
    return this->Functions.FractionSteps(this->View, index.X, index.Y, index.Z, steps);
  }

  ///@{
  /** Return the memory outside the object, and its size (bytes). */
  const void* GetMemory() const noexcept { return this->Table.data(); }
  std::size_t GetMemorySize() const noexcept { return this->Table.capacity() * sizeof(double); }
  ///@}

private:
  const std::vector<double> Table;
  LabelField View;
  LabelFunctions Functions;
};

} // namespace VolumeHaptics

#endif
