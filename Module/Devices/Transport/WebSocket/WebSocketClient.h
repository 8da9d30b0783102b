// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A WebSocket to a service on this computer, and single requests by HTTP, with Boost.Beast.
 *
 * Beast was chosen among the libraries of Debian 12. It is headers only, so that programs and
 * wheels need no library at run time. It has no thread: the device's thread calls it, every call
 * has a time limit, and a message costs one write() and one read(). libwebsockets owns the loop and
 * calls back from it; its package brings two event loops and TLS. libcurl 7.88 was built without
 * WebSockets there, websocketpp had its last release in 2020, and ixwebsocket is no package.
 *
 * Not for the servo: it allocates and waits.
 */
#ifndef WebSocketClient_h
#define WebSocketClient_h

#include <cstdint>
#include <memory>
#include <string>

namespace VolumeHaptics
{

class WebSocketClient
{
public:
  /** The longest accepted message (bytes). A longer one closes the connection. */
  static constexpr std::size_t LongestMessage = 1 << 20;

  enum class Outcome
  {
    Message,
    Nothing, ///< no message came before the time
    Closed   ///< the connection was closed by the service, or because of an error
  };

  WebSocketClient();
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /**
   * Connects to a port of this computer, within a time (s). If this fails, returns false and writes
   * the reason to `error`.
   */
  bool Open(std::uint16_t port, double seconds, std::string& error);
  bool IsOpen() const noexcept;
  /** Sends a text within a time (s). If this fails, closes the connection and returns false. */
  bool Send(const std::string& text, double seconds);
  /**
   * Receives the next message that comes before a time of ServoClock, or a message that has come
   * already.
   */
  Outcome Receive(std::string& text, std::int64_t until);
  /** Closes the connection properly, within at most a time (s). */
  void Close(double seconds = 0.0) noexcept;

private:
  struct Connection;
  std::unique_ptr<Connection> Link;
};

/**
 * Fetches the answer of a service on this computer to GET, within a time (s). If there is no answer
 * or its status is not 200, returns false and writes the reason to `error`.
 */
bool FetchText(std::uint16_t port, const std::string& target, double seconds, std::string& text,
  std::string& error);

} // namespace VolumeHaptics

#endif
