// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyService.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <list>
#include <locale>
#include <mutex>
#include <sstream>
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
using Clock = std::chrono::steady_clock;

/// The position in the documentation's example of an inventory: a tip in front of the arm's base.
constexpr Triple BaseToMiddle{ 0.0, -0.12, 0.15 };
constexpr double LongestStep = 5e-3; // s: a machine that stands still does not move the hand
constexpr double ShortStep = 1e-4;   // s

using Members = std::vector<std::pair<std::string, std::string>>;

/// Objects as text, so that the order and the omissions are those of a service.
class Writer
{
public:
  explicit Writer(const HaplyShape& shape)
    : Shape(shape)
  {
  }
  std::string Object(Members members) const
  {
    if (this->Shape.IsReordered)
    {
      std::reverse(members.begin(), members.end());
    }
    std::string text = "{";
    for (const auto& [name, value] : members)
    {
      text += (text.size() > 1 ? ",\"" : "\"") + name + "\":" + value;
    }
    return text + "}";
  }
  std::string Numbers(const std::vector<std::pair<std::string, double>>& numbers,
    const std::vector<double>& defaults) const
  {
    Members members;
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      if (!this->Shape.OmitsDefaults || numbers[i].second != defaults[i])
      {
        std::ostringstream out;
        out.imbue(std::locale::classic());
        out.precision(9);
        out << numbers[i].second;
        members.emplace_back(numbers[i].first, out.str());
      }
    }
    return this->Object(members);
  }
  std::string Vector(const Triple& v, double missing = 0.0) const
  {
    return this->Numbers(
      { { "x", v[0] }, { "y", v[1] }, { "z", v[2] } }, { missing, missing, missing });
  }
  std::string Turn(const std::array<double, 4>& q) const
  {
    return this->Numbers(
      { { "w", q[0] }, { "x", q[1] }, { "y", q[2] }, { "z", q[3] } }, { 1.0, 0.0, 0.0, 0.0 });
  }
  std::string Flags(const std::vector<std::pair<std::string, bool>>& flags) const
  {
    Members members;
    for (const auto& [name, value] : flags)
    {
      if (!this->Shape.OmitsDefaults || value)
      {
        members.emplace_back(name, value ? "true" : "false");
      }
    }
    return this->Object(members);
  }
  /// A list, or a map.
  std::string Family(const std::vector<std::pair<std::string, Members>>& devices) const
  {
    if (this->Shape.HasMaps)
    {
      Members members;
      for (const auto& [id, device] : devices)
      {
        members.emplace_back(id, this->Object(device));
      }
      return this->Object(members);
    }
    std::string text = "[";
    for (auto [id, device] : devices)
    {
      device.insert(device.begin(), { "device_id", "\"" + id + "\"" });
      text += (text.size() > 1 ? "," : "") + this->Object(device);
    }
    return text + "]";
  }

private:
  const HaplyShape Shape;
};
} // namespace

struct HaplyService::Server
{
  using Listener = websocket::stream<tcp::socket&>;

  explicit Server(const HaplyShape& shape)
    : Shape(shape)
    , Write(shape)
  {
  }

