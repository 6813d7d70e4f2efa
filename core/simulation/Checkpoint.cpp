// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Checkpoint.h"

#include "core/base/Sha256.h"

#include <span>

namespace toile::simulation {
namespace {

/// Numbers whose order is the same in equal scenes.
struct Numbers {
    std::vector<double> all;

    template <class... Values>
    void add(Values... values) {
        (all.push_back(static_cast<double>(values)), ...);
    }
    void add(const Vec3& v) { add(v.x, v.y, v.z); }
    void add(const material::MembraneStiffness& s) { add(s.c11, s.c12, s.c22, s.c33); }
};

void addMesh(Numbers& numbers, const meshing::GarmentMesh& mesh) {
    for (const meshing::PieceMesh& piece : mesh.pieces) {
        for (const Vec2 p : piece.material) numbers.add(p.x, p.y);
        for (const auto& [a, b, c] : piece.display) numbers.add(a, b, c);
    }
    for (const meshing::SeamNodes& seam : mesh.seams)
        for (const auto& [a, b] : seam.pairs) numbers.add(a.piece, a.node, b.piece, b.node);
}

void addModel(Numbers& numbers, const Garment& garment) {
    const cloth::ClothModel& model = garment.model;
    for (const double m : model.mass) numbers.add(m);
    for (const int p : model.pinned) numbers.add(p);
    for (const int p : garment.pinnedToBody) numbers.add(p);
    for (const auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        for (const cloth::Spring& s : *springs) numbers.add(s.a, s.b, s.restLength, s.stiffness);
    for (const auto* stencils : {&model.bending, &model.twist})
        for (const cloth::Stencil& s : *stencils) {
            for (const double c : s.coefficients) numbers.add(c);
            numbers.add(s.stiffness);
        }
    for (const cloth::Hinge& h : model.hinges) numbers.add(h.restAngle, h.stiffness);
    for (const auto& t : model.triangles) numbers.add(t.stiffness);
    for (const auto& c : model.cells) numbers.add(c.stiffness);
    if (!model.tensionCurves.empty()) {
        for (const auto& t : model.triangles) numbers.add(t.tension);
        for (const auto& c : model.cells) numbers.add(c.tension);
    }
    for (const cloth::TensionCurves& curves : model.tensionCurves)
        for (const auto* curve : {&curves.warp, &curves.weft}) {
            numbers.add(curve->size());
            for (const material::TensionPoint& point : *curve) numbers.add(point.strain, point.modulusFactor);
        }
    for (const double t : garment.halfThickness) numbers.add(t);
    for (const double f : garment.friction) numbers.add(f);
}

/// What the mesh and the merged cloth do not tell of a seam, where it is not plain.
void addSeam(Numbers& numbers, std::size_t index, const pattern::Seam& seam) {
    if (seam.order != 0) numbers.add(index, seam.order);
    if (seam.foldAngle != 0 || seam.stiffnessFactor != 1) numbers.add(index, seam.foldAngle, seam.stiffnessFactor);
    if (seam.elastic) numbers.add(index, seam.elastic->ratio, seam.elastic->stiffness);
    for (const pattern::SeamSection& section : seam.sections)
        if (section != pattern::SeamSection{}) numbers.add(index, section.ease, section.gatherRatio.value_or(0));
}

} // namespace

std::string fingerprintOf(const Scene& scene, const Garment& garment) {
    Numbers numbers;
    addMesh(numbers, *garment.mesh);
    addModel(numbers, garment);
    if (scene.body)
        for (const Vec3& v : (*scene.body)->mesh.vertices) numbers.add(v);
    for (const pattern::Tack& tack : scene.pattern.tacks) {
        for (const pattern::ClothPoint& end : tack.ends) numbers.add(end.point.x, end.point.y);
        numbers.add(tack.order);
    }
    for (std::size_t i = 0; i < scene.pattern.pieces.size(); ++i) {
        const pattern::Piece& piece = *scene.pattern.pieces[i];
        if (piece.pressure != 0) numbers.add(i, piece.pressure);
        if (piece.layer != 0) numbers.add(i, piece.layer);
    }
    for (std::size_t i = 0; i < scene.pattern.seams.size(); ++i) addSeam(numbers, i, scene.pattern.seams[i]);
    const SceneSettings& s = scene.settings;
    if (s.air) {
        numbers.add(s.air->wind);
        numbers.add(s.air->drag);
    }
    numbers.add(s.gravity);
    if (s.strainDamping != 0) numbers.add(s.strainDamping);
    numbers.add(s.damping, s.skinOffset, s.bodyFriction, s.seamTime, s.frameStep, s.substeps, s.selfContact,
                scene.paper);
    return sha256(std::as_bytes(std::span(numbers.all)));
}

} // namespace toile::simulation
