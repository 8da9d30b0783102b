// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HfabEmulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace emulated
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr double Pi = 3.14159265358979323846;
constexpr double LargestCurrent = 6000.0; // mA, escon_max_milliamps
constexpr auto Watchdog = std::chrono::milliseconds(100);
/// The first two messages of a host are farther apart than this, unless the controller answers the
/// first one.
constexpr auto Patience = std::chrono::milliseconds(15);
/// After such a pause, answers and messages may cross for this time.
constexpr auto Confusion = std::chrono::milliseconds(200);

/** A row of the host's tables, with the host's names and order. */
struct Row
{
  Triple CapstanDiameters;
  Triple BodyDiameters;
  Triple BodyLengths;
  Triple WorkspaceOrigin;
  Triple TorqueConstants;
  double CountsPerRevolution;
  std::array<bool, 3> MotorAndBodyAligned;
  std::array<int, 3> EncoderHome;
};

const Row& RowOf(int model)
{
  static const Row polhem{ { 0.0288534, 0.0136981, 0.0137281 }, { 0.175, 0.100, 0.100 },
    { 0.1, 0.165, 0.1308 }, { 0.2045, 0.0, 0.0325 }, { 0.0603, 0.0538, 0.0538 }, 4096,
    { false, true, false }, { 8312, -10366, 19764 } };
  static const Row vintage{ { 0.013, 0.010, 0.010 }, { 0.117, 0.077, 0.077 },
    { 0.000, 0.138, 0.112 }, { 0.138, 0.000, -0.097 }, { 0.0234, 0.0234, 0.0234 }, 4000,
    { true, false, true }, { 0, 7700, 0 } };
  static const Row woody{ { 0.010, 0.010, 0.010 }, { 0.160, 0.120, 0.120 }, { 0.080, 0.205, 0.245 },
    { 0.220, 0.000, 0.080 }, { 0.0259, 0.0259, 0.0259 }, 2000, { false, true, true },
    { 0, 0, -6000 } };
  return model == 1 ? polhem : model == 2 ? vintage : woody;
}

double Square(double x)
{
  return x * x;
}

/** Returns Polhem's tip position by the host's formula, from three triangle angles at the elbow. */
Triple PolhemTip(const Triple& t)
{
  constexpr double l0 = 34e-3;
  constexpr double l1 = 165e-3;
  constexpr double l2 = 25e-3;
  constexpr double l3 = 190e-3;
  constexpr double l4 = 34e-3;
  constexpr double l5 = 130.8e-3;
  const double toElbow = Square(l0 + l1 * std::cos(t[1])) + Square(l1 * std::sin(t[1]));
  const double toCrank = Square(l0 + l1 * std::cos(t[1]) - l2 * std::cos(t[2])) +
    Square(l1 * std::sin(t[1]) - l2 * std::sin(t[2]));
  const double first = (l1 * l1 + toElbow - l0 * l0) / (2.0 * l1 * std::sqrt(toElbow));
  const double second = (l4 * l4 + toCrank - l3 * l3) / (2.0 * l4 * std::sqrt(toCrank));
  const double third = (toElbow + toCrank - l2 * l2) / (2.0 * std::sqrt(toElbow * toCrank));
  const double lambda = t[1] - std::acos(first) - std::acos(second) - std::acos(third);
  const double reach = l0 / 2.0 + l1 * std::cos(t[1]) + l5 * std::cos(lambda);
  return { reach * std::cos(t[0]), reach * std::sin(t[0]),
    l1 * std::sin(t[1]) + l5 * std::sin(lambda) };
}

