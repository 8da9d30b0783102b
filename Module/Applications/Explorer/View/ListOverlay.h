// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ListOverlay_h
#define Explore_ListOverlay_h

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <string>
#include <vector>

namespace Explore
{
/// A list over the scene, in which the user marks a line to choose a file or a series.
class ListOverlay
{
public:
  explicit ListOverlay(vtkRenderer* overlay);
  ~ListOverlay();
  ListOverlay(const ListOverlay&) = delete;
  ListOverlay& operator=(const ListOverlay&) = delete;

  /// Shows the lines, with the line of index `marked` highlighted.
  void Show(const std::string& title, const std::vector<std::string>& lines, int marked);
  void Hide();
  bool IsShown() const;
  /// Moves the mark up (negative) or down, without leaving the list.
  void Move(int lines);
  int GetMarked() const { return this->Marked; }
  /// Returns the index of the line at a position (pixels); -1 if there is none.
  int Find(int x, int y) const;

private:
  void Write();

  vtkRenderer* const Overlay;
  vtkNew<vtkTextActor> Text;
  std::string Title;
  std::vector<std::string> Lines;
  int Marked = 0;
  int First = 0; ///< index of the first visible line
  int Seen = 0;  ///< number of visible lines
};
} // namespace Explore

#endif
