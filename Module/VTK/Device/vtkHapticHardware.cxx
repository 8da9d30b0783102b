// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticHardware.h"

#include "Devices/Common/DeviceMemory.h"
#include "Devices/Kinds/DeviceRegistry.h"
#include "VTK/Device/HapticDeviceSettings.h"

#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace VolumeHaptics;

namespace
{
std::vector<DeviceListing> ListAll()
{
  std::vector<DeviceListing> all{ { "virtual", "A stylus without hardware: the mouse",
    "available" } };
  std::vector<DeviceListing> plugged = VolumeHaptics::ListDevices();
  std::move(plugged.begin(), plugged.end(), std::back_inserter(all));
  return all;
}

vtkSmartPointer<vtkStringArray> AddColumn(vtkTable* table, const char* name)
{
  const auto column = vtkSmartPointer<vtkStringArray>::New();
  column->SetName(name);
  table->AddColumn(column);
  return column;
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticHardware::vtkHapticHardware()
{
  const char* const file = std::getenv("VOLUMEHAPTICS_FALCON_FIRMWARE");
  this->FirmwareFile = file ? file : "";
}

//------------------------------------------------------------------------------
vtkStringArray* vtkHapticHardware::EnumerateDevices()
{
  static const vtkSmartPointer<vtkStringArray> ids = vtkSmartPointer<vtkStringArray>::New();
  ids->Reset();
  for (const DeviceListing& device : ListAll())
  {
    ids->InsertNextValue(device.Id);
  }
  return ids;
}

//------------------------------------------------------------------------------
void vtkHapticHardware::ListDevices(vtkTable* devices)
{
  if (!devices)
  {
    return;
  }
  devices->Initialize();
  const auto ids = AddColumn(devices, "Id");
  const auto names = AddColumn(devices, "Name");
  const auto states = AddColumn(devices, "State");
  const auto forces = AddColumn(devices, "Force");
  for (const DeviceListing& device : ListAll())
  {
    ids->InsertNextValue(device.Id);
    names->InsertNextValue(device.Name);
    states->InsertNextValue(device.State);
    std::string error;
    forces->InsertNextValue(device.Identity.empty()
        ? std::string()
        : DeviceMemory::Read(device.Identity, error).DescribeScale());
  }
}

//------------------------------------------------------------------------------
void vtkHapticHardware::ListMissingKinds(vtkTable* kinds)
{
  if (!kinds)
  {
    return;
  }
  kinds->Initialize();
  const auto names = AddColumn(kinds, "Kind");
  const auto states = AddColumn(kinds, "State");
  for (const DeviceObstacle& obstacle : VolumeHaptics::ListMissingKinds())
  {
    names->InsertNextValue(obstacle.Kind);
    states->InsertNextValue(obstacle.Text);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticHardware::AddDeviceKind(const DeviceKind& kind)
{
  std::string error;
  const bool isAdded = VolumeHaptics::AddDeviceKind(kind, error);
  if (!isAdded)
  {
    vtkGenericWarningMacro(<< error);
  }
  return isAdded;
}

//------------------------------------------------------------------------------
void vtkHapticHardware::SetFirmwareFile(const std::string& file)
{
  if (file != this->FirmwareFile)
  {
    this->FirmwareFile = file;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticHardware::SetVendorPath(const std::string& path)
{
  if (path != this->VendorPath)
  {
    this->VendorPath = path;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticHardware::SetNewtonsPerFullScale(double x, double y)
{
  if (!std::isfinite(x) || !std::isfinite(y))
  {
    vtkErrorMacro("NewtonsPerFullScale must be finite; it stays as it was.");
    return;
  }
  const HardwareVector& row = HardwareSettingRows::NewtonsPerFullScale;
  const double newtons[2] = { std::clamp(x, row.Minimum, row.Maximum),
    std::clamp(y, row.Minimum, row.Maximum) };
  if (newtons[0] != this->NewtonsPerFullScale[0] || newtons[1] != this->NewtonsPerFullScale[1])
  {
    std::copy(newtons, newtons + 2, this->NewtonsPerFullScale);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticHardware::SetNewtonsPerFullScale(const double newtons[2])
{
  if (!newtons)
  {
    vtkErrorMacro(
      "NewtonsPerFullScale needs two numbers, but got a null pointer; it stays as it was.");
    return;
  }
  this->SetNewtonsPerFullScale(newtons[0], newtons[1]);
}

//------------------------------------------------------------------------------
DeviceOptions vtkHapticHardware::MakeOptions() const
{
  DeviceOptions options;
  options.FirmwareFile = this->FirmwareFile;
  options.VendorPath = this->VendorPath;
  options.HomingTime = this->HomingTime;
  options.UseGuard = this->UseGuard;
  options.NewtonsPerFullScale = { this->NewtonsPerFullScale[0], this->NewtonsPerFullScale[1] };
  return options;
}

//------------------------------------------------------------------------------
void vtkHapticHardware::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirmwareFile: " << (this->FirmwareFile.empty() ? "(none)" : this->FirmwareFile)
     << "\n";
  os << indent << "VendorPath: "
     << (this->VendorPath.empty() ? "(VOLUMEHAPTICS_VENDOR_PATH)" : this->VendorPath) << "\n";
  PrintSettings(os, indent, this, HardwareSettings);
  PrintSettings(os, indent, this, HardwareVectors);
}
