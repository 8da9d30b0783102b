// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/WindowDock.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Largest fraction of the remaining window that a dock may occupy, so that the scene stays visible.
 */
constexpr double MostOfRest = 0.9;

} // namespace

/** Arranges the viewports of a window with docks. */
class DockLayout
{
public:
  /** Returns the layout of a window, which all of its docks share. */
  static std::shared_ptr<DockLayout> Of(vtkRenderWindow* window);

  explicit DockLayout(vtkRenderWindow* window)
    : Window(window)
  {
  }

  vtkRenderWindow* GetWindow() const { return this->Window; }
  /** Places the strip of a dock, which is identified by its address. */
  void Place(
    const WindowDock* dock, DockEdge edge, double fraction, const std::vector<vtkRenderer*>& strip);
  /** Places the bar of a dock along the top, above all strips. */
  void PlaceBar(const WindowDock* dock, double fraction, vtkRenderer* over);
  void Remove(const WindowDock* dock);

private:
  using Viewport = std::array<double, 4>; ///< left, bottom, right, top

  struct Strip
  {
    const WindowDock* Dock;
    DockEdge Edge;
    double Fraction;
    std::vector<vtkWeakPointer<vtkRenderer>> Renderers;
    bool IsBar = false; ///< whether it is a bar, whose renderer covers the whole window
  };
  struct Narrowed
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    Viewport Before;
    Viewport Now;
  };

  static Viewport ViewportOf(vtkRenderer* renderer);
  /** Cuts a strip off the remaining window `left`, and returns the strip's viewport. */
  static Viewport CutOff(const Strip& strip, Viewport& left);
  bool IsInStrip(vtkRenderer* renderer) const;
  void Arrange();
  void Narrow(vtkRenderer* renderer, const Viewport& left);

  vtkWeakPointer<vtkRenderWindow> Window;
  std::vector<Strip> Strips; ///< strips in the order of their placement
  std::vector<Narrowed> Others;
};

//------------------------------------------------------------------------------
std::shared_ptr<DockLayout> DockLayout::Of(vtkRenderWindow* window)
{
  // A static list without a lock is safe, because all windows belong to one thread.
  static std::vector<std::weak_ptr<DockLayout>> all;
  std::shared_ptr<DockLayout> found;
  for (auto it = all.begin(); it != all.end();)
  {
    const std::shared_ptr<DockLayout> layout = it->lock();
    found = layout && layout->GetWindow() == window ? layout : found;
    it = layout ? it + 1 : all.erase(it);
  }
  if (!found)
  {
    found = std::make_shared<DockLayout>(window);
    all.emplace_back(found);
  }
  return found;
}

//------------------------------------------------------------------------------
void DockLayout::Place(
  const WindowDock* dock, DockEdge edge, double fraction, const std::vector<vtkRenderer*>& strip)
{
  const auto known = std::find_if(this->Strips.begin(), this->Strips.end(),
    [dock](const Strip& one) { return one.Dock == dock; });
  Strip& placed = known != this->Strips.end() ? *known : this->Strips.emplace_back();
  placed = { dock, edge, fraction, { strip.begin(), strip.end() } };
  this->Arrange();
}

//------------------------------------------------------------------------------
void DockLayout::PlaceBar(const WindowDock* dock, double fraction, vtkRenderer* over)
{
  const bool isPlaced = !this->Strips.empty() && this->Strips.front().Dock == dock;
  if (!isPlaced)
  {
    this->Strips.insert(this->Strips.begin(), Strip{});
  }
  this->Strips.front() = { dock, DockEdge::Top, fraction, { over }, true };
  this->Arrange();
}

//------------------------------------------------------------------------------
void DockLayout::Remove(const WindowDock* dock)
{
  this->Strips.erase(std::remove_if(this->Strips.begin(), this->Strips.end(),
                       [dock](const Strip& one) { return one.Dock == dock; }),
    this->Strips.end());
  if (!this->Strips.empty())
  {
    this->Arrange();
    return;
  }
  for (Narrowed& one : this->Others)
  {
    if (one.Renderer && ViewportOf(one.Renderer) == one.Now)
    {
      one.Renderer->SetViewport(one.Before.data());
    }
  }
  this->Others.clear();
}

//------------------------------------------------------------------------------
DockLayout::Viewport DockLayout::ViewportOf(vtkRenderer* renderer)
{
  Viewport viewport;
  renderer->GetViewport(viewport.data());
  return viewport;
}

