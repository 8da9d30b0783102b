// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticPresentLabels.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>

namespace VolumeHaptics
{
namespace
{

/** A set of labels in a range: a bit for each, or a hash table if the bits were too many. */
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
  static constexpr std::int64_t MostBits = std::int64_t{ 1 } << 27; // 16 MiB

  std::int64_t From;
  std::vector<bool> Bits;
  std::unordered_set<int> Hashed;
};

bool IsTableLabel(double value)
{
  constexpr double least = std::numeric_limits<int>::min();
  constexpr double most = std::numeric_limits<int>::max();
  // False for NaN, too. Rounding can't move a number beyond int into its range.
  return value >= least && value <= most && value == std::floor(value);
}

/** Calls a function at least once with every label that a table can have. */
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
      // Neighbours usually have the same label: skip repetitions.
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

std::vector<int> FindSpreadLabels(vtkDataArray* labels)
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

std::vector<int> FindPresentLabels(vtkDataArray* labels, const SweepProgress& progress)
{
  const auto visitAll = [&](double before, auto& visit)
  {
    return VisitPieces(labels, before, progress,
      [&](vtkIdType begin, vtkIdType end) { VisitLabels(labels, begin, end, visit); });
  };
  // Do not use VTK's range: VTK caches it until the array is modified, and an image may change
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
