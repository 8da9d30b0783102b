// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "UsbIp.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <sys/socket.h>

namespace emulated
{
namespace
{
constexpr std::uint32_t CommandSubmit = 1;
constexpr std::uint32_t CommandUnlink = 2;
constexpr std::uint32_t AnswerSubmit = 3;
constexpr std::uint32_t AnswerUnlink = 4;
constexpr std::uint32_t LargestTransfer = 1u << 16;

bool ReceiveAll(int socket, void* bytes, std::size_t size)
{
  auto* place = static_cast<std::uint8_t*>(bytes);
  while (size > 0)
  {
    const ssize_t part = recv(socket, place, size, MSG_WAITALL);
    if (part == 0 || (part < 0 && errno != EINTR))
    {
      return false;
    }
    place += std::max<ssize_t>(part, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(part, 0));
  }
  return true;
}
} // namespace

bool UsbIp::Send(const void* bytes, std::size_t size)
{
  return send(this->Socket, bytes, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
}

bool UsbIp::Answer(std::uint32_t number, int result, const std::uint8_t* data)
{
  const std::size_t size = data && result > 0 ? static_cast<std::size_t>(result) : 0;
  std::vector<std::uint8_t> bytes(sizeof(Message) + size);
  Message answer{};
  answer[0] = htonl(AnswerSubmit);
  answer[1] = htonl(number);
  answer[5] = htonl(static_cast<std::uint32_t>(std::min(result, 0)));
  answer[6] = htonl(static_cast<std::uint32_t>(std::max(result, 0)));
  std::memcpy(bytes.data(), answer.data(), sizeof(answer));
  if (size > 0)
  {
    std::memcpy(bytes.data() + sizeof(answer), data, size);
  }
  return this->Send(bytes.data(), bytes.size());
}

bool UsbIp::Receive()
{
  Message message;
  if (!ReceiveAll(this->Socket, message.data(), sizeof(message)))
  {
    return false;
  }
  const std::uint32_t command = ntohl(message[0]);
  const bool understood = command == CommandSubmit
    ? this->Submit(message)
    : command == CommandUnlink && this->Unlink(message);
  return understood && this->AnswerWaiting();
}

bool UsbIp::Submit(const Message& message)
{
  const std::uint32_t number = ntohl(message[1]);
  const bool isIn = ntohl(message[3]) != 0;
  const auto endpoint = static_cast<std::uint8_t>(ntohl(message[4]));
  const std::uint32_t size = ntohl(message[6]);
  if (size > LargestTransfer)
  {
    return false;
  }
  Bytes data(size, 0);
  if (!isIn && size > 0 && !ReceiveAll(this->Socket, data.data(), size))
  {
    return false;
  }
  this->Newest = number;
  if (this->TakenBack.erase(number) > 0)
  {
    return true;
  }
  if (endpoint != 0)
  {
    const auto address = static_cast<std::uint8_t>(endpoint | (isIn ? 0x80 : 0));
    this->Waiting.push_back({ number, address, std::move(data) });
    return true;
  }
  std::uint8_t setup[8];
  std::memcpy(setup, &message[10], sizeof(setup));
  const int room = static_cast<int>(size);
  const int result = this->Control(setup, data.data(), room);
  // A transfer to the device either stalls or is sent completely.
  return this->Answer(number, result < 0 || isIn ? result : room, isIn ? data.data() : nullptr);
}

int UsbIp::Try(Transfer& transfer)
{
  const int size = static_cast<int>(transfer.Data.size());
  return (transfer.Endpoint & 0x80) != 0
    ? this->Model.In(transfer.Endpoint, transfer.Data.data(), size)
    : this->Model.Out(transfer.Endpoint, transfer.Data.data(), size);
}

bool UsbIp::Unlink(const Message& message)
{
  const std::uint32_t victim = ntohl(message[5]);
  const auto found = std::find_if(this->Waiting.begin(), this->Waiting.end(),
    [victim](const Transfer& transfer) { return transfer.Number == victim; });
  // Compare by the difference, because the increasing numbers wrap around.
  const bool isYetToCome = static_cast<std::int32_t>(victim - this->Newest) > 0;
  Message answer{};
  answer[0] = htonl(AnswerUnlink);
  answer[1] = message[1];
  if (isYetToCome)
  {
    this->TakenBack.insert(victim);
  }
  const bool waits = found != this->Waiting.end();
  if (waits)
  {
    this->Waiting.erase(found);
  }
  if (waits || isYetToCome)
  {
    answer[5] = htonl(static_cast<std::uint32_t>(-ECONNRESET));
  }
  return this->Send(answer.data(), sizeof(answer));
}

bool UsbIp::AnswerWaiting()
{
  // Serve OUT transfers first, because the model may answer them with IN data.
  for (const int direction : { 0, 0x80 })
  {
    for (auto transfer = this->Waiting.begin(); transfer != this->Waiting.end();)
    {
      const bool isIn = (transfer->Endpoint & 0x80) != 0;
      const int result = (transfer->Endpoint & 0x80) == direction ? this->Try(*transfer) : -EAGAIN;
      if (result == -EAGAIN)
      {
        ++transfer;
        continue;
      }
      const Transfer ended = std::move(*transfer);
      transfer = this->Waiting.erase(transfer);
      if (!this->Answer(ended.Number, result, isIn ? ended.Data.data() : nullptr))
      {
        return false;
      }
    }
  }
  return true;
}

int UsbIp::Describe(std::size_t from, std::size_t size, std::uint8_t* data, int room) const
{
  const std::size_t given = std::min(size, static_cast<std::size_t>(room));
  std::copy_n(this->Descriptors.begin() + static_cast<std::ptrdiff_t>(from), given, data);
  return static_cast<int>(given);
}

/**
 * Handles the requests that are the same for all devices, and passes other requests to the model.
 */
int UsbIp::Control(const std::uint8_t setup[8], std::uint8_t* data, int size)
{
  constexpr std::uint8_t GetStatus = 0, ClearFeature = 1, GetDescriptor = 6, SetConfiguration = 9,
                         SetInterface = 11;
  const std::uint8_t type = setup[0];
  const std::uint8_t request = setup[1];
  const std::size_t deviceSize = this->Descriptors[0];
  if (type == 0x80 && request == GetDescriptor && setup[3] == 1)
  {
    return this->Describe(0, deviceSize, data, size);
  }
  if (type == 0x80 && request == GetDescriptor && setup[3] == 2)
  {
    return this->Describe(deviceSize, this->Descriptors.size() - deviceSize, data, size);
  }
  if ((type == 0x00 && request == SetConfiguration) || (type == 0x01 && request == SetInterface) ||
    (type == 0x02 && request == ClearFeature))
  {
    return 0;
  }
  if (type >= 0x80 && type <= 0x82 && request == GetStatus)
  {
    return std::min(size, 2); // two zeros: neither self-powered nor halted
  }
  return this->Model.Control(setup, data, size);
}
} // namespace emulated
