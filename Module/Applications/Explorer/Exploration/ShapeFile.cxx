// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/ShapeFile.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/WholeFile.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <cstdlib>
#include <istream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace
{
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& name)
{
  const auto make = [&name](auto reader) -> vtkSmartPointer<vtkAlgorithm>
  {
    reader->SetFileName(name.c_str());
    return reader;
  };
  const std::string ending = Explore::GetEnding(name);
  return ending == ".stl" ? make(vtkSmartPointer<vtkSTLReader>::New())
    : ending == ".ply"    ? make(vtkSmartPointer<vtkPLYReader>::New())
    : ending == ".vtk"    ? make(vtkSmartPointer<vtkPolyDataReader>::New())
    : ending == ".obj"    ? make(vtkSmartPointer<vtkOBJReader>::New())
                          : make(vtkSmartPointer<vtkXMLPolyDataReader>::New());
}

/// Returns the size (bytes) of a type of numbers in a .ply; 0 if the type is unknown.
std::size_t GetPlySize(const std::string& type)
{
  const std::map<std::string, std::size_t> sizes = { { "char", 1 }, { "int8", 1 }, { "uchar", 1 },
    { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 }, { "int", 4 },
    { "int32", 4 }, { "uint", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

struct PlyProperty
{
  std::size_t CountSize = 0; ///< size of the number of elements of a list (bytes); 0 if it is not a
                             ///< list
  std::size_t Size = 0;      ///< bytes of a number
};
struct PlyElements
{
  double Count = 0.0;
  std::vector<PlyProperty> Properties;
};

/// Whether a binary element is complete. Moves `at` to its end.
bool SkipBinary(const PlyElements& kind, const std::string& bytes, bool isBig, std::size_t& at)
{
  for (const PlyProperty& property : kind.Properties)
  {
    std::size_t numbers = 1;
    if (property.CountSize > 0)
    {
      numbers = 0;
      for (std::size_t i = 0; i < property.CountSize && at + i < bytes.size(); ++i)
      {
        const std::size_t shift = 8 * (isBig ? property.CountSize - 1 - i : i);
        numbers |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i])) << shift;
      }
      at += property.CountSize;
    }
    if (at > bytes.size() || numbers > (bytes.size() - at) / property.Size)
    {
      return false;
    }
    at += numbers * property.Size;
  }
  return true;
}

/// Reads a line of text. Returns whether it has all values of an element.
bool SkipLine(const PlyElements& kind, std::istream& text)
{
  std::string line;
  std::getline(text, line);
  std::istringstream words(line);
  double number = 0.0;
  for (const PlyProperty& property : kind.Properties)
  {
    words >> number;
    for (double left = property.CountSize > 0 ? number : 0.0; left > 0.0 && words; --left)
    {
      words >> number;
    }
  }
  return static_cast<bool>(words);
}

/// Whether a .ply has all elements that its header promises. Without them, VTK's reader continues,
/// and frees memory that it never had. Accepts a header that this function does not support, and
/// leaves it to the reader.
bool HasAllElements(const std::string& name)
{
  std::vector<PlyElements> kinds;
  std::string format, line;
  vtksys::ifstream in(name.c_str(), std::ios::binary);
  while (std::getline(in, line) && line.find("end_header") != 0)
  {
    std::istringstream words(line);
    std::string word, first, second, third;
    words >> word >> first >> second >> third;
    if (word == "format")
    {
      format = first;
    }
    else if (word == "element")
    {
      kinds.push_back({ std::strtod(second.c_str(), nullptr), {} });
    }
    else if (word == "property" && !kinds.empty())
    {
      const bool isList = first == "list";
      kinds.back().Properties.push_back(
        { isList ? GetPlySize(second) : 0, GetPlySize(isList ? third : first) });
      if (kinds.back().Properties.back().Size == 0)
      {
        return true;
      }
    }
  }
  std::string bytes;
  if (format != "ascii")
  {
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  std::size_t at = 0;
  for (const PlyElements& kind : kinds)
  {
    for (double i = 0.0; i < kind.Count; ++i)
    {
      if (!(format == "ascii" ? SkipLine(kind, in)
                              : SkipBinary(kind, bytes, format == "binary_big_endian", at)) ||
        kind.Properties.empty())
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether a binary .stl has all triangles that its head promises. VTK's reader continues without
/// them.
bool HasAllTriangles(const std::string& name)
{
  constexpr std::size_t head = 84, triangle = 50; // bytes
  const std::size_t size = vtksys::SystemTools::FileLength(name);
  vtksys::ifstream in(name.c_str(), std::ios::binary);
  unsigned char start[head + 1024] = {};
  in.read(reinterpret_cast<char*>(start), sizeof(start));
  const std::string text(
    reinterpret_cast<const char*>(start), static_cast<std::size_t>(in.gcount()));
  if (text.find("solid") == 0 && text.find("facet") != std::string::npos)
  {
    return true; // a text, which the reader checks
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    count |= static_cast<std::size_t>(start[head - 4 + i]) << (8 * i);
  }
  return size >= head + triangle * count;
}

bool HasAllPoints(vtkPolyData* shape)
{
  for (vtkCellArray* const cells :
    { shape->GetVerts(), shape->GetLines(), shape->GetPolys(), shape->GetStrips() })
  {
    vtkDataArray* const ids = cells->GetConnectivityArray();
    for (vtkIdType i = 0; i < cells->GetNumberOfConnectivityIds(); ++i)
    {
      const double id = ids->GetComponent(i, 0);
      if (id < 0.0 || id >= static_cast<double>(shape->GetNumberOfPoints()))
      {
        return false;
      }
    }
  }
  return true;
}
} // namespace

namespace Explore
{
std::string GetEnding(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& name, std::string& error)
{
  error = GetEnding(name) == ".vtp" ? DetectMissingEnd(name) : DetectDevice(name);
  if (!error.empty())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkAlgorithm> reader = MakeReader(name);
  const auto check = [&name]
  {
    const std::string ending = GetEnding(name);
    const bool isWhole =
      (ending != ".ply" || HasAllElements(name)) && (ending != ".stl" || HasAllTriangles(name));
    return isWhole ? std::string() : "its header promises elements that are not in the file";
  };
  const bool isRead = ReadChecked(reader, error, check);
  const vtkSmartPointer<vtkPolyData> shape =
    vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  if (isRead && shape && HasAllPoints(shape))
  {
    return shape;
  }
  error = !error.empty() ? error
    : isRead && shape    ? "it has a cell with a point that does not exist"
                         : "it is damaged";
  return nullptr;
}

vtkSmartPointer<vtkPolyData> ReadShapeFile(
  const std::string& option, const std::string& name, const std::string& cure)
{
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    throw InputError(option + " " + name, "there is no such file", "name one that is there");
  }
  std::string error;
  vtkSmartPointer<vtkPolyData> shape = ReadPolyData(name, error);
  if (!shape)
  {
    throw InputError(option + " " + name, "it can't be read: " + error, cure);
  }
  return shape;
}
} // namespace Explore
