// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticWrappedText.h"

#include "VTK/Scene/Base/HapticOverlays.h"

#include "vtkStdString.h" // argument type in VTK 9.1
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <array>
#include <sstream>
#include <tuple>

namespace VolumeHaptics
{
namespace
{

/** Returns the width and the height of a text (pixels). */
std::array<int, 2> MeasureText(const std::string& text, vtkTextProperty* letters, int dpi)
{
  int box[4] = { 0, -1, 0, -1 };
  vtkTextRenderer* const renderer = vtkTextRenderer::GetInstance();
  if (text.empty() || !renderer || !renderer->GetBoundingBox(letters, text, box, dpi))
  {
    return { 0, 0 };
  }
  return { box[1] - box[0] + 1, box[3] - box[2] + 1 };
}

/** Returns the byte position after the UTF-8 character that begins at `at`. */
std::size_t EndOfLetter(const std::string& text, std::size_t at)
{
  constexpr unsigned char kind = 0xc0;
  constexpr unsigned char inside = 0x80;
  do
  {
    ++at;
  } while (at < text.size() && (static_cast<unsigned char>(text[at]) & kind) == inside);
  return at;
}

} // namespace

std::string WrapLines(const std::string& text, vtkTextProperty* letters, int width, int dpi)
{
  const auto fits = [&](const std::string& line)
  { return MeasureText(line, letters, dpi)[0] <= width; };
  std::string wrapped;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::string now;
    std::istringstream words(fits(line) ? std::string() : line);
    for (std::string word; words >> word;)
    {
      const std::string longer = now.empty() ? word : now + " " + word;
      if (fits(longer))
      {
        now = longer;
        continue;
      }
      wrapped += now.empty() ? "" : now + "\n";
      now.clear();
      for (std::size_t at = 0; at < word.size();)
      {
        const std::size_t end = EndOfLetter(word, at);
        const std::string letter = word.substr(at, end - at);
        if (!now.empty() && !fits(now + letter))
        {
          wrapped += now + "\n";
          now.clear();
        }
        now += letter;
        at = end;
      }
    }
    wrapped += (now.empty() ? line : now) + "\n";
  }
  return wrapped.empty() ? wrapped : wrapped.substr(0, wrapped.size() - 1);
}

HapticWrappedText::Room FindRoom(vtkViewport* viewport, double left, double top, int below)
{
  const int* const size = viewport->GetSize();
  const int height = static_cast<int>(top * size[1]);
  vtkWindow* const window = viewport->GetVTKWindow();
  return { static_cast<int>(ComputeTextRight(viewport) - 2.0 * left * size[0]), height - below,
    height, window ? window->GetDPI() : 72 };
}

void HapticWrappedText::Fit(vtkTextActor* actor, const std::string& text, const Room& room)
{
  const auto numbers = [](const Room& r)
  { return std::make_tuple(r.Width, r.Free, r.Height, r.DPI); };
  if (text == this->Text && numbers(room) == numbers(this->Had))
  {
    return;
  }
  this->Text = text;
  this->Had = room;
  vtkTextProperty* const letters = actor->GetTextProperty();
  std::string wrapped;
  const auto fits = [&](int size, int height)
  {
    letters->SetFontSize(size);
    wrapped = WrapLines(text, letters, room.Width, room.DPI);
    return MeasureText(wrapped, letters, room.DPI)[1] <= height;
  };
  for (const int height : { room.Free, room.Height })
  {
    int size = Largest;
    while (size > Smallest && !fits(size, height))
    {
      --size;
    }
    if (fits(size, height))
    {
      break;
    }
  }
  actor->SetInput(wrapped.c_str());
}

} // namespace VolumeHaptics
