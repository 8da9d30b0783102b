// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Local/LineSocket.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>

#include <array>
#include <chrono>

namespace VolumeHaptics
{
namespace
{

namespace asio = boost::asio;
using boost::system::error_code;

bool IsNothing(const error_code& error)
{
  return error == asio::error::would_block || error == asio::error::try_again ||
    error == asio::error::interrupted;
}

} // namespace

struct LineSocket::Connection
{
  asio::io_context Io{ 1 };
  asio::ip::tcp::socket Socket{ this->Io };
  std::string Unread; // an incomplete message
};

LineSocket::LineSocket(char separator)
  : Separator(separator)
{
}

LineSocket::~LineSocket() = default;

bool LineSocket::Open(std::uint16_t port, double seconds, std::string& error)
{
  this->Close();
  auto link = std::make_unique<Connection>();
  error_code failure = asio::error::timed_out;
  link->Socket.async_connect({ asio::ip::address_v4::loopback(), port },
    [&failure](const error_code& result) { failure = result; });
  link->Io.run_for(
    std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(seconds)));
  error_code ignored;
  if (!failure)
  {
    link->Socket.set_option(asio::ip::tcp::no_delay(true), ignored);
    link->Socket.non_blocking(true, failure);
  }
  if (failure)
  {
    error = failure.message();
    // The pending operation refers to variables of this function, so it must finish here.
    link->Socket.close(ignored);
    link->Io.restart();
    link->Io.run();
    return false;
  }
  this->Link = std::move(link);
  return true;
}

bool LineSocket::Send(const std::string& text)
{
  if (!this->Link)
  {
    return false;
  }
  const std::string message = text + this->Separator;
  error_code failure;
  const std::size_t sent = this->Link->Socket.send(asio::buffer(message), 0, failure);
  if (failure || sent != message.size())
  {
    this->Close();
  }
  return this->IsOpen();
}

void LineSocket::SendRaw(const char* bytes, std::size_t size) noexcept
{
  if (this->Link)
  {
    error_code ignored;
    this->Link->Socket.send(asio::buffer(bytes, size), 0, ignored);
  }
}

bool LineSocket::Receive(std::vector<std::string>& messages)
{
  std::array<char, 4096> part{};
  // Limit the number of reads, because a service may send endlessly.
  for (int i = 0; this->Link && i < 16; ++i)
  {
    error_code failure;
    const std::size_t size = this->Link->Socket.receive(asio::buffer(part), 0, failure);
    if (IsNothing(failure))
    {
      break;
    }
    std::string& unread = this->Link->Unread;
    unread.append(part.data(), failure ? 0 : size);
    for (std::size_t end = unread.find(this->Separator); end != std::string::npos;
         end = unread.find(this->Separator))
    {
      messages.push_back(unread.substr(0, end));
      unread.erase(0, end + 1);
    }
    if (failure || unread.size() > LongestMessage)
    {
      this->Close();
    }
  }
  return this->IsOpen();
}

void LineSocket::Close() noexcept
{
  this->Link.reset();
}

struct PacketSocket::Connection
{
  asio::io_context Io{ 1 };
  asio::ip::udp::socket Socket{ this->Io };
};

PacketSocket::PacketSocket() = default;
PacketSocket::~PacketSocket() = default;

bool PacketSocket::Open(const std::string& address, std::uint16_t port, std::string& error)
{
  this->Close();
  error_code failure;
  const asio::ip::address_v4 to = asio::ip::make_address_v4(address, failure);
  if (failure || to.is_multicast() || to.is_unspecified() ||
    to == asio::ip::address_v4::broadcast())
  {
    error = "\"" + address + "\" is not the address of one device, such as 192.168.1.50";
    return false;
  }
  auto link = std::make_unique<Connection>();
  link->Socket.open(asio::ip::udp::v4(), failure);
  if (!failure)
  {
    // From now on, the system delivers only packets from this address.
    link->Socket.connect({ to, port }, failure);
  }
  if (!failure)
  {
    link->Socket.non_blocking(true, failure);
  }
  if (failure)
  {
    error = failure.message();
    return false;
  }
  this->Link = std::move(link);
  return true;
}

bool PacketSocket::Send(const std::vector<std::uint8_t>& packet) noexcept
{
  error_code failure;
  if (this->Link)
  {
    this->Link->Socket.send(asio::buffer(packet), 0, failure);
  }
  return this->Link && (!failure || IsNothing(failure));
}

bool PacketSocket::Receive(std::vector<std::uint8_t>& packet)
{
  std::array<std::uint8_t, 1500> bytes{};
  error_code failure;
  packet.clear();
  if (this->Link)
  {
    const std::size_t size = this->Link->Socket.receive(asio::buffer(bytes), 0, failure);
    packet.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(failure ? 0 : size));
  }
  return this->Link && (!failure || IsNothing(failure));
}

void PacketSocket::Close() noexcept
{
  this->Link.reset();
}

} // namespace VolumeHaptics
