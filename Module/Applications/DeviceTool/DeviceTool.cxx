// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/DeviceTool.h"

#include "Applications/DeviceTool/GentleWall.h"
#include "Applications/DeviceTool/LiveLine.h"
#include "Applications/DeviceTool/ToolOptions.h"

#include <vtkCallbackCommand.h>
#include <vtkHapticDevice.h>
#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkVolumeHapticsFilter.h>

#include <chrono>
#include <iomanip>
#include <iostream>
#include <thread>

namespace
{

using Command = ToolOptions::Command;

constexpr double RecordSeconds = 10.0;
constexpr auto ShowPeriod = std::chrono::milliseconds(100);

/// A device whose errors go to a stream, in readable form.
class ToolDevice
{
public:
  explicit ToolDevice(std::ostream& errors)
  {
    vtkNew<vtkCallbackCommand> print;
    print->SetClientData(&errors);
    print->SetCallback(
      [](vtkObject*, unsigned long, void* stream, void* text)
      {
        // VTK puts the object's address before the text, and blank lines after it.
        const std::string message = static_cast<const char*>(text);
        const std::size_t begin = message.find("): ");
        const std::size_t end = message.find_last_not_of('\n') + 1;
        const std::size_t first = begin == std::string::npos ? 0 : begin + 3;
        *static_cast<std::ostream*>(stream) << message.substr(first, end - first) << "\n";
      });
    for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      this->Device->AddObserver(event, print);
      this->Wall->AddObserver(event, print);
    }
  }
  vtkHapticDevice* operator->() { return this->Device; }
  vtkHapticDevice* Get() { return this->Device; }
  vtkVolumeHapticsFilter* GetWall() { return this->Wall; }

private:
  vtkNew<vtkVolumeHapticsFilter> Wall;
  vtkNew<vtkHapticDevice> Device;
};

int List(std::ostream& out)
{
  vtkNew<vtkTable> devices;
  vtkHapticDevice::ListDevices(devices);
  for (vtkIdType i = 0; i < devices->GetNumberOfRows(); ++i)
  {
    out << std::left << std::setw(16) << devices->GetValueByName(i, "Id").ToString() << "  "
        << devices->GetValueByName(i, "Name").ToString() << "\n"
        << std::string(18, ' ') << devices->GetValueByName(i, "State").ToString() << "\n";
    const std::string force = devices->GetValueByName(i, "Force").ToString();
    out << (force.empty() ? "" : std::string(18, ' ') + "force: " + force + "\n");
  }
  if (devices->GetNumberOfRows() == 1)
  {
    out << "No haptic device is plugged in.\n";
  }
  return 0;
}

/// Waits for Enter; false if the input ends before.
bool AskForEnter(const char* wish, std::istream& in, std::ostream& out, std::ostream& errors)
{
  out << wish << std::endl;
  std::string enter;
  if (std::getline(in, enter))
  {
    return true;
  }
  errors << "Enter was not pressed.\n";
  return false;
}

/// Shows the requests to the hand until the device is ready; false if it won't be.
bool MakeReady(ToolDevice& device, const ToolOptions& options, std::istream& in, std::ostream& out,
  std::ostream& errors)
{
  const bool isWooden = options.Id.compare(0, 6, "wooden") == 0;
  // A WoodenHaptics asks for its rest pose whenever it is opened.
  if (options.What == Command::Home && !isWooden)
  {
    device->Home();
  }
  LiveLine line(out);
  for (;;)
  {
    const int status = device->GetStatus();
    const std::string text = device->GetStatusText();
    const bool asksForHome =
      status == vtkHapticDevice::HOMING && text.find("press Home()") != std::string::npos;
    if (asksForHome)
    {
      line.End();
      out << text << "\n";
      if (!AskForEnter(
            "Put the arm into its rest pose, hold it there and press Enter.", in, out, errors))
      {
        return false;
      }
      device->Home();
    }
    else if (status == vtkHapticDevice::HOMING || status == vtkHapticDevice::FIRMWARE)
    {
      line.Show(text);
      std::this_thread::sleep_for(ShowPeriod);
    }
    else if (status == vtkHapticDevice::FAULT)
    {
      line.End();
      errors << text << "\n";
      return false;
    }
    else
    {
      break;
    }
  }
  line.End();
  out << options.Id << " is ready.\n";
  return true;
}

/// Shows the live state for some seconds (0: until interrupted); false if the device is lost
/// meanwhile.
bool Watch(ToolDevice& device, double seconds, std::ostream& out, std::ostream& errors)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  LiveLine line(out);
  while (seconds <= 0.0 || Clock::now() - start < std::chrono::duration<double>(seconds))
  {
    device->UpdateState();
    if (device->GetStatus() == vtkHapticDevice::FAULT)
    {
      line.End();
      errors << device->GetStatusText() << "\n";
      return false;
    }
    line.Show(DescribeState(device.Get()));
    std::this_thread::sleep_for(ShowPeriod);
  }
  return true;
}

