// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticVolumeFrames.h"

#include "VTK/Scene/Frames/SoftwareOpenGL.h"

#include "vtkCallbackCommand.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVOpenGLInformation.h"
#include "vtkPVSession.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace VolumeHaptics
{
namespace
{

// s: longest frame in motion; Qt, events and haptics need the rest of 1/20 s
constexpr double LongestMotion = 0.03;
// s: longest frame at rest while armed, because the force fades if the device is not polled
constexpr double LongestRest = 0.5;
// Hz: smallest desired rate; below it, vtkSmartVolumeMapper casts all rays
constexpr double LeastRate = 1.0;
// Hz: highest desired rate; above it, larger distances between rays save little time
constexpr double HighestRate = 60.0;
constexpr const char* Mode = "VolumeRenderingMode";

HapticVolumeFrames::PointerQuery AskPointer = nullptr;

int NumberOf(vtkSMProxy* proxy, const char* name)
{
  return proxy->GetProperty(name) ? vtkSMPropertyHelper(proxy, name, true).GetAsInt() : 0;
}

/**
 * Returns the part of a representation that currently draws it as a volume; null if there is none.
 */
vtkSMProxy* FindVolume(vtkSMProxy* representation)
{
  if (!representation || !representation->GetProperty(Mode) ||
    !representation->GetProperty("Representation") || NumberOf(representation, "Visibility") == 0)
  {
    return nullptr;
  }
  const char* const type = vtkSMPropertyHelper(representation, "Representation").GetAsString();
  // A representation exposes the properties of its parts, so this property's parent is the part.
  return type && std::strcmp(type, "Volume") == 0 ? representation->GetProperty(Mode)->GetParent()
                                                  : nullptr;
}

/**
 * Returns whether vtkFixedPointVolumeRayCastMapper can draw a volume like ParaView's own choice of
 * mapper.
 */
bool CanBeCast(vtkSMProxy* representation)
{
  constexpr int blends[] = { vtkVolumeMapper::COMPOSITE_BLEND,
    vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
    vtkVolumeMapper::ADDITIVE_BLEND };
  const int blend = NumberOf(representation, "BlendMode");
  const vtkSMPropertyHelper input(representation, "Input", true);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkPVDataInformation* const data =
    source ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
  auto* const colored = vtkSMPVRepresentationProxy::SafeDownCast(representation);
  vtkPVArrayInformation* const array =
    colored ? colored->GetArrayInformationForColorArray() : nullptr;
  return std::find(std::begin(blends), std::end(blends), blend) != std::end(blends) && data &&
    data->GetDataSetType() == VTK_IMAGE_DATA && array && array->GetNumberOfComponents() == 1 &&
    vtkSMPropertyHelper(representation, "ColorArrayName", true).GetInputArrayAssociation() ==
    vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    NumberOf(representation, "UseSeparateOpacityArray") == 0 &&
    NumberOf(representation, "UseTransfer2D") == 0;
}

/**
 * Sends the mode to the objects in the client and on the servers, without changing the property.
 */
void SendMode(vtkSMProxy* volume, int mode)
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(volume) << "SetRequestedRenderMode" << mode
         << vtkClientServerStream::End;
  if (vtkSMSession* const session = volume->GetSession())
  {
    session->ExecuteStream(volume->GetLocation(), stream);
  }
}

} // namespace

//------------------------------------------------------------------------------
void HapticVolumeFrames::SetPointerQuery(PointerQuery query)
{
  AskPointer = query;
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::Rate::Update(double time, double longest)
{
  if (time > longest || time < 0.7 * longest)
  {
    this->Hz *= std::clamp(time / longest, 0.7, 1.5);
    this->Hz = std::clamp(this->Hz, LeastRate, HighestRate);
  }
}

//------------------------------------------------------------------------------
HapticVolumeFrames::HapticVolumeFrames()
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* const frames = static_cast<HapticVolumeFrames*>(self);
      if (!frames->IsDrawing)
      {
        return;
      }
      switch (event)
      {
        case vtkCommand::StartEvent:
          frames->Begin();
          break;
        case vtkCommand::EndEvent:
          frames->End();
          break;
        default:
          frames->Interrupt();
      }
    });
}

