// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VibrationServices.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include <poll.h>
#include <sys/socket.h>

namespace emulated
{
namespace
{
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;
using udp = asio::ip::udp;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;
using boost::system::error_code;

/// A server with its own thread that accepts one client after another.
class OneClientServer
{
public:
  template <typename Serve>
  void Listen(const char* variable, Serve serve)
  {
    setenv(variable, std::to_string(this->Acceptor.local_endpoint().port()).c_str(), 1);
    this->Thread = std::thread(
      [this, serve]
      {
        while (!this->MustStop)
        {
          error_code error;
          tcp::socket socket = this->Acceptor.accept(error);
          if (error || this->MustStop)
          {
            return;
          }
          socket.set_option(tcp::no_delay(true), error);
          this->Client = socket.native_handle();
          try
          {
            serve(socket);
          }
          catch (const std::exception&)
          {
            // Either the client or this service has ended the connection.
          }
          this->Client = -1;
        }
      });
  }
  void HangUp()
  {
    if (this->Client >= 0)
    {
      ::shutdown(this->Client, SHUT_RDWR);
    }
  }
  void Stop()
  {
    if (!this->MustStop.exchange(true))
    {
      ::shutdown(this->Acceptor.native_handle(), SHUT_RDWR); // ends accept()
      this->HangUp();
      this->Thread.join();
      error_code ignored;
      this->Acceptor.close(ignored);
    }
  }
  std::atomic<bool> MustStop{ false };

private:
  asio::io_context Io;
  tcp::acceptor Acceptor{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  std::atomic<int> Client{ -1 };
  std::thread Thread;
};

bool IsOneOf(const std::string& text, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), text) != names.end();
}
} // namespace

struct PlayedBhaptics::Server
{
  struct Frame
  {
    std::string Place;
    std::map<int, int> Dots;
    Clock::time_point End;
  };

  OneClientServer Port;
  std::mutex Mutex; // guards all following members
  Vibrations Told;
  std::vector<std::string> Places;
  std::map<std::string, Frame> Frames; // frames by their key
  bool SendsJunk = false;
  std::atomic<bool> Floods{ false };
  bool HasNews = false;

  std::string MakeStatus()
  {
    Json active = Json::array();
    Json status = Json::object();
    for (const std::string& place : this->Places)
    {
      status[place] = Json::array({ 0, 0, 0, 0, 0, 0 });
    }
    for (const auto& [key, frame] : this->Frames)
    {
      if (frame.End > Clock::now())
      {
        active.push_back(key);
      }
    }
    return Json{
      { "RegisteredKeys", Json::array() }, { "ActiveKeys", active },
      { "ConnectedDeviceCount", this->Places.size() }, { "ConnectedPositions", this->Places },
      { "Status", status }
    }.dump();
  }
  bool Submit(const Json& request)
  {
    const std::string type = request.value("Type", "");
    const std::string key = request.value("Key", "");
    if (type == "turnOff" || type == "turnOffAll")
    {
      this->Frames.erase(key);
      this->Frames = type == "turnOffAll" ? std::map<std::string, Frame>() : this->Frames;
      this->Told.Levels.push_back(0);
      this->Told.EndsStopped = true;
      return type == "turnOffAll" || !key.empty();
    }
    const Json frame = request.value("Frame", Json());
    if (type != "frame" || key.empty() || !frame.is_object() ||
      !IsOneOf(frame.value("Position", ""),
        { "VestFront", "VestBack", "Head", "HandL", "HandR", "FootL", "FootR", "ForearmL",
          "ForearmR", "GloveL", "GloveR" }))
    {
      return false;
    }
    Frame added;
    added.Place = frame.value("Position", "");
    const int duration = frame.value("DurationMillis", 0);
    int largest = 0;
    for (const Json& dot : frame.value("DotPoints", Json::array()))
    {
      const int index = dot.value("Index", -1);
      const int intensity = dot.value("Intensity", -1);
      if (index < 0 || index > 19 || intensity < 0 || intensity > 100)
      {
        return false;
      }
      added.Dots[index] = intensity;
      largest = std::max(largest, intensity);
    }
    added.End = Clock::now() + std::chrono::milliseconds(duration);
    this->Frames[key] = added;
    this->Told.Levels.push_back(largest);
    this->Told.EndsStopped = false;
    return duration > 0;
  }
  void Receive(const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Told.Messages.push_back(text);
    const Json all = Json::parse(text, nullptr, false);
    const bool isKnown = all.is_object() && all.contains("Submit") && all["Submit"].is_array();
    bool isTaken = isKnown;
    for (const Json& request : isKnown ? all["Submit"] : Json::array())
    {
      isTaken = this->Submit(request) && isTaken;
    }
    this->Told.Refused += isTaken ? 0 : 1;
    this->HasNews = true;
  }
  void Serve(tcp::socket& socket)
  {
    beast::flat_buffer buffer;
    beast::http::request<beast::http::string_body> request;
    beast::http::read(socket, buffer, request);
    const std::string target(request.target());
    if (target.compare(0, 14, "/v2/feedbacks?") != 0 || target.find("app_id=") == std::string::npos)
    {
      return;
    }
    websocket::stream<tcp::socket&> stream(socket);
    stream.accept(request);
    stream.text(true);
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Told.IsOpen = true;
    }
    try
    {
      this->Converse(stream);
    }
    catch (const std::exception&)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Told.IsOpen = false;
      throw;
    }
  }
  void Converse(websocket::stream<tcp::socket&>& stream)
  {
    for (beast::flat_buffer buffer;; buffer.clear())
    {
      if (this->Floods)
      {
        std::string frames; // many complete text frames with two letters each
        for (int i = 0; i < 10000; ++i)
        {
          frames += "\x81\x02{}";
        }
        asio::write(stream.next_layer(), asio::buffer(frames));
        continue;
      }
      // Read the next message. If none arrives within 5 ms, do other work.
      pollfd waited{ stream.next_layer().native_handle(), POLLIN, 0 };
      if (::poll(&waited, 1, 5) > 0)
      {
        stream.read(buffer);
        this->Receive(beast::buffers_to_string(buffer.data()));
      }
      std::string answer;
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        answer = this->SendsJunk ? "{\"ConnectedPositions\":7"
          : this->HasNews        ? this->MakeStatus()
                                 : "";
        this->HasNews = this->SendsJunk = false;
      }
      if (!answer.empty())
      {
        stream.write(asio::buffer(answer));
      }
    }
  }
};

