// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/Calibrate.h"

#include "Applications/DeviceTool/HungWeight.h"
#include "Applications/DeviceTool/LiveLine.h"
#include "Applications/DeviceTool/ScaleFit.h"
#include "Applications/DeviceTool/ScalePress.h"
#include "Applications/DeviceTool/WorkspaceVolume.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <thread>
#include <vtkHapticProperty.h>
#include <vtkMatrix4x4.h>
#include <vtkVolumeHapticsFilter.h>

class vtkVolumeHapticsFilter;

namespace
{

constexpr double Strength = 1000.0;    // N, much more than any device can exert
constexpr double MediumSpacing = 40.0; // mm
// number of voxels with which the medium exceeds every device's workspace
constexpr int MediumSteps = 6;

/**
 * Makes the filter a medium in which the proxy never moves, so that a spring of this stiffness
 * (N/m) holds the hand in all directions. One world unit is a millimetre of the device.
 */
void MakeHoldingMedium(vtkVolumeHapticsFilter* filter, double stiffness)
{
  TouchField(filter, MediumSpacing, MediumSteps, [](const double*) { return 0.0; });
  vtkHapticProperty* const property = filter->GetProperty();
  SetEverywhere(property->GetStiffness(), stiffness);
  SetEverywhere(property->GetFriction(), 0.0);
  SetEverywhere(property->GetViscosity(), Strength);
  SetEverywhere(property->GetSurfaceStrength(), 0.0);
}

} // namespace

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double Millimetre = 1e-3; // m
constexpr auto LookPeriod = std::chrono::milliseconds(10);
/// Stretch (m) at which the spring exerts the largest force.
constexpr double FullWay = 0.015;
/// Longest time (s) in which a device becomes armed or a force fades.
constexpr double OrderTime = 2.0;
/// Time (s) in which the force rises after Arm, with a margin: the rise takes half a second.
constexpr double RiseTime = 1.0;  // s
constexpr double Patience = 60.0; // s, without --seconds
/// Range of suitable weights, as fractions of the largest force, provided that the device's forces
/// are calibrated.
constexpr double LightFraction = 0.1;
constexpr double HeavyFraction = 0.6;
/// The forces that press on the scale, as fractions of the largest force. The first force must
/// exceed twice the friction, which may act against it before the force rises.
constexpr double Levels[] = { 0.3, 0.45, 0.6, 0.75 };
constexpr int Tries = 3;
constexpr double MostGrams = 20000.0;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The device's handle, which a simulated spring holds. Its fixed end can be shifted.
class HeldHandle
{
public:
  HeldHandle(ToolDevice& device, int axis, std::ostream& errors)
    : Device(device)
    , Axis(axis)
    , Errors(errors)
  {
    this->MoveTo(0.0);
    this->Device->SetDeviceToWorld(this->DeviceToWorld);
  }
  ~HeldHandle() { this->Device->SetDeviceToWorld(nullptr); }
  HeldHandle(const HeldHandle&) = delete;
  HeldHandle& operator=(const HeldHandle&) = delete;

