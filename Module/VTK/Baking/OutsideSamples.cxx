// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/OutsideSamples.h"

#include "VTK/Baking/HapticVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Numbers for missing values: of programs for maps and weather, and of DICOM and ITK. */
constexpr double MissingNumbers[] = { -9999.0, -99999.0, -32768.0, -32767.0, -2147483648.0,
  -2147483647.0 };
/** 1e20, 1e30, 1e37, 9.97e36 (NetCDF), and the largest numbers of both floating-point types. */
constexpr double LeastEnormous = 1e19;
/** Of the range of all others. */
constexpr double LeastGap = 0.1;

bool IsEnormous(double value)
{
  return std::abs(value) >= LeastEnormous;
}

/** Whether programs write it for a missing value. */
bool MayBeMissing(double value)
{
  return std::isfinite(value) &&
    (IsEnormous(value) ||
      std::find(std::begin(MissingNumbers), std::end(MissingNumbers), value) !=
        std::end(MissingNumbers));
}

/** The samples of a component in their places. */
template <typename T>
class Grid
{
public:
  explicit Grid(const VolumeView& view)
    : First(static_cast<const T*>(view.Data))
    , View(view)
  {
  }

  std::int64_t Size(int axis) const { return this->View.Dimensions[axis]; }
  std::int64_t Count() const { return this->Size(0) * this->Size(1) * this->Size(2); }
  T At(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return this
      ->First[i * this->View.Stride[0] + j * this->View.Stride[1] + k * this->View.Stride[2]];
  }
  /** In the order of memory, x fastest. */
  T operator[](std::int64_t at) const { return this->First[at * this->View.Stride[0]]; }
  bool IsFace(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i == 0 || j == 0 || k == 0 || i == this->Size(0) - 1 || j == this->Size(1) - 1 ||
      k == this->Size(2) - 1;
  }

  /** Calls for each sample of the faces, until that returns true. */
  template <typename Visit>
  bool AnyOfFaces(Visit&& visit) const
  {
    for (std::int64_t k = 0; k < this->Size(2); ++k)
    {
      for (std::int64_t j = 0; j < this->Size(1); ++j)
      {
        const bool isFace = this->IsFace(1, j, k) || this->Size(0) < 3;
        const std::int64_t step = isFace ? 1 : this->Size(0) - 1;
        for (std::int64_t i = 0; i < this->Size(0); i += step)
        {
          if (visit(this->At(i, j, k)))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  const T* First;
  VolumeView View;
};

/** The least and the largest number but those that are missing; the first is larger without any. */
template <typename T>
std::array<double, 2> FindInside(const Grid<T>& grid, const std::optional<double>& missing)
{
  std::array<double, 2> range{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (std::int64_t at = 0; at < grid.Count(); ++at)
  {
    const auto value = static_cast<double>(grid[at]);
    if (std::isfinite(value) && !(missing && value == *missing))
    {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
  return range;
}

/** The number of the corners that stands for missing values. */
template <typename T>
std::optional<double> FindMissing(const Grid<T>& grid)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto value = static_cast<double>(grid.At((corner & 1) ? grid.Size(0) - 1 : 0,
      (corner & 2) ? grid.Size(1) - 1 : 0, (corner & 4) ? grid.Size(2) - 1 : 0));
    if (!MayBeMissing(value))
    {
      continue;
    }
    const std::array<double, 2> inside = FindInside(grid, value);
    const double gap = value < inside[0] ? inside[0] - value : value - inside[1];
    if (inside[0] <= inside[1] && !IsEnormous(inside[0]) && !IsEnormous(inside[1]) &&
      gap > LeastGap * (inside[1] - inside[0]))
    {
      return value;
    }
  }
  return {};
}

/** NaN in one piece with that of the faces: marks, or none if there is none. */
template <typename T>
std::vector<bool> MarkOuterNaN(const Grid<T>& grid)
{
  const auto isNaN = [](T value) { return value != value; };
  if (!std::is_floating_point_v<T> || !grid.AnyOfFaces(isNaN))
  {
    return {};
  }
  const std::int64_t row = grid.Size(0);
  const std::int64_t layer = row * grid.Size(1);
  std::vector<bool> marks(static_cast<std::size_t>(grid.Count()));
  const auto isMarked = [&marks](std::int64_t at) { return marks[static_cast<std::size_t>(at)]; };
  // To and fro, until nothing is added: of what is convex, once each.
  bool isDone = false;
  for (int sign = 1; !isDone; sign = -sign)
  {
    isDone = true;
    for (std::int64_t n = 0; n < grid.Count(); ++n)
    {
      const std::int64_t at = sign > 0 ? n : grid.Count() - 1 - n;
      if (isMarked(at) || !isNaN(grid[at]))
      {
        continue;
      }
      const std::int64_t i = at % row;
      const std::int64_t j = at / row % grid.Size(1);
      const std::int64_t k = at / layer;
      if (grid.IsFace(i, j, k) || isMarked(at - 1) || isMarked(at + 1) || isMarked(at - row) ||
        isMarked(at + row) || isMarked(at - layer) || isMarked(at + layer))
      {
        marks[static_cast<std::size_t>(at)] = true;
        isDone = false;
      }
    }
  }
  return marks;
}

template <typename T>
FilledSamples Fill(
  const VolumeView& view, vtkDataArray* scalars, const std::optional<double>& wanted)
{
  const Grid<T> grid(view);
  const std::optional<double> missing = FindMissing(grid);
  const std::vector<bool> marks = MarkOuterNaN(grid);
  FilledSamples filled;
  if (!missing && marks.empty())
  {
    return filled;
  }
  const std::array<double, 2> inside = FindInside(grid, missing);
  if (!(inside[0] <= inside[1]))
  {
    return filled; // nothing is inside
  }
  using Limits = std::numeric_limits<T>;
  const double value = std::clamp(wanted.value_or(inside[0]), static_cast<double>(Limits::lowest()),
    static_cast<double>(Limits::max()));
  filled.Array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(scalars->GetDataType()));
  filled.Array->SetName(scalars->GetName());
  filled.Array->SetNumberOfTuples(grid.Count());
  auto* const to = static_cast<T*>(filled.Array->GetVoidPointer(0));
  std::int64_t count = 0;
  for (std::int64_t at = 0; at < grid.Count(); ++at)
  {
    const bool isMissing = missing && static_cast<double>(grid[at]) == *missing;
    const bool isOutside = isMissing || (!marks.empty() && marks[static_cast<std::size_t>(at)]);
    to[at] = isOutside ? static_cast<T>(value) : grid[at];
    count += isMissing ? 1 : 0;
  }
  if (missing)
  {
    std::ostringstream text;
    text << "The value " << *missing << " of " << count << " samples in the "
         << DescribeArray(scalars) << " of the input image is taken for \"missing\": they are "
         << "outside, and felt as " << value
         << ". If it was measured, shift all values by 1, and the functions with them.";
    filled.Missing = text.str();
  }
  return filled;
}

} // namespace

FilledSamples FillOutside(
  vtkImageData* image, vtkDataArray* scalars, int component, std::optional<double> value)
{
  VolumeView view;
  vtkSmartPointer<vtkDataArray> holder;
  int dimensions[3];
  image->GetDimensions(dimensions);
  FilledSamples filled;
  if (component >= scalars->GetNumberOfComponents() || image->GetNumberOfPoints() == 0 ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    !LocateSamples(scalars, component, dimensions, view, holder) || !view.Data)
  {
    return filled;
  }
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(filled = Fill<VTK_TT>(view, scalars, value));
    default:
      break;
  }
  return filled;
}

} // namespace VolumeHaptics
