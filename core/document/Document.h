// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/Scene.h"

#include <string>

namespace toile::document {

/// What is edited and saved: one immutable value (docs/formats/toile.md).
struct Document {
    pattern::Pattern pattern;
    std::string avatarFile; ///< path relative to the document's file; empty = none
    simulation::SceneSettings scene;
    int nextId = 1;      ///< the next number for an id; see pattern/Ids.h
    Json unknown;        ///< top-level keys of the file that we do not know; kept
    Json unknownOfScene; ///< the same of its "scene"
    friend bool operator==(const Document&, const Document&) = default;
};

} // namespace toile::document
