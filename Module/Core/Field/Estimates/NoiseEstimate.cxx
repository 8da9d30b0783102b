// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/NoiseEstimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{
constexpr int BlockSide = NoiseBlockSide;
constexpr int BlockSamples = BlockSide * BlockSide * BlockSide;
constexpr int Quadratic = 10; // number of coefficients of a quadratic
/**
 * Largest number of blocks along each axis, so that at most 16^3 blocks are examined, or 8^3 in a
 * large volume.
 */
constexpr int MostBlocksAlongAnAxis = 16;
constexpr int MostBlocksAlongAnAxisIfLarge = 8;
/** The blocks with the smallest remainders count as flat; they are this fraction of all blocks. */
constexpr double Flattest = 0.1;
/**
 * A tenth of all estimates lie below this fraction of the true value, if an estimate has 115
 * degrees of freedom.
 */
constexpr double FractionAtFlattest = 0.916;
/** Noise below this fraction of the largest value is only rounding. */
constexpr double NoiseRounding = 1e-9;
constexpr double NoiseThreshold = 3.4;

/**
 * Orthogonal functions on -2 ... 2 (constant, line and parabola), and the sums of their squares.
 */
constexpr double Basis[3][BlockSide] = { { 1, 1, 1, 1, 1 }, { -2, -1, 0, 1, 2 },
  { 2, -1, -2, -1, 2 } };
constexpr double Squares[3] = { 5, 10, 14 };
/** Degrees along x, y and z of the products of these functions with a total degree of at most 2. */
constexpr int Terms[Quadratic][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } };

/** Positions of the blocks along one axis of a volume. */
struct BlockAxis
{
  static constexpr std::int64_t None = -1;

  BlockAxis(std::int64_t count, int most)
    : Last(count - 1)
    , Step(std::max<std::int64_t>(BlockSide, count / most))
    , Blocks(count < BlockSide ? 0 : (count - BlockSide) / this->Step + 1)
  {
  }

  /** Returns the block that contains an index, or None. */
  std::int64_t Find(std::int64_t index) const
  {
    const std::int64_t block = index / this->Step;
    return block < this->Blocks && index - block * this->Step < BlockSide ? block : None;
  }
  bool IsEnd(std::int64_t index) const { return index == 0 || index == this->Last; }

  std::int64_t Last;
  std::int64_t Step;
  std::int64_t Blocks;
};

std::array<BlockAxis, 3> AxesOf(const std::int64_t n[3])
{
  const int most = IsLargeVolume(n) ? MostBlocksAlongAnAxisIfLarge : MostBlocksAlongAnAxis;
  return { BlockAxis(n[0], most), BlockAxis(n[1], most), BlockAxis(n[2], most) };
}

/** The values of all terms at the samples of a block. */
struct TermTable
{
  constexpr TermTable()
  {
    for (int i = 0; i < BlockSamples; ++i)
    {
      for (int t = 0; t < Quadratic; ++t)
      {
        this->Value[i][t] = Basis[Terms[t][0]][i % BlockSide] *
          Basis[Terms[t][1]][i / BlockSide % BlockSide] *
          Basis[Terms[t][2]][i / (BlockSide * BlockSide)];
      }
    }
  }
  double Value[BlockSamples][Quadratic] = {};
};
constexpr TermTable TermValues;

/** Returns the sum of squares of a block after the best quadratic is subtracted. */
double Remainder(const double* block)
{
  // Subtract the middle sample, so that large values do not lose digits in the sums.
  const double middle = block[BlockSamples / 2];
  double left = 0.0;
  double sums[Quadratic] = {};
  for (int i = 0; i < BlockSamples; ++i)
  {
    const double value = block[i] - middle;
    left += value * value;
    for (int t = 0; t < Quadratic; ++t)
    {
      sums[t] += value * TermValues.Value[i][t];
    }
  }
  for (int t = 0; t < Quadratic; ++t)
  {
    const int* const term = Terms[t];
    left -= sums[t] * sums[t] / (Squares[term[0]] * Squares[term[1]] * Squares[term[2]]);
  }
  return std::max(0.0, left);
}

/** The remainders of all blocks of a volume, and the values of flat blocks. */
class Remainders
{
public:
  void Add(const double* block)
  {
    bool isFlat = true;
    bool isFinite = true;
    for (int i = 0; i < BlockSamples; ++i)
    {
      isFlat = isFlat && block[i] == block[0];
      isFinite = isFinite && std::isfinite(block[i]);
    }
    if (isFinite && isFlat)
    {
      this->Flat.push_back(block[0]);
    }
    else if (isFinite)
    {
      this->Left.push_back(Remainder(block));
    }
  }

