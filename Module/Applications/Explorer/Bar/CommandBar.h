// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_CommandBar_h
#define Explore_CommandBar_h

#include "Applications/Explorer/Bar/CommandTable.h"
#include "VTK/Scene/Base/WindowDock.h"

#include "vtkCallbackCommand.h"
#include "vtkContextActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextProperty.h"

#include <array>
#include <string>
#include <vector>

class vtkContext2D;

namespace Explore
{
/// A bar with buttons along the top of a window, with a hint for the button under the pointer. Its
/// buttons open a menu for each group of commands, and a menu of all commands. The scene occupies
/// the rest of the window, below the bar.
class CommandBar
{
public:
  CommandBar(
    CommandTable& commands, vtkRenderWindow* window, vtkRenderWindowInteractor* interactor);
  ~CommandBar();
  CommandBar(const CommandBar&) = delete;
  CommandBar& operator=(const CommandBar&) = delete;

  /// Draws the bar. The context item calls this in each frame.
  bool Paint(vtkContext2D* painter);

private:
  struct Box
  {
    float Left = 0.0f, Bottom = 0.0f, Width = 0.0f, Height = 0.0f; // pixels
    bool Contains(int x, int y) const;
  };
  struct Button
  {
    Icon Picture;
    std::string Label; // below the icon, if there is room
    Box Place;
    bool IsOn = false;
    bool IsUsable = true;
  };
  struct Row
  {
    std::string Text;
    std::string Key;
    bool IsTitle = false;
    bool IsOn = false;
    Command What;
    Box Place; // empty if the row is not visible
  };

  void Dock();
  bool Handle(unsigned long event);
  void Activate(const Button& button);
  void OpenMenu(const std::string& group, const Button& from);
  void CloseMenu();
  /// Closes the menu without drawing. Called before each command.
  void HideMenu();
  /// Draws the scene after HideMenu().
  void EndMenu();
  void Scroll(int rows);
  void PointAt(int x, int y);
  int FindButton(int x, int y) const;
  int FindRow(int x, int y) const;

  void UpdateButtons();
  void MeasureLabels();
  void LayOut();
  void DrawButtons(vtkContext2D* painter);
  void DrawPicture();
  /// Chooses the largest font size with which the menu fits.
  void LayOutMenu();
  bool LayOutMenu(int letters);
  void DrawMenu(vtkContext2D* painter);
  void DrawTip(vtkContext2D* painter);
  std::string DescribeButton(const Button& button, std::string& key) const;
  void SetLetters(vtkContext2D* painter, double points, const RGB& colour, bool isBold) const;
  /// Measures without drawing: input may abort a frame before the bar is drawn, and the next click
  /// still needs the positions of the buttons.
  float MeasureWidth(const std::string& text, double points, bool isBold) const;
  float ToPixels(double points) const;

  CommandTable& All;
  const vtkSmartPointer<vtkRenderWindow> Window;
  const vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkContextActor> Actor;
  VolumeHaptics::WindowDock Strip;
  bool IsShown = true;
  std::vector<Button> Buttons;
  int Pointed = -1; ///< index of the button under the pointer
  float Height = 0.0f;
  bool HasLabels = true;
  std::vector<float> LabelWidths; ///< label widths at the current scale
  double LabelScale = 0.0;
  std::string Drawn; ///< content of the bar as last drawn, for comparison
  vtkNew<vtkImageData> Picture;

  std::vector<Row> Rows; ///< rows of the open menu
  bool IsMenuOpen = false;
  bool IsEndDue = false; ///< whether EndMenu() has to follow
  Icon Opener = Icon::None;
  float MenuLeft = 0.0f; ///< wanted left end
  int First = 0;         ///< first visible row
  int Visible = 0;       ///< number of visible rows
  int PointedRow = -1;
  int Letters = 11; ///< points
  Box Menu;
  vtkNew<vtkTextProperty> Measured; ///< text properties used for measuring

  // each for the left, the middle and the right button
  std::array<bool, 3> HasPress{}; ///< whether the bar also handles the release of this button
  std::array<bool, 3> IsDown{}; ///< whether this button was pressed in the scene and is still down
  vtkNew<vtkCallbackCommand> ReleaseObserver;
  vtkNew<vtkCallbackCommand> MouseObserver;
  vtkNew<vtkCallbackCommand> FrameObserver;
};
} // namespace Explore

#endif
