// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandTool_h
#define Explore_HandTool_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkHapticBurr.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticPointShell.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Switches the tool in the window's hand. Key w switches to the next tool: needle, burr, the tool
/// of a file if there is one, and point. Ctrl+Z and Ctrl+Y undo and redo strokes of the burr while
/// it is in the hand. Ctrl+E writes the track of a needle in tissue to track-001.vtp, or what a
/// burr has removed to removal-001.vti, or to the next free number.
///
/// Where the label table sets no shaft friction, all values above that of the outer surface rub
/// along the needle. For the other tools, these values are solid. With a preset for CT,
/// vtkHapticNeedle::ApplyPreset() sets how the needle cuts. The burr has a radius of four voxels.
/// The energy for removing tissue grows with the value, from that of the outer surface to the
/// largest one.
class HandTool
{
public:
  HandTool(TouchScene& touch, const Exploration& exploration, const std::string& tool);
  ~HandTool();
  HandTool(const HandTool&) = delete;
  HandTool& operator=(const HandTool&) = delete;

  /// Returns whether the burr has removed tissue since a file was last written.
  bool HasUnwrittenRemoval() const;

private:
  void AddCommands();
  bool HasShape() const { return this->Shape->GetMesh() != nullptr; }
  void ChangeTool();
  void Hold(vtkHapticTool* tool);
  /// Shows a text in the window, and prints it to the terminal.
  void Tell(const std::string& text);
  void Write();
  void WriteTrack();
  void WriteRemoval();

  TouchScene& Touch;
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkHapticNeedle> Needle;
  vtkNew<vtkHapticBurr> Burr;
  vtkNew<vtkHapticPointShell> Shape;
  double WrittenVolume = 0.0; ///< removed volume in the last written file (mm^3)
};
} // namespace Explore

#endif
