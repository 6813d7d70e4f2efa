// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Shapes.h"
#include "core/io/BodySize.h"
#include "core/io/ToileFile.h"
#include "core/pattern/PatternCheck.h"
#include "core/simulation/Simulation.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <regex>

/// Files that say what cannot be.
namespace toile::study::stability {
namespace {

struct Mutation {
    std::string text;   ///< of the whole file
    std::size_t line;   ///< that was changed, from 1
    std::string number; ///< that stands there now
};

/// A file with each of its numbers replaced, one at a time.
std::vector<Mutation> mutationsOf(const std::string& text) {
    constexpr std::array<const char*, 10> strange{"NaN",   "Infinity", "-1",    "0",    "1e999",
                                                  "1e300", "-1e9",     "\"1\"", "null", "[]"};
    static const std::regex number(R"([-+]?\d+(\.\d+)?([eE][-+]?\d+)?(?=[,\s\]}]))");
    std::vector<Mutation> all;
    for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
        const auto at = static_cast<std::size_t>(found->position()), length = static_cast<std::size_t>(found->length());
        if (at > 0 && text[at - 1] == '"') continue; // a name that begins with a digit
        const auto line =
            static_cast<std::size_t>(1 + std::count(text.begin(), text.begin() + found->position(), '\n'));
        for (const char* other : strange) all.push_back({std::string(text).replace(at, length, other), line, other});
    }
    return all;
}

/// What becomes of a document: a sentence that refuses it, or one frame step in which all stays a number.
struct Outcome {
    bool refused = false;
    std::string problem; ///< neither refused with a sentence nor sound
};

Outcome outcomeOf(const Mutation& mutation) {
    const auto document = io::documentFromText(mutation.text, "mutated.toile");
    if (!document) {
        const std::string& sentence = document.error().text;
        if (toString(document.error()).find("mutated.toile") == std::string::npos || sentence.empty())
            return {true, "refused without naming the file: " + sentence};
        return {true, {}};
    }
    const auto problems = pattern::checkPattern(document->pattern);
    if (std::ranges::any_of(problems, &pattern::Problem::isError)) return {true, {}};
    simulation::Scene scene;
    scene.pattern = document->pattern;
    scene.settings = document->scene;
    auto simulation = simulation::Simulation::create(scene);
    if (!simulation) return {true, simulation.error().text.empty() ? "refused without a sentence" : ""};
    if (const auto done = simulation->advance(); !done)
        return {true, done.error().text.empty() ? "stopped without a sentence" : ""};
    const auto sound = [](const Vec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); };
    if (!std::ranges::all_of(simulation->state().positions, sound)) return {false, "a position is no number"};
    return {};
}

Findings s20MutatedFile(const Effort& effort) {
    document::Document document;
    const simulation::Scene scene = validation::twoSquares(0.05);
    document.pattern = scene.pattern;
    document.scene = scene.settings;
    const std::vector<Mutation> all = mutationsOf(io::toileText(document));
    const std::size_t stride = effort.quick ? 7 : 1;
    int tried = 0, refused = 0;
    std::string problem;
    for (std::size_t i = 0; i < all.size(); i += stride) {
        const Outcome outcome = outcomeOf(all[i]);
        ++tried;
        refused += outcome.refused;
        if (problem.empty() && !outcome.problem.empty())
            problem = fmt::format("line {} with {}: {}", all[i].line, all[i].number, outcome.problem);
    }
    return {
        {tested("S20", fmt::format("{} numbers of a file changed, {} refused, the others simulated", tried, refused),
                problem.empty() && refused > 0, problem)},
        {}};
}

/// A box as tall as nobody is, from a file whose format says metres.
Findings s36BodyOfWrongSize(const Effort&) {
    Findings found;
    for (const double height : {17.0, 0.17}) {
        const auto sized = io::sizedAsBody(
            geometry::box({-0.15 * height, 0, -0.1 * height}, {0.15 * height, height, 0.1 * height}), true, {});
        const std::string sentence = sized ? "" : sized.error().text;
        Row row = mustBeRefused("S36", fmt::format("body {:g} m tall", height), sentence);
        if (sentence.find(" m high") == std::string::npos)
            row = tested("S36", row.what, false, "The unit is not named: " + sentence);
        found.rows.push_back(std::move(row));
    }
    return found;
}

} // namespace

std::vector<Case> fileCases() {
    return {{"S20", "every number of a file changed", s20MutatedFile},
            {"S36", "body 10 or 0.1 times too big", s36BodyOfWrongSize}};
}

} // namespace toile::study::stability