  const HaplyShape Shape;
  const Writer Write;
  asio::io_context Io;
  tcp::acceptor States{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor Events{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor Http{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  std::atomic<bool> MustStop{ false };
  std::thread StatesThread;
  std::thread EventsThread;
  std::thread HttpThread;

  std::mutex Mutex; // of all that follows
  std::vector<std::thread> Threads;
  std::vector<int> Sockets; // duplicates of open connections, by which they are ended
  std::list<Listener*> Listeners;
  std::vector<HaplySession> Sessions;
  HaplyFault Fault = HaplyFault::None;
  EmulatedHand Hand;
  Triple Offset{};
  Triple Force{};
  Clock::time_point Stepped = Clock::now();
  std::array<double, 4> Grip{ 1.0, 0.0, 0.0, 0.0 };
  bool IsPressed = false;
  bool IsCalibrated = true;
  bool IsReady = true;
  bool IsPlugged = true;
  Triple Place{};
  double Scale = 1.0;

  bool IsNew() const { return this->Shape.Version >= "3.5"; }
  std::string Prefix() const { return this->Shape.HasMaps ? "/3.0" : this->IsNew() ? "" : "/3.1"; }

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
            // The client is gone, or this service dies.
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

  // All of these under the mutex.
  void Step()
  {
    const Clock::time_point now = Clock::now();
    double time = std::min(std::chrono::duration<double>(now - this->Stepped).count(), LongestStep);
    this->Stepped = now;
    for (; time > 0.0; time -= ShortStep)
    {
      this->Hand.Step(std::min(time, ShortStep), this->Force);
    }
  }
  Members MakeArm(bool hasConfig, const Triple& tip, const Triple& force, bool isInUse) const
  {
    const Writer& write = this->Write;
    Members state{ { "cursor_velocity", write.Vector(this->Hand.Velocity) },
      { "body_orientation", write.Turn({ 1.0, 0.0, 0.0, 0.0 }) },
      { "current_cursor_force", write.Vector(force) }, { "control_mode", "\"idle\"" } };
    if (this->Fault != HaplyFault::Blind)
    {
      state.insert(state.begin(),
        { "cursor_position",
          this->Fault == HaplyFault::NoNumber ? R"({"x":0.0,"y":null,"z":0.0})"
                                              : write.Vector(tip) });
    }
    if (this->IsNew())
    {
      state.emplace_back("transform",
        write.Object({ { "position", write.Vector(this->Place) },
          { "rotation", write.Turn({ 1.0, 0.0, 0.0, 0.0 }) },
          { "scale",
            this->Fault == HaplyFault::NoScale
              ? R"({"x":null})"
              : write.Vector({ this->Scale, this->Scale, this->Scale }, 1.0) } }));
    }
    Members arm;
    if (hasConfig)
    {
      arm.emplace_back("config",
        write.Object({ { "type", "\"" + this->Shape.Type + "\"" }, { "port", "\"COM12\"" },
          { "device_info", "{\"major_version\":7,\"minor_version\":4,\"id\":\"049D\"}" },
          { "handedness", "\"right\"" } }));
    }
    arm.emplace_back("state", write.Object(state));
    // Told in full or not: a missing flag is not a default that the documentation states.
    Members status;
    for (const auto& [name, value] : { std::pair("calibrated", this->IsCalibrated),
           std::pair("in_use", isInUse), std::pair("power_supply", true),
           std::pair("ready", this->IsReady), std::pair("started", true) })
    {
      if (value || !this->Shape.OmitsFalseFlags)
      {
        status.emplace_back(name, value ? "true" : "false");
      }
    }
    if (hasConfig || this->Shape.HasStatus)
    {
      arm.emplace_back("status", write.Object(status));
    }
    return arm;
  }
  bool IsInUse(const std::string& arm) const
  {
    return std::any_of(this->Sessions.begin(), this->Sessions.end(),
      [&arm](const HaplySession& session) { return session.IsOpen && session.Arm == arm; });
  }
  /// `number` is that of the message that it answers.
  std::string MakeMessage(bool hasConfig, bool isCentred, std::size_t number = 0)
  {
    this->Step();
    const Writer& write = this->Write;
    Triple tip = this->Hand.Tip;
    for (int a = 0; a < 3; ++a)
    {
      tip[a] += this->Offset[a] + (isCentred ? 0.0 : BaseToMiddle[a]);
    }
    tip[0] += static_cast<double>(number) * this->Shape.NumberScale;
    std::vector<std::pair<std::string, Members>> arms{ { Other,
      this->MakeArm(hasConfig, { 0.3, 0.3, 0.3 }, {}, this->IsInUse(Other)) } };
    if (this->IsPlugged)
    {
      arms.insert(
        arms.begin(), { Id, this->MakeArm(hasConfig, tip, this->Force, this->IsInUse(Id)) });
    }
    const Members grip{
      { "state",
        write.Object({ { "orientation", write.Turn(this->Grip) }, { "hall", "0" },
          { "buttons",
            write.Flags({ { "a", this->IsPressed }, { "b", false }, { "c", false } }) } }) },
      { "status", "{\"awake\":true}" }
    };
    Members all{ { this->Shape.Family, write.Family(arms) },
      { "wireless_verse_grip", write.Family({ { "61548", grip } }) } };
    if (this->IsNew())
    {
      all.insert(all.begin(), { "session_id", "7" });
    }
    return write.Object(all);
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
      inventory = this->MakeMessage(true, false);
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
    bool isCentred = false;
    for (beast::flat_buffer buffer;; buffer.clear())
    {
      stream.read(buffer);
      const std::string text = beast::buffers_to_string(buffer.data());
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Take(text, session, isCentred);
      std::string state =
        this->MakeMessage(false, isCentred, this->Sessions[session].Forces.size());
      const HaplyFault fault = this->Fault;
      lock.unlock();
      if (fault == HaplyFault::Slow)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
      }
      if (fault != HaplyFault::Silent)
      {
        state = fault == HaplyFault::Junk ? state.substr(0, state.size() / 2) : state;
        stream.write(asio::buffer(state));
      }
      if (fault == HaplyFault::Twice)
      {
        stream.write(asio::buffer(state));
      }
    }
  }
  void Take(const std::string& text, std::size_t number, bool& isCentred)
  {
    HaplySession& session = this->Sessions[number];
    session.Greeting = session.Greeting.empty() ? text : session.Greeting;
    const Json message = Json::parse(text, nullptr, false);
    const std::string arm = "/" + this->Shape.Family + "/0";
    const Json::json_pointer device(arm);
    const Json::json_pointer vector(
      arm + "/commands/set_cursor_force/" + (this->IsNew() ? "vector" : "values"));
    if (message.is_discarded() || !message.contains(vector) ||
      (message[device].value("device_id", "") != Id &&
        message[device].value("device_id", "") != Other))
    {
      ++session.Refused;
      return;
    }
    const Json::json_pointer preset(arm + "/configure/preset");
    isCentred = isCentred ||
      (this->IsNew() && message.contains(preset) && message[preset] == "arm_front_centered");
    this->Step();
    const Json& force = message[vector];
    session.Arm = message[device].value("device_id", "");
    session.Forces.push_back(
      { force.value("x", 0.0), force.value("y", 0.0), force.value("z", 0.0) });
    if (session.Arm == Id)
    {
      this->Force = session.Forces.back();
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
        "\",\"project_version\":\"" + this->Shape.Version + ".0\"}";
    }
    else if (target == this->Prefix() + "/devices" && this->Shape.HasDeviceList)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      body = this->MakeMessage(true, false);
    }
    if (hasHttp && !body.empty())
    {
      answer.result(http::status::ok);
      // The envelope of 3.5; the same without one is in its tutorial 00.
      answer.body() = this->IsNew() ? "{\"ok\":true,\"data\":" + body + "}" : body;
    }
    answer.prepare_payload();
    http::write(socket, answer);
  }
  /// Keeps a listener to the events until it is gone.
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
    stream.read(buffer); // nothing comes: ends when the client does
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
  this->All->Fault = fault;
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
  this->All->Hand.Goal = goal;
}

Triple HaplyService::GetTip()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Hand.Tip;
}

void HaplyService::Shift(const Triple& by)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Offset = by;
}

Triple HaplyService::GetForce()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Force;
}

void HaplyService::SetCalibrated(bool isCalibrated)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->IsCalibrated = isCalibrated;
}

void HaplyService::SetReady(bool isReady)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->IsReady = isReady;
}

void HaplyService::Unplug()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->IsPlugged = false;
}

void HaplyService::SetTransform(const Triple& position, double scale)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Place = position;
  this->All->Scale = scale;
}

void HaplyService::SetGrip(const std::array<double, 4>& orientation, bool isPressed)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Grip = orientation;
  this->All->IsPressed = isPressed;
}

std::vector<HaplySession> HaplyService::GetSessions()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Sessions;
}

} // namespace emulated
