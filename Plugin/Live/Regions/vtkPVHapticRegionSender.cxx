// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionSender.h"

#include "HapticRegionMessage.h"
#include "vtkPVHapticLargeFile.h"
#include "vtkPVHapticRegionFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPointData.h"
#include "vtkProcessModule.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkPVHapticRegionSender);

//------------------------------------------------------------------------------
/** The volume at one of the sent times. */
struct vtkPVHapticRegionSender::Instant
{
  vtkNew<vtkPVHapticRegionFilter> Filter;
  double Time = 0.0;
  bool IsThere = false;
  int Whole[6] = { 0, -1, 0, -1, 0, -1 };
  std::string Array;
  ///@{
  /**
   * The next five members are for data other than images: the piece of this process, and the source
   * that resamples all pieces.
   */
  vtkSmartPointer<vtkDataObject> Piece; ///< a shallow copy
  vtkWeakPointer<vtkDataObject> Seen;
  vtkMTimeType SeenTime = 0;
  bool IsNew = false; ///< whether the piece has changed since Regions was opened
  /** exists on the first process; null if it could not be opened */
  vtkSmartPointer<vtkHapticRegionSource> Regions;
  std::string Problem; ///< reason why Regions is null
  ///@}

  void CopyGrid(vtkDataObject* data)
  {
    if (data != this->Seen || data->GetMTime() != this->SeenTime || !this->Piece)
    {
      this->Seen = data;
      this->SeenTime = data->GetMTime();
      this->Piece.TakeReference(data->NewInstance());
      this->Piece->ShallowCopy(data);
      this->IsNew = true;
    }
  }
};

namespace
{

/** The size of a volume's corner (samples along an axis), with room for the largest kernel. */
constexpr int CornerSteps = 39;

/** Writes the requested region to `wanted`, or a corner of the volume if the region is empty. */
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

/** Gathers the pieces of all processes on the first process. Every process must have a piece. */
vtkSmartPointer<vtkDataObject> GatherPieces(
  vtkDataObject* piece, vtkMultiProcessController* controller)
{
  if (controller->GetNumberOfProcesses() == 1)
  {
    return piece;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  controller->Gather(piece, pieces, 0);
  const auto whole = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const vtkSmartPointer<vtkDataObject>& one : pieces)
  {
    whole->SetBlock(whole->GetNumberOfBlocks(), one);
  }
  return whole;
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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
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
  // Make the same request as ParaView's own views, so that nothing is read again.
  vtkAlgorithm* const source = input->GetProducer();
  const int port = input->GetIndex();
  auto* const pipeline = Pipeline::SafeDownCast(source->GetExecutive());
  if (!pipeline || !pipeline->UpdateInformation())
  {
    return false;
  }
  vtkInformation* const info = source->GetOutputInformation(port);
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    // Set the whole extent: a filter with a path requests nothing on the other processes, which
    // would leave their extent empty.
    int whole[6];
    info->Get(Pipeline::WHOLE_EXTENT(), whole);
    info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
    vtkProcessModule::GetNumberOfGhostLevelsToRequest(info));
  const bool isGood = pipeline->Update(port) != 0;
  vtkDataObject* const data = source->GetOutputDataObject(port);
  auto* const piece = vtkImageData::SafeDownCast(data);
  if (isGood && data && !piece)
  {
    instant.CopyGrid(data);
    return true;
  }
  instant.Piece = nullptr;
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
    this->Latest = 1 - this->Latest; // overwrite the older time, which is no longer needed
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
bool vtkPVHapticRegionSender::IsGrid(const Instant& instant)
{
  const int here = instant.Piece ? 1 : 0;
  int isGrid = here;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &here, &isGrid, 1, vtkCommunicator::MAX_OP);
  return isGrid != 0;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::Resample(Instant& instant, bool hasPiece, const char* array,
  const int region[6], vtkImageData* image, std::string& error)
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  const std::string name = array ? array : "";
  const int here[2] = { hasPiece && instant.Piece ? 0 : 1,
    instant.IsNew || name != instant.Array ? 1 : 0 };
  int all[2] = { 1, 1 };
  controller->AllReduce(here, all, 2, vtkCommunicator::MAX_OP);
  if (all[0])
  {
    error = "The server could not bring the data up to date. Its messages say why.";
    return false;
  }
  const bool isFirst = controller->GetLocalProcessId() == 0;
  if (all[1])
  {
    instant.IsNew = false;
    instant.Array = name;
    instant.Regions = nullptr;
    const vtkSmartPointer<vtkDataObject> whole = GatherPieces(instant.Piece, controller);
    if (isFirst)
    {
      const auto regions = vtkSmartPointer<vtkHapticRegionSource>::New();
      const std::vector<std::string> wanted(name.empty() ? 0 : 1, name);
      instant.Problem.clear();
      if (regions->OpenDataSet(whole, 0.0, wanted, instant.Problem))
      {
        instant.Regions = regions;
      }
    }
  }
  if (!isFirst)
  {
    return true;
  }
  if (!instant.Regions)
  {
    error = instant.Problem;
    return false;
  }
  int box[6];
  ChooseRegion(instant.Regions->GetWholeExtent(), region, box);
  if (!instant.Regions->ReadRegion(box, image, error))
  {
    return false;
  }
  vtkPointData* const points = image->GetPointData();
  if (vtkDataArray* const found = name.empty() ? nullptr : points->GetArray(name.c_str()))
  {
    points->SetScalars(found); // marks the array to send
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionSender::Assemble(
  Instant& instant, bool hasPiece, const char* array, const int region[6], std::string& error)
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
  if (!filter->CanExecute(hasPiece, error))
  {
    return false;
  }
  int wanted[6];
  ChooseRegion(instant.Whole, region, wanted);
  filter->SetRegion(wanted);
  filter->Modified(); // on all processes or on none
  if (!filter->UpdateExtent(filter->GetRegion()))
  {
    error = filter->GetProblem();
    error = error.empty()
      ? "The server could not cut out what is around the tip. Its messages say why."
      : error;
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
      const bool hasPiece = instant && (!isPresent || this->UpdatePiece(*instant));
      const bool isGrid = instant && IsGrid(*instant);
      vtkNew<vtkImageData> resampled;
      bool isThere = false;
      if (isGrid)
      {
        isThere = Resample(*instant, hasPiece, array, region, resampled, error);
      }
      else if (instant)
      {
        isThere = this->Assemble(*instant, hasPiece, array, region, error);
      }
      else
      {
        error = "The server no longer has the volume at the time that was asked for.";
      }
      if (!isFirst)
      {
        return;
      }
      vtkImageData* const image = isGrid ? resampled.Get() : nullptr;
      message =
        isThere ? PackRegion(image ? image : instant->Filter->GetOutput()) : PackError(error);
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
