// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedTexture.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkCallbackCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeTexture.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

/**
 * The most renderings in a row that may show all tissue; beyond, VTK uploads the array in each of
 * them.
 */
constexpr int MostMissed = 3;

/** Types whose textures VTK fills from the array itself, or from floats made of it. */
bool HasTextureType(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_CHAR:
    case VTK_BIT:
    case VTK_ID_TYPE:
      return false;
    default:
      return array->GetNumberOfComponents() <= 4;
  }
}

/** Sets how OpenGL reads the samples of a brick from memory, until the scope ends. */
class PackedSamples
{
public:
  explicit PackedSamples(vtkOpenGLState* state)
    : State(state)
    , Unit(state)
  {
    for (std::size_t i = 0; i < std::size(Names); ++i)
    {
      state->vtkglGetIntegerv(Names[i], &this->Before[i]);
      // VTK caches these, and may not have noticed what others have set.
      state->vtkglPixelStorei(Names[i], this->Before[i]);
      state->vtkglPixelStorei(Names[i], Names[i] == GL_UNPACK_ALIGNMENT ? 1 : 0);
    }
    state->vtkglGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->Buffer);
    if (this->Buffer != 0)
    {
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    }
  }
  ~PackedSamples()
  {
    for (std::size_t i = 0; i < std::size(Names); ++i)
    {
      this->State->vtkglPixelStorei(Names[i], this->Before[i]);
    }
    if (this->Buffer != 0)
    {
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(this->Buffer));
    }
  }
  PackedSamples(const PackedSamples&) = delete;
  PackedSamples& operator=(const PackedSamples&) = delete;

private:
  static constexpr unsigned int Names[] = { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES };

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglActiveTexture Unit;
  int Before[std::size(Names)] = {};
  int Buffer = 0;
};

} // namespace

CarvedTexture::CarvedTexture(
  vtkOpenGLGPUVolumeRayCastMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks)
  : Mapper(mapper)
  , Carved(carved)
  , Bricks(bricks)
{
  this->Forget();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<CarvedTexture*>(self)->FollowRendering(event); });
  for (const unsigned long event : { vtkCommand::VolumeMapperRenderStartEvent,
         vtkCommand::UpdateShaderEvent, vtkCommand::VolumeMapperRenderEndEvent })
  {
    mapper->AddObserver(event, this->Observer);
  }
}

CarvedTexture::~CarvedTexture()
{
  if (vtkOpenGLGPUVolumeRayCastMapper* const mapper = this->Mapper)
  {
    mapper->RemoveObserver(this->Observer);
  }
}

void CarvedTexture::Forget()
{
  this->Texture = nullptr;
  this->Missed = 0;
  this->IsFrameDue = false;
  this->HasFailed = !HasTextureType(this->Carved.Array);
}

vtkVolumeTexture* CarvedTexture::FindVolume() const
{
  if (vtkOpenGLGPUVolumeRayCastMapper* const mapper = this->Mapper)
  {
    for (auto& input : mapper->AssembledInputs)
    {
      vtkVolumeTexture* const volume = input.second.Texture;
      if (volume && volume->GetLoadedScalars() == this->Carved.Array)
      {
        return volume;
      }
    }
  }
  return nullptr;
}

bool CarvedTexture::FindUpload()
{
  vtkVolumeTexture* const volume = this->FindVolume();
  if (!volume)
  {
    this->HasFailed = true;
    return false;
  }
  const auto& partitions = volume->GetPartitions();
  const float* const range = volume->ScalarRange[this->Carved.Component];
  const auto air = static_cast<float>(this->Carved.Air);
  if (partitions[0] * partitions[1] * partitions[2] > 1 || !(air >= range[0] && air <= range[1]))
  {
    this->HasFailed = true;
    return false;
  }
  // The block's pointer is valid only after an upload: VTK does not reset it when it releases the
  // texture.
  if (this->Texture && this->UploadTime == volume->UploadTime.GetMTime())
  {
    return false;
  }
  this->Texture = volume->GetCurrentBlock()->TextureObject;
  this->UploadTime = volume->UploadTime.GetMTime();
  return true;
}