//------------------------------------------------------------------------------
DockLayout::Viewport DockLayout::CutOff(const Strip& strip, Viewport& left)
{
  const int low = IsColumn(strip.Edge) ? 0 : 1; // index of the left or bottom coordinate; the
                                                // opposite one is 2 entries later
  const int high = low + 2;
  const double size = std::min(strip.Fraction, MostOfRest * (left[high] - left[low]));
  Viewport taken = left;
  if (IsLow(strip.Edge))
  {
    taken[high] = left[low] + size;
    left[low] = taken[high];
  }
  else
  {
    taken[low] = left[high] - size;
    left[high] = taken[low];
  }
  return taken;
}

//------------------------------------------------------------------------------
bool DockLayout::IsInStrip(vtkRenderer* renderer) const
{
  return std::any_of(this->Strips.begin(), this->Strips.end(),
    [renderer](const Strip& strip)
    {
      return std::find(strip.Renderers.begin(), strip.Renderers.end(), renderer) !=
        strip.Renderers.end();
    });
}

//------------------------------------------------------------------------------
void DockLayout::Arrange()
{
  if (!this->Window)
  {
    return;
  }
  Viewport left{ { 0.0, 0.0, 1.0, 1.0 } };
  for (const Strip& strip : this->Strips)
  {
    const Viewport taken = CutOff(strip, left);
    const auto parts = static_cast<double>(strip.Renderers.size());
    for (std::size_t i = 0; i < strip.Renderers.size(); ++i)
    {
      const auto at = static_cast<double>(i);
      Viewport wanted = strip.IsBar ? Viewport{ { 0.0, 0.0, 1.0, 1.0 } } : taken;
      if (strip.IsBar)
      {
        // A bar takes no space from the others, because its renderer draws over them.
      }
      else if (IsColumn(strip.Edge))
      {
        wanted[1] = taken[1] + (parts - 1.0 - at) / parts * (taken[3] - taken[1]);
        wanted[3] = taken[1] + (parts - at) / parts * (taken[3] - taken[1]);
      }
      else
      {
        wanted[0] = taken[0] + at / parts * (taken[2] - taken[0]);
        wanted[2] = taken[0] + (at + 1.0) / parts * (taken[2] - taken[0]);
      }
      if (strip.Renderers[i] && ViewportOf(strip.Renderers[i]) != wanted)
      {
        strip.Renderers[i]->SetViewport(wanted.data());
      }
    }
  }
  vtkRendererCollection* const renderers = this->Window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
  {
    if (!this->IsInStrip(renderer))
    {
      this->Narrow(renderer, left);
    }
  }
}

//------------------------------------------------------------------------------
void DockLayout::Narrow(vtkRenderer* renderer, const Viewport& left)
{
  const auto known = std::find_if(this->Others.begin(), this->Others.end(),
    [renderer](const Narrowed& one) { return one.Renderer == renderer; });
  const bool isKnown = known != this->Others.end();
  Narrowed& one = isKnown ? *known : this->Others.emplace_back();
  const Viewport viewport = ViewportOf(renderer);
  if (!isKnown || viewport != one.Now)
  {
    one.Renderer = renderer;
    one.Before = viewport;
  }
  const double width = left[2] - left[0];
  const double height = left[3] - left[1];
  one.Now = { left[0] + width * one.Before[0], left[1] + height * one.Before[1],
    left[0] + width * one.Before[2], left[1] + height * one.Before[3] };
  if (viewport != one.Now)
  {
    renderer->SetViewport(one.Now.data());
  }
}

void WindowDock::Enter(vtkRenderWindow* window)
{
  if (this->Layout && this->Layout->GetWindow() != window)
  {
    this->GiveBack();
  }
  if (!this->Layout)
  {
    this->Layout = DockLayout::Of(window);
  }
}

void WindowDock::Place(
  vtkRenderWindow* window, DockEdge edge, double fraction, const std::vector<vtkRenderer*>& strip)
{
  this->Enter(window);
  this->Layout->Place(this, edge, fraction, strip);
}

void WindowDock::PlaceBar(vtkRenderWindow* window, double fraction, vtkRenderer* over)
{
  this->Enter(window);
  this->Layout->PlaceBar(this, fraction, over);
}

void WindowDock::GiveBack()
{
  if (this->Layout)
  {
    this->Layout->Remove(this);
    this->Layout = nullptr;
  }
}

} // namespace VolumeHaptics
