// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticHistogram.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

constexpr int MostBins = 128;
constexpr vtkIdType MostQuick = 1 << 22;    // values: 25 ms on a desktop computer of 2023
constexpr vtkIdType MostSpread = 1 << 11;   // values: 8 MiB of a file that is mapped into memory
constexpr vtkIdType ValuesAPiece = 1 << 20; // 6 ms

bool AreWholeNumbers(vtkDataArray* scalars)
{
  return scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE;
}

/** Calls a function with each finite value of the tuples from Begin to End. */
template <typename Function>
struct ValueVisitor
{
  const int Component;
  const vtkIdType Begin;
  const vtkIdType End;
  Function& Visit;

  template <typename ArrayType>
  void operator()(ArrayType* scalars)
  {
    for (const auto tuple : vtk::DataArrayTupleRange(scalars, this->Begin, this->End))
    {
      const double value = static_cast<double>(tuple[this->Component]);
      if (std::isfinite(value))
      {
        this->Visit(value);
      }
    }
  }
};

template <typename Function>
void VisitValues(
  vtkDataArray* scalars, int component, vtkIdType begin, vtkIdType end, Function&& visit)
{
  ValueVisitor<std::remove_reference_t<Function>> visitor{ component, begin, end, visit };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, visitor))
  {
    visitor(scalars);
  }
}

/** The finite range so far; the first is the larger as long as there is none. */
struct RangeFinder
{
  double Range[2] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };

  void operator()(double value)
  {
    this->Range[0] = std::min(this->Range[0], value);
    this->Range[1] = std::max(this->Range[1], value);
  }
};

/** Bins for a range; none if there is none. */
ValueCounts MakeBins(const double found[2], bool areWhole)
{
  ValueCounts bins;
  if (!(found[0] <= found[1]))
  {
    return bins;
  }
  double* const range = bins.Range;
  range[0] = std::clamp(found[0], -FarthestShown, FarthestShown);
  range[1] = std::clamp(found[1], -FarthestShown, FarthestShown);
  // Each bin has to hold the same number of whole numbers.
  double width =
    areWhole ? std::ceil((range[1] - range[0] + 1.0) / MostBins) : (range[1] - range[0]) / MostBins;
  // Charts are drawn in single precision: bins that it can't tell apart are useless.
  constexpr double precision = 1e-7;
  const double least =
    std::max(1.0 / FarthestShown, precision * std::max(std::abs(range[0]), std::abs(range[1])));
  width = range[0] < range[1] ? std::max(width, least) : 1.0;
  bins.Width = width;
  bins.Origin = range[0] + (areWhole ? 0.5 * (width - 1.0) : 0.5 * width);
  const int count = std::clamp(static_cast<int>((range[1] - range[0]) / width) + 1, 1, MostBins);
  bins.Counts.resize(static_cast<std::size_t>(count));
  return bins;
}

/** Counts without VTK's vtkImageHistogram, which ParaView lacks. */
void CountInto(double value, ValueCounts& bins)
{
  const double last = static_cast<double>(bins.Counts.size() - 1);
  const double bin = std::floor((value - bins.Origin) / bins.Width + 0.5);
  ++bins.Counts[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
}

int ClampComponent(vtkDataArray* scalars, int component)
{
  return std::clamp(component, 0, scalars->GetNumberOfComponents() - 1);
}

} // namespace

bool AreQuicklyCounted(vtkDataArray* scalars)
{
  return scalars->GetNumberOfTuples() <= MostQuick;
}

ValueCounts CountSpreadValues(vtkDataArray* scalars, int component)
{
  const int used = ClampComponent(scalars, component);
  const vtkIdType all = scalars->GetNumberOfTuples();
  const vtkIdType looks = std::min(all, MostSpread);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(looks));
  RangeFinder finder;
  // One in each of as many stretches, at a place that moves by the golden section: even steps could
  // fall into the same column of every row.
  constexpr double section = 0.6180339887498949;
  double place = 0.0;
  for (vtkIdType look = 0; look < looks; ++look)
  {
    place += section;
    place -= std::floor(place);
    const double at = (static_cast<double>(look) + place) / static_cast<double>(looks);
    const auto tuple = static_cast<vtkIdType>(at * static_cast<double>(all));
    const double value = scalars->GetComponent(std::min(tuple, all - 1), used);
    if (std::isfinite(value))
    {
      finder(value);
      values.push_back(value);
    }
  }
  ValueCounts bins = MakeBins(finder.Range, AreWholeNumbers(scalars));
  for (const double value : values)
  {
    CountInto(value, bins);
  }
  return bins;
}

std::optional<ValueCounts> CountAllValues(
  vtkDataArray* scalars, int component, const CountProgress& progress)
{
  const int used = ClampComponent(scalars, component);
  const vtkIdType all = scalars->GetNumberOfTuples();
  bool isEnded = false;
  const auto visitAll = [&](double from, auto&& visit)
  {
    for (vtkIdType begin = 0; begin < all && !isEnded; begin += ValuesAPiece)
    {
      isEnded = !progress(from + 0.5 * static_cast<double>(begin) / static_cast<double>(all));
      VisitValues(
        scalars, used, begin, isEnded ? begin : std::min(begin + ValuesAPiece, all), visit);
    }
  };
  RangeFinder finder;
  visitAll(0.0, finder);
  ValueCounts bins = MakeBins(finder.Range, AreWholeNumbers(scalars));
  if (!bins.Counts.empty())
  {
    visitAll(0.5, [&bins](double value) { CountInto(value, bins); });
  }
  return isEnded ? std::nullopt : std::optional<ValueCounts>(std::move(bins));
}

void FillHistogram(const ValueCounts& counts, vtkTable* table)
{
  table->Initialize();
  if (counts.Counts.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> values, shares;
  values->SetName("value");
  shares->SetName("share");
  double largest = 0.0;
  for (std::size_t i = 0; i < counts.Counts.size(); ++i)
  {
    values->InsertNextValue(counts.Origin + static_cast<double>(i) * counts.Width);
    const double share = std::log1p(static_cast<double>(counts.Counts[i]));
    shares->InsertNextValue(share);
    largest = std::max(largest, share);
  }
  for (vtkIdType i = 0; i < shares->GetNumberOfValues() && largest > 0.0; ++i)
  {
    shares->SetValue(i, shares->GetValue(i) / largest);
  }
  table->AddColumn(values);
  table->AddColumn(shares);
}

} // namespace VolumeHaptics
