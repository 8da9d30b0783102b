// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a file that is not a recording is refused, with one error and without force. */

#include "ReplayRig.h"

#include <sys/stat.h>
#include <unistd.h>

using namespace devicetest;

TEST_F(Replay, RefusesEverythingElseWithOneClearError)
{
  for (const char* id : { "", "nothing", "replay:", "replay:/nowhere/at/all.vtp", "replay:a.txt" })
  {
    EXPECT_FALSE(this->Device->Open(id)) << id;
    this->ExpectError("");
  }
  EXPECT_FALSE(this->Device->Open(nullptr));
  this->ExpectError("virtual");
  for (const char* ending : { ".vtp", ".csv" })
  {
    const std::string file = this->File("Good") + ending;
    this->Record(file);
    const std::string good = Load(file);
    this->ExpectRefused(ending, "");
    this->ExpectRefused(ending, "\x89PNG\r\n\x1a\n no recording at all");
    for (const double share : { 0.01, 0.3, 0.6, 0.95 })
    {
      const auto cut = static_cast<std::size_t>(share * static_cast<double>(good.size()));
      // Cuts a table within the first columns of a row. A cut in the last column would leave a
      // valid number.
      const std::size_t row = good.rfind('\n', cut);
      const bool isTable = ending == std::string(".csv") && row != std::string::npos;
      this->ExpectRefused(ending, good.substr(0, isTable ? row + 20 : cut));
    }
  }
}

TEST_F(Replay, RefusesTablesWithBadNumbers)
{
  const std::string head = "Time (s),Tip x (world),Tip y (world),Tip z (world)\n";
  this->ExpectRefused(".csv", head);
  this->ExpectRefused(".csv", head + "0,1,2,3\n0.001,1,nan,3\n0.002,1,2,3\n");
  this->ExpectRefused(".csv", head + "0,1,2,3\n0.001,1,inf,3\n0.002,1,2,3\n");
  this->ExpectRefused(".csv", head + "0,1,2,3\n0.002,1,2,3\n0.001,1,2,3\n");
  this->ExpectRefused(".csv", head + "0,1,2,3\n0.001,1,2\n");
  this->ExpectRefused(".csv", head + "0,1,2,3\n0.001,one,2,3\n");
  this->ExpectRefused(".csv", "a,b\n1,2\n3,4\n");
}

TEST_F(Replay, RefusesWhatIsNoFile)
{
  // Opening a pipe without a writer, or reading a device to its end, would never return.
  for (const char* const ending : { ".vtp", ".csv" })
  {
    const std::string name = this->File("NoFile") + ending;
    const auto refuse = [&](const char* words)
    {
      EXPECT_FALSE(this->Device->Open(("replay:" + name).c_str())) << name;
      ASSERT_EQ(this->Log.Errors.size(), 1U);
      EXPECT_NE(this->Log.Errors[0].find(name), std::string::npos) << this->Log.Errors[0];
      this->ExpectError(words);
      unlink(name.c_str());
    };
    ASSERT_EQ(mkfifo(name.c_str(), 0600), 0);
    refuse("is a pipe");
    ASSERT_EQ(symlink("/dev/zero", name.c_str()), 0);
    refuse("is a device");
    ASSERT_EQ(symlink("/", name.c_str()), 0);
    refuse("is a folder");
  }
}
