// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"
#include "core/simulation/SceneCheck.h"
#include "ui/panels/PropertySheet.h"
#include "ui/values/Words.h"

#include <QFileInfo>
#include <cmath>

namespace toile::ui {
namespace {

using document::Document;
using simulation::SceneSettings;

auto sceneSetting(auto change) {
    return [change](const Document& document, auto value) -> DocumentResult {
        SceneSettings scene = document.scene;
        change(scene, value);
        return document::withScene(document, scene);
    };
}

/// Whether there is air, and if so what it does.
void addAirRows(PropertySheet& sheet, const std::optional<simulation::Air>& air) {
    constexpr double strongest = 50, mostDrag = 10; // [m/s], [–]
    sheet.rows.push_back({QStringLiteral("air"), tr("Air"),
                          FlagRow{air.has_value(), sceneSetting([](SceneSettings& s, bool on) {
                                      s.air = on ? std::optional(simulation::Air{}) : std::nullopt;
                                  })},
                          tr("It drags at cloth that moves, and wind blows it.")});
    if (!air) return;
    const auto wind = [&](const char* name, const QString& label, double Vec3::*along, const QString& tip) {
        sheet.rows.push_back({QString::fromLatin1(name), label,
                              NumberRow{Quantity::wind, air->wind.*along, -strongest, strongest, 0.5,
                                        sceneSetting([along](SceneSettings& s, double speed) {
                                            if (s.air) s.air->wind.*along = speed;
                                        })},
                              tip});
    };
    wind("windX", tr("Wind along x"), &Vec3::x, tr("Towards the avatar's left."));
    wind("windY", tr("Wind along y"), &Vec3::y, tr("Upward."));
    wind("windZ", tr("Wind along z"), &Vec3::z, tr("Towards where the avatar looks."));
    sheet.rows.push_back(
        {QStringLiteral("drag"), tr("Drag coefficient"),
         NumberRow{Quantity::factor, air->drag, 0, mostDrag, 0.1, sceneSetting([](SceneSettings& s, double drag) {
                       if (s.air) s.air->drag = drag;
                   })},
         tr("Of cloth across the stream; a flat plate has 1.2.")});
}

} // namespace

PropertySheet sceneSheet(const Document& document) {
    PropertySheet sheet{tr("Scene"), {}};
    const SceneSettings& scene = document.scene;
    const auto number = [&](const char* name, const QString& label, Quantity quantity, double SceneSettings::*field,
                            double low, double high, double step, const QString& tip = {}) {
        sheet.rows.push_back({QString::fromLatin1(name), label,
                              NumberRow{quantity, scene.*field, low, high, step,
                                        sceneSetting([field](SceneSettings& s, double value) { s.*field = value; })},
                              tip});
    };
    const QString avatar = QString::fromStdString(document.avatarFile);
    const QString name = avatar.isEmpty() ? tr("none") : QFileInfo(avatar).fileName();
    sheet.rows.push_back({QStringLiteral("avatar"), tr("Avatar"), FactRow{name}, avatar});
    sheet.rows.push_back({QStringLiteral("gravity"), tr("Gravity"),
                          NumberRow{Quantity::acceleration, -scene.gravity.y, -100, 100, 0.5,
                                    sceneSetting([](SceneSettings& s, double value) {
                                        s.gravity = {0, -value, 0};
                                    })},
                          tr("Downward.")});
    addAirRows(sheet, scene.air);
    number("damping", tr("Damping"), Quantity::damping, &SceneSettings::damping, 0, 100, 0.1,
           tr("Mass-proportional: how soon the cloth comes to rest."));
    number("strainDamping", tr("Strain damping"), Quantity::shortTime, &SceneSettings::strainDamping, 0, 1, 1,
           tr("Stiffness-proportional: the time in which stretch and bends that are let go fall to a third. "
              "Folds swing less; cloth that falls is not slowed down."));
    number("skinOffset", tr("Skin offset"), Quantity::length, &SceneSettings::skinOffset, 0, 0.05, 0.5,
           tr("Distance of the cloth's underside to the body; lower it only at the end."));
    number("bodyFriction", tr("Body friction"), Quantity::factor, &SceneSettings::bodyFriction, 0, 2, 0.05);
    number("seamTime", tr("Seam time"), Quantity::time, &SceneSettings::seamTime, 0.01, 30, 0.1,
           tr("In which the seams are drawn together."));
    sheet.rows.push_back(
        {QStringLiteral("substeps"), tr("Substeps"),
         NumberRow{
             Quantity::count, double(scene.substeps), 0, simulation::mostSubsteps, 1,
             sceneSetting([](SceneSettings& s, double count) { s.substeps = static_cast<int>(std::lround(count)); }),
             tr("automatic")},
         tr("Of a frame step, while cloth is simulated by positions; automatic: as many as its longest thread "
            "needs. Cloth is stiffer with more.")});
    sheet.rows.push_back(
        {QStringLiteral("selfContact"), tr("Self-contact"),
         FlagRow{scene.selfContact, sceneSetting([](SceneSettings& s, bool on) { s.selfContact = on; })}});
    return sheet;
}

} // namespace toile::ui
