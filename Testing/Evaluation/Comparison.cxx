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
  const auto compare = [&](const std::vector<Subject>& subjects, const std::string& file)
  {
    for (const Subject& subject : subjects)
    {
      const std::string number = std::to_string(&subject - subjects.data() + 1);
      all.Plots.push_back(MakeLikenessPlot(file + "-" + number, subject.Name));
      CompareOn(subject, likeness, &all.Plots.back());
    }
  };
  compare(MakeShapes(), "likeness");
  std::string error;
  compare(MakeBone(volume, BoneValue, effort, error), "likeness-bone");
  likeness.Text += error.empty() ? "" : " Bone is left out. " + error;
  all.Tables.push_back(std::move(likeness));
  all.Tables.push_back(CompareRelief(effort, all.Plots));
  all.Tables.push_back(CompareStability(effort, all.Plots));
  return all;
}

} // namespace evaluation
