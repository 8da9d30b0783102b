# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A head to touch in a Qt window: pyvistaqt's QtInteractor, and a tool bar for touch, method and materials.

Needs pyvistaqt and a Qt for Python: pip install pyvistaqt PyQt5.
"""
import sys

import pyvista as pv
from pyvistaqt import QtInteractor
from qtpy import QtCore, QtWidgets
from volumehaptics import examples, vtkHapticProperty, vtkVolumeHapticsFilter
from volumehaptics.pyvista import add_haptics


class Window(QtWidgets.QMainWindow):
    def __init__(self, head):
        super().__init__()
        self.setWindowTitle("Touch in pyvistaqt")
        self.resize(900, 700)
        self.plotter = QtInteractor(self)
        self.setCentralWidget(self.plotter)
        self.plotter.set_background("black", top="slategray")
        skin = self.plotter.add_volume(
            head, clim=(-600, 1000), opacity=[0, 0.35, 0.35, 0.2, 0.14, 0.6, 0.9, 1], shade=True,
            cmap=["#edb08f", "#e0977d", "#f5ebd8", "#ffffff"], opacity_unit_distance=4, show_scalar_bar=False)
        skin.prop.interpolation_type = "linear"
        self.haptics = add_haptics(self.plotter, skin, "CT contrast", iso_value=-300)
        self.plotter.view_vector((1, -0.8, 0.35), (0, 0, 1))
        self.make_tool_bar()
        self.plotter.setFocus()

    def make_tool_bar(self):
        bar = self.addToolBar("Touch")
        self.touch = bar.addAction("Touch")
        self.touch.setCheckable(True)
        self.touch.triggered.connect(self.set_touch)
        # Update the button, because key t begins and ends the touch, too.
        style = self.haptics.style
        style.AddObserver("ModifiedEvent", lambda *_: self.touch.setChecked(bool(style.GetTouchMode())))
        felt = self.haptics.filter
        for names, chosen, choose in (
            (vtkVolumeHapticsFilter.GetMethodNames(), felt.GetMethodName(), felt.SetMethodByName),
            (vtkHapticProperty.GetPresetNames(), "CT contrast", felt.GetProperty().ApplyPreset),
        ):
            box = QtWidgets.QComboBox()
            box.setFocusPolicy(QtCore.Qt.NoFocus)  # keeps keyboard input in the scene
            box.addItems([names.GetValue(i) for i in range(names.GetNumberOfValues())])
            box.setCurrentText(chosen)
            box.textActivated.connect(choose)
            bar.addWidget(box)

    def set_touch(self, on):
        # Begin the touch at the centre of the scene, because the pointer is still on the button.
        interactor = self.plotter.iren.interactor
        width, height = interactor.GetSize()
        interactor.SetEventInformation(width // 2, height // 2, 0, 0)
        self.haptics.style.SetTouchMode(on)

    def closeEvent(self, event):  # noqa: N802 (Qt's name)
        self.haptics.close()
        self.plotter.close()
        super().closeEvent(event)


if __name__ == "__main__":
    application = QtWidgets.QApplication(sys.argv)
    window = Window(pv.read(sys.argv[1]) if len(sys.argv) > 1 else pv.wrap(examples.phantom()))
    window.show()
    sys.exit(application.exec_())
