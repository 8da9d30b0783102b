// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlayedVendor.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace
{
PlayedVendor& Played()
{
  static PlayedVendor played;
  return played;
}
} // namespace

extern "C"
{
#if defined(_WIN32)
  __declspec(dllexport)
#else
  __attribute__((visibility("default")))
#endif
    PlayedVendor* GetPlayedVendor()
  {
    return &Played();
  }

  int PlayedCount()
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    ++Played().Asked;
    return Played().Count;
  }
  int PlayedDescribe(int number, char* name, size_t nameSize, char* serial, size_t serialSize)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    ++Played().Asked;
    std::snprintf(name, nameSize, "%s %d", Played().Name.c_str(), number);
    std::snprintf(
      serial, serialSize, "%s", Played().TellsSerialOnlyOpen ? "" : Played().Serial.c_str());
    return VOLUME_HAPTICS_VENDOR_DONE;
  }
  void* PlayedOpen(int)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    Played().Calls.emplace_back("open");
    return Played().OpenFails != 0 ? nullptr : &Played();
  }
  int PlayedGetLimits(void*, VolumeHapticsVendorLimits* limits)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    *limits = Played().Limits;
    return VOLUME_HAPTICS_VENDOR_DONE;
  }
  int PlayedGetSerial(void*, char* serial, size_t size)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    std::snprintf(serial, size, "%s", Played().Serial.c_str());
    return VOLUME_HAPTICS_VENDOR_DONE;
  }
  int PlayedRead(void*, VolumeHapticsVendorPose* pose)
  {
    int time = 0;
    {
      const std::lock_guard<std::mutex> lock(Played().Mutex);
      std::swap(time, Played().ReadTime);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(time));
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    *pose = Played().Pose;
    return Played().ReadResult;
  }
  int PlayedWrite(void*, const double force[3], const double torque[3])
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    std::array<double, 3> f{};
    std::array<double, 3> t{};
    std::copy(force, force + 3, f.begin());
    std::copy(torque, torque + 3, t.begin());
    if (f != Played().Force || t != Played().Torque || Played().Calls.back() == "open")
    {
      const bool isZero = f == std::array<double, 3>{} && t == std::array<double, 3>{};
      Played().Calls.emplace_back(isZero ? "zero" : "force");
    }
    Played().Force = f;
    Played().Torque = t;
    return Played().WriteResult;
  }
  int PlayedHome(void*)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    ++Played().Homes;
    return Played().HomeResult;
  }
  const char* PlayedLastError(void*)
  {
    return Played().Error.c_str();
  }
  void PlayedClose(void*)
  {
    const std::lock_guard<std::mutex> lock(Played().Mutex);
    Played().Calls.emplace_back("close");
  }
}
