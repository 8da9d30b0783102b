// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the recorder without a device: its memory, its bytes per tick, and journals that end at any
 * byte.
 */

#include "RecorderRig.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Device/Recording/TickCollector.h"
#include "VTK/Tools/ToolArrays.h"

#include <algorithm>

using namespace recordertest;

namespace
{

/// Returns the resident memory of this process (bytes).
double Resident()
{
  std::ifstream stream("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  stream >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

TEST_F(Recorder, TakesBoundedMemoryAndAtMost300BytesATick)
{
  constexpr int ticks = 60000;
  // These ticks would take 110 MB in memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr double most = 64e6; // sanitizers need additional memory
#else
  constexpr double most = 16e6;
#endif
  HapticRecording recording;
  this->Start(recording, this->File);
  const double before = Resident();
  double largest = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    this->Push(recording, this->Source.Next());
    largest = i % 1000 == 0 ? std::max(largest, Resident()) : largest;
  }
  this->Finish(recording);
  largest = std::max(largest, Resident());
  EXPECT_LT(largest - before, most);
  const double bytes = static_cast<double>(vtksys::SystemTools::FileLength(this->File)) / ticks;
  RecordProperty("BytesPerTick", std::to_string(bytes));
  EXPECT_LT(bytes, 300.0);
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), ticks);
}

TEST_F(Recorder, KeepsForReadersATenthOfAState)
{
  EXPECT_LE(sizeof(StateRow) * TickCollector::MostStates, 20e6);
  EXPECT_LE(sizeof(RecordingRow) * HapticRecording::MostWaiting, 7e6);
}

TEST_F(Recorder, HasRoomForTheNumbersOfAllTools)
{
  int numbers = 0;
  for (const ToolColumn* const array : GetToolArrays())
  {
    numbers += array->IsRecorded ? array->Components : 0;
  }
  EXPECT_GE(numbers, 5) << "ToolOrientation and RemovedVolume";
  EXPECT_LE(numbers, MostToolNumbers);
}

TEST_F(Recorder, WritesWhatTheTicksAre)
{
  // Recordings with no tick, one tick, a part of a group of 256, whole groups, and one additional
  // tick.
  for (const int count : { 0, 1, 2, 100, 256, 512, 513 })
  {
    Ticks source;
    HapticRecording recording;
    this->Start(recording, this->File);
    std::vector<ServoSnapshot> ticks;
    for (int i = 0; i < count; ++i)
    {
      ticks.push_back(source.Next());
      this->Push(recording, ticks.back());
    }
    this->Finish(recording);
    const auto trace = Read(this->File);
    ASSERT_EQ(trace->GetNumberOfPoints(), count);
    ASSERT_EQ(trace->GetNumberOfCells(), count > 1 ? 1 : 0);
    for (int a = 0; a < trace->GetPointData()->GetNumberOfArrays(); ++a)
    {
      EXPECT_EQ(trace->GetPointData()->GetArray(a)->GetNumberOfTuples(), count);
    }
    const std::vector<const ToolColumn*>& ofTools = GetToolArrays();
    const auto recorded = std::count_if(
      ofTools.begin(), ofTools.end(), [](const ToolColumn* array) { return array->IsRecorded; });
    EXPECT_EQ(trace->GetPointData()->GetNumberOfArrays(), 36 + recorded);
    double work = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const TickRecord& r = ticks[i].Record;
      const auto number = [&](const char* name, int c)
      { return trace->GetPointData()->GetArray(name)->GetComponent(i, c); };
      EXPECT_EQ(number("Tick", 0), i);
      EXPECT_EQ(number("Time", 0), ticks[i].Time);
      EXPECT_EQ(number("DeviceTip", 1), r.Tip.Y);
      EXPECT_EQ(number("Tip", 2), 1000.0 * r.Tip.Z);
      EXPECT_EQ(trace->GetPoint(i)[0], 1000.0 * r.Proxy.X);
      EXPECT_EQ(number("Command", 2), ticks[i].Command.Z);
      EXPECT_EQ(number("TorqueCommand", 0), ticks[i].Torque.X);
      EXPECT_EQ(number("Torque", 1), r.Torque.Y);
      EXPECT_EQ(number("ToolOrientation", 2), r.ToolOrientation.Y);
      EXPECT_EQ(number("DeviceOrientation", 0), ticks[i].Orientation.W);
      EXPECT_EQ(number("DeviceOrientation", 3), ticks[i].Orientation.Z);
      EXPECT_EQ(number("Orientation", 3), ticks[i].Orientation.Z)
        << "the world's axes are the same";
      EXPECT_EQ(number("SurfaceValue", 0), r.SurfaceValue);
      EXPECT_EQ(number("Contact", 0), 2.0);
      EXPECT_EQ(number("Enabled", 0), 1.0);
      EXPECT_EQ(number("Share", 0), 0.75);
      EXPECT_EQ(number("Reason", 0), static_cast<double>(GateReason::Rising));
      work += i > 0
        ? 0.5 * Dot(r.Force + ticks[i - 1].Record.Force, r.Tip - ticks[i - 1].Record.Tip)
        : 0.0;
      EXPECT_EQ(number("Energy", 0), work);
    }
    vtkFieldData* const fields = trace->GetFieldData();
    EXPECT_EQ(fields->GetArray("DeviceToWorld")->GetNumberOfTuples(), count > 0 ? 1 : 0);
    EXPECT_EQ(fields->GetArray("InitialState")->GetNumberOfTuples(), count > 0 ? 1 : 0);
    EXPECT_EQ(
      fields->GetAbstractArray("Settings")->GetVariantValue(0).ToString(), "settings <&> \xFF");
  }
}

