// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/LabelShapes.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace VolumeHaptics
{
namespace
{

/** Standard deviation (fine voxels) of the Gaussian that smooths distances in a slice. */
constexpr double Smoothing = 2.0;
/**
 * Labels and gaps are fully smoothed if half of their thickness (fine voxels) is at least this
 * length, and not smoothed if it is less than half of it.
 */
constexpr float Thick = 4.0F;
/** Number of steps per fine voxel in which distances are stored. */
constexpr float DistanceParts = 256.0F;
constexpr float NoSite = 1e12F;

/**
 * Computes the squared distances to the nearest site from the distances along rows, as the lower
 * envelope of parabolas (P. F. Felzenszwalb and D. P. Huttenlocher, Theory of Computing 8, 2012).
 */
class ColumnTransform
{
public:
  explicit ColumnTransform(std::size_t most)
    : Row(most)
    , Sites(most)
    , Begins(most + 1)
  {
  }

  void operator()(float* data, std::int64_t count, std::int64_t stride, float pixel)
  {
    const float square = pixel * pixel;
    std::int64_t last = -1;
    for (std::int64_t i = 0; i < count; ++i)
    {
      const float value = data[i * stride];
      this->Row[i] = value;
      if (value >= NoSite)
      {
        continue;
      }
      float begin = -NoSite;
      while (last >= 0)
      {
        const auto site = this->Sites[last];
        const auto from = static_cast<float>(site);
        const auto to = static_cast<float>(i);
        begin = 0.5F * ((value - this->Row[site]) / (square * (to - from)) + to + from);
        if (begin > this->Begins[last])
        {
          break;
        }
        --last;
        begin = -NoSite;
      }
      ++last;
      this->Sites[last] = i;
      this->Begins[last] = begin;
    }
    if (last < 0)
    {
      return;
    }
    std::int64_t at = 0;
    for (std::int64_t i = 0; i < count; ++i)
    {
      while (at < last && this->Begins[at + 1] < static_cast<float>(i))
      {
        ++at;
      }
      const auto way = static_cast<float>(i - this->Sites[at]);
      data[i * stride] = square * way * way + this->Row[this->Sites[at]];
    }
  }

private:
  std::vector<float> Row;
  std::vector<std::int64_t> Sites;
  std::vector<float> Begins;
};

/** Computes the distances of pixels from a label's boundary in a box of a slice. */
class DistanceMap
{
public:
  DistanceMap(const SliceGrid& grid, const PixelBox& box)
    : Grid(grid)
    , Size{ box.Size(0), box.Size(1) }
  {
  }

  /** Computes the signed distances, which are above 0 where `is` is set. */
  std::vector<std::int16_t> Compute(const std::vector<std::uint8_t>& is)
  {
    const std::vector<float> inside = this->Transform(is, 0);
    std::vector<float> raw = this->Transform(is, 1);
    const float half =
      0.5F * static_cast<float>(std::min(this->Grid.Pixel[0], this->Grid.Pixel[1]));
    const auto away = static_cast<float>(this->Grid.Away);
    for (std::size_t i = 0; i < raw.size(); ++i)
    {
      const float distance = is[i] != 0 ? std::sqrt(inside[i]) - half : half - std::sqrt(raw[i]);
      raw[i] = std::clamp(distance, -away, away);
    }
    std::vector<float> smooth = raw;
    this->Smooth(smooth, 0);
    this->Smooth(smooth, 1);
    std::vector<std::int16_t> found(raw.size());
    for (std::int64_t j = 0; j < this->Size[1]; ++j)
    {
      for (std::int64_t i = 0; i < this->Size[0]; ++i)
      {
        const auto at = static_cast<std::size_t>(i + this->Size[0] * j);
        const float fraction =
          std::abs(raw[at]) < Thick ? this->ThickFraction(raw, smooth, i, j) : 1.0F;
        found[at] = static_cast<std::int16_t>(
          std::lround(DistanceParts * (raw[at] + fraction * (smooth[at] - raw[at]))));
      }
    }
    return found;
  }

private:
  /** Computes the squared distances to the nearest pixel of a kind. */
  std::vector<float> Transform(const std::vector<std::uint8_t>& is, std::uint8_t kind) const
  {
    std::vector<float> squares(is.size(), NoSite);
    const auto pixel = static_cast<float>(this->Grid.Pixel[0]);
    for (std::int64_t j = 0; j < this->Size[1]; ++j)
    {
      // Scan the row in both directions.
      const std::uint8_t* const row = &is[static_cast<std::size_t>(this->Size[0] * j)];
      float* const to = &squares[static_cast<std::size_t>(this->Size[0] * j)];
      float way = NoSite;
      for (std::int64_t i = 0; i < this->Size[0]; ++i)
      {
        way = row[i] == kind ? 0.0F : way + pixel;
        to[i] = way;
      }
      way = NoSite;
      for (std::int64_t i = this->Size[0]; i-- > 0;)
      {
        way = row[i] == kind ? 0.0F : way + pixel;
        const float nearest = std::min(to[i], way);
        to[i] = nearest < NoSite ? nearest * nearest : NoSite;
      }
    }
    ColumnTransform transform(static_cast<std::size_t>(this->Size[1]));
    for (std::int64_t i = 0; i < this->Size[0]; ++i)
    {
      transform(&squares[static_cast<std::size_t>(i)], this->Size[1], this->Size[0],
        static_cast<float>(this->Grid.Pixel[1]));
    }
    return squares;
  }

  /**
   * Smooths the values along an axis with a Gaussian. Repeats the values at the border.
   */
  void Smooth(std::vector<float>& values, int axis) const
  {
    const double scale = Smoothing / this->Grid.Pixel[axis];
    const auto radius = static_cast<std::int64_t>(std::ceil(3.0 * scale));
    if (scale < 0.3)
    {
      return;
    }
    std::vector<float> weights;
    double sum = 0.0;
    for (std::int64_t i = -radius; i <= radius; ++i)
    {
      const double t = static_cast<double>(i) / scale;
      weights.push_back(static_cast<float>(std::exp(-0.5 * t * t)));
      sum += weights.back();
    }
    const std::int64_t count = this->Size[axis];
    // number of values that are smoothed at once
    const std::int64_t width = axis == 0 ? 1 : this->Size[0];
    const std::int64_t lines = axis == 0 ? this->Size[1] : 1;
    std::vector<float> line(static_cast<std::size_t>((count + 2 * radius) * width));
    for (std::int64_t l = 0; l < lines; ++l)
    {
      float* const data = &values[static_cast<std::size_t>(l * count)];
      for (std::int64_t i = -radius; i < count + radius; ++i)
      {
        std::copy_n(data + std::clamp<std::int64_t>(i, 0, count - 1) * width, width,
          line.begin() + (i + radius) * width);
      }
      std::fill_n(data, count * width, 0.0F);
      for (std::int64_t tap = 0; tap <= 2 * radius; ++tap)
      {
        const float weight = weights[static_cast<std::size_t>(tap)] / static_cast<float>(sum);
        const float* const source = &line[static_cast<std::size_t>(tap * width)];
        for (std::int64_t i = 0; i < count * width; ++i)
        {
          data[i] += weight * source[i];
        }
      }
    }
  }

  float At(const std::vector<float>& values, std::int64_t i, std::int64_t j) const
  {
    const std::int64_t x = std::clamp<std::int64_t>(i, 0, this->Size[0] - 1);
    const std::int64_t y = std::clamp<std::int64_t>(j, 0, this->Size[1] - 1);
    return values[static_cast<std::size_t>(x + this->Size[0] * y)];
  }

  /** Returns a bilinearly interpolated value between pixels. */
  float Between(const std::vector<float>& values, float x, float y) const
  {
    const float left = std::floor(x);
    const float low = std::floor(y);
    const auto i = static_cast<std::int64_t>(left);
    const auto j = static_cast<std::int64_t>(low);
    const auto row = [&](std::int64_t at)
    {
      const float from = this->At(values, i, at);
      return from + (x - left) * (this->At(values, i + 1, at) - from);
    };
    const float from = row(j);
    return from + (y - low) * (row(j + 1) - from);
  }

  /**
   * Returns how thick the shape is on both sides of a boundary: 1 if it is thick on both sides, 0
   * if it is thin on one side, and a linear ramp between.
   */
  float ThickFraction(const std::vector<float>& raw, const std::vector<float>& smooth,
    std::int64_t i, std::int64_t j) const
  {
    const auto acrossX = static_cast<float>(this->Grid.Pixel[0]);
    const auto acrossY = static_cast<float>(this->Grid.Pixel[1]);
    const float slopeX = (this->At(smooth, i + 1, j) - this->At(smooth, i - 1, j)) / acrossX;
    const float slopeY = (this->At(smooth, i, j + 1) - this->At(smooth, i, j - 1)) / acrossY;
    const float slope = std::hypot(slopeX, slopeY);
    if (!(slope > 0.0F))
    {
      return 0.0F;
    }
    const float here = this->At(raw, i, j);
    const auto at = [&](float way)
    {
      const float step = way / slope;
      return this->Between(raw, static_cast<float>(i) + step * slopeX / acrossX,
        static_cast<float>(j) + step * slopeY / acrossY);
    };
    const float depth = std::min(at(Thick - here), -at(-Thick - here));
    return std::clamp(2.0F * depth / Thick - 1.0F, 0.0F, 1.0F);
  }

  const SliceGrid& Grid;
  std::int64_t Size[2];
};

/**
 * Returns where a piece ends that the next slice lacks, as a fraction of the distance to that
 * slice. The piece's distance at the pixel is `here` in this slice and `before` in the previous
 * one; its largest distances in these slices are `most` and `mostBefore`. Slices are `step` fine
 * voxels apart.
 *
 * In a slice through a ball, r^2 - rho^2 = S (2 r - S). Along the slices, it is a parabola with the
 * second difference -2 step^2. A piece that does not get smaller ends halfway.
 */
float ComputeEnd(float here, float before, float most, float mostBefore, float step)
{
  constexpr float half = 0.5F;
  constexpr float last = 0.95F;
  constexpr float least = 0.02F;
  if (!(mostBefore > 0.0F))
  {
    return half;
  }
  const float square = here * (2.0F * most - here);
  const float slope =
    square - before * (2.0F * std::max(mostBefore, before) - before) - step * step;
  const float root = std::sqrt(slope * slope + 4.0F * step * step * square);
  const float end = (slope + root) / (2.0F * step * step);
  return end <= 1.0F ? std::clamp(end, least, last) : std::max(2.0F - end, half);
}

/**
 * Returns the length by which the radius of a piece decreases up to the next slice, or 0 if it does
 * not decrease. The arguments are those of ComputeEnd.
 */
float ComputeFall(float most, float mostBefore, float step)
{
  const float fall = (mostBefore * mostBefore + step * step - most * most) / (2.0F * most);
  return mostBefore > 0.0F ? std::max(fall, 0.0F) : 0.0F;
}

/** Numbers the connected pieces of a label. Pixels are connected along rows and columns. */
void CollectPieces(LabelShape& shape)
{
  std::vector<std::size_t> parents;
  const auto root = [&parents](std::size_t run)
  {
    while (parents[run] != run)
    {
      run = parents[run] = parents[parents[run]];
    }
    return run;
  };
  const PixelBox& box = shape.Box;
  std::size_t first = 0; // index of the previous row's first run
  for (std::int64_t j = box.Low[1]; j < box.High[1]; ++j)
  {
    const std::int16_t* const row = shape.GetRow(j);
    std::size_t other = first;
    first = shape.Runs.size();
    for (std::int64_t i = 0; i < box.Size(0); ++i)
    {
      if (row[i] <= 0)
      {
        continue;
      }
      PieceRun run{ j, box.Low[0] + i, 0, 0 };
      while (i < box.Size(0) && row[i] > 0)
      {
        ++i;
      }
      run.End = box.Low[0] + i;
      parents.push_back(parents.size());
      while (other < first && shape.Runs[other].End <= run.Begin)
      {
        ++other;
      }
      for (std::size_t at = other; at < first && shape.Runs[at].Begin < run.End; ++at)
      {
        parents[root(at)] = root(parents.size() - 1);
      }
      shape.Runs.push_back(run);
    }
  }
  std::vector<std::size_t> numbers(parents.size());
  for (std::size_t run = 0; run < parents.size(); ++run)
  {
    if (parents[run] == run)
    {
      numbers[run] = shape.Pieces++;
    }
  }
  for (std::size_t run = 0; run < parents.size(); ++run)
  {
    shape.Runs[run].Piece = numbers[root(run)];
  }
}

} // namespace

const LabelShape* FindShape(const SliceShapes& shapes, std::int64_t label)
{
  const auto found = std::lower_bound(shapes.begin(), shapes.end(), label,
    [](const LabelShape& shape, std::int64_t value) { return shape.Label < value; });
  return found != shapes.end() && found->Label == label ? &*found : nullptr;
}

SliceShapes ExtractShapes(const SliceGrid& grid, const std::vector<std::int64_t>& labels)
{
  struct Extent
  {
    std::int64_t Low[2];
    std::int64_t High[2];
  };
  std::unordered_map<std::int64_t, Extent> extents;
  for (std::int64_t j = 0; j < grid.Size[1]; ++j)
  {
    const std::int64_t* const row = &labels[static_cast<std::size_t>(grid.Size[0] * j)];
    for (std::int64_t i = 0; i < grid.Size[0];)
    {
      std::int64_t end = i + 1;
      for (; end < grid.Size[0] && row[end] == row[i]; ++end)
      {
      }
      Extent& extent = extents.try_emplace(row[i], Extent{ { i, j }, { end, j } }).first->second;
      extent.Low[0] = std::min(extent.Low[0], i);
      extent.High[0] = std::max(extent.High[0], end);
      extent.High[1] = j + 1;
      i = end;
    }
  }
  SliceShapes shapes;
  for (const auto& [label, extent] : extents)
  {
    LabelShape shape;
    shape.Label = label;
    for (int a = 0; a < 2; ++a)
    {
      const auto margin = static_cast<std::int64_t>(std::ceil(grid.Away / grid.Pixel[a])) + 1;
      shape.Box.Low[a] = std::max<std::int64_t>(extent.Low[a] - margin, 0);
      shape.Box.High[a] = std::min(extent.High[a] + margin, grid.Size[a]);
    }
    shapes.push_back(std::move(shape));
  }
  // Sort the labels, so that their order does not depend on the hash.
  std::sort(shapes.begin(), shapes.end(),
    [](const LabelShape& a, const LabelShape& b) { return a.Label < b.Label; });
  return shapes;
}

void MeasureShapes(
  const SliceGrid& grid, const std::vector<std::int64_t>& labels, SliceShapes& shapes)
{
  for (LabelShape& shape : shapes)
  {
    const PixelBox& box = shape.Box;
    std::vector<std::uint8_t> is;
    is.reserve(static_cast<std::size_t>(box.Area()));
    for (std::int64_t j = box.Low[1]; j < box.High[1]; ++j)
    {
      const std::int64_t* const row = &labels[static_cast<std::size_t>(grid.Size[0] * j)];
      for (std::int64_t i = box.Low[0]; i < box.High[0]; ++i)
      {
        is.push_back(row[i] == shape.Label ? 1 : 0);
      }
    }
    shape.Distances = DistanceMap(grid, box).Compute(is);
    CollectPieces(shape);
  }
}

float DistanceAt(const LabelShape* shape, const SliceGrid& grid, std::int64_t i, std::int64_t j)
{
  const bool isThere = shape && i >= shape->Box.Low[0] && i < shape->Box.High[0] &&
    j >= shape->Box.Low[1] && j < shape->Box.High[1];
  return isThere ? static_cast<float>(shape->Distances[static_cast<std::size_t>(
                     i - shape->Box.Low[0] + shape->Box.Size(0) * (j - shape->Box.Low[1]))]) /
      DistanceParts
                 : -static_cast<float>(grid.Away);
}

void LimitEnds(const SliceGrid& grid, const LabelShape& shape, const LabelShape* before,
  const LabelShape* next, std::vector<float>& limits)
{
  std::vector<char> isEnd(shape.Pieces, 1);
  std::size_t ends = shape.Pieces;
  for (const PieceRun& run : shape.Runs)
  {
    for (std::int64_t i = run.Begin; i < run.End && isEnd[run.Piece] != 0; ++i)
    {
      if (DistanceAt(next, grid, i, run.Row) >= 0.0F)
      {
        isEnd[run.Piece] = 0;
        --ends;
      }
    }
  }
  if (ends == 0)
  {
    return;
  }
  struct Largest
  {
    float Here = 0.0F;
    float Before = -HUGE_VALF;
  };
  std::vector<Largest> most(shape.Pieces);
  for (const PieceRun& run : shape.Runs)
  {
    for (std::int64_t i = run.Begin; i < run.End && isEnd[run.Piece] != 0; ++i)
    {
      Largest& of = most[run.Piece];
      of.Here = std::max(of.Here, DistanceAt(&shape, grid, i, run.Row));
      of.Before = std::max(of.Before, DistanceAt(before, grid, i, run.Row));
    }
  }
  if (limits.empty())
  {
    limits.assign(static_cast<std::size_t>(grid.Size[0] * grid.Size[1]), HUGE_VALF);
  }
  const PixelBox& box = shape.Box;
  const std::int64_t width = box.Size(0);
  /** Decrease of the radius at the pixels of pieces that end. */
  std::vector<float> falls(shape.Distances.size(), 0.0F);
  const auto step = static_cast<float>(grid.Step);
  for (const PieceRun& run : shape.Runs)
  {
    const Largest& of = most[run.Piece];
    for (std::int64_t i = run.Begin; i < run.End && isEnd[run.Piece] != 0; ++i)
    {
      falls[static_cast<std::size_t>(i - box.Low[0] + width * (run.Row - box.Low[1]))] =
        ComputeFall(of.Here, of.Before, step);
      const float here = DistanceAt(&shape, grid, i, run.Row);
      const float end =
        ComputeEnd(here, DistanceAt(before, grid, i, run.Row), of.Here, of.Before, step);
      limits[static_cast<std::size_t>(i + grid.Size[0] * run.Row)] = here * (1.0F - end) / end;
    }
  }
  // Around a piece, use the decrease at the piece's nearest pixel.
  const auto acrossX = static_cast<float>(grid.Pixel[0]);
  const auto acrossY = static_cast<float>(grid.Pixel[1]);
  for (std::int64_t j = box.Low[1]; j < box.High[1]; ++j)
  {
    for (std::int64_t i = box.Low[0]; i < box.High[0]; ++i)
    {
      const auto distance = [&](std::int64_t x, std::int64_t y)
      {
        return DistanceAt(&shape, grid, std::clamp(x, box.Low[0], box.High[0] - 1),
          std::clamp(y, box.Low[1], box.High[1] - 1));
      };
      const float here = distance(i, j);
      const float previous = DistanceAt(before, grid, i, j);
      if (here > 0.0F || previous < -step)
      {
        continue;
      }
      const float slopeX = (distance(i + 1, j) - distance(i - 1, j)) / acrossX;
      const float slopeY = (distance(i, j + 1) - distance(i, j - 1)) / acrossY;
      const float way = (1.5F - here) / std::max(std::hypot(slopeX, slopeY), 1e-3F);
      const std::int64_t x = i - box.Low[0] + std::lround(way * slopeX / acrossX);
      const std::int64_t y = j - box.Low[1] + std::lround(way * slopeY / acrossY);
      const bool isInBox = x >= 0 && y >= 0 && x < width && y < box.Size(1);
      const float fall = isInBox ? falls[static_cast<std::size_t>(x + width * y)] : 0.0F;
      if (fall > 0.0F)
      {
        float& limit = limits[static_cast<std::size_t>(i + grid.Size[0] * j)];
        limit = std::min(limit, std::max(2.0F * fall - previous, -here));
      }
    }
  }
}

} // namespace VolumeHaptics
