// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticDock
 * @brief   the dock window "Volume Haptics"
 *
 * The window has buttons to choose the device, attach it to the active view and volume, arm, stop,
 * home and record. It also shows the preset and the method of the filter, a button for the look of
 * the volume, and the felt forces. Like every dock window, it is listed in ParaView's menu View.
 */
#ifndef HapticDock_h
#define HapticDock_h

#include "HapticController.h"

#include <QDockWidget>
#include <QTimer>

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

class HapticDock : public QDockWidget
{
  Q_OBJECT
  typedef QDockWidget Superclass;

public:
  explicit HapticDock(QWidget* parent = nullptr);
  ~HapticDock() override;

private Q_SLOTS:
  void listDevices();
  void onAttach(bool on);
  void onSecond();
  void onRecord(bool on);
  void onLoadPreset();
  void onSavePreset();
  void onTold(const QString& message);
  void onHelp();
  void update();

private:
  QPushButton* addButton(QGridLayout* grid, int row, int column, const char* name,
    const QString& text, const QString& tip);
  void addChoices(QGridLayout* grid, int row);
  /**
   * Shows the preset and the method of a filter. Without a filter, the user's choice for the next
   * filter remains.
   */
  void showChoices(const HapticController::Figures& now);
  /** Opens a file dialog. Returns the chosen name; empty if the user cancels. */
  QString askFile(const char* name, const QString& title, const QString& kinds, bool isNew);

  HapticController* Controller;
  QTimer Timer;
  QString Told; ///< last message of the controller, shown until the next action
  QComboBox* Device;
  QComboBox* SecondDevice;
  QPushButton* Attach;
  QPushButton* Arm;
  QPushButton* Touch;
  QPushButton* Home;
  QPushButton* Record;
  QComboBox* Preset;
  QComboBox* Method;
  QPushButton* LoadPreset;
  QPushButton* SavePreset;
  QPushButton* ShowAsCT;
  QPushButton* OpenRecorded;
  QLabel* Felt;
  QLabel* Status;
  QToolButton* Why;
  QLabel* Force;
  QProgressBar* Bar;
  QLabel* Rate;
};

#endif
