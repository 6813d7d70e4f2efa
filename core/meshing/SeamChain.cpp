// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/SeamChain.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace toile::meshing {
namespace {

constexpr double silentMismatch = 1e-3;         ///< [m]
constexpr double silentRelativeMismatch = 3e-3; ///< [–]
constexpr double warnedMismatch = 3e-3;         ///< [m]
constexpr double jointReach = 0.35; ///< joints of both sides nearer than this part of ε are one place [–]
constexpr double sameFraction = 1e-9;
constexpr double sameNotch = 1e-6; ///< notches nearer than this along the chain are one [m]

using Failure = std::optional<Error>;

Failure seamError(const SeamInput& seam, const std::string& text) {
    return Error{ErrorCode::invalidInput, text, {.object = nameOf(seam)}};
}

std::string edgeName(const MeshInput& input, const SeamPartInput& part) {
    return nameOf(input.pieces[static_cast<std::size_t>(part.piece)], part.loop, part.edge);
}

const EdgeArc& arcOf(const std::vector<PieceBoundary>& boundaries, const SeamPartInput& part) {
    return boundaries[static_cast<std::size_t>(part.piece)]
        .loops[static_cast<std::size_t>(part.loop)]
        .edges[static_cast<std::size_t>(part.edge)];
}

Failure partError(const MeshInput& input, const SeamInput& seam, const SeamPartInput& part,
                  const std::vector<PieceBoundary>& boundaries) {
    if (part.piece < 0 || part.piece >= static_cast<int>(input.pieces.size()))
        return seamError(seam,
                         "The seam names piece no. " + std::to_string(part.piece + 1) + ", which does not exist.");
    const PieceInput& piece = input.pieces[static_cast<std::size_t>(part.piece)];
    if (part.loop < 0 || part.loop >= loopCount(piece) || part.edge < 0 ||
        part.edge >= static_cast<int>(loopOf(piece, part.loop).size()))
        return seamError(seam, "The seam names an edge that " + nameOf(piece) + " does not have.");
    if (!(part.from >= 0 && part.from < part.to && part.to <= 1))
        return seamError(seam, "The stretch of " + edgeName(input, part) +
                                   " must run from a smaller to a larger fraction in [0, 1].");
    const EdgeArc& edge = arcOf(boundaries, part);
    if (edge.collapsed || edge.length * (part.to - part.from) < 1e-6)
        return seamError(seam, "The seam uses " + edgeName(input, part) + ", which has no length.");
    return std::nullopt;
}

bool overlap(const SeamPartInput& a, const SeamPartInput& b) {
    return a.piece == b.piece && a.loop == b.loop && a.edge == b.edge &&
           std::min(a.to, b.to) - std::max(a.from, b.from) > sameFraction;
}

Failure overlapError(const MeshInput& input, const SeamInput& seam) {
    const std::size_t ofA = seam.sides[0].size(), all = ofA + seam.sides[1].size();
    const auto part = [&](std::size_t i) { return i < ofA ? seam.sides[0][i] : seam.sides[1][i - ofA]; };
    for (std::size_t i = 0; i < all; ++i)
        for (std::size_t j = i + 1; j < all; ++j)
            if (overlap(part(i), part(j)))
                return seamError(seam, "The seam uses the same stretch of " + edgeName(input, part(i)) + " twice.");
    return std::nullopt;
}

/// A place on a loop, comparable: edge and fraction, ends of edges belonging to the next edge.
struct LoopPlace {
    int piece, loop, edge;
    double fraction;
    bool operator==(const LoopPlace& other) const {
        return piece == other.piece && loop == other.loop && edge == other.edge &&
               std::abs(fraction - other.fraction) < sameFraction;
    }
};

LoopPlace placeAt(const MeshInput& input, const SeamPartInput& part, double fraction) {
    const int edges = static_cast<int>(loopOf(input.pieces[static_cast<std::size_t>(part.piece)], part.loop).size());
    if (fraction > 1 - sameFraction) return {part.piece, part.loop, (part.edge + 1) % edges, 0};
    return {part.piece, part.loop, part.edge, fraction};
}

/// Neighbouring parts must follow one another; a part that would follow if walked the other way is turned
/// wrongly.
Failure directionError(const MeshInput& input, const SeamInput& seam, const std::vector<SeamPartInput>& parts) {
    const auto startOf = [&](const SeamPartInput& p) { return placeAt(input, p, p.reversed ? p.to : p.from); };
    const auto endOf = [&](const SeamPartInput& p) { return placeAt(input, p, p.reversed ? p.from : p.to); };
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const SeamPartInput &here = parts[i], &there = parts[i + 1];
        if (endOf(here) == startOf(there)) continue;
        const bool thereTurned = endOf(here) == endOf(there);
        const bool hereTurned = startOf(here) == startOf(there);
        const bool bothTurned = startOf(here) == endOf(there);
        if (thereTurned || hereTurned || bothTurned)
            return seamError(seam, "The chain walks " + edgeName(input, thereTurned ? there : here) +
                                       " in the wrong direction: it does not lead on to " +
                                       edgeName(input, thereTurned ? here : there) + ".");
    }
    return std::nullopt;
}

