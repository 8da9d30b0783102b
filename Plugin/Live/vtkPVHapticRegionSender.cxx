// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionSender.h"

#include "HapticRegionMessage.h"
#include "vtkPVHapticLargeFile.h"
#include "vtkPVHapticRegionFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkPVHapticRegionSender);

//------------------------------------------------------------------------------
/** The volume at a time that was sent. */
struct vtkPVHapticRegionSender::Instant
{
  vtkNew<vtkPVHapticRegionFilter> Filter;
  double Time = 0.0;
  bool IsThere = false;
  int Whole[6] = { 0, -1, 0, -1, 0, -1 };
  std::string Array;
};

namespace
{

/** A corner in which the largest kernel fits. */
constexpr int CornerSteps = 39;

/** The region that was asked for, or the corner of a volume. */
void ChooseRegion(const int whole[6], const int region[6], int wanted[6])
{
  std::copy_n(region, 6, wanted);
  if (region[0] > region[1])
  {
    for (int a = 0; a < 6; a += 2)
    {
      wanted[a] = whole[a];
      wanted[a + 1] = std::min(whole[a] + CornerSteps, whole[a + 1]);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkPVHapticRegionSender::vtkPVHapticRegionSender()
{
  for (std::unique_ptr<Instant>& instant : this->Instants)
  {
    instant.reset(new Instant);
  }
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
bool vtkPVHapticRegionSender::UpdatePiece(Instant& instant)
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
  info->Get(Pipeline::WHOLE_EXTENT(), instant.Whole);
  instant.Filter->SetPiece(piece, instant.Whole);
  return true;
}

//------------------------------------------------------------------------------
vtkPVHapticRegionSender::Instant* vtkPVHapticRegionSender::Find(double time, bool isPresent)
{
  const Instant& latest = *this->Instants[this->Latest];
  if (isPresent && latest.IsThere && latest.Time != time)
  {
    this->Latest = 1 - this->Latest; // the older one is no longer needed
  }
  if (isPresent)
  {
    Instant& present = *this->Instants[this->Latest];
    present.Time = time;
    present.IsThere = true;
    return &present;
  }
  for (const std::unique_ptr<Instant>& instant : this->Instants)
  {
    if (instant->IsThere && instant->Time == time)
    {
      return instant.get();
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::Assemble(
  Instant& instant, bool isPresent, const char* array, const int region[6], std::string& error)
{
  vtkPVHapticRegionFilter* const filter = instant.Filter;
  filter->SetController(vtkMultiProcessController::GetGlobalController());
  const std::string name = array ? array : "";
  if (name != instant.Array)
  {
    instant.Array = name;
    const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    name.empty() ? filter->SetInputArrayToProcess(0, 0, 0, points, vtkDataSetAttributes::SCALARS)
                 : filter->SetInputArrayToProcess(0, 0, 0, points, name.c_str());
  }
  const bool hasPiece = !isPresent || this->UpdatePiece(instant);
  if (!filter->CanExecute(hasPiece, error))
  {
    return false;
  }
  int wanted[6];
  ChooseRegion(instant.Whole, region, wanted);
  filter->SetRegion(wanted);
  filter->Modified(); // on every process, or on none
  if (!filter->UpdateExtent(filter->GetRegion()))
  {
    error = "The server could not cut out what is around the tip. Its messages say why.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::ReadLargeFile(
  const int region[6], vtkImageData* image, std::string& error)
{
  vtkPVHapticLargeFile* const file = vtkPVHapticLargeFile::Find(this->GetInputConnection(0, 0));
  if (!file->Open())
  {
    error = "The server could not open the file. Its messages say why.";
    return false;
  }
  vtkHapticRegionSource* const regions = file->GetRegions();
  int wanted[6];
  ChooseRegion(regions->GetWholeExtent(), region, wanted);
  return regions->ReadRegion(wanted, image, error);
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionSender::Send(
  const char* array, int x0, int x1, int y0, int y1, int z0, int z1, double time, int isPresent)
{
  using namespace VolumeHapticsLive;

  const int region[6] = { x0, x1, y0, y1, z0, z1 };
  std::vector<char> message;
  std::string error;
  try
  {
    const bool isFirst = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
    if (vtkPVHapticLargeFile::Find(this->GetInputConnection(0, 0)))
    {
      if (!isFirst)
      {
        return;
      }
      vtkNew<vtkImageData> image;
      message = this->ReadLargeFile(region, image, error) ? PackRegion(image) : PackError(error);
    }
    else
    {
      Instant* const instant = this->Find(time, isPresent != 0);
      const bool isThere =
        instant && this->Assemble(*instant, isPresent != 0, array, region, error);
      if (!instant)
      {
        error = "The server no longer has the volume at the time that was asked for.";
      }
      if (!isFirst)
      {
        return;
      }
      message = isThere ? PackRegion(instant->Filter->GetOutput()) : PackError(error);
    }
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
  os << indent << "Time: " << this->Instants[this->Latest]->Time << "\n";
}
