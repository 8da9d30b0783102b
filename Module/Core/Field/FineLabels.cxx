// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FineLabels.h"

#include "Core/Field/LabelSamples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

namespace VolumeHaptics
{
namespace
{

/** Fine voxels: the Gaussian that smooths distances along a slice. */
constexpr double Smoothing = 2.0;
/** Fine voxels: labels or gaps twice this thick are smoothed; half as thick ones not at all. */
constexpr float Thick = 4.0F;
/**
 * If a slice lacks a label, the label counts as this many slices away, but at most Farthest, in
 * fine voxels.
 */
constexpr double AwaySlices = 12.0;
constexpr double Farthest = 120.0;
/** Distances are kept in parts of a fine voxel. */
constexpr float DistanceParts = 256.0F;
/**
 * Fine voxels: nearer than this to another label in its slice, a pixel may have a share of it above
 * 0.
 */
constexpr double ActiveWidth = 4.0;
/** The number of slices that are processed at once. */
constexpr std::int64_t ChunkSlices = 16;

constexpr float NoSite = 1e12F;

/** Pixels of a slice: from Low up to, but without, High, along the two axes. */
struct PixelBox
{
  std::int64_t Low[2];
  std::int64_t High[2];

  std::int64_t Size(int a) const { return this->High[a] - this->Low[a]; }
  std::int64_t Area() const { return this->Size(0) * this->Size(1); }
};

/** Pixels of a row within a label, with the number of their connected piece. */
struct PieceRun
{
  std::int64_t Row;
  std::int64_t Begin;
  std::int64_t End;
  std::size_t Piece;
};

/** The signed distances of a label in a slice, in a box beyond which they are -Away. */
struct LabelShape
{
  std::int64_t Label;
  PixelBox Box;
  std::vector<std::int16_t> Distances;
  std::vector<PieceRun> Runs; ///< where distances are above 0, row by row
  std::size_t Pieces = 0;

  /** In DistanceParts, from the box's first pixel of a row on; null if the box has none there. */
  const std::int16_t* GetRow(std::int64_t j) const
  {
    return j >= this->Box.Low[1] && j < this->Box.High[1]
      ? &this->Distances[static_cast<std::size_t>(this->Box.Size(0) * (j - this->Box.Low[1]))]
      : nullptr;
  }
};

using SliceShapes = std::vector<LabelShape>;

/** The shape of a label in a slice; null if the slice lacks the label. */
const LabelShape* FindShape(const SliceShapes& shapes, std::int64_t label)
{
  const auto found = std::lower_bound(shapes.begin(), shapes.end(), label,
    [](const LabelShape& shape, std::int64_t value) { return shape.Label < value; });
  return found != shapes.end() && found->Label == label ? &*found : nullptr;
}

/** The pixels of a slice in fine voxels, and the distance of a label that the slice lacks. */
struct SliceGrid
{
  std::int64_t Size[2];
  double Pixel[2];
  double Step; ///< to the next slice
  double Away;
};

/**
 * Squares of the distances to the nearest site, from distances along rows: the lower envelope of
 * parabolas (P. F. Felzenszwalb and D. P. Huttenlocher, Theory of Computing 8, 2012).
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

/** Computes distances in a box of a slice. */
class DistanceMap
{
public:
  DistanceMap(const SliceGrid& grid, const PixelBox& box)
    : Grid(grid)
    , Size{ box.Size(0), box.Size(1) }
  {
  }

  /** Above 0 where `is` is set. */
  std::vector<std::int16_t> Find(const std::vector<std::uint8_t>& is)
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
        const float share = std::abs(raw[at]) < Thick ? this->ThickShare(raw, smooth, i, j) : 1.0F;
        found[at] = static_cast<std::int16_t>(
          std::lround(DistanceParts * (raw[at] + share * (smooth[at] - raw[at]))));
      }
    }
    return found;
  }

