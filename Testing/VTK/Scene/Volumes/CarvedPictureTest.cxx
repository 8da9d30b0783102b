// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that rendering a carved volume equals VTK's rendering of an image from which the tissue was
 * removed.
 */

#include "VTK/Scene/Volumes/CarvedPicture.h"
#include "CarvedScene.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkMultiVolume.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkSmartVolumeMapper.h>

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <cstring>
#include <memory>

using namespace carvedtest;

namespace
{
constexpr int MostDifference = 2; // grey levels of tolerance
constexpr int LeastChange = 20;

struct Kind
{
  int Type;
  int Components;
  double Air;
  double Tissue;
};

template <typename Mapper>
class Rig
{
public:
  explicit Rig(const Kind& kind, int component = 0)
    : Values(kind)
    , Component(component)
    , Image(MakeImage(kind.Type, kind.Components, kind.Air, kind.Tissue))
    , Before(vtkSmartPointer<vtkImageData>::New())
    , Scene(vtkNew<vtkVolume>(), vtkNew<Mapper>(), kind.Components, kind.Air, kind.Tissue)
    , Reference(vtkNew<vtkVolume>(), vtkNew<Mapper>(), kind.Components, kind.Air, kind.Tissue)
  {
    this->Before->DeepCopy(this->Image);
    this->Scene.Mapper->SetInputDataObject(this->Image);
    this->Begin(kind.Air);
  }
  void Begin(double air)
  {
    CarvedArray array;
    array.Array = this->Image->GetPointData()->GetScalars();
    array.Component = this->Component;
    std::copy(Size, Size + 3, array.Dimensions);
    std::copy(this->Burr.First, this->Burr.First + 3, array.First);
    array.Removal = this->Burr.Removal;
    array.Air = air;
    this->Picture = std::make_unique<CarvedPicture>(this->Scene.Mapper, array);
  }
  /// Draws as many frames as the picture requests. Returns the last frame.
  std::vector<int> Follow()
  {
    std::vector<int> drawn;
    int frames = 0;
    do
    {
      this->Picture->Update();
      drawn = this->Scene.Draw();
    } while (this->Picture->Update() && ++frames < 10);
    EXPECT_LT(frames, 10) << "there is always one more frame to draw";
    return drawn;
  }
  std::vector<int> DrawReference()
  {
    this->Reference.Mapper->SetInputDataObject(MakeCarved(
      this->Image, this->Burr.Fractions, this->Component, this->Picture->GetArray().Air));
    return this->Reference.Draw();
  }
  void ExpectUntouched()
  {
    vtkDataArray* const now = this->Image->GetPointData()->GetScalars();
    vtkDataArray* const before = this->Before->GetPointData()->GetScalars();
    const auto bytes = static_cast<std::size_t>(now->GetNumberOfValues() * now->GetDataTypeSize());
    EXPECT_EQ(std::memcmp(now->GetVoidPointer(0), before->GetVoidPointer(0), bytes), 0);
  }
  /// Checks the picture through removals, uploads, changes of opacity and window, and the return of
  /// tissue.
  void CheckAll(bool hasTexture = true)
  {
    const std::vector<int> whole = this->Follow();
    if (this->Burr.Removal->Bricks.IsEmpty())
    {
      EXPECT_EQ(this->Scene.Mapper->GetInputDataObject(0, 0), this->Image);
    }
    EXPECT_LE(Difference(whole, this->DrawReference()), MostDifference);
    const vtkMTimeType time = this->Image->GetMTime();
    // Removes tissue in three steps.
    std::vector<int> last = whole;
    for (int step = 0; step < 3; ++step)
    {
      SCOPED_TRACE(step);
      this->Burr.At(28.0 - 3.0 * step, 19.0, 30.0 - 3.0 * step, 6.0 + step);
      EXPECT_TRUE(this->Picture->Update());
      const std::vector<int> now = this->Scene.Draw();
      if (step > 0)
      {
        EXPECT_LE(Difference(now, this->DrawReference()), MostDifference) << "in the next frame";
      }
      const std::vector<int> later = this->Follow();
      EXPECT_LE(Difference(later, this->DrawReference()), MostDifference);
      EXPECT_GT(Difference(later, last), LeastChange);
      last = later;
    }
    EXPECT_FALSE(this->Picture->Update());
    EXPECT_EQ(this->Image->GetMTime(), time);
    this->ExpectUntouched();
    // VTK must upload a modified image again.
    this->Image->Modified();
    this->Picture->Update();
    EXPECT_LE(Difference(this->Scene.Draw(), this->DrawReference()), MostDifference);
    // A volume without shading uses another shader.
    this->Scene.Volume->GetProperty()->ShadeOff();
    this->Reference.Volume->GetProperty()->ShadeOff();
    this->Burr.At(16.0, 12.0, 26.0, 5.0);
    EXPECT_TRUE(this->Picture->Update());
    EXPECT_LE(Difference(this->Scene.Draw(), this->DrawReference()), MostDifference);
    this->Scene.Volume->GetProperty()->ShadeOn();
    this->Reference.Volume->GetProperty()->ShadeOn();
    // The volume moves to another window, which later loses its OpenGL objects.
    this->Scene.Open();
    EXPECT_LE(Difference(this->Follow(), this->DrawReference()), MostDifference);
    this->Scene.Window->Finalize();
    EXPECT_LE(Difference(this->Follow(), this->DrawReference()), MostDifference);
    // Restore the removed tissue.
    this->Burr.Reset();
    EXPECT_TRUE(this->Picture->Update());
    EXPECT_LE(Difference(this->Scene.Draw(), whole), MostDifference);
    this->Burr.At(20.0, 17.0, 28.0, 9.0);
    EXPECT_LE(Difference(this->Follow(), this->DrawReference()), MostDifference);
    EXPECT_GT(Difference(this->Scene.Draw(), whole), LeastChange);
    EXPECT_EQ(this->Picture->HasTexture(), hasTexture);
    // Deleting the picture must restore the volume.
    this->Picture = nullptr;
    EXPECT_LE(Difference(this->Scene.Draw(), whole), MostDifference);
    EXPECT_EQ(this->Scene.Mapper->GetInputDataObject(0, 0), this->Image);
    this->ExpectUntouched();
  }

