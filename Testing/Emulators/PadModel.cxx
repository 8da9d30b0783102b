// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PadModel.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace emulated
{
namespace
{
constexpr long JiffyTime = 4; // ms, period of the kernel's timer
using Lock = std::lock_guard<std::recursive_mutex>;

input_absinfo Range(int least, int most, int flat, bool isStick)
{
  input_absinfo axis{};
  axis.value = isStick ? (least + most + 1) / 2 : least;
  axis.minimum = least;
  axis.maximum = most;
  axis.flat = flat;
  return axis;
}
} // namespace

PadModel::PadModel(Kind kind)
  : Model(kind)
{
  const bool isXbox = kind == Kind::Xbox;
  const input_absinfo stick = isXbox ? Range(-32768, 32767, 128, true) : Range(0, 255, 0, true);
  const input_absinfo trigger = Range(0, 255, 0, false);
  this->Axes = { { ABS_X, stick }, { ABS_Y, stick } };
  if (kind == Kind::Wheel)
  {
    const input_absinfo pedal = Range(0, 255, 0, false);
    this->Axes = { { ABS_X, Range(0, 65535, 0, true) }, { ABS_Y, pedal }, { ABS_Z, pedal },
      { ABS_RZ, pedal } };
    return;
  }
  if (kind == Kind::Older)
  {
    this->Axes.insert({ { ABS_Z, stick }, { ABS_RZ, stick } });
    return;
  }
  this->Axes.insert(
    { { ABS_RX, stick }, { ABS_RY, stick }, { ABS_Z, trigger }, { ABS_RZ, trigger } });
}

std::string PadModel::GetName() const
{
  constexpr const char* names[] = { "Microsoft X-Box 360 pad",
    "Sony Interactive Entertainment DualSense Wireless Controller", "Generic USB Gamepad",
    "Logitech G29 Driving Force Racing Wheel" };
  return names[static_cast<int>(this->Model)];
}

int PadModel::GetVendor() const
{
  constexpr int vendors[] = { 0x045e, 0x054c, 0x0079, 0x046d };
  return vendors[static_cast<int>(this->Model)];
}

int PadModel::GetProduct() const
{
  constexpr int products[] = { 0x028e, 0x0ce6, 0x0006, 0xc24f };
  return products[static_cast<int>(this->Model)];
}

std::set<unsigned> PadModel::GetButtons() const
{
  if (this->Model == Kind::Wheel)
  {
    return { BTN_TRIGGER, BTN_THUMB, BTN_THUMB2, BTN_TOP, BTN_TOP2, BTN_PINKIE, BTN_BASE };
  }
  return { BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT, BTN_START,
    BTN_MODE, BTN_THUMBL, BTN_THUMBR };
}

int PadModel::ValueAt(unsigned axis, double share) const
{
  const input_absinfo& range = this->Axes.at(axis);
  const bool isTrigger = this->Model != Kind::Older && (axis == ABS_Z || axis == ABS_RZ);
  const double least = range.minimum;
  const double size = static_cast<double>(range.maximum) - least;
  return static_cast<int>(std::lround(least + size * (isTrigger ? share : 0.5 * (share + 1.0))));
}

void PadModel::Send(unsigned type, unsigned code, int value)
{
  input_event event{};
  event.type = static_cast<__u16>(type);
  event.code = static_cast<__u16>(code);
  event.value = value;
  input_event end{};
  this->Input({ event, end }); // zeros are EV_SYN and SYN_REPORT
}

void PadModel::Move(unsigned axis, double share)
{
  const Lock lock(this->Guard);
  const int value = this->ValueAt(axis, share);
  if (this->Axes.at(axis).value != value)
  {
    this->Axes.at(axis).value = value;
    this->Send(EV_ABS, axis, value);
  }
}

void PadModel::MoveUnheard(unsigned axis, double share)
{
  const Lock lock(this->Guard);
  this->Axes.at(axis).value = this->ValueAt(axis, share);
  input_event dropped{};
  dropped.type = EV_SYN;
  dropped.code = SYN_DROPPED;
  input_event rest{};
  rest.type = EV_ABS;
  rest.code = static_cast<__u16>(axis);
  // a value other than the axis's, because events were lost
  rest.value = this->Axes.at(axis).minimum;
  this->Input({ dropped, rest, {} });
}

void PadModel::Press(unsigned button, bool isHeld)
{
  const Lock lock(this->Guard);
  isHeld ? static_cast<void>(this->Pressed.insert(button))
         : static_cast<void>(this->Pressed.erase(button));
  this->Send(EV_KEY, button, isHeld ? 1 : 0);
}

input_absinfo PadModel::GetAxis(unsigned code)
{
  const Lock lock(this->Guard);
  return this->Axes.at(code);
}

bool PadModel::IsPressed(unsigned button)
{
  const Lock lock(this->Guard);
  return this->Pressed.count(button) != 0;
}

int PadModel::Grab(const void* file, bool isOn)
{
  const Lock lock(this->Guard);
  if (isOn ? this->Holder != nullptr : this->Holder != file)
  {
    return isOn ? -EBUSY : -EINVAL;
  }
  this->Holder = isOn ? file : nullptr;
  return 0;
}

double PadModel::GetTime() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
}

