// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include "CostFit.h"
#include "Likeness.h"
#include "Relief.h"

namespace evaluation
{

Comparison CompareMethods(vtkImageData* volume, const Effort& effort)
{
  Comparison all;
  all.Tables.push_back(MeasureCost(effort, all.Plots));
  Table likeness = MakeLikenessTable();
  for (const Subject& shape : MakeShapes())
  {
    CompareOn(shape, likeness);
  }
  std::string error;
  for (const Subject& bone : MakeBone(volume, BoneValue, effort, error))
  {
    CompareOn(bone, likeness);
  }
  likeness.Text += error.empty() ? "" : " Bone is left out. " + error;
  all.Tables.push_back(std::move(likeness));
  all.Tables.push_back(CompareRelief(effort, all.Plots));
  all.Tables.push_back(CompareStability(effort, all.Plots));
  return all;
}

} // namespace evaluation
