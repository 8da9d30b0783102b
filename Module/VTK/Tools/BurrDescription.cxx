// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/BurrDescription.h"

#include "VTK/Tools/ShellDescription.h"

#include "vtkHapticBurr.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

constexpr double SecondsOfMinute = 60.0;

/**
 * Returns the head of a radius, shared with the models that use it: a servo keeps the points that
 * it has.
 */
std::shared_ptr<const PointShell> FindHead(double radius)
{
  static std::mutex mutex;
  // Never destroyed: a filter may live until the process exits.
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

} // namespace

bool DescribeBurr(vtkHapticBurr* burr, HapticModelDescription& d, std::string& error)
{
  if (!CheckNumbers(burr, d, error) || !DescribeShapedTool(burr, "removes what is solid", d, error))
  {
    return false;
  }
  d.Tool.Kind = ToolKind::Burr;
  BurrSettings& settings = d.Tool.Burr.Settings;
  settings.Radius = burr->GetRadius();
  settings.Speed = burr->GetSpeed() / SecondsOfMinute;
  settings.Friction = burr->GetFriction();
  settings.Vibration = burr->GetVibration();
  settings.SpinButton = burr->GetSpinButton();
  d.Tool.Shell.Points = FindHead(burr->GetRadius());
  return true;
}

} // namespace VolumeHaptics
