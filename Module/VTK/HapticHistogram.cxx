// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticHistogram.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImageHistogram.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

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
  constexpr int most = 128;
  const int type = scalars->GetDataType();
  double width = (range[1] - range[0]) / most;
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    // A bin has to hold as many whole numbers as the next one.
    width = std::ceil((range[1] - range[0] + 1.0) / most);
  }
  width = width > 0.0 ? width : 1.0;
  const int bins = std::clamp(static_cast<int>((range[1] - range[0]) / width) + 1, 1, most);

  vtkNew<vtkImageHistogram> histogram;
  histogram->SetInputData(image);
  histogram->SetActiveComponent(used);
  histogram->GenerateHistogramImageOff();
  histogram->AutomaticBinningOff();
  histogram->SetNumberOfBins(bins);
  histogram->SetBinSpacing(width);
  histogram->SetBinOrigin(
    range[0] + (type == VTK_FLOAT || type == VTK_DOUBLE ? 0.5 * width : 0.5 * (width - 1)));
  histogram->Update();
  vtkIdTypeArray* const counts = histogram->GetHistogram();

  vtkNew<vtkDoubleArray> values, shares;
  values->SetName("value");
  shares->SetName("share");
  double largest = 0.0;
  for (int i = 0; i < bins; ++i)
  {
    values->InsertNextValue(histogram->GetBinOrigin() + i * width);
    shares->InsertNextValue(std::log1p(static_cast<double>(counts->GetValue(i))));
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
