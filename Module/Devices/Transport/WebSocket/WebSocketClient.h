// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A WebSocket to a service on this computer, and single requests over HTTP, with Boost.Beast.
 *
 * Beast was chosen among the libraries of Debian 12. It is headers only, so that programs and
 * wheels need no library at run time. It has no thread of its own: the device's thread calls it,
 * every call has a time limit, and a message costs one write() and one read(). libwebsockets owns
 * the loop and calls back from it, and its package depends on two event loops and TLS. libcurl 7.88
 * is built without WebSockets there, websocketpp had its last release in 2020, and there is no
 * package of ixwebsocket.
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
  /** Size of the longest message that is accepted (bytes). A longer one closes the connection. */
  static constexpr std::size_t LongestMessage = 1 << 20;

  enum class Outcome
  {
    Message,
    Nothing, ///< no message came in time
    Closed   ///< the service has closed the connection, or an error has
  };

  WebSocketClient();
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /**
   * Connects to a port of this computer within a time (s). `target` is the path and the query.
   * Returns false and writes the reason to `error` if this fails.
   */
  bool Open(
    std::uint16_t port, double seconds, std::string& error, const std::string& target = "/");
  bool IsOpen() const noexcept;
  /** Sends a text within a time (s). Closes the connection and returns false if this fails. */
  bool Send(const std::string& text, double seconds);
  /**
   * Sets a text (shorter than 64 KiB) that is sent before an open connection ends for any reason,
   * if the socket takes it then: the service closes it, breaks the protocol, or Close() is called.
   */
  void SetLastWord(const std::string& text);
  /** Sends this text now, if the socket takes it at once. A handler of a crash may call it. */
  void WriteLastWord() noexcept;
  /**
   * Receives the next message that comes before `until`, a time of ServoClock, or one that has
   * already come.
   */
  Outcome Receive(std::string& text, std::int64_t until);
  /** Closes the connection by the protocol, within a time (s). */
  void Close(double seconds = 0.0) noexcept;

private:
  struct Connection;
  std::unique_ptr<Connection> Link;
};

/**
 * Fetches the answer of a service on this computer to an HTTP GET, within a time (s). Returns false
 * and writes the reason to `error` if there is no answer or if its status is not 200.
 */
bool FetchText(std::uint16_t port, const std::string& target, double seconds, std::string& text,
  std::string& error);

} // namespace VolumeHaptics

#endif
