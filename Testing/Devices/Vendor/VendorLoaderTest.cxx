// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests which plug-ins are loaded, and the error texts for the others, according to the rules in
 * Documentation/devices.md. File modes are POSIX modes.
 */

#include "VendorRig.h"

#include <fstream>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace vendortest;

namespace
{
class VendorLoader : public testing::Test
{
protected:
  /// Opens the simulated plug-in. Returns the error.
  static std::string Refused(const std::string& id = "vendor:played") { return ErrorOf(id); }
  const PluginFolder Folder;
};
} // namespace

TEST_F(VendorLoader, ListsDevicesOfAllPluginsByNameAndNumber)
{
  this->Folder.Add("played");
  const std::vector<DeviceListing> all = ListVendors();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].Id, "vendor:played:0");
  EXPECT_EQ(all[1].Id, "vendor:played:1");
  EXPECT_EQ(all[1].Name, "Played stylus 1");
  EXPECT_EQ(all[0].State, "available");
  EXPECT_EQ(all[0].Identity, "vendor:played:SN_1_2") << "a word in the user's file of devices";
  EXPECT_EQ(TextOfMissing(), "");
}

TEST_F(VendorLoader, SaysThatNoPluginIsFoundAndWhereOneComesFrom)
{
  EXPECT_TRUE(Has(TextOfMissing(), "Examples/Vendor")) << TextOfMissing();
  unsetenv("VOLUMEHAPTICS_VENDOR_PATH");
  EXPECT_TRUE(Has(TextOfMissing(), "VOLUMEHAPTICS_VENDOR_PATH")) << TextOfMissing();
  EXPECT_TRUE(Has(Refused(), "no folder is searched")) << Refused();
}

TEST_F(VendorLoader, AProgramNamesTheFoldersInstead)
{
  this->Folder.Add("played");
  unsetenv("VOLUMEHAPTICS_VENDOR_PATH");
  DeviceOptions options;
  options.VendorPath = "/nowhere:" + this->Folder.Path.string();
  DeviceBench bench;
  EXPECT_TRUE(bench.Open("vendor:played:1", options)) << bench.Error;
}

TEST_F(VendorLoader, LoadsNothingThatOthersMayWrite)
{
  const fs::path file = this->Folder.Add("played");
  for (const fs::path& open : { file, this->Folder.Path })
  {
    for (const mode_t mode : { 0770, 0702 })
    {
      ASSERT_EQ(chmod(open.c_str(), mode), 0);
      EXPECT_TRUE(Has(Refused(), "chmod go-w")) << Refused();
      EXPECT_TRUE(Has(Refused(), open.c_str())) << Refused();
      EXPECT_TRUE(ListVendors().empty());
      EXPECT_TRUE(Has(TextOfMissing(), "others may write")) << TextOfMissing();
    }
    ASSERT_EQ(chmod(open.c_str(), 0700), 0);
  }
  // Users with write permission for a folder above can replace this folder.
  const fs::path inner = this->Folder.Path / "open" / "inner";
  fs::create_directories(inner);
  fs::rename(file, inner / file.filename());
  setenv("VOLUMEHAPTICS_VENDOR_PATH", inner.c_str(), 1);
  ASSERT_EQ(chmod(inner.parent_path().c_str(), 0777), 0);
  EXPECT_TRUE(Has(Refused(), "others may write")) << Refused();
  // In a folder with the sticky bit, other users can't replace files that they do not own.
  ASSERT_EQ(chmod(inner.parent_path().c_str(), 01777), 0);
  DeviceBench bench;
  EXPECT_TRUE(bench.Open("vendor:played")) << bench.Error;
}

TEST_F(VendorLoader, ALinkIsAsSafeAsItsTarget)
{
  const fs::path file = this->Folder.Add("played");
  const fs::path elsewhere = this->Folder.Path / "elsewhere";
  fs::create_directory(elsewhere);
  fs::rename(file, elsewhere / "real.so");
  fs::create_symlink(elsewhere / "real.so", file);
  ASSERT_EQ(chmod(elsewhere.c_str(), 0777), 0);
  EXPECT_TRUE(Has(Refused(), "others may write")) << Refused();
}

TEST_F(VendorLoader, ALinkIsAsSafeAsTheFoldersOnItsWay)
{
  const fs::path file = this->Folder.Add("played");
  const fs::path safe = this->Folder.Path / "safe";
  const fs::path open = this->Folder.Path / "open";
  fs::create_directory(safe);
  fs::create_directory(open);
  fs::rename(file, safe / "real.so");
  ASSERT_EQ(chmod(safe.c_str(), 0700), 0);
  ASSERT_EQ(chmod((safe / "real.so").c_str(), 0700), 0);
  // Other users could create a link in this folder, which the loader searches.
  fs::create_symlink(safe / "real.so", open / file.filename());
  setenv("VOLUMEHAPTICS_VENDOR_PATH", open.c_str(), 1);
  for (const mode_t mode : { 0777, 01777, 0770 })
  {
    ASSERT_EQ(chmod(open.c_str(), mode), 0);
    EXPECT_TRUE(Has(Refused(), ("chmod go-w '" + open.string()).c_str())) << Refused();
    EXPECT_TRUE(ListVendors().empty());
  }
  // The second of two links is in a folder where other users can replace it.
  fs::create_symlink(open / file.filename(), file);
  setenv("VOLUMEHAPTICS_VENDOR_PATH", this->Folder.Path.c_str(), 1);
  EXPECT_TRUE(Has(Refused(), ("chmod go-w '" + open.string()).c_str())) << Refused();
  // The loader must also check the target of a link to the folder.
  fs::create_directory_symlink(open, this->Folder.Path / "plugins");
  setenv("VOLUMEHAPTICS_VENDOR_PATH", (this->Folder.Path / "plugins").c_str(), 1);
  EXPECT_TRUE(Has(Refused(), ("chmod go-w '" + open.string()).c_str())) << Refused();
  ASSERT_EQ(chmod(open.c_str(), 0755), 0);
  DeviceBench bench;
  EXPECT_TRUE(bench.Open("vendor:played")) << bench.Error;
}

