// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that an unusable setup causes one error with the file's name, the key and the remedy, and
 * changes nothing.
 */

#include "Rigs/FullDisk.h"
#include "SetupErrorsRig.h"

#include <filesystem>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>

using namespace setuptest;

TEST_F(SetupErrors, ValuesThatCannotBe)
{
  this->Refuse(this->Haptics(R"("ServoRate":"fast")"), { "Haptics.ServoRate", "\"fast\"", "1 to" });
  this->Refuse(this->Haptics(R"("ServoRate":NaN)"), { "Haptics.ServoRate", "remove this key" });
  this->Refuse(this->Haptics(R"("MaximumForce":-1)"), { "Haptics.MaximumForce", "0 or more" });
  this->Refuse(this->Haptics(R"("ForceFieldGain":Infinity)"), { "Haptics.ForceFieldGain" });
  this->Refuse(this->Haptics(R"("Method":"Penalty")"), { "Haptics.Method", "ForceField" });
  this->Refuse(this->Haptics(R"("Component":1.5)"), { "Haptics.Component", "whole number" });
  this->Refuse(this->Haptics(R"("HideInvisible":1)"), { "Haptics.HideInvisible", "true or false" });
  this->Refuse(this->Haptics(R"("Stiffness":{"Nodes":[[0,1,0.5,0],[1,-5,0.5,0]]})"),
    { "Haptics.Stiffness.Nodes[1][1]", "-5", "0 or more" });
  this->Refuse(
    this->Haptics(R"("Friction":{"Nodes":[[0,1]]})"), { "Friction.Nodes[0]", "4 numbers" });
  this->Refuse(this->Haptics(R"("Friction":{"Nodes":[[1,1,0.5,0],[0,1,0.5,0]]})"),
    { "Haptics.Friction.Nodes[1]", "behind" });
  this->Refuse(this->Haptics(R"("Distinctness":{"Nodes":[[0,1.5,0.5,0]]})"), { "Distinctness" });
  this->Refuse(this->Haptics(R"("Viscosity":3)"), { "Haptics.Viscosity", "object" });
  this->Refuse(this->Haptics(R"("TraceArrays":"Force, Furce")"),
    { "Haptics.TraceArrays", "\"Furce\"", "\"Force\"", "remove this key" });
  this->Refuse(this->Haptics(R"("TraceArrays":["Force"])"), { "Haptics.TraceArrays", "a text" });
  this->Refuse(this->With("ViewAngle", "200"), { "Camera.ViewAngle", "179.9" });
}

TEST_F(SetupErrors, WhatDoesNotGoTogether)
{
  const std::string start = R"({"Format":"VTK Volume Haptics setup","Version":1,)";
  this->Refuse(start + R"("DeviceToWorld":[1,2,3]})", { "DeviceToWorld", "16 numbers" });
  this->Refuse(start + R"("DeviceToWorld":[1,0,0,0,0,1,0,0,0,0,-1,0,0,0,0,1]})",
    { "DeviceToWorld", "uniform, positive scale" });
  this->Refuse(start + R"("Camera":{"Position":[1,2,3],"FocalPoint":[1,2,3]}})", { "FocalPoint" });
  this->Refuse(start + R"("Camera":{"ViewUp":[0,0,0]}})", { "Camera.ViewUp", "direction" });
}

TEST_F(SetupErrors, FilesThatAreNoSetup)
{
  this->Refuse(this->With("Version", "2"), { "newer", "Update" });
  this->Refuse(this->With("Version", "\"1\""), { "Version" });
  this->Refuse(this->With("Format", "\"other\""), { "not a setup" });
  this->Refuse("", { "can't be" });
  this->Refuse("not a setup", { "not JSON" });
  this->Refuse("[1, 2]", { "not a setup" });
  this->Refuse(this->Good.substr(0, this->Good.size() / 2), { "not JSON", "Line" });
  this->Refuse(this->Good + "{}", { "not JSON" });
  // Freeing deeply nested lists is recursive, and stacks may be small, so such lists must be
  // refused.
  this->Refuse(this->Good.substr(0, this->Good.rfind('}')) + ",\"Notes\":" + std::string(200, '[') +
      std::string(200, ']') + "}",
    { "not JSON", "nested more than 64 deep" });
  this->Refuse(std::string(5000, '['), { "not JSON" });
  EXPECT_FALSE(this->Target.Setup->Load("/no/such/folder/setup.json"));
  this->ExpectError({ "/no/such/folder/setup.json", "exists" });
  EXPECT_FALSE(this->Target.Setup->Load(testing::TempDir().c_str()));
  this->ExpectError({ "can't be read" });
  EXPECT_FALSE(this->Target.Setup->Load(nullptr));
  this->ExpectError({ "no file" });
}

TEST_F(SetupErrors, FilesThatHaveNoEnd)
{
  const auto refuse = [this](const std::string& file, const char* words)
  {
    EXPECT_FALSE(this->Target.Setup->Load(file.c_str())) << file;
    this->ExpectError({ file, words });
  };
  refuse("/dev/zero", "is a device");
  const std::string pipe = File("Pipe.json");
  unlink(pipe.c_str());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  refuse(pipe, "is a pipe");
  EXPECT_FALSE(this->Target.Setup->Save(pipe.c_str()));
  this->ExpectError({ pipe, "is a pipe" });
  unlink(pipe.c_str());
  // Makes a sparse file of 2 GiB; truncate() extends the setup without writing the added bytes.
  const std::string large = File("Large.json");
  std::ofstream(large) << this->Good;
  ASSERT_EQ(truncate(large.c_str(), off_t{ 1 } << 31), 0);
  refuse(large, "larger than 16 MiB");
  unlink(large.c_str());
}

