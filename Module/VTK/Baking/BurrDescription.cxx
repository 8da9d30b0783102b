// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/BurrDescription.h"

#include "VTK/Baking/ShellDescription.h"

#include "vtkHapticBurr.h"
#include "vtkHapticPointShell.h"

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

static_assert(int{ vtkHapticBurr::FROM_STRENGTH } == int{ vtkHapticPointShell::FROM_STRENGTH } &&
    int{ vtkHapticBurr::ABOVE } == int{ vtkHapticPointShell::ABOVE } &&
    int{ vtkHapticBurr::BELOW } == int{ vtkHapticPointShell::BELOW },
  "FindSolid() takes both");

/** The heads that models use, by their radius: a servo goes on with the points that it has. */
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
  const ToolNumber numbers[] = { { "Radius", burr->GetRadius(), "world units" },
    { "ContactArea", burr->GetContactArea(), "square world units" },
    { "CouplingStiffness", burr->GetCouplingStiffness(), "N/m" } };
  for (const ToolNumber& number : numbers)
  {
    if (!CheckToolNumber("vtkHapticBurr", number, error))
    {
      return false;
    }
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
  ShellDescription& shell = d.Tool.Shell;
  SolidLevel solid;
  if (!CheckNumbers(burr, d, error) ||
    !CheckToolVolume("vtkHapticBurr", "removes what is solid", d, error) ||
    !FindSolid(
      "vtkHapticBurr", burr->GetSolid(), burr->GetContactValue(), d.Material, solid, error))
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
  shell.Points = FindHead(burr->GetRadius());
  shell.Touch.Level = solid.Level;
  shell.Touch.IsBelow = solid.IsBelow;
  shell.Touch.ContactArea = burr->GetContactArea();
  shell.Touch.CouplingStiffness = burr->GetCouplingStiffness();
  return true;
}

} // namespace VolumeHaptics
