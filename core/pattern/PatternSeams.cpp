// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternSeams.h"

#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

constexpr double sameFraction = 1e-9;

bool shareStretch(const SeamPart& part, const EdgePick& pick) {
    return part.piece == pick.piece && part.edge == pick.edge &&
           std::min(part.to, pick.to) - std::max(part.from, pick.from) > sameFraction;
}

/// A mirror image's contour runs against its source's edges.
bool isImage(const Pattern& pattern, const PieceId& piece) {
    return findPiece(pattern, piece)->mirror.has_value();
}

/// Walked along the contours of the pieces, as they are seen.
std::vector<SeamPart> alongContours(const Pattern& pattern, std::span<const EdgePick> picks) {
    std::vector<SeamPart> parts;
    for (const EdgePick& pick : picks)
        parts.push_back({pick.piece, pick.edge, pick.from, pick.to, isImage(pattern, pick.piece)});
    return parts;
}

std::vector<SeamPart> turnedRound(std::vector<SeamPart> parts) {
    std::ranges::reverse(parts);
    for (SeamPart& part : parts) part.reversed = !part.reversed;
    return parts;
}

struct Ends {
    Vec3 first, last;
};

/// Where a chain begins and ends in space; none where a piece is not placed.
std::optional<Ends> endsOf(const Pattern& pattern, const std::vector<SeamPart>& parts) {
    const auto place = [&](const SeamPart& part, bool first) -> std::optional<Vec3> {
        const Piece* piece = findPiece(pattern, part.piece);
        const auto points = partPoints(pattern, part, 0.01);
        if (points.empty() || !piece->placement) return std::nullopt;
        return placed(*piece->placement, first ? points.front() : points.back());
    };
    if (parts.empty()) return std::nullopt;
    const auto first = place(parts.front(), true), last = place(parts.back(), false);
    if (!first || !last) return std::nullopt;
    return Ends{*first, *last};
}

Result<void> canBeSewn(const Pattern& pattern, const EdgePick& pick) {
    const Piece* piece = findPiece(pattern, pick.piece);
    if (!piece) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", pick.piece.value));
    const Piece* shape = shapeOf(pattern, *piece);
    if (!shape || !findEdge(*shape, pick.edge))
        return fail(ErrorCode::notFound, fmt::format("There is no edge \"{}\".", pick.edge.value), placeOf(*piece));
    if (!(pick.from >= 0 && pick.to <= 1 && pick.to - pick.from > sameFraction))
        return fail(ErrorCode::invalidInput, "A seam runs over a stretch between the ends of an edge.",
                    placeOf(*piece));
    if (const Seam* other = seamOver(pattern, pick))
        return fail(ErrorCode::invalidInput,
                    fmt::format("This stretch is already sewn by the seam \"{}\".", other->name), placeOf(*piece));
    return {};
}

/// Every pick can be sewn, and no stretch is picked twice.
Result<void> allCanBeSewn(const Pattern& pattern, std::span<const EdgePick> a, std::span<const EdgePick> b) {
    if (a.empty() || b.empty()) return fail(ErrorCode::invalidInput, "A seam joins two sides: pick an edge for each.");
    std::vector<EdgePick> picks(a.begin(), a.end());
    picks.insert(picks.end(), b.begin(), b.end());
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (auto ok = canBeSewn(pattern, picks[i]); !ok) return ok;
        for (std::size_t j = 0; j < i; ++j)
            if (shareStretch({picks[j].piece, picks[j].edge, picks[j].from, picks[j].to}, picks[i]))
                return fail(ErrorCode::invalidInput, "A stretch cannot be sewn to itself.",
                            placeOf(*findPiece(pattern, picks[i].piece)));
    }
    return {};
}

std::string defaultName(const Pattern& pattern, const PieceId& a, const PieceId& b) {
    return fmt::format("{} – {}", findPiece(pattern, a)->name, findPiece(pattern, b)->name);
}

