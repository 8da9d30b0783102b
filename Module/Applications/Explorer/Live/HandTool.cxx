// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/HandTool.h"

#include "Applications/Explorer/Live/FreeFile.h"
#include "Applications/Explorer/Live/ToolFile.h"

#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <iostream>

namespace
{
/// N per metre of the shaft, where no label says it: that of soft tissue.
constexpr double SHAFT_FRICTION = 25.0;
} // namespace

namespace Explore
{
HandTool::HandTool(TouchScene& touch, const Exploration& exploration,
  vtkRenderWindowInteractor* interactor, const std::string& tool)
  : Device(touch.Device)
  , Filter(exploration.Filter)
  , Interactor(interactor)
{
  vtkPiecewiseFunction* const shaft = this->Needle->GetShaftFriction();
  const double skin = exploration.Values.OuterThreshold;
  shaft->AddPoint(skin, 0.0);
  shaft->AddPoint(skin + 1e-3 * (exploration.Values.Range[1] - skin), SHAFT_FRICTION);
  this->KeyObserver->SetClientData(this);
  this->KeyObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<HandTool*>(self)->PressKey(); });
  this->Interactor->AddObserver(vtkCommand::KeyPressEvent, this->KeyObserver);
  this->Shape->SetSolidToAbove();
  this->Shape->SetContactValue(skin);
  if (tool == "needle")
  {
    this->Take(this->Needle);
  }
  else if (!tool.empty())
  {
    this->Shape->SetMesh(ReadToolFile(tool));
    this->Take(this->Shape);
  }
}

HandTool::~HandTool()
{
  this->Interactor->RemoveObserver(this->KeyObserver);
}

void HandTool::PressKey()
{
  switch (this->Interactor->GetKeyCode())
  {
    case 'N':
      this->ChangeTool();
      break;
    case 'T':
      this->WriteTrack();
      break;
    default:
      break;
  }
}

void HandTool::ChangeTool()
{
  vtkHapticTool* const held = this->Filter->GetTool();
  if (!held)
  {
    this->Take(this->Needle);
  }
  else
  {
    this->Take(held == this->Needle.Get() && this->HasShape() ? this->Shape.Get() : nullptr);
  }
}

void HandTool::Take(vtkHapticTool* tool)
{
  vtkVolumeHapticsFilter* const filter = this->Filter;
  const std::string name = !tool ? "point"
    : tool == this->Needle.Get() ? "needle"
                                 : "tool with a shape";
  if (tool && filter->GetMethod() != vtkVolumeHapticsFilter::PROXY)
  {
    std::cout << "A " << name << " needs the method proxy, which key m gets to." << std::endl;
    return;
  }
  if (tool && this->Device->HasFrames())
  {
    std::cout << "A " << name << " is not for a volume that moves." << std::endl;
    return;
  }
  filter->SetTool(tool);
  std::cout << "The hand holds a " << name << "." << std::endl;
}

void HandTool::WriteTrack()
{
  vtkNew<vtkPolyData> track;
  this->Device->GetNeedleTrack(track);
  if (track->GetNumberOfCells() == 0)
  {
    std::cout << "The needle is not in tissue, and has no track." << std::endl;
    return;
  }
  const std::string file = FindFreeFile("track", ".vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(track);
  std::cout << (writer->Write() ? "Written: " : "Can't be written: ") << file << std::endl;
}
} // namespace Explore
