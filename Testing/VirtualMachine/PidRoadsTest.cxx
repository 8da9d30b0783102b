// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares two ways to the same force-feedback device on a real kernel: reports through hidraw, and
 * effects through the kernel's own driver (hid-pidff, evdev's force feedback). Prints how fast each
 * way is, and which force remains when its process dies. Documentation/devices/wheels.md has the
 * figures and the conclusions.
 */

#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"
#include "Waiting.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace machinetest
{
using namespace emulated;

namespace
{
double Since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

constexpr int Full = 32767;
constexpr int Duration = 100; ///< ms, length of the effect

/** A way to push along the device's x. Levels are from -Full to Full. */
class Road
{
public:
  virtual ~Road() = default;
  virtual const char* GetName() const = 0;
  virtual bool Open() = 0;
  virtual bool Push(int level) = 0;
  /** Starts the effect again. */
  virtual bool Refresh() = 0;
};

/** A way through hidraw, with OpenFFBoard's reports, byte by byte as PidDialogue sends them. */
class Hidraw : public Road
{
public:
  explicit Hidraw(std::string node)
    : Node(std::move(node))
  {
  }
  ~Hidraw() override { close(this->File); }
  const char* GetName() const override { return "hidraw"; }
  bool Open() override
  {
    this->File = open(this->Node.c_str(), O_RDWR);
    std::uint8_t create[] = { 0x11, 1, 0, 0 };
    // The number of HIDIOCSFEATURE(4), as linux/hidraw.h defines it.
    constexpr unsigned long setFeature = _IOC(_IOC_WRITE | _IOC_READ, 'H', 0x06, sizeof(create));
    return this->Send({ 0x0C, 8 }) && this->Send({ 0x0C, 1 }) && this->Send({ 0x0D, 255 }) &&
      ioctl(this->File, setFeature, create) == sizeof(create) &&
      this->Send(
        { 1, 1, 1, Duration, 0, 0, 0, 0, 0, 0, 0, 255, 0, 4, 0x28, 0x23, 0, 0, 0, 0, 0, 0 }) &&
      this->Push(0) && this->Refresh();
  }
  bool Push(int level) override
  {
    return this->Send({ 5, 1, static_cast<std::uint8_t>(level & 0xFF),
      static_cast<std::uint8_t>(level >> 8 & 0xFF) });
  }
  bool Refresh() override { return this->Send({ 10, 1, 1, 1 }); }

private:
  bool Send(const std::vector<std::uint8_t>& report) const
  {
    return write(this->File, report.data(), report.size()) == static_cast<ssize_t>(report.size());
  }

  const std::string Node;
  int File = -1;
};

class Evdev : public Road
{
public:
  ~Evdev() override { close(this->File); }
  const char* GetName() const override { return "evdev"; }
  bool Open() override
  {
    std::error_code none;
    for (const auto& node : std::filesystem::directory_iterator("/dev/input", none))
    {
      const int file = open(node.path().c_str(), O_RDWR | O_CLOEXEC);
      std::uint8_t bits[FF_MAX / 8 + 1] = {};
      if (file >= 0 && ioctl(file, EVIOCGBIT(EV_FF, sizeof(bits)), bits) > 0 &&
        (bits[FF_CONSTANT / 8] >> FF_CONSTANT % 8 & 1) != 0)
      {
        this->File = file;
        break;
      }
      close(file);
    }
    input_absinfo axis{};
    if (ioctl(this->File, EVIOCGABS(ABS_X), &axis) >= 0)
    {
      std::cout << "evdev: x from " << axis.minimum << " to " << axis.maximum << ", fuzz "
                << axis.fuzz << ", flat " << axis.flat << "\n";
    }
    std::memset(&this->Effect, 0, sizeof(this->Effect));
    this->Effect.type = FF_CONSTANT;
    this->Effect.id = -1;
    this->Effect.direction = 0x4000;
    this->Effect.replay.length = Duration;
    return this->File >= 0 && this->Push(0) && this->Refresh();
  }
  bool Push(int level) override
  {
    this->Effect.u.constant.level = static_cast<std::int16_t>(level);
    return ioctl(this->File, EVIOCSFF, &this->Effect) >= 0;
  }
  bool Refresh() override
  {
    input_event play{};
    play.type = EV_FF;
    play.code = static_cast<std::uint16_t>(this->Effect.id);
    play.value = 1;
    return write(this->File, &play, sizeof(play)) == sizeof(play);
  }

private:
  int File = -1;
  ff_effect Effect{};
};

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}
double Worst(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}
} // namespace

