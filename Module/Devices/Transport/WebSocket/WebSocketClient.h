// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A WebSocket client for services on this computer, and single HTTP requests, with Boost.Beast.
 *
 * Beast was chosen from the libraries of Debian 12. It consists of headers only, so programs and
 * wheels need no library at run time. It has no thread of its own: the device's thread calls it,
 * every call has a time limit, and a message takes one write() and one read(). libwebsockets runs
 * its own loop with callbacks, and its package depends on two event loops and TLS. Debian's libcurl
 * 7.88 is built without WebSockets, websocketpp had its last release in 2020, and ixwebsocket is
 * not packaged.
 *
 * Not for the servo, because it allocates memory and waits.
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
  /** Largest size of an accepted message (bytes). A larger message closes the connection. */
  static constexpr std::size_t LongestMessage = 1 << 20;

  enum class Outcome
  {
    Message,
    Nothing, ///< no message arrived in time
    Closed   ///< the connection was closed by the service or because of an error
  };

  WebSocketClient();
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /**
   * Connects to a port of this computer within a time (s). `target` is the path and the query. On
   * failure, returns false and writes the reason to `error`.
   */
  bool Open(
    std::uint16_t port, double seconds, std::string& error, const std::string& target = "/");
  bool IsOpen() const noexcept;
  /** Sends a text within a time (s). On failure, closes the connection and returns false. */
  bool Send(const std::string& text, double seconds);
  /**
   * Sets a text (shorter than 64 KiB) that is sent before the connection ends, if the socket still
   * accepts it: when the service closes the connection or breaks the protocol, or when Close() is
   * called.
   */
  void SetLastWord(const std::string& text);
  /** Sends this text now, if the socket accepts it at once. May be called by a crash handler. */
  void WriteLastWord() noexcept;
  /**
   * Receives the next message, if it has already arrived or arrives before `until`, a time of
   * ServoClock.
   */
  Outcome Receive(std::string& text, std::int64_t until);
  /** Closes the connection with the protocol's handshake, within a time (s). */
  void Close(double seconds = 0.0) noexcept;

private:
  struct Connection;
  std::unique_ptr<Connection> Link;
};

/**
 * Sends an HTTP GET to a service on this computer and receives the answer, within a time (s). If
 * there is no answer or its status is not 200, returns false and writes the reason to `error`.
 */
bool FetchText(std::uint16_t port, const std::string& target, double seconds, std::string& text,
  std::string& error);

} // namespace VolumeHaptics

#endif
