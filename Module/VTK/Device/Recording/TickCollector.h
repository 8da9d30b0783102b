// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects the ticks of a servo loop for a recording and for displays, with their models. Also
 * writes states as rows of a table.
 */
#ifndef TickCollector_h
#define TickCollector_h

#include "Core/Servo/ServoLoop.h"
#include "VTK/Device/Recording/HapticRecording.h"

#include "vtkNew.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

class vtkDoubleArray;
class vtkTable;

namespace VolumeHaptics
{

/**
 * Values of a tick that displays need, in the device's space. A row has a tenth of the size of a
 * ServoSnapshot, since up to 86000 rows wait for a slow reader.
 */
struct StateRow
{
  explicit StateRow(const ServoSnapshot& state);

  Vector3 Tip;
  Vector3 Proxy;
  Vector3 Force;
  Vector3 Command;
  Quaternion Orientation;
  double Time;
  double NormalForce;
  double FrictionForce;
  double DragForce;
  double SurfaceValue;
  double Residency;
  std::array<float, MostPrimitives> ModeForces; ///< N, magnitudes
  std::uint64_t Tick;
  std::uint64_t Generation;
  ContactState Contact;
  GateReason Fault;
  bool Armed;
  bool HasOrientation;
};

/** A table of states, with the columns that vtkHapticState::Drain documents. */
class StateTable
{
public:
  StateTable();
  ~StateTable();
  StateTable(const StateTable&) = delete;
  StateTable& operator=(const StateTable&) = delete;

  void Append(const StateRow& state, const Affine3& toWorld);
  /** Moves the columns into `table`, replacing its columns. */
  void WriteTo(vtkTable* table);

private:
  enum Scalar
  {
    Time,
    Tick,
    NormalForce,
    FrictionForce,
    DragForce,
    SurfaceValue,
    Contact,
    Armed,
    Fault,
    Residency,
    Scalars
  };
  enum Vector
  {
    Tip,
    Proxy,
    Force,
    Command,
    Vectors
  };
  vtkNew<vtkDoubleArray> ScalarColumns[Scalars];
  vtkNew<vtkDoubleArray> VectorColumns[Vectors];
  vtkNew<vtkDoubleArray> Orientations;
  vtkNew<vtkDoubleArray> ModeForces;
};

/**
 * Collects the ticks of a servo loop. Call all functions on the owner's thread; the keeper thread
 * may also call Drain.
 */
class TickCollector
{
public:
  /** Collects the ticks of a loop, which must outlive this object. */
  explicit TickCollector(ServoLoop& loop)
    : Loop(loop)
  {
  }

  /** Publishes a model to the loop, and keeps it while a state of its ticks may still be read. */
  void Publish(std::shared_ptr<const HapticModel> model);
  /** Returns the last published model; null before the first one. */
  const HapticModel* GetLatestModel() const
  {
    return this->Models.empty() ? nullptr : this->Models.rbegin()->second.Model.get();
  }
  /** Returns whether the loop already uses the last published model. */
  bool IsLatestUsed() const
  {
    return !this->Models.empty() && this->Loop.GetAcknowledged() >= this->Models.rbegin()->first;
  }
  /**
   * Returns the model of a generation, while the owner may still read a state of it. Returns null
   * before the first model.
   */
  const HapticModel* FindModel(std::uint64_t generation);

  ///@{
  /** Adds ticks to a recording that has begun, until StopRecording returns it. */
  void StartRecording(std::unique_ptr<HapticRecording> recording);
  std::unique_ptr<HapticRecording> StopRecording();
  /** Checks whether a recording needs a copy of the removed tissue; call this now and then. */
  void PollRecording();
  bool IsRecording() const { return this->Recording != nullptr; }
  /** Sets the hashes of the recording in progress: see HapticRecording::SetHashes. */
  void SetRecordingHashes(const RecordingHashes& hashes) { this->Recording->SetHashes(hashes); }
  /** Returns why the recording has failed; empty if it has not. */
  std::string GetRecordingTrouble() const
  {
    return this->Recording ? this->Recording->GetTrouble() : std::string();
  }
  ///@}

  ///@{
  /**
   * Returns all states since a reader's last call, oldest first, so that a display misses none.
   * States are kept from the first call until StopTaking. Each reader gets all states. A reader
   * that does not call for MostStates ticks loses its oldest states.
   */
  std::vector<StateRow> DrainStates(int reader);
  void StopTaking(int reader);
  ///@}
  static constexpr std::size_t MostStates = 86000; // 20 MB

  /** Collects all ticks that the loop has produced. */
  void Drain();

private:
  /**
   * Returns whether a recording waits for its first tick with a removal that differs from this one.
   */
  bool AwaitsOther(const TissueRemoval* removal);
  /** Returns the removal of the last published model; null if it removes nothing. */
  TissueRemoval* GetLatestRemoval() const;
  /** Waits at most 0.1 s for the end of the tick in progress. */
  void AwaitTick() const;
  /** Drops the states that all readers have received. Call this with the mutex locked. */
  void ForgetStates();
  /** Drops the models of older generations, which no reader can request any more. */
  void Forget(std::uint64_t generation);

  ServoLoop& Loop;
  std::mutex Mutex; // for the owner and the keeper thread; the loop never locks it
  std::unique_ptr<HapticRecording> Recording;
  std::uint64_t LostBefore = 0; // number of lost ticks when the recording began
  struct Reader
  {
    std::uint64_t Next = 0;            // index of the first state that the reader has not received
    std::uint64_t TakenGeneration = 0; // generation of the last state received
    std::uint64_t FirstUntaken = 0;    // lower bound of the generations of states not yet received
  };
  std::map<int, Reader> Readers; // modified by the owner only, under the mutex
  std::deque<StateRow> States;
  std::uint64_t Forgotten = 0; // number of states that were dropped so far
  /** Used by the owner: models by generation. The first one belongs to the last state requested. */
  std::map<std::uint64_t, PublishedTouch> Models;
};

} // namespace VolumeHaptics

#endif
