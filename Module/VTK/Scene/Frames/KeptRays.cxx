// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Frames/KeptRays.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFiniteDifferenceGradientEstimator.h"
#include "vtkFixedPointRayCastImage.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphericalDirectionEncoder.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <utility>

namespace VolumeHaptics
{
namespace
{

// Number of rays: casting the rays of a shorter gap costs less than another pass.
constexpr int ShortestGap = 16;
constexpr std::size_t MostPasses = 4;
// Number of rays: copying an image of this size takes no noticeable time.
constexpr int MostCoarseRays = 1 << 16;

/** Collects values as 64-bit words, for bitwise comparison. */
struct WordWriter
{
  std::vector<std::uint64_t> Words;

  void Add(std::uint64_t word) { this->Words.push_back(word); }
  void AddAddress(const void* address)
  {
    this->Add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(address)));
  }
  void Add(const double* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      std::uint64_t word;
      std::memcpy(&word, values + i, sizeof word);
      this->Add(word);
    }
  }
  void Add(const int* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Add(static_cast<std::uint64_t>(values[i]));
    }
  }
};

void AddCamera(WordWriter& to, vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  to.Add(&camera->GetViewTransformMatrix()->Element[0][0], 16);
  to.Add(
    &camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), 0.0, 1.0)->Element[0][0],
    16);
  to.Add(camera->GetPosition(), 3); // the headlight and the shading depend on the position
  to.Add(camera->GetFocalPoint(), 3);
  to.Add(renderer->GetViewport(), 4);
  to.Add(renderer->GetRenderWindow()->GetSize(), 2);
  int tile[4];
  renderer->GetTiledSizeAndOrigin(tile, tile + 1, tile + 2, tile + 3);
  to.Add(tile, 4);
}

void AddLights(WordWriter& to, vtkRenderer* renderer)
{
  to.Add(static_cast<std::uint64_t>(renderer->GetTwoSidedLighting()));
  vtkLightCollection* const lights = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  lights->InitTraversal(at);
  while (vtkLight* const light = lights->GetNextLight(at))
  {
    double place[6];
    light->GetTransformedPosition(place);
    light->GetTransformedFocalPoint(place + 3);
    const double intensity = light->GetSwitch() ? light->GetIntensity() : 0.0;
    to.Add(&intensity, 1);
    to.Add(place, 6);
    to.Add(light->GetAmbientColor(), 3);
    to.Add(light->GetDiffuseColor(), 3);
    to.Add(light->GetSpecularColor(), 3);
  }
}

void AddCuts(WordWriter& to, vtkVolumeMapper* mapper)
{
  to.Add(static_cast<std::uint64_t>(mapper->GetBlendMode()));
  to.Add(static_cast<std::uint64_t>(mapper->GetCropping()));
  to.Add(static_cast<std::uint64_t>(mapper->GetCroppingRegionFlags()));
  to.Add(mapper->GetCroppingRegionPlanes(), 6);
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    double plane[6];
    planes->GetItem(i)->GetOrigin(plane);
    planes->GetItem(i)->GetNormal(plane + 3);
    to.Add(plane, 6);
  }
}

/**
 * Replaces the mapper's encoder of directions. Before each frame, vtkFixedPointVolumeRayCastMapper
 * asks the encoder for 65536 directions and computes a shade for each. If the shades would be
 * unchanged, this encoder returns no directions, so that none are computed.
 */
class ShadedDirections : public vtkSphericalDirectionEncoder
{
public:
  static ShadedDirections* New() { VTK_STANDARD_NEW_BODY(ShadedDirections); }
  vtkTypeMacro(ShadedDirections, vtkSphericalDirectionEncoder);
  int GetNumberOfEncodedDirections() override
  {
    return this->KeepsShades ? 0 : this->Superclass::GetNumberOfEncodedDirections();
  }
  /** Called by the mapper once before it computes the shades of each light. */
  float* GetDecodedGradientTable() override
  {
    this->KeepsShades = this->AreKept && this->AreKept();
    return this->Superclass::GetDecodedGradientTable();
  }

  std::function<bool()> AreKept;

private:
  bool KeepsShades = false;
};

