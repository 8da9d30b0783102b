// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a scene's volumes that display an array also display what a tool has left of it. */

#include "CarvedScene.h"
#include "VTK/Scene/Volumes/CarvedPicture.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticRemoval.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkVariant.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

using namespace carvedtest;

namespace
{
class CarvedPicturesScene : public testing::Test
{
protected:
  /// Draws as many frames as the pictures request. Returns the last frame.
  std::vector<int> Follow(const std::vector<CarvedArray>& arrays)
  {
    std::vector<int> drawn;
    int frames = 0;
    do
    {
      this->Pictures.Update(this->Scene.Renderer, arrays);
      drawn = this->Scene.Draw();
    } while (this->Pictures.Update(this->Scene.Renderer, arrays) && ++frames < 10);
    EXPECT_LT(frames, 10);
    return drawn;
  }
  CarvedArray MakeArray() const
  {
    CarvedArray array;
    array.Array = this->Image->GetPointData()->GetScalars();
    std::copy(Size, Size + 3, array.Dimensions);
    array.Removal = this->Burr.Removal;
    return array;
  }

  vtkSmartPointer<vtkImageData> Image = MakeImage(VTK_UNSIGNED_CHAR, 1, 0.0, 250.0);
  Carving Burr;
  Shown Scene{ vtkNew<vtkVolume>(), vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), 1, 0.0, 250.0 };
  CarvedPictures Pictures;
};
} // namespace

TEST_F(CarvedPicturesScene, ShowsItInAllVolumesOfTheWindow)
{
  this->Scene.Mapper->SetInputDataObject(this->Image);
  // Another mapper displays the same array beside the first volume.
  vtkNew<vtkVolume> second;
  vtkNew<vtkFixedPointVolumeRayCastMapper> copied;
  copied->SetInputData(this->Image);
  second->SetMapper(copied);
  SetLook(second->GetProperty(), 1, 0.0, 250.0);
  vtkNew<vtkRenderer> beside;
  beside->AddVolume(second);
  this->Scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  this->Scene.Window->AddRenderer(beside);
  beside->SetActiveCamera(this->Scene.Renderer->GetActiveCamera());
  const std::vector<int> whole = this->Follow({});
  EXPECT_EQ(Difference(this->Follow({ this->MakeArray() }), whole), 0) << "nothing was removed";
  EXPECT_EQ(copied->GetInput(), this->Image);

  this->Burr.At(28.0, 19.0, 30.0, 7.0);
  const std::vector<int> carved = this->Follow({ this->MakeArray() });
  int differences[2] = { 0, 0 };
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    int& most = differences[i / 3 % Side >= Side / 2 ? 1 : 0];
    most = std::max(most, std::abs(whole[i] - carved[i]));
  }
  EXPECT_GT(differences[0], 20);
  EXPECT_GT(differences[1], 20);
  // The mapper without a texture uses a copy, but GetImage() must return the application's image.
  EXPECT_NE(copied->GetInput(), this->Image);
  EXPECT_EQ(this->Pictures.GetImage(copied), this->Image);
  EXPECT_EQ(this->Pictures.GetImage(this->Scene.Mapper), this->Image);
  EXPECT_EQ(
    this->Pictures.GetGivenInput(this->Scene.Mapper), this->Scene.Mapper->GetInputConnection(0, 0));

  // With the removal of another filter, or without a removal, the whole volume must be displayed.
  CarvedArray other = this->MakeArray();
  other.Removal = std::make_shared<TissueRemoval>();
  EXPECT_LE(Difference(this->Follow({ other }), whole), 1);
  EXPECT_LE(Difference(this->Follow({ this->MakeArray() }), carved), 1);
  EXPECT_TRUE(this->Pictures.Update(this->Scene.Renderer, {})) << "all tissue is to be drawn";
  EXPECT_LE(Difference(this->Scene.Draw(), whole), 1);
  EXPECT_EQ(copied->GetInput(), this->Image);
  EXPECT_FALSE(this->Pictures.Update(this->Scene.Renderer, {}));
}

