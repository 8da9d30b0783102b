// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a USB device that this user may not open, with the permissions that a kernel without a rule
 * gives it.
 */
#include "Rigs/FalconRig.h"

#include <unistd.h>

using namespace emulated;

class KernelPermission : public FalconTest
{
};

TEST_F(KernelPermission, MissingGivesTheRule)
{
  const std::string rule =
    "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"0403\", ATTR{idProduct}==\"cb48\", TAG+=\"uaccess\"";
  ASSERT_EQ(seteuid(65534), 0);
  const std::vector<DeviceListing> all = ListDevices();
  const bool isOpen = this->Open();
  ASSERT_EQ(seteuid(0), 0);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(Has(all[0].State, rule)) << all[0].State;
  EXPECT_FALSE(isOpen);
  EXPECT_TRUE(Has(this->Error, rule)) << this->Error;
  EXPECT_TRUE(this->Open()) << this->Error;
}
