/* SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors */
/* SPDX-License-Identifier: BSD-3-Clause */

/*
 * The function table of the played plug-in, in C, because VendorPlugin.h must compile as C, too.
 * The environment variable PLAYED_VENDOR selects a plug-in of version 1, or one that must not be
 * loaded.
 */
#include "Devices/Vendor/VendorPlugin.h"

#include <stdlib.h>
#include <string.h>

int PlayedCount(void);
int PlayedDescribe(int number, char* name, size_t nameSize, char* serial, size_t serialSize);
void* PlayedOpen(int number);
int PlayedGetLimits(void* device, struct VolumeHapticsVendorLimits* limits);
int PlayedGetSerial(void* device, char* serial, size_t size);
int PlayedRead(void* device, struct VolumeHapticsVendorPose* pose);
int PlayedWrite(void* device, const double force[3], const double torque[3]);
int PlayedHome(void* device);
const char* PlayedLastError(void* device);
void PlayedClose(void* device);

/* The limits as declared in VendorPlugin.h of version 1. */
struct LimitsOfVersion1
{
  double MaximumForce, MaximumTorque, MaximumStiffness, MaximumDamping, MaximumSpeed, OwnDamping,
    WorkspaceRadius;
  uint32_t ForceAxes;
};

static int GetLimitsOfVersion1(void* device, struct VolumeHapticsVendorLimits* limits)
{
  struct VolumeHapticsVendorLimits all;
  const int result = PlayedGetLimits(device, &all);
  struct LimitsOfVersion1 old;
  memcpy(&old, &all, sizeof(old));
  memcpy(limits, &old, sizeof(old));
  return result;
}

const struct VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version)
{
  static struct VolumeHapticsVendorPlugin plugin = { VOLUME_HAPTICS_VENDOR_VERSION, &PlayedCount,
    &PlayedDescribe, &PlayedOpen, &PlayedGetLimits, &PlayedGetSerial, &PlayedRead, &PlayedWrite,
    &PlayedHome, &PlayedLastError, &PlayedClose };
  const char* const fault = getenv("PLAYED_VENDOR");
  if (fault && strcmp(fault, "later") == 0)
  {
    return NULL;
  }
  if (fault && strcmp(fault, "first") == 0)
  {
    plugin.Version = 1;
    plugin.GetLimits = &GetLimitsOfVersion1;
    return version == 1 ? &plugin : NULL;
  }
  if (fault && strcmp(fault, "without-write") == 0)
  {
    plugin.Write = NULL;
  }
  return version == VOLUME_HAPTICS_VENDOR_VERSION ? &plugin : NULL;
}