private:
  /** Squares of the distances to the nearest pixel of this kind. */
  std::vector<float> Transform(const std::vector<std::uint8_t>& is, std::uint8_t kind) const
  {
    std::vector<float> squares(is.size(), NoSite);
    const auto pixel = static_cast<float>(this->Grid.Pixel[0]);
    for (std::int64_t j = 0; j < this->Size[1]; ++j)
    {
      // Along a row, up and down again.
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

  /** Smooths along an axis with a Gaussian; the border repeats. */
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
    const std::int64_t width = axis == 0 ? 1 : this->Size[0]; // values smoothed at once
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

  /** Bilinear between pixels. */
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

  /** 1 at a boundary that is thick on both sides, 0 if one side is thin. */
  float ThickShare(const std::vector<float>& raw, const std::vector<float>& smooth, std::int64_t i,
    std::int64_t j) const
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

/** The labels of a slice, one after another. */
SliceShapes FindShapes(const SliceGrid& grid, const std::vector<std::int64_t>& labels)
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
  // In an order that does not depend on the hash.
  std::sort(shapes.begin(), shapes.end(),
    [](const LabelShape& a, const LabelShape& b) { return a.Label < b.Label; });
  return shapes;
}

/** Fine voxels, at a pixel. */
float DistanceAt(const LabelShape* shape, const SliceGrid& grid, std::int64_t i, std::int64_t j)
{
  const bool isThere = shape && i >= shape->Box.Low[0] && i < shape->Box.High[0] &&
    j >= shape->Box.Low[1] && j < shape->Box.High[1];
  return isThere ? static_cast<float>(shape->Distances[static_cast<std::size_t>(
                     i - shape->Box.Low[0] + shape->Box.Size(0) * (j - shape->Box.Low[1]))]) /
      DistanceParts
                 : -static_cast<float>(grid.Away);
}

/**
 * The fraction of the way to the next slice at which a piece that the next slice lacks ends, at a
 * pixel with the distance `here`, and `before` in the slice before; the piece's largest distances
 * are `most` and `mostBefore`. Slices are `step` fine voxels apart.
 *
 * In the slices of a ball, r^2 - rho^2 = S (2 r - S) is a parabola of the height with the second
 * difference -2 step^2. A piece that does not become smaller ends halfway.
 */
float FindEnd(float here, float before, float most, float mostBefore, float step)
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

/** The decrease of the radius of such a piece up to the next slice; 0 if there is none. */
float FindFall(float most, float mostBefore, float step)
{
  const float fall = (mostBefore * mostBefore + step * step - most * most) / (2.0F * most);
  return mostBefore > 0.0F ? std::max(fall, 0.0F) : 0.0F;
}

/**
 * For pieces of a label that the next slice lacks: limits for the distances of all labels there, so
 * that the piece ends where FindEnd() says, and falls around it as steeply as FindFall() says.
 */
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
  std::vector<float> falls(shape.Distances.size(), 0.0F); ///< at the pixels of such pieces
  const auto step = static_cast<float>(grid.Step);
  for (const PieceRun& run : shape.Runs)
  {
    const Largest& of = most[run.Piece];
    for (std::int64_t i = run.Begin; i < run.End && isEnd[run.Piece] != 0; ++i)
    {
      falls[static_cast<std::size_t>(i - box.Low[0] + width * (run.Row - box.Low[1]))] =
        FindFall(of.Here, of.Before, step);
      const float here = DistanceAt(&shape, grid, i, run.Row);
      const float end =
        FindEnd(here, DistanceAt(before, grid, i, run.Row), of.Here, of.Before, step);
      limits[static_cast<std::size_t>(i + grid.Size[0] * run.Row)] = here * (1.0F - end) / end;
    }
  }
  // Around a piece: as at the piece's nearest pixel.
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

/** Connected pieces of pixels within the label, by their neighbours along rows and columns. */
void FindPieces(LabelShape& shape)
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
  std::size_t first = 0; // run of the row before
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
    shape.Distances = DistanceMap(grid, box).Find(is);
    FindPieces(shape);
  }
}

/** A cubic between two values, with limited slopes: it stays between them. */
struct Cubic
{
  Cubic(float before, float from, float to, float after)
    : C0(from)
  {
    const float rise = to - from;
    const auto limit = [rise](float slope)
    {
      return rise >= 0.0F ? std::clamp(slope, 0.0F, 3.0F * rise)
                          : std::clamp(slope, 3.0F * rise, 0.0F);
    };
    const float first = limit(0.5F * (to - before));
    const float last = limit(0.5F * (after - from));
    this->C1 = first;
    this->C2 = 3.0F * rise - 2.0F * first - last;
    this->C3 = first + last - 2.0F * rise;
  }

