// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DocumentFile.h"

#include "core/base/Extension.h"
#include "core/base/RegularFile.h"
#include "core/io/ToileFile.h"
#include "core/pattern/PatternCheck.h"
#include "core/simulation/SceneCheck.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace toile::io {
namespace {

using pattern::Problem;

constexpr std::uint64_t largestDocument = 256 << 20; // [bytes]

Result<Imported> importedFrom(const std::string& text, const std::string& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".toile")
        return documentFromText(text, path).map([](document::Document d) { return Imported{std::move(d), {}}; });
    if (extension == ".json") return garmentCodeFromText(text, path);
    return fail(ErrorCode::unsupported,
                fmt::format("Files ending in \"{}\" cannot be read as a pattern: .toile and .json (GarmentCode) can.",
                            extension),
                {.file = path});
}

std::vector<Problem> checkAvatar(const document::Document& document, const std::string& path) {
    if (document.avatarFile.empty()) return {};
    std::error_code none;
    if (std::filesystem::is_regular_file(fileNamedBy(path, document.avatarFile), none)) return {};
    return {
        {{.path = "avatar"}, fmt::format("There is no file \"{}\" beside the document.", document.avatarFile), true}};
}

std::vector<Problem> checkPinsToBody(const document::Document& document) {
    if (!document.avatarFile.empty()) return {};
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < document.pattern.pins.size(); ++i)
        if (const pattern::Pin& pin = document.pattern.pins[i]; pin.toBody)
            problems.push_back(
                {{.path = fmt::format("pins[{}].toBody", i), .object = fmt::format("pin \"{}\"", pin.id.value)},
                 "The document has no avatar to which its cloth could be pinned: it stays where it lies.",
                 false});
    return problems;
}

/// In which the paths of problems can be looked up: those of another format are not those of the document.
std::optional<Json> pathsIn(const std::string& text, const std::string& path) {
    if (extensionOf(path) != ".toile") return std::nullopt;
    auto json = parseJson(text, path);
    if (!json) return std::nullopt;
    return std::move(*json);
}

void locate(Place& place, const std::string& path, const std::optional<Json>& json) {
    place.file = path;
    if (json && !place.path.empty()) place.line = lineOf(*json, place.path);
}

} // namespace

Result<Imported> readDocument(const std::string& path) {
    return readRegularFile(path, largestDocument).and_then([&](const std::string& text) {
        return importedFrom(text, path);
    });
}

std::filesystem::path fileNamedBy(const std::filesystem::path& documentPath, const std::string& name) {
    return documentPath.parent_path() / name;
}

std::string nameFrom(const std::filesystem::path& documentPath, const std::filesystem::path& file) {
    // ".." leads out of the folder that a link leads to; the file itself may be a link whose name is to stay.
    const auto folderOf = [](const std::filesystem::path& path) {
        std::error_code unknown;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path).parent_path(), unknown);
    };
    return (folderOf(file) / file.filename()).lexically_proximate(folderOf(documentPath)).generic_string();
}

bool Checked::hasErrors() const {
    return pattern::hasErrors(problems);
}

Result<Checked> checkFile(const std::string& path) {
    const auto text = readRegularFile(path, largestDocument);
    if (!text) return tl::unexpected<Error>(text.error());
    auto imported = importedFrom(*text, path);
    if (!imported) return tl::unexpected<Error>(imported.error());
    Checked checked{std::move(imported->document), {}};
    for (const Warning& warning : imported->warnings)
        checked.problems.push_back({{.object = warning.place}, warning.text, false});
    const auto append = [&](const std::vector<Problem>& more) {
        checked.problems.insert(checked.problems.end(), more.begin(), more.end());
    };
    append(checkAvatar(checked.document, path));
    append(simulation::checkScene(checked.document.scene));
    append(pattern::checkPattern(checked.document.pattern));
    append(checkPinsToBody(checked.document));
    const std::optional<Json> json = pathsIn(*text, path);
    for (Problem& problem : checked.problems) locate(problem.place, path, json);
    return checked;
}

Error locatedIn(const std::string& path, Error error) {
    const bool isOfDocument = !error.place.path.empty() || !error.place.object.empty();
    if (!error.place.file.empty() || !isOfDocument) return error;
    const auto text = readRegularFile(path, largestDocument);
    locate(error.place, path, text ? pathsIn(*text, path) : std::nullopt);
    return error;
}

int lineOf(const Json& root, std::string_view path) {
    const Json* at = &root;
    while (!path.empty()) {
        const Json* next = nullptr;
        std::size_t used = 0;
        if (path.front() == '[') {
            std::size_t index = 0;
            used = path.find(']') + 1; // npos + 1 = 0
            std::from_chars(path.data() + 1, path.data() + used, index);
            if (const auto* array = at->asArray(); array && used > 0 && index < array->size()) next = &(*array)[index];
        } else {
            if (path.front() == '.') path.remove_prefix(1);
            used = std::min(path.find_first_of(".["), path.size());
            next = at->find(path.substr(0, used));
        }
        if (!next || used == 0) break;
        at = next;
        path.remove_prefix(used);
    }
    return at->line();
}

} // namespace toile::io