/** Subclass that only gives access to protected members of vtkFixedPointVolumeRayCastMapper. */
struct RayCasterParts : vtkFixedPointVolumeRayCastMapper
{
  static vtkDirectionEncoder*& GetDirections(vtkFixedPointVolumeRayCastMapper* mapper)
  {
    return mapper->*(&RayCasterParts::DirectionEncoder);
  }
  static void SetDirections(
    vtkFixedPointVolumeRayCastMapper* mapper, vtkDirectionEncoder* directions)
  {
    (mapper->*(&RayCasterParts::GradientEstimator))->SetDirectionEncoder(directions);
    directions->Register(mapper);
    std::exchange(GetDirections(mapper), directions)->UnRegister(mapper);
  }
};

} // namespace

//------------------------------------------------------------------------------
KeptRays::KeptRays(
  vtkRenderer* renderer, vtkVolume* volume, vtkFixedPointVolumeRayCastMapper* mapper)
  : Renderer(renderer)
  , Volume(volume)
  , Mapper(mapper)
  , Observer(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* const rays = static_cast<KeptRays*>(self);
      event == vtkCommand::VolumeMapperRenderStartEvent ? rays->Begin() : rays->End();
    });
  mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, this->Observer);
  mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this->Observer);

  this->OwnDirections = RayCasterParts::GetDirections(mapper);
  if (this->OwnDirections->IsA("vtkSphericalDirectionEncoder"))
  {
    vtkNew<ShadedDirections> directions;
    directions->AreKept = [this]
    { return this->IsDrawn() && !this->Shades.empty() && this->Shades == this->DescribeShades(); };
    RayCasterParts::SetDirections(mapper, directions);
  }
}

//------------------------------------------------------------------------------
KeptRays::~KeptRays()
{
  if (this->Mapper)
  {
    this->Mapper->RemoveObserver(this->Observer);
    RayCasterParts::SetDirections(this->Mapper, this->OwnDirections);
  }
}

//------------------------------------------------------------------------------
bool KeptRays::IsDrawn() const
{
  return this->Renderer && this->Volume && this->Mapper &&
    this->Mapper->GetVolume() == this->Volume &&
    this->Mapper->GetRenderWindow() == this->Renderer->GetRenderWindow();
}

//------------------------------------------------------------------------------
bool KeptRays::CanKeep() const
{
  if (!this->Renderer || !this->Volume || !this->Mapper)
  {
    return false;
  }
  vtkRenderWindow* const window = this->Renderer->GetRenderWindow();
  // A final window or level changes the image itself, so that it can't be reused in the next frame.
  return window && !window->GetStereoRender() && this->Mapper->GetFinalColorWindow() == 1.0F &&
    this->Mapper->GetFinalColorLevel() == 0.5F && this->Mapper->GetInput();
}

//------------------------------------------------------------------------------
bool KeptRays::IsCurrent() const
{
  return !this->Now.Look.empty() && this->CanKeep() && this->Now.Look == this->DescribeLook();
}

//------------------------------------------------------------------------------
bool KeptRays::DrainWhole()
{
  return std::exchange(this->IsWhole, false);
}

//------------------------------------------------------------------------------
KeptRays::Words KeptRays::DescribeLook() const
{
  WordWriter to;
  AddCamera(to, this->Renderer);
  AddLights(to, this->Renderer);
  AddCuts(to, this->Mapper);
  this->Volume->ComputeMatrix();
  to.Add(&this->Volume->GetMatrix()->Element[0][0], 16);
  vtkVolumeProperty* const property = this->Volume->GetProperty();
  to.AddAddress(property);
  to.Add(property->GetMTime());
  // Use the input of the outer mapper: vtkSmartVolumeMapper gives its ray caster a copy, whose
  // modification time is later than the image's.
  auto* const outer = vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper());
  vtkDataObject* const input = outer ? outer->GetDataObjectInput() : nullptr;
  to.AddAddress(input);
  to.Add(input ? input->GetMTime() : 0);
  to.Add(static_cast<std::uint64_t>(this->Mapper->GetScalarMode()));
  to.Add(static_cast<std::uint64_t>(this->Mapper->GetArrayId()));
  for (const char* name = this->Mapper->GetArrayName(); name && *name; ++name)
  {
    to.Add(static_cast<std::uint64_t>(static_cast<unsigned char>(*name)));
  }
  return std::move(to.Words);
}

