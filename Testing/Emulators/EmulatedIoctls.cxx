// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedPlug.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <sys/ioctl.h>

#include <linux/usbdevice_fs.h>

namespace emulated
{
namespace
{

/**
 * Thrown if the client has ended in the middle of its request, for example because it was killed.
 */
struct ClientHasEnded
{
};

UMockdevIoctlData* Resolve(UMockdevIoctlData* argument, std::size_t offset, std::size_t size)
{
  UMockdevIoctlData* const target = umockdev_ioctl_data_resolve(argument, offset, size, nullptr);
  return target != nullptr ? target : throw ClientHasEnded();
}

/**
 * Accesses the memory that an argument points to, which stays valid during this object's lifetime.
 */
template <typename T>
class Argument
{
public:
  explicit Argument(UMockdevIoctlData* argument)
    : Data(Resolve(argument, 0, sizeof(T)))
  {
  }
  ~Argument() { g_object_unref(this->Data); }
  Argument(const Argument&) = delete;
  Argument& operator=(const Argument&) = delete;
  T* operator->() { return reinterpret_cast<T*>(this->Data->data); }
  T& operator*() { return *reinterpret_cast<T*>(this->Data->data); }

private:
  UMockdevIoctlData* const Data;
};

usbdevfs_urb& UrbOf(UMockdevIoctlData* data)
{
  return *reinterpret_cast<usbdevfs_urb*>(data->data);
}

} // namespace

gboolean EmulatedUsb::Plug::OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plug)
{
  Plug& self = *static_cast<Plug*>(plug);
  int result = 0;
  {
    const std::lock_guard<std::mutex> lock(self.Mutex);
    try
    {
      result = self.Answer(
        client, umockdev_ioctl_client_get_request(client), umockdev_ioctl_client_get_arg(client));
    }
    catch (const ClientHasEnded&)
    {
      result = -EIO; // OnVanished follows
    }
  }
  umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
  return TRUE;
}

void EmulatedUsb::Plug::OnVanished(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plug)
{
  Plug& self = *static_cast<Plug*>(plug);
  const std::lock_guard<std::mutex> lock(self.Mutex);
  if (self.Owner == client)
  {
    self.Owner = nullptr;
    self.Model.Released();
  }
  for (std::list<Urb>* const urbs : { &self.Waiting, &self.Ended })
  {
    urbs->remove_if(
      [client](const Urb& urb)
      {
        const bool isHis = urb.Client == client;
        if (isHis)
        {
          g_object_unref(urb.Data);
        }
        return isHis;
      });
  }
  self.PumpLocked();
}

int EmulatedUsb::Plug::Answer(
  UMockdevIoctlClient* client, unsigned long request, UMockdevIoctlData* argument)
{
  const bool isForUrbs = request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY ||
    request == USBDEVFS_DISCARDURB;
  if (this->Gone && !isForUrbs)
  {
    return -ENODEV;
  }
  switch (request)
  {
    case USBDEVFS_GET_CAPABILITIES:
      *Argument<std::uint32_t>(argument) = USBDEVFS_CAP_ZERO_PACKET |
        USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
        USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      return 0;
    case USBDEVFS_CLAIMINTERFACE:
      return this->Claim(client);
    case USBDEVFS_DISCONNECT_CLAIM:
      return this->DisconnectAndClaim(client, argument);
    case USBDEVFS_RELEASEINTERFACE:
      if (this->Owner != client)
      {
        return -EINVAL;
      }
      this->Owner = nullptr;
      this->Model.Released();
      return 0;
    case USBDEVFS_GETDRIVER:
    {
      Argument<usbdevfs_getdriver> driver(argument);
      const std::string name = this->Owner != nullptr ? "usbfs" : this->Driver;
      std::strncpy(driver->driver, name.c_str(), sizeof(driver->driver) - 1);
      return name.empty() ? -ENODATA : 0;
    }
    case USBDEVFS_IOCTL:
      return this->DriverIoctl(argument);
    case USBDEVFS_CLEAR_HALT:
    {
      // Clear the halt by the USB request CLEAR_FEATURE (ENDPOINT_HALT).
      const std::uint8_t setup[8] = { 0x02, 1, 0, 0,
        static_cast<std::uint8_t>(*Argument<unsigned int>(argument)), 0, 0, 0 };
      return this->Model.Control(setup, nullptr, 0);
    }
    case USBDEVFS_SUBMITURB:
      return this->Submit(client, argument);
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      return this->Reap(client, argument);
    case USBDEVFS_DISCARDURB:
      return this->Discard(argument);
    default:
      return -ENOTTY;
  }
}

int EmulatedUsb::Plug::Claim(UMockdevIoctlClient* client)
{
  if ((this->Owner != nullptr && this->Owner != client) || !this->Driver.empty())
  {
    return -EBUSY;
  }
  this->Owner = client;
  return 0;
}

