// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticPresentLabels.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>

namespace VolumeHaptics
{
namespace
{

/** A set of labels within a range: a bit for each, or if that were too many, a hash table. */
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

/** Calls a function with every label that a table can have, at least once. */
template <typename ArrayType, typename Function>
void VisitLabels(ArrayType* scalars, Function&& visit)
{
  constexpr double least = std::numeric_limits<int>::min();
  constexpr double most = std::numeric_limits<int>::max();
  bool isFirst = true;
  vtk::GetAPIType<ArrayType> last{};
  for (const auto tuple : vtk::DataArrayTupleRange(scalars))
  {
    const vtk::GetAPIType<ArrayType> value = tuple[0];
    // Neighbours mostly have the same label.
    if (isFirst || value != last)
    {
      isFirst = false;
      last = value;
      const double label = static_cast<double>(value);
      // False for NaN, too. Rounding can't move a number beyond int into it.
      if (label >= least && label <= most && label == std::floor(label))
      {
        visit(static_cast<int>(value));
      }
    }
  }
}

/** VTK keeps the range of an array until that is modified, which its image may be without. */
struct LabelCollector
{
  std::vector<int> Labels;

  template <typename ArrayType>
  void operator()(ArrayType* scalars)
  {
    int from = std::numeric_limits<int>::max();
    int to = std::numeric_limits<int>::min();
    VisitLabels(scalars,
      [&](int label)
      {
        from = std::min(from, label);
        to = std::max(to, label);
      });
    if (from <= to)
    {
      LabelSet labels(from, to);
      VisitLabels(scalars, [&labels](int label) { labels.Insert(label); });
      this->Labels = labels.List();
    }
  }
};

} // namespace

double EstimatePresentLabelsTime(vtkImageData* image)
{
  constexpr double secondsPerSample = 4e-9; // measured on a desktop computer of 2023
  return image ? secondsPerSample * static_cast<double>(image->GetNumberOfPoints()) : 0.0;
}

std::vector<int> FindPresentLabels(vtkImageData* image)
{
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return {};
  }
  LabelCollector collect;
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, collect))
  {
    collect(scalars);
  }
  return collect.Labels;
}

} // namespace VolumeHaptics
