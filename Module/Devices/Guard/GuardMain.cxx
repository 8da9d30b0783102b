// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Guard/GuardMain.h"

#include "Core/Realtime/ServoClock.h"
#include "Core/Realtime/ServoPriority.h"
#include "Devices/Guard/GuardMemory.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <poll.h>
#include <sys/mman.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

enum Argument
{
  Layout = 1,
  Memory,
  Link,
  Parent,
  Clock,
  FirstWord
};

/**
 * Closes the files that the guard inherited from the program, except `kept`. Otherwise the guard
 * might keep a pipe open after the program has ended.
 */
void CloseOthers(std::vector<int> kept)
{
#if defined(SYS_close_range)
  std::sort(kept.begin(), kept.end());
  unsigned int from = STDERR_FILENO + 1;
  for (const int descriptor : kept)
  {
    const auto end = static_cast<unsigned int>(descriptor);
    if (end > from)
    {
      syscall(SYS_close_range, from, end - 1, 0u);
    }
    from = std::max(from, end + 1);
  }
  syscall(SYS_close_range, from, ~0u, 0u);
#endif
}

/**
 * Blocks signals for all threads that are created later. Returns a file descriptor that becomes
 * readable on SIGTERM.
 */
int OpenSignals()
{
  // Block signals before threads are created. A crash still ends the process.
  ServoClock::BlockSignals();
  sigset_t term;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  return signalfd(-1, &term, SFD_CLOEXEC);
}

/**
 * Waits until the program has ended in any way. The link hangs up when its last file descriptor is
 * closed, by exit or exec. The descriptor of the ended process also becomes readable, even if one
 * of its children still has the link open.
 */
void WaitForParent(int link, int parent, int signals, HardwareExchange& exchange)
{
  int process = -1;
#if defined(SYS_pidfd_open)
  process = static_cast<int>(syscall(SYS_pidfd_open, parent, 0u));
#endif
  // The program may have ended before its descriptor was opened, and another process may have its
  // id now.
  const bool isGone = getppid() != parent;
  std::array<pollfd, 3> watched{ { { link, 0, 0 }, { process, POLLIN, 0 },
    { signals, POLLIN, 0 } } };
  while (!isGone && poll(watched.data(), watched.size(), -1) <= 0)
  {
  }
  exchange.RequestStop();
}

/**
 * Returns whether this process has the same clock as the program, which passed the time `told` when
 * it started this process. The clocks differ if a time namespace separates the processes; the guard
 * then could not detect that the program has stopped.
 */
bool IsSameClock(const std::string& told)
{
  constexpr double longest = 60.0; // seconds, longest duration of a start
  const double since = ServoClock::SecondsSince(std::strtoll(told.c_str(), nullptr, 10));
  return since >= 0.0 && since < longest;
}

bool Answer(int link, char sign, const std::string& text)
{
  const std::string line = sign + text + '\n';
  return send(link, line.data(), line.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(line.size());
}

void Serve(HardwareDriver& driver, HardwareExchange& exchange)
{
  try
  {
    driver.ServeUntilStop(exchange);
  }
  catch (const std::exception& e)
  {
    exchange.SetCondition(DeviceStage::Lost, e.what());
  }
}

} // namespace

int RunGuard(const std::vector<std::string>& arguments, const GuardedDriverMaker& make)
{
  if (arguments.size() <= FirstWord)
  {
    std::fputs("volumehaptics-guard is started by the library that needs it: it talks to a haptic "
               "device, and sends zero force when the program that uses the device ends or "
               "hangs.\n",
      stderr);
    return 2;
  }
  const int memoryDescriptor = std::atoi(arguments[Memory].c_str());
  const int link = std::atoi(arguments[Link].c_str());
  const int signals = OpenSignals();
  std::string error;
  static GuardMemory memory; // static, because threads use it until the process ends
  if (arguments[Layout] != GuardMemory::GetLayout())
  {
    Answer(link, '-',
      "The guard of the device has another version than this library. Reinstall "
      "both, from the same package.");
    return 1;
  }
  if (!IsSameClock(arguments[Clock]))
  {
    Answer(link, '-',
      "The guard of the device has another clock than this program. Enter the time namespace "
      "first, then start the program.");
    return 1;
  }
  if (!memory.Adopt(memoryDescriptor, error))
  {
    Answer(link, '-', error);
    return 1;
  }
  HardwareExchange& exchange = memory.GetExchange();
  CloseOthers({ memoryDescriptor, link, signals, exchange.GetWakeDescriptor() });
  const int parent = std::atoi(arguments[Parent].c_str());
  std::thread([=, &exchange] { WaitForParent(link, parent, signals, exchange); }).detach();

  const std::unique_ptr<HardwareDriver> driver =
    make({ arguments.begin() + FirstWord, arguments.end() }, error);
  if (!driver || !driver->Connect(error))
  {
    Answer(link, '-', error);
    return 1;
  }
  if (Answer(link, '+', driver->GetIdentity() + '\t' + driver->GetName()))
  {
    ServoPriority::RaiseThread();
    // Lock the memory as far as permitted; otherwise a page might have to be read from the disk
    // first.
    mlockall(MCL_CURRENT);
    Serve(*driver, exchange);
  }
  driver->Disconnect();
  return 0;
}

} // namespace VolumeHaptics
