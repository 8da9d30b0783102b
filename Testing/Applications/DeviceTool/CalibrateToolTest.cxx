// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs "volumehaptics-device calibrate" with a simulated handle of known strength and a user who
 * follows all requests.
 */

#include "Devices/Common/DeviceKind.h"
#include "Emulators/HungHandle.h"
#include "Rigs/TemporaryFolder.h"
#include "ToolRig.h"

#include <vtkHapticDevice.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <mutex>

using namespace emulated;
using namespace VolumeHaptics;

namespace
{

/// State that the devices of the kind "hung" share with the test.
struct Bench
{
  std::mutex Lock;
  HungHandle Handle;
  double LastAsked = 0.0;
  double FirstAsked = -1.0; ///< N; first requested force; negative before the first push
  double LargestAsked = 0.0;
  std::chrono::steady_clock::time_point LastWrite;
  bool HasPaused = false; ///< the servo paused during a push
  std::atomic<bool> IsLost{ false };

  static Bench& Get()
  {
    static Bench bench;
    return bench;
  }
  void Reset(const HungHandle& handle = {})
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    this->Handle = handle;
    this->HasPaused = false;
    this->LastAsked = this->LargestAsked = 0.0;
    this->FirstAsked = -1.0;
    this->IsLost = false;
  }
};

/// The servo treats a longer pause as a gap, after which the spring starts again (SafetyLimits).
constexpr auto LongestTick = std::chrono::milliseconds(20);

class HungDevice : public DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "hung"; }
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits;
    limits.MaximumForce = 8.0;
    limits.MaximumStiffness = 3000.0;
    limits.WorkspaceRadius = 0.04;
    return limits;
  }
  DeviceCondition GetCondition() override
  {
    DeviceCondition condition;
    condition.Stage = Bench::Get().IsLost ? DeviceStage::Lost : DeviceStage::Ready;
    return condition;
  }
  std::string GetIdentity() const override { return "hung:1"; }
  void SetForceScale(double scale) noexcept override { this->Scale = scale; }
  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    Bench& bench = Bench::Get();
    const std::lock_guard<std::mutex> guard(bench.Lock);
    const Triple tip = bench.Handle.GetTip();
    sample.Tip = { tip[0], tip[1], tip[2] };
    sample.Fresh = true;
    this->Period = period;
    return bench.IsLost ? DeviceState::Lost : DeviceState::Running;
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    Bench& bench = Bench::Get();
    const std::lock_guard<std::mutex> guard(bench.Lock);
    const double s = 1.0 / this->Scale;
    const auto now = std::chrono::steady_clock::now();
    bench.HasPaused =
      bench.HasPaused || (bench.LastAsked > 0.0 && now - bench.LastWrite > LongestTick);
    bench.LastWrite = now;
    bench.Handle.Step({ s * force.X, s * force.Y, s * force.Z }, this->Period);
    bench.LastAsked = s * Norm(force);
    bench.FirstAsked = bench.FirstAsked < 0.0 ? bench.LastAsked : bench.FirstAsked;
    bench.LargestAsked = std::max(bench.LargestAsked, bench.LastAsked);
    return bench.IsLost ? DeviceState::Lost : DeviceState::Running;
  }
  void Quench() noexcept override {}

private:
  std::atomic<double> Scale{ 1.0 };
  double Period = 1e-3;
};

bool AddKind()
{
  static const bool added = vtkHapticDevice::AddDeviceKind({ "hung",
    [] {
      return std::vector<DeviceListing>{ { "hung:0", "A simulated handle", "available",
        "hung:1" } };
    },
    [](const std::string&, const DeviceOptions&, std::string&)
    { return std::make_unique<HungDevice>(); } });
  return added;
}

/// The tool's output. Passes each line to the simulated user as soon as it is flushed.
class Screen : public std::streambuf
{
public:
  const std::string& GetText() const { return this->Text; }
  std::string GetLastLine() const
  {
    const std::string text = this->Text.substr(0, this->Text.find_last_not_of('\n') + 1);
    return text.substr(text.rfind('\n') + 1);
  }
  std::function<void(const std::string&)> Shows; ///< called with each flushed line

protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override
  {
    this->Text.append(text, static_cast<std::size_t>(size));
    return size;
  }
  int overflow(int c) override
  {
    this->Text += static_cast<char>(c);
    return c;
  }
  int sync() override
  {
    this->Shows(this->GetLastLine());
    return 0;
  }

private:
  std::string Text;
};

