// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRegionSource.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/LengthUnit.h"
#include "VTK/Regions/CoarseImage.h"
#include "VTK/Regions/DataSetSampler.h"
#include "VTK/Regions/Formats/LargeFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"
#include "VTK/Regions/HapticRegionSettings.h"
#include "VTK/Regions/RegionStore.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkHapticRegionSource);
vtkCxxSetSmartPointerMacro(vtkHapticRegionSource, CoarseImage, vtkImageData);

using namespace VolumeHaptics;

namespace
{
void WarnOfOutside(vtkHapticRegionSource* source, RegionStore& store)
{
  const std::string notice = store.DrainNotice();
  if (!notice.empty())
  {
    vtkWarningWithObjectMacro(source, << Printable(notice));
  }
}

/** Largest number of regions in memory at once while a hand feels the volume. */
constexpr vtkTypeInt64 RegionsInMemory = 4;
/** Largest coarser level of a file (voxels) that is loaded. */
constexpr vtkIdType MostCoarseVoxels = 1 << 22;
/** Largest total size (bytes) of the samples, so that all file offsets fit into 64 bits. */
constexpr double MostBytes = 4e18;
} // namespace

//------------------------------------------------------------------------------
vtkHapticRegionSource::vtkHapticRegionSource()
  : Store(new RegionStore)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticRegionSource::~vtkHapticRegionSource()
{
  // Disconnect the port, because a filter may hold it longer than this source lives.
  this->GetOutputPort()->SetProducer(nullptr);
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::SetDirection(const double direction[9])
{
  if (!direction)
  {
    vtkErrorMacro(
      "Direction needs nine numbers, row by row, but got a null pointer; it stays as it was.");
    return;
  }
  if (!std::equal(direction, direction + 9, this->Direction))
  {
    std::copy(direction, direction + 9, this->Direction);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::SetReader(Reader reader, bool isAwaited)
{
  this->Function = std::move(reader);
  this->Sampler.reset();
  this->IsAwaited = isAwaited;
  this->OpenedName.clear();
  this->FileNotes.clear();
  this->Series.clear();
  this->SeriesNumber = 0;
  std::fill_n(this->ChunkSize, 3, 0);
  this->Reload();
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenFile(const char* fileName, int series)
{
  std::string error;
  const bool isOpen = this->OpenFile(fileName, error, series);
  if (!isOpen)
  {
    vtkErrorMacro(<< Printable(error));
  }
  return isOpen;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenFile(const char* fileName, std::string& error, int series)
{
  return this->Open(fileName, false, series, error);
}

//------------------------------------------------------------------------------
std::string vtkHapticRegionSource::GetFileFormat(const char* fileName)
{
  return GetFormatName(fileName ? fileName : "");
}

//------------------------------------------------------------------------------
std::string vtkHapticRegionSource::GetFileEndings()
{
  return ListFileEndings();
}

//------------------------------------------------------------------------------
double vtkHapticRegionSource::GetMillimetersPerUnit(const char* unit)
{
  return MillimetresPerUnit(unit ? unit : "");
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenWholeFile(const char* fileName, int series)
{
  std::string error;
  const bool isOpen = this->OpenWholeFile(fileName, error, series);
  if (!isOpen)
  {
    vtkErrorMacro(<< Printable(error));
  }
  return isOpen;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenWholeFile(const char* fileName, std::string& error, int series)
{
  return this->Open(fileName, true, series, error);
}

//------------------------------------------------------------------------------
int vtkHapticRegionSource::GetNumberOfSeries()
{
  return static_cast<int>(this->Series.size());
}

//------------------------------------------------------------------------------
const char* vtkHapticRegionSource::GetSeriesName(int index)
{
  return index >= 0 && index < this->GetNumberOfSeries()
    ? this->Series[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkHapticRegionSource::GetSeriesNumber()
{
  return this->SeriesNumber;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::Open(
  const char* fileName, bool mayBeWhole, int series, std::string& error)
{
  const std::string name = fileName ? fileName : "";
  try
  {
    LargeFile file = OpenLargeFile(name, mayBeWhole, series);
    const vtkSmartPointer<vtkImageData> coarse = ReadCoarserLevel(file, MostCoarseVoxels);
    this->SetWholeExtent(file.Extent.data());
    this->SetScalarType(file.ScalarType);
    this->SetOrigin(file.Origin.data());
    this->SetSpacing(file.Spacing.data());
    this->SetDirection(file.Direction.data());
    this->SetReader(std::move(file.Read));
    this->OpenedName = name;
    this->FileNotes.clear();
    for (const std::string& note : file.Notes)
    {
      this->FileNotes += (this->FileNotes.empty() ? "" : "\n") + note;
    }
    this->SeriesNumber = file.Volumes.empty() ? 0 : file.Volume;
    this->Series = std::move(file.Volumes);
    std::copy_n(file.ChunkSize.begin(), 3, this->ChunkSize);
    this->SetCoarseImage(coarse);
    return true;
  }
  catch (const std::exception& failure)
  {
    error = "The file " + name + " can't be opened: " + failure.what();
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenDataSet(vtkDataObject* data, double spacing, const char* arrayNames)
{
  std::vector<std::string> arrays;
  std::istringstream names(arrayNames ? arrayNames : "");
  for (std::string name; std::getline(names, name, ';');)
  {
    arrays.push_back(name);
  }
  std::string error;
  if (this->OpenDataSet(data, spacing, arrays, error))
  {
    return true;
  }
  vtkErrorMacro(<< Printable(error));
  return false;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::OpenDataSet(
  vtkDataObject* data, double spacing, const std::vector<std::string>& arrays, std::string& error)
{
  if (!data)
  {
    error = "OpenDataSet() needs data, but got a null pointer.";
    return false;
  }
  const std::shared_ptr<DataSetSampler> sampler =
    DataSetSampler::Make(data, arrays, spacing, error);
  if (!sampler)
  {
    return false;
  }
  const SamplingGrid& grid = sampler->GetGrid();
  const double straight[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  const int* const n = grid.Dimensions;
  this->SetWholeExtent(0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1);
  this->SetOrigin(grid.Origin[0], grid.Origin[1], grid.Origin[2]);
  this->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
  this->SetDirection(straight);
  this->SetScalarType(VTK_FLOAT);
  this->SetCoarseImage(nullptr);
  this->OpenedName.clear();
  this->FileNotes.clear();
  this->SetReader(
    [sampler](const int box[6], void* samples)
    {
      sampler->Read(box, static_cast<float*>(samples));
      return true;
    });
  this->Sampler = sampler;
  return true;
}

//------------------------------------------------------------------------------
int vtkHapticRegionSource::CountValues() const
{
  return this->Sampler ? this->Sampler->CountValues() : 1;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::PutSamples(
  vtkDataArray* samples, vtkImageData* image, std::string& error)
{
  try
  {
    this->PutArrays(samples, image);
    return true;
  }
  catch (const std::bad_alloc&)
  {
    image->Initialize();
    error = "There is not enough memory for a region. Read a smaller one, or lower MemoryLimit.";
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::PutArrays(vtkDataArray* samples, vtkImageData* image)
{
  const vtkIdType count = image->GetNumberOfPoints();
  vtkPointData* const arrays = image->GetPointData();
  vtkSmartPointer<vtkDataArray> values = samples;
  if (!values)
  {
    values = VolumeHaptics::NewArray(this->ScalarType, 1, count * this->CountValues());
    values->SetName("Scalars");
    values->Fill(0.0);
  }
  if (!this->Sampler)
  {
    arrays->SetScalars(values);
    return;
  }
  vtkIdType first = 0;
  for (const SampledArray& sampled : this->Sampler->GetArrays())
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(sampled.Name.c_str());
    array->SetNumberOfComponents(sampled.Components);
    VolumeHaptics::AllocateTuples(array, count);
    const auto* const from = static_cast<const float*>(values->GetVoidPointer(first));
    std::copy_n(from, count * sampled.Components, array->GetPointer(0));
    first += count * sampled.Components;
    arrays->AddArray(array);
    if (sampled.Components == 1 && !arrays->GetScalars())
    {
      arrays->SetActiveScalars(array->GetName());
    }
    else if (sampled.Components == 3 && !arrays->GetVectors())
    {
      arrays->SetActiveVectors(array->GetName());
    }
    else if (sampled.Components > 3 && !arrays->GetTensors())
    {
      arrays->SetActiveTensors(array->GetName());
    }
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::Reload()
{
  this->Store->Clear();
  ++this->Version;
  this->Modified();
}

//------------------------------------------------------------------------------
RegionPlanner& vtkHapticRegionSource::GetPlanner()
{
  return this->Store->GetPlanner();
}

//------------------------------------------------------------------------------
std::string vtkHapticRegionSource::CheckSettings()
{
  BoxExtent whole;
  std::copy_n(this->WholeExtent, 6, whole.begin());
  if (whole[0] > whole[1] || whole[2] > whole[3] || whole[4] > whole[5])
  {
    return "The volume has no extent. SetWholeExtent() to that of all its samples.";
  }
  if (this->ScalarType < VTK_CHAR || this->ScalarType > VTK_UNSIGNED_LONG_LONG ||
    this->ScalarType == VTK_STRING || this->ScalarType == VTK_OPAQUE)
  {
    return "The ScalarType " + std::to_string(this->ScalarType) +
      " is no type of numbers. Set it to VTK_SHORT, VTK_FLOAT or another one.";
  }
  if (CountSamples(whole) * vtkDataArray::GetDataTypeSize(this->ScalarType) > MostBytes)
  {
    return "The WholeExtent has more samples than can be counted. Check its numbers.";
  }
  if (!this->Function && (!this->FileName || !*this->FileName))
  {
    return "There is nothing to read samples from. SetFileName() to a raw file, or SetReader().";
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::Prepare(std::string& error)
{
  error = this->CheckSettings();
  if (!error.empty())
  {
    this->Store->Clear();
    return false;
  }
  LargeVolumeKey key;
  std::copy_n(this->WholeExtent, 6, key.Extent.begin());
  key.ScalarType = this->ScalarType;
  key.Version = this->Version;
  key.AreLabels = this->AreLabels;
  if (!this->Function)
  {
    key.File = this->FileName;
    key.HeaderSize = this->HeaderSize;
    key.ByteOrder = this->ByteOrder;
  }
  const int size = this->CountValues() * vtkDataArray::GetDataTypeSize(this->ScalarType);
  if (!this->Store->IsOf(key))
  {
    auto volume = std::make_shared<LargeVolume>();
    volume->Extent = key.Extent;
    volume->ScalarType = key.ScalarType;
    volume->SampleSize = static_cast<std::size_t>(size);
    volume->AreLabels = key.AreLabels;
    if (this->Sampler)
    {
      volume->ValuesPerSample = this->CountValues();
      volume->IsSmooth = true;
      volume->BorderValue = this->Sampler->GetLeastScalar();
    }
    volume->IsAwaited = this->IsAwaited || !this->Function;
    if (this->Function)
    {
      volume->Name = this->Sampler ? "the data set"
        : this->OpenedName.empty() ? "the reader"
                                   : "the file " + this->OpenedName;
      volume->Read = this->Function;
      std::copy_n(this->ChunkSize, 3, volume->ChunkSize.begin());
    }
    else
    {
      volume->Name = "the file " + key.File;
      const RawVolumeFile file{ MakeAbsolute(key.File), key.Extent, volume->SampleSize,
        key.HeaderSize, IsOtherByteOrder(key.ByteOrder == BIG) };
      volume->Read = [file](const int box[6], void* samples)
      {
        file.Read(box, samples);
        return true;
      };
    }
    this->Store->SetVolume(key, std::move(volume));
  }
  RegionPlanner& planner = this->GetPlanner();
  planner.SetWhole(this->WholeExtent, this->Origin, this->Spacing, this->Direction);
  planner.MaximumSpeed = this->MaximumSpeed;
  planner.SetMaximumVoxels(static_cast<vtkIdType>(this->MemoryLimit / RegionsInMemory / size));
  return this->UpdateCoarse(error);
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::UpdateCoarse(std::string& error)
{
  CoarseKey key;
  if (this->CoarseImage)
  {
    const vtkNew<vtkImageData> whole;
    whole->SetOrigin(this->Origin);
    whole->SetSpacing(this->Spacing);
    whole->SetDirectionMatrix(this->Direction);
    const int fromZero[6] = { 0, 0, 0, 0, 0, 0 }; // box readers count from zero
    if (!MakeIndexToWorld(whole, fromZero, "volume", key.IndexToWorld, error))
    {
      return false;
    }
    key.Image = this->CoarseImage;
    key.Time = this->CoarseImage->GetMTime();
  }
  if (this->Store->HasCoarseLevel(key))
  {
    return true;
  }
  std::shared_ptr<const CoarseLevel> level;
  if (this->CoarseImage)
  {
    level = CoarseLevel::Make(this->CoarseImage, this->AreLabels, key.IndexToWorld, error);
    if (!level)
    {
      return false;
    }
  }
  this->Store->SetCoarseLevel(key, std::move(level));
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticRegionSource::GetCoarseImage()
{
  return this->CoarseImage;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::MakeCoarseImage(vtkIdType mostVoxels)
{
  std::string error;
  if (!this->Prepare(error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  try
  {
    this->SetCoarseImage(AverageVolume(
      *this->Store->GetVolume(), { this->Origin, this->Spacing, this->Direction }, mostVoxels));
    return true;
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< Printable(failure.what()));
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::SetFeltAs(int kernelRadius, bool areLabels)
{
  if (this->KernelRadius != kernelRadius)
  {
    this->KernelRadius = kernelRadius;
    if (!this->Store->GetSamples())
    {
      this->Modified(); // the placeholder's size has changed
    }
  }
  if (this->AreLabels != areLabels)
  {
    this->AreLabels = areLabels;
    this->Modified(); // outside samples have another value now
  }
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::Follow(const double tip[3], double time)
{
  std::string error;
  if (!tip)
  {
    vtkErrorMacro("Follow() needs a tip, but got a null pointer.");
    return false;
  }
  if (!this->Prepare(error))
  {
    return false; // the pipeline will report the reason
  }
  const std::string before = this->Store->GetTrouble();
  const bool hasCome = this->Store->Poll(tip, time);
  const std::string& trouble = this->Store->GetTrouble();
  if (before.empty() && !trouble.empty())
  {
    vtkErrorMacro(<< Printable(trouble) << " It is tried again.");
  }
  WarnOfOutside(this, *this->Store);
  if (hasCome)
  {
    this->Modified();
  }
  if (!this->IsAwaited && this->Store->IsWaiting())
  {
    this->InvokeEvent(vtkCommand::UserEvent);
  }
  return hasCome;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::TakeLead(const void* device)
{
  this->Leader = this->Leader ? this->Leader : device;
  return this->Leader == device;
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::LeaveLead(const void* device)
{
  this->Leader = this->Leader == device ? nullptr : this->Leader;
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::NoteUseTime(double seconds)
{
  this->Store->SetUseTime(seconds);
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::IsWaiting()
{
  return this->Store->IsWaiting();
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::HasSamples()
{
  vtkImageData* const image = this->GetOutput();
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  return scalars && scalars == this->Store->GetSamples() && !this->Store->IsStandIn();
}

//------------------------------------------------------------------------------
std::string vtkHapticRegionSource::GetStatusText()
{
  const std::string& trouble = this->Store->GetTrouble();
  if (!trouble.empty())
  {
    return Printable(trouble) + " It is tried again.";
  }
  if (!this->Store->IsWaiting())
  {
    return {};
  }
  if (this->Store->IsStandIn())
  {
    return "The samples around the tip are being read; the coarse image stands in.";
  }
  return this->Store->IsSurveyed() ? "The samples around the tip are being read."
                                   : "The noise of the volume is being estimated.";
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::ReadRegion(const int region[6], vtkImageData* image)
{
  std::string error;
  const bool isRead = this->ReadRegion(region, image, error);
  if (!isRead)
  {
    vtkErrorMacro(<< Printable(error));
  }
  return isRead;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionSource::ReadRegion(const int region[6], vtkImageData* image, std::string& error)
{
  if (!region || !image)
  {
    error = "ReadRegion() needs an extent of six numbers and an image, but got a null pointer.";
    return false;
  }
  if (!this->Prepare(error))
  {
    return false;
  }
  BoxExtent box;
  for (int a = 0; a < 6; a += 2)
  {
    box[a] = std::max(region[a], this->WholeExtent[a]);
    box[a + 1] = std::min(region[a + 1], this->WholeExtent[a + 1]);
    if (box[a] > box[a + 1])
    {
      std::ostringstream message;
      message << "The region (" << region[0] << ", " << region[1] << ", " << region[2] << ", "
              << region[3] << ", " << region[4] << ", " << region[5]
              << ") has no part of the volume in it. Give an extent within WholeExtent.";
      error = message.str();
      return false;
    }
  }
  const vtkSmartPointer<vtkDataArray> samples = this->Store->Read(box, error);
  if (!samples)
  {
    return false;
  }
  image->Initialize();
  image->SetExtent(box.data());
  image->SetOrigin(this->Origin);
  image->SetSpacing(this->Spacing);
  image->SetDirectionMatrix(this->Direction);
  if (!this->PutSamples(samples, image, error))
  {
    return false;
  }
  this->Store->WriteFacts(image, false);
  return true;
}

//------------------------------------------------------------------------------
int vtkHapticRegionSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  std::string error;
  if (!this->Prepare(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  BoxExtent region;
  std::copy_n(this->WholeExtent, 6, region.begin());
  // Without samples, make the region only as wide as the kernel, so that no position in it counts
  // as resident.
  region = this->Store->GetSamples() ? this->Store->GetRegion()
                                     : ComputeMiddle(region, 2 * this->KernelRadius + 1);
  vtkInformation* const info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), region.data(), 6);
  info->Set(vtkDataObject::ORIGIN(), this->Origin, 3);
  info->Set(vtkDataObject::SPACING(), this->Spacing, 3);
  info->Set(vtkDataObject::DIRECTION(), this->Direction, 9);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->ScalarType, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticRegionSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(outputs);
  int region[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), region);
  output->SetExtent(region);
  output->SetOrigin(this->Origin);
  output->SetSpacing(this->Spacing);
  output->SetDirectionMatrix(this->Direction);
  std::string error;
  if (!this->PutSamples(this->Store->GetSamples(), output, error))
  {
    vtkErrorMacro(<< Printable(error));
    return 0;
  }
  this->Store->WriteFacts(output, true);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticRegionSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintSettings(os, indent, this, RegionSourceVectors);
  PrintSettings(os, indent, this, RegionSourceSettings);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Reader: " << (this->Function ? "set" : "(none)") << "\n";
  os << indent << "CoarseImage: " << (this->CoarseImage ? "set" : "(none)") << "\n";
  os << indent << "Status: " << this->GetStatusText() << "\n";
}