int EmulatedUsb::Plug::DisconnectAndClaim(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  Argument<usbdevfs_disconnect_claim> claim(argument);
  const bool isExcepted = (claim->flags & USBDEVFS_DISCONNECT_CLAIM_EXCEPT_DRIVER) != 0 &&
    std::strcmp(claim->driver, "usbfs") == 0 && this->Owner != nullptr;
  if (isExcepted)
  {
    return -EBUSY;
  }
  this->Driver.clear();
  return this->Claim(client);
}

int EmulatedUsb::Plug::DriverIoctl(UMockdevIoctlData* argument)
{
  Argument<usbdevfs_ioctl> ioctl(argument);
  if (static_cast<unsigned int>(ioctl->ioctl_code) == USBDEVFS_CONNECT && this->Owner == nullptr)
  {
    // After this call, the kernel lets its drivers probe again. The matching driver is ftdi_sio.
    this->Driver = "ftdi_sio";
    return 1;
  }
  return -ENODATA;
}

int EmulatedUsb::Plug::Submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  UMockdevIoctlData* const data = Resolve(argument, 0, sizeof(usbdevfs_urb));
  const auto size = static_cast<gsize>(UrbOf(data).buffer_length);
  UMockdevIoctlData* const buffer =
    umockdev_ioctl_data_resolve(data, G_STRUCT_OFFSET(usbdevfs_urb, buffer), size, nullptr);
  if (buffer != nullptr)
  {
    g_object_unref(buffer); // the client's request keeps a reference to the buffer
  }
  else if (size > 0)
  {
    g_object_unref(data);
    throw ClientHasEnded();
  }
  const Urb urb{ data, client };
  (this->Try(urb) ? this->Ended : this->Waiting).push_back(urb);
  // The transfer may have produced the answer that a caller waits for.
  this->PumpLocked();
  return 0;
}

int EmulatedUsb::Plug::Reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  const auto urb = std::find_if(this->Ended.begin(), this->Ended.end(),
    [client](const Urb& ended) { return ended.Client == client; });
  if (urb == this->Ended.end())
  {
    return this->Gone ? -ENODEV : -EAGAIN;
  }
  UMockdevIoctlData* const place = Resolve(argument, 0, sizeof(gpointer));
  umockdev_ioctl_data_set_ptr(place, 0, urb->Data);
  g_object_unref(place);
  g_object_unref(urb->Data);
  this->Ended.erase(urb);
  this->PumpLocked();
  return 0;
}

int EmulatedUsb::Plug::Discard(UMockdevIoctlData* argument)
{
  gulong address = 0;
  std::memcpy(&address, argument->data, sizeof(address));
  const auto urb = std::find_if(this->Waiting.begin(), this->Waiting.end(),
    [address](const Urb& waiting) { return waiting.Data->client_addr == address; });
  if (urb == this->Waiting.end())
  {
    return -EINVAL;
  }
  UrbOf(urb->Data).status = -ENOENT;
  UrbOf(urb->Data).actual_length = 0;
  this->Ended.splice(this->Ended.end(), this->Waiting, urb);
  this->PumpLocked();
  return 0;
}

/** Attempts a transfer. Returns false if it has to wait. */
bool EmulatedUsb::Plug::Try(const Urb& waiting)
{
  usbdevfs_urb& urb = UrbOf(waiting.Data);
  auto* const bytes = static_cast<std::uint8_t*>(urb.buffer);
  int result = 0;
  if (this->Gone)
  {
    result = -ESHUTDOWN;
  }
  else if (urb.type == USBDEVFS_URB_TYPE_CONTROL)
  {
    constexpr int setup = 8;
    result = this->Model.Control(bytes, bytes + setup, urb.buffer_length - setup);
  }
  else if ((urb.endpoint & 0x80) != 0)
  {
    result = this->Model.In(urb.endpoint, bytes, urb.buffer_length);
  }
  else
  {
    result = this->Model.Out(urb.endpoint, bytes, urb.buffer_length);
  }
  urb.status = std::min(result, 0);
  urb.actual_length = std::max(result, 0);
  return result != -EAGAIN;
}

void EmulatedUsb::Plug::PumpLocked()
{
  for (auto urb = this->Waiting.begin(); urb != this->Waiting.end();)
  {
    const auto next = std::next(urb);
    if (this->Try(*urb))
    {
      this->Ended.splice(this->Ended.end(), this->Waiting, urb);
    }
    urb = next;
  }
  this->SetReady(!this->Ended.empty() || this->Gone);
}

void EmulatedUsb::Plug::Pump()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->PumpLocked();
}

} // namespace emulated
