// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/TouchScene.h"

#include "Applications/Explorer/Bar/CommandBar.h"
#include "Applications/Explorer/Exploration/HeardTicks.h"
#include "Applications/Explorer/Exploration/Inspection.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Live/FreeFile.h"
#include "Applications/Explorer/Live/HandHold.h"
#include "Applications/Explorer/Live/HandLabel.h"
#include "Applications/Explorer/Live/HandTool.h"
#include "Applications/Explorer/Live/KeptWork.h"
#include "Applications/Explorer/Live/LookSwitch.h"
#include "Applications/Explorer/Live/SavedMeasurements.h"
#include "Applications/Explorer/Live/TimeSlider.h"
#include "Applications/Explorer/Live/TouchReplay.h"
#include "Applications/Explorer/Live/WindowFiles.h"
#include "Applications/Explorer/Live/WindowRecorder.h"
#include "Applications/Explorer/Record/DemoScript.h"
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/Sound/SoundStream.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace Explore
{
namespace
{
/// Lets the user choose a preset and a method. Key F8 saves the materials as a preset in a new
/// preset-001.json, which --preset accepts.
class FeelChoice
{
public:
  FeelChoice(TouchScene& touch, const Exploration& exploration);
  ~FeelChoice() { this->Touch.Commands.Remove(this); }
  FeelChoice(const FeelChoice&) = delete;
  FeelChoice& operator=(const FeelChoice&) = delete;

private:
  void Choose(const std::string& preset);
  void ChooseMethod(int method);
  void Save();

  TouchScene& Touch;
  vtkVolumeHapticsFilter* const Filter;
  vtkImageData* const Image;
  Analysis Values;
  std::string Preset; // name of the last chosen preset
};

FeelChoice::FeelChoice(TouchScene& touch, const Exploration& exploration)
  : Touch(touch)
  , Filter(exploration.Filter)
  , Image(exploration.Input.Image)
  , Values(exploration.Values)
  , Preset(exploration.Materials)
{
  CommandTable& table = touch.Commands;
  vtkStringArray* const presets = vtkHapticProperty::GetPresetNames();
  for (vtkIdType i = 0; i < presets->GetNumberOfValues(); ++i)
  {
    const std::string name = presets->GetValue(i);
    table.Add(this,
      { "Preset", name, "", [this, name] { this->Choose(name); },
        [this, name] { return this->Preset == name; }, nullptr });
  }
  table.Add(this,
    { "Preset", "save the materials to a file", "F8", [this] { this->Save(); }, nullptr, nullptr });
  vtkStringArray* const methods = vtkVolumeHapticsFilter::GetMethodNames();
  for (vtkIdType i = 0; i < methods->GetNumberOfValues(); ++i)
  {
    const int method = static_cast<int>(i);
    const auto isUsable = [this, method] {
      return method != vtkVolumeHapticsFilter::PRIMITIVES || this->Filter->GetNumberOfModes() > 0;
    };
    table.Add(this,
      { "Method", methods->GetValue(i), "", [this, method] { this->ChooseMethod(method); },
        [this, method] { return this->Filter->GetMethod() == method; }, isUsable });
  }
}

void FeelChoice::Choose(const std::string& preset)
{
  vtkHapticProperty* const property = this->Filter->GetProperty();
  vtkNew<vtkHapticProperty> before;
  before->DeepCopy(property);
  const Analysis values = this->Values;
  std::string error;
  try
  {
    const MessageCapture capture;
    ApplyMaterials(preset, this->Values, this->Image, this->Filter);
    FitThresholds(property, this->Values);
    // Publish now, because the next publication by the style would remove the notice below.
    if (this->Touch.Device->IsRunning() && !this->Touch.Device->Publish())
    {
      error = capture.FirstError();
    }
  }
  catch (const InputError& refused)
  {
    error = refused.what();
  }
  if (error.empty())
  {
    this->Preset = preset;
  }
  else
  {
    const MessageCapture capture;
    property->DeepCopy(before);
    this->Values = values;
    this->Touch.Device->Publish();
  }
  this->Touch.Display->SetNotice(error.empty() ? ("Materials: " + preset).c_str() : error.c_str());
}

void FeelChoice::ChooseMethod(int method)
{
  const int before = this->Filter->GetMethod();
  std::string notice;
  {
    const MessageCapture capture;
    this->Filter->SetMethod(method);
    if (!this->Touch.Device->Publish())
    {
      notice = capture.FirstError();
      this->Filter->SetMethod(before);
      this->Touch.Device->Publish();
    }
  }
  this->Touch.Display->SetNotice(notice.c_str());
}

void FeelChoice::Save()
{
  const std::string file = FindFreePath("preset", ".json");
  std::string notice = "Materials saved, for --preset " + file;
  {
    const MessageCapture capture;
    if (!this->Touch.Editor->GetProperty()->WritePreset(file.c_str()))
    {
      notice = capture.FirstError();
    }
  }
  this->Touch.Display->SetNotice(notice.c_str());
}

/// Plays the sound of touches in a scene until the object is deleted. Ctrl+M turns it off and on.
/// If the output fails, one line reports the error, and the scene continues without sound; the key
/// then tries again.
///
/// The sound uses the states that the scene's style reads for the displays (StatesEvent), so the
/// servo's loop has no extra work.
class WindowSound
{
public:
  explicit WindowSound(TouchScene& touch);
  ~WindowSound();
  WindowSound(const WindowSound&) = delete;
  WindowSound& operator=(const WindowSound&) = delete;

  SoundStream& GetStream() { return this->Stream; }

private:
  void DrainStates();
  void PressKey();

  TouchScene& Touch;
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkInteractorStyleHaptic> Style;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  HeardTicks Ticks;
  SoundStream Stream;
  // after Stream, so that it is destroyed before the stream that it plays
  std::unique_ptr<SoundOutput> Output;
  bool HasFailed = false;
  vtkNew<vtkCallbackCommand> StatesObserver;
};

WindowSound::WindowSound(TouchScene& touch)
  : Touch(touch)
  , Device(touch.Device)
  , Style(touch.Style)
  , Display(touch.Display)
  , Ticks(touch.Device->GetVolumeHaptics())
  , Stream(SAMPLES_PER_SECOND)
  , Output(SoundOutput::Open(this->Stream))
{
  touch.Commands.Add(this,
    { "Window", "sound", "Ctrl+m", [this] { this->PressKey(); },
      [this] { return !this->Stream.IsMuted(); }, nullptr });
  this->StatesObserver->SetClientData(this);
  this->StatesObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<WindowSound*>(self)->DrainStates(); });
  this->Style->AddObserver(vtkInteractorStyleHaptic::StatesEvent, this->StatesObserver);
}

