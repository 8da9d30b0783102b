// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeLoader.h"

#include "VTK/Reading/Dicom/DicomFolder.h"
#include "VTK/Reading/GridLoader.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MaskFolder.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/SliceGeometry.h"
#include "VTK/Reading/VolumeChecks.h"
#include "VTK/Reading/VolumeFields.h"
#include "VTK/Reading/VolumeOrientation.h"
#include "VTK/Reading/WholeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/NrrdHeader.h"
#include "VTK/Material/Labels/SegmentationFile.h"
#include "VTK/Regions/Formats/HeaderText.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageShiftScale.h"
#include "vtkInformation.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageHeader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace
{
using Explore::InputError;
using Explore::Volume;

/// MetaIO's types that vtkMetaImageReader supports and that have the same size on every system.
constexpr const char* META_TYPES[] = { "MET_CHAR", "MET_UCHAR", "MET_SHORT", "MET_USHORT",
  "MET_INT", "MET_UINT", "MET_FLOAT", "MET_DOUBLE" };

struct UnreadableFile
{
  const char* Endings; ///< file extensions, separated by blanks
  const char* Fault;
  const char* Cure;
};

/// Formats that are not supported here, each with a way to convert it.
constexpr UnreadableFile UNREADABLE[] = {
  { " .head .brik ", "is an AFNI file, which is not supported",
    "convert it to NIfTI with 3dAFNItoNIFTI" },
  { " .par .rec ", "is a PAR/REC file, which is not supported",
    "convert it to NIfTI with dcm2niix" },
  { " .zip .tar .tgz .7z .rar ", "is a packed folder (an archive)",
    "unpack it, and choose the folder of its slices" },
  { " .gz .bz2 .xz ", "is a packed file", "unpack it, and choose the file inside" },
  { " .v ", "is an ECAT file, which is not supported",
    "convert it to NIfTI, e.g. with nibabel: nib.save(nib.load('pet.v'), 'pet.nii')" },
  { " .trk .tck ", "has tracts, which are lines, not a volume",
    "choose the volume in which they were tracked" },
  { " .jpg .jpeg .png .bmp ", "is a picture, which has one slice, or fewer grey levels than a scan",
    "choose the volume that it was made from" },
  { " .npy .npz ", "has a NumPy array, without spacing and position",
    "give it to volumehaptics.image() in Python, or write it as .nii.gz or .nrrd" },
  { " .mat ", "is a MATLAB file, which is not supported",
    "write its array with niftiwrite, or with pynrrd or nibabel" },
  { " .mrc .map .ccp4 ", "is a density map (MRC), which is not supported",
    "convert it to NRRD or TIFF, e.g. with mrcfile and tifffile in Python" },
  { " .czi .lif .nd2 .oib .oif .vsi .lsm .ims .oir .dm3 .dm4 ",
    "is a microscope's own format, which is not supported",
    "convert it to OME-TIFF or OME-Zarr, e.g. with bioformats2raw or Fiji" },
  { " .raw .vol .bin .dat ", "has no header: neither its size nor its type is known",
    "write a header for it, such as .mhd with DimSize, ElementType and ElementDataFile" },
  { " .h5 .hdf5 .nxs ", "is HDF5, of which only VTKHDF is supported",
    "write its array as .vtkhdf, .nrrd, TIFF or Zarr" },
  { " .gii .surf .pial .white .inflated ", "is a surface of a brain, not a volume",
    "choose the volume that it was made from" },
  { " .stl .ply .obj ", "is a surface, not a volume",
    "choose a volume; a surface can be a tool or a guide in it" },
};

std::string ListKnown()
{
  return ".vti .nii .nii.gz .hdr .img .pvd " + vtkHapticRegionSource::GetFileEndings() +
    ", a grid (" + Explore::ListGridEndings() + "), DICOM or TIFF slices, or a folder of them";
}

bool EndsWith(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
    text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

bool IsXml(const std::string& path)
{
  return EndsWith(vtksys::SystemTools::LowerCase(path), ".vti");
}

bool IsNifti(const std::string& lower)
{
  for (const char* const ending : { ".nii", ".hdr", ".img" })
  {
    if (EndsWith(lower, ending) || EndsWith(lower, std::string(ending) + ".gz"))
    {
      return true;
    }
  }
  return false;
}

/// Returns the first existing file with the same name and one of these extensions, such as the
/// samples of a NIfTI volume in two files; empty if there is none.
std::string FindBeside(const std::string& path, std::initializer_list<const char*> endings)
{
  const std::string lower = vtksys::SystemTools::LowerCase(path);
  const std::string base = path.substr(0, path.size() - (EndsWith(lower, ".gz") ? 7 : 4));
  for (const char* const ending : endings)
  {
    if (vtksys::SystemTools::FileExists(base + ending, true))
    {
      return base + ending;
    }
  }
  return {};
}

/// Returns the reason why the header of a NIfTI file (or of the file beside its samples) can't be
/// true; empty if it can.
std::string DetectFalseNifti(const std::string& path)
{
  const std::string lower = vtksys::SystemTools::LowerCase(path);
  const bool areSamples = EndsWith(lower, ".img") || EndsWith(lower, ".img.gz");
  const std::string header =
    areSamples ? FindBeside(path, { ".hdr", ".hdr.gz", ".HDR", ".HDR.GZ" }) : path;
  const std::string fault = Explore::DetectDevice(header);
  return header.empty() || !fault.empty() ? fault : Explore::DetectFalseNiftiHeader(header);
}

/// Returns whether the file's contents are gzip, whatever its name.
bool IsPacked(const std::string& path)
{
  std::ifstream file = VolumeHaptics::OpenStream(path);
  return file.get() == 0x1f && file.get() == 0x8b;
}

/// Returns the file with the samples: the one that the header names, or the header's own file.
/// Returns an empty text if the samples are in several files.
std::string FindSamples(const std::string& path)
{
  const std::string lower = vtksys::SystemTools::LowerCase(path);
  std::string data;
  if (EndsWith(lower, ".mhd") || EndsWith(lower, ".mha"))
  {
    data = VolumeHaptics::HeaderText(path).Value({ "ElementDataFile" });
  }
  else if (IsNifti(lower) && !EndsWith(lower, ".nii") && !EndsWith(lower, ".nii.gz"))
  {
    // Find the samples of NIfTI and Analyze volumes in two files.
    const std::string samples = FindBeside(path, { ".img", ".img.gz", ".IMG", ".IMG.GZ" });
    const std::size_t ending = EndsWith(lower, ".gz") ? 7 : 4;
    return samples.empty() ? path.substr(0, path.size() - ending) + ".img" : samples;
  }
  if (data == "LIST" || data.find('%') != std::string::npos)
  {
    return {};
  }
  if (data.empty() || vtksys::SystemTools::LowerCase(data) == "local")
  {
    return path;
  }
  return vtksys::SystemTools::CollapseFullPath(
    data, vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::CollapseFullPath(path)));
}

/// Returns an upper bound on the size (bytes) of the samples in a file; -1 if the file is damaged.
double CountHeld(const std::string& path, const std::string& samples)
{
  const std::string lower = vtksys::SystemTools::LowerCase(path);
  const bool isMeta = EndsWith(lower, ".mhd") || EndsWith(lower, ".mha");
  const VolumeHaptics::HeaderText meta(isMeta ? path : std::string());
  const bool isPacked =
    isMeta ? meta.IsTrue({ "CompressedData" }) : IsNifti(lower) && IsPacked(samples);
  const bool isRaw = isMeta ? meta.IsTrue({ "BinaryData" }, true) : IsNifti(lower);
  // Skip files with compressed data after a header of a given size.
  const bool isHere = samples == path && isMeta;
  const bool isPlain = meta.Value({ "HeaderSize" }).empty();
  const std::size_t head = isMeta ? meta.GetSize() : 0;
  const auto length = static_cast<double>(vtksys::SystemTools::FileLength(samples));
  if (isPacked && isPlain && (!isHere || head > 0))
  {
    return Explore::CountUnpacked(samples, isHere ? head : 0);
  }
  // Upper limit of compression: deflate shrinks zeros by at most 1032, LZMA by 7000.
  constexpr double smallest = 10000.0;
  return isRaw && !isPacked ? length : smallest * length;
}

/// Returns the reason why a reader's information can't be true for its file; empty if it can. Call
/// this before the samples are read, because readers allocate memory for everything that a header
/// declares.
std::string DetectFalsePromise(vtkAlgorithm* reader, const std::string& path)
{
  vtkInformation* const information = reader->GetOutputInformation(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (information && information->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  }
  double bytes = 1.0;
  for (int a = 0; a < 6; a += 2)
  {
    bytes *= std::max(0.0, 1.0 + extent[a + 1] - extent[a]);
  }
  vtkInformation* const scalars = vtkDataObject::GetActiveFieldInformation(
    information, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (scalars && scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
  {
    bytes *= scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  }
  if (scalars && scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
  {
    bytes *= vtkDataArray::GetDataTypeSize(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
  }
  const std::string samples = FindSamples(path);
  const std::string device = samples.empty()
    ? Explore::DetectDeviceIn(
        vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::CollapseFullPath(path)))
    : Explore::DetectDevice(samples);
  if (!device.empty())
  {
    return device;
  }
  const std::string holes = VolumeHaptics::DetectHoles(samples);
  if (!holes.empty())
  {
    return vtksys::SystemTools::GetFilenameName(samples) + " " + holes;
  }
  if (!vtksys::SystemTools::FileExists(samples, true))
  {
    return {}; // the reader will report the fault
  }
  const double held = CountHeld(path, samples);
  return held < 0.0 ? "its compressed samples are damaged or truncated"
    : bytes > held
    ? "its header announces more voxels than the file has, which ends before the last voxel"
    : std::string();
}

/// Runs a reader and combines all of its errors into one message.
template <typename Reader>
vtkSmartPointer<vtkImageData> Run(Reader* reader, const std::string& path, const char* format)
{
  const std::string cure =
    std::string("export it again as ") + format + ", and check that the copy is complete";
  reader->SetFileName(path.c_str());
  Explore::MessageCapture capture;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw InputError(path, std::string("is not a ") + format + " file, whatever its name says",
      "check what the file really is; " + cure);
  }
  // Check before VTK's reader opens the file, because it trusts the contents.
  std::string detail = IsXml(path) ? Explore::DetectMissingEnd(path) : std::string();
  if (!detail.empty() ||
    !Explore::ReadChecked(reader, detail, [&] { return DetectFalsePromise(reader, path); }))
  {
    throw InputError(path,
      std::string("cannot be read as ") + format + (detail.empty() ? "" : " (" + detail + ")"),
      cure);
  }
  vtkNew<vtkImageData> image;
  image->ShallowCopy(reader->GetOutput());
  return image;
}

/// Converts 64-bit integers to 16 or 32 bits if they fit, because VTK's mappers do not support 64
/// bits.
void NarrowSamples(vtkImageData* image)
{
  vtkDataArray* const wide = image ? image->GetPointData()->GetScalars() : nullptr;
  const int type = wide ? wide->GetDataType() : VTK_VOID;
  const bool isWide = type == VTK_LONG || type == VTK_UNSIGNED_LONG || type == VTK_LONG_LONG ||
    type == VTK_UNSIGNED_LONG_LONG || type == VTK_ID_TYPE;
  double range[2] = { 0.0, 0.0 };
  for (int c = 0; isWide && c < wide->GetNumberOfComponents(); ++c)
  {
    double one[2];
    wide->GetRange(one, c);
    range[0] = std::min(range[0], one[0]);
    range[1] = std::max(range[1], one[1]);
  }
  const auto fits = [&range](auto number)
  {
    using Limits = std::numeric_limits<decltype(number)>;
    return range[0] >= Limits::min() && range[1] <= Limits::max();
  };
  if (isWide && fits(int{}))
  {
    image->GetPointData()->SetScalars(
      VolumeHaptics::CopyArray(wide, fits(short{}) ? VTK_SHORT : VTK_INT));
  }
}

Volume ReadVti(const std::string& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  return { Run(reader.Get(), path, "VTK image (.vti)"), {}, "VTK image", {}, {}, {} };
}

/// Returns whether vtkMetaImageReader can read the file: it supports the sample type with MetaIO's
/// size and the number of dimensions, and parses the header without overflowing its buffers.
bool IsKnownToVTK(const std::string& path)
{
  const VolumeHaptics::HeaderText header(path);
  const std::string type = header.Value({ "ElementType" });
  const bool isKnown = std::any_of(std::begin(META_TYPES), std::end(META_TYPES),
    [&](const char* known) { return type == known || type == std::string(known) + "_ARRAY"; });
  const std::size_t axes = header.Numbers({ "DimSize" }).size();
  return header.IsPlain() && isKnown && axes >= 1 && axes <= 3 &&
    header.Value({ "NDims" }) == std::to_string(axes);
}

/// Reads a whole file with the code that reads regions, and adds its notes.
Volume ReadAsRegions(
  const std::string& path, const std::string& format, int series, const char* cure)
{
  vtkNew<vtkHapticRegionSource> source;
  std::string error;
  Volume volume;
  volume.Format = format;
  volume.Image = source->OpenWholeFile(path.c_str(), error, series)
    ? Explore::ReadWhole(source, error)
    : nullptr;
  if (!volume.Image)
  {
    throw InputError(path, "cannot be read as " + format + " (" + error + ")", cure);
  }
  volume.Axes = Explore::FindFormatAxes(format);
  Explore::AddFileNotes(source, volume);
  return volume;
}

/// Reads a MetaImage, including files that VTK's reader does not support: with 64-bit samples,
/// MetaIO's long, or more than three axes.
Volume ReadMetaImage(const std::string& path, int series)
{
  vtkNew<vtkMetaImageReader> reader;
  const bool isRaw = reader->CanReadFile(path.c_str()) && !IsKnownToVTK(path);
  Volume volume = isRaw
    ? ReadAsRegions(path, "MetaImage", series,
        "see the reason in brackets, or write it with samples of 8, 16 or 32 bits")
    : Volume{ Run(reader.Get(), path, "MetaImage"), {}, "MetaImage", {}, {}, {} };
  const VolumeHaptics::HeaderText header(path);
  if (!isRaw)
  {
    Explore::ScaleLengths(volume.Image, header.GetMetaUnit());
    volume.Notes = header.DescribeMeta();
  }
  Explore::ApplyMetaImageOrientation(path, volume.Image);
  volume.Axes = Explore::ReadMetaImageAxes(path);
  volume.HasPlace = !header.Value({ "TransformMatrix", "Orientation", "Rotation" }).empty();
  return volume;
}

/// Reads a NRRD file without VTK's reader, which misreads samples written as text and the sizes of
/// four axes. The segments of a segmentation become labels.
Volume ReadNrrd(const std::string& path, int series)
{
  const VolumeHaptics::NrrdHeader header = VolumeHaptics::ReadNrrdHeader(path);
  if (header.Fields.empty())
  {
    throw InputError(path, "is not a NRRD file, whatever its name says",
      "check what the file really is; export it again as NRRD, and check that the copy is "
      "complete");
  }
  const bool isSegmentation = std::any_of(header.Values.begin(), header.Values.end(),
    [](const auto& value)
    {
      constexpr std::size_t digit = 7; // behind "Segment"
      const std::string& key = value.first;
      return key.rfind("Segment", 0) == 0 && key.size() > digit && key[digit] >= '0' &&
        key[digit] <= '9';
    });
  Volume volume = isSegmentation
    ? Explore::ReadNrrdSegmentation(path, series)
    : ReadAsRegions(path, "NRRD", series, "see the reason in brackets");
  volume.Axes = Explore::FindNrrdAxes(header);
  const std::string note = Explore::DescribeNrrdTurn(header);
  volume.Notes.insert(volume.Notes.end(), note.empty() ? 0 : 1, note);
  return volume;
}

/// Converts stored numbers to values with the scale in a NIfTI header, which vtkNIFTIImageReader
/// ignores. Integers stay integers if the header only adds an integer.
void ApplyNiftiScale(double slope, double intercept, Volume& volume)
{
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  const bool isMeant = slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept);
  if (!isMeant || (slope == 1.0 && intercept == 0.0) || !scalars)
  {
    return;
  }
  double range[2];
  scalars->GetRange(range, 0);
  for (int c = 1; c < scalars->GetNumberOfComponents(); ++c)
  {
    double other[2];
    scalars->GetRange(other, c);
    range[0] = std::min(range[0], other[0]);
    range[1] = std::max(range[1], other[1]);
  }
  using Short = std::numeric_limits<short>;
  const bool isShort = slope == 1.0 && intercept == std::round(intercept) &&
    scalars->GetDataTypeMax() <= std::numeric_limits<int>::max() &&
    range[0] + intercept >= Short::min() && range[1] + intercept <= Short::max();
  const bool isLong = scalars->GetDataTypeSize() > 2 && scalars->GetDataType() != VTK_FLOAT;
  const int fraction = isLong ? VTK_DOUBLE : VTK_FLOAT;
  vtkNew<vtkImageShiftScale> shift;
  shift->SetInputData(volume.Image);
  shift->SetShift(intercept / slope);
  shift->SetScale(slope);
  shift->SetOutputScalarType(isShort ? VTK_SHORT : fraction);
  shift->Update();
  volume.Image = shift->GetOutput();
  std::ostringstream note;
  note << "values are " << slope << " times the stored ones, plus " << intercept
       << ", as the NIfTI header says";
  volume.Notes.push_back(note.str());
}

bool IsCifti(const std::string& path)
{
  vtkNew<vtkNIFTIImageReader> reader;
  const Explore::MessageCapture capture; // the volume's reader reports faults
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  constexpr int first = 3000, last = 3099;
  const int intent = reader->GetNIFTIHeader() ? reader->GetNIFTIHeader()->GetIntentCode() : 0;
  return intent >= first && intent <= last;
}

Volume ReadNifti(const std::string& path, bool timesAreComponents)
{
  const std::string fault = DetectFalseNifti(path);
  if (!fault.empty())
  {
    throw InputError(path, "is not a NIfTI file, whatever its name says (" + fault + ")",
      "check what the file really is; export it again as NIfTI, and check that the copy is "
      "complete");
  }
  if (IsCifti(path)) // refuse the file before reading its samples, which may be many
  {
    throw InputError(path, "is a CIFTI file, whose values belong to places of a brain's surface",
      "extract its volume with wb_command -cifti-separate, or choose the volume it was made of");
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetTimeAsVector(timesAreComponents);
  Volume volume{ Run(reader.Get(), path, "NIfTI"), {}, "NIfTI", {}, {}, {} };
  for (int axis = 1; axis <= 3; ++axis)
  {
    if (!(std::abs(reader->GetNIFTIHeader()->GetPixDim(axis)) > 0.0) && !reader->GetSFormMatrix())
    {
      volume.Notes.push_back(
        "no voxel spacing along index axis " + std::to_string(axis) + " (pixdim): 1 is assumed");
    }
  }
  ApplyNiftiScale(reader->GetRescaleSlope(), reader->GetRescaleIntercept(), volume);
  vtkMatrix4x4* matrix = reader->GetSFormMatrix();
  const char* form = "sform";
  if (!matrix)
  {
    matrix = reader->GetQFormMatrix();
    form = "qform";
  }
  if (reader->GetSFormMatrix())
  {
    // The spacing is the length of the sform's columns (method 3). Undo VTK's division of these
    // columns by pixdim.
    double spacing[3];
    for (int c = 0; c < 3; ++c)
    {
      spacing[c] = volume.Image->GetSpacing()[c] *
        std::hypot(matrix->GetElement(0, c), matrix->GetElement(1, c), matrix->GetElement(2, c));
    }
    volume.Image->SetSpacing(spacing);
  }
  Explore::ApplyNiftiOrientation(matrix, volume.Image);
  volume.Axes = matrix ? Explore::WorldAxes::Patient : Explore::WorldAxes::Unknown;
  volume.HasPlace = matrix != nullptr;
  volume.Notes.push_back(matrix ? std::string("orientation from the NIfTI ") + form +
        ", turned from right-anterior-superior to left-posterior-superior"
                                : "no NIfTI orientation: index axes taken as right, anterior, "
                                  "superior");
  const int units = reader->GetNIFTIHeader()->GetXYZTUnits() & 7;
  if (units == 1 || units == 3)
  {
    Explore::ScaleLengths(volume.Image, units == 1 ? 1000.0 : 0.001);
    volume.Notes.push_back(std::string("lengths turned from ") +
      (units == 1 ? "metres" : "micrometres") + " into millimetres");
  }
  return volume;
}

Volume ReadFile(const std::string& path, bool timesAreComponents, int series)
{
  const std::string lower = vtksys::SystemTools::LowerCase(path);
  if (EndsWith(lower, ".vti"))
  {
    return ReadVti(path);
  }
  if (EndsWith(lower, ".mhd") || EndsWith(lower, ".mha"))
  {
    return ReadMetaImage(path, series);
  }
  if (IsNifti(lower))
  {
    return ReadNifti(path, timesAreComponents);
  }
  if (EndsWith(lower, ".nrrd") || EndsWith(lower, ".nhdr"))
  {
    return ReadNrrd(path, series);
  }
  const std::string format = vtkHapticRegionSource::GetFileFormat(path.c_str());
  if (!format.empty())
  {
    return ReadAsRegions(path, format, series, "see the reason in brackets");
  }
  if (Explore::IsGrid(path))
  {
    return Explore::ReadGrid(path);
  }
  if (Explore::IsDicomFile(path))
  {
    return Explore::ReadDicomFile(path, series);
  }
  const Explore::DicomObject object = Explore::FindDicomObject(path);
  if (!object.Name.empty())
  {
    throw InputError(path, "is " + object.Name, object.Cure);
  }
  if (EndsWith(lower, ".dcm") || EndsWith(lower, ".ima"))
  {
    throw InputError(path, "is not a DICOM slice, whatever its name says",
      "check what the file really is; give a DICOM slice, or the folder of its series");
  }
  const std::string ending = " " + vtksys::SystemTools::GetFilenameLastExtension(lower) + " ";
  for (const auto& [endings, fault, cure] : UNREADABLE)
  {
    if (std::string(endings).find(ending) != std::string::npos)
    {
      throw InputError(path, fault, cure);
    }
  }
  throw InputError(path, "has an unknown extension", "convert it to one of these: " + ListKnown());
}
} // namespace

namespace Explore
{
vtkSmartPointer<vtkImageData> ReadWhole(vtkHapticRegionSource* source, std::string& error)
{
  vtkNew<vtkImageData> region; // temporary: it also gets the arrays that mark it as a region
  if (!source->ReadRegion(source->GetWholeExtent(), region, error))
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(region);
  image->GetPointData()->SetScalars(region->GetPointData()->GetScalars());
  return image;
}

void AddFileNotes(vtkHapticRegionSource* source, Volume& volume)
{
  std::istringstream notes(source->GetFileNotes());
  for (std::string note; std::getline(notes, note);)
  {
    volume.Notes.push_back(note);
  }
  for (int i = 0; i < source->GetNumberOfSeries(); ++i)
  {
    volume.Series.emplace_back(source->GetSeriesName(i));
  }
  volume.SeriesNumber = source->GetSeriesNumber();
}

void ListSegments(Volume& volume, int chosen)
{
  volume.Series = { "0 all segments, as labels" };
  for (vtkIdType i = 0; i < volume.LabelTable->GetNumberOfLabels(); ++i)
  {
    const std::string name = volume.LabelTable->GetLabelName(volume.LabelTable->GetLabel(i));
    volume.Series.push_back(std::to_string(i + 1) + " " + VolumeHaptics::Printable(name));
  }
  volume.SeriesNumber = chosen;
  if (chosen > 0)
  {
    volume.Notes.push_back(
      "segment " + volume.Series[static_cast<std::size_t>(chosen)] + " is read alone");
  }
}

Volume ReadNrrdSegmentation(const std::string& path, int series)
{
  Volume volume;
  volume.Format = "NRRD segmentation";
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  volume.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
  const std::string error =
    VolumeHaptics::ReadSegmentation(path, volume.Image, volume.LabelTable, series);
  if (!error.empty())
  {
    throw InputError(path, error, "see the reason in brackets, or choose another file");
  }
  ListSegments(volume, series);
  double layers = 1.0 / static_cast<double>(volume.Image->GetNumberOfPoints());
  for (const double size : VolumeHaptics::ReadNrrdHeader(path).GetNumbers("sizes"))
  {
    layers *= size;
  }
  if (series == 0 && layers > 1.5)
  {
    volume.Notes.push_back("labels in " + std::to_string(std::lround(layers)) +
      " layers: where several are in a voxel, the last one in the file counts");
  }
  return volume;
}

Volume ReadVolume(const std::string& path, bool timesAreComponents, int series)
{
  if (vtksys::SystemTools::CollapseFullPath(path) == "/")
  {
    throw InputError(path, "is the root folder", "choose the folder that has the slices");
  }
  if (!vtksys::SystemTools::PathExists(path))
  {
    throw InputError(path, "there is no such file or folder",
      "check the spelling; what can be read is " + ListKnown());
  }
  Volume volume;
  if (vtksys::SystemTools::FileIsDirectory(path))
  {
    const std::string format = vtkHapticRegionSource::GetFileFormat(path.c_str());
    const std::vector<std::string> masks =
      format.empty() ? ListMasks(path) : std::vector<std::string>();
    volume = !masks.empty() ? ReadMasks(path, masks, series)
      : format.empty()      ? ReadDicomFolder(path, series)
                            : ReadAsRegions(path, format, series, "see the reason in brackets");
  }
  else
  {
    std::string fault;
    if (!VolumeHaptics::CheckRegular(path, fault))
    {
      throw InputError(path, fault, "copy its contents into a file, and choose that");
    }
    const std::string holes = VolumeHaptics::DetectHoles(path);
    if (!holes.empty())
    {
      throw InputError(path, holes, "copy or download it again");
    }
    if (!vtksys::SystemTools::TestFileAccess(path, vtksys::TEST_FILE_READ))
    {
      throw InputError(path, "can't be read by you", "chmod u+r it, or copy it");
    }
    // The file of an OpenFOAM case may be empty, because only its folder matters.
    const bool mayBeEmpty = EndsWith(vtksys::SystemTools::LowerCase(path), ".foam");
    if (!mayBeEmpty && vtksys::SystemTools::FileLength(path) == 0)
    {
      throw InputError(path, "is empty (0 bytes)", "copy or download it again");
    }
    volume = ReadFile(path, timesAreComponents, series);
  }
  NarrowSamples(volume.Image);
  for (const Volume::Phase& phase : volume.Phases)
  {
    NarrowSamples(phase.Image);
  }
  std::string folder = path;
  vtksys::SystemTools::ConvertToUnixSlashes(folder);
  volume.Name = vtksys::SystemTools::GetFilenameName(folder);
  return volume;
}

void AlignVolume(Volume& volume)
{
  const std::string note =
    StraightenIfSheared(volume.Image, volume.MayBeLabels || volume.LabelTable != nullptr);
  volume.Notes.insert(volume.Notes.end(), note.empty() ? 0 : 1, note);
  volume.Image = AlignToAxes(volume.Image);
}

NiftiTimes ReadNiftiTimes(const std::string& path, double unknown)
{
  vtkNew<vtkNIFTIImageReader> reader;
  const MessageCapture capture; // the volume's reader will report the fault
  if (!IsNifti(vtksys::SystemTools::LowerCase(path)) || !DetectFalseNifti(path).empty() ||
    !reader->CanReadFile(path.c_str()))
  {
    return {};
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (reader->GetTimeDimension() < 2)
  {
    return {};
  }
  constexpr int seconds = 8, milliseconds = 16, microseconds = 24; // unit codes of the NIfTI header
  const int unit = reader->GetNIFTIHeader()->GetXYZTUnits() & 56;
  const double scale = unit == milliseconds ? 1e-3 : unit == microseconds ? 1e-6 : 1.0;
  const double spacing = scale * reader->GetTimeSpacing();
  const bool isKnown = (unit == 0 || unit == seconds || scale < 1.0) && spacing > 0.0;
  return { reader->GetTimeDimension(), isKnown && std::isfinite(spacing) ? spacing : unknown };
}

Volume LoadVolume(const std::string& path, int series, const std::string& array)
{
  Volume volume = ReadVolume(path, false, series);
  VolumeFields fields;
  volume.Flow = volume.IsGrid ? VolumeFields::FindFlow(volume.Image, array) : std::string();
  if (!array.empty() || !volume.Flow.empty())
  {
    // Show the same array that is felt.
    const std::string& shown = array.empty() ? volume.Flow : array;
    volume.IsField = fields.UseWith(shown, path, volume.Image) || volume.IsField;
  }
  else if (fields.Use(volume.Image))
  {
    volume.IsField = true;
    volume.Notes.emplace_back("only the magnitude of the vectors is shown and felt; --method "
                              "primitives follows their directions");
  }
  CheckVolume(path, volume, series);
  volume.MayBeLabels = !volume.IsGrid && !volume.IsField && LooksLikeLabels(volume.Image);
  AlignVolume(volume);
  fields.GiveTo(volume.Image);
  for (Volume::Phase& phase : volume.Phases)
  {
    Volume one;
    one.Image = phase.Image;
    one.IsField = volume.IsField;
    one.Modality = volume.Modality;
    CheckVolume(path, one);
    ShiftValues(one, volume.Shift - one.Shift); // use the shift of the first phase for all, even if
                                                // another shift fits this phase
    AlignVolume(one);
    phase.Image = one.Image;
  }
  return volume;
}
} // namespace Explore
