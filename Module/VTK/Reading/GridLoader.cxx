// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/GridLoader.h"

#include "Core/Platform/ReaderProcess.h"
#include "VTK/Reading/ForeignData.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/WholeFile.h"
#include "VTK/Regions/DataSetParts.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGenericEnSightReader.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenFOAMReader.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkResampleToImage.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersion.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <sstream>
#include <utility>
#include <vector>
#include <vtksys/SystemTools.hxx>

namespace
{
vtkSmartPointer<vtkPolyData> DetectEdges(vtkDataSet* part)
{
  constexpr double sharp = 30.0; // degrees
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(part);
  // Merge the points, because the faces of a structured grid do not share points.
  vtkNew<vtkCleanPolyData> join;
  join->SetInputConnection(surface->GetOutputPort());
  join->ToleranceIsAbsoluteOn();
  join->SetAbsoluteTolerance(0.0);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(join->GetOutputPort());
  edges->SetFeatureAngle(sharp);
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}
} // namespace

namespace Explore
{
namespace
{
/// Makes lines that outline the cells of a grid: the sharp edges and the open borders of the
/// surfaces of its parts. If there are no such lines, makes the box around all parts.

vtkSmartPointer<vtkPolyData> MakeGridOutline(const std::vector<vtkDataSet*>& parts)
{
  vtkNew<vtkAppendPolyData> all;
  vtkBoundingBox box;
  vtkIdType lines = 0;
  for (vtkDataSet* const part : parts)
  {
    const vtkSmartPointer<vtkPolyData> edges = DetectEdges(part);
    lines += edges->GetNumberOfLines();
    all->AddInputData(edges);
    box.AddBounds(part->GetBounds());
  }
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkOutlineSource> corners;
  corners->SetBounds(bounds);
  vtkAlgorithm* const source = lines > 0 ? static_cast<vtkAlgorithm*>(all) : corners;
  source->Update();
  return vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
}
} // namespace
} // namespace Explore

namespace
{
using Explore::InputError;
using Explore::Volume;
using Files = vtksys::SystemTools;

/// Largest number of samples of the image; more would take minutes.
constexpr double MOST_SAMPLES = 1 << 25;

/// Kind of a file format, which determines the checks before VTK's reader runs.
enum class FileKind
{
  XML,    ///< XML, in which a truncated file is detected by its missing end
  BLOCKS, ///< XML that refers to other files at any place
  LEGACY, ///< a file whose faults VTK's reader detects
  CASE    ///< a file that refers to files beside it, which VTK's reader opens
};

struct Format
{
  const char* Ending;
  const char* Name;
  vtkSmartPointer<vtkAlgorithm> (*MakeReader)(const std::string& path);
  FileKind Kind;
  double MetersPerUnit = 0.001; // 1 for OpenFOAM, which uses metres; other formats do not define a
                                // unit
};

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// Makes a reader for EnSight files, which needs folder and name separately to find the other
/// files.
vtkSmartPointer<vtkAlgorithm> MakeEnSightReader(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
  reader->SetFilePath(Files::GetFilenamePath(Files::CollapseFullPath(path)).c_str());
  reader->SetCaseFileName(Files::GetFilenameName(path).c_str());
  return reader;
}

const Format FORMATS[] = {
  { ".vtu", "VTK unstructured grid", MakeReader<vtkXMLGenericDataObjectReader>, FileKind::XML },
  { ".vtr", "VTK rectilinear grid", MakeReader<vtkXMLGenericDataObjectReader>, FileKind::XML },
  { ".vts", "VTK structured grid", MakeReader<vtkXMLGenericDataObjectReader>, FileKind::XML },
  { ".vtm", "VTK multi-block data set", MakeReader<vtkXMLGenericDataObjectReader>,
    FileKind::BLOCKS },
  { ".vtmb", "VTK multi-block data set", MakeReader<vtkXMLGenericDataObjectReader>,
    FileKind::BLOCKS },
  { ".vtk", "legacy VTK", MakeReader<vtkGenericDataObjectReader>, FileKind::LEGACY },
  { ".foam", "OpenFOAM case", MakeReader<vtkOpenFOAMReader>, FileKind::CASE, 1.0 },
  { ".case", "EnSight case", MakeEnSightReader, FileKind::CASE },
};

const Format* FindFormat(const std::string& path)
{
  const std::string ending = Files::LowerCase(Files::GetFilenameLastExtension(path));
  const Format* const found = std::find_if(std::begin(FORMATS), std::end(FORMATS),
    [&](const Format& format) { return ending == format.Ending; });
  return found == std::end(FORMATS) ? nullptr : found;
}

[[noreturn]] void ThrowUnreadable(
  const std::string& path, const Format& format, const std::string& detail)
{
  throw InputError(path,
    std::string("cannot be read as ") + format.Name + (detail.empty() ? "" : " (" + detail + ")"),
    "check what the file really is, export it again, and check that the copy is complete");
}

/// Reads a file, and only its last time if it has several. Throws InputError if nothing could be
/// read.
vtkSmartPointer<vtkDataObject> Read(const std::string& path, const Format& format, Volume& volume)
{
  const vtkSmartPointer<vtkAlgorithm> reader = format.MakeReader(path);
  // Check before the reader runs, because it opens the other files that the file refers to.
  const bool isXml = format.Kind == FileKind::XML || format.Kind == FileKind::BLOCKS;
  std::string detail = isXml ? Explore::DetectMissingEnd(path)
    : format.Kind == FileKind::CASE
    ? Explore::DetectDeviceIn(Files::GetFilenamePath(Files::CollapseFullPath(path)))
    : std::string();
  const auto chooseTime = [&]
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const information = reader->GetOutputInformation(0);
    const int times = information && information->Has(Pipeline::TIME_STEPS())
      ? information->Length(Pipeline::TIME_STEPS())
      : 0;
    if (times > 1)
    {
      const double last = information->Get(Pipeline::TIME_STEPS())[times - 1];
      std::ostringstream note;
      note << "the last of " << times << " times, " << last << ", is felt";
      volume.Notes.push_back(note.str());
      information->Set(Pipeline::UPDATE_TIME_STEP(), last);
    }
    return std::string();
  };
  if (!detail.empty() || !Explore::ReadChecked(reader, detail, chooseTime) ||
    !reader->GetOutputDataObject(0))
  {
    ThrowUnreadable(path, format, detail);
  }
  return reader->GetOutputDataObject(0);
}

