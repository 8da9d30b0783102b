// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The plug-in openhaptics: Touch, Touch X and Phantom Premium of 3D Systems through OpenHaptics
// (libHD).
//
// A callback on libHD's scheduler thread reads the devices and sets their forces, a thousand times
// a second. Poses and forces are transferred without locks. The callback sets a force to zero if it
// is not renewed for 50 ms. libHD has the same axes as this library (right, up and towards the
// user), but uses millimetres, newtons and millinewton metres. This was not verified on a device.
//
// The library reports a peak force and a continuous force, 3.3 N and 0.88 N on a Touch. A force
// above the continuous force is allowed for 2.5 s.
//
// The vendor's setup program names the devices. vendor:openhaptics is the default, or "Default
// Device", or "Default PHANToM"; $VOLUMEHAPTICS_OPENHAPTICS_DEVICES names others, separated by
// commas, as vendor:openhaptics:1 and so on. Several devices can be open, and one callback serves
// them all. The scheduler stops while a device is opened or closed, because libHD accepts devices
// only before its scheduler starts. The forces of the other devices fade out first, and these
// devices have to be armed again afterwards.
#include <Devices/Vendor/VendorPlugin.h>

#include "Latest.h"
#include "Orientation.h"

#include <HD/hd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace
{

constexpr std::int64_t LongestForce = 50'000'000; // ns that a force lasts without renewal
// ns without a callback after which the scheduler counts as stopped
constexpr std::int64_t LongestSilence = 100'000'000;
constexpr HDulong SchedulerRate = 1000; // Hz
constexpr int FadeRounds = 50;          // calls of the callback in which the force fades out
// s for which a force above the continuous force is allowed. 3D Systems states no time; libHD
// reports a motor that overheats nevertheless as a fault.
constexpr double PeakTime = 2.5;

std::int64_t Now()
{
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

// State that the scheduler's callback writes and the reader of states reads.
struct Report
{
  double Position[3] = {};   // mm
  double Transform[16] = {}; // stylus to device, column-major
  int Buttons = 0;
  bool IsCalibrated = false;
  unsigned Calibration = 0; // libHD's error number if the device is not calibrated
  unsigned Error = 0;       // libHD's error number; HD_SUCCESS without an error
  std::int64_t Time = 0;
};

// Force and torque that the callback sends to the device.
struct Order
{
  double Force[3] = {};  // N
  double Torque[3] = {}; // N m
  std::int64_t Time = 0;
  unsigned Pause = 0; // number of the last pause that the writer has seen
};

struct Device
{
  HHD Handle = 0;
  std::string Serial;
  VolumeHapticsVendorLimits Limits{};
  Latest<Report> Reports;
  Latest<Order> Orders;
  // whether the callback clears the last fault, because the user tries again
  std::atomic<bool> Forgives{ false };
  // Used by the callback only.
  bool IsCalibrated = false;
  unsigned Error = HD_SUCCESS;
  // Used by the reader only.
  unsigned Pause = 0; // number of the last pause that was reported
  std::string Text;
};

// Open devices, and the callback that serves them. The list changes only while the scheduler is
// stopped.
struct Service
{
  std::mutex Mutex; // held while a device is opened or closed; never by the callback
  std::vector<Device*> Devices;
  HDSchedulerHandle Callback = 0;
  std::atomic<bool> Fades{ false }; // whether the forces fade out before a pause
  double Share = 1.0;               // factor of all forces, from 0 to 1; used by the callback only
  std::atomic<bool> Pauses{ false };
  std::atomic<unsigned> Pause{ 0 };       // number of pauses so far
  std::atomic<std::int64_t> Resumed{ 0 }; // time of the last start
  std::atomic<unsigned long> Rounds{ 0 }; // number of calls of the callback
};
Service service;

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
  // libHD does not report which devices are plugged in, and reports the model only of open devices.
  std::snprintf(name, nameSize, "OpenHaptics \"%s\"", Names()[static_cast<size_t>(number)].c_str());
  std::snprintf(serial, serialSize, "%s", "");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

// Reports whether the device is calibrated. Updates the calibration if the device needs it, which
// makes the position jump.
void Calibrate(Device& device, Report& report)
{
  const HDenum state = hdCheckCalibration();
  if (state == HD_CALIBRATION_NEEDS_UPDATE)
  {
    // A device may support several ways of calibration. Try them in the order of the vendor's
    // example.
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

// Empties libHD's error stack, and stores each error with its device, or with all devices if its
// device is unknown.
void TakeFaults()
{
  for (HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error); error = hdGetError())
  {
    const bool isKnown = std::any_of(service.Devices.begin(), service.Devices.end(),
      [&error](const Device* one) { return one->Handle == error.hHD; });
    for (Device* const device : service.Devices)
    {
      // Keep the first error until the user tries again.
      const bool isIts = !isKnown || device->Handle == error.hHD;
      device->Error = isIts && device->Error == HD_SUCCESS ? error.errorCode : device->Error;
    }
  }
}

void Serve(Device& device)
{
  Report report;
  if (device.Forgives.exchange(false, std::memory_order_acq_rel))
  {
    device.Error = HD_SUCCESS;
    device.IsCalibrated = false;
  }
  hdMakeCurrentDevice(device.Handle);
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
  const bool flows = device.IsCalibrated && device.Error == HD_SUCCESS &&
    report.Time - order.Time < LongestForce && !service.Pauses.load() &&
    order.Pause == service.Pause.load();
  double force[3] = {};
  double torque[3] = {};
  for (int axis = 0; flows && axis < 3; ++axis)
  {
    force[axis] = service.Share * order.Force[axis];
    torque[axis] = service.Share * 1000.0 * order.Torque[axis]; // mN m
  }
  hdSetDoublev(HD_CURRENT_FORCE, force);
  if (device.Limits.MaximumTorque > 0.0)
  {
    hdSetDoublev(HD_CURRENT_TORQUE, torque);
  }
  hdEndFrame(device.Handle);
  TakeFaults();
  report.IsCalibrated = device.IsCalibrated;
  report.Error = device.Error;
  device.Reports.Write(report);
}

HDCallbackCode HDCALLBACK OnTick(void* /*data*/)
{
  service.Share = service.Fades.load() ? std::max(0.0, service.Share - 1.0 / FadeRounds) : 1.0;
  for (Device* const device : service.Devices)
  {
    Serve(*device);
  }
  service.Rounds.fetch_add(1, std::memory_order_release);
  return HD_CALLBACK_CONTINUE;
}

// Waits until the callback has run completely `count` times. Waits for one more call, because the
// first call may have begun earlier. Gives up after LongestSilence without a call.
void WaitForRounds(int count)
{
  bool isCalled = true;
  for (int i = 0; i <= count && isCalled; ++i)
  {
    const unsigned long before = service.Rounds.load(std::memory_order_acquire);
    isCalled = false;
    for (const std::int64_t end = Now() + LongestSilence; !isCalled && Now() < end;)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      isCalled = service.Rounds.load(std::memory_order_acquire) != before;
    }
  }
}

// Discards libHD's error stack. Must not be called while the callback runs, because the callback
// would miss the errors.
void ForgetFaults()
{
  while (HD_DEVICE_ERROR(hdGetError()))
  {
  }
}

// Stops the scheduler if it runs, after the force of every device has faded to zero.
void Pause()
{
  service.Fades.store(true);
  if (!service.Devices.empty())
  {
    WaitForRounds(FadeRounds);
  }
  service.Pauses.store(true);
  service.Pause.fetch_add(1);
  if (!service.Devices.empty())
  {
    WaitForRounds(1);
    hdStopScheduler();
  }
}

// Starts the scheduler if a device is open. Returns libHD's error.
HDErrorInfo Resume()
{
  ForgetFaults();
  service.Fades.store(false);
  HDErrorInfo fault{};
  if (!service.Devices.empty())
  {
    service.Resumed.store(Now());
    hdSetSchedulerRate(SchedulerRate);
    if (service.Callback == 0)
    {
      service.Callback = hdScheduleAsynchronous(&OnTick, nullptr, HD_MAX_SCHEDULER_PRIORITY);
    }
    hdStartScheduler();
    fault = hdGetError();
  }
  service.Pauses.store(false);
  return fault;
}

// Closes a device while the scheduler is stopped. Removes the callback after the last device.
void Disable(Device* device)
{
  auto& all = service.Devices;
  all.erase(std::remove(all.begin(), all.end(), device), all.end());
  if (all.empty() && service.Callback != 0)
  {
    hdUnschedule(service.Callback);
    service.Callback = 0;
  }
  hdDisableDevice(device->Handle);
  delete device;
}

// Reads the limits of libHD's current device.
void ReadLimits(Device& device)
{
  VolumeHapticsVendorLimits& limits = device.Limits;
  HDint outputs = 0;
  double stiffness = 0.0; // N/mm
  double damping = 0.0;   // N s/mm
  double box[6] = {};     // mm, smallest and largest x, y, z
  hdGetIntegerv(HD_OUTPUT_DOF, &outputs);
  hdGetDoublev(HD_NOMINAL_MAX_FORCE, &limits.MaximumForce);
  hdGetDoublev(HD_NOMINAL_MAX_CONTINUOUS_FORCE, &limits.ContinuousForce);
  hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &stiffness);
  hdGetDoublev(HD_NOMINAL_MAX_DAMPING, &damping);
  hdGetDoublev(HD_USABLE_WORKSPACE_DIMENSIONS, box);
  limits.PeakTime = PeakTime;
  // N m, of the weakest axis on the data sheet of the Phantom Premium 6DOF.
  limits.MaximumTorque = outputs == 6 ? 0.17 : 0.0;
  limits.MaximumStiffness = 1000.0 * stiffness;
  limits.MaximumDamping = 1000.0 * damping;
  limits.MaximumSpeed = 2.5;
  const double least = std::min({ box[3] - box[0], box[4] - box[1], box[5] - box[2] });
  limits.WorkspaceRadius = 0.5e-3 * std::max(0.0, least);
  limits.ForceAxes = 7;
  const HDstring serial = hdGetString(HD_DEVICE_SERIAL_NUMBER);
  device.Serial = serial ? serial : "";
}

void* Open(int number)
{
  const std::lock_guard<std::mutex> lock(service.Mutex);
  const std::string name = Names()[static_cast<size_t>(number)];
  // Some installations lack an unnamed default, but have a device of one of its two usual names.
  std::vector<HDstring> tries{ name.c_str() };
  if (number == 0)
  {
    tries = { HD_DEFAULT_DEVICE, "Default Device", "Default PHANToM" };
  }
  Pause();
  HHD handle = 0;
  HDErrorInfo error{};
  for (const HDstring one : tries)
  {
    ForgetFaults(); // discards errors of an earlier try
    handle = hdInitDevice(one);
    error = hdGetError();
    if (!HD_DEVICE_ERROR(error))
    {
      break;
    }
  }
  const bool isKnown = std::any_of(service.Devices.begin(), service.Devices.end(),
    [handle](const Device* one) { return one->Handle == handle; });
  if (HD_DEVICE_ERROR(error) || isKnown)
  {
    OpenError() = "can't be opened (" +
      std::string(isKnown ? "open by another name" : hdGetErrorString(error.errorCode)) +
      "). Plug it in, pair it by the vendor's setup program as \"" + name +
      "\", and close other programs that use it.";
    Resume();
    return nullptr;
  }
  auto* const device = new Device;
  device->Handle = handle;
  hdMakeCurrentDevice(handle);
  ReadLimits(*device);
  hdEnable(HD_FORCE_OUTPUT);
  device->Pause = service.Pause.load();
  service.Devices.push_back(device);
  const HDErrorInfo started = Resume();
  if (HD_DEVICE_ERROR(started))
  {
    OpenError() = "can't be started (" + std::string(hdGetErrorString(started.errorCode)) +
      "). Plug it in again.";
    hdStopScheduler();
    Disable(device);
    return nullptr;
  }
  return device;
}

int GetLimits(void* handle, VolumeHapticsVendorLimits* limits)
{
  *limits = static_cast<Device*>(handle)->Limits;
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int GetSerial(void* handle, char* serial, size_t size)
{
  std::snprintf(serial, size, "%s", static_cast<Device*>(handle)->Serial.c_str());
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Read(void* handle, VolumeHapticsVendorPose* pose)
{
  auto& device = *static_cast<Device*>(handle);
  const unsigned pause = service.Pause.load();
  const bool isOver = !service.Pauses.load();
  if (!isOver || device.Pause != pause)
  {
    // Report the end of a pause once: the device then has to be armed again, so the force can't
    // return by itself.
    device.Pause = isOver ? pause : device.Pause;
    device.Text = "waits while another device of this library is opened or closed.";
    return VOLUME_HAPTICS_VENDOR_WAITS;
  }
  const bool isNew = device.Reports.Update();
  const Report& report = device.Reports.Get();
  const std::int64_t age = Now() - std::max(report.Time, service.Resumed.load());
  if (age > LongestSilence)
  {
    device.Text = "is not read any more: the library's scheduler stands still. Open() it again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (report.Error != HD_SUCCESS)
  {
    device.Text = "has a fault (" + std::string(hdGetErrorString(report.Error)) +
      "). Let it rest if its motors are warm, check its cable, then Home() and Arm() again.";
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
  auto& device = *static_cast<Device*>(handle);
  Order order;
  std::copy(force, force + 3, order.Force);
  std::copy(torque, torque + 3, order.Torque);
  order.Time = Now();
  order.Pause = device.Pause;
  device.Orders.Write(order);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Home(void* handle)
{
  static_cast<Device*>(handle)->Forgives.store(true, std::memory_order_release);
  WaitForRounds(1);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

const char* LastError(void* device)
{
  return device ? static_cast<Device*>(device)->Text.c_str() : OpenError().c_str();
}

void Close(void* handle)
{
  const std::lock_guard<std::mutex> lock(service.Mutex);
  Pause();
  Disable(static_cast<Device*>(handle));
  Resume();
}

} // namespace

const VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version)
{
  static const VolumeHapticsVendorPlugin plugin = { VOLUME_HAPTICS_VENDOR_VERSION, &Count,
    &Describe, &Open, &GetLimits, &GetSerial, &Read, &Write, &Home, &LastError, &Close };
  return version == VOLUME_HAPTICS_VENDOR_VERSION ? &plugin : nullptr;
}
