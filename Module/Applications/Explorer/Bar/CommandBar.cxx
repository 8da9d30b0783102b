// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Bar/CommandBar.h"

#include "Applications/Explorer/View/PaintedItem.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextScene.h"
#include "vtkPen.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{
using Explore::RGB;

constexpr RGB GROUND{ 0.09, 0.11, 0.15 }; // background of bar and menus
constexpr RGB LIT{ 0.19, 0.23, 0.31 };    // background of the item under the pointer
constexpr RGB CHOSEN{ 0.16, 0.36, 0.60 }; // background of commands that are switched on
constexpr RGB INK{ 0.90, 0.92, 0.95 };
constexpr RGB FAINT{ 0.58, 0.63, 0.70 };
constexpr RGB UNUSABLE{ 0.36, 0.40, 0.46 };
constexpr RGB RED{ 0.95, 0.35, 0.32 };
constexpr RGB TITLE{ 1.0, 0.78, 0.35 };

// Lengths in points.
constexpr double BUTTON = 32.0;   // height of a button without a label, and its minimum width
constexpr double SMALLEST = 18.0; // minimum width of a button in a small window
constexpr double ICON = 20.0;
constexpr double LABEL_LETTERS = 8.0;
constexpr double LABEL_HEIGHT = 11.0;
constexpr double LABEL_GAP = 5.0;   // margin on both sides of a label
constexpr double GAP = 8.0;         // between groups of buttons
constexpr double PADDING = 8.0;     // margin around a menu and a hint
constexpr int LARGEST_LETTERS = 11; // largest font size of menus
constexpr int SMALLEST_LETTERS = 7;
constexpr float BAR_PRIORITY = 20.0f; // receives events before everything else in the window

constexpr unsigned long BAR_EVENTS[] = { vtkCommand::MouseMoveEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonDoubleClickEvent,
  vtkCommand::LeftButtonReleaseEvent, vtkCommand::RightButtonPressEvent,
  vtkCommand::RightButtonReleaseEvent, vtkCommand::MiddleButtonPressEvent,
  vtkCommand::MiddleButtonReleaseEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent, vtkCommand::LeaveEvent,
  vtkCommand::TimerEvent };

/// Returns the index of an event's mouse button: 0 left, 1 middle, 2 right.
std::size_t FindMouseButton(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::MiddleButtonPressEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
      return 1;
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::RightButtonReleaseEvent:
      return 2;
    default:
      return 0;
  }
}

unsigned char ToByte(double part)
{
  return static_cast<unsigned char>(std::lround(255.0 * part));
}

std::string BeginUpper(std::string text)
{
  if (!text.empty())
  {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

void Fill(vtkImageData* image, int left, int bottom, int width, int height, const RGB& colour)
{
  const int* const size = image->GetDimensions();
  for (int y = std::max(0, bottom); y < std::min(size[1], bottom + height); ++y)
  {
    for (int x = std::max(0, left); x < std::min(size[0], left + width); ++x)
    {
      auto* const pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixel[c] = ToByte(colour[c]);
      }
    }
  }
}

} // namespace

