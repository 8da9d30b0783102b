// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ends the touch when a Qt widget is no longer visible, for programs with VTK's widget for Qt.
 */
#ifndef WidgetWatch_h
#define WidgetWatch_h

#include "vtkInteractorStyleHaptic.h"
#include "vtkWeakPointer.h"

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QWidget>

namespace VolumeHaptics
{

/**
 * VTK sends no event when a Qt widget is hidden, minimised or closed. This class watches the widget
 * for these events, lets the force fade, and leaves the touch mode. One call is enough:
 *
 *   view->interactor()->SetInteractorStyle(style); // a QVTKOpenGLNativeWidget
 *   VolumeHaptics::WidgetWatch::Watch(view, style);
 *
 * The widget owns the watch. The program compiles this header with its own Qt 5 or 6 (Widgets), so
 * the library does not depend on Qt.
 */
class WidgetWatch final : public QObject
{
public:
  static void Watch(QWidget* widget, vtkInteractorStyleHaptic* style)
  {
    new WidgetWatch(widget, style);
  }
  ~WidgetWatch() override { this->LetGo(); }

  bool eventFilter(QObject* watched, QEvent* event) override
  {
    // Also watch the window, because only the window receives an event when it is minimised. The
    // widget may move to another window, such as that of a floating dock, so watch the new window
    // when the widget is shown again.
    const QEvent::Type type = event->type();
    if (type == QEvent::Hide ||
      (type == QEvent::WindowStateChange && this->Window && this->Window->isMinimized()))
    {
      this->LetGo();
    }
    else if (watched == this->parent() && (type == QEvent::Show || type == QEvent::ParentChange))
    {
      this->WatchWindow();
    }
    return QObject::eventFilter(watched, event);
  }

private:
  WidgetWatch(QWidget* widget, vtkInteractorStyleHaptic* style)
    : QObject(widget)
    , Style(style)
  {
    widget->installEventFilter(this);
    this->WatchWindow();
  }

  void WatchWindow()
  {
    QWidget* const window = static_cast<QWidget*>(this->parent())->window();
    if (this->Window && this->Window != window && this->Window != this->parent())
    {
      this->Window->removeEventFilter(this);
    }
    this->Window = window;
    window->installEventFilter(this);
  }

  void LetGo()
  {
    if (this->Style)
    {
      this->Style->FadeOut();
    }
  }

  vtkWeakPointer<vtkInteractorStyleHaptic> Style;
  QPointer<QWidget> Window; ///< the window that contains the widget
};

} // namespace VolumeHaptics

#endif
