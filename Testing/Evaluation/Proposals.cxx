// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Proposals.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace evaluation
{
namespace
{
double NumberOf(vtkTable* boundaries, vtkIdType row, const char* column)
{
  return boundaries->GetValueByName(row, column).ToDouble();
}
} // namespace

Table MakeProposalTable()
{
  return { "Materials that the scans propose",
    "The boundaries that ProposeFromImage() finds, the most important one first: the values on "
    "both sides, the width s of the blurred step, the share of the area of all edges, and the "
    "strength of the higher side's surface.",
    { "scan", "from", "to", "s (mm)", "share (%)", "strength (N)", "kernel radius (voxels)" }, {} };
}

bool AddProposal(const char* scan, vtkImageData* image, Table& table)
{
  vtkNew<vtkHapticProperty> feel;
  if (!feel->ProposeFromImage(image))
  {
    return false;
  }
  vtkTable* const found = feel->GetProposedBoundaries();
  for (vtkIdType i = 0; i < found->GetNumberOfRows(); ++i)
  {
    const double high = NumberOf(found, i, "High");
    table.Rows.push_back({ scan, Number(NumberOf(found, i, "Low")), Number(high),
      Number(NumberOf(found, i, "Width")), Number(100.0 * NumberOf(found, i, "Share")),
      Number(feel->GetSurfaceStrength()->GetValue(high)),
      std::to_string(feel->GetProposedKernelRadius()) });
  }
  return true;
}

Figure CountMissingBoundaries(vtkImageData* head)
{
  const auto isSoft = [](double value) { return value > -50.0 && value < 100.0; };
  bool hasSkin = false;
  bool hasSkull = false;
  vtkNew<vtkHapticProperty> feel;
  vtkTable* const found = feel->ProposeFromImage(head) ? feel->GetProposedBoundaries() : nullptr;
  for (vtkIdType i = 0; found && i < found->GetNumberOfRows(); ++i)
  {
    const double low = NumberOf(found, i, "Low");
    const double high = NumberOf(found, i, "High");
    hasSkin = hasSkin || (low < -900.0 && isSoft(high));
    hasSkull = hasSkull || (isSoft(low) && high > 400.0);
  }
  return { "boundaries of skin and skull that the head CT's proposal lacks", "",
    (hasSkin ? 0.0 : 1.0) + (hasSkull ? 0.0 : 1.0), 0.0 };
}

} // namespace evaluation
