// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/HapticHistogram.h"

#include "vtkArrayDispatch.h"
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

/** The finite range so far; empty while the first number is the larger. */
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
  // Give each bin the same number of whole numbers.
  double width =
    areWhole ? std::ceil((range[1] - range[0] + 1.0) / MostBins) : (range[1] - range[0]) / MostBins;
  // Charts are drawn in single precision, which can't tell narrower bins apart.
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

ValueCounts CountSpreadValues(vtkDataArray* scalars, int component)
{
  std::vector<double> values;
  RangeFinder finder;
  VisitSpreadValues(scalars, ClampComponent(scalars, component),
    [&](double value)
    {
      if (std::isfinite(value))
      {
        finder(value);
        values.push_back(value);
      }
    });
  ValueCounts bins = MakeBins(finder.Range, AreWholeNumbers(scalars));
  for (const double value : values)
  {
    CountInto(value, bins);
  }
  return bins;
}

std::optional<ValueCounts> CountAllValues(
  vtkDataArray* scalars, int component, const SweepProgress& progress)
{
  const int used = ClampComponent(scalars, component);
  const auto visitAll = [&](double from, auto&& visit)
  {
    return VisitPieces(scalars, from, progress,
      [&](vtkIdType begin, vtkIdType end) { VisitValues(scalars, used, begin, end, visit); });
  };
  RangeFinder finder;
  if (!visitAll(0.0, finder))
  {
    return std::nullopt;
  }
  ValueCounts bins = MakeBins(finder.Range, AreWholeNumbers(scalars));
  const auto count = [&bins](double value) { CountInto(value, bins); };
  if (!bins.Counts.empty() && !visitAll(0.5, count))
  {
    return std::nullopt;
  }
  return bins;
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
