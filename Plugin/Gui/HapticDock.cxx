// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticDock.h"

#include "VTK/Filter/HapticFilterSettings.h"

#include "vtkHapticProperty.h"
#include "vtkHapticViewStyle.h"
#include "vtkStringArray.h"

#include "pqFileDialog.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QCursor>
#include <QDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int Period = 100;    ///< ms between two updates from the device
constexpr int BarSteps = 1000; ///< number of steps of the bar, from 0 to the largest force

/**
 * Reads the pointer's position from the window system, which knows it before the motion events
 * arrive.
 */
void PollPointer(int position[2])
{
  const QPoint place = QCursor::pos();
  position[0] = place.x();
  position[1] = place.y();
}

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
  vtkHapticViewStyle::SetPointerQuery(PollPointer);
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
  auto* const help = new QToolButton(panel);
  help->setObjectName("HapticHelp");
  help->setText("?");
  help->setToolTip(tr("Explains this window, the filter and the device."));
  grid->addWidget(help, 1, 2);

  this->SecondDevice = new QComboBox(panel);
  this->SecondDevice->setObjectName("HapticSecondDevice");
  this->SecondDevice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->SecondDevice->setToolTip(tr("Device for the other hand, in the same view and volume."));
  grid->addWidget(this->SecondDevice, 1, 0, 1, 2);

  this->Attach = this->addButton(grid, 2, 0, "HapticAttach", tr("Attach"),
    tr("Attaches the device to the active render view and volume, or detaches it."));
  this->Arm = this->addButton(grid, 2, 1, "HapticArm", tr("Arm"),
    tr("Let force through to the hand, or stop it at once. Key a in the view; Escape stops."));
  this->Touch = this->addButton(grid, 3, 0, "HapticTouch", tr("Touch with the mouse"),
    tr(
      "The mouse leads the tip of the virtual device, the wheel moves it into the screen. Key t."));
  this->Record = this->addButton(grid, 3, 1, "HapticRecord", tr("Record..."),
    tr("Records every servo tick to a file, until pressed again."));
  this->Home = this->addButton(grid, 4, 0, "HapticHome", tr("Home"),
    tr("Finds the zero of the device's encoders; you move the grip as the status says."));
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
  this->addChoices(grid, 5);
  grid->addWidget(this->Force, 9, 0);
  grid->addWidget(this->Rate, 9, 1, 1, 2);
  this->OpenRecorded = this->addButton(grid, 4, 1, "HapticOpenRecorded", QString(),
    tr("Opens the last recording in ParaView, and shows it: its line in a render view, or its "
       "table."));
  this->OpenRecorded->setCheckable(false);

  auto* const all = new QVBoxLayout(panel);
  all->addLayout(grid);
  all->addWidget(this->Bar);
  all->addWidget(this->Felt);
  all->addWidget(this->Status);
  this->Why = new QToolButton(panel);
  this->Why->setObjectName("HapticWhy");
  this->Why->setText(tr("Why?"));
  this->Why->setCheckable(true);
  this->Why->setToolTip(tr("The whole status, with the cure."));
  all->addWidget(this->Why);
  all->addStretch(1);
  this->setWidget(panel);

  this->connect(refresh, &QToolButton::clicked, this, &HapticDock::listDevices);
  this->connect(help, &QToolButton::clicked, this, &HapticDock::onHelp);
  this->connect(this->Why, &QToolButton::toggled, this, &HapticDock::update);
  using Chosen = void (QComboBox::*)(int);
  this->connect(this->SecondDevice, static_cast<Chosen>(&QComboBox::currentIndexChanged), this,
    &HapticDock::onSecond);
  this->connect(this->Attach, &QPushButton::toggled, this, &HapticDock::onAttach);
  this->connect(this->Arm, &QPushButton::toggled, this->Controller, &HapticController::setArmed);
  this->connect(
    this->Touch, &QPushButton::toggled, this->Controller, &HapticController::setTouchMode);
  this->connect(this->Home, &QPushButton::clicked, this->Controller, &HapticController::home);
  this->connect(this->Record, &QPushButton::toggled, this, &HapticDock::onRecord);
  this->connect(
    this->OpenRecorded, &QPushButton::clicked, this->Controller, &HapticController::openRecorded);
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
void HapticDock::addChoices(QGridLayout* grid, int row)
{
  const auto addCombo = [&](int at, const char* name, const QString& text, const QString& tip)
  {
    auto* const combo = new QComboBox(this);
    combo->setObjectName(name);
    combo->setToolTip(tip);
    auto* const title = new QLabel(text, this);
    title->setBuddy(combo);
    grid->addWidget(title, at, 0);
    grid->addWidget(combo, at, 1, 1, 2);
    return combo;
  };
  this->Preset = addCombo(row, "HapticPreset", tr("Preset"),
    tr("What the tissues feel like. Custom: the functions of the filter. \"CT contrast\" is for CT "
       "in Hounsfield units. A filter that Attach makes begins with it."));
  this->Preset->addItem(tr("Proposed by the data"), QString());
  this->Preset->addItem("Custom", "Custom");
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const QString name = QString::fromStdString(names->GetValue(i));
    this->Preset->addItem(name, name);
  }
  this->Method = addCombo(row + 1, "HapticMethod", tr("Method"),
    tr("How the volume is felt. Key m in the view switches to the next one."));
  for (const VolumeHaptics::SettingChoice& method : VolumeHaptics::FilterSettingRows::MethodNames)
  {
    this->Method->addItem(tr(method.Text));
  }
  this->LoadPreset = this->addButton(grid, row + 2, 0, "HapticLoadPreset", tr("Load preset..."),
    tr("Loads functions from a file; they are used with Custom."));
  this->SavePreset = this->addButton(grid, row + 2, 1, "HapticSavePreset", tr("Save preset..."),
    tr("Saves what is felt now to a file, which can be loaded here, in Python or in "
       "volumehaptics-explore."));
  this->ShowAsCT = this->addButton(grid, row + 3, 0, "HapticShowAsCT", tr("Show as CT volume"),
    tr(
      "Renders the surface that the hand meets first, from skin to bone, at Hounsfield units. What "
      "the opacity hides is not felt."));
  for (QPushButton* const button : { this->LoadPreset, this->SavePreset, this->ShowAsCT })
  {
    button->setCheckable(false);
  }
  using Chosen = void (QComboBox::*)(int);
  this->connect(this->Preset, static_cast<Chosen>(&QComboBox::currentIndexChanged), this,
    [this]
    {
      const QString chosen = this->Preset->currentData().toString();
      if (!chosen.isEmpty())
      {
        this->Controller->setPreset(chosen);
      }
    });
  this->connect(this->Method, static_cast<Chosen>(&QComboBox::currentIndexChanged),
    this->Controller, &HapticController::setMethod);
  this->connect(this->LoadPreset, &QPushButton::clicked, this, &HapticDock::onLoadPreset);
  this->connect(this->SavePreset, &QPushButton::clicked, this, &HapticDock::onSavePreset);
  this->connect(
    this->ShowAsCT, &QPushButton::clicked, this->Controller, &HapticController::showAsCT);
}