TEST_F(VendorLoader, LinksInACircleEndWithAnError)
{
  const fs::path file = this->Folder.Path / "libvolumehaptics-played.so";
  fs::create_symlink(file.filename(), file);
  EXPECT_TRUE(Has(Refused(), "too many links")) << Refused();
}

TEST_F(VendorLoader, LoadsNothingThatBelongsToAnotherUser)
{
  if (geteuid() != 0)
  {
    GTEST_SKIP() << "only root can give files away";
  }
  constexpr uid_t other = 65534;
  const fs::path file = this->Folder.Add("played");
  for (const fs::path& given : { file, this->Folder.Path })
  {
    ASSERT_EQ(chown(given.c_str(), other, other), 0);
    EXPECT_TRUE(Has(Refused(), ("\"" + given.string() + "\" belongs to another").c_str()))
      << Refused();
    EXPECT_TRUE(ListVendors().empty());
    ASSERT_EQ(chown(given.c_str(), 0, 0), 0);
  }
  // A link that belongs to another user is refused, too.
  fs::rename(file, this->Folder.Path / "real.so");
  fs::create_symlink("real.so", file);
  ASSERT_EQ(lchown(file.c_str(), other, other), 0);
  EXPECT_TRUE(Has(Refused(), "belongs to another")) << Refused();
  ASSERT_EQ(lchown(file.c_str(), 0, 0), 0);
  DeviceBench bench;
  EXPECT_TRUE(bench.Open("vendor:played")) << bench.Error;
}

TEST_F(VendorLoader, NothingIsSearchedBesideTheFolders)
{
  this->Folder.Add("played");
  EXPECT_TRUE(Has(Refused("vendor:../played"), "is not a device id"));
  EXPECT_TRUE(Has(Refused("vendor:/tmp/x:0"), "is not a device id"));
  EXPECT_TRUE(Has(Refused("vendor"), "is not a device id"));
  EXPECT_TRUE(Has(Refused("vendor:played:x"), "is not a device id"));
  EXPECT_TRUE(Has(Refused("vendor:played:2"), "has no device 2"));
  EXPECT_TRUE(Has(Refused("vendor:other"), "libvolumehaptics-other.so")) << Refused("vendor:other");
  setenv("VOLUMEHAPTICS_VENDOR_PATH", "plugins", 1);
  EXPECT_TRUE(Has(Refused(), "Name the whole path")) << Refused();
}

TEST_F(VendorLoader, AFileThatIsNoPluginIsRefusedWithItsReason)
{
  const fs::path junk = this->Folder.Path / "libvolumehaptics-junk.so";
  std::ofstream(junk) << "not a library";
  fs::permissions(junk, fs::perms::owner_all);
  EXPECT_TRUE(Has(Refused("vendor:junk"), "can't be loaded")) << Refused("vendor:junk");
  // A library without the plug-in's function is refused.
  this->Folder.Add("empty");
  EXPECT_TRUE(Has(Refused("vendor:empty"), "does not export VolumeHapticsVendorGetPlugin"));
  // The vendor's library is not installed. The error contains the dynamic loader's message.
  this->Folder.Add("orphan");
  EXPECT_TRUE(Has(Refused("vendor:orphan"), "libvolumehaptics-no-such-sdk.so"))
    << Refused("vendor:orphan");
  EXPECT_TRUE(Has(TextOfMissing(), "libvolumehaptics-no-such-sdk.so")) << TextOfMissing();
  EXPECT_TRUE(Has(TextOfMissing(), "LD_LIBRARY_PATH")) << TextOfMissing();
}

TEST_F(VendorLoader, APluginOfVersion1HasNoContinuousForce)
{
  this->Folder.Add("played");
  setenv("PLAYED_VENDOR", "first", 1);
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("vendor:played")) << bench.Error;
  EXPECT_EQ(bench.Device->GetLimits().MaximumForce, 4.0);
  EXPECT_EQ(bench.Device->GetLimits().ForceAxes, 7u);
  EXPECT_EQ(bench.Device->GetLimits().ContinuousForce, 0.0);
  unsetenv("PLAYED_VENDOR");
}

TEST_F(VendorLoader, APluginOfALaterVersionIsRefused)
{
  this->Folder.Add("played");
  setenv("PLAYED_VENDOR", "later", 1);
  EXPECT_TRUE(Has(Refused(), "for a later version than 2")) << Refused();
  setenv("PLAYED_VENDOR", "without-write", 1);
  EXPECT_TRUE(Has(Refused(), "leaves functions out")) << Refused();
  unsetenv("PLAYED_VENDOR");
  // The library stays loaded, because its threads may still run.
  const fs::path file = this->Folder.Path / "libvolumehaptics-played.so";
  EXPECT_NE(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD), nullptr);
}
