// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/BakedNeedle.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkHapticNeedle.h"
#include "vtkPiecewiseFunction.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

class NeedleKind final : public ToolKindOf<vtkHapticNeedle, NeedleSettings>
{
public:
  using ToolKindOf::ToolKindOf;

  std::vector<ToolFunction> GetFunctions() const override
  {
    using N = vtkHapticNeedle;
    return { { "ShaftFriction", "N/m",
               [](vtkHapticTool* tool) { return N::SafeDownCast(tool)->GetShaftFriction(); } },
      { "CuttingForce", "N",
        [](vtkHapticTool* tool) { return N::SafeDownCast(tool)->GetCuttingForce(); } } };
  }
  const ToolColumns& GetColumns() const override { return BakedNeedle::Columns(); }
  void Describe(vtkHapticTool* tool, ToolPlan& plan) const override;
  bool HasShaft() const override { return true; }
};

void NeedleKind::Describe(vtkHapticTool* tool, ToolPlan& plan) const
{
  auto* const needle = vtkHapticNeedle::SafeDownCast(tool);
  if (plan.Model.Settings.Method != HapticMethod::Proxy)
  {
    plan.Error = "A vtkHapticNeedle punctures surfaces, which only the method PROXY knows. Choose "
                 "it with SetMethodToProxy(), or remove the needle with SetTool(nullptr).";
    return;
  }
  if (!plan.Model.TimeSteps.empty())
  {
    plan.Error = "A vtkHapticNeedle can't be inserted into a volume that moves, and the image on "
                 "input port 0 has several frames. Stop time with SetTimeUnitsPerSecond(0), or "
                 "remove the needle with SetTool(nullptr).";
    return;
  }
  NeedleDescription described;
  described.LateralStrength = needle->GetLateralStrength();
  described.HasCuttingForce = needle->GetCuttingForce()->GetSize() > 0;
  if (!std::isfinite(described.LateralStrength))
  {
    plan.Error = "The LateralStrength of the vtkHapticNeedle is not a finite number. Set it with "
                 "SetLateralStrength().";
    return;
  }
  const std::vector<ToolFunction> functions = this->GetFunctions();
  described.ShaftFriction = this->ReadFunction(functions[0], tool, plan);
  described.CuttingForce = this->ReadFunction(functions[1], tool, plan);
  plan.Tool = std::make_shared<const BakedNeedle>(std::move(described));
}

} // namespace

const ToolKind& GetNeedleKind();
const ToolKind& GetNeedleKind()
{
  static const auto* const kind = new NeedleKind("Needle", "needle");
  return *kind;
}

} // namespace VolumeHaptics
