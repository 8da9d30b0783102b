// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/WebSocket/WebSocketClient.h"

#include "Core/Realtime/ServoClock.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <random>

namespace VolumeHaptics
{
namespace
{

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

using Moment = std::chrono::steady_clock::time_point;

/** Converts a time of ServoClock to a time of steady_clock, which is the same clock. */
Moment MomentOf(std::int64_t time)
{
  return Moment(std::chrono::duration_cast<Moment::duration>(std::chrono::nanoseconds(time)));
}

Moment After(double seconds)
{
  return MomentOf(
    ServoClock::Now() + static_cast<std::int64_t>(seconds * ServoClock::NanosecondsPerSecond));
}

/**
 * Handles events until holds() returns true. Returns false if this does not happen before `end`.
 */
template <typename Holds>
bool RunUntil(asio::io_context& io, Moment end, Holds&& holds)
{
  io.restart();
  // Process data that have already arrived even if the time is over, but limit their number,
  // because a service may send pings endlessly.
  constexpr int mostEvents = 1000;
  for (int i = 0; i < mostEvents && !holds() && io.poll_one() > 0; ++i)
  {
  }
  while (!holds() && std::chrono::steady_clock::now() < end)
  {
    io.restart();
    io.run_one_until(end);
  }
  return holds();
}

/** Starts an operation and waits until it ends. Cancels it if it is not done before `end`. */
template <typename Start>
error_code Await(asio::io_context& io, beast::tcp_stream& stream, Moment end, Start&& start)
{
  bool isDone = false;
  error_code result;
  start(
    [&](error_code error, auto&&...)
    {
      isDone = true;
      result = error;
    });
  if (!RunUntil(io, end, [&] { return isDone; }))
  {
    stream.close();
    // Wait until the cancelled operation has ended, because it refers to variables of this
    // function.
    while (!isDone)
    {
      io.restart();
      io.run_one();
    }
    return beast::error::timeout;
  }
  return result;
}

/**
 * Connects to the service, which may listen at this computer's IPv4 address, IPv6 address, or both.
 */
error_code Reach(asio::io_context& io, beast::tcp_stream& stream, std::uint16_t port, Moment end)
{
  error_code result;
  for (const asio::ip::address& address : { asio::ip::address(asio::ip::address_v4::loopback()),
         asio::ip::address(asio::ip::address_v6::loopback()) })
  {
    const error_code error = Await(io, stream, end,
      [&](auto&& done)
      { stream.async_connect(asio::ip::tcp::endpoint(address, port), std::move(done)); });
    if (!error)
    {
      error_code ignored;
      stream.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
      return error;
    }
    result = address.is_v4() ? error : result;
    stream.close();
  }
  return result;
}

std::string HostOf(std::uint16_t port)
{
  return "localhost:" + std::to_string(port);
}

/**
 * The stream below Beast. Beast answers pings and closes the connection by itself if the service
 * closes it or breaks the protocol. Therefore this stream writes the last word before the close
 * frame, or before the end of a connection without one. It also drops pongs that follow soon after
 * another pong (RFC 6455, section 5.5.3), so that a flood of pings does not fill the connection.
 */
class LastWordStream
{
public:
  using executor_type = beast::tcp_stream::executor_type;
  using next_layer_type = beast::tcp_stream;

  explicit LastWordStream(asio::io_context& io)
    : Tcp(io)
  {
  }
  executor_type get_executor() noexcept { return this->Tcp.get_executor(); }
  next_layer_type& next_layer() noexcept { return this->Tcp; }
  const next_layer_type& next_layer() const noexcept { return this->Tcp; }

  /** Treats all further bytes as frames. Called after the handshake. */
  void BeginFrames() noexcept { this->HasFrames = true; }
  /** Sets the text (shorter than 64 KiB) that is sent as the last message. */
  void SetLastWord(const std::string& text)
  {
    // Build a masked text frame according to RFC 6455, section 5.2.
    constexpr std::size_t mostShort = 125;
    const auto byte = [](std::size_t value) { return static_cast<char>(value & 0xFF); };
    std::string frame{ byte(0x81) };
    if (text.size() > mostShort)
    {
      frame += { byte(0x80 | 126), byte(text.size() >> 8), byte(text.size()) };
    }
    else
    {
      frame += byte(0x80 | text.size());
    }
    std::random_device random;
    const std::array<char, 4> mask = { byte(random()), byte(random()), byte(random()),
      byte(random()) };
    frame.append(mask.data(), mask.size());
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      frame += static_cast<char>(text[i] ^ mask[i % mask.size()]);
    }
    this->LastWord = std::move(frame);
  }
  /**
   * Writes the last word once, if the socket accepts it at once. Called between two frames, or in a
   * crash handler, when a frame is nearly always complete.
   */
  void WriteLastWord() noexcept
  {
    if (!this->LastWord.empty())
    {
      error_code ignored;
      this->Tcp.socket().non_blocking(true, ignored);
      this->Tcp.socket().send(asio::buffer(this->LastWord), 0, ignored);
      this->LastWord.clear();
    }
  }

