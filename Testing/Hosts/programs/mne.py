# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import mne

figure = mne.viz.create_3d_figure((600, 600), show=True)
figure.plotter.add_actor(make_volume(image))
mne.viz.set_3d_view(figure, azimuth=60, elevation=70, distance=300.0, focalpoint=(0.0, 0.0, 0.0))
figure.plotter.add_key_event("u", lambda: hear("u"))
figure.plotter.app_window.setWindowTitle("host")
# code of Documentation/hosts.md
