// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/TickCollector.h"

#include "vtkDoubleArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace VolumeHaptics
{

StateRow::StateRow(const ServoSnapshot& state)
  : Tip(state.Record.Tip)
  , Proxy(state.Record.Proxy)
  , Force(state.Record.Force)
  , Command(state.Command)
  , Orientation(state.Orientation)
  , Time(state.Time)
  , NormalForce(state.Record.NormalForce)
  , FrictionForce(state.Record.FrictionForce)
  , DragForce(state.Record.DragForce)
  , SurfaceValue(state.Record.SurfaceValue)
  , Residency(state.Residency)
  , Tick(state.Tick)
  , Generation(state.Generation)
  , Contact(state.Record.Contact)
  , Fault(state.GetFault())
  , Armed(state.IsArmed())
  , HasOrientation(state.HasOrientation)
{
  std::transform(state.Modes.begin(), state.Modes.end(), this->ModeForces.begin(),
    [](const Vector3& force) { return static_cast<float>(Norm(force)); });
}

StateTable::StateTable()
{
  static const char* const scalars[] = { "Time", "Tick", "NormalForce", "FrictionForce",
    "DragForce", "SurfaceValue", "Contact", "Armed", "Fault", "Residency" };
  static const char* const vectors[] = { "Tip", "Proxy", "Force", "Command" };
  for (int i = 0; i < Scalars; ++i)
  {
    this->ScalarColumns[i]->SetName(scalars[i]);
  }
  for (int i = 0; i < Vectors; ++i)
  {
    this->VectorColumns[i]->SetName(vectors[i]);
    this->VectorColumns[i]->SetNumberOfComponents(3);
  }
  this->Orientations->SetName("Orientation");
  this->Orientations->SetNumberOfComponents(4);
  this->ModeForces->SetName("ModeForces");
  this->ModeForces->SetNumberOfComponents(MostPrimitives);
}

StateTable::~StateTable() = default;

void StateTable::Append(const StateRow& state, const Affine3& toWorld)
{
  const double scalars[Scalars] = { state.Time, static_cast<double>(state.Tick), state.NormalForce,
    state.FrictionForce, state.DragForce, state.SurfaceValue, static_cast<double>(state.Contact),
    state.Armed ? 1.0 : 0.0, static_cast<double>(state.Fault), state.Residency };
  const Matrix3 rotation = RotationOf(toWorld);
  const Vector3 vectors[Vectors] = { toWorld(state.Tip), toWorld(state.Proxy),
    rotation * state.Force, rotation * state.Command };
  for (int i = 0; i < Scalars; ++i)
  {
    this->ScalarColumns[i]->InsertNextValue(scalars[i]);
  }
  for (int i = 0; i < Vectors; ++i)
  {
    this->VectorColumns[i]->InsertNextTuple3(vectors[i].X, vectors[i].Y, vectors[i].Z);
  }
  const Quaternion q = TurnedBy(rotation, state.Orientation, state.HasOrientation);
  this->Orientations->InsertNextTuple4(q.W, q.X, q.Y, q.Z);
  this->ModeForces->InsertNextTuple(state.ModeForces.data());
}

void StateTable::WriteTo(vtkTable* table)
{
  table->Initialize();
  for (const auto& column : this->ScalarColumns)
  {
    table->AddColumn(column);
  }
  for (const auto& column : this->VectorColumns)
  {
    table->AddColumn(column);
  }
  table->AddColumn(this->Orientations);
  table->AddColumn(this->ModeForces);
}

void TickCollector::Drain()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  ServoSnapshot snapshot;
  while (this->Loop.Drain(snapshot))
  {
    if (this->Recording)
    {
      this->Recording->Append(snapshot);
    }
    if (!this->Readers.empty())
    {
      if (this->States.size() == MostStates)
      {
        this->States.pop_front();
        ++this->Forgotten;
      }
      this->States.emplace_back(snapshot);
    }
  }
  if (this->Recording)
  {
    this->Recording->SetMissed(this->Loop.GetLostRecords() - this->LostBefore);
  }
}

bool TickCollector::AwaitsOther(const TissueRemoval* removal)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Recording && this->Recording->IsAwaited() && removal &&
    removal != this->GetLatestRemoval();
}

