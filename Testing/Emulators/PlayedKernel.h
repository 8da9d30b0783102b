// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Simulates the kernel's side of USB/IP for a test, command by command. */
#ifndef PlayedKernel_h
#define PlayedKernel_h

#include "UsbIp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

namespace machinetest
{
using Bytes = std::vector<std::uint8_t>;

struct Reply
{
  /// 3: answer to a transfer; 4: answer to an unlink request; 0: nothing was received
  std::uint32_t Command = 0;
  std::uint32_t Number = 0;
  int Status = 0;
  Bytes Data;
};

class PlayedKernel
{
public:
  explicit PlayedKernel(emulated::UsbModel& model)
  {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, this->Ends), 0);
    this->Device = std::make_unique<emulated::UsbIp>(model, this->Ends[1]);
  }
  ~PlayedKernel()
  {
    close(this->Ends[0]);
    close(this->Ends[1]);
  }

  ///@{
  /** Sends a transfer. Returns false if sending fails. */
  bool In(std::uint32_t number, std::uint32_t endpoint, std::uint32_t size)
  {
    return this->Send({ 1, number, 0, 1, endpoint, 0, size, 0, 0, 0 }, Bytes(8), {});
  }
  bool Out(std::uint32_t number, std::uint32_t endpoint, const Bytes& data)
  {
    const auto size = static_cast<std::uint32_t>(data.size());
    return this->Send({ 1, number, 0, 0, endpoint, 0, size, 0, 0, 0 }, Bytes(8), data);
  }
  bool Unlink(std::uint32_t number, std::uint32_t victim)
  {
    return this->Send({ 2, number, 0, 0, 0, victim, 0, 0, 0, 0 }, Bytes(8), {});
  }
  bool Raw(const std::vector<std::uint32_t>& numbers) { return this->Send(numbers, Bytes(8), {}); }
  ///@}

  /**
   * Sends a control request. Returns the answer with the data, or with the size of the sent data.
   */
  Reply Request(const Bytes& setup, const Bytes& data = {})
  {
    const std::uint32_t isIn = setup[0] >> 7;
    const auto size = static_cast<std::uint32_t>(isIn ? setup[6] | setup[7] << 8 : data.size());
    EXPECT_TRUE(this->Send({ 1, 99, 0, isIn, 0, 0, size, 0, 0, 0 }, setup, data));
    const Reply reply = this->Receive(isIn != 0);
    EXPECT_EQ(reply.Number, 99u);
    return reply;
  }

  Reply Receive(bool isIn)
  {
    std::uint32_t words[12] = {};
    if (recv(this->Ends[0], words, sizeof(words), MSG_DONTWAIT) != sizeof(words))
    {
      return {};
    }
    Reply reply{ ntohl(words[0]), ntohl(words[1]), static_cast<int>(ntohl(words[5])), {} };
    const std::size_t size = isIn && reply.Command == 3 ? ntohl(words[6]) : 0;
    reply.Data.resize(size);
    EXPECT_TRUE(size == 0 ||
      recv(this->Ends[0], reply.Data.data(), size, MSG_DONTWAIT) == static_cast<ssize_t>(size));
    return reply;
  }

  emulated::UsbIp& GetDevice() { return *this->Device; }
  void HangUp() { shutdown(this->Ends[0], SHUT_RDWR); }

private:
  bool Send(const std::vector<std::uint32_t>& numbers, const Bytes& setup, const Bytes& data)
  {
    std::uint32_t words[12] = {};
    std::transform(numbers.begin(), numbers.end(), words, [](std::uint32_t n) { return htonl(n); });
    std::memcpy(&words[10], setup.data(), 8);
    EXPECT_EQ(send(this->Ends[0], words, sizeof(words), 0), static_cast<ssize_t>(sizeof(words)));
    EXPECT_EQ(send(this->Ends[0], data.data(), data.size(), 0), static_cast<ssize_t>(data.size()));
    return this->Device->Receive();
  }

  int Ends[2] = {};
  std::unique_ptr<emulated::UsbIp> Device;
};
} // namespace machinetest

#endif