//------------------------------------------------------------------------------
void HapticDock::showChoices(const HapticController::Figures& now)
{
  this->LoadPreset->setEnabled(now.HasTouch);
  this->SavePreset->setEnabled(now.Attached);
  this->ShowAsCT->setEnabled(now.CanShow);
  if (!now.HasTouch)
  {
    return;
  }
  const QSignalBlocker presets(this->Preset);
  const QSignalBlocker methods(this->Method);
  int at = this->Preset->findText(now.Preset);
  if (at < 0) // the preset comes from a script or a file, so it is not in the list yet
  {
    this->Preset->addItem(now.Preset, now.Preset);
    at = this->Preset->count() - 1;
  }
  // Don't change a list while the user has it open.
  if (!this->Preset->view()->isVisible())
  {
    this->Preset->setCurrentIndex(at);
  }
  if (!this->Method->view()->isVisible())
  {
    this->Method->setCurrentIndex(now.Method);
  }
}

//------------------------------------------------------------------------------
QString HapticDock::askFile(
  const char* name, const QString& title, const QString& kinds, bool isNew)
{
  // Use a dialog for the client's files, because the client reads and writes the file even if the
  // data are on a server.
  pqFileDialog dialog(nullptr, this, title, QString(), kinds);
  dialog.setObjectName(name);
  dialog.setFileMode(isNew ? pqFileDialog::AnyFile : pqFileDialog::ExistingFile);
  return dialog.exec() == QDialog::Accepted && !dialog.getSelectedFiles().isEmpty()
    ? dialog.getSelectedFiles().first()
    : QString();
}

//------------------------------------------------------------------------------
void HapticDock::onLoadPreset()
{
  const QString file =
    this->askFile("HapticLoadPresetDialog", tr("Load a preset"), tr("Presets (*.json)"), false);
  if (!file.isEmpty())
  {
    this->Controller->loadPreset(file);
  }
}

void HapticDock::onSavePreset()
{
  const QString file =
    this->askFile("HapticSavePresetDialog", tr("Save the preset"), tr("Presets (*.json)"), true);
  if (!file.isEmpty())
  {
    this->Controller->savePreset(file);
  }
}

//------------------------------------------------------------------------------
void HapticDock::listDevices()
{
  const QList<HapticController::DeviceChoice> choices = HapticController::listDevices();
  for (QComboBox* const list : { this->Device, this->SecondDevice })
  {
    const QSignalBlocker blocker(list);
    const QString chosen = list->currentData().toString();
    list->clear();
    if (list == this->SecondDevice)
    {
      list->addItem(tr("No second hand"), QString());
    }
    for (const HapticController::DeviceChoice& choice : choices)
    {
      // Show only the first sentence of the state, which may include the cure; the tool tip shows
      // the full text.
      const QString state = choice.State.section(". ", 0, 0);
      list->addItem(QString("%1: %2").arg(choice.Id, state), choice.Id);
      list->setItemData(list->count() - 1, choice.Name + "\n" + choice.State, Qt::ToolTipRole);
    }
    list->setCurrentIndex(std::max(0, list->findData(chosen)));
  }
}

