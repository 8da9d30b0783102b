// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticDock.h"

#include "pqFileDialog.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int Period = 100;    ///< ms between looks at the device
constexpr int BarSteps = 1000; ///< of the bar, up to the largest force

void SetChecked(QPushButton* button, bool on)
{
  const QSignalBlocker blocker(button);
  button->setChecked(on);
}
} // namespace

//------------------------------------------------------------------------------
HapticDock::HapticDock(QWidget* parent)
  : Superclass(tr("Volume Haptics"), parent)
  , Controller(new HapticController(this))
{
  auto* const panel = new QWidget(this);
  panel->setObjectName("HapticPanel");
  auto* const grid = new QGridLayout;

  this->Device = new QComboBox(panel);
  this->Device->setObjectName("HapticDevice");
  this->Device->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Device->setToolTip(tr("The haptic devices that can be attached now."));
  grid->addWidget(this->Device, 0, 0, 1, 2);
  auto* const refresh = new QToolButton(panel);
  refresh->setObjectName("HapticRefresh");
  refresh->setIcon(this->style()->standardIcon(QStyle::SP_BrowserReload));
  refresh->setToolTip(tr("Look for devices again."));
  grid->addWidget(refresh, 0, 2);

  this->Attach = this->addButton(grid, 1, 0, "HapticAttach", tr("Attach"),
    tr("To the active render view and the active volume, or back."));
  this->Arm = this->addButton(grid, 1, 1, "HapticArm", tr("Arm"),
    tr("Let force through to the hand, or stop it at once. Key a in the view; Escape stops."));
  this->Touch = this->addButton(grid, 2, 0, "HapticTouch", tr("Touch with the mouse"),
    tr(
      "The mouse leads the tip of the virtual device, the wheel moves it into the screen. Key t."));
  this->Record = this->addButton(grid, 2, 1, "HapticRecord", tr("Record..."),
    tr("Every tick of the servo, into a file, until pressed again."));
  this->Home = this->addButton(grid, 3, 0, "HapticHome", tr("Home"),
    tr("Look for the zero of the device's encoders, with the hand's help."));
  this->Home->setCheckable(false);

  const auto label = [panel](const char* name, bool wraps)
  {
    auto* const made = new QLabel(panel);
    made->setObjectName(name);
    made->setWordWrap(wraps);
    return made;
  };
  this->Felt = label("HapticFelt", true);
  this->Status = label("HapticStatus", true);
  this->Status->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Force = label("HapticForce", false);
  QFont large = this->Force->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  this->Force->setFont(large);
  this->Rate = label("HapticRate", false);
  this->Rate->setAlignment(Qt::AlignRight | Qt::AlignBottom);
  this->Bar = new QProgressBar(panel);
  this->Bar->setObjectName("HapticBar");
  this->Bar->setRange(0, BarSteps);
  this->Bar->setTextVisible(false);
  this->Bar->setMaximumHeight(10);
  grid->addWidget(this->Force, 4, 0);
  grid->addWidget(this->Rate, 4, 1, 1, 2);

  auto* const all = new QVBoxLayout(panel);
  all->addLayout(grid);
  all->addWidget(this->Bar);
  all->addWidget(this->Felt);
  all->addWidget(this->Status);
  all->addStretch(1);
  this->setWidget(panel);

  this->connect(refresh, &QToolButton::clicked, this, &HapticDock::listDevices);
  this->connect(this->Attach, &QPushButton::toggled, this, &HapticDock::onAttach);
  this->connect(this->Arm, &QPushButton::toggled, this->Controller, &HapticController::setArmed);
  this->connect(
    this->Touch, &QPushButton::toggled, this->Controller, &HapticController::setTouchMode);
  this->connect(this->Home, &QPushButton::clicked, this->Controller, &HapticController::home);
  this->connect(this->Record, &QPushButton::toggled, this, &HapticDock::onRecord);
  this->connect(this->Controller, &HapticController::told, this, &HapticDock::onTold);
  this->connect(&this->Timer, &QTimer::timeout, this, &HapticDock::update);
  this->listDevices();
  this->update();
  this->Timer.start(Period);
}

