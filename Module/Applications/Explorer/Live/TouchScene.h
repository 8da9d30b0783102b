// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TouchScene_h
#define Explore_TouchScene_h

#include "Applications/Explorer/Scene/ExplorerScene.h"

#include "vtkHapticDevice.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurementRepresentation.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticRepresentation.h"
#include "vtkHapticSetup.h"
#include "vtkHapticSliceView.h"
#include "vtkInteractorStyleHaptic.h"

#include <array>
#include <string>

namespace Explore
{
/// The fraction of the window's width for slices beside the scene.
constexpr double SLICE_SHARE = 0.3;

/// The device of the window: see vtkHapticDevice::Open and SetFirmwareFile.
struct DeviceChoice
{
  std::string Id = "virtual";
  std::string Firmware;                          // empty: that of the environment variable
  std::array<double, 2> Newtons{ 100.0, 100.0 }; // newtons of a stick at full scale, along x and y
};

/// A scene that can be touched: the volume, and a device with a running servo, with all displays of
/// its state. Hidden tissue is not felt.
struct TouchScene
{
  ExplorerScene Scene;
  vtkNew<vtkHapticDevice> Device;
  vtkNew<vtkHapticRepresentation> Hand;
  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticSliceView> Slices;
  VolumeCut Cut;
  vtkNew<vtkHapticMeasurements> Measurements;
  vtkNew<vtkHapticMeasurementRepresentation> Measured;
  vtkNew<vtkHapticSetup> Setup;
  vtkNew<vtkInteractorStyleHaptic> Style;
};

/// Fills the scene, opens the device and starts its servo. Throws InputError if the device can't be
/// opened.
void BuildTouchScene(TouchScene& touch, const Exploration& exploration, const SceneOptions& options,
  const DeviceChoice& device);

/// The file that a window shows.
struct FileChoice
{
  std::string Path;
  int Series = 0;        // number of the series in a DICOM folder
  bool AsLabels = false; // whether a label map is shown as labels
};

/// Options of the window; files without a name are not read. The key S saves measurements without a
/// name to the first free of measurements-001.mrk.json ...
struct WindowOptions
{
  std::string Setup;
  std::string Measurements;
  std::string Script;
  std::string Movie;
  bool Sound = false;
  std::string Tool;   // "needle", "burr", a file, or empty for a point
  std::string Replay; // a recording of a touch to show
  FileChoice File;
  std::string Notice;     // notice at the beginning
  bool BringBack = false; // whether unsaved work is restored; see KeptWork.h
};

/// Shows the scene in a window and returns when it is closed, with the file to open next, or an
/// empty path. Loads the files first, if they exist, and saves them at the end. Throws InputError
/// if a file can't be read.
FileChoice RunTouchWindow(vtkRenderWindow* window, const Exploration& exploration,
  const SceneOptions& options, const DeviceChoice& device, const WindowOptions& wanted);
} // namespace Explore

#endif
