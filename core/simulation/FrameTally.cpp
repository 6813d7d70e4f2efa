// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/FrameTally.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::simulation {
namespace {

std::string describe(const FrameTally::Kind& kind, std::string_view what) {
    if (kind.frames == 0) return fmt::format("none with intersections {}", what);
    return fmt::format("{} with intersections {}, up to {}, the last at {:.2f} s", kind.frames, what, kind.most,
                       *kind.last);
}

Json toJson(const FrameTally::Kind& kind) {
    Json json;
    json.set("frames", kind.frames).set("most", kind.most);
    return json.set("last", kind.last ? Json(*kind.last) : Json());
}

} // namespace

void FrameTally::Kind::add(double time, int pairs) {
    if (pairs == 0) return;
    ++frames;
    most = std::max(most, pairs);
    last = time;
}

void FrameTally::add(double time, Intersections seen) {
    ++frames;
    withBody.add(time, seen.body);
    withItself.add(time, seen.self);
    atOpenSeams.add(time, seen.atOpenSeams);
}

std::string describe(const FrameTally& tally) {
    return fmt::format("{} frames: {}; {}; {}", tally.frames, describe(tally.withBody, "with the body"),
                       describe(tally.withItself, "of the cloth with itself"),
                       describe(tally.atOpenSeams, "beside seams that close"));
}

Json toJson(const FrameTally& tally) {
    Json json;
    json.set("count", tally.frames).set("withBody", toJson(tally.withBody));
    return json.set("withItself", toJson(tally.withItself)).set("atOpenSeams", toJson(tally.atOpenSeams));
}

} // namespace toile::simulation