  void CheckBriefly()
  {
    const std::vector<int> whole = this->Scene.Draw();
    this->Burr.At(28.0, 19.0, 30.0, 6.0);
    this->Follow();
    this->Burr.At(25.0, 19.0, 27.0, 7.0);
    EXPECT_TRUE(this->Picture->Update());
    const std::vector<int> drawn = this->Scene.Draw();
    EXPECT_LE(Difference(drawn, this->DrawReference()), MostDifference);
    EXPECT_GT(Difference(drawn, whole), LeastChange);
    EXPECT_TRUE(this->Picture->HasTexture());
    this->Picture = nullptr;
    EXPECT_LE(Difference(this->Scene.Draw(), whole), MostDifference);
    this->ExpectUntouched();
  }

  Kind Values;
  int Component;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> Before;
  Carving Burr;
  Shown Scene;
  Shown Reference;
  std::unique_ptr<CarvedPicture> Picture;
};

const Kind Byte{ VTK_UNSIGNED_CHAR, 1, 3.0, 250.0 };
const Kind Short{ VTK_SHORT, 1, -1000.0, 1800.0 };
const Kind Float{ VTK_FLOAT, 1, -0.25, 2.5 };

using OfTexture = Rig<vtkOpenGLGPUVolumeRayCastMapper>;
using OfCopy = Rig<vtkFixedPointVolumeRayCastMapper>;
} // namespace

TEST(CarvedPicture, OfEachTypeIsThatOfACarvedImage)
{
  for (const Kind& kind : { Byte, Short, Float })
  {
    SCOPED_TRACE(kind.Type);
    OfTexture rig(kind);
    rig.CheckAll();
  }
  for (const Kind& kind :
    { Kind{ VTK_SIGNED_CHAR, 1, -100.0, 120.0 }, Kind{ VTK_UNSIGNED_SHORT, 1, 0.0, 40000.0 },
      Kind{ VTK_INT, 1, -70000.0, 90000.0 }, Kind{ VTK_DOUBLE, 1, -1.0, 1.0 } })
  {
    SCOPED_TRACE(kind.Type);
    OfTexture rig(kind);
    rig.CheckBriefly();
  }
}

TEST(CarvedPicture, OfOneOfTwoComponentsLeavesTheOther)
{
  for (const Kind& kind :
    { Kind{ VTK_SHORT, 2, -1000.0, 1800.0 }, Kind{ VTK_DOUBLE, 2, -1.0, 1.0 } })
  {
    for (const int component : { 0, 1 })
    {
      SCOPED_TRACE(component);
      OfTexture rig(kind, component);
      rig.CheckBriefly();
    }
  }
}

TEST(CarvedPicture, OfAnotherMapperIsACopy)
{
  for (const Kind& kind : { Byte, Short, Float })
  {
    SCOPED_TRACE(kind.Type);
    OfCopy rig(kind);
    rig.CheckAll(false);
  }
}