WindowSound::~WindowSound()
{
  this->Touch.Commands.Remove(this);
  this->Style->RemoveObserver(this->StatesObserver);
}

void WindowSound::DrainStates()
{
  for (const SoundTick& tick :
    this->Ticks.Read(this->Style->GetStates(), this->Device->GetState()->GetLabel()))
  {
    this->Stream.Push(tick);
  }
  const std::string trouble = this->Output ? this->Output->DrainTrouble() : std::string();
  if (!trouble.empty())
  {
    this->HasFailed = true;
    this->Stream.SetMuted(true);
    std::cerr << "--sound: there is no sound (" << trouble
              << "). Cure: start PulseAudio or PipeWire, then press Ctrl+M in the window."
              << std::endl;
    this->Display->SetNotice("There is no sound: start PulseAudio or PipeWire, then press Ctrl+M");
  }
}

void WindowSound::PressKey()
{
  if (this->HasFailed)
  {
    this->Output.reset();
    this->Output = SoundOutput::Open(this->Stream);
    this->HasFailed = false;
  }
  this->Stream.SetMuted(!this->Stream.IsMuted());
  const char* const now = this->Stream.IsMuted() ? "Sound off" : "Sound on";
  std::cout << now << std::endl;
  this->Display->SetNotice(now);
}
} // namespace
} // namespace Explore