  /// Arms the device. The spring then holds the handle where it is now.
  void Arm()
  {
    this->MoveTo(0.0);
    this->Device->Publish();
    this->Device->Arm();
    this->Armed = this->Last = Clock::now();
  }
  /// Waits until the safety stage passes the full force, because a spring that is stretched earlier
  /// stays soft.
  bool WaitForForce()
  {
    HeldSample sample;
    bool isOn = true;
    while (isOn && SecondsSince(this->Armed) < RiseTime)
    {
      isOn = this->Look(sample);
    }
    return isOn;
  }
  /// Reads the next sample. Returns false and reports an error if the device no longer exerts a
  /// force.
  bool Look(HeldSample& sample)
  {
    std::this_thread::sleep_for(LookPeriod);
    this->Device->UpdateState();
    const int status = this->Device->GetStatus();
    const bool isOn = status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
    if (status == vtkHapticDevice::FAULT || (!isOn && SecondsSince(this->Armed) > OrderTime))
    {
      this->Errors << this->Device->GetStatusText() << "\n";
      return false;
    }
    const double* const tip = this->Device->GetState()->GetTipPosition();
    std::copy_n(this->Device->GetState()->GetForce(), 3, sample.Force.begin());
    std::transform(tip, tip + 3, sample.Tip.begin(), [](double x) { return Millimetre * x; });
    sample.Tip[this->Axis] += this->Shift;
    sample.Elapsed = SecondsSince(this->Last);
    this->Last = Clock::now();
    return true;
  }
  /// Moves the spring's fixed end along the axis to `shift` (m) from its position at Arm().
  void ShiftTo(double shift)
  {
    if (shift != this->Shift)
    {
      this->MoveTo(shift);
      this->Device->Publish();
    }
  }
  /// Fades the force to zero.
  void LetGo()
  {
    this->Device->FadeOut();
    const Clock::time_point start = Clock::now();
    double size = 1.0;
    while (size > 0.0 && SecondsSince(start) < OrderTime)
    {
      std::this_thread::sleep_for(LookPeriod);
      this->Device->UpdateState();
      const double* const force = this->Device->GetState()->GetForce();
      size = std::hypot(force[0], force[1], force[2]);
    }
  }

private:
  void MoveTo(double shift)
  {
    this->Shift = shift;
    this->DeviceToWorld->Identity();
    for (int i = 0; i < 3; ++i)
    {
      this->DeviceToWorld->SetElement(i, i, 1.0 / Millimetre);
    }
    this->DeviceToWorld->SetElement(this->Axis, 3, -shift / Millimetre);
  }

  ToolDevice& Device;
  const int Axis;
  std::ostream& Errors;
  vtkNew<vtkMatrix4x4> DeviceToWorld;
  double Shift = 0.0; ///< shift (m) of the spring's fixed end along Axis
  Clock::time_point Armed;
  Clock::time_point Last;
};

/// Steps a measurement until it is over, then releases the handle. Returns false after an error.
template <typename T>
bool Measure(T& measurement, HeldHandle& handle, ToolStreams streams)
{
  HeldSample sample;
  LiveLine line(streams.Out);
  handle.Arm();
  if (!handle.WaitForForce())
  {
    return false;
  }
  while (!measurement.IsOver())
  {
    line.Show(measurement.GetRequest());
    if (!handle.Look(sample))
    {
      return false;
    }
    measurement.Step(sample);
    handle.ShiftTo(measurement.GetShift());
  }
  line.Show(measurement.GetRequest());
  handle.LetGo();
  line.End();
  if (!measurement.GetFault().empty())
  {
    streams.Errors << measurement.GetFault() << "\n";
    return false;
  }
  return true;
}

bool Weigh(ToolDevice& device, const ToolOptions& options, int axis, ToolStreams streams,
  double& factor, double& doubt)
{
  const double most = device->GetMaximumForce();
  HungWeight::Settings settings;
  settings.Weight = 1e-3 * options.Grams * HungWeight::Gravity;
  settings.Axis = axis;
  settings.MostForce = most;
  settings.Patience = options.Seconds > 0.0 ? options.Seconds : Patience;
  char text[400];
  std::snprintf(text, sizeof(text),
    "The device holds its handle with %.2f N at the most; weights of about %.0f to %.0f g are "
    "good. "
    "Hold the handle in the middle of the workspace, without the weight, and press Enter; Ctrl+C "
    "ends at once.",
    most, 1e3 * LightFraction * most / HungWeight::Gravity,
    1e3 * HeavyFraction * most / HungWeight::Gravity);
  if (!streams.AskForEnter(text))
  {
    return false;
  }
  HeldHandle handle(device, axis, streams.Errors);
  HungWeight weight(settings);
  if (!device->Start() || !Measure(weight, handle, streams))
  {
    return false;
  }
  factor = weight.GetFactor();
  doubt = weight.GetDoubt();
  std::snprintf(text, sizeof(text), "The friction of the arm is %.2f N.\n",
    weight.GetFriction() * factor * device->GetForceScale());
  streams.Out << text;
  return true;
}