//------------------------------------------------------------------------------
KeptRays::Words KeptRays::DescribeShades() const
{
  WordWriter to;
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  to.Add(camera->GetPosition(), 3);
  to.Add(camera->GetFocalPoint(), 3);
  AddLights(to, this->Renderer);
  this->Volume->ComputeMatrix();
  to.Add(&this->Volume->GetMatrix()->Element[0][0], 16);
  to.AddAddress(this->Volume->GetProperty());
  to.Add(this->Volume->GetProperty()->GetMTime());
  to.AddAddress(this->Mapper->GetCurrentScalars()); // identifies the array, because the mapper has
                                                    // one table per component
  return std::move(to.Words);
}

//------------------------------------------------------------------------------
KeptRays::Words KeptRays::DescribeImage() const
{
  vtkFixedPointRayCastImage* const image = this->Mapper->GetRayCastImage();
  WordWriter to;
  to.Add(image->GetImageViewportSize(), 2);
  to.Add(image->GetImageInUseSize(), 2);
  to.Add(image->GetImageOrigin(), 2);
  const double distances[] = { this->Mapper->GetImageSampleDistance(),
    this->Mapper->GetSampleDistance() };
  to.Add(distances, 2);
  to.AddAddress(this->Mapper->GetInput());
  to.Add(this->Mapper->GetInput()->GetMTime());
  to.AddAddress(this->Mapper->GetCurrentScalars());
  return std::move(to.Words);
}

//------------------------------------------------------------------------------
KeptRays::Words KeptRays::DescribeStorage() const
{
  vtkFixedPointRayCastImage* const image = this->Mapper->GetRayCastImage();
  WordWriter to;
  to.AddAddress(image->GetImage());
  to.Add(image->GetImageMemorySize(), 2);
  return std::move(to.Words);
}

//------------------------------------------------------------------------------
void KeptRays::StoreCoarse()
{
  vtkFixedPointRayCastImage* const image = this->Mapper->GetRayCastImage();
  const int* const size = image->GetImageInUseSize();
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(size[0]);
  const std::ptrdiff_t step = 4 * static_cast<std::ptrdiff_t>(image->GetImageMemorySize()[0]);
  if (size[0] * size[1] > MostCoarseRays)
  {
    return;
  }
  this->Coarse.Look = this->Now.Look;
  this->Coarse.Image = this->Now.Image;
  this->Coarse.Depths = this->Now.Depths;
  this->Coarse.Pixels.resize(row * size[1]);
  for (int j = 0; j < size[1]; ++j)
  {
    std::copy_n(image->GetImage() + j * step, row, this->Coarse.Pixels.data() + j * row);
  }
}

//------------------------------------------------------------------------------
bool KeptRays::CopyCoarse(const Words& look, const Words& image)
{
  if (look != this->Coarse.Look || image != this->Coarse.Image)
  {
    return false;
  }
  vtkFixedPointRayCastImage* const to = this->Mapper->GetRayCastImage();
  const int* const size = to->GetImageInUseSize();
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(size[0]);
  const std::ptrdiff_t step = 4 * static_cast<std::ptrdiff_t>(to->GetImageMemorySize()[0]);
  for (int j = 0; j < size[1]; ++j)
  {
    std::copy_n(this->Coarse.Pixels.data() + j * row, row, to->GetImage() + j * step);
  }
  this->Now.Depths = this->Coarse.Depths;
  return true;
}

//------------------------------------------------------------------------------
void KeptRays::ReadDepths(std::vector<float>& depths) const
{
  vtkFixedPointRayCastImage* const image = this->Mapper->GetRayCastImage();
  const int* const size = image->GetImageInUseSize();
  depths.resize(static_cast<std::size_t>(size[0]) * size[1]);
  if (!image->GetUseZBuffer())
  {
    std::fill(depths.begin(), depths.end(), 1.0F);
    return;
  }
  // Same result as vtkFixedPointRayCastImage::GetZBufferValue, but without a call per ray.
  const int* const pixels = image->GetZBufferSize();
  const float distance = image->GetImageSampleDistance();
  const auto pixelOf = [distance](int ray, int count)
  { return std::min(static_cast<int>(static_cast<float>(ray) * distance), count - 1); };
  std::vector<int> columns(size[0]);
  for (int i = 0; i < size[0]; ++i)
  {
    columns[i] = pixelOf(i, pixels[0]);
  }
  float* to = depths.data();
  for (int j = 0; j < size[1]; ++j)
  {
    const float* const row =
      image->GetZBuffer() + static_cast<std::ptrdiff_t>(pixelOf(j, pixels[1])) * pixels[0];
    to =
      std::transform(columns.begin(), columns.end(), to, [row](int column) { return row[column]; });
  }
}

