/* SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors */
/* SPDX-License-Identifier: BSD-3-Clause */
/**
 * @file
 * The C interface of a plug-in for a vendor's library: the devices vendor:PLUGIN:N.
 *
 * A plug-in is a shared library, libvolumehaptics-PLUGIN.so (.dll on Windows), that you build
 * against the vendor's SDK. It exports one function, VolumeHapticsVendorGetPlugin, which returns a
 * table of functions. It needs only this header, and works with every VTK Volume Haptics that has
 * the same or a later VOLUME_HAPTICS_VENDOR_VERSION. Examples/Cxx/VendorDevice.cxx is a template;
 * Examples/Vendor has plug-ins for Force Dimension's and 3D Systems' libraries.
 *
 * Units are metres, newtons, newton metres, seconds. Axes point right, up and towards the user. A
 * stylus points along its own -z, so that its handle is on the side of +z, and has its button on
 * the side of +y; its orientation is the rotation from the device's axes to the stylus's axes.
 *
 * Threads: Read, Write and Home of a device are called on one thread. Before that, Open, GetLimits,
 * GetSerial and a Write of zero are called on another thread, and afterwards a Write of zero and
 * Close. Functions for one device never run at the same time; functions for two devices may. Count
 * and Describe are not called while a device of the plug-in is open. Read and Write are called
 * about a thousand times a second and should take at most a millisecond; if they take more than
 * half a second, the device is lost. Functions must not throw.
 *
 * Safety: the forces passed to Write are finite and within the limits; a force that stays above
 * ContinuousForce fades to it. Only Write may exert a force, and Home for a device that moves by
 * itself; the last call before Close is a Write of zero. If the program is killed, only the
 * vendor's own watchdog ends the force: keep it on.
 */
#ifndef VolumeHapticsVendorPlugin_h
#define VolumeHapticsVendorPlugin_h

#include <stddef.h>
#include <stdint.h>

/** Version 1 is version 2 without ContinuousForce, PeakTime and VOLUME_HAPTICS_VENDOR_GONE. */
#define VOLUME_HAPTICS_VENDOR_VERSION 2u

#ifdef __cplusplus
extern "C"
{
#endif

  /**
   * Results of the functions that return an int. After a negative result, LastError() returns a
   * text.
   */
  enum VolumeHapticsVendorResult
  {
    VOLUME_HAPTICS_VENDOR_NEWS = 1,   /**< Read: a new measurement */
    VOLUME_HAPTICS_VENDOR_DONE = 0,   /**< Read: the device is connected and has nothing new */
    VOLUME_HAPTICS_VENDOR_WAITS = -1, /**< Read: not homed or switched on yet: there is no pose */
    VOLUME_HAPTICS_VENDOR_LOST = -2,  /**< a fault, after which no force may flow */
    /**
     * Result of Read: the device was unplugged. If it has a serial number, it is closed, and
     * reopened once it is plugged in again. For this purpose Count, Describe and, until the device
     * is open, Open are called twice a second. LastError() is not called.
     */
    VOLUME_HAPTICS_VENDOR_GONE = -3
  };

  /**
   * Limits of a device. 0 stands for an unlimited or unknown value. Only MaximumForce must be
   * known.
   */
  struct VolumeHapticsVendorLimits
  {
    double MaximumForce;     /**< N */
    double MaximumTorque;    /**< N m; 0 if it gives no torque */
    double MaximumStiffness; /**< N/m, held at 1 kHz */
    double MaximumDamping;   /**< N s/m */
    double MaximumSpeed;     /**< m/s; a faster tip means that the hand has lost the handle */
    double OwnDamping;       /**< N s/m, its own viscous friction */
    double WorkspaceRadius;  /**< m */
    uint32_t ForceAxes;      /**< bit i: it can push along axis i; 7, or 0: all */
    double ContinuousForce;  /**< N, given for any time if MaximumForce is a peak; else 0 */
    double PeakTime;         /**< s for which more than ContinuousForce is given; then it fades */
  };

  struct VolumeHapticsVendorPose
  {
    double Position[3];
    double Orientation[4];  /**< a unit quaternion, w first, if HasOrientation is not 0 */
    int64_t Age;            /**< ns since the measurement; 0 if not known */
    uint32_t Buttons;       /**< bit 0 is the main button */
    int32_t HasOrientation; /**< 0 if the device measures no orientation */
  };

  struct VolumeHapticsVendorPlugin
  {
    uint32_t Version; /**< VOLUME_HAPTICS_VENDOR_VERSION */
    /**
     * Returns the number of devices that are plugged in or that may be tried. After a negative
     * result, LastError() returns the reason.
     */
    int (*Count)(void);
    /** Writes a device's name for the user, and its serial number or an empty text. */
    int (*Describe)(int number, char* name, size_t nameSize, char* serial, size_t serialSize);
    /**
     * Opens a device, still without a force, and returns a handle. If it is null, LastError()
     * returns the reason.
     */
    void* (*Open)(int number);
    int (*GetLimits)(void* device, struct VolumeHapticsVendorLimits* limits);
    /** Writes the serial number of an open device; an empty text if it has none. */
    int (*GetSerial)(void* device, char* serial, size_t size);
    int (*Read)(void* device, struct VolumeHapticsVendorPose* pose);
    int (*Write)(void* device, const double force[3], const double torque[3]);
    /**
     * Homes the device, or retries after a fault. Called at the user's request. Homing may take
     * seconds, during which Read is not called. Null if homing is not needed.
     */
    int (*Home)(void* device);
    /**
     * Returns the last fault, or the last request to the user, and its cure. The text continues a
     * sentence after the device's name, such as "is not homed. Press Home()." If the device is
     * null, the text is about the plug-in. It is valid until the next call.
     */
    const char* (*LastError)(void* device);
    void (*Close)(void* device);
  };

  /** Returns the table of functions; null if the plug-in does not support the version. */
#if defined(_WIN32)
  __declspec(dllexport)
#else
__attribute__((visibility("default")))
#endif
    const struct VolumeHapticsVendorPlugin* VolumeHapticsVendorGetPlugin(uint32_t version);

#ifdef __cplusplus
}
#endif

#endif
