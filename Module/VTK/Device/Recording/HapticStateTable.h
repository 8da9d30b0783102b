// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes states of the servo as rows of a table, for displays.
 */
#ifndef HapticStateTable_h
#define HapticStateTable_h

#include "Core/Servo/ServoLoop.h"

#include "vtkNew.h"

#include <array>

class vtkDoubleArray;
class vtkTable;

namespace VolumeHaptics
{

/**
 * The values of a tick that displays need, in the device's space. A row has a tenth of the size of
 * a ServoSnapshot, because up to 86000 rows wait for a slow reader.
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
  /** Moves the columns to `table`, in place of its own. */
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

} // namespace VolumeHaptics

#endif
