// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticImageLink.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkSISourceProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

namespace VolumeHapticsLive
{
namespace
{

vtkDataObject* OutputOf(vtkSMSourceProxy* source, unsigned int port)
{
  if (!source || !source->GetSession())
  {
    return nullptr;
  }
  source->UpdatePipeline();
  auto* const implementation =
    vtkSISourceProxy::SafeDownCast(source->GetSession()->GetSIObject(source->GetGlobalID()));
  vtkAlgorithmOutput* const output =
    implementation ? implementation->GetOutputPort(static_cast<int>(port)) : nullptr;
  return output ? output->GetProducer()->GetOutputDataObject(output->GetIndex()) : nullptr;
}

} // namespace

void HapticImageLink::Follow(
  vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort)
{
  vtkDataObject* const data = OutputOf(source, port);
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (data == this->Seen && time == this->SeenTime && filter == this->SeenFilter)
  {
    return;
  }
  this->Seen = data;
  this->SeenTime = time;
  this->SeenFilter = filter;
  vtkSmartPointer<vtkDataObject> copy;
  if (data)
  {
    copy.TakeReference(data->NewInstance());
    copy->ShallowCopy(data);
  }
  filter->SetInputDataObject(filterPort, copy);
}

} // namespace VolumeHapticsLive
