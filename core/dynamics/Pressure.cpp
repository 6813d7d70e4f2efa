// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Pressure.h"

#include "core/cloth/Forces.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

void addTrueForces(std::span<const Face> faces, std::span<const Vec3> positions, std::span<Vec3> forces) {
    for (const Face& face : faces) {
        const Vec3 share = (face.pressure / 3) * areaOf(face, positions);
        for (const int p : face.particles) forces[p] += share;
    }
}

/// ∂(p·V)/∂x of the cones from the faces to the middle.
void addVolumeForces(std::span<const Face> faces, const Vec3& middle, std::span<const Vec3> positions,
                     std::span<Vec3> forces) {
    for (const Face& face : faces) {
        const double sixth = face.share * face.pressure / 6;
        for (int i = 0; i < 3; ++i)
            forces[face.particles[i]] += sixth * cross(positions[face.particles[(i + 1) % 3]] - middle,
                                                       positions[face.particles[(i + 2) % 3]] - middle);
    }
}

/// Bound of the rows of M⁻¹∂f/∂x [1/s²]: the three blocks of a face are as large as its sides times p/6.
double frequencySquaredOf(const cloth::ClothModel& model, std::span<const Face> faces, std::span<const Vec3> x) {
    std::vector<Vec3> rows(model.mass.size()); // x alone is used: what is handed to masters is a vector
    for (const Face& face : faces) {
        const auto [a, b, c] = face.particles;
        const double sides = distance(x[a], x[b]) + distance(x[b], x[c]) + distance(x[c], x[a]);
        for (const int p : face.particles) rows[p].x += std::abs(face.pressure) * face.share * sides / 6;
    }
    cloth::gatherToMasters(model, rows);
    double largest = 0;
    for (std::size_t p = 0; p < rows.size(); ++p)
        if (model.mass[p] > 0) largest = std::max(largest, rows[p].x / model.mass[p]);
    return largest;
}

} // namespace

Pressure::Pressure(const cloth::ClothModel& model, std::vector<Face> faces, std::span<const Vec3> positions)
    : model_(model), faces_(std::move(faces)) {
    std::erase_if(faces_, [](const Face& face) { return face.pressure == 0; });
    frequencySquared_ = frequencySquaredOf(model, faces_, positions);
}

std::size_t Pressure::bytes() const {
    return faces_.capacity() * sizeof(Face) + (border_.capacity() + forces_.capacity()) * sizeof(Vec3);
}

void Pressure::project(Substep& substep) {
    forces_.assign(substep.positions.size(), {});
    addTrueForces(faces_, substep.positions, forces_);
    moveBy(forces_, model_, substep);
}

/// What the border takes is exact here. The energy goes on from what it was.
void Pressure::beginIteration(std::span<const Vec3> positions) {
    const double before = border_.empty() ? 0 : energy(positions);
    middle_ = {};
    for (const Face& face : faces_)
        for (const int p : face.particles) middle_ += positions[p] / (3.0 * static_cast<double>(faces_.size()));
    std::vector<Vec3> ofVolume(positions.size());
    addVolumeForces(faces_, middle_, positions, ofVolume);
    border_.assign(positions.size(), {});
    addTrueForces(faces_, positions, border_);
    for (std::size_t p = 0; p < border_.size(); ++p) border_[p] -= ofVolume[p];
    datum_ += before - energy(positions);
}

double Pressure::energy(std::span<const Vec3> positions) const {
    double sum = datum_;
    for (const Face& face : faces_) {
        const auto [a, b, c] = face.particles;
        sum -= face.share * face.pressure / 6 *
               dot(positions[a] - middle_, cross(positions[b] - middle_, positions[c] - middle_));
    }
    for (std::size_t p = 0; p < border_.size(); ++p) sum -= dot(border_[p], positions[p] - middle_);
    return sum;
}

void Pressure::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    addVolumeForces(faces_, middle_, positions, forces);
    for (std::size_t p = 0; p < border_.size(); ++p) forces[p] += border_[p];
}

/// −p/6·∂(b × c)/∂b = p/6·[c]×, and so on round the face.
void Pressure::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    for (const Face& face : faces_)
        for (int i = 0; i < 3; ++i) {
            const int p = face.particles[i], q = face.particles[(i + 1) % 3];
            const Vec3 c = (face.share * face.pressure / 6) * (positions[face.particles[(i + 2) % 3]] - middle_);
            sink.add(p, q, {0, -c.z, c.y, c.z, 0, -c.x, -c.y, c.x, 0});
            sink.add(q, p, {0, c.z, -c.y, -c.z, 0, c.x, c.y, -c.x, 0});
        }
}

} // namespace toile::dynamics
