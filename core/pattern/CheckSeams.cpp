// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CheckParts.h"
#include "core/pattern/Editing.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternSeams.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

const char* sideName(std::size_t side) {
    return side == 0 ? "sideA" : "sideB";
}

/// Returns whether the part names a stretch that exists.
bool checkPart(const Pattern& pattern, const SeamPart& part, const std::string& at, Problems& problems) {
    const Piece* piece = findPiece(pattern, part.piece);
    if (!piece) {
        problems.error(at + ".piece", fmt::format("There is no piece \"{}\".", part.piece.value));
        return false;
    }
    const Piece* shape = shapeOf(pattern, *piece);
    if (!shape) return false; // the mirror piece's own problem
    if (!findEdge(*shape, part.edge)) {
        problems.error(at + ".edge", fmt::format("The piece \"{}\" has no edge \"{}\".", piece->name, part.edge.value));
        return false;
    }
    if (part.from >= 0 && part.from < part.to && part.to <= 1) return true;
    problems.error(
        at,
        fmt::format("A stretch runs from a smaller to a larger fraction between 0 and 1, but this one from {} to {}.",
                    part.from, part.to));
    return false;
}

bool checkParts(const Pattern& pattern, const Seam& seam, Problems& problems) {
    bool sound = true;
    for (std::size_t side = 0; side < 2; ++side) {
        if (seam.sides[side].empty()) {
            problems.error(sideName(side), "A seam joins two sides, but this one is empty.");
            sound = false;
        }
        for (std::size_t i = 0; i < seam.sides[side].size(); ++i)
            sound =
                checkPart(pattern, seam.sides[side][i], fmt::format("{}[{}]", sideName(side), i), problems) && sound;
    }
    return sound;
}

void checkNumbers(const Seam& seam, Problems& problems) {
    if (!(std::abs(seam.foldAngle) < 3.2)) problems.error("foldAngleDegrees", "A fold angle is at most 180°.");
    if (!(seam.stiffnessFactor > 0 && std::isfinite(seam.stiffnessFactor)))
        problems.error("stiffnessFactor",
                       fmt::format("The stiffness factor is {}, but must be positive.", seam.stiffnessFactor));
    if (seam.elastic)
        if (const auto ok = checked(*seam.elastic); !ok)
            problems.error("elastic." + ok.error().place.path, ok.error().text);
    for (std::size_t i = 0; i < seam.sections.size(); ++i) {
        if (!std::isfinite(seam.sections[i].ease))
            problems.error(fmt::format("sections[{}].ease", i), "The ease must be a finite length.");
        if (const auto ratio = seam.sections[i].gatherRatio; ratio && !isGatherRatio(*ratio))
            problems.error(fmt::format("sections[{}].gatherRatio", i),
                           fmt::format("The gather ratio is {}, but must be between 0.01 and 100.", *ratio));
    }
}

void checkLengths(const Pattern& pattern, const Seam& seam, const SeamTolerance& tolerance, Problems& problems) {
    const auto sections = sectionsOf(pattern, seam);
    if (!sections)
        return problems.error("sections", fmt::format("The notches divide the seam into {}, but {} are declared.",
                                                      sectionCount(pattern, seam), seam.sections.size()));
    for (std::size_t i = 0; i < sections->size(); ++i) {
        const SectionLengths& s = (*sections)[i];
        const double difference = std::abs(s.mismatch());
        if (difference <= std::max(tolerance.silent, tolerance.silentShare * std::min(s.a, s.b))) continue;
        const std::string where = sections->size() > 1 ? fmt::format("Section {}: side", i + 1) : "Side";
        std::string text = fmt::format(
            "{} A is {:.1f} mm long and side B {:.1f} mm; {:.1f} mm of ease are declared, {:.1f} mm are left over.",
            where, mm(s.a), mm(s.b), mm(s.wantedEase), mm(s.mismatch()));
        if (difference <= tolerance.warning) problems.warning("", std::move(text));
        else problems.error("", std::move(text));
    }
}

/// Both sides walked the same way round their pieces: the right side of one would meet the wrong side of the other.
bool joinsRightToWrong(const Pattern& pattern, const Seam& seam) {
    const auto forward = [&](const SeamPart& part) {
        return part.reversed == findPiece(pattern, part.piece)->mirror.has_value();
    };
    const auto allForward = [&](const auto& side) { return std::ranges::all_of(side, forward); };
    const auto noneForward = [&](const auto& side) { return std::ranges::none_of(side, forward); };
    return (allForward(seam.sides[0]) && allForward(seam.sides[1])) ||
           (noneForward(seam.sides[0]) && noneForward(seam.sides[1]));
}

void checkDirection(const Pattern& pattern, const Seam& seam, Problems& problems) {
    if (joinsRightToWrong(pattern, seam))
        problems.warning("", "The seam joins the right side of one piece to the wrong side of the other: reverse it?");
    else if (isTwisted(pattern, seam))
        problems.warning("",
                         "The seam is twisted: where the pieces are placed, its ends lie nearer the other way round.");
}

struct Stretch {
    const SeamPart* part;
    const Seam* seam;
    std::string path;
};

void checkOverlaps(const Pattern& pattern, std::vector<Problem>& all) {
    constexpr double rounding = 1e-9;
    std::vector<Stretch> stretches;
    for (std::size_t s = 0; s < pattern.seams.size(); ++s)
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t i = 0; i < pattern.seams[s].sides[side].size(); ++i)
                stretches.push_back({&pattern.seams[s].sides[side][i], &pattern.seams[s],
                                     fmt::format("seams[{}].{}[{}]", s, sideName(side), i)});
    for (std::size_t i = 0; i < stretches.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const SeamPart &p = *stretches[i].part, &q = *stretches[j].part;
            if (p.piece != q.piece || p.edge != q.edge || std::min(p.to, q.to) - std::max(p.from, q.from) <= rounding)
                continue;
            Problems problems(all, stretches[i].path, placeOf(*stretches[i].seam).object);
            problems.error("", fmt::format("This stretch of the edge \"{}\" is already sewn by the seam \"{}\".",
                                           p.edge.value, stretches[j].seam->name));
        }
}

} // namespace

void checkSeams(const Pattern& pattern, const std::set<PieceId>& unsound, const SeamTolerance& tolerance,
                std::vector<Problem>& all) {
    const auto isMeasurable = [&](const SeamPart& part) {
        return !unsound.contains(shapeOf(pattern, *findPiece(pattern, part.piece))->id);
    };
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const Seam& seam = pattern.seams[i];
        Problems problems(all, fmt::format("seams[{}]", i), placeOf(seam).object);
        checkNumbers(seam, problems);
        if (!checkParts(pattern, seam, problems)) continue;
        for (std::size_t side = 0; side < 2; ++side) checkChain(pattern, seam.sides[side], sideName(side), problems);
        if (!std::ranges::all_of(seam.sides, [&](const auto& side) { return std::ranges::all_of(side, isMeasurable); }))
            continue;
        checkLengths(pattern, seam, tolerance, problems);
        checkDirection(pattern, seam, problems);
    }
    checkOverlaps(pattern, all);
}

} // namespace toile::pattern
