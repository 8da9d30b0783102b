// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/PolyDataReading.h"

#include "VTK/Base/XmlFiles.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace VolumeHaptics
{

vtkSmartPointer<vtkPolyData> ReadXmlPolyData(const std::string& file, bool& failed)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  failed = !ReadXmlFile(reader, file) || failed;
  return reader->GetOutput();
}

} // namespace VolumeHaptics