SeamChain chainOf(const std::vector<SeamPartInput>& parts, const std::vector<PieceBoundary>& boundaries, Arena& arena) {
    SeamChain chain{std::pmr::vector<ChainPart>(&arena)};
    for (const SeamPartInput& part : parts) {
        const double length = arcOf(boundaries, part).length * (part.to - part.from);
        chain.parts.push_back({part, chain.length, length});
        chain.length += length;
    }
    return chain;
}

/// Where the notches of a side lie along it. One at a joint of two edges may be marked on either, or on both; at the
/// ends of the chain both sides meet anyway.
std::pmr::vector<double> notchesOf(const MeshInput& input, const SeamChain& chain, Arena& arena) {
    std::pmr::vector<double> places(&arena);
    for (const ChainPart& part : chain.parts) {
        const PieceInput& piece = input.pieces[static_cast<std::size_t>(part.part.piece)];
        for (const double notch : loopOf(piece, part.part.loop)[static_cast<std::size_t>(part.part.edge)].notches)
            if (notch >= part.part.from && notch <= part.part.to) places.push_back(part.chainOf(notch));
    }
    std::erase_if(places, [&](double at) { return at < sameNotch || at > chain.length - sameNotch; });
    std::sort(places.begin(), places.end());
    places.erase(
        std::unique(places.begin(), places.end(), [](double below, double above) { return above - below < sameNotch; }),
        places.end());
    return places;
}

Failure lengthError(const SeamInput& seam, const std::string& section, double lengthA, double lengthB,
                    const SeamSectionInput& declared, std::vector<Warning>& warnings) {
    const double wanted = declared.gatherRatio ? (*declared.gatherRatio - 1) * lengthB : declared.ease;
    const double mismatch = std::abs(lengthA - lengthB - wanted);
    if (mismatch <= std::max(silentMismatch, silentRelativeMismatch * std::max(lengthA, lengthB))) return std::nullopt;
    const std::string text = section + " is " + millimetres(lengthA) + " long on the first side and " +
                             millimetres(lengthB) + " on the second; declared ease " + millimetres(wanted) + ", " +
                             millimetres(mismatch) + " remain.";
    if (mismatch > warnedMismatch) return seamError(seam, text + " Declare the ease or correct the edges.");
    warnings.push_back({nameOf(seam), text});
    return std::nullopt;
}

Failure pairNotches(const MeshInput& input, const SeamInput& seam, CheckedSeam& checked, Arena& arena,
                    std::vector<Warning>& warnings) {
    const std::array<std::pmr::vector<double>, 2> notches{notchesOf(input, checked.sides[0], arena),
                                                          notchesOf(input, checked.sides[1], arena)};
    const SeamAnchor end{checked.sides[0].length, checked.sides[1].length};
    checked.anchors.assign(1, SeamAnchor{0, 0});
    const bool paired = notches[0].size() == notches[1].size();
    if (seam.sections.size() > 1 && (!paired || seam.sections.size() != notches[0].size() + 1))
        return seamError(seam, "Ease is declared for " + std::to_string(seam.sections.size()) +
                                   " sections, but the notches make " + std::to_string(notches[0].size() + 1) +
                                   " on the first side and " + std::to_string(notches[1].size() + 1) +
                                   " on the second.");
    if (paired)
        for (std::size_t i = 0; i < notches[0].size(); ++i) checked.anchors.push_back({notches[0][i], notches[1][i]});
    checked.anchors.push_back(end);
    for (const SeamSectionInput& section : seam.sections) {
        if (!std::isfinite(section.ease) ||
            (section.gatherRatio && !(*section.gatherRatio > 0.01 && *section.gatherRatio < 100)))
            return seamError(seam, "The ease must be a number, and a gather ratio between 0.01 and 100.");
        checked.ease += section.ease;
    }
    const bool perSection = seam.sections.size() == checked.anchors.size() - 1;
    if (!perSection) // nothing declared, or one ease for the whole seam
        if (!seam.sections.empty() || !paired)
            return lengthError(seam, "The seam", end[0], end[1],
                               seam.sections.empty() ? SeamSectionInput{} : seam.sections[0], warnings);
    for (std::size_t i = 0; i + 1 < checked.anchors.size(); ++i) {
        const SeamAnchor &from = checked.anchors[i], &to = checked.anchors[i + 1];
        const std::string section = checked.anchors.size() == 2 ? "The seam" : "Section " + std::to_string(i + 1);
        if (auto error = lengthError(seam, section, to[0] - from[0], to[1] - from[1],
                                     perSection ? seam.sections[i] : SeamSectionInput{}, warnings))
            return error;
    }
    return std::nullopt;
}

