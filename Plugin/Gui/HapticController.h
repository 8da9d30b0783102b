// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticController
 * @brief   the actions of the dock window's buttons
 *
 * Everything acts through the properties of a `HapticDevice` and a `HapticView`, so that scripts
 * can do the same. The Python trace shows what is set up, but neither Running, Armed nor Recording:
 * a user who replays it has not got a hand on the device. Nothing of it can be undone: "undo" must
 * not arm a device.
 *
 * When ParaView quits, and when the server, the view, the device, its filter or the volume goes,
 * the device is detached first, with zero force.
 */
#ifndef HapticController_h
#define HapticController_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QList>
#include <QObject>
#include <QString>

class pqServerManagerModelItem;
class vtkSMHapticDeviceProxy;
class vtkSMHapticViewProxy;

class HapticController : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit HapticController(QObject* parent);
  ~HapticController() override;

  struct DeviceChoice
  {
    QString Id;
    QString Name;  ///< maker, product, place
    QString State; ///< "available", "in use", or what is in the way and the cure
  };
  /** Looks anew. "virtual" is first. */
  static QList<DeviceChoice> listDevices();

  /** The contents of the dock. */
  struct Figures
  {
    bool Attached = false;
    bool Armed = false;
    bool Touches = false; ///< the mouse leads the tip
    bool Recording = false;
    bool IsVirtual = false;
    bool CanHome = false;
    QString Felt; ///< names of the volume and of the filter; empty if nothing is attached
    QString Status;
    double Force = 0.0;        ///< N, on the hand
    double MaximumForce = 0.0; ///< N
    double TickRate = 0.0;     ///< Hz
    long long MissedTicks = 0;
  };

  /** Polls the device. */
  Figures look();

public Q_SLOTS:
  /**
   * Attaches to the active render view. The active source says what is felt: a HapticDevice, a
   * VolumeHaptics filter, or image data; what is missing is made. Else told() says what to do.
   */
  void attach(const QString& deviceId);
  void detach();
  void setArmed(bool on);
  void setTouchMode(bool on);
  void home();
  /** Records into a .vtp or .csv, or, with an empty name, ends and writes the recording. */
  void record(const QString& file);
  /** Detached, stopped, forgotten. */
  void release();

Q_SIGNALS:
  /** The failure and its cure; empty: all is well. */
  void told(const QString& message);

private Q_SLOTS:
  void onItemGoes(pqServerManagerModelItem* item);

private:
  void change(const char* property, int value);
  void set(const char* property, const QString& value);

  vtkWeakPointer<vtkSMHapticDeviceProxy> Device;
  vtkSmartPointer<vtkSMHapticViewProxy> View;
};

#endif
