// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes VTK's XML files without VTK's own error messages.
 */
#ifndef XmlFiles_h
#define XmlFiles_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkPolyData;
class vtkXMLReader;
class vtkXMLWriter;

namespace VolumeHaptics
{

/**
 * Reads a file. Returns false after an error; the reader's output then has the part that could be
 * read.
 */
bool ReadXmlFile(vtkXMLReader* reader, const std::string& file);
/**
 * Writes the whole file or none of it. On failure, returns false, with the reason and the cure in
 * `error`.
 */
bool WriteXmlFile(
  vtkXMLWriter* writer, vtkDataObject* data, const std::string& file, std::string& error);

/** Reads as much of a file as possible. Sets `failed` to true after an error. */
vtkSmartPointer<vtkPolyData> ReadXmlPolyData(const std::string& file, bool& failed);

} // namespace VolumeHaptics

#endif