double Determinant(const Triple& a, const Triple& b, const Triple& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/** Returns the derivatives of the tip's position by each angle, computed from differences. */
std::array<Triple, 3> SlopesOf(int model, const Triple& angles)
{
  constexpr double h = 1e-5;
  std::array<Triple, 3> slopes{};
  for (int j = 0; j < 3; ++j)
  {
    Triple above = angles;
    Triple below = angles;
    above[j] += h / 2.0;
    below[j] -= h / 2.0;
    const Triple a = HfabEmulator::TipOf(model, above);
    const Triple b = HfabEmulator::TipOf(model, below);
    for (int i = 0; i < 3; ++i)
    {
      slopes[j][i] = (a[i] - b[i]) / h;
    }
  }
  return slopes;
}

/** Computes the angles for a tip position by Newton's method, starting from nearby angles. */
void Follow(int model, const Triple& tip, Triple& angles)
{
  for (int i = 0; i < 8; ++i)
  {
    const Triple now = HfabEmulator::TipOf(model, angles);
    const Triple way{ tip[0] - now[0], tip[1] - now[1], tip[2] - now[2] };
    const std::array<Triple, 3> m = SlopesOf(model, angles);
    const double whole = Determinant(m[0], m[1], m[2]);
    angles[0] += Determinant(way, m[1], m[2]) / whole;
    angles[1] += Determinant(m[0], way, m[2]) / whole;
    angles[2] += Determinant(m[0], m[1], way) / whole;
  }
}

double SignOf(const Row& row, int joint)
{
  return row.MotorAndBodyAligned[joint] ? -1.0 : 1.0;
}

std::array<int, 3> CountsOf(int model, const Triple& angles)
{
  const Row& row = RowOf(model);
  std::array<int, 3> counts{};
  for (int j = 0; j < 3; ++j)
  {
    const double motor =
      SignOf(row, j) * angles[j] * row.BodyDiameters[j] / row.CapstanDiameters[j];
    counts[j] = static_cast<int>(std::lround(motor * row.CountsPerRevolution / (2.0 * Pi)));
  }
  return counts;
}
} // namespace

Triple HfabEmulator::TipOf(int model, const Triple& t)
{
  const Row& row = RowOf(model);
  Triple tip;
  if (model == 1)
  {
    tip = PolhemTip(t);
  }
  else
  {
    const Triple& l = row.BodyLengths;
    const double reach = l[1] * std::sin(t[1]) + l[2] * std::sin(t[2]);
    tip = { std::cos(t[0]) * reach, std::sin(t[0]) * reach,
      l[0] + l[1] * std::cos(t[1]) - l[2] * std::cos(t[2]) };
  }
  for (int i = 0; i < 3; ++i)
  {
    tip[i] -= row.WorkspaceOrigin[i];
  }
  return tip;
}

Triple HfabEmulator::AnglesOf(int model, const std::array<int, 3>& counts)
{
  const Row& row = RowOf(model);
  Triple angles{};
  for (int j = 0; j < 3; ++j)
  {
    const double motor = 2.0 * Pi * counts[j] / row.CountsPerRevolution;
    angles[j] = SignOf(row, j) * motor * row.CapstanDiameters[j] / row.BodyDiameters[j];
  }
  return angles;
}

std::array<int, 3> HfabEmulator::HomeOf(int model)
{
  return RowOf(model).EncoderHome;
}

Triple HfabEmulator::CurrentsOf(int model, const Triple& angles, const Triple& force)
{
  const Row& row = RowOf(model);
  const std::array<Triple, 3> slopes = SlopesOf(model, angles);
  Triple currents{};
  for (int j = 0; j < 3; ++j)
  {
    double torque = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      torque += slopes[j][i] * force[i];
    }
    currents[j] = 1000.0 * torque * SignOf(row, j) * row.CapstanDiameters[j] /
      row.BodyDiameters[j] / row.TorqueConstants[j];
  }
  return currents;
}

HfabEmulator::HfabEmulator(int model)
  : Model(model)
{
  this->Master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (this->Master < 0 || grantpt(this->Master) != 0 || unlockpt(this->Master) != 0)
  {
    throw std::runtime_error("no pseudo-terminal can be made");
  }
  this->Port = ptsname(this->Master);
  this->PlaceAtHome();
  // After power-on, the encoders count from 0 wherever the arm is.
  this->Angles[0] += 0.1;
  this->Hand.Place(TipOf(model, this->Angles));
  this->PressButton();
  this->LastMove = Clock::now();
  this->Thread = std::thread([this] { this->Run(); });
}

