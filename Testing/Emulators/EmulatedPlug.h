// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A USB device from plugging in to unplugging: its file under /dev/bus/usb, and its ioctls. The
 * object answers requests until the program ends.
 */
#ifndef EmulatedPlug_h
#define EmulatedPlug_h

#include "EmulatedUsb.h"
#include "Testbed.h"

#include <list>
#include <mutex>

namespace emulated
{

class EmulatedUsb::Plug
{
public:
  Plug(UsbModel& model, const std::string& port, int address);

  void Unplug();
  void ForgetProgram();
  bool IsGone() const { return this->Gone; }
  std::string GetFile() const { return this->File; }

  /** Passes data that the model sends unrequested to the caller that waits for data. */
  void Pump();

  mutable std::mutex Mutex;
  std::string Driver;                   ///< driver of the kernel that is bound to interface 0
  UMockdevIoctlClient* Owner = nullptr; ///< client that has claimed interface 0

private:
  /** A request that libusb has submitted, with its client. */
  struct Urb
  {
    UMockdevIoctlData* Data;
    UMockdevIoctlClient* Client;
  };
  static gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plug);
  static void OnVanished(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plug);

  void AddDevice(const std::string& port, int address);
  void ReplaceNode();
  ///@{
  /** Answer requests. Must be called with the mutex locked; return 0 or -errno. */
  int Answer(UMockdevIoctlClient* client, unsigned long request, UMockdevIoctlData* argument);
  int Claim(UMockdevIoctlClient* client);
  int DisconnectAndClaim(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int DriverIoctl(UMockdevIoctlData* argument);
  int Submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int Reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int Discard(UMockdevIoctlData* argument);
  ///@}
  bool Try(const Urb& urb);
  void PumpLocked();
  void SetReady(bool ready);

  UsbModel& Model;
  UMockdevIoctlBase* const Base;
  std::string Node; ///< /dev/bus/usb/...
  std::string Path; ///< path in /sys/devices
  std::string File; ///< file that replaces the node
  std::list<Urb> Waiting;
  std::list<Urb> Ended;
  int Pipe = -1;
  bool Full = false;
  bool Gone = false;
};

} // namespace emulated

#endif
