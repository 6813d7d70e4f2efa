// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/SewSummary.h"

#include "app/batch/Console.h"
#include "core/dynamics/Method.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace toile::batch {
namespace {

/// "sewing by xpbd, draping by rk4 (stable in steps of up to 0.1 ms, of which it took 8000)"
std::string methodsOf(const simulation::SewReport& report) {
    std::string text;
    for (const simulation::PhaseRun& phase : report.phases) {
        text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", nameOf(phase.phase), phase.method);
        if (std::isfinite(phase.steps.limit))
            text += fmt::format(" (stable in steps of up to {:.3g} ms, of which it took {})", 1000 * phase.steps.limit,
                                phase.steps.parts);
    }
    return text;
}

/// "left out: wind, pressure, frame steps (which saved some 0.5 s)"
void printLeftOut(const std::vector<simulation::LeftOut>& leftOut) {
    std::vector<std::string> stages;
    for (const auto& [stage, why, saved] : leftOut)
        stages.push_back(saved > 0 ? fmt::format("{} (which saved some {:.1f} s)", stage, saved) : stage);
    if (!stages.empty()) fmt::print("left out: {}\n", fmt::join(stages, ", "));
}

/// ", residual 4.6e-04", or of what lies still ", but in no equilibrium: residual 6.2e+03".
std::string balanceOf(const simulation::SewReport& report) {
    if (!report.residual) return "";
    const bool onlySlow = report.ending == "at rest" && !report.atRest;
    return fmt::format(", {}residual {:.1e}", onlySlow ? "but in no equilibrium: " : "", *report.residual);
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

} // namespace

void printSummary(const simulation::SewReport& report, const SewOptions& options) {
    std::size_t closed = 0;
    for (const simulation::SeamResult& seam : report.seams) closed += seam.state.merged;
    const auto tacked = std::ranges::count(report.tacks, true, &simulation::TackResult::closed);
    fmt::print("{} particles, {} of {} seams closed, {}{:.2f} s simulated in {:.1f} s; {}{}\n", report.particles,
               closed, report.seams.size(),
               report.tacks.empty() ? "" : fmt::format("{} of {} tacks, ", tacked, report.tacks.size()),
               report.simulatedSeconds, report.wallSeconds,
               report.restWallSeconds && report.ending == "at rest"
                   ? fmt::format("{} after {:.1f} s", report.ending, *report.restWallSeconds)
                   : report.ending,
               balanceOf(report));
    if (report.coarse)
        fmt::print("of it on its own mesh, of {} particles: {:.2f} s simulated in {:.1f} s; {}\n",
                   report.coarse->particles, report.coarse->simulatedSeconds, report.coarse->wallSeconds,
                   report.coarse->ending);
    if (options.paper || options.method != dynamics::nameOf(dynamics::Method::xpbd))
        fmt::print("{}\n", methodsOf(report));
    for (const simulation::FoldReport& fold : report.folds)
        fmt::print("piece \"{}\", fold \"{}\": pressed to {:.0f}°, lies at {:.0f}°, from {:.0f}° to {:.0f}°\n",
                   oneLine(fold.piece), oneLine(fold.name), degrees(fold.restAngle), degrees(fold.mean),
                   degrees(fold.least), degrees(fold.most));
    if (report.contact.bodyClearanceMinimum)
        fmt::print("{:.1f} mm from the body at the nearest, {} intersections with the body, {} with itself\n",
                   1000 * *report.contact.bodyClearanceMinimum, report.contact.bodyIntersections,
                   report.contact.selfIntersections);
    if (report.worn) {
        fmt::print("{}\n", report.worn->worn ? "worn" : "not worn:");
        for (const std::string& why : report.worn->why) fmt::print("  {}\n", oneLine(why));
    }
    printLeftOut(report.leftOut);
    printWarnings(report.warnings);
}

void printWearing(const simulation::WearingReport& wearing) {
    const simulation::ContactSummary& contact = wearing.contact;
    fmt::print("the body moved for {:.2f} s, at {:.1f} m/s at most: ", wearing.seconds, wearing.bodySpeed);
    if (contact.bodyClearanceMinimum)
        fmt::print("{:.1f} mm from it at the nearest, ", 1000 * *contact.bodyClearanceMinimum);
    fmt::print("{} intersections with it, {} of the cloth with itself; the hem rose by {:.0f} mm; {}{}\n",
               contact.bodyIntersections, contact.selfIntersections, 1000 * wearing.hemRise, wearing.after.ending,
               balanceOf(wearing.after));
    constexpr double worthTelling = 1e-4; // [m]
    if (wearing.offItsPin > worthTelling)
        fmt::print("cloth pinned to the body was held back by other cloth, by {:.1f} mm at most\n",
                   1000 * wearing.offItsPin);
}

} // namespace toile::batch