/// A simulated user, who reads the requests, moves and loads the handle accordingly, and types the
/// answers.
class User : public std::streambuf
{
public:
  User(Screen& screen, double weight)
    : Seen(screen)
    , Weight(weight)
  {
    screen.Shows = [this](const std::string& line) { this->Follow(line); };
  }
  std::vector<std::string> Answers; ///< answers to the first questions for grams
  std::string Breaks;               ///< the device is lost when this request appears

protected:
  /// Returns a line of input whenever the tool reads one.
  int underflow() override
  {
    const bool wantsGrams = this->Seen.GetLastLine().find("How many grams") != std::string::npos;
    this->Line = "\n";
    if (wantsGrams && this->Typed < this->Answers.size())
    {
      this->Line = this->Answers[this->Typed++] + "\n";
    }
    else if (wantsGrams)
    {
      this->Line = std::to_string(static_cast<int>(this->Grams)) + "\n";
    }
    this->setg(this->Line.data(), this->Line.data(), this->Line.data() + this->Line.size());
    return this->Line[0];
  }

private:
  void Follow(const std::string& line)
  {
    const auto asks = [&line](const char* words) { return line.find(words) != std::string::npos; };
    Bench& bench = Bench::Get();
    const std::lock_guard<std::mutex> guard(bench.Lock);
    HungHandle& handle = bench.Handle;
    this->Grams = this->IsReading ? handle.GetShown() : this->Grams;
    this->IsReading = asks("Read the scale now");
    bench.IsLost = bench.IsLost || (!this->Breaks.empty() && asks(this->Breaks.c_str()));
    handle.IsHeld = asks("Hold the device") || asks("force ends") || asks("Confirming") ||
      asks("press Enter") || asks("How many grams") || asks("not a number");
    handle.Weight = asks("Hang the weight") || asks("Reading with the") ? this->Weight : 0.0;
  }

  const Screen& Seen;
  const double Weight; // kg, of the weight that the user hangs
  std::string Line;
  std::size_t Typed = 0;
  double Grams = 0.0;     ///< the scale's last reading
  bool IsReading = false; ///< the user looks at the scale
};

class CalibrateToolTest : public testing::Test
{
protected:
  CalibrateToolTest()
  {
    EXPECT_TRUE(AddKind());
    Bench::Get().Reset();
    setenv("VOLUMEHAPTICS_DEVICES", this->File.c_str(), 1);
    std::ofstream(this->File) << "hung:1 confirmed=2026-11-20\n";
  }
  /// Runs the tool. Repeats the run if the machine paused the process during the measurement.
  int Run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), { "calibrate", "hung" });
    const HungHandle handle = Bench::Get().Handle;
    const std::string file = this->ReadFile();
    int result = this->RunOnce(arguments);
    for (int i = 0; i < 4 && Bench::Get().HasPaused; ++i)
    {
      Bench::Get().Reset(handle);
      std::ofstream(this->File) << file;
      result = this->RunOnce(arguments);
    }
    return result;
  }
  int RunOnce(const std::vector<std::string>& arguments)
  {
    Screen screen;
    std::ostringstream errors;
    int result = 0;
    {
      User user(screen, this->Weight);
      user.Answers = this->Answers;
      user.Breaks = this->Breaks;
      std::istream in(&user);
      std::ostream out(&screen);
      result = RunDeviceTool(arguments, in, out, errors);
    }
    this->Out = screen.GetText();
    this->Errors = errors.str();
    EXPECT_EQ(Bench::Get().LastAsked, 0.0) << "the last force";
    EXPECT_LE(Bench::Get().FirstAsked, 0.0) << "the first force";
    return result;
  }
  std::string ReadFile() const
  {
    std::ifstream in(this->File);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  /// Returns the calibration factor in the file of devices, or 0 if there is none.
  double GetStored() const
  {
    const std::string all = this->ReadFile();
    const std::size_t at = all.find("scale=");
    return at == std::string::npos ? 0.0 : std::stod(all.substr(at + 6));
  }

  const std::string File = TemporaryPath("calibrate.txt");
  double Weight = 0.1; // kg, of the weight that the user hangs
  std::vector<std::string> Answers;
  std::string Breaks;
  std::string Out;
  std::string Errors;
};

} // namespace