double ComputeFinestSpacing(const vtkBoundingBox& box)
{
  double edges[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetLengths(edges);
  }
  return std::cbrt(edges[0] * edges[1] * edges[2] / MOST_SAMPLES);
}

/// Makes an empty image that covers all parts.
vtkSmartPointer<vtkImageData> MakeFrame(
  const std::string& path, const std::vector<vtkDataSet*>& parts, Volume& volume)
{
  const vtkBoundingBox box = VolumeHaptics::ComputeBox(parts);
  const double cells = VolumeHaptics::CountCells(parts);
  const double average = VolumeHaptics::ComputeSampleSpacing(box, cells);
  const double finest = ComputeFinestSpacing(box);
  VolumeHaptics::SamplingGrid grid;
  if (!VolumeHaptics::PlaceGrid(box, std::max(average, finest), grid))
  {
    throw InputError(path, "has no cells, or they have no volume",
      "write grids of three-dimensional cells, such as hexahedra and tetrahedra");
  }
  auto frame = vtkSmartPointer<vtkImageData>::New();
  frame->SetDimensions(grid.Dimensions);
  frame->SetOrigin(grid.Origin);
  frame->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
  std::ostringstream note;
  note << static_cast<vtkIdType>(cells) << " cells, resampled to cubes of " << grid.Spacing
       << (finest > average ? ", which are larger than the cells: crop the data to feel more" : "");
  volume.Notes.push_back(note.str());
  return frame;
}

vtkSmartPointer<vtkImageData> Resample(vtkDataObject* data, vtkImageData* frame)
{
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputDataObject(data);
  average->PassCellDataOff();
  vtkNew<vtkResampleToImage> resample;
  resample->SetInputConnection(average->GetOutputPort());
  resample->UseInputBoundsOff();
  resample->SetSamplingBounds(frame->GetBounds());
  resample->SetSamplingDimensions(frame->GetDimensions());
  resample->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(frame);
  image->GetPointData()->ShallowCopy(resample->GetOutput()->GetPointData());
  return image;
}

/// Fills the image outside all cells: scalars with the smallest value inside; other arrays stay 0.
/// Then removes the mask and the ghost array.
void FillOutside(vtkImageData* image)
{
  constexpr const char* maskName = "vtkValidPointMask";
  vtkPointData* const points = image->GetPointData();
  const vtkSmartPointer<vtkDataArray> mask = points->GetArray(maskName);
  for (int i = 0; mask && i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    if (!array || array == mask || array->GetNumberOfComponents() != 1)
    {
      continue;
    }
    double least = VTK_DOUBLE_MAX;
    for (vtkIdType k = 0; k < mask->GetNumberOfTuples(); ++k)
    {
      const double value = array->GetComponent(k, 0);
      least = mask->GetComponent(k, 0) != 0.0 && value < least ? value : least;
    }
    for (vtkIdType k = 0; k < mask->GetNumberOfTuples() && least < VTK_DOUBLE_MAX; ++k)
    {
      if (mask->GetComponent(k, 0) == 0.0)
      {
        array->SetComponent(k, 0, least);
      }
    }
  }
  for (const char* const name : { maskName, vtkDataSetAttributes::GhostArrayName() })
  {
    points->RemoveArray(name);
  }
}