TEST_F(Recorder, KeepsEveryPlacement)
{
  // Records more placements than fit into a block, and several placements in one group of ticks.
  constexpr int moves = 600;
  HapticRecording recording;
  this->Start(recording, this->File);
  for (int i = 0; i < moves; ++i)
  {
    ServoSnapshot tick = this->Source.Next();
    tick.Generation = static_cast<std::uint64_t>(i) + 2;
    recording.AddModel(tick.Generation,
      std::make_shared<const HapticModel>(
        *this->Model,
        [i]
        {
          Affine3 map;
          map.Linear = 1000.0 * Matrix3{};
          map.Offset.X = i;
          return map;
        }(),
        ForceCaps{ static_cast<double>(1 + i), 0.5 }));
    this->Push(recording, tick);
  }
  this->Finish(recording);
  const auto trace = Read(this->File);
  vtkDataArray* const matrices = trace->GetFieldData()->GetArray("DeviceToWorld");
  ASSERT_EQ(matrices->GetNumberOfTuples(), moves);
  vtkDataArray* const caps = trace->GetFieldData()->GetArray("Caps");
  ASSERT_EQ(caps->GetNumberOfTuples(), moves);
  EXPECT_EQ(caps->GetComponent(moves - 1, 0), moves);
  EXPECT_EQ(caps->GetComponent(moves - 1, 1), 0.5);
  for (int i = 0; i < moves; ++i)
  {
    EXPECT_EQ(matrices->GetComponent(i, 3), i);
    EXPECT_EQ(trace->GetPointData()->GetArray("Placement")->GetComponent(i, 0), i);
  }
}

TEST_F(Recorder, ReadsAJournalThatEndsAnywhere)
{
  const std::string journal = this->File + ".part";
  std::string whole;
  {
    HapticRecording recording;
    this->Start(recording, this->File);
    for (int i = 0; i < 600; ++i)
    {
      this->Push(recording, this->Source.Next());
    }
  }
  whole = Load(journal);
  ASSERT_GT(whole.size(), 10000U);
  vtkIdType before = 0;
  for (int share = 0; share <= 40; ++share)
  {
    const std::size_t cut = whole.size() * static_cast<std::size_t>(share) / 40;
    // A file that was growing when the power failed may end with zeros.
    const std::string zeros(share % 2 ? 5000 : 0, '\0');
    std::ofstream(journal, std::ios::binary) << whole.substr(0, cut) << zeros;
    std::string error;
    if (!WriteRecording(journal, this->File, error))
    {
      EXPECT_NE(error.find("is not the unfinished recording"), std::string::npos) << error;
      EXPECT_LT(share, 3) << "what the recording is about comes first";
      continue;
    }
    const auto trace = Read(this->File);
    const vtkIdType ticks = trace->GetNumberOfPoints();
    EXPECT_TRUE(share == 40 ? ticks == 600 : ticks % 256 == 0) << ticks;
    EXPECT_GE(ticks, before);
    before = ticks;
    for (vtkIdType i = 0; i < ticks; ++i)
    {
      ASSERT_EQ(trace->GetPointData()->GetArray("Tick")->GetComponent(i, 0), i);
    }
  }
  // Changed bytes in the middle of a journal must cause an error, and preserve the journal and an
  // earlier file with the recording's name.
  for (std::size_t at = 5; at < whole.size(); at += whole.size() / 50)
  {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ 0x10);
    std::ofstream(journal, std::ios::binary) << other;
    std::ofstream(this->File) << "good";
    std::string error;
    EXPECT_FALSE(WriteRecording(journal, this->File, error)) << at;
    EXPECT_NE(error.find(journal), std::string::npos) << error;
    EXPECT_EQ(Load(this->File), "good");
    unlink(this->File.c_str());
    EXPECT_FALSE(WriteRecording(journal, this->File, error)) << at;
    EXPECT_EQ(Load(journal), other);
    if (Exists(this->File))
    {
      const vtkIdType ticks = Read(this->File)->GetNumberOfPoints();
      EXPECT_LT(ticks, 600);
      EXPECT_NE(error.find("the " + std::to_string(ticks) + " ticks before"), std::string::npos)
        << error;
    }
  }
}

TEST_F(Recorder, SaysHowManyTicksWereLost)
{
  HapticRecording recording;
  this->Start(recording, this->File);
  this->Push(recording, this->Source.Next());
  recording.SetMissed(3);
  EXPECT_EQ(recording.GetLostTicks(), 3U);
  this->Finish(recording);
  EXPECT_EQ(Read(this->File)->GetFieldData()->GetArray("LostTicks")->GetComponent(0, 0), 3.0);
}

TEST(HapticFiles, PrintsWhatIsNotUtf8)
{
  // The examples are from RFC 3629, sections 3 and 7, and from Markus Kuhn's stress test: overlong
  // forms, surrogates, and truncated sequences.
  EXPECT_EQ(Printable("caf\xC3\xA9 \xE6\x97\xA5\xE6\x9C\xAC \xF0\xA3\x8E\xB4"),
    "caf\xC3\xA9 \xE6\x97\xA5\xE6\x9C\xAC \xF0\xA3\x8E\xB4");
  EXPECT_EQ(Printable("\xC0\x80"), "\\xC0\\x80");
  EXPECT_EQ(Printable("\xED\xA0\x80"), "\\xED\\xA0\\x80");
  EXPECT_EQ(Printable("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80");
  EXPECT_EQ(Printable("a\xE6\x97"), "a\\xE6\\x97");
  EXPECT_EQ(Printable("\xFFz"), "\\xFFz");
  const std::string withZero("ui\0nt", 5);
  EXPECT_EQ(Printable(withZero), "ui\\x00nt");
  EXPECT_TRUE(IsUtf8(withZero));
  EXPECT_FALSE(IsUtf8("a\xE6\x97"));
}
