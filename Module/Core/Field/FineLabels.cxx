// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/FineLabels.h"

#include "Core/Field/LabelSamples.h"
#include "Core/Field/LabelShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/**
 * Distance assigned to a label in a slice that lacks it: AwaySlices slices, but at most Farthest
 * fine voxels.
 */
constexpr double AwaySlices = 12.0;
constexpr double Farthest = 120.0;
/**
 * A pixel may contain a part of another label if that label is nearer in the slice than this
 * distance (fine voxels).
 */
constexpr double ActiveWidth = 4.0;
/** Number of slices that are processed at once. */
constexpr std::int64_t ChunkSlices = 16;

/**
 * A cubic between two values. Its slopes are limited so that it stays within the range of the
 * values.
 */
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

/** The labels with the largest and the second largest distance at a fine voxel. */
template <typename T>
struct Place
{
  /**
   * Adds a label. `distance` is its distance in this layer, and `rise` is its distance in the next
   * layer minus `distance`.
   */
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
   * Returns the fraction of the voxel that has the second label, in units of 1 / Parts. In the
   * slice, the boundary is at half the difference of both distances.
   */
  std::uint8_t ComputeFraction() const
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

/** Returns the smallest type that holds all labels from `low` to `high`. */
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
  /** Prepares the refinement of the image by a factor along an axis. */
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

  /**
   * Returns for each slice whether its hash differs from the one in `last`. If there are no earlier
   * hashes, all slices count as changed.
   */
  std::vector<char> CollectChanged(const std::vector<std::uint64_t>& last) const
  {
    std::vector<char> changed(static_cast<std::size_t>(this->Slices), 1);
    for (std::size_t i = 0; i < changed.size() && last.size() == changed.size(); ++i)
    {
      changed[i] = this->Hashes[i] != last[i] ? 1 : 0;
    }
    return changed;
  }

  /** Computes the hashes of the slices, the work, and the range of labels. */
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
        const SliceShapes shapes = ExtractShapes(this->Grid, labels);
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

  /** Returns the layout of the resulting labels. Its Data is not set. */
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
   * Collects the pixels whose label changes up to the next slice, or differs from the label of a
   * nearby pixel in one of both slices. In each run, `Piece` is the number of such pixels before
   * it. `from` has the labels of the slice.
   */
  std::vector<PieceRun> FindActive(const std::vector<std::int64_t>& from, std::int64_t slice) const;

  /**
   * Computes the labels between a slice and the next one. For the last slice, computes its own
   * labels.
   */
  template <typename T>
  void FillGap(const std::vector<SliceShapes>& shapes, std::int64_t slice, const VolumeView& view,
    T* labels, std::uint8_t* fractions) const;

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
  // Widen the box along columns, then along rows.
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
    std::int64_t end = 0; // end of the row's last run
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
  const VolumeView& view, T* labels, std::uint8_t* fractions) const
{
  // The two slices at each side of the gap. At the ends of the image, the first or the last slice
  // repeats.
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
  // limits of the distances in the four slices; empty if no piece ends here
  std::vector<float> limits[4];
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

  // All labels of both slices in ascending order, because among equal distances the first label
  // wins.
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
            // Continue the line through both distances, because the piece ends where this line is
            // 0.
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
  // At all other pixels, the label is the same in both slices.
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
        fractions[to] = 0;
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
        fractions[to] = place->ComputeFraction();
      }
    }
  }
}

Vector3 FineLabels::ChooseSteps(
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
  const Vector3 steps = ChooseSteps(view, spacing, mostVoxels);
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
  std::vector<std::byte> before; // labels of the previous axis
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
      fine->Fractions = last->Fractions;
    }
    else
    {
      const std::size_t bytes =
        WithSampleType(found.Type, [](auto sample) { return sizeof(sample); });
      fine->Labels.assign(static_cast<std::size_t>(voxels) * bytes, std::byte{});
      fine->Fractions.assign(static_cast<std::size_t>(voxels), 0);
    }
    found.Data = fine->Labels.data();
    const std::vector<char> changed =
      pass.CollectChanged(isAgain ? last->Hashes : std::vector<std::uint64_t>());
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
          made = ExtractShapes(pass.Grid, labels);
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
                reinterpret_cast<T*>(fine->Labels.data()), fine->Fractions.data());
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
    // Moving keeps the memory in place, so that the next axis can read it.
    before = std::move(fine->Labels);
    image.Data = before.data();
  }
  fine->Labels = std::move(before);
  fine->View = LabelView(image);
  return fine;
}

} // namespace VolumeHaptics
