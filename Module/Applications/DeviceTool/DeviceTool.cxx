// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/DeviceTool.h"

#include "Applications/DeviceTool/Calibrate.h"
#include "Applications/DeviceTool/LiveLine.h"
#include "Applications/DeviceTool/ToolDevice.h"
#include "Applications/DeviceTool/ToolOptions.h"
#include "Applications/DeviceTool/WorkspaceVolume.h"

#include <chrono>
#include <iomanip>
#include <iostream>
#include <thread>
#include <vtkHapticProperty.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkVolumeHapticsFilter.h>

class vtkVolumeHapticsFilter;

namespace
{

/// Largest force on the hand (N).
constexpr double GentleForce = 1.0;

constexpr double Stiffness = 200.0; // N/m: the largest force is reached after 5 mm
// N, much more than the force on the hand, so that the hand never punctures the wall
constexpr double SurfaceStrength = 100.0;
constexpr double WallSpacing = 4.0; // mm
// number of voxels with which the wall exceeds every device's workspace
constexpr int WallSteps = 50;

/**
 * Makes the filter a wall perpendicular to an axis (0 to 2): free space on the positive side of the
 * workspace's centre, and a smooth solid of 200 N/m on the negative side. One world unit is a
 * millimetre of the device.
 */
void MakeGentleWall(vtkVolumeHapticsFilter* filter, int axis)
{
  // The value is the depth in the wall (mm).
  TouchField(
    filter, WallSpacing, WallSteps, [axis](const double* position) { return -position[axis]; });
  vtkHapticProperty* const property = filter->GetProperty();
  SetEverywhere(property->GetStiffness(), Stiffness);
  SetEverywhere(property->GetFriction(), 0.0);
  SetEverywhere(property->GetViscosity(), 0.0);
  SetEverywhere(property->GetDistinctness(), 1.0);
  property->GetSurfaceStrength()->RemoveAllPoints();
  property->GetSurfaceStrength()->AddPoint(0.0, 0.0);
  property->GetSurfaceStrength()->AddPoint(0.1, SurfaceStrength);
  property->SetSurfaceSideToHigher();
}

} // namespace

namespace
{

using Command = ToolOptions::Command;

constexpr double RecordSeconds = 10.0;
constexpr auto ShowPeriod = std::chrono::milliseconds(100);

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
  vtkNew<vtkTable> missing;
  vtkHapticDevice::ListMissingKinds(missing);
  for (vtkIdType i = 0; i < missing->GetNumberOfRows(); ++i)
  {
    out << std::left << std::setw(16) << missing->GetValueByName(i, "Kind").ToString()
        << "  can't be used yet:\n"
        << std::string(18, ' ') << missing->GetValueByName(i, "State").ToString() << "\n";
  }
  return 0;
}

/// Shows the device's requests to the user until the device is ready. Returns false if it does not
/// become ready.
bool MakeReady(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  // Devices of these kinds request their rest pose whenever they are opened, so Home() is not
  // needed.
  const std::string kind = options.Id.substr(0, options.Id.find(':'));
  const bool asksByItself = kind == "wooden" || kind == "hfab";
  if (options.What == Command::Home && !asksByItself)
  {
    device->Home();
  }
  LiveLine line(streams.Out);
  for (;;)
  {
    const int status = device->GetStatus();
    const std::string text = device->GetStatusText();
    const bool asksForHome =
      status == vtkHapticDevice::HOMING && text.find("press Home()") != std::string::npos;
    if (asksForHome)
    {
      line.End();
      streams.Out << text << "\n";
      if (!streams.AskForEnter("Put the arm into its rest pose, hold it there and press Enter."))
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
      streams.Errors << text << "\n";
      return false;
    }
    else
    {
      break;
    }
  }
  line.End();
  const std::string calibration = device->GetCalibrationText();
  streams.Out << options.Id << " is ready" << (calibration.empty() ? "" : ", its force ")
              << calibration << ".\n";
  return true;
}

