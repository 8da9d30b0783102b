// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An application that presses with a device. Once its standard input is readable, it ends in the
 * way named by its first argument (see FalconGuardTest.cxx), without ever sending zero force. The
 * second argument names the device. A device that vibrates gets a changing force.
 */

#include "Devices/Kinds/DeviceRegistry.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include <poll.h>
#include <unistd.h>

using namespace VolumeHaptics;

namespace
{

void End(const std::string& way)
{
  if (way == "abort")
  {
    std::abort();
  }
  else if (way == "crash")
  {
    std::raise(SIGSEGV);
  }
  else if (way == "exception")
  {
    std::thread([] { throw 1; }).join();
  }
  else if (way == "quick_exit")
  {
    std::quick_exit(0);
  }
  else if (way == "_exit")
  {
    _exit(0);
  }
  else if (way == "exec")
  {
    execlp("sleep", "sleep", "60", nullptr);
  }
  else if (way == "fork")
  {
    // The child process continues to have all files and devices of the application open.
    if (fork() == 0)
    {
      sleep(5);
    }
    _exit(0);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::string error;
  DeviceOptions options;
  const auto device = MakeDevice(argc < 3 ? "" : argv[2], options, error);
  if (!device || !device->Open(error))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    return 1;
  }
  const bool vibrates = device->GetLimits().Vibrates;
  pollfd input = { STDIN_FILENO, POLLIN, 0 };
  for (int tick = 0; poll(&input, 1, 0) == 0; ++tick)
  {
    DeviceSample sample;
    device->Read(0.001, sample);
    device->Write({ 0.0, 0.0, vibrates && tick / 40 % 2 != 0 ? -2.0 : 2.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  End(argv[1]);
  return 2;
}