  float operator()(float t) const
  {
    return ((this->C3 * t + this->C2) * t + this->C1) * t + this->C0;
  }
  float Slope(float t) const { return (3.0F * this->C3 * t + 2.0F * this->C2) * t + this->C1; }

  float C0, C1, C2, C3;
};

/** The labels with the largest and the second largest distance, at a fine voxel. */
template <typename T>
struct Place
{
  /** `rise` is the rise of the distance to the next layer. */
  void Add(T label, float distance, float rise)
  {
    if (distance > this->Best)
    {
      this->Next = this->Best;
      this->NextRise = this->Rise;
      this->Best = distance;
      this->Rise = rise;
      this->Winner = label;
    }
    else if (distance > this->Next)
    {
      this->Next = distance;
      this->NextRise = rise;
    }
  }

  /**
   * The other label's share, in parts. The boundary is half the difference of the distances away,
   * within the slice.
   */
  std::uint8_t FindShare() const
  {
    const float rise = 0.5F * (this->Rise - this->NextRise);
    const float away = 0.5F * (this->Best - this->Next) / std::sqrt(1.0F + rise * rise);
    return static_cast<std::uint8_t>(
      static_cast<float>(FineLabels::Parts) * std::clamp(0.5F - away, 0.0F, 0.5F) + 0.5F);
  }

  float Best = -HUGE_VALF;
  float Rise = 0.0F;
  float Next = -HUGE_VALF;
  float NextRise = 0.0F;
  T Winner{};
};

std::uint64_t HashSlice(const std::vector<std::int64_t>& labels)
{
  std::uint64_t hash = 0x9E3779B97F4A7C15U;
  for (const std::int64_t label : labels)
  {
    hash = (hash ^ static_cast<std::uint64_t>(label)) * 0xD6E8FEB86659FD93U;
    hash ^= hash >> 32;
  }
  return hash;
}

/** The narrowest type that holds labels from low to high. */
ScalarType TypeOf(std::int64_t low, std::int64_t high)
{
  const auto fits = [&](auto t)
  {
    using T = decltype(t);
    return low >= std::numeric_limits<T>::min() && high <= std::numeric_limits<T>::max();
  };
  return fits(std::uint8_t{}) ? ScalarType::UInt8
    : fits(std::int16_t{})    ? ScalarType::Int16
    : fits(std::int32_t{})    ? ScalarType::Int32
                              : ScalarType::Int64;
}

std::array<int, 3> FromCoarsest(const Vector3& spacing)
{
  const double length[3] = { spacing.X, spacing.Y, spacing.Z };
  std::array<int, 3> axes{ 0, 1, 2 };
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return length[a] > length[b]; });
  return axes;
}

} // namespace

struct FineLabels::Pass
{
  /** Refines the image along an axis by a factor. */
  Pass(const VolumeView& image, int axis, int factor, const double* spacing, double finest)
    : Image(image)
    , Axis(axis)
    , Factor(factor)
    , Across{ axis == 0 ? 1 : 0, axis == 2 ? 1 : 2 }
  {
    for (int a = 0; a < 2; ++a)
    {
      this->Grid.Size[a] = image.Dimensions[this->Across[a]];
      this->Grid.Pixel[a] = spacing[this->Across[a]] / finest;
    }
    this->Grid.Step = spacing[axis] / finest;
    this->Grid.Away = std::min(AwaySlices * spacing[axis] / finest, Farthest);
    this->Slices = image.Dimensions[axis];
  }

  std::vector<std::int64_t> ReadSlice(std::int64_t slice) const
  {
    std::vector<std::int64_t> labels;
    labels.reserve(static_cast<std::size_t>(this->Grid.Size[0] * this->Grid.Size[1]));
    WithSampleType(this->Image.Type,
      [&](auto sample)
      {
        using T = decltype(sample);
        const std::int64_t* const stride = this->Image.Stride;
        const T* const data = static_cast<const T*>(this->Image.Data) + slice * stride[this->Axis];
        for (std::int64_t j = 0; j < this->Grid.Size[1]; ++j)
        {
          const T* const row = data + j * stride[this->Across[1]];
          for (std::int64_t i = 0; i < this->Grid.Size[0]; ++i)
          {
            labels.push_back(ToLabel(row[i * stride[this->Across[0]]]));
          }
        }
      });
    return labels;
  }

