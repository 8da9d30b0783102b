// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyService.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <future>
#include <list>
#include <mutex>
#include <thread>

#include <sys/socket.h>
#include <unistd.h>

namespace emulated
{
namespace
{
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;
using Json = nlohmann::json;
} // namespace

struct HaplyService::Server
{
  using Listener = websocket::stream<tcp::socket&>;

  explicit Server(const HaplyShape& shape)
    : Shape(shape)
    , Arms(shape)
  {
  }

  const HaplyShape Shape;
  asio::io_context Io;
  tcp::acceptor States{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor Events{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor Http{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  std::atomic<bool> MustStop{ false };
  std::thread StatesThread;
  std::thread EventsThread;
  std::thread HttpThread;

  std::mutex Mutex; // guards all following members
  std::vector<std::thread> Threads;
  // duplicates of open connections, through which the destructor ends them
  std::vector<int> Sockets;
  std::list<Listener*> Listeners;
  std::vector<HaplySession> Sessions;
  HaplyState Arms;

  std::string Prefix() const
  {
    return this->Shape.HasMaps ? "/3.0" : this->Arms.IsNew() ? "" : "/3.1";
  }

  void Listen()
  {
    this->StatesThread = std::thread(
      [this]
      {
        this->Accept(
          this->States, [this](tcp::socket& s) { this->Answer(s, !this->Shape.HasOwnHttp); });
      });
    this->HttpThread = std::thread(
      [this] { this->Accept(this->Http, [this](tcp::socket& s) { this->Answer(s, true); }); });
    this->EventsThread = std::thread(
      [this] { this->Accept(this->Events, [this](tcp::socket& s) { this->Hold(s); }); });
  }
  template <typename Serve>
  void Accept(tcp::acceptor& acceptor, Serve serve)
  {
    while (!this->MustStop)
    {
      boost::system::error_code error;
      auto socket = std::make_shared<tcp::socket>(acceptor.accept(error));
      if (error || this->MustStop)
      {
        return;
      }
      socket->set_option(tcp::no_delay(true), error);
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Threads.emplace_back(
        [this, socket, serve]
        {
          tcp::socket mine = std::move(*socket);
          const int number = ::dup(mine.native_handle());
          {
            const std::lock_guard<std::mutex> other(this->Mutex);
            this->Sockets.push_back(number);
          }
          try
          {
            serve(mine);
          }
          catch (const std::exception&)
          {
            // Either the client or this service has ended the connection.
          }
          const std::lock_guard<std::mutex> other(this->Mutex);
          this->Sockets.erase(std::find(this->Sockets.begin(), this->Sockets.end(), number));
          ::close(number);
        });
    }
  }
  void Stop()
  {
    if (this->MustStop.exchange(true))
    {
      return;
    }
    for (tcp::acceptor* const acceptor : { &this->States, &this->Events, &this->Http })
    {
      ::shutdown(acceptor->native_handle(), SHUT_RDWR); // ends accept()
    }
    this->StatesThread.join();
    this->EventsThread.join();
    this->HttpThread.join();
    std::vector<std::thread> threads;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      for (const int socket : this->Sockets)
      {
        ::shutdown(socket, SHUT_RDWR);
      }
      threads.swap(this->Threads);
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    boost::system::error_code ignored;
    this->States.close(ignored);
    this->Events.close(ignored);
    this->Http.close(ignored);
  }

  bool IsInUse(const std::string& arm) const
  {
    return std::any_of(this->Sessions.begin(), this->Sessions.end(),
      [&arm](const HaplySession& session) { return session.IsOpen && session.Arm == arm; });
  }
  /// Returns the initial view of a session, before any configuration.
  HaplyView MakeView() const
  {
    HaplyView view;
    view.Preset = this->Shape.Preset;
    view.Basis = this->Shape.Basis;
    return view;
  }
  std::string MakeMessage(bool hasConfig, const HaplyView& view, std::size_t number = 0)
  {
    return this->Arms.MakeMessage(
      hasConfig, view, [this](const std::string& arm) { return this->IsInUse(arm); }, number);
  }

  void Answer(tcp::socket& socket, bool hasHttp)
  {
    beast::flat_buffer buffer;
    http::request<http::string_body> request;
    http::read(socket, buffer, request);
    if (!websocket::is_upgrade(request))
    {
      this->AnswerHttp(socket, request, hasHttp);
      return;
    }
    websocket::stream<tcp::socket&> stream(socket);
    stream.accept(request);
    stream.text(true);
    std::size_t session = 0;
    std::string inventory;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      session = this->Sessions.size();
      this->Sessions.emplace_back();
      inventory = this->MakeMessage(true, this->MakeView());
    }
    try
    {
      stream.write(asio::buffer(inventory));
      this->Converse(stream, session);
    }
    catch (const std::exception&)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(this->Shape.DropTime));
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Sessions[session].IsOpen = false;
    }
  }
  void Converse(websocket::stream<tcp::socket&>& stream, std::size_t session)
  {
    HaplyView view = this->MakeView();
    std::future<void> flood; // its destructor waits until the thread has ended
    for (beast::flat_buffer buffer;; buffer.clear())
    {
      stream.read(buffer);
      const std::string text = beast::buffers_to_string(buffer.data());
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Receive(text, session, view);
      std::string state =
        this->MakeMessage(view.IsWhole, view, this->Sessions[session].Forces.size());
      const HaplyFault fault = this->Arms.Fault;
      lock.unlock();
      if (fault == HaplyFault::Slow || fault == HaplyFault::SlowBlind)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
      }
      if (fault >= HaplyFault::Wrong)
      {
        if (!flood.valid())
        {
          flood = this->Misbehave(stream.next_layer().native_handle(), fault);
        }
      }
      else if (fault != HaplyFault::Silent)
      {
        state = fault == HaplyFault::Junk ? state.substr(0, state.size() / 2)
          : fault == HaplyFault::Deep
          ? state.substr(0, state.size() - 1) + ",\"notes\":" + HaplyState::DeepJson() + "}"
          : state;
        stream.write(asio::buffer(state));
      }
      if (fault == HaplyFault::Twice)
      {
        stream.write(asio::buffer(state));
      }
    }
  }
  /// Sends pings of two bytes each until the fault ends or the connection does.
  void Flood(int number, HaplyFault fault)
  {
    std::string pings;
    for (int i = 0; i < 2048; ++i)
    {
      pings.append("\x89\0", 2);
    }
    std::size_t at = 0;
    for (bool goesOn = true; goesOn && !this->MustStop;)
    {
      const ssize_t sent =
        ::send(number, pings.data() + at, pings.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
      at = (at + static_cast<std::size_t>(std::max<ssize_t>(sent, 0))) % pings.size();
      if (sent < 0)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      const std::lock_guard<std::mutex> lock(this->Mutex);
      goesOn = this->Arms.Fault == fault && (sent >= 0 || errno == EAGAIN);
    }
  }
  /// Sends an answer that no service should send. Frames follow RFC 6455, section 5.2.
  std::future<void> Misbehave(int number, HaplyFault fault)
  {
    const auto send = [number](const char* bytes, std::size_t size)
    { ::send(number, bytes, size, MSG_NOSIGNAL); };
    const sockaddr nobody = { AF_UNSPEC, {} };
    switch (fault)
    {
      case HaplyFault::Wrong:
        send("\xF1\0", 2); // reserved bits
        break;
      case HaplyFault::TooLong:
        send("\x81\x7F\0\0\0\1\0\0\0\0", 10);
        break;
      case HaplyFault::Leaves:
        send("\x88\0", 2);
        break;
      case HaplyFault::HalfEnds:
        ::shutdown(number, SHUT_WR);
        break;
      case HaplyFault::Resets:
        ::connect(number, &nobody, sizeof(nobody)); // Linux then resets the connection
        break;
      case HaplyFault::Pings:
        return std::async(std::launch::async, [=] { this->Flood(number, fault); });
      default:
        this->Flood(number, fault);
        break;
    }
    return {};
  }
  void Receive(const std::string& text, std::size_t number, HaplyView& view)
  {
    HaplySession& session = this->Sessions[number];
    session.Greeting = session.Greeting.empty() ? text : session.Greeting;
    const Json message = Json::parse(text, nullptr, false);
    const std::string arm = "/" + this->Shape.Family + "/0";
    const Json::json_pointer device(arm);
    const Json::json_pointer vector(
      arm + "/commands/set_cursor_force/" + (this->Arms.IsNew() ? "vector" : "values"));
    if (message.is_discarded() || !message.contains(vector) ||
      (message[device].value("device_id", "") != Id &&
        message[device].value("device_id", "") != Other))
    {
      ++session.Refused;
      return;
    }
    // In newer versions, the preset must be an object, even for a single name. A bare string is an
    // error.
    const Json::json_pointer preset(arm + "/configure/preset/preset");
    const Json::json_pointer basis("/session/configure/basis/permutation");
    if (this->Arms.IsNew() && this->Shape.TakesPresets && message.contains(preset) &&
      message[preset].is_string())
    {
      view.Preset = message[preset].get<std::string>();
    }
    view.IsWhole = this->Arms.IsNew() && this->Shape.TellsConfig &&
      message.contains(Json::json_pointer("/session/force_render_full_state"));
    if (this->Arms.IsNew() && message.contains(basis))
    {
      view.Basis = message[basis].get<std::string>();
    }
    this->Arms.Step();
    const Json& force = message[vector];
    session.Arm = message[device].value("device_id", "");
    session.Forces.push_back(
      view.FromSession({ force.value("x", 0.0), force.value("y", 0.0), force.value("z", 0.0) }));
    if (session.Arm == Id)
    {
      this->Arms.Force = session.Forces.back();
    }
  }
  void AnswerHttp(
    tcp::socket& socket, const http::request<http::string_body>& request, bool hasHttp)
  {
    http::response<http::string_body> answer{ http::status::not_found, request.version() };
    const std::string target(request.target());
    std::string body;
    if (target == this->Prefix() + "/version")
    {
      body = "{\"project_name\":\"haply-inverse-service\",\"git_tag\":\"" + this->Shape.Version +
        "\",\"project_version\":\"" + this->Shape.Version + ".0\"" +
        (this->Shape.VersionNotes.empty() ? "" : ",\"notes\":" + this->Shape.VersionNotes) + "}";
    }
    else if (target == this->Prefix() + "/devices" && this->Shape.HasDeviceList)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      body = this->MakeMessage(true, this->MakeView());
    }
    if (hasHttp && !body.empty())
    {
      answer.result(http::status::ok);
      // Version 3.5 wraps the content in an envelope. Tutorial 00 shows the same content without
      // one.
      answer.body() = this->Arms.IsNew() ? "{\"ok\":true,\"data\":" + body + "}" : body;
    }
    answer.prepare_payload();
    http::write(socket, answer);
  }
  /// Serves a client of the event channel until it disconnects.
  void Hold(tcp::socket& socket)
  {
    websocket::stream<tcp::socket&> stream(socket);
    struct AtEnd
    {
      Server* All;
      Listener* Stream;
      ~AtEnd()
      {
        const std::lock_guard<std::mutex> lock(this->All->Mutex);
        this->All->Listeners.remove(this->Stream);
      }
    };
    const AtEnd atEnd{ this, &stream };
    stream.accept();
    stream.text(true);
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Listeners.push_back(&stream);
    }
    beast::flat_buffer buffer;
    stream.read(buffer); // returns when the client disconnects, because it sends nothing
  }
};