/// Reads the number of grams that the user types. Returns 1 for a number, 0 for an empty line,
/// which asks for another push, and -1 after an error.
int AskForGrams(ToolStreams streams, double& grams)
{
  for (int i = 0; i < Tries; ++i)
  {
    streams.Out << "How many grams did it show? (Enter alone: push again)" << std::endl;
    std::string text;
    if (!std::getline(streams.In, text))
    {
      streams.Errors << "No number was entered.\n";
      return -1;
    }
    if (text.empty())
    {
      return 0;
    }
    if (ReadNumberInRange(text, -MostGrams, MostGrams, grams))
    {
      return 1;
    }
    streams.Out << "\"" << text << "\" is not a number of grams, such as 153 or 152.5.\n";
  }
  streams.Errors << "No number of grams was entered: nothing is stored.\n";
  return -1;
}

bool Press(ToolDevice& device, int axis, double direction, ToolStreams streams, double& factor,
  double& doubt)
{
  const double most = device->GetMaximumForce();
  char text[400];
  std::snprintf(text, sizeof(text),
    "Put a kitchen scale %s%c of the handle, closer than 2 cm or touching it, so that the handle "
    "presses its middle and nothing else does. The device pushes %d times, with up to %.2f N. Take "
    "the handle and press Enter; Ctrl+C ends at once.",
    direction < 0.0 ? "on the side of -" : "on the side of ", "xyz"[axis],
    static_cast<int>(std::size(Levels)), Levels[std::size(Levels) - 1] * most);
  if (!streams.AskForEnter(text))
  {
    return false;
  }
  HeldHandle handle(device, axis, streams.Errors);
  if (!device->Start())
  {
    return false;
  }
  std::vector<ScaleReading> readings;
  while (readings.size() < std::size(Levels))
  {
    ScalePress::Settings settings;
    settings.Axis = axis;
    settings.Direction = direction;
    settings.Level = Levels[readings.size()] * most;
    settings.MostForce = most;
    ScalePress press(settings);
    if (!Measure(press, handle, streams))
    {
      return false;
    }
    double grams = 0.0;
    const int answer = AskForGrams(streams, grams);
    if (answer < 0)
    {
      return false;
    }
    if (answer > 0)
    {
      readings.push_back({ press.GetForce(), 1e-3 * grams * HungWeight::Gravity });
    }
  }
  ScaleFit fit;
  std::string error;
  if (!FitScale(readings, fit, error))
  {
    streams.Errors << error << "\n";
    return false;
  }
  factor = fit.Factor;
  doubt = fit.Doubt;
  std::snprintf(text, sizeof(text), "The readings are on a line within %.3f N.\n", fit.Residual);
  streams.Out << text;
  return true;
}

} // namespace

bool Calibrate(ToolDevice& device, const ToolOptions& options, ToolStreams streams)
{
  if (device->GetCalibrationText().empty())
  {
    streams.Errors << options.Id << " gives no force of its own: there is nothing to calibrate.\n";
    return false;
  }
  streams.Out << options.Id << " is " << device->GetCalibrationText() << ".\n";
  if (!device->GetSignsConfirmed())
  {
    streams.Out << "Its force directions were never confirmed: that comes first.\n";
    if (!ConfirmSigns(device, options.Id.c_str(), streams))
    {
      return false;
    }
  }
  const bool isStick = options.IsStick();
  const int axis = options.Axis >= 0 ? options.Axis : isStick ? 0 : 1;
  const double direction = options.Axis >= 0 && !options.IsAxisNegative ? 1.0 : -1.0;
  MakeHoldingMedium(device.GetVolume(), device->GetMaximumForce() / FullWay);
  device->SetVolumeHaptics(device.GetVolume());

  double factor = 1.0;
  double doubt = 0.0;
  const bool isMeasured = options.Grams > 0.0
    ? Weigh(device, options, axis, streams, factor, doubt)
    : Press(device, axis, direction, streams, factor, doubt);
  device->Stop();
  if (!isMeasured)
  {
    return false;
  }
  // The factor was measured with the old scale in effect, so multiply the two.
  const double scale = factor * device->GetForceScale();
  const int complaints = device.CountComplaints();
  if (!device->CalibrateForce(scale) || device.CountComplaints() > complaints)
  {
    return false;
  }
  char text[300];
  std::snprintf(text, sizeof(text),
    "%s gives %.3f N (+- %.1f %%) for each newton that it is asked for. %s\n", options.Id.c_str(),
    scale, 100.0 * doubt / factor, DescribeMemory(device));
  streams.Out << text;
  return true;
}
