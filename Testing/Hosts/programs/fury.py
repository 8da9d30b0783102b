# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from fury import ui, window

scene = window.Scene()
scene.add(make_volume(image))
manager = window.ShowManager(scene=scene, title="host", size=(500, 500))
manager.initialize()
said = []
bar = ui.LineSlider2D(center=(250, 60), length=200)
bar.on_change = lambda slider: said.append(slider.value)
scene.add(bar)
manager.iren.AddObserver("KeyPressEvent", lambda *_: hear(manager.iren.GetKeySym()), -1.0)
drag = ((0.5, 0.12), (0.6, 0.12))
# code of Documentation/hosts.md