namespace Explore
{
bool CommandBar::Box::Contains(int x, int y) const
{
  return static_cast<float>(x) >= this->Left && static_cast<float>(x) < this->Left + this->Width &&
    static_cast<float>(y) >= this->Bottom && static_cast<float>(y) < this->Bottom + this->Height;
}

CommandBar::CommandBar(
  CommandTable& commands, vtkRenderWindow* window, vtkRenderWindowInteractor* interactor)
  : All(commands)
  , Window(window)
  , Interactor(interactor)
{
  this->Buttons = { { Icon::Menu, "Menu", {} }, { Icon::Open, "File", {} },
    { Icon::Touch, "Touch", {} }, { Icon::Hold, "Hold", {} }, { Icon::Method, "Method", {} },
    { Icon::Preset, "Preset", {} }, { Icon::Tool, "Tool", {} }, { Icon::Cut, "Cut", {} },
    { Icon::Slices, "Slices", {} }, { Icon::Measure, "Measure", {} },
    { Icon::Record, "Record", {} }, { Icon::Play, "Play", {} }, { Icon::Look, "Look", {} } };
  vtkNew<PaintedItem> item;
  item->Painter = [this](vtkContext2D* painter) { return this->Paint(painter); };
  this->Actor->GetScene()->AddItem(item);
  this->Renderer->AddViewProp(this->Actor);
  this->Renderer->InteractiveOff();
  this->Renderer->SetLayer(window->GetNumberOfLayers());
  window->SetNumberOfLayers(window->GetNumberOfLayers() + 1);
  window->AddRenderer(this->Renderer);
  this->FrameObserver->SetClientData(this);
  this->FrameObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<CommandBar*>(self)->Dock(); });
  window->AddObserver(vtkCommand::StartEvent, this->FrameObserver);
  this->MouseObserver->SetClientData(this);
  this->MouseObserver->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto& bar = *static_cast<CommandBar*>(self);
      bar.MouseObserver->SetAbortFlag(bar.Handle(event));
    });
  for (const unsigned long event : BAR_EVENTS)
  {
    interactor->AddObserver(event, this->MouseObserver, BAR_PRIORITY);
  }
  // A style that drags the camera grabs the release event; a passive observer still receives it.
  this->ReleaseObserver->SetClientData(this);
  this->ReleaseObserver->SetPassiveObserver(1);
  this->ReleaseObserver->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<CommandBar*>(self)->IsDown[FindMouseButton(event)] = false; });
  for (const unsigned long event : { vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
  {
    interactor->AddObserver(event, this->ReleaseObserver);
  }
  commands.Add(this,
    { "Window", "this bar on or off", "Ctrl+b", [this] { this->IsShown = !this->IsShown; },
      [this] { return this->IsShown; }, nullptr });
}

CommandBar::~CommandBar()
{
  this->All.Remove(this);
  this->Interactor->RemoveObserver(this->MouseObserver);
  this->Interactor->RemoveObserver(this->ReleaseObserver);
  this->Window->RemoveObserver(this->FrameObserver);
  this->Strip.GiveBack();
  this->Window->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
float CommandBar::ToPixels(double points) const
{
  return static_cast<float>(
    std::lround(points * VolumeHaptics::PixelsPerPoint(this->Renderer.Get())));
}

void CommandBar::Dock()
{
  const int* const size = this->Window->GetSize();
  if (!this->IsShown || size[1] <= 0)
  {
    this->Strip.GiveBack();
    return;
  }
  this->MeasureLabels();
  // Show labels if they fit.
  float labelled = 2.0f * GAP;
  for (const float width : this->LabelWidths)
  {
    labelled += std::max(this->ToPixels(BUTTON), width + 2.0f * this->ToPixels(LABEL_GAP));
  }
  constexpr int roomy = 400; // points: in a lower window, labels take too much
  this->HasLabels =
    labelled <= static_cast<float>(size[0]) && size[1] >= static_cast<int>(this->ToPixels(roomy));
  const float most = static_cast<float>(size[0]) / static_cast<float>(this->Buttons.size());
  const float icon = std::clamp(most, this->ToPixels(SMALLEST), this->ToPixels(BUTTON));
  this->Height = this->HasLabels ? this->ToPixels(BUTTON + LABEL_HEIGHT) : icon;
  this->LayOut();
  this->Strip.PlaceBar(this->Window, this->Height / static_cast<float>(size[1]), this->Renderer);
}

//------------------------------------------------------------------------------
int CommandBar::FindButton(int x, int y) const
{
  for (std::size_t i = 0; this->IsShown && i < this->Buttons.size(); ++i)
  {
    if (this->Buttons[i].Place.Contains(x, y))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

int CommandBar::FindRow(int x, int y) const
{
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    if (!this->Rows[i].IsTitle && this->Rows[i].Place.Contains(x, y))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void CommandBar::PointAt(int x, int y)
{
  const int row = this->IsMenuOpen ? this->FindRow(x, y) : -1;
  const int button = this->FindButton(x, y);
  if (row != this->PointedRow || button != this->Pointed)
  {
    this->PointedRow = row;
    this->Pointed = button;
    this->Interactor->Render();
  }
}

bool CommandBar::Handle(unsigned long event)
{
  const int* const at = this->Interactor->GetEventPosition();
  const int x = at[0];
  const int y = at[1];
  const bool isOnBar = this->IsShown &&
    static_cast<float>(y) >= static_cast<float>(this->Window->GetSize()[1]) - this->Height;
  const std::size_t pressed = FindMouseButton(event);
  switch (event)
  {
    case vtkCommand::MouseMoveEvent:
      this->PointAt(x, y);
      // A drag that began in the scene continues even over the bar.
      return this->IsMenuOpen ||
        (isOnBar &&
          std::find(this->IsDown.begin(), this->IsDown.end(), true) == this->IsDown.end());
    case vtkCommand::LeaveEvent:
      this->PointAt(-1, -1);
      return false;
    case vtkCommand::KeyPressEvent:
      // Pass the key on. If it ends the touch, this must not wait for a frame, so close the menu
      // without drawing.
      this->HideMenu();
      return false;
    case vtkCommand::TimerEvent:
      this->EndMenu();
      return false;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      if (this->IsMenuOpen)
      {
        constexpr int step = 3;
        this->Scroll(event == vtkCommand::MouseWheelForwardEvent ? -step : step);
      }
      return this->IsMenuOpen || isOnBar;
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::LeftButtonDoubleClickEvent:
    {
      const int button = this->FindButton(x, y);
      const int row = this->IsMenuOpen ? this->FindRow(x, y) : -1;
      const bool wasOpen = this->IsMenuOpen;
      this->HasPress[pressed] = wasOpen || isOnBar;
      this->IsDown[pressed] = !this->HasPress[pressed];
      if (wasOpen && row < 0 && this->Menu.Contains(x, y))
      {
        return true; // clicking a title has no effect
      }
      const Icon opener = this->Opener;
      const Command chosen = row >= 0 ? this->Rows[static_cast<std::size_t>(row)].What : Command();
      this->HideMenu(); // run the command before drawing, because it may release the hand
      if (row >= 0)
      {
        this->All.Run(chosen);
      }
      else if (button >= 0)
      {
        const Button chosenButton = this->Buttons[static_cast<std::size_t>(button)];
        if (!wasOpen || chosenButton.Picture != opener)
        {
          this->Activate(chosenButton);
        }
      }
      this->EndMenu();
      return this->HasPress[pressed];
    }
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::MiddleButtonPressEvent:
      this->HasPress[pressed] = this->IsMenuOpen || isOnBar;
      this->IsDown[pressed] = !this->HasPress[pressed];
      this->CloseMenu();
      return this->HasPress[pressed];
    default: // the release of a button
      return std::exchange(this->HasPress[pressed], false);
  }
}

void CommandBar::Activate(const Button& button)
{
  if (button.Picture == Icon::Menu)
  {
    this->OpenMenu("", button);
    return;
  }
  for (const CommandGroup& group : CommandTable::GetGroups())
  {
    if (group.Button == button.Picture)
    {
      this->OpenMenu(group.Title, button);
      return;
    }
  }
  this->All.Run(this->All.FindButton(button.Picture));
}

void CommandBar::OpenMenu(const std::string& wanted, const Button& from)
{
  this->Rows.clear();
  for (const CommandGroup& group : CommandTable::GetGroups())
  {
    const std::vector<Command> list = wanted.empty() || wanted == group.Title
      ? this->All.ListGroup(group.Title)
      : std::vector<Command>();
    if (list.empty())
    {
      continue;
    }
    Row title;
    title.Text = group.Title;
    title.IsTitle = true;
    this->Rows.push_back(title);
    for (const Command& command : list)
    {
      Row row;
      row.Text = BeginUpper(command.Text);
      row.Key = CommandTable::LabelKey(command.Key);
      row.IsOn = command.IsOn && command.IsOn();
      row.What = command;
      this->Rows.push_back(row);
    }
  }
  this->IsMenuOpen = !this->Rows.empty();
  this->Opener = from.Picture;
  this->MenuLeft = from.Place.Left;
  this->First = 0;
  this->PointedRow = -1;
  this->LayOutMenu();
  this->Interactor->Render();
}

void CommandBar::CloseMenu()
{
  this->HideMenu();
  this->EndMenu();
}

void CommandBar::HideMenu()
{
  this->IsEndDue = this->IsEndDue || this->IsMenuOpen;
  this->IsMenuOpen = false;
  this->Rows.clear();
  this->PointedRow = -1;
  this->Opener = Icon::None;
}

void CommandBar::EndMenu()
{
  if (!std::exchange(this->IsEndDue, false))
  {
    return;
  }
  this->Interactor->Render();
}

void CommandBar::Scroll(int rows)
{
  const int last = std::max(0, static_cast<int>(this->Rows.size()) - this->Visible);
  const int first = std::clamp(this->First + rows, 0, last);
  if (first != this->First)
  {
    this->First = first;
    this->LayOutMenu();
    this->PointedRow = -1;
    this->Interactor->Render();
  }
}

//------------------------------------------------------------------------------
void CommandBar::SetLetters(
  vtkContext2D* painter, double points, const RGB& colour, bool isBold) const
{
  vtkTextProperty* const look = painter->GetTextProp();
  look->SetFontSize(static_cast<int>(std::lround(points)));
  look->SetColor(colour[0], colour[1], colour[2]);
  look->SetBold(isBold);
  look->ItalicOff();
  look->ShadowOff();
  look->SetOrientation(0.0);
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToCentered();
}

float CommandBar::MeasureWidth(const std::string& text, double points, bool isBold) const
{
  int box[4] = { 0, -1, 0, -1 };
  this->Measured->SetFontSize(static_cast<int>(std::lround(points)));
  this->Measured->SetBold(isBold);
  if (vtkTextRenderer* const renderer = vtkTextRenderer::GetInstance(); renderer && !text.empty())
  {
    renderer->GetBoundingBox(this->Measured, text, box, this->Window->GetDPI());
  }
  return static_cast<float>(box[1] - box[0] + 1);
}

void CommandBar::UpdateButtons()
{
  for (Button& button : this->Buttons)
  {
    bool isGroup = button.Picture == Icon::Menu;
    for (const CommandGroup& group : CommandTable::GetGroups())
    {
      isGroup = isGroup || group.Button == button.Picture;
    }
    const Command command = isGroup ? Command() : this->All.FindButton(button.Picture);
    button.IsUsable = isGroup || command.Run;
    button.IsOn = isGroup ? this->IsMenuOpen && this->Opener == button.Picture
                          : command.Run && command.IsOn && command.IsOn();
  }
}

void CommandBar::MeasureLabels()
{
  const double scale = VolumeHaptics::PixelsPerPoint(this->Renderer.Get());
  if (this->LabelWidths.empty() || scale != this->LabelScale)
  {
    this->LabelScale = scale;
    this->LabelWidths.clear();
    for (const Button& button : this->Buttons)
    {
      this->LabelWidths.push_back(this->MeasureWidth(button.Label, LABEL_LETTERS, false));
    }
  }
}

void CommandBar::LayOut()
{
  const int* const size = this->Window->GetSize();
  const auto right = static_cast<float>(size[0]);
  const float bottom = static_cast<float>(size[1]) - this->Height;
  float used = 0.0f;
  std::vector<float> widths;
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    const float least =
      this->HasLabels ? this->LabelWidths[i] + 2.0f * this->ToPixels(LABEL_GAP) : 0.0f;
    const float icon = this->HasLabels ? this->ToPixels(BUTTON) : this->Height;
    widths.push_back(std::max(least, icon));
    used += widths.back();
  }
  // Leave gaps after the groups for the file, the hand, the tool, the slices and the recording.
  const float gap = this->ToPixels(GAP);
  constexpr float gaps = 4.0f;
  const bool hasGaps = used + gaps * gap <= right;
  float left = 0.0f;
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    Button& button = this->Buttons[i];
    const Icon icon = button.Picture;
    button.Place = { left, bottom, widths[i], this->Height };
    left += widths[i];
    const bool isLast =
      icon == Icon::Open || icon == Icon::Hold || icon == Icon::Tool || icon == Icon::Measure;
    left += hasGaps && isLast ? gap : 0.0f;
  }
}

void CommandBar::DrawPicture()
{
  const int* const size = this->Window->GetSize();
  const int height = static_cast<int>(this->Height);
  std::ostringstream wanted;
  wanted << size[0] << " " << height << " " << this->HasLabels << " " << this->Pointed;
  for (const Button& button : this->Buttons)
  {
    wanted << " " << button.IsOn << button.IsUsable;
  }
  if (wanted.str() == this->Drawn)
  {
    return;
  }
  this->Drawn = wanted.str();
  this->Picture->SetDimensions(size[0], height, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  Fill(this->Picture, 0, 0, size[0], height, GROUND);
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    const Button& button = this->Buttons[i];
    const int left = static_cast<int>(button.Place.Left);
    const int width = static_cast<int>(button.Place.Width);
    const bool isPointed = static_cast<int>(i) == this->Pointed && button.IsUsable;
    if (button.IsOn || isPointed)
    {
      Fill(this->Picture, left + 1, 1, width - 2, height - 2, button.IsOn ? CHOSEN : LIT);
    }
    const int room = this->HasLabels ? height - static_cast<int>(this->ToPixels(LABEL_HEIGHT))
                                     : std::min(width, height);
    const int icon = std::min(static_cast<int>(this->ToPixels(ICON)), room * 3 / 4);
    const RGB& colour = !button.IsUsable ? UNUSABLE : button.Picture == Icon::Record ? RED : INK;
    DrawIcon(this->Picture, button.Picture, left + (width - icon) / 2,
      height - room + (room - icon) / 2, icon, colour);
  }
  this->Picture->Modified();
}

void CommandBar::DrawButtons(vtkContext2D* painter)
{
  this->DrawPicture();
  const auto bottom = static_cast<float>(this->Window->GetSize()[1]) - this->Height;
  painter->DrawImage(0.0f, bottom, this->Picture);
  for (std::size_t i = 0; this->HasLabels && i < this->Buttons.size(); ++i)
  {
    const Button& button = this->Buttons[i];
    this->SetLetters(painter, LABEL_LETTERS, button.IsUsable ? INK : UNUSABLE, false);
    const float left = button.Place.Left + 0.5f * (button.Place.Width - this->LabelWidths[i]);
    painter->DrawString(
      std::round(left), bottom + this->ToPixels(0.5 * LABEL_HEIGHT + 2.0), button.Label);
  }
}

std::string CommandBar::DescribeButton(const Button& button, std::string& key) const
{
  key.clear();
  if (button.Picture == Icon::Menu)
  {
    return "All commands, with their keys";
  }
  for (const CommandGroup& group : CommandTable::GetGroups())
  {
    if (group.Button == button.Picture)
    {
      return group.Tip;
    }
  }
  const Command command = this->All.FindButton(button.Picture);
  key = CommandTable::LabelKey(command.Key);
  const std::string label = button.Label;
  return !command.Run                              ? label + ": not available for this volume"
    : command.Text.rfind(':') != std::string::npos ? BeginUpper(command.Text)
                                                   : label + ": " + command.Text;
}

void CommandBar::DrawTip(vtkContext2D* painter)
{
  if (this->Pointed < 0 || this->IsMenuOpen)
  {
    return;
  }
  const Button& button = this->Buttons[static_cast<std::size_t>(this->Pointed)];
  std::string key;
  const std::string text = this->DescribeButton(button, key);
  const std::string label = key.empty() ? text : text + "   [" + key + "]";
  const auto right = static_cast<float>(this->Window->GetSize()[0]);
  const float padding = this->ToPixels(PADDING);
  float width = 0.0f;
  int letters = LARGEST_LETTERS;
  for (; letters >= SMALLEST_LETTERS; --letters)
  {
    this->SetLetters(painter, letters, INK, false);
    width = this->MeasureWidth(label, letters, false) + 2.0f * padding;
    if (width <= right)
    {
      break;
    }
  }
  const float height = this->ToPixels(1.9 * letters);
  const float left = std::max(0.0f, std::min(button.Place.Left, right - width));
  const float bottom = button.Place.Bottom - height - this->ToPixels(3.0);
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(ToByte(GROUND[0]), ToByte(GROUND[1]), ToByte(GROUND[2]), 245);
  painter->DrawRect(left, bottom, width, height);
  this->SetLetters(painter, letters, INK, false);
  painter->DrawString(left + padding, bottom + 0.5f * height, label);
}

void CommandBar::LayOutMenu()
{
  for (int letters = LARGEST_LETTERS; !this->LayOutMenu(letters) && letters > SMALLEST_LETTERS;
       --letters)
  {
  }
}

bool CommandBar::LayOutMenu(int letters)
{
  const int* const size = this->Window->GetSize();
  const float padding = this->ToPixels(PADDING);
  const float mark = this->ToPixels(1.3 * letters);
  const float gap = this->ToPixels(1.8 * letters);
  const float line = this->ToPixels(1.75 * letters);
  float text = 0.0f;
  float key = 0.0f;
  for (const Row& row : this->Rows)
  {
    text = std::max(text, this->MeasureWidth(row.Text, letters, row.IsTitle));
    key = std::max(key, this->MeasureWidth(row.Key, letters, false));
  }
  const float column = mark + text + (key > 0.0f ? gap + key : 0.0f) + padding;
  const float above = this->IsShown ? this->Height : 0.0f;
  const float room = static_cast<float>(size[1]) - above - 2.0f * padding;
  const int perColumn = std::max(1, static_cast<int>(room / line));
  const auto width = static_cast<float>(size[0]);
  const int most = std::max(1, static_cast<int>((width - padding) / column));
  const int count = static_cast<int>(this->Rows.size());
  const int columns = std::max(1, std::min(most, (count + perColumn - 1) / perColumn));
  const int lines = std::min(perColumn, (count + columns - 1) / columns);
  this->Visible = std::min(count, columns * lines);
  this->First = std::clamp(this->First, 0, count - this->Visible);
  this->Letters = letters;
  const float menu = static_cast<float>(columns) * column + padding;
  this->Menu.Width = menu;
  this->Menu.Height = static_cast<float>(lines) * line + 2.0f * padding;
  this->Menu.Left = std::max(0.0f, std::min(this->MenuLeft, width - menu));
  this->Menu.Bottom = static_cast<float>(size[1]) - above - this->Menu.Height;
  for (int i = 0; i < count; ++i)
  {
    Row& row = this->Rows[static_cast<std::size_t>(i)];
    const int at = i - this->First;
    row.Place = {};
    if (at >= 0 && at < this->Visible)
    {
      const auto place = static_cast<float>(at / lines);
      const auto below = static_cast<float>(at % lines);
      row.Place = { this->Menu.Left + 0.5f * padding + place * column,
        this->Menu.Bottom + this->Menu.Height - padding - (below + 1.0f) * line, column, line };
    }
  }
  return menu <= width && (this->Visible == count || letters <= SMALLEST_LETTERS + 2);
}

void CommandBar::DrawMenu(vtkContext2D* painter)
{
  this->LayOutMenu();
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(ToByte(GROUND[0]), ToByte(GROUND[1]), ToByte(GROUND[2]), 250);
  painter->DrawRect(this->Menu.Left, this->Menu.Bottom, this->Menu.Width, this->Menu.Height);
  const float mark = this->ToPixels(1.3 * this->Letters);
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    const Row& row = this->Rows[i];
    if (row.Place.Width <= 0.0f)
    {
      continue;
    }
    const float middle = row.Place.Bottom + 0.5f * row.Place.Height;
    if (row.IsOn || static_cast<int>(i) == this->PointedRow)
    {
      const RGB& behind = static_cast<int>(i) == this->PointedRow ? LIT : GROUND;
      painter->GetBrush()->SetColor(ToByte(behind[0]), ToByte(behind[1]), ToByte(behind[2]), 255);
      painter->DrawRect(
        row.Place.Left, row.Place.Bottom, row.Place.Width - mark * 0.3f, row.Place.Height);
    }
    if (row.IsOn)
    {
      const float side = std::round(0.4f * mark);
      painter->GetBrush()->SetColor(ToByte(TITLE[0]), ToByte(TITLE[1]), ToByte(TITLE[2]), 255);
      painter->DrawRect(row.Place.Left + 0.3f * mark, middle - 0.5f * side, side, side);
    }
    this->SetLetters(painter, this->Letters, row.IsTitle ? TITLE : INK, row.IsTitle);
    painter->DrawString(row.Place.Left + (row.IsTitle ? 0.3f * mark : mark), middle, row.Text);
    if (!row.Key.empty())
    {
      this->SetLetters(painter, this->Letters, FAINT, false);
      const float width = this->MeasureWidth(row.Key, this->Letters, false);
      painter->DrawString(row.Place.Left + row.Place.Width - 0.8f * mark - width, middle, row.Key);
    }
  }
  // A thin scroll bar on the right shows that the list is longer.
  const auto count = static_cast<float>(this->Rows.size());
  if (this->Visible < static_cast<int>(this->Rows.size()))
  {
    const float height = this->Menu.Height * static_cast<float>(this->Visible) / count;
    const float top = this->Menu.Height * static_cast<float>(this->First) / count;
    const float thick = this->ToPixels(3.0);
    painter->GetBrush()->SetColor(ToByte(FAINT[0]), ToByte(FAINT[1]), ToByte(FAINT[2]), 255);
    painter->DrawRect(this->Menu.Left + this->Menu.Width - thick,
      this->Menu.Bottom + this->Menu.Height - top - height, thick, height);
  }
}

bool CommandBar::Paint(vtkContext2D* painter)
{
  this->UpdateButtons();
  if (this->IsShown)
  {
    this->LayOut();
    this->DrawButtons(painter);
    this->DrawTip(painter);
  }
  if (this->IsMenuOpen)
  {
    this->DrawMenu(painter);
  }
  return true;
}
} // namespace Explore