long PadModel::Jiffies() const
{
  return static_cast<long>(this->GetTime() * 1000.0) / JiffyTime;
}

long PadModel::Ticks(int milliseconds) const
{
  return (milliseconds + JiffyTime - 1) / JiffyTime;
}

int PadModel::Upload(const void* file, ff_effect& effect)
{
  const Lock lock(this->Guard);
  if (!this->HasForce())
  {
    return -ENOSYS;
  }
  if (this->Refuses)
  {
    return -EIO;
  }
  if (effect.type != (this->Rumbles() ? FF_RUMBLE : FF_CONSTANT))
  {
    return -EINVAL;
  }
  if (effect.id == -1)
  {
    int id = 0;
    while (id < this->GetSlots() && this->Effects[static_cast<std::size_t>(id)].Owner)
    {
      ++id;
    }
    if (id == this->GetSlots())
    {
      return -ENOSPC;
    }
    effect.id = static_cast<__s16>(id);
  }
  else if (effect.id < 0 || effect.id >= this->GetSlots() ||
    !this->Effects[static_cast<std::size_t>(effect.id)].Owner)
  {
    return -EINVAL;
  }
  Effect& mine = this->Effects[static_cast<std::size_t>(effect.id)];
  if (mine.Owner && mine.Owner != file)
  {
    return -EACCES;
  }
  if (mine.Started)
  {
    mine.Playing = false;
    mine.PlayAt = this->Jiffies() + this->Ticks(effect.replay.delay);
    mine.StopAt = mine.PlayAt + this->Ticks(effect.replay.length);
    this->Schedule();
  }
  mine.What = effect;
  mine.Owner = file;
  this->LongestReplay = effect.replay.length == 0 || this->LongestReplay == 0
    ? 0
    : std::max<int>(this->LongestReplay, effect.replay.length);
  return 0;
}

int PadModel::Erase(const void* file, int id)
{
  const Lock lock(this->Guard);
  if (id < 0 || id >= this->GetSlots() || !this->Effects[static_cast<std::size_t>(id)].Owner)
  {
    return -EINVAL;
  }
  if (this->Effects[static_cast<std::size_t>(id)].Owner != file)
  {
    return -EACCES;
  }
  this->Playback(id, 0);
  this->Effects[static_cast<std::size_t>(id)].Owner = nullptr;
  return 0;
}

void PadModel::CloseFiles()
{
  const Lock lock(this->Guard);
  for (int id = 0; id < this->GetSlots(); ++id)
  {
    this->Erase(this->Effects[static_cast<std::size_t>(id)].Owner, id);
  }
  this->Holder = nullptr;
}

int PadModel::Write(const input_event& event)
{
  const Lock lock(this->Guard);
  if (event.type != EV_FF || !this->HasForce())
  {
    return 0;
  }
  if (event.code == FF_GAIN)
  {
    this->Gain = event.value;
    for (Effect& effect : this->Effects)
    {
      effect.Playing = false;
    }
    this->PlayEffects();
  }
  else if (event.code == FF_AUTOCENTER)
  {
    this->Autocentre = event.value;
  }
  else if (event.code < this->GetSlots() && this->Effects[event.code].Owner)
  {
    this->Playback(event.code, event.value);
  }
  return 0;
}

void PadModel::Playback(int id, int value)
{
  Effect& effect = this->Effects[static_cast<std::size_t>(id)];
  if (value > 0)
  {
    effect.Started = true;
    effect.Count = value;
    effect.PlayAt = this->Jiffies() + this->Ticks(effect.What.replay.delay);
    effect.StopAt = effect.PlayAt + this->Ticks(effect.What.replay.length);
  }
  else if (effect.Playing)
  {
    effect.Aborting = true;
  }
  else
  {
    effect.Started = false;
  }
  this->PlayEffects();
}

