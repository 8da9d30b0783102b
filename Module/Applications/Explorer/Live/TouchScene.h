// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TouchScene_h
#define Explore_TouchScene_h

#include "Applications/Explorer/Bar/CommandTable.h"
#include "Applications/Explorer/Scene/ExplorerScene.h"

#include "vtkCamera.h"
#include "vtkHapticDevice.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurementRepresentation.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticRepresentation.h"
#include "vtkHapticSetup.h"
#include "vtkHapticSliceView.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

namespace Explore
{
/// Fraction of the window's width that is given to slices beside the scene.
constexpr double SLICE_SHARE = 0.3;

/// The devices of the window: see vtkHapticDevice::Open and SetFirmwareFile.
struct DeviceChoice
{
  std::string Id = "virtual";
  std::string SecondId; // device of the other hand; empty if there is none
  std::string Firmware; // empty: the file named by the environment variable
  // force (N) of a stick at full scale, along x and y
  std::array<double, 2> Newtons{ 100.0, 100.0 };
};

/// Devices that are open, but not started yet; null if there are none.
struct OpenDevices
{
  vtkSmartPointer<vtkHapticDevice> First;
  vtkSmartPointer<vtkHapticDevice> Second;
};

/// Opens the devices of a window. Throws InputError if that fails.
OpenDevices OpenDevicesOf(const DeviceChoice& choice);

/// A touchable scene: the volume, a device with a running servo, and all displays of the device's
/// state. Hidden tissue can't be felt.
struct TouchScene
{
  CommandTable Commands; // declared before the parts that add commands
  ExplorerScene Scene;
  vtkSmartPointer<vtkHapticDevice> Device; // null: BuildTouchScene opens it
  vtkNew<vtkHapticRepresentation> Hand;
  vtkSmartPointer<vtkHapticDevice> SecondDevice; // null if there is no second hand
  vtkNew<vtkHapticRepresentation> SecondHand;
  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticSliceView> Slices;
  VolumeCut Cut;
  vtkNew<vtkHapticMeasurements> Measurements;
  vtkNew<vtkHapticMeasurementRepresentation> Measured;
  vtkNew<vtkHapticSetup> Setup;
  vtkNew<vtkInteractorStyleHaptic> Style;
};

/// Fills the scene, opens the device and starts the servo. Throws InputError if the device can't be
/// opened.
void BuildTouchScene(TouchScene& touch, const Exploration& exploration, const SceneOptions& options,
  const DeviceChoice& device);

/// The parts of the window that stay the same for the next volume.
struct WindowPlace
{
  vtkSmartPointer<vtkRenderWindow> Window; // null: a new one is opened
  vtkSmartPointer<vtkCamera> View;         // null: the whole volume is shown
};

/// A file that a window shows, or that the user has chosen to open next.
struct FileChoice
{
  std::string Path;
  int Series = 0;         // see LoadVolumes
  bool AsLabels = false;  // whether the values are shown as labels
  WindowPlace Place = {}; // state of the window in which the file was chosen
  // whether the volume consists of several files, of which this is the first
  bool HasMoreFiles = false;
};

/// Options of the window. A file without a name is not read. If the measurements have no file name,
/// Ctrl+S saves them to the first free file of measurements-001.mrk.json ...
struct WindowOptions
{
  std::string Setup;
  std::string Measurements;
  std::string Script;
  std::string Movie;
  bool Sound = false;
  std::string Tool;   // "needle", "burr", a file, or empty for a point
  std::string Replay; // file of a recorded touch to show
  FileChoice File;
  std::string Notice;              // notice shown when the window opens
  bool BringBack = false;          // whether to restore unsaved work (KeptWork.h)
  OpenDevices Devices;             // devices that were opened before the volume was read
  vtkSmartPointer<vtkCamera> View; // initial camera; null: the whole volume is shown
};

/// Shows the scene in a window until it closes. Loads the files of the options first, if they
/// exist, and saves them at the end. Returns the file to open next; its path is empty if there is
/// none. Throws InputError if a file can't be read.
FileChoice RunTouchWindow(vtkRenderWindow* window, const Exploration& exploration,
  const SceneOptions& options, const DeviceChoice& device, const WindowOptions& wanted);
} // namespace Explore

#endif
