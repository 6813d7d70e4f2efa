// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"

namespace toile::simulation {

/// Made once for all tests of a program.
inline const body::Body& usualBody() {
    static const body::Body made = body::makeMannequin({})->body;
    return made;
}

} // namespace toile::simulation