HaplyService::HaplyService(const HaplyShape& shape)
  : All(std::make_unique<Server>(shape))
{
  const unsigned short events = this->All->Events.local_endpoint().port();
  std::string ports = std::to_string(this->All->States.local_endpoint().port()) + "," +
    std::to_string(events) + "," + std::to_string(this->All->Http.local_endpoint().port());
  if (!shape.HasEvents)
  {
    this->All->Events.close();
  }
  setenv("VOLUMEHAPTICS_HAPLY", ports.c_str(), 1);
  this->All->Listen();
}

HaplyService::~HaplyService()
{
  this->Die();
}

void HaplyService::Die()
{
  this->All->Stop();
}

void HaplyService::Break(HaplyFault fault)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.Fault = fault;
}

void HaplyService::PushEvent(const std::string& json)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  for (Server::Listener* const listener : this->All->Listeners)
  {
    boost::system::error_code ignored;
    listener->write(asio::buffer(json), ignored);
  }
}

std::size_t HaplyService::CountListeners()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Listeners.size();
}

void HaplyService::DropListeners()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  for (Server::Listener* const listener : this->All->Listeners)
  {
    ::shutdown(listener->next_layer().native_handle(), SHUT_RDWR);
  }
}

void HaplyService::SetGoal(const Triple& goal)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.Hand.Goal = goal;
}

Triple HaplyService::GetTip()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Arms.Hand.Tip;
}

void HaplyService::Shift(const Triple& by)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.Offset = by;
}

Triple HaplyService::GetForce()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Arms.Force;
}

void HaplyService::SetCalibrated(bool isCalibrated)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.IsCalibrated = isCalibrated;
}

void HaplyService::SetReady(bool isReady)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.IsReady = isReady;
}

void HaplyService::Unplug()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.IsPlugged = false;
}

void HaplyService::PlugIn()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.IsPlugged = true;
}

void HaplyService::SetTransform(const Triple& position, double scale)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.Place = position;
  this->All->Arms.Scale = scale;
}

void HaplyService::SetGrip(const std::array<double, 4>& orientation, bool isPressed)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Arms.Grip = orientation;
  this->All->Arms.IsPressed = isPressed;
}

std::vector<HaplySession> HaplyService::GetSessions()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Sessions;
}

} // namespace emulated
