// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/SceneCases.h"

#include "core/study/scenes/Drapes.h"
#include "core/study/scenes/Sheets.h"
#include "samples/BodyScenes.h"
#include "samples/Samples.h"
#include "samples/TShirt.h"

#include <array>

namespace toile::batch {
namespace {

using namespace study::scenes;

constexpr std::array<std::string_view, 7> groups{"flap", "hanging", "stiff", "ball", "tunic", "t-shirt", "falling"};

simulation::Scene sceneOf(const document::Document& document, body::Body body) {
    return {document.pattern, Shared<body::Body>(std::move(body)), document.scene};
}

std::vector<Case> flaps(bool full) {
    std::vector<Case> cases{flapCase(1), flapCase(100)};
    if (full)
        for (const double factor : {1e4, 1e6}) cases.push_back(flapCase(factor));
    return cases;
}

std::vector<Case> hangingSheets(bool full) {
    std::vector<Case> cases{hangingCase(32), hangingCase(64)};
    if (full) cases.push_back(hangingCase(128));
    return cases;
}

std::vector<Case> stiffSheets(bool full) {
    std::vector<Case> cases{stiffHangingCase(1e4)};
    if (full) cases.push_back(stiffHangingCase(1e6));
    return cases;
}

simulation::Scene overBall(double spacing) {
    return sceneOf(samples::clothOverBall({.spacing = spacing}), {"ball", samples::ballMesh(), {}, {}});
}

std::vector<Case> ball() {
    return {
        drapeCase({.name = "cloth over a ball, 65 × 65",
                   .about = "samples/cloth-over-ball.toile: 1 m of 500 N/m falls on a ball of radius 0.1 m, with "
                            "self-contact. Other programs: Blender 788 particles inside, or none for 8.4 to 40 CPU s "
                            "per simulated second; ARCSim 72, clean.",
                   .scene = overBall(1.0 / 64),
                   .seconds = 2,
                   .cpuPerSecond = 4})};
}

/// A goal for the whole cost, and the spacing with about as many particles as the goal is for.
Case tunicCase(const char* name, const char* elsewhere, double spacing, double cpuSeconds) {
    return drapeCase(
        {.name = name,
         .about = std::string("samples/capsule-tunic.toile: two rectangles of poplin on a capsule, sewn at the "
                              "sides and the shoulders, with self-contact. Other programs: ") +
                  elsewhere,
         .scene = sceneOf(samples::capsuleTunic({.spacing = spacing}), {"capsule", samples::capsuleMesh(), {}, {}}),
         .cpuSeconds = cpuSeconds});
}

std::vector<Case> tunics(bool full) {
    std::vector<Case> cases{tunicCase(
        "tunic on a capsule, 3 k",
        "Blender closed and clean for 30 CPU s, or 287 particles inside for 10.6; C-IPC clean, 159 CPU s for its "
        "first two steps.",
        0.013, 6)};
    if (full)
        cases.push_back(tunicCase("tunic on a capsule, 12 k",
                                  "Blender 699 particles inside for 40 CPU s, or clean with a gap of 3.5 mm for 269.",
                                  0.0065, 25));
    return cases;
}

Result<std::vector<Case>> tShirts() {
    const auto wearers = samples::sampleWearers();
    if (!wearers) return tl::unexpected(wearers.error());
    const body::Mannequin& wearer = wearers->usual;
    auto shirt = samples::tShirt(wearer.measurements, wearer.body, {.spacing = 0.0142});
    if (!shirt) return tl::unexpected(shirt.error());
    shirt->scene.selfContact = true;
    return std::vector<Case>{drapeCase(
        {.name = "T-shirt on a mannequin, 3.5 k",
         .about = "samples/t-shirt.toile at 14.2 mm, with self-contact. Other programs: Blender 17 to 18 CPU s "
                  "with its seams open and 257 particles inside, or 244 with seams open by 22 mm.",
         .scene = sceneOf(*shirt, wearer.body),
         .cpuSeconds = 10})};
}

std::vector<Case> fallingCloths(bool full) {
    const auto falling = [](const char* name, double spacing) {
        return drapeCase({.name = name,
                          .about = "samples/cloth-over-ball.toile falls on its ball and folds on itself.",
                          .scene = overBall(spacing),
                          .seconds = 2,
                          .everyFrame = true,
                          .once = true});
    };
    std::vector<Case> cases{falling("falling cloth, 4 000", 1.0 / 64)};
    if (full) cases.push_back(falling("falling cloth, 40 000", 1.0 / 199));
    return cases;
}

} // namespace

std::span<const std::string_view> sceneGroups() {
    return groups;
}

Result<std::vector<Case>> sceneCases(std::string_view group, bool full) {
    if (group == "flap") return flaps(full);
    if (group == "hanging") return hangingSheets(full);
    if (group == "stiff") return stiffSheets(full);
    if (group == "ball") return ball();
    if (group == "tunic") return tunics(full);
    if (group == "t-shirt") return tShirts();
    return fallingCloths(full);
}

} // namespace toile::batch
