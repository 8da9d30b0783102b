// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for Force Dimension's header of this name: the functions that the plug-in uses, with
 * the signatures, constants and units of the SDK's public documentation
 * (downloads.forcedimension.com/sdk/doc, Haptic SDK 3.14). Names of device types are omitted,
 * because SDK 3.17 deprecates those of 3.14 and has new ones; the numbers are the same.
 */
#ifndef FakeDhdc_h
#define FakeDhdc_h

using ushort = unsigned short;
using uchar = unsigned char;
using uint = unsigned int;

#define DHD_ON 1
#define DHD_OFF 0
#define DHD_TIMEGUARD 1
#define DHD_MOTOR_SATURATED 2
#define DHD_MAX_STATUS 16
#define DHD_STATUS_POWER 0
#define DHD_STATUS_CONNECTED 1
#define DHD_STATUS_FORCE 5

extern "C"
{
  const char* dhdErrorGetLastStr();
  int dhdGetDeviceCount();
  int dhdGetSerialNumber(ushort* sn, char ID = -1);
  int dhdGetSystemType(char ID = -1);
  double dhdGetMaxForce(char ID = -1);
  double dhdGetMaxTorque(char ID = -1);
  int dhdGetStatus(int status[DHD_MAX_STATUS], char ID = -1);
  int dhdEnableForce(uchar val, char ID = -1);
  bool dhdHasWrist(char ID = -1);
  bool dhdHasActiveGripper(char ID = -1);
  int dhdEmulateButton(uchar val, char ID = -1);
  uint dhdGetButtonMask(char ID = -1);
  int dhdGetPosition(double* px, double* py, double* pz, char ID = -1);
  int dhdGetPositionAndOrientationFrame(
    double* px, double* py, double* pz, double matrix[3][3], char ID = -1);
  int dhdSetForce(double fx, double fy, double fz, char ID = -1);
  int dhdSetForceAndTorque(
    double fx, double fy, double fz, double tx, double ty, double tz, char ID = -1);
}

#endif
