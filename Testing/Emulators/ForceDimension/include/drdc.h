// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for Force Dimension's header of the same name (see dhdc.h).
 */
#ifndef FakeDrdc_h
#define FakeDrdc_h

#include "dhdc.h"

extern "C"
{
  int drdOpenID(char ID);
  int drdClose(char ID = -1);
  bool drdIsInitialized(char ID = -1);
  int drdAutoInit(char ID = -1);
  int drdStop(bool frc = false, char ID = -1);
}

#endif
