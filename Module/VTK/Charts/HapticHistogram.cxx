// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticHistogram.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Counts without VTK's vtkImageHistogram, which ParaView lacks. */
struct BinCounter
{
  const int Component;
  const double Origin; // the middle of the first bin
  const double Width;
  std::vector<vtkIdType>& Counts;

  template <typename ArrayType>
  void operator()(ArrayType* scalars)
  {
    const double last = static_cast<double>(this->Counts.size() - 1);
    for (const auto tuple : vtk::DataArrayTupleRange(scalars))
    {
      const double value = static_cast<double>(tuple[this->Component]);
      if (std::isfinite(value))
      {
        const double bin = std::floor((value - this->Origin) / this->Width + 0.5);
        ++this->Counts[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
      }
    }
  }
};

} // namespace

double EstimateHistogramTime(vtkImageData* image)
{
  constexpr double secondsPerSample = 6e-9; // measured on a desktop computer of 2023
  return image ? secondsPerSample * static_cast<double>(image->GetNumberOfPoints()) : 0.0;
}

bool FillHistogram(vtkImageData* image, int component, vtkTable* table, double range[2])
{
  table->Initialize();
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return false;
  }
  const int used = std::clamp(component, 0, scalars->GetNumberOfComponents() - 1);
  scalars->GetFiniteRange(range, used);
  if (!(range[0] <= range[1]))
  {
    return false;
  }
  range[0] = std::clamp(range[0], -FarthestShown, FarthestShown);
  range[1] = std::clamp(range[1], -FarthestShown, FarthestShown);
  constexpr int most = 128;
  const int type = scalars->GetDataType();
  double width = (range[1] - range[0]) / most;
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    // Each bin has to hold the same number of integers.
    width = std::ceil((range[1] - range[0] + 1.0) / most);
  }
  // Charts are drawn in single precision: bins that it can't tell apart are useless.
  constexpr double precision = 1e-7;
  const double least =
    std::max(1.0 / FarthestShown, precision * std::max(std::abs(range[0]), std::abs(range[1])));
  width = range[0] < range[1] ? std::max(width, least) : 1.0;
  const int bins = std::clamp(static_cast<int>((range[1] - range[0]) / width) + 1, 1, most);

  const double origin =
    range[0] + (type == VTK_FLOAT || type == VTK_DOUBLE ? 0.5 * width : 0.5 * (width - 1));
  std::vector<vtkIdType> counts(bins);
  BinCounter count{ used, origin, width, counts };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, count))
  {
    count(scalars);
  }

  vtkNew<vtkDoubleArray> values, shares;
  values->SetName("value");
  shares->SetName("share");
  double largest = 0.0;
  for (int i = 0; i < bins; ++i)
  {
    values->InsertNextValue(origin + i * width);
    shares->InsertNextValue(std::log1p(static_cast<double>(counts[i])));
    largest = std::max(largest, shares->GetValue(i));
  }
  for (int i = 0; i < bins && largest > 0.0; ++i)
  {
    shares->SetValue(i, shares->GetValue(i) / largest);
  }
  table->AddColumn(values);
  table->AddColumn(shares);
  return true;
}

} // namespace VolumeHaptics