//------------------------------------------------------------------------------
HapticVolumeFrames::~HapticVolumeFrames()
{
  this->SetView(nullptr);
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::SetView(vtkSMRenderViewProxy* view)
{
  if (view && view == this->View)
  {
    return;
  }
  this->ChooseRayCasters(Touch::Off);
  this->GiveBack();
  if (this->Window)
  {
    this->Window->RemoveObserver(this->Observer);
  }
  this->View = view;
  this->Window = view ? view->GetRenderWindow() : nullptr;
  this->OnProcessor.reset();
  this->WindowOnProcessor.reset();
  if (this->Window)
  {
    // Observe after FrameQuality, because it recognises motion by the rate that ParaView has set.
    constexpr float priority = -1.0F;
    for (const auto event :
      { vtkCommand::StartEvent, vtkCommand::EndEvent, vtkCommand::AbortCheckEvent })
    {
      this->Window->AddObserver(event, this->Observer, priority);
    }
  }
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::Draw(bool quickly, Touch touch)
{
  const vtkSmartPointer<vtkSMRenderViewProxy> view = this->View.GetPointer();
  if (!view || this->IsDrawing)
  {
    return;
  }
  this->ChooseRayCasters(touch);
  this->IsQuick = quickly;
  this->IsTouched = touch != Touch::Off;
  this->IsArmed = touch == Touch::Armed;
  this->IsDrawing = true;
  quickly ? view->InteractiveRender() : view->StillRender();
  this->IsDrawing = false;
}

//------------------------------------------------------------------------------
bool HapticVolumeFrames::IsOnProcessor()
{
  if (!this->OnProcessor)
  {
    vtkNew<vtkPVOpenGLInformation> info;
    this->View->GetSession()->GatherInformation(
      vtkPVSession::RENDER_SERVER, info, this->View->GetGlobalID());
    this->OnProcessor = NamesSoftwareOpenGL(info->GetCapabilities());
  }
  return *this->OnProcessor;
}

//------------------------------------------------------------------------------
bool HapticVolumeFrames::IsWindowOnProcessor()
{
  if (!this->WindowOnProcessor && !this->Window->GetNeverRendered())
  {
    this->WindowOnProcessor = IsSoftwareOpenGL(this->Window);
  }
  return this->WindowOnProcessor.value_or(false);
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::ChooseRayCasters(Touch touch)
{
  this->CastsOnProcessor = false;
  std::vector<Volume> chosen;
  const auto find = [](std::vector<Volume>& all, vtkSMProxy* drawn)
  {
    return std::find_if(
      all.begin(), all.end(), [drawn](const Volume& volume) { return volume.Drawn == drawn; });
  };
  if (this->View && touch != Touch::Off)
  {
    const vtkSMPropertyHelper shown(this->View, "Representations", true);
    for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
    {
      vtkSMProxy* const representation = shown.GetAsProxy(i);
      vtkSMProxy* const drawn = FindVolume(representation);
      const int own = drawn ? NumberOf(representation, Mode) : vtkSmartVolumeMapper::GPURenderMode;
      this->CastsOnProcessor |= own == vtkSmartVolumeMapper::RayCastRenderMode;
      if (own == vtkSmartVolumeMapper::DefaultRenderMode && CanBeCast(representation) &&
        this->IsOnProcessor())
      {
        chosen.push_back({ representation, drawn, representation->GetProperty(Mode)->GetMTime() });
      }
    }
  }
  for (const Volume& volume : chosen)
  {
    const auto known = find(this->Volumes, volume.Drawn);
    if (known == this->Volumes.end() || known->SetTime != volume.SetTime)
    {
      SendMode(volume.Drawn, vtkSmartVolumeMapper::RayCastRenderMode);
    }
    this->CastsOnProcessor = true;
  }
  for (const Volume& volume : this->Volumes)
  {
    if (volume.Drawn && volume.Representation && find(chosen, volume.Drawn) == chosen.end())
    {
      SendMode(volume.Drawn, NumberOf(volume.Representation, Mode));
    }
  }
  this->Volumes = std::move(chosen);
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::Begin()
{
  this->Start = std::chrono::steady_clock::now();
  if (AskPointer)
  {
    AskPointer(this->Pointer);
  }
  // Set the rate here, because ParaView sets its own rate before each frame.
  if (this->SetsRate())
  {
    this->Window->SetDesiredUpdateRate(this->IsQuick ? this->InMotion.Hz : this->AtRest.Hz);
  }
  if (this->IsQuick && this->IsTouched && this->IsWindowOnProcessor())
  {
    vtkRendererCollection* const renderers = this->Window->GetRenderers();
    vtkCollectionSimpleIterator at;
    renderers->InitTraversal(at);
    while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
    {
      if (renderer->GetUseFXAA())
      {
        renderer->UseFXAAOff();
        this->Smoothed.emplace_back(renderer);
      }
    }
  }
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::GiveBack()
{
  for (const auto& renderer : this->Smoothed)
  {
    if (renderer)
    {
      renderer->UseFXAAOn();
    }
  }
  this->Smoothed.clear();
  if (std::exchange(this->KeepsPicture, false) && this->Window)
  {
    this->Window->SwapBuffersOn();
  }
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::End()
{
  this->GiveBack();
  if (!this->SetsRate() || this->Window->GetAbortRender())
  {
    return;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - this->Start;
  this->IsQuick ? this->InMotion.Update(time.count(), LongestMotion)
                : this->AtRest.Update(time.count(), LongestRest);
}

//------------------------------------------------------------------------------
void HapticVolumeFrames::Interrupt()
{
  if (!this->IsTouched || this->IsQuick || !AskPointer)
  {
    return;
  }
  int pointer[2];
  AskPointer(pointer);
  if (!std::equal(pointer, pointer + 2, this->Pointer))
  {
    this->Window->SetAbortRender(1);
    // Don't swap buffers, because a window that draws for Qt would show its unfinished frame.
    this->KeepsPicture = this->KeepsPicture || this->Window->GetSwapBuffers() != 0;
    this->Window->SwapBuffersOff();
  }
}

} // namespace VolumeHaptics
