// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * HID devices through hidapi: which are plugged in, and one that is open.
 *
 * Linux lets any number of programs open a hidraw node, and each of them send forces. Here a device
 * is held by one alone: a lock (flock) on its node keeps out every other holder that asks for it,
 * in this process and in others. What does not ask, such as a joystick driver of the kernel, is not
 * kept out.
 */
#ifndef HidPort_h
#define HidPort_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <hidapi.h>

#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** The packets that the kernel keeps for a reader. */
constexpr int LongestQueue = 64;

/** An interface of a HID device that is plugged in. */
struct HidPlace
{
  std::string Path; ///< what opens it; on Linux its node
  std::string Maker;
  std::string Product; ///< what the device calls itself
  std::uint16_t Vendor = 0;
  std::uint16_t ProductId = 0;
  std::uint16_t UsagePage = 0; ///< of its first collection; 0 where that is not known

  /** Maker, product and path, for people. */
  std::string GetLabel() const;
  /** "available", "in use", or what is in the way and the cure. */
  std::string GetState() const;
  /** What it says of its reports. False, with the reason, where that can't be had or understood. */
  bool ReadDescriptor(HidReportDescriptor& descriptor, std::string& error) const;
};

/** In the order in which the system numbers them. Any thread. */
std::vector<HidPlace> FindHidDevices();

/**
 * hidapi's functions without a device share an error message. Looking whether one is free is
 * claiming it, too.
 */
std::mutex& GetHidMutex();

/** Holds the lock on a node. */
class HidClaim
{
public:
  enum class Answer : std::uint8_t
  {
    Held,
    InUse,
    Forbidden,
    Missing
  };

  HidClaim() = default;
  ~HidClaim() { this->Release(); }
  HidClaim(const HidClaim&) = delete;
  HidClaim& operator=(const HidClaim&) = delete;

  Answer Take(const std::string& path) noexcept;
  void Release() noexcept;

private:
  int Descriptor = -1;
};

/**
 * A device that is held and open. Nothing waits longer than it is told to, or than the kernel's 5 s
 * for USB.
 */
class HidPort
{
public:
  HidPort() = default;
  ~HidPort() { this->Close(); }
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;

  /** False, with the reason and the cure. IsInUse tells whether that is another holder. */
  bool Open(const HidPlace& place, std::string& error);
  void Close() noexcept;
  bool IsInUse() const noexcept { return this->InUse; }

  /**
   * The size of a report, 0 where none came within the time (ms), below zero where the device is
   * gone.
   */
  int Read(std::uint8_t* bytes, std::size_t size, int time) noexcept;

  ///@{
  /**
   * Reports begin with their id, 0 where the device has none. False where the device does not take
   * it.
   */
  bool Write(const std::uint8_t* report, std::size_t size) noexcept;
  bool SendFeature(const std::uint8_t* report, std::size_t size) noexcept;
  /**
   * After the kernel has waited in vain for a device to take a report, nothing more is sent until
   * this is called: each report would wait as long, and the device's own watchdog has long taken
   * its force away.
   */
  void TryAgain() noexcept { this->Stuck = false; }
  /**
   * Fills in the report of the id that it begins with. Its size with the id, below zero where there
   * is none.
   */
  int GetFeature(std::uint8_t* report, std::size_t size) noexcept;
  ///@}

private:
  template <typename F>
  bool Send(F&& send) noexcept;

  hid_device* Device = nullptr;
  HidClaim Claim;
  bool InUse = false;
  bool Stuck = false;
};

} // namespace VolumeHaptics

#endif
