// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/JsonNode.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::io {

void JsonNode::refuse(std::string sentence, ErrorCode code) const {
    if (reading_->error) return;
    reading_->error =
        Error{code, std::move(sentence), {.file = reading_->file, .line = json_ ? json_->line() : 0, .path = path_}};
}

JsonNode JsonNode::operator[](const std::string& key) {
    const std::string path = path_.empty() ? key : path_ + '.' + key;
    if (!json_) return {nullptr, path, *reading_};
    if (!json_->asObject()) refuse(fmt::format("Expected an object, but found {}.", json_->kind()));
    asked_.push_back(key);
    return {json_->find(key), path, *reading_};
}

JsonNode JsonNode::required(const std::string& key) {
    JsonNode member = (*this)[key];
    if (json_ && !member.exists()) refuse(fmt::format("The key \"{}\" is missing here.", key));
    return member;
}

std::vector<JsonNode> JsonNode::items() const {
    std::vector<JsonNode> nodes;
    if (!json_) return nodes;
    const auto* array = json_->asArray();
    if (!array) {
        refuse(fmt::format("Expected a list, but found {}.", json_->kind()));
        return nodes;
    }
    nodes.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i)
        nodes.emplace_back(&(*array)[i], fmt::format("{}[{}]", path_, i), *reading_);
    return nodes;
}

std::vector<JsonNode> JsonNode::items(std::size_t count) const {
    std::vector<JsonNode> nodes = items();
    if (!json_ || nodes.size() == count) return nodes;
    refuse(fmt::format("Expected a list of {}, but found {}.", count, nodes.size()));
    return {};
}

double JsonNode::number(double missing) const {
    if (!json_) return missing;
    const double* value = json_->asNumber();
    if (value) return *value;
    refuse(fmt::format("Expected a number, but found {}.", json_->kind()));
    return missing;
}

int JsonNode::integer(int missing, int low, int high) const {
    const double value = number(missing);
    if (json_ && (value != std::floor(value) || value < low || value > high)) {
        refuse(fmt::format("Expected a whole number from {} to {}, but found {}.", low, high, value));
        return missing;
    }
    return static_cast<int>(value);
}

bool JsonNode::truth(bool missing) const {
    if (!json_) return missing;
    if (const bool* value = json_->asBool()) return *value;
    refuse(fmt::format("Expected true or false, but found {}.", json_->kind()));
    return missing;
}

std::string JsonNode::text(std::string missing) const {
    if (!json_) return missing;
    if (const std::string* value = json_->asString()) return *value;
    refuse(fmt::format("Expected a text in quotes, but found {}.", json_->kind()));
    return missing;
}

int JsonNode::choice(std::span<const char* const> names, int missing) const {
    if (!json_) return missing;
    const std::string value = text();
    const auto found = std::ranges::find(names, value);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    if (json_->asString())
        refuse(fmt::format("Expected one of \"{}\", but found \"{}\".", fmt::join(names, "\", \""), value));
    return missing;
}

Json JsonNode::unknown() const {
    Json rest;
    if (!json_ || !json_->asObject()) return rest;
    for (const auto& [key, value] : *json_->asObject())
        if (std::ranges::find(asked_, key) == asked_.end()) rest.add(key, value);
    return rest;
}

} // namespace toile::io
