// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace toile::io {

/// Reads a JSON text as a tree whose nodes know their path. The first mistake is kept and reading goes on with
/// defaults, so that readers stay plain lists of fields; ask `error` when all is read.
struct JsonReading {
    std::string file;
    std::optional<Error> error;
};

/// One value of the text. Asking an object for a key marks it as known.
class JsonNode {
public:
    JsonNode(const Json* json, std::string path, JsonReading& reading)
        : json_(json), path_(std::move(path)), reading_(&reading) {}

    [[nodiscard]] bool exists() const { return json_ != nullptr; }
    [[nodiscard]] const Json* json() const { return json_; }
    [[nodiscard]] const std::string& path() const { return path_; }

    /// Notes a mistake at this value, unless there was one before.
    void refuse(std::string sentence, ErrorCode code = ErrorCode::invalidInput) const;

    /// The member of an object; where it is missing, a node that does not exist. Refuses when this is no object.
    [[nodiscard]] JsonNode operator[](const std::string& key);
    /// The same; refuses where it is missing.
    [[nodiscard]] JsonNode required(const std::string& key);
    /// The items of a list; none where this does not exist. Refuses when this is no list.
    [[nodiscard]] std::vector<JsonNode> items() const;
    /// The items of a list of exactly this length; empty after a refusal.
    [[nodiscard]] std::vector<JsonNode> items(std::size_t count) const;

    // Values. A node that does not exist gives the default in silence; one of another kind refuses.
    [[nodiscard]] double number(double missing = 0) const;
    [[nodiscard]] int integer(int missing, int low, int high) const;
    [[nodiscard]] bool truth(bool missing = false) const;
    [[nodiscard]] std::string text(std::string missing = {}) const;
    /// The index of the text among the names.
    [[nodiscard]] int choice(std::span<const char* const> names, int missing) const;

    /// The members of this object that were never asked for; null if there are none.
    [[nodiscard]] Json unknown() const;

private:
    const Json* json_;
    std::string path_;
    JsonReading* reading_;
    std::vector<std::string> asked_;
};

} // namespace toile::io
