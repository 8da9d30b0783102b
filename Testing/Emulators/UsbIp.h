// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The device's side of USB/IP, the protocol with which Linux uses USB devices over a socket. A
 * message consists of 48 bytes of big-endian numbers, followed by data. A transfer waits until the
 * model has data or room for it, or until the kernel unlinks it.
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
  /** Answers on the socket. The socket and the model must outlive this object. */
  UsbIp(UsbModel& model, int socket)
    : Model(model)
    , Socket(socket)
    , Descriptors(model.GetDescriptors())
  {
  }

  /**
   * Reads a message and answers it. Returns false if the other side has closed the connection or
   * sends invalid data.
   */
  bool Receive();
  /**
   * Answers the waiting transfers for which the model now has data or room. Returns false if
   * sending fails.
   */
  bool AnswerWaiting();

private:
  using Bytes = std::vector<std::uint8_t>;
  using Message = std::array<std::uint32_t, 12>; ///< numbers in network byte order
  struct Transfer
  {
    std::uint32_t Number;
    std::uint8_t Endpoint; ///< address of the endpoint, in which bit 7 stands for IN
    Bytes Data;            ///< bytes to send, or a buffer of the requested size
  };

  int Control(const std::uint8_t setup[8], std::uint8_t* data, int size);
  int Describe(std::size_t from, std::size_t size, std::uint8_t* data, int room) const;
  bool Submit(const Message& message);
  bool Unlink(const Message& message);
  /** Attempts a transfer. Returns a size or -errno; -EAGAIN if the model has no data or no room. */
  int Try(Transfer& transfer);
  /** Sends an answer with a size or -errno, and optional data. Returns false if sending fails. */
  bool Answer(std::uint32_t number, int result, const std::uint8_t* data);
  bool Send(const void* bytes, std::size_t size);

  UsbModel& Model;
  const int Socket;
  const Bytes Descriptors;
  std::list<Transfer> Waiting; ///< transfers in order of arrival
  std::uint32_t Newest = 0;    ///< number of the newest transfer
  /**
   * Numbers of transfers that were unlinked before they arrived, because the kernel's sending
   * thread may swap both messages.
   */
  std::set<std::uint32_t> TakenBack;
};
} // namespace emulated

#endif
