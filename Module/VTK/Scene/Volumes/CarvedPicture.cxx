// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedPicture.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Scene/Base/SmartMapperParts.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeTexture.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace VolumeHaptics
{
namespace
{

vtkImageData* GetImage(vtkVolumeMapper* mapper, int port)
{
  return mapper->GetNumberOfInputConnections(port) > 0
    ? vtkImageData::SafeDownCast(mapper->GetInputDataObject(port, 0))
    : nullptr;
}

/** Returns the array that a mapper draws of the image at a port. */
vtkDataArray* GetShown(vtkVolumeMapper* mapper, int port)
{
  vtkImageData* const image = GetImage(mapper, port);
  int isCells = 0;
  return image
    ? vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), isCells)
    : nullptr;
}

bool IsShownInstead(vtkDataArray* shown, vtkDataArray* touched)
{
  return shown->HasInformation() &&
    shown->GetInformation()->Get(vtkHapticRemoval::TOUCHED_ARRAY()) == touched &&
    shown->GetNumberOfTuples() == touched->GetNumberOfTuples() &&
    shown->GetNumberOfComponents() == touched->GetNumberOfComponents();
}

/**
 * Largest number of consecutive renderings that may show all tissue. After more, VTK is assumed to
 * upload the array in each rendering.
 */
constexpr int MostMissed = 3;

/** Returns whether VTK fills textures from arrays of this type, directly or through floats. */
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

/**
 * Sets how OpenGL reads the samples of a brick from memory, and restores the previous settings at
 * the end of the scope.
 */
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
      // Reset VTK's cache of these settings, which others may have changed without VTK.
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

/** Returns whether a mapper currently draws without a texture of its image. */
bool DrawsOtherwise(vtkVolumeMapper* mapper)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  if (!smart)
  {
    return false;
  }
  const int mode = smart->GetLastUsedRenderMode();
  return mode == vtkSmartVolumeMapper::GPURenderMode
    ? SmartMapperParts::DrawsFewerVoxels(smart)
    : mode != vtkSmartVolumeMapper::UndefinedRenderMode;
}

CarvedArray WithArray(const CarvedArray& touched, vtkDataArray* shown)
{
  CarvedArray carved = touched;
  carved.Array = shown ? shown : touched.Array.Get();
  return carved;
}

vtkOpenGLGPUVolumeRayCastMapper* GetTextureMapper(vtkVolumeMapper* mapper)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  return vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(
    smart ? static_cast<vtkVolumeMapper*>(SmartMapperParts::GetGPUMapper(smart)) : mapper);
}

} // namespace

int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    if (GetShown(mapper, port) == array)
    {
      return port;
    }
  }
  return -1;
}

vtkDataArray* GetShownArray(vtkVolumeMapper* mapper, vtkDataArray* touched)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    vtkDataArray* const shown = GetShown(mapper, port);
    if (shown && (shown == touched || IsShownInstead(shown, touched)))
    {
      return shown;
    }
  }
  return nullptr;
}

bool CarvedCopy::Replace()
{
  vtkVolumeMapper* const mapper = this->Mapper;
  const int port = FindShownPort(mapper, this->Carved.Array);
  if (port < 0)
  {
    return false;
  }
  this->Image = GetImage(mapper, port);
  this->Copy.TakeReference(this->Image->NewInstance());
  this->CopyImage();
  this->Input.Put(mapper, port, this->Copy);
  return true;
}

void CarvedCopy::CopyImage()
{
  this->ImageTime = this->Image->GetMTime();
  this->Left = CopyArray(this->Carved.Array);
  if (this->Left->HasInformation())
  {
    // Remove the mark of a touched array from the copy.
    this->Left->GetInformation()->Remove(vtkHapticRemoval::TOUCHED_ARRAY());
  }
  this->Copy->ShallowCopy(this->Image);
  // Keep the arrays' indices, because a mapper may select an array by index.
  vtkPointData* const from = this->Image->GetPointData();
  vtkPointData* const to = this->Copy->GetPointData();
  to->Initialize();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    to->AddArray(array == this->Carved.Array ? this->Left.Get() : array);
  }
  int attributes[vtkDataSetAttributes::NUM_ATTRIBUTES];
  from->GetAttributeIndices(attributes);
  for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
  {
    if (attributes[kind] >= 0)
    {
      to->SetActiveAttribute(attributes[kind], kind);
    }
  }
  this->Bricks.DrainAll([this](std::uint32_t brick) { this->WriteBrick(brick); });
}

