// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionSender.h"

#include "HapticRegionMessage.h"
#include "vtkPVHapticRegionFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkPVHapticRegionSender);

namespace
{

/** A corner in which the largest kernel fits. */
constexpr int CornerSteps = 39;

} // namespace

//------------------------------------------------------------------------------
vtkPVHapticRegionSender::vtkPVHapticRegionSender()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkPVHapticRegionSender::~vtkPVHapticRegionSender() = default;

//------------------------------------------------------------------------------
int vtkPVHapticRegionSender::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::UpdatePiece(int whole[6])
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  vtkAlgorithmOutput* const input = this->GetInputConnection(0, 0);
  if (!input)
  {
    return false;
  }
  // Requests the same as ParaView's own views, so that nothing is read a second time.
  vtkAlgorithm* const source = input->GetProducer();
  const int port = input->GetIndex();
  auto* const pipeline = Pipeline::SafeDownCast(source->GetExecutive());
  if (!pipeline || !pipeline->UpdateInformation())
  {
    return false;
  }
  vtkInformation* const info = source->GetOutputInformation(port);
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
    vtkProcessModule::GetNumberOfGhostLevelsToRequest(info));
  const bool isGood = pipeline->Update(port) != 0;
  auto* const piece = vtkImageData::SafeDownCast(source->GetOutputDataObject(port));
  if (!isGood || !piece || !info->Has(Pipeline::WHOLE_EXTENT()))
  {
    return false;
  }
  info->Get(Pipeline::WHOLE_EXTENT(), whole);
  this->Filter->SetPiece(piece, whole);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::Assemble(const char* array, const int region[6], std::string& error)
{
  this->Filter->SetController(vtkMultiProcessController::GetGlobalController());
  const std::string name = array ? array : "";
  if (name != this->Array)
  {
    this->Array = name;
    const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    name.empty()
      ? this->Filter->SetInputArrayToProcess(0, 0, 0, points, vtkDataSetAttributes::SCALARS)
      : this->Filter->SetInputArrayToProcess(0, 0, 0, points, name.c_str());
  }
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  const bool hasPiece = this->UpdatePiece(whole);
  if (!this->Filter->CanExecute(hasPiece, error))
  {
    return false;
  }
  int wanted[6];
  std::copy_n(region, 6, wanted);
  if (region[0] > region[1])
  {
    for (int a = 0; a < 6; a += 2)
    {
      wanted[a] = whole[a];
      wanted[a + 1] = std::min(whole[a] + CornerSteps, whole[a + 1]);
    }
  }
  this->Filter->SetRegion(wanted);
  this->Filter->Modified(); // on every process, or on none
  if (!this->Filter->UpdateExtent(this->Filter->GetRegion()))
  {
    error = "The server could not cut out what is around the tip. Its messages say why.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionSender::Send(
  const char* array, int x0, int x1, int y0, int y1, int z0, int z1)
{
  using namespace VolumeHapticsLive;

  const int region[6] = { x0, x1, y0, y1, z0, z1 };
  std::vector<char> message;
  std::string error;
  try
  {
    const bool isThere = this->Assemble(array, region, error);
    if (vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() > 0)
    {
      return;
    }
    message = isThere ? PackRegion(this->Filter->GetOutput()) : PackError(error);
  }
  catch (const std::exception& exception)
  {
    message = PackError(std::string("The server could not cut out what is around the tip (") +
      exception.what() + "). Lower MaximumRegionVoxels.");
  }
  auto* const session =
    vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  if (auto* const client = session ? session->GetController(vtkPVSession::CLIENT) : nullptr)
  {
    SendMessage(client, message);
  }
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionSender::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Array: " << (this->Array.empty() ? "(active scalars)" : this->Array.c_str())
     << "\n";
}
