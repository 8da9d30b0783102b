// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The plug-in forcedimension: omega, delta, sigma, lambda and the Novint Falcon through Force
// Dimension's SDK (libdrd, which contains libdhd). Other devices of the SDK get at most 8 N, unless
// the SDK has a limit for them.
//
// The SDK's axes are x towards the user, y to the right and z up, in metres and newtons. This
// library's x, y and z are the SDK's y, z and x. This was not verified on a device. The SDK's
// watchdog and velocity threshold stay on: they brake a device whose program has ended or that
// moves too fast.
//
// After Home(), a device that is not initialised moves by itself to find its zero position.
#include <Devices/Vendor/VendorPlugin.h>

#include "Orientation.h"

#include <dhdc.h>
#include <drdc.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace
{

struct Device
{
  char Id = -1;
  bool HadForce = false; // whether the force has been on since homing
  bool HasWrist = false; // whether the device measures an orientation
  double MaximumTorque = 0.0;
  std::string Error;
};

std::string& OpenError()
{
  static std::string error;
  return error;
}

// Returns the library's own text for the last fault, and the cure.
std::string Explain(const char* what, const char* cure)
{
  const char* const reason = dhdErrorGetLastStr();
  return std::string(what) + " (" + (reason ? reason : "no reason given") + "). " + cure;
}

constexpr const char* LookAfterIt = "Check its cable and power, then Home() and Arm() again.";

// Values of dhdGetSystemType(). SDK 3.17 deprecates the names of SDK 3.14, so these names are
// independent of both.
enum DeviceType
{
  Omega3 = 33,
  Omega6Right,
  Omega7Right,
  Omega6Left,
  Omega7Left,
  Delta3 = 63,
  Delta6,
  Sigma7Right = 104,
  Sigma7Left,
  Lambda7Right = 108,
  Lambda7Left,
  Lambda3 = 203,
  Sigma3 = 206
};

// Returns a type's limits (N, N m, m) from the data sheets, or from CHAI3D where its limits are
// lower. The stiffness is lower than on the data sheet, so that it suits 1 kHz.
VolumeHapticsVendorLimits LimitsOf(int type)
{
  VolumeHapticsVendorLimits limits{};
  limits.MaximumForce = 8.0;
  limits.MaximumStiffness = 2000.0;
  limits.MaximumSpeed = 2.5;
  limits.WorkspaceRadius = 0.04;
  limits.ForceAxes = 7;
  switch (type)
  {
    case Omega3:
    case Omega6Right:
    case Omega6Left:
    case Omega7Right:
    case Omega7Left:
      limits.MaximumForce = 12.0;
      limits.WorkspaceRadius = 0.055;
      break;
    case Delta3:
    case Delta6:
      limits.MaximumForce = 20.0;
      limits.MaximumTorque = type == Delta6 ? 0.2 : 0.0;
      limits.WorkspaceRadius = 0.13;
      break;
    case Sigma3:
    case Sigma7Right:
    case Sigma7Left:
      limits.MaximumForce = 12.0;
      limits.MaximumTorque = type == Sigma3 ? 0.0 : 0.2;
      limits.WorkspaceRadius = 0.065;
      break;
    case Lambda3:
    case Lambda7Right:
    case Lambda7Left:
      limits.MaximumForce = 12.0;
      limits.MaximumTorque = type == Lambda3 ? 0.0 : 0.2;
      limits.WorkspaceRadius = 0.1125;
      break;
    default:
      break;
  }
  return limits;
}

// Returns an open device's limits: those of its type, or those that the SDK has in use. Negative
// values from the SDK mean "no limit".
VolumeHapticsVendorLimits LimitsOf(char id)
{
  VolumeHapticsVendorLimits limits = LimitsOf(dhdGetSystemType(id));
  const double force = dhdGetMaxForce(id);
  const double torque = dhdGetMaxTorque(id);
  limits.MaximumForce = force > 0.0 ? force : limits.MaximumForce;
  limits.MaximumTorque = limits.MaximumTorque > 0.0 && torque > 0.0 ? torque : limits.MaximumTorque;
  return limits;
}

int Count()
{
  const int count = dhdGetDeviceCount();
  if (count < 0)
  {
    OpenError() = Explain("can't be asked for its devices", "Look after permission and cables.");
  }
  return count;
}

int Describe(int, char* name, size_t nameSize, char* serial, size_t serialSize)
{
  // The SDK reports name and serial number for open devices only.
  std::snprintf(name, nameSize, "Force Dimension device");
  std::snprintf(serial, serialSize, "%s", "");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

void Close(void* handle)
{
  auto* const device = static_cast<Device*>(handle);
  drdClose(device->Id);
  delete device;
}

void* Open(int number)
{
  const int id = drdOpenID(static_cast<char>(number));
  if (id < 0)
  {
    OpenError() = Explain("can't be opened",
      "Close other programs that use it, and check its power and your permission for it.");
    return nullptr;
  }
  auto* const device = new Device;
  device->Id = static_cast<char>(id);
  device->HasWrist = dhdHasWrist(device->Id);
  device->MaximumTorque = LimitsOf(device->Id).MaximumTorque;
  if (dhdHasActiveGripper(device->Id))
  {
    dhdEmulateButton(DHD_ON, device->Id); // makes closing the gripper act as button 0
  }
  if (drdIsInitialized(device->Id) && dhdEnableForce(DHD_ON, device->Id) < 0)
  {
    OpenError() = Explain("does not switch its force on", "Check its cable and power.");
    Close(device);
    return nullptr;
  }
  return device;
}

int GetLimits(void* handle, VolumeHapticsVendorLimits* limits)
{
  *limits = LimitsOf(static_cast<Device*>(handle)->Id);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int GetSerial(void* handle, char* serial, size_t size)
{
  ushort number = 0;
  if (dhdGetSerialNumber(&number, static_cast<Device*>(handle)->Id) < 0)
  {
    number = 0;
  }
  std::snprintf(serial, size, "%s", number != 0 ? std::to_string(number).c_str() : "");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

// Checks the device's status. Returns a negative number if the device can't be used now.
int CheckStatus(Device& device)
{
  int status[DHD_MAX_STATUS] = {};
  if (dhdGetStatus(status, device.Id) < 0)
  {
    device.Error = Explain("does not tell its status", LookAfterIt);
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (status[DHD_STATUS_CONNECTED] == 0)
  {
    device.Error = "was unplugged.";
    return VOLUME_HAPTICS_VENDOR_GONE;
  }
  if (status[DHD_STATUS_POWER] == 0)
  {
    device.Error = std::string("has no power. ") + LookAfterIt;
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (!drdIsInitialized(device.Id))
  {
    device.Error = "has no zero yet. Take your hand off it and press Home(): it moves by itself.";
    return VOLUME_HAPTICS_VENDOR_WAITS;
  }
  const bool hasForce = status[DHD_STATUS_FORCE] != 0;
  if (device.HadForce && !hasForce)
  {
    device.Error = "has switched its force off: by its button, its watchdog, or since it was too "
                   "fast. Press Home(), and Arm() again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  if (!hasForce)
  {
    // Report that the device is waiting: otherwise its button could switch on a force that has not
    // grown from zero.
    device.Error = "has its force switched off. Press its force button, or Home().";
    return VOLUME_HAPTICS_VENDOR_WAITS;
  }
  device.HadForce = true;
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Read(void* handle, VolumeHapticsVendorPose* pose)
{
  auto& device = *static_cast<Device*>(handle);
  const int status = CheckStatus(device);
  if (status < 0)
  {
    return status;
  }
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double frame[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const int result = device.HasWrist
    ? dhdGetPositionAndOrientationFrame(&x, &y, &z, frame, device.Id)
    : dhdGetPosition(&x, &y, &z, device.Id);
  if (result < 0)
  {
    device.Error = Explain("does not report its position", LookAfterIt);
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  pose->Position[0] = y;
  pose->Position[1] = z;
  pose->Position[2] = x;
  if (device.HasWrist)
  {
    // Permute rows and columns to this library's order of axes.
    const int theirs[3] = { 1, 2, 0 };
    double ours[3][3];
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        ours[row][column] = frame[theirs[row]][theirs[column]];
      }
    }
    ToQuaternion(ours, pose->Orientation);
    pose->HasOrientation = 1;
  }
  pose->Buttons = dhdGetButtonMask(device.Id);
  // If a force is sent too soon, the SDK's time guard repeats the last position, which is not an
  // error.
  return result == DHD_TIMEGUARD ? VOLUME_HAPTICS_VENDOR_DONE : VOLUME_HAPTICS_VENDOR_NEWS;
}

int Write(void* handle, const double force[3], const double torque[3])
{
  auto& device = *static_cast<Device*>(handle);
  // Positive results, such as that for saturated motors, are not errors.
  const int result = device.MaximumTorque > 0.0
    ? dhdSetForceAndTorque(force[2], force[0], force[1], torque[2], torque[0], torque[1], device.Id)
    : dhdSetForce(force[2], force[0], force[1], device.Id);
  if (result < 0)
  {
    device.Error = Explain("does not take a force", LookAfterIt);
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Home(void* handle)
{
  auto& device = *static_cast<Device*>(handle);
  device.HadForce = false;
  if (!drdIsInitialized(device.Id))
  {
    if (drdAutoInit(device.Id) < 0)
    {
      device.Error = Explain("did not find its zero", "Free its way, then press Home() again.");
      drdStop(false, device.Id);
      return VOLUME_HAPTICS_VENDOR_LOST;
    }
    // The homing routine holds the device and accepts no force from this library until it is
    // stopped.
    if (drdStop(true, device.Id) < 0)
    {
      device.Error = Explain("goes on moving by itself", LookAfterIt);
      return VOLUME_HAPTICS_VENDOR_LOST;
    }
  }
  if (dhdEnableForce(DHD_ON, device.Id) < 0)
  {
    device.Error = Explain("does not switch its force on", LookAfterIt);
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  return VOLUME_HAPTICS_VENDOR_DONE;
}

const char* LastError(void* device)
{
  return device ? static_cast<Device*>(device)->Error.c_str() : OpenError().c_str();
}

} // namespace

const VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version)
{
  static const VolumeHapticsVendorPlugin plugin = { VOLUME_HAPTICS_VENDOR_VERSION, &Count,
    &Describe, &Open, &GetLimits, &GetSerial, &Read, &Write, &Home, &LastError, &Close };
  return version == VOLUME_HAPTICS_VENDOR_VERSION ? &plugin : nullptr;
}
