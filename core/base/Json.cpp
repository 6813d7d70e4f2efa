// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Json.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace toile {
namespace {

/// Walks the text and counts the lines that the reader has consumed.
struct LineIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    int* line = nullptr;
    bool* endsLine = nullptr; ///< the last character read was a line end

    reference operator*() const { return *at; }
    LineIterator& operator++() {
        *endsLine = *at == '\n';
        if (*endsLine) ++*line;
        ++at;
        return *this;
    }
    LineIterator operator++(int) {
        const LineIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const LineIterator& a, const LineIterator& b) { return a.at == b.at; }
    friend bool operator!=(const LineIterator& a, const LineIterator& b) { return a.at != b.at; }
};

constexpr int deepestNesting = 200;
constexpr std::size_t fewMembers = 32; ///< of an object: so few are searched as fast one by one

bool isPlain(const Json& json) {
    return !json.asArray() && !json.asObject();
}

void writeString(std::string& out, const std::string& text) {
    out += '"';
    for (const char c : text) {
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
            else out += c;
        }
    }
    out += '"';
}

void writePlain(std::string& out, const Json& json) {
    if (const bool* b = json.asBool()) out += *b ? "true" : "false";
    else if (const double* d = json.asNumber()) out += fmt::format("{}", *d == 0 ? 0.0 : *d);
    else if (const std::string* s = json.asString()) writeString(out, *s);
    else out += "null";
}

/// indent < 0: all on one line.
void write(std::string& out, const Json& json, int indent) {
    if (isPlain(json)) return writePlain(out, json);
    const auto* array = json.asArray();
    const auto* object = json.asObject();
    const bool flat = indent < 0 || (array && std::ranges::all_of(*array, isPlain));
    const int inner = flat ? -1 : indent + 2;
    auto separate = [&, first = true]() mutable {
        if (!first) out += flat ? ", " : ",";
        if (!flat) out += '\n' + std::string(static_cast<std::size_t>(inner), ' ');
        first = false;
    };
    out += array ? '[' : '{';
    if (array)
        for (const Json& item : *array) {
            separate();
            write(out, item, inner);
        }
    else
        for (const auto& [key, value] : *object) {
            separate();
            writeString(out, key);
            out += ": ";
            write(out, value, inner);
        }
    const bool empty = array ? array->empty() : object->empty();
    if (!flat && !empty) out += '\n' + std::string(static_cast<std::size_t>(indent), ' ');
    out += array ? ']' : '}';
}

} // namespace

/// Receives the events of nlohmann's parser and builds our value.
class JsonReader : public nlohmann::json_sax<nlohmann::json> {
public:
    JsonReader(std::string file, const int& line, const bool& endsLine)
        : file_(std::move(file)), line_(line), endsLine_(endsLine) {}

    Result<Json> finish() && {
        if (error_) return tl::unexpected<Error>(*error_);
        return std::move(root_);
    }

    bool null() override { return add(Json()); }
    bool boolean(bool value) override { return add(Json(value)); }
    // The scanner has read one character past a number; if that was a line end, the number stood a line above.
    bool number_integer(number_integer_t v) override { return add(Json(static_cast<double>(v)), endsLine_); }
    bool number_unsigned(number_unsigned_t v) override { return add(Json(static_cast<double>(v)), endsLine_); }
    bool number_float(number_float_t v, const string_t&) override { return add(Json(v), endsLine_); }
    bool string(string_t& text) override { return add(Json(std::move(text))); }
    bool binary(binary_t&) override { return refuse("binary data cannot stand in a JSON text."); }
    bool start_object(std::size_t) override { return open(Json(Json::Object{})); }
    bool start_array(std::size_t) override { return open(Json(Json::Array{})); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& text) override {
        if (isGiven(text)) return refuse(fmt::format("the key \"{}\" is given twice.", text));
        key_ = text;
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& problem) override {
        std::string text = problem.what(); // "[json.exception…] parse error at line 3, column 5: syntax error …"
        if (const auto at = text.find("] "); at != std::string::npos) text = text.substr(at + 2);
        if (text.starts_with("parse error")) text = text.substr(std::min(text.size(), text.find(": ") + 2));
        return refuse("this is not valid JSON: " + text + ".");
    }

private:
    /// A list or an object whose end has not been read yet.
    struct Open {
        Json* json = nullptr;       ///< does not move while its children are read
        std::set<std::string> keys; ///< of an object with more than a few members; else empty
    };

