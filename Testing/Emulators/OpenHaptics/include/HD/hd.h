// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for OpenHaptics' header of this name: the functions that the plug-in uses, with the
 * signatures and units of its public documentation (OpenHaptics Toolkit 3.5, API Reference). The
 * values of enumerators differ from the library's.
 */
#ifndef FakeHd_h
#define FakeHd_h

using HHD = unsigned int;
using HDenum = unsigned int;
using HDint = int;
using HDulong = unsigned long;
using HDushort = unsigned short;
using HDdouble = double;
using HDstring = const char*;
using HDerror = unsigned int;
using HDSchedulerHandle = unsigned long;
using HDCallbackCode = unsigned int;

#define HDCALLBACK
#define HD_DEFAULT_DEVICE nullptr
#define HD_MAX_SCHEDULER_PRIORITY 0xFFFF

struct HDErrorInfo
{
  HDerror errorCode;
  int internalErrorCode;
  HHD hHD;
};
#define HD_DEVICE_ERROR(X) ((X).errorCode != HD_SUCCESS)

enum : unsigned int
{
  HD_CALLBACK_DONE,
  HD_CALLBACK_CONTINUE,
  HD_SUCCESS = 0,
  HD_BAD_HANDLE = 11,
  HD_FRAME_ERROR,
  HD_COMM_ERROR,
  HD_WARM_MOTORS,
  HD_INVALID_ENUM,
  HD_INVALID_OPERATION,
  HD_CURRENT_POSITION = 101,
  HD_CURRENT_TRANSFORM,
  HD_CURRENT_BUTTONS,
  HD_CURRENT_FORCE,
  HD_CURRENT_TORQUE,
  HD_NOMINAL_MAX_FORCE,
  HD_NOMINAL_MAX_STIFFNESS,
  HD_NOMINAL_MAX_DAMPING,
  HD_USABLE_WORKSPACE_DIMENSIONS,
  HD_DEVICE_SERIAL_NUMBER,
  HD_OUTPUT_DOF,
  HD_CALIBRATION_STYLE,
  HD_NOMINAL_MAX_CONTINUOUS_FORCE,
  HD_CALIBRATION_ENCODER_RESET = 1, // the calibration styles are bits, like in the library
  HD_CALIBRATION_AUTO = 2,
  HD_CALIBRATION_INKWELL = 4,
  HD_FORCE_OUTPUT = 201,
  HD_CALIBRATION_OK = 301,
  HD_CALIBRATION_NEEDS_UPDATE,
  HD_CALIBRATION_NEEDS_MANUAL_INPUT
};

extern "C"
{
  using HDSchedulerCallback = HDCallbackCode(HDCALLBACK*)(void*);

  HHD hdInitDevice(HDstring name);
  void hdDisableDevice(HHD device);
  void hdMakeCurrentDevice(HHD device);
  void hdEnable(HDenum capability);
  void hdBeginFrame(HHD device);
  void hdEndFrame(HHD device);
  void hdGetDoublev(HDenum name, HDdouble* values);
  void hdGetIntegerv(HDenum name, HDint* values);
  void hdSetDoublev(HDenum name, const HDdouble* values);
  HDstring hdGetString(HDenum name);
  HDErrorInfo hdGetError();
  HDstring hdGetErrorString(HDerror error);
  HDenum hdCheckCalibration();
  void hdUpdateCalibration(HDenum style);
  void hdSetSchedulerRate(HDulong rate);
  void hdStartScheduler();
  void hdStopScheduler();
  HDSchedulerHandle hdScheduleAsynchronous(
    HDSchedulerCallback callback, void* data, HDushort priority);
  void hdUnschedule(HDSchedulerHandle callback);
}

#endif
