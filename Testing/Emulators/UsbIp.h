// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The device's side of USB/IP, in which Linux speaks to USB devices over a socket.
 *
 * Messages are 48 bytes of numbers, big-endian, and data. A transfer that the model has nothing
 * for, or no room, waits until it has, or until the kernel takes it back.
 */
#ifndef UsbIp_h
#define UsbIp_h

#include "DeviceModels.h"

#include <array>
#include <list>
#include <set>

namespace emulated
{
class UsbIp
{
public:
  /** Answers on the socket; both have to outlive this. */
  UsbIp(UsbModel& model, int socket)
    : Model(model)
    , Socket(socket)
    , Descriptors(model.GetDescriptors())
  {
  }

  /** Takes one message and answers it; false once the other side has hung up or makes no sense. */
  bool Receive();
  /** Answers those waiting transfers that the model has something for by now. */
  bool AnswerWaiting();

private:
  using Bytes = std::vector<std::uint8_t>;
  using Message = std::array<std::uint32_t, 12>; ///< in the network's order
  struct Transfer
  {
    std::uint32_t Number;
    std::uint8_t Endpoint; ///< its address
    Bytes Data;            ///< with the size of what is asked for, or what goes out
  };

  int Control(const std::uint8_t setup[8], std::uint8_t* data, int size);
  int Describe(std::size_t from, std::size_t size, std::uint8_t* data, int room) const;
  bool Submit(const Message& message);
  bool Unlink(const Message& message);
  /** A result is a size or -errno; -EAGAIN if the model has nothing for it, or no room. */
  int Try(Transfer& transfer);
  /** A result is a size or -errno; data follow if there are any. */
  bool Answer(std::uint32_t number, int result, const std::uint8_t* data);
  bool Send(const void* bytes, std::size_t size);

  UsbModel& Model;
  const int Socket;
  const Bytes Descriptors;
  std::list<Transfer> Waiting; ///< in the order in which they came
  std::uint32_t Newest = 0;    ///< number of a transfer
  /** Taken back before they came: the kernel's thread that sends may mix up the two. */
  std::set<std::uint32_t> TakenBack;
};
} // namespace emulated

#endif