  /**
   * Writes the last message, unless a frame is incomplete and the message would become a part of
   * it.
   */
  void EndFrames() noexcept
  {
    if (this->FrameLeft == 0)
    {
      this->WriteLastWord();
    }
  }

  template <typename Buffers, typename Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler)
  {
    return this->Tcp.async_read_some(buffers, std::forward<Handler>(handler));
  }
  template <typename Buffers, typename Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler)
  {
    if (this->HasFrames && this->FrameLeft == 0)
    {
      std::array<unsigned char, 10> head = {};
      asio::buffer_copy(asio::buffer(head), buffers);
      const int kind = head[0] & 0x0F;
      if (kind == Pong && ServoClock::Now() < this->NextPong)
      {
        const std::size_t size = beast::buffer_bytes(buffers);
        return asio::post(this->Tcp.get_executor(),
          [size, done = std::forward<Handler>(handler)]() mutable { done(error_code{}, size); });
      }
      this->NextPong =
        kind == Pong ? ServoClock::Now() + 100 * ServoClock::Millisecond : this->NextPong;
      if (kind == Close)
      {
        this->WriteLastWord();
      }
      this->FrameLeft = SizeOfFrame(head);
    }
    this->Tcp.async_write_some(buffers,
      [this, done = std::forward<Handler>(handler)](error_code error, std::size_t size) mutable
      {
        this->FrameLeft -= std::min<std::uint64_t>(size, this->FrameLeft);
        done(error, size);
      });
  }
  /** Called by Beast when the connection ends. */
  template <typename Handler>
  friend void async_teardown(beast::role_type role, LastWordStream& stream, Handler&& handler)
  {
    stream.EndFrames();
    beast::async_teardown(role, stream.Tcp, std::forward<Handler>(handler));
  }

private:
  static constexpr int Close = 8;
  static constexpr int Pong = 10;

  static std::uint64_t SizeOfFrame(const std::array<unsigned char, 10>& head) noexcept
  {
    constexpr int maskSize = 4;
    const int code = head[1] & 0x7F;
    const int sizeBytes = code == 127 ? 8 : code == 126 ? 2 : 0;
    std::uint64_t size = sizeBytes == 0 ? code : 0;
    for (int i = 0; i < sizeBytes; ++i)
    {
      size = size << 8 | head[2 + i];
    }
    return size + 2 + sizeBytes + maskSize;
  }

  beast::tcp_stream Tcp;
  bool HasFrames = false;
  std::uint64_t FrameLeft = 0; // remaining bytes of the frame that is being written
  std::int64_t NextPong = 0;   // earliest time of the next pong (ServoClock)
  std::string LastWord;        // a complete frame
};

} // namespace

struct WebSocketClient::Connection
{
  asio::io_context Io{ 1 };
  websocket::stream<LastWordStream> Stream{ Io };
  beast::flat_buffer Buffer;
  bool IsReading = false;
  bool HasMessage = false;
  bool IsClosed = false;

  beast::tcp_stream& Tcp() { return beast::get_lowest_layer(this->Stream); }
  void Read()
  {
    this->IsReading = true;
    this->Stream.async_read(this->Buffer,
      [this](error_code error, std::size_t)
      {
        this->IsReading = false;
        this->HasMessage = !error;
        if (error)
        {
          this->IsClosed = true;
          // sends the last word, because the service may have closed only its own direction
          this->Stream.next_layer().EndFrames();
        }
      });
  }
};

WebSocketClient::WebSocketClient() = default;

WebSocketClient::~WebSocketClient()
{
  this->Close();
}

bool WebSocketClient::IsOpen() const noexcept
{
  return this->Link && !this->Link->IsClosed;
}