  /** The slices whose hash has changed since the last time; all if there is no last time. */
  std::vector<char> FindChanged(const std::vector<std::uint64_t>& last) const
  {
    std::vector<char> changed(static_cast<std::size_t>(this->Slices), 1);
    for (std::size_t i = 0; i < changed.size() && last.size() == changed.size(); ++i)
    {
      changed[i] = this->Hashes[i] != last[i] ? 1 : 0;
    }
    return changed;
  }

  /** Computes hashes, work and the range of labels. */
  void Scan(const Loop& loop)
  {
    const auto count = static_cast<std::size_t>(this->Slices);
    this->Hashes.resize(count);
    std::vector<std::array<std::int64_t, 3>> facts(count);
    loop(this->Slices,
      [&](std::int64_t slice)
      {
        const std::vector<std::int64_t> labels = this->ReadSlice(slice);
        const auto at = static_cast<std::size_t>(slice);
        this->Hashes[at] = HashSlice(labels);
        const SliceShapes shapes = FindShapes(this->Grid, labels);
        facts[at] = { shapes.front().Label, shapes.back().Label, 0 };
        for (const LabelShape& shape : shapes)
        {
          facts[at][2] += shape.Box.Area();
        }
      });
    this->Low = facts.front()[0];
    this->High = facts.front()[1];
    for (const auto& fact : facts)
    {
      this->Low = std::min(this->Low, fact[0]);
      this->High = std::max(this->High, fact[1]);
      this->Work += fact[2];
    }
  }

  /** The view of the resulting labels, and their bytes. */
  VolumeView MakeView() const
  {
    VolumeView view;
    view.Type = TypeOf(this->Low, this->High);
    std::copy_n(this->Image.Dimensions, 3, view.Dimensions);
    view.Dimensions[this->Axis] = (this->Slices - 1) * this->Factor + 1;
    view.Stride[0] = 1;
    view.Stride[1] = view.Dimensions[0];
    view.Stride[2] = view.Dimensions[0] * view.Dimensions[1];
    return view;
  }

  /**
   * Pixels whose label changes up to the next slice, or differs from a nearby pixel's in one of the
   * two; `Piece` of a run is the number of those before it. `from` has the labels of the slice.
   */
  std::vector<PieceRun> FindActive(const std::vector<std::int64_t>& from, std::int64_t slice) const;

  /** Computes the labels from a slice up to the next one, or of the last slice. */
  template <typename T>
  void FillGap(const std::vector<SliceShapes>& shapes, std::int64_t slice, const VolumeView& view,
    T* labels, std::uint8_t* shares) const;

  const VolumeView Image;
  const int Axis;
  const int Factor;
  const int Across[2];
  SliceGrid Grid;
  std::int64_t Slices;
  std::vector<std::uint64_t> Hashes;
  std::int64_t Low = 0;
  std::int64_t High = 0;
  std::int64_t Work = 0;
};

std::vector<PieceRun> FineLabels::Pass::FindActive(
  const std::vector<std::int64_t>& from, std::int64_t slice) const
{
  const std::vector<std::int64_t> to = slice + 1 < this->Slices ? this->ReadSlice(slice + 1) : from;
  const std::int64_t width = this->Grid.Size[0];
  const std::int64_t height = this->Grid.Size[1];
  std::vector<std::uint8_t> isEdge(from.size());
  for (std::int64_t j = 0; j < height; ++j)
  {
    for (std::int64_t i = 0; i < width; ++i)
    {
      const auto at = static_cast<std::size_t>(i + width * j);
      const auto right = at + (i + 1 < width ? 1 : 0);
      const auto below = at + static_cast<std::size_t>(j + 1 < height ? width : 0);
      isEdge[at] = from[at] != to[at] || from[at] != from[right] || from[at] != from[below] ||
          to[at] != to[right] || to[at] != to[below]
        ? 1
        : 0;
    }
  }
  // Widened along columns, then along rows.
  std::int64_t reach[2];
  for (int a = 0; a < 2; ++a)
  {
    reach[a] = static_cast<std::int64_t>(std::ceil(ActiveWidth / this->Grid.Pixel[a])) + 1;
  }
  std::vector<std::int32_t> edges(static_cast<std::size_t>(width));
  const auto count = [&](std::int64_t j, std::int32_t sign)
  {
    for (std::int64_t i = 0; i < width && j >= 0 && j < height; ++i)
    {
      edges[static_cast<std::size_t>(i)] += sign * isEdge[static_cast<std::size_t>(i + width * j)];
    }
  };
  for (std::int64_t j = 0; j < std::min(reach[1], height); ++j)
  {
    count(j, 1);
  }
  std::vector<PieceRun> runs;
  std::size_t before = 0;
  for (std::int64_t j = 0; j < height; ++j)
  {
    count(j + reach[1], 1);
    count(j - reach[1] - 1, -1);
    std::int64_t end = 0; // of the row's last run
    for (std::int64_t i = 0; i < width; ++i)
    {
      if (edges[static_cast<std::size_t>(i)] == 0)
      {
        continue;
      }
      const std::int64_t begin = std::max(i - reach[0], end);
      const std::int64_t next = std::min(i + reach[0] + 1, width);
      if (begin == end && end > 0)
      {
        runs.back().End = next;
      }
      else
      {
        runs.push_back({ j, begin, next, 0 });
      }
      end = next;
    }
  }
  for (PieceRun& run : runs)
  {
    run.Piece = before;
    before += static_cast<std::size_t>(run.End - run.Begin);
  }
  return runs;
}

