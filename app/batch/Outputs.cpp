// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Outputs.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {

Result<void> checkedOutput(const std::string& file, std::initializer_list<std::string> extensions) {
    if (file.empty()) return {};
    const std::filesystem::path path(file);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder, unknown))
        return fail(ErrorCode::notFound, fmt::format("There is no folder \"{}\".", folder.string()), {.file = file});
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extensions.size() > 0 && std::ranges::find(extensions, extension) == extensions.end())
        return fail(
            ErrorCode::unsupported,
            fmt::format("This cannot be written as \"{}\", only as {}.", extension, fmt::join(extensions, ", ")),
            {.file = file});
    return {};
}

} // namespace toile::batch
