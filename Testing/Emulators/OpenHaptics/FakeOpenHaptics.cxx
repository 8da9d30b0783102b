// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FakeOpenHaptics.h"

#include <HD/hd.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace
{
using emulated::FakeArm;
using emulated::FakeOpenHaptics;
using emulated::Triple;

constexpr HHD FirstHandle = 3;
constexpr HHD RightHandle = 4;

struct Scheduler
{
  std::thread Thread;
  std::atomic<bool> Runs{ false };
  HDSchedulerCallback Callback = nullptr;
  void* Data = nullptr;
};
Scheduler scheduler;
HHD current = FirstHandle;

FakeOpenHaptics& Fake()
{
  return FakeOpenHaptics::Get();
}

FakeArm& Arm(HHD handle)
{
  return handle == RightHandle ? Fake().Right : Fake();
}

bool IsOpen(HHD handle)
{
  return (handle == FirstHandle || handle == RightHandle) && Arm(handle).IsOpen;
}

// Pushes an error on the current device's error stack.
void Push(HDerror fault)
{
  Arm(current).Faults.push_back(fault);
}

void RunScheduler()
{
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  while (scheduler.Runs)
  {
    std::this_thread::sleep_for(std::chrono::microseconds(1000));
    const auto now = Clock::now();
    const double time = std::min(0.05, std::chrono::duration<double>(now - last).count());
    last = now;
    bool standsStill = false;
    {
      const std::lock_guard<std::mutex> lock(Fake().Mutex);
      const int steps = 1 + static_cast<int>(time / 1e-3);
      for (int i = 0; i < steps; ++i)
      {
        for (const HHD handle : { FirstHandle, RightHandle })
        {
          FakeArm& arm = Arm(handle);
          arm.Hand.Step(time / steps, arm.IsForceEnabled ? arm.Force : Triple{});
        }
      }
      standsStill = Fake().StandsStill;
    }
    if (scheduler.Callback && !standsStill)
    {
      scheduler.Callback(scheduler.Data);
    }
  }
}
} // namespace

emulated::FakeOpenHaptics& FakeOpenHaptics::Get()
{
  static FakeOpenHaptics fake;
  return fake;
}

