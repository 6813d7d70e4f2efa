// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/MeshExport.h"

#include "core/base/AtomicFile.h"
#include "core/base/Extension.h"
#include "core/geometry/Polygon.h"
#include "core/meshing/DisplayElements.h"
#include "core/picture/RenderPicture.h"
#include "core/simulation/Topology.h"

#include <fmt/format.h>

namespace toile::batch {
namespace {

constexpr double gapBetweenPieces = 0.05; // [m]

/// Where each piece goes so that all stand in a row, bottoms on one line.
std::vector<Vec2> rowOf(const meshing::GarmentMesh& mesh) {
    std::vector<Vec2> offsets;
    double x = 0;
    for (const meshing::PieceMesh& piece : mesh.pieces) {
        const geometry::Box2 box = geometry::boundsOf(piece.nodes);
        offsets.push_back({x - box.low.x, -box.low.y});
        x += box.high.x - box.low.x + gapBetweenPieces;
    }
    return offsets;
}

/// Corners of every cell.
std::vector<std::vector<int>> cellsOf(const meshing::PieceMesh& mesh) {
    std::vector<std::vector<int>> cells;
    for (const meshing::Rectangle& cell : mesh.rectangles) cells.emplace_back(cell.nodes.begin(), cell.nodes.end());
    for (const meshing::Triangle& t : mesh.triangles) cells.emplace_back(t.nodes.begin(), t.nodes.end());
    return cells;
}

/// The same without corners on sides: a rectangle with slaves on its sides is cut as it is displayed.
std::vector<std::vector<int>> facesOf(const meshing::PieceMesh& mesh) {
    const std::vector<int> elements = meshing::displayElements(mesh);
    std::vector<int> parts(mesh.rectangles.size() + mesh.triangles.size(), 0);
    for (const int element : elements) ++parts[static_cast<std::size_t>(element)];
    std::vector<std::vector<int>> faces;
    for (std::size_t r = 0; r < mesh.rectangles.size(); ++r)
        if (parts[r] == 2) faces.emplace_back(mesh.rectangles[r].nodes.begin(), mesh.rectangles[r].nodes.end());
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (parts[static_cast<std::size_t>(elements[i])] != 2)
            faces.emplace_back(mesh.display[i].begin(), mesh.display[i].end());
    return faces;
}

std::string objText(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh) {
    std::string text = "# metres, x weft, y warp\n";
    const std::vector<Vec2> offsets = rowOf(mesh);
    std::size_t first = 1;
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        text += fmt::format("g {}\n", pattern.pieces[i]->id.value);
        for (const Vec2 node : mesh.pieces[i].nodes)
            text += fmt::format("v {} {} 0\n", node.x + offsets[i].x, node.y + offsets[i].y);
        for (const std::vector<int>& cell : facesOf(mesh.pieces[i])) {
            text += "f";
            for (const int node : cell) text += fmt::format(" {}", first + static_cast<std::size_t>(node));
            text += "\n";
        }
        first += mesh.pieces[i].nodes.size();
    }
    return text;
}

std::string svgText(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh) {
    const std::vector<Vec2> offsets = rowOf(mesh);
    double width = 0, height = 0;
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        const geometry::Box2 box = geometry::boundsOf(mesh.pieces[i].nodes);
        width = std::max(width, 1000 * (box.high.x + offsets[i].x));
        height = std::max(height, 1000 * (box.high.y + offsets[i].y));
    }
    std::string text = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" "
                                   "viewBox=\"0 0 {0:.3f} {1:.3f}\">\n"
                                   "<g fill=\"none\" stroke=\"#345\" stroke-width=\"0.4\">\n",
                                   width, height);
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        text += fmt::format("<g id=\"{}\">\n", pattern.pieces[i]->id.value);
        for (const std::vector<int>& cell : cellsOf(mesh.pieces[i])) {
            text += "<path d=\"M";
            for (const int node : cell) {
                const Vec2 p = mesh.pieces[i].nodes[node] + offsets[i];
                text += fmt::format(" {:.3f},{:.3f}", 1000 * p.x, height - 1000 * p.y);
            }
            text += " Z\"/>\n";
        }
        text += "</g>\n";
    }
    return text + "</g>\n</svg>\n";
}

Result<void> writePicture(const std::filesystem::path& file, const pattern::Pattern& pattern,
                          const meshing::GarmentMesh& mesh) {
    simulation::Frame frame;
    frame.topology = simulation::topologyOf(pattern, mesh);
    const std::vector<Vec2> offsets = rowOf(mesh);
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i)
        for (const Vec2 node : mesh.pieces[i].nodes)
            frame.positions.push_back({node.x + offsets[i].x, node.y + offsets[i].y, 0});
    picture::RenderScene scene;
    scene.frame = Shared<simulation::Frame>(std::move(frame));
    scene.options.meshLines = scene.options.regions = true;
    scene.options.floor = scene.options.shadows = false;
    scene.options.seams = false; // threads from piece to piece would cover the cells
    const auto image = picture::renderPicture(scene, picture::ViewDirection::front, 2400, 1200);
    if (!image) return tl::unexpected(image.error());
    return picture::writePng(file, *image);
}

} // namespace

Result<void> writeMesh(const std::filesystem::path& file, const pattern::Pattern& pattern,
                       const meshing::GarmentMesh& mesh) {
    const std::string extension = extensionOf(file);
    if (extension == ".obj") return writeFileAtomically(file, objText(pattern, mesh));
    if (extension == ".svg") return writeFileAtomically(file, svgText(pattern, mesh));
    if (extension == ".png") return writePicture(file, pattern, mesh);
    return fail(ErrorCode::unsupported, "A mesh can be written as .obj, .svg or .png.", {.file = file.string()});
}

} // namespace toile::batch
