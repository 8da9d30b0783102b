// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The plug-in openhaptics: Touch, Touch X and Phantom Premium of 3D Systems through OpenHaptics
// (libHD).
//
// A callback on the library's own scheduler thread reads the device and sets its force, a thousand
// times a second. Poses and forces are transferred without locks. The callback sets a force to zero
// if it is not renewed for 50 ms. libHD's axes are the same as this library's: right, up and
// towards the user, in millimetres, newtons and millinewton metres. This was not verified on a
// device.
//
// The library reports a peak force and a continuous force, 3.3 N and 0.88 N on a Touch. The largest
// force here is twice the continuous one. A force above the continuous one is given for 2.5 s;
// within another 2.5 s the callback lowers its limit to the continuous force.
//
// The vendor's setup program names the devices. vendor:openhaptics is the default, or "Default
// Device", or "Default PHANToM"; $VOLUMEHAPTICS_OPENHAPTICS_DEVICES names others, separated by
// commas, as vendor:openhaptics:1 and so on. One of them can be open at a time.
#include <Devices/Vendor/VendorPlugin.h>

#include "Latest.h"
#include "Orientation.h"

#include <HD/hd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace
{

constexpr std::int64_t LongestForce = 50'000'000; // ns that a force lasts without renewal
// ns without a callback after which the scheduler counts as stopped
constexpr std::int64_t LongestSilence = 100'000'000;
constexpr HDulong SchedulerRate = 1000; // Hz
// s after which a force above the continuous one has faded to it, and after which it may be as
// large again
constexpr double FadeTime = 5.0;

std::int64_t Now()
{
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

// Report of the callback.
struct Report
{
  double Position[3] = {};   // mm
  double Transform[16] = {}; // stylus to device, columns first
  int Buttons = 0;
  bool IsCalibrated = false;
  unsigned Calibration = 0; // libHD's number of the fault if the device is not calibrated
  unsigned Error = 0;       // libHD's number of a fault; HD_SUCCESS if there is none
  std::int64_t Time = 0;
};

// Force and torque that the callback sends to the device.
struct Order
{
  double Force[3] = {};  // N
  double Torque[3] = {}; // N m
  std::int64_t Time = 0;
};

struct Device
{
  HHD Handle = 0;
  HDSchedulerHandle Callback = 0;
  double MaximumTorque = 0.0;
  double MaximumForce = 0.0;    // N
  double ContinuousForce = 0.0; // N, which the motors give for ever
  Latest<Report> Reports;
  Latest<Order> Orders;
  std::atomic<bool> Forgives{ false }; // whether the user wants another try after a fault
  // Used by the callback only.
  bool IsCalibrated = false;
  unsigned Error = HD_SUCCESS;
  double Spent = 0.0; // the part of FadeTime for which the force was above the continuous one
  std::int64_t Ticked = 0;
  std::int64_t Opened = 0;
  std::string Text;
};

bool isOpen = false;

std::string& OpenError()
{
  static std::string error;
  return error;
}

std::vector<std::string> Names()
{
  std::vector<std::string> names{ "Default Device" };
  const char* const variable = std::getenv("VOLUMEHAPTICS_OPENHAPTICS_DEVICES");
  const std::string others = variable ? variable : "";
  for (std::size_t from = 0; from < others.size();)
  {
    const std::size_t end = std::min(others.find(',', from), others.size());
    if (end > from)
    {
      names.push_back(others.substr(from, end - from));
    }
    from = end + 1;
  }
  return names;
}

int Count()
{
  return static_cast<int>(Names().size());
}

int Describe(int number, char* name, size_t nameSize, char* serial, size_t serialSize)
{
  // libHD does not report which devices are plugged in, and reports models of open devices only.
  std::snprintf(name, nameSize, "OpenHaptics \"%s\"", Names()[static_cast<size_t>(number)].c_str());
  std::snprintf(serial, serialSize, "%s", "");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

// Reports whether the device knows its zero. Updates the calibration of a device that needs an
// update; the position then jumps.
void Calibrate(Device& device, Report& report)
{
  const HDenum state = hdCheckCalibration();
  if (state == HD_CALIBRATION_NEEDS_UPDATE)
  {
    // A device may support several ways. The order is that of the vendor's example.
    HDint styles = 0;
    hdGetIntegerv(HD_CALIBRATION_STYLE, &styles);
    for (const HDenum style :
      { HD_CALIBRATION_AUTO, HD_CALIBRATION_INKWELL, HD_CALIBRATION_ENCODER_RESET })
    {
      if ((styles & static_cast<HDint>(style)) != 0)
      {
        hdUpdateCalibration(style);
        break;
      }
    }
  }
  device.IsCalibrated = state == HD_CALIBRATION_OK;
  report.Calibration = state;
}

// Limits a force to the maximum, and after some time above the continuous force to the latter. The
// limit moves slowly, so that nothing jumps.
void LimitForce(Device& device, std::int64_t now, double force[3])
{
  const double norm = std::sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
  const double step = std::min(0.1, 1e-9 * static_cast<double>(now - device.Ticked)) / FadeTime;
  device.Ticked = now;
  // The requested force counts: one that is held down to the continuous force goes on to be.
  const bool isAbove = norm > device.ContinuousForce;
  device.Spent = std::clamp(device.Spent + (isAbove ? step : -step), 0.0, 1.0);
  // Without limit for the first half.
  const double faded = std::max(0.0, 2.0 * device.Spent - 1.0);
  const double most = device.MaximumForce - faded * (device.MaximumForce - device.ContinuousForce);
  for (int axis = 0; norm > most && axis < 3; ++axis)
  {
    force[axis] *= most / norm;
  }
}

HDCallbackCode HDCALLBACK OnTick(void* data)
{
  auto& device = *static_cast<Device*>(data);
  Report report;
  if (device.Forgives.exchange(false, std::memory_order_acq_rel))
  {
    device.Error = HD_SUCCESS;
    device.IsCalibrated = false;
  }
  hdBeginFrame(device.Handle);
  if (!device.IsCalibrated)
  {
    Calibrate(device, report);
  }
  hdGetDoublev(HD_CURRENT_POSITION, report.Position);
  hdGetDoublev(HD_CURRENT_TRANSFORM, report.Transform);
  hdGetIntegerv(HD_CURRENT_BUTTONS, &report.Buttons);
  report.Time = Now();
  device.Orders.Update();
  const Order& order = device.Orders.Get();
  const bool flows =
    device.IsCalibrated && device.Error == HD_SUCCESS && report.Time - order.Time < LongestForce;
  double force[3] = {};
  double torque[3] = {};
  for (int axis = 0; flows && axis < 3; ++axis)
  {
    force[axis] = order.Force[axis];
    torque[axis] = 1000.0 * order.Torque[axis]; // mN m
  }
  LimitForce(device, report.Time, force);
  hdSetDoublev(HD_CURRENT_FORCE, force);
  if (device.MaximumTorque > 0.0)
  {
    hdSetDoublev(HD_CURRENT_TORQUE, torque);
  }
  hdEndFrame(device.Handle);
  // libHD keeps a stack of faults. Store the first one until the user tries again.
  for (HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error); error = hdGetError())
  {
    device.Error = device.Error == HD_SUCCESS ? error.errorCode : device.Error;
  }
  report.IsCalibrated = device.IsCalibrated;
  report.Error = device.Error;
  device.Reports.Write(report);
  return HD_CALLBACK_CONTINUE;
}

// Waits until the callback has reported, but at most LongestSilence.
void WaitForTick(Device& device)
{
  for (const std::int64_t end = Now() + LongestSilence; !device.Reports.Update() && Now() < end;)
  {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

// Empties libHD's stack of faults. Must not be called while the callback runs, because the callback
// has to see the faults.
void ForgetFaults()
{
  while (HD_DEVICE_ERROR(hdGetError()))
  {
  }
}

void Disable(Device* device)
{
  hdDisableDevice(device->Handle);
  delete device;
  isOpen = false;
}

void* Open(int number)
{
  if (isOpen)
  {
    OpenError() = "can't be opened beside another one of this library. Close() that one.";
    return nullptr;
  }
  const std::string name = Names()[static_cast<size_t>(number)];
  // Some installations have no default, but its name of today or before.
  std::vector<HDstring> tries{ name.c_str() };
  if (number == 0)
  {
    tries = { HD_DEFAULT_DEVICE, "Default Device", "Default PHANToM" };
  }
  HHD handle = 0;
  HDErrorInfo error{};
  for (const HDstring one : tries)
  {
    ForgetFaults(); // faults of an earlier try
    handle = hdInitDevice(one);
    error = hdGetError();
    if (!HD_DEVICE_ERROR(error))
    {
      break;
    }
  }
  if (HD_DEVICE_ERROR(error))
  {
    OpenError() = "can't be opened (" + std::string(hdGetErrorString(error.errorCode)) +
      "). Plug it in, pair it by the vendor's setup program as \"" + name +
      "\", and close other programs that use it.";
    return nullptr;
  }
  auto* const device = new Device;
  isOpen = true;
  device->Handle = handle;
  device->Opened = Now();
  hdMakeCurrentDevice(handle);
  HDint outputs = 0;
  hdGetIntegerv(HD_OUTPUT_DOF, &outputs);
  // N m, from the data sheet of the Phantom Premium 6DOF, for its weakest axis.
  device->MaximumTorque = outputs == 6 ? 0.17 : 0.0;
  hdGetDoublev(HD_NOMINAL_MAX_FORCE, &device->MaximumForce);
  hdGetDoublev(HD_NOMINAL_MAX_CONTINUOUS_FORCE, &device->ContinuousForce);
  if (device->ContinuousForce > 0.0)
  {
    // The default force, half of the maximum, is then one that the motors give for ever.
    device->MaximumForce = std::min(device->MaximumForce, 2.0 * device->ContinuousForce);
  }
  else
  {
    device->ContinuousForce = device->MaximumForce;
  }
  ForgetFaults(); // a device that does not know the parameter gives no torque
  hdEnable(HD_FORCE_OUTPUT);
  hdSetSchedulerRate(SchedulerRate);
  device->Callback = hdScheduleAsynchronous(&OnTick, device, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  const HDErrorInfo started = hdGetError();
  if (HD_DEVICE_ERROR(started))
  {
    OpenError() = "can't be started (" + std::string(hdGetErrorString(started.errorCode)) +
      "). Plug it in again.";
    hdStopScheduler();
    hdUnschedule(device->Callback);
    Disable(device);
    return nullptr;
  }
  return device;
}

int GetLimits(void* handle, VolumeHapticsVendorLimits* limits)
{
  auto& device = *static_cast<Device*>(handle);
  *limits = {};
  hdMakeCurrentDevice(device.Handle);
  double stiffness = 0.0; // N/mm
  double damping = 0.0;   // N s/mm
  double box[6] = {};     // mm, smallest and largest x, y, z
  limits->MaximumForce = device.MaximumForce;
  hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &stiffness);
  hdGetDoublev(HD_NOMINAL_MAX_DAMPING, &damping);
  hdGetDoublev(HD_USABLE_WORKSPACE_DIMENSIONS, box);
  limits->MaximumTorque = device.MaximumTorque;
  limits->MaximumStiffness = 1000.0 * stiffness;
  limits->MaximumDamping = 1000.0 * damping;
  limits->MaximumSpeed = 2.5;
  const double least = std::min({ box[3] - box[0], box[4] - box[1], box[5] - box[2] });
  limits->WorkspaceRadius = 0.5e-3 * std::max(0.0, least);
  limits->ForceAxes = 7;
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int GetSerial(void* handle, char* serial, size_t size)
{
  hdMakeCurrentDevice(static_cast<Device*>(handle)->Handle);
  const HDstring text = hdGetString(HD_DEVICE_SERIAL_NUMBER);
  std::snprintf(serial, size, "%s", text ? text : "");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Read(void* handle, VolumeHapticsVendorPose* pose)
{
  auto& device = *static_cast<Device*>(handle);
  const bool isNew = device.Reports.Update();
  const Report& report = device.Reports.Get();
  const std::int64_t age = Now() - std::max(report.Time, device.Opened);
  if (age > LongestSilence)
  {
    device.Text = "is not read any more: the library's scheduler stands still. Open() it again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (report.Error != HD_SUCCESS)
  {
    device.Text = "has a fault (" + std::string(hdGetErrorString(report.Error)) +
      "). Let it rest if its motors are warm, look after its cable, then Home() and Arm() again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (report.Time == 0 || !report.IsCalibrated)
  {
    device.Text = report.Calibration == HD_CALIBRATION_NEEDS_MANUAL_INPUT
      ? "has no zero yet: put the stylus into its inkwell, or move the arm through its range."
      : "finds its zero.";
    return VOLUME_HAPTICS_VENDOR_WAITS;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    pose->Position[axis] = 1e-3 * report.Position[axis];
  }
  double matrix[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[row][column] = report.Transform[4 * column + row];
    }
  }
  ToQuaternion(matrix, pose->Orientation);
  pose->HasOrientation = 1;
  pose->Buttons = static_cast<uint32_t>(report.Buttons);
  pose->Age = age;
  return isNew ? VOLUME_HAPTICS_VENDOR_NEWS : VOLUME_HAPTICS_VENDOR_DONE;
}

int Write(void* handle, const double force[3], const double torque[3])
{
  Order order;
  std::copy(force, force + 3, order.Force);
  std::copy(torque, torque + 3, order.Torque);
  order.Time = Now();
  static_cast<Device*>(handle)->Orders.Write(order);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Home(void* handle)
{
  auto& device = *static_cast<Device*>(handle);
  device.Forgives.store(true, std::memory_order_release);
  // Wait twice until the callback reports the new try, because the first report may have begun
  // earlier.
  WaitForTick(device);
  WaitForTick(device);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

const char* LastError(void* device)
{
  return device ? static_cast<Device*>(device)->Text.c_str() : OpenError().c_str();
}

void Close(void* handle)
{
  auto* const device = static_cast<Device*>(handle);
  // The last order was zero. Wait twice, because a tick that began before the order may have missed
  // it.
  WaitForTick(*device);
  WaitForTick(*device);
  hdStopScheduler();
  hdUnschedule(device->Callback);
  Disable(device);
}

} // namespace

const VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version)
{
  static const VolumeHapticsVendorPlugin plugin = { VOLUME_HAPTICS_VENDOR_VERSION, &Count,
    &Describe, &Open, &GetLimits, &GetSerial, &Read, &Write, &Home, &LastError, &Close };
  return version == VOLUME_HAPTICS_VENDOR_VERSION ? &plugin : nullptr;
}
