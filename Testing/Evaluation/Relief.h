// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how much of a fine sinusoidal relief is left in the force.
 */
#ifndef Evaluation_Relief_h
#define Evaluation_Relief_h

#include "Methods.h"
#include "Table.h"

namespace evaluation
{

/** Amplitude (mm), small enough that the force is linear in it even at the shortest wavelength. */
constexpr double ReliefAmplitude = 0.05;

/**
 * Returns the amplitude of a sine with a frequency (radians per sample) in a signal, fitted by
 * least squares together with a mean and a drift; 0 if the signal is too short.
 */
double AmplitudeOf(const std::vector<double>& signal, double frequency);

/**
 * Returns the force's amplitude divided by k ReliefAmplitude, across a frictionless relief of a
 * wavelength (mm, with voxels of 1 mm). FORCE_FIELD is measured on the rising flank of its force,
 * with a gain that sets the stiffness there to k.
 */
double MeasureRelief(const Method& method, double wavelength);

/**
 * Returns the wavelength at which a response that increases with the wavelength passes 1/sqrt(2),
 * or 0 if it never does.
 */
double CutOff(const std::vector<double>& wavelengths, const std::vector<double>& responses);

/** Compares all methods at wavelengths of 2 to 40 voxels; adds a plot. */
Table CompareRelief(const Effort& effort, std::vector<Plot>& plots);

} // namespace evaluation

#endif
