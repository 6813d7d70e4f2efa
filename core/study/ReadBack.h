// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"

namespace toile::study {

/// What a record must have, and of what kind, to be one: its member by that key; null = it is none.
template <class Value>
[[nodiscard]] const Value* memberOf(const Json& json, const char* key, const Value* (Json::*as)() const) {
    const Json* member = json.find(key);
    return member ? (member->*as)() : nullptr;
}

} // namespace toile::study
