// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Guard/GuardMemory.h"

#include <cerrno>
#include <cstring>
#include <new>

#include <sys/mman.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

/**
 * Version of the protocol: change it whenever program and guard exchange anything new outside the
 * exchange.
 */
constexpr int Protocol = 1;

static_assert(std::atomic<std::uint32_t>::is_always_lock_free &&
    std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
    std::atomic<std::uint8_t>::is_always_lock_free && std::atomic<DeviceStage>::is_always_lock_free,
  "locks of an atomic are not shared by two processes");

std::string SystemError(const char* what)
{
  return std::string("The memory that is shared with the guard process can't be allocated (") +
    what + ": " + std::strerror(errno) + ").";
}

} // namespace

GuardMemory::~GuardMemory()
{
  this->End();
  if (this->Address != nullptr)
  {
    munmap(this->Address, sizeof(HardwareExchange));
  }
}

void GuardMemory::End() noexcept
{
  if (this->IsOwner && this->Exchange != nullptr)
  {
    this->Exchange->~HardwareExchange();
  }
  this->Exchange = nullptr;
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
}

bool GuardMemory::Renew(std::string& error)
{
  const int fresh = memfd_create("volumehaptics-guard", MFD_CLOEXEC);
  if (fresh < 0 || ftruncate(fresh, sizeof(HardwareExchange)) != 0)
  {
    error = SystemError("memfd_create");
    if (fresh >= 0)
    {
      close(fresh);
    }
    return false;
  }
  this->End();
  this->IsOwner = this->Map(fresh, error);
  if (this->IsOwner)
  {
    this->Exchange = new (this->Address) HardwareExchange;
  }
  return this->IsOwner;
}

bool GuardMemory::Adopt(int descriptor, std::string& error)
{
  if (!this->Map(descriptor, error))
  {
    return false;
  }
  this->Exchange = std::launder(static_cast<HardwareExchange*>(this->Address));
  return true;
}

bool GuardMemory::Map(int descriptor, std::string& error)
{
  this->Descriptor = descriptor;
  void* const address = mmap(this->Address, sizeof(HardwareExchange), PROT_READ | PROT_WRITE,
    MAP_SHARED | (this->Address != nullptr ? MAP_FIXED : 0), descriptor, 0);
  if (address == MAP_FAILED)
  {
    error = SystemError("mmap");
    return false;
  }
  this->Address = address;
  return true;
}

std::string GuardMemory::GetLayout()
{
  return std::to_string(Protocol) + "." + std::to_string(sizeof(HardwareExchange));
}

} // namespace VolumeHaptics
