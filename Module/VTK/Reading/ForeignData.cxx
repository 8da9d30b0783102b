// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/ForeignData.h"

#include "Core/Platform/ReaderProcess.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/WholeFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <istream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
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

/// Returns the size (bytes) of a number type of the PLY format; 0 if the type is unknown.
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
  std::size_t CountSize = 0; ///< size (bytes) of the length of a list; 0 for a single number
  std::size_t Size = 0;      ///< bytes per number
};
struct PlyElements
{
  double Count = 0.0;
  std::vector<PlyProperty> Properties;
};

/// Moves `at` behind a binary element. Returns false if the element is incomplete.
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

/// Reads a line of text. Returns whether it contains all values of an element.
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

/// Returns whether a .ply file contains all elements that its header declares. If not, VTK's reader
/// continues and frees memory that it never allocated. A header that this function can't parse is
/// accepted and left to the reader.
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

/// Returns whether a binary .stl file contains all triangles that its header declares. VTK's reader
/// would continue without the missing ones.
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
    return true; // text format, which the reader checks itself
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

vtkSmartPointer<vtkPolyData> ReadHere(const std::string& name, std::string& error)
{
  error = Explore::GetEnding(name) == ".vtp" ? Explore::DetectMissingEnd(name)
                                             : Explore::DetectDevice(name);
  if (!error.empty())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkAlgorithm> reader = MakeReader(name);
  const auto check = [&name]
  {
    const std::string ending = Explore::GetEnding(name);
    const bool isWhole =
      (ending != ".ply" || HasAllElements(name)) && (ending != ".stl" || HasAllTriangles(name));
    return isWhole ? std::string() : "its header announces more elements than the file has";
  };
  const bool isRead = Explore::ReadChecked(reader, error, check);
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

using VolumeHaptics::BytePacker;
using VolumeHaptics::ByteUnpacker;

[[noreturn]] void ThrowFalse()
{
  throw std::runtime_error("its reader's answer contradicts itself");
}

std::size_t CountBytes(int type, std::uint64_t values)
{
  const std::uint64_t size = static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(type));
  return static_cast<std::size_t>(type == VTK_BIT ? (values + 7) / 8 : values * size);
}

void PackArray(vtkDataArray* array, BytePacker& packer)
{
  packer.PutText(array->GetName() ? array->GetName() : "");
  packer.Put(array->GetName() != nullptr);
  packer.Put(array->GetDataType());
  packer.Put(array->GetNumberOfComponents());
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const char* const name = array->GetComponentName(c);
    packer.PutText(name ? name : "");
  }
  packer.Put<std::uint64_t>(static_cast<std::uint64_t>(array->GetNumberOfTuples()));
  const auto values = static_cast<std::uint64_t>(array->GetNumberOfValues());
  packer.PutBytes(array->GetVoidPointer(0), CountBytes(array->GetDataType(), values));
}

vtkSmartPointer<vtkDataArray> UnpackArray(ByteUnpacker& unpacker)
{
  const std::string name = unpacker.GetText();
  const auto isNamed = unpacker.Get<bool>();
  const int type = unpacker.Get<int>();
  const int components = unpacker.Get<int>();
  constexpr int mostComponents = 1 << 16;
  std::vector<std::string> names;
  for (int c = 0; c < std::min(components, mostComponents); ++c)
  {
    names.push_back(unpacker.GetText());
  }
  const auto tuples = unpacker.Get<std::uint64_t>();
  constexpr std::uint64_t mostTuples = std::uint64_t{ 1 } << 40;
  constexpr int types[] = { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
    VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
    VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };
  const bool isNumber = std::find(std::begin(types), std::end(types), type) != std::end(types);
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(isNumber ? vtkDataArray::CreateDataArray(type) : nullptr);
  if (!array || components < 1 || components > mostComponents || tuples > mostTuples)
  {
    ThrowFalse();
  }
  const std::size_t size = CountBytes(type, tuples * static_cast<std::uint64_t>(components));
  const char* const bytes = unpacker.Take(size, 1); // checks that the bytes exist before memory is
                                                    // allocated
  array->SetName(isNamed ? name.c_str() : nullptr);
  array->SetNumberOfComponents(components);
  for (int c = 0; c < components; ++c)
  {
    const std::string& text = names[static_cast<std::size_t>(c)];
    text.empty() ? void() : array->SetComponentName(c, text.c_str());
  }
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  size > 0 ? std::memcpy(array->GetVoidPointer(0), bytes, size) : nullptr;
  return array;
}

