// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests a device that this user has no permission to open. */

#include "Emulators/Testbed.h"
#include "Rigs/FalconRig.h"

#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>

using namespace emulated;

class FalconPermission : public FalconTest
{
};

TEST_F(FalconPermission, MissingGivesTheRule)
{
  const std::string rule =
    "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"0403\", ATTR{idProduct}==\"cb48\", TAG+=\"uaccess\"";
  // Root may open all devices, so run the test temporarily as the user "nobody", who can see all
  // devices but can't open this one.
  char* const root = umockdev_testbed_get_root_dir(Testbed());
  using std::filesystem::perms;
  std::filesystem::permissions(root, perms::all);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
  {
    if (!entry.is_symlink())
    {
      std::filesystem::permissions(entry, perms::all);
    }
  }
  g_free(root);
  ASSERT_EQ(chmod(this->Usb.GetNode().c_str(), 0600), 0);
  // Use no guard, because umockdev does not work for a program with another effective user.
  setenv("VOLUMEHAPTICS_GUARD", "off", 1);
  const uid_t user = geteuid();
  const bool isRoot = user == 0;
  ASSERT_EQ(isRoot ? seteuid(65534) : chmod(this->Usb.GetNode().c_str(), 0), 0);
  const std::vector<DeviceListing> all = ListDevices();
  const bool opened = this->Open();
  ASSERT_EQ(isRoot ? seteuid(user) : 0, 0);
  unsetenv("VOLUMEHAPTICS_GUARD");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(Has(all[0].State, rule)) << all[0].State;
  EXPECT_FALSE(opened);
  EXPECT_TRUE(Has(this->Error, rule)) << this->Error;
  EXPECT_TRUE(Has(this->Error, "Novint Falcon")) << this->Error;
}
