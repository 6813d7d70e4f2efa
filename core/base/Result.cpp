// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Result.h"

#include <vector>

namespace toile {

std::string toString(const Place& place) {
    std::string text = place.file;
    const auto append = [&text](const std::string& part, const char* separator) {
        if (part.empty()) return;
        if (!text.empty()) text += separator;
        text += part;
    };
    if (place.line > 0) append(std::to_string(place.line), ":");
    append(place.path, ": ");
    append(place.object, ": ");
    return text;
}

std::string toString(const Error& error) {
    const std::string place = toString(error.place);
    return place.empty() ? error.text : place + ": " + error.text;
}

} // namespace toile
