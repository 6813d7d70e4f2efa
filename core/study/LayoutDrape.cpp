// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/LayoutDrape.h"

#include "core/study/Calibration.h"
#include "core/study/ReadBack.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace toile::study {
namespace {

using simulation::StrainSummary;

template <class Whole>
struct Field {
    const char* key;
    double Whole::*member;
};

constexpr std::array strainFields{Field{"warpMaximum", &StrainSummary::warpMaximum},
                                  Field{"weftMaximum", &StrainSummary::weftMaximum},
                                  Field{"shearMaximum", &StrainSummary::shearMaximum},
                                  Field{"warpPercentile99", &StrainSummary::warpPercentile99},
                                  Field{"weftPercentile99", &StrainSummary::weftPercentile99},
                                  Field{"warpPercentile95", &StrainSummary::warpPercentile95},
                                  Field{"weftPercentile95", &StrainSummary::weftPercentile95},
                                  Field{"shearPercentile95", &StrainSummary::shearPercentile95},
                                  Field{"rms", &StrainSummary::rms}};
constexpr std::array partFields{Field{"area", &PartDeformation::area},
                                Field{"strainRms", &PartDeformation::strainRms},
                                Field{"shearRms", &PartDeformation::shearRms},
                                Field{"curvatureRms", &PartDeformation::curvatureRms},
                                Field{"stretchEnergy", &PartDeformation::stretchEnergy},
                                Field{"bendingEnergy", &PartDeformation::bendingEnergy}};

template <class Whole>
Json& write(Json& json, const Whole& whole, const auto& fields) {
    for (const auto& [key, member] : fields) json.set(key, whole.*member);
    return json;
}

template <class Whole>
bool read(const Json* json, Whole& whole, const auto& fields) {
    for (const auto& [key, member] : fields) {
        const double* number = json ? memberOf(*json, key, &Json::asNumber) : nullptr;
        if (!number) return false;
        whole.*member = *number;
    }
    return true;
}

/// Three numbers a point, or null.
Json toJson(const DrapedLattice& lattice) {
    Json::Array numbers;
    for (const auto& point : lattice)
        if (point) numbers.insert(numbers.end(), {point->x, point->y, point->z});
        else numbers.emplace_back();
    return numbers;
}

std::optional<DrapedLattice> latticeFrom(const Json::Array& numbers) {
    DrapedLattice lattice;
    for (auto at = numbers.begin(); at != numbers.end();) {
        if (at->isNull()) {
            lattice.emplace_back();
            ++at;
            continue;
        }
        Vec3 point;
        for (double* coordinate : {&point.x, &point.y, &point.z}) {
            const double* number = at == numbers.end() ? nullptr : at->asNumber();
            if (!number) return std::nullopt;
            *coordinate = *number;
            ++at;
        }
        lattice.emplace_back(point);
    }
    return lattice;
}

Json toJson(const PartDeformation& part) {
    Json json;
    json.set("piece", part.piece).set("region", part.region).set("finer", part.finer);
    return write(json, part, partFields);
}

std::optional<PartDeformation> partFrom(const Json& json) {
    const auto *piece = memberOf(json, "piece", &Json::asString), *region = memberOf(json, "region", &Json::asString);
    const auto* finer = memberOf(json, "finer", &Json::asBool);
    if (!piece || !region || !finer) return std::nullopt;
    PartDeformation part{.piece = *piece, .region = *region, .finer = *finer};
    return read(&json, part, partFields) ? std::optional(part) : std::nullopt;
}

std::optional<LayoutKind> kindNamed(std::string_view name) {
    const auto found = std::ranges::find(layoutKinds, name, [](LayoutKind kind) { return nameOf(kind); });
    return found == layoutKinds.end() ? std::nullopt : std::optional(*found);
}

} // namespace

Result<LayoutGo> drapedBy(const Layout& layout, const pattern::Pattern& drawn, const simulation::SewSettings& settings,
                          std::stop_token stop) {
    auto simulation = simulation::Simulation::create(layout.scene);
    if (!simulation) return tl::unexpected(simulation.error());
    const double start = threadSeconds();
    const auto report = simulation::sew(*simulation, settings, stop);
    if (!report) return tl::unexpected(report.error());
    const double seconds = threadSeconds() - start;
    LayoutResult result{.kind = layout.kind, .spacing = layout.spacing};
    result.particles = report->particles;
    result.springs = report->springsStructural + report->springsShear + report->bending + report->twist;
    for (const auto& stage : report->stages) result.bytes += stage.bytes;
    result.time = runTimeOf({seconds});
    result.atRest = report->atRest;
    result.energy = report->gravityEnergy + report->elasticEnergy;
    result.strain = report->strain;
    return LayoutGo{std::move(result), latticeOf(*simulation), deformationOf(*simulation, drawn), seconds};
}

Json toJson(const LayoutGo& go) {
    const LayoutResult& result = go.result;
    Json json, strain, parts = Json::Array();
    json.set("layout", std::string(nameOf(result.kind))).set("spacing", result.spacing);
    json.set("particles", result.particles).set("springs", result.springs).set("bytes", result.bytes);
    json.set("atRest", result.atRest).set("energy", result.energy).set("cpuSeconds", go.seconds);
    json.set("strain", write(strain, result.strain, strainFields)).set("lattice", toJson(go.lattice));
    for (const PartDeformation& part : go.parts) parts.push(toJson(part));
    return json.set("parts", parts);
}

std::optional<LayoutGo> layoutGoFrom(const Json& json) {
    const auto* name = memberOf(json, "layout", &Json::asString);
    const auto* atRest = memberOf(json, "atRest", &Json::asBool);
    const auto number = [&](const char* key) { return memberOf(json, key, &Json::asNumber); };
    const double *spacing = number("spacing"), *particles = number("particles"), *springs = number("springs"),
                 *bytes = number("bytes"), *energy = number("energy"), *seconds = number("cpuSeconds");
    const auto *numbers = memberOf(json, "lattice", &Json::asArray), *parts = memberOf(json, "parts", &Json::asArray);
    if (!name || !atRest || !spacing || !particles || !springs || !bytes || !energy || !seconds || !numbers || !parts)
        return std::nullopt;
    const auto kind = kindNamed(*name);
    auto lattice = latticeFrom(*numbers);
    if (!kind || !lattice) return std::nullopt;
    LayoutGo go{.result = {.kind = *kind, .spacing = *spacing}, .lattice = std::move(*lattice), .seconds = *seconds};
    LayoutResult& result = go.result;
    result.particles = static_cast<int>(*particles);
    result.springs = static_cast<int>(*springs);
    result.bytes = static_cast<std::size_t>(*bytes);
    result.time = runTimeOf({go.seconds});
    result.atRest = *atRest;
    result.energy = *energy;
    if (!read(json.find("strain"), result.strain, strainFields)) return std::nullopt;
    for (const Json& kept : *parts) {
        auto part = partFrom(kept);
        if (!part) return std::nullopt;
        go.parts.push_back(std::move(*part));
    }
    return go;
}

} // namespace toile::study