class PidRoads : public testing::TestWithParam<bool>
{
protected:
  std::unique_ptr<Road> Make() const
  {
    return GetParam() ? std::unique_ptr<Road>(new Evdev)
                      : std::unique_ptr<Road>(new Hidraw(this->Plug.GetNode()));
  }
  double GetPush() const { return this->Model.GetForce()[0]; }
  bool HasArrived(int level) const
  {
    const std::vector<std::uint8_t> last = this->Model.GetLast(5);
    return last.size() == 4 && last[2] == (level & 0xFF) && last[3] == level >> 8;
  }

  OpenFfboardModel Model;
  EmulatedHid Plug{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
};

TEST_P(PidRoads, LatencyAndRate)
{
  const std::unique_ptr<Road> road = this->Make();
  ASSERT_TRUE(Eventually([&] { return road->Open(); }));
  constexpr int times = 300;
  std::vector<double> calls;
  std::vector<double> arrivals;
  for (int i = 1; i <= times; ++i)
  {
    const int level = 20 * i;
    ASSERT_TRUE(road->Refresh());
    usleep(5000);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_TRUE(road->Push(level));
    calls.push_back(Since(begin));
    while (!this->HasArrived(level) && Since(begin) < 60.0)
    {
      usleep(10);
    }
    ASSERT_TRUE(this->HasArrived(level));
    arrivals.push_back(Since(begin));
  }
  std::cout << road->GetName() << ": call median " << 1e3 * Median(calls) << " ms, worst "
            << 1e3 * Worst(calls) << "; at the device median " << 1e3 * Median(arrivals)
            << " ms, worst " << 1e3 * Worst(arrivals) << "\n";
  const std::vector<std::uint8_t> effect = this->Model.GetLast(1);
  std::cout << road->GetName() << ": Set Effect";
  for (const std::uint8_t byte : effect)
  {
    std::cout << ' ' << int{ byte };
  }
  std::cout << "; Device Control";
  for (const std::uint8_t byte : this->Model.GetLast(12))
  {
    std::cout << ' ' << int{ byte };
  }
  std::cout << "\n";

  // Send once a millisecond, and then as fast as possible (pause in us).
  for (const int pause : { 1000, 0 })
  {
    const int before = this->Model.CountOutputs();
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i)
    {
      ASSERT_TRUE(road->Push(i % 2 == 0 ? 1000 + i : -1000 - i));
      usleep(static_cast<useconds_t>(pause));
    }
    const double asked = Since(begin);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    std::cout << road->GetName() << ": " << times / asked << " updates/s asked, "
              << this->Model.CountOutputs() - before << " of " << times << " reached the device\n";
  }
}

TEST_P(PidRoads, ASignThatBothShare)
{
  const std::unique_ptr<Road> road = this->Make();
  ASSERT_TRUE(Eventually([&] { return road->Open(); }));
  EXPECT_TRUE(road->Push(Full / 2) && road->Refresh());
  EXPECT_TRUE(Eventually(
    [&]
    {
      road->Refresh();
      return this->GetPush() < -0.4 * FfbHandle::FullScale;
    }))
    << "to the left, from the right";
}

TEST_P(PidRoads, DeathOfTheHost)
{
  for (const int signal : { SIGKILL, SIGSTOP })
  {
    const std::unique_ptr<Road> road = this->Make();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
      while (!road->Open())
      {
        usleep(5000);
      }
      for (;;)
      {
        road->Push(-Full / 2);
        road->Refresh();
        usleep(20000);
      }
    }
    ASSERT_TRUE(Eventually([&] { return this->GetPush() > 0.4 * FfbHandle::FullScale; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const auto begin = std::chrono::steady_clock::now();
    kill(child, signal);
    // Measure by the model's own clock as well, because the model runs slower on a slow machine.
    const int time = this->Model.GetClock();
    EXPECT_TRUE(Eventually([&] { return this->GetPush() == 0.0; }));
    std::cout << (GetParam() ? "evdev" : "hidraw") << ": "
              << (signal == SIGKILL ? "killed" : "stopped") << ", force for " << 1e3 * Since(begin)
              << " ms more, " << this->Model.GetClock() - time << " ms of the device\n";
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(this->GetPush(), 0.0);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(HidrawAndEvdev, PidRoads, testing::Bool());
} // namespace machinetest