bool CarvedCopy::Update()
{
  if (!this->Input.IsShown())
  {
    return this->Replace();
  }
  if (this->Input.UpdateReplaced() != this->Image)
  {
    this->Input.GiveBack();
    return this->Replace();
  }
  if (this->Image->GetMTime() != this->ImageTime)
  {
    this->CopyImage();
    return true;
  }
  bool isNew = false;
  this->Bricks.Drain(
    [this, &isNew](std::uint32_t brick)
    {
      this->WriteBrick(brick);
      isNew = true;
    });
  if (isNew)
  {
    this->Left->Modified();
    this->Copy->Modified();
  }
  return isNew;
}

void CarvedCopy::WriteBrick(std::uint32_t brick)
{
  ArrayBox box;
  if (!ComputeBrickBox(this->Carved, brick, box))
  {
    return;
  }
  CopyBrick(this->Carved, brick, BrickContent::Left, box, this->Buffer);
  const auto tuple = static_cast<std::int64_t>(
    this->Buffer.size() / static_cast<std::size_t>(box.Samples())); // bytes per tuple
  auto* const values = static_cast<unsigned char*>(this->Left->GetVoidPointer(0));
  const unsigned char* from = this->Buffer.data();
  for (std::int64_t k = box.Low[2]; k < box.Low[2] + box.Size[2]; ++k)
  {
    for (std::int64_t j = box.Low[1]; j < box.Low[1] + box.Size[1]; ++j)
    {
      const std::int64_t at =
        box.Low[0] + this->Carved.Dimensions[0] * (j + this->Carved.Dimensions[1] * k);
      const std::int64_t row = tuple * box.Size[0];
      std::memcpy(values + tuple * at, from, static_cast<std::size_t>(row));
      from += row;
    }
  }
}

CarvedTexture::CarvedTexture(
  vtkOpenGLGPUVolumeRayCastMapper* mapper, const CarvedArray& carved, FollowedBricks& bricks)
  : Mapper(mapper)
  , Carved(carved)
  , Bricks(bricks)
{
  this->Forget();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<CarvedTexture*>(self)->HandleRendering(event); });
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

bool CarvedTexture::DetectUpload()
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
  // The block's pointer is valid only after an upload, because VTK does not reset it when the
  // texture is released.
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

void CarvedTexture::HandleRendering(unsigned long event)
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
      this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.Drain(f); });
    }
  }
  else if (event == vtkCommand::UpdateShaderEvent)
  {
    if (this->DetectUpload())
    {
      this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.DrainAll(f); });
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
    return; // the mapper has drawn nothing
  }
  vtkVolumeTexture* const volume = this->FindVolume();
  bool isLate = false;
  if (!volume || volume->UploadTime > this->Begin)
  {
    isLate = this->DetectUpload();
  }
  if (isLate)
  {
    this->Send(BrickContent::Left, [this](auto&& f) { this->Bricks.DrainAll(f); });
  }
  // Without a texture, this rendering built the shader, and so lacked the event that the next one
  // sends.
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
  if (!ComputeBrickBox(this->Carved, brick, box))
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
    return; // nothing to restore, because VTK uploads the array before the next drawing
  }
  window->PushContext();
  if (this->IsAtHand())
  {
    this->Send(BrickContent::Whole, [this](auto&& f) { this->Bricks.DrainAll(f); });
  }
  window->PopContext();
}

CarvedPicture::CarvedPicture(vtkVolumeMapper* mapper, CarvedArray touched, vtkDataArray* shown)
  : Mapper(mapper)
  , Touched(std::move(touched))
  , Carved(WithArray(this->Touched, shown))
  , Bricks(Carved.Removal)
{
  if (vtkOpenGLGPUVolumeRayCastMapper* const drawing = GetTextureMapper(mapper))
  {
    this->Texture = std::make_unique<CarvedTexture>(drawing, this->Carved, this->Bricks);
  }
}

CarvedPicture::~CarvedPicture()
{
  if (this->Texture)
  {
    this->Texture->Restore();
  }
}

bool CarvedPicture::Update()
{
  const bool isNew = this->Bricks.Poll();
  vtkVolumeMapper* const mapper = this->Mapper;
  if (!mapper || this->Carved.Removal->Bricks.IsEmpty())
  {
    return false;
  }
  if (this->Copy)
  {
    return this->Copy->Update();
  }
  if (FindShownPort(mapper, this->Carved.Array) < 0)
  {
    if (this->Texture)
    {
      this->Texture->Forget();
    }
    return false;
  }
  if (this->Texture && !this->Texture->IsImpossible() && !DrawsOtherwise(mapper))
  {
    const bool isDue = this->Texture->DrainFrameDue();
    return isNew || isDue;
  }
  if (this->Texture)
  {
    this->Texture->Restore();
    this->Texture = nullptr;
  }
  this->Copy = std::make_unique<CarvedCopy>(mapper, this->Carved, this->Bricks);
  return this->Copy->Update();
}