bool CarvedTexture::IsAtHand() const
{
  vtkTextureObject* const texture = this->Texture;
  vtkOpenGLRenderWindow* const window = texture ? texture->GetContext() : nullptr;
  return window && texture->GetHandle() != 0 && window->IsCurrent();
}

void CarvedTexture::FollowRendering(unsigned long event)
{
  if (this->HasFailed)
  {
    return;
  }
  if (event == vtkCommand::VolumeMapperRenderStartEvent)
  {
    this->Begin.Modified();
    if (this->IsAtHand())
    {
      this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.Take(f); });
    }
  }
  else if (event == vtkCommand::UpdateShaderEvent)
  {
    if (this->FindUpload())
    {
      this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.TakeAll(f); });
    }
  }
  else
  {
    this->EndRendering();
  }
}

void CarvedTexture::EndRendering()
{
  vtkOpenGLGPUVolumeRayCastMapper* const mapper = this->Mapper;
  if (!mapper || mapper->AssembledInputs.empty())
  {
    return; // nothing was drawn
  }
  vtkVolumeTexture* const volume = this->FindVolume();
  bool isLate = false;
  if (!volume || volume->UploadTime > this->Begin)
  {
    isLate = this->FindUpload();
  }
  if (isLate)
  {
    this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.TakeAll(f); });
  }
  // Without a texture, this rendering built the shader, and the next rendering will send the event.
  const bool wasMissed = isLate || !this->Texture;
  this->Missed = wasMissed ? this->Missed + 1 : 0;
  this->HasFailed = this->HasFailed || this->Missed > MostMissed;
  this->IsFrameDue = this->IsFrameDue || wasMissed || this->HasFailed;
}

template <typename Take>
void CarvedTexture::Send(BrickContent content, Take&& take)
{
  vtkVolumeTexture* const volume = this->FindVolume();
  if (!volume)
  {
    return;
  }
  const PackedSamples samples(this->Texture->GetContext()->GetState());
  this->Texture->Activate();
  take([&](std::uint32_t brick) { this->SendBrick(volume, content, brick); });
  this->Texture->Deactivate();
}

void CarvedTexture::SendBrick(vtkVolumeTexture* volume, BrickContent content, std::uint32_t brick)
{
  ArrayBox box;
  if (!FindBrickBox(this->Carved, brick, box))
  {
    return;
  }
  int type = this->Carved.Array->GetDataType();
  if (volume->HandleLargeDataTypes)
  {
    type = VTK_FLOAT;
    CopyBrickAsFloat(this->Carved, brick, content, box, volume->Scale, volume->Bias, this->Buffer);
  }
  else
  {
    CopyBrick(this->Carved, brick, content, box, this->Buffer);
  }
  const int components = this->Carved.Array->GetNumberOfComponents();
  glTexSubImage3D(GL_TEXTURE_3D, 0, static_cast<GLint>(box.Low[0]), static_cast<GLint>(box.Low[1]),
    static_cast<GLint>(box.Low[2]), static_cast<GLsizei>(box.Size[0]),
    static_cast<GLsizei>(box.Size[1]), static_cast<GLsizei>(box.Size[2]),
    this->Texture->GetFormat(type, components, false),
    static_cast<GLenum>(this->Texture->GetDataType(type)), this->Buffer.data());
}

void CarvedTexture::Restore()
{
  vtkTextureObject* const texture = this->Texture;
  vtkOpenGLRenderWindow* const window = texture ? texture->GetContext() : nullptr;
  if (!window || texture->GetHandle() == 0)
  {
    return; // VTK uploads the array before drawing it again
  }
  window->PushContext();
  if (this->IsAtHand())
  {
    this->Send(BrickContent::Whole, [this](auto&& f) { this->Bricks.TakeAll(f); });
  }
  window->PopContext();
}

} // namespace VolumeHaptics
