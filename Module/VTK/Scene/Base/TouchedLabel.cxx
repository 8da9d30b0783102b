// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/TouchedLabel.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkVolumeHapticsFilter.h"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/** Returns the point array of the labels: the chosen array, or the scalars. */
vtkDataArray* FindLabels(vtkVolumeHapticsFilter* filter, vtkImageData* image)
{
  vtkInformation* const choice = filter->GetInputArrayInformation(1);
  const char* const name = choice && choice->Has(vtkDataObject::FIELD_NAME())
    ? choice->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  return name ? image->GetPointData()->GetArray(name) : image->GetPointData()->GetScalars();
}

} // namespace

std::string NameLabelAt(vtkVolumeHapticsFilter* filter, const double position[3])
{
  constexpr int labelPort = 3;
  vtkHapticLabelTable* const table = filter ? filter->GetLabelTable() : nullptr;
  if (!table || filter->GetNumberOfInputConnections(labelPort) == 0)
  {
    return {};
  }
  auto* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(labelPort, 0));
  vtkDataArray* const labels = image ? FindLabels(filter, image) : nullptr;
  if (!labels || labels->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return {};
  }
  double continuous[3];
  image->TransformPhysicalPointToContinuousIndex(position, continuous);
  const int* const extent = image->GetExtent();
  int index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nearest = std::round(continuous[axis]);
    if (!(nearest >= extent[2 * axis] && nearest <= extent[2 * axis + 1]))
    {
      return {};
    }
    index[axis] = static_cast<int>(nearest);
  }
  const double label = labels->GetComponent(image->ComputePointId(index), 0);
  if (!(label >= std::numeric_limits<int>::min() && label <= std::numeric_limits<int>::max()) ||
    !table->HasLabel(static_cast<int>(label)))
  {
    return {};
  }
  const std::string name = table->GetLabelName(static_cast<int>(label));
  return name.empty() ? "label " + std::to_string(static_cast<int>(label)) : name;
}

} // namespace VolumeHaptics
