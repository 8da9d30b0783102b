// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests output in pieces, which several ranks request. The first piece contains everything. */

#include "Rigs/ApiRig.h"

#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

using namespace apitest;

namespace
{
/// A source that provides the requested part of an image, and records the requests.
class Cropper : public vtkImageAlgorithm
{
public:
  static Cropper* New();
  vtkTypeMacro(Cropper, vtkImageAlgorithm);

  vtkSmartPointer<vtkImageData> Image;
  std::vector<vtkIdType> Asked; // points

protected:
  Cropper() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Image->GetExtent(), 6);
    outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* const info = outputs->GetInformationObject(0);
    vtkImageData* const output = vtkImageData::GetData(info);
    output->ShallowCopy(this->Image);
    output->Crop(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
    this->Asked.push_back(output->GetNumberOfPoints());
    return 1;
  }
};
vtkStandardNewMacro(Cropper);

using FilterPieces = ApiTest;
} // namespace

TEST_F(FilterPieces, TheFirstIsTheWholeTraceAndTheOthersAreEmpty)
{
  const auto whole = (this->Run(51), Keep(this->Filter));
  vtkNew<Cropper> cropper;
  cropper->Image = this->Image;
  this->Filter->SetInputConnection(cropper->GetOutputPort());
  for (const int pieces : { 2, 7 })
  {
    for (int piece = 0; piece < pieces; ++piece)
    {
      this->Filter->Modified();
      this->Filter->UpdatePiece(piece, pieces, 0);
      EXPECT_TRUE(this->Log.Errors.empty());
      EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), piece == 0 ? 51 : 0);
      if (piece == 0)
      {
        EXPECT_TRUE(IsSame(this->Filter->GetOutput(), whole));
      }
    }
  }
  // An empty piece must not read the volume.
  for (const vtkIdType asked : cropper->Asked)
  {
    EXPECT_TRUE(asked == this->Image->GetNumberOfPoints() || asked == 0) << asked;
  }
  this->Filter->UpdatePiece(0, 1, 0);
  EXPECT_TRUE(IsSame(this->Filter->GetOutput(), whole));
}

TEST_F(FilterPieces, AnEmptyPieceHasNothingToSayOfBadInput)
{
  this->Image->GetPointData()->Initialize();
  this->Filter->UpdatePiece(1, 2, 0);
  EXPECT_TRUE(this->Log.Errors.empty());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}
