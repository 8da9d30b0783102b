// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Touch in a Qt window: a QVTKOpenGLNativeWidget, and a tool bar with a button for touch and boxes
// to choose method and materials.
#include <QVTKOpenGLNativeWidget.h>
#include <Qt/WidgetWatch.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkHapticDevice.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticProperty.h>
#include <vtkHapticRepresentation.h>
#include <vtkInteractorStyleHaptic.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkStringArray.h>
#include <vtkVolume.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QMainWindow>
#include <QSurfaceFormat>
#include <QToolBar>

namespace
{

QComboBox* AddChoice(QToolBar* bar, vtkStringArray* names)
{
  auto* const choice = new QComboBox;
  choice->setFocusPolicy(Qt::NoFocus); // keeps keyboard input in the scene
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    choice->addItem(QString::fromStdString(names->GetValue(i)));
  }
  bar->addWidget(choice);
  return choice;
}

class Window : public QMainWindow
{
public:
  explicit Window(const char* file)
  {
    this->Head->SetFileName(file);
    this->ShowVolume();
    this->MakeTouchable();
    this->MakeToolBar();
    this->setWindowTitle("Touch in Qt");
    this->resize(900, 700);
  }

  ~Window() override
  {
    this->View->interactor()->SetInteractorStyle(nullptr);
    this->Device->Close(); // disarms, and waits for the servo to stop
  }

private:
  void ShowVolume()
  {
    vtkNew<vtkSmartVolumeMapper> mapper;
    mapper->SetInputConnection(this->Head->GetOutputPort());
    this->Volume->SetMapper(mapper);
    vtkVolumeProperty* const look = this->Volume->GetProperty();
    look->GetScalarOpacity()->AddSegment(-500.0, 0.0, 1000.0, 0.6);
    look->GetRGBTransferFunction()->AddRGBSegment(-500.0, 0.9, 0.6, 0.5, 1000.0, 1.0, 1.0, 0.9);
    look->SetInterpolationTypeToLinear();
    look->ShadeOn();
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->GetActiveCamera()->SetPosition(1.0, -1.0, 0.35);
    this->Renderer->ResetCamera();

    vtkNew<vtkGenericOpenGLRenderWindow> window;
    window->AddRenderer(this->Renderer);
    this->View->setRenderWindow(window);
    this->setCentralWidget(this->View);
    this->View->setFocus();
  }

  void MakeTouchable()
  {
    this->Device->Open("virtual"); // the mouse
    this->Style->SetDevice(this->Device);
    this->Style->SetDefaultRenderer(this->Renderer);
    // touches the parts that the volume shows, also after the opacity changes
    this->Style->TouchVolume(this->Volume);
    this->Device->GetVolumeHaptics()->GetProperty()->ApplyPreset("CT contrast");
    this->Device->Start();
    this->Hand->SetDevice(this->Device);
    this->Renderer->AddViewProp(this->Hand);
    this->Display->SetDevice(this->Device); // shows hints and force arrows
    this->Renderer->AddViewProp(this->Display);
    this->Style->SetHeadUpDisplay(this->Display);
    // The style polls the servo with the timers of Qt, which the widget's interactor provides.
    vtkRenderWindowInteractor* const interactor = this->View->interactor();
    interactor->SetInteractorStyle(this->Style);
    // End the touch when the widget is hidden, minimised or closed.
    VolumeHaptics::WidgetWatch::Watch(this->View, this->Style);

    // Make key q close the window; VTK's own handler would only end VTK's event loop.
    this->Quit->SetClientData(this);
    this->Quit->SetCallback([](vtkObject*, unsigned long, void* window, void*)
      { static_cast<Window*>(window)->close(); });
    interactor->AddObserver(vtkCommand::ExitEvent, this->Quit);
  }

  void MakeToolBar()
  {
    QToolBar* const bar = this->addToolBar("Touch");
    QAction* const touch = bar->addAction("Touch");
    touch->setCheckable(true);
    QObject::connect(touch, &QAction::triggered,
      [this](bool on)
      {
        // Begin the touch at the centre of the scene, because the pointer is still on the button.
        vtkRenderWindowInteractor* const interactor = this->View->interactor();
        const int* const size = interactor->GetSize();
        interactor->SetEventInformation(size[0] / 2, size[1] / 2);
        this->Style->SetTouchMode(on);
      });
    // Update the button, because key t begins and ends the touch, too.
    this->Follow->SetClientData(touch);
    this->Follow->SetCallback(
      [](vtkObject* style, unsigned long, void* action, void*)
      {
        static_cast<QAction*>(action)->setChecked(
          static_cast<vtkInteractorStyleHaptic*>(style)->GetTouchMode());
      });
    this->Style->AddObserver(vtkCommand::ModifiedEvent, this->Follow);

    vtkVolumeHapticsFilter* const felt = this->Device->GetVolumeHaptics();
    QComboBox* const method = AddChoice(bar, vtkVolumeHapticsFilter::GetMethodNames());
    QObject::connect(method, &QComboBox::textActivated,
      [felt](const QString& name) { felt->SetMethodByName(name.toUtf8().constData()); });
    QComboBox* const preset = AddChoice(bar, vtkHapticProperty::GetPresetNames());
    preset->setCurrentText("CT contrast");
    QObject::connect(preset, &QComboBox::textActivated,
      [felt](const QString& name) { felt->GetProperty()->ApplyPreset(name.toUtf8().constData()); });
  }

  vtkNew<vtkXMLImageDataReader> Head;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkHapticDevice> Device;
  vtkNew<vtkHapticRepresentation> Hand;
  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkInteractorStyleHaptic> Style;
  vtkNew<vtkCallbackCommand> Quit;
  vtkNew<vtkCallbackCommand> Follow;
  QVTKOpenGLNativeWidget* View = new QVTKOpenGLNativeWidget(this);
};

} // namespace

int main(int argc, char* argv[])
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  Window window(argv[1]); // Data/HeadPhantom.vti
  window.show();
  return QApplication::exec();
}
