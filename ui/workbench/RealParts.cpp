// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/RealParts.h"

#include "core/io/BodyImport.h"
#include "core/io/BodyPoses.h"
#include "core/io/CheckpointFile.h"
#include "core/io/DocumentFile.h"
#include "core/io/DrapeExport.h"
#include "core/io/ToileFile.h"
#include "core/meshing/GarmentMesher.h"
#include "core/pattern/PatternPieces.h"
#include "core/simulation/MeshInputOf.h"
#include "ui/workbench/RunnerSimulation.h"

namespace toile::ui {
namespace {

/// The document of a file; pieces of foreign patterns, which often lie on each other, are laid out.
Result<io::Imported> readAny(const std::string& file) {
    auto imported = io::readDocument(file);
    if (!imported) return imported;
    pattern::Pattern& pattern = imported->document.pattern;
    if (piecesCoverEachOther(pattern)) pattern = laidOut(pattern);
    return imported;
}

/// Meshes what changed since the pattern before.
MeshPreview::Mesher previewMesher() {
    return [mesher = std::make_shared<meshing::GarmentMesher>()](
               const pattern::Pattern& pattern) -> Result<const meshing::GarmentMesh*> {
        auto input = simulation::meshInputOf(pattern);
        if (!input) return tl::unexpected(input.error());
        return mesher->mesh(*input);
    };
}

} // namespace

WorkbenchParts realParts(const QString& recoveryFolder) {
    WorkbenchParts parts;
    parts.read = readAny;
    parts.write = [](const std::string& file, const document::Document& document) {
        return io::writeToile(document, file);
    };
    parts.readBody = [](const std::string& file) {
        // A body of ours says what it is; a foreign file that does not look human is a thing to drape over.
        auto human = io::readBody(file);
        return human ? human : io::readBody(file, {.isHuman = false});
    };
    parts.readMotion = [](const std::string& folder, const body::Body& body, double step) {
        return io::readBodyPoses(folder, body, step);
    };
    parts.readCheckpoint = io::readCheckpoint;
    parts.writeCheckpoint = [](const std::string& file, const simulation::Checkpoint& checkpoint) {
        return io::writeCheckpoint(checkpoint, file);
    };
    parts.mesh = previewMesher();
    parts.simulation = std::make_unique<RunnerSimulation>();
    parts.recoveryFolder = recoveryFolder;
    return parts;
}

Result<void> writeDrapeOf(const std::string& file, const simulation::Frame& frame) {
    return io::writeDrape(file, *frame.topology, frame.positions);
}

} // namespace toile::ui