TEST(CarvedPicture, OfASmartMapperIsThatOfItsTexture)
{
  Rig<vtkSmartVolumeMapper> rig(Short);
  for (vtkVolumeMapper* mapper : { rig.Scene.Mapper.Get(), rig.Reference.Mapper.Get() })
  {
    vtkSmartVolumeMapper::SafeDownCast(mapper)->SetRequestedRenderModeToGPU();
  }
  rig.CheckBriefly();
}

TEST(CarvedPicture, OfASmartMapperWithoutTextureIsACopy)
{
  Rig<vtkSmartVolumeMapper> rig(Short);
  for (vtkVolumeMapper* mapper : { rig.Scene.Mapper.Get(), rig.Reference.Mapper.Get() })
  {
    vtkSmartVolumeMapper::SafeDownCast(mapper)->SetRequestedRenderModeToRayCast();
  }
  rig.CheckAll(false);
}

TEST(CarvedPicture, OfATextureInBlocksIsACopy)
{
  OfTexture rig(Short);
  for (vtkVolumeMapper* mapper : { rig.Scene.Mapper.Get(), rig.Reference.Mapper.Get() })
  {
    vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper)->SetPartitions(2, 1, 1);
  }
  rig.Scene.Draw();
  rig.Burr.At(28.0, 19.0, 30.0, 7.0);
  EXPECT_LE(Difference(rig.Follow(), rig.DrawReference()), MostDifference);
  EXPECT_FALSE(rig.Picture->HasTexture());
  EXPECT_TRUE(
    rig.Picture->IsCopy(vtkImageData::SafeDownCast(rig.Scene.Mapper->GetInputDataObject(0, 0))));
}

/// A texture can't represent values beyond the image's range. No sample of this image is as low as
/// the air of -1000, so the picture must be a copy.
TEST(CarvedPicture, WithAirBeyondTheRangeIsACopy)
{
  OfTexture rig({ VTK_SHORT, 1, 300.0, 1800.0 });
  const std::vector<int> whole = rig.Scene.Draw();
  rig.Picture = nullptr;
  rig.Begin(-1000.0);
  rig.Burr.At(28.0, 19.0, 30.0, 7.0);
  const std::vector<int> drawn = rig.Follow();
  EXPECT_LE(Difference(drawn, rig.DrawReference()), MostDifference);
  EXPECT_GT(Difference(drawn, whole), LeastChange);
  EXPECT_FALSE(rig.Picture->HasTexture());
}

TEST(CarvedPicture, OfARegionTakesTheFractionsOfTheRegion)
{
  OfTexture rig(Byte);
  rig.Picture = nullptr;
  const std::int64_t first[3] = { 101, 50, 3 };
  std::copy(first, first + 3, rig.Burr.First);
  rig.Begin(rig.Values.Air);
  // Bricks outside the region must have no effect.
  SetFraction(rig.Burr.Removal->Bricks, 20, 20, 20, 0);
  SetFraction(rig.Burr.Removal->Bricks, 99, 55, 10, 0);
  SetFraction(rig.Burr.Removal->Bricks, 150, 55, 10, 0);
  rig.CheckAll();
}

TEST(CarvedPicture, IsCroppedAndClipped)
{
  OfTexture rig(Short);
  for (vtkVolumeMapper* mapper : { rig.Scene.Mapper.Get(), rig.Reference.Mapper.Get() })
  {
    mapper->CroppingOn();
    mapper->SetCroppingRegionPlanes(0.0, 100.0, -50.0, 50.0, 0.0, 30.0);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(22.0, 0.0, 0.0);
    plane->SetNormal(1.0, 0.2, 0.0);
    mapper->AddClippingPlane(plane);
  }
  rig.CheckAll();
}

