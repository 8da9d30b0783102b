// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples a label image: for each label around a position, the fraction of the voxels that have it,
 * weighted by a Gaussian of 8 taps.
 *
 * Collect() reads the 8^3 voxels, and stores one bit for each label and voxel: whether the voxel
 * has the label. Fraction() sums the kernel's weights over the bits of a label. A row along x has 8
 * bits. LabelWeights has a table of the weights' sums for all patterns of 4 bits, so that a row
 * needs only two lookups, whatever its labels are.
 *
 * Near a wall, a label usually covers the beginning or the end of a row. Then the sums over the
 * first and over the last voxels suffice, and a row needs one lookup (LabelSteps, StepWeights).
 *
 * The kernels are compiled once for each instruction set, like those of FieldSampler. All variants
 * return the same fractions, to the bit.
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
  /**
   * Limit of the labels around a position. Voxels with further labels count as if they had the last
   * one.
   */
  static constexpr int Most = 32;

  int Count; ///< number of labels
  std::int64_t Label[Most];
  /** For each label and plane k: bit i + 8 j is set if voxel (i, j, k) has the label. */
  std::uint64_t Planes[Most][Taps];
};

/**
 * The rows of a label if it covers the beginning, the end, the whole or nothing of each row. Place
 * is the position of each row's sums in StepWeights::Sums, in bytes.
 */
struct LabelSteps
{
  /** Position for row j of plane k: Place[k][j]. */
  std::uint16_t Place[LabelBlock::Taps][LabelBlock::Taps];

  /** Sets the positions from the planes of a label. Returns false if a row has another pattern. */
  bool Set(const std::uint64_t* planes) noexcept;
};

/** The weights of a kernel at a position, prepared for the rows of LabelSteps. */
struct StepWeights
{
  static constexpr int Ends = LabelBlock::Taps + 1;

  /**
   * Sums over the first 0 to 8 weights of a row, followed by sums over the last 0 to 8 weights.
   * Each sum consists of the same numbers as in LabelWeights::Low.
   */
  alignas(32) double Sums[2 * Ends][4];
  ///@{
  /** Factors of rows and planes, as in LabelWeights. */
  alignas(32) double Across[LabelBlock::Taps][4];
  alignas(32) double Along[2 * LabelBlock::Taps];
  ///@}
};

/** The weights of a kernel at a position, prepared for sums over bits. */
struct LabelWeights
{
  static constexpr int Patterns = 16;

  /**
   * Sums for each pattern of the first (Low) and the last (High) four bits of a row. A sum consists
   * of value, slope, and value again.
   */
  alignas(32) double Low[Patterns][4];
  alignas(32) double High[Patterns][4];
  /** Factors of these numbers for each row of a plane: value, value, slope. */
  alignas(32) double Across[LabelBlock::Taps][4];
  /** Factors for each plane: all values, then all slopes. */
  alignas(32) double Along[2 * LabelBlock::Taps];
};

/** The samples and the weights of a kernel. Owns none of them. */
struct LabelField
{
  static constexpr int Intervals = 32; ///< number of intervals per voxel
  static constexpr int Coefficients = 4;

  VolumeView Volume;
  /**
   * Polynomials of the weights: for each interval the constant coefficients of all taps, then the
   * linear ones, and so on.
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
 * Samples a label image with a Gaussian of 8 taps (GaussianWeights::OwnDerivative). Does not own
 * the samples.
 *
 * The weights equal the kernel's at 32 fractions of a voxel. Between them, they are cubic Hermite
 * polynomials, so that weights and slopes are continuous, and each slope is the derivative of its
 * weight. They differ from the kernel's own weights by less than 1e-8.
 */
class LabelSampler
{
public:
  LabelSampler(const VolumeView& view, const GradientKernel& kernel,
    InstructionSet instructions = DetectInstructionSet());
  LabelSampler(const LabelSampler&) = delete;
  LabelSampler& operator=(const LabelSampler&) = delete;

  /**
   * Collects the labels around a continuous index in the image. Outside the image, the voxels at
   * its border repeat.
   */
  void Collect(const Vector3& index, LabelBlock& block) const noexcept
  {
    this->Functions.Collect(this->View, index.X, index.Y, index.Z, block);
  }

  /** Computes the weights at a continuous index in the image. */
  void Weigh(const Vector3& index, LabelWeights& weights) const noexcept
  {
    this->Functions.Weigh(this->View, index.X, index.Y, index.Z, weights);
  }

  /**
   * Returns the fraction of a label around a position, and the fraction's gradient per index step.
   */
  FieldSample Fraction(const LabelWeights& weights, const std::uint64_t* planes) const noexcept
  {
    return this->Functions.Fraction(weights, planes);
  }

  /** The same for a label whose rows are steps. The index must be in the image. */
  FieldSample Fraction(const Vector3& index, const LabelSteps& steps) const noexcept
  {
    return this->Functions.FractionSteps(this->View, index.X, index.Y, index.Z, steps);
  }

  ///@{
  /** Return the address and the size (bytes) of the memory outside the object. */
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
