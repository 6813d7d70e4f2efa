// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "core/document/Document.h"

#include <string>
#include <vector>

namespace toile::samples {

/// samples/NAME.toile
struct NamedDocument {
    std::string name;
    document::Document document;
};

/// samples/bodies/NAME.glb
struct NamedBody {
    std::string name;
    body::Body body;
};

/// Every sample of ours, drafted for the mannequin.
[[nodiscard]] std::vector<NamedDocument> sampleDocuments(const body::Mannequin& mannequin);
/// The bodies the documents name: mannequin, table, cylinder.
[[nodiscard]] std::vector<NamedBody> sampleBodies(const body::Mannequin& mannequin);

} // namespace toile::samples
