// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconKind.h"

#include "Devices/Common/DeviceTexts.h"
#include "Devices/Falcon/FalconDriver.h"
#include "Devices/Guard/GuardWish.h"
#if defined(__linux__)
#include "Devices/Guard/GuardedDevice.h"
#endif

namespace VolumeHaptics
{
namespace
{

std::vector<DeviceListing> ListFalcons()
{
  std::vector<DeviceListing> listings;
  std::string error;
  const UsbContext context = MakeUsbContext(error);
  if (context)
  {
    for (const UsbDevice& device : ListUsbDevices(context.get(), FalconProduct))
    {
      listings.push_back(
        { "falcon:" + std::to_string(listings.size()), UsbNameOf(device.get(), FalconProduct),
          UsbStateOf(device.get(), FalconProduct), UsbIdentityOf(device.get(), "falcon") });
    }
  }
  return listings;
}

std::unique_ptr<DeviceBackend> MakeFalcon(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const int number = ReadDeviceNumber(id, "falcon", error);
  if (number < 0)
  {
    return nullptr;
  }
  auto driver = std::make_unique<FalconDriver>(number, options);
  if (IsGuardWanted(options))
  {
#if defined(__linux__)
    return GuardedDevice::Make(std::move(driver), FalconDriver::MakeWords(number, options), error);
#else
    error = MakeNoGuardText(FalconProduct.Name);
    return nullptr;
#endif
  }
  return std::make_unique<HardwareDevice>(std::move(driver));
}

} // namespace

DeviceKind GetFalconKind()
{
  return { "falcon", &ListFalcons, &MakeFalcon };
}

} // namespace VolumeHaptics