//------------------------------------------------------------------------------
void KeptRays::CollectChanges(const std::vector<float>& depths)
{
  const int* const size = this->Mapper->GetRayCastImage()->GetImageInUseSize();
  this->Rows.assign(size[1], {});
  this->Passes = 0;
  for (int j = 0; j < size[1]; ++j)
  {
    std::vector<Run>& runs = this->Rows[j];
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(j) * size[0];
    for (int i = this->OwnBounds[2 * j]; i <= this->OwnBounds[2 * j + 1]; ++i)
    {
      if (depths[row + i] == this->Now.Depths[row + i])
      {
        continue;
      }
      if (!runs.empty() && (i - runs.back().Last <= ShortestGap || runs.size() == MostPasses))
      {
        runs.back().Last = i;
      }
      else
      {
        runs.push_back({ i, i });
      }
    }
    this->Passes = std::max(this->Passes, runs.size());
  }
}

//------------------------------------------------------------------------------
void KeptRays::SetPass(std::size_t pass)
{
  int* bounds = this->Mapper->GetRowBounds();
  for (const std::vector<Run>& runs : this->Rows)
  {
    const Run run = pass < runs.size() ? runs[pass] : Run{ 0, -1 };
    *bounds++ = run.First;
    *bounds++ = run.Last;
  }
}

//------------------------------------------------------------------------------
void KeptRays::Begin()
{
  if (this->IsCasting)
  {
    return;
  }
  const bool isExpected = std::exchange(this->IsExpected, false);
  this->Passes = 0;
  this->OwnBounds.clear();
  this->Shades = this->IsDrawn() ? this->DescribeShades() : Words();
  if (!this->CanKeep() || !this->IsDrawn())
  {
    this->Now.Look.clear();
    this->IsWhole = true;
    return;
  }
  vtkRenderWindow* const window = this->Renderer->GetRenderWindow();
  const int rows = this->Mapper->GetRayCastImage()->GetImageInUseSize()[1];
  const int* const bounds = this->Mapper->GetRowBounds();
  this->OwnBounds.assign(bounds, bounds + 2 * static_cast<std::ptrdiff_t>(rows));
  Words look = this->DescribeLook();
  Words image = this->DescribeImage();
  Words storage = this->DescribeStorage();
  this->ReadDepths(this->NewDepths);
  const bool isKept =
    (look == this->Now.Look && image == this->Now.Image && storage == this->Storage) ||
    this->CopyCoarse(look, image);
  if (isKept)
  {
    this->CollectChanges(this->NewDepths);
    this->SetPass(0);
  }
  else if (isExpected)
  {
    this->Rows.assign(rows, {});
    this->SetPass(0);
    window->SetAbortRender(1);
  }
  this->IsWhole = !isKept;
  this->Now.Look = std::move(look);
  this->Now.Image = std::move(image);
  this->Storage = std::move(storage);
  this->Now.Depths.swap(this->NewDepths);
  this->ImageDistance = this->Mapper->GetImageSampleDistance();
  this->SampleDistance = this->Mapper->GetSampleDistance();
}

//------------------------------------------------------------------------------
void KeptRays::End()
{
  if (this->IsCasting || !this->Mapper || this->OwnBounds.empty())
  {
    return;
  }
  vtkRenderWindow* const window = this->Mapper->GetRenderWindow();
  this->IsCasting = true;
  for (std::size_t pass = 1; pass < this->Passes && !window->GetAbortRender(); ++pass)
  {
    this->SetPass(pass);
    this->Mapper->RenderSubVolume();
  }
  this->IsCasting = false;
  // Restore the mapper's own bounds, which it needs to clear the rest of this image in the next
  // frame.
  std::copy(this->OwnBounds.begin(), this->OwnBounds.end(), this->Mapper->GetRowBounds());
  if (window->GetAbortRender())
  {
    this->Now.Look.clear();
  }
  else
  {
    this->StoreCoarse();
  }
}

} // namespace VolumeHaptics
