// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Prolongation.h"

#include "core/dynamics/TriangleFinder.h"

#include <algorithm>
#include <tuple>

namespace toile::dynamics {
namespace {

/// A node of a patch: a particle where it lies in the material.
struct Node {
    int particle = 0, patch = 0;
    Vec2 at;
    [[nodiscard]] auto key() const { return std::tuple(particle, patch, at.x, at.y); }
};

/// By particle, each once.
std::vector<Node> nodesOf(const LevelMesh& mesh) {
    std::vector<Node> nodes;
    for (const LevelTriangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) nodes.push_back({t.particles[i], t.patch, t.material[i]});
    std::ranges::sort(nodes, {}, &Node::key);
    const auto [first, last] = std::ranges::unique(nodes, {}, &Node::key);
    nodes.erase(first, last);
    return nodes;
}

} // namespace

Prolongation prolongation(const LevelMesh& fine, const LevelMesh& coarse) {
    const TriangleFinder finder(coarse);
    const std::vector<Node> nodes = nodesOf(fine);
    Prolongation result;
    result.begin.push_back(0);
    auto node = nodes.begin();
    for (int particle = 0; particle < fine.particles; ++particle) {
        std::vector<Prolongation::Term> row;
        const auto first = node;
        for (; node != nodes.end() && node->particle == particle; ++node) {
            const auto place = finder.find(node->patch, node->at);
            for (int i = 0; i < 3; ++i) {
                if (place.weights[i] == 0) continue;
                const int at = coarse.triangles[place.triangle].particles[i];
                const auto same = std::ranges::find(row, at, &Prolongation::Term::particle);
                if (same == row.end()) row.push_back({at, place.weights[i]});
                else same->weight += place.weights[i];
            }
        }
        for (Prolongation::Term& term : row) term.weight /= static_cast<double>(node - first);
        result.terms.insert(result.terms.end(), row.begin(), row.end());
        result.begin.push_back(static_cast<int>(result.terms.size()));
    }
    return result;
}

std::vector<int> parentsOf(const LevelMesh& fine, const LevelMesh& coarse) {
    const TriangleFinder finder(coarse);
    std::vector<int> parents;
    for (const LevelTriangle& t : fine.triangles)
        parents.push_back(finder.find(t.patch, (t.material[0] + t.material[1] + t.material[2]) / 3).triangle);
    return parents;
}

} // namespace toile::dynamics