TEST_F(SetupErrors, NamesAndTextsThatAreNotUtf8)
{
  // Bytes that are not UTF-8 are printed in hexadecimal, because Python discards messages with such
  // bytes.
  EXPECT_FALSE(this->Target.Setup->Load("/no/such/\xE4.json"));
  this->ExpectError({ "/no/such/\\xE4.json" });
  EXPECT_FALSE(this->Target.Setup->Save("/no/such/\xE4.json"));
  this->ExpectError({ "/no/such/\\xE4.json" });
  this->Refuse(this->Haptics("\"Method\":\"\xE4\xFF\""), { "Haptics.Method" });
}

TEST_F(SetupErrors, KeysThatAreNotKnownAreIgnored)
{
  const std::string file = File("Unknown.json");
  std::ofstream(file) << this->Haptics(R"("Colour":"blue","ServoRate":500)");
  EXPECT_TRUE(this->Target.Setup->Load(file.c_str()));
  EXPECT_EQ(this->Target.Filter->GetServoRate(), 500.0);
  EXPECT_EQ(this->Target.Filter->GetKernelRadius(), 7);
}

TEST_F(SetupErrors, Saving)
{
  EXPECT_FALSE(this->Target.Setup->Save("/no/such/folder/setup.json"));
  this->ExpectError({ "/no/such/folder/setup.json", "folder exists" });
  EXPECT_FALSE(this->Target.Setup->Save(""));
  this->ExpectError({ "no file" });
  // A full disk must not destroy the valid file.
  const std::string good = File("Good.json");
  chmod(good.c_str(), 0640);
  {
    const devicetest::FullDisk full(100);
    EXPECT_FALSE(this->Target.Setup->Save(good.c_str()));
  }
  this->ExpectError({ good, "Make room" });
  EXPECT_EQ(Read(good), this->Good);
  // A link must stay a link, and its target must keep its permissions.
  const std::string link = File("Link.json");
  unlink(link.c_str());
  ASSERT_EQ(symlink(good.c_str(), link.c_str()), 0);
  EXPECT_TRUE(this->Target.Setup->Save(link.c_str()));
  struct stat status;
  ASSERT_EQ(lstat(link.c_str(), &status), 0);
  EXPECT_TRUE(S_ISLNK(status.st_mode));
  ASSERT_EQ(stat(good.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
  unlink(link.c_str());
  // Saving to a link without a target must create the target.
  const std::string later = File("Later.json");
  ASSERT_EQ(symlink("Later.json", link.c_str()), 0);
  EXPECT_TRUE(this->Target.Setup->Save(link.c_str()));
  EXPECT_EQ(Read(later), this->Good);
  ASSERT_EQ(lstat(link.c_str(), &status), 0);
  EXPECT_TRUE(S_ISLNK(status.st_mode));
  unlink(link.c_str());
  // A setting that could not be loaded again must not be saved, and the valid file must remain.
  this->Target.Filter->SetForceFieldGain(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(this->Target.Setup->Save(File("Good.json").c_str()));
  this->ExpectError({ "Haptics.ForceFieldGain", "not saved" });
  EXPECT_EQ(Read(File("Good.json")), this->Good);
}

TEST_F(SetupErrors, SavingKeepsOwnerAndGroup)
{
  if (geteuid() != 0)
  {
    GTEST_SKIP() << "only root can give files away";
  }
  constexpr uid_t alice = 60001;
  constexpr gid_t staff = 60002;
  const std::string file = File("Alices.json");
  const auto expect = [&](mode_t mode)
  {
    struct stat status;
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, alice);
    EXPECT_EQ(status.st_gid, staff);
    EXPECT_EQ(status.st_mode & 07777, mode);
  };
  std::ofstream(file) << "old";
  ASSERT_EQ(chown(file.c_str(), alice, staff), 0);
  ASSERT_EQ(chmod(file.c_str(), 04660), 0);
  EXPECT_TRUE(this->Target.Setup->Save(file.c_str()));
  expect(0660);
  EXPECT_EQ(Read(file), this->Good);
  // A user who can write to the file, but is neither its owner nor in its group, can't assign a new
  // file to that group. So the file must be written in place.
  std::ofstream(file) << "old and longer than nothing";
  ASSERT_EQ(chmod(file.c_str(), 0666), 0);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(std::filesystem::path(file).parent_path());
  struct stat folder;
  ASSERT_EQ(stat(".", &folder), 0);
  ASSERT_EQ(chmod(".", 0777), 0);
  ASSERT_EQ(seteuid(65534), 0);
  EXPECT_TRUE(this->Target.Setup->Save("Alices.json"));
  ASSERT_EQ(seteuid(0), 0);
  ASSERT_EQ(chmod(".", folder.st_mode & 07777), 0);
  expect(0666);
  EXPECT_EQ(Read(file), this->Good);
  for (const auto& entry : std::filesystem::directory_iterator("."))
  {
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
  }
  std::filesystem::current_path(before);
}
