// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Warnings.h"

#include "core/dynamics/SelfContact.h"
#include "core/simulation/BodyThrough.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::simulation {
namespace {

using Warnings = std::vector<Warning>;

/// The name of a seam or tack, with its id where others are called the same.
template <class Named>
std::string labelAmong(const std::vector<Named>& all, std::size_t which) {
    const Named& one = all[which];
    const bool isAlone = std::ranges::count(all, one.name, &Named::name) == 1;
    return isAlone ? fmt::format("\"{}\"", one.name) : fmt::format("\"{}\" ({})", one.name, one.id.value);
}

void warnOfOpenSeams(Warnings& warnings, const Simulation& simulation) {
    for (std::size_t i = 0; i < simulation.seams().size(); ++i)
        if (!simulation.seams()[i].merged)
            warnings.push_back(
                {"seam " + labelAmong(simulation.scene().pattern.seams, i),
                 fmt::format("The seam is not closed; its gap is {:.1f} mm.", 1000 * simulation.gapOf(i).maximum)});
}

void warnOfOpenTacks(Warnings& warnings, const Simulation& simulation) {
    for (std::size_t i = 0; i < simulation.tacks().size(); ++i)
        if (const double gap = simulation.gapOfTack(i); gap > TackSettings{}.closedGap)
            warnings.push_back({"tack " + labelAmong(simulation.scene().pattern.tacks, i),
                                fmt::format("The tack is not closed; its gap is {:.1f} mm.", 1000 * gap)});
}

void warnOfPinsWithoutBody(Warnings& warnings, const Simulation& simulation) {
    if (simulation.body()) return;
    for (const pattern::Pin& pin : simulation.scene().pattern.pins)
        if (pin.toBody)
            warnings.push_back({fmt::format("pin \"{}\"", pin.id.value),
                                "There is no body to which its cloth could be pinned: it stays where it lies."});
}

/// One warning for each place, and no more than a reader can look at.
void warnOfCrossedLayers(Warnings& warnings, const Simulation& simulation) {
    constexpr std::size_t most = 10;
    const auto* contact = dynamic_cast<const dynamics::SelfContact*>(simulation.plan().find("self-contact"));
    if (!contact) return;
    const std::vector<Vec3> places = contact->crossingPlaces(simulation.state().positions);
    for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
        warnings.push_back(
            {fmt::format("({:.3f}, {:.3f}, {:.3f}) m", places[i].x, places[i].y, places[i].z),
             fmt::format("Layers have crossed here and could not be drawn apart ({} of {}).", i + 1, places.size())});
}

void warnOfWrongOrder(Warnings& warnings, const ContactSummary& contact) {
    if (contact.nodesInWrongOrder > 0)
        warnings.push_back(
            {"layers", fmt::format("{} nodes lie behind a piece of a lower layer.", contact.nodesInWrongOrder)});
}

/// Why cloth cuts the body.
std::string_view whyItCuts(const ContactSummary& contact, double skinOffset, bool sticksThrough) {
    if (sticksThrough) return "The body sticks through it.";
    if (contact.bodyClearanceMinimum.value_or(0) < skinOffset / 3) return "Particles are pressed into it as well.";
    return "Its particles keep their distance, but cells are too coarse for how sharply the body is curved there; a "
           "finer spacing or a larger skin offset helps.";
}

void warnOfClothInBody(Warnings& warnings, const Simulation& simulation, const ContactSummary& contact) {
    if (contact.bodyIntersections == 0) return;
    const std::vector<BodyThrough> parts = bodyThrough(simulation);
    for (const BodyThrough& part : parts)
        warnings.push_back({fmt::format("piece \"{}\"", simulation.scene().pattern.pieces[part.piece]->name),
                            fmt::format("The {} sticks through its cloth: start with the piece clear of the body, or "
                                        "with a body that stands otherwise.",
                                        partOf(part))});
    warnings.push_back(
        {"body contact", fmt::format("Cloth cuts the body: {} pairs of triangles meet. {}", contact.bodyIntersections,
                                     whyItCuts(contact, simulation.scene().settings.skinOffset, !parts.empty()))});
}

void warnOfHeldBackCloth(Warnings& warnings, const Simulation& simulation) {
    for (const StepPlan::StageCost& stage : simulation.stageCosts())
        if (stage.heldBack > 0)
            warnings.push_back(
                {stage.name,
                 fmt::format("In {} substeps so much cloth was near, and so fast, that it was held back: its "
                             "pairs would not have found room in memory.",
                             stage.heldBack)});
}

void warnOfUnsolvedSteps(Warnings& warnings, const Simulation& simulation) {
    for (const PhaseRun& phase : simulation.phases()) {
        if (phase.unsolvedSteps == 0) continue;
        const bool byPositions = phase.method == dynamics::nameOf(dynamics::Method::xpbd);
        warnings.push_back(
            {nameOf(phase.phase),
             fmt::format("{} frame steps by {} {} and were taken as they were.", phase.unsolvedSteps, phase.method,
                         byPositions ? "gained energy that nothing gave them"
                                     : "have parts that did not reach their tolerance, or gained energy still,")});
    }
}

/// What to choose where a method had to be helped.
std::string_view adviceInsteadOf(std::string_view method) {
    if (method == dynamics::nameOf(dynamics::Method::xpbd))
        return "More substeps (--substeps), shorter frame steps (--step) or trbdf2 are what to use instead.";
    if (method == dynamics::nameOf(dynamics::Method::trBdf2) ||
        method == dynamics::nameOf(dynamics::Method::backwardEuler))
        return "Shorter frame steps (--step), or xpbd, are what to use instead.";
    return "For cloth so stiff use trbdf2 or xpbd instead, or shorter frame steps (--step).";
}

void warnOfRedoneSteps(Warnings& warnings, const Simulation& simulation) {
    for (const PhaseRun& phase : simulation.phases()) {
        if (phase.redoneSteps == 0) continue;
        const bool byPositions = phase.method == dynamics::nameOf(dynamics::Method::xpbd);
        warnings.push_back(
            {nameOf(phase.phase),
             fmt::format("{} frame steps by {} {} and were made again {}. {}", phase.redoneSteps, phase.method,
                         byPositions ? "did not end in numbers"
                                     : "gained energy that nothing gave them, or did not end in numbers,",
                         byPositions ? "in finer substeps" : "by backward-euler", adviceInsteadOf(phase.method))});
    }
}

void warnOfLimitedSteps(Warnings& warnings, const Simulation& simulation) {
    for (const PhaseRun& phase : simulation.phases())
        if (phase.limitedSteps > 0)
            warnings.push_back({nameOf(phase.phase),
                                fmt::format("In {} frame steps cloth was as fast as {} lets it be, {:.0f} m/s; by "
                                            "trbdf2 it would have been faster.",
                                            phase.limitedSteps, phase.method, speedLimit)});
}

void warnOfRefusedFactor(Warnings& warnings, const Simulation& simulation) {
    if (simulation.refusedFactor() > 0)
        warnings.push_back(
            {"memory",
             fmt::format("A factor of the linear system would have taken {:.3g} MB, which could not be had: conjugate "
                         "gradients solved it alone, which takes longer and may end early. A larger spacing, or more "
                         "memory, is what helps.",
                         1e-6 * static_cast<double>(simulation.refusedFactor()))});
}

} // namespace

std::vector<Warning> warningsOf(const Simulation& simulation, const ContactSummary& contact) {
    Warnings warnings;
    warnOfOpenSeams(warnings, simulation);
    warnOfOpenTacks(warnings, simulation);
    warnOfPinsWithoutBody(warnings, simulation);
    warnOfCrossedLayers(warnings, simulation);
    warnOfHeldBackCloth(warnings, simulation);
    warnOfUnsolvedSteps(warnings, simulation);
    warnOfRedoneSteps(warnings, simulation);
    warnOfLimitedSteps(warnings, simulation);
    warnOfRefusedFactor(warnings, simulation);
    warnOfClothInBody(warnings, simulation, contact);
    warnOfWrongOrder(warnings, contact);
    return warnings;
}

} // namespace toile::simulation
