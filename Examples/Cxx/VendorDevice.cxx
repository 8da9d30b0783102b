// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A template of a plug-in that makes a device which needs its vendor's library available to all
// programs of VTK Volume Haptics:
//
//   cmake -S Examples/Cxx -B build -DVolumeHaptics_DIR=... && cmake --build build
//   export VOLUMEHAPTICS_VENDOR_PATH=$PWD/build
//   volumehaptics-device list                        # vendor:example:0
//   volumehaptics-device monitor vendor:example:0
//
// The "library" here only imitates the usual functions of such libraries, so that the example runs
// as it is: replace VendorSdk's calls by those of your vendor's library. VendorPlugin.h describes
// what each function has to do. For safety, a plug-in is not loaded if other users can write to it
// or to a folder above it.
#include <Devices/Vendor/VendorPlugin.h>

#include <cmath>
#include <cstdio>

// ---- The vendor's library, with its own handles, error codes, axes, and millimetres.
namespace VendorSdk
{
struct Pose
{
  double Millimetres[3]; // right, away from the user, up
  // x, y, z, w: the rotation of the pen; without a rotation, its tail points to the user
  double Quaternion[4];
  unsigned int Buttons;
};

int CountDevices()
{
  return 1;
}
int Open(int number)
{
  return number == 0 ? 42 : -1; // a handle; a negative number is an error
}
int Read(int /*handle*/, Pose* pose) // negative: an error; 0: nothing new
{
  static double time = 0.0;
  time += 0.001;
  const double half = 0.3 * std::sin(time); // makes the tail swing to the right and to the left
  *pose = { { 10.0 * std::sin(time), 0.0, 20.0 }, { 0.0, 0.0, std::sin(half), std::cos(half) },
    0u };
  return 1;
}
int Write(int /*handle*/, const double /*newtons*/[3])
{
  return 0;
}
void Close(int /*handle*/) {}
} // namespace VendorSdk

namespace
{

struct Device
{
  int Handle = -1;
  const char* Error = "";
};

const char* openError = "";

int Count()
{
  return VendorSdk::CountDevices();
}

int Describe(int number, char* name, size_t nameSize, char* serial, size_t serialSize)
{
  std::snprintf(name, nameSize, "A stylus of a vendor");
  // The user's confirmation and calibration of the device are stored under this name.
  std::snprintf(serial, serialSize, "example-%d", number);
  return VOLUME_HAPTICS_VENDOR_DONE;
}

void* Open(int number)
{
  const int handle = VendorSdk::Open(number);
  if (handle < 0)
  {
    openError = "can't be opened. Plug it in, and close other programs that use it.";
    return nullptr;
  }
  auto* const device = new Device;
  device->Handle = handle;
  return device;
}

// Returns the limits on the data sheet.
int GetLimits(void*, VolumeHapticsVendorLimits* limits)
{
  *limits = {};
  limits->MaximumForce = 3.3;
  limits->MaximumStiffness = 1000.0;
  limits->MaximumSpeed = 2.5;
  limits->WorkspaceRadius = 0.08;
  limits->ForceAxes = 7;
  // The motors can sustain 0.9 N indefinitely, and the largest force for two seconds.
  limits->ContinuousForce = 0.9;
  limits->PeakTime = 2.0;
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int GetSerial(void*, char* serial, size_t size)
{
  std::snprintf(serial, size, "example-0");
  return VOLUME_HAPTICS_VENDOR_DONE;
}

int Read(void* handle, VolumeHapticsVendorPose* pose)
{
  auto* const device = static_cast<Device*>(handle);
  VendorSdk::Pose told;
  const int result = VendorSdk::Read(device->Handle, &told);
  if (result < 0)
  {
    // The force stays off until the user opens or homes the device and arms it again.
    device->Error = "does not answer. Check its cable, then Home() and Arm() again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  // The sample uses metres, and axes that point right, up and towards the user.
  const double* const p = told.Millimetres;
  pose->Position[0] = 1e-3 * p[0];
  pose->Position[1] = 1e-3 * p[2];
  pose->Position[2] = -1e-3 * p[1];
  // The sample stores w first; x, y and z are components along the same axes as those of the
  // position. If the library measures no orientation, leave HasOrientation 0.
  const double* const q = told.Quaternion;
  pose->Orientation[0] = q[3];
  pose->Orientation[1] = q[0];
  pose->Orientation[2] = q[2];
  pose->Orientation[3] = -q[1];
  pose->HasOrientation = 1;
  pose->Buttons = told.Buttons;
  return result > 0 ? VOLUME_HAPTICS_VENDOR_NEWS : VOLUME_HAPTICS_VENDOR_DONE;
}

int Write(void* handle, const double force[3], const double[3])
{
  auto* const device = static_cast<Device*>(handle);
  // Convert the force to the library's axes.
  const double newtons[3] = { force[0], -force[2], force[1] };
  if (VendorSdk::Write(device->Handle, newtons) < 0)
  {
    device->Error = "does not take forces. Check its cable, then Home() and Arm() again.";
    return VOLUME_HAPTICS_VENDOR_LOST;
  }
  return VOLUME_HAPTICS_VENDOR_DONE;
}

const char* LastError(void* device)
{
  return device ? static_cast<Device*>(device)->Error : openError;
}

void Close(void* handle)
{
  auto* const device = static_cast<Device*>(handle);
  VendorSdk::Close(device->Handle);
  delete device;
}

} // namespace

const VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version)
{
  static const VolumeHapticsVendorPlugin plugin = { VOLUME_HAPTICS_VENDOR_VERSION, &Count,
    &Describe, &Open, &GetLimits, &GetSerial, &Read, &Write, nullptr, &LastError, &Close };
  return version == VOLUME_HAPTICS_VENDOR_VERSION ? &plugin : nullptr;
}