TEST_F(CalibrateToolTest, ConfirmsFirstAndFindsTheStrengthByAWeight)
{
  std::ofstream(this->File) << "";
  Bench::Get().Handle.Strength = 0.4;
  ASSERT_EQ(this->Run({ "--weight", "100" }), 0) << this->Errors << this->Out;
  EXPECT_NE(this->Out.find("its force uncalibrated"), std::string::npos) << this->Out;
  EXPECT_NE(this->Out.find("moves with the force along every axis"), std::string::npos);
  EXPECT_NEAR(this->GetStored() / 0.4, 1.0, 0.03) << this->Out;
  EXPECT_NE(this->ReadFile().find("confirmed="), std::string::npos);
  EXPECT_LE(Bench::Get().LargestAsked, 4.0 + 1e-9) << "half of what the device has";
}

TEST_F(CalibrateToolTest, FindsTheStrengthByAScaleAnew)
{
  std::ofstream(this->File) << "hung:1 confirmed=2026-11-20 scale=1.25 calibrated=2026-11-20\n";
  Bench::Get().Handle.Strength = 1.7;
  Bench::Get().Handle.HasScale = true;
  this->Answers = { "a lot" };
  ASSERT_EQ(this->Run({ "--scale" }), 0) << this->Errors << this->Out;
  EXPECT_NE(this->Out.find("calibrated 1.25 on 2026-11-20"), std::string::npos) << this->Out;
  EXPECT_NE(this->Out.find("\"a lot\" is not a number of grams"), std::string::npos) << this->Out;
  EXPECT_NEAR(this->GetStored() / 1.7, 1.0, 0.03) << this->Out;
}

TEST_F(CalibrateToolTest, StoresNothingOfNumbersThatAreNone)
{
  Bench::Get().Handle.HasScale = true;
  this->Answers = { "heavy", "1e9", "12 kg" };
  EXPECT_EQ(this->Run({ "--scale" }), 1);
  EXPECT_NE(this->Errors.find("No number of grams"), std::string::npos) << this->Errors;
  EXPECT_EQ(this->GetStored(), 0.0);
}

TEST_F(CalibrateToolTest, StoresNothingIfNoWeightIsHung)
{
  this->Weight = 0.0;
  EXPECT_EQ(this->Run({ "--weight", "100", "--seconds", "4" }), 1);
  EXPECT_NE(this->Errors.find("Nothing has changed for 4 s"), std::string::npos) << this->Errors;
  EXPECT_EQ(this->GetStored(), 0.0);
}

TEST_F(CalibrateToolTest, StoresNothingIfTheFactorIsNone)
{
  // The user says 3 kg but hangs 100 g.
  EXPECT_EQ(this->Run({ "--weight", "3000" }), 1);
  EXPECT_NE(this->Errors.find("0.1 to 10"), std::string::npos) << this->Errors;
  EXPECT_EQ(this->GetStored(), 0.0);
}

TEST_F(CalibrateToolTest, StoresNothingIfTheDeviceIsLost)
{
  this->Breaks = "Reading without the weight";
  EXPECT_EQ(this->Run({ "--weight", "100" }), 1);
  EXPECT_NE(this->Errors, "");
  EXPECT_EQ(this->GetStored(), 0.0);
}

TEST_F(CalibrateToolTest, HasNothingToDoForADeviceWithoutForce)
{
  std::istringstream in("\n");
  std::ostringstream out;
  std::ostringstream errors;
  EXPECT_EQ(RunDeviceTool({ "calibrate", "virtual", "--scale" }, in, out, errors), 1);
  EXPECT_NE(errors.str().find("nothing to calibrate"), std::string::npos) << errors.str();
}