PlayedBhaptics::PlayedBhaptics(std::vector<std::string> places)
  : All(std::make_unique<Server>())
{
  this->All->Places = std::move(places);
  this->All->Port.Listen(
    "VOLUMEHAPTICS_BHAPTICS", [all = this->All.get()](tcp::socket& socket) { all->Serve(socket); });
}

PlayedBhaptics::~PlayedBhaptics()
{
  this->Die();
  unsetenv("VOLUMEHAPTICS_BHAPTICS");
}

void PlayedBhaptics::Die()
{
  this->All->Port.Stop();
}

Vibrations PlayedBhaptics::Get()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Told;
}

int PlayedBhaptics::GetDot(const std::string& place, int index)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  int intensity = 0;
  for (const auto& [key, frame] : this->All->Frames)
  {
    const auto dot = frame.Dots.find(index);
    if (frame.Place == place && frame.End > Clock::now() && dot != frame.Dots.end())
    {
      intensity = std::max(intensity, dot->second);
    }
  }
  return intensity;
}

void PlayedBhaptics::SetPlaces(const std::vector<std::string>& places)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Places = places;
  this->All->HasNews = true;
}

void PlayedBhaptics::SendJunk()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->SendsJunk = true;
}

void PlayedBhaptics::Flood()
{
  this->All->Floods = true;
}

struct PlayedWeart::Server
{
  OneClientServer Port;
  std::mutex Mutex; // guards all following members
  Vibrations Told;
  std::vector<std::string> Hands;
  std::string Status;
  bool IsActuating = true;
  bool HasNews = false;
  std::map<std::string, double> Volumes; // volumes by hand

