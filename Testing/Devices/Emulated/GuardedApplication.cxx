// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An application that presses with a Falcon, and comes to its end in the way that its argument says
 * once there is something to read: see FalconGuardTest.cxx. It never says zero.
 */

#include "Devices/Common/DeviceRegistry.h"

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
    // A child that goes on has everything open that the application had.
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
  const auto device = MakeDevice("falcon", options, error);
  if (argc < 2 || !device || !device->Open(error))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    return 1;
  }
  pollfd input = { STDIN_FILENO, POLLIN, 0 };
  while (poll(&input, 1, 0) == 0)
  {
    DeviceSample sample;
    device->Read(0.001, sample);
    device->Write({ 0.0, 0.0, 2.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  End(argv[1]);
  return 2;
}
