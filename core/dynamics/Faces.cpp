// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Faces.h"

#include "core/cloth/Forces.h"

namespace toile::dynamics {

void appendRectangle(std::vector<Face>& faces, const std::array<int, 4>& particles, double mass, double pressure) {
    for (int corner = 0; corner < 4; ++corner)
        faces.push_back({{particles[corner], particles[(corner + 1) % 4], particles[(corner + 2) % 4]},
                         0.25 * mass,
                         0.5,
                         pressure});
}

void moveBy(std::span<Vec3> forces, const cloth::ClothModel& model, Substep& substep) {
    for (std::size_t p = 0; p < forces.size(); ++p)
        if (substep.inverseMass[p] == 0) forces[p] = {};
    cloth::gatherToMasters(model, forces);
    const double squared = substep.duration * substep.duration;
    for (std::size_t p = 0; p < forces.size(); ++p)
        substep.positions[p] += (substep.inverseMass[p] * squared) * forces[p];
}

} // namespace toile::dynamics