void PadModel::PlayEffects()
{
  const long now = this->Jiffies();
  bool hasAny = false;
  int strong = 0;
  int weak = 0;
  double x = 0.0;
  for (Effect& effect : this->Effects)
  {
    if (!effect.Started || now < effect.PlayAt)
    {
      continue;
    }
    hasAny = true;
    if (effect.Aborting)
    {
      effect.Aborting = effect.Playing = effect.Started = false;
    }
    else if (effect.What.replay.length != 0 && now >= effect.StopAt)
    {
      effect.Playing = false;
      effect.Started = --effect.Count > 0;
      effect.PlayAt = now + this->Ticks(effect.What.replay.delay);
      effect.StopAt = effect.PlayAt + this->Ticks(effect.What.replay.length);
    }
    else
    {
      effect.Playing = true;
      if (this->Model == Kind::Wheel)
      {
        const double angle = effect.What.direction * 2.0 * std::acos(-1.0) / 0x10000;
        x += std::sin(angle) * effect.What.u.constant.level / 256.0 * this->Gain / 0xFFFF;
        continue;
      }
      const auto scale = [this](__u16 speed)
      { return static_cast<int>(static_cast<long>(speed) * this->Gain / 0xFFFF); };
      strong = std::min(0xFFFF, strong + scale(effect.What.u.rumble.strong_magnitude));
      weak = std::min(0xFFFF, weak + scale(effect.What.u.rumble.weak_magnitude));
    }
  }
  if (hasAny && this->Model == Kind::Wheel)
  {
    this->Force = 0x80 + static_cast<int>(std::lround(std::clamp(x, -128.0, 127.0)));
  }
  // Motors get new speeds only when an effect begins, plays or ends.
  if (hasAny && (strong != this->Motors.Strong || weak != this->Motors.Weak))
  {
    this->Motors = { this->GetTime(), strong, weak };
    this->History.push_back(this->Motors);
  }
  this->Schedule();
}

void PadModel::Schedule()
{
  const long now = this->Jiffies();
  this->TimerAt = -1;
  for (const Effect& effect : this->Effects)
  {
    const long next =
      effect.Playing && effect.What.replay.length != 0 ? effect.StopAt : effect.PlayAt;
    if (effect.Started && next >= now && (this->TimerAt < 0 || next < this->TimerAt))
    {
      this->TimerAt = next;
    }
  }
  this->TimerAt = this->TimerAt == now ? now + 1 : this->TimerAt;
}

void PadModel::StepInAndOut()
{
  this->Step();
  this->Move(ABS_RY, static_cast<long>(this->GetTime() / 0.5) % 2 == 0 ? -1.0 : 1.0);
}

void PadModel::Step()
{
  const Lock lock(this->Guard);
  if (this->TimerAt >= 0 && this->Jiffies() >= this->TimerAt)
  {
    this->PlayEffects();
  }
  if (this->Model == Kind::Wheel)
  {
    // At full strength, the centring spring exerts the full force at the end of the axis.
    const double spring = -FullScale * this->Autocentre / 0xFFFF * this->Hand.Tip[0] / Travel;
    this->Hand.Step(1e-3, { this->ComputeForce() + spring, 0.0, 0.0 });
    this->Move(ABS_X, std::clamp(this->Hand.Tip[0] / Travel, -1.0, 1.0));
  }
}

double PadModel::ComputeForce() const
{
  return -FullScale * (this->Force - 0x80) / 127.0;
}

void PadModel::SetGoal(double right)
{
  const Lock lock(this->Guard);
  this->Hand.Goal[0] = right;
}

double PadModel::GetPlace()
{
  const Lock lock(this->Guard);
  return this->Hand.Tip[0];
}

double PadModel::GetForce()
{
  const Lock lock(this->Guard);
  return this->ComputeForce();
}

int PadModel::GetAutocentre()
{
  const Lock lock(this->Guard);
  return this->Autocentre;
}

PadModel::Change PadModel::GetMotors()
{
  const Lock lock(this->Guard);
  return this->Motors;
}

bool PadModel::IsStill()
{
  const Change motors = this->GetMotors();
  return motors.Strong == 0 && motors.Weak == 0;
}

std::vector<PadModel::Change> PadModel::GetHistory()
{
  const Lock lock(this->Guard);
  return this->History;
}

void PadModel::ForgetHistory()
{
  const Lock lock(this->Guard);
  this->History.clear();
}

int PadModel::CountEffects()
{
  const Lock lock(this->Guard);
  return static_cast<int>(std::count_if(this->Effects.begin(), this->Effects.end(),
    [](const Effect& effect) { return effect.Owner != nullptr; }));
}

int PadModel::GetLongestReplay()
{
  const Lock lock(this->Guard);
  return this->LongestReplay;
}

} // namespace emulated