/// Pushes gently along each axis, until it is known whether the device moves with the force.
bool Confirm(ToolDevice& device, const ToolOptions& options, std::istream& in, std::ostream& out,
  std::ostream& errors)
{
  if (device->GetCalibrationText().empty())
  {
    errors << options.Id << " gives no force of its own: there is nothing to confirm.\n";
    return false;
  }
  device->ForgetConfirmation();
  if (!device->Start() ||
    !AskForEnter("Hold the device loosely in the middle of its workspace and press Enter. Keep the "
                 "hand still: for about ten seconds it pushes gently along each axis.",
      in, out, errors))
  {
    return false;
  }
  device->Arm();
  LiveLine line(out);
  while (!device->GetSignsConfirmed())
  {
    std::this_thread::sleep_for(ShowPeriod);
    device->UpdateState();
    if (device->GetStatus() == vtkHapticDevice::FAULT)
    {
      line.End();
      errors << device->GetStatusText() << "\n";
      return false;
    }
    line.Show("Confirming ...");
  }
  line.End();
  device->Stop();
  out << options.Id << " moves with the force along every axis. This is remembered.\n";
  return true;
}

bool Test(ToolDevice& device, const ToolOptions& options, std::istream& in, std::ostream& out,
  std::ostream& errors)
{
  if (device->GetMaximumForce() <= 0.0)
  {
    errors << options.Id << " gives no force: there is nothing to feel. Try monitor.\n";
    return false;
  }
  const bool isStick = options.Id.compare(0, 3, "pid") == 0;
  const int axis = options.Axis >= 0 ? options.Axis : isStick ? 0 : 2;
  MakeGentleWall(device.GetWall(), axis);
  device->SetVolumeHaptics(device.GetWall());
  device->SetMaximumForce(GentleForce);
  if (!device->Start())
  {
    return false;
  }
  out << "There is a wall in the middle of the workspace, on the negative side of "
      << "xyz"[axis] << ". It pushes with at most " << GentleForce << " N.\n";
  if (isStick && !options.HasNewtons)
  {
    out << "That is if its force at full scale is " << options.Newtons[0]
        << " N. Most devices have less and are hardly felt: measure it, then say so with "
           "--newtons.\n";
  }
  if (!AskForEnter("Take the device in your hand and press Enter to arm it; Ctrl+C ends at once.",
        in, out, errors))
  {
    return false;
  }
  if (!device->GetSignsConfirmed())
  {
    out << "It was never found out whether it moves with the force: hold it loosely and keep the "
           "hand still. For about ten seconds it pushes gently along each axis; then comes the "
           "wall.\n";
  }
  device->Arm();
  return Watch(device, options.Seconds, out, errors);
}

bool Record(ToolDevice& device, const ToolOptions& options, std::ostream& out, std::ostream& errors)
{
  // With a wall to touch, though not armed: a recording needs one.
  MakeGentleWall(device.GetWall(), 2);
  device->SetVolumeHaptics(device.GetWall());
  if (!device->Start() || !device->StartRecording(options.File.c_str()))
  {
    return false;
  }
  const double seconds = options.Seconds > 0.0 ? options.Seconds : RecordSeconds;
  const bool isWhole = Watch(device, seconds, out, errors);
  if (!device->StopRecording())
  {
    return false;
  }
  out << "Recorded to " << options.File << "\n";
  return isWhole;
}

} // namespace

int RunDeviceTool(const std::vector<std::string>& arguments, std::istream& in, std::ostream& out,
  std::ostream& errors)
{
  ToolOptions options;
  std::string error;
  if (!ReadToolOptions(arguments, options, error))
  {
    errors << error << "\n";
    return 2;
  }
  if (options.What == Command::Help)
  {
    out << ToolUsage;
    return 0;
  }
  if (options.What == Command::List)
  {
    return List(out);
  }

  ToolDevice device(errors);
  if (!options.Firmware.empty())
  {
    device->SetFirmwareFile(options.Firmware);
  }
  device->SetHomingTime(options.HomingTime);
  device->SetNewtonsPerFullScale(options.Newtons);
  device->SetServoRate(options.ServoRate);
  bool done = device->Open(options.Id.c_str()) && MakeReady(device, options, in, out, errors);
  if (done && options.What == Command::Test)
  {
    done = Test(device, options, in, out, errors);
  }
  else if (done && options.What == Command::Confirm)
  {
    done = Confirm(device, options, in, out, errors);
  }
  else if (done && options.What == Command::Record)
  {
    done = Record(device, options, out, errors);
  }
  else if (done && options.What == Command::Monitor)
  {
    done = device->Start() && Watch(device, options.Seconds, out, errors);
  }
  return done ? 0 : 1;
}
