// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/stability/Watch.h"

#include <string>
#include <vector>

namespace toile::study::stability {

/// A way of stepping, with or without the cap of position-based dynamics.
struct MapMethod {
    std::string name;
    dynamics::Method method = dynamics::Method::trBdf2;
    double stiffnessCap = 1;
};
[[nodiscard]] std::vector<MapMethod> mapMethods();

/// One cell of the map of S1: the flap by a method, of a stiffness, in steps of a length.
struct MapCell {
    std::string method;
    double stiffness = 0; ///< of the cloth along warp and weft [N/m]
    double step = 0;      ///< [s]
    double duration = 0;  ///< of the run: 0.4 s, or what a number of steps reaches [s]
    double stepLimit = 0; ///< of explicit methods [s]
    Watched run;
    double error = 0; ///< rms distance to the reference over how far the reference has moved; NaN without a run [–]
    double softened = 1; ///< stiffness used over the true one, of the springs, where a cap took some away [–]
    bool bounded = true; ///< by the energy rule of the method
};

struct MapSettings {
    int cells = 16; ///< along a side
    std::vector<double> stiffnesses, steps;
    int mostSteps = 40000;       ///< of a run by an explicit or position-based method
    int mostImplicitSteps = 400; ///< of one that solves equations
};
[[nodiscard]] MapSettings mapSettings(bool quick);

[[nodiscard]] std::vector<MapCell> stiffnessMap(const MapSettings& settings);

/// A gnuplot program that draws the map into stiffness-map.svg and .png: a panel a method, coloured by error, hatched
/// where a cap softened the cloth.
[[nodiscard]] std::string mapScript(const std::vector<MapCell>& cells);

} // namespace toile::study::stability
