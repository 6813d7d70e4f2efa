// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string> // and <compare>, which moc cannot read first
#include <utility>

namespace toile {

/// The name by which a thing of the document is addressed; never reused within a document.
/// Ids of different kinds do not mix.
template <class Tag>
struct Id {
    std::string value;

    Id() = default;
    explicit Id(std::string text) : value(std::move(text)) {}

    [[nodiscard]] bool empty() const { return value.empty(); }
    friend auto operator<=>(const Id&, const Id&) = default;
};

} // namespace toile

template <class Tag>
struct std::hash<toile::Id<Tag>> {
    std::size_t operator()(const toile::Id<Tag>& id) const noexcept { return std::hash<std::string>{}(id.value); }
};
