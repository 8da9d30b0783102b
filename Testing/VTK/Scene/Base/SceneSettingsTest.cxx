// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the scene's public headers document the same settings as the lists of settings. */

#include "Rigs/SettingChecks.h"
#include "VTK/Experimental/HapticXRControllerSettings.h"
#include "VTK/Scene/Display/HapticDisplaySettings.h"
#include "VTK/Scene/Display/HapticMeasurementViewSettings.h"
#include "VTK/Scene/Editor/HapticEditorSettings.h"
#include "VTK/Scene/Hand/HapticRepresentationSettings.h"
#include "VTK/Scene/Interaction/HapticStyleSettings.h"
#include "VTK/Scene/Slices/HapticSliceViewSettings.h"

using namespace settingtest;
using namespace VolumeHaptics;

TEST(SceneSettings, HeadersHaveTheDefaultsAndKeepTheRanges)
{
  ExpectHeadersBehave<vtkHapticRepresentation>(RepresentationSettings);
  ExpectHeadersBehave<vtkHapticFunctionEditor>(EditorSettings);
  ExpectHeadersBehave<vtkHapticHeadUpDisplay>(DisplaySettings);
  ExpectHeadersBehave<vtkHapticMeasurementRepresentation>(MeasurementViewSettings);
  ExpectHeadersBehave<vtkHapticSliceView>(SliceViewSettings);
  ExpectHeadersBehave<vtkHapticXRController>(XRControllerSettings);
  ExpectHeadersBehave<vtkInteractorStyleHaptic>(StyleSettings);
}

TEST(SceneSettings, EveryMacroOfTheHeadersHasARow)
{
  std::vector<std::string> representation = Names(RepresentationSettings);
  representation.insert(representation.end(), { "WorldUnitName", "TrailArrayName" }); // texts
  ExpectRows("vtkHapticRepresentation", representation);
  ExpectRows("vtkHapticFunctionEditor", Names(EditorSettings));
  std::vector<std::string> display = Names(DisplaySettings);
  for (const char* text : { "HelpText", "Hint", "Notice", "RecordingText", "SettingsText" })
  {
    display.emplace_back(text);
  }
  ExpectRows("vtkHapticHeadUpDisplay", display);
  ExpectRows("vtkHapticMeasurementRepresentation", Names(MeasurementViewSettings));
  std::vector<std::string> slices = Names(SliceViewSettings);
  slices.emplace_back("Unit"); // a text
  ExpectRows("vtkHapticSliceView", slices);
  std::vector<std::string> controller = Names(XRControllerSettings);
  controller.emplace_back("ActionName"); // a text
  ExpectRows("vtkHapticXRController", controller);
  ExpectRows("vtkInteractorStyleHaptic", Names(StyleSettings));
}

TEST(SceneSettings, CommentsOfTheHeadersBeginWithTheDocumentation)
{
  ExpectComments("vtkHapticRepresentation", RepresentationSettings);
  ExpectComments("vtkHapticFunctionEditor", EditorSettings);
  ExpectComments("vtkHapticHeadUpDisplay", DisplaySettings);
  ExpectComments("vtkHapticMeasurementRepresentation", MeasurementViewSettings);
  ExpectComments("vtkHapticSliceView", SliceViewSettings);
  ExpectComments("vtkHapticXRController", XRControllerSettings);
  ExpectComments("vtkInteractorStyleHaptic", StyleSettings);
}
