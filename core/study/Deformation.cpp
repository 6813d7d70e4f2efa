// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Deformation.h"

#include "core/base/Contracts.h"
#include "core/cloth/Curvature.h"
#include "core/cloth/Strain.h"
#include "core/geometry/Polygon.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace toile::study {
namespace {

using pattern::Piece;
using pattern::Region;

bool holds(const Region& region, const Vec2& point) {
    return geometry::windingNumber(region.outline, point) != 0 &&
           std::ranges::none_of(region.holes,
                                [&](const auto& hole) { return geometry::windingNumber(hole, point) != 0; });
}

template <std::size_t N>
Vec2 middleOf(const std::array<int, N>& nodes, const std::vector<Vec2>& material) {
    Vec2 sum;
    for (const int node : nodes) sum = sum + material[node];
    return sum / static_cast<double>(N);
}

/// The sums over a part, before they are divided by its area.
class Part {
public:
    Part(const Piece& piece, const Region* region, const material::Fabric& fabric)
        : fabric_(fabric), region_(region), result_{.piece = piece.name} {
        if (!region) return;
        result_.region = region->name;
        result_.finer = region->refinement > 0;
        factors_ = region->stiffness;
    }
    [[nodiscard]] bool holds(const Vec2& point) const { return !region_ || study::holds(*region_, point); }

    void add(const cloth::Strain& strain) {
        const double warp = strain.warp * strain.warp, weft = strain.weft * strain.weft,
                     shear = strain.shear * strain.shear;
        result_.area += strain.area;
        result_.strainRms += strain.area * (warp + weft) / 2;
        result_.shearRms += strain.area * shear;
        result_.stretchEnergy += strain.area / 2 *
                                 (factors_.stretch * (fabric_.warpStiffness * warp + fabric_.weftStiffness * weft) +
                                  factors_.shear * fabric_.shearStiffness * shear);
    }
    void add(const cloth::Curvature& curvature) {
        const double squared = curvature.area * curvature.value * curvature.value;
        bentArea_ += curvature.area / 2; // every node has a line along weft and one along warp
        result_.curvatureRms += squared / 2;
        result_.bendingEnergy += squared / 2 * factors_.bending * (fabric_.warpBending + fabric_.weftBending) / 2;
    }
    [[nodiscard]] PartDeformation result() const {
        PartDeformation result = result_;
        if (result.area == 0) return result;
        result.strainRms = std::sqrt(result.strainRms / result.area);
        result.shearRms = std::sqrt(result.shearRms / result.area);
        result.stretchEnergy /= result.area;
        if (bentArea_ == 0) return result;
        result.curvatureRms = std::sqrt(result.curvatureRms / bentArea_);
        result.bendingEnergy /= bentArea_;
        return result;
    }

private:
    const material::Fabric& fabric_;
    const Region* region_;
    pattern::StiffnessFactors factors_;
    PartDeformation result_;
    double bentArea_ = 0;
};

/// The piece's regions, then what they leave of it.
std::vector<Part> partsOf(const Piece& piece, const material::Fabric& fabric) {
    std::vector<Part> parts;
    for (const Region& region : piece.regions) parts.emplace_back(piece, &region, fabric);
    parts.emplace_back(piece, nullptr, fabric);
    return parts;
}

Part& partAt(std::vector<Part>& parts, const Vec2& point) {
    return *std::ranges::find_if(parts, [&](const Part& part) { return part.holds(point); }); // the last holds all
}

/// Means over the area of parts that are to be finer, or of the others.
PartDeformation together(const std::vector<PartDeformation>& parts, bool finer) {
    PartDeformation sum;
    for (const PartDeformation& part : parts) {
        if (part.finer != finer) continue;
        sum.area += part.area;
        sum.strainRms += part.area * part.strainRms * part.strainRms;
        sum.curvatureRms += part.area * part.curvatureRms * part.curvatureRms;
        sum.stretchEnergy += part.area * part.stretchEnergy;
        sum.bendingEnergy += part.area * part.bendingEnergy;
    }
    if (sum.area == 0) return sum;
    sum.strainRms = std::sqrt(sum.strainRms / sum.area);
    sum.curvatureRms = std::sqrt(sum.curvatureRms / sum.area);
    sum.stretchEnergy /= sum.area;
    sum.bendingEnergy /= sum.area;
    return sum;
}

} // namespace

std::vector<PartDeformation> deformationOf(const simulation::Simulation& simulation, const pattern::Pattern& drawn) {
    std::vector<PartDeformation> all;
    const auto& garment = simulation.garment();
    for (std::size_t i = 0; i < drawn.pieces.size(); ++i) {
        const Piece piece = pattern::resolved(drawn, *drawn.pieces[i]);
        const material::Fabric* fabric = pattern::findFabric(drawn, piece.fabric);
        expects(fabric != nullptr, "a garment's pieces have fabrics");
        const cloth::Patch patch = simulation::elementsOf(garment, i);
        std::vector<Part> parts = partsOf(piece, *fabric);
        const std::vector<cloth::Strain> strains = cloth::strains(patch, simulation.state().positions);
        for (std::size_t e = 0; e < strains.size(); ++e)
            partAt(parts, e < patch.rectangles.size()
                              ? middleOf(patch.rectangles[e].nodes, patch.material)
                              : middleOf(patch.triangles[e - patch.rectangles.size()].nodes, patch.material))
                .add(strains[e]);
        for (const cloth::Curvature& curvature : cloth::curvatures(patch, simulation.state().positions))
            partAt(parts, patch.material[curvature.node]).add(curvature);
        for (const Part& part : parts) all.push_back(part.result());
    }
    return all;
}

std::string deformationText(const std::vector<PartDeformation>& parts) {
    std::string text =
        "| piece | part | area cm² | rms strain % | rms shear ° | rms curvature 1/m | stretching mJ/m² | "
        "bending mJ/m² |\n|---|---|---|---|---|---|---|---|\n";
    for (const PartDeformation& part : parts)
        if (part.area > 0)
            text += fmt::format("| {} | {}{} | {:.0f} | {:.2f} | {:.2f} | {:.1f} | {:.3g} | {:.3g} |\n", part.piece,
                                part.region.empty() ? "rest" : part.region, part.finer ? " (finer)" : "",
                                1e4 * part.area, 100 * part.strainRms, part.shearRms * 180 / std::numbers::pi,
                                part.curvatureRms, 1e3 * part.stretchEnergy, 1e3 * part.bendingEnergy);
    const PartDeformation finer = together(parts, true), others = together(parts, false);
    if (finer.area == 0 || others.area == 0) return text;
    return text +
           fmt::format("\nWhere the mesh is to be finer the cloth stores {:.2g} times the stretching energy and "
                       "{:.2g} times the bending energy per area of the other cloth (rms strain {:.2f} % against "
                       "{:.2f} %, rms curvature {:.1f} 1/m against {:.1f}). **{}**\n",
                       finer.stretchEnergy / others.stretchEnergy, finer.bendingEnergy / others.bendingEnergy,
                       100 * finer.strainRms, 100 * others.strainRms, finer.curvatureRms, others.curvatureRms,
                       finer.energy() > others.energy() ? "The regions lie where the cloth deforms more."
                                                        : "The cloth deforms less there than elsewhere.");
}

} // namespace toile::study