//------------------------------------------------------------------------------
HapticDock::~HapticDock() = default;

//------------------------------------------------------------------------------
QPushButton* HapticDock::addButton(
  QGridLayout* grid, int row, int column, const char* name, const QString& text, const QString& tip)
{
  auto* const button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setCheckable(true);
  grid->addWidget(button, row, column, 1, column == 1 ? 2 : 1);
  return button;
}

//------------------------------------------------------------------------------
void HapticDock::listDevices()
{
  const QString chosen = this->Device->currentData().toString();
  this->Device->clear();
  for (const HapticController::DeviceChoice& choice : HapticController::listDevices())
  {
    // A state may be a sentence with the cure: that goes into the tool tip.
    const QString state = choice.State.section(". ", 0, 0);
    this->Device->addItem(QString("%1: %2").arg(choice.Id, state), choice.Id);
    this->Device->setItemData(
      this->Device->count() - 1, choice.Name + "\n" + choice.State, Qt::ToolTipRole);
  }
  this->Device->setCurrentIndex(std::max(0, this->Device->findData(chosen)));
}

//------------------------------------------------------------------------------
void HapticDock::onAttach(bool on)
{
  this->Told.clear();
  if (on)
  {
    this->Controller->attach(this->Device->currentData().toString());
  }
  else
  {
    this->Controller->release();
  }
  this->update();
}

//------------------------------------------------------------------------------
void HapticDock::onRecord(bool on)
{
  QString file;
  if (on)
  {
    // The client writes the file, even if the data are on a server.
    pqFileDialog dialog(nullptr, this, tr("Record to"), QString(),
      tr("Traces (*.vtp);;Comma separated values (*.csv)"));
    dialog.setObjectName("HapticRecordDialog");
    dialog.setFileMode(pqFileDialog::AnyFile);
    if (dialog.exec() != QDialog::Accepted || dialog.getSelectedFiles().isEmpty())
    {
      SetChecked(this->Record, false);
      return;
    }
    file = dialog.getSelectedFiles().first();
  }
  this->Controller->record(file);
}

//------------------------------------------------------------------------------
void HapticDock::onTold(const QString& message)
{
  this->Told = message;
}

//------------------------------------------------------------------------------
void HapticDock::update()
{
  const HapticController::Figures now = this->Controller->look();
  SetChecked(this->Attach, now.Attached);
  SetChecked(this->Arm, now.Armed);
  SetChecked(this->Touch, now.Touches);
  SetChecked(this->Record, now.Recording);
  this->Attach->setText(now.Attached ? tr("Detach") : tr("Attach"));
  this->Arm->setText(now.Armed ? tr("Stop") : tr("Arm"));
  this->Record->setText(now.Recording ? tr("End recording") : tr("Record..."));
  this->Device->setEnabled(!now.Attached);
  this->Arm->setEnabled(now.Attached);
  this->Touch->setEnabled(now.Attached && now.IsVirtual);
  this->Record->setEnabled(now.Attached);
  this->Home->setVisible(now.Attached && now.CanHome);
  this->Force->setText(QString("%1 N").arg(now.Force, 0, 'f', 2));
  this->Bar->setValue(now.MaximumForce > 0.0
      ? static_cast<int>(std::min(1.0, now.Force / now.MaximumForce) * BarSteps)
      : 0);
  this->Bar->setToolTip(tr("Up to %1 N").arg(now.MaximumForce));
  this->Rate->setText(now.Attached
      ? tr("%1 Hz, %2 missed").arg(now.TickRate, 0, 'f', 0).arg(now.MissedTicks)
      : QString());
  this->Felt->setText(now.Attached ? now.Felt : QString());
  this->Status->setText(!this->Told.isEmpty() ? this->Told
      : now.Attached                          ? now.Status
                     : tr("Select a volume and a render view, and attach."));
}
