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
#include <cstdint>
#include <limits>
#include <type_traits>
#include <unordered_set>

namespace VolumeHaptics
{
namespace
{

constexpr int MostBins = 128;

bool AreWholeNumbers(vtkDataArray* scalars)
{
  return scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE;
}

/** Calls a function with each finite value of a component in the tuples from Begin to End. */
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

/** Finds the range of finite values. While there are none, Range[0] exceeds Range[1]. */
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

/** Makes empty bins for a range; no bins if the range is empty. */
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
  // Make each bin contain the same number of integers.
  double width =
    areWhole ? std::ceil((range[1] - range[0] + 1.0) / MostBins) : (range[1] - range[0]) / MostBins;
  // Limit the bins' width from below: charts are drawn in single precision, which can't resolve
  // narrower bins.
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

/** Adds a value to its bin. VTK's vtkImageHistogram is not used, because ParaView lacks it. */
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

/**
 * A set of labels in a range: one bit per label, or a hash table if that would need too many bits.
 */
class LabelSet
{
public:
  LabelSet(std::int64_t from, std::int64_t to)
    : From(from)
    , Bits(to - from < MostBits ? static_cast<std::size_t>(to - from + 1) : 0)
  {
  }

  void Insert(int label)
  {
    if (this->Bits.empty())
    {
      this->Hashed.insert(label);
    }
    else
    {
      this->Bits[static_cast<std::size_t>(label - this->From)] = true;
    }
  }

  std::vector<int> List() const
  {
    std::vector<int> labels(this->Hashed.begin(), this->Hashed.end());
    std::sort(labels.begin(), labels.end());
    for (std::size_t i = 0; i < this->Bits.size(); ++i)
    {
      if (this->Bits[i])
      {
        labels.push_back(static_cast<int>(this->From + static_cast<std::int64_t>(i)));
      }
    }
    return labels;
  }

private:
  static constexpr std::int64_t MostBits = std::int64_t{ 1 } << 27; // bits: 16 MiB

  std::int64_t From;
  std::vector<bool> Bits;
  std::unordered_set<int> Hashed;
};

bool IsTableLabel(double value)
{
  constexpr double least = std::numeric_limits<int>::min();
  constexpr double most = std::numeric_limits<int>::max();
  // The condition is false for NaN, too. Rounding can't move a number outside int into the range.
  return value >= least && value <= most && value == std::floor(value);
}

/** Calls a function at least once with every value in the array that can be a label. */
template <typename Function>
struct LabelVisitor
{
  const vtkIdType Begin;
  const vtkIdType End;
  Function& Visit;

  template <typename ArrayType>
  void operator()(ArrayType* scalars)
  {
    bool isFirst = true;
    vtk::GetAPIType<ArrayType> last{};
    for (const auto tuple : vtk::DataArrayTupleRange(scalars, this->Begin, this->End))
    {
      const vtk::GetAPIType<ArrayType> value = tuple[0];
      // Skip repetitions, because neighbours usually have the same label.
      if (isFirst || value != last)
      {
        isFirst = false;
        last = value;
        if (IsTableLabel(static_cast<double>(value)))
        {
          this->Visit(static_cast<int>(value));
        }
      }
    }
  }
};

template <typename Function>
void VisitLabels(vtkDataArray* scalars, vtkIdType begin, vtkIdType end, Function& visit)
{
  LabelVisitor<Function> visitor{ begin, end, visit };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, visitor))
  {
    visitor(scalars);
  }
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
  vtkNew<vtkDoubleArray> values, fractions;
  values->SetName("value");
  fractions->SetName("share");
  double largest = 0.0;
  for (std::size_t i = 0; i < counts.Counts.size(); ++i)
  {
    values->InsertNextValue(counts.Origin + static_cast<double>(i) * counts.Width);
    const double fraction = std::log1p(static_cast<double>(counts.Counts[i]));
    fractions->InsertNextValue(fraction);
    largest = std::max(largest, fraction);
  }
  for (vtkIdType i = 0; i < fractions->GetNumberOfValues() && largest > 0.0; ++i)
  {
    fractions->SetValue(i, fractions->GetValue(i) / largest);
  }
  table->AddColumn(values);
  table->AddColumn(fractions);
}

std::vector<int> CollectSpreadLabels(vtkDataArray* labels)
{
  std::vector<int> found;
  VisitSpreadValues(labels, 0,
    [&found](double value)
    {
      if (IsTableLabel(value))
      {
        found.push_back(static_cast<int>(value));
      }
    });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<int> CollectPresentLabels(vtkDataArray* labels, const SweepProgress& progress)
{
  const auto visitAll = [&](double before, auto& visit)
  {
    return VisitPieces(labels, before, progress,
      [&](vtkIdType begin, vtkIdType end) { VisitLabels(labels, begin, end, visit); });
  };
  // Compute the range here: VTK would cache it until the array is modified, but values may change
  // without that.
  int from = std::numeric_limits<int>::max();
  int to = std::numeric_limits<int>::min();
  const auto widen = [&](int label)
  {
    from = std::min(from, label);
    to = std::max(to, label);
  };
  if (!visitAll(0.0, widen) || from > to)
  {
    return {};
  }
  LabelSet found(from, to);
  const auto insert = [&found](int label) { found.Insert(label); };
  return visitAll(0.5, insert) ? found.List() : std::vector<int>();
}

} // namespace VolumeHaptics
