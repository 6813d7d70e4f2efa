// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace toile {

/// A JSON value that keeps the order of its keys and the line it stood on.
class Json {
public:
    using Array = std::vector<Json>;
    using Member = std::pair<std::string, Json>;
    using Object = std::vector<Member>;

    Json() = default; ///< null
    Json(std::nullptr_t) {}
    Json(bool value) : value_(value) {}
    Json(double value); ///< a number that is not finite becomes null
    Json(int value) : value_(static_cast<double>(value)) {}
    Json(std::size_t value) : value_(static_cast<double>(value)) {}
    Json(const char* text) : value_(std::string(text)) {}
    Json(std::string text) : value_(std::move(text)) {}
    Json(Array items) : value_(std::move(items)) {}
    Json(Object members) : value_(std::move(members)) {}

    [[nodiscard]] bool isNull() const { return std::holds_alternative<std::monostate>(value_); }
    [[nodiscard]] const bool* asBool() const { return std::get_if<bool>(&value_); }
    [[nodiscard]] const double* asNumber() const { return std::get_if<double>(&value_); }
    [[nodiscard]] const std::string* asString() const { return std::get_if<std::string>(&value_); }
    [[nodiscard]] const Array* asArray() const { return std::get_if<Array>(&value_); }
    [[nodiscard]] const Object* asObject() const { return std::get_if<Object>(&value_); }

    /// "a number", "an object" …: for messages.
    [[nodiscard]] const char* kind() const;
    /// The member of an object; null if this is no object or has no such key.
    [[nodiscard]] const Json* find(std::string_view key) const;
    /// Sets or replaces a member; a null becomes an object first.
    Json& set(std::string key, Json value);
    /// The same for a key that the object is known not to have; what it has is not searched.
    Json& add(std::string key, Json value);
    /// Appends to an array; a null becomes an array first.
    Json& push(Json value);

    /// Line of the file it was read from; 0 = made by us.
    [[nodiscard]] int line() const { return line_; }

    friend bool operator==(const Json& a, const Json& b) { return a.value_ == b.value_; }

private:
    friend class JsonReader;
    std::variant<std::monostate, bool, double, std::string, Array, Object> value_;
    int line_ = 0;
};

/// Reads a whole text. Errors carry the file's name and the line; a key given twice in an object is an error.
[[nodiscard]] Result<Json> parseJson(std::string_view text, const std::string& file = {});

/// One value per line, two spaces deeper per level; arrays of plain numbers stay on one line. Numbers have as many
/// digits as it takes to read the same double.
[[nodiscard]] std::string toText(const Json& json);
/// The whole value on one line, for JSONL.
[[nodiscard]] std::string toLine(const Json& json);

} // namespace toile
