// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "samples/Blouse.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>

namespace toile::simulation {

/// Made once for all tests of a program: it takes a second.
inline const body::Mannequin& mannequin() {
    static const body::Mannequin made = *body::makeMannequin({});
    return made;
}

/// The one the blouse is drafted for.
inline const body::Mannequin& blouseWearer() {
    static const body::Mannequin made = *body::makeMannequin(samples::blouseWearer());
    return made;
}

inline pattern::Pattern blouseAt(double spacing) {
    return samples::blouse(blouseWearer().measurements, blouseWearer().body, {.spacing = spacing}).value().pattern;
}

inline Scene onBlouseWearer(pattern::Pattern pattern) {
    return {std::move(pattern), Shared<body::Body>(blouseWearer().body), {}};
}

inline Scene onMannequin(pattern::Pattern pattern) {
    return {std::move(pattern), Shared<body::Body>(mannequin().body), {}};
}

/// The garment after so many simulated seconds, without the finish by statics: it does not have to be at rest.
inline SewReport sewnFor(double seconds, const Scene& scene) {
    return sewn(scene, {.seconds = seconds});
}

/// One of the reasons why the garment is not worn holds these words.
inline bool says(const SewReport& report, const std::string& words) {
    return std::ranges::any_of(report.worn->why,
                               [&](const std::string& why) { return why.find(words) != std::string::npos; });
}

/// The limbs that pass through its openings, in the order of the alphabet.
inline std::vector<std::string> openingsOf(const SewReport& report) {
    std::vector<std::string> names;
    for (const OpeningReport& opening : report.worn->openings)
        names.push_back(opening.crossings == 1 ? opening.name : opening.name + ", not crossed once");
    std::ranges::sort(names);
    return names;
}

/// For the messages of failing tests.
inline std::string reasonsOf(const SewReport& report) {
    std::string all;
    for (const std::string& why : report.worn->why) all += why + " ";
    return all;
}

} // namespace toile::simulation