/// Joints of the two chains that nearly face each other become anchors.
void pairJoints(double spacing, Arena& arena, CheckedSeam& checked) {
    std::pmr::vector<SeamAnchor> found(&arena);
    double lastB = 0;
    for (std::size_t i = 1; i < checked.sides[0].parts.size(); ++i) {
        const double jointA = checked.sides[0].parts[i].start;
        const double facing = checked.across(0, jointA);
        std::optional<double> best;
        for (std::size_t j = 1; j < checked.sides[1].parts.size(); ++j) {
            const double jointB = checked.sides[1].parts[j].start;
            if (jointB <= lastB || std::abs(jointB - facing) > jointReach * spacing) continue;
            if (!best || std::abs(jointB - facing) < std::abs(*best - facing)) best = jointB;
        }
        if (!best) continue;
        const bool rising = std::all_of(checked.anchors.begin(), checked.anchors.end(), [&](const SeamAnchor& anchor) {
            return (anchor[0] < jointA && anchor[1] < *best) || (anchor[0] > jointA && anchor[1] > *best);
        });
        if (!rising) continue;
        found.push_back({jointA, *best});
        lastB = *best;
    }
    checked.anchors.insert(checked.anchors.end(), found.begin(), found.end());
    std::sort(checked.anchors.begin(), checked.anchors.end());
}

} // namespace

double ChainPart::chainOf(double fraction) const {
    const double along = (fraction - part.from) / (part.to - part.from) * length;
    return start + (part.reversed ? length - along : along);
}

double ChainPart::fractionOf(double chain) const {
    const double along = std::clamp(chain - start, 0.0, length) / length;
    return part.from + (part.to - part.from) * (part.reversed ? 1 - along : along);
}

double CheckedSeam::across(int fromSide, double chain) const {
    const auto here = static_cast<std::size_t>(fromSide), there = 1 - here;
    std::size_t i = 1;
    while (i + 1 < anchors.size() && anchors[i][here] < chain) ++i;
    const SeamAnchor &low = anchors[i - 1], &high = anchors[i];
    return low[there] + (high[there] - low[there]) * (chain - low[here]) / (high[here] - low[here]);
}

std::string nameOf(const SeamInput& seam) {
    return "seam \"" + seam.label + "\"";
}

Result<CheckedSeam> checkedSeam(const MeshInput& input, const SeamInput& seam,
                                const std::vector<PieceBoundary>& boundaries, Arena& arena,
                                std::vector<Warning>& warnings) {
    double spacing = 1e9;
    for (const auto& side : seam.sides) {
        if (side.empty()) return tl::unexpected(*seamError(seam, "One side of the seam is empty."));
        for (const SeamPartInput& part : side) {
            if (auto error = partError(input, seam, part, boundaries)) return tl::unexpected(*error);
            spacing = std::min(spacing, input.pieces[static_cast<std::size_t>(part.piece)].spacing);
        }
        if (auto error = directionError(input, seam, side)) return tl::unexpected(*error);
    }
    if (auto error = overlapError(input, seam)) return tl::unexpected(*error);
    CheckedSeam checked{{chainOf(seam.sides[0], boundaries, arena), chainOf(seam.sides[1], boundaries, arena)},
                        std::pmr::vector<SeamAnchor>(&arena)};
    if (auto error = pairNotches(input, seam, checked, arena, warnings)) return tl::unexpected(*error);
    pairJoints(spacing, arena, checked);
    return checked;
}

} // namespace toile::meshing
