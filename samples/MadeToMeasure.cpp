// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/MadeToMeasure.h"

#include "core/body/Measuring.h"
#include "core/pattern/PatternPieces.h"
#include "core/simulation/Arrange.h"

namespace toile::samples {
namespace {

/// The draft wraps sleeves and cuffs round the straight line from shoulder to wrist. Laid flat beside the arm instead,
/// they are rolled round its middle line.
pattern::Pattern rolledRoundTheArms(pattern::Pattern pattern, const body::Body& body) {
    for (auto& shared : pattern.pieces) {
        if (!shared->id.value.starts_with("sleeve") && !shared->id.value.starts_with("cuff")) continue;
        pattern::Piece piece = *shared;
        piece.placement->curl.reset();
        shared = std::move(piece);
    }
    return simulation::startingClearOf(pattern, body);
}

} // namespace

BlouseSettings longSleeved() {
    BlouseSettings settings{.aboveWrist = 0};
    settings.block.armholeDepth = 0.20;
    settings.frontWaistDart.intake = 0.016;
    return settings;
}

Result<document::Document> blouseMadeToMeasure(const body::Body& body, const BlouseSettings& settings) {
    const auto measured = body::measurementsOf(body);
    if (!measured) return tl::unexpected(measured.error());
    auto document = blouse(*measured, body, settings);
    if (!document) return document;
    document->pattern = pattern::laidOut(rolledRoundTheArms(std::move(document->pattern), body));
    return document;
}

} // namespace toile::samples