HfabEmulator::~HfabEmulator()
{
  this->Stop = true;
  this->Thread.join();
  this->Unplug();
}

void HfabEmulator::Unplug()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (this->Master >= 0)
  {
    close(this->Master);
    this->Master = -1;
  }
}

void HfabEmulator::PlaceAtHome()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Angles = AnglesOf(this->Model, HomeOf(this->Model));
  this->Hand.Place(TipOf(this->Model, this->Angles));
}

void HfabEmulator::PressButton()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Offset = CountsOf(this->Model, this->Angles);
  this->Counts = {};
  this->NeedsButton = false;
}

void HfabEmulator::SetHandle(const std::array<int, 3>& counts)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Handle = counts;
}

void HfabEmulator::SetGoal(const Triple& goal)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Goal = goal;
}

Triple HfabEmulator::GetTip() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Hand.Tip;
}

std::array<int, 3> HfabEmulator::GetCurrents() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Currents;
}

Triple HfabEmulator::GetForce() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const Row& row = RowOf(this->Model);
  Triple torques{};
  for (int j = 0; j < 3; ++j)
  {
    torques[j] = 1e-3 * this->Currents[j] * row.TorqueConstants[j] * SignOf(row, j) *
      row.BodyDiameters[j] / row.CapstanDiameters[j];
  }
  // The torque of each joint is the force projected on the derivative for that joint, which gives
  // three equations for the force.
  const std::array<Triple, 3> m = SlopesOf(this->Model, this->Angles);
  const Triple x{ m[0][0], m[1][0], m[2][0] };
  const Triple y{ m[0][1], m[1][1], m[2][1] };
  const Triple z{ m[0][2], m[1][2], m[2][2] };
  const double whole = Determinant(x, y, z);
  return { Determinant(torques, y, z) / whole, Determinant(x, torques, z) / whole,
    Determinant(x, y, torques) / whole };
}

double HfabEmulator::DrainLongestPause()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return std::chrono::duration<double>(std::exchange(this->LongestPause, {})).count();
}

bool HfabEmulator::IsRaw() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  termios settings{};
  tcgetattr(this->Master, &settings);
  return (settings.c_lflag & (ICANON | ECHO | ISIG)) == 0 && (settings.c_oflag & OPOST) == 0 &&
    (settings.c_iflag & (ICRNL | IXON)) == 0;
}

void HfabEmulator::Run()
{
  while (!this->Stop)
  {
    int master = -1;
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      master = this->Master;
    }
    this->Move();
    pollfd port{ master, POLLIN, 0 };
    char bytes[64];
    if (poll(&port, 1, 1) <= 0 || (port.revents & POLLIN) == 0)
    {
      if ((port.revents & (POLLHUP | POLLNVAL)) != 0)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // until a program opens the port
      }
      continue;
    }
    const ssize_t size = read(master, bytes, sizeof(bytes));
    // A controller never stalls, but this thread may, and bytes may be delayed. After a pause,
    // therefore treat messages that arrive together as if they had been sent one after another.
    const auto now = Clock::now();
    this->HeldUpUntil = now - this->LastBytes > Patience ? now + Confusion : this->HeldUpUntil;
    const bool wasHeldUp = now < this->HeldUpUntil && this->Fault != HfabFault::Late;
    this->LastBytes = now;
    for (ssize_t i = 0; i < size; ++i)
    {
      // After a message, the firmware discards all waiting bytes. If there are more than the end of
      // the line, it rejects the message.
      const bool isTrailed = !wasHeldUp &&
        std::any_of(
          bytes + i + 1, bytes + size, [](char c) { return c != '\n' && c != '\r' && c != '\0'; });
      this->Take(bytes[i], isTrailed);
      i = bytes[i] == ']' && !wasHeldUp ? size : i;
    }
  }
}

