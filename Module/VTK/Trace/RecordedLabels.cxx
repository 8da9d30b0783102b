// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/RecordedLabels.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/JsonText.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include "vtksys/SystemTools.hxx"

namespace VolumeHaptics
{

bool ReadSettingsBeside(const std::string& csv, std::string& settings, std::string& error)
{
  settings.clear();
  // bytes; the file has one tuple per placement of the device
  constexpr std::size_t largest = 64 << 20;
  const std::string file = csv + ".json";
  if (!vtksys::SystemTools::FileExists(file))
  {
    return true;
  }
  std::string text;
  std::string fault;
  Json::Value root;
  if (!ReadSmallFile(file, largest, text, fault) || !ParseJson(text, root, fault))
  {
    error = "The settings of the recording, " + Printable(file) +
      ", can't be read: " + Printable(fault) +
      " Bring back the file as it was written, or remove it to feel the path with "
      "the settings that there are.";
    return false;
  }
  if (root.isObject() && root[RecordingNames::Settings].isString())
  {
    settings = root[RecordingNames::Settings].asString();
  }
  return true;
}

void SetRecordedSettings(vtkPolyData* path, const std::string& settings)
{
  vtkNew<vtkStringArray> array;
  array->SetName(RecordingNames::Settings);
  array->InsertNextValue(settings);
  path->GetFieldData()->AddArray(array);
}

std::string FindRecordedSetting(vtkPolyData* recording, const std::string& prefix)
{
  auto* const settings = vtkStringArray::SafeDownCast(
    recording->GetFieldData()->GetAbstractArray(RecordingNames::Settings));
  if (!settings || settings->GetNumberOfValues() == 0)
  {
    return {};
  }
  const std::string text = "\n" + settings->GetValue(0);
  const std::size_t found = text.find("\n" + prefix);
  if (found == std::string::npos)
  {
    return {};
  }
  const std::size_t begin = found + 1 + prefix.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

bool IsOlderThanMaterialPlacement(vtkPolyData* recording)
{
  return !FindRecordedSetting(recording, "ContactAlignment: ").empty() &&
    FindRecordedSetting(recording, "MaterialPlacement: ").empty();
}

bool HasFineLabels(vtkPolyData* recording)
{
  return !recording || FindRecordedSetting(recording, RecordingNames::DeviceRate).empty() ||
    !FindRecordedSetting(recording, RecordingNames::LabelGrid).empty();
}

std::string ReadLabelHash(vtkPolyData* recording)
{
  return FindRecordedSetting(recording, RecordingNames::LabelHash);
}

std::string CompareLabels(vtkPolyData* path, const std::string& hash)
{
  const std::string recorded = ReadLabelHash(path);
  if (recorded.empty() || recorded == hash)
  {
    return {};
  }
  const std::string cure =
    "Connect the same label image to input port 3 with SetLabelConnection, and give the same "
    "table with SetLabelTable, which the field array Settings shows. Or, to feel its path with "
    "the labels that there are, remove this array, or the file .csv.json of a table.";
  return "The recording on input port 1 was made with labels" +
    (hash.empty() ? ", and there is no label image. "
                  : " of the hash " + Printable(recorded) + ", and those on input port 3 have " +
          hash + " (HashLabels): they are others. ") +
    cure;
}

} // namespace VolumeHaptics
