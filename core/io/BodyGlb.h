// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/io/GlbFile.h"

#include <optional>

namespace toile::io {

[[nodiscard]] GlbFile glbOf(const body::Body& body);

/// The body that glbOf put into a file; none if the file is someone else's. Error when what we would have written is
/// there but broken.
[[nodiscard]] Result<std::optional<body::Body>> bodyOf(const GlbFile& glb, const std::string& file);

} // namespace toile::io
