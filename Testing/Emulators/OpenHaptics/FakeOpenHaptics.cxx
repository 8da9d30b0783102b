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
using emulated::FakeOpenHaptics;
using emulated::Triple;

constexpr HHD TheHandle = 3;

struct Scheduler
{
  std::thread Thread;
  std::atomic<bool> Runs{ false };
  HDSchedulerCallback Callback = nullptr;
  void* Data = nullptr;
};
Scheduler scheduler;
bool isOpen = false;
bool isForceEnabled = false;
bool isInFrame = false; // used by the scheduler thread
Triple frameForce{};
Triple frameTorque{};

FakeOpenHaptics& Fake()
{
  return FakeOpenHaptics::Get();
}

void Push(HDerror fault)
{
  Fake().Faults.push_back(fault);
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
        Fake().Hand.Step(time / steps, isForceEnabled ? Fake().Force : Triple{});
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
    const bool isNamed = Fake().Name.empty() || (name != nullptr && Fake().Name == name);
    if (!Fake().IsPluggedIn || isOpen || !isNamed)
    {
      Push(HD_COMM_ERROR);
      return 0;
    }
    isOpen = true;
    return TheHandle;
  }

  void hdDisableDevice(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    Fake().Calls.emplace_back("disable");
    if (device != TheHandle)
    {
      Push(HD_BAD_HANDLE);
    }
    isOpen = isForceEnabled = false;
  }

  void hdMakeCurrentDevice(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    if (device != TheHandle)
    {
      Push(HD_BAD_HANDLE);
    }
  }

  void hdEnable(HDenum capability)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    isForceEnabled = isForceEnabled || capability == HD_FORCE_OUTPUT;
  }

  void hdBeginFrame(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    if (device != TheHandle || isInFrame)
    {
      Push(HD_FRAME_ERROR);
    }
    isInFrame = true;
    frameForce = frameTorque = {};
  }

  void hdEndFrame(HHD device)
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    if (device != TheHandle || !isInFrame)
    {
      Push(HD_FRAME_ERROR);
    }
    isInFrame = false;
    Fake().Force = frameForce;
    Fake().Torque = frameTorque;
    ++Fake().Frames;
    const bool isZero = frameForce == Triple{};
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
          values[axis] = 1000.0 * Fake().Hand.Tip[axis];
        }
        values[1] = Fake().TellsNonsense ? std::numeric_limits<double>::infinity() : values[1];
        break;
      case HD_CURRENT_TRANSFORM:
        std::fill(values, values + 16, 0.0);
        for (int column = 0; column < 3; ++column)
        {
          std::copy(&Fake().Turn[3 * column], &Fake().Turn[3 * column] + 3, values + 4 * column);
          values[12 + column] = 1000.0 * Fake().Hand.Tip[column];
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
    if (!isInFrame)
    {
      Push(HD_FRAME_ERROR);
      return;
    }
    Triple& target = name == HD_CURRENT_FORCE ? frameForce : frameTorque;
    std::copy(values, values + 3, target.begin());
  }

  HDstring hdGetString(HDenum)
  {
    return "HD 0815=7";
  }

  HDErrorInfo hdGetError()
  {
    const std::lock_guard<std::mutex> lock(Fake().Mutex);
    HDErrorInfo error{ HD_SUCCESS, 0, TheHandle };
    if (!Fake().Faults.empty())
    {
      error.errorCode = Fake().Faults.back();
      Fake().Faults.pop_back();
    }
    return error;
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
    Fake().ForcesAtTheEnd += Fake().Force == Triple{} ? 0 : 1;
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