void PackAttributes(vtkDataSetAttributes* attributes, BytePacker& packer)
{
  std::vector<int> numbers;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    attributes->GetArray(i) ? numbers.push_back(i) : void();
  }
  packer.Put<std::uint64_t>(numbers.size());
  for (const int i : numbers)
  {
    PackArray(attributes->GetArray(i), packer);
    packer.Put(attributes->IsArrayAnAttribute(i));
  }
}

void UnpackAttributes(ByteUnpacker& unpacker, vtkIdType tuples, vtkDataSetAttributes* attributes)
{
  for (auto left = unpacker.Get<std::uint64_t>(); left > 0; --left)
  {
    const vtkSmartPointer<vtkDataArray> array = UnpackArray(unpacker);
    const int use = unpacker.Get<int>();
    if (array->GetNumberOfTuples() != tuples)
    {
      ThrowFalse();
    }
    const int at = attributes->AddArray(array);
    if (use >= 0 && use < vtkDataSetAttributes::NUM_ATTRIBUTES)
    {
      attributes->SetActiveAttribute(at, use);
    }
  }
}

void PackFields(vtkFieldData* fields, BytePacker& packer)
{
  std::vector<vtkAbstractArray*> arrays;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = fields->GetAbstractArray(i);
    vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array)
      ? arrays.push_back(array)
      : void();
  }
  packer.Put<std::uint64_t>(arrays.size());
  for (vtkAbstractArray* const array : arrays)
  {
    auto* const texts = vtkStringArray::SafeDownCast(array);
    packer.Put(texts != nullptr);
    if (!texts)
    {
      PackArray(vtkDataArray::SafeDownCast(array), packer);
      continue;
    }
    packer.PutText(texts->GetName() ? texts->GetName() : "");
    packer.Put<std::uint64_t>(static_cast<std::uint64_t>(texts->GetNumberOfValues()));
    for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
    {
      packer.PutText(texts->GetValue(i));
    }
  }
}

void UnpackFields(ByteUnpacker& unpacker, vtkFieldData* fields)
{
  for (auto left = unpacker.Get<std::uint64_t>(); left > 0; --left)
  {
    if (!unpacker.Get<bool>())
    {
      fields->AddArray(UnpackArray(unpacker));
      continue;
    }
    vtkNew<vtkStringArray> texts;
    texts->SetName(unpacker.GetText().c_str());
    for (auto more = unpacker.Get<std::uint64_t>(); more > 0; --more)
    {
      texts->InsertNextValue(unpacker.GetText());
    }
    fields->AddArray(texts);
  }
}

void PackCells(vtkCellArray* cells, BytePacker& packer)
{
  std::vector<vtkIdType> offsets;
  std::vector<vtkIdType> ids;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, cell);
    offsets.push_back(cell->GetNumberOfIds());
    ids.insert(ids.end(), cell->begin(), cell->end());
  }
  packer.PutList(offsets);
  packer.PutList(ids);
}

vtkSmartPointer<vtkCellArray> UnpackCells(ByteUnpacker& unpacker, vtkIdType points)
{
  const std::vector<vtkIdType> sizes = unpacker.GetList<vtkIdType>();
  const std::vector<vtkIdType> ids = unpacker.GetList<vtkIdType>();
  for (const vtkIdType id : ids)
  {
    id < 0 || id >= points ? ThrowFalse() : void();
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::size_t at = 0;
  for (const vtkIdType size : sizes)
  {
    if (size < 0 || static_cast<std::size_t>(size) > ids.size() - at)
    {
      ThrowFalse();
    }
    cells->InsertNextCell(size, ids.data() + at);
    at += static_cast<std::size_t>(size);
  }
  return cells;
}
} // namespace