namespace
{
using Explore::TouchScene;

/// Shift of the volume to the right of the centre, in halves of the window's width, which leaves
/// room for the head-up display's plot.
constexpr double BESIDE_PLOT = -0.14;

/// Adds all parts to the scene. Two-dimensional parts are drawn above the volume and below the
/// marker.
void AddParts(TouchScene& touch, const Explore::Exploration& exploration)
{
  constexpr int labelPort = 3;
  const Explore::Analysis& analysis = exploration.Values;
  touch.Hand->SetDevice(touch.Device);
  // Draw one newton two centimetres long, whatever the unit of the world.
  touch.Hand->SetRadius(0.003 / analysis.MetersPerWorldUnit);
  touch.Hand->SetForceScale(50.0 * analysis.MetersPerWorldUnit);
  touch.Scene.Renderer->AddViewProp(touch.Hand);
  if (touch.SecondDevice)
  {
    touch.SecondHand->SetDevice(touch.SecondDevice);
    touch.SecondHand->SecondHandOn();
    touch.SecondHand->SetRadius(touch.Hand->GetRadius());
    touch.SecondHand->SetForceScale(touch.Hand->GetForceScale());
    touch.Scene.Renderer->AddViewProp(touch.SecondHand);
  }

  touch.Display->SetSecondDevice(touch.SecondDevice);
  touch.Display->SetDevice(touch.Device);
  touch.Scene.Overlay->AddViewProp(touch.Display);

  // Use the true scale of the volume. The scale of the hand may differ, because it enlarges small
  // objects.
  touch.Measurements->SetMetersPerWorldUnit(exploration.Input.MetersPerUnit);
  // Record a point every half voxel, because 3D Slicer can't handle one point per millisecond.
  const double* const spacing = exploration.Input.Image->GetSpacing();
  touch.Measurements->SetPathSpacing(0.5 * std::min({ spacing[0], spacing[1], spacing[2] }));
  touch.Measured->SetMeasurements(touch.Measurements);
  touch.Measured->SetHeadUpDisplay(touch.Display);
  touch.Measured->SetRadius(0.0018 / analysis.MetersPerWorldUnit);
  touch.Scene.Renderer->AddViewProp(touch.Measured);
  touch.Display->SetMeasurements(touch.Measurements);

  touch.Editor->SetProperty(exploration.Filter->GetProperty());
  touch.Editor->SetVolumeProperty(touch.Scene.Look);
  touch.Editor->SetInputData(exploration.Body);
  touch.Editor->SetLabelTable(exploration.Filter->GetLabelTable());
  touch.Editor->SetLabelData(
    vtkImageData::SafeDownCast(exploration.Filter->GetInputDataObject(labelPort, 0)));
  touch.Editor->VisibilityOff();
  touch.Scene.Overlay->AddViewProp(touch.Editor);
}

/// Places the editor beside the display's plot and the slices, above the scale of the arrows.
/// Places the orientation marker beside the hint, or below it if the slices leave too little room.
void PlaceParts(TouchScene& touch)
{
  const double share = touch.Slices->GetVisibility() ? touch.Slices->GetShare() : 0.0;
  const int width = static_cast<int>((1.0 - share) * touch.Scene.Window->GetSize()[0]);
  const int height = touch.Editor->GetLabelTable() ? 300 : 190;
  touch.Editor->SetRectangle(std::max(10, width - 265), 40, 255, height);
  const double top = share > 0.0 ? 0.88 : 1.0;
  touch.Scene.Marker->SetViewport(0.84, top - 0.2, 1.0, top);
}

/// Adds slices through the tip. They are hidden if their share of the window's width is zero.
void AddSlices(
  TouchScene& touch, const Explore::Exploration& exploration, const Explore::SceneOptions& options)
{
  vtkHapticSliceView* const slices = touch.Slices;
  slices->SetDevice(touch.Device);
  slices->SetHeadUpDisplay(touch.Display);
  slices->SetAnatomical(options.Anatomical);
  if (exploration.Values.Kind == Explore::VolumeKind::CT)
  {
    // A range from fat to dense bone in which soft tissues can still be distinguished.
    slices->SetUnit("HU");
    slices->SetColorWindow(800.0);
    slices->SetColorLevel(150.0);
  }
  slices->SetShare(Explore::SLICE_SHARE);
  slices->SetVisibility(options.SliceShare > 0.0);
  slices->SetRenderWindow(touch.Scene.Window);
  touch.Style->SetSliceView(slices);
  PlaceParts(touch);
  vtkNew<vtkCallbackCommand> place;
  place->SetClientData(&touch);
  place->SetCallback([](vtkObject*, unsigned long, void* scene, void*)
    { PlaceParts(*static_cast<TouchScene*>(scene)); });
  slices->AddObserver(vtkCommand::ModifiedEvent, place);
}

[[noreturn]] void RefuseDevice(const std::string& id, const std::string& error)
{
  throw Explore::InputError("--device " + id, error,
    "choose another device, or none; volumehaptics-device list shows those that can be used");
}

vtkSmartPointer<vtkHapticDevice> OpenDevice(
  const std::string& id, const Explore::DeviceChoice& choice)
{
  const Explore::MessageCapture capture;
  auto device = vtkSmartPointer<vtkHapticDevice>::New();
  if (!choice.Firmware.empty())
  {
    device->SetFirmwareFile(choice.Firmware);
  }
  device->SetNewtonsPerFullScale(choice.Newtons.data());
  if (!device->Open(id.c_str()))
  {
    RefuseDevice(id, capture.FirstError());
  }
  return device;
}

/// Starts the servo of a device of the window. Throws InputError if that fails.
void StartDevice(vtkHapticDevice* device, const Explore::Exploration& exploration)
{
  const Explore::MessageCapture capture;
  device->SetVolumeHaptics(exploration.Filter);
  device->SetServoRate(exploration.ServoRate);
  if (!device->Start())
  {
    RefuseDevice(device->GetDeviceId(), capture.FirstError());
  }
}

/// Formats a list with columns separated by tabs as an aligned table.
std::string Align(const std::string& keys)
{
  constexpr std::size_t width = 16;
  std::istringstream lines(keys);
  std::string text;
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos)
    {
      line = "  " + line.substr(0, tab) + std::string(width - std::min(width - 1, tab), ' ') +
        line.substr(tab + 1);
    }
    text += line + "\n";
  }
  return text;
}
} // namespace