TEST_F(CarvedPicturesScene, LeavesOtherVolumesAlone)
{
  const vtkSmartPointer<vtkImageData> other = MakeImage(VTK_UNSIGNED_CHAR, 1, 0.0, 250.0);
  this->Scene.Mapper->SetInputDataObject(other);
  const std::vector<int> whole = this->Scene.Draw();
  this->Burr.At(28.0, 19.0, 30.0, 7.0);
  EXPECT_FALSE(this->Pictures.Update(this->Scene.Renderer, { this->MakeArray() }));
  EXPECT_EQ(Difference(this->Follow({ this->MakeArray() }), whole), 0);
  // A mapper that receives the array later must also display the removal.
  this->Scene.Mapper->SetInputDataObject(this->Image);
  EXPECT_GT(Difference(this->Follow({ this->MakeArray() }), whole), 20);
  this->Scene.Mapper->SetInputDataObject(other);
  EXPECT_LE(Difference(this->Follow({ this->MakeArray() }), whole), 1);
  this->Scene.Mapper->SetInputDataObject(this->Image);
  EXPECT_GT(Difference(this->Follow({ this->MakeArray() }), whole), 20);
  EXPECT_EQ(this->Scene.Mapper->GetInputDataObject(0, 0), this->Image) << "by its texture";
  EXPECT_EQ(this->Pictures.GetImage(nullptr), nullptr);
  this->Pictures.Clear();
  EXPECT_LE(Difference(this->Scene.Draw(), whole), 1);
}

/// The volume displays a copy of the touched array, in which a part is hidden. Tissue must be
/// removed from this copy, first with a texture and then in another copy.
TEST_F(CarvedPicturesScene, ShowsItInAnArrayThatIsShownInstead)
{
  const vtkSmartPointer<vtkImageData> other = MakeImage(VTK_UNSIGNED_CHAR, 1, 0.0, 250.0);
  vtkDataArray* const shown = other->GetPointData()->GetScalars();
  for (vtkIdType i = 2; i < shown->GetNumberOfTuples() / 3; ++i)
  {
    shown->SetComponent(i, 0, 0.0);
  }
  shown->GetInformation()->Set(
    vtkHapticRemoval::TOUCHED_ARRAY(), this->Image->GetPointData()->GetScalars());
  this->Burr.At(28.0, 19.0, 30.0, 7.0);
  const vtkSmartPointer<vtkImageData> reference =
    MakeCarved(other, this->Burr.Fractions, 0, this->MakeArray().Air);
  this->Scene.Mapper->SetInputDataObject(other);
  const std::vector<int> whole = this->Scene.Draw();
  this->Scene.Mapper->SetInputDataObject(reference);
  const std::vector<int> expected = this->Scene.Draw();
  EXPECT_GT(Difference(expected, whole), 20);

  this->Scene.Mapper->SetInputDataObject(other);
  EXPECT_LE(Difference(this->Follow({ this->MakeArray() }), expected), 1);
  EXPECT_EQ(this->Scene.Mapper->GetInputDataObject(0, 0), other) << "by its texture";
  EXPECT_LE(Difference(this->Follow({}), whole), 1);

  vtkNew<vtkVolume> second;
  vtkNew<vtkFixedPointVolumeRayCastMapper> copied;
  copied->SetInputData(other);
  second->SetMapper(copied);
  SetLook(second->GetProperty(), 1, 0.0, 250.0);
  this->Scene.Renderer->RemoveAllViewProps();
  this->Scene.Renderer->AddVolume(second);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(this->Pictures.Update(this->Scene.Renderer, { this->MakeArray() }), i == 0) << i;
    vtkDataArray* const copy = copied->GetInput()->GetPointData()->GetScalars();
    vtkDataArray* const wanted = reference->GetPointData()->GetScalars();
    ASSERT_NE(copy, shown);
    for (vtkIdType at = 0; at < wanted->GetNumberOfTuples(); ++at)
    {
      ASSERT_EQ(copy->GetComponent(at, 0), wanted->GetComponent(at, 0)) << at;
    }
  }
  this->Burr.Reset();
  this->Follow({});
  EXPECT_EQ(copied->GetInput(), other);

  // An array that replaces another volume's array must remain whole, and so must an array of
  // another size.
  shown->GetInformation()->Set(vtkHapticRemoval::TOUCHED_ARRAY(), shown);
  this->Burr.At(28.0, 19.0, 30.0, 7.0);
  EXPECT_FALSE(this->Pictures.Update(this->Scene.Renderer, { this->MakeArray() }));
  shown->GetInformation()->Set(
    vtkHapticRemoval::TOUCHED_ARRAY(), this->Image->GetPointData()->GetScalars());
  shown->SetNumberOfTuples(shown->GetNumberOfTuples() - 1);
  EXPECT_FALSE(this->Pictures.Update(this->Scene.Renderer, { this->MakeArray() }));
}

