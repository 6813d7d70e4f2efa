// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <string>
#include <type_traits>

namespace toile::pattern {

/// Hands out ids whose numbers were never used in the document. An edit that makes new things borrows one and
/// moves it on; whoever keeps the document stores `next` with it (document::edited does both).
struct IdSource {
    int next = 1;

    /// "p" piece, "v" vertex, "e" edge, "r" region, "s" seam, "f" fabric, "n" pin, "t" tack, "l" fold, and the number.
    template <class IdType>
    [[nodiscard]] IdType take() {
        return IdType(letterOf<IdType>() + std::to_string(next++));
    }

private:
    template <class IdType>
    static constexpr char letterOf() {
        if constexpr (std::is_same_v<IdType, PieceId>) return 'p';
        else if constexpr (std::is_same_v<IdType, VertexId>) return 'v';
        else if constexpr (std::is_same_v<IdType, EdgeId>) return 'e';
        else if constexpr (std::is_same_v<IdType, RegionId>) return 'r';
        else if constexpr (std::is_same_v<IdType, SeamId>) return 's';
        else if constexpr (std::is_same_v<IdType, FabricId>) return 'f';
        else if constexpr (std::is_same_v<IdType, TackId>) return 't';
        else if constexpr (std::is_same_v<IdType, FoldId>) return 'l';
        else {
            static_assert(std::is_same_v<IdType, PinId>);
            return 'n';
        }
    }
};

/// The smallest number above every number that ends an id of the pattern: no id made from it is in use.
[[nodiscard]] int firstFreeNumber(const Pattern& pattern);

} // namespace toile::pattern
