// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/HandTool.h"

#include "Applications/Explorer/Live/FreeFile.h"
#include "Applications/Explorer/Live/ToolFile.h"

#include "VTK/Trace/TraceWriter.h"

#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <iostream>

namespace
{
/// Friction (N per metre of the shaft) where the label table sets none: a value for soft tissue.
constexpr double SHAFT_FRICTION = 25.0;
/// Energies (J/mm^3) for removing the softest and the hardest tissue. With these values, 2 N drill
/// soft tissue at once, and hard bone within seconds. They are examples, not measurements.
constexpr double LEAST_ENERGY = 0.5;
constexpr double MOST_ENERGY = 10.0;
/// Radius of the burr (voxels).
constexpr double BURR_RADIUS = 4.0;

double ComputeVoxel(vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  return std::cbrt(std::abs(spacing[0] * spacing[1] * spacing[2]));
}
} // namespace

namespace Explore
{
HandTool::HandTool(TouchScene& touch, const Exploration& exploration, const std::string& tool)
  : Touch(touch)
  , Device(touch.Device)
  , Filter(exploration.Filter)
{
  vtkPiecewiseFunction* const shaft = this->Needle->GetShaftFriction();
  const double skin = exploration.Values.OuterThreshold;
  shaft->AddPoint(skin, 0.0);
  shaft->AddPoint(skin + 1e-3 * (exploration.Values.Range[1] - skin), SHAFT_FRICTION);
  if (exploration.Materials.compare(0, 3, "CT ") == 0)
  {
    this->Needle->ApplyPreset(exploration.Materials.c_str());
  }
  this->Shape->SetSolidToAbove();
  this->Shape->SetContactValue(skin);
  this->Burr->SetSolidToAbove();
  this->Burr->SetContactValue(skin);
  this->Burr->GetSpecificEnergy()->AddPoint(skin, LEAST_ENERGY);
  this->Burr->GetSpecificEnergy()->AddPoint(exploration.Values.Range[1], MOST_ENERGY);
  if (vtkImageData* const image = this->Filter->GetTouchedImage())
  {
    this->Burr->SetRadius(BURR_RADIUS * ComputeVoxel(image));
  }
  if (tool == "needle")
  {
    this->Hold(this->Needle);
  }
  else if (tool == "burr")
  {
    this->Hold(this->Burr);
  }
  else if (!tool.empty())
  {
    this->Shape->SetMesh(ReadToolFile(tool));
    this->Hold(this->Shape);
  }
  this->AddCommands();
}

HandTool::~HandTool()
{
  this->Touch.Commands.Remove(this);
}

void HandTool::AddCommands()
{
  CommandTable& table = this->Touch.Commands;
  const auto add = [&](const char* name, vtkHapticTool* tool)
  {
    table.Add(this,
      { "Tool", name, "", [this, tool] { this->Hold(tool); },
        [this, tool] { return this->Filter->GetTool() == tool; },
        [this, tool] { return tool != this->Shape.Get() || this->HasShape(); } });
  };
  add("point", nullptr);
  add("needle", this->Needle);
  add("burr: removes tissue while the left button is pressed", this->Burr);
  add("the tool from the file", this->Shape);
  table.Add(
    this, { "Tool", "the next tool", "w", [this] { this->ChangeTool(); }, nullptr, nullptr });
  table.Add(this,
    { "Tool", "save the track; what was removed", "Ctrl+e", [this] { this->Write(); }, nullptr,
      nullptr });
  const auto isBurr = [this] { return this->Filter->GetTool() == this->Burr.Get(); };
  const auto undo = [this]
  {
    this->Tell(
      this->Filter->GetRemoval()->Undo() ? "Burr stroke undone." : "No burr stroke to undo.");
  };
  const auto redo = [this]
  {
    this->Tell(
      this->Filter->GetRemoval()->Redo() ? "Burr stroke redone." : "No burr stroke to redo.");
  };
  const auto addStroke = [&](const char* text, const char* key, const std::function<void()>& run)
  {
    Command command{ "Tool", text, key, run, nullptr, isBurr };
    command.TakesKey = [this] // over the function editor, the key belongs to the editor
    {
      const int* const at = this->Touch.Commands.GetInteractor()->GetEventPosition();
      return !this->Touch.Editor->Contains(at[0], at[1]);
    };
    table.Add(this, command);
  };
  addStroke("undo a stroke of the burr", "Ctrl+z", undo);
  addStroke("redo a stroke of the burr", "Ctrl+y", redo);
}

void HandTool::Tell(const std::string& text)
{
  std::cout << text << std::endl;
  this->Touch.Display->SetNotice(text.c_str());
}

void HandTool::ChangeTool()
{
  vtkHapticTool* const held = this->Filter->GetTool();
  if (!held)
  {
    this->Hold(this->Needle);
  }
  else if (held == this->Needle.Get())
  {
    this->Hold(this->Burr);
  }
  else
  {
    this->Hold(held == this->Burr.Get() && this->HasShape() ? this->Shape.Get() : nullptr);
  }
}

void HandTool::Hold(vtkHapticTool* tool)
{
  vtkVolumeHapticsFilter* const filter = this->Filter;
  const std::string name = tool ? tool->GetText() : "point";
  if (tool && filter->GetMethod() != vtkVolumeHapticsFilter::PROXY)
  {
    this->Tell("A " + name + " needs the method proxy (key m).");
    return;
  }
  if (tool && this->Device->GetPlayback()->HasTimeSteps())
  {
    this->Tell("A " + name + " can't touch a volume that moves.");
    return;
  }
  filter->SetTool(tool);
  if (this->Device->IsRunning())
  {
    // Publish now, because the next publication by the style would remove the notice below.
    this->Device->Publish();
  }
  this->Tell("The hand holds a " + name + ".");
}

void HandTool::Write()
{
  if (this->Filter->GetTool() == this->Burr.Get())
  {
    this->WriteRemoval();
  }
  else
  {
    this->WriteTrack();
  }
}

void HandTool::WriteRemoval()
{
  vtkHapticRemoval* const removal = this->Filter->GetRemoval();
  if (removal->IsEmpty())
  {
    this->Tell("The burr has removed nothing yet.");
    return;
  }
  const std::string file = FindFreePath("removal", ".vti");
  const double volume = removal->GetRemovedVolume();
  const bool isWritten = removal->WriteFile(file);
  this->WrittenVolume = isWritten ? volume : this->WrittenVolume;
  this->Tell((isWritten ? "Written: " : "Can't be written: ") + file);
}

bool HandTool::HasUnwrittenRemoval() const
{
  vtkHapticRemoval* const removal = this->Filter->GetRemoval();
  return !removal->IsEmpty() && removal->GetRemovedVolume() != this->WrittenVolume;
}

void HandTool::WriteTrack()
{
  vtkNew<vtkPolyData> track;
  this->Device->GetState()->GetNeedleTrack(track);
  if (track->GetNumberOfCells() == 0)
  {
    this->Tell("No track: the needle is not in tissue.");
    return;
  }
  const std::string file = FindFreePath("track", ".vtp");
  std::string error;
  const bool isWritten = VolumeHaptics::WriteTracePolyData(track, file, error);
  this->Tell(isWritten ? "Written: " + file : "Can't be written: " + file + ": " + error);
}
} // namespace Explore
