// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture for child processes with an armed device without a watchdog. The device stores its last
 * force in memory that outlives the child, as such a device's motors would hold it.
 */
#ifndef EndingsRig_h
#define EndingsRig_h

#include "SignalsRig.h"

#include <Devices/Common/DeviceKind.h>

#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace devicetest
{

/// State that a device in a child process shares with the parent, which evaluates it.
struct LastingDevice
{
  std::atomic<double> Sent{ 0.0 }; ///< norm of the last force (N)
  std::atomic<bool> IsQuenched{ false };
  std::atomic<bool> IsPressed{ false };
  std::atomic<bool> CrashesInRead{ false };
  std::atomic<bool> IsCrashing{ false };
  std::atomic<int> TimeToCrash{ 0 }; ///< time (ms) from CrashesInRead to the crash
  std::atomic<bool> CrashesInQuench{ false };
  std::atomic<bool> HadForce{ false };
  std::atomic<int> Handled{ 0 };
  std::atomic<double> ForceWhenHandled{ 0.0 };
  std::atomic<void*> Address{ nullptr };

  double GetForce() const { return this->IsQuenched ? 0.0 : this->Sent.load(); }
  void Handle()
  {
    ++this->Handled;
    this->ForceWhenHandled = this->ForceWhenHandled + this->GetForce();
  }
};

/// State of the running test's device, in memory that is shared with child processes.
inline LastingDevice* Lasting = nullptr;

#if defined(__GNUC__)
__attribute__((no_sanitize("address", "undefined")))
#endif
inline void
WriteToNowhere()
{
  *static_cast<volatile int*>(nullptr) = 1;
}

class LastingBackend : public VolumeHaptics::DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override { this->Write({}); }
  std::string GetName() const override { return "lasting"; }
  VolumeHaptics::DeviceLimits GetLimits() const override
  {
    VolumeHaptics::DeviceLimits limits;
    limits.MaximumForce = 6.0;
    return limits;
  }
  VolumeHaptics::DeviceState Read(
    double period, VolumeHaptics::DeviceSample& sample) noexcept override
  {
    if (Lasting->CrashesInRead)
    {
      Lasting->IsCrashing = true;
      poll(nullptr, 0, Lasting->TimeToCrash);
      WriteToNowhere();
    }
    this->Time += period;
    // The tip is in front of the wall, or inside it while `IsPressed` is true.
    const double depth = Lasting->IsPressed ? 0.009 + 0.001 * std::sin(10.0 * this->Time) : 0.005;
    sample.Tip = { 0.007, 0.007, depth };
    sample.Fresh = true;
    return VolumeHaptics::DeviceState::Running;
  }
  VolumeHaptics::DeviceState Write(const VolumeHaptics::Vector3& force) noexcept override
  {
    Lasting->Sent = VolumeHaptics::Norm(force);
    Lasting->IsQuenched = false;
    return VolumeHaptics::DeviceState::Running;
  }
  void Quench() noexcept override
  {
    Lasting->IsQuenched = true;
    if (Lasting->CrashesInQuench)
    {
      WriteToNowhere();
    }
  }

private:
  double Time = 0.0;
};

class Endings : public Signals
{
protected:
  Endings()
  {
    static const bool added = vtkHapticDevice::AddDeviceKind({ "lasting",
      []
      {
        return std::vector<VolumeHaptics::DeviceListing>{ { "lasting:0",
          "A device that keeps its force", "available" } };
      },
      [](const std::string&, const VolumeHaptics::DeviceOptions&, std::string&)
      { return std::make_unique<LastingBackend>(); } });
    static_cast<void>(added);
    void* const memory = mmap(
      nullptr, sizeof(LastingDevice), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    Lasting = new (memory) LastingDevice;
  }
  ~Endings() override { munmap(Lasting, sizeof(LastingDevice)); }

  /// Arms the device, and waits until a force acts. At the default rate (Hz), a tick takes 10 ms,
  /// so a test detects whether an ending waits for the next tick.
  void Feel(double rate = 100.0)
  {
    const rlimit none{ 0, 0 };
    setrlimit(RLIMIT_CORE, &none);
    Lasting->IsPressed = false;
    Lasting->HadForce = false;
    this->Device->SetServoRate(rate);
    this->Device->SetMaximumForceRate(1e4);
    const bool isFelt = this->Device->Open("lasting:0") && this->Device->Start() &&
      Eventually(
        [this]
        {
          this->Device->UpdateState();
          return this->Device->GetState()->GetTipPosition()[2] == 5.0;
        });
    this->Device->Arm();
    // Start the press after the ramp, because a wall that is pressed during the ramp stays soft.
    const bool isArmed = Eventually(
      [this]
      {
        this->Device->UpdateState();
        return IsFullyArmed(this->Device);
      });
    Lasting->IsPressed = true;
    Lasting->HadForce = isFelt && isArmed && Eventually([] { return Lasting->GetForce() > 0.2; });
  }
  static void Forget()
  {
    Lasting->Handled = 0;
    Lasting->ForceWhenHandled = 0.0;
  }
  /// Waits until a force acts in a child process, and ends the process with `how`. Returns the exit
  /// code, or minus the signal. Expects that no force remains.
  template <typename F>
  int End(F&& how)
  {
    const int result = InChild(
      [&]
      {
        this->Feel();
        how();
        return 77; // not reached if the child ends as expected
      });
    EXPECT_TRUE(Lasting->HadForce);
    EXPECT_EQ(Lasting->GetForce(), 0.0);
    return result;
  }
};
} // namespace devicetest

#endif