  /** Returns the noise of a volume whose samples have the given range. */
  double ComputeNoise(const double range[2]) const
  {
    std::vector<double> left = this->Left;
    for (const double value : this->Flat)
    {
      if (value != range[0] && value != range[1])
      {
        left.push_back(0.0);
      }
    }
    if (left.empty())
    {
      return 0.0;
    }
    const auto tenth = left.begin() + static_cast<std::ptrdiff_t>(Flattest * (left.size() - 1));
    std::nth_element(left.begin(), tenth, left.end());
    const double noise = std::sqrt(*tenth / (BlockSamples - Quadratic)) / FractionAtFlattest;
    return noise > NoiseRounding * std::max(std::abs(range[0]), std::abs(range[1])) ? noise : 0.0;
  }

private:
  std::vector<double> Left; // remainders of all blocks that have more than one value
  std::vector<double> Flat; // values of the blocks that have only one value
};

/**
 * Returns the standard deviation of a component of the estimated gradient (per voxel) for noise
 * with a standard deviation of one.
 */
double NoiseGain(const GradientKernel& kernel)
{
  // Noise is independent from sample to sample, so the result is the root of the sum of the squared
  // weights. It is averaged over positions.
  constexpr int positions = 32;
  double smoothing = 0.0;
  double slope = 0.0;
  for (int p = 0; p < positions; ++p)
  {
    const double t = (p + 0.5) / positions;
    double s = 0.0;
    double d = 0.0;
    if (kernel.Estimator == GradientEstimator::CentralDifference)
    {
      s = (1.0 - t) * (1.0 - t) + t * t;
      d = 2.0 * s / (4.0 * kernel.Radius * kernel.Radius);
    }
    else if (kernel.Estimator == GradientEstimator::CubicBSpline)
    {
      const double w[4] = { std::pow(1.0 - t, 3) / 6.0, 2.0 / 3.0 - t * t * (2.0 - t) / 2.0,
        2.0 / 3.0 - (1.0 - t) * (1.0 - t) * (1.0 + t) / 2.0, t * t * t / 6.0 };
      const double v[4] = { -0.5 * (1.0 - t) * (1.0 - t), -2.0 * t + 1.5 * t * t,
        2.0 * (1.0 - t) - 1.5 * (1.0 - t) * (1.0 - t), 0.5 * t * t };
      for (int i = 0; i < 4; ++i)
      {
        s += w[i] * w[i];
        d += v[i] * v[i];
      }
    }
    else
    {
      // Read the weights at the middle of an interval of the table, where the polynomials' argument
      // is 1/2.
      const int count = 2 * kernel.Taps;
      const double* const c =
        &kernel.Table[static_cast<std::size_t>(p) * GradientKernel::Coefficients * count];
      for (int i = 0; i < count; ++i)
      {
        double weight = 0.0;
        for (int power = GradientKernel::Coefficients - 1; power >= 0; --power)
        {
          weight = 0.5 * weight + c[power * count + i];
        }
        (i < kernel.Taps ? s : d) += weight * weight;
      }
    }
    smoothing += s / positions;
    slope += d / positions;
  }
  return smoothing * std::sqrt(slope);
}
static_assert(GradientKernel::Intervals == 32, "NoiseGain reads one position per interval");

} // namespace

bool IsLargeVolume(const std::int64_t dimensions[3])
{
  const std::int64_t* const n = dimensions;
  return n[0] > 0 && n[1] > 0 && n[2] > MostSamplesRead / n[0] / n[1];
}

bool IsLargeVolume(const int extent[6])
{
  std::int64_t dimensions[3];
  for (int a = 0; a < 3; ++a)
  {
    dimensions[a] = std::int64_t{ extent[2 * a + 1] } - extent[2 * a] + 1;
  }
  return IsLargeVolume(dimensions);
}

bool HasRangeOfAll(const std::int64_t dimensions[3])
{
  const std::int64_t* const n = dimensions;
  return n[0] <= 0 || n[1] <= 0 || n[2] <= MostSamplesRanged / n[0] / n[1];
}

