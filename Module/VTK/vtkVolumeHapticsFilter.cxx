// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsFilter.h"

#include "HapticModelBuilder.h"
#include "HapticTipPath.h"
#include "HapticTrace.h"
#include "vtkVolumeHapticsCompat.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkVolumeHapticsFilter);

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::vtkVolumeHapticsFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
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
void vtkVolumeHapticsFilter::SetPathData(vtkPolyData* path)
{
  this->SetInputDataInternal(1, path);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsFilter::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Property ? std::max(time, this->Property->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using namespace VolumeHaptics;

  vtkImageData* const image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* const path = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const scalars = this->GetInputArrayToProcess(0, inputs, association);
  if (!scalars || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    vtkErrorMacro("The input image has no point scalars to touch. Give its point data active "
                  "scalars, or name a numeric point array with SetInputArrayToProcess(0, 0, 0, "
                  "vtkDataObject::FIELD_ASSOCIATION_POINTS, name).");
    return 0;
  }

  HapticModelOptions options;
  options.Estimator = static_cast<VolumeHaptics::GradientEstimator>(this->GradientEstimator);
  options.KernelRadius = this->KernelRadius;
  // Device space is the world in metres; only its scale matters to an offline trace.
  options.DeviceToWorld.Linear = (1.0 / this->MetersPerWorldUnit) * Matrix3{};
  options.Settings.Method = static_cast<HapticMethod>(this->Method);
  options.Settings.TickPeriod = 1.0 / this->ServoRate;
  options.Settings.MaximumForce = this->MaximumForce;
  options.Settings.ForceFieldGain = this->ForceFieldGain;
  options.Settings.ForceFieldDamping = this->ForceFieldDamping;

  std::string error;
  const std::shared_ptr<const HapticModel> model =
    BuildHapticModel(image, scalars, this->GetProperty(), options, error);
  TipPath tips;
  if (!model || (path && !ReadTipPath(path, options.Settings.TickPeriod, tips, error)))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const auto ticks = static_cast<vtkIdType>(tips.Tips.size());
  const vtkIdType progressStep = std::max<vtkIdType>(1000, ticks / 100);
  HapticTrace trace;
  trace.Reserve(ticks);
  ServoState state;
  TickRecord record;
  for (vtkIdType i = 0; i < ticks; ++i)
  {
    if (i % progressStep == 0)
    {
      this->UpdateProgress(static_cast<double>(i) / ticks);
      if (MustAbort(this))
      {
        break;
      }
    }
    Tick(*model, state, model->WorldToDevice(tips.Tips[i]), record);
    trace.Append(*model, tips.StartTime + i * options.Settings.TickPeriod, record);
  }
  trace.WriteTo(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
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
  static const char* const estimators[] = { "CentralDifference", "Gaussian", "CubicBSpline" };
  os << indent << "Method: " << (this->Method == PROXY ? "Proxy" : "ForceField") << "\n";
  os << indent << "Solver: Paper\n";
  os << indent << "GradientEstimator: " << estimators[this->GradientEstimator] << "\n";
  os << indent << "KernelRadius: " << this->KernelRadius << " voxels\n";
  os << indent << "ServoRate: " << this->ServoRate << " Hz\n";
  os << indent << "MetersPerWorldUnit: " << this->MetersPerWorldUnit << "\n";
  os << indent << "ForceFieldGain: " << this->ForceFieldGain << "\n";
  os << indent << "ForceFieldDamping: " << this->ForceFieldDamping << "\n";
  os << indent << "MaximumForce: " << this->MaximumForce << " N\n";
}