Result<Pattern> changedSection(const Pattern& pattern, const SeamId& id, std::size_t section,
                               const std::function<Result<void>(Seam&, SeamSection&)>& change) {
    return changed(pattern, id, [&](Seam& seam) -> Result<void> {
        const auto sections = sectionsOf(pattern, seam);
        const std::size_t count = sections ? sections->size() : sectionCount(pattern, seam);
        if (section >= count)
            return fail(ErrorCode::invalidInput, fmt::format("This seam has {} sections.", count), placeOf(seam));
        seam.sections.resize(count);
        return change(seam, seam.sections[section]);
    });
}

/// Every section declared anew, by its lengths.
template <class Declare>
Result<Pattern> declared(const Pattern& pattern, const SeamId& seam, Declare declare) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        s.sections.clear();
        const auto sections = sectionsOf(pattern, s);
        if (!sections) return fail(ErrorCode::invalidInput, "This seam names an edge that does not exist.", placeOf(s));
        for (const SectionLengths& section : *sections) s.sections.push_back(declare(section));
        return {};
    });
}

} // namespace

Result<Pattern> addSeam(const Pattern& pattern, std::span<const EdgePick> a, std::span<const EdgePick> b,
                        std::string name, IdSource& ids) {
    if (auto ok = allCanBeSewn(pattern, a, b); !ok) return tl::unexpected<Error>(std::move(ok).error());
    Seam seam;
    seam.id = ids.take<SeamId>();
    seam.name = name.empty() ? defaultName(pattern, a.front().piece, b.front().piece) : std::move(name);
    seam.sides = {alongContours(pattern, a), turnedRound(alongContours(pattern, b))};
    if (isTwisted(pattern, seam)) seam.sides[1] = turnedRound(seam.sides[1]);
    Pattern next = pattern;
    next.seams.push_back(std::move(seam));
    return next;
}

Result<Pattern> addSeam(const Pattern& pattern, const EdgePick& a, const EdgePick& b, IdSource& ids) {
    return addSeam(pattern, std::span(&a, 1), std::span(&b, 1), {}, ids);
}

Result<Pattern> addSeam(const Pattern& pattern, std::array<std::vector<SeamPart>, 2> sides, std::string name,
                        IdSource& ids) {
    std::array<std::vector<EdgePick>, 2> picks;
    for (std::size_t side = 0; side < 2; ++side)
        for (const SeamPart& part : sides[side]) picks[side].push_back({part.piece, part.edge, part.from, part.to});
    if (auto ok = allCanBeSewn(pattern, picks[0], picks[1]); !ok) return tl::unexpected<Error>(std::move(ok).error());
    Seam seam;
    seam.id = ids.take<SeamId>();
    seam.name = name.empty() ? defaultName(pattern, picks[0].front().piece, picks[1].front().piece) : std::move(name);
    seam.sides = std::move(sides);
    Pattern next = pattern;
    next.seams.push_back(std::move(seam));
    return next;
}

Result<Pattern> reverseSeam(const Pattern& pattern, const SeamId& seam) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        s.sides[1] = turnedRound(std::move(s.sides[1]));
        return {};
    });
}

Result<Pattern> removeSeam(const Pattern& pattern, const SeamId& seam) {
    return changed(pattern, seam, [](Seam&) { return Result<void>(); }).map([&](Pattern next) {
        std::erase_if(next.seams, [&](const Seam& s) { return s.id == seam; });
        return next;
    });
}

Result<Pattern> setSeamEase(const Pattern& pattern, const SeamId& seam, std::size_t section, double ease) {
    return changedSection(pattern, seam, section, [&](Seam& whole, SeamSection& s) -> Result<void> {
        if (!std::isfinite(ease))
            return fail(ErrorCode::invalidInput, "The ease must be a finite length.", placeOf(whole));
        s = {ease, std::nullopt};
        return {};
    });
}

Result<Pattern> easeAway(const Pattern& pattern, const SeamId& seam) {
    return declared(pattern, seam, [](const SectionLengths& lengths) {
        return SeamSection{lengths.a - lengths.b, std::nullopt};
    });
}

