// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "core/geometry/TriangleMesh.h"

/// Cloths of which one knows beforehand where they deform, with a finer region there: for the paper's claim.
namespace toile::samples {

/// A strip of denim across the rod of rodMesh(): it is bent over the rod and hangs straight elsewhere. A region across
/// its middle.
[[nodiscard]] document::Document finerOverRod();
/// A strip of denim held at both ends, which hangs slack between them and is bent gently all along. A region across
/// its middle, where it is bent most.
[[nodiscard]] document::Document finerInSlack();

/// A level rod along x, 20 mm thick and 0.2 m long, 0.6 m above the floor.
[[nodiscard]] geometry::TriangleMesh rodMesh();

} // namespace toile::samples
