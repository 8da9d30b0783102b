// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fine detail: how much of a sinusoidal relief reaches the hand.
 */
#ifndef Evaluation_Relief_h
#define Evaluation_Relief_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** Amplitude (mm): so low that what is felt is linear in it, even at the shortest wavelength. */
constexpr double ReliefAmplitude = 0.05;

/**
 * The amplitude of the sine of a frequency (radians a sample) in a signal, by least squares beside
 * a mean and a drift; 0 of a signal that is too short to tell.
 */
double AmplitudeOf(const std::vector<double>& signal, double frequency);

/**
 * The force's amplitude over k ReliefAmplitude, across a relief of a wavelength (mm, of voxels of 1
 * mm), without friction. FORCE_FIELD works on the rising flank of its force, with the gain that
 * makes it as stiff as k there.
 */
double MeasureRelief(const Method& method, double wavelength);

/** The wavelength at which a rising response passes 1/sqrt(2); 0 if it does not. */
double CutOff(const std::vector<double>& wavelengths, const std::vector<double>& responses);

/** All methods, wavelengths from 2 to 40 voxels; adds a plot. */
Table CompareRelief(const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