    /// Whether the innermost object has this key already, which it is about to get.
    bool isGiven(const std::string& key) {
        auto& [json, keys] = open_.back();
        const auto& members = *json->asObject();
        if (members.size() < fewMembers) return json->find(key) != nullptr;
        if (keys.empty())
            for (const auto& [name, value] : members) keys.insert(name);
        return !keys.insert(key).second;
    }
    bool add(Json value, bool lineAbove = false) {
        value.line_ = line_ - (lineAbove ? 1 : 0);
        place(std::move(value));
        return true;
    }
    Json* place(Json value) {
        if (open_.empty()) return &(root_ = std::move(value));
        if (auto* array = std::get_if<Json::Array>(&open_.back().json->value_))
            return &array->emplace_back(std::move(value));
        auto& object = std::get<Json::Object>(open_.back().json->value_);
        return &object.emplace_back(std::move(key_), std::move(value)).second;
    }
    bool open(Json value) {
        if (open_.size() >= deepestNesting) return refuse("the values are nested too deeply.");
        value.line_ = line_;
        open_.push_back({place(std::move(value)), {}});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    bool refuse(std::string text) {
        error_ =
            Error{ErrorCode::invalidInput, std::move(text), Place{.file = file_, .line = line_ - (endsLine_ ? 1 : 0)}};
        return false;
    }

    std::string file_;
    const int& line_;
    const bool& endsLine_;
    Json root_;
    std::vector<Open> open_; // the innermost last
    std::string key_;
    std::optional<Error> error_;
};

Json::Json(double value) {
    if (std::isfinite(value)) value_ = value;
}

const char* Json::kind() const {
    static constexpr const char* names[] = {"null", "true or false", "a number", "a text", "a list", "an object"};
    return names[value_.index()];
}

const Json* Json::find(std::string_view key) const {
    const auto* object = asObject();
    if (!object) return nullptr;
    const auto found = std::ranges::find(*object, key, &Member::first);
    return found == object->end() ? nullptr : &found->second;
}

Json& Json::set(std::string key, Json value) {
    if (isNull()) value_ = Object{};
    auto& object = std::get<Object>(value_);
    const auto found = std::ranges::find(object, key, &Member::first);
    if (found != object.end()) found->second = std::move(value);
    else object.emplace_back(std::move(key), std::move(value));
    return *this;
}

Json& Json::add(std::string key, Json value) {
    if (isNull()) value_ = Object{};
    std::get<Object>(value_).emplace_back(std::move(key), std::move(value));
    return *this;
}

Json& Json::push(Json value) {
    if (isNull()) value_ = Array{};
    std::get<Array>(value_).push_back(std::move(value));
    return *this;
}

Result<Json> parseJson(std::string_view text, const std::string& file) {
    int line = 1;
    bool endsLine = false;
    JsonReader reader(file, line, endsLine);
    const LineIterator begin{text.data(), &line, &endsLine}, end{text.data() + text.size(), &line, &endsLine};
    nlohmann::json::sax_parse(begin, end, &reader);
    return std::move(reader).finish();
}

std::string toText(const Json& json) {
    std::string out;
    write(out, json, 0);
    out += '\n';
    return out;
}

std::string toLine(const Json& json) {
    std::string out;
    write(out, json, -1);
    return out;
}

} // namespace toile
