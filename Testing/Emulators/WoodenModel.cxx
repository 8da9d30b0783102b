// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WoodenModel.h"

#include "HidItems.h"

#include <cerrno>
#include <cmath>
#include <thread>

namespace emulated
{
namespace
{
constexpr double Pi = 3.141592653589793;
constexpr double Capstan = 0.010;                     // m
constexpr double Bodies[3] = { 0.160, 0.120, 0.120 }; // m
constexpr double Height = 0.080;                      // m
constexpr double Upper = 0.205;                       // m
constexpr double Fore = 0.245;                        // m
constexpr double Foot[3] = { 0.22, 0.0, 0.08 };       // m
constexpr double TorqueConstant = 0.0259;             // N m/A
constexpr double CountsPerTurn = 2000.0;
constexpr double Step = 1e-3; // s
const Triple RestAngles{ 0.0, 0.0, Pi / 2.0 };

Triple TipOf(const Triple& t)
{
  const double reach = Upper * std::sin(t[1]) + Fore * std::sin(t[2]);
  return { std::cos(t[0]) * reach - Foot[0], std::sin(t[0]) * reach - Foot[1],
    Height + Upper * std::cos(t[1]) - Fore * std::cos(t[2]) - Foot[2] };
}

/**
 * Returns the derivatives of the tip's position with respect to the angles as columns, computed
 * from differences.
 */
std::array<Triple, 3> Slopes(const Triple& angles)
{
  constexpr double h = 1e-6;
  std::array<Triple, 3> columns;
  for (int j = 0; j < 3; ++j)
  {
    Triple more = angles;
    Triple less = angles;
    more[j] += h;
    less[j] -= h;
    for (int a = 0; a < 3; ++a)
    {
      columns[j][a] = (TipOf(more)[a] - TipOf(less)[a]) / (2.0 * h);
    }
  }
  return columns;
}

double Determinant(const Triple& a, const Triple& b, const Triple& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Triple RowOf(const std::array<Triple, 3>& m, int row)
{
  return { m[0][row], m[1][row], m[2][row] };
}

/** Computes the angles for a tip position by Newton's method, starting from nearby angles. */
void Follow(const Triple& tip, Triple& angles)
{
  for (int i = 0; i < 8; ++i)
  {
    const Triple now = TipOf(angles);
    const Triple way{ tip[0] - now[0], tip[1] - now[1], tip[2] - now[2] };
    const std::array<Triple, 3> m = Slopes(angles);
    const double whole = Determinant(m[0], m[1], m[2]);
    angles[0] += Determinant(way, m[1], m[2]) / whole;
    angles[1] += Determinant(m[0], way, m[2]) / whole;
    angles[2] += Determinant(m[0], m[1], way) / whole;
  }
}
} // namespace

WoodenModel::WoodenModel(Board board, std::string name)
  : Controller(board)
  , Name(std::move(name))
{
  this->PowerUp();
}

void WoodenModel::PowerUp()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Angles = RestAngles;
  this->Hand.Place(TipOf(RestAngles));
  // The encoders have these counts if they are switched on in the rest pose.
  this->Offset = { 0, 0, 6000 };
  this->Currents = {};
  this->Button = false;
  this->Fault = WoodenFault::None;
}

std::vector<std::uint8_t> WoodenModel::GetReportDescriptor() const
{
  // A vendor page with byte fields in both directions and without ids, equal for both boards.
  HidItems items;
  const auto bytes = static_cast<unsigned>(this->GetPacketSize());
  items.Page(0xFFAB).Usage(0x0200).Open(HidItems::ApplicationCollection).Logical(0, 255);
  items.Usage(1).Fields(8, bytes).Input().Usage(2).Fields(8, bytes).Output();
  return items.Close().Get();
}

int WoodenModel::Output(const std::uint8_t* report, int size)
{
  if (this->Fault == WoodenFault::WriteError)
  {
    return -EIO;
  }
  // USB transfers one packet per millisecond.
  const auto now = std::chrono::steady_clock::now();
  this->Next = std::max(now, this->Next + std::chrono::milliseconds(1));
  std::this_thread::sleep_until(this->Next);
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Last.assign(report, report + size);
  const auto word = [report](int w)
  { return static_cast<std::int16_t>(report[1 + 2 * w] | report[2 + 2 * w] << 8); };
  if (size == 1 + this->GetPacketSize() && report[0] == 0)
  {
    ++this->Packets;
    for (int j = 0; j < 3; ++j)
    {
      this->Currents[j] = word(3) == 1 ? 0 : word(j);
    }
    if (word(3) == 1)
    {
      ++this->Presets;
      this->LastPreset = this->Last;
    }
    const bool isMissed = word(3) == 1 && this->MissedPresets > 0;
    this->MissedPresets -= isMissed ? 1 : 0;
    if (word(3) == 1 && !this->IgnoresPresets && !isMissed)
    {
      this->Button = false;
      for (int j = 0; j < 3; ++j)
      {
        const double counts = this->Angles[j] * Bodies[j] / Capstan * CountsPerTurn / (2.0 * Pi);
        this->Offset[j] = static_cast<int>(std::lround(counts)) - word(4 + j);
      }
    }
  }
  this->Hand.Step(Step, this->ComputeForce());
  Follow(this->Hand.Tip, this->Angles);
  this->SendCounts();
  return size;
}

void WoodenModel::SendCounts()
{
  std::uint8_t report[64]{};
  const WoodenFault fault = this->Fault;
  for (int j = 0; j < 3; ++j)
  {
    const double counts = this->Angles[j] * Bodies[j] / Capstan * CountsPerTurn / (2.0 * Pi);
    const long jump = fault == WoodenFault::Jump && j == 1 ? 2000 : 0;
    const long read =
      fault == WoodenFault::LostZero ? 0 : std::lround(counts) - this->Offset[j] + jump;
    report[2 * j] = static_cast<std::uint8_t>(read & 0xFF);
    report[2 * j + 1] = static_cast<std::uint8_t>(read >> 8 & 0xFF);
  }
  report[12] = this->Button ? 1 : 0;
  if (fault != WoodenFault::Silence)
  {
    this->Input(report, fault == WoodenFault::ShortReport ? 7 : this->GetPacketSize());
  }
}

Triple WoodenModel::ComputeForce() const
{
  // The torque of each joint is the force projected on the derivative for that joint, which gives
  // three equations for the force.
  Triple torques;
  for (int j = 0; j < 3; ++j)
  {
    torques[j] = 1e-3 * this->Currents[j] * TorqueConstant * Bodies[j] / Capstan;
  }
  const std::array<Triple, 3> m = Slopes(this->Angles);
  const Triple x = RowOf(m, 0);
  const Triple y = RowOf(m, 1);
  const Triple z = RowOf(m, 2);
  const double whole = Determinant(x, y, z);
  return { Determinant(torques, y, z) / whole, Determinant(x, torques, z) / whole,
    Determinant(x, y, torques) / whole };
}

void WoodenModel::SetGoal(const Triple& goal)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Goal = goal;
}

Triple WoodenModel::GetTip() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Hand.Tip;
}

Triple WoodenModel::GetForce() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->ComputeForce();
}

std::vector<std::uint8_t> WoodenModel::GetLastPacket() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Last;
}

std::vector<std::uint8_t> WoodenModel::GetLastPreset() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->LastPreset;
}

void WoodenModel::PassTime(double time)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (time >= 0.5)
  {
    this->Currents = {};
  }
}

} // namespace emulated
