// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Tests the output on a real sound server, and a server that is missing, dies or hangs. The class
/// comment of ContactSound gives the expected pitch, 500 Hz sqrt(12) for bone.

#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/Sound/SoundStream.h"
#include "SoundServer.h"
#include "Spectrum.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>

using namespace soundtest;
using Explore::SoundOutput;
using Explore::SoundStream;
using Explore::SoundTick;

namespace
{

/** Taps on bone three times a second, in bursts of 20 ms, while `goesOn` is true. */
template <typename F>
void Tap(SoundStream& stream, F&& goesOn)
{
  static int next = 0;
  while (goesOn())
  {
    for (int i = 0; i < 20; ++i, ++next)
    {
      SoundTick tick;
      tick.Time = 0.001 * next;
      if (next % 320 < 20)
      {
        tick.Contact = Explore::SurfaceContact::Sticking;
        tick.NormalForce = 0.1;
        tick.Stiffness = 400.0;
        tick.Strength = 12.0;
      }
      stream.Push(tick);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void TapFor(SoundStream& stream, int bursts)
{
  Tap(stream, [&bursts] { return bursts-- > 0; });
}

void TapUntilItPlays(SoundStream& stream)
{
  Tap(stream, [] { return SoundServer::ListStreams().empty(); });
}

std::string WaitForTrouble(SoundStream& stream, SoundOutput& output)
{
  std::string trouble;
  Tap(stream, [&] { return (trouble = output.DrainTrouble()).empty(); });
  return trouble;
}

class Output : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasSoundServer())
    {
      GTEST_SKIP() << "there is no sound server; Testing/run.sh installs one";
    }
    this->Server = std::make_unique<SoundServer>();
  }

  std::unique_ptr<SoundServer> Server;
  SoundStream Stream{ RATE };
};

} // namespace

TEST_F(Output, IsWhatWasRendered)
{
  constexpr std::size_t BYTES = 2 * sizeof(float) * static_cast<std::size_t>(RATE); // 2 s
  const std::string file = TemporaryPath("heard");
  {
    const auto output = SoundOutput::Open(this->Stream);
    TapUntilItPlays(this->Stream);
    EXPECT_EQ(SoundServer::ListStreams().find('\n'), SoundServer::ListStreams().rfind('\n'));
    Program recorder(SoundServer::RecorderWords(), file);
    Tap(this->Stream,
      [&file]
      { return !std::filesystem::exists(file) || std::filesystem::file_size(file) < BYTES; });
    recorder.End(SIGTERM);
    EXPECT_EQ(output->DrainTrouble(), "");
  }
  EXPECT_EQ(SoundServer::ListStreams(), "") << "it ends with the output";
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  std::vector<float> heard(bytes.size() / sizeof(float));
  std::memcpy(heard.data(), bytes.data(), heard.size() * sizeof(float));
  EXPECT_GT(*std::max_element(heard.begin(), heard.end()), 0.2f);
  EXPECT_LE(*std::max_element(heard.begin(), heard.end()), 0.3f) << "0.6 J / (J + 0.1 N)";
  // Analyse a single click, since several clicks interfere.
  const auto click = std::find_if(heard.begin(), heard.end(), [](float x) { return x > 0.15f; });
  std::vector<float> one(click, std::min(click + 4000, heard.end()));
  const double pitch = 500.0 * std::sqrt(12.0);
  EXPECT_NEAR(FindPeak(one, 0.8 * pitch, 1.25 * pitch, 0.001 * pitch), pitch, 0.01 * pitch);
  EXPECT_GT(std::count(heard.begin(), heard.end(), 0.0f), static_cast<int>(RATE) / 4)
    << "silent between them";
}

TEST_F(Output, TellsOnceThatThereIsNoServer)
{
  this->Server->Server.End(SIGTERM);
  const auto output = SoundOutput::Open(this->Stream);
  EXPECT_NE(WaitForTrouble(this->Stream, *output), "");
  TapFor(this->Stream, 20);
  EXPECT_EQ(output->DrainTrouble(), "");
}

TEST_F(Output, TellsOnceThatTheServerDied)
{
  const auto output = SoundOutput::Open(this->Stream);
  TapUntilItPlays(this->Stream);
  EXPECT_EQ(output->DrainTrouble(), "");
  this->Server->Server.End(SIGKILL);
  EXPECT_NE(WaitForTrouble(this->Stream, *output), "");
  TapFor(this->Stream, 20);
  EXPECT_EQ(output->DrainTrouble(), "");
}

TEST_F(Output, DoesNotWaitForAServerThatHangs)
{
  {
    const auto output = SoundOutput::Open(this->Stream);
    TapUntilItPlays(this->Stream);
    this->Server->Server.Signal(SIGSTOP);
    TapFor(this->Stream, 20);
  }
  {
    const auto output = SoundOutput::Open(this->Stream); // the server does not respond
    TapFor(this->Stream, 20);
    EXPECT_EQ(output->DrainTrouble(), "");
  }
  this->Server->Server.Signal(SIGCONT);
}