namespace Explore
{
void PackImage(vtkImageData* image, BytePacker& packer)
{
  packer.PutBytes(image->GetExtent(), 6 * sizeof(int));
  packer.PutBytes(image->GetOrigin(), 3 * sizeof(double));
  packer.PutBytes(image->GetSpacing(), 3 * sizeof(double));
  packer.PutBytes(image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
  PackAttributes(image->GetPointData(), packer);
  PackAttributes(image->GetCellData(), packer);
  PackFields(image->GetFieldData(), packer);
}

vtkSmartPointer<vtkImageData> UnpackImage(ByteUnpacker& unpacker)
{
  auto extent = unpacker.Get<std::array<int, 6>>();
  const auto origin = unpacker.Get<std::array<double, 3>>();
  const auto spacing = unpacker.Get<std::array<double, 3>>();
  const auto direction = unpacker.Get<std::array<double, 9>>();
  double samples = 1.0;
  for (std::size_t a = 0; a < extent.size(); a += 2)
  {
    samples *= std::max(0.0, 1.0 + extent[a + 1] - extent[a]);
  }
  constexpr double most = 1e12;
  if (samples > most)
  {
    ThrowFalse();
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent.data());
  image->SetOrigin(origin.data());
  image->SetSpacing(spacing.data());
  image->SetDirectionMatrix(direction.data());
  UnpackAttributes(unpacker, image->GetNumberOfPoints(), image->GetPointData());
  UnpackAttributes(unpacker, image->GetNumberOfCells(), image->GetCellData());
  UnpackFields(unpacker, image->GetFieldData());
  return image;
}

void PackPolyData(vtkPolyData* shape, BytePacker& packer)
{
  vtkNew<vtkPoints> none;
  PackArray((shape->GetPoints() ? shape->GetPoints() : none.Get())->GetData(), packer);
  for (vtkCellArray* const cells :
    { shape->GetVerts(), shape->GetLines(), shape->GetPolys(), shape->GetStrips() })
  {
    PackCells(cells, packer);
  }
  PackAttributes(shape->GetPointData(), packer);
  PackAttributes(shape->GetCellData(), packer);
}

vtkSmartPointer<vtkPolyData> UnpackPolyData(ByteUnpacker& unpacker)
{
  const vtkSmartPointer<vtkDataArray> places = UnpackArray(unpacker);
  if (places->GetNumberOfComponents() != 3)
  {
    ThrowFalse();
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  const vtkIdType count = points->GetNumberOfPoints();
  shape->SetVerts(UnpackCells(unpacker, count));
  shape->SetLines(UnpackCells(unpacker, count));
  shape->SetPolys(UnpackCells(unpacker, count));
  shape->SetStrips(UnpackCells(unpacker, count));
  UnpackAttributes(unpacker, count, shape->GetPointData());
  UnpackAttributes(unpacker, shape->GetNumberOfCells(), shape->GetCellData());
  return shape;
}

std::string GetEnding(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
}

std::string PackSurface(const std::string& name)
{
  VolumeHaptics::BytePacker packer;
  std::string error;
  const vtkSmartPointer<vtkPolyData> surface = ReadHere(name, error);
  packer.PutText(error);
  surface ? PackPolyData(surface, packer) : void();
  return std::move(packer.Bytes);
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& name, std::string& error)
{
  using VolumeHaptics::ReadResult;
  // Check the contents of VTK's XML formats before reading a file.
  std::string answer;
  const ReadResult result = GetEnding(name) == ".vtp"
    ? ReadResult::NoProcess
    : VolumeHaptics::AskReader(VolumeHaptics::ReadTask::Surface, name, answer);
  if (result == ReadResult::NoProcess)
  {
    return ReadHere(name, error);
  }
  error = answer;
  try
  {
    VolumeHaptics::ByteUnpacker unpacker(answer);
    error = result == ReadResult::Answered ? unpacker.GetText() : error;
    return error.empty() ? UnpackPolyData(unpacker) : nullptr;
  }
  catch (const std::exception& fault) // the answer is malformed
  {
    error = fault.what();
    return nullptr;
  }
}
} // namespace Explore