void TickCollector::Publish(std::shared_ptr<const HapticModel> model)
{
  TissueRemoval* const removal = model ? model->Baked->Removal.get() : nullptr;
  if (this->AwaitsOther(removal))
  {
    // The recording may still wait for its first tick, which uses the present removal: collect it
    // now.
    this->Loop.KeepNothing();
    this->AwaitTick();
    this->Drain();
  }
  const bool isOther = this->AwaitsOther(removal);
  if (isOther)
  {
    if (TissueRemoval* const before = this->GetLatestRemoval())
    {
      (void)before->EndSnapshot();
    }
    removal->BeginSnapshot();
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const std::uint64_t generation = this->Loop.Publish(model);
  const PublishedTouch touch{ std::move(model), this->Loop.GetTool() };
  if (this->Recording)
  {
    this->Recording->AddModel(generation, touch.Model, touch.Tool);
  }
  this->Models[generation] = touch;
  if (isOther)
  {
    this->Loop.KeepTool();
  }
  // Drop old models here, so that they do not pile up when no reader requests states.
  for (auto& [id, reader] : this->Readers)
  {
    if (reader.Next < this->Forgotten && !this->States.empty())
    {
      const std::uint64_t first = this->States.front().Generation;
      reader.TakenGeneration = std::max(reader.TakenGeneration, first);
      reader.FirstUntaken = std::max(reader.FirstUntaken, first);
    }
  }
  this->Forget(this->Loop.GetWrittenGeneration());
}

void TickCollector::Forget(std::uint64_t generation)
{
  std::uint64_t first = generation;
  for (const auto& [id, reader] : this->Readers)
  {
    first = std::min(first, reader.FirstUntaken);
  }
  this->Models.erase(this->Models.begin(), this->Models.lower_bound(first));
}

void TickCollector::ForgetStates()
{
  std::uint64_t least = this->Forgotten + this->States.size();
  for (const auto& [id, reader] : this->Readers)
  {
    least = std::min(least, reader.Next);
  }
  for (; this->Forgotten < least; ++this->Forgotten)
  {
    this->States.pop_front();
  }
}

std::vector<StateRow> TickCollector::DrainStates(int id)
{
  if (this->Readers.count(id) == 0)
  {
    const std::uint64_t generation = this->Loop.GetWrittenGeneration();
    this->Drain(); // also collects the earlier states, which only other readers get
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Readers[id] = { this->Forgotten + this->States.size(), generation, generation };
    this->Loop.SetRecording(true);
  }
  this->Drain();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  Reader& reader = this->Readers[id];
  const std::uint64_t first = std::max(reader.Next, this->Forgotten) - this->Forgotten;
  std::vector<StateRow> states(
    this->States.begin() + static_cast<std::ptrdiff_t>(first), this->States.end());
  reader.Next = this->Forgotten + this->States.size();
  reader.FirstUntaken = reader.TakenGeneration;
  if (!states.empty())
  {
    reader.TakenGeneration = states.back().Generation;
  }
  this->ForgetStates();
  return states;
}

void TickCollector::StopTaking(int id)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Readers.erase(id);
  this->ForgetStates();
  this->Loop.SetRecording(this->Recording || !this->Readers.empty());
}

const HapticModel* TickCollector::FindModel(std::uint64_t generation)
{
  // States are requested in order, so older models are no longer needed.
  this->Forget(generation);
  const auto found = this->Models.find(generation);
  return found == this->Models.end() ? nullptr : found->second.Model.get();
}

void TickCollector::StartRecording(std::unique_ptr<HapticRecording> recording)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->LostBefore = this->Loop.GetLostRecords();
  for (const auto& [generation, touch] : this->Models)
  {
    recording->AddModel(generation, touch.Model, touch.Tool);
  }
  if (TissueRemoval* const removal = this->GetLatestRemoval())
  {
    removal->BeginSnapshot();
  }
  this->Recording = std::move(recording);
  this->Loop.SetRecording(true);
  this->Loop.KeepTool(); // call this last, so that the tick that keeps the tool reaches the
                         // recording
}

void TickCollector::AwaitTick() const
{
  const std::uint64_t last = this->Loop.GetTickCount();
  for (int i = 0; i < 100 && this->Loop.GetTickCount() == last; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void TickCollector::PollRecording()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  TissueRemoval* const removal = this->GetLatestRemoval();
  if (this->Recording && this->Recording->IsAwaited() && removal && !this->Loop.IsKeepWanted() &&
    removal->IsSnapshotLate())
  {
    removal->BeginSnapshot();
    this->Loop.KeepTool();
  }
}

TissueRemoval* TickCollector::GetLatestRemoval() const
{
  const HapticModel* const model =
    this->Models.empty() ? nullptr : this->Models.rbegin()->second.Model.get();
  return model ? model->Baked->Removal.get() : nullptr;
}

std::unique_ptr<HapticRecording> TickCollector::StopRecording()
{
  this->Loop.SetRecording(!this->Readers.empty());
  this->Loop.KeepNothing();
  // Wait for the tick in progress, which belongs to the recording, too.
  this->AwaitTick();
  this->Drain();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Recording);
}

} // namespace VolumeHaptics