  std::string MakeStatus()
  {
    Json devices = Json::array();
    for (const std::string& hand : this->Hands)
    {
      devices.push_back({ { "macAddress", "AA:BB:CC:00:11:22" }, { "handSide", hand } });
    }
    return Json{
      { "type", "MW_STATUS" }, { "ts", 1700000000000 },
      { "data",
        { { "status", this->Status }, { "version", "2.0.0" }, { "statusCode", 0 },
          { "errorDesc", "" }, { "warningCode", 0 }, { "warningDesc", "" },
          { "actuationsEnabled", this->IsActuating }, { "connectedDevices", devices } } }
    }.dump();
  }
  /// Processes a line of fields. Returns false if the line is not understood.
  bool Take(const std::vector<std::string>& fields)
  {
    const std::string& id = fields[0];
    if (id == "StartFromClient" || id == "StopFromClient")
    {
      this->Status = id == "StartFromClient" ? "RUNNING" : "IDLE";
      this->HasNews = true;
      return id == "StopFromClient" ? fields.size() == 1
                                    : fields.size() == 4 && fields[3] == "TrackType1";
    }
    const bool isStop = id == "stopTexture";
    const std::size_t at = isStop ? 1 : 6;
    if ((!isStop && id != "texture") || fields.size() != at + 2 ||
      !IsOneOf(fields[at], { "LEFT", "RIGHT" }) ||
      !IsOneOf(fields[at + 1], { "THUMB", "INDEX", "MIDDLE", "ANNULAR", "PINKY", "PALM" }))
    {
      return false;
    }
    double volume = 0.0;
    if (!isStop)
    {
      const int index = std::stoi(fields[1]);
      const double speed = std::stod(fields[4]);
      volume = std::stod(fields[5]);
      if (index < 0 || index > 21 || speed < 0.0 || speed > 0.5 || volume < 0.0 || volume > 100.0)
      {
        return false;
      }
    }
    this->Told.Levels.push_back(static_cast<int>(volume));
    if (this->Status == "RUNNING" && this->IsActuating && fields[at + 1] == "INDEX")
    {
      this->Volumes[fields[at]] = volume;
    }
    return true;
  }
  void Receive(const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Told.Messages.push_back(text);
    if (text[0] == '{')
    {
      const Json all = Json::parse(text, nullptr, false);
      const std::string type = all.is_object() ? all.value("type", "") : "";
      this->HasNews = this->HasNews || type == "MW_GET_STATUS";
      this->Told.Refused += type == "MW_GET_STATUS" && all.contains("ts") ? 0 : 1;
      return;
    }
    std::vector<std::string> fields;
    std::istringstream line(text);
    for (std::string field; std::getline(line, field, ':');)
    {
      fields.push_back(field);
    }
    this->Told.Refused += this->Take(fields) ? 0 : 1;
    this->Told.EndsStopped =
      fields[0] == "stopTexture" || (fields[0] == "StopFromClient" && this->Told.EndsStopped);
  }
  void Serve(tcp::socket& socket)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Told.IsOpen = true;
    }
    std::string unread;
    for (bool isOpen = true; isOpen && !this->Port.MustStop;)
    {
      pollfd waited{ socket.native_handle(), POLLIN, 0 };
      if (::poll(&waited, 1, 5) > 0)
      {
        char part[512];
        error_code error;
        const std::size_t size = socket.read_some(asio::buffer(part), error);
        isOpen = !error;
        unread.append(part, error ? 0 : size);
        for (std::size_t end = unread.find('~'); end != std::string::npos; end = unread.find('~'))
        {
          this->Receive(unread.substr(0, end));
          unread.erase(0, end + 1);
        }
      }
      std::string answer;
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        answer =
          this->HasNews ? "Tracking:TrackType1:0:0:0:0:0:0:0:0~" + this->MakeStatus() + "~" : "";
        this->HasNews = false;
      }
      if (isOpen && !answer.empty())
      {
        asio::write(socket, asio::buffer(answer));
      }
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Told.IsOpen = false;
  }
};

PlayedWeart::PlayedWeart(std::vector<std::string> hands, std::string status)
  : All(std::make_unique<Server>())
{
  this->All->Hands = std::move(hands);
  this->All->Status = std::move(status);
  this->All->Port.Listen(
    "VOLUMEHAPTICS_WEART", [all = this->All.get()](tcp::socket& socket) { all->Serve(socket); });
}

PlayedWeart::~PlayedWeart()
{
  this->Die();
  unsetenv("VOLUMEHAPTICS_WEART");
}

void PlayedWeart::Die()
{
  this->All->Port.Stop();
}

Vibrations PlayedWeart::Get()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Told;
}

double PlayedWeart::GetVolume(const std::string& hand)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Volumes[hand];
}

std::string PlayedWeart::GetStatus()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Status;
}

void PlayedWeart::SetActuating(bool isActuating)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->IsActuating = isActuating;
  this->All->HasNews = true;
}

void PlayedWeart::HangUp()
{
  this->All->Port.HangUp();
}

void PlayedWeart::SetHands(const std::vector<std::string>& hands)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Hands = hands;
  this->All->HasNews = true;
}

struct PlayedHapbeat::Server
{
  static constexpr std::size_t RingSize = 4096; // samples, 256 ms
  static constexpr double Rate = 16000.0;

  asio::io_context Io;
  udp::socket Socket{ this->Io, { asio::ip::address_v4::loopback(), 0 } };
  std::thread Thread;
  std::atomic<bool> MustStop{ false };

  std::mutex Mutex; // guards all following members
  Vibrations Told;
  bool IsSilent = false;
  bool IsStreaming = false;
  int LastNumber = -1;
  int Lost = 0;
  std::deque<int> Ring;
  std::deque<int> Played; // samples played in the last 16 ms
  Clock::time_point At = Clock::now();

