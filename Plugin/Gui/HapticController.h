// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticController
 * @brief   the actions of the dock window's buttons
 *
 * All actions set properties of a `HapticDevice` and a `HapticView`, so that scripts can do the
 * same. The Python trace contains the setup, but not Running, Armed and Recording, because a user
 * who replays it may not have a hand on the device. No action can be undone, because "undo" must
 * not arm a device.
 *
 * Before ParaView quits, and before the server, the view, the device, its filter or the volume is
 * removed, the device is detached, with zero force. Escape ends the touch mode and disarms,
 * whichever widget has the keyboard focus.
 */
#ifndef HapticController_h
#define HapticController_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QList>
#include <QObject>
#include <QString>

class pqPipelineSource;
class pqServerManagerModelItem;
class pqView;
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
    QString Name;  ///< maker, product, and port
    QString State; ///< "available", "in use", or the obstacle and the cure
  };
  /** Searches for devices again. The first entry is always "virtual". */
  static QList<DeviceChoice> listDevices();

  /** The device state that the dock shows. */
  struct Figures
  {
    bool Attached = false;
    bool Armed = false;
    bool Touches = false; ///< whether the mouse moves the tip
    bool Recording = false;
    bool IsVirtual = false;
    bool CanHome = false;
    bool HasTouch = false; ///< whether a filter is attached, or exists for the active source
    QString Preset;        ///< preset of that filter
    int Method = 0;        ///< method of that filter
    bool CanShow = false;  ///< whether there is a volume, and a render view
    bool IsVolume = false; ///< whether the view shows the volume by volume rendering
    QString Recorded;      ///< file of the last recording if it was written; otherwise empty
    QString Felt; ///< names of the felt volume and its filter; empty if nothing is attached
    QString Status;
    bool IsFault = false;
    double Force = 0.0;       ///< N, on the hand
    bool HasSecond = false;   ///< whether there is a device for the other hand
    double SecondForce = 0.0; ///< N, on the other hand
    QString SecondStatus;
    double MaximumForce = 0.0; ///< N
    double TickRate = 0.0;     ///< Hz
    long long MissedTicks = 0;
  };

  /**
   * Returns the purpose of the filter, the device and the path, with all their properties, as HTML.
   */
  static QString describeAll();

  /** Polls the device and returns its state. */
  Figures look();

  /** Filters the application's events for the key Escape. */
  bool eventFilter(QObject* watched, QEvent* event) override;

public Q_SLOTS:
  /**
   * Attaches a device to the active render view. The active source, which is a HapticDevice, a
   * VolumeHaptics filter, or a volume, determines what is felt. Missing objects are made; a new
   * filter gets the preset and the method. An empty preset stands for the preset that suits the
   * data. On failure, told() is emitted with the cure.
   */
  void attach(const QString& deviceId, const QString& preset, int method);
  void detach();
  /** Arms or disarms all hands. */
  void setArmed(bool on);
  /**
   * Uses a device for the other hand, which feels the same as the attached one. An empty name
   * removes the other hand from the view, and stops its device.
   */
  void setSecondDevice(const QString& deviceId);
  /** Sets the touch mode. Switching it on also gives the view the keyboard focus. */
  void setTouchMode(bool on);
  void home();
  /** Records to a .vtp or .csv file. An empty name ends the recording and writes it. */
  void record(const QString& file);
  ///@{
  /**
   * Set the preset or the method of the attached filter or, if nothing is attached, of the active
   * source's filter. Do nothing without a filter.
   */
  void setPreset(const QString& name);
  void setMethod(int method);
  /**
   * Read functions from a file of vtkHapticProperty::WritePreset, or write the felt functions to
   * such a file.
   */
  void loadPreset(const QString& file);
  void savePreset(const QString& file);
  ///@}
  /**
   * Shows the felt volume or, if there is none, the active source, as a CT volume in the active
   * view.
   */
  void showAsCT();
  /** Opens the last recording in ParaView, and shows it. */
  void openRecorded();
  /** Detaches and stops the device, and releases it. */
  void release();

Q_SIGNALS:
  /**
   * Emitted with a message for the user, such as a failure and its cure; an empty message removes
   * the last one.
   */
  void told(const QString& message);

private Q_SLOTS:
  void onItemGoes(pqServerManagerModelItem* item);

private:
  void change(const char* property, int value);
  static void order(vtkSMHapticDeviceProxy* device, const char* property, int value);
  void set(const char* property, const QString& value);
  pqPipelineSource* findTouch() const;
  pqPipelineSource* findVolume(pqPipelineSource* touch) const;
  pqView* findView() const;
  void followRecording(bool isRecording);
  void showSecond();

  vtkWeakPointer<vtkSMHapticDeviceProxy> Device;
  vtkWeakPointer<vtkSMHapticDeviceProxy> Second;
  vtkSmartPointer<vtkSMHapticViewProxy> View;
  bool WasRecording = false;
  QString Recorded;
};

#endif