template <typename T>
void FineLabels::Pass::FillGap(const std::vector<SliceShapes>& shapes, std::int64_t slice,
  const VolumeView& view, T* labels, std::uint8_t* shares) const
{
  // The slices around the gap; the first and last slices of the image repeat.
  const SliceShapes* around[4];
  for (int s = 0; s < 4; ++s)
  {
    const std::int64_t at = std::clamp<std::int64_t>(slice + s - 1, 0, this->Slices - 1);
    around[s] = &shapes[static_cast<std::size_t>(at)];
  }
  const std::int64_t layers = slice + 1 < this->Slices ? this->Factor : 1;
  const std::int64_t* const n = this->Grid.Size;
  const std::vector<std::int64_t> from = this->ReadSlice(slice);
  const std::vector<PieceRun> runs = this->FindActive(from, slice);
  const std::size_t area = runs.empty()
    ? 0
    : runs.back().Piece + static_cast<std::size_t>(runs.back().End - runs.back().Begin);
  const std::size_t count = static_cast<std::size_t>(layers) * area;
  std::vector<Place<T>> places(count);
  std::vector<float> limits[4]; // for the distances in the four slices; empty if no piece ends
  for (int s = 1; s < 3 && layers > 1; ++s)
  {
    for (const LabelShape& shape : *around[s])
    {
      const LabelShape* const below = FindShape(*around[s - 1], shape.Label);
      const LabelShape* const above = FindShape(*around[s + 1], shape.Label);
      LimitEnds(this->Grid, shape, below, above, limits[s + 1]);
      LimitEnds(this->Grid, shape, above, below, limits[s - 1]);
    }
  }
  const bool hasLimits =
    std::any_of(limits, limits + 4, [](const std::vector<float>& limit) { return !limit.empty(); });
  for (std::vector<float>& limit : limits)
  {
    if (hasLimits && limit.empty())
    {
      limit.assign(static_cast<std::size_t>(n[0] * n[1]), HUGE_VALF);
    }
  }

  // All labels of both slices in rising order: if distances are equal, the first label counts.
  std::vector<std::int64_t> known;
  for (int s = 1; s < 3; ++s)
  {
    for (const LabelShape& shape : *around[s])
    {
      known.push_back(shape.Label);
    }
  }
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  for (const std::int64_t label : known)
  {
    const LabelShape* shape[4];
    PixelBox box{ { n[0], n[1] }, { 0, 0 } };
    for (int s = 0; s < 4; ++s)
    {
      shape[s] = FindShape(*around[s], label);
      for (int a = 0; a < 2 && shape[s] && (s == 1 || s == 2); ++a)
      {
        box.Low[a] = std::min(box.Low[a], shape[s]->Box.Low[a]);
        box.High[a] = std::max(box.High[a], shape[s]->Box.High[a]);
      }
    }
    for (const PieceRun& run : runs)
    {
      if (run.Row < box.Low[1] || run.Row >= box.High[1])
      {
        continue;
      }
      for (std::int64_t i = std::max(run.Begin, box.Low[0]); i < std::min(run.End, box.High[0]);
           ++i)
      {
        float along[4];
        for (int s = 0; s < 4; ++s)
        {
          along[s] = DistanceAt(shape[s], this->Grid, i, run.Row);
        }
        if (hasLimits)
        {
          const auto place = static_cast<std::size_t>(i + n[0] * run.Row);
          for (int s = 0; s < 4; ++s)
          {
            along[s] = std::clamp(along[s], -limits[s][place], limits[s][place]);
          }
          if (std::min(limits[1][place], limits[2][place]) < HUGE_VALF)
          {
            // The end of a piece is where a line is 0.
            along[0] = 2.0F * along[1] - along[2];
            along[3] = 2.0F * along[2] - along[1];
          }
        }
        const Cubic cubic(along[0], along[1], along[2], along[3]);
        Place<T>* place = &places[static_cast<std::size_t>(layers) *
          (run.Piece + static_cast<std::size_t>(i - run.Begin))];
        for (std::int64_t layer = 0; layer < layers; ++layer, ++place)
        {
          const float t = static_cast<float>(layer) / static_cast<float>(this->Factor);
          place->Add(
            static_cast<T>(label), cubic(t), cubic.Slope(t) / static_cast<float>(this->Factor));
        }
      }
    }
  }
  // Elsewhere the label is the same in both slices.
  const std::int64_t* const stride = view.Stride;
  const std::int64_t across[2] = { stride[this->Across[0]], stride[this->Across[1]] };
  const std::int64_t up = stride[this->Axis];
  for (std::int64_t layer = 0; layer < layers; ++layer)
  {
    const std::int64_t begin = (slice * this->Factor + layer) * up;
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      const std::int64_t* const row = &from[static_cast<std::size_t>(n[0] * j)];
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const std::int64_t to = begin + i * across[0] + j * across[1];
        labels[to] = static_cast<T>(row[i]);
        shares[to] = 0;
      }
    }
  }
  const Place<T>* place = places.data();
  for (const PieceRun& run : runs)
  {
    for (std::int64_t i = run.Begin; i < run.End; ++i)
    {
      std::int64_t to = slice * this->Factor * up + i * across[0] + run.Row * across[1];
      for (std::int64_t layer = 0; layer < layers; ++layer, ++place, to += up)
      {
        labels[to] = place->Winner;
        shares[to] = place->FindShare();
      }
    }
  }
}

