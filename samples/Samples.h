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

/// Whom the samples are drafted for.
struct Wearers {
    body::Mannequin usual;
    body::Mannequin fuller; ///< wears the blouse
};
[[nodiscard]] Result<Wearers> sampleWearers();

/// Every sample of ours.
[[nodiscard]] Result<std::vector<NamedDocument>> sampleDocuments(const Wearers& wearers);
/// The bodies the documents name: mannequins, table, cylinder.
[[nodiscard]] std::vector<NamedBody> sampleBodies(const Wearers& wearers);

} // namespace toile::samples
