// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "core/pattern/Ids.h"

#include <functional>

namespace toile::document {

using pattern::IdSource;
using pattern::Pattern;

/// The document after an edit of its pattern; an edit that makes new things takes their ids from the source.
///     edited(document, [&](const Pattern& p, IdSource& ids) { return addPiece(p, piece, ids); })
[[nodiscard]] Result<Document> edited(const Document& document,
                                      const std::function<Result<Pattern>(const Pattern&, IdSource&)>& edit);

/// Path of a body file, relative to the document's file; empty = no body.
[[nodiscard]] Document withAvatar(const Document& document, std::string file);
/// Error when a setting is no number or makes no sense.
[[nodiscard]] Result<Document> withScene(const Document& document, const simulation::SceneSettings& scene);

/// What is simulated: the document's garment on a body.
[[nodiscard]] simulation::Scene sceneOf(const Document& document, std::optional<Shared<body::Body>> body);

} // namespace toile::document