extern "C"
{

  HHD hdInitDevice(HDstring name)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    Fake().Calls.push_back(std::string("init ") + (name ? name : "default"));
    const bool isRight = name != nullptr && std::string(name) == "Right";
    const bool isNamed = isRight || Fake().Name.empty() || (name != nullptr && Fake().Name == name);
    const HHD handle = isRight ? RightHandle : FirstHandle;
    if (scheduler.Runs)
    {
      Push(HD_INVALID_OPERATION);
      return 0;
    }
    if (!Fake().IsPluggedIn || Arm(handle).IsOpen || !isNamed)
    {
      Push(HD_COMM_ERROR);
      return 0;
    }
    Arm(handle).IsOpen = true;
    current = handle;
    return handle;
  }

  void hdDisableDevice(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    Fake().Calls.emplace_back("disable");
    if (!IsOpen(device))
    {
      Push(HD_BAD_HANDLE);
      return;
    }
    if (scheduler.Runs)
    {
      Push(HD_INVALID_OPERATION);
    }
    Arm(device).IsOpen = Arm(device).IsForceEnabled = false;
  }

  void hdMakeCurrentDevice(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    if (!IsOpen(device))
    {
      Push(HD_BAD_HANDLE);
      return;
    }
    current = device;
  }

  void hdEnable(HDenum capability)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    bool& isEnabled = Arm(current).IsForceEnabled;
    isEnabled = isEnabled || capability == HD_FORCE_OUTPUT;
  }

  void hdBeginFrame(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    FakeArm& arm = Arm(device);
    if (!IsOpen(device) || arm.IsInFrame)
    {
      Push(HD_FRAME_ERROR);
    }
    arm.IsInFrame = true;
    arm.FrameForce = arm.FrameTorque = {};
  }

  void hdEndFrame(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    FakeArm& arm = Arm(device);
    if (!IsOpen(device) || !arm.IsInFrame)
    {
      Push(HD_FRAME_ERROR);
    }
    arm.IsInFrame = false;
    if (device == FirstHandle)
    {
      Fake().LargestFall = std::max(Fake().LargestFall, arm.Force[1] - arm.FrameForce[1]);
    }
    arm.Force = arm.FrameForce;
    arm.Torque = arm.FrameTorque;
    ++Fake().Frames;
    const bool isZero = arm.FrameForce == Triple{};
    Fake().ForcesBeforeZero += !isZero && Fake().Calibration != HD_CALIBRATION_OK ? 1 : 0;
  }

  void hdGetDoublev(HDenum name, HDdouble* values)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    const double box[6] = { -80, -60, -35, 80, 60, 35 };
    switch (name)
    {
      case HD_CURRENT_POSITION:
        for (int axis = 0; axis < 3; ++axis)
        {
          values[axis] = 1000.0 * Arm(current).Hand.Tip[axis];
        }
        values[1] = Fake().TellsNonsense ? std::numeric_limits<double>::infinity() : values[1];
        break;
      case HD_CURRENT_TRANSFORM:
        std::fill(values, values + 16, 0.0);
        for (int column = 0; column < 3; ++column)
        {
          std::copy(&Fake().Turn[3 * column], &Fake().Turn[3 * column] + 3, values + 4 * column);
          values[12 + column] = 1000.0 * Arm(current).Hand.Tip[column];
        }
        values[15] = 1.0;
        break;
      case HD_NOMINAL_MAX_FORCE:
        *values = 3.3;
        break;
      case HD_NOMINAL_MAX_CONTINUOUS_FORCE:
        *values = Fake().ContinuousForce;
        break;
      case HD_NOMINAL_MAX_STIFFNESS:
        *values = 1.0; // N/mm
        break;
      case HD_NOMINAL_MAX_DAMPING:
        *values = 0.003; // N s/mm
        break;
      case HD_USABLE_WORKSPACE_DIMENSIONS:
        std::copy(box, box + 6, values);
        break;
      default:
        Push(HD_FRAME_ERROR);
    }
  }

  void hdGetIntegerv(HDenum name, HDint* values)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    *values = name == HD_CURRENT_BUTTONS ? Fake().Buttons
      : name == HD_OUTPUT_DOF            ? Fake().OutputDof
                                         : Fake().Styles;
  }

  void hdSetDoublev(HDenum name, const HDdouble* values)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    FakeArm& arm = Arm(current);
    if (!arm.IsInFrame)
    {
      Push(HD_FRAME_ERROR);
      return;
    }
    Triple& target = name == HD_CURRENT_FORCE ? arm.FrameForce : arm.FrameTorque;
    std::copy(values, values + 3, target.begin());
  }

  HDstring hdGetString(HDenum)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    return current == RightHandle ? "HD 0816" : "HD 0815=7";
  }

  HDErrorInfo hdGetError()
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    for (const HHD handle : { FirstHandle, RightHandle })
    {
      std::vector<unsigned>& faults = Arm(handle).Faults;
      if (!faults.empty())
      {
        const HDErrorInfo error{ faults.back(), 0, handle };
        faults.pop_back();
        return error;
      }
    }
    return { HD_SUCCESS, 0, current };
  }

  HDstring hdGetErrorString(HDerror error)
  {
    return error == HD_COMM_ERROR ? "Communication error"
      : error == HD_WARM_MOTORS   ? "Motors too warm"
                                  : "Some error";
  }

  HDenum hdCheckCalibration()
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    return Fake().Calibration;
  }

  void hdUpdateCalibration(HDenum style)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    const char* const name = style == HD_CALIBRATION_AUTO ? "update automatically"
      : style == HD_CALIBRATION_INKWELL                   ? "update in the inkwell"
      : style == HD_CALIBRATION_ENCODER_RESET             ? "update by a reset"
                                                          : nullptr;
    if (name == nullptr || (Fake().Styles & static_cast<int>(style)) == 0)
    {
      Push(HD_INVALID_ENUM);
      return;
    }
    Fake().Calls.emplace_back(name);
    Fake().Calibration = HD_CALIBRATION_OK;
  }

  void hdSetSchedulerRate(HDulong) {}

  void hdStartScheduler()
  {
    scheduler.Runs = true;
    scheduler.Thread = std::thread(&RunScheduler);
  }

  void hdStopScheduler()
  {
    scheduler.Runs = false;
    if (scheduler.Thread.joinable())
    {
      scheduler.Thread.join();
    }
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    Fake().Calls.emplace_back("stop");
    const bool isZero = Fake().Force == Triple{} && Fake().Right.Force == Triple{};
    Fake().ForcesAtTheEnd += isZero ? 0 : 1;
  }

  HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback callback, void* data, HDushort)
  {
    scheduler.Callback = callback;
    scheduler.Data = data;
    return 9;
  }

  void hdUnschedule(HDSchedulerHandle)
  {
    scheduler.Callback = nullptr;
  }
}
