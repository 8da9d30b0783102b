// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A source of an image's time steps.
 */
#ifndef TimeSource_h
#define TimeSource_h

#include <vtkDataArray.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace apitest
{

/// A source that produces the time steps of an image. Like a reader, it writes each time step to
/// the same memory.
class TimeSource : public vtkImageAlgorithm
{
public:
  static TimeSource* New() { VTK_STANDARD_NEW_BODY(TimeSource); }
  vtkTypeMacro(TimeSource, vtkImageAlgorithm);

  std::vector<double> Steps;
  std::function<vtkSmartPointer<vtkImageData>(double)> Make;
  std::vector<double> Asked;
  double FailsAt = std::numeric_limits<double>::quiet_NaN();

protected:
  TimeSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const info = outputs->GetInformationObject(0);
    info->Set(Pipeline::WHOLE_EXTENT(), this->Make(this->Steps.front())->GetExtent(), 6);
    info->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
    const double range[] = { this->Steps.front(), this->Steps.back() };
    info->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const info = outputs->GetInformationObject(0);
    const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
      ? info->Get(Pipeline::UPDATE_TIME_STEP())
      : this->Steps.front();
    this->Asked.push_back(time);
    if (time == this->FailsAt)
    {
      return 0;
    }
    const auto made = this->Make(time);
    vtkDataArray* const array = made->GetPointData()->GetScalars();
    if (this->Memory && array && this->Memory->GetDataSize() == array->GetDataSize() &&
      this->Memory->GetDataType() == array->GetDataType())
    {
      std::memcpy(this->Memory->GetVoidPointer(0), array->GetVoidPointer(0),
        static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize());
      this->Memory->Modified();
      made->GetPointData()->SetScalars(this->Memory);
    }
    else if (array)
    {
      this->Memory = array;
    }
    vtkImageData* const output = vtkImageData::GetData(info);
    output->ShallowCopy(made);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }

private:
  vtkSmartPointer<vtkDataArray> Memory;
};

} // namespace apitest

#endif