bool WebSocketClient::Open(
  std::uint16_t port, double seconds, std::string& error, const std::string& target)
{
  this->Close();
  try
  {
    auto link = std::make_unique<Connection>();
    const Moment end = After(seconds);
    error_code failure = Reach(link->Io, link->Tcp(), port, end);
    if (!failure)
    {
      link->Stream.read_message_max(LongestMessage);
      failure = Await(link->Io, link->Tcp(), end,
        [&](auto&& done) { link->Stream.async_handshake(HostOf(port), target, std::move(done)); });
    }
    if (failure)
    {
      error = failure.message();
      return false;
    }
    link->Stream.text(true);
    link->Stream.next_layer().BeginFrames();
    this->Link = std::move(link);
    return true;
  }
  catch (const std::exception& e)
  {
    error = e.what();
    return false;
  }
}

bool WebSocketClient::Send(const std::string& text, double seconds)
{
  if (!this->IsOpen())
  {
    return false;
  }
  Connection& link = *this->Link;
  const error_code error = Await(link.Io, link.Tcp(), After(seconds),
    [&](auto&& done) { link.Stream.async_write(asio::buffer(text), std::move(done)); });
  link.IsClosed = link.IsClosed || error;
  return !link.IsClosed;
}

void WebSocketClient::SetLastWord(const std::string& text)
{
  if (this->IsOpen())
  {
    this->Link->Stream.next_layer().SetLastWord(text);
  }
}

void WebSocketClient::WriteLastWord() noexcept
{
  if (this->IsOpen())
  {
    this->Link->Stream.next_layer().WriteLastWord();
  }
}

WebSocketClient::Outcome WebSocketClient::Receive(std::string& text, std::int64_t until)
{
  if (!this->Link)
  {
    return Outcome::Closed;
  }
  Connection& link = *this->Link;
  if (!link.IsReading && !link.HasMessage && !link.IsClosed)
  {
    link.Read();
  }
  RunUntil(link.Io, MomentOf(until), [&] { return link.HasMessage || link.IsClosed; });
  if (link.HasMessage)
  {
    text = beast::buffers_to_string(link.Buffer.data());
    link.Buffer.clear();
    link.HasMessage = false;
    return Outcome::Message;
  }
  return link.IsClosed ? Outcome::Closed : Outcome::Nothing;
}

void WebSocketClient::Close(double seconds) noexcept
{
  try
  {
    if (this->IsOpen() && seconds > 0.0)
    {
      Connection& link = *this->Link;
      Await(link.Io, link.Tcp(), After(seconds),
        [&](auto&& done)
        { link.Stream.async_close(websocket::close_code::normal, std::move(done)); });
    }
    if (this->Link)
    {
      this->Link->Tcp().close();
    }
  }
  catch (const std::exception&)
  {
    // The connection ends here, even without a closing handshake.
  }
  this->Link.reset();
}

bool FetchText(std::uint16_t port, const std::string& target, double seconds, std::string& text,
  std::string& error)
{
  try
  {
    asio::io_context io{ 1 };
    beast::tcp_stream stream{ io };
    const Moment end = After(seconds);
    http::request<http::empty_body> request{ http::verb::get, target, 11 };
    request.set(http::field::host, HostOf(port));
    beast::flat_buffer buffer{ WebSocketClient::LongestMessage };
    http::response_parser<http::string_body> answer;
    answer.body_limit(WebSocketClient::LongestMessage);
    error_code failure = Reach(io, stream, port, end);
    if (!failure)
    {
      failure = Await(
        io, stream, end, [&](auto&& done) { http::async_write(stream, request, std::move(done)); });
    }
    if (!failure)
    {
      failure = Await(io, stream, end,
        [&](auto&& done) { http::async_read_header(stream, buffer, answer, std::move(done)); });
    }
    // Beast of Boost 1.74 does not check the announced length against the limit, so check it here.
    if (!failure && answer.content_length().value_or(0) > WebSocketClient::LongestMessage)
    {
      failure = http::error::body_limit;
    }
    if (!failure)
    {
      failure = Await(io, stream, end,
        [&](auto&& done) { http::async_read(stream, buffer, answer, std::move(done)); });
    }
    if (!failure && answer.get().result() == http::status::ok)
    {
      text = std::move(answer.get().body());
      return true;
    }
    error = failure ? failure.message() : "HTTP " + std::to_string(answer.get().result_int());
  }
  catch (const std::exception& e)
  {
    error = e.what();
  }
  return false;
}

} // namespace VolumeHaptics
