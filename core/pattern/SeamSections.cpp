// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/SeamSections.h"

#include "core/pattern/PatternMeasures.h"

#include <algorithm>

namespace toile::pattern {
namespace {

struct DeclaredSection {
    SeamSection declared;
    double from = 0, to = 0; ///< along side A [m]
    double wantedEase = 0;   ///< [m]
};

std::vector<DeclaredSection> placedAlong(const Seam& seam, const std::vector<SectionLengths>& lengths) {
    std::vector<DeclaredSection> sections;
    double at = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        sections.push_back({seam.sections[i], at, at + lengths[i].a, lengths[i].wantedEase});
        at += lengths[i].a;
    }
    return sections;
}

/// What is wanted from one place of side A to another, to which this length of side B belongs.
SeamSection wantedBetween(const std::vector<DeclaredSection>& sections, double from, double to, double lengthB) {
    constexpr double rounding = 1e-6; // of shares
    double wanted = 0;
    std::vector<std::optional<double>> ratios;
    for (const DeclaredSection& section : sections) {
        const double share = (std::min(to, section.to) - std::max(from, section.from)) / (section.to - section.from);
        if (!(share > rounding)) continue;
        wanted += share * section.wantedEase;
        ratios.push_back(section.declared.gatherRatio);
    }
    if (std::ranges::none_of(ratios, [](const auto& ratio) { return ratio.has_value(); })) return {wanted, {}};
    const bool alike = std::ranges::all_of(ratios, [&](const auto& ratio) { return ratio == ratios.front(); });
    return {0, alike ? ratios.front() : 1 + wanted / lengthB};
}

} // namespace

void divideSectionsAnew(Pattern& pattern, const Pattern& before) {
    for (Seam& seam : pattern.seams) {
        if (seam.sections.size() < 2) continue;
        Seam undeclared = seam;
        undeclared.sections.clear();
        const auto was = sectionsOf(before, seam), is = sectionsOf(pattern, undeclared);
        if (!was || !is || is->size() == was->size()) continue;
        const std::vector<DeclaredSection> declared = placedAlong(seam, *was);
        seam.sections.clear();
        double at = 0;
        for (const SectionLengths& section : *is) {
            seam.sections.push_back(wantedBetween(declared, at, at + section.a, section.b));
            at += section.a;
        }
    }
}

} // namespace toile::pattern
