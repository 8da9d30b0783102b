// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidClaim.h"

#if defined(__linux__)
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{

std::mutex& GetHidMutex()
{
  static std::mutex mutex;
  return mutex;
}

HidClaim::Answer HidClaim::Own(const std::string& path) noexcept
{
  this->Release();
#if defined(__linux__)
  this->Descriptor = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (this->Descriptor < 0)
  {
    return errno == EACCES || errno == EPERM ? Answer::Forbidden : Answer::Missing;
  }
  if (flock(this->Descriptor, LOCK_EX | LOCK_NB) != 0)
  {
    this->Release();
    return Answer::InUse;
  }
#else
  (void)path;
#endif
  return Answer::Held;
}

bool HidClaim::Write(const std::uint8_t* report, std::size_t size) const noexcept
{
#if defined(__linux__)
  return write(this->Descriptor, report, size) == static_cast<ssize_t>(size);
#else
  return report == nullptr && size == 0;
#endif
}

void HidClaim::Release() noexcept
{
#if defined(__linux__)
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
#endif
}

} // namespace VolumeHaptics
