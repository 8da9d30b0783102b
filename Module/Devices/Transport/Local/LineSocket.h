// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sockets whose calls never wait: messages over TCP to a service on this computer, and packets over
 * UDP to one address. They use Boost.Asio, which Boost.Beast requires anyway.
 *
 * Not for the servo, because they allocate memory.
 */
#ifndef LineSocket_h
#define LineSocket_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Text messages over TCP to a port of this computer, each terminated by a separator. */
class LineSocket
{
public:
  /** Largest size of an accepted message (bytes). A larger message closes the connection. */
  static constexpr std::size_t LongestMessage = 1 << 16;

  explicit LineSocket(char separator);
  ~LineSocket();
  LineSocket(const LineSocket&) = delete;
  LineSocket& operator=(const LineSocket&) = delete;

  /**
   * Connects to a port of this computer within a time (s). On failure, returns false and writes the
   * reason to `error`.
   */
  bool Open(std::uint16_t port, double seconds, std::string& error);
  bool IsOpen() const noexcept { return this->Link != nullptr; }
  /**
   * Sends a message and its separator. If the socket does not accept all of it at once, the service
   * is not reading: closes the connection and returns false.
   */
  bool Send(const std::string& text);
  /**
   * Sends bytes if the socket accepts them at once. Uses only a system call, for a crash handler.
   */
  void SendRaw(const char* bytes, std::size_t size) noexcept;
  /**
   * Appends all messages that have arrived. Returns false if the service has closed the connection,
   * or has sent too long a message.
   */
  bool Receive(std::vector<std::string>& messages);
  void Close() noexcept;

private:
  struct Connection;
  const char Separator;
  std::unique_ptr<Connection> Link;
};

/** Packets over UDP to one address. */
class PacketSocket
{
public:
  PacketSocket();
  ~PacketSocket();
  PacketSocket(const PacketSocket&) = delete;
  PacketSocket& operator=(const PacketSocket&) = delete;

  /**
   * Opens a socket that exchanges packets with only one address, such as "127.0.0.1". On failure,
   * returns false and writes the reason to `error`. Names, multicast and broadcast addresses, and
   * IPv6 are refused.
   */
  bool Open(const std::string& address, std::uint16_t port, std::string& error);
  bool IsOpen() const noexcept { return this->Link != nullptr; }
  /** Sends a packet. Returns false if the system reports that no program has the port open. */
  bool Send(const std::vector<std::uint8_t>& packet) noexcept;
  /**
   * Receives a packet that has arrived; `packet` is empty if there is none. Returns false if the
   * system reports that no program has the port open.
   */
  bool Receive(std::vector<std::uint8_t>& packet);
  void Close() noexcept;

private:
  struct Connection;
  std::unique_ptr<Connection> Link;
};

} // namespace VolumeHaptics

#endif
