// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/ToolDevice.h"

#include "Applications/DeviceTool/LiveLine.h"

#include <vtkCallbackCommand.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>

bool ToolStreams::AskForEnter(const char* wish)
{
  this->Out << wish << std::endl;
  std::string enter;
  if (std::getline(this->In, enter))
  {
    return true;
  }
  this->Errors << "Enter was not pressed.\n";
  return false;
}

ToolDevice::ToolDevice(std::ostream& errors)
  : Errors(errors)
{
  vtkNew<vtkCallbackCommand> print;
  print->SetClientData(this);
  print->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* text)
    {
      // VTK writes the object's address before the text, and blank lines after it.
      const std::string message = static_cast<const char*>(text);
      const std::size_t begin = message.find("): ");
      const std::size_t end = message.find_last_not_of('\n') + 1;
      const std::size_t first = begin == std::string::npos ? 0 : begin + 3;
      auto* const tool = static_cast<ToolDevice*>(self);
      tool->Errors << message.substr(first, end - first) << "\n";
      ++tool->Complaints;
    });
  for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    this->Device->AddObserver(event, print);
    this->Volume->AddObserver(event, print);
  }
}

bool ConfirmSigns(ToolDevice& device, const char* id, ToolStreams streams)
{
  constexpr auto period = std::chrono::milliseconds(100);
  device->ForgetConfirmation();
  if (!device->Start() ||
    !streams.AskForEnter("Hold the device loosely in the middle of its workspace and press Enter. "
                         "Keep the hand still: for about ten seconds it pushes gently along each "
                         "axis."))
  {
    return false;
  }
  device->Arm();
  LiveLine line(streams.Out);
  while (!device->GetSignsConfirmed())
  {
    std::this_thread::sleep_for(period);
    device->UpdateState();
    if (device->GetStatus() == vtkHapticDevice::FAULT)
    {
      line.End();
      streams.Errors << device->GetStatusText() << "\n";
      return false;
    }
    line.Show("Confirming ...");
  }
  line.End();
  device->Stop();
  streams.Out << id << " moves with the force along every axis. " << DescribeMemory(device) << "\n";
  return true;
}

const char* DescribeMemory(ToolDevice& device)
{
  return device->IsRemembered()
    ? "This is remembered."
    : "This is not remembered: it has no serial number that tells it from other devices.";
}
