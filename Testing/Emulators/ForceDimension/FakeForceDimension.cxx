// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FakeForceDimension.h"

#include <drdc.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace
{
using emulated::FakeForceDimension;
using Clock = std::chrono::steady_clock;

const char* lastError = "no error";
Clock::time_point lastRead;

/** Accesses the fake library with its mutex locked, if this device is open. */
struct Opened
{
  explicit Opened(char id)
    : Fake(FakeForceDimension::Get())
    , Lock(Fake.Mutex)
    , Is(Fake.IsOpen && (id == 0 || id == -1))
  {
    if (!this->Is)
    {
      lastError = "no device found";
    }
  }
  explicit operator bool() const { return this->Is; }
  FakeForceDimension* operator->() const { return &this->Fake; }

  FakeForceDimension& Fake;
  const std::unique_lock<std::mutex> Lock;
  const bool Is;
};

/** Moves the hand for the time since the last read, in steps of at most a millisecond. */
bool Move(FakeForceDimension& fake)
{
  const auto now = Clock::now();
  const double time = std::min(0.05, std::chrono::duration<double>(now - lastRead).count());
  const bool isSoon = time < 1e-4;
  if (!isSoon)
  {
    const int steps = 1 + static_cast<int>(time / 1e-3);
    const emulated::Triple force = fake.ForceIsOn ? fake.Force : emulated::Triple{};
    for (int i = 0; i < steps; ++i)
    {
      fake.Hand.Step(time / steps, force);
    }
    lastRead = now;
  }
  return isSoon;
}

int ReadPosition(FakeForceDimension& fake, double* px, double* py, double* pz)
{
  if (fake.FailsToRead)
  {
    lastError = "communication error";
    return -1;
  }
  const bool isSoon = Move(fake);
  *px = fake.TellsNonsense ? std::numeric_limits<double>::quiet_NaN() : fake.Hand.Tip[0];
  *py = fake.Hand.Tip[1];
  *pz = fake.Hand.Tip[2];
  return isSoon ? DHD_TIMEGUARD : 0;
}

int Set(FakeForceDimension& fake, const emulated::Triple& force, const emulated::Triple& torque)
{
  if (fake.FailsToWrite)
  {
    lastError = "communication error";
    return -1;
  }
  if (fake.IsRegulating)
  {
    lastError = "regulation is running";
    return -1;
  }
  const bool isZero = force == emulated::Triple{} && torque == emulated::Triple{};
  fake.ForcesBeforeZero += !isZero && !fake.IsInitialised ? 1 : 0;
  if (force != fake.Force || torque != fake.Torque)
  {
    fake.Calls.emplace_back(isZero ? "zero" : "force");
  }
  fake.Force = force;
  fake.Torque = torque;
  return std::abs(force[0]) > 12.0 ? DHD_MOTOR_SATURATED : 0;
}
} // namespace

emulated::FakeForceDimension& FakeForceDimension::Get()
{
  static FakeForceDimension fake;
  return fake;
}

