// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodySize.h"

#include <array>
#include <fmt/format.h>

namespace toile::io {
namespace {

constexpr double leastHeight = 1.2, mostHeight = 2.3; // of an adult [m]

constexpr std::array units{LengthUnit::metre, LengthUnit::decimetre, LengthUnit::centimetre, LengthUnit::millimetre,
                           LengthUnit::inch};

bool isHeight(double metres) {
    return metres >= leastHeight && metres <= mostHeight;
}

std::optional<LengthUnit> unitThatFits(double height) {
    for (const LengthUnit unit : units)
        if (isHeight(height * metresIn(unit))) return unit;
    return std::nullopt;
}

/// Lying: much longer along z than along y.
bool hasZUp(const geometry::Box3& box) {
    return box.high.z - box.low.z > 1.5 * (box.high.y - box.low.y);
}

void scale(geometry::TriangleMesh& mesh, double factor) {
    for (Vec3& v : mesh.vertices) v = v * factor;
}

std::string tooTallOrSmall(double height, const std::string& advice) {
    return fmt::format("The body is {:.4g} m high; an adult is between {} and {} m. {}", height, leastHeight,
                       mostHeight, advice);
}

} // namespace

double metresIn(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::metre: return 1;
    case LengthUnit::decimetre: return 0.1;
    case LengthUnit::centimetre: return 0.01;
    case LengthUnit::millimetre: return 0.001;
    case LengthUnit::inch: return 0.0254;
    }
    return 1;
}

const char* nameOf(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::metre: return "metres";
    case LengthUnit::decimetre: return "decimetres";
    case LengthUnit::centimetre: return "centimetres";
    case LengthUnit::millimetre: return "millimetres";
    case LengthUnit::inch: return "inches";
    }
    return "metres";
}

Vec3 stoodUp(const Vec3& p) {
    return {p.x, p.z, -p.y};
}

Result<SizedMesh> sizedAsBody(geometry::TriangleMesh mesh, bool formatSaysMetres, std::optional<LengthUnit> told) {
    SizedMesh sized{.mesh = std::move(mesh)};
    geometry::Box3 box = geometry::boundsOf(sized.mesh.vertices);
    if (!formatSaysMetres && hasZUp(box)) {
        for (Vec3& v : sized.mesh.vertices) v = stoodUp(v);
        sized.stoodUp = true;
        box = geometry::boundsOf(sized.mesh.vertices);
        sized.warnings.push_back({"body", "It was lying on its back: z is taken to be up."});
    }
    const double height = box.high.y - box.low.y;
    const auto fitting = unitThatFits(height);
    sized.unit = told ? *told : !formatSaysMetres && fitting ? *fitting : LengthUnit::metre;
    const double metres = height * metresIn(sized.unit);
    if (!isHeight(metres))
        return fail(ErrorCode::invalidInput,
                    fitting ? tooTallOrSmall(metres, fmt::format("Its numbers look like {}: say so, or scale it by {}.",
                                                                 nameOf(*fitting), metresIn(*fitting)))
                            : tooTallOrSmall(metres, "No usual unit makes it one."));
    if (sized.unit != LengthUnit::metre) {
        scale(sized.mesh, metresIn(sized.unit));
        if (!told)
            sized.warnings.push_back({"body", fmt::format("Its numbers are taken to be {}: it is then {:.3g} m high.",
                                                          nameOf(sized.unit), metres)});
    }
    return sized;
}

Result<SizedMesh> scaledToMetres(geometry::TriangleMesh mesh, LengthUnit unit) {
    SizedMesh sized{std::move(mesh), unit, {}};
    scale(sized.mesh, metresIn(unit));
    return sized;
}

} // namespace toile::io