  template <typename Number>
  static Number Read(const std::vector<std::uint8_t>& packet, std::size_t at)
  {
    Number number = 0;
    // assumes a little-endian machine, like the tests in general
    std::memcpy(&number, packet.data() + at, sizeof(number));
    return number;
  }
  /// Plays the samples that are due.
  void Step()
  {
    const Clock::time_point now = Clock::now();
    const auto due = static_cast<int>(Rate * std::chrono::duration<double>(now - this->At).count());
    this->At += std::chrono::nanoseconds(static_cast<std::int64_t>(due / Rate * 1e9));
    for (int i = 0; i < due; ++i)
    {
      this->Played.push_back(this->Ring.empty() ? 0 : this->Ring.front());
      if (!this->Ring.empty())
      {
        this->Ring.pop_front();
      }
      if (this->Played.size() > 256)
      {
        this->Played.pop_front();
      }
    }
  }
  /// Processes a packet, and writes the service's answer, if any. Returns false if the packet is
  /// malformed or unknown.
  bool Take(const std::vector<std::uint8_t>& packet, std::vector<std::uint8_t>& answer)
  {
    if (packet.size() < 8 || packet[0] != 0x42 || packet[1] != 0x48 || packet[2] != 1 ||
      Read<std::uint16_t>(packet, 6) != packet.size() - 8)
    {
      return false;
    }
    const int number = Read<std::uint16_t>(packet, 4);
    const bool isRepeated = number == this->LastNumber;
    this->LastNumber = number;
    switch (packet[3])
    {
      case 0x10:
        if (packet.size() == 16 && !this->IsSilent)
        {
          const std::string names =
            std::string("duo_wl") + '\0' + "player_1/pos_neck" + '\0' + "3.0" + '\0';
          answer.assign(packet.begin(), packet.begin() + 16);
          answer[3] = 0x11;
          answer.insert(answer.end(), 8, 0);
          answer.insert(answer.end(), names.begin(), names.end());
          answer[6] = static_cast<std::uint8_t>(answer.size() - 8);
          answer[7] = 0;
        }
        return packet.size() == 16;
      case 0x30:
        if (!isRepeated)
        {
          this->IsStreaming = true;
          this->Ring.clear();
          this->Told.EndsStopped = false;
        }
        return packet.size() >= 20 && Read<std::uint16_t>(packet, 8) == 16000 && packet[10] == 1 &&
          packet[11] == 0;
      case 0x31:
        for (std::size_t i = 12; this->IsStreaming && i + 1 < packet.size(); i += 2)
        {
          this->Lost += this->Ring.size() < RingSize ? 0 : 1;
          this->Ring.push_back(Read<std::int16_t>(packet, i));
        }
        return packet.size() <= 1472;
      case 0x32:
        this->IsStreaming = false; // the remaining samples in the ring are still played
        this->Told.EndsStopped = true;
        return packet.size() == 8;
      default:
        return false;
    }
  }
  void Run()
  {
    std::vector<std::uint8_t> packet(2048);
    while (!this->MustStop)
    {
      pollfd waited{ this->Socket.native_handle(), POLLIN, 0 };
      const bool hasPacket = ::poll(&waited, 1, 2) > 0;
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Step();
      if (!hasPacket)
      {
        continue;
      }
      packet.resize(2048);
      udp::endpoint from;
      error_code error;
      packet.resize(this->Socket.receive_from(asio::buffer(packet), from, 0, error));
      std::vector<std::uint8_t> answer;
      this->Told.Messages.emplace_back(packet.begin(), packet.end());
      this->Told.Refused += this->Take(packet, answer) ? 0 : 1;
      if (!answer.empty())
      {
        this->Socket.send_to(asio::buffer(answer), from, 0, error);
      }
    }
  }
};

PlayedHapbeat::PlayedHapbeat()
  : All(std::make_unique<Server>())
{
  this->All->Thread = std::thread([all = this->All.get()] { all->Run(); });
}

PlayedHapbeat::~PlayedHapbeat()
{
  this->All->MustStop = true;
  this->All->Thread.join();
}

std::uint16_t PlayedHapbeat::GetPort() const
{
  return this->All->Socket.local_endpoint().port();
}

Vibrations PlayedHapbeat::Get()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Told;
}

double PlayedHapbeat::GetLoudness()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->Step();
  int largest = 0;
  for (const int sample : this->All->Played)
  {
    largest = std::max(largest, std::abs(sample));
  }
  return largest / 32767.0;
}

int PlayedHapbeat::CountLost()
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  return this->All->Lost;
}

void PlayedHapbeat::SetSilent(bool isSilent)
{
  const std::lock_guard<std::mutex> lock(this->All->Mutex);
  this->All->IsSilent = isSilent;
}

} // namespace emulated
