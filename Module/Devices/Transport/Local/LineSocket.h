// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sockets whose calls never wait: messages over TCP to a service on this computer, and packets over
 * UDP to one address. With Boost.Asio, which comes with Boost.Beast.
 *
 * Not for the servo: they allocate.
 */
#ifndef LineSocket_h
#define LineSocket_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Text messages over TCP to a port of this computer, each ended by a separator. */
class LineSocket
{
public:
  /** Size of the longest message that is accepted (bytes). A longer one closes the connection. */
  static constexpr std::size_t LongestMessage = 1 << 16;

  explicit LineSocket(char separator);
  ~LineSocket();
  LineSocket(const LineSocket&) = delete;
  LineSocket& operator=(const LineSocket&) = delete;

  /**
   * Connects to a port of this computer within a time (s). Returns false and writes the reason to
   * `error` if this fails.
   */
  bool Open(std::uint16_t port, double seconds, std::string& error);
  bool IsOpen() const noexcept { return this->Link != nullptr; }
  /**
   * Sends a message and its separator. Closes the connection and returns false if the socket does
   * not take all of it at once, because the service then does not read.
   */
  bool Send(const std::string& text);
  /**
   * Sends bytes if the socket takes them at once. Only a system call, for the handler of a crash.
   */
  void SendRaw(const char* bytes, std::size_t size) noexcept;
  /**
   * Appends the messages that have come. Returns false if the service has closed the connection, or
   * has sent a message that is too long.
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
   * Opens a socket that sends to and hears from one address only, such as "127.0.0.1". Returns
   * false and writes the reason to `error` if this fails, as it does for names, for addresses of
   * many computers, and for IPv6.
   */
  bool Open(const std::string& address, std::uint16_t port, std::string& error);
  bool IsOpen() const noexcept { return this->Link != nullptr; }
  /** Sends a packet. Returns false if nobody is there, as far as the system knows. */
  bool Send(const std::vector<std::uint8_t>& packet) noexcept;
  /**
   * Receives a packet that has come; an empty one if none has. Returns false if nobody is there, as
   * far as the system knows.
   */
  bool Receive(std::vector<std::uint8_t>& packet);
  void Close() noexcept;

private:
  struct Connection;
  std::unique_ptr<Connection> Link;
};

} // namespace VolumeHaptics

#endif
