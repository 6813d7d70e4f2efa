// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

#include <string>
#include <string_view>
#include <vector>

namespace toile::io {

/// A document made from a foreign file, and what the file did not say.
struct Imported {
    document::Document document;
    std::vector<Warning> warnings;
};

/// Reads a pattern of GarmentCode or NeuralTailor (JSON: panels, edges, stitches, translations and rotations).
///
/// Contours become ours: panels that run clockwise in their own plane are mirrored, with their placement, so that the
/// right side faces the same way. Angles are read as R = Rz·Ry·Rx. Lengths are divided by `units_in_meter`.
/// A stitch joins the end of the first edge to the start of the second one; where the lengths differ, the
/// difference is declared as ease. Facts about the format: docs/formats/garmentcode.md.
[[nodiscard]] Result<Imported> readGarmentCode(const std::string& path);
[[nodiscard]] Result<Imported> garmentCodeFromText(std::string_view text, const std::string& file = {});

/// The text looks like such a pattern: an object with "pattern" and in it "panels".
[[nodiscard]] bool isGarmentCode(const Json& json);

} // namespace toile::io
