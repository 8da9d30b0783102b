// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adds an application's own device to vtkHapticDevice: a back end, a device kind, and two lines in
// the application. The "library" here only imitates the usual functions of device libraries, so
// that the example runs as it is: replace OwnLibrary's calls by those of your library. To offer a
// device to all programs, write a plug-in instead: see VendorDevice.cxx.
#include <Devices/Common/DeviceKind.h>
#include <vtkHapticDevice.h>
#include <vtkNew.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>

// ---- The device's library, with its own handles, error codes, axes, and millimetres.
namespace OwnLibrary
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
int Open(int /*number*/)
{
  return 42; // a handle; a negative number is an error
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
} // namespace OwnLibrary

namespace
{
using namespace VolumeHaptics;

/// Returns the time (ns), on the clock of DeviceSample.
std::int64_t Now()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

class OwnBackend : public DeviceBackend
{
public:
  explicit OwnBackend(int number)
    : Number(number)
  {
  }
  ~OwnBackend() override { this->Close(); }

  // Called on the application's thread, where you may wait, allocate and throw.
  bool Open(std::string& error) override
  {
    this->Handle = OwnLibrary::Open(this->Number);
    if (this->Handle < 0)
    {
      error =
        this->GetName() + " can't be opened. Plug it in, and close other programs that use it.";
    }
    return this->Handle >= 0;
  }
  void Close() override
  {
    if (this->Handle >= 0)
    {
      this->Write({});
      OwnLibrary::Close(this->Handle);
      this->Handle = -1;
    }
  }
  std::string GetName() const override { return "own:" + std::to_string(this->Number); }
  // Returns the limits on the data sheet. 0 means no limit, or an unknown one.
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits;
    limits.MaximumForce = 3.3;
    limits.MaximumStiffness = 1000.0;
    limits.MaximumSpeed = 2.5;
    limits.WorkspaceRadius = 0.08;
    return limits;
  }

  // Called on the servo's thread, a thousand times a second: no locks, no allocations, no
  // exceptions, and no waiting. If the library can't promise that, call it on a thread of your own,
  // and transfer positions and forces without locks.
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    OwnLibrary::Pose pose;
    const int result = OwnLibrary::Read(this->Handle, &pose);
    if (result < 0)
    {
      return DeviceState::Lost; // removes the force until the user opens and arms the device again
    }
    // DeviceSample uses metres, and axes that point right, up and towards the user.
    const double* const p = pose.Millimetres;
    sample.Tip = { 1e-3 * p[0], 1e-3 * p[2], -1e-3 * p[1] };
    // DeviceSample stores w first; x, y and z are components along the same axes as those of the
    // position. If the library measures no orientation, leave HasOrientation false. DeviceBackend.h
    // describes the axes of the stylus itself.
    const double* const q = pose.Quaternion;
    sample.Orientation = { q[3], q[0], q[2], -q[1] };
    sample.HasOrientation = true;
    sample.Buttons = pose.Buttons;
    sample.Fresh = result > 0;
    // This library reports no time of measurement, so use the current time.
    sample.Time = sample.Fresh ? Now() : 0;
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    // The force is already finite, clamped, and limited in its growth by the safety stage. Convert
    // it to the library's axes.
    const double newtons[3] = { force.X, -force.Z, force.Y };
    return OwnLibrary::Write(this->Handle, newtons) < 0 ? DeviceState::Lost : DeviceState::Running;
  }
  // Any thread may call this function if the servo's thread does not respond. If your library
  // accepts calls from one thread only, write a watchdog here; this library accepts calls from any
  // thread.
  void Quench() noexcept override
  {
    const double none[3] = { 0.0, 0.0, 0.0 };
    OwnLibrary::Write(this->Handle, none);
  }

private:
  const int Number;
  int Handle = -1;
};

DeviceKind MakeOwnKind()
{
  DeviceKind kind;
  kind.Name = "own";
  kind.List = []
  {
    std::vector<DeviceListing> devices;
    for (int i = 0; i < OwnLibrary::CountDevices(); ++i)
    {
      devices.push_back({ "own:" + std::to_string(i), "A stylus of our own", "available" });
    }
    return devices;
  };
  kind.Make = [](const std::string& id, const DeviceOptions&,
                std::string& error) -> std::unique_ptr<DeviceBackend>
  {
    for (int i = 0; i < OwnLibrary::CountDevices(); ++i)
    {
      if (id == "own:" + std::to_string(i) || (id == "own" && i == 0))
      {
        return std::make_unique<OwnBackend>(i);
      }
    }
    error = "There is no \"" + id + "\" here. Plug it in.";
    return nullptr;
  };
  return kind;
}
} // namespace

int main()
{
  vtkHapticDevice::AddDeviceKind(MakeOwnKind()); // once, before EnumerateDevices() and Open()
  vtkNew<vtkHapticDevice> device;
  if (!device->Open("own:0") || !device->Start())
  {
    return 1;
  }
  for (int i = 0; i < 5; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    device->UpdateState();
    const double* const tip = device->GetState()->GetTipPosition();
    const double* const turn = device->GetState()->GetTipOrientation();
    std::cout << "tip " << tip[0] << " " << tip[1] << " " << tip[2] << " mm, turned by "
              << 2.0 * std::acos(turn[0]) << " rad\n";
  }
  std::cout << device->GetStatusText() << "\n";
}