void CarvedPictures::Collect(
  vtkRenderer* renderer, const CarvedArray& array, std::vector<std::unique_ptr<CarvedPicture>>& now)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* const volume = vtkVolume::SafeDownCast(prop);
    auto* const mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
    // The array is null if the mapper shows the copy of another picture, or another array.
    vtkDataArray* const shown = GetShownArray(mapper, array.Array);
    const auto isKnown = [mapper, shown, &array](const std::unique_ptr<CarvedPicture>& one)
    {
      return one && one->GetMapper() == mapper && one->GetArray().IsSame(array) &&
        (!shown || shown == one->GetShown());
    };
    if (!mapper || std::any_of(now.begin(), now.end(), isKnown))
    {
      continue;
    }
    const auto known = std::find_if(this->All.begin(), this->All.end(), isKnown);
    if (known != this->All.end())
    {
      now.push_back(std::move(*known));
    }
    else if (shown)
    {
      now.push_back(std::make_unique<CarvedPicture>(mapper, array, shown));
    }
  }
}

bool CarvedPictures::Update(vtkRenderer* renderer, const std::vector<CarvedArray>& arrays)
{
  std::vector<std::unique_ptr<CarvedPicture>> now;
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  vtkRendererCollection* const renderers = window ? window->GetRenderers() : nullptr;
  for (const CarvedArray& array : arrays)
  {
    if (!renderers)
    {
      this->Collect(renderer, array, now);
      continue;
    }
    vtkCollectionSimpleIterator it;
    renderers->InitTraversal(it);
    while (vtkRenderer* one = renderers->GetNextRenderer(it))
    {
      this->Collect(one, array, now);
    }
  }
  // Removing a picture changes what is shown, too.
  bool isNew = std::any_of(this->All.begin(), this->All.end(),
    [](const std::unique_ptr<CarvedPicture>& one) { return one != nullptr; });
  this->All = std::move(now);
  for (const std::unique_ptr<CarvedPicture>& one : this->All)
  {
    isNew = one->Update() || isNew;
  }
  return isNew;
}

vtkAlgorithmOutput* CarvedPictures::GetGivenInput(vtkVolumeMapper* mapper) const
{
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  vtkDataObject* const shown = mapper->GetInputDataObject(0, 0);
  const auto picture = std::find_if(this->All.begin(), this->All.end(),
    [mapper, shown](const std::unique_ptr<CarvedPicture>& one)
    { return one->GetMapper() == mapper && one->IsCopy(shown); });
  return picture == this->All.end() ? mapper->GetInputConnection(0, 0) : (*picture)->GetReplaced();
}

vtkImageData* CarvedPictures::GetImage(vtkVolumeMapper* mapper) const
{
  vtkAlgorithmOutput* const input = this->GetGivenInput(mapper);
  return input
    ? vtkImageData::SafeDownCast(input->GetProducer()->GetOutputDataObject(input->GetIndex()))
    : nullptr;
}

//------------------------------------------------------------------------------
void ReplacedInput::Put(vtkVolumeMapper* mapper, int port, vtkImageData* image)
{
  if (mapper != this->Mapper || port != this->Port || !this->IsShown())
  {
    this->GiveBack();
    this->Mapper = mapper;
    this->Port = port;
    this->Before = mapper->GetInputAlgorithm(port, 0);
    this->BeforePort = mapper->GetInputConnection(port, 0)->GetIndex();
  }
  if (image != this->Image || !this->IsShown())
  {
    this->Image = image;
    mapper->SetInputDataObject(port, image);
  }
}

void ReplacedInput::GiveBack()
{
  if (this->IsShown())
  {
    this->Mapper->SetInputConnection(this->Port, this->GetReplaced());
  }
  this->Image = nullptr;
  this->Before = nullptr;
}

bool ReplacedInput::IsShown() const
{
  return this->Mapper && this->Image && this->Mapper->GetNumberOfInputConnections(this->Port) > 0 &&
    this->Mapper->GetInputDataObject(this->Port, 0) == this->Image;
}

vtkImageData* ReplacedInput::UpdateReplaced() const
{
  if (!this->Before)
  {
    return nullptr;
  }
  this->Before->Update(this->BeforePort);
  return vtkImageData::SafeDownCast(this->Before->GetOutputDataObject(this->BeforePort));
}

} // namespace VolumeHaptics
