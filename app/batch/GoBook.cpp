// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/GoBook.h"

#include "core/base/Sha256.h"
#include "core/io/ToileFile.h"

#include <span>

namespace toile::batch {

std::string hashOf(const document::Document& document, const simulation::Scene& scene) {
    const std::string text = io::toileText(document);
    std::string hash = sha256(std::as_bytes(std::span(text)));
    if (scene.body) hash += sha256(std::as_bytes(std::span((*scene.body)->mesh.vertices)));
    return sha256(std::as_bytes(std::span(hash)));
}

} // namespace toile::batch
