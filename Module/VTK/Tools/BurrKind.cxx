// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Burr/BakedBurr.h"
#include "VTK/Tools/ShellDescription.h"

#include "vtkAppendPolyData.h"
#include "vtkHapticBurr.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr double SecondsOfMinute = 60.0;

/**
 * Returns the head of a burr with this radius. All models with this radius share it, so that a
 * servo keeps its points.
 */
std::shared_ptr<const PointShell> GetHead(double radius)
{
  static std::mutex mutex;
  // Never destroyed, because a filter may exist until the process exits.
  static auto* const heads = new std::map<double, std::weak_ptr<const PointShell>>;
  const std::lock_guard<std::mutex> lock(mutex);
  for (auto i = heads->begin(); i != heads->end();)
  {
    i = i->second.expired() ? heads->erase(i) : std::next(i);
  }
  auto head = (*heads)[radius].lock();
  if (!head)
  {
    head = std::make_shared<const PointShell>(BakedBurr::MakeHead(radius));
    (*heads)[radius] = head;
  }
  return head;
}

bool CheckNumbers(vtkHapticBurr* burr, const HapticModelDescription& d, std::string& error)
{
  if (!CheckToolNumber(burr, { "Radius", burr->GetRadius(), "world units" }, error))
  {
    return false;
  }
  const double voxel = std::cbrt(std::abs(Determinant(d.IndexToWorld.Linear)));
  if (burr->GetRadius() < voxel)
  {
    std::ostringstream text;
    text << "The Radius of the vtkHapticBurr is " << burr->GetRadius()
         << " world units, less than a voxel of the volume (" << voxel
         << "): what it removes would have no shape. Set it to some voxels with SetRadius().";
    error = text.str();
    return false;
  }
  if (!std::isfinite(burr->GetSpeed()) || !std::isfinite(burr->GetFriction()))
  {
    error = "The Speed or the Friction of the vtkHapticBurr is not a finite number. Set them with "
            "SetSpeed() and SetFriction().";
    return false;
  }
  return true;
}

/** Size of a burr's shaft, in radii of its head. The shaft extends along +z, towards the handle. */
constexpr double ShaftRadius = 0.35;
constexpr double ShaftLength = 9.0;
/**
 * Blades: number of blades on the head. BladeDepth: depth of the grooves between them, in radii.
 */
constexpr int Blades = 8;
constexpr double BladeDepth = 0.12;
constexpr int HeadResolution = 64;

vtkSmartPointer<vtkPolyData> MakeBladedHead(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(HeadResolution);
  sphere->SetPhiResolution(HeadResolution / 2);
  sphere->Update();
  vtkPolyData* const head = sphere->GetOutput();
  vtkPoints* const points = head->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    // The blades twist with the height. Between them, the surface is nearer to the centre.
    const double turn = std::atan2(x[1], x[0]) + x[2] / radius;
    const double between = 0.5 - 0.5 * std::cos(Blades * turn);
    const double fraction = 1.0 - BladeDepth * between * std::hypot(x[0], x[1]) / radius;
    points->SetPoint(i, fraction * x[0], fraction * x[1], fraction * x[2]);
  }
  return head;
}

vtkSmartPointer<vtkPolyData> MakeBurr(double radius)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0.0, 0.0, 0.0);
  line->SetPoint2(0.0, 0.0, ShaftLength * radius);
  vtkNew<vtkTubeFilter> shaft;
  shaft->SetInputConnection(line->GetOutputPort());
  shaft->SetRadius(ShaftRadius * radius);
  shaft->SetNumberOfSides(24);
  shaft->CappingOn();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(MakeBladedHead(radius));
  both->AddInputConnection(shaft->GetOutputPort());
  both->Update();
  return both->GetOutput();
}

class BurrKind final : public ToolKindOf<vtkHapticBurr, HapticBurrSettings>
{
public:
  using ToolKindOf::ToolKindOf;

  std::vector<ToolFunction> GetFunctions() const override
  {
    return { { "SpecificEnergy", "J/mm^3",
      [](vtkHapticTool* tool) { return vtkHapticBurr::SafeDownCast(tool)->GetSpecificEnergy(); },
      10.0 } };
  }
  const ToolColumns& GetColumns() const override { return BakedBurr::Columns(); }
  void Describe(vtkHapticTool* tool, ToolPlan& plan) const override;
  vtkSmartPointer<vtkPolyData> MakeShape(vtkHapticTool* tool) const override
  {
    return MakeBurr(vtkHapticBurr::SafeDownCast(tool)->GetRadius());
  }
  double ComputeReach(vtkHapticTool* tool) const override
  {
    return vtkHapticBurr::SafeDownCast(tool)->GetRadius();
  }
  /** The head is a ball, which has no felt orientation, so draw it with that of the stylus. */
  bool TurnsWithStylus() const override { return true; }
  bool IsTurnable() const override { return true; }
};

void BurrKind::Describe(vtkHapticTool* tool, ToolPlan& plan) const
{
  auto* const burr = vtkHapticBurr::SafeDownCast(tool);
  BurrDescription described;
  if (!CheckNumbers(burr, plan.Model, plan.Error) ||
    !DescribeShapedTool(burr, "removes what is solid", plan, described.Head))
  {
    return;
  }
  BurrSettings& settings = described.Settings;
  settings.Radius = burr->GetRadius();
  settings.Speed = burr->GetSpeed() / SecondsOfMinute;
  settings.Friction = burr->GetFriction();
  settings.Vibration = burr->GetVibration();
  settings.SpinButton = burr->GetSpinButton();
  described.Head.Points = GetHead(burr->GetRadius());
  described.SpecificEnergy = this->ReadFunction(this->GetFunctions()[0], tool, plan);
  plan.Tool = std::make_shared<const BakedBurr>(std::move(described));
}

} // namespace

const ToolKind& GetBurrKind();
const ToolKind& GetBurrKind()
{
  static const auto* const kind = new BurrKind("Burr", "burr");
  return *kind;
}

} // namespace VolumeHaptics
