// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/DocumentFile.h"
#include "core/simulation/MeshInputOf.h"

#include <algorithm>
#include <cstdlib>
#include <string>

/// Inputs that the measurements of the mesher share.
namespace toile::bench {

inline pattern::Pattern sample(const std::string& name) {
    auto opened = io::readDocument(TOILE_SAMPLES "/" + name + ".toile");
    if (!opened) std::abort();
    return opened->document.pattern;
}

/// The back of the blouse, 0.28 m² with curved armholes and neckline, without its regions.
inline meshing::MeshInput blouseBack(double spacing) {
    auto input = simulation::meshInputOf(sample("blouse"), {.spacing = spacing});
    if (!input) std::abort();
    std::erase_if(input->pieces, [](const auto& piece) { return piece.label != "Back"; });
    if (input->pieces.size() != 1) std::abort();
    input->pieces[0].regions.clear();
    input->seams.clear();
    return *input;
}

} // namespace toile::bench
