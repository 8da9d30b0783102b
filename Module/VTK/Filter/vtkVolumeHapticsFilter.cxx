// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsFilter.h"

#include "VTK/Baking/HapticCut.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Base/HapticHash.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Filter/HapticMethods.h"
#include "VTK/Filter/PathTouch.h"
#include "VTK/Filter/PlannerSettings.h"
#include "VTK/Modes/ModePresets.h"
#include "VTK/Regions/RegionPlanner.h"
#include "VTK/Tools/ToolKind.h"
#include "VTK/Trace/TraceArrayChoice.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkHapticTool.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <utility>

namespace
{
/** Returns whether the requested piece is a later one; the first piece contains the whole trace. */
bool IsLaterPiece(vtkInformationVector* outputs)
{
  vtkInformation* const output = outputs->GetInformationObject(0);
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}
} // namespace

vtkStandardNewMacro(vtkVolumeHapticsFilter);
vtkCxxSetSmartPointerMacro(vtkVolumeHapticsFilter, LabelTable, vtkHapticLabelTable);

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::vtkVolumeHapticsFilter()
  : TraceArrays(VolumeHaptics::AllTraceArrays)
  , Baker(new VolumeHaptics::HapticBaker(this))
  , Hashes(new VolumeHaptics::ArrayHash[2])
  , Removal(vtkSmartPointer<vtkHapticRemoval>::New())
  , Cut(new VolumeHaptics::HapticCut)
{
  this->SetNumberOfInputPorts(4);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->SetInputArrayToProcess(
    1, 3, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::~vtkVolumeHapticsFilter() = default;

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetProperty(vtkHapticProperty* property)
{
  if (this->Property != property)
  {
    this->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticProperty* vtkVolumeHapticsFilter::GetProperty()
{
  if (!this->Property)
  {
    this->Property = vtkSmartPointer<vtkHapticProperty>::New();
  }
  return this->Property;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::AddMode(vtkHapticMode* mode)
{
  if (mode && std::find(this->Modes.begin(), this->Modes.end(), mode) == this->Modes.end())
  {
    this->Modes.emplace_back(mode);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveMode(vtkHapticMode* mode)
{
  const auto found = std::find(this->Modes.begin(), this->Modes.end(), mode);
  if (found != this->Modes.end())
  {
    this->Modes.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveAllModes()
{
  if (!this->Modes.empty())
  {
    this->Modes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::GetNumberOfModes()
{
  return static_cast<int>(this->Modes.size());
}

//------------------------------------------------------------------------------
vtkHapticMode* vtkVolumeHapticsFilter::GetMode(int mode)
{
  return mode >= 0 && mode < this->GetNumberOfModes()
    ? this->Modes[static_cast<std::size_t>(mode)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetTool(vtkHapticTool* tool)
{
  if (tool && !VolumeHaptics::FindToolKind(tool))
  {
    vtkErrorMacro("A " << tool->GetClassName()
                       << " can't be felt and is not set: derive it from one of the module's "
                          "tools, such as vtkHapticNeedle.");
    return;
  }
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticTool* vtkVolumeHapticsFilter::GetTool()
{
  return this->Tool;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::ApplyModePreset(const char* name, vtkImageData* image)
{
  std::string error;
  const VolumeHaptics::HapticModes modes = VolumeHaptics::MakeModePreset(name, image, error);
  if (modes.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  this->RemoveAllModes();
  for (vtkHapticMode* const mode : modes)
  {
    this->AddMode(mode);
  }
  this->SetMethodToPrimitives();
  return true;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVolumeHapticsFilter::GetModePresetNames()
{
  static const vtkSmartPointer<vtkStringArray> names = VolumeHaptics::MakeModePresetNames();
  return names;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetDisplacementArrayName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->DisplacementArrayName != wanted)
  {
    this->DisplacementArrayName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::GetDisplacementArrayName()
{
  return this->DisplacementArrayName;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVolumeHapticsFilter::GetMethodNames()
{
  static const vtkSmartPointer<vtkStringArray> names = []
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    for (const VolumeHaptics::MethodChoice& choice : VolumeHaptics::MethodChoices())
    {
      array->InsertNextValue(choice.Name);
    }
    return array;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::Choose(std::size_t choice)
{
  const VolumeHaptics::MethodChoice& chosen = VolumeHaptics::MethodChoices()[choice];
  this->SetMethod(chosen.Method);
  if (chosen.Solver != VolumeHaptics::MethodChoice::AnySolver)
  {
    this->SetSolver(chosen.Solver);
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::SetMethodByName(const char* name)
{
  const auto& all = VolumeHaptics::MethodChoices();
  const std::string wanted = name ? name : "";
  std::string known;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted == all[i].Name)
    {
      this->Choose(i);
      return true;
    }
    known += (i > 0 ? ", \"" : "\"") + std::string(all[i].Name) + "\"";
  }
  vtkErrorMacro("There is no method \"" << wanted << "\". Take one of " << known << ".");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::GetMethodName()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Name;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::GetMethodText()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Text;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::NextMethod()
{
  const auto& all = VolumeHaptics::MethodChoices();
  std::size_t next = VolumeHaptics::FindMethodChoice(this->Method, this->Solver) + 1;
  if (next < all.size() && all[next].Method == PRIMITIVES && this->Modes.empty())
  {
    ++next;
  }
  this->Choose(next % all.size());
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::ChooseTraceArrays(const std::vector<std::string>& names)
{
  VolumeHaptics::TraceArrayChoice choice = 0;
  const std::string error = VolumeHaptics::ReadTraceArrays(names, choice);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  if (this->TraceArrays != choice)
  {
    this->TraceArrays = choice;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::SetTraceArrays(const char* names)
{
  return this->ChooseTraceArrays(VolumeHaptics::SplitTraceArrays(names ? names : "all"));
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::SetTraceArrays(vtkStringArray* names)
{
  std::vector<std::string> words;
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    words.push_back(names->GetValue(i));
  }
  return this->ChooseTraceArrays(names ? words : std::vector<std::string>{ "all" });
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::GetTraceArrays()
{
  return VolumeHaptics::DescribeTraceArrays(this->TraceArrays);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::CheckTraceArrays(const std::string& names)
{
  VolumeHaptics::TraceArrayChoice choice = 0;
  return VolumeHaptics::ReadTraceArrays(VolumeHaptics::SplitTraceArrays(names), choice);
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::GetNumberOfTraceArrays()
{
  return static_cast<int>(VolumeHaptics::GetNumberOfTraceArrays());
}

//------------------------------------------------------------------------------
const char* vtkVolumeHapticsFilter::GetTraceArrayName(int array)
{
  return array >= 0 && array < this->GetNumberOfTraceArrays()
    ? VolumeHaptics::GetTraceArrayName(static_cast<std::size_t>(array))
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::GetTraceArrayStatus(const char* name)
{
  const std::size_t array = VolumeHaptics::FindTraceArray(name ? name : "");
  return array < VolumeHaptics::GetNumberOfTraceArrays() &&
    VolumeHaptics::IsChosen(this->TraceArrays, array);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetTraceArrayStatus(const char* name, int status)
{
  this->ChooseTraceArrays(
    VolumeHaptics::ListTraceArrays(this->TraceArrays, name ? name : "", status != 0));
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::PrintSettings(ostream& os, vtkIndent indent)
{
  os << indent << "Property: ";
  if (this->Property)
  {
    os << "\n";
    this->Property->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::FilterSettings);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::FilterTexts);
  for (vtkHapticMode* const mode : this->Modes)
  {
    os << indent << "Mode: " << mode->GetClassName() << "\n";
    mode->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Tool: " << (this->Tool ? this->Tool->GetClassName() : "(none)") << "\n";
  if (this->Tool)
  {
    this->Tool->PrintSelf(os, indent.GetNextIndent());
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetPathData(vtkPolyData* path)
{
  this->SetInputDataInternal(1, path);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputDataInternal(2, surface);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetLabelData(vtkImageData* labels)
{
  this->SetInputDataInternal(3, labels);
}

//------------------------------------------------------------------------------
vtkHapticLabelTable* vtkVolumeHapticsFilter::GetLabelTable()
{
  return this->LabelTable;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetRemoval(vtkHapticRemoval* removal)
{
  if (!removal)
  {
    this->SetRemoval(vtkNew<vtkHapticRemoval>());
  }
  else if (this->Removal != removal)
  {
    this->Removal = removal;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticRemoval* vtkVolumeHapticsFilter::GetRemoval()
{
  return this->Removal;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetClippingPlanes(vtkPlaneCollection* planes)
{
  if (this->Cut->Planes != planes)
  {
    this->Cut->Planes = planes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlaneCollection* vtkVolumeHapticsFilter::GetClippingPlanes()
{
  return this->Cut->Planes;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::AddClippingPlane(vtkPlane* plane)
{
  if (plane && !this->Cut->Planes)
  {
    this->SetClippingPlanes(vtkNew<vtkPlaneCollection>());
  }
  if (plane && !this->Cut->Planes->IsItemPresent(plane))
  {
    this->Cut->Planes->AddItem(plane);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveClippingPlane(vtkPlane* plane)
{
  if (this->Cut->Planes && this->Cut->Planes->IsItemPresent(plane))
  {
    this->Cut->Planes->RemoveItem(plane);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveAllClippingPlanes()
{
  this->SetClippingPlanes(nullptr);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCropping(bool cropping)
{
  if (this->Cut->Cropping != cropping)
  {
    this->Cut->Cropping = cropping;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::GetCropping()
{
  return this->Cut->Cropping;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionPlanes(const double planes[6])
{
  if (!std::equal(planes, planes + 6, this->Cut->RegionPlanes))
  {
    std::copy(planes, planes + 6, this->Cut->RegionPlanes);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionPlanes(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double planes[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  this->SetCroppingRegionPlanes(planes);
}

//------------------------------------------------------------------------------
double* vtkVolumeHapticsFilter::GetCroppingRegionPlanes()
{
  return this->Cut->RegionPlanes;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionFlags(int flags)
{
  if (this->Cut->RegionFlags != flags)
  {
    this->Cut->RegionFlags = flags;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::GetCroppingRegionFlags()
{
  return this->Cut->RegionFlags;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetFeelCutFaces(bool feel)
{
  if (this->Cut->HasSolidFaces != feel)
  {
    this->Cut->HasSolidFaces = feel;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::GetFeelCutFaces()
{
  return this->Cut->HasSolidFaces;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsFilter::GetMTime()
{
  vtkMTimeType time =
    std::max({ this->Superclass::GetMTime(), this->Cut->GetMTime(), this->Removal->GetMTime() });
  for (vtkHapticMode* const mode : this->Modes)
  {
    time = std::max(time, mode->GetMTime());
  }
  time = this->Tool ? std::max(time, this->Tool->GetMTime()) : time;
  time = this->Property ? std::max(time, this->Property->GetMTime()) : time;
  return this->LabelTable ? std::max(time, this->LabelTable->GetMTime()) : time;
}

//------------------------------------------------------------------------------
vtkHapticRegionSource* vtkVolumeHapticsFilter::GetRegionSource()
{
  if (auto* const source = vtkHapticRegionSource::SafeDownCast(this->GetInputAlgorithm(0, 0)))
  {
    return source;
  }
  std::vector<std::string> arrays;
  const char* const name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  arrays.emplace_back(name ? name : "");
  for (vtkHapticMode* const mode : this->Modes)
  {
    const bool isFelt = this->Method == PRIMITIVES && mode->GetActive();
    arrays.push_back(isFelt ? mode->GetArrayName() : std::string());
  }
  return this->Baker->GetResampled().Find(this->GetInputDataObject(0, 0), std::move(arrays));
}

//------------------------------------------------------------------------------
vtkImageData* vtkVolumeHapticsFilter::GetTouchedImage()
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  vtkHapticRegionSource* const source = this->GetRegionSource();
  if (source && source != this->GetInputAlgorithm(0, 0))
  {
    this->ConfigureSource(source);
    source->Update();
    return source->GetOutput();
  }
  return image;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::ConfigureSource(vtkHapticRegionSource* source)
{
  if (!source)
  {
    vtkErrorMacro("ConfigureSource() needs a source of regions, but got a null pointer.");
    return;
  }
  VolumeHaptics::RegionPlanner& planner = source->GetPlanner();
  planner.SetWhole(
    source->GetWholeExtent(), source->GetOrigin(), source->GetSpacing(), source->GetDirection());
  VolumeHaptics::ConfigurePlanner(planner, this);
  source->SetFeltAs(this->KernelRadius, this->GetProperty()->GetScalarsAreLabels());
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    // Other data sets are accepted, too, and composite data as one object: see GetTouchedImage().
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashScalars()
{
  return this->Hashes[0].Get(this->Baker->GetTouched()[0]);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashLabels()
{
  return this->Hashes[1].Get(this->Baker->GetTouched()[1]);
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  if (VolumeHaptics::AreTimeStepsFelt(this) &&
    !VolumeHaptics::ReadTimeSteps(inputs[0]->GetInformationObject(0)).empty())
  {
    // The trace covers all time steps of the volume, so the output has no time steps itself.
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_STEPS());
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  const bool isFirst = !IsLaterPiece(outputs);
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* const input = inputs[port]->GetInformationObject(0);
    if (!input)
    {
      continue;
    }
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), isFirst ? 1 : 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (input->Has(Pipeline::WHOLE_EXTENT()))
    {
      constexpr int none[] = { 0, -1, 0, -1, 0, -1 };
      input->Set(
        Pipeline::UPDATE_EXTENT(), isFirst ? input->Get(Pipeline::WHOLE_EXTENT()) : none, 6);
      input->Set(Pipeline::EXACT_EXTENT(), 0);
    }
    if (port == 0 && VolumeHaptics::AreTimeStepsFelt(this))
    {
      const std::vector<double> steps = VolumeHaptics::ReadTimeSteps(input);
      if (!steps.empty())
      {
        input->Set(Pipeline::UPDATE_TIME_STEP(), steps.front());
      }
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  if (IsLaterPiece(outputs))
  {
    output->Initialize();
    return 1;
  }
  return VolumeHaptics::TouchPath(
    this, vtkPolyData::GetData(inputs[1]), this->TraceArrays, this->Hashes[1], output);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintSettings(os, indent);
  this->Cut->Print(os, indent);
  os << indent << "LabelTable: ";
  if (this->LabelTable)
  {
    os << "\n";
    this->LabelTable->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilterUpdate(vtkObjectBase* filter)
{
  if (auto* const haptics = vtkVolumeHapticsFilter::SafeDownCast(filter))
  {
    haptics->Update();
  }
}
