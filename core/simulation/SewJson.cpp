// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"
#include "core/simulation/Wearing.h"

#include <cmath>
#include <numbers>

namespace toile::simulation {
namespace {

template <class Range, class ToJson>
Json listOf(const Range& range, ToJson itemToJson) {
    Json list(Json::Array{});
    for (const auto& item : range) list.push(itemToJson(item));
    return list;
}

Json toJson(const SeamResult& seam) {
    Json json;
    json.set("name", seam.state.name).set("pairs", seam.state.pairs).set("initialGap", seam.state.initialGap);
    json.set("gapAtMergeMaximum", seam.state.merged ? Json(seam.state.gapAtMerge) : Json());
    json.set("maximumGap", seam.gap.maximum).set("meanGap", seam.gap.mean);
    json.set("merged", seam.state.merged).set("closed", seam.state.merged);
    return json;
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

Json toJson(const FoldReport& fold) {
    Json json;
    json.set("piece", fold.piece).set("name", fold.name).set("foldAngleDegrees", degrees(fold.restAngle));
    json.set("meanAngleDegrees", degrees(fold.mean));
    return json.set("leastAngleDegrees", degrees(fold.least)).set("mostAngleDegrees", degrees(fold.most));
}

Json toJson(const TackResult& tack) {
    Json json;
    json.set("name", tack.name).set("initialGap", tack.initialGap).set("gap", tack.gap);
    return json.set("closed", tack.closed);
}

Json toJson(const OpeningReport& opening) {
    Json json;
    json.set("name", opening.name)
        .set("crossings", opening.crossings)
        .set("limbs", listOf(opening.limbs, [](const auto& l) { return Json(l); }));
    json.set("perimeter", opening.perimeter).set("height", opening.height);
    return json;
}

Json numberOrNull(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json stretchJson(const std::optional<StrainSummary>& woven) {
    const auto value = [&](double StrainSummary::*member) { return woven ? Json((*woven).*member) : Json(); };
    Json json;
    json.set("warpPercentile99", value(&StrainSummary::warpPercentile99))
        .set("warpMaximum", value(&StrainSummary::warpMaximum));
    return json.set("weftPercentile99", value(&StrainSummary::weftPercentile99))
        .set("weftMaximum", value(&StrainSummary::weftMaximum));
}

Json toJson(const std::optional<WornReport>& worn) {
    Json json;
    if (!worn) {
        json.set("verdict", nullptr)
            .set("why", Json(Json::Array{"The scene has no body with limbs."}))
            .set("openings", nullptr);
        return json.set("rightSideOut", nullptr)
            .set("turnedLength", nullptr)
            .set("landmarks", nullptr)
            .set("stretch", nullptr);
    }
    json.set("verdict", worn->worn).set("why", listOf(worn->why, [](const auto& reason) { return Json(reason); }));
    json.set("openings", listOf(worn->openings, [](const OpeningReport& opening) { return toJson(opening); }));
    json.set("rightSideOut", worn->rightSideOut).set("turnedLength", worn->turnedLength);
    Json landmarks;
    landmarks.set("napeDistance", numberOrNull(worn->napeDistance));
    landmarks.set("necklineWiderBy", numberOrNull(worn->necklineWiderBy));
    landmarks.set("symmetryDifference", numberOrNull(worn->symmetryDifference));
    landmarks.set("waistDrop", numberOrNull(worn->waistDrop));
    return json.set("landmarks", landmarks).set("stretch", stretchJson(worn->wovenStrain));
}

Json toJson(const ContactSummary& contact) {
    Json json;
    json.set("bodyPenetrationMaximum", contact.bodyPenetrationMaximum);
    json.set("bodyClearanceMinimum", numberOrNull(contact.bodyClearanceMinimum));
    json.set("selfIntersections", contact.selfIntersections).set("bodyIntersections", contact.bodyIntersections);
    json.set("nodesInWrongOrder", contact.nodesInWrongOrder);
    json.set("outsideBody", contact.outsideBody).set("layersApart", contact.layersApart);
    return json.set("guarantee", contact.guarantee);
}

Json toJson(const std::optional<cloth::PaperReport>& paper) {
    Json json;
    json.set("triangles", paper ? Json(paper->triangles) : Json());
    json.set("fitResidual", paper ? Json(paper->fitResidual) : Json());
    return json.set("droppedBending", paper ? Json(paper->droppedBending) : Json());
}

Json toJson(const std::optional<CoarseRun>& coarse) {
    Json json;
    json.set("particles", coarse ? Json(coarse->particles) : Json());
    json.set("steps", coarse ? Json(coarse->steps) : Json());
    json.set("simulatedSeconds", coarse ? Json(coarse->simulatedSeconds) : Json());
    json.set("cpuSeconds", coarse ? Json(coarse->cpuSeconds) : Json());
    json.set("wallSeconds", coarse ? Json(coarse->wallSeconds) : Json());
    return json.set("ending", coarse ? Json(coarse->ending) : Json());
}

} // namespace

Json toJson(const SewReport& report) {
    Json json;
    json.set("particles", report.particles);
    Json springs;
    springs.set("structural", report.springsStructural).set("shear", report.springsShear);
    springs.set("flexion", report.flexion).set("bending", report.bending).set("twist", report.twist);
    json.set("springs", springs);
    json.set("seams", listOf(report.seams, [](const SeamResult& seam) { return toJson(seam); }));
    json.set("folds", listOf(report.folds, [](const FoldReport& fold) { return toJson(fold); }));
    json.set("tacks", listOf(report.tacks, [](const TackResult& tack) { return toJson(tack); }));
    json.set("worn", toJson(report.worn));
    json.set("contact", toJson(report.contact));
    json.set("mass", report.mass).set("clampedCells", report.clampedCells).set("paper", toJson(report.paper));
    json.set("finishDisplacementMaximum", numberOrNull(report.finishDisplacementMaximum));
    json.set("finishSeconds", numberOrNull(report.finishSeconds));
    Json strain;
    strain.set("warpMaximum", report.strain.warpMaximum).set("weftMaximum", report.strain.weftMaximum);
    strain.set("warpPercentile99", report.strain.warpPercentile99)
        .set("weftPercentile99", report.strain.weftPercentile99);
    strain.set("shearMaximum", report.strain.shearMaximum).set("rms", report.strain.rms);
    json.set("strain", strain);
    Json curvature;
    curvature.set("rms", report.curvature.rms).set("alternating", report.curvature.alternating);
    json.set("curvature", curvature);
    json.set("simulatedSeconds", report.simulatedSeconds).set("heldSeconds", report.heldSeconds);
    json.set("sleptSeconds", report.sleptSeconds);
    json.set("sleptSavedSeconds", report.sleptSavedSeconds);
    json.set("sleptApartSteps", report.sleptApartSteps);
    json.set("sleptApartSavedSeconds", report.sleptApartSavedSeconds);
    json.set("cpuSeconds", report.cpuSeconds).set("wallSeconds", report.wallSeconds);
    json.set("restWallSeconds", numberOrNull(report.restWallSeconds));
    json.set("coarse", toJson(report.coarse));
    json.set("steps", report.steps).set("substeps", report.substeps);
    json.set("atRest", report.atRest).set("ending", report.ending).set("residual", numberOrNull(report.residual));
    Json energy;
    energy.set("kinetic", report.kineticEnergy)
        .set("gravity", report.gravityEnergy)
        .set("elastic", report.elasticEnergy);
    json.set("energy", energy);
    json.set("refusedFactorBytes", report.refusedFactorBytes);
    json.set("peakBytes", report.peakBytes).set("resultHash", report.resultHash);
    json.set("phases", listOf(report.phases, [](const PhaseRun& phase) {
                 Json item;
                 item.set("name", nameOf(phase.phase))
                     .set("method", std::string(phase.method))
                     .set("simulatedSeconds", phase.seconds);
                 item.set("stepLimit", std::isfinite(phase.steps.limit) ? Json(phase.steps.limit) : Json());
                 item.set("parts", phase.steps.parts).set("newtonIterations", phase.steps.newtonIterations);
                 item.set("factorizations", phase.steps.factorizations)
                     .set("gradientIterations", phase.steps.gradientIterations);
                 item.set("repeatedParts", phase.steps.repeated).set("redoneSteps", phase.redoneSteps);
                 item.set("unsolvedSteps", phase.unsolvedSteps);
                 return item;
             }));
    json.set("stages", listOf(report.stages, [&](const StageShare& stage) {
                 Json item;
                 item.set("name", stage.name).set("seconds", stage.seconds);
                 item.set("share", report.wallSeconds > 0 ? stage.seconds / report.wallSeconds : 0.0)
                     .set("bytes", stage.bytes);
                 return item;
             }));
    json.set("leftOut", listOf(report.leftOut, [](const LeftOut& left) {
                 Json item;
                 item.set("stage", left.stage).set("why", left.why);
                 return item;
             }));
    json.set("warnings", listOf(report.warnings, [](const Warning& warning) {
                 Json item;
                 item.set("place", warning.place).set("text", warning.text);
                 return item;
             }));
    return json;
}

Json toJson(const WearingReport& report) {
    Json json;
    json.set("seconds", report.seconds).set("steps", report.steps).set("bodySpeedMaximum", report.bodySpeed);
    json.set("bodyPenetrationMaximum", report.contact.bodyPenetrationMaximum);
    json.set("bodyClearanceMinimum", numberOrNull(report.contact.bodyClearanceMinimum));
    json.set("bodyIntersections", report.contact.bodyIntersections);
    json.set("selfIntersections", report.contact.selfIntersections);
    json.set("outsideBody", report.contact.outsideBody).set("offItsPinMaximum", report.offItsPin);
    json.set("hemRise", report.hemRise);
    json.set("atRest", report.after.atRest);
    json.set("residual", numberOrNull(report.after.residual));
    json.set("warpMaximum", report.after.strain.warpMaximum).set("weftMaximum", report.after.strain.weftMaximum);
    json.set("cpuSeconds", report.cpuSeconds + report.after.cpuSeconds);
    return json.set("resultHash", report.after.resultHash);
}

} // namespace toile::simulation
