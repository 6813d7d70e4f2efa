// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Quantities.h"

#include "core/base/Contracts.h"
#include "core/body/Measuring.h"
#include "core/geometry/Polygon.h"
#include "core/simulation/Inspect.h"
#include "core/study/HangingQuantities.h"
#include "core/study/WornQuantities.h"

#include <array>

namespace toile::study {
namespace {

struct Description {
    const char *name, *key;
    Measure measure;
};

constexpr std::array descriptions{Description{"hem at the centre front", "hemFront", Measure::length},
                                  Description{"hem at the centre back", "hemBack", Measure::length},
                                  Description{"hem at the left side", "hemLeft", Measure::length},
                                  Description{"hem at the right side", "hemRight", Measure::length},
                                  Description{"folds at the hem", "hemFolds", Measure::count},
                                  Description{"ease at the bust", "bustEase", Measure::length},
                                  Description{"ease at the waist", "waistEase", Measure::length},
                                  Description{"ease at the hip", "hipEase", Measure::length},
                                  Description{"back neck to nape", "napeDistance", Measure::length},
                                  Description{"height of the shoulder points", "shoulderHeight", Measure::length},
                                  Description{"distance of the shoulder points", "shoulderDistance", Measure::length},
                                  Description{"lowest point", "lowestPoint", Measure::length},
                                  Description{"mean height", "meanHeight", Measure::length},
                                  Description{"area seen from above", "shadowArea", Measure::area},
                                  Description{"folds at the lowest border", "borderFolds", Measure::count},
                                  Description{"contact with the body", "contactArea", Measure::area},
                                  Description{"strain along warp, 95 %", "warpStrain", Measure::strain},
                                  Description{"strain along weft, 95 %", "weftStrain", Measure::strain},
                                  Description{"shear, 95 %", "shear", Measure::strain}};
/// A garment's hem and ease tell what these tell of other cloth.
void appendHanging(std::vector<Found>& found, const WornDrape& worn) {
    const bool isWorn = worn.body && !worn.body->axes.empty();
    if (isWorn) {
        found.insert(found.end(), 4, Found(tl::unexpected(std::string("It is worn: hem and ease tell."))));
        found.push_back(contactAreaOf(worn));
        return;
    }
    const Hanging hanging = hangingOf(worn);
    for (const double value : {hanging.lowest, hanging.meanHeight, hanging.shadow}) found.push_back(value);
    if (hanging.folds) found.push_back(*hanging.folds);
    else found.push_back(tl::unexpected(std::string("It has no border.")));
    if (hanging.contact) found.push_back(*hanging.contact);
    else found.push_back(tl::unexpected(std::string("There is no body.")));
}

} // namespace

double resolutionOf(Measure measure) {
    switch (measure) {
    case Measure::length: return 0.5e-3; // half a division of a tape
    case Measure::strain: return 0.5e-3;
    case Measure::area: return 1e-3;
    case Measure::count: break;
    }
    return 0.5;
}

double shown(Measure measure, double value) {
    switch (measure) {
    case Measure::length: return 1e3 * value;
    case Measure::strain: return 1e2 * value;
    case Measure::area: return 1e4 * value;
    case Measure::count: break;
    }
    return value;
}

std::string_view unitOf(Measure measure) {
    switch (measure) {
    case Measure::length: return "mm";
    case Measure::strain: return "%";
    case Measure::area: return "cm²";
    case Measure::count: break;
    }
    return "";
}

int foldsOf(const std::vector<Vec3>& line) {
    constexpr double deep = 0.005; // [m]
    std::vector<Vec2> seenFromAbove;
    for (const Vec3& p : line) seenFromAbove.push_back({p.x, p.z});
    const std::vector<Vec2> tape = body::convexHull(seenFromAbove);
    const auto inValley = [&](const Vec2& p) { return geometry::distanceToBorder(tape, p) > deep; };
    int folds = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
        folds += inValley(seenFromAbove[i]) && !inValley(seenFromAbove[(i + 1) % line.size()]);
    return folds;
}

std::vector<Quantity> quantitiesOf(const WornDrape& worn) {
    std::vector<Found> found = wornQuantities(worn);
    appendHanging(found, worn);
    for (const double strain :
         {worn.strain.warpPercentile95, worn.strain.weftPercentile95, worn.strain.shearPercentile95})
        found.push_back(strain);
    expects(found.size() == descriptions.size(), "a finding for each quantity");
    std::vector<Quantity> quantities = noQuantities();
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i]) quantities[i].value = *found[i];
        else quantities[i].whyAbsent = found[i].error();
    return quantities;
}

std::vector<Quantity> noQuantities() {
    std::vector<Quantity> quantities;
    for (const auto& [name, key, measure] : descriptions) quantities.push_back({name, key, measure, std::nullopt, ""});
    return quantities;
}

std::vector<Quantity> quantitiesOf(const simulation::Simulation& simulation) {
    const simulation::Drape drape = simulation::drapeOf(simulation);
    const simulation::Scene& scene = simulation.scene();
    WornDrape worn{
        drape, scene.body ? &**scene.body : nullptr, simulation.body(), {}, simulation::strainOf(simulation)};
    for (const double half : simulation.garment().halfThickness)
        worn.touching.push_back(scene.settings.skinOffset + half);
    return quantitiesOf(worn);
}

} // namespace toile::study
