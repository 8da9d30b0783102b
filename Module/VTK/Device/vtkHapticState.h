// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticState
 * @brief   the latest state of a device: tip, proxy, forces and contact
 *
 * Has the values of the latest servo tick of a vtkHapticDevice, as of the last UpdateState:
 *
 *   vtkHapticState* state = device->GetState();
 *   ... in the GUI's timer ...
 *   if (device->UpdateState())
 *   {
 *     cursor->SetPosition(state->GetProxyPosition());
 *     label->SetInput(std::to_string(vtkMath::Norm(state->GetForce())).c_str());
 *   }
 *
 * All getters return values of the same tick. Positions are in world units and forces in newtons
 * along the world's axes, unless stated. When the device is deleted, the state keeps its last
 * values.
 *
 * @sa vtkHapticDevice, vtkHapticRepresentation
 */
#ifndef vtkHapticState_h
#define vtkHapticState_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPolyData;
class vtkTable;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
class DeviceSession;
struct DeviceParts;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticState : public vtkObject
{
public:
  static vtkHapticState* New();
  vtkTypeMacro(vtkHapticState, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Get the latest positions of tip and proxy (world), the force sent to the device, and the
   * computed force (N, world axes).
   */
  vtkGetVector3Macro(TipPosition, double);
  vtkGetVector3Macro(ProxyPosition, double);
  vtkGetVector3Macro(Force, double);
  vtkGetVector3Macro(ComputedForce, double);
  ///@}
  ///@{
  /**
   * Get, in the latest state, the torque of a tool that has a shape (vtkHapticPointShell) on the
   * hand about the tip (N m, world axes), as sent and as computed, and the orientation of the tool,
   * whose origin is the proxy: a unit quaternion (w, x, y, z) that rotates the world's axes to the
   * tool's. All are zeros without such a tool; the head of a vtkHapticBurr does not rotate, and
   * causes no torque. No torque is sent to a device that can't render it.
   */
  vtkGetVector3Macro(Torque, double);
  vtkGetVector3Macro(ComputedTorque, double);
  vtkGetVector4Macro(ToolOrientation, double);
  ///@}
  ///@{
  /**
   * Get the orientation of the stylus in the latest state, if the device measures one. It is a unit
   * quaternion (w, x, y, z, as in vtkQuaternion) that rotates the world's axes to the stylus's: the
   * stylus points along its -z, its handle is on the side of +z, and its button on the side of +y.
   * HasTipOrientation is false, and the quaternion (1, 0, 0, 0), if the device measures none or its
   * quaternion is not finite or not of unit norm within 1 %, unless
   * vtkHapticVirtualHand::SetToolOrientation turns it. The forces of tools depend on it.
   */
  vtkGetVector4Macro(TipOrientation, double);
  bool HasTipOrientation() { return this->IsOriented; }
  ///@}
  /** Get whether, in the latest state, the device itself measures the orientation of its stylus. */
  bool IsTipOrientationMeasured() { return this->IsMeasured; }
  /**
   * Get whether a vtkHapticBurr spins in the latest state, because of
   * vtkHapticVirtualHand::SetSpinning or its button.
   */
  bool IsSpinning() { return this->Spins; }
  vtkGetMacro(Buttons, int); ///< Get the buttons in the latest state: bit 0 is the main button.
  /**
   * Get the rate (rad/s, device axes) at which a SpaceMouse turns the volume in the latest state.
   */
  vtkGetVector3Macro(TurnRate, double);
  /** Get the contact in the latest state: 0 free, 1 sticking, 2 sliding, 3 penetrating. */
  vtkGetMacro(Contact, int);
  ///@{
  /**
   * Get, in the latest state, the value V(x_s) inside the surface, and the parts of the force (N)
   * that come from the surface, friction and the medium.
   */
  vtkGetMacro(SurfaceValue, double);
  vtkGetMacro(NormalForce, double);
  vtkGetMacro(FrictionForce, double);
  vtkGetMacro(DragForce, double);
  ///@}
  /**
   * Get, in the latest state, the part of the distance between tip and proxy (world) that causes no
   * force. With the solver PRECISE, a spring that gets stiffer under a resting hand gets slack
   * instead of more force; 0 otherwise.
   */
  vtkGetMacro(Slack, double);
  /**
   * Get, in the latest state, the force of a mode of PRIMITIVES on the hand (N, world axes), before
   * MaximumForce; zero for other methods and for a mode that does not exist. The index counts from
   * 0 as in the filter's GetMode.
   */
  double* GetModeForce(int mode) VTK_SIZEHINT(3);

  /**
   * Write the shapes on which the felt modes hold the hand, at the proxy of the latest state: lines
   * such as a flow line, up to `reach` voxels to either side, and fronts as polygons with a radius
   * of a quarter of `reach`, with point normals to the free side. A mode about tensors also gives a
   * vertex at the proxy with the tensor as point tensors, whose first eigenvalue is scaled to an
   * eighth of `reach`, for vtkTensorGlyph. The shapes come from the data that the servo reads, in
   * world units. The cell array Mode has the number of the mode. Empty for other methods.
   */
  void GetFollowed(vtkPolyData* shapes, double reach = 32.0);

  /**
   * Write the track of a vtkHapticNeedle in the hand through tissue (world): a line for each
   * stretch of one label, from the entry to the tip. Point array Depth (world units), cell arrays
   * Label and Length (world units). Field arrays, one number each: Depth and Deepest (world units),
   * Angle to the normal of the surface at the entry (degrees; -1 without one), ShaftForce (N), and
   * ForbiddenTouches, how often a forbidden label stopped this insertion. Without a needle in
   * tissue there are no lines. vtkXMLPolyDataWriter exports the track. Check for free space before:
   * on a full disk it writes only part of the file, and Write() may still return 1.
   */
  void GetNeedleTrack(vtkPolyData* track);

  /** Parts of the geometry from GetGeometry, as in its cell array Part. */
  enum PartType
  {
    TIP = 0,
    PROXY = 1,
    SURFACE_POSITION = 2, ///< x_s
    MEDIUM_POSITION = 3,  ///< x_v
    SPRING = 4,           ///< line from the tip to the proxy
    FORCE = 5,            ///< line from the tip along the force on the hand
    NORMAL_FORCE = 6,     ///< line from the proxy along the force of the surface
    FRICTION_FORCE = 7    ///< line from the proxy along the friction of the surface
  };

  /**
   * Get the latest state as plain cells for any mapper or writer: vertices for the tip, the proxy
   * and the positions x_s and x_v at which the materials were read, and lines for the spring and
   * the forces. The cell array Part identifies them (see PartType); Newtons is the size of a force
   * (N). Lines begin at the point on which a force acts and are Newtons / forceScale world units
   * long. `commanded` chooses the force that went to the device instead of the computed one. The
   * field arrays Contact, SurfaceValue and Orientation (w, x, y, z; all 0 if the device has none)
   * have values of the state. Empty before the first state.
   */
  void GetGeometry(vtkPolyData* geometry, double forceScale = 0.1, bool commanded = false);

  /**
   * Get the depth (world units) to which a vtkHapticNeedle is inserted in the latest state; 0 if it
   * is not inserted.
   */
  double GetNeedleDepth();

  /**
   * Get the label just inside the surface in the latest state, that is, at the proxy plus r times
   * the normal; 0 if the filter has no label image, or there is no label. vtkHapticLabelTable has
   * its name.
   */
  vtkGetMacro(Label, vtkTypeInt64);
  /**
   * Get whether, in the latest state, the wall in front of a forbidden label holds the tip back.
   * When this begins, vtkHapticDevice::UpdateState invokes vtkCommand::UserEvent.
   */
  bool IsAtForbiddenLabel() { return this->IsHeldAtLabel; }
  ///@{
  /**
   * Get, in the latest state (world), the unit normal inwards, and the positions x_s and x_v at
   * which the materials were read (fig. 4).
   */
  vtkGetVector3Macro(Normal, double);
  vtkGetVector3Macro(SurfacePosition, double);
  vtkGetVector3Macro(MediumPosition, double);
  ///@}
  /**
   * Get the fraction of the force, 0 to 1, that is felt in the latest state. It decreases where
   * data around the tip are missing (vtkHapticRegionFilter), after FadeOut or AttentionTime, and
   * during long work. It takes at least 50 ms from 1 to 0 and back. The ramp after Arm is not
   * included.
   */
  vtkGetMacro(Residency, double);
  /** Get the number of the latest state since Start, and its time (s). */
  vtkGetMacro(Tick, vtkIdType);
  vtkGetMacro(Time, double);

  /**
   * Write all states since the last call, oldest first, as rows of a table that is overwritten. Its
   * columns are Time (s), Tick, NormalForce, FrictionForce, DragForce (N), SurfaceValue, Contact,
   * Armed, Fault, Residency, with three components Tip, Proxy (world), Force (computed) and Command
   * (sent; N, world axes), with four Orientation (world; w, x, y, z; all 0 if the device has none),
   * and with eight ModeForces (N, magnitudes of GetModeForce). States are kept from the first call
   * on; a reader that does not call for 86000 ticks loses the oldest. Each reader has a number, and
   * gets all states; a call with nullptr as the table ends the reading. The first
   * vtkInteractorStyleHaptic of a device has number 0, further ones have -1, -2 and so on: see
   * AddReader.
   */
  void Drain(vtkTable* states, int reader = 0);

  ///@{
  /**
   * Reserve a number for Drain: 0, or -1, -2 and so on if it is already reserved. RemoveReader
   * releases the number and ends the reading. Applications may use numbers above 0 without
   * reserving them.
   */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

protected:
  vtkHapticState() = default;
  ~vtkHapticState() override = default;

  double TipPosition[3] = { 0.0, 0.0, 0.0 };
  double ProxyPosition[3] = { 0.0, 0.0, 0.0 };
  double Force[3] = { 0.0, 0.0, 0.0 };
  double ComputedForce[3] = { 0.0, 0.0, 0.0 };
  double Torque[3] = { 0.0, 0.0, 0.0 };
  double ComputedTorque[3] = { 0.0, 0.0, 0.0 };
  double ToolOrientation[4] = { 0.0, 0.0, 0.0, 0.0 };
  double TipOrientation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double TurnRate[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 0.0 };
  double SurfacePosition[3] = { 0.0, 0.0, 0.0 };
  double MediumPosition[3] = { 0.0, 0.0, 0.0 };
  double ModeForces[9][3] = {}; // forces of at most eight modes; the ninth row stays zero for
                                // invalid numbers
  bool IsOriented = false;
  bool IsMeasured = false;
  bool Spins = false;
  bool IsHeldAtLabel = false;
  int Buttons = 0;
  int Contact = 0;
  double SurfaceValue = 0.0;
  double NormalForce = 0.0;
  double FrictionForce = 0.0;
  double DragForce = 0.0;
  double Slack = 0.0;
  vtkTypeInt64 Label = 0;
  double Residency = 1.0;
  vtkIdType Tick = 0;
  double Time = 0.0;

private:
#ifndef __VTK_WRAP__
  friend class VolumeHaptics::DeviceSession; // sets the state
  friend struct VolumeHaptics::DeviceParts;
  VolumeHaptics::DeviceParts* Parts = nullptr; // null without a device
#endif

  vtkHapticState(const vtkHapticState&) = delete;
  void operator=(const vtkHapticState&) = delete;
};

#endif