Result<Pattern> gatherAway(const Pattern& pattern, const SeamId& seam) {
    return declared(pattern, seam, [](const SectionLengths& lengths) { return SeamSection{0, lengths.a / lengths.b}; });
}

bool isGathered(const Seam& seam) {
    return std::ranges::any_of(seam.sections, [](const SeamSection& s) { return s.gatherRatio.has_value(); });
}

bool isGatherRatio(double ratio) {
    return ratio > 0.01 && ratio < 100;
}

Result<Pattern> setGatherRatio(const Pattern& pattern, const SeamId& seam, std::size_t section, double ratio) {
    return changedSection(pattern, seam, section, [&](Seam& whole, SeamSection& s) -> Result<void> {
        if (!isGatherRatio(ratio))
            return fail(ErrorCode::invalidInput, "A gather ratio lies between 0.01 and 100.", placeOf(whole));
        s = {0, ratio};
        return {};
    });
}

Result<Pattern> setFoldAngle(const Pattern& pattern, const SeamId& seam, double angle) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        if (!(std::abs(angle) < 3.2)) return fail(ErrorCode::invalidInput, "A fold angle is at most 180°.", placeOf(s));
        s.foldAngle = angle;
        return {};
    });
}

Result<Pattern> setSeamStiffness(const Pattern& pattern, const SeamId& seam, double factor) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        if (!(factor > 0 && std::isfinite(factor)))
            return fail(ErrorCode::invalidInput, "A stiffness factor must be positive.", placeOf(s));
        s.stiffnessFactor = factor;
        return {};
    });
}

Result<Pattern> setElastic(const Pattern& pattern, const SeamId& seam, std::optional<Elastic> elastic) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        if (elastic)
            if (const auto ok = checked(*elastic); !ok)
                return fail(ErrorCode::invalidInput, ok.error().text, placeOf(s));
        s.elastic = elastic;
        return {};
    });
}

Result<void> checked(const Elastic& elastic) {
    if (!(elastic.ratio > 0 && elastic.ratio < 1))
        return fail(ErrorCode::invalidInput,
                    fmt::format("An elastic is shorter than its seam: its ratio is {}, but must be between 0 and 1.",
                                elastic.ratio),
                    {.path = "ratio"});
    if (!(elastic.stiffness > 0 && std::isfinite(elastic.stiffness)))
        return fail(ErrorCode::invalidInput,
                    fmt::format("The stiffness of an elastic is {} N, but must be positive.", elastic.stiffness),
                    {.path = "stiffness"});
    return {};
}

Result<Pattern> setSeamOrder(const Pattern& pattern, const SeamId& seam, int order) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        s.order = order;
        return {};
    });
}

Result<Pattern> renameSeam(const Pattern& pattern, const SeamId& seam, std::string name) {
    return changed(pattern, seam, [&](Seam& s) -> Result<void> {
        s.name = std::move(name);
        return {};
    });
}

bool isTwisted(const Pattern& pattern, const Seam& seam) {
    constexpr double clearly = 0.9; // nearly equal sums (a dart laid flat, an edge folded on itself) decide nothing
    const auto a = endsOf(pattern, seam.sides[0]), b = endsOf(pattern, seam.sides[1]);
    if (!a || !b) return false;
    const double straight = geometry::distance(a->first, b->first) + geometry::distance(a->last, b->last);
    const double crossed = geometry::distance(a->first, b->last) + geometry::distance(a->last, b->first);
    return crossed < clearly * straight;
}

const Seam* seamOver(const Pattern& pattern, const EdgePick& stretch) {
    for (const Seam& seam : pattern.seams)
        for (const auto& side : seam.sides)
            if (std::ranges::any_of(side, [&](const SeamPart& part) { return shareStretch(part, stretch); }))
                return &seam;
    return nullptr;
}

} // namespace toile::pattern
