// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"

#include <string>
#include <vector>

namespace toile::body {

struct NamedMeasurements {
    std::string name;
    Measurements measurements;
};

/// Six adults of different height, girth and build.
inline std::vector<NamedMeasurements> sampleMeasurements() {
    const Measurements usual;
    Measurements petite = usual, tall = usual, full = usual, slim = usual, man = usual;
    petite.height = 1.55, petite.bust = 0.80, petite.underBust = 0.70, petite.waist = 0.62, petite.hip = 0.86;
    petite.neck = 0.33, petite.biceps = 0.25, petite.wrist = 0.145, petite.thigh = 0.50, petite.shoulderWidth = 0.36;
    petite.napeToWaist = 0.375, petite.bustHeight = 0.245, petite.arm = 0.53, petite.insideLeg = 0.69;
    tall.height = 1.80, tall.bust = 0.94, tall.underBust = 0.80, tall.waist = 0.75, tall.hip = 1.02, tall.thigh = 0.58;
    tall.shoulderWidth = 0.41, tall.napeToWaist = 0.435, tall.bustHeight = 0.28, tall.arm = 0.625,
    tall.insideLeg = 0.83;
    full.bust = 1.10, full.underBust = 0.94, full.waist = 0.90, full.hip = 1.15, full.neck = 0.39, full.biceps = 0.35;
    full.wrist = 0.175, full.thigh = 0.67, full.shoulderWidth = 0.41, full.bustHeight = 0.30;
    slim.bust = 0.80, slim.underBust = 0.70, slim.waist = 0.60, slim.hip = 0.87, slim.neck = 0.32, slim.biceps = 0.235;
    slim.wrist = 0.145, slim.thigh = 0.49, slim.shoulderWidth = 0.37, slim.bustHeight = 0.255;
    man.height = 1.78, man.bust = 1.00, man.underBust = 0.93, man.waist = 0.85, man.hip = 0.98, man.neck = 0.39;
    man.biceps = 0.32, man.wrist = 0.175, man.thigh = 0.57, man.shoulderWidth = 0.43, man.napeToWaist = 0.46;
    man.bustHeight = 0.27, man.arm = 0.62, man.insideLeg = 0.82;
    return {{"usual", usual}, {"petite", petite}, {"tall", tall}, {"full", full}, {"slim", slim}, {"man", man}};
}

} // namespace toile::body