namespace Explore
{
OpenDevices OpenDevicesOf(const DeviceChoice& choice)
{
  OpenDevices devices{ OpenDevice(choice.Id, choice), nullptr };
  if (!choice.SecondId.empty())
  {
    devices.Second = OpenDevice(choice.SecondId, choice);
  }
  return devices;
}

namespace
{
/// Adds the commands that no other part provides.
void AddWindowCommands(TouchScene& touch, vtkRenderWindowInteractor* interactor)
{
  const vtkSmartPointer<vtkRenderWindow> window = touch.Scene.Window;
  const vtkSmartPointer<vtkRenderer> renderer = touch.Scene.Renderer;
  auto first = vtkSmartPointer<vtkCamera>::New();
  first->DeepCopy(renderer->GetActiveCamera());
  const auto reset = [renderer, first]
  {
    renderer->GetActiveCamera()->DeepCopy(first);
    renderer->ResetCameraClippingRange();
  };
  touch.Commands.Add(&touch, { "Look", "reset the view", "r", reset, nullptr, nullptr });
  const auto addEdit = [&](const char* text, bool (vtkHapticFunctionEditor::*act)())
  {
    const auto run = [&touch, act]
    {
      if (!(touch.Editor->*act)())
      {
        touch.Display->SetNotice("There is no edit to undo or redo");
      }
    };
    touch.Commands.Add(&touch, { "Materials", text, "", run, nullptr, nullptr });
  };
  addEdit("undo an edit", &vtkHapticFunctionEditor::Undo);
  addEdit("redo an edit", &vtkHapticFunctionEditor::Redo);
  touch.Commands.Add(&touch,
    { "Window", "stereo glasses", "",
      [window] { window->SetStereoRender(!window->GetStereoRender()); },
      [window] { return window->GetStereoRender() != 0; }, nullptr });
  touch.Commands.Add(&touch,
    { "Window", "close", "q", [interactor] { interactor->ExitCallback(); }, nullptr, nullptr });
}

/// Removes notices from the screen after enough time to read them.
class NoticeTimer
{
public:
  NoticeTimer(TouchScene& touch, vtkRenderWindowInteractor* interactor);
  ~NoticeTimer() { this->Interactor->RemoveObserver(this->Observer); }
  NoticeTimer(const NoticeTimer&) = delete;
  NoticeTimer& operator=(const NoticeTimer&) = delete;

private:
  void Update();

  TouchScene& Touch;
  const vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::string Notice;
  std::chrono::steady_clock::time_point Begin; // when the notice appeared
  vtkNew<vtkCallbackCommand> Observer;
};

NoticeTimer::NoticeTimer(TouchScene& touch, vtkRenderWindowInteractor* interactor)
  : Touch(touch)
  , Interactor(interactor)
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<NoticeTimer*>(self)->Update(); });
  interactor->AddObserver(vtkCommand::TimerEvent, this->Observer);
}