/// Returns the name of the active scalars, vectors or tensors in the first part that has them.
std::string FindActive(const std::vector<vtkDataSet*>& parts)
{
  for (vtkDataSet* const part : parts)
  {
    for (vtkDataSetAttributes* const arrays :
      std::initializer_list<vtkDataSetAttributes*>{ part->GetPointData(), part->GetCellData() })
    {
      vtkDataArray* const scalars = arrays->GetScalars();
      if (scalars && scalars->GetName() && scalars->GetNumberOfComponents() == 1)
      {
        return scalars->GetName();
      }
    }
  }
  return {};
}
Volume ReadGridHere(const std::string& path)
{
  const Format& format = *FindFormat(path);
  Volume volume;
  volume.Format = format.Name;
  volume.MetersPerUnit = format.MetersPerUnit;
  const vtkSmartPointer<vtkDataObject> data = Read(path, format, volume);
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    volume.Image = image;
    return volume;
  }
  const std::vector<vtkDataSet*> parts = VolumeHaptics::CollectParts(data);
  if (VolumeHaptics::LackFaces(parts))
  {
    throw InputError(path,
      std::string("has polyhedra, whose faces VTK ") + vtkVersion::GetVTKVersion() + " can't read",
      std::string("write it as tetrahedra (filter Tetrahedralize of ParaView)") +
        (VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) ? ", or use VTK 9.4 or later" : ""));
  }
  volume.Image = Resample(data, MakeFrame(path, parts, volume));
  FillOutside(volume.Image);
  volume.Outline = Explore::MakeGridOutline(parts);
  const std::string active = FindActive(parts);
  volume.Image->GetPointData()->SetActiveScalars(active.empty() ? nullptr : active.c_str());
  volume.IsGrid = true;
  volume.IsField = true;
  return volume;
}

Volume UnpackGrid(VolumeHaptics::ByteUnpacker& unpacker)
{
  Volume volume;
  volume.Format = unpacker.GetText();
  volume.MetersPerUnit = unpacker.Get<double>();
  for (auto left = unpacker.Get<std::uint64_t>(); left > 0; --left)
  {
    volume.Notes.push_back(unpacker.GetText());
  }
  volume.Image = Explore::UnpackImage(unpacker);
  volume.IsGrid = volume.IsField = unpacker.Get<bool>();
  volume.Outline = volume.IsGrid ? Explore::UnpackPolyData(unpacker) : nullptr;
  return volume;
}
} // namespace

namespace Explore
{
std::string ListGridEndings()
{
  std::string list;
  for (const Format& format : FORMATS)
  {
    list += (list.empty() ? "" : " ") + std::string(format.Ending);
  }
  return list;
}

bool IsGrid(const std::string& path)
{
  return FindFormat(path) != nullptr;
}

std::string PackGrid(const std::string& path)
{
  VolumeHaptics::BytePacker packer;
  try
  {
    const Volume volume = ReadGridHere(path);
    packer.PutText({});
    packer.PutText(volume.Format);
    packer.Put(volume.MetersPerUnit);
    packer.Put<std::uint64_t>(volume.Notes.size());
    for (const std::string& note : volume.Notes)
    {
      packer.PutText(note);
    }
    PackImage(volume.Image, packer);
    packer.Put(volume.IsGrid);
    volume.IsGrid ? PackPolyData(volume.Outline, packer) : void();
  }
  catch (const InputError& fault)
  {
    packer.Bytes.clear();
    packer.PutText(fault.what());
  }
  return std::move(packer.Bytes);
}

Volume ReadGrid(const std::string& path)
{
  using VolumeHaptics::ReadTask;
  const FileKind kind = FindFormat(path)->Kind;
  const bool namesFiles = kind == FileKind::CASE || kind == FileKind::BLOCKS;
  std::string answer;
  const VolumeHaptics::ReadResult result =
    VolumeHaptics::AskReader(namesFiles ? ReadTask::Case : ReadTask::Grid, path, answer);
  if (result == VolumeHaptics::ReadResult::NoProcess)
  {
    Volume volume = ReadGridHere(path);
    volume.Notes.insert(volume.Notes.end(), answer.empty() ? 0 : 1, answer);
    return volume;
  }
  std::string detail = answer;
  if (result == VolumeHaptics::ReadResult::Answered)
  {
    VolumeHaptics::ByteUnpacker unpacker(answer);
    try
    {
      const std::string fault = unpacker.GetText();
      return fault.empty() ? UnpackGrid(unpacker) : throw InputError(fault);
    }
    catch (const InputError&)
    {
      throw;
    }
    catch (const std::exception& fault) // the answer is malformed
    {
      detail = fault.what();
    }
  }
  ThrowUnreadable(path, *FindFormat(path), detail);
}

} // namespace Explore