std::vector<std::array<int, 6>> ComputeNoiseBoxes(const int whole[6])
{
  NoiseSamples samples;
  for (int a = 0; a < 3; ++a)
  {
    samples.Dimensions[a] = std::int64_t{ whole[2 * a + 1] } - whole[2 * a] + 1;
  }
  const std::array<BlockAxis, 3> axes = AxesOf(samples.Dimensions);
  std::vector<std::array<int, 6>> boxes;
  const std::int64_t blocks = axes[0].Blocks * axes[1].Blocks * axes[2].Blocks;
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    const std::int64_t at[3] = { b % axes[0].Blocks, b / axes[0].Blocks % axes[1].Blocks,
      b / axes[0].Blocks / axes[1].Blocks };
    std::array<int, 6> box{};
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = whole[2 * a] + static_cast<int>(at[a] * axes[a].Step);
      box[2 * a + 1] = box[2 * a] + BlockSide - 1;
    }
    boxes.push_back(box);
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 6> box{};
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = box[2 * a + 1] = whole[2 * a + ((corner >> a) & 1)];
    }
    boxes.push_back(box);
  }
  return boxes;
}

void CollectNoiseSamples(
  const SampleReader& read, const int extent[6], const int whole[6], NoiseSamples& samples)
{
  std::int64_t n[3];    // size of the piece
  std::int64_t from[3]; // index of the piece's first sample in the whole volume
  struct Wanted
  {
    std::int64_t Index; // index in the piece
    bool IsInBlock;
    bool IsEnd;
  };
  std::vector<Wanted> wanted[3];
  for (int a = 0; a < 3; ++a)
  {
    n[a] = std::int64_t{ extent[2 * a + 1] } - extent[2 * a] + 1;
    from[a] = std::int64_t{ extent[2 * a] } - whole[2 * a];
    samples.Dimensions[a] = std::int64_t{ whole[2 * a + 1] } - whole[2 * a] + 1;
  }
  const std::array<BlockAxis, 3> axes = AxesOf(samples.Dimensions);
  const bool isRanged = HasRangeOfAll(samples.Dimensions);
  for (int a = 0; a < 3; ++a)
  {
    for (std::int64_t i = 0; i < n[a]; ++i)
    {
      const bool isInBlock = axes[a].Find(from[a] + i) != BlockAxis::None;
      const bool isEnd = axes[a].IsEnd(from[a] + i);
      if (isInBlock || isEnd)
      {
        wanted[a].push_back({ i, isInBlock, isEnd });
      }
    }
  }
  if (samples.Indices.empty())
  {
    // Reserve the memory at once. Otherwise megabytes would be moved again and again.
    std::size_t most = 1;
    for (const std::vector<Wanted>& along : wanted)
    {
      most *= along.size();
    }
    samples.Indices.reserve(most);
    samples.Values.reserve(most);
  }
  for (const Wanted& k : wanted[2])
  {
    for (const Wanted& j : wanted[1])
    {
      const std::int64_t row =
        samples.Dimensions[0] * (from[1] + j.Index + samples.Dimensions[1] * (from[2] + k.Index));
      for (const Wanted& i : wanted[0])
      {
        const bool isInBlock = i.IsInBlock && j.IsInBlock && k.IsInBlock;
        const bool isCorner = i.IsEnd && j.IsEnd && k.IsEnd;
        if (isInBlock || isCorner)
        {
          samples.Indices.push_back(from[0] + i.Index + row);
          samples.Values.push_back(read(i.Index + n[0] * (j.Index + n[1] * k.Index)));
          const double value = samples.Values.back();
          if (!isRanged)
          {
            samples.MergeValues(&value, 1);
          }
        }
      }
    }
  }
}

double FindBorderValue(const NoiseSamples& samples)
{
  int first = 8;
  double value = 0.0;
  for (std::size_t s = 0; s < samples.Indices.size(); ++s)
  {
    const int corner = samples.GetCorner(s);
    if (corner >= 0 && corner < first && std::isfinite(samples.Values[s]))
    {
      first = corner;
      value = samples.Values[s];
    }
  }
  return value;
}