extern "C"
{

  const char* dhdErrorGetLastStr()
  {
    return lastError;
  }

  int dhdGetDeviceCount()
  {
    return FakeForceDimension::Get().Count;
  }

  int drdOpenID(char ID)
  {
    FakeForceDimension& fake = FakeForceDimension::Get();
    const std::lock_guard<std::mutex> lock(fake.Mutex);
    if (ID < 0 || ID >= fake.Count || fake.IsOpen || fake.FailsToOpen || !fake.IsPluggedIn)
    {
      lastError = "device already in use";
      return -1;
    }
    fake.IsOpen = true;
    fake.Calls.emplace_back("open");
    lastRead = Clock::now();
    return ID;
  }

  int drdClose(char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    fake->Calls.emplace_back("close");
    fake->IsOpen = fake->ForceIsOn = fake->IsRegulating = false;
    return 0;
  }

  bool drdIsInitialized(char ID)
  {
    const Opened fake(ID);
    return fake && fake->IsInitialised;
  }

  int drdAutoInit(char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    fake->Calls.emplace_back("init");
    fake->IsRegulating = true;
    fake->IsInitialised = !fake->FailsToInit;
    lastError = fake->FailsToInit ? "timeout" : lastError;
    return fake->FailsToInit ? -1 : 0;
  }

  int drdStop(bool frc, char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    fake->Calls.emplace_back(frc ? "stop" : "brake");
    fake->IsRegulating = false;
    fake->ForceIsOn = fake->ForceIsOn && frc;
    return 0;
  }

  int dhdGetSerialNumber(ushort* sn, char ID)
  {
    const Opened fake(ID);
    *sn = 4711;
    return fake ? 0 : -1;
  }

  int dhdGetSystemType(char ID)
  {
    const Opened fake(ID);
    return fake ? fake->Type : -1;
  }

  double dhdGetMaxForce(char ID)
  {
    const Opened fake(ID);
    return fake ? fake->MaxForce : -1.0;
  }

  double dhdGetMaxTorque(char ID)
  {
    const Opened fake(ID);
    return fake ? fake->MaxTorque : -1.0;
  }

  int dhdGetStatus(int status[DHD_MAX_STATUS], char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    std::fill(status, status + DHD_MAX_STATUS, 0);
    status[DHD_STATUS_POWER] = fake->HasPower ? 1 : 0;
    status[DHD_STATUS_CONNECTED] = fake->IsPluggedIn ? 1 : 0;
    status[DHD_STATUS_FORCE] = fake->ForceIsOn ? 1 : 0;
    return 0;
  }

  int dhdEnableForce(uchar val, char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    if (fake->FailsToEnable)
    {
      lastError = "communication error";
      return -1;
    }
    fake->Calls.emplace_back(val == DHD_ON ? "on" : "off");
    fake->ForceIsOn = val == DHD_ON;
    return 0;
  }

  bool dhdHasWrist(char ID)
  {
    const Opened fake(ID);
    return fake && fake->HasWrist;
  }

  bool dhdHasActiveGripper(char ID)
  {
    const Opened fake(ID);
    return fake && fake->HasGripper;
  }

  int dhdEmulateButton(uchar val, char ID)
  {
    const Opened fake(ID);
    if (!fake || !fake->HasGripper)
    {
      lastError = "feature not available";
      return -1;
    }
    fake->EmulatesButton = val == DHD_ON;
    return 0;
  }

  uint dhdGetButtonMask(char ID)
  {
    const Opened fake(ID);
    const bool isEmulated = fake && fake->EmulatesButton && fake->IsGripperClosed;
    return fake ? fake->Buttons | (isEmulated ? 1u : 0u) : 0u;
  }

  int dhdGetPosition(double* px, double* py, double* pz, char ID)
  {
    const Opened fake(ID);
    return fake ? ReadPosition(fake.Fake, px, py, pz) : -1;
  }

  int dhdGetPositionAndOrientationFrame(
    double* px, double* py, double* pz, double matrix[3][3], char ID)
  {
    const Opened fake(ID);
    if (!fake)
    {
      return -1;
    }
    for (int row = 0; row < 3; ++row)
    {
      std::copy(fake->Frame[row].begin(), fake->Frame[row].end(), matrix[row]);
    }
    return ReadPosition(fake.Fake, px, py, pz);
  }

  int dhdSetForce(double fx, double fy, double fz, char ID)
  {
    const Opened fake(ID);
    return fake ? Set(fake.Fake, { fx, fy, fz }, {}) : -1;
  }

  int dhdSetForceAndTorque(
    double fx, double fy, double fz, double tx, double ty, double tz, char ID)
  {
    const Opened fake(ID);
    return fake ? Set(fake.Fake, { fx, fy, fz }, { tx, ty, tz }) : -1;
  }
}
