// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Presses in a Qt widget, and hides the widget in every way that Qt supports: no force may remain.
 * Qt and VTK render off screen here, because only the events matter.
 */

#include "VTK/Scene/Interaction/StyleRig.h"

#include "Qt/WidgetWatch.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTabWidget>

#include <functional>
#include <memory>

using namespace scenetest;

namespace
{
class WidgetWatch : public StyleTest
{
protected:
  WidgetWatch()
  {
    this->Main = std::make_unique<QMainWindow>();
    this->Tabs = new QTabWidget;
    this->View = new QWidget;
    this->Tabs->addTab(this->View, "scene");
    this->Tabs->addTab(new QWidget, "other");
    this->Main->setCentralWidget(this->Tabs);
    VolumeHaptics::WidgetWatch::Watch(this->View, this->Style);
    this->Main->show();
    QApplication::processEvents();
  }
  void ExpectLetsGo(const std::function<void()>& act)
  {
    EXPECT_GT(Length(this->Device->GetState()->GetForce()), 0.3) << "N";
    act();
    QApplication::processEvents();
    EXPECT_FALSE(this->Style->GetTouchMode());
    EXPECT_FALSE(this->Device->IsArmOrdered());
    EXPECT_TRUE(Eventually(
      [this]
      {
        this->Device->UpdateState();
        return Length(this->Device->GetState()->GetForce()) == 0.0;
      }));
  }

  /// Qt allows one application object per process, so all tests share this object.
  int Count = 1;
  char Name[16] = "WidgetWatch";
  char* Names[2] = { Name, nullptr };
  QApplication Application{ Count, Names };
  std::unique_ptr<QMainWindow> Main;
  QTabWidget* Tabs = nullptr;
  QWidget* View = nullptr;
};
} // namespace

TEST_F(WidgetWatch, LetsGoOfAWidgetThatIsHidden)
{
  this->PushIn();
  this->ExpectLetsGo([this] { this->View->hide(); });
}

TEST_F(WidgetWatch, LetsGoInAWindowThatIsHidden)
{
  this->PushIn();
  this->ExpectLetsGo([this] { this->Main->hide(); });
}

TEST_F(WidgetWatch, LetsGoInAWindowThatIsClosed)
{
  this->PushIn();
  this->ExpectLetsGo([this] { this->Main->close(); });
}

TEST_F(WidgetWatch, LetsGoInAWindowThatIsMinimized)
{
  this->PushIn();
  this->ExpectLetsGo([this] { this->Main->showMinimized(); });
}

TEST_F(WidgetWatch, LetsGoBehindAnotherTab)
{
  this->PushIn();
  this->ExpectLetsGo([this] { this->Tabs->setCurrentIndex(1); });
}

TEST_F(WidgetWatch, LetsGoOfAWidgetThatIsDeleted)
{
  this->PushIn();
  this->ExpectLetsGo([this] { delete this->View; });
}

TEST_F(WidgetWatch, FollowsTheWidgetToAnotherWindow)
{
  auto* const dock = new QDockWidget(this->Main.get());
  dock->setWidget(this->View);
  this->Main->addDockWidget(Qt::LeftDockWidgetArea, dock);
  dock->show();
  dock->setFloating(true);
  QApplication::processEvents();
  this->PushIn();
  this->Main->showMinimized(); // the main window no longer contains the widget
  QApplication::processEvents();
  EXPECT_TRUE(this->Style->GetTouchMode());
  this->ExpectLetsGo([dock] { dock->showMinimized(); });
}

TEST_F(WidgetWatch, MayOutliveTheStyle)
{
  this->Interactor->SetInteractorStyle(nullptr);
  auto* const other = vtkInteractorStyleHaptic::New();
  VolumeHaptics::WidgetWatch::Watch(this->View, other);
  other->Delete();
  this->View->hide();
  this->View->show();
  this->Interactor->SetInteractorStyle(this->Style);
  this->PushIn();
  EXPECT_TRUE(this->Style->GetTouchMode()) << "a shown one keeps its hand";
}