namespace
{
/// A picture of a mapper without a texture, outside of any window.
struct Undrawn
{
  Undrawn(vtkImageData* image, const CarvedArray& array)
  {
    this->Mapper->SetInputData(image);
    this->Picture = std::make_unique<CarvedPicture>(this->Mapper, array);
  }
  vtkDataArray* GetShown() const
  {
    return vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0))
      ->GetPointData()
      ->GetScalars();
  }
  bool Shows(vtkImageData* reference) const
  {
    vtkDataArray* const wanted = reference->GetPointData()->GetScalars();
    vtkDataArray* const is = this->GetShown();
    bool isSame = is->GetDataType() == wanted->GetDataType();
    for (vtkIdType i = 0; i < wanted->GetNumberOfValues(); ++i)
    {
      const double value = wanted->GetVariantValue(i).ToDouble();
      // The picture may round doubles in a different order.
      isSame = isSame && std::abs(is->GetVariantValue(i).ToDouble() - value) <= 1e-12 * 300.0;
    }
    return isSame;
  }

  vtkNew<vtkFixedPointVolumeRayCastMapper> Mapper;
  std::unique_ptr<CarvedPicture> Picture;
};
} // namespace

/// Carved values must be rounded to the nearest value of the type. The last burr's air value is
/// beyond the range of small integers.
TEST_F(CarvedPicturesScene, HasTheValuesOfItsType)
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_DOUBLE })
  {
    for (const double air : { 7.0, -300.0 })
    {
      SCOPED_TRACE(type);
      this->Image = MakeImage(type, 3, 5.0, 120.0);
      this->Burr = Carving();
      CarvedArray array = this->MakeArray();
      array.Component = 1;
      array.Air = air;
      const Undrawn scene(this->Image, array);
      EXPECT_FALSE(scene.Picture->Update());
      this->Burr.At(28.0, 19.0, 30.0, 9.0);
      EXPECT_TRUE(scene.Picture->Update());
      EXPECT_TRUE(scene.Shows(MakeCarved(this->Image, this->Burr.Fractions, 1, air)));
      EXPECT_FALSE(scene.Picture->Update());
      this->Burr.At(18.0, 9.0, 20.0, 9.0);
      EXPECT_TRUE(scene.Picture->Update());
      EXPECT_TRUE(scene.Shows(MakeCarved(this->Image, this->Burr.Fractions, 1, air)));
    }
  }
}

/// After another thread has carved, the picture must represent the last change, whatever was drawn
/// before.
TEST_F(CarvedPicturesScene, FollowsAnotherThread)
{
  const Undrawn scene(this->Image, this->MakeArray());
  std::atomic<bool> isDone{ false };
  std::thread servo(
    [&]
    {
      for (int i = 0; i < 60; ++i)
      {
        this->Burr.At(10.0 + i % 20, 17.0, 10.0 + i % 7, 4.0 + 0.1 * i);
      }
      isDone = true;
    });
  int changes = 0;
  while (!isDone)
  {
    changes += scene.Picture->Update() ? 1 : 0;
  }
  servo.join();
  scene.Picture->Update();
  EXPECT_GT(changes, 1);
  EXPECT_TRUE(scene.Shows(MakeCarved(this->Image, this->Burr.Fractions, 0, 0.0)));
}