Vector3 FineLabels::FindSteps(
  const LabelView& view, const Vector3& spacing, std::int64_t mostVoxels)
{
  const double length[3] = { spacing.X, spacing.Y, spacing.Z };
  const double finest = std::min({ spacing.X, spacing.Y, spacing.Z });
  const std::int64_t* const n = view.GetView().Dimensions;
  double left = static_cast<double>(mostVoxels) / static_cast<double>(n[0] * n[1] * n[2]);
  double steps[3];
  for (const int axis : FromCoarsest(spacing))
  {
    const bool isThick = length[axis] > LargestRatio * finest && n[axis] > 1;
    const double wanted = isThick ? std::round(length[axis] / finest) : 1.0;
    steps[axis] = std::max(1.0, std::min({ wanted, std::floor(left), 64.0 }));
    left /= steps[axis];
  }
  return { steps[0], steps[1], steps[2] };
}

std::shared_ptr<const FineLabels> FineLabels::Make(const LabelView& view, const Vector3& spacing,
  const Loop& loop, const FineLabels* last, std::int64_t mostVoxels)
{
  const Loop each = loop ? loop
                         : [](std::int64_t count, const Body& body)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      body(i);
    }
  };
  double step[3] = { spacing.X, spacing.Y, spacing.Z };
  const double finest = std::min({ step[0], step[1], step[2] });
  VolumeView image = view.GetView();
  const Vector3 steps = FindSteps(view, spacing, mostVoxels);
  const int factors[3] = { static_cast<int>(steps.X), static_cast<int>(steps.Y),
    static_cast<int>(steps.Z) };
  const auto passes = 3 - std::count(factors, factors + 3, 1);
  if (passes == 0)
  {
    return nullptr;
  }
  std::shared_ptr<FineLabels> fine(new FineLabels);
  fine->Spacing = spacing;
  fine->Steps = steps;
  std::vector<std::byte> before; // the labels of the pass before
  for (const int axis : FromCoarsest(spacing))
  {
    if (factors[axis] == 1)
    {
      continue;
    }
    Pass pass(image, axis, factors[axis], step, finest);
    pass.Scan(each);
    if (pass.Work > MostWork)
    {
      return nullptr;
    }
    VolumeView found = pass.MakeView();
    const bool isAgain = last && passes == 1 && last->Hashes.size() == pass.Hashes.size() &&
      IsIdentical(last->Spacing, spacing) && IsIdentical(last->Steps, fine->Steps) &&
      last->View.GetView().Type == found.Type &&
      std::equal(found.Dimensions, found.Dimensions + 3, last->View.GetView().Dimensions);
    const std::int64_t voxels = found.Dimensions[0] * found.Dimensions[1] * found.Dimensions[2];
    if (isAgain)
    {
      fine->Labels = last->Labels;
      fine->Shares = last->Shares;
    }
    else
    {
      const std::size_t bytes =
        WithSampleType(found.Type, [](auto sample) { return sizeof(sample); });
      fine->Labels.assign(static_cast<std::size_t>(voxels) * bytes, std::byte{});
      fine->Shares.assign(static_cast<std::size_t>(voxels), 0);
    }
    found.Data = fine->Labels.data();
    const std::vector<char> changed =
      pass.FindChanged(isAgain ? last->Hashes : std::vector<std::uint64_t>());
    const auto isNear = [&](std::int64_t slice, std::int64_t below, std::int64_t above)
    {
      const auto from = changed.begin() + std::max<std::int64_t>(slice - below, 0);
      const auto to = changed.begin() + std::min(slice + above + 1, pass.Slices);
      return std::find(from, to, 1) != to;
    };
    std::vector<SliceShapes> shapes(static_cast<std::size_t>(pass.Slices));
    std::vector<char> hasShapes(static_cast<std::size_t>(pass.Slices), 0);
    for (std::int64_t begin = 0; begin < pass.Slices; begin += ChunkSlices)
    {
      const std::int64_t end = std::min(begin + ChunkSlices, pass.Slices);
      std::vector<std::int64_t> gaps;
      std::vector<std::int64_t> slices;
      for (std::int64_t slice = begin; slice < end; ++slice)
      {
        if (isNear(slice, 1, 2))
        {
          gaps.push_back(slice);
        }
      }
      for (std::int64_t slice = std::max<std::int64_t>(begin - 1, 0);
           slice < std::min(end + 2, pass.Slices); ++slice)
      {
        const bool isNeeded = std::any_of(gaps.begin(), gaps.end(),
          [slice](std::int64_t gap) { return slice >= gap - 1 && slice <= gap + 2; });
        if (isNeeded && hasShapes[static_cast<std::size_t>(slice)] == 0)
        {
          hasShapes[static_cast<std::size_t>(slice)] = 1;
          slices.push_back(slice);
        }
      }
      each(static_cast<std::int64_t>(slices.size()),
        [&](std::int64_t i)
        {
          const std::int64_t slice = slices[static_cast<std::size_t>(i)];
          const std::vector<std::int64_t> labels = pass.ReadSlice(slice);
          SliceShapes& made = shapes[static_cast<std::size_t>(slice)];
          made = FindShapes(pass.Grid, labels);
          MeasureShapes(pass.Grid, labels, made);
        });
      each(static_cast<std::int64_t>(gaps.size()),
        [&](std::int64_t i)
        {
          WithSampleType(found.Type,
            [&](auto sample)
            {
              using T = decltype(sample);
              pass.FillGap(shapes, gaps[static_cast<std::size_t>(i)], found,
                reinterpret_cast<T*>(fine->Labels.data()), fine->Shares.data());
            });
        });
      fine->SlicesFound += static_cast<std::int64_t>(gaps.size());
      for (std::int64_t slice = std::max<std::int64_t>(begin - 1, 0); slice < end - 1; ++slice)
      {
        shapes[static_cast<std::size_t>(slice)] = {};
      }
    }
    if (passes == 1)
    {
      fine->Hashes = pass.Hashes;
    }
    step[axis] /= factors[axis];
    image = found;
    before = std::move(fine->Labels); // its memory does not move: the next pass reads it
    image.Data = before.data();
  }
  fine->Labels = std::move(before);
  fine->View = LabelView(image);
  return fine;
}

} // namespace VolumeHaptics