void NoticeTimer::Update()
{
  constexpr double least = 6.0;     // s
  constexpr double perLetter = 0.1; // s per letter, for a slow reader
  const auto now = std::chrono::steady_clock::now();
  const std::string notice = this->Touch.Display->GetNotice();
  if (notice != this->Notice)
  {
    this->Notice = notice;
    this->Begin = now;
  }
  const std::chrono::duration<double> age = now - this->Begin;
  if (!notice.empty() && age.count() > least + perLetter * static_cast<double>(notice.size()))
  {
    this->Touch.Display->SetNotice("");
    this->Interactor->Render();
  }
}
} // namespace

void BuildTouchScene(TouchScene& touch, const Exploration& exploration, const SceneOptions& options,
  const DeviceChoice& device)
{
  BuildScene(touch.Scene, exploration, options);
  vtkVolumeHapticsFilter* const filter = exploration.Filter;
  filter->GetProperty()->SetVisibilityFrom(touch.Scene.Look);
  if (!touch.Device)
  {
    const OpenDevices devices = OpenDevicesOf(device);
    touch.Device = devices.First;
    touch.SecondDevice = devices.Second;
  }
  StartDevice(touch.Device, exploration);
  if (!device.SecondId.empty())
  {
    if (exploration.Input.TimeSteps)
    {
      throw InputError("--device " + device.SecondId,
        "is a second device, and a moving volume can be touched with one only", "give one device");
    }
    touch.SecondDevice->UseToolOff(); // only the first hand uses the tool
    StartDevice(touch.SecondDevice, exploration);
  }
  AddParts(touch, exploration);
  AddSlices(touch, exploration, options);
  // A large volume has no cropping box, because its renderer already crops the mapper.
  touch.Cut.SetScene(touch.Scene.Volume, filter, touch.Scene.Overlay, exploration.Values.BodyBounds,
    !exploration.Input.Large);
  touch.Cut.AddCommands(touch.Commands);
  touch.Setup->SetVolumeHaptics(filter);
  touch.Setup->SetVolumeProperty(touch.Scene.Look);
  touch.Setup->SetCamera(touch.Scene.Renderer->GetActiveCamera());
  touch.Style->SetDevice(touch.Device);
  touch.Style->SetSecondDevice(touch.SecondDevice);
  touch.Style->SetHeadUpDisplay(touch.Display);
  touch.Style->SetFunctionEditor(touch.Editor);
  touch.Style->SetMeasurements(touch.Measurements);
  touch.Style->SetDefaultRenderer(touch.Scene.Renderer);
  touch.Style->SetCoarseVolume(exploration.Input.Large ? touch.Scene.Volume.Get() : nullptr);
  if (vtkHapticTimeStepSource* const timeSteps = exploration.Input.TimeSteps)
  {
    timeSteps->Update();
    filter->SetDisplacementArrayName(exploration.Input.Displacements.c_str());
    filter->SetInputConnection(0, timeSteps->GetOutputPort());
    touch.Device->GetPlayback()->SetModeToLoop();
    touch.Device->GetPlayback()->Play();
  }
}