void VisitNoiseBlocks(const NoiseSamples& samples, const BlockVisitor& visit)
{
  const std::array<BlockAxis, 3> axes = AxesOf(samples.Dimensions);
  const std::int64_t blocks = axes[0].Blocks * axes[1].Blocks * axes[2].Blocks;
  constexpr double missing = std::numeric_limits<double>::infinity();
  std::vector<double> all(static_cast<std::size_t>(blocks * BlockSamples), missing);
  std::vector<std::int64_t> alongX; // block at each index, stored because divisions take long
  for (std::int64_t i = 0; i < samples.Dimensions[0]; ++i)
  {
    alongX.push_back(axes[0].Find(i));
  }
  // The row (along x) of the last sample, which usually contains the next sample, too.
  std::array<std::int64_t, 3> at{};
  std::int64_t row = -samples.Dimensions[0];
  std::int64_t y = BlockAxis::None;
  std::int64_t z = BlockAxis::None;
  for (std::size_t s = 0; s < samples.Indices.size(); ++s)
  {
    at[0] = samples.Indices[s] - row;
    if (at[0] < 0 || at[0] >= samples.Dimensions[0])
    {
      at = samples.ComputePlace(s);
      row = samples.Indices[s] - at[0];
      y = axes[1].Find(at[1]);
      z = axes[2].Find(at[2]);
    }
    const std::int64_t x = alongX[static_cast<std::size_t>(at[0])];
    if (x != BlockAxis::None && y != BlockAxis::None && z != BlockAxis::None)
    {
      const std::int64_t block = x + axes[0].Blocks * (y + axes[1].Blocks * z);
      const std::int64_t sample = at[0] - x * axes[0].Step +
        BlockSide * (at[1] - y * axes[1].Step + BlockSide * (at[2] - z * axes[2].Step));
      all[static_cast<std::size_t>(block * BlockSamples + sample)] = samples.Values[s];
    }
  }
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    visit(&all[static_cast<std::size_t>(b * BlockSamples)]);
  }
}

void VisitNoiseBlocks(
  const SampleReader& read, const std::int64_t dimensions[3], const BlockVisitor& visit)
{
  const std::int64_t* const n = dimensions;
  const std::array<BlockAxis, 3> axes = AxesOf(n);
  std::int64_t offsets[BlockSamples];
  for (int i = 0; i < BlockSamples; ++i)
  {
    offsets[i] = i % BlockSide +
      n[0] * (i / BlockSide % BlockSide + n[1] * std::int64_t{ i / (BlockSide * BlockSide) });
  }
  double block[BlockSamples];
  const std::int64_t blocks = axes[0].Blocks * axes[1].Blocks * axes[2].Blocks;
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    const std::int64_t x = axes[0].Step * (b % axes[0].Blocks);
    const std::int64_t y = axes[1].Step * (b / axes[0].Blocks % axes[1].Blocks);
    const std::int64_t z = axes[2].Step * (b / axes[0].Blocks / axes[1].Blocks);
    for (int i = 0; i < BlockSamples; ++i)
    {
      block[i] = read(x + n[0] * (y + n[1] * z) + offsets[i]);
    }
    visit(block);
  }
}

double EstimateNoise(const NoiseSamples& samples)
{
  Remainders remainders;
  VisitNoiseBlocks(samples, [&](const double* block) { remainders.Add(block); });
  return remainders.ComputeNoise(samples.Range);
}

double EstimateNoise(const SampleReader& read, const std::int64_t dimensions[3], double range[2])
{
  const std::int64_t* const n = dimensions;
  NoiseSamples seen; // only its range is used
  Remainders remainders;
  VisitNoiseBlocks(read, n,
    [&](const double* block)
    {
      remainders.Add(block);
      seen.MergeValues(block, BlockSamples);
    });
  if (!HasRangeOfAll(n))
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::int64_t i = (corner & 1) != 0 ? n[0] - 1 : 0;
      const std::int64_t j = (corner & 2) != 0 ? n[1] - 1 : 0;
      const std::int64_t k = (corner & 4) != 0 ? n[2] - 1 : 0;
      const double value = read(i + n[0] * (j + n[1] * k));
      seen.MergeValues(&value, 1);
    }
    std::copy_n(seen.Range, 2, range);
  }
  return remainders.ComputeNoise(range);
}

Polyline MakeNoiseRamp(double noise, const GradientKernel& kernel, const Affine3& indexToWorld)
{
  if (!(noise > 0.0))
  {
    return {};
  }
  const Matrix3 columns = Transpose(indexToWorld.Linear);
  const double finest =
    std::min({ Norm(columns.Row[0]), Norm(columns.Row[1]), Norm(columns.Row[2]) });
  const double start = NoiseThreshold * noise * NoiseGain(kernel) / finest;
  return { { start, 0.0 }, { 2.0 * start, 1.0 } };
}

} // namespace VolumeHaptics