void HfabEmulator::Move()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto now = Clock::now();
  const bool isLate = now - this->LastMessage > Watchdog;
  if (isLate && this->Currents != std::array<int, 3>{})
  {
    this->Currents = {};
    ++this->Watchdogs;
  }
}

/**
 * Processes a byte like await_message() of the firmware, which waits for a ']' and counts brackets
 * and commas.
 */
void HfabEmulator::Take(char byte, bool isTrailed)
{
  this->Line += byte;
  constexpr std::size_t buffer = 127;
  if (byte != ']')
  {
    if (this->Line.size() == buffer)
    {
      this->Answer(128);
    }
    return;
  }
  const std::size_t start = this->Line.rfind('[');
  if (start == std::string::npos)
  {
    this->Answer(256);
    return;
  }
  if (std::count(this->Line.begin(), this->Line.end(), ',') != 2)
  {
    this->Answer(512);
    return;
  }
  if (isTrailed || this->Fault == HfabFault::Refusal)
  {
    this->Answer(8);
    return;
  }
  std::array<int, 3> milliamperes{};
  if (std::sscanf(this->Line.c_str() + start, "[%d,%d,%d]", &milliamperes[0], &milliamperes[1],
        &milliamperes[2]) != 3)
  {
    this->Answer(1024);
    return;
  }
  this->ReceiveCurrents(milliamperes);
  this->Answer(0);
}

void HfabEmulator::ReceiveCurrents(const std::array<int, 3>& milliamperes)
{
  ++this->Messages;
  const Triple force = this->GetForce();
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto now = Clock::now();
  this->LongestPause = std::max(this->LongestPause, now - this->LastMessage);
  this->LastMessage = now;
  for (int j = 0; j < 3; ++j)
  {
    const bool flows = !this->NeedsButton && std::abs(milliamperes[j]) <= LargestCurrent;
    this->Currents[j] = flows ? milliamperes[j] : 0;
  }
  // Move the hand for the time since the last message, in steps of at most a millisecond.
  const double time = std::min(0.02, std::chrono::duration<double>(now - this->LastMove).count());
  this->LastMove = now;
  const int steps = 1 + static_cast<int>(time / 1e-3);
  for (int i = 0; i < steps; ++i)
  {
    this->Hand.Step(time / steps, force);
  }
  Follow(this->Model, this->Hand.Tip, this->Angles);
  this->Counts = CountsOf(this->Model, this->Angles);
  for (int j = 0; j < 3; ++j)
  {
    this->Counts[j] -= this->Offset[j];
  }
  if (this->NeedsButton)
  {
    this->Counts[0] = static_cast<int>(8000.0 + 4000.0 * std::sin(0.0002 * this->Pretended++));
    this->Counts[1] = milliamperes[0];
  }
}

void HfabEmulator::Answer(int error)
{
  this->Line.clear();
  this->Errors |= error;
  const HfabFault fault = this->Fault;
  if (fault == HfabFault::Silence)
  {
    return;
  }
  if (fault == HfabFault::Late)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::array<int, 3> counts = this->Counts;
  counts[1] += fault == HfabFault::Jump ? 1000 : 0;
  char text[128];
  const int size = fault == HfabFault::Junk
    ? std::snprintf(text, sizeof(text), "[3,1,2,oops]\n")
    : std::snprintf(text, sizeof(text), "[%d,%d,%d,%d,%d,%d,%d,%d]\n",
        fault == HfabFault::OtherArm ? 1 + this->Model % 3 : this->Model, counts[0], counts[1],
        counts[2], this->Handle[0], this->Handle[1], this->Handle[2], error);
  if (this->Master >= 0)
  {
    [[maybe_unused]] const ssize_t written =
      write(this->Master, text, static_cast<std::size_t>(size));
  }
}

} // namespace emulated