FileChoice RunTouchWindow(vtkRenderWindow* window, const Exploration& exploration,
  const SceneOptions& options, const DeviceChoice& device, const WindowOptions& wanted)
{
  const std::string& setup = wanted.Setup;
  TouchScene touch;
  touch.Scene.Window = window;
  touch.Device = wanted.Devices.First;
  touch.SecondDevice = wanted.Devices.Second;
  BuildTouchScene(touch, exploration, options, device);
  if (!setup.empty() && vtksys::SystemTools::FileExists(setup, true))
  {
    const MessageCapture capture;
    if (!touch.Setup->Load(setup.c_str()))
    {
      throw InputError(
        "--setup " + setup, capture.FirstError(), "correct it or choose another file");
    }
  }
  if (options.Cut == CutKind::Box && !touch.Cut.HasRegions())
  {
    throw InputError("--cut box", "can't be used with a volume that may be larger than memory",
      "use --cut plane, or leave out --large");
  }
  touch.Cut.SetKind(options.Cut);
  SavedMeasurements saved(touch, wanted.Measurements);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(touch.Scene.Window);
  interactor->SetInteractorStyle(touch.Style);
  touch.Cut.SetInteractor(interactor);
  touch.Commands.SetStyle(touch.Style);
  touch.Commands.SetInteractor(interactor);
  auto feel = std::make_unique<FeelChoice>(touch, exploration);
  auto tool = std::make_unique<HandTool>(touch, exploration, wanted.Tool);
  auto look = std::make_unique<LookSwitch>(touch, exploration.Values);
  auto hold = std::make_unique<HandHold>(touch);
  auto label = std::make_unique<HandLabel>(touch, exploration);
  auto recorder = std::make_unique<WindowRecorder>(touch, interactor, wanted.Movie);
  auto script = wanted.Script.empty()
    ? nullptr
    : std::make_unique<DemoScript>(ReadDemoScript(wanted.Script), interactor);
  auto heard = wanted.Sound ? std::make_unique<WindowSound>(touch) : nullptr;
  FileChoice choice;
  auto files =
    std::make_unique<WindowFiles>(touch, interactor, exploration.Input, wanted.File, choice);
  auto replay = wanted.Replay.empty()
    ? nullptr
    : std::make_unique<TouchReplay>(touch, interactor, wanted.Replay);
  auto time = exploration.Input.TimeSteps && !replay
    ? std::make_unique<TimeSlider>(touch, exploration, interactor)
    : nullptr;
  auto kept =
    std::make_unique<KeptWork>(touch, exploration.Filter, saved, *tool, *look, wanted.File);
  touch.Scene.Renderer->GetActiveCamera()->SetWindowCenter(BESIDE_PLOT, 0.0);
  AddWindowCommands(touch, interactor);
  auto notices = std::make_unique<NoticeTimer>(touch, interactor);
  const std::string name = vtksys::SystemTools::GetFilenameName(wanted.File.Path);
  touch.Scene.Window->SetWindowName(("VTK Volume Haptics: " + name).c_str());
  auto bar = std::make_unique<CommandBar>(touch.Commands, touch.Scene.Window, interactor);
  const Inspection facts(
    exploration.Input, exploration.Values, exploration.Materials, exploration.Filter);
  touch.Commands.SetFacts(facts.ListFacts());
  if (wanted.View)
  {
    touch.Scene.Renderer->GetActiveCamera()->DeepCopy(wanted.View);
    touch.Scene.Renderer->ResetCameraClippingRange();
    touch.Scene.Renderer->GetActiveCamera()->SetWindowCenter(BESIDE_PLOT, 0.0);
  }
  std::cout << touch.Scene.MapperName << "\n\n" << Align(touch.Style->GetKeys()) << std::endl;
  const std::string offer = kept->GetOffer();
  const std::string told = facts.ListTold();
  const std::string asked = !wanted.Notice.empty() ? wanted.Notice : offer;
  const std::string notice = asked + (asked.empty() || told.empty() ? "" : "\n") + told;
  if (!notice.empty())
  {
    touch.Display->SetNotice(notice.c_str());
  }
  if (!offer.empty())
  {
    std::cout << offer << std::endl;
  }
  touch.Scene.Window->Render();
  interactor->Initialize();
  if (wanted.BringBack)
  {
    kept->BringBack();
    touch.Display->SetNotice(notice.c_str());
  }
  interactor->Start();
  choice.Place.View = vtkSmartPointer<vtkCamera>::New();
  choice.Place.View->DeepCopy(touch.Scene.Renderer->GetActiveCamera());
  bar.reset();
  notices.reset();
  time.reset();
  replay.reset();
  files.reset();
  script.reset();
  recorder.reset();
  heard.reset();
  label.reset();
  hold.reset();
  feel.reset();
  touch.Commands.SetInteractor(nullptr);
  touch.Cut.SetInteractor(nullptr);
  touch.Device->Close();
  if (touch.SecondDevice)
  {
    touch.SecondDevice->Close();
  }
  look->ShowOutside();
  const bool isSetUp = !setup.empty() && touch.Setup->Save(setup.c_str());
  const std::string error = saved.SaveAtEnd();
  kept->KeepAtEnd(isSetUp);
  kept.reset();
  look.reset();
  tool.reset();
  if (!error.empty())
  {
    throw InputError("--measurements " + wanted.Measurements, error,
      "choose a file in a folder that you may write to");
  }
  if (!setup.empty() && !isSetUp)
  {
    throw InputError(
      "--setup " + setup, "can't be written", "choose a file in a folder that you may write to");
  }
  return choice;
}

} // namespace Explore
