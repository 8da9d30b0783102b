// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/LabelMap.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace
{
constexpr std::size_t MOST_LABELS = 512;
constexpr double HIGHEST_LABEL = 65535.0; // FreeSurfer's labels are above 10000
// smallest fraction of the neighbours along rows that must be equal
constexpr double LEAST_ALIKE = 0.75;
// largest fraction of the voxels at a step whose values may be within the step
constexpr double MOST_BETWEEN = 0.05;
constexpr vtkIdType MOST_ROWS = 20000;
} // namespace

namespace Explore
{
bool LooksLikeLabels(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  const int* const size = image->GetDimensions();
  double range[2];
  if (!values || values->GetNumberOfComponents() != 1 || size[0] < 3)
  {
    return false;
  }
  values->GetFiniteRange(range, 0);
  if (range[0] < 0.0 || range[1] > HIGHEST_LABEL || range[1] <= range[0])
  {
    return false;
  }
  const vtkIdType rows = static_cast<vtkIdType>(size[1]) * size[2];
  const vtkIdType every = rows / MOST_ROWS + 1;
  std::set<double> labels;
  std::int64_t pairs = 0, alike = 0, steps = 0, between = 0;
  for (vtkIdType row = 0; row < rows; row += every)
  {
    double before[2] = { 0.0, 0.0 };
    for (int i = 0; i < size[0]; ++i)
    {
      const double value = values->GetComponent(row * size[0] + i, 0);
      if (value != std::floor(value))
      {
        return false;
      }
      if (i == 0 || value != before[1])
      {
        labels.insert(value);
        if (labels.size() > MOST_LABELS)
        {
          return false;
        }
      }
      if (i > 0)
      {
        ++pairs;
        alike += value == before[1];
      }
      if (i > 1 && value != before[0])
      {
        ++steps;
        const auto [low, high] = std::minmax(value, before[0]);
        between += before[1] > low && before[1] < high;
      }
      before[0] = before[1];
      before[1] = value;
    }
  }
  return alike >= LEAST_ALIKE * static_cast<double>(pairs) &&
    between <= MOST_BETWEEN * static_cast<double>(std::max<std::int64_t>(steps, 1));
}
} // namespace Explore