//------------------------------------------------------------------------------
void HapticDock::onSecond()
{
  this->Told.clear();
  this->Controller->setSecondDevice(this->SecondDevice->currentData().toString());
  this->update();
}

//------------------------------------------------------------------------------
void HapticDock::onAttach(bool on)
{
  this->Told.clear();
  if (on)
  {
    this->Controller->attach(this->Device->currentData().toString(),
      this->Preset->currentData().toString(), this->Method->currentIndex());
    this->Controller->setSecondDevice(this->SecondDevice->currentData().toString());
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
    file = this->askFile("HapticRecordDialog", tr("Record to"),
      tr("Traces (*.vtp);;Comma separated values (*.csv)"), true);
    if (file.isEmpty())
    {
      SetChecked(this->Record, false);
      return;
    }
  }
  this->Controller->record(file);
}

//------------------------------------------------------------------------------
void HapticDock::onTold(const QString& message)
{
  this->Told = message;
}

//------------------------------------------------------------------------------
void HapticDock::onHelp()
{
  auto* const window = new QDialog(this);
  window->setObjectName("HapticHelpWindow");
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setWindowTitle(tr("Volume Haptics: help"));
  window->resize(700, 600);
  auto* const page = new QTextBrowser(window);
  page->setObjectName("HapticHelpPage");
  page->setOpenExternalLinks(true);
  QString text = tr("<h2>This window</h2><p>Select a volume in the pipeline browser, click on a "
                    "render view, choose a "
                    "device and press Attach. Arm lets force through, Stop and Escape end it at "
                    "once. Touch with the "
                    "mouse leads the virtual device.</p><dl>");
  for (const auto* const widget : this->widget()->findChildren<QWidget*>())
  {
    const auto* const button = qobject_cast<const QAbstractButton*>(widget);
    const bool isSecond = widget == this->SecondDevice;
    const QString name = button       ? button->text()
      : isSecond                      ? tr("Second device")
      : widget->inherits("QComboBox") ? QString(widget->objectName()).remove("Haptic")
                                      : QString();
    if (!widget->toolTip().isEmpty() && !name.isEmpty())
    {
      text += QString("<dt><b>%1</b></dt><dd>%2</dd>")
                .arg(name.toHtmlEscaped(), widget->toolTip().toHtmlEscaped());
    }
  }
  page->setHtml(text + "</dl>" + HapticController::describeAll());
  auto* const all = new QVBoxLayout(window);
  all->addWidget(page);
  window->show();
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
  this->Force->setText(now.HasSecond
      ? tr("%1 N, %2 N").arg(now.Force, 0, 'f', 2).arg(now.SecondForce, 0, 'f', 2)
      : tr("%1 N").arg(now.Force, 0, 'f', 2));
  this->Bar->setValue(now.MaximumForce > 0.0
      ? static_cast<int>(std::min(1.0, now.Force / now.MaximumForce) * BarSteps)
      : 0);
  this->Bar->setToolTip(tr("Up to %1 N").arg(now.MaximumForce));
  this->Rate->setText(now.Attached
      ? tr("%1 Hz, %2 missed").arg(now.TickRate, 0, 'f', 0).arg(now.MissedTicks)
      : QString());
  this->showChoices(now);
  const bool isHidden = now.Attached && !now.IsVolume;
  this->Felt->setText(!now.Attached ? QString()
      : isHidden                    ? now.Felt + "\n" +
        tr(
          "Nothing is rendered as a volume in this view, so that everything is felt: press Show as "
          "CT volume, or choose the representation Volume.")
                 : now.Felt);
  this->OpenRecorded->setVisible(!now.Recorded.isEmpty());
  this->OpenRecorded->setText(tr("Open %1").arg(QFileInfo(now.Recorded).fileName()));
  // Show only the first sentence of a status; the button Why shows the rest. A fault is always
  // shown in full.
  const bool isStatus = now.Attached && (this->Told.isEmpty() || now.IsFault);
  const auto shorten = [this](const QString& status)
  {
    const QString first = status.section(". ", 0, 0);
    return this->Why->isChecked() || first == status ? status : first + ".";
  };
  QStringList lines;
  if (isStatus)
  {
    lines << shorten(now.Status);
  }
  if (isStatus && now.HasSecond)
  {
    lines << shorten(now.SecondStatus);
  }
  if (!this->Told.isEmpty())
  {
    lines << this->Told;
  }
  else if (!now.Attached)
  {
    lines << tr("Select a volume and a render view, and attach.");
  }
  this->Status->setText(lines.join("\n"));
  this->Status->setToolTip(isStatus ? now.Status : QString());
  this->Why->setVisible(isStatus && now.Status.contains(". "));
}
