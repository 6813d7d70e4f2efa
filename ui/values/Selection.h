// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <variant>
#include <vector>

namespace toile::ui {

struct VertexRef {
    pattern::PieceId piece;
    pattern::VertexId vertex;
    friend bool operator==(const VertexRef&, const VertexRef&) = default;
};

struct EdgeRef {
    pattern::PieceId piece;
    pattern::EdgeId edge;
    friend bool operator==(const EdgeRef&, const EdgeRef&) = default;
};

struct RegionRef {
    pattern::PieceId piece;
    pattern::RegionId region;
    friend bool operator==(const RegionRef&, const RegionRef&) = default;
};

struct FoldRef {
    pattern::PieceId piece;
    pattern::FoldId fold;
    friend bool operator==(const FoldRef&, const FoldRef&) = default;
};

struct AvatarItem {
    friend bool operator==(AvatarItem, AvatarItem) = default;
};

struct SceneItem {
    friend bool operator==(SceneItem, SceneItem) = default;
};

/// One thing of the document that can be looked at and changed.
using Item = std::variant<pattern::PieceId, VertexRef, EdgeRef, RegionRef, FoldRef, pattern::SeamId, pattern::TackId,
                          pattern::FabricId, AvatarItem, SceneItem>;

/// What is selected, in the order in which it was picked.
using Selection = std::vector<Item>;

[[nodiscard]] bool contains(const Selection& selection, const Item& item);
/// With the item added, or taken out if it was there.
[[nodiscard]] Selection toggled(Selection selection, const Item& item);
/// Without what the pattern does not have (any more).
[[nodiscard]] Selection existing(const Selection& selection, const pattern::Pattern& pattern);
/// The last picked item of a kind; null if there is none.
template <class Kind>
[[nodiscard]] const Kind* lastOf(const Selection& selection) {
    for (auto item = selection.rbegin(); item != selection.rend(); ++item)
        if (const Kind* found = std::get_if<Kind>(&*item)) return found;
    return nullptr;
}
/// The piece an item belongs to; an empty id for items of no piece.
[[nodiscard]] pattern::PieceId pieceOf(const Item& item);

} // namespace toile::ui