/// Shows the live state for some seconds (0: until interrupted). Returns false if the device is
/// lost before then.
bool Watch(ToolDevice& device, double seconds, ToolStreams streams)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  LiveLine line(streams.Out);
  while (seconds <= 0.0 || Clock::now() - start < std::chrono::duration<double>(seconds))
  {
    device->UpdateState();
    if (device->GetStatus() == vtkHapticDevice::FAULT)
    {
      line.End();
      streams.Errors << device->GetStatusText() << "\n";
      return false;
    }
    line.Show(DescribeState(device.Get()));
    std::this_thread::sleep_for(ShowPeriod);
  }
  return true;
}

bool Confirm(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  if (device->GetCalibrationText().empty())
  {
    streams.Errors << options.Id << " gives no force of its own: there is nothing to confirm.\n";
    return false;
  }
  return ConfirmSigns(device, options.Id.c_str(), streams);
}

bool Test(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  if (device->GetMaximumForce() <= 0.0)
  {
    streams.Errors << options.Id << " gives no force: there is nothing to feel. Try monitor.\n";
    return false;
  }
  const bool isStick = options.IsStick();
  const bool vibrates = options.Id.compare(0, 9, "vibration") == 0;
  const int axis = options.Axis >= 0 ? options.Axis : isStick ? 0 : 2;
  MakeGentleWall(device.GetVolume(), axis);
  device->SetVolumeHaptics(device.GetVolume());
  device->SetMaximumForce(GentleForce);
  if (!device->Start())
  {
    return false;
  }
  streams.Out << "There is a wall in the middle of the workspace, on the negative side of "
              << "xyz"[axis];
  vibrates ? streams.Out << ". It can't push: its contact is vibration.\n"
           : streams.Out << ". It pushes with at most " << GentleForce << " N.\n";
  if (isStick && !options.HasNewtons)
  {
    streams.Out << "That is if its force at full scale is " << options.Newtons[0]
                << " N. Most devices have less and are hardly felt: measure it, then give it "
                   "with --newtons.\n";
  }
  if (!streams.AskForEnter(
        "Take the device in your hand and press Enter to arm it; Ctrl+C ends at once."))
  {
    return false;
  }
  if (!device->GetSignsConfirmed())
  {
    streams.Out << "Its force directions were never confirmed: hold it loosely and keep the hand "
                   "still. For about ten seconds it pushes gently along each axis; then comes the "
                   "wall.\n";
  }
  device->Arm();
  return Watch(device, options.Seconds, streams);
}

bool Record(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  // A recording needs a volume: use the wall, although the device stays disarmed.
  MakeGentleWall(device.GetVolume(), 2);
  device->SetVolumeHaptics(device.GetVolume());
  if (!device->Start() || !device->GetRecorder()->Start(options.File.c_str()))
  {
    return false;
  }
  const double seconds = options.Seconds > 0.0 ? options.Seconds : RecordSeconds;
  const bool isWhole = Watch(device, seconds, streams);
  if (!device->GetRecorder()->Stop())
  {
    return false;
  }
  streams.Out << "Recorded to " << options.File << "\n";
  return isWhole;
}

bool Do(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  switch (options.What)
  {
    case Command::Monitor:
      return device->Start() && Watch(device, options.Seconds, streams);
    case Command::Confirm:
      return Confirm(device, options, streams);
    case Command::Calibrate:
      return Calibrate(device, options, streams);
    case Command::Test:
      return Test(device, options, streams);
    case Command::Record:
      return Record(device, options, streams);
    case Command::Home:
    case Command::Help:
    case Command::List:
      break;
  }
  return true;
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

  const ToolStreams streams{ in, out, errors };
  ToolDevice device(errors);
  if (!options.Firmware.empty())
  {
    device->SetFirmwareFile(options.Firmware);
  }
  if (!options.VendorPath.empty())
  {
    device->SetVendorPath(options.VendorPath);
  }
  device->SetHomingTime(options.HomingTime);
  device->SetNewtonsPerFullScale(options.Newtons);
  device->SetServoRate(options.ServoRate);
  if (!device->Open(options.Id.c_str()) || !MakeReady(device, options, streams))
  {
    return 1;
  }
  return Do(device, options, streams) ? 0 : 1;
}
