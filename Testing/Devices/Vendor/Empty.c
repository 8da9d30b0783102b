/* SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors */
/* SPDX-License-Identifier: BSD-3-Clause */

/* A library that is not a plug-in. */
int VolumeHapticsEmpty(void);
int VolumeHapticsEmpty(void)
{
  return 0;
}