TEST(CarvedPicture, OfOneOfSeveralVolumesOfAMapper)
{
  OfTexture rig(Short);
  const vtkSmartPointer<vtkImageData> other = MakeImage(VTK_SHORT, 1, -1000.0, 1800.0);
  other->SetOrigin(-14.0, 3.0, 0.0);
  for (Shown* shown : { &rig.Scene, &rig.Reference })
  {
    vtkNew<vtkMultiVolume> volume;
    vtkNew<vtkVolume> first;
    vtkNew<vtkVolume> second;
    SetLook(first->GetProperty(), 1, -1000.0, 1800.0);
    SetLook(second->GetProperty(), 1, -1000.0, 1800.0);
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    mapper->SetInputDataObject(0, other);
    mapper->SetInputDataObject(1, rig.Image);
    volume->SetMapper(mapper);
    volume->SetVolume(first, 0);
    volume->SetVolume(second, 1);
    shown->Renderer->RemoveVolume(shown->Volume);
    shown->Renderer->AddVolume(volume);
    shown->Volume = volume;
    shown->Mapper = mapper;
  }
  rig.Begin(rig.Values.Air);
  const auto drawReference = [&rig]
  {
    rig.Reference.Mapper->SetInputDataObject(
      1, MakeCarved(rig.Image, rig.Burr.Fractions, 0, rig.Values.Air));
    return rig.Reference.Draw();
  };
  const std::vector<int> whole = rig.Scene.Draw();
  for (int step = 0; step < 3; ++step)
  {
    SCOPED_TRACE(step);
    rig.Burr.At(28.0 - 3.0 * step, 19.0, 30.0, 6.0);
    const std::vector<int> drawn = rig.Follow();
    EXPECT_LE(Difference(drawn, drawReference()), MostDifference);
    EXPECT_GT(Difference(drawn, whole), LeastChange);
  }
  EXPECT_TRUE(rig.Picture->HasTexture());
  // After the release of their OpenGL objects, VTK uploads all inputs in each rendering.
  rig.Scene.Open();
  EXPECT_LE(Difference(rig.Follow(), drawReference()), MostDifference);
  rig.Picture = nullptr;
  EXPECT_LE(Difference(rig.Scene.Draw(), whole), MostDifference);
  EXPECT_EQ(rig.Scene.Mapper->GetInputDataObject(1, 0), rig.Image);
}

TEST(CarvedPicture, LeavesTheStateOfOpenGL)
{
  OfTexture rig(Byte);
  // The last bricks contain tissue, although the image has only one sample of each row there.
  vtkDataArray* const array = rig.Image->GetPointData()->GetScalars();
  for (vtkIdType i = Size[0] - 1; i < array->GetNumberOfTuples(); i += Size[0])
  {
    array->SetComponent(i, 0, 240.0);
  }
  rig.Burr.At(28.0, 19.0, 30.0, 6.0);
  rig.Follow();
  vtkOpenGLState* const state = vtkOpenGLRenderWindow::SafeDownCast(rig.Scene.Window)->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  const auto read = [state]
  {
    std::vector<int> values;
    for (const unsigned int name :
      { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES, GL_PIXEL_UNPACK_BUFFER_BINDING,
        GL_TEXTURE_BINDING_3D, GL_ACTIVE_TEXTURE, GL_CURRENT_PROGRAM })
    {
      int value = 0;
      state->vtkglGetIntegerv(name, &value);
      values.push_back(value);
    }
    return values;
  };
  const std::vector<int> last = rig.Scene.Draw();
  const std::vector<int> before = read();
  EXPECT_EQ(before[0], 8);
  rig.Burr.At(40.0, 17.0, 19.0, 8.0);
  EXPECT_TRUE(rig.Picture->Update());
  const std::vector<int> drawn = rig.Scene.Draw();
  EXPECT_EQ(read(), before);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_LE(Difference(drawn, rig.DrawReference()), MostDifference);
  EXPECT_GT(Difference(drawn, last), LeastChange);
  rig.Scene.Window->MakeCurrent();
  rig.Picture = nullptr;
  EXPECT_EQ(read(), before);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// A picture that outlives its volume, or exists beside another picture, must leave no changes
/// behind.
TEST(CarvedPicture, EndsBeforeOrAfterWhatItShows)
{
  {
    OfTexture rig(Byte);
    rig.Burr.At(28.0, 19.0, 30.0, 6.0);
    rig.Follow();
    rig.Scene.Window->Finalize();
    rig.Picture = nullptr;
  }
  auto rig = std::make_unique<OfTexture>(Byte);
  rig->Burr.At(28.0, 19.0, 30.0, 6.0);
  rig->Follow();
  std::unique_ptr<CarvedPicture> picture = std::move(rig->Picture);
  rig = nullptr;
  EXPECT_EQ(picture->GetMapper(), nullptr);
  EXPECT_FALSE(picture->Update());
}

TEST(CarvedPicture, FollowsWithManyOthers)
{
  OfTexture rig(Byte);
  rig.Picture = nullptr;
  for (int i = 0; i < CarvedBricks::MostFollowers; ++i)
  {
    rig.Burr.Removal->Bricks.AddFollower();
  }
  rig.Begin(rig.Values.Air);
  rig.Scene.Draw();
  rig.Burr.At(28.0, 19.0, 30.0, 6.0);
  EXPECT_TRUE(rig.Picture->Update());
  EXPECT_LE(Difference(rig.Scene.Draw(), rig.DrawReference()), MostDifference);
}
